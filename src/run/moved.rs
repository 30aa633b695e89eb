//! The motion of an executed block: which axes, from where, to where, along what, how long.

use super::arc::{self, Computed};
use super::state::AxisSet;
use super::travel::Travel;
use crate::dict::{AxisLetter, GCode, Micro};
use crate::named::named;

named! {
    /// How a block moves.
    #[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
    pub enum MotionType {
        /// G00.
        Rapid "rapid",
        /// G01.
        Linear "linear",
        /// G02.
        ArcCw "arc_cw",
        /// G03.
        ArcCcw "arc_ccw",
        /// G33.
        Thread "thread",
        /// G30.
        Reference "reference",
    }
}

impl MotionType {
    /// Whether it is one of G01, G02 and G03.
    pub const fn is_working(self) -> bool {
        match self {
            Self::Linear | Self::ArcCw | Self::ArcCcw => true,
            Self::Rapid | Self::Thread | Self::Reference => false,
        }
    }

    /// Whether it is one of G02 and G03.
    pub const fn is_arc(self) -> bool {
        match self {
            Self::ArcCw | Self::ArcCcw => true,
            Self::Rapid | Self::Linear | Self::Thread | Self::Reference => false,
        }
    }

    /// The motion that a function of group G0 makes; the other functions make none.
    pub(super) const fn of(code: GCode) -> Option<Self> {
        match code {
            GCode::G00 => Some(Self::Rapid),
            GCode::G01 => Some(Self::Linear),
            GCode::G02 => Some(Self::ArcCw),
            GCode::G03 => Some(Self::ArcCcw),
            GCode::G30 => Some(Self::Reference),
            GCode::G33 => Some(Self::Thread),
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
}

/// The facts of a motion, besides how its axes travel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving {
    pub(super) kind: MotionType,
    /// The axes whose programmed start is not where the tool stands (MOT-8).
    pub(super) stale: AxisSet,
    /// The axis that is the spindle at the moment (MFN-10), by place in machine order.
    pub(super) spindle: Option<usize>,
    pub(super) arc: Option<ArcFacts>,
}

/// The facts of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcFacts {
    /// First-named first.
    pub(super) plane: [AxisLetter; 2],
    /// The axis of the helix, by place in machine order.
    pub(super) helix: Option<usize>,
    /// From the start; `None`: unknown.
    pub(super) to_center: Option<[Micro; 2]>,
    /// `None`: the start, the end or the centre is unknown.
    pub(super) computed: Option<Computed>,
}

impl Moving {
    /// See [`Motion::is_in_degrees`].
    #[inline]
    pub(super) fn is_in_degrees(&self, travels: &[Travel]) -> bool {
        let stands = |travel: &Travel| {
            // From where an origin or a correction left it, an axis moves though its number stays (MOT-8).
            let unsettled = self.stale.contains(travel.axis) && !travel.incremental;
            // The values of the axis words of G30 are not used (MOT-7).
            self.kind != MotionType::Reference && travel.distance == Some(Micro::ZERO) && !unsettled
        };
        self.arc.is_none()
            && travels.iter().any(|travel| self.is_rotary(travel))
            && travels.iter().all(|travel| self.is_rotary(travel) || stands(travel))
    }

    fn is_rotary(&self, travel: &Travel) -> bool {
        travel.definition.rotary || self.spindle == Some(travel.axis)
    }
}

/// How a block moves, as its readers see it. Lengths are millimetres, of rotary axes degrees; positions are programmed
/// coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'r> {
    pub(super) moving: &'r Moving,
    pub(super) travels: &'r [Travel],
}

/// How long a motion is (MOT-6).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Length {
    /// In millimetres.
    Mm(Micro),
    /// In degrees: only rotary axes move.
    Deg(Micro),
    /// Not known.
    Missing(Missing),
}

impl Length {
    /// In millimetres, when it is measured in them.
    pub const fn mm(self) -> Option<Micro> {
        match self {
            Self::Mm(length) => Some(length),
            Self::Deg(_) | Self::Missing(_) => None,
        }
    }

