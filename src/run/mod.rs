//! Executes a resolved program block by block: calls, jumps, parameters, modal state, geometry. Lazy: the state is the
//! call frames and the modal values, whatever the program repeats.

mod arc;
mod arithmetic;
mod block;
mod checkpoint;
mod end;
mod executed;
mod executor;
mod flow;
mod frames;
mod lines;
mod modal;
mod motion;
mod moved;
mod parameters;
mod points;
mod sink;
mod state;
mod technology;

pub use crate::ir::{AxisList, AxisMap, Jump, MStop, MotionType};
pub use checkpoint::Checkpoint;
pub use end::End;
pub use executed::{Call, Data, Executed, Feed, FeedUnit};
pub use executor::{Executor, Stop};
pub use moved::{ArcPath, Length, Missing, Motion};
pub use sink::{Sink, Start};
