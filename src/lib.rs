//! Compiler toolchain for part programs of the CNC8x6, CNC8x9 and CNC872 controls.

pub mod text;
pub mod dict;
pub mod diag;
pub mod config;
pub mod session;
pub mod cli;
