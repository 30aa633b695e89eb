//! The block stream: its records, their JSON, their schema. The only serialised form of a program.

mod records;
mod schema;
mod write;

pub use records::{
    AxisList, AxisMap, AxisRecord, BlockRecord, Call, Data, EndRecord, FileRecord, Jump, MFunctionRecord, MStop,
    Motion, MotionType, ProgramRecord, SCHEMA,
};
pub use schema::schema;
pub use write::{BlockWriter, write_end, write_file, write_program};
