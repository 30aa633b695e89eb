//! Where the tool's axis stood and worked so far: what tells at which height the other axes can move (RST-2).

use std::collections::HashMap;

use crate::dict::{AxisLetter, Decimal, GCode, Micro};
use crate::run::{Executed, MotionType, State};

/// The functions of origin in force: positions with the same ones are heights above the same workpiece.
type Origin = (Option<GCode>, Option<GCode>);

/// What heights of a tool are counted from.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
struct Frame {
    tool: Option<Decimal>,
    origin: Origin,
    /// D and `&` while a length correction is on: D is the radius alone while there is none (MOT-8).
    correction: Option<(Option<Decimal>, u16)>,
}

impl Frame {
    fn of(block: &Executed<'_>) -> Self {
        let state = block.state();
        let correction = state.length_correction().filter(|on| *on != 0).map(|on| (state.d(), on));
        Self { tool: block.tool(), origin: state.origin(), correction }
    }
}

/// Where the tool's axis stood, with one tool at one origin.
#[derive(Clone, Copy, Debug, Default)]
struct Stood {
    /// Its greatest position that was not reached by cutting down, and its least.
    highest: Option<Micro>,
    lowest: Option<Micro>,
    /// The greatest position at which a rapid moved other axes alone, or to which the axis rose alone or in rapid.
    cleared: Option<Micro>,
}

/// Above all heights.
const UNKNOWN: Micro = Micro::from_millionths(i64::MAX);

/// Whether the tool works on such a motion.
fn is_work(kind: MotionType) -> bool {
    kind.is_working() || kind == MotionType::Thread
}

/// Where an axis stands, when that is known.
fn position(state: &State, at: usize) -> Option<Micro> {
    state.axis_position(at).filter(|_| !state.is_unsettled(at))
}

/// Follows an execution.
#[derive(Debug, Default)]
pub(super) struct Heights {
    /// The tool's axis, and its place in machine order.
    axis: Option<(AxisLetter, usize)>,
    /// What is in force, and what is known of it.
    frame: Frame,
    stood: Stood,
    /// The greatest position at which any tool worked at this origin; [`UNKNOWN`] where nobody knows one.
    worked: Option<Micro>,
    /// The tool's axis came to where it is in rapid, and nothing was worked there.
    in_rapid: bool,
    /// The last motion worked along other axes.
    works_across: bool,
    /// The last motion worked, and the axis did not rise in it.
    in_cut: bool,
    /// What is known of what was in force before.
    earlier: HashMap<Frame, Stood>,
    worked_earlier: HashMap<Origin, Micro>,
}

impl Heights {
    pub fn new(axis: Option<(AxisLetter, usize)>) -> Self {
        Self { axis, in_rapid: true, ..Self::default() }
    }

    /// Follows a block; `before`: what was in force before it.
    pub fn pass(&mut self, block: &Executed<'_>, before: &State) {
        let Some((axis, at)) = self.axis else { return };
        if !block.moves_on() {
            self.change_frame(block);
        }
        let stands = position(block.state(), at);
        let mut clear = self.in_rapid;
        if let Some(motion) = block.motion() {
            let moves = motion.moves(axis);
            let alone = moves && motion.axes().count() == 1;
            let rapid = motion.kind() == MotionType::Rapid;
            self.in_rapid = rapid && (moves || self.in_rapid);
            let rises = self.start(block, before).is_some_and(|start| stands > Some(start));
            // A height at which the program came by cutting down is none to move at in rapid.
            clear = rapid || rises;
            if rapid && (rises || !moves) || rises && alone {
                self.stood.cleared = self.stood.cleared.max(stands);
            }
            self.in_cut = !rapid && !rises;
        }
        self.stood.highest = self.stood.highest.max(stands.filter(|_| clear));
        self.stood.lowest = [self.stood.lowest, stands].into_iter().flatten().min();
        self.worked = self.worked.max(self.works_at(block, before));
        if block.motion().is_some() {
            self.works_across = self.is_across(block);
        }
    }

