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
mod cursor;
mod explain;
mod files;
mod findings;
mod hover;
mod places;
mod publisher;
mod requests;
mod roots;
mod server;
mod settings;
mod texts;
mod transport;
mod workers;

pub use server::{Ended, serve};
