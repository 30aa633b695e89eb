//! The integration tests, one binary.
#![expect(clippy::disallowed_methods, reason = "tests read files")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod disk;
mod explain;
mod faults;
mod markers;
mod model;
mod properties;
mod rules;
mod run;
mod samples;
mod tidy;
mod traps;
mod valid;
