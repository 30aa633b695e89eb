//! What a start at the next block would need: kept while the program is executed, judged before each block.

use super::approach::{Approach, Height, Lack, Target, UnknownAxes};
use super::heights::Heights;
use super::reason::Reason;
use crate::analysis::state::{Axes, Before, Unknown};
use crate::config::{Axis, MayMove, Settings};
use crate::diag::CallKind;
use crate::dict::{
    Address, AxisLetter, CLAMP_GROUP, Decimal, FeedPer, GCode, GGroup, Micro, ORIENTED_STOP, OTHER_GROUP,
    SPINDLE_GROUP, SPINDLE_TURNS, TOOL_CHANGE,
};
use crate::run::{Executed, Program, State};
use crate::syntax::Word;

/// What the user wants.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Where the tool's axis is clear of everything, as programmed at the place; `None`: where the program itself
    /// stood.
    pub safe: Option<Decimal>,
    /// Where the approach changes from rapid to feed: so many mm above the place.
    pub clearance: Decimal,
    /// Functions of M groups 10 to 14 are restored too.
    pub all_m: bool,
}

/// The functions of the project's machine that turn or bend space: the letters of the axes do not say where the tool
/// points.
const BENDING: [GCode; 3] = [GCode::G31, GCode::G38, GCode::G39];

/// Functions that copy, or drag an axis.
const COPYING: [GCode; 4] = [GCode::G05, GCode::G06, GCode::G07, GCode::G08];

/// The last function of group G11 that was written with its words.
#[derive(Clone, Debug)]
pub(super) struct Conversion {
    pub function: GCode,
    pub values: Vec<(char, Decimal)>,
    /// Another one was in force.
    pub adds: bool,
}

/// Follows an execution: call [`Self::arrive`] at a block, judge, then [`Self::pass`] it.
#[derive(Debug)]
pub(super) struct Tracker {
    pub options: Options,
    /// The letter of the tool's axis, and its place in machine order.
    tool_letter: AxisLetter,
    tool_axis: Option<usize>,
    /// Whether the project file names it.
    tool_is_named: bool,
    /// Of the linear axes the program moves X and Y alone: the user brings the tool to its depth.
    is_flat: bool,
    /// The place in machine order of the linear axis that is parallel to it, and the greatest position of that one.
    parallel: Option<usize>,
    parallel_highest: Option<Micro>,
    before: Before,
    axes: Axes,
    /// By place in machine order: a motion or a block of data gave it its position.
    named: [bool; 9],
    /// By place in machine order: G91 moved it on from where it was unsettled, so that its place is not known (MOT-8).
    drifted: [bool; 9],
    /// By place in machine order: of what left it unsettled, a length correction is not all.
    origin_moved: [bool; 9],
    /// Axes that the program never moved itself, and a macrocycle that may move any axis, a bit for each place in
    /// machine order.
    unseen: u16,
    heights: Heights,
    /// G74 was in force.
    turns: bool,
    /// The function and the block that wrote an origin.
    origin: Option<(GCode, u32)>,
    /// The block that wrote corrections.
    pub corrections: Option<u32>,
    /// The G6 function that F and S were written under.
    pub feed_mode: Option<GCode>,
    pub speed_mode: Option<GCode>,
    /// The S that was in force as a speed of the spindle last, and the G6 function that made it one: the gear follows
    /// from it (MFN-9).
    pub turning: Option<(GCode, Decimal)>,
    /// The spindle turned with the tool that is in it.
    turned: bool,
    /// M functions that the state does not keep, in the order of their last writing: seq, block, number. M10 or M11,
    /// and every one of the last group, where none excludes another.
    pub apart: Vec<(u64, u32, u8)>,
    pub conversion: Option<Conversion>,
}

