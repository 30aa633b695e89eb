//! The equidistant: the path of the tool's centre under G41 and G42, from the radii of `[corrections]` (EQU-1…EQU-4),
//! and what is wrong with it (W0811, W0812).

mod curve;
mod path;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use curve::{Curve, minus};
use path::{Corrected, Leg, Mark};

use crate::config::Settings;
use crate::diag::{Diagnostic, Finding, Findings};
use crate::dict::{Address, AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::run::{End, Executed, Motion, MotionType, Sink};
use crate::text::Location;

/// The axes of a plane, first-named first, and the one across it.
type Plane = [AxisLetter; 3];

/// A piece of the corrected path.
#[derive(Clone, Debug, PartialEq)]
pub struct EquidistantPiece {
    /// The executed block that it belongs to.
    pub seq: u64,
    /// X, Y and Z in millimetres.
    pub points: Vec<[f64; 3]>,
    /// There is no room for the tool.
    pub collides: bool,
}

/// A finding about a block, raised when nothing is left of it.
#[derive(Debug)]
struct Pending {
    at: Location,
    finding: Finding,
}

/// Reads executed blocks, and makes the corrected path of them.
#[derive(Debug)]
pub struct Equidistant {
    radii: BTreeMap<u8, Decimal>,
    corrected: Corrected,
    plane: Option<Plane>,
    /// Where X, Y and Z stand, in mm.
    stand: [Option<f64>; 3],
    /// Blocks whose pieces are not finished yet, the first of them counted from `first`.
    pending: BTreeMap<usize, Pending>,
    next: usize,
    reported: BTreeSet<Location>,
    unknown: BTreeSet<i64>,
    /// The pieces, when they are wanted.
    pieces: Option<Vec<EquidistantPiece>>,
}

impl Equidistant {
    /// For programs checked or drawn with these settings. `draws`: the pieces are wanted, not only what is wrong.
    pub fn new(settings: &Settings, draws: bool) -> Self {
        Self {
            radii: settings.machine.corrections.clone(),
            corrected: Corrected::default(),
            plane: None,
            stand: [None; 3],
            pending: BTreeMap::new(),
            next: 0,
            reported: BTreeSet::new(),
            unknown: BTreeSet::new(),
            pieces: draws.then(Vec::new),
        }
    }

    /// Whether radii are configured.
    pub fn is_wanted(&self) -> bool {
        !self.radii.is_empty()
    }

    /// The pieces, in the order of execution.
    pub fn pieces(&self) -> &[EquidistantPiece] {
        self.pieces.as_deref().unwrap_or_default()
    }

    /// The next executed block.
    pub fn read(&mut self, block: &Executed<'_>, findings: &mut Findings) {
        if !self.is_wanted() {
            return;
        }
        if let Some(motion) = block.motion() {
            self.follow(block, &motion, findings);
            self.collect(findings);
        }
        self.stand = SPACE.map(|axis| block.position(axis).map(Micro::to_f64));
    }

    /// The program is over.
    pub fn finish(&mut self, findings: &mut Findings) {
        self.corrected.stop();
        self.collect(findings);
    }

    fn follow(&mut self, block: &Executed<'_>, motion: &Motion<'_>, findings: &mut Findings) {
        let side = match block.g(GGroup::G3) {
            Some(GCode::G41) => 1.0,
            Some(GCode::G42) => -1.0,
            Some(_) | None => 0.0,
        };
        let plane = plane(block);
        if plane != self.plane {
            self.corrected.stop();
            self.plane = plane;
        }
        let leg = plane.and_then(|plane| self.leg(block, motion, plane));
        let Some(leg) = leg else { return self.corrected.stop() };
        let mark = Mark { seq: block.seq(), block: self.next };
        self.next += 1;
        if side == 0.0 {
            return self.corrected.leave(mark, leg);
        }
        let Some((d, radius)) = self.radius(block, findings) else { return self.corrected.stop() };
        let shown = radius.to_string();
        let arc = leg.curve.and_then(|curve| match curve {
            Curve::Arc { radius: own, .. } if curve.offset(side * float(radius)).is_none() => {
                Some(Micro::from_f64(own))
            }
            Curve::Arc { .. } | Curve::Line { .. } => None,
        });
        let arc = arc.map(shown_micro);
        let finding = Finding::CorrectionCollides { d, radius: shown, arc };
        self.pending.insert(mark.block, Pending { at: block.place(), finding });
        self.corrected.follow(mark, leg, side * float(radius));
    }

    /// D in force with its radius. Reports a missing one once.
    fn radius(&mut self, block: &Executed<'_>, findings: &mut Findings) -> Option<(u32, Decimal)> {
        let number = block.d()?.as_whole()?;
        let d = u8::try_from(number).ok();
        if let Some(radius) = d.and_then(|d| self.radii.get(&d)) {
            return Some((u32::try_from(number).ok()?, *radius));
        }
        if self.unknown.insert(number) {
            let d = u32::try_from(number).ok()?;
            let file = block.file();
            let (_, id) = block.at();
            let word = file.and_then(|file| file.words(id).iter().find(|word| word.address == Address::D).copied());
            let at = file.zip(word).map_or_else(|| block.place(), |(file, word)| file.word_place(word));
            findings.add(Diagnostic::new(Finding::UnknownCorrection { d }, at));
        }
        None
    }

    /// The motion in its plane; `None` when its start or end is not known.
    fn leg(&self, block: &Executed<'_>, motion: &Motion<'_>, plane: Plane) -> Option<Leg> {
        if motion.kind() == MotionType::Reference {
            return None;
        }
        let start = |axis: AxisLetter| {
            if motion.moves(axis) { motion.start(axis).map(Micro::to_f64) } else { self.stand_of(axis) }
        };
        // An axis at an unknown position that does not move counts as 0.
        let known =
            |axis: AxisLetter, value: Option<f64>| if motion.moves(axis) { value } else { Some(value.unwrap_or(0.0)) };
        let end = |axis: AxisLetter| block.position(axis).map(Micro::to_f64);
        let [u, v, w] = plane;
        let from = [known(u, start(u))?, known(v, start(v))?];
        let to = [known(u, end(u))?, known(v, end(v))?];
        let heights = [known(w, start(w))?, known(w, end(w))?];
        let curve = match motion.arc() {
            None => (from != to).then_some(Curve::Line { from, to }),
            Some(arc) if arc.plane == [u, v] => {
                let center = arc.center?.map(Micro::to_f64);
                let [x, y] = minus(from, center);
                let sweep = arc.sweep_deg?.to_f64().to_radians();
                let sweep = if motion.kind() == MotionType::ArcCw { -sweep } else { sweep };
                Some(Curve::Arc { center, radius: (x * x + y * y).sqrt(), start: libm::atan2(y, x), sweep })
            }
            Some(_) => return None,
        };
        Some(Leg { curve, from, to, heights })
    }

    fn stand_of(&self, axis: AxisLetter) -> Option<f64> {
        let place = SPACE.iter().position(|known| *known == axis)?;
        self.stand.get(place).copied().flatten()
    }

    /// Takes the finished pieces, and reports those without room.
    fn collect(&mut self, findings: &mut Findings) {
        let Some(plane) = self.plane else { return };
        for piece in self.corrected.take() {
            if let Some(pending) = self.pending.remove(&piece.mark.block)
                && piece.collides
                && self.reported.insert(pending.at)
            {
                findings.add(Diagnostic::new(pending.finding, pending.at));
            }
            if let Some(pieces) = &mut self.pieces {
                let points = piece.points.iter().map(|(point, height)| in_space(plane, *point, *height)).collect();
                pieces.push(EquidistantPiece { seq: piece.mark.seq, points, collides: piece.collides });
            }
        }
    }
}

/// The axes of a picture.
const SPACE: [AxisLetter; 3] = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z];

/// The plane in force; `None` for those with a fourth axis.
fn plane(block: &Executed<'_>) -> Option<Plane> {
    let [x, y, z] = SPACE;
    match block.g(GGroup::G1) {
        Some(GCode::G18) => Some([y, z, x]),
        Some(GCode::G19) => Some([z, x, y]),
        Some(GCode::G17) | None => Some([x, y, z]),
        Some(_) => None,
    }
}

fn in_space(plane: Plane, [u, v]: [f64; 2], w: f64) -> [f64; 3] {
    let mut point = [0.0; 3];
    for (slot, axis) in point.iter_mut().zip(SPACE) {
        let place = plane.iter().position(|known| *known == axis);
        *slot = match place {
            Some(0) => u,
            Some(1) => v,
            _ => w,
        };
    }
    point
}

fn float(value: Decimal) -> f64 {
    Micro::from(value).to_f64()
}

/// A computed length with as many decimals as it needs, three at most.
fn shown_micro(value: Micro) -> String {
    let text = format!("{:.3}", value.to_f64());
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

impl Sink for Equidistant {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        self.read(block, findings);
        ControlFlow::Continue(())
    }

    fn end(mut self, _: End, findings: &mut Findings) {
        self.finish(findings);
    }
}
