//! How the machine moves through a program: joints, velocities, times (the rules CNT, VEL, TIM, DOT).
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | read | an executed block | [`Step`] | the adapter |
//! | merge | steps with motion | pieces | `merge` |
//! | joints | pieces | which are passed continuously, caps | `joint` |
//! | plan | a stretch of pieces, in parts | velocities, times, phases | `envelope` (linear), `parabola` with `curve` (parabolic) |
//! | give | times of pieces | [`BlockTimes`] in the order of execution | [`Planner`] |

mod curve;
mod envelope;
mod joint;
mod merge;
mod model;
mod parabola;
mod planner;
mod ramp;
mod step;
mod times;

pub use model::{Model, Profile, Recognition};
pub use planner::{Listener, Planner};
pub use step::{Direction, Dynamics, Mode, Move, Step, Unit};
pub use times::{BlockTimes, Break, CapBy, Dot, InStretch, Joint, Limit, MotionTimes, Phase, Velocities};