impl Tracker {
    pub fn new(settings: &Settings, options: Options) -> Self {
        let tool_letter = settings.machine.tool_axis.unwrap_or(AxisLetter::Z);
        let axes = &settings.machine.axes;
        let tool_axis = axes.index(tool_letter);
        let parallel = tool_letter.parallel().and_then(|letter| axes.index(letter));
        let parallel = parallel.filter(|at| axes.get(*at).is_some_and(|axis| !axis.rotary));
        Self {
            options,
            tool_letter,
            tool_axis,
            tool_is_named: settings.machine.tool_axis.is_some(),
            is_flat: false,
            parallel,
            parallel_highest: None,
            before: Before::new(settings),
            axes: Axes::new(settings),
            named: [false; 9],
            drifted: [false; 9],
            origin_moved: [false; 9],
            unseen: 0,
            heights: Heights::new(tool_axis.map(|at| (tool_letter, at))),
            turns: false,
            origin: None,
            corrections: None,
            feed_mode: None,
            speed_mode: None,
            turning: None,
            turned: false,
            apart: Vec::new(),
            conversion: None,
        }
    }

    /// Looks at the program before it is executed.
    pub fn begin(&mut self, program: &Program<'_>) {
        let axes = &program.settings.machine.axes;
        let flat = [AxisLetter::X, AxisLetter::Y];
        let deep = |axis: Axis| !axis.rotary && (!flat.contains(&axis.letter) || axis.letter == self.tool_letter);
        let moves = |word: &Word| axes.index_of(word.address).and_then(|at| axes.get(at)).is_some_and(deep);
        let mut files = program.resolved.written_files();
        self.is_flat = !files.any(|file| file.block_ids().any(|block| file.words(block).iter().any(moves)));
    }

    /// What is in force.
    pub const fn state(&self) -> &State {
        self.before.state()
    }

    pub const fn heights(&self) -> &Heights {
        &self.heights
    }

    pub const fn before(&self) -> &Before {
        &self.before
    }

    /// What a call of the cycle map changes before a block.
    pub fn arrive(&mut self, block: &Executed<'_>) {
        self.before.arrive(block);
    }

    /// Follows a block.
    pub fn pass(&mut self, block: &Executed<'_>) {
        self.axes.pass(block, self.before.elsewhere(block));
        if !block.moves_on() {
            self.note(block);
        }
        let before = self.before.state();
        let by_distance = block.g(GGroup::G9) == Some(GCode::G91);
        for axis in block.motion().into_iter().flat_map(|motion| motion.axes()) {
            let Some(at) = block.settings().machine.axes.index(axis) else { continue };
            let places = (self.named.get_mut(at), self.drifted.get_mut(at));
            let (Some(named), Some(drifted)) = places else { continue };
            *named = true;
            *drifted = by_distance && (*drifted || before.is_unsettled(at));
        }
        let parallel = self.parallel.and_then(|at| block.state().axis_position(at));
        self.parallel_highest = self.parallel_highest.max(parallel);
        self.heights.pass(block, before);
        self.before.pass(block);
    }

    /// The parts that only blocks with more than axis words change.
    fn note(&mut self, block: &Executed<'_>) {
        let (before, after) = (self.before.state(), block.state());
        self.turns |= block.g(GGroup::G10) == Some(GCode::G74);
        let mode = block.g(GGroup::G6);
        if block.written(Address::F) {
            self.feed_mode = mode;
        }
        if block.written(Address::S) {
            self.speed_mode = mode;
        }
        if block.feed_mode().is_some_and(|mode| !mode.constant_cut) {
            self.turning = mode.zip(block.s());
        }
        self.turned &= !block.m_written().contains(&TOOL_CHANGE);
        self.turned |= after.m_in_force(SPINDLE_GROUP).is_some_and(|m| SPINDLE_TURNS.contains(&m));
        let functions = &block.settings().machine.m_functions;
        for &number in block.m_written() {
            let group = functions.group(number);
            if [CLAMP_GROUP, OTHER_GROUP].contains(&group) {
                let replaces = |other: u8| other == number || group == CLAMP_GROUP && functions.group(other) == group;
                self.apart.retain(|(_, _, other)| !replaces(*other));
                self.apart.push((block.seq(), block.n(), number));
            }
        }
        let data = block.data();
        if let Some(data) = data {
            let table = matches!(data.g, GCode::G92 | GCode::G93);
            if table && data.origin.is_some() {
                self.origin = self.origin.or(Some((data.g, block.n())));
            } else if table {
                self.corrections = Some(block.n());
            }
        }
        if let Some(function) = block.g_written().find(|code| code.group() == GGroup::G11) {
            let values = data.map(|data| data.values.to_vec()).unwrap_or_default();
            let in_force = before.g_in_force(GGroup::G11) != GCode::power_up(GGroup::G11);
            let last = self.conversion.as_ref().filter(|_| in_force);
            let adds = last.is_some_and(|last| last.adds || (last.function, &last.values) != (function, &values));
            self.conversion = Some(Conversion { function, values, adds });
        }
        let machine = &block.settings().machine;
        let moves_origin = data.is_some()
            || block.g(GGroup::G5) != before.g_in_force(GGroup::G5)
            || block.g(GGroup::G11) != before.g_in_force(GGroup::G11);
        let corrects = block.written(Address::D) || block.written(Address::Correction);
        let any = block.opaque_call().is_some_and(|l| machine.macrocycles.get(&l) == Some(&MayMove::All));
        for (at, _) in machine.axes.iter().enumerate() {
            let (was, is) = (before.is_unsettled(at), after.is_unsettled(at));
            if let Some(moved) = self.origin_moved.get_mut(at) {
                *moved = is && (*moved || moves_origin || !was && !corrects);
            }
            if any && !self.is_named(at) {
                self.unseen |= 1 << at;
            }
            if let Some(named) = self.named.get_mut(at) {
                *named |= before.axis_position(at) != after.axis_position(at);
            }
        }
    }