    fn change_frame(&mut self, block: &Executed<'_>) {
        if let Some(data) = block.data() {
            // What was counted from the old values means nothing any more.
            let written = data.origin.unwrap_or(data.g);
            let moves = |(g5, g11): Origin| [g5, g11].contains(&Some(written));
            let corrects = |frame: Frame| data.d.is_some() && frame.correction.is_some_and(|(d, _)| d == data.d);
            self.earlier.retain(|frame, _| !moves(frame.origin) && !corrects(*frame));
            self.worked_earlier.retain(|origin, _| !moves(*origin));
            if moves(self.frame.origin) {
                self.worked = None;
            }
            if moves(self.frame.origin) || corrects(self.frame) {
                self.stood = Stood::default();
            }
        }
        let frame = Frame::of(block);
        if frame == self.frame {
            return;
        }
        self.earlier.insert(self.frame, self.stood);
        self.stood = self.earlier.get(&frame).copied().unwrap_or_default();
        if frame.origin != self.frame.origin {
            if let Some(worked) = self.worked {
                self.worked_earlier.insert(self.frame.origin, worked);
            }
            self.worked = self.worked_earlier.get(&frame.origin).copied();
        }
        self.frame = frame;
    }

    /// Whether positions of the tool's axis before a block are none behind it.
    pub fn changes(&self, block: &Executed<'_>) -> bool {
        !block.moves_on() && (block.data().is_some() || Frame::of(block) != self.frame)
    }

    /// Where the tool's axis is while a block works: at the lower end of its motion, which may begin in the air, on the
    /// ridge between two such motions, and at the top of an arc. [`UNKNOWN`] when nobody knows.
    pub fn works_at(&self, block: &Executed<'_>, before: &State) -> Option<Micro> {
        let (axis, at) = self.axis?;
        let motion = block.motion().filter(|motion| is_work(motion.kind()))?;
        let start = self.start(block, before);
        let ends = [start, position(block.state(), at)];
        let lower = ends.into_iter().flatten().min();
        let ridge = start.filter(|_| self.works_across && self.is_across(block));
        // Below both ends, an arc may still be in the air.
        let beyond = |top: &Micro| ends.into_iter().flatten().all(|end| *top > end);
        let top = match motion.arc() {
            Some(arc) if arc.center.is_none() && arc.plane.contains(&axis) => Some(UNKNOWN),
            _ => motion.extremes().filter(|(of, _)| *of == axis).map(|(_, top)| top).filter(beyond).max(),
        };
        lower.or(Some(UNKNOWN)).max(ridge).max(top)
    }

    /// Whether a block works along other axes than the tool's.
    fn is_across(&self, block: &Executed<'_>) -> bool {
        let other = |axis: AxisLetter| self.axis.is_none_or(|(tool, _)| axis != tool);
        block.motion().is_some_and(|motion| is_work(motion.kind()) && motion.axes().any(other))
    }

    /// Where the tool's axis is before the motion of a block, counted as in the block.
    fn start(&self, block: &Executed<'_>, before: &State) -> Option<Micro> {
        let (axis, at) = self.axis?;
        let counts_anew = block.motion().is_some_and(|motion| motion.is_stale_along(axis));
        position(before, at).filter(|_| !counts_anew)
    }

    /// Whether the tool's axis came to where it is in rapid, and nothing was worked there.
    pub const fn came_in_rapid(&self) -> bool {
        self.in_rapid
    }

    /// Whether the last motion worked without rising.
    pub const fn is_in_cut(&self) -> bool {
        self.in_cut
    }

    /// The height at which the approach to a place can move the other axes, as the program shows it: the greatest that
    /// it had with this tool at this origin, above all that was worked there. The height of the place itself is one
    /// where the program crossed at it or rose to it; `alone`: no other axis moves.
    pub fn clear_of(&self, place: Micro, alone: bool) -> Option<Micro> {
        let at_place = self.stood.cleared == Some(place) || self.in_rapid && alone;
        self.stood
            .highest
            .filter(|highest| self.worked < Some(*highest) && (*highest > place || (*highest == place && at_place)))
    }

    /// Whether the tool came to a place from the other side of the workpiece's axis: an approach from above would cross
    /// the workpiece. A little beyond it, as in facing, is none.
    pub fn is_beyond_axis(&self, place: Micro) -> bool {
        let clear = self.stood.highest.is_some_and(|highest| Micro::ZERO.minus(place) < highest);
        place < Micro::ZERO && !(clear && self.stood.lowest >= Some(place))
    }
}
