//! The language server: findings and answers for editors, over the same stages as the command line.
//!
//! One thread listens and keeps the documents ([`server`], [`roots`]). A change starts a run over every open document that
//! it concerns ([`analysis`]), in a thread; a newer change cancels it. Requests wait for the run's first half and are
//! answered in threads of their own ([`requests`]); each kind has its file.

mod analysis;
mod baseline;
mod cancel;
mod capabilities;
mod client;
mod code_actions;
mod code_lens;
mod commands;
mod completion;
mod cursor;
mod definition;
mod dots;
mod edit_texts;
mod edits;
mod executed;
mod explain;
mod extents;
mod files;
mod findings;
mod flow;
mod folding;
mod hierarchy;
mod hover;
mod hover_texts;
mod inlay_hints;
mod line_length;
mod links;
mod meaning;
mod moves;
mod names;
mod navigation_texts;
mod observe;
mod on_type;
mod outline;
mod page;
mod places;
mod publisher;
mod reach;
mod references;
mod rename;
mod rename_doubts;
mod renumber;
mod requests;
mod roots;
mod sections;
mod selection;
mod semantic_tokens;
mod server;
mod settings;
mod shown;
mod signals;
mod texts;
mod transport;
mod values;
mod workers;
mod workspace_symbols;

pub use server::{Ended, serve};
