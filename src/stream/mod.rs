//! The block stream: a sink that writes executed blocks as records, and their schema. The only serialised form of a
//! program; its records are nobody else's business.

mod beside;
mod json;
mod json_line;
mod records;
mod row;
mod schema;
#[cfg(feature = "view")]
mod single;
mod writer;

#[cfg(feature = "arrow")]
pub(crate) use json::program_record;
pub use json::{JsonStream, write};
pub use records::SCHEMA;
#[cfg(feature = "arrow")]
pub(crate) use records::{AxisMap, BlockRecord, CALLS_BY, Call, Data, EndRecord, FileRecord, Motion, Record};
#[cfg(feature = "arrow")]
pub(crate) use row::Rows;
pub use schema::schema;
#[cfg(feature = "view")]
pub(crate) use single::SingleRecord;
#[cfg(feature = "arrow")]
pub(crate) use writer::record_text;
