//! What a block moves (§10), and what its words are when they are data.

use super::arc::{self, Arc};
use super::block::{Block, DataFacts, Effect, InForce};
use super::moved::{ArcFacts, MotionType, Moving};
use super::parameters::with_origin;
use super::planes;
use super::site::Site;
use super::state::{Position, State};
use super::technology::{check_working_motion, choose_dynamic_set};
use super::travel::{Reading, Travel};
use super::words::{BlockWords, Valued};
use crate::config::Machine;
use crate::diag::{CenterPlace, Diagnostic, Finding};
use crate::dict::{Decimal, GCode, GGroup, Micro};
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

/// The motion that axis words of a block make where these functions hold.
pub(super) fn kind_in_force(g: &InForce) -> MotionType {
    g.of(GGroup::G0).and_then(MotionType::of).unwrap_or(MotionType::Rapid)
}

/// The axis that is the spindle at the moment (MFN-10), by place in machine order.
pub(super) fn spindle(machine: &Machine, state: &State) -> Option<usize> {
    (state.m(2) == Some(19)).then(|| machine.spindle()).flatten()
}

/// Executes the motion or the data words of the block.
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, block: &mut Block) -> Moved {
    let words = &block.words;
    if words.unknown_g {
        // §13: nothing moves, and the axes are unknown after it.
        for (axis, _) in words.axis_words() {
            state.set_position(axis, Position::Undetermined);
        }
        return Moved::No;
    }
    if let Some(function) = words.data() {
        apply_data(site, state, block, function);
        return Moved::No;
    }
    let kind = kind_in_force(&block.g);
    let centered = words.i.is_some() || words.j.is_some();
    let full_circle = kind.is_arc() && words.axis_count == 0 && centered && words.has(GCode::G23).is_none();
    let is_arc = kind.is_arc() && (words.axis_count > 0 || full_circle);
    use_center_words(site, state, block, is_arc, kind.is_arc());
    let Block { words, g, travels, effect, .. } = block;
    if words.axis_count == 0 && !full_circle {
        return Moved::No;
    }
    let at = place(site, words);
    if kind.is_working() {
        check_working_motion(site, state, g, at);
    }
    let stale = std::mem::take(&mut state.origin_changed);
    let mut moving = Moving { kind, stale, spindle: spindle(site.machine(), state), arc: None };
    let reading = Reading::of(site.machine(), state, g);
    travels.clear();
    travels.extend(words.axis_words().filter_map(|(axis, word)| reading.travel(site.machine(), state, axis, word)));
    if kind == MotionType::Reference {
        for travel in travels.iter() {
            state.set_position(travel.axis, Position::Unknown);
        }
    } else if kind.is_arc() {
        let Some(arc) = find_arc(site, state, words, g, at, &moving, travels) else {
            for travel in travels.iter() {
                state.set_position(travel.axis, Position::Undetermined);
            }
            return if full_circle { Moved::WithoutCycle } else { Moved::Yes };
        };
        moving.arc = Some(arc);
        // Axes of an arc that begins nobody knows where have a finding of their own.
        arrive(site, state, travels, arc.computed.is_some());
    } else {
        arrive(site, state, travels, true);
    }
    *effect = Effect::Motion(moving);
    if full_circle || kind == MotionType::Reference { Moved::WithoutCycle } else { Moved::Yes }
}

/// Where a finding about an arc or a motion stands: its G word if written, else its first axis word.
fn place(site: &Site<'_>, words: &BlockWords) -> Location {
    let written = words.written(GGroup::G0).map(|(_, word)| word);
    let word = written
        .or_else(|| words.first_axis_word())
        .or_else(|| words.i.map(|valued| valued.word))
        .or_else(|| words.j.map(|valued| valued.word));
    word.map_or_else(|| site.block_place(), |word| site.word_place(word))
}