    /// Whether the program gave the axis its position.
    pub fn is_named(&self, at: usize) -> bool {
        self.named.get(at).copied().unwrap_or(false)
    }

    /// Whether the program gave no axis a position so far: a start here is one at its beginning.
    fn begins(&self) -> bool {
        !self.named.contains(&true)
    }

    /// Whether an axis is not where the program says, or has it from the project file, after a change of origin or
    /// correction (MOT-8). The length of the tool is none of a rotary axis.
    fn is_stale(&self, at: usize, rotary: bool) -> bool {
        let is = |of: &[bool; 9]| of.get(at).copied().unwrap_or(false);
        (is(&self.drifted) || self.state().is_unsettled(at)) && (!rotary || is(&self.origin_moved))
    }

    /// Why an axis is not where the program says it is, if it is not known.
    pub fn lack(&self, at: usize, axis: Axis) -> Option<Lack> {
        if self.state().axis_position(at).is_some() {
            let from_start = !self.is_named(at) && (self.begins() || self.is_stale(at, axis.rotary));
            return from_start.then_some(Lack::FromStart);
        }
        match self.axes.why(axis.letter) {
            Unknown::Reference => None,
            Unknown::NotProgrammed => Some(Lack::Fresh),
            Unknown::Macrocycle if !self.is_named(at) && self.unseen & 1 << at != 0 => Some(Lack::Unseen),
            Unknown::Spindle => Some(Lack::Turned),
            Unknown::Macrocycle | Unknown::MFunction | Unknown::Cycle | Unknown::Incremental | Unknown::Value => {
                Some(Lack::Lost)
            }
        }
    }

