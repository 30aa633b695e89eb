//! Functions about a place of a program: what holds there, and a program that starts there.

use cnc872c::analysis::state::{Asked, AtTime, Place, PlaceFault, Timing, fault_text, json as state_json};
use cnc872c::config::{Purpose, parse_decimal};
use cnc872c::dict::{Decimal, Micro};
use cnc872c::restart::{self as starting, Answer, Spot, refusal_text};
use cnc872c::session::Outcome;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::fault::Fault;
use crate::one::{One, Program, one};
use crate::options::Options;

/// A place of a program: one of the first five.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct At {
    n: Option<i64>,
    line: Option<i64>,
    seq: Option<i64>,
    time: Option<f64>,
    at_tool: Option<i64>,
    file: Option<String>,
    #[pyo3(item("pass"))]
    pass_number: Option<i64>,
    after: bool,
}

impl At {
    /// The place that execution finds. A time is looked for first.
    fn asked(self, one: &mut One<'_>) -> Result<Asked, Fault> {
        let place = match self {
            Self { n: Some(n), .. } => Place::N(number("n", n)?),
            Self { line: Some(line), .. } => Place::Line(number("line", line)?),
            Self { at_tool: Some(tool), .. } => Place::Tool(Decimal::whole(tool)),
            Self { seq, .. } => Place::Seq(number("seq", seq.unwrap_or(0))?),
        };
        let pass = self.pass_number.map(|pass| number("pass_", pass)).transpose()?;
        let mut asked = Asked { place, file: self.file, pass, after: self.after };
        if let Some(seconds) = self.time {
            if !(seconds.is_finite() && seconds >= 0.0) {
                return Err(Fault::Place(format!("time: {seconds} is no time in seconds")));
            }
            let mut at_time = AtTime::new(one.session.settings, seconds);
            let run = one.session.watch(one.path, &one.name, Purpose::Report, &mut &mut at_time);
            match at_time.found() {
                Ok(seq) => asked.place = Place::Seq(seq),
                Err(seconds) => return Err(no_place(one, run.outcome, &PlaceFault::TooLate { seconds }, &asked)),
            }
        }
        Ok(asked)
    }
}

/// A number that a place may have.
fn number<T: TryFrom<i64>>(name: &str, given: i64) -> Result<T, Fault> {
    T::try_from(given).map_err(|_| Fault::Place(format!("{name}: there is no {given}")))
}

/// Whether the program has errors, or was not executed to its end.
fn is_faulty(outcome: &Outcome) -> bool {
    outcome.findings.has_errors() || outcome.unusable || outcome.not_executed.is_some()
}

/// The exception for a program that has errors.
fn broken(one: &mut One<'_>, outcome: Outcome) -> Fault {
    one.add(outcome).err().unwrap_or_else(|| Fault::Program(one.json()))
}

/// Why there is no such place: the program has errors, or else.
fn no_place(one: &mut One<'_>, outcome: Outcome, fault: &PlaceFault, asked: &Asked) -> Fault {
    if is_faulty(&outcome) { broken(one, outcome) } else { Fault::Place(fault_text(fault, asked, one.lang)) }
}

/// What holds at a place, as JSON.
#[pyfunction]
pub fn state(py: Python<'_>, program: Program, options: &Bound<'_, PyDict>, at: At) -> PyResult<String> {
    one(py, program, Options::new(options)?, move |mut one| {
        let settings = one.session.settings;
        let asked = at.asked(&mut one)?;
        let run = one.session.state(one.path, &one.name, asked.clone(), Timing::Configured);
        if run.error_before || run.outcome.unusable || run.outcome.not_executed.is_some() {
            return Err(broken(&mut one, run.outcome));
        }
        match run.found {
            Ok(found) => Ok(state_json(&found, &one.name, settings)),
            Err(fault) => Err(no_place(&mut one, run.outcome, &fault, &asked)),
        }
    })
}

/// How a start is made.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Start {
    safe: Option<f64>,
    clearance: f64,
    all_m: bool,
}

impl Start {
    fn options(&self) -> Result<starting::Options, Fault> {
        let safe = self.safe.map(|safe| thousandths("safe", safe)).transpose()?;
        let clearance = thousandths("clearance", self.clearance)?;
        if clearance <= Decimal::ZERO {
            return Err(Fault::Option("clearance is above 0".to_owned()));
        }
        Ok(starting::Options { safe, clearance, all_m: self.all_m })
    }
}

/// A position in thousandths, as a program can have it.
fn thousandths(name: &str, value: f64) -> Result<Decimal, Fault> {
    let found = parse_decimal(&value.to_string()).filter(|value| value.abs() <= Decimal::DIMENSION_MAX);
    found.ok_or_else(|| Fault::Option(format!("{name}: {value} is no position in thousandths")))
}

/// A program that starts at a place, in the old one's encoding.
#[pyfunction]
pub fn restart(
    py: Python<'_>,
    program: Program,
    options: &Bound<'_, PyDict>,
    at: At,
    start: Start,
) -> PyResult<Vec<u8>> {
    one(py, program, Options::new(options)?, move |mut one| {
        let start = start.options()?;
        let asked = at.asked(&mut one)?;
        let made = starting::restart(&one.session, one.path, &one.name, &asked, start, one.lang);
        match made.answer {
            _ if is_faulty(&made.outcome) => Err(broken(&mut one, made.outcome)),
            Answer::Broken => Err(broken(&mut one, made.outcome)),
            Answer::Place(fault) => Err(no_place(&mut one, made.outcome, &fault, &asked)),
            Answer::Refused { reason, nearest } => Err(Fault::Place(refusal_text(&reason, nearest.as_ref(), one.lang))),
            Answer::Program(made) => {
                let bytes = one.session.loader.read(one.path).map_err(|error| Fault::Io(one.path.into(), error))?;
                Ok(made.bytes(&bytes))
            }
        }
    })
}

/// The places at which a start is possible, as values of their fields, and how many more there would be with `safe`.
type Spots = (Vec<(u64, u32, Option<String>, u32, u64, Option<f64>, bool)>, u64);

/// The tool changes and rapids at which a start is possible.
#[pyfunction]
pub fn restart_places(py: Python<'_>, program: Program, options: &Bound<'_, PyDict>, start: Start) -> PyResult<Spots> {
    one(py, program, Options::new(options)?, move |mut one| {
        let (outcome, found) = starting::list(&one.session, one.path, &one.name, start.options()?);
        let Some(starting::Places { spots, with_safe: more, .. }) = found else {
            return Err(broken(&mut one, outcome));
        };
        let plain = |spot: Spot| {
            let Spot { seq, n, file, line, pass, tool, changes } = spot;
            let tool = tool.map(|tool| Micro::from(tool).to_f64());
            (seq, n, (!file.is_empty()).then_some(file), line, pass, tool, changes)
        };
        Ok((spots.into_iter().map(plain).collect(), more))
    })
}
