//! Steps as a value change dump (IEEE 1364), for waveform viewers: bits as wires, bytes and words as vectors, real
//! numbers as reals. Declarations are written by the `vcd` crate; times and values, which are nearly all of a long
//! dump, go to the same place as text made here.

use std::fmt;
use std::io::{self, Write};

use vcd::{SimulationCommand, TimescaleUnit, VarType};

use super::dictionary::{Form, Signal};
use super::reader::{Header, Writer};
use super::steps::{Place, Step};
use super::values::Value;
use crate::analysis::{push_digits, write_real};
use crate::dict::Micro;
use crate::run::End;

/// The scope of the signals whose names have no dot, and of the variables that are no signals.
const SCOPE: &str = "PLC";
/// Text goes out when there is so much of it, in bytes.
const BUFFER: usize = 1 << 16;

/// A value change dump.
pub struct Wave<W: Write> {
    out: vcd::Writer<W>,
    signals: Vec<Variable>,
    seq: Variable,
    n: Variable,
    stop: Variable,
    /// The step before.
    before: Option<(u64, Place)>,
    /// When its block ends, µs, where that is known.
    end: Option<u64>,
    /// Text that waits for the next write.
    text: String,
}

/// A declared variable.
#[derive(Debug, Default)]
struct Variable {
    id: String,
    form: Option<Form>,
}

impl<W: Write> fmt::Debug for Wave<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Wave").field("before", &self.before).finish_non_exhaustive()
    }
}

impl<W: Write> Wave<W> {
    /// Writes to `out`.
    pub fn new(out: W) -> Self {
        Self {
            out: vcd::Writer::new(out),
            signals: Vec::new(),
            seq: Variable::default(),
            n: Variable::default(),
            stop: Variable::default(),
            before: None,
            end: None,
            text: String::new(),
        }
    }

    fn declare(&mut self, kind: VarType, width: u32, name: &str, form: Option<Form>) -> io::Result<Variable> {
        let id = self.out.add_var(kind, width, name, None)?.to_string();
        Ok(Variable { id, form })
    }

    fn declare_signal(&mut self, signal: &Signal) -> io::Result<Variable> {
        let name = name_in_scope(signal);
        let form = signal.form();
        let (kind, width) = match form {
            Form::Bit => (VarType::Wire, 1),
            Form::Byte => (VarType::Wire, 8),
            Form::Word => (VarType::Wire, 16),
            Form::DWord => (VarType::Wire, 32),
            Form::Real => (VarType::Real, 64),
        };
        self.declare(kind, width, &name, Some(form))
    }

