//! Record batches kept in memory.

use std::io;

use arrow_array::RecordBatch;
use arrow_schema::SchemaRef;

use super::{Batches, End};

/// All batches of a program.
#[derive(Debug, Default)]
pub struct Kept {
    /// Their schema; `None` before the first block.
    pub schema: Option<SchemaRef>,
    /// The batches.
    pub batches: Vec<RecordBatch>,
    /// The last record; `None`: the program is not whole.
    pub end: Option<End>,
}

impl Batches for Kept {
    fn begin(&mut self, schema: &SchemaRef) -> io::Result<()> {
        self.schema = Some(SchemaRef::clone(schema));
        Ok(())
    }

    fn batch(&mut self, batch: RecordBatch) -> io::Result<()> {
        self.batches.push(batch);
        Ok(())
    }

    fn end(&mut self, end: &End) -> io::Result<()> {
        self.end = Some(end.clone());
        Ok(())
    }
}
