//! From executed blocks to steps.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use super::ChangeKind;
use super::steps::{CENTER_BY, Context, Event, Motion, Steps, UNKNOWN, Value};
use super::unknown::{Unknowns, as_written, is_unclear};
use crate::config::Machine;
use crate::diag::Findings;
use crate::dict::{
    Address, AxisLetter, COOLANT_12, COOLANT_12_GROUP, COOLANT_34, COOLANT_34_GROUP, Decimal, GCode, GGroup, M_GROUPS,
    Micro, OPTIONAL_STOP, ORIENTED_STOP, PROGRAM_ENDS, PROGRAM_GROUP, PROGRAM_STOP, SPINDLE_GROUP, SPINDLE_STOP,
    SPINDLE_TURNS, TOOL_CHANGE, standard_m_functions,
};
use crate::run::{End, Executed, MotionType, Sink, State};

/// Reads the steps of a program.
#[derive(Debug)]
pub struct StepReader {
    steps: Steps,
    parameters: bool,
    context: u32,
    before: Option<Written>,
    /// The sums of distances, by axis, since nobody knows where it is.
    way: [Micro; AxisLetter::ALL.len()],
    /// The parameters that a macrocycle of the machine or a fixed cycle was called with last.
    handed: BTreeMap<u8, Value>,
    /// The speed of the spindle in the last block that shows it; nothing while the spindle stands.
    shown_speed: Option<Decimal>,
    /// The greatest speed since then, and where it was written: its seq, its number.
    passed_speed: Option<(Decimal, u64, u32)>,
    /// The speed counts in the block.
    counts_speed: bool,
    unknowns: Unknowns,
}

/// What lasts, as a change of it counts and its repetition does not.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
struct Written {
    t: Option<Decimal>,
    d: Option<Decimal>,
    h: Option<Decimal>,
    p: Option<Decimal>,
    correction: Option<u16>,
    m: [Option<u8>; M_GROUPS],
}

impl Written {
    fn of(state: &State) -> Self {
        let (t, d, h, p) = (state.t(), state.d(), state.h(), state.p());
        let m = std::array::from_fn(|group| state.m_in_force(group));
        Self { t, d, h, p, correction: state.length_correction(), m }
    }
}

impl StepReader {
    /// `parameters`: also what is assigned to parameters, and jumps.
    pub fn new(parameters: bool) -> Self {
        Self {
            steps: Steps::default(),
            parameters,
            context: 0,
            before: None,
            way: Default::default(),
            handed: BTreeMap::new(),
            shown_speed: None,
            passed_speed: None,
            counts_speed: false,
            unknowns: Unknowns::default(),
        }
    }

    /// The steps read.
    pub fn finish(self) -> Steps {
        self.steps
    }

    fn event(&mut self, block: &Executed<'_>, kind: ChangeKind, slot: &str, value: Value) {
        self.add(block, Event::passing(kind, slot, value));
    }

    fn lasting(&mut self, block: &Executed<'_>, kind: ChangeKind, slot: &str, value: Value) {
        self.add(block, Event { kind, slot: slot.to_owned(), value, lasts: true, beside: false });
    }

    fn add(&mut self, block: &Executed<'_>, event: Event) {
        self.steps.add_event(block.seq(), block.n(), self.context, event);
    }

    /// A speed to which the spindle runs up while nothing else shows it, above those before and behind.
    fn follow_speed(&mut self, block: &Executed<'_>) {
        let turns = block.state().m_in_force(SPINDLE_GROUP).is_some_and(|m| SPINDLE_TURNS.contains(&m));
        let speed = block.state().s().filter(|_| turns);
        if let Some(now) = speed.filter(|_| !self.counts_speed) {
            let greater = self.passed_speed.is_none_or(|(passed, ..)| passed < now);
            self.passed_speed = if greater { Some((now, block.seq(), block.n())) } else { self.passed_speed };
            return;
        }
        let passed = self.passed_speed.take().filter(|(passed, ..)| Some(*passed) > speed.max(self.shown_speed));
        if let Some((passed, seq, n)) = passed {
            self.steps.add_event(seq, n, self.context, Event::passing(ChangeKind::Speed, "S", Value::from(passed)));
        }
        self.shown_speed = speed;
    }

    /// The words of a block whose values nobody knows, and those whose effect nobody knows.
    fn read_unknown(&mut self, block: &Executed<'_>) {
        self.unknowns.assign(block);
        for (address, from) in self.unknowns.words(block) {
            self.event(block, ChangeKind::Parameter, address.row().letter, Value::Text(from));
        }
        for (address, value) in as_written(block) {
            self.event(block, ChangeKind::Data, address.row().letter, value);
        }
    }

