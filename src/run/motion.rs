//! The motion of a block (§10), or the data that its words are.

use super::arc::{self, Arc};
use super::arrival::{arrive, arrive_from_unknown};
use super::block::{Block, DataFacts, Effect, InForce};
use super::functions::report_unmodelled;
use super::moved::{ArcFacts, MotionType, Moving};
use super::other_centers;
use super::site::Site;
use super::state::{AxisSet, Position, State};
use super::technology::choose_dynamic_set;
use super::travel::{Reading, Travel};
use super::words::{BlockWords, Valued};
use super::{arc_findings, planes, spindle, warnings};
use crate::config::Machine;
use crate::diag::{CenterPlace, Finding};
use crate::dict::{Address, Decimal, GCode, GGroup, Micro, Plane};
use crate::resolve::centers_without_use;
use crate::syntax::BlockFlags;

/// Whether a block moved, for the cycles that a motion calls.
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

/// Executes the motion or the data words of the block.
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, block: &mut Block) -> Moved {
    let words = &block.words;
    let merged = site.file.flags(site.block).has(BlockFlags::MERGED);
    if words.unknown_g || merged || is_unknown(words, &block.g) {
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
    if let Some(cycle) = unmapped_cycle(site.machine(), words, &block.g, kind) {
        apply_unmapped_cycle(site, state, block, cycle);
        return Moved::No;
    }
    let centered = words.i.is_some() || words.j.is_some();
    let full_circle = kind.is_arc() && words.axis_count == 0 && centered && words.has(GCode::G23).is_none();
    let is_arc = kind.is_arc() && (words.axis_count > 0 || full_circle);
    use_center_words(site, state, block, is_arc, kind.is_arc());
    let Block { words, g, travels, effect, .. } = block;
    if words.axis_count == 0 && !full_circle {
        return Moved::No;
    }
    // It may be a cycle (§13): nothing is known but what is wrong with the arc, and the axes are unknown after it.
    let may_be_cycle = g.unknown.has(GGroup::G8);
    if (kind.is_working() || kind == MotionType::Thread) && !may_be_cycle {
        warnings::check_motion(site, state, words, g, kind == MotionType::Thread);
    }
    let reading = Reading::of(site.machine(), state, g);
    reading.travels(site.machine(), state, words, travels);
    spindle::check(site, state, travels);
    let plane = if kind.is_arc() { planes::axes_of(&site.machine().axes, planes::in_force(g)) } else { None };
    let stale = settle_origin(state, travels, plane);
    let mut moving = Moving { kind, stale, spindle: spindle::axis(site.machine(), state), arc: None };
    if kind == MotionType::Reference {
        for travel in travels.iter() {
            state.set_position(travel.axis, Position::Unknown);
        }
    } else if kind.is_arc() {
        let found = find_arc(site, state, words, g, &moving, travels).filter(|_| !may_be_cycle);
        let Some(arc) = found else {
            for travel in travels.iter() {
                state.set_position(travel.axis, Position::Undetermined);
            }
            return if full_circle { Moved::WithoutCycle } else { Moved::Yes };
        };
        moving.arc = Some(arc);
        if arc.computed.is_some() {
            arrive(site, state, travels);
        } else {
            arrive_from_unknown(site, state, travels);
        }
    } else {
        arrive(site, state, travels);
    }
    *effect = Effect::Motion(moving);
    if full_circle || kind == MotionType::Reference { Moved::WithoutCycle } else { Moved::Yes }
}

/// The fixed cycle in force, when a block with axis words does what nobody knows (GRP-6): no configuration maps it.
fn unmapped_cycle(machine: &Machine, words: &BlockWords, g: &InForce, kind: MotionType) -> Option<GCode> {
    let cycle = g.of(GGroup::G8).filter(|code| code.is_cycle())?;
    let unknown =
        words.axis_count > 0 && kind != MotionType::Reference && !machine.cycles.contains_key(&cycle.number());
    unknown.then_some(cycle)
}

/// A block whose motion only the control knows: its words are kept as they are, its axes are unknown after it.
fn apply_unmapped_cycle(site: &mut Site<'_>, state: &mut State, block: &mut Block, cycle: GCode) {
    let Block { words, g, travels, centers, .. } = block;
    let written = words.has(cycle).or_else(|| words.first_axis_word());
    let at = written.map_or_else(|| site.block_place(), |word| site.word_place(word));
    // A height without a value has its finding, which says what a cycle takes and that it is not known.
    let height = site.file.words(site.block).iter().any(|word| word.address == Address::R && word.is_void());
    if height && words.has(cycle).is_some() {
        state.said.unmodelled.push(cycle);
    } else {
        report_unmodelled(site, state, cycle, at);
    }
    let reading = Reading::of(site.machine(), state, g);
    reading.travels(site.machine(), state, words, travels);
    spindle::check(site, state, travels);
    for (axis, valued) in words.axis_words() {
        state.set_position(axis, Position::Undetermined);
        if let (Some(definition), Some(value)) = (site.machine().axes.get(axis), valued.value) {
            centers.push((definition.letter.letter(), value));
        }
    }
    let dynamic = choose_dynamic_set(site, state, words);
    for (letter, valued) in [('I', words.i), ('J', words.j), ('K', words.k)] {
        if !(letter == 'I' && dynamic) {
            centers.extend(valued.and_then(|valued| valued.value).map(|value| (letter, value)));
        }
    }
}

/// The axes of the motion whose programmed start is not where the tool stands (MOT-8). `plane`: the axes of the plane
/// in force, which an arc moves too. The motion of an axis ends that state for it.
#[inline]
pub(super) fn settle_origin(state: &mut State, travels: &[Travel], plane: Option<[usize; 2]>) -> AxisSet {
    let mut stale = AxisSet::default();
    if state.unsettled.is_empty() {
        return stale;
    }
    let unsettled = state.unsettled;
    let by_plane = plane.filter(|_| travels.len() < 2).into_iter().flatten();
    for axis in travels.iter().map(|travel| travel.axis).chain(by_plane) {
        state.unsettled.remove(axis);
        if unsettled.contains(axis) {
            stale.insert(axis);
        }
    }
    stale
}

/// Whether what the block does depends on a group whose function nobody knows. Two axis words are the plane of their
/// arc (MOT-3), and what is wrong with it does not depend on a cycle (§13); with others the plane in force counts, with
/// none also whether G23 takes I.
fn is_unknown(words: &BlockWords, g: &InForce) -> bool {
    if words.other_axis && (words.i.is_some() || words.j.is_some() || kind_in_force(g).is_arc()) {
        return true;
    }
    if g.unknown.is_empty() {
        return false;
    }
    let others: &[GGroup] = match (kind_in_force(g).is_arc(), words.axis_count) {
        (true, 2) => &[],
        (true, 0) => &[GGroup::G1, GGroup::G2, GGroup::G8],
        (true, _) => &[GGroup::G1, GGroup::G8],
        (false, _) => &[GGroup::G8],
    };
    g.unknown.has_any(&[GGroup::G0, GGroup::G9, GGroup::G10]) || g.unknown.has_any(others)
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
    let other_letters = is_arc && !spiral && other_centers::report_k(site, state, words, g);
    // G02 or G03 that is missing in one arc is missing in the next.
    let arc_words = words.axis_count > 0 && words.i.is_some() && words.j.is_some();
    let without_use = arc_words && !(is_arc || circular || spiral || cycle || thread);
    let goes_on = without_use
        && state.said.stray_centers.goes_on(site.file.file, site.block)
        && words.written(GGroup::G0).is_none();
    // Nobody knows whether it is an arc, or whether G09, G10 or G23 takes the word.
    let taken = g.unknown.has(GGroup::G2) && !(is_arc && words.axis_count == 2);
    let silent = goes_on || taken || !is_arc && g.unknown.has(GGroup::G0);
    let mut useless = Vec::new();
    for (letter, valued) in [('I', words.i), ('J', words.j), ('K', words.k)] {
        // A malformed word has its finding.
        let Some(valued) = valued.filter(|valued| !valued.word.is_void()) else { continue };
        if (letter == 'I' && dynamic) || (letter == 'K' && other_letters) {
            continue;
        }
        let kept = if is_arc && letter == 'K' { spiral } else { spiral || cycle || thread };
        if kept {
            centers.extend(valued.value.map(|value| (letter, value)));
        } else if !(silent || is_arc && letter != 'K') {
            useless.push((letter, site.word_place(valued.word)));
        }
    }
    let of_arc = circular && matches!(useless.first(), Some(('K', _)));
    let place = if of_arc { CenterPlace::ThirdInArc } else { CenterPlace::NoUse };
    match centers_without_use(&useless, place) {
        Some((finding, at)) if of_arc => {
            arc_findings::found(site, state, (words, g), finding, at);
            // It may have been meant as the other word of the centre.
            if words.i.is_some() || words.j.is_some() {
                words.j = words.k.map(|k| Valued { value: None, ..k });
            }
        }
        Some((finding, at)) => site.found(finding, at),
        None => {}
    }
}

/// A block whose words are data (GRP-4): nothing moves.
fn apply_data(site: &mut Site<'_>, state: &mut State, block: &mut Block, function: GCode) {
    let Block { words, g, values, effect, .. } = block;
    let table = words.has(GCode::G92).or_else(|| words.has(GCode::G93)).is_some();
    for (axis, valued) in words.axis_words() {
        if let (Some(axis), Some(value)) = (site.machine().axes.get(axis), valued.value) {
            values.push((axis.letter.letter(), value));
        }
    }
    let centers = [('I', words.i), ('J', words.j), ('K', words.k)];
    let centers = centers.into_iter().filter_map(|(letter, valued)| Some((letter, valued?)));
    if table {
        let right = centers.filter(|(_, valued)| !valued.word.is_void());
        let useless: Vec<_> = right.map(|(letter, valued)| (letter, site.word_place(valued.word))).collect();
        // Found before execution where the function is written out.
        if let Some((finding, at)) = centers_without_use(&useless, CenterPlace::InTableBlock) {
            site.found(finding, at);
        }
    } else {
        values.extend(centers.filter_map(|(letter, valued)| Some((letter, valued.value?))));
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
    state.unsettled = AxisSet::ALL;
    if words.has(GCode::G93).is_some() {
        // The named axes are at the programmed coordinates (GRP-4).
        for (axis, _) in words.axis_words() {
            state.unsettled.remove(axis);
        }
    }
}

/// The arc that the block moves along, with its findings. `None`: its axes make no arc.
fn find_arc(
    site: &mut Site<'_>,
    state: &mut State,
    words: &BlockWords,
    g: &InForce,
    moving: &Moving,
    travels: &mut Vec<Travel>,
) -> Option<ArcFacts> {
    let machine = site.machine();
    // A word that cannot be read may have been meant as another axis.
    let unclear = words.axis_words().any(|(_, valued)| valued.word.is_void());
    let plane = planes::in_force(g);
    let Some((pair, helix)) = planes::of_arc(planes::axes_of(&machine.axes, plane), travels) else {
        let centered = words.i.is_some() || words.j.is_some();
        let goes_on = !centered && state.said.no_center.goes_on(site.file.file, site.block);
        if unclear || goes_on && words.written(GGroup::G0).is_none() {
            return None;
        }
        let of_machine = |plane: &Plane| planes::axes_of(&machine.axes, *plane).is_some();
        let other = Plane::ALL.into_iter().find(of_machine).filter(|_| !of_machine(&plane));
        let plane = format!("{} ({})", plane.name, plane.function);
        let finding = Finding::ArcAxes { plane, many: travels.len() > 3, other };
        arc_findings::found(site, state, (words, g), finding, words.place_of_motion(site));
        return None;
    };
    let zero = |word: Option<Valued>| word.is_none_or(|valued| valued.value == Some(Decimal::ZERO));
    let centered = !(zero(words.i) && zero(words.j));
    let helical = g.of(GGroup::G2) == Some(GCode::G09) || g.unknown.has(GGroup::G2);
    let off_plane = helix.is_some() && centered && !helical && !unclear;
    if !unclear {
        arc_findings::check_plane(site, state, words, g, pair);
    }
    stay(machine, state, pair, travels);
    let named = planes::named(&machine.axes, pair);
    let [first, second] = named.map(|axis| machine.axes.get(axis).map(|axis| axis.letter));
    let mut arc = ArcFacts { plane: [first?, second?], helix, to_center: None, computed: None };
    arc.to_center = center(site, state, words, g, named);
    let path = arc.to_center.and_then(|to_center| {
        let [start, end] = ends(site, state, (words, g), named, travels)?;
        Some(Arc { start, end, to_center, counter_clockwise: moving.kind == MotionType::ArcCcw })
    });
    let tolerance = Micro::from(machine.limits.arc_tolerance).to_f64();
    let computed = path.as_ref().map(Arc::compute);
    let fits = computed.as_ref().is_none_or(|computed| arc::radii_agree(computed, tolerance));
    // One of its words was meant as another.
    if off_plane && fits {
        arc_findings::found(site, state, (words, g), Finding::HelixWithoutG09 {}, words.place_of_motion(site));
    }
    let (Some(path), Some(computed)) = (path, computed) else { return Some(arc) };
    if !fits {
        arc_findings::radii(site, state, (words, g), words.place_of_motion(site), named, (&path, &computed));
    } else if path.start != path.end {
        // The mode in force was meant.
        state.said.arc_mode = false;
    }
    // Of an axis that the arc does not have one finding is enough.
    let is_stale =
        if off_plane { pair.iter().any(|axis| moving.stale.contains(*axis)) } else { !moving.stale.is_empty() };
    if is_stale && !unclear {
        arc_findings::found(site, state, (words, g), Finding::ArcAfterOriginChange {}, words.place_of_motion(site));
    }
    arc.computed = Some(computed);
    Some(arc)
}

/// Both axes of an arc move, also one that no word names: it comes back to where it stood (MOT-3).
fn stay(machine: &Machine, state: &State, pair: [usize; 2], travels: &mut Vec<Travel>) {
    for axis in pair {
        let Some(definition) = machine.axes.get(axis) else { continue };
        if let Err(at) = travels.binary_search_by_key(&axis, |travel| travel.axis) {
            let before = state.position(axis);
            let distance = Some(Micro::ZERO);
            let stays = Travel { axis, definition, before, after: before, distance, incremental: false, word: None };
            travels.insert(at, stays);
        }
    }
}

/// The way from the start of an arc to its centre, along its axes, first-named first. `None`: it is unknown, or missing
/// and reported.
fn center(
    site: &mut Site<'_>,
    state: &mut State,
    words: &BlockWords,
    g: &InForce,
    named: [usize; 2],
) -> Option<[Micro; 2]> {
    let value = |word: Option<Valued>| word.map_or(Some(Decimal::ZERO), |valued| valued.value);
    let (i, j) = (value(words.i)?, value(words.j)?);
    if i == Decimal::ZERO && j == Decimal::ZERO {
        arc_findings::missing_center(site, state, words, g, words.place_of_motion(site));
        return None;
    }
    let [i, j] = [Micro::from(i), Micro::from(j)];
    let [for_i, _] = arc_findings::center_axes(site.machine(), named);
    Some(if for_i == named[0] { [i, j] } else { [j, i] })
}

/// Start and end of an arc along its axes. `None`: one is unknown.
fn ends(
    site: &mut Site<'_>,
    state: &mut State,
    block: (&BlockWords, &InForce),
    named: [usize; 2],
    travels: &[Travel],
) -> Option<[[Micro; 2]; 2]> {
    let start = named.map(|axis| state.position(axis));
    let end = named.map(|axis| {
        let travel = travels.iter().find(|travel| travel.axis == axis);
        travel.map_or_else(|| state.position(axis), |travel| travel.after)
    });
    let (Some(start_u), Some(start_v)) = (start[0].known(), start[1].known()) else {
        arc_findings::unknown_start(site, state, block, block.0.place_of_motion(site), named, start);
        return None;
    };
    Some([[start_u, start_v], [end[0].known()?, end[1].known()?]])
}
