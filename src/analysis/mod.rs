//! Readers of executed blocks: each is a [`crate::run::Sink`], and none knows another.

pub mod motion;
mod totals;

pub use totals::Totals;