    /// What holds before the first block.
    fn start(&mut self, block: &Executed<'_>) -> Written {
        let start = Written::of(&State::new(block.settings()));
        let event = |(group, number): (usize, &Option<u8>)| number.map(|number| function_event(group, number, true));
        self.steps.start = start.m.iter().enumerate().filter_map(event).collect();
        start
    }

    /// Reads the words that act before the motion of a block.
    fn read_before(&mut self, block: &Executed<'_>, before: &Written) {
        let after = Written::of(block.state());
        let number = |value: Option<Decimal>| value.map(Value::from);
        let correction = after.correction.map(|digits| Value::Text(format!("{digits:04}")));
        let changed = [
            (ChangeKind::Tool, "T", after.t != before.t, number(after.t)),
            (ChangeKind::Correction, "D", after.d != before.d, number(after.d)),
            (ChangeKind::Correction, "&", after.correction != before.correction, correction),
            (ChangeKind::Function, "H", after.h != before.h, number(after.h)),
            (ChangeKind::Function, "P", after.p != before.p, number(after.p)),
        ];
        for (kind, slot, changed, value) in changed {
            if let Some(value) = value.filter(|_| changed) {
                self.lasting(block, kind, slot, value);
            }
        }
        self.read_functions(block, before, When::Before, block.motion().is_some());
        if let Some(data) = block.data() {
            // G93 says where an axis stands: X of a diameter at half its number.
            let stands = |letter: char| {
                let letter = AxisLetter::from_letter(letter).filter(|_| data.g == GCode::G93)?;
                block.position(letter)
            };
            let words = data.values.iter().map(|(letter, value)| match stands(*letter) {
                Some(position) => format!("{letter}{position}"),
                None => format!("{letter}{value}"),
            });
            let origin = data.origin.map(|origin| origin.to_string());
            let correction = data.d.map(|d| format!("D{d}"));
            let words: Vec<String> = origin.into_iter().chain(correction).chain(words).collect();
            self.event(block, ChangeKind::Data, &data.g.to_string(), Value::Text(words.join(" ")));
        } else if !block.words().is_empty() || block.is_unmapped_cycle() {
            if block.is_unmapped_cycle() {
                self.read_parameters(block);
            }
            // A fixed cycle that nobody knows, a spiral, a thread.
            let slot = block.g(GGroup::G8).filter(|code| code.is_cycle()).map_or("I J K".to_owned(), |g| g.to_string());
            let words = block.words().iter().map(|(letter, value)| format!("{letter}{value}"));
            let words: Vec<String> = words.collect();
            self.event(block, ChangeKind::Data, &slot, Value::Text(words.join(" ")));
        }
    }

    /// The M functions that act then; `moves`: the block has a motion.
    fn read_functions(&mut self, block: &Executed<'_>, before: &Written, when: When, moves: bool) {
        let machine = &block.settings().machine;
        let group_of = |number: u8| machine.m_functions.group(number);
        // Their order in the block does not matter.
        let timed = block.m_written().iter().map(|number| (*number, When::of(*number, machine)));
        let mut written: Vec<(u8, bool)> =
            timed.filter(|(_, (then, _))| *then == when).map(|(number, (_, sure))| (number, sure)).collect();
        written.sort_unstable_by_key(|(number, _)| (group_of(*number), *number));
        for (number, sure) in written {
            let group = usize::from(group_of(number));
            let stays = standard_m_functions(machine.dialect).any(|row| usize::from(row.group) == group);
            // A second M19 turns the spindle back.
            let turns = number == ORIENTED_STOP && block.m_changed().contains(&group_of(number));
            let beside = moves && !sure;
            let repeats = stays && !turns && before.m.get(group).copied().flatten() == Some(number);
            if number == TOOL_CHANGE {
                let unknown = || Value::Text(self.unknowns.told(Address::T).to_owned());
                let tool = block.tool().map_or_else(unknown, Value::from);
                let slot = "M06".to_owned();
                self.add(block, Event { kind: ChangeKind::Tool, slot, value: tool, lasts: true, beside });
                continue;
            }
            let event = Event { beside, ..function_event(group, number, stays) };
            if repeats {
                self.steps.add_repeated(event);
            } else {
                self.add(block, event);
            }
        }
    }

