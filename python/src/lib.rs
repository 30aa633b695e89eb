//! The native half of the Python package `cnc872c`: runs programs, and gives what they make as Arrow columns or JSON.
//!
//! | module | is |
//! |---|---|
//! | `options` | the options of all functions, from keyword arguments |
//! | `files` | what programs are read from: the disk, and texts given in memory |
//! | `setup` | the configuration of programs, each project file read once |
//! | `work` | long work without the interpreter's lock, stopped by Ctrl-C |
//! | `fault` | why a function has no result, as exceptions |
//! | `one`, `place`, `many` | functions over one program, over a place of it, and over many programs |
//! | `table`, `cell` | record batches as an object of Python, and single values of them |

mod cell;
mod fault;
mod files;
mod many;
mod one;
mod options;
mod place;
mod setup;
mod table;
mod work;

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command line; the exit status.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| cnc872c::cli::status(arguments))
}

/// The functions of the package `cnc872c`, which gives them their types and documents them.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<table::Table>()?;
    module.add_function(wrap_pyfunction!(main, module)?)?;
    module.add_function(wrap_pyfunction!(many::check, module)?)?;
    module.add_function(wrap_pyfunction!(many::stats, module)?)?;
    module.add_function(wrap_pyfunction!(one::compile, module)?)?;
    module.add_function(wrap_pyfunction!(one::motion, module)?)?;
    module.add_function(wrap_pyfunction!(one::plc, module)?)?;
    module.add_function(wrap_pyfunction!(one::compare, module)?)?;
    module.add_function(wrap_pyfunction!(one::format, module)?)?;
    module.add_function(wrap_pyfunction!(place::state, module)?)?;
    module.add_function(wrap_pyfunction!(place::restart, module)?)?;
    module.add_function(wrap_pyfunction!(place::restart_places, module)?)
}
