//! What a block moves (§10): targets, lengths, arcs, data words.

use super::arc::{self, Arc};
use super::block::Valued;
use super::executor::Executor;
use super::state::Position;
use crate::config::Axis;
use crate::diag::{CenterPlace, Diagnostic, Finding};
use crate::dict::{AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::ir::{AxisList, AxisMap, Data, Motion, MotionType};
use crate::syntax::Word;
use crate::text::Location;

/// What a block did, for what follows from it.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) enum Moved {
    /// Nothing moves.
    #[default]
    No,
    /// A motion that triggers a mapped cycle (GRP-6).
    Yes,
    /// A motion that does not: G30, a full circle without axis words.
    WithoutCycle,
}

/// The motion that a function of group G0 makes; the other functions make none.
pub(super) const fn motion_type(code: GCode) -> Option<MotionType> {
    match code {
        GCode::G00 => Some(MotionType::Rapid),
        GCode::G01 => Some(MotionType::Linear),
        GCode::G02 => Some(MotionType::ArcCw),
        GCode::G03 => Some(MotionType::ArcCcw),
        GCode::G30 => Some(MotionType::Reference),
        GCode::G33 => Some(MotionType::Thread),
        GCode::G17 | GCode::G18 | GCode::G19 | GCode::G14 | GCode::G15 | GCode::G16 => None,
        GCode::G05 | GCode::G06 | GCode::G07 | GCode::G08 | GCode::G09 | GCode::G10 => None,
        GCode::G23 | GCode::G24 | GCode::G98 | GCode::G40 | GCode::G41 | GCode::G42 => None,
        GCode::G26 | GCode::G27 | GCode::G28 | GCode::G29 => None,
        GCode::G53 | GCode::G54 | GCode::G55 | GCode::G56 | GCode::G57 | GCode::G58 | GCode::G59 => None,
        GCode::G94 | GCode::G95 | GCode::G96 | GCode::G97 => None,
        GCode::G70 | GCode::G71 | GCode::G72 | GCode::G73 | GCode::G79 => None,
        GCode::G80 | GCode::G81 | GCode::G82 | GCode::G83 | GCode::G84 => None,
        GCode::G85 | GCode::G86 | GCode::G87 | GCode::G88 | GCode::G89 => None,
        GCode::G90 | GCode::G91 | GCode::G04 | GCode::G92 | GCode::G93 | GCode::G74 | GCode::G75 => None,
        GCode::G34 | GCode::G35 | GCode::G36 | GCode::G37 | GCode::G38 | GCode::G39 | GCode::G31 => None,
    }
}

/// How one axis moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Travel {
    pub(super) axis: usize,
    pub(super) definition: Axis,
    pub(super) before: Position,
    pub(super) after: Position,
    /// `None`: unknown.
    pub(super) distance: Option<Micro>,
    pub(super) incremental: bool,
    word: Option<Word>,
}

/// How the values of axis words are read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reading {
    /// G91.
    incremental: bool,
    /// The axis whose values are diameters: X under G74 (MOT-1).
    diameter: Option<usize>,
}

impl Reading {
    /// Whether values are distances.
    pub(super) const fn is_incremental(self) -> bool {
        self.incremental
    }

    /// Where an axis is after a word with that value, a coordinate. Without a value nobody knows (PAR-5).
    #[inline]
    pub(super) fn target(self, axis: usize, value: Option<Decimal>) -> Position {
        value.map_or(Position::Undetermined, |value| Position::Known(self.coordinate(axis, value)))
    }

    /// A programmed value as a coordinate.
    #[inline]
    fn coordinate(self, axis: usize, value: Decimal) -> Micro {
        let value = Micro::from(value);
        if self.diameter == Some(axis) { value.half() } else { value }
    }
}