    /// What acts behind the motion of a block, or may; `moves`: there is one.
    fn read_behind(&mut self, block: &Executed<'_>, before: &Written, moves: bool) {
        self.read_functions(block, before, When::Behind, moves);
        if let Some(dwell) = block.dwell() {
            self.event(block, ChangeKind::Dwell, "G04", Value::Number(dwell.millionths()));
        }
        if let Some(l) = block.opaque_call() {
            let count = Some(block.call_count()).filter(|count| *count != 1);
            let count = count.map_or_else(String::new, |count| format!(" Q{count}"));
            self.read_parameters(block);
            self.event(block, ChangeKind::Function, "G72", Value::Text(format!("L{l}{count}")));
        }
        if self.parameters {
            for (index, value) in block.params() {
                self.event(block, ChangeKind::Parameter, &format!("R{index}"), Value::from(*value));
            }
            if let Some(jump) = block.jump() {
                // Numbers of blocks do not matter, how often it jumps does.
                let left = jump.left.map(|left| Value::from(Decimal::whole(i64::from(left))));
                let left = left.unwrap_or_else(|| Value::Text(String::new()));
                self.event(block, ChangeKind::Parameter, "G73", left);
            }
        }
        self.read_functions(block, before, When::Last, false);
    }

    /// The parameters that the program assigned, and that a macrocycle of the machine or a fixed cycle may read.
    fn read_parameters(&mut self, block: &Executed<'_>) {
        if self.parameters {
            return;
        }
        for index in (0..96).filter(|index| block.state().is_assigned(*index)) {
            let value = block.parameter(index).map_or_else(|| Value::Text("?".to_owned()), Value::from);
            if self.handed.insert(index, value.clone()).as_ref() != Some(&value) {
                self.event(block, ChangeKind::Parameter, &format!("R{index}"), value);
            }
        }
    }

    fn note_context(&mut self, block: &Executed<'_>) {
        let kind = block.motion().map(|motion| motion.kind());
        let working = kind.is_some_and(|kind| kind.is_working() || kind == MotionType::Thread) || block.is_opaque();
        let unclear = is_unclear(block);
        let working = working || unclear;
        let feed = block.feed().map(|feed| (feed.value, feed.unit, feed.hundredth));
        let radius = block.g(GGroup::G3).filter(|code| *code != GCode::G40);
        let plane = block.g(GGroup::G1).filter(|_| radius.is_some());
        // A block that takes no time, such as M03 alone, has no speed yet.
        let lasts =
            kind.is_some() || block.dwell().is_some() || block.stop() || block.cond_stop() || block.change_pos();
        self.counts_speed = working || lasts && block.m(SPINDLE_GROUP).is_some_and(|m| SPINDLE_TURNS.contains(&m));
        // What S means; the unit of F tells of the other functions of the group.
        let turns = self.counts_speed;
        let speed = block.g(GGroup::G6).filter(|code| turns && matches!(code, GCode::G96 | GCode::G97));
        let motion = [GGroup::G2, GGroup::G3, GGroup::G5, GGroup::G11].into_iter();
        let counts =
            |group: &GGroup| unclear || block.is_opaque() && (*group != GGroup::G0 || block.opaque_call().is_some());
        let inherited = INHERITED.into_iter().filter(counts);
        let functions = motion.chain(inherited).filter_map(|group| block.g(group)).chain(plane).chain(speed);
        let context = Context {
            tool: block.tool(),
            working,
            feed: feed.filter(|_| working),
            turns,
            speed: block.s().filter(|_| turns),
            functions: functions.collect(),
            dynamic_set: block.dynamic_set().filter(|_| block.continuous_mode()),
        };
        self.context = self.steps.context(&context);
    }

