//! The state between two blocks, for readers that ask about a place in a program.

use super::state::{AxisSet, Held, Origin, State};
use super::{Executed, Feed, FeedUnit, Passed};
use crate::config::Machine;
use crate::dict::{Address, Decimal, FEED_GROUP, FeedPer, GCode, GGroup, Micro, REDUCED_FEED};
use crate::syntax::{BlockId, Value, Word};
use crate::text::FileId;

/// A counter of a jump that is armed (FLW-4).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct ArmedCounter {
    /// How many calls are open where it counts.
    pub depth: usize,
    /// The file of the jump.
    pub file: FileId,
    /// The block of the jump.
    pub block: BlockId,
    /// Jumps that are left; 0 until the next arrival.
    pub left: u32,
    /// Of how many.
    pub of: u32,
}

impl State {
    /// The lasting function of a G group; `None` when nobody knows which one is.
    pub fn g_in_force(&self, group: GGroup) -> Option<GCode> {
        self.modal(group)
    }

    /// The lasting function of an M group; none of groups 1, 7 and 9.
    pub fn m_in_force(&self, group: usize) -> Option<u8> {
        self.m(group)
    }

    /// Where an axis is, by place in machine order; `None` when that is not known.
    pub fn axis_position(&self, axis: usize) -> Option<Micro> {
        self.position(axis).known()
    }

    /// The axes that stand elsewhere than in another state, or of which only one of the two knows where.
    pub fn axes_elsewhere(&self, other: &Self) -> AxisSet {
        let pairs = self.positions.iter().zip(&other.positions).enumerate();
        pairs.filter(|(_, (here, there))| here.known() != there.known()).map(|(axis, _)| axis).collect()
    }

    /// The value of a parameter; `None` when that is not known (PAR-5).
    pub fn parameter(&self, index: u8) -> Option<Decimal> {
        self.parameters.get(usize::from(index)).and_then(|parameter| parameter.value)
    }

    /// Whether a parameter was read before the program assigned it: its value is that of the machine's table (PAR-5).
    pub fn is_read_from_machine(&self, index: u8) -> bool {
        self.said.read_outside.get(usize::from(index)).copied().unwrap_or(false)
    }

    /// F, with what it counts in a motion measured in millimetres.
    pub fn feed(&self, machine: &Machine) -> Option<Feed> {
        let value = self.feed.value()?;
        let mode = self.modal(GGroup::G6).and_then(|function| machine.feed_mode(function));
        let unit = FeedUnit::of(mode.map_or(FeedPer::Minute, |mode| mode.per), false);
        let function = self.m(FEED_GROUP);
        let hundredth = function == Some(REDUCED_FEED) && machine.m_functions.reduces_feed(function);
        Some(Feed { value, unit, hundredth })
    }

    /// S.
    pub const fn s(&self) -> Option<Decimal> {
        self.speed.value()
    }

    /// T.
    pub const fn t(&self) -> Option<Decimal> {
        self.tool.value()
    }

    /// The tool in the spindle (TEC-4).
    pub const fn tool_in_spindle(&self) -> Option<Decimal> {
        self.in_spindle.value()
    }

    /// H.
    pub const fn h(&self) -> Option<Decimal> {
        self.h.value()
    }

    /// P.
    pub const fn p(&self) -> Option<Decimal> {
        self.p.value()
    }

    /// D.
    pub const fn d(&self) -> Option<Decimal> {
        self.d.value()
    }

    /// The four digits of `&`, as a number.
    pub fn length_correction(&self) -> Option<u16> {
        self.correction.value().and_then(Decimal::as_whole).and_then(|digits| u16::try_from(digits).ok())
    }

    /// The gear, 1–4 (MFN-9).
    pub const fn gear_in_force(&self) -> Option<u8> {
        self.gear
    }

    /// The dynamic set as records show it (GRP-7).
    pub fn dynamic_set(&self) -> Option<u8> {
        self.dynamic_set.filter(|_| self.modal(GGroup::G2) == Some(GCode::G23))
    }

    /// The dynamic set that the next G23 without `I` has, 1–4 (GRP-7); `None` when that is not known.
    pub const fn chosen_dynamic_set(&self) -> Option<u8> {
        self.dynamic_set
    }

    /// The G5 and G11 functions of the last block, those that hold for it alone included (MOT-8).
    pub const fn origin(&self) -> (Option<GCode>, Option<GCode>) {
        self.last_origin
    }

    /// Whether the programmed position of an axis is not where the tool stands (MOT-8), by place in machine order.
    pub const fn is_unsettled(&self, axis: usize) -> bool {
        self.unsettled.contains(axis)
    }

