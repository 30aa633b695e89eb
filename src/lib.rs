//! Compiler toolchain for part programs of the CNC8x6, CNC8x9 and CNC872 controls.

pub mod analysis;
pub mod cli;
pub mod config;
pub mod diag;
pub mod dict;
pub mod edit;
pub mod explain;
pub mod lsp;
mod query;
pub mod resolve;
pub mod run;
pub mod session;
pub mod stream;
pub mod syntax;
pub mod text;
pub mod view;
