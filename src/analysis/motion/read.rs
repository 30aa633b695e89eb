//! From executed blocks to what the planner reads. The only file here that knows how blocks are executed.

use super::model::Model;
use super::step::{Direction, Dynamics, Mode, Move, Step, Unit};
use crate::config::{GivenBy, Motion as Configured, MotionKey, Profile, Rapid, SetKey, Settings, TimedFunction};
use crate::dict::{Address, AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::run::{ArcPath, Executed, FeedUnit, Length, Missing, Motion, MotionType};

/// The part of P that is a jerk of 1 mm/s³ (VEL-11).
const P_OF_JERK: f64 = 32.768;

fn float(value: Decimal) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "values of the configuration have far fewer than 53 bits")]
    let thousandths = value.thousandths() as f64;
    thousandths / 1000.0
}

impl Model {
    /// The machine of these settings.
    pub fn of(settings: &Settings) -> Self {
        let motion = &settings.machine.motion;
        let number = |key| float(motion.number(key));
        Self {
            recognition: motion.recognition.value,
            angle_deg: number(MotionKey::Angle),
            profile: motion.profile.value,
            accel: number(MotionKey::Accel),
            accel_rapid: number(MotionKey::AccelRapid),
            shortest_s: number(MotionKey::ShortestBlock) / 1000.0,
            break_mm: number(MotionKey::BreakLength).max(0.0),
            merge_mm: number(MotionKey::MergeLength).max(0.0),
            red: number(MotionKey::Red) / 100.0,
            raise_mm: number(MotionKey::RaiseLength).max(0.0),
            raise_s: number(MotionKey::Raise) / 1000.0,
            look_ahead: usize::try_from(motion.number(MotionKey::LookAhead).thousandths() / 1000).unwrap_or(1),
            cycle_ms: number(MotionKey::Cycle),
            lacks_cycle: motion.lacks_cycle,
            settle_s: number(MotionKey::Settle) / 1000.0,
            gap_s: number(MotionKey::BlockGap) / 1000.0,
            settle_given: motion.given(MotionKey::Settle).from != GivenBy::Default,
            gap_given: motion.given(MotionKey::BlockGap).from != GivenBy::Default,
        }
    }
}

/// Reads the blocks of one execution.
#[derive(Clone, Debug)]
pub struct StepReader {
    motion: Configured,
    /// The linear axes in machine order.
    linear: Vec<AxisLetter>,
    optional_stop: bool,
    by_parameter: bool,
    /// The dynamics of each set as last read; set 0 is that of G00.
    dynamics: [Option<Dynamics>; 5],
    correction: Option<u16>,
    /// The dynamic set that was chosen last (VEL-14).
    set: u8,
    /// What G and F words of the block before left in force, where blocks are joined (CNT-4).
    in_force: Option<InForce>,
    /// M functions that act at the end of their block (TIM-1).
    at_end: Vec<u8>,
    /// Whether a motion of known length was executed.
    moved: bool,
    /// The axes that motions led to known positions, by place in [`AxisLetter::ALL`].
    reached: [bool; AxisLetter::ALL.len()],
    /// Of the block before.
    line: u32,
}

impl StepReader {
    /// For programs executed with these settings.
    pub fn new(settings: &Settings) -> Self {
        let machine = &settings.machine;
        Self {
            motion: machine.motion.clone(),
            linear: machine.axes.iter().filter(|axis| !axis.rotary).map(|axis| axis.letter).collect(),
            optional_stop: settings.optional_stop,
            by_parameter: machine.motion.depends_on_parameters(),
            dynamics: [None; 5],
            correction: None,
            set: 1,
            in_force: None,
            at_end: machine.m_functions.at_end().collect(),
            moved: false,
            reached: [false; AxisLetter::ALL.len()],
            line: 0,
        }
    }

