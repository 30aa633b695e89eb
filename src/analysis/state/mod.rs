//! What holds at a place of a program: `state`.
//!
//! One execution in constant memory: the reader keeps what was in force before each block, who wrote it, and at the
//! place that is asked for makes a [`Found`] of it.

mod before;
mod clock;
mod errors;
mod follow;
mod found;
mod index;
mod json;
mod place;
mod reader;
mod text;
mod unknown;
mod words;
mod writers;

pub use before::Before;
pub use clock::{AtTime, Clock, Progress, TimedProgress, Timeline, TimelineReader, Timing};
pub use found::{CounterAt, Found};
pub use index::{Arrivals, Index, Indexer, Replay};
pub use json::{SCHEMA, document, json, schema};
pub use place::{Arrival, Asked, CallAt, Place, PlaceFault, Search};
pub use reader::StateReader;
pub use text::text;
pub use unknown::{Axes, Unknown};
pub use words::{fault_text, passes_text};
pub use writers::{Slot, Written, each_written};
