//! One layout for programs and macrocycles (FMT-1 to FMT-7): blanks, line ends, the case of addresses and the writing
//! of numbers change, nothing else. What could not be read stays byte for byte.

mod block;
#[cfg(feature = "lsp")]
mod changes;
mod gap;
mod kept;
mod word;

#[cfg(feature = "lsp")]
use std::ops::RangeInclusive;
use std::path::Path;
use std::sync::Arc;

use super::alone::{self, Reading};
use super::output::{Output, Written};
use crate::config::{Level, Settings, Style};
use crate::diag::{Code, Findings};
use crate::session::Outcome;
use crate::syntax::ParsedFile;
use crate::text::SourceText;
#[cfg(feature = "lsp")]
use crate::text::Span;
#[cfg(feature = "lsp")]
use changes::{Changes, Collector};
use gap::Layout;
use kept::Kept;

/// Most characters of a line (LEX-7).
const LINE: usize = 80;

/// A text with what formatting changes in it.
#[derive(Debug)]
pub struct Formatting {
    file: ParsedFile,
    kept: Kept,
    style: Style,
    findings: Findings,
}

/// Formatting changes what it reads, and whether a line can be read may depend on the lines around it: so often it is
/// done again before it must have come to an end.
const MOST_ROUNDS: usize = 4;

impl Formatting {
    /// Reads a text to be formatted. `path` says whether it is a program or a macrocycle.
    ///
    /// # Errors
    /// The finding that keeps the file as it is.
    pub fn of(path: &Path, source: &Arc<SourceText>, settings: &Settings) -> Result<Self, Box<Outcome>> {
        let mut watchful = settings.clone();
        watchful.lints.extend(kept::WARNINGS.map(|code| (code, Level::Warn)));
        let (outcome, resolved) = alone::resolve(path, source, &watchful);
        let outcome = obstacle(outcome)?;
        let Some(file) = resolved.into_program() else { return Err(Box::default()) };
        let kept = Kept::of(&file, &outcome.findings);
        let mut formatting = Self { file, kept, style: settings.format, findings: outcome.findings };
        formatting.keep_lines_that_would_grow();
        Ok(formatting)
    }

    /// How many lines stay as they are because they could not be read.
    pub fn lines_left(&self) -> usize {
        self.kept.unread()
    }

    /// Whether the formatted text is certain to read like this one. Lines that stay, errors, and long lines leave
    /// doubt: after formatting there may be others.
    fn is_settled(&self) -> bool {
        !self.findings.has_errors() && !self.findings.has(Code::E0109) && self.kept.is_empty()
    }

    /// The meaning of the text.
    fn reading(&self) -> Reading {
        Reading::of(&self.file, &self.findings)
    }

    /// The edits in the order of the text.
    fn edits(&self, write: &mut dyn FnMut(Written<'_>)) {
        Layout::new(&self.file, &self.kept, self.style).write(write);
    }

    /// Gives the formatted text to `out`, part by part, unless it is the same; whether it is another one.
    fn write(&self, source: &SourceText, out: &mut dyn FnMut(&str)) -> bool {
        let mut output = Output::new(source, out);
        self.edits(&mut |edit| output.write(edit));
        output.finish()
    }

    /// The place in the text of a part of it; nothing for the whole.
    #[cfg(feature = "lsp")]
    fn place(&self, part: Part) -> Option<Span> {
        let source = &self.file.source;
        match part {
            Part::Whole => None,
            Part::Line(line) => Some(source.line_span(line)),
            Part::Blocks(span) => {
                let lines = self.whole_blocks(kept::lines_of(&self.file, span));
                Some(source.line_span(*lines.start()).to(source.line_span(*lines.end())))
            }
        }
    }

    /// The lines of all blocks that those lines touch.
    #[cfg(feature = "lsp")]
    fn whole_blocks(&self, lines: RangeInclusive<usize>) -> RangeInclusive<usize> {
        let (mut first, mut last) = lines.into_inner();
        let mut block_part = block::Part::default();
        loop {
            let before = (first, last);
            for block in self.file.block_ids() {
                block_part.read(&self.file, block);
                let lines = kept::lines_of(&self.file, block_part.span());
                if *lines.start() <= last && first <= *lines.end() {
                    (first, last) = (first.min(*lines.start()), last.max(*lines.end()));
                }
            }
            if before == (first, last) {
                return first..=last;
            }
        }
    }

    /// Formatting makes no line longer than 80 characters that was not: where it would, the block stays.
    fn keep_lines_that_would_grow(&mut self) {
        loop {
            let grown = Layout::new(&self.file, &self.kept, self.style).grown();
            if grown.is_empty() {
                return;
            }
            self.kept.keep(&self.file, grown);
        }
    }
}

/// What came of formatting a file.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Formatted {
    /// Whether it becomes another one. If not, what was given of it does not count.
    pub changed: bool,
    /// How many lines stay because they could not be read.
    pub lines_left: usize,
}

