//! The options that all functions have.

use std::path::PathBuf;
use std::sync::Arc;

use cnc872c::config::{Level, Overrides, parse_parameter};
use cnc872c::diag::Code;
use cnc872c::dict::{Dialect, Lang};
use cnc872c::text::Encoding;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use toml_edit::{Array, DocumentMut, InlineTable, Value};

use crate::fault::Fault;

/// The name that a project file has which is given as a dictionary.
const DICTIONARY: &str = "config";

/// The project file.
pub enum Config {
    /// That beside the program or above it.
    Found,
    /// Named by the caller.
    File(PathBuf),
    /// Its text; paths in it are relative to the working folder.
    Text(PathBuf, Arc<[u8]>),
}

/// The caller's values that win over the project file.
pub struct Options {
    /// The project file.
    pub config: Config,
    /// Values that win over it.
    pub overrides: Overrides,
    /// The language of findings.
    pub lang: Lang,
}

fn wrong(py: Python<'_>, words: String) -> PyErr {
    Fault::Option(words).raise(py)
}

impl Options {
    /// From keyword arguments.
    ///
    /// # Errors
    /// `TypeError` for what is no option, and for a value of another type; `ConfigError` for a value that cannot be.
    pub fn new(options: &Bound<'_, PyDict>) -> PyResult<Self> {
        let py = options.py();
        let mut made = Self { config: Config::Found, overrides: Overrides::default(), lang: Lang::En };
        let over = &mut made.overrides;
        // The stricter level of one code wins.
        let mut levels = [(Level::Allow, Vec::new()), (Level::Warn, Vec::new()), (Level::Deny, Vec::new())];
        for (name, value) in options {
            let name: String = name.extract()?;
            if value.is_none() {
                continue;
            }
            match name.as_str() {
                "config" => made.config = config(&value)?,
                "dialect" => {
                    let given: String = value.extract()?;
                    let found = Dialect::ALL.into_iter().find(|dialect| dialect.name() == given);
                    over.dialect = Some(found.ok_or_else(|| wrong(py, format!("dialect {given:?} is not known")))?);
                }
                "channel_config" => over.channel_config = Some(value.extract()?),
                "macrocycles" => over.macrocycles = paths(&value)?,
                "param" => over.parameters = parameters(&value)?,
                "block_skip" => over.block_skip = Some(value.extract()?),
                "optional_stop" => over.optional_stop = Some(value.extract()?),
                "encoding" => over.encoding = Some(encoding(&value)?),
                "max_blocks" => {
                    let most = count("max_blocks", value.extract()?).map_err(|fault| fault.raise(py))?;
                    if most == 0 {
                        return Err(wrong(py, "max_blocks is at least 1".to_owned()));
                    }
                    over.max_blocks = Some(most);
                }
                "allow" => levels[0].1 = names(&value)?,
                "warn" => levels[1].1 = names(&value)?,
                "deny" => levels[2].1 = names(&value)?,
                "lang" => {
                    let given: String = value.extract()?;
                    made.lang = Lang::named(&given)
                        .ok_or_else(|| wrong(py, format!("lang {given:?} is not known: \"en\", \"cs\"")))?;
                }
                other => return Err(PyTypeError::new_err(format!("{other:?} is no option"))),
            }
        }
        for (level, names) in levels {
            for name in names {
                let code = code(&name).map_err(|words| wrong(py, words))?;
                over.lints.push((code, level));
            }
        }
        Ok(made)
    }

    /// The same for a call that computes motion, with keys that are tried.
    pub fn with_motion(mut self, tried: Vec<(String, String)>) -> Self {
        self.overrides.motion = tried;
        self.overrides.computes_motion = true;
        self
    }
}

/// A finding that has a level.
fn code(name: &str) -> Result<Code, String> {
    match Code::find(name) {
        Some(code) if code.is_configurable() => Ok(code),
        Some(_) => Err(format!("{name} is an error: only warnings and E0109 have a level")),
        None => Err(format!("no finding has the code or name {name:?}")),
    }
}

fn encoding(value: &Bound<'_, PyAny>) -> PyResult<Encoding> {
    let given: String = value.extract()?;
    let found = Encoding::NAMED.iter().find(|(name, _)| *name == given).map(|(_, encoding)| *encoding);
    found.ok_or_else(|| wrong(value.py(), format!("encoding {given:?} is not known")))
}

