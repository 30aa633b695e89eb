//! Record batches as an object of Python.

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{RecordBatch, RecordBatchIterator};
use arrow_schema::ffi::FFI_ArrowSchema;
use arrow_schema::{ArrowError, Schema, SchemaRef};
use cnc872c::columns::{Kept, PROGRAM, ROWS};
use pyo3::exceptions::{PyIndexError, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::cell::cell;

/// Record batches in memory.
#[pyclass(frozen, module = "cnc872c._native")]
pub struct Table {
    schema: SchemaRef,
    batches: Vec<RecordBatch>,
    rows: usize,
    last: String,
    files: String,
}

fn arrow_error(error: ArrowError) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}

impl From<Kept> for Table {
    fn from(kept: Kept) -> Self {
        let Kept { schema, batches, end } = kept;
        let end = end.unwrap_or_default();
        Self {
            schema: schema.unwrap_or_else(|| Schema::empty().into()),
            rows: batches.iter().map(RecordBatch::num_rows).sum(),
            batches,
            last: end.record().to_owned(),
            files: end.files().to_owned(),
        }
    }
}

#[pymethods]
impl Table {
    fn __len__(&self) -> usize {
        self.rows
    }

    /// A stream of the batches, which shares their memory: the Arrow PyCapsule interface. The schema asked for is only
    /// a wish, which is not granted.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        drop(requested_schema);
        let batches = self.batches.clone().into_iter().map(Ok);
        let reader = RecordBatchIterator::new(batches, SchemaRef::clone(&self.schema));
        let stream = FFI_ArrowArrayStream::new(Box::new(reader));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// The names, types and units of the columns.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.schema.as_ref()).map_err(arrow_error)?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }

    /// The names of the columns.
    fn columns(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
    }

    /// A value, by column and row.
    fn cell<'py>(&self, py: Python<'py>, column: usize, row: usize) -> PyResult<Bound<'py, PyAny>> {
        // All batches but the last are full.
        let batch = self.batches.get(row / ROWS).filter(|batch| row % ROWS < batch.num_rows());
        let array = batch.and_then(|batch| batch.columns().get(column));
        cell(py, array.ok_or_else(|| PyIndexError::new_err("no such cell"))?, row % ROWS)
    }

    /// The first record, as JSON.
    fn first(&self) -> &str {
        self.schema.metadata().get(PROGRAM).map_or("", String::as_str)
    }

    /// The last record, as JSON.
    fn last(&self) -> &str {
        &self.last
    }

    /// The records about other files, as JSON.
    fn files(&self) -> &str {
        &self.files
    }
}
