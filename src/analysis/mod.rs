//! Readers of executed blocks: each is a [`crate::run::Sink`], and none knows another.

pub mod compare;
pub mod equidistant;
pub mod json;
pub mod motion;
mod number;
mod part;
pub mod plc;
mod record_schema;
pub mod sheet;
pub mod state;
mod totals;

pub use number::{Number, push_digits, write_real};
pub use part::Part;
pub use record_schema::{document_schema, forbid_null, record_schema};
pub use totals::Totals;
