//! Joints: which are passed continuously, which not and why (CNT-1…CNT-3), and the caps of blocks and joints
//! (VEL-1…VEL-7).

use super::model::Model;
use super::step::{Direction, Dynamics, Mode, Unit};
use super::times::{Break, CapBy, Limit};
use crate::config::{Profile, Recognition};
use crate::run::MotionType;

/// A motion, or a piece of several that are joined.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Which block's record it has: blocks are counted as they come.
    pub slot: u64,
    pub seq: u64,
    pub n: u32,
    pub kind: MotionType,
    pub unit: Unit,
    /// The function of group G2 in its first block.
    pub mode: Mode,
    /// The same in the block of its record.
    pub end_mode: Mode,
    pub length: Option<f64>,
    pub from: Direction,
    pub to: Direction,
    pub vector: [f64; 9],
    pub programmed: Option<f64>,
    pub radius: Option<f64>,
    pub dynamics: Dynamics,
    pub dwells: bool,
    pub stops: bool,
    pub breaks_before: bool,
    pub breaks_after: bool,
    /// Whether it is one of the short blocks that may be joined.
    pub plain: bool,
    pub is_piece: bool,
    /// The piece before it.
    pub with: Option<With>,
    pub broken: Option<Break>,
    /// Tangent of half the angle at it; where both directions are known.
    pub half_tan: Option<f64>,
}

/// The part of a piece that the joint behind it depends on.
#[derive(Clone, Copy, Debug)]
pub(super) struct With {
    pub seq: u64,
    pub n: u32,
    pub kind: MotionType,
    /// Working motion in G23, by the mode of its first block (DOT-1).
    pub in_g23: bool,
    /// The mode of the block that the joint is behind, and that its end waits by (TIM-1).
    pub end_mode: Mode,
    pub length: Option<f64>,
    pub programmed: Option<f64>,
}

impl With {
    /// Whether the block before the joint is a working motion in G23.
    pub(super) fn ends_in_g23(self) -> bool {
        self.kind.is_working() && self.end_mode == Mode::Continuous
    }
}

impl Piece {
    /// Itself as the piece before another one.
    pub(super) fn as_with(&self) -> With {
        let Self { seq, n, kind, end_mode, length, programmed, .. } = *self;
        With { seq, n, kind, in_g23: self.is_in_g23(), end_mode, length, programmed }
    }

    /// Working motion in G23, by the mode of its first block (DOT-1).
    pub(super) fn is_in_g23(&self) -> bool {
        self.kind.is_working() && self.mode == Mode::Continuous
    }

    /// Programmed velocity, where it is known and not 0.
    pub(super) fn velocity(&self) -> Option<f64> {
        self.programmed.filter(|velocity| *velocity > 0.0)
    }

    /// Whether its time is known.
    pub(super) fn is_timed(&self) -> bool {
        self.length.is_some() && self.velocity().is_some() && self.kind != MotionType::Reference
    }

    const fn has_unknown(&self) -> bool {
        let unknown = matches!(self.from, Direction::Unknown) || matches!(self.to, Direction::Unknown);
        // Motion that no joint can be continuous with needs no direction.
        unknown || self.length.is_none()
    }
}

/// The reasons `start` … `axes` (CNT-2) between two blocks; `idle`: blocks without motion were executed between them.
pub(super) fn early_break(model: &Model, earlier: Option<&Piece>, idle: bool, later: &Piece) -> Option<Break> {
    let Some(earlier) = earlier else { return Some(Break::Start) };
    let other = |kind: MotionType| matches!(kind, MotionType::Thread | MotionType::Reference);
    // Each block in G98 begins and ends with a ramp (CNT-1); in G24 the earlier one may go on (CNT-3).
    if later.mode != Mode::Continuous || earlier.mode == Mode::Basic {
        Some(Break::Mode)
    } else if earlier.kind == MotionType::Rapid || later.kind == MotionType::Rapid {
        Some(Break::Rapid)
    } else if idle {
        Some(Break::NoMotion)
    } else if other(earlier.kind) || other(later.kind) {
        Some(Break::OtherMotion)
    } else if earlier.dwells {
        Some(Break::Dwell)
    } else if earlier.stops {
        Some(Break::Stop)
    } else if earlier.breaks_after || later.breaks_before {
        Some(Break::MFunction)
    } else if earlier.has_unknown() || later.has_unknown() || earlier.velocity().is_none() || later.velocity().is_none()
    {
        Some(Break::Unknown)
    } else {
        let apart = match model.recognition {
            // An arc with one axis beyond the three may have no direction along these at its other end.
            Recognition::Automatic => [earlier.to, later.from].contains(&Direction::Still),
            Recognition::Manual => earlier.unit != later.unit,
        };
        apart.then_some(Break::Axes)
    }
}

/// The reasons `short_length` … `angle` between two pieces that nothing before them breaks; `allowed` is the tangent of
/// half the tolerance angle.
pub(super) fn late_break(model: &Model, allowed: f64, earlier: &Piece, later: &Piece) -> Option<Break> {
    let short = |piece: &Piece| piece.length.is_some_and(|length| length < model.break_mm);
    let brief = |piece: &Piece| match (piece.length, piece.velocity()) {
        (Some(length), Some(velocity)) => length < model.shortest_s * velocity,
        _ => false,
    };
    if model.break_mm > 0.0 && (short(earlier) || short(later)) {
        Some(Break::ShortLength)
    } else if model.profile == Profile::Ramps && (brief(earlier) || brief(later)) {
        Some(Break::ShortTime)
    } else if model.recognition == Recognition::Automatic {
        // An angle equal to the tolerance is not below it, however it was rounded.
        later.half_tan.is_none_or(|tan| tan >= allowed * (1.0 - 1e-12)).then_some(Break::Angle)
    } else {
        None
    }
}