    /// Why it is not known.
    pub const fn missing(self) -> Option<Missing> {
        match self {
            Self::Missing(missing) => Some(missing),
            Self::Mm(_) | Self::Deg(_) => None,
        }
    }

    /// In degrees, when it is measured in them.
    pub const fn deg(self) -> Option<Micro> {
        match self {
            Self::Deg(length) => Some(length),
            Self::Mm(_) | Self::Missing(_) => None,
        }
    }
}

named! {
    /// Why the length of a motion is not known.
    #[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
    pub enum Missing {
        /// A distance is not known: the start of an axis (MOT-2), or a value that only the machine has (PAR-5).
        Start "start",
        /// After a change of origin or correction the tool is not where the program says (MOT-8).
        Origin "origin",
        /// A motion to the reference point (MOT-7).
        Reference "reference",
    }
}

/// An arc (MOT-3…MOT-5).
#[derive(Clone, Copy, Debug)]
pub struct ArcPath {
    /// The axes of its plane, first-named first: G03 turns from the first to the second.
    pub plane: [AxisLetter; 2],
    /// The centre along these axes; `None` when the start or the end is not known.
    pub center: Option<[Micro; 2]>,
    /// The way from the start to the centre along these axes.
    pub to_center: Option<[Micro; 2]>,
    /// At the start.
    pub radius_mm: Option<Micro>,
    /// Positive, up to 360.
    pub sweep_deg: Option<Micro>,
    /// The axis along which a helix moves.
    pub helix: Option<AxisLetter>,
}

impl<'r> Motion<'r> {
    /// What kind of motion.
    pub const fn kind(&self) -> MotionType {
        self.moving.kind
    }