/// What I, J and K are for in this block: words of the record, the dynamic set, or nothing (MOT-3, GRP-7, GRP-8).
fn use_center_words(site: &mut Site<'_>, state: &mut State, block: &mut Block, is_arc: bool, circular: bool) {
    let Block { words, g, centers, .. } = block;
    if words.i.is_none() && words.j.is_none() && words.k.is_none() {
        return;
    }
    let dynamic = !is_arc && choose_dynamic_set(site, state, words);
    let spiral = matches!(g.of(GGroup::G2), Some(GCode::G09 | GCode::G10));
    let cycle = g.of(GGroup::G8).is_some_and(GCode::is_cycle);
    let thread = g.of(GGroup::G0) == Some(GCode::G33);
    for (letter, valued) in [('I', words.i), ('J', words.j), ('K', words.k)] {
        let Some(valued) = valued else { continue };
        if letter == 'I' && dynamic {
            continue;
        }
        let kept = if is_arc && letter == 'K' { spiral } else { spiral || cycle || thread };
        if kept {
            centers.extend(valued.value.map(|value| (letter, value)));
        } else if !(is_arc && letter != 'K') {
            let place = if circular && letter == 'K' { CenterPlace::ThirdInArc } else { CenterPlace::NoUse };
            site.found(Finding::CenterWordNotUsable { letter, place }, site.word_place(valued.word));
        }
    }
}

/// A block whose words are data (GRP-4): nothing moves.
fn apply_data(site: &mut Site<'_>, state: &mut State, block: &mut Block, function: GCode) {
    let Block { words, g, values, effect, .. } = block;
    let table = words.has(GCode::G92).is_some() || words.has(GCode::G93).is_some();
    for (axis, valued) in words.axis_words() {
        if let (Some(axis), Some(value)) = (site.machine().axes.get(axis), valued.value) {
            values.push((axis.letter.letter(), value));
        }
    }
    for (letter, valued) in [('I', words.i), ('J', words.j), ('K', words.k)] {
        let Some(valued) = valued else { continue };
        if table {
            let place = CenterPlace::InTableBlock;
            site.found(Finding::CenterWordNotUsable { letter, place }, site.word_place(valued.word));
        } else {
            values.extend(valued.value.map(|value| (letter, value)));
        }
    }
    if words.has(GCode::G93).is_some() {
        let reading = Reading::of(site.machine(), state, g);
        for (axis, valued) in words.axis_words() {
            state.set_position(axis, reading.target(axis, valued.value));
        }
    }
    let origin_written = words.written(GGroup::G5).is_some();
    let corrections_only = words.has(GCode::G92).is_some() && words.d.is_some() && !origin_written;
    *effect = Effect::Data(DataFacts {
        g: function,
        origin: g.of(GGroup::G5).filter(|_| table && !corrections_only),
        d: words.d.and_then(|valued| valued.value),
    });
    state.origin_changed = true;
}

/// Puts the positions after the motion into force, and warns of axes that the program does not know (MOT-2).
#[inline]
pub(super) fn arrive(site: &mut Site<'_>, state: &mut State, travels: &[Travel], warn: bool) {
    for travel in travels {
        if travel.incremental && travel.before == Position::Unknown && travel.distance.is_some() && warn {
            warn_incremental(site, state, travel);
        }
        state.set_position(travel.axis, travel.after);
    }
}

fn warn_incremental(site: &mut Site<'_>, state: &mut State, travel: &Travel) {
    let Some(said @ false) = state.said.incremental.get_mut(travel.axis) else { return };
    *said = true;
    let Some(word) = travel.word else { return };
    let finding = Finding::IncrementalFromUnknown { axis: travel.definition.letter.letter() };
    site.found(finding, site.word_place(word));
}

