//! One row of facts a program, for archives: `cnc872c.stats/1`.

#[cfg(feature = "arrow")]
mod arrow;
mod program;
mod render;
mod row;

#[cfg(feature = "arrow")]
pub use arrow::RowTable;
pub use program::{hash, row};
pub use render::{CSV_HEAD, csv, human, json_break, json_end, json_head, json_row};
pub use row::{Extents, Number, Row, SCHEMA, schema};
