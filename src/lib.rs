//! Compiler toolchain for part programs of the CNC8x6, CNC8x9 and CNC872 controls: it finds what is wrong with a
//! program, and executes it block by block as the control does.
//!
//! A [`session::Session`] runs one program: it loads the files, checks the text, executes the blocks, and shows each
//! to a [`run::Sink`]. The program `cnc872c` is a command line over it; this example does the same from memory:
//!
//! ```
#![doc = include_str!("../examples/library.rs")]
//! ```
//!
//! # In reading order
//!
//! | module | |
//! |---|---|
//! | [`session`] | the pipeline on one page: load, resolve, execute, report |
//! | [`text`], [`disk`] | source text and its places; the [`text::Loader`] that files come from, in memory or on disk |
//! | [`dict`] | the language as rows: addresses, G and M functions, dialects, exact numbers |
//! | [`diag`] | every finding there is, its texts in English and Czech, the forms that findings are written in |
//! | [`syntax`] | tokens, the grammar of a block, the tree of a file |
//! | [`config`] | the machine: project file, ChannelConfig, machine constants |
//! | [`resolve`] | units, call and jump targets, the checks of the text |
//! | [`run`] | execution: [`run::Executed`] blocks and the [`run::Sink`]s that read them |
//! | [`analysis`] | such readers: totals, motion and time, the PLC, the set-up sheet, the equidistant |
//! | [`stream`] | the reader that writes the block stream |
//! | `columns` | the readers that write columns |
//! | [`edit`] | text to text: what fixes make of a file |
//! | [`restart`] | programs that start in the middle of another one |
//! | [`explain`] | pages about functions, addresses, keys and findings |
//! | [`parallel`] | threads, where there are any |
//! | `stats` | one row of facts a program, for archives |
//! | `view`, `lsp`, `cli` | the picture of a program, the language server, the command line |
//!
//! # Features
//!
//! | feature | gives |
//! |---|---|
//! | none | the core, on one thread; also for `wasm32-unknown-unknown`, with [`text::MemoryLoader`] |
//! | `parallel` | long programs on all processors, output written beside execution |
//! | `view` | the page that shows a program, and still pictures |
//! | `arrow` | the streams as Apache Arrow columns |
//! | `lsp` | the language server |
//! | `cli` (default) | the command line, findings in the form for people, and all of the above |
//!
//! # Stability
//!
//! What programs read keeps its meaning: exit statuses, the codes of findings, the project file, and the forms whose
//! names have a version, as `cnc872c.blocks/2`. The Rust interface has version 0: what the example above uses changes
//! only with an entry in the changelog and a new minor version; everything else may change with any version.

pub mod analysis;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "arrow")]
pub mod columns;
pub mod config;
pub mod diag;
pub mod dict;
pub mod disk;
pub mod edit;
pub mod explain;
#[cfg(test)]
#[path = "../tests/it/json_schema.rs"]
mod json_schema;
#[cfg(feature = "lsp")]
pub mod lsp;
mod named;
pub mod parallel;
#[cfg(feature = "lsp")]
mod query;
pub mod resolve;
pub mod restart;
pub mod run;
pub mod session;
#[cfg(feature = "cli")]
pub mod stats;
pub mod stream;
mod sure;
pub mod syntax;
pub mod text;
#[cfg(feature = "view")]
pub mod view;
