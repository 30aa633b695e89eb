//! How far motions reach.

use crate::dict::{AxisLetter, Micro};
use crate::run::{ArcPath, Motion, MotionType};

/// The least and the greatest programmed position of each axis.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Extents {
    axes: [Option<(Micro, Micro)>; AxisLetter::ALL.len()],
}

impl Extents {
    /// The axes that moved over known positions, in the order of their letters.
    pub fn axes(&self) -> impl Iterator<Item = (AxisLetter, Micro, Micro)> + '_ {
        AxisLetter::ALL.into_iter().zip(self.axes).filter_map(|(letter, reach)| {
            let (least, greatest) = reach?;
            Some((letter, least, greatest))
        })
    }

    /// Whether no axis moved over known positions.
    pub fn is_empty(&self) -> bool {
        self.axes.iter().all(Option::is_none)
    }

    fn add(&mut self, letter: AxisLetter, position: Micro) {
        if let Some(slot) = self.axes.get_mut(letter as usize) {
            let (least, greatest) = slot.unwrap_or((position, position));
            *slot = Some((least.min(position), greatest.max(position)));
        }
    }

    /// Adds the way of a motion, as far as it is known.
    pub fn add_motion(&mut self, motion: &Motion<'_>) {
        if motion.kind() == MotionType::Reference {
            return;
        }
        for letter in motion.axes() {
            for position in [motion.start(letter), motion.end(letter)].into_iter().flatten() {
                self.add(letter, position);
            }
        }
        if let Some(arc) = motion.arc().filter(|_| motion.kind().is_arc()) {
            self.add_arc(motion, &arc);
        }
    }

    /// The quadrant points that an arc passes.
    fn add_arc(&mut self, motion: &Motion<'_>, arc: &ArcPath) {
        let [u, v] = arc.plane;
        let (Some(center), Some(radius), Some(sweep)) = (arc.center, arc.radius_mm, arc.sweep_deg) else { return };
        let (Some(from_u), Some(from_v)) = (motion.start(u), motion.start(v)) else { return };
        let start = libm::atan2(from_v.minus(center[1]).to_f64(), from_u.minus(center[0]).to_f64()).to_degrees();
        let turn = if motion.kind() == MotionType::ArcCcw { 1.0 } else { -1.0 };
        let quadrants = [
            (0.0, u, center[0].plus(radius)),
            (90.0, v, center[1].plus(radius)),
            (180.0, u, center[0].minus(radius)),
            (270.0, v, center[1].minus(radius)),
        ];
        for (angle, letter, position) in quadrants {
            if ((angle - start) * turn).rem_euclid(360.0) < sweep.to_f64() {
                self.add(letter, position);
            }
        }
    }
}
