//! Arcs, computed step by step as the page does it (`web/src/data/program.ts`).

use crate::dict::Micro;
use crate::run::MotionType;

/// An arc from its start, about its centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swept {
    /// From the start to the centre, along the axes of the plane.
    pub to_center: [Micro; 2],
    radius: f64,
    /// In radians, positive.
    sweep: f64,
}

/// The arc between two points about a centre.
pub(super) fn sweep(start: [Micro; 2], end: [Micro; 2], center: [Micro; 2], kind: MotionType) -> Swept {
    let [start_u, start_v] = start;
    let [end_u, end_v] = end;
    let to_center = [center[0].minus(start_u), center[1].minus(start_v)];
    let [to_u, to_v] = to_center.map(Micro::to_f64);
    let whole = |value: f64| (value * 1e6).round();
    let at_u = whole(end_u.to_f64() - start_u.to_f64() - to_u);
    let at_v = whole(end_v.to_f64() - start_v.to_f64() - to_v);
    let (from_u, from_v) = (whole(-to_u), whole(-to_v));
    let cross = from_u * at_v - from_v * at_u;
    let dot = from_u * at_u + from_v * at_v;
    let turn = libm::atan2(cross, dot);
    let turn = if kind == MotionType::ArcCw { -turn } else { turn };
    let sweep = if turn <= 0.0 { turn + std::f64::consts::TAU } else { turn };
    Swept { to_center, radius: (to_u * to_u + to_v * to_v).sqrt(), sweep }
}

impl Swept {
    pub fn radius(&self) -> Micro {
        Micro::from_f64(self.radius)
    }

    pub fn sweep_deg(&self) -> Micro {
        Micro::from_f64(self.sweep * 180.0 / std::f64::consts::PI)
    }

    /// The angle it turns through, in radians, positive.
    pub const fn sweep(&self) -> f64 {
        self.sweep
    }

    /// How long it is, in mm.
    pub fn path(&self) -> f64 {
        self.radius * self.sweep
    }
}