/// A path, or several.
pub fn paths(value: &Bound<'_, PyAny>) -> PyResult<Vec<PathBuf>> {
    if let Ok(one) = value.extract::<PathBuf>() {
        return Ok(vec![one]);
    }
    value.try_iter()?.map(|path| path?.extract()).collect()
}

/// A name, or several.
fn names(value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    if let Ok(one) = value.extract::<String>() {
        return Ok(vec![one]);
    }
    value.try_iter()?.map(|name| name?.extract()).collect()
}

/// `{"R10": 5}`.
fn parameters(value: &Bound<'_, PyAny>) -> PyResult<Vec<(u8, cnc872c::dict::Decimal)>> {
    let one = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let text = format!("{}={}", name.str()?, value.str()?);
        parse_parameter(&text).map_err(|fault| wrong(value.py(), format!("param: {text}: {}", fault.text(Lang::En))))
    };
    value.cast::<PyDict>()?.iter().map(one).collect()
}

/// A number of blocks.
///
/// # Errors
/// When it is negative.
pub fn count(name: &str, given: i64) -> Result<u64, Fault> {
    u64::try_from(given).map_err(|_| Fault::Option(format!("{name}: {given} is less than 0")))
}

/// `{"motion.accel-mm-s2": 800}`: keys with their values, or these as TOML.
pub fn tried(value: &Bound<'_, PyAny>) -> PyResult<Vec<(String, String)>> {
    let one = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let text =
            if value.is_instance_of::<PyDict>() { toml(&value, DEPTH)?.to_string() } else { value.str()?.to_string() };
        Ok((key.extract()?, text))
    };
    value.cast::<PyDict>()?.iter().map(one).collect()
}

fn config(value: &Bound<'_, PyAny>) -> PyResult<Config> {
    if let Ok(dictionary) = value.cast::<PyDict>() {
        let mut document = DocumentMut::new();
        for (key, value) in dictionary {
            document.insert(&key.extract::<String>()?, item(&value, DEPTH)?);
        }
        return Ok(Config::Text(DICTIONARY.into(), document.to_string().into_bytes().into()));
    }
    Ok(Config::File(value.extract()?))
}

/// No project file is nested deeper.
const DEPTH: usize = 16;

/// So much deeper a value may be nested.
///
/// # Errors
/// `ConfigError` when it is nested too deeply, as one that contains itself.
fn deeper(value: &Bound<'_, PyAny>, depth: usize) -> PyResult<usize> {
    depth.checked_sub(1).ok_or_else(|| wrong(value.py(), "config: nested too deeply".to_owned()))
}

/// A value at the top of the project file: dictionaries are tables, lists of them are arrays of tables.
fn item(value: &Bound<'_, PyAny>, depth: usize) -> PyResult<toml_edit::Item> {
    let depth = deeper(value, depth)?;
    if let Ok(dictionary) = value.cast::<PyDict>() {
        let mut table = toml_edit::Table::new();
        for (key, value) in dictionary {
            table.insert(&key.extract::<String>()?, item(&value, depth)?);
        }
        return Ok(table.into());
    }
    Ok(toml_edit::Item::Value(toml(value, depth)?))
}

fn toml(value: &Bound<'_, PyAny>, depth: usize) -> PyResult<Value> {
    let depth = deeper(value, depth)?;
    // Booleans are whole numbers to Python.
    if value.is_instance_of::<PyBool>() {
        return Ok(value.extract::<bool>()?.into());
    }
    if value.is_instance_of::<PyInt>() {
        let given = value.extract::<i64>();
        return Ok(given.map_err(|_| wrong(value.py(), format!("config: {value} is too large")))?.into());
    }
    if value.is_instance_of::<PyFloat>() {
        return Ok(value.extract::<f64>()?.into());
    }
    if value.is_instance_of::<PyString>() {
        return Ok(value.extract::<String>()?.into());
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        let items = value.try_iter()?.map(|item| toml(&item?, depth)).collect::<PyResult<Array>>()?;
        return Ok(items.into());
    }
    if let Ok(dictionary) = value.cast::<PyDict>() {
        let mut table = InlineTable::new();
        for (key, value) in dictionary {
            table.insert(&key.extract::<String>()?, toml(&value, depth)?);
        }
        return Ok(table.into());
    }
    let path: PathBuf =
        value.extract().map_err(|_| PyTypeError::new_err(format!("{value:?} is no value of a project file")))?;
    Ok(path.to_string_lossy().into_owned().into())
}
