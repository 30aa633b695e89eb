//! Where record batches go.

use std::io;
use std::sync::Arc;

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, Metadata, Schema, SchemaRef};

use super::table::Table;

/// Key of the first record in the metadata of the schema.
pub const PROGRAM: &str = "cnc872c.program";
/// Key of the records about other files in the metadata of the last batch.
pub const FILES: &str = "cnc872c.files";
/// Key of the last record in the metadata of the last batch.
const END: &str = "cnc872c.end";

/// The last record, and those about other files, as JSON.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct End(pub(super) Metadata);

impl End {
    /// `end` is the last record; `files` those about other files.
    pub(crate) fn new(end: &str, files: &[String]) -> Self {
        let mut metadata = Metadata::new().with(END, end.trim_end());
        if !files.is_empty() {
            let files: Vec<&str> = files.iter().map(|file| file.trim_end()).collect();
            metadata.insert(FILES, format!("[{}]", files.join(",")));
        }
        Self(metadata)
    }

    /// The last record.
    pub fn record(&self) -> &str {
        self.0.get(END).map_or("", String::as_str)
    }

    /// A list of the records about other files.
    pub fn files(&self) -> &str {
        self.0.get(FILES).map_or("[]", String::as_str)
    }
}

/// Takes record batches.
pub trait Batches {
    /// Before the first batch.
    ///
    /// # Errors
    /// What writing gives, here and below.
    fn begin(&mut self, schema: &SchemaRef) -> io::Result<()>;

    /// The next batch.
    ///
    /// # Errors
    /// What writing gives.
    fn batch(&mut self, batch: RecordBatch) -> io::Result<()>;

    /// The rows are whole.
    ///
    /// # Errors
    /// What writing gives.
    fn end(&mut self, end: &End) -> io::Result<()>;
}

/// The error of a writer as it came from there.
pub(super) fn io_error(error: ArrowError) -> io::Error {
    if let ArrowError::IoError(_, error) = error { error } else { io::Error::other(error) }
}

/// A table whose batches go somewhere. The first error stays, and ends the run.
pub(crate) struct Rows<'o> {
    pub table: Table,
    out: &'o mut (dyn Batches + Send),
    schema: SchemaRef,
    failed: &'o mut Option<io::Error>,
}

impl<'o> Rows<'o> {
    pub fn new(out: &'o mut (dyn Batches + Send), failed: &'o mut Option<io::Error>) -> Self {
        Self { table: Table::default(), out, schema: Arc::new(Schema::empty()), failed }
    }

    /// Whether nothing failed.
    pub const fn goes_on(&self) -> bool {
        self.failed.is_none()
    }

    /// Begins with the columns of the row in the table, which is no row of the data. The schema has `value` as
    /// metadata.
    pub fn begin(&mut self, key: &str, value: &str) {
        self.schema = self.table.declare(Metadata::new().with(key, value.trim_end()));
        let begun = self.out.begin(&self.schema);
        self.keep(begun);
    }

    /// After each row.
    #[inline]
    pub fn row(&mut self) {
        if self.table.end_row() {
            self.hand_on();
        }
    }

    fn hand_on(&mut self) {
        let batch = self.table.batch(&self.schema);
        self.take(batch);
    }

    /// Gives on a batch that was made elsewhere.
    pub fn take(&mut self, batch: Result<RecordBatch, ArrowError>) {
        if self.goes_on() {
            let taken = batch.map_err(io_error).and_then(|batch| self.out.batch(batch));
            self.keep(taken);
        }
    }

    /// What fails elsewhere ends the run too.
    pub fn fail(&mut self, error: io::Error) {
        self.keep(Err(error));
    }

    /// The columns, for rows that are made elsewhere.
    pub fn columns(&mut self) -> (Table, SchemaRef) {
        (self.table.another(), SchemaRef::clone(&self.schema))
    }

    /// The rows are whole.
    pub fn end(&mut self, end: &End) {
        if self.table.has_rows() && self.goes_on() {
            self.hand_on();
        }
        if self.goes_on() {
            let ended = self.out.end(end);
            self.keep(ended);
        }
    }

    /// The first error, for those who give it on.
    pub fn result(&mut self) -> io::Result<()> {
        self.failed.take().map_or(Ok(()), Err)
    }

    fn keep(&mut self, result: io::Result<()>) {
        if let Err(error) = result {
            self.failed.get_or_insert(error);
        }
    }
}