impl Executor<'_, '_> {
    /// Executes the motion or the data words of the block.
    pub(super) fn run_motion(&mut self) -> Moved {
        self.record.motion = None;
        self.record.data = None;
        self.record.words.clear();
        if self.words.unknown_g {
            // §13: nothing moves, and the axes are unknown after it.
            for axis in 0..9 {
                if self.words.axes.get(axis).is_some_and(Option::is_some) {
                    self.state.set_position(axis, Position::Undetermined);
                }
            }
            return Moved::No;
        }
        if let Some(function) = self.words.data() {
            self.run_data(function);
            return Moved::No;
        }
        let kind = self.in_force(GGroup::G0).and_then(motion_type).unwrap_or(MotionType::Rapid);
        let circular = matches!(kind, MotionType::ArcCw | MotionType::ArcCcw);
        let centered = self.words.i.is_some() || self.words.j.is_some();
        let full_circle = circular && self.words.axis_count == 0 && centered && self.words.has(GCode::G23).is_none();
        let is_arc = circular && (self.words.axis_count > 0 || full_circle);
        self.use_center_words(is_arc, circular);
        if self.words.axis_count == 0 && !full_circle {
            return Moved::No;
        }
        let at = self.motion_place();
        if matches!(kind, MotionType::Linear | MotionType::ArcCw | MotionType::ArcCcw) {
            self.check_working_motion(at);
        }
        let stale = std::mem::take(&mut self.state.origin_changed);
        self.stale = stale;
        let mut travels = std::mem::take(&mut self.travels);
        self.find_travels(&mut travels);
        match kind {
            MotionType::Reference => self.run_reference(&travels),
            MotionType::ArcCw | MotionType::ArcCcw => self.run_arc(kind, at, stale, &mut travels),
            MotionType::Rapid | MotionType::Linear | MotionType::Thread => self.run_straight(kind, stale, &travels),
        }
        self.travels = travels;
        if full_circle || kind == MotionType::Reference { Moved::WithoutCycle } else { Moved::Yes }
    }

    /// Where a finding about an arc or a motion stands: its G word if written, else its first axis word.
    fn motion_place(&self) -> Location {
        let written = self.words.written(GGroup::G0).map(|(_, word)| word);
        let word = written
            .or_else(|| self.words.first_axis_word())
            .or_else(|| self.words.i.map(|valued| valued.word))
            .or_else(|| self.words.j.map(|valued| valued.word));
        word.map_or_else(|| self.block_place(), |word| self.word_place(word))
    }

    /// What I, J and K are for in this block: the record's `words`, the dynamic set, or nothing (MOT-3, GRP-7, GRP-8).
    fn use_center_words(&mut self, is_arc: bool, circular: bool) {
        if self.words.i.is_none() && self.words.j.is_none() && self.words.k.is_none() {
            return;
        }
        let dynamic = !is_arc && self.choose_dynamic_set();
        let spiral = matches!(self.in_force(GGroup::G2), Some(GCode::G09 | GCode::G10));
        let cycle = self.in_force(GGroup::G8).is_some_and(GCode::is_cycle);
        let thread = self.in_force(GGroup::G0) == Some(GCode::G33);
        for (letter, valued) in [('I', self.words.i), ('J', self.words.j), ('K', self.words.k)] {
            let Some(valued) = valued else { continue };
            if letter == 'I' && dynamic {
                continue;
            }
            let kept = if is_arc && letter == 'K' { spiral } else { spiral || cycle || thread };
            if kept {
                if let Some(value) = valued.value {
                    self.record.words.push((letter, value));
                }
            } else if !(is_arc && letter != 'K') {
                let place = if circular && letter == 'K' { CenterPlace::ThirdInArc } else { CenterPlace::NoUse };
                let finding = Finding::CenterWordNotUsable { letter, place };
                self.report(Diagnostic::new(finding, self.word_place(valued.word)));
            }
        }
    }

