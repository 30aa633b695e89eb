//! Executes a resolved program block by block: calls, jumps, parameters, modal state, geometry. Lazy: the state is the
//! call frames and the modal values, whatever the program repeats.

mod arc;
mod arithmetic;
mod block;
mod checkpoint;
mod executor;
mod flow;
mod frames;
mod lines;
mod modal;
mod motion;
mod parameters;
mod points;
mod state;
mod technology;

pub use checkpoint::Checkpoint;
pub use executor::{Executor, Stop};