/// The arc that the block moves along, with its findings. `None`: its axes make no arc.
fn find_arc(
    site: &mut Site<'_>,
    state: &State,
    words: &BlockWords,
    g: &InForce,
    at: Location,
    moving: &Moving,
    travels: &mut Vec<Travel>,
) -> Option<ArcFacts> {
    let machine = site.machine();
    let plane = planes::in_force(&machine.axes, g);
    let Some((pair, helix)) = planes::of_arc(&plane, travels) else {
        let name = plane.name;
        let plane = g.of(GGroup::G1).map_or_else(|| name.to_owned(), |code| format!("{name} ({code})"));
        site.found(Finding::ArcAxes { plane, many: travels.len() > 3 }, at);
        return None;
    };
    if helix.is_some() && g.of(GGroup::G2) != Some(GCode::G09) {
        site.found(Finding::HelixWithoutG09 {}, at);
    }
    if words.axis_count == 0 {
        stay(machine, state, pair, travels);
    }
    let named = planes::named(&machine.axes, pair);
    let [first, second] = named.map(|axis| machine.axes.get(axis).map(|axis| axis.letter));
    let mut arc = ArcFacts { plane: [first?, second?], helix, radius: None, computed: None };
    let Some(to_center) = center(site, words, named, at) else { return Some(arc) };
    arc.radius = Some(arc::radius(to_center));
    let Some([start, end]) = ends(site, state, named, travels, at) else { return Some(arc) };
    let counter_clockwise = moving.kind == MotionType::ArcCcw;
    let computed = Arc { start, end, to_center, counter_clockwise }.compute();
    let tolerance = Micro::from(machine.limits.arc_tolerance).to_f64();
    if !arc::radii_agree(&computed, tolerance) {
        report_radii(site, state, words, at, computed.radius, computed.end_radius);
    }
    if moving.stale {
        site.found(Finding::ArcAfterOriginChange {}, at);
    }
    arc.computed = Some(computed);
    Some(arc)
}

/// A full circle without axis words moves the two axes of the plane, back to where they stood (MOT-3).
fn stay(machine: &Machine, state: &State, [one, other]: [usize; 2], travels: &mut Vec<Travel>) {
    for axis in [one.min(other), one.max(other)] {
        let Some(definition) = machine.axes.get(axis) else { continue };
        let before = state.position(axis);
        let distance = Some(Micro::ZERO);
        travels.push(Travel { axis, definition, before, after: before, distance, incremental: false, word: None });
    }
}

/// The way from the start of an arc to its centre, along its axes, first-named first. `None`: it is unknown, or missing
/// and reported.
fn center(site: &mut Site<'_>, words: &BlockWords, named: [usize; 2], at: Location) -> Option<[Micro; 2]> {
    let value = |word: Option<Valued>| word.map_or(Some(Decimal::ZERO), |valued| valued.value);
    let (i, j) = (value(words.i)?, value(words.j)?);
    if i == Decimal::ZERO && j == Decimal::ZERO {
        let radius_word = !words.r.is_empty();
        site.found(Finding::MissingArcCenter { radius_word }, at);
        return None;
    }
    // I is along the earlier axis of the machine, J along the later one, also for G19 (MOT-3).
    let [i, j] = [Micro::from(i), Micro::from(j)];
    Some(if named[0] > named[1] { [j, i] } else { [i, j] })
}

/// Start and end of an arc along its axes. `None`: one is unknown.
fn ends(
    site: &mut Site<'_>,
    state: &State,
    named: [usize; 2],
    travels: &[Travel],
    at: Location,
) -> Option<[[Micro; 2]; 2]> {
    let start = named.map(|axis| state.position(axis));
    let end = named.map(|axis| {
        let travel = travels.iter().find(|travel| travel.axis == axis);
        travel.map_or_else(|| state.position(axis), |travel| travel.after)
    });
    let (Some(start_u), Some(start_v)) = (start[0].known(), start[1].known()) else {
        let unknown: Vec<String> = named
            .into_iter()
            .zip(start)
            .filter(|(_, position)| *position == Position::Unknown)
            .filter_map(|(axis, _)| site.machine().axes.get(axis))
            .map(|axis| axis.letter.to_string())
            .collect();
        if !unknown.is_empty() {
            site.found(Finding::ArcFromUnknown { axes: unknown.join(", ") }, at);
        }
        return None;
    };
    Some([[start_u, start_v], [end[0].known()?, end[1].known()?]])
}

/// E0603 stands at I, else at J (§13 Motion).
fn report_radii(site: &mut Site<'_>, state: &State, words: &BlockWords, at: Location, start: f64, end: f64) {
    let word = words.i.or(words.j).map(|valued| valued.word);
    let place = word.map_or(at, |word| site.word_place(word));
    let shown = |radius: f64| {
        let text = format!("{radius:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    let finding = Finding::ArcRadiusMismatch { start: shown(start), end: shown(end) };
    let diagnostic = Diagnostic::new(finding, place);
    site.report(match word {
        Some(word) => with_origin(state, diagnostic, word),
        None => diagnostic,
    });
}
