//! The table for people, and CSV for spreadsheets.

use std::io::{self, Write};

use super::dictionary::{Form, Signal};
use super::reader::{Header, Writer};
use super::steps::Step;
use super::values::{Value, write_value};
use crate::analysis::write_real;
use crate::diag::terminal_safe;
use crate::run::End;

/// One line for each step that changes a signal: seq, N, line, then the signals that changed. The first step shows bits
/// that are 1 and cells that have a value.
#[derive(Debug)]
pub struct Table<W> {
    out: W,
    /// Also steps that change nothing.
    all: bool,
    signals: Vec<&'static Signal>,
    /// Names of the files after the program, by index.
    files: Vec<String>,
    begun: bool,
    line: String,
}

impl<W: Write> Table<W> {
    /// Writes to `out`.
    pub const fn new(out: W, all: bool) -> Self {
        Self { out, all, signals: Vec::new(), files: Vec::new(), begun: false, line: String::new() }
    }

    fn push(&mut self, index: usize, value: Value) {
        if let Some(signal) = self.signals.get(index) {
            self.line.push(' ');
            self.line.push_str(&signal.name);
            self.line.push('=');
            match value {
                Some(_) => write_value(signal, value, &mut self.line),
                None => self.line.push('-'),
            }
        }
    }
}

impl<W: Write> Writer for Table<W> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.signals = header.signals.to_vec();
        Ok(())
    }

    fn file(&mut self, _: u32, name: &str) -> io::Result<()> {
        self.files.push(terminal_safe(name).into_owned());
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        self.line.clear();
        if self.begun {
            for &index in step.changed {
                self.push(index, step.values.get(index).copied().flatten());
            }
        } else {
            for (index, value) in step.values.iter().enumerate() {
                let bit = self.signals.get(index).is_some_and(|signal| signal.form() == Form::Bit);
                if value.is_some() && !(bit && *value == Some(0)) {
                    self.push(index, *value);
                }
            }
        }
        self.begun = true;
        if self.line.is_empty() && !self.all {
            return Ok(());
        }
        let place = step.place;
        let block = format!("N{}", place.n);
        let file = usize::try_from(place.file).ok().and_then(|index| self.files.get(index.checked_sub(1)?));
        let line = file.map_or_else(|| place.line.to_string(), |name| format!("{name}:{}", place.line));
        let stop = if place.stop { " stop" } else { "" };
        writeln!(self.out, "{:>6} {block:<6} {line:>5} {stop}{}", place.seq, self.line)
    }

    fn end(&mut self, _: End) -> io::Result<()> {
        self.out.flush()
    }
}

/// A row for each step, a column for each signal.
#[derive(Debug)]
pub struct Csv<W> {
    out: W,
    signals: Vec<&'static Signal>,
    /// Text of each cell, kept while its value stays.
    cells: Vec<String>,
    begun: bool,
    row: String,
}

impl<W: Write> Csv<W> {
    /// Writes to `out`.
    pub const fn new(out: W) -> Self {
        Self { out, signals: Vec::new(), cells: Vec::new(), begun: false, row: String::new() }
    }

    fn renew(&mut self, index: usize, value: Value) {
        if let (Some(signal), Some(cell)) = (self.signals.get(index), self.cells.get_mut(index)) {
            cell.clear();
            write_value(signal, value, cell);
        }
    }
}

impl<W: Write> Writer for Csv<W> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.signals = header.signals.to_vec();
        self.cells = vec![String::new(); self.signals.len()];
        self.row.push_str("seq,n,file,line,stop,start_s");
        for signal in &self.signals {
            self.row.push(',');
            self.row.push_str(&signal.name);
        }
        writeln!(self.out, "{}", self.row)
    }

    fn file(&mut self, _: u32, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        if self.begun {
            for &index in step.changed {
                self.renew(index, step.values.get(index).copied().flatten());
            }
        } else {
            for (index, value) in step.values.iter().enumerate() {
                self.renew(index, *value);
            }
        }
        self.begun = true;
        let place = step.place;
        let stop = if place.stop { "1" } else { "" };
        self.row = format!("{},{},{},{},{stop},", place.seq, place.n, place.file, place.line);
        if let Some(start) = step.start_s {
            write_real(start.millionths(), &mut self.row);
        }
        for cell in &self.cells {
            self.row.push(',');
            self.row.push_str(cell);
        }
        self.row.push('\n');
        self.out.write_all(self.row.as_bytes())
    }

    fn end(&mut self, _: End) -> io::Result<()> {
        self.out.flush()
    }
}