    /// The addresses that were programmed with values that are not known.
    pub fn undetermined(&self) -> impl Iterator<Item = Address> {
        let held = [
            (Address::F, self.feed),
            (Address::S, self.speed),
            (Address::T, self.tool),
            (Address::T, self.in_spindle),
            (Address::H, self.h),
            (Address::P, self.p),
            (Address::D, self.d),
            (Address::Correction, self.correction),
        ];
        held.into_iter().filter(|(_, held)| *held == Held::Undetermined).map(|(address, _)| address)
    }

    /// Whether the program gave a parameter a value that is not known.
    pub fn is_lost(&self, index: u8) -> bool {
        let parameter = self.parameters.get(usize::from(index));
        parameter.is_some_and(|parameter| parameter.value.is_none() && parameter.origin != Origin::Machine)
    }

    /// Whether the program gave a parameter its value, known or not.
    pub fn is_assigned(&self, index: u8) -> bool {
        self.parameters.get(usize::from(index)).is_some_and(|parameter| matches!(parameter.origin, Origin::Word(_)))
    }

    /// What M02 and M30 leave of the G functions: those of power-up (MFN-7).
    pub fn reset_functions(&mut self, machine: &Machine) {
        self.g = machine.power_up;
    }

    /// A fixed cycle holds from now on: calls of the cycle map suspend it and bring it back between two blocks (GRP-6).
    pub fn set_cycle(&mut self, cycle: GCode) {
        self.set_modal(cycle);
    }

    /// The next block is executed: what a macrocycle of the machine moved before it is not known (FLW-12).
    pub fn pass_machine_call(&mut self) {
        self.lose_moved_unseen();
    }

    /// Becomes what is in force after `block`, from what was before it; what findings name and what they said already
    /// is left out.
    #[inline]
    pub fn follow(&mut self, block: &Executed<'_>) {
        let after = block.state();
        (self.positions, self.unsettled) = (after.positions, after.unsettled);
        if !block.moves_on() {
            self.follow_words(block, after);
        }
    }

    /// The same for points that were executed at once.
    pub fn follow_points(&mut self, points: &Passed<'_>) {
        let after = points.state();
        (self.positions, self.unsettled) = (after.positions, after.unsettled);
    }

    /// The parts that words other than those of axes change. Parameters are most of a state, and few blocks have any.
    fn follow_words(&mut self, block: &Executed<'_>, after: &Self) {
        let Self {
            g,
            unknown,
            m,
            positions: _,
            parameters,
            feed,
            speed,
            tool,
            in_spindle,
            h,
            p,
            d,
            correction,
            dynamic_set,
            orients,
            moved_unseen,
            unsettled: _,
            feed_per,
            feed_reduced,
            gear,
            spindle_words: _,
            corrects,
            origins: _,
            last_origin,
            named_tool,
            retracted,
            works_by_g53,
            compiled: _,
            said,
        } = after;
        (self.g, self.unknown, self.m) = (*g, *unknown, *m);
        (self.feed, self.speed, self.tool, self.in_spindle) = (*feed, *speed, *tool, *in_spindle);
        (self.h, self.p, self.d, self.correction) = (*h, *p, *d, *correction);
        (self.dynamic_set, self.orients, self.moved_unseen) = (*dynamic_set, *orients, *moved_unseen);
        (self.feed_per, self.feed_reduced, self.gear) = (*feed_per, *feed_reduced, *gear);
        (self.corrects, self.last_origin) = (*corrects, *last_origin);
        (self.named_tool, self.retracted, self.works_by_g53) = (*named_tool, *retracted, *works_by_g53);
        if block.has_parameters() {
            self.parameters = *parameters;
            self.said.read_outside = said.read_outside;
        }
    }
}

impl Executed<'_> {
    /// Whether it may read or write parameters.
    pub fn has_parameters(&self) -> bool {
        let words = self.file().map_or(&[][..], |file| file.words(self.at().1));
        let is_parameter = |word: &Word| word.address == Address::R || matches!(word.value(), Value::Parameter { .. });
        self.g(GGroup::G4).is_some() || words.iter().any(is_parameter)
    }

    /// The counters that are armed after it, outermost call first.
    pub fn counters(&self) -> impl Iterator<Item = ArmedCounter> + '_ {
        self.interpreter.frames.iter().enumerate().flat_map(|(depth, frame)| {
            let file = frame.unit.file;
            let armed = move |(block, counter): (&BlockId, &super::frames::Counter)| ArmedCounter {
                depth,
                file,
                block: *block,
                left: counter.left,
                of: counter.of,
            };
            frame.counters.iter().map(armed)
        })
    }

    /// How many calls are open at it.
    pub const fn depth(&self) -> usize {
        self.interpreter.frames.len().saturating_sub(1)
    }

    /// A file that it was executed with.
    pub fn file_of(&self, file: FileId) -> Option<&crate::syntax::ParsedFile> {
        self.program.resolved.file(file)
    }
}