    /// How a start at the block can be approached, with the axes that are not known there.
    ///
    /// # Errors
    /// Why there is none, whatever the program does later and whatever `--safe` is.
    pub fn judge(&self, block: &Executed<'_>) -> Result<Target, Reason> {
        self.judge_functions(block)?;
        let settings = block.settings();
        let state = self.state();
        if let Some(address) = state.undetermined().next() {
            return Err(Reason::Value { name: address.row().letter.to_owned() });
        }
        // A group that has a function at power-up has one ever after.
        let powered = settings.machine.m_power_up.iter().enumerate();
        if powered.filter(|(_, power_up)| power_up.is_some()).any(|(group, _)| state.m_in_force(group).is_none()) {
            return Err(Reason::Value { name: Address::M.row().letter.to_owned() });
        }
        let lathe =
            self.turns || settings.machine.power_up.get(GGroup::G10.index()).copied().flatten() == Some(GCode::G74);
        if lathe && !self.tool_is_named {
            return Err(Reason::Lathe);
        }
        let Some(tool) = self.tool_axis else { return Err(Reason::NoAxis { axis: self.tool_letter.to_string() }) };
        let mut target = Target::default();
        for (at, axis) in settings.machine.axes.iter().enumerate() {
            if self.is_named(at) && state.axis_position(at).is_some() && self.is_stale(at, axis.rotary) {
                return Err(Reason::Stale { axis: axis.letter.to_string() });
            }
            let unknown = &mut target.unknown;
            match self.lack(at, axis) {
                Some(Lack::Lost) => unknown.lost |= 1 << at,
                Some(Lack::FromStart) if !self.begins() => unknown.from_start |= 1 << at,
                Some(Lack::Turned) => {
                    unknown.fresh |= 1 << at;
                    unknown.turned |= if self.counts_anew(settings) { 1 << at } else { 0 };
                }
                Some(Lack::Fresh | Lack::Unseen) => unknown.fresh |= 1 << at,
                Some(Lack::FromStart) | None => {}
            }
        }
        let UnknownAxes { lost, from_start, fresh, .. } = target.unknown;
        // Of a tool's axis that never moves nobody but the user knows.
        let fresh = if self.is_flat && !self.tool_is_named { 0 } else { fresh };
        let below = (lost | from_start | fresh) & 1 << tool != 0;
        let approach = self.approach(settings, tool, below)?;
        let place = approach.tool.map(|(_, place)| place);
        let lost = lost & !(1 << tool);
        if let Some(axis) = settings.machine.axes.get(lost.trailing_zeros() as usize)
            && place.is_some_and(|place| approach.lacks.is_some() || place < approach.top)
        {
            return Err(Reason::Position { axis: axis.letter.to_string() });
        }
        let level = |place: &Micro| approach.height == Height::Highest && *place == approach.top;
        target.level = place.filter(level).filter(|_| approach.lacks.is_none());
        target.approach = Approach { lathe, ..approach };
        Ok(target)
    }

    /// Whether positions are counted from elsewhere than at power-up.
    fn counts_anew(&self, settings: &Settings) -> bool {
        let (state, start) = (self.state(), State::new(settings));
        let differs = |group: GGroup| state.g_in_force(group) != start.g_in_force(group);
        differs(GGroup::G5) || differs(GGroup::G11) || state.length_correction().is_some_and(|on| on != 0)
    }

    /// What is in force must be something that a program can begin with.
    fn judge_functions(&self, block: &Executed<'_>) -> Result<(), Reason> {
        let state = self.state();
        let in_force = |group: GGroup, of: &[GCode]| {
            state.g_in_force(group).filter(|code| of.contains(code)).map(|code| code.to_string())
        };
        if let Some(call) = block.calls().find(|call| matches!(call.by, CallKind::Cycle(_))) {
            return Err(Reason::InCycle { l: call.l });
        }
        if let Some(g) = in_force(GGroup::G3, &[GCode::G41, GCode::G42]) {
            return Err(Reason::Correction { g });
        }
        if in_force(GGroup::G0, &[GCode::G33]).is_some() {
            return Err(Reason::Thread);
        }
        if let Some(cycle) = state.g_in_force(GGroup::G8).filter(|code| code.is_cycle()) {
            return Err(Reason::Cycle { g: cycle.to_string() });
        }
        if let Some((g, n)) = self.origin {
            return Err(Reason::Origin { g: g.to_string(), n });
        }
        if state.m_in_force(SPINDLE_GROUP) == Some(ORIENTED_STOP) {
            return Err(Reason::Oriented);
        }
        if let Some(g) = in_force(GGroup::G2, &COPYING) {
            return Err(Reason::Copying { g });
        }
        let conversion = state.g_in_force(GGroup::G11).filter(|code| Some(*code) != GCode::power_up(GGroup::G11));
        if let Some(function) = conversion {
            let letter = self.tool_letter.letter();
            let values = self.conversion.as_ref().map_or(&[][..], |conversion| &conversion.values);
            // I, J and K stand for axes; without words nobody knows which it is.
            let of_tool = |(axis, _): &(char, Decimal)| *axis == letter || matches!(axis, 'I' | 'J' | 'K');
            if BENDING.contains(&function) || values.is_empty() || values.iter().any(of_tool) {
                return Err(Reason::Converted { g: function.to_string() });
            }
            if self.conversion.as_ref().is_some_and(|conversion| conversion.adds) {
                return Err(Reason::Conversions { g: function.to_string() });
            }
        }
        Ok(())
    }

