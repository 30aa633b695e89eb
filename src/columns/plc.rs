//! Signals of the PLC as columns: one row a step, one column a signal.

use std::fmt;
use std::io;

use super::batches::{Batches, End as LastBatch, PROGRAM, Rows};
use super::blocks::{DEG, MM};
use super::table::Table;
use crate::analysis::plc::{Cell, Form, Header, Signal, Step, Value, Writer, end_text, file_text, header_text};
use crate::dict::Micro;
use crate::run::End;

/// Steps as columns. All signals have their values in every row.
pub struct StepTable<'o> {
    rows: Rows<'o>,
    /// With the units of their numbers.
    signals: Vec<(&'static Signal, &'static str)>,
    files: Vec<String>,
}

impl fmt::Debug for StepTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StepTable").finish_non_exhaustive()
    }
}

impl<'o> StepTable<'o> {
    /// Gives record batches to `out`. What that fails with goes to `failed`, and ends the reading.
    pub fn new(out: &'o mut (dyn Batches + Send), failed: &'o mut Option<io::Error>) -> Self {
        Self { rows: Rows::new(out, failed), signals: Vec::new(), files: Vec::new() }
    }
}

impl Writer for StepTable<'_> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        let axes = &header.settings.machine.axes;
        let unit = |signal: &Signal| {
            let Cell::Position(place) = signal.cell else { return signal.cell.unit() };
            axes.get(usize::from(place)).map_or("", |axis| if axis.rotary { DEG } else { MM })
        };
        self.signals = header.signals.iter().map(|signal| (*signal, unit(signal))).collect();
        let values = vec![None; self.signals.len()];
        let none = Step { values: &values, ..Step::default() };
        put(&mut self.rows.table, &none, &self.signals);
        self.rows.begin(PROGRAM, &header_text(header));
        self.rows.result()
    }

    fn file(&mut self, index: u32, name: &str) -> io::Result<()> {
        self.files.push(file_text(index, name));
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        put(&mut self.rows.table, step, &self.signals);
        self.rows.row();
        self.rows.result()
    }

    fn end(&mut self, end: End) -> io::Result<()> {
        self.rows.end(&LastBatch::new(&end_text(end), &self.files));
        self.rows.result()
    }
}

fn put(table: &mut Table, step: &Step<'_>, signals: &[(&'static Signal, &'static str)]) {
    let place = step.place;
    table.long("seq", Some(place.seq));
    table.whole("n", "", Some(place.n));
    table.whole("file", "", Some(place.file));
    table.whole("line", "", Some(place.line));
    table.number("start_s", "s", step.start_s.map(Micro::to_f64));
    table.flag("stop", place.stop);
    for ((signal, unit), value) in signals.iter().copied().zip(step.values) {
        let value: Value = *value;
        match signal.form() {
            Form::Real => table.number(&signal.name, unit, value.map(|value| Micro::from_millionths(value).to_f64())),
            Form::Bit | Form::Byte => table.byte(&signal.name, value.and_then(|value| u8::try_from(value).ok())),
            Form::Word | Form::DWord => {
                table.whole(&signal.name, unit, value.and_then(|value| u32::try_from(value).ok()));
            }
        }
    }
}
