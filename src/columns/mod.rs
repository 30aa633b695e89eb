//! The streams as Apache Arrow columns: one row a record, in record batches of [`ROWS`] rows.
//!
//! | stage | by |
//! |---|---|
//! | a record, or what one is made of, as cells of a row | `blocks`, `motion`, `plc`; blocks in a thread `beside` execution |
//! | rows to record batches | `table` |
//! | record batches on their way: as an Arrow IPC stream, or kept in memory | [`Batches`]: `ipc`, `kept` |
//!
//! A column is named as the field of the record, one within another with `_` between. What a record leaves out is null,
//! and a flag that it leaves out is false. The first record is metadata of the schema, `cnc872c.program`; the last one,
//! `cnc872c.end`, and those about other files, `cnc872c.files`, are metadata of a last batch without rows.

mod batches;
mod beside;
mod blocks;
mod cells;
mod ipc;
mod kept;
mod motion;
mod plc;
mod table;

pub(crate) use batches::Rows;
pub use batches::{Batches, End, FILES, PROGRAM};
pub use blocks::BlockTable;
pub use ipc::Ipc;
pub use kept::Kept;
pub use motion::MotionTable;
pub use plc::StepTable;
pub use table::ROWS;
pub(crate) use table::Table;
