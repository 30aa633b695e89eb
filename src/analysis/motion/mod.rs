//! How the machine moves through a program: joints, velocities, times (the rules CNT, VEL, TIM, DOT).
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | read | an executed block | [`Step`] | the adapter |
//! | merge | steps with motion | pieces | `merge` |
//! | joints | pieces | which are passed continuously, caps | `joint` |
//! | plan | a stretch of pieces, in parts | velocities, times, phases | `envelope` (linear), `parabola` with `curve` and `climb` (parabolic) |
//! | give | times of pieces | [`BlockTimes`] in the order of execution | [`Planner`] |

mod account;
mod basis;
mod climb;
mod csv;
mod curve;
mod envelope;
mod findings;
mod joint;
mod json;
mod merge;
mod model;
mod parabola;
mod planned;
mod planner;
mod ramp;
#[cfg(test)]
mod ramp_tests;
mod read;
mod records;
mod step;
mod summary;
mod times;
mod words;

pub use crate::config::{Profile, Recognition};
pub use account::{Account, clock};
pub use basis::{Basis, BasisValue, InForce, Table};
pub use csv::{CSV_HEAD, write_csv};
pub use findings::JointFindings;
#[cfg(feature = "arrow")]
pub(crate) use json::PER_MINUTE;
pub use json::{machine, total, write_block};
pub use model::Model;
pub use planned::Planned;
pub use planner::{Listener, Planner};
pub use read::StepReader;
#[cfg(feature = "arrow")]
pub(crate) use records::twelve_digits;
pub use records::{SCHEMA, schema};
pub use step::{Direction, Dynamics, Mode, Move, Step, Unit};
pub use summary::{Estimate, RedJoint, Summary, Total};
pub use times::{BlockTimes, Break, CapBy, Dot, InStretch, Joint, Limit, MotionTimes, Phase, Untimed, Velocities};

/// A number with at most so many decimals, without trailing zeros.
pub fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
