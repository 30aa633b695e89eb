//! Planes that the configured machine does not have (GRP-2).

use crate::config::Axes;
use crate::diag::{Finding, PlaneFault};
use crate::dict::{GCode, Plane, PlaneAxis};

/// The fault of choosing a plane by `function`, when the machine lacks one of its axes.
pub fn missing_axis(axes: &Axes, function: GCode) -> Option<Finding> {
    let plane = Plane::of(function)?;
    let missing = plane.axes.into_iter().find(|axis| !exists(axes, *axis))?;
    let letters = match missing {
        PlaneAxis::Letter(letter) => Some(letter.letter()),
        PlaneAxis::Fourth => None,
    };
    Some(Finding::PlaneMismatch { plane, fault: PlaneFault::missing(letters), meant: meant(axes, function) })
}

/// The plane that was probably meant: that of the same number in ISO 6983, else the only one that the machine has.
fn meant(axes: &Axes, function: GCode) -> Option<Plane> {
    let has = |plane: &Plane| plane.axes.into_iter().all(|axis| exists(axes, axis));
    let exchanged = [(GCode::G18, GCode::G19), (GCode::G19, GCode::G18)];
    let iso = exchanged.into_iter().find(|(here, _)| *here == function).and_then(|(_, iso)| Plane::of(iso));
    let mut all = Plane::ALL.into_iter().filter(has);
    let only = all.next().filter(|_| all.next().is_none());
    iso.filter(has).or(only)
}

fn exists(axes: &Axes, axis: PlaneAxis) -> bool {
    match axis {
        PlaneAxis::Letter(letter) => axes.index(letter).is_some(),
        PlaneAxis::Fourth => axes.fourth().is_some(),
    }
}
