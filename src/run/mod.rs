//! Executes a resolved program block by block: calls, jumps, parameters, modal state, geometry.
//!
//! [`Interpreter::step`] gives one [`Executed`] block after the other; a [`Sink`] reads them. The order of the rules in
//! a block is in `interpreter.rs`; each rule is a function of what it looks at.

mod arc;
mod arc_findings;
mod arithmetic;
mod arrival;
mod block;
mod end;
mod executed;
mod flow;
mod frames;
mod functions;
mod gears;
mod held;
mod interpreter;
mod m_functions;
mod motion;
mod moved;
mod other_centers;
mod parameters;
mod passed;
mod planes;
mod points;
mod program;
mod reading;
mod repeats;
mod sink;
mod site;
mod spindle;
mod state;
mod technology;
mod travel;
mod unknown;
mod warnings;
mod words;

pub use block::Jump;
pub use end::End;
pub use executed::{Call, Data, Executed, Feed, FeedUnit};
pub use flow::LostCall;
pub use held::ArmedCounter;
pub use interpreter::{Interpreter, Stop, Stretch};
pub use m_functions::MStop;
pub use moved::{ArcPath, Length, Missing, Motion, MotionType};
pub use passed::{Passed, PointPath, Points};
pub use program::Program;
pub use sink::Sink;
pub use state::{AxisSet, State};
