//! Why a function has no result.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use cnc872c::diag::{Format, Report, Shown, render};
use cnc872c::dict::Lang;
use cnc872c::text::path_name;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

/// Why there is no result.
#[derive(Debug)]
pub enum Fault {
    /// A file cannot be read or written.
    Io(PathBuf, io::Error),
    /// An option is wrong.
    Option(String),
    /// Configuration is wrong: the findings as JSON.
    Config(String),
    /// The program has errors, or was not executed to its end: the findings as JSON.
    Program(String),
    /// There is no such place in the program.
    Place(String),
    /// Named folders that hold no programs.
    Barren(PathBuf),
    /// No program is named.
    None,
}

/// Numbers of errors that are the same on all systems that the package is for.
const NOT_FOUND: i32 = 2;
const IS_A_DIRECTORY: i32 = 21;

impl Fault {
    /// As an exception.
    pub fn raise(self, py: Python<'_>) -> PyErr {
        let made = match self {
            Self::Io(path, error) => Ok(os_error(py, &path, &error)),
            Self::Barren(folder) => {
                let words = (NOT_FOUND, "the folder holds no programs", path_name(&folder));
                Ok(PyOSError::new_err(words))
            }
            Self::None => Ok(PyOSError::new_err((NOT_FOUND, "no program is named"))),
            Self::Option(words) => exception(py, "ConfigError", &words),
            Self::Place(words) => exception(py, "PlaceError", &words),
            Self::Config(report) => exception(py, "config_error", &report),
            Self::Program(report) => exception(py, "program_error", &report),
        };
        made.unwrap_or_else(|error| error)
    }
}

fn exception(py: Python<'_>, name: &str, argument: &str) -> PyResult<PyErr> {
    let made = py.import("cnc872c._errors")?.getattr(name)?.call1((argument,))?;
    Ok(PyErr::from_value(made))
}

fn os_error(py: Python<'_>, path: &Path, error: &io::Error) -> PyErr {
    let number = error.raw_os_error().or(match error.kind() {
        ErrorKind::NotFound => Some(NOT_FOUND),
        ErrorKind::IsADirectory => Some(IS_A_DIRECTORY),
        _ => None,
    });
    let name = path_name(path);
    let Some(number) = number else { return PyOSError::new_err(format!("{error}: {name:?}")) };
    let words = py.import("os").and_then(|os| os.getattr("strerror")?.call1((number,))?.extract::<String>());
    // Python makes FileNotFoundError and its like of the number.
    PyOSError::new_err((number, words.unwrap_or_else(|_| error.to_string()), name))
}

/// The findings as JSON `cnc872c.diagnostics/1`.
pub fn json(report: &Report, lang: Lang) -> String {
    let mut text = Vec::new();
    let shown = Shown { lang, colour: false, all: true };
    // Writing to memory never fails.
    let _ = render(Format::Json, report, shown, &mut text);
    String::from_utf8_lossy(&text).into_owned()
}
