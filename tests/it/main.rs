//! Integration tests: one binary, a module for each part.

#![allow(
    missing_docs,
    clippy::disallowed_methods,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests make files, and fail when something is not as expected"
)]

mod cli;
mod cli_check;
mod cli_compile;
mod cli_fix;