    /// The axes that move, in machine order.
    pub fn axes(&self) -> impl Iterator<Item = AxisLetter> + use<'r> {
        self.travels.iter().map(|travel| travel.definition.letter)
    }

    /// Whether an axis moves.
    pub fn moves(&self, axis: AxisLetter) -> bool {
        self.travel(axis).is_some()
    }

    /// Where an axis that moves stands before; `None` when that is not known.
    pub fn start(&self, axis: AxisLetter) -> Option<Micro> {
        self.travel(axis)?.before.known()
    }

    /// Where an axis that moves stands after; `None` when that is not known.
    pub fn end(&self, axis: AxisLetter) -> Option<Micro> {
        self.travel(axis).filter(|_| self.goes_as_written())?.after.known()
    }

    /// By how much the programmed coordinate of an axis changes, with its sign; known also of an axis that moves by G91
    /// from a position that is not.
    pub fn distance(&self, axis: AxisLetter) -> Option<Micro> {
        self.travel(axis).filter(|_| self.goes_as_written())?.distance
    }

    /// The distance of an axis that moves by G91 from an unknown position (MOT-2); `None` for other axes.
    pub fn delta(&self, axis: AxisLetter) -> Option<Micro> {
        let from_unknown = |travel: &&Travel| travel.incremental && travel.before.known().is_none();
        self.travel(axis).filter(|_| self.goes_as_written()).filter(from_unknown)?.distance
    }

    /// Whether the programmed start is not where the tool stands, after a change of origin or correction (MOT-8).
    pub const fn is_stale(&self) -> bool {
        !self.moving.stale.is_empty()
    }

    /// The same of one axis.
    pub fn is_stale_along(&self, axis: AxisLetter) -> bool {
        self.travel(axis).is_some_and(|travel| self.moving.stale.contains(travel.axis))
    }

    /// How long it is.
    pub fn length(&self) -> Length {
        if !self.goes_as_written() {
            return Length::Missing(Missing::Reference);
        }
        if self.is_stale() {
            return Length::Missing(Missing::Origin);
        }
        let length = match &self.moving.arc {
            Some(arc) => self.along_arc(arc),
            None => self.straight(),
        };
        length.unwrap_or(Length::Missing(Missing::Start))
    }

    /// Whether the motion is measured in degrees (MOT-6): no linear axis is in it, or linear ones are named that do not
    /// move, beside rotary ones. An arc never is.
    pub fn is_in_degrees(&self) -> bool {
        self.moving.is_in_degrees(self.travels)
    }

    /// The length of a straight motion: the linear axes alone decide, when one of them moves (MOT-6).
    fn straight(&self) -> Option<Length> {
        let linear = !self.is_in_degrees();
        let mut sum = 0.0;
        for travel in self.travels.iter().filter(|travel| self.moving.is_rotary(travel) != linear) {
            sum += travel.distance?.square();
        }
        let length = Micro::root(sum);
        Some(if linear { Length::Mm(length) } else { Length::Deg(length) })
    }

    fn along_arc(&self, arc: &ArcFacts) -> Option<Length> {
        let computed = arc.computed?;
        let path = computed.radius * computed.sweep_rad;
        let helix = arc.helix.and_then(|axis| self.travels.iter().find(|travel| travel.axis == axis));
        let path = match helix {
            // Axes beyond the two of an arc add to its length only when linear (§13 Motion).
            Some(travel) if !self.moving.is_rotary(travel) => {
                let distance = travel.distance?.to_f64();
                (path * path + distance * distance).sqrt()
            }
            Some(_) | None => path,
        };
        Some(Length::Mm(Micro::from_f64(path)))
    }

    /// The arc, when it is one.
    pub fn arc(&self) -> Option<ArcPath> {
        let arc = self.moving.arc?;
        let letter = |axis| self.travels.iter().find(|travel| travel.axis == axis);
        Some(ArcPath {
            plane: arc.plane,
            center: arc.computed.map(|computed| computed.center),
            to_center: arc.to_center,
            radius_mm: arc.to_center.map(|to_center| Micro::from_f64(arc::radius(to_center))),
            sweep_deg: arc.computed.map(|computed| Micro::from_f64(computed.sweep_rad.to_degrees())),
            helix: arc.helix.and_then(letter).map(|travel| travel.definition.letter),
        })
    }

    /// The points of an arc where an axis of its plane is farthest from the centre, with that axis and its position;
    /// none where the arc is not known.
    pub fn extremes(&self) -> impl Iterator<Item = (AxisLetter, Micro)> + use<> {
        let extremes = self.arc().and_then(|arc| {
            let ([u, v], [center_u, center_v], radius) = (arc.plane, arc.center?, arc.radius_mm?);
            let ([to_u, to_v], sweep) = (arc.to_center?, arc.sweep_deg?.to_f64());
            let start = libm::atan2(-to_v.to_f64(), -to_u.to_f64()).to_degrees();
            let turn = if self.kind() == MotionType::ArcCcw { 1.0 } else { -1.0 };
            let all = [
                (0.0, u, center_u.plus(radius)),
                (90.0, v, center_v.plus(radius)),
                (180.0, u, center_u.minus(radius)),
                (270.0, v, center_v.minus(radius)),
            ];
            let passes = move |angle: f64| ((angle - start) * turn).rem_euclid(360.0) < sweep;
            Some(all.into_iter().filter(move |(angle, ..)| passes(*angle)).map(|(_, axis, position)| (axis, position)))
        });
        extremes.into_iter().flatten()
    }

    /// The axis that is the spindle (M19, MFN-10), when it moves.
    pub fn spindle_axis(&self) -> Option<AxisLetter> {
        let axis = self.moving.spindle?;
        self.travels.iter().find(|travel| travel.axis == axis).map(|travel| travel.definition.letter)
    }

    /// Whether the axes go where their words say: not to the reference point.
    fn goes_as_written(&self) -> bool {
        self.kind() != MotionType::Reference
    }

    fn travel(&self, axis: AxisLetter) -> Option<&'r Travel> {
        self.travels.iter().find(|travel| travel.definition.letter == axis)
    }
}