    /// A block whose words are data (GRP-4): nothing moves.
    fn run_data(&mut self, function: GCode) {
        let table = self.words.has(GCode::G92).is_some() || self.words.has(GCode::G93).is_some();
        let mut values: Vec<(char, Decimal)> = Vec::new();
        for (axis, valued) in self.words.axis_words() {
            if let (Some(axis), Some(value)) = (self.settings.machine.axes.get(axis), valued.value) {
                values.push((axis.letter.letter(), value));
            }
        }
        for (letter, valued) in [('I', self.words.i), ('J', self.words.j), ('K', self.words.k)] {
            let Some(valued) = valued else { continue };
            if table {
                let finding = Finding::CenterWordNotUsable { letter, place: CenterPlace::InTableBlock };
                self.report(Diagnostic::new(finding, self.word_place(valued.word)));
            } else if let Some(value) = valued.value {
                values.push((letter, value));
            }
        }
        if self.words.has(GCode::G93).is_some() {
            let reading = self.reading();
            for axis in 0..9 {
                if let Some(valued) = self.words.axes.get(axis).copied().flatten() {
                    self.state.set_position(axis, reading.target(axis, valued.value));
                }
            }
        }
        if self.wants_records {
            let d = self.words.d.and_then(|valued| valued.value);
            let origin_written = self.words.written(GGroup::G5).is_some();
            let corrections_only = self.words.has(GCode::G92).is_some() && self.words.d.is_some() && !origin_written;
            let origin = self.in_force(GGroup::G5).filter(|_| table && !corrections_only).map(GCode::number);
            self.record.data = Some(Data { g: function.number(), origin, d, values });
        }
        self.state.origin_changed = true;
    }

    /// How the values of axes are read in this block.
    pub(super) fn reading(&self) -> Reading {
        let incremental = self.in_force(GGroup::G9) == Some(GCode::G91);
        let diameters = self.state.modal(GGroup::G10) == Some(GCode::G74);
        let diameter = if diameters { self.settings.machine.axes.index(AxisLetter::X) } else { None };
        Reading { incremental, diameter }
    }

    /// How an axis word moves its axis (MOT-1, MOT-2).
    #[inline]
    pub(super) fn travel(&self, axis: usize, valued: Valued, reading: Reading) -> Option<Travel> {
        let definition = self.settings.machine.axes.get(axis)?;
        let before = self.state.position(axis);
        let incremental = reading.incremental;
        let value = valued.value.map(|value| reading.coordinate(axis, value));
        let (after, distance) = match (incremental, value, before) {
            (false, Some(target), Position::Known(start)) => (Position::Known(target), Some(target.minus(start))),
            (false, Some(target), _) => (Position::Known(target), None),
            (true, Some(distance), Position::Known(start)) => (Position::Known(start.plus(distance)), Some(distance)),
            (true, Some(distance), unknown) => (unknown, Some(distance)),
            (_, None, _) => (Position::Undetermined, None),
        };
        Some(Travel { axis, definition, before, after, distance, incremental, word: Some(valued.word) })
    }

    /// The motions of the axes written in the block, in machine order.
    fn find_travels(&self, travels: &mut Vec<Travel>) {
        let reading = self.reading();
        travels.clear();
        travels.extend(self.words.axis_words().filter_map(|(axis, valued)| self.travel(axis, valued, reading)));
    }

    /// The axis that is the spindle at the moment (MFN-10).
    fn spindle_axis(&self) -> Option<usize> {
        (self.state.m(2) == Some(19)).then(|| self.settings.machine.spindle()).flatten()
    }

    /// Puts the positions after the motion into force, and warns of axes that the program does not know (MOT-2).
    fn arrive(&mut self, travels: &[Travel], warned_arc: bool) {
        for travel in travels {
            if travel.incremental && travel.before == Position::Unknown && travel.distance.is_some() && !warned_arc {
                self.warn_incremental(travel);
            }
            self.state.set_position(travel.axis, travel.after);
        }
    }

