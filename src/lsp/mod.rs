//! The language server: findings and answers for editors, over the same stages as the command line.
//!
//! One thread listens and keeps the documents ([`server`], [`roots`]). A change starts a run over every open document that
//! it concerns ([`analysis`]), in a thread; a newer change cancels it. Requests wait for the run's first half and are
//! answered in threads of their own ([`requests`]); each kind has its file.

mod analysis;
mod cancel;
mod capabilities;
mod client;
mod code_actions;
mod commands;
mod cursor;
mod edit_texts;
mod edits;
mod explain;
mod extents;
mod files;
mod findings;
mod folding;
mod hover;
mod outline;
mod places;
mod publisher;
mod renumber;
mod requests;
mod roots;
mod sections;
mod selection;
mod semantic_tokens;
mod server;
mod settings;
mod texts;
mod transport;
mod workers;
mod workspace_symbols;

pub use server::{Ended, serve};
