//! The steps in which a condition holds, a line each.

use std::io::{self, Write};

use super::condition::Condition;
use super::reader::{Header, Writer};
use super::steps::Step;
use super::values::write_value;
use crate::diag::terminal_safe;
use crate::run::End;

/// Writes `file:line:column: N40 seq=12 M03PI=1 …` for each step in which the condition holds, with the values of the
/// signals that it names.
#[derive(Debug)]
pub struct Finder<W> {
    out: W,
    condition: Condition,
    /// Names of the files, by index.
    files: Vec<String>,
    found: u64,
    line: String,
}

impl<W: Write> Finder<W> {
    /// Looks for `condition`, and writes to `out`.
    pub const fn new(out: W, condition: Condition) -> Self {
        Self { out, condition, files: Vec::new(), found: 0, line: String::new() }
    }

    /// In how many steps the condition held.
    pub const fn found(&self) -> u64 {
        self.found
    }
}

impl<W: Write> Writer for Finder<W> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.files.push(terminal_safe(header.name).into_owned());
        Ok(())
    }

    fn file(&mut self, _: u32, name: &str) -> io::Result<()> {
        self.files.push(terminal_safe(name).into_owned());
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        if !self.condition.holds(step.before, step.values) {
            return Ok(());
        }
        self.found += 1;
        let place = step.place;
        let file = usize::try_from(place.file).ok().and_then(|index| self.files.get(index)).map_or("", String::as_str);
        let stop = if place.stop { " stop" } else { "" };
        self.line = format!("{file}:{}:{}: N{} seq={}{stop}", place.line, place.column, place.n, place.seq);
        for (signal, value) in self.condition.signals().iter().zip(step.values) {
            self.line.push(' ');
            self.line.push_str(&signal.name);
            self.line.push('=');
            match value {
                Some(_) => write_value(signal, *value, &mut self.line),
                None => self.line.push('-'),
            }
        }
        writeln!(self.out, "{}", self.line)
    }

    fn end(&mut self, _: End) -> io::Result<()> {
        self.out.flush()
    }
}