    fn warn_incremental(&mut self, travel: &Travel) {
        let Some(warned @ false) = self.incremental_warned.get_mut(travel.axis) else { return };
        *warned = true;
        let Some(word) = travel.word else { return };
        let finding = Finding::IncrementalFromUnknown { axis: travel.definition.letter.letter() };
        self.report(Diagnostic::new(finding, self.word_place(word)));
    }

    /// The motion of a record, without lengths.
    #[inline]
    fn motion(&self, kind: MotionType, travels: &[Travel]) -> Motion {
        let mut axes = AxisList::default();
        let mut delta = AxisMap::default();
        for travel in travels {
            axes.push(travel.definition.letter);
            if travel.incremental && travel.before.known().is_none() {
                delta.set(travel.definition.letter, travel.distance);
            }
        }
        let spindle_axis = self
            .spindle_axis()
            .and_then(|axis| self.settings.machine.axes.get(axis))
            .map(|axis| axis.letter)
            .filter(|letter| axes.contains(*letter));
        Motion {
            kind,
            axes,
            delta,
            length_mm: None,
            length_deg: None,
            plane: None,
            center: AxisMap::default(),
            radius_mm: None,
            sweep_deg: None,
            spindle_axis,
        }
    }

    fn run_reference(&mut self, travels: &[Travel]) {
        if self.wants_records {
            let mut motion = self.motion(MotionType::Reference, travels);
            motion.delta.clear();
            self.record.motion = Some(motion);
        }
        for travel in travels {
            self.state.set_position(travel.axis, Position::Unknown);
        }
    }

    #[inline]
    pub(super) fn run_straight(&mut self, kind: MotionType, stale: bool, travels: &[Travel]) {
        if self.wants_records {
            let mut motion = self.motion(kind, travels);
            if !stale {
                self.measure(&mut motion, travels);
            }
            self.record.motion = Some(motion);
        }
        self.arrive(travels, false);
    }

    fn is_rotary(&self, travel: &Travel) -> bool {
        travel.definition.rotary || self.spindle_axis() == Some(travel.axis)
    }

    /// The length of a straight motion: the linear axes alone decide, when there are any (MOT-6).
    #[inline]
    fn measure(&self, motion: &mut Motion, travels: &[Travel]) {
        let linear = travels.iter().any(|travel| !self.is_rotary(travel));
        let mut sum = 0.0;
        for travel in travels.iter().filter(|travel| self.is_rotary(travel) != linear) {
            let Some(distance) = travel.distance else { return };
            let distance = distance.to_f64();
            sum += distance * distance;
        }
        let length = Micro::from_f64(sum.sqrt());
        if linear {
            motion.length_mm = Some(length);
        } else {
            motion.length_deg = Some(length);
        }
    }

    /// The axes of the plane in force, first-named first, `None` when the machine lacks one; and its name (§7).
    fn plane_axes(&self) -> (Option<[usize; 2]>, &'static str) {
        let axes = &self.settings.machine.axes;
        let (x, y, z) = (axes.index(AxisLetter::X), axes.index(AxisLetter::Y), axes.index(AxisLetter::Z));
        let fourth = axes.fourth();
        let plane = self.in_force(GGroup::G1);
        let (pair, name) = match plane {
            Some(GCode::G18) => ((y, z), "YZ"),
            Some(GCode::G19) => ((z, x), "ZX"),
            Some(GCode::G14) => ((z, fourth), "Z4"),
            Some(GCode::G15) => ((y, fourth), "Y4"),
            Some(GCode::G16) => ((fourth, x), "4X"),
            Some(_) | None => ((x, y), "XY"),
        };
        (pair.0.zip(pair.1).map(|(first, second)| [first, second]), name)
    }

