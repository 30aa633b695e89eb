//! The language server: findings and answers for editors, over the same stages as the command line.
//!
//! One thread listens and keeps the documents (`server`, `documents`). A change starts a run over every open document
//! that it concerns (`analysis`), in a thread; a newer change cancels it. Requests wait for the run's first half and
//! are answered in threads of their own (`requests`); each kind has its file.

mod analysis;
mod capabilities;
mod checked;
mod client;
mod code_actions;
mod code_lens;
mod commands;
mod compare;
mod completion;
mod definition;
mod documents;
mod dots;
mod edits;
mod explain;
mod files;
mod findings;
mod folding;
mod formatting;
mod hierarchy;
mod hover;
mod inlay_hints;
mod links;
mod offered;
mod on_type;
mod ongoing;
mod outline;
mod path;
mod places;
mod project_file;
mod publisher;
mod references;
mod rename;
mod requests;
mod restart;
mod roots;
mod selection;
mod semantic_tokens;
mod server;
mod settings;
mod signals;
mod signature;
mod snapshot;
mod state;
mod texts;
mod transport;
mod workers;
mod workspace;
mod workspace_findings;
mod workspace_symbols;

pub use server::{Ended, serve};
