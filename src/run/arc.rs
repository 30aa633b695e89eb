//! The geometry of arcs in their plane (MOT-3…MOT-5). Floats live here and are rounded once, on output.

use crate::dict::Micro;

/// An arc in a plane whose first-named axis is `u` and second-named one `v`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    /// Where it starts.
    pub(super) start: [Micro; 2],
    /// Where it ends.
    pub(super) end: [Micro; 2],
    /// From the start to the centre.
    pub(super) to_center: [Micro; 2],
    /// G03: from the first-named to the second-named axis.
    pub(super) counter_clockwise: bool,
}

/// The computed values of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Computed {
    pub(super) center: [Micro; 2],
    /// At the start, in mm.
    pub(super) radius: f64,
    /// At the end, in mm.
    pub(super) end_radius: f64,
    /// Positive, up to 2π.
    pub(super) sweep_rad: f64,
}

impl Arc {
    /// Computes the arc. End equal to start is a full circle (MOT-4).
    pub(super) fn compute(&self) -> Computed {
        let [iu, iv] = self.to_center;
        let center = [add(self.start, self.to_center, 0), add(self.start, self.to_center, 1)];
        let from = [-i128::from(iu.millionths()), -i128::from(iv.millionths())];
        let to = [difference(self.end, center, 0), difference(self.end, center, 1)];
        // Exact, so that an end on the ray of the start is found whatever the size.
        let cross = from[0] * to[1] - from[1] * to[0];
        let dot = from[0] * to[0] + from[1] * to[1];
        let turn = libm::atan2(float(cross), float(dot));
        let turn = if self.counter_clockwise { turn } else { -turn };
        let sweep_rad = if turn <= 0.0 { turn + std::f64::consts::TAU } else { turn };
        Computed { center, radius: radius(self.to_center), end_radius: length(to), sweep_rad }
    }
}

/// The length of the vector from the start to the centre, in mm.
pub(super) fn radius(to_center: [Micro; 2]) -> f64 {
    let [u, v] = to_center;
    length([i128::from(u.millionths()), i128::from(v.millionths())])
}

/// Whether radii of that difference make one arc (MOT-4); equality is allowed.
pub(super) fn radii_agree(computed: &Computed, tolerance_mm: f64) -> bool {
    let allowed = tolerance_mm.max(computed.radius / 1000.0);
    // A nanometre absorbs what the square roots round.
    (computed.radius - computed.end_radius).abs() <= allowed + 1e-6
}

fn add(a: [Micro; 2], b: [Micro; 2], at: usize) -> Micro {
    let pick = |point: [Micro; 2]| if at == 0 { point[0] } else { point[1] };
    pick(a).plus(pick(b))
}

fn difference(a: [Micro; 2], b: [Micro; 2], at: usize) -> i128 {
    let pick = |point: [Micro; 2]| i128::from(if at == 0 { point[0] } else { point[1] }.millionths());
    pick(a) - pick(b)
}

fn length(vector: [i128; 2]) -> f64 {
    let [u, v] = vector;
    (float(u) * float(u) + float(v) * float(v)).sqrt() / 1e6
}

#[expect(clippy::cast_precision_loss, reason = "rounded to the nearest double, the same on every machine")]
fn float(value: i128) -> f64 {
    value as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(end: [i64; 2], to_center: [i64; 2], counter_clockwise: bool) -> Computed {
        let mm = |point: [i64; 2]| point.map(|value| Micro::from_millionths(value * 1_000_000));
        Arc { start: mm([10, 0]), end: mm(end), to_center: mm(to_center), counter_clockwise }.compute()
    }

    /// MOT-5: G03 turns from the first to the second axis; MOT-4: full circles.
    #[test]
    fn sweeps() {
        let degrees = |computed: Computed| computed.sweep_rad.to_degrees().round();
        assert_eq!(degrees(arc([0, 10], [-10, 0], true)), 90.0);
        assert_eq!(degrees(arc([0, 10], [-10, 0], false)), 270.0);
        assert_eq!(degrees(arc([10, 0], [-10, 0], true)), 360.0);
        assert_eq!(degrees(arc([10, 0], [-10, 0], false)), 360.0);
        assert_eq!(degrees(arc([-10, 0], [-10, 0], false)), 180.0);
    }

    /// MOT-4: a difference equal to the tolerance is allowed.
    #[test]
    fn tolerance() {
        let micro = |value: i64| Micro::from_millionths(value);
        let with_end = |end: i64| {
            let arc = Arc {
                start: [micro(1_000_000), micro(0)],
                end: [micro(0), micro(end)],
                to_center: [micro(-1_000_000), micro(0)],
                counter_clockwise: true,
            };
            radii_agree(&arc.compute(), 0.01)
        };
        assert!(with_end(1_010_000));
        assert!(!with_end(1_011_000));
    }
}