    /// The pair as its plane names it, first-named first (MOT-5).
    fn named_pair(&self, pair: [usize; 2]) -> [usize; 2] {
        let axes = &self.settings.machine.axes;
        let letters = |axis: usize| axes.get(axis).map(|axis| axis.letter);
        let [a, b] = if pair[0] <= pair[1] { pair } else { [pair[1], pair[0]] };
        let (x, y, z, fourth) =
            (Some(AxisLetter::X), Some(AxisLetter::Y), Some(AxisLetter::Z), axes.fourth().and_then(letters));
        let named = [[x, y], [y, z], [z, x], [z, fourth], [y, fourth], [fourth, x]];
        if named.contains(&[letters(b), letters(a)]) && letters(b).is_some() { [b, a] } else { [a, b] }
    }

    /// The two axes of an arc and the one of its helix, by the axis words (MOT-3).
    fn arc_axes(&mut self, at: Location, travels: &[Travel]) -> Option<([usize; 2], Option<usize>)> {
        let (plane, name) = self.plane_axes();
        let in_plane = |travel: &Travel| plane.is_some_and(|plane| plane.contains(&travel.axis));
        let axes = match (travels, plane) {
            ([], Some(plane)) => Some((plane, None)),
            ([one], Some(plane)) if in_plane(one) => Some((plane, None)),
            ([first, second], _) => Some(([first.axis, second.axis], None)),
            (three @ [_, _, _], Some(plane)) if three.iter().filter(|travel| in_plane(travel)).count() == 2 => {
                Some((plane, three.iter().map(|travel| travel.axis).find(|axis| !plane.contains(axis))))
            }
            _ => None,
        };
        if axes.is_none() {
            let plane = self.in_force(GGroup::G1).map_or_else(|| name.to_owned(), |code| format!("{name} ({code})"));
            self.report(Diagnostic::new(Finding::ArcAxes { plane, many: travels.len() > 3 }, at));
        }
        axes
    }

    fn run_arc(&mut self, kind: MotionType, at: Location, stale: bool, travels: &mut Vec<Travel>) {
        let Some((pair, helix)) = self.arc_axes(at, travels) else {
            for travel in travels.iter() {
                self.state.set_position(travel.axis, Position::Undetermined);
            }
            return;
        };
        if helix.is_some() && self.in_force(GGroup::G2) != Some(GCode::G09) {
            self.report(Diagnostic::new(Finding::HelixWithoutG09 {}, at));
        }
        if self.words.axis_count == 0 {
            self.stay(travels, pair);
        }
        let mut motion = self.motion(kind, travels);
        let unknown_start = self.run_arc_in_plane(kind, at, stale, pair, helix, travels, &mut motion);
        if self.wants_records {
            self.record.motion = Some(motion);
        }
        self.arrive(travels, unknown_start);
    }

    /// A full circle without axis words moves the two axes of the plane, back to where they stood (MOT-3).
    fn stay(&self, travels: &mut Vec<Travel>, [one, other]: [usize; 2]) {
        for axis in [one.min(other), one.max(other)] {
            let Some(definition) = self.settings.machine.axes.get(axis) else { continue };
            let before = self.state.position(axis);
            let distance = Some(Micro::ZERO);
            travels.push(Travel { axis, definition, before, after: before, distance, incremental: false, word: None });
        }
    }

