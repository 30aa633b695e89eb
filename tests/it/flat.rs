//! CMP-6: a program written out flat, block by block as it is executed, does the same.

use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::Path;

use cnc872c::analysis::compare::{Comparison, StepReader, Steps, Tolerances, compare};
use cnc872c::config::Purpose;
use cnc872c::diag::Findings;
use cnc872c::dict::{Address, Decimal, GCode, Micro};
use cnc872c::run::{End, Executed, Sink, State};
use cnc872c::session::Session;
use cnc872c::syntax::{Value, Word};
use cnc872c::text::MemoryLoader;

use crate::state::samples;

/// Writes executed blocks: no calls, no jumps, no parameters, numbers in the order of execution.
struct Flat {
    /// Before the next block: it reads the values that parameters had then (PAR-4).
    before: State,
    text: String,
    calls: bool,
    /// Some of it cannot be written as text.
    impossible: bool,
}

/// Functions that lead execution, and those that compute.
const LEADS: [GCode; 9] =
    [GCode::G70, GCode::G71, GCode::G72, GCode::G73, GCode::G79, GCode::G26, GCode::G27, GCode::G28, GCode::G29];

/// Whether a function is nothing in a flat program: mapped cycles are the macrocycles that they call.
fn leads(block: &Executed<'_>, number: Decimal) -> bool {
    let cycles = block.settings().machine.cycles.keys().copied();
    LEADS.map(GCode::number).into_iter().chain(cycles).any(|leads| number.as_whole() == Some(i64::from(leads)))
}

impl Flat {
    fn word(&self, block: &Executed<'_>, word: &Word) -> Option<String> {
        let calls = block.g_written().any(|code| matches!(code, GCode::G71 | GCode::G72 | GCode::G73));
        let value = match word.value() {
            Value::Parameter { index, negated } => {
                let value = self.before.parameter(index)?;
                if negated { value.negated() } else { value }
            }
            Value::Number(value) => value,
            Value::None => return None,
        };
        let address = word.address;
        let is_left_out = [Address::N, Address::Skip, Address::Program, Address::R, Address::L].contains(&address)
            // Of a block that calls and dwells it is both.
            || address == Address::Q && calls && block.dwell().is_none()
            || address == Address::G && leads(block, value);
        if is_left_out {
            return None;
        }
        if address == Address::Correction {
            return Some(format!("&{:04}", value.as_whole()?));
        }
        Some(format!("{address}{value}"))
    }
}

impl Sink for &mut Flat {
    type Whole = End;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.calls |= block.depth() > 0 || block.jump().is_some();
        self.impossible |= block.opaque_call().is_some();
        let is_unknown = |word: &Word| match word.value() {
            Value::Parameter { index, .. } => word.address != Address::R && self.before.parameter(index).is_none(),
            Value::None | Value::Number(_) => false,
        };
        self.impossible |= block.source_words().iter().any(is_unknown);
        let words: Vec<String> = block.source_words().iter().filter_map(|word| self.word(block, word)).collect();
        if !words.is_empty() {
            let _ = writeln!(self.text, "N{} {}", block.seq() + 1, words.join(" "));
        }
        self.before = block.state().clone();
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}

fn steps(session: &Session<'_>, file: &str) -> Option<Steps> {
    let mut reader = StepReader::new(false);
    let run = session.watch(Path::new(file), file, Purpose::Report, &mut &mut reader);
    run.whole.map(|_| reader.finish())
}

#[test]
fn every_sample_written_out_flat() {
    let tolerances = Tolerances { position: Micro::from_millionths(1000), percent: 0.0 };
    let mut compared = [0; 2];
    for sample in samples() {
        let session = sample.session();
        let Some(as_written) = steps(&session, &sample.file) else { continue };
        let mut flat =
            Flat { before: State::new(&sample.settings), text: "%1\n".to_owned(), calls: false, impossible: false };
        session.watch(Path::new(&sample.file), &sample.file, Purpose::Report, &mut &mut flat);
        if flat.impossible {
            continue;
        }
        let loader = MemoryLoader::new().with("flat.nc", flat.text.clone().into_bytes());
        let session = Session { loader: &loader, settings: &sample.settings, progress: None };
        let Some(steps) = steps(&session, "flat.nc") else { panic!("{}\n{}", sample.name, flat.text) };
        for (old, new) in [(&as_written, &steps), (&steps, &as_written)] {
            assert_eq!(compare(old, new, tolerances), Comparison::default(), "{}\n{}", sample.name, flat.text);
        }
        compared[usize::from(flat.calls)] += 1;
    }
    assert!(compared[0] > 100 && compared[1] > 50, "{compared:?}");
}