/// Formats a file, and gives its bytes to `out`, part by part, as soon as they are known.
///
/// # Errors
/// The finding that keeps the file as it is.
pub fn format(
    path: &Path,
    source: &Arc<SourceText>,
    settings: &Settings,
    out: &mut dyn FnMut(&[u8]),
) -> Result<Formatted, Box<Outcome>> {
    let encoding = source.encoding();
    let mut out = |text: &str| out(&encoding.encode(text));
    let mut changed = false;
    let mut made: Option<Arc<SourceText>> = None;
    let Rounds { left, stays } = in_rounds(path, source, settings, &mut |formatting, source| {
        if made.is_none() && formatting.is_settled() {
            changed = formatting.write(source, &mut out);
            return None;
        }
        let mut text = String::with_capacity(source.text().len() + source.text().len() / 16);
        let again = formatting.write(source, &mut |part| text.push_str(part));
        // The tree takes more memory than the text.
        drop(formatting);
        let next = again.then(|| Arc::new(source.with_text(text)))?;
        made = Some(Arc::clone(&next));
        Some(next)
    })?;
    if let Some(made) = made.filter(|_| !stays) {
        changed = true;
        out(made.text());
    }
    Ok(Formatted { changed, lines_left: left })
}

/// What formatting changes in a text, or in a part of it.
///
/// # Errors
/// The finding that keeps the text as it is.
#[cfg(feature = "lsp")]
pub(crate) fn changes(
    path: &Path,
    source: &Arc<SourceText>,
    settings: &Settings,
    part: Part,
) -> Result<Changes, Box<Outcome>> {
    let mut all: Option<Changes> = None;
    let mut within = None;
    let rounds = in_rounds(path, source, settings, &mut |formatting, source| {
        if all.is_none() {
            within = formatting.place(part);
        }
        let mut collector = Collector::new(source);
        formatting.edits(&mut |edit| collector.write(edit));
        let changes = collector.finish();
        let again = !changes.is_empty() && !formatting.is_settled();
        let changes = match all.take() {
            Some(before) => before.then(changes),
            None => changes,
        };
        let next = again.then(|| Arc::new(SourceText::from_text(source.name(), changes.text())));
        all = Some(changes);
        next
    })?;
    let mut changes = all.filter(|_| !rounds.stays).unwrap_or_default();
    if let Some(within) = within {
        changes.keep_within(source, within);
    }
    Ok(changes)
}

/// The part of a text to format.
#[cfg(feature = "lsp")]
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part {
    /// All of it.
    Whole,
    /// The blocks that a span touches.
    Blocks(Span),
    /// One line, from 0, whatever block it belongs to.
    Line(usize),
}

/// The outcome of formatting in rounds.
struct Rounds {
    /// How many lines of the first text stay because they could not be read.
    left: usize,
    /// All of them stay: what could not be read would be read otherwise after formatting (FMT-7).
    stays: bool,
}

/// Formats a text, and what becomes of it, until nothing changes any more. `apply` takes the edits, and gives the text
/// that they make when it is to be formatted again: one with errors, or with lines that stay.
fn in_rounds(
    path: &Path,
    source: &Arc<SourceText>,
    settings: &Settings,
    apply: &mut dyn FnMut(Formatting, &SourceText) -> Option<Arc<SourceText>>,
) -> Result<Rounds, Box<Outcome>> {
    let formatting = Formatting::of(path, source, settings)?;
    let left = formatting.lines_left();
    let first = (!formatting.is_settled()).then(|| formatting.reading());
    let mut next = apply(formatting, source);
    for round in 1..=MOST_ROUNDS {
        let (Some(made), Some(first)) = (next, &first) else { break };
        let formatting = Formatting::of(path, &made, settings).ok();
        let Some(formatting) = formatting.filter(|formatting| first.stays_in(&formatting.reading())) else {
            let ended = source.text().ends_with(['\n', '\r']);
            return Ok(Rounds { left: source.lines().count() - usize::from(ended), stays: true });
        };
        next = if round < MOST_ROUNDS { apply(formatting, &made) } else { None };
    }
    Ok(Rounds { left, stays: false })
}

/// What keeps a file as it is (FMT-6): UTF-16 (E0115), and programs for other controls (W0113); without a finding there
/// is nothing to format.
fn obstacle(outcome: Outcome) -> Result<Outcome, Box<Outcome>> {
    let Some(code) = [Code::E0115, Code::W0113].into_iter().find(|code| outcome.findings.has(*code)) else {
        return Ok(outcome);
    };
    let mut findings = Findings::with_levels(*outcome.findings.levels());
    outcome.findings.items().iter().filter(|item| item.code() == code).for_each(|item| findings.add(item.clone()));
    Err(Box::new(Outcome { findings, ..outcome }))
}
