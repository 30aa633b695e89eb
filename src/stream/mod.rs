//! The block stream: a sink that writes executed blocks as records, and their schema. The only serialised form of a program;
//! its records are nobody else's business.

mod beside;
mod json;
mod lines;
mod records;
mod row;
mod schema;
#[cfg(feature = "view")]
mod single;
mod writer;

pub use json::{JsonStream, Part, write};
pub use records::SCHEMA;
pub use schema::schema;
#[cfg(feature = "view")]
pub(crate) use single::SingleRecord;