    /// The block as a step.
    pub fn read(&mut self, block: &Executed<'_>) -> Step {
        self.set = block.dynamic_set().unwrap_or(self.set);
        let words = self.words(block);
        let motion = block.motion();
        let dwells = block.g(GGroup::G10) == Some(GCode::G04);
        let approach = motion.is_some_and(|motion| self.approaches(&motion));
        let motion = motion.map(|motion| self.motion(block, &motion));
        self.moved |= motion.is_some_and(|motion| motion.length.is_some());
        self.line = block.line_after(self.line);
        Step {
            seq: block.seq(),
            n: block.n(),
            file: block.file_index(),
            line: self.line,
            place: block.place(),
            mode: match block.g(GGroup::G2) {
                Some(GCode::G23) => Mode::Continuous,
                Some(GCode::G24) => Mode::Tight,
                Some(GCode::G98) | None => Mode::Basic,
                Some(_) => Mode::Other,
            },
            opaque: block.is_opaque(),
            motion,
            dwell_s: dwells.then(|| block.dwell().map_or(0.0, Micro::to_f64)),
            stops: block.stop() || (block.cond_stop() && self.optional_stop),
            breaks_before: block.break_cont(),
            breaks_after: block.break_cont_end(),
            function_s: words.function_s,
            plain: words.plain && block.g(GGroup::G9) != Some(GCode::G91),
            untimed_change: words.untimed_change,
            untimed_function: words.untimed_function,
            approach,
            tool: block.tool(),
        }
    }

    /// Whether a motion lacks its length because it leads to the first known position: as the first motion, or as G00
    /// along axes that were nowhere known before it.
    fn approaches(&mut self, motion: &Motion<'_>) -> bool {
        if self.moved {
            return false;
        }
        let missing = matches!(motion.length(), Length::Missing(Missing::Start | Missing::Origin));
        let first = self.reached.iter().all(|reached| !reached);
        let mut approaches = missing && (first || motion.kind() == MotionType::Rapid);
        for letter in motion.axes() {
            let is_known = motion.end(letter).is_some();
            let Some(reached) = self.reached.get_mut(letter as usize) else { continue };
            let lacks = motion.is_stale() || motion.distance(letter).is_none();
            approaches &= !lacks || (is_known && !*reached);
            *reached |= is_known;
        }
        approaches
    }

    /// Reads the words of the block.
    fn words(&mut self, block: &Executed<'_>) -> Words {
        let mut found = Words { plain: true, ..Words::default() };
        let times = &self.motion.times;
        let (mut start_s, mut end_s) = (0.0_f64, 0.0_f64);
        let (mut correction, mut changes) = (false, false);
        let mut tool_s = None;
        for word in block.source_words() {
            if word.address.axis().is_some() {
                continue;
            }
            match word.address {
                Address::G | Address::F => changes = true,
                Address::M | Address::S | Address::T | Address::H | Address::P | Address::D => found.plain = false,
                Address::Correction => correction = true,
                Address::Program | Address::N | Address::Skip | Address::R | Address::L | Address::Q => continue,
                Address::X | Address::Y | Address::Z | Address::I | Address::J | Address::K => continue,
                Address::A | Address::B | Address::C | Address::U | Address::V | Address::W => continue,
            }
            if let Some(time) = times.get(&TimedFunction::Address(word.address.letter())) {
                start_s = start_s.max(float(time.value));
                tool_s = tool_s.or(Some(time).filter(|_| word.address == Address::T));
            } else {
                // Auxiliary functions, as M functions are.
                found.untimed_function |= matches!(word.address, Address::H | Address::P);
            }
        }
        for number in block.m_written() {
            match times.get(&TimedFunction::M(u16::from(*number))) {
                Some(time) if self.at_end.contains(number) => end_s = end_s.max(float(time.value)),
                Some(time) => start_s = start_s.max(float(time.value)),
                // A T beside it gives the change its time.
                None if *number == TOOL_CHANGE => found.untimed_change |= tool_s.is_none(),
                None => found.untimed_function |= !STOPS.contains(number),
            }
        }
        found.function_s = start_s + end_s;
        if correction {
            let digits = block.length_correction();
            // Before the first one nothing is corrected, as with &0000.
            found.plain &= digits.unwrap_or(0) == self.correction.unwrap_or(0);
            self.correction = digits;
        }
        if self.motion.number(MotionKey::MergeLength) > Decimal::ZERO {
            let now = InForce::behind(block);
            found.plain &= !changes || self.in_force.is_some_and(|before| before.is_kept_by(block, &now));
            self.in_force = Some(now);
        }
        found
    }