    /// Computes an arc into `motion`; gives whether its start is unknown.
    #[expect(clippy::too_many_arguments, reason = "the block's facts, each used once")]
    fn run_arc_in_plane(
        &mut self,
        kind: MotionType,
        at: Location,
        stale: bool,
        pair: [usize; 2],
        helix: Option<usize>,
        travels: &[Travel],
        motion: &mut Motion,
    ) -> bool {
        let named = self.named_pair(pair);
        let letter = |axis: usize| self.settings.machine.axes.get(axis).map(|axis| axis.letter);
        if let (Some(first), Some(second)) = (letter(named[0]), letter(named[1])) {
            motion.plane = Some([first, second]);
        }
        let center_word = |word: Option<Valued>| match word {
            None => Some(Decimal::ZERO),
            Some(valued) => valued.value,
        };
        let (Some(i), Some(j)) = (center_word(self.words.i), center_word(self.words.j)) else {
            // The centre depends on something unknown: no more can be said.
            return true;
        };
        if i == Decimal::ZERO && j == Decimal::ZERO {
            let radius_word = !self.words.r.is_empty();
            self.report(Diagnostic::new(Finding::MissingArcCenter { radius_word }, at));
            return true;
        }
        // I is along the earlier axis of the machine, J along the later one, also for G19 (MOT-3).
        let by_machine = [Micro::from(i), Micro::from(j)];
        let swapped = named[0] > named[1];
        let to_center = if swapped { [by_machine[1], by_machine[0]] } else { by_machine };
        motion.radius_mm = Some(Micro::from_f64(arc::radius(to_center)));
        let start = named.map(|axis| self.state.position(axis));
        let of_axis = |axis: usize| travels.iter().find(|travel| travel.axis == axis);
        let end = named.map(|axis| match of_axis(axis) {
            Some(travel) => travel.after,
            None => self.state.position(axis),
        });
        let (Some(start_u), Some(start_v)) = (start[0].known(), start[1].known()) else {
            self.warn_unknown_start(at, named, start);
            return true;
        };
        let (Some(end_u), Some(end_v)) = (end[0].known(), end[1].known()) else { return true };
        let arc = Arc {
            start: [start_u, start_v],
            end: [end_u, end_v],
            to_center,
            counter_clockwise: kind == MotionType::ArcCcw,
        };
        let computed = arc.compute();
        let tolerance = Micro::from(self.settings.machine.limits.arc_tolerance).to_f64();
        if !arc::radii_agree(&computed, tolerance) {
            self.report_radii(at, computed.radius, computed.end_radius);
        }
        for (axis, center) in named.into_iter().zip(computed.center) {
            if let Some(letter) = self.settings.machine.axes.get(axis).map(|axis| axis.letter) {
                motion.center.set(letter, Some(center));
            }
        }
        motion.sweep_deg = Some(Micro::from_f64(computed.sweep_rad.to_degrees()));
        if stale {
            self.report(Diagnostic::new(Finding::ArcAfterOriginChange {}, at));
            return false;
        }
        let path = computed.radius * computed.sweep_rad;
        motion.length_mm = match helix.and_then(of_axis) {
            // Axes beyond the two of an arc add to its length only when linear (§13 Motion).
            Some(travel) if !self.is_rotary(travel) => travel.distance.map(|distance| {
                let distance = distance.to_f64();
                Micro::from_f64((path * path + distance * distance).sqrt())
            }),
            Some(_) | None => Some(Micro::from_f64(path)),
        };
        false
    }

    fn warn_unknown_start(&mut self, at: Location, axes: [usize; 2], start: [Position; 2]) {
        let unknown: Vec<String> = axes
            .into_iter()
            .zip(start)
            .filter(|(_, position)| *position == Position::Unknown)
            .filter_map(|(axis, _)| self.settings.machine.axes.get(axis))
            .map(|axis| axis.letter.to_string())
            .collect();
        if !unknown.is_empty() {
            self.report(Diagnostic::new(Finding::ArcFromUnknown { axes: unknown.join(", ") }, at));
        }
    }

    /// E0603 stands at I, else at J (§13 Motion).
    fn report_radii(&mut self, at: Location, start: f64, end: f64) {
        let word = self.words.i.or(self.words.j).map(|valued| valued.word);
        let place = word.map_or(at, |word| self.word_place(word));
        let shown = |radius: f64| {
            let text = format!("{radius:.4}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        let finding = Finding::ArcRadiusMismatch { start: shown(start), end: shown(end) };
        let diagnostic = Diagnostic::new(finding, place);
        let diagnostic = match word {
            Some(word) => self.with_origin(diagnostic, word),
            None => diagnostic,
        };
        self.report(diagnostic);
    }
}
