//! `cnc872c/signals`: what the PLC reads in the block at a place.

use std::io;
use std::path::Path;

use gen_lsp_types::TextDocumentPositionParams;
use serde_json::{Value, json};

use super::analysis::Analysis;
use super::places::offset;
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::analysis::Part;
use crate::analysis::plc::{self, Form, Header, Place, Reader, Signal, Step, Writer};
use crate::config::Purpose;
use crate::dict::Lang;
use crate::edit::edit_texts::EditText;
use crate::query;
use crate::query::cursor::{DOCUMENT, block_at};
use crate::query::hover_texts::Said;
use crate::query::observe::{MOST, executing};
use crate::query::shown::count;
use crate::run::End;
use crate::session::{Session, TimedSignals, Times};

/// Most different steps of the block that are shown.
const SHOWN: usize = 20;

/// A place in a program or macrocycle gives `{ "text", "truncated" }`: the steps of the block, with the signals that
/// they change and those that are neither 0 nor absent. Null where no block is.
pub(super) fn signals(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: TextDocumentPositionParams,
) -> Answer<Option<Value>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let lang = snapshot.client.lang();
    let place = offset(&file.source, params.position, snapshot.client.unit);
    let block = block_at(file, place).filter(|_| place <= file.end);
    let Some((block, number)) = block.and_then(|block| Some((block, file.n_word(block)?))) else { return Ok(None) };
    let Some(program) = executing(snapshot.open(), analysis) else {
        let macrocycle = Session::is_macrocycle_name(&analysis.path);
        let why = if macrocycle { Said::NoProgram } else { Said::HasErrors };
        return Err(Refusal::new(why.text(lang)));
    };
    let at = file.source.line_column(number.start());
    let machine = &program.settings.machine;
    let empty = || Sheet {
        snapshot,
        program,
        path: &analysis.path,
        place: (at.line, at.column),
        index: (program.path == analysis.path).then_some(0),
        signals: Vec::new(),
        runs: 0,
        seen: Vec::new(),
        more: false,
    };
    let mut sheet = empty();
    let mut failed = None;
    if machine.motion.configured {
        // With those that motion gives, as far as the program has no errors.
        let signals = plc::default(machine.dialect, true, true);
        let reader = Reader::new(signals, machine, Part::default(), &mut sheet, &mut failed).unreported();
        let times = Times { phases: false, time_dist: true };
        let name = program.path.to_string_lossy();
        program.session().run_timed(&program.path, &name, Purpose::Check, times, TimedSignals(reader));
    }
    if sheet.runs == 0 && !snapshot.cancel.is_cancelled() {
        sheet = empty();
        failed = None;
        let signals = plc::default(machine.dialect, true, false);
        let reader = Reader::new(signals, machine, Part::default(), &mut sheet, &mut failed).unreported();
        program.observe(reader);
    }
    if snapshot.cancel.is_cancelled() {
        return Ok(None);
    }
    let title = file.source.slice(file.source.line_span(at.line as usize - 1)).trim().to_owned();
    let truncated = sheet.more || failed.is_some();
    let n = file.shown_number(block);
    Ok(Some(json!({ "text": sheet.text(n, &title, lang), "truncated": truncated })))
}

/// The signals of the block.
struct Sheet<'a> {
    snapshot: &'a Snapshot,
    program: &'a query::analysis::Analysis,
    /// The document.
    path: &'a Path,
    /// Line and column of the block's `N`.
    place: (u32, u32),
    /// Index of the document among the program's files, once it is known.
    index: Option<u32>,
    signals: Vec<&'static Signal>,
    /// How often the block was executed.
    runs: u64,
    seen: Vec<Seen>,
    /// There are more different steps than are shown.
    more: bool,
}

/// Steps of the block that are alike.
struct Seen {
    place: Place,
    values: Vec<plc::Value>,
    changed: Vec<usize>,
    times: u64,
}

impl Writer for Sheet<'_> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.signals = header.signals.to_vec();
        Ok(())
    }

    fn file(&mut self, index: u32, name: &str) -> io::Result<()> {
        if self.index.is_none() && self.program.loader.canonical(Path::new(name)) == self.path {
            self.index = Some(index);
        }
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let place = step.place;
        if place.seq >= MOST || self.snapshot.cancel.is_cancelled() {
            return Err(io::ErrorKind::Interrupted.into());
        }
        if self.index != Some(place.file) || (place.line, place.column) != self.place {
            return Ok(());
        }
        self.runs += u64::from(!place.stop);
        let alike = |seen: &&mut Seen| {
            seen.place.stop == place.stop && seen.values == step.values && seen.changed == step.changed
        };
        if let Some(seen) = self.seen.iter_mut().find(alike) {
            seen.times += 1;
        } else if self.seen.len() < SHOWN {
            // What was absent before the program is no news.
            let told = |index: &usize| place.seq > 0 || step.values.get(*index).copied().flatten().is_some();
            let changed = step.changed.iter().copied().filter(told).collect();
            self.seen.push(Seen { place, values: step.values.to_vec(), changed, times: 1 });
        } else {
            self.more = true;
        }
        Ok(())
    }

    fn end(&mut self, _: End) -> io::Result<()> {
        Ok(())
    }
}

impl Sheet<'_> {
    fn text(&self, n: u32, title: &str, lang: Lang) -> String {
        let said = if self.runs == 0 { Said::NeverRuns { n } } else { Said::Runs { n, runs: count(self.runs) } };
        let mut text = format!("{title}\n{}\n", said.text(lang));
        for seen in &self.seen {
            let stop = if seen.place.stop { ", stop" } else { "" };
            let times = if seen.times > 1 { format!(" ({}×)", count(seen.times)) } else { String::new() };
            text.push_str(&format!("\nseq {}{stop}{times}\n", seen.place.seq));
            let holds = |index: &usize| {
                let value = seen.values.get(*index).copied().flatten();
                let bit = self.signals.get(*index).is_some_and(|signal| signal.form() == Form::Bit);
                !seen.changed.contains(index) && value.is_some() && !(bit && value == Some(0))
            };
            self.push(EditText::SignalsChange, &seen.changed, seen, lang, &mut text);
            let rest: Vec<usize> = (0..seen.values.len()).filter(holds).collect();
            self.push(EditText::SignalsHold, &rest, seen, lang, &mut text);
        }
        text
    }

    fn push(&self, heading: EditText, indices: &[usize], seen: &Seen, lang: Lang, text: &mut String) {
        if indices.is_empty() {
            return;
        }
        text.push_str(&format!("  {}\n", heading.text(lang)));
        for &index in indices {
            let (Some(signal), Some(value)) = (self.signals.get(index), seen.values.get(index)) else { continue };
            let mut shown = format!("{}=", signal.name);
            match value {
                Some(_) => plc::write_value(signal, *value, &mut shown),
                None => shown.push('-'),
            }
            let meaning = signal.meaning_on(&self.program.settings.machine, lang);
            text.push_str(&format!("    {shown:<22}  {meaning}\n"));
        }
    }
}