    /// Nothing says where the tool is clear.
    pub fn no_safe(&self) -> Reason {
        Reason::NoSafe { axis: self.tool_letter.to_string() }
    }

    /// An axis that is parallel to the tool's, and is not where it stood highest.
    fn lowered(&self, settings: &Settings) -> Option<AxisLetter> {
        let at = self.parallel.filter(|at| self.state().axis_position(*at) < self.parallel_highest)?;
        Some(settings.machine.axes.get(at)?.letter)
    }

    /// The heights of the approach (RST-2); `below`: nobody knows where the tool's axis stands.
    fn approach(&self, settings: &Settings, tool: usize, below: bool) -> Result<Approach, Reason> {
        let state = self.state();
        let machine = &settings.machine;
        let diameters = state.g_in_force(GGroup::G10) == Some(GCode::G74);
        let is_known = |at: usize, axis: Axis| !self.begins() && self.lack(at, axis).is_none();
        let mut approach = Approach { diameters, ..Approach::default() };
        for (at, axis) in machine.axes.iter().enumerate().filter(|(at, axis)| is_known(*at, *axis)) {
            let Some(position) = state.axis_position(at) else {
                approach.reference.push(axis.letter);
                continue;
            };
            approach.written(axis.letter, position)?;
            if at != tool {
                approach.others.push((axis.letter, position));
            }
        }
        if below && !approach.others.is_empty() {
            return Err(Reason::Position { axis: self.tool_letter.to_string() });
        }
        let is_known = machine.axes.get(tool).is_some_and(|axis| is_known(tool, axis));
        let Some(place) = state.axis_position(tool).filter(|_| is_known) else { return Ok(approach) };
        approach.tool = Some((self.tool_letter, place));
        if approach.is_diameter(self.tool_letter) && self.heights.is_beyond_axis(place) {
            return Err(Reason::OtherSide);
        }
        let safe = self.options.safe.map(|safe| {
            let safe = Micro::from(safe);
            if approach.is_diameter(self.tool_letter) { safe.half() } else { safe }
        });
        if let Some(axis) = self.lowered(settings).filter(|_| !approach.others.is_empty()) {
            return Err(Reason::Lowered { axis: axis.to_string(), tool: self.tool_letter.to_string() });
        }
        approach.height = match safe {
            Some(safe) if safe < place => Height::Place,
            Some(_) => Height::Safe,
            None => Height::Highest,
        };
        let top = safe.or_else(|| self.heights.clear_of(place, approach.others.is_empty()));
        approach.lacks = match top {
            None => Some(self.no_safe()),
            Some(top) if safe.is_some() && top <= place && !self.heights.came_in_rapid() => {
                Some(Reason::SafeBelow { axis: self.tool_letter.to_string() })
            }
            Some(_) => None,
        };
        approach.top = top.unwrap_or(place).max(place);
        approach.clearance = Micro::from(self.options.clearance);
        if approach.lacks.is_some() || approach.top > place {
            if state.feed(machine).is_none() {
                return Err(Reason::NoFeed);
            }
            let per = |mode: Option<GCode>| mode.and_then(|mode| machine.feed_mode(mode)).map(|mode| mode.per);
            if let Some(mode) = self.feed_mode.filter(|mode| per(Some(*mode)) != per(state.g_in_force(GGroup::G6))) {
                return Err(Reason::FeedUnit { g: mode.to_string() });
            }
            let per = per(state.g_in_force(GGroup::G6));
            let turns = state.m_in_force(SPINDLE_GROUP).is_some_and(|m| SPINDLE_TURNS.contains(&m))
                && state.s() != Some(Decimal::ZERO);
            if per == Some(FeedPer::Revolution) && !turns {
                return Err(Reason::Standing);
            }
            if self.turned && !turns && self.heights.is_in_cut() {
                return Err(Reason::StandingInCut);
            }
        }
        approach.written(self.tool_letter, approach.top)?;
        Ok(approach)
    }
}
