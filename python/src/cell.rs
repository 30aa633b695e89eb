//! Single values of columns as objects of Python.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, UInt8Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef};
use arrow_schema::DataType;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The value in that row: `None` where there is none, lists as lists, maps and structs as dictionaries.
pub fn cell<'py>(py: Python<'py>, array: &dyn Array, row: usize) -> PyResult<Bound<'py, PyAny>> {
    if array.is_null(row) {
        return Ok(py.None().into_bound(py));
    }
    Ok(match array.data_type() {
        DataType::UInt8 => array.as_primitive::<UInt8Type>().value(row).into_pyobject(py)?.into_any(),
        DataType::UInt32 => array.as_primitive::<UInt32Type>().value(row).into_pyobject(py)?.into_any(),
        DataType::UInt64 => array.as_primitive::<UInt64Type>().value(row).into_pyobject(py)?.into_any(),
        DataType::Float64 => array.as_primitive::<Float64Type>().value(row).into_pyobject(py)?.into_any(),
        DataType::Boolean => array.as_boolean().value(row).into_pyobject(py)?.to_owned().into_any(),
        DataType::Utf8 => array.as_string::<i32>().value(row).into_pyobject(py)?.into_any(),
        DataType::Dictionary(..) => {
            let names = array.as_dictionary::<Int8Type>();
            let place = usize::try_from(names.keys().value(row)).unwrap_or(0);
            cell(py, names.values(), place)?
        }
        DataType::List(_) => list(py, &array.as_list::<i32>().value(row))?,
        DataType::FixedSizeList(..) => list(py, &array.as_fixed_size_list().value(row))?,
        DataType::Map(..) => {
            let entries = array.as_map().value(row);
            let dictionary = PyDict::new(py);
            if let [keys, values] = entries.columns() {
                for at in 0..entries.len() {
                    dictionary.set_item(cell(py, keys, at)?, cell(py, values, at)?)?;
                }
            }
            dictionary.into_any()
        }
        DataType::Struct(fields) => {
            let dictionary = PyDict::new(py);
            for (field, column) in fields.iter().zip(array.as_struct().columns()) {
                dictionary.set_item(field.name(), cell(py, column, row)?)?;
            }
            dictionary.into_any()
        }
        other => return Err(PyTypeError::new_err(format!("{other} is no type of a column"))),
    })
}

fn list<'py>(py: Python<'py>, items: &ArrayRef) -> PyResult<Bound<'py, PyAny>> {
    let items = (0..items.len()).map(|at| cell(py, items, at)).collect::<PyResult<Vec<_>>>()?;
    Ok(PyList::new(py, items)?.into_any())
}