    fn motion(&mut self, block: &Executed<'_>, motion: &Motion<'_>) -> Move {
        let (length, unit) = match motion.length() {
            Length::Mm(length) => (Some(length.to_f64()), Unit::Mm),
            Length::Deg(length) => (Some(length.to_f64()), Unit::Deg),
            Length::Missing(_) => (None, Unit::Mm),
        };
        let kind = motion.kind();
        let arc = motion.arc().filter(|_| kind.is_arc());
        let spindle = motion.spindle_axis();
        let mut vector = [0.0; 9];
        let mut along = [0.0; 3];
        let mut known = !motion.is_stale();
        for (place, letter) in self.linear.iter().enumerate() {
            if !motion.moves(*letter) || spindle == Some(*letter) {
                continue;
            }
            match motion.distance(*letter) {
                // Whole millionths keep directions exact.
                Some(distance) => {
                    if let Some(slot) = vector.get_mut(place) {
                        *slot = distance.to_f64();
                    }
                    if let Some(slot) = along.get_mut(place) {
                        *slot = millionths(distance);
                    }
                }
                None => known &= place >= 3,
            }
        }
        let (from, to) = match arc {
            _ if !known => (Direction::Unknown, Direction::Unknown),
            Some(arc) => self.tangents(motion, &arc),
            None if kind.is_arc() => (Direction::Unknown, Direction::Unknown),
            None if along == [0.0; 3] => (Direction::Still, Direction::Still),
            None => (Direction::Along(along), Direction::Along(along)),
        };
        // In the parabolic profile G00 goes by the set of G00; elsewhere by a key.
        let set =
            if kind == MotionType::Rapid && self.motion.profile.value == Profile::Parabolic { 0 } else { self.set };
        Move {
            kind,
            length,
            unit,
            from,
            to,
            vector,
            programmed: match kind {
                MotionType::Rapid => self.rapid(motion, length),
                MotionType::Reference => None,
                MotionType::Linear | MotionType::ArcCw | MotionType::ArcCcw | MotionType::Thread => {
                    self.feed(block, kind)
                }
            },
            radius: arc.and_then(|arc| arc.radius_mm).map(Micro::to_f64),
            dynamics: self.dynamics(block, set),
        }
    }

    /// Programmed velocity of working motion (VEL-1), mm/s or deg/s.
    fn feed(&self, block: &Executed<'_>, kind: MotionType) -> Option<f64> {
        let feed = block.feed()?;
        let value = float(feed.value) / 60.0;
        // S and the key are revolutions per minute.
        let velocity = match feed.unit {
            FeedUnit::MmPerMinute | FeedUnit::DegPerMinute => value,
            FeedUnit::MmPerRevolution | FeedUnit::DegPerRevolution if block.const_cut_speed() => {
                value * float(self.motion.given(MotionKey::ConstantCutting).value?)
            }
            FeedUnit::MmPerRevolution | FeedUnit::DegPerRevolution => value * float(block.s()?),
        };
        // M37 reduces the feed; a thread keeps its pitch.
        Some(if feed.hundredth && kind != MotionType::Thread { velocity / 100.0 } else { velocity })
    }

    /// Velocity of G00 along the path (VEL-2), mm/s or deg/s.
    fn rapid(&self, motion: &Motion<'_>, length: Option<f64>) -> Option<f64> {
        match &self.motion.rapid.value {
            Rapid::Path(velocity) => Some(float(*velocity) / 60.0),
            Rapid::Axes(table) => {
                let length = length?;
                let velocity = |letter: AxisLetter| {
                    let own = table.iter().find(|(other, _)| *other == letter);
                    float(own.map_or(Rapid::DEFAULT, |(_, velocity)| *velocity)) / 60.0
                };
                let times =
                    motion.axes().filter_map(|letter| Some(motion.distance(letter)?.to_f64().abs() / velocity(letter)));
                let time = times.fold(0.0, f64::max);
                (time > 0.0).then(|| length / time)
            }
        }
    }

    /// The dynamics of a set; 0 is that of G00.
    fn dynamics(&mut self, block: &Executed<'_>, set: u8) -> Dynamics {
        let place = usize::from(set);
        if !self.by_parameter
            && let Some(dynamics) = self.dynamics.get(place).copied().flatten()
        {
            return dynamics;
        }
        let motion = &self.motion;
        let dynamics = if motion.profile.value == Profile::Parabolic {
            let value = |key| float(motion.dynamic(place, key, |number| block.parameter(number)));
            let accel = value(SetKey::Linear);
            let parabolic = value(SetKey::Parabolic);
            // Without P nothing limits the jerk: so much of it is as good as no limit.
            let jerk_free = parabolic <= 0.0;
            let jerk = if jerk_free { accel * 1e6 } else { parabolic / P_OF_JERK };
            Dynamics {
                accel,
                jerk,
                jerk_free,
                accuracy_um: value(SetKey::Accuracy),
                overload: value(SetKey::Overload),
                centripetal: value(SetKey::Centripetal),
            }
        } else {
            let value = |key| float(motion.number(key));
            Dynamics {
                accel: value(MotionKey::AccelContinuous),
                jerk: 0.0,
                jerk_free: false,
                accuracy_um: value(MotionKey::Accuracy),
                overload: value(MotionKey::Overload),
                centripetal: value(MotionKey::Centripetal),
            }
        };
        if let Some(slot) = self.dynamics.get_mut(place) {
            *slot = Some(dynamics);
        }
        dynamics
    }

