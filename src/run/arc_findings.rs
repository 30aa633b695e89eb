//! Findings about arcs that cannot be right (MOT-4), with advice that leads to the intended arc.

use super::arc::{self, Arc, Computed};
use super::block::InForce;
use super::parameters::with_origin;
use super::planes;
use super::site::Site;
use super::state::{Position, State};
use super::travel::Reading;
use super::words::{BlockWords, Valued};
use crate::config::{ArcCenters, Machine};
use crate::diag::{ArcMeant, ArcPoints, Centers, Diagnostic, Edit, Finding, FixTitle, LabelText, PlaneFault};
use crate::dict::{AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::syntax::{BlockFlags, BlockId, Word};
use crate::text::Location;

/// The axes that I and J belong to (MOT-3): in the order of the machine, also for G19, or as configured in that of the
/// plane's name. Pairs that no plane names keep the order of the machine.
pub(super) fn center_axes(machine: &Machine, named: [usize; 2]) -> [usize; 2] {
    match machine.arc_centers {
        ArcCenters::PlaneOrder => named,
        ArcCenters::MachineOrder => [named[0].min(named[1]), named[0].max(named[1])],
    }
}

/// Shows what makes the block an arc when it does not say so itself.
pub(super) fn because_of(state: &State, words: &BlockWords, g: &InForce, diagnostic: Diagnostic) -> Diagnostic {
    let function = g.of(GGroup::G0).filter(|_| words.written(GGroup::G0).is_none());
    let (Some(function), Some((n, place))) = (function, state.origins.motion) else { return diagnostic };
    let function = if n == 0 { function.to_string() } else { format!("{function} (N{n})") };
    diagnostic.with_label(place, LabelText::MakesArc { function })
}

/// Reports a finding of an arc, with what makes the block one.
pub(super) fn found(
    site: &mut Site<'_>,
    state: &State,
    (words, g): (&BlockWords, &InForce),
    finding: Finding,
    at: Location,
) {
    site.report(because_of(state, words, g, Diagnostic::new(finding, at)));
}

/// W0616: under a radius correction an arc in other axes than those of the plane in force. The first of such arcs has
/// it, until a plane is written.
pub(super) fn check_plane(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce, pair: [usize; 2]) {
    let Some(correction) = g.of(GGroup::G3).filter(|code| *code != GCode::G40) else { return };
    let axes = &site.machine().axes;
    let (plane, meant) = (planes::in_force(g), planes::of_pair(axes, pair));
    if g.unknown.has(GGroup::G1) || meant == Some(plane) {
        return;
    }
    let arc = Some([pair[0].min(pair[1]), pair[0].max(pair[1])]);
    if std::mem::replace(&mut state.said.other_axes, arc) == arc {
        return;
    }
    let letters: Vec<String> = planes::named(axes, pair)
        .into_iter()
        .filter_map(|axis| axes.get(axis))
        .map(|axis| axis.letter.to_string())
        .collect();
    let fault = PlaneFault::OtherAxes { axes: letters.join(", "), correction: correction.to_string() };
    let finding = Finding::PlaneMismatch { plane, fault, meant };
    found(site, state, (words, g), finding, words.place_of_motion(site));
}

/// E0602, with what makes the block an arc when it does not say so itself; then the first of such blocks in a row has
/// it.
pub(super) fn missing_center(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce, at: Location) {
    let modal = words.written(GGroup::G0).is_none();
    let centered = words.i.is_some() || words.j.is_some();
    if state.said.no_center.goes_on(site.file.file, site.block) && modal && !centered {
        return;
    }
    let function = g.of(GGroup::G0).map_or_else(String::new, |code| code.to_string());
    let origin = state.origins.motion.filter(|_| modal);
    let by = origin.map(|(n, _)| format!("{function} (N{n})"));
    let finding = Finding::MissingArcCenter { radius_word: !words.r.is_empty(), by };
    let mut diagnostic = Diagnostic::new(finding, at);
    if let Some((_, place)) = origin {
        diagnostic = diagnostic.with_label(place, LabelText::InForce { function });
    }
    site.report(diagnostic);
}

/// W0606, with the M function that moved the machine; once for an axis, until its position is known.
pub(super) fn unknown_start(
    site: &mut Site<'_>,
    state: &mut State,
    (words, g): (&BlockWords, &InForce),
    at: Location,
    axes: [usize; 2],
    start: [Position; 2],
) {
    let unknown = axes.into_iter().zip(start).filter(|(_, position)| *position == Position::Unknown);
    let mut letters = Vec::new();
    let mut news = false;
    for (axis, _) in unknown {
        letters.extend(site.machine().axes.get(axis).map(|axis| axis.letter.to_string()));
        news |= state.said.arc_starts.insert(axis);
    }
    if !news {
        return;
    }
    let mut diagnostic = Diagnostic::new(Finding::ArcFromUnknown { axes: letters.join(", ") }, at);
    if let Some((m, place)) = state.origins.moved {
        diagnostic = diagnostic.with_label(place, LabelText::PositionLost { m });
    }
    site.report(because_of(state, words, g, diagnostic));
}

/// E0603 at I, else at J, with start, centre and end, and what I and J probably are. Arcs that fit under the other of
/// G90 and G91 have it once.
pub(super) fn radii(
    site: &mut Site<'_>,
    state: &mut State,
    (words, g): (&BlockWords, &InForce),
    at: Location,
    named: [usize; 2],
    (arc, computed): (&Arc, &Computed),
) {
    let machine = site.machine();
    let word = words.i.or(words.j).map(|valued| valued.word);
    let place = word.map_or(at, |word| site.word_place(word));
    let radius = |radius: f64| {
        let text = format!("{radius:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    let [for_i, for_j] = center_axes(machine, named);
    let letter = |axis: usize| machine.axes.get(axis).map_or(' ', |axis| axis.letter.letter());
    let in_order = |pair: [Micro; 2]| if for_i == named[0] { pair } else { [pair[1], pair[0]] };
    let text = |pair: [Micro; 2]| in_order(pair).map(|value| value.to_string());
    let x = machine.axes.index(AxisLetter::X).filter(|_| state.modal(GGroup::G10) == Some(GCode::G74));
    let diameter = named.iter().position(|axis| Some(*axis) == x);
    // Where the radii nearly agree, a digit of the end or of the centre is wrong.
    let near = (computed.radius - computed.end_radius).abs() < computed.radius / 50.0;
    let mut meant = if near { ArcMeant::Nothing } else { meant_center(machine, arc, diameter, in_order) };
    if meant == ArcMeant::Nothing && mirrored(machine, arc).is_none() {
        meant = meant_mode(site, state, (words, g), named, arc);
    }
    let other_mode = matches!(meant, ArcMeant::Distances | ArcMeant::Positions);
    let said = std::mem::replace(&mut state.said.arc_mode, other_mode);
    if other_mode && said {
        return;
    }
    let points = ArcPoints {
        axes: [letter(for_i), letter(for_j)],
        start: text(arc.start),
        center: text(computed.center),
        end: text(arc.end),
        diameters: diameter.is_some(),
    };
    let finding = Finding::ArcRadiusMismatch {
        start: radius(computed.radius),
        end: radius(computed.end_radius),
        points: Box::new(points),
        meant,
    };
    let diagnostic = offer(site, words, Diagnostic::new(finding, place));
    let diagnostic = because_of(state, words, g, diagnostic);
    site.report(match word {
        Some(word) => with_origin(state, diagnostic, word),
        None => diagnostic,
    });
}

/// Offers the words that fit in place of those that are written, when these are numbers.
fn offer(site: &Site<'_>, words: &BlockWords, mut diagnostic: Diagnostic) -> Diagnostic {
    let Finding::ArcRadiusMismatch { meant, .. } = &diagnostic.finding else { return diagnostic };
    let pairs = match meant {
        ArcMeant::Coordinates { words } | ArcMeant::Exchanged { words } | ArcMeant::Several { words } => {
            words.0.clone()
        }
        ArcMeant::Nothing | ArcMeant::Distances | ArcMeant::Positions => return diagnostic,
    };
    if [words.i, words.j].into_iter().flatten().any(|valued| valued.word.is_parametric()) {
        return diagnostic;
    }
    for [i, j] in pairs {
        let text = format!("I{i} J{j}");
        let edit = |valued: Valued, text: &str| Edit { at: site.word_place(valued.word), text: text.to_owned() };
        let edits = match (words.i, words.j) {
            (Some(one), Some(other)) => vec![edit(one, &format!("I{i}")), edit(other, &format!("J{j}"))],
            (Some(one), None) | (None, Some(one)) => vec![edit(one, &text)],
            (None, None) => return diagnostic,
        };
        diagnostic = diagnostic.with_offers(FixTitle::Write { text }, edits);
    }
    diagnostic
}

/// Whether the radii of an arc agree (MOT-4).
fn fits(machine: &Machine, arc: &Arc) -> bool {
    arc::radii_agree(&arc.compute(), Micro::from(machine.limits.arc_tolerance).to_f64())
}

/// Whether I and J fit as coordinates of the centre, as the program writes them (`diameter`: X is one), or exchanged.
fn meant_center(
    machine: &Machine,
    arc: &Arc,
    diameter: Option<usize>,
    in_order: impl Fn([Micro; 2]) -> [Micro; 2],
) -> ArcMeant {
    let fits = |to_center: &[Micro; 2]| *to_center != [Micro::ZERO; 2] && fits_about(machine, arc, *to_center);
    let [u, v] = arc.to_center;
    let mut absolute = vec![[u.minus(arc.start[0]), v.minus(arc.start[1])]];
    absolute.extend(diameter.map(|x| {
        let half = |at: usize, value: Micro| if x == at { value.half() } else { value };
        [half(0, u).minus(arc.start[0]), half(1, v).minus(arc.start[1])]
    }));
    absolute.retain(fits);
    let exchanged: Vec<_> = [[v, u]].into_iter().filter(fits).collect();
    let centers = |pairs: Vec<[Micro; 2]>| {
        Centers(pairs.into_iter().map(|to_center| in_order(to_center).map(|value| value.to_string())).collect())
    };
    match (absolute.len(), exchanged.len(), mirrored(machine, arc)) {
        (0, 0, _) => ArcMeant::Nothing,
        (1, 0, None) => ArcMeant::Coordinates { words: centers(absolute) },
        (0, _, None) => ArcMeant::Exchanged { words: centers(exchanged) },
        (.., mirrored) => {
            let mut all = [mirrored.into_iter().collect(), absolute, exchanged].concat();
            all.dedup();
            let alone = all.len() == 1;
            let words = centers(all);
            if alone { ArcMeant::Exchanged { words } } else { ArcMeant::Several { words } }
        }
    }
}

fn fits_about(machine: &Machine, arc: &Arc, to_center: [Micro; 2]) -> bool {
    fits(machine, &Arc { to_center, ..*arc })
}

/// The way to the centre with another sign of I or J with which the arc fits.
fn mirrored(machine: &Machine, arc: &Arc) -> Option<[Micro; 2]> {
    let [u, v] = arc.to_center;
    let minus = |value: Micro| Micro::ZERO.minus(value);
    let mirrored = [[minus(u), v], [u, minus(v)], [minus(u), minus(v)]];
    mirrored.into_iter().find(|to_center| *to_center != arc.to_center && fits_about(machine, arc, *to_center))
}

/// Whether the arc fits under the other of G90 and G91.
fn meant_mode(
    site: &Site<'_>,
    state: &State,
    (words, g): (&BlockWords, &InForce),
    named: [usize; 2],
    arc: &Arc,
) -> ArcMeant {
    // Any arc fits that ends where it starts.
    let fits = |start: [Micro; 2], end: [Micro; 2]| start != end && fits(site.machine(), &Arc { start, end, ..*arc });
    let [u, v] = named.map(|axis| words.axis_words().any(|(other, _)| other == axis));
    let either = |written: bool, end: Micro, stays: Micro| if written { end } else { stays };
    let [[from_u, from_v], [to_u, to_v]] = [arc.start, arc.end];
    match g.of(GGroup::G9) {
        Some(GCode::G90) => {
            let end = [either(u, from_u.plus(to_u), from_u), either(v, from_v.plus(to_v), from_v)];
            if fits(arc.start, end) { ArcMeant::Distances } else { ArcMeant::Nothing }
        }
        Some(GCode::G91) => {
            let reading = Reading::of(site.machine(), state, g);
            let before = |axis| written_before(site, axis).map(|value| reading.coordinate(axis, value));
            let [Some(start_u), Some(start_v)] = named.map(before) else { return ArcMeant::Nothing };
            let end = [either(u, to_u.minus(from_u), start_u), either(v, to_v.minus(from_v), start_v)];
            if fits([start_u, start_v], end) { ArcMeant::Positions } else { ArcMeant::Nothing }
        }
        _ => ArcMeant::Nothing,
    }
}

/// So many blocks before an arc are looked at for the words of its start.
const BEFORE: u32 = 64;

/// The number that was written last for an axis in the blocks of the unit before this one.
fn written_before(site: &Site<'_>, axis: usize) -> Option<Decimal> {
    let letter = site.machine().axes.get(axis)?.letter;
    let blocks = (site.block.0.saturating_sub(BEFORE)..site.block.0).rev();
    let begins = |block: &u32| site.file.flags(BlockId(*block)).has(BlockFlags::ENTRY);
    let blocks = blocks.take_while(|block| !begins(block));
    let of_axis = |word: &&Word| word.address.axis() == Some(letter);
    let words = blocks.filter_map(|block| site.file.words(BlockId(block)).iter().find(of_axis));
    words.map(|word| word.number()).next()?
}
