//! A table of rows that are no stream of a program.

use std::io::{self, Write};

use arrow_ipc::writer::StreamWriter;
use arrow_schema::{Metadata, SchemaRef};

use super::batches::io_error;
use super::table::Table;

/// An Arrow IPC stream of rows.
pub struct Plain<'o, R> {
    table: Table,
    put: fn(&mut Table, &R),
    schema: SchemaRef,
    writer: StreamWriter<&'o mut (dyn Write + Send)>,
}

impl<R> std::fmt::Debug for Plain<'_, R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Plain").finish_non_exhaustive()
    }
}

impl<'o, R> Plain<'o, R> {
    /// Begins with the columns into which `put` puts any row, as `example`.
    pub(crate) fn begin(
        out: &'o mut (dyn Write + Send),
        put: fn(&mut Table, &R),
        example: &R,
        metadata: Metadata,
    ) -> io::Result<Self> {
        let mut table = Table::default();
        put(&mut table, example);
        let schema = table.declare(metadata);
        let writer = StreamWriter::try_new(out, &schema).map_err(io_error)?;
        Ok(Self { table, put, schema, writer })
    }

    /// The next row.
    ///
    /// # Errors
    /// What writing gives.
    pub fn row(&mut self, row: &R) -> io::Result<()> {
        (self.put)(&mut self.table, row);
        if self.table.end_row() { self.hand_on() } else { Ok(()) }
    }

    /// The end of the stream.
    ///
    /// # Errors
    /// What writing gives.
    pub fn finish(mut self) -> io::Result<()> {
        if self.table.has_rows() {
            self.hand_on()?;
        }
        self.writer.finish().map_err(io_error)
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.table.batch(&self.schema).map_err(io_error)?;
        self.writer.write(&batch).map_err(io_error)
    }
}
