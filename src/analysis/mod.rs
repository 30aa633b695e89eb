//! Readers of executed blocks: each is a [`crate::run::Sink`], and none knows another.

mod totals;

pub use totals::Totals;