    /// The directions of an arc at its ends.
    fn tangents(&self, motion: &Motion<'_>, arc: &ArcPath) -> (Direction, Direction) {
        let unknown = (Direction::Unknown, Direction::Unknown);
        let (Some(center), Some(sweep), Some(radius)) = (arc.center, arc.sweep_deg, arc.radius_mm) else {
            return unknown;
        };
        let [u, v] = arc.plane;
        let from_center = |place: [Option<Micro>; 2]| match place {
            [Some(at_u), Some(at_v)] => Some([millionths(at_u.minus(center[0])), millionths(at_v.minus(center[1]))]),
            _ => None,
        };
        let start = from_center([motion.start(u), motion.start(v)]);
        let end = from_center([motion.end(u), motion.end(v)]);
        let (Some(start), Some(end)) = (start, end) else { return unknown };
        let helix = match arc.helix.map(|letter| (letter, motion.distance(letter))) {
            None => None,
            Some((letter, Some(distance))) => Some((letter, millionths(distance))),
            Some((letter, None)) if self.axis_place(letter).is_some() => return unknown,
            Some((_, None)) => None,
        };
        let turn = if motion.kind() == MotionType::ArcCcw { 1.0 } else { -1.0 };
        let path = sweep.to_f64().to_radians() * millionths(radius);
        let tangent = |at: [f64; 2]| {
            let size = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let mut along = [0.0; 3];
            let mut put = |letter: AxisLetter, part: f64| {
                if let Some(slot) = self.axis_place(letter).and_then(|place| along.get_mut(place)) {
                    *slot = part;
                }
            };
            put(u, -turn * at[1] / size * path);
            put(v, turn * at[0] / size * path);
            if let Some((letter, distance)) = helix {
                put(letter, distance);
            }
            if size > 0.0 && along != [0.0; 3] { Direction::Along(along) } else { Direction::Still }
        };
        (tangent(start), tangent(end))
    }

    /// The place of an axis among the first three linear ones.
    fn axis_place(&self, letter: AxisLetter) -> Option<usize> {
        self.linear.iter().take(3).position(|other| *other == letter)
    }
}

fn millionths(value: Micro) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "distances have far fewer than 53 bits")]
    let value = value.millionths() as f64;
    value
}

/// The tool change.
const TOOL_CHANGE: u8 = 6;
/// M functions that stop or end the program: they take no time of the machine.
const STOPS: [u8; 4] = [0, 1, 2, 30];

/// The words of a block.
#[derive(Clone, Copy, Debug, Default)]
struct Words {
    /// Nothing that keeps the block from being joined to its neighbours.
    plain: bool,
    /// Seconds of its functions: the slowest at its start, and after them the slowest at its end.
    function_s: f64,
    /// A tool change that nobody gave a time for.
    untimed_change: bool,
    /// Other functions that nobody gave a time for.
    untimed_function: bool,
}

/// What G and F words set (CNT-4).
#[derive(Clone, Copy, Debug)]
struct InForce {
    g: [Option<GCode>; GGroup::ALL.len()],
    set: Option<u8>,
    /// F, and whether a hundredth of it counts; what it counts follows from G6 and from the axes, which are no words.
    feed: Option<(Decimal, bool)>,
}

impl InForce {
    /// What holds behind a block, functions of one block left out.
    fn behind(block: &Executed<'_>) -> Self {
        let state = block.state();
        Self {
            g: GGroup::ALL.map(|group| state.g_in_force(group)),
            set: block.dynamic_set(),
            feed: block.feed().map(|feed| (feed.value, feed.hundredth)),
        }
    }

    /// Whether the next block has nothing else in force; `now`: what holds behind that.
    fn is_kept_by(&self, next: &Executed<'_>, now: &Self) -> bool {
        let mut groups = GGroup::ALL.into_iter().zip(self.g);
        groups.all(|(group, before)| next.g(group).is_none_or(|now| before == Some(now)))
            && (self.set, self.feed) == (now.set, now.feed)
    }
}