    /// Whether it moves.
    fn read_motion(&mut self, block: &Executed<'_>) -> bool {
        let Some(moves) = block.motion() else { return false };
        let mut motion = Motion::new(moves.kind());
        let by_distance = block.g(GGroup::G9) == Some(GCode::G91);
        let arc = moves.arc().and_then(|arc| {
            let known = arc.center.filter(|_| !moves.is_stale());
            // From a start that nobody knows, the way to the centre counts.
            motion.by = if known.is_none() { CENTER_BY } else { 0 };
            Some((arc, known.or(arc.to_center)?))
        });
        // An arc ends somewhere along both axes of its plane, named or not.
        let plane = arc.map(|(arc, _)| arc.plane);
        let ends = |letter: &AxisLetter| moves.moves(*letter) || plane.is_some_and(|plane| plane.contains(letter));
        for letter in AxisLetter::ALL.into_iter().filter(ends) {
            let bit = 1 << (letter as u16);
            // From where an origin or a correction left it, an axis moves though its position stays, and by distances
            // it comes where nobody knows (MOT-8).
            let stale = moves.is_stale_along(letter);
            let end = if moves.moves(letter) { moves.end(letter) } else { block.position(letter) };
            let known = end.filter(|_| !(stale && by_distance));
            let way = self.follow(letter, known, moves.distance(letter));
            motion.axes |= bit;
            if known.is_none() {
                motion.by |= bit;
            }
            if !stale && known.is_some() && known == moves.start(letter) {
                motion.still |= bit;
            }
            motion.push(known.or(way).map_or(UNKNOWN, Micro::millionths));
        }
        if let Some((arc, center)) = arc {
            motion.plane = Some(arc.plane);
            center.iter().chain(&arc.sweep_deg).for_each(|value| motion.push(value.millionths()));
        }
        let (is_arc, returns) = (moves.arc().is_some(), moves.kind() == MotionType::Reference);
        if block.moves_on() && (motion.values().contains(&UNKNOWN) || self.unknowns.has_told()) {
            self.read_unknown(block);
        }
        let adds = motion.still != motion.axes || is_arc || returns;
        if adds {
            self.steps.add_motion(block.seq(), block.n(), self.context, &motion);
        }
        adds
    }

    /// The sum of distances since nobody knows where an axis is.
    fn follow(&mut self, letter: AxisLetter, known: Option<Micro>, distance: Option<Micro>) -> Option<Micro> {
        let way = self.way.get_mut(letter as usize)?;
        *way = if known.is_some() { Micro::ZERO } else { way.plus(distance.unwrap_or_default()) };
        distance.map(|_| *way)
    }
}

/// The groups whose functions a macrocycle of the machine and a fixed cycle inherit (FLW-10). A cycle does not inherit
/// the first: it moves by itself.
pub(super) const INHERITED: [GGroup; 4] = [GGroup::G0, GGroup::G1, GGroup::G9, GGroup::G10];

fn function_event(group: usize, number: u8, lasts: bool) -> Event {
    let stop = group == PROGRAM_GROUP && !PROGRAM_ENDS.contains(&number);
    let kind = if stop { ChangeKind::Stop } else { ChangeKind::Function };
    Event { kind, slot: format!("m{group}"), value: Value::Text(format!("M{number:02}")), lasts, beside: false }
}

/// When an M function acts: before the motion of its block, behind it, or when all of the block is done.
#[derive(Clone, Copy, Eq, PartialEq)]
enum When {
    Before,
    Behind,
    Last,
}

impl When {
    /// When, and whether that is sure: by MFN-4, or since spindle and coolant go on before the motion. Of other
    /// functions the sources do not say it.
    fn of(number: u8, machine: &Machine) -> (Self, bool) {
        let stops = [PROGRAM_STOP, OPTIONAL_STOP].contains(&number) || PROGRAM_ENDS.contains(&number);
        let off = [SPINDLE_STOP, COOLANT_12[1], COOLANT_34[1]].contains(&number);
        let function = machine.m_functions.get(number);
        let at_end = function.is_some_and(|function| function.acts_at_end());
        let at_start = function.is_some_and(|function| function.break_cont || function.change_pos);
        let group = usize::from(machine.m_functions.group(number));
        let on = SPINDLE_TURNS.contains(&number) || [COOLANT_12_GROUP, COOLANT_34_GROUP].contains(&group);
        if stops {
            (Self::Last, true)
        } else if at_end || off {
            (Self::Behind, at_end)
        } else {
            (Self::Before, at_start || on)
        }
    }
}

impl Sink for &mut StepReader {
    type Whole = End;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.steps.blocks += 1;
        if let Some(length) = block.motion().and_then(|motion| motion.length().mm()) {
            self.steps.path = self.steps.path.plus(length);
        }
        if block.moves_on() && self.before.is_some() {
            self.read_motion(block);
            return ControlFlow::Continue(());
        }
        let before = self.before.take().unwrap_or_else(|| self.start(block));
        if block.change_pos() {
            self.way = Default::default();
        }
        self.steps.diameters |= block.g(GGroup::G10) == Some(GCode::G74);
        self.note_context(block);
        self.follow_speed(block);
        self.read_unknown(block);
        self.read_before(block, &before);
        let moves = self.read_motion(block);
        self.read_behind(block, &before, moves);
        self.before = Some(Written::of(block.state()));
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
