//! What holds at a place of a program: `state`.
//!
//! One execution in constant memory: the reader keeps what was in force before each block, who wrote it, and at the place
//! that is asked for makes a [`Found`] of it.

mod before;
mod clock;
mod errors;
mod json;
mod place;
mod reader;
mod text;
mod unknown;
mod words;
mod writers;

pub use before::Before;
pub use clock::{AtTime, Progress, TimedProgress};
pub use json::{SCHEMA, json, schema};
pub use place::{Arrival, Asked, CallAt, Place, PlaceFault};
pub use reader::{Found, StateReader};
pub use text::text;
pub use unknown::{Axes, Unknown};
pub use words::fault_text;
pub use writers::{Slot, Written};
