//! What execution shows, between the words: how often a jump's stretch runs, how often a unit is called, what
//! parameters hold where they are read.

use gen_lsp_types::{InlayHint, InlayHintParams, Label, Tooltip};

use super::analysis::Analysis;
use super::places::{Places, span};
use super::snapshot::{Answer, Snapshot};
use crate::dict::{Address, Decimal, GCode, Lang, Micro, Plane};
use crate::query::cursor::{DOCUMENT, block_at};
use crate::query::flow::Flow;
use crate::query::hover_texts::Said;
use crate::query::observe::{Observation, control_of, executing, observe};
use crate::query::observed::Observed;
use crate::query::shown::{count, formula};
use crate::resolve::Roles;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Value, Word};

/// Different values that a hint shows; its tooltip shows more.
const SHOWN: usize = 3;

/// `textDocument/inlayHint`. A program without calls, jumps and parameters in the range is not executed.
pub(super) fn inlay_hint(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: InlayHintParams,
) -> Answer<Option<Vec<InlayHint>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let asked = span(&file.source, params.range, unit);
    let Some(last) = block_at(file, asked.end) else { return Ok(None) };
    let first = block_at(file, asked.start).unwrap_or_default();
    let rich = |block: &BlockId| file.flags(*block).has(BlockFlags::RICH);
    let blocks: Vec<BlockId> = (first.0..=last.0).map(BlockId).filter(rich).collect();
    let executed: Vec<BlockId> = blocks.iter().copied().filter(|block| has_hints(file, *block)).collect();
    let program = executing(snapshot.open(), analysis).filter(|_| !executed.is_empty());
    let observation = match program {
        None => Observation::default(),
        Some(program) => match observe(&snapshot.cancel, program, analysis, executed) {
            Some(observation) => observation,
            None => return Ok(None),
        },
    };
    let hinter = Hinter { analysis, file, observation: &observation, lang: snapshot.client.lang() };
    let mut places = Places::new(&file.source, unit);
    let mut hints = Vec::new();
    for block in blocks {
        let mut found = hinter.block(block);
        found.extend(hinter.written(block));
        found.sort_by_key(|hint| hint.at);
        for hint in found.into_iter().filter(|hint| asked.start <= hint.at && hint.at <= asked.end) {
            hints.push(InlayHint {
                position: places.position(hint.at),
                label: Label::String(hint.label),
                kind: None,
                text_edits: None,
                tooltip: Some(Tooltip::String(hint.tooltip)),
                padding_left: Some(true),
                padding_right: None,
                data: None,
            });
        }
    }
    Ok(Some(hints).filter(|hints| program.is_some() || !hints.is_empty()))
}

/// Whether a block may have hints.
fn has_hints(file: &ParsedFile, block: BlockId) -> bool {
    let flow = |code| matches!(code, GCode::G73 | GCode::G79);
    file.flags(block).has(BlockFlags::RICH)
        && (file.words(block).iter().any(|word| word.is_parametric())
            || crate::query::observe::g_functions(file, block).any(|(code, _)| flow(code)))
}

/// One hint, not yet as the protocol has it.
struct Hint {
    at: u32,
    label: String,
    tooltip: String,
}

struct Hinter<'a> {
    analysis: &'a Analysis,
    file: &'a ParsedFile,
    observation: &'a Observation,
    lang: Lang,
}

impl Hinter<'_> {
    fn block(&self, block: BlockId) -> Vec<Hint> {
        let Some(observed) = self.observation.of(block) else { return Vec::new() };
        let mut hints = self.values(block, observed);
        if let Some(flow) = Flow::of(self.analysis, self.file, block) {
            let hint =
                if flow.code == GCode::G79 { self.called(&flow, observed) } else { self.jump(block, &flow, observed) };
            hints.extend(hint);
        }
        hints
    }

    /// What words mean that are hard to read: control words, the planes that ISO names otherwise, the time of a dwell.
    fn written(&self, block: BlockId) -> Vec<Hint> {
        let text = self.file.source.text();
        let words = self.file.words(block);
        let dwell = Roles::written(words).dwell.is_some();
        let hint = |word: &Word| {
            let (label, tooltip) =
                if let Some(control) = control_of(&self.analysis.settings.machine, self.file, block, *word) {
                    let formula = formula(control);
                    (formula.clone(), Said::HintControl { formula })
                } else if let Some(code @ (GCode::G18 | GCode::G19)) = word.g_code()
                    && let Some(plane) = Plane::of(code)
                {
                    (plane.name.to_owned(), Said::HintPlane { g: code.number(), name: plane.name })
                } else if word.address == Address::Q && dwell {
                    let units = word.number().filter(|_| !word.is_faulty())?;
                    let s = Micro::from_millionths(units.thousandths().saturating_mul(10)).to_string();
                    (format!("= {s} s"), Said::HintDwell { s })
                } else {
                    return None;
                };
            Some(Hint { at: word.span(text).end, label, tooltip: tooltip.text(self.lang) })
        };
        words.iter().filter_map(hint).collect()
    }

    /// `= 10, 20, 30, …` after a word that a parameter gives; nothing where it was never known.
    fn values(&self, block: BlockId, observed: &Observed) -> Vec<Hint> {
        let text = self.file.source.text();
        let hint = |word: &Word| {
            let Value::Parameter { index, negated } = word.value() else { return None };
            let read = observed.reads.get(&index).filter(|values| values.is_known())?;
            let values = if negated { read.map(Decimal::negated) } else { read.clone() };
            let tooltip = Said::HintValue { r: index, values: read.list(|value| value) }.text(self.lang);
            let label = format!("= {}", values.brief(SHOWN, |value| value));
            Some(Hint { at: word.span(text).end, label, tooltip })
        };
        self.file.words(block).iter().filter_map(hint).collect()
    }

    /// `called 2×` after the entry of a unit; nothing when execution could not be followed that far.
    fn called(&self, flow: &Flow, observed: &Observed) -> Option<Hint> {
        let known = observed.runs > 0 || self.observation.end.is_some();
        known.then(|| Hint {
            at: flow.end(self.file.source.text()),
            label: Said::Called { runs: self.least(observed.runs) }.text(self.lang),
            tooltip: Said::HintCalled.text(self.lang),
        })
    }

    /// `×4` after a jump with a counter: backward, how often its stretch runs in a row; forward, how often it is taken.
    fn jump(&self, block: BlockId, flow: &Flow, observed: &Observed) -> Option<Hint> {
        let to = flow.jump()?;
        let counted = to <= block || !flow.uncounted;
        if !counted || !observed.taken.is_known() {
            return None;
        }
        let number = |block| self.file.shown_number(block);
        let jumps = self.least(observed.jumps);
        let (values, tooltip) = if to <= block {
            let runs = observed.taken.map(|jumps| jumps.saturating_add(1));
            let passes = runs.list(count);
            (runs, Said::HintStretch { from: number(to), to: number(block), passes, jumps })
        } else {
            let times = observed.taken.list(count);
            (observed.taken.clone(), Said::HintForward { times, jumps })
        };
        let label = format!("×{}", values.brief(SHOWN, count));
        Some(Hint { at: flow.end(self.file.source.text()), label, tooltip: tooltip.text(self.lang) })
    }

    /// A count, which may be higher when not all was executed.
    fn least(&self, number: u64) -> String {
        let number = count(number);
        if self.observation.end.is_none() { format!("≥ {number}") } else { number }
    }
}
