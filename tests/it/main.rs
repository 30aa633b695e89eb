//! The integration tests, one binary.
#![expect(clippy::disallowed_methods, reason = "tests read files")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod advice;
mod bombs;
mod cli;
mod cli_check;
mod cli_compile;
mod cli_faults;
mod cli_fix;
mod cli_init;
mod cli_report;
mod cli_rewrite;
mod cli_view;
mod cli_walk;
#[cfg(feature = "arrow")]
mod columns;
mod compare;
mod dialects;
mod disk;
mod docs;
mod editor_queries;
mod editors;
mod endings;
mod explain;
mod faults;
mod fields;
mod format;
mod json_schema;
mod lsp;
mod markers;
mod model;
mod motion;
mod offers;
mod plc;
mod plc_cli;
mod plc_random;
mod properties;
mod restart;
mod rewrites;
mod rules;
mod run;
mod same_program;
mod samples;
mod slip_measure;
mod slips;
mod state;
mod stats;
mod statuses;
mod stream;
mod terminal;
mod terms;
mod tidy;
mod time;
mod traps;
mod valid;