    /// The signals of a scope, in the order of the dictionary.
    fn declare_scope(&mut self, signals: &[&'static Signal], block: bool, to: &mut [Variable]) -> io::Result<()> {
        for (signal, variable) in signals.iter().zip(to) {
            if signal.row.is_of_command_block() == block {
                *variable = self.declare_signal(signal)?;
            }
        }
        Ok(())
    }

    /// The time of a step: later than that of the step before.
    fn time(&self, step: &Step<'_>) -> u64 {
        let after = self.before.map(|(time, _)| time + 1);
        // Millionths of a second are what a time counts.
        match step.start_s.map(microseconds) {
            Some(time) => time.max(after.unwrap_or(0)),
            None => after.unwrap_or(0),
        }
    }

    fn write_changes(&mut self, step: &Step<'_>) {
        let Self { text, signals, seq, n, stop, before, .. } = self;
        let place = step.place;
        let last = before.map(|(_, place)| place);
        let is_other = |other: fn(&Place) -> u64| last.is_none_or(|last| other(&last) != other(&place));
        if is_other(|place| place.seq) {
            push_vector(text, place.seq, &seq.id);
        }
        if is_other(|place| u64::from(place.n)) {
            push_vector(text, u64::from(place.n), &n.id);
        }
        if is_other(|place| u64::from(place.stop)) {
            push(text, Form::Bit, Some(i64::from(place.stop)), &stop.id);
        }
        let mut value = |index: usize| {
            if let (Some(variable), Some(value)) = (signals.get(index), step.values.get(index)) {
                push(text, variable.form.unwrap_or(Form::Bit), *value, &variable.id);
            }
        };
        if last.is_none() {
            (0..step.values.len()).for_each(value);
        } else {
            step.changed.iter().for_each(|&index| value(index));
        }
    }

    fn write_text(&mut self) -> io::Result<()> {
        let written = self.out.writer().write_all(self.text.as_bytes());
        self.text.clear();
        written
    }
}

fn push_time(text: &mut String, time: u64) {
    text.push('#');
    push_digits(time, 1, text);
    text.push('\n');
}

/// A run that breaks off leaves what it came to.
impl<W: Write> Drop for Wave<W> {
    fn drop(&mut self) {
        let _ = self.write_text();
    }
}

fn microseconds(seconds: Micro) -> u64 {
    u64::try_from(seconds.millionths()).unwrap_or(0)
}

/// `BLK.M[10]` is `M_10` in its scope.
fn name_in_scope(signal: &Signal) -> String {
    let name = signal.name.split_once('.').map_or(signal.name.as_str(), |(_, name)| name);
    name.replace('[', "_").replace(']', "")
}

fn push(text: &mut String, form: Form, value: Value, id: &str) {
    match (form, value) {
        (Form::Bit, Some(bit)) => {
            text.push(if bit == 0 { '0' } else { '1' });
            text.push_str(id);
            text.push('\n');
        }
        (Form::Bit, None) => {
            text.push('x');
            text.push_str(id);
            text.push('\n');
        }
        (Form::Real, Some(number)) => {
            text.push('r');
            write_real(number, text);
            push_id(text, id);
        }
        (Form::Real, None) => {
            text.push_str("rNaN");
            push_id(text, id);
        }
        (Form::Byte | Form::Word | Form::DWord, Some(number)) => push_vector(text, number.unsigned_abs(), id),
        (Form::Byte | Form::Word | Form::DWord, None) => {
            text.push_str("bx");
            push_id(text, id);
        }
    }
}

/// In binary; leading zeros may be left out.
fn push_vector(text: &mut String, number: u64, id: &str) {
    /// Four digits at once.
    const DIGITS: [&str; 16] = [
        "0000", "0001", "0010", "0011", "0100", "0101", "0110", "0111", "1000", "1001", "1010", "1011", "1100", "1101",
        "1110", "1111",
    ];
    text.push('b');
    let digits = u64::BITS - (number | 1).leading_zeros();
    // How many of the first four are leading zeros.
    let mut skipped = (digits.next_multiple_of(4) - digits) as usize;
    for four in (0..digits.div_ceil(4)).rev() {
        let four = DIGITS.get((number >> (4 * four) & 15) as usize).and_then(|four| four.get(skipped..));
        text.push_str(four.unwrap_or_default());
        skipped = 0;
    }
    push_id(text, id);
}

fn push_id(text: &mut String, id: &str) {
    text.push(' ');
    text.push_str(id);
    text.push('\n');
}

impl<W: Write> Writer for Wave<W> {
    fn wants_lines(&self) -> bool {
        false
    }

    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.out.version(concat!("cnc872c ", env!("CARGO_PKG_VERSION")))?;
        self.out.timescale(1, TimescaleUnit::US)?;
        let mut variables: Vec<Variable> = header.signals.iter().map(|_| Variable::default()).collect();
        if header.signals.iter().any(|signal| signal.row.is_of_command_block()) {
            self.out.add_module("BLK")?;
            self.declare_scope(header.signals, true, &mut variables)?;
            self.out.upscope()?;
        }
        self.out.add_module(SCOPE)?;
        self.seq = self.declare(VarType::Integer, u64::BITS, "seq", None)?;
        self.n = self.declare(VarType::Integer, u32::BITS, "n", None)?;
        self.stop = self.declare(VarType::Wire, 1, "stop", None)?;
        self.declare_scope(header.signals, false, &mut variables)?;
        self.out.upscope()?;
        self.signals = variables;
        self.out.enddefinitions()
    }

    fn file(&mut self, _: u32, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let time = self.time(step);
        push_time(&mut self.text, time);
        let first = self.before.is_none();
        if first {
            self.write_text()?;
            self.out.begin(SimulationCommand::Dumpvars)?;
        }
        self.write_changes(step);
        self.before = Some((time, step.place));
        self.end = step.end_s.map(microseconds);
        if first {
            self.write_text()?;
            self.out.end()?;
        }
        if self.text.len() < BUFFER { Ok(()) } else { self.write_text() }
    }

    fn end(&mut self, _: End) -> io::Result<()> {
        if let Some((time, _)) = self.before {
            push_time(&mut self.text, self.end.unwrap_or(0).max(time + 1));
        }
        self.write_text()?;
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::plc::dictionary::find;

    fn shown(form: Form, value: Value) -> String {
        let mut text = String::new();
        push(&mut text, form, value, "!");
        text
    }

    #[test]
    fn values() {
        assert_eq!(
            [shown(Form::Bit, Some(1)), shown(Form::Bit, Some(0)), shown(Form::Bit, None)],
            ["1!\n", "0!\n", "x!\n"]
        );
        assert_eq!(shown(Form::Byte, Some(0x95)), "b10010101 !\n");
        assert_eq!([shown(Form::DWord, Some(0)), shown(Form::Word, None)], ["b0 !\n", "bx !\n"]);
        for number in (0..40).chain([0x1234_5678, u64::from(u32::MAX), 1 << 63, u64::MAX]) {
            let mut text = String::new();
            push_vector(&mut text, number, "!");
            assert_eq!(text, format!("b{number:b} !\n"));
        }
        assert_eq!([shown(Form::Real, Some(-12_500_000)), shown(Form::Real, None)], ["r-12.5 !\n", "rNaN !\n"]);
    }

    #[test]
    fn names() {
        let name = |name: &str| name_in_scope(find(name).unwrap());
        assert_eq!(
            [name("BLK.M[10]"), name("BLK.M10"), name("BLK.AxNC[3]"), name("PB06")],
            ["M_10", "M10", "AxNC_3", "PB06"]
        );
    }
}