/// Tangent of half the angle between two directions; none where one is not known, or neither axis moves.
pub(super) fn half_tan(earlier: Direction, later: Direction) -> Option<f64> {
    let (Direction::Along(a), Direction::Along(b)) = (earlier, later) else { return None };
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let square = |v: [f64; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (sine, lengths) = (square(cross).sqrt(), (square(a) * square(b)).sqrt());
    if sine == 0.0 {
        return Some(if dot >= 0.0 { 0.0 } else { f64::INFINITY });
    }
    // Where the angle is near 180 degrees the sum loses its digits; the sine does not.
    Some(if dot >= 0.0 { sine / (lengths + dot) } else { (lengths - dot) / sine })
}

/// The angle, degrees.
pub(super) fn angle_deg(half_tan: f64) -> f64 {
    if half_tan.is_infinite() { 180.0 } else { 2.0 * libm::atan(half_tan).to_degrees() }
}

/// What limits the velocity in a block (VEL-7).
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockCaps {
    pub programmed: f64,
    pub centripetal: f64,
    pub shortest: f64,
    pub by: CapBy,
}

impl BlockCaps {
    /// Of a piece whose time is known; `stretch`: it lies in a stretch.
    pub(super) fn of(model: &Model, piece: &Piece, stretch: bool) -> Self {
        let programmed = piece.programmed.unwrap_or(0.0);
        let arc = matches!(piece.kind, MotionType::ArcCw | MotionType::ArcCcw);
        let centripetal = match piece.radius {
            Some(radius) if arc && piece.dynamics.centripetal > 0.0 => (piece.dynamics.centripetal * radius).sqrt(),
            Some(_) | None => f64::INFINITY,
        };
        let shortest = match piece.length {
            Some(length) if stretch && model.profile != Profile::Ramps && model.shortest_s > 0.0 => {
                length / model.shortest_s
            }
            Some(_) | None => f64::INFINITY,
        };
        let by = if programmed <= centripetal && programmed <= shortest {
            if piece.kind == MotionType::Rapid { CapBy::Rapid } else { CapBy::Feed }
        } else if centripetal <= shortest {
            CapBy::Centripetal
        } else {
            CapBy::ShortestBlock
        };
        Self { programmed, centripetal, shortest, by }
    }

    /// The block cap.
    pub(super) fn least(&self) -> f64 {
        self.programmed.min(self.centripetal).min(self.shortest)
    }
}

/// What limits the velocity at a continuous joint (VEL-7), in the order of [`Limit`].
#[derive(Clone, Copy, Debug)]
pub(super) struct JointCaps {
    feed: f64,
    centripetal: f64,
    shortest: f64,
    accuracy: f64,
    overload: f64,
}

impl JointCaps {
    /// Between two blocks; the angle between them by the tangent of its half.
    pub(super) fn of(
        model: &Model,
        (one, one_caps): (&Piece, &BlockCaps),
        (other, other_caps): (&Piece, &BlockCaps),
    ) -> Self {
        let tan = other.half_tan.unwrap_or(0.0);
        let criteria = |dynamics: &Dynamics| {
            if model.profile == Profile::Ramps || tan == 0.0 {
                return (f64::INFINITY, f64::INFINITY);
            }
            let sine = if tan.is_infinite() { 1.0 } else { tan / (1.0 + tan * tan).sqrt() };
            let on =
                |value: f64, velocity: f64| if value > 0.0 && model.cycle_ms > 0.0 { velocity } else { f64::INFINITY };
            // µm/ms are mm/s.
            let accuracy = on(dynamics.accuracy_um, dynamics.accuracy_um / (model.cycle_ms * tan));
            let overload = on(dynamics.overload, dynamics.overload * model.cycle_ms / 1000.0 / (2.0 * sine));
            (accuracy, overload)
        };
        let (first, second) = (criteria(&one.dynamics), criteria(&other.dynamics));
        Self {
            feed: one_caps.programmed.min(other_caps.programmed),
            centripetal: one_caps.centripetal.min(other_caps.centripetal),
            shortest: one_caps.shortest.min(other_caps.shortest),
            accuracy: first.0.min(second.0),
            overload: first.1.min(second.1),
        }
    }

    /// The joint cap.
    pub(super) fn least(&self) -> f64 {
        self.feed.min(self.centripetal).min(self.shortest).min(self.accuracy).min(self.overload)
    }

    /// Programmed feeds alone.
    pub(super) const fn feed(&self) -> f64 {
        self.feed
    }

    /// What gives the velocity there; `seen`: the cap by look-ahead, where more follows than is seen.
    pub(super) fn limit(&self, velocity: f64, seen: f64) -> Limit {
        let caps = [
            (self.feed, Limit::Feed),
            (self.centripetal, Limit::Centripetal),
            (self.shortest, Limit::ShortestBlock),
            (self.accuracy, Limit::Accuracy),
            (self.overload, Limit::Overload),
            (seen, Limit::LookAhead),
        ];
        let gives = |(cap, _): &(f64, Limit)| velocity >= cap * (1.0 - 1e-9);
        caps.iter().find(|cap| gives(cap)).map_or(Limit::Ramp, |(_, limit)| *limit)
    }
}
