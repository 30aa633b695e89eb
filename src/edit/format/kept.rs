//! Which lines stay byte for byte (FMT-6): those that could not be read, and all lines of the blocks that they cut.

use std::ops::{Range, RangeInclusive};

use super::block::{BLANK, extent, items};
use super::word;
use crate::config::Style;
use crate::diag::{Code, Findings};
use crate::syntax::{BlockFlags, ParsedFile};
use crate::text::{FileId, Span};

/// The warnings that say that a line, or the file, is perhaps not what was meant. They count when they are allowed,
/// too.
pub(super) const WARNINGS: [Code; 4] = [Code::W0113, Code::W0114, Code::W0213, Code::W0221];

/// Whether a finding says that its line could not be read as it was meant.
const fn is_unread(code: Code) -> bool {
    code.is_malformed() || matches!(code, Code::W0114 | Code::W0213 | Code::W0221)
}

/// The lines that stay as they are.
#[derive(Debug, Default)]
pub(super) struct Kept {
    /// By line from 0; empty when no line stays.
    lines: Vec<bool>,
    /// How many of them because they could not be read.
    unread: usize,
}

impl Kept {
    /// The lines that could not be read. Where there are more than findings are kept, none could.
    pub(super) fn of(file: &ParsedFile, findings: &Findings) -> Self {
        let mut kept = Self::default();
        // Characters that are no word have an error, or one of those warnings.
        if !findings.has_errors() && findings.items().iter().all(|item| !is_unread(item.code())) {
            debug_assert!(debris(file).is_empty(), "no finding in {:?}", file.source.text());
            return kept;
        }
        let lines = file.source.lines().count();
        if findings.beyond().any(|((found_in, code), _)| found_in == FileId(0) && is_unread(code)) {
            kept.add(lines, 0..lines);
        }
        let unread = findings.items().iter().filter(|item| item.at.file == FileId(0) && is_unread(item.code()));
        kept.add(lines, unread.flat_map(|item| lines_of(file, item.at.span)));
        kept.add(lines, debris(file));
        // A line whose number is missing is read as a block only while it is not indented.
        let merged = file.block_ids().filter(|block| file.flags(*block).has(BlockFlags::MERGED));
        kept.add(lines, merged.flat_map(|block| lines_of(file, extent(file, block))));
        kept.close(file);
        kept.unread = kept.lines.iter().filter(|stays| **stays).count();
        kept
    }

    /// Keeps more lines.
    pub(super) fn keep(&mut self, file: &ParsedFile, lines: impl IntoIterator<Item = usize>) {
        self.add(file.source.lines().count(), lines);
        self.close(file);
    }

    fn add(&mut self, count: usize, lines: impl IntoIterator<Item = usize>) {
        for line in lines {
            self.lines.resize(count, false);
            if let Some(stays) = self.lines.get_mut(line) {
                *stays = true;
            }
        }
    }

    /// Whether no line stays.
    pub(super) const fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// How many lines could not be read, blocks that they cut included.
    pub(super) const fn unread(&self) -> usize {
        self.unread
    }

    /// Whether the line at a place stays. `hint` is the line of a place shortly before, and becomes the one of this
    /// place.
    pub(super) fn has(&self, file: &ParsedFile, at: u32, hint: &mut usize) -> bool {
        if self.is_empty() {
            return false;
        }
        *hint = file.source.lines().line_near(at, *hint);
        self.line(*hint)
    }

    /// Whether a line stays, from 0.
    pub(super) fn line(&self, line: usize) -> bool {
        self.lines.get(line).is_some_and(|stays| *stays)
    }

    /// Takes in all lines of the blocks of which one stays: blocks that share lines stay together.
    fn close(&mut self, file: &ParsedFile) {
        if self.is_empty() {
            return;
        }
        let index = file.source.lines();
        let mut line = 0;
        let mut together = 0..0;
        for block in file.block_ids() {
            let span = extent(file, block);
            let first = index.line_near(span.start, line);
            line = index.line_near(span.end.saturating_sub(1).max(span.start), first);
            if first >= together.end {
                self.close_lines(together);
                together = first..first;
            }
            together.end = together.end.max(line + 1);
        }
        self.close_lines(together);
    }

    fn close_lines(&mut self, together: Range<usize>) {
        if let Some(lines) = self.lines.get_mut(together)
            && lines.contains(&true)
        {
            lines.fill(true);
        }
    }
}

/// The lines that a part of the text is in.
pub(super) fn lines_of(file: &ParsedFile, span: Span) -> RangeInclusive<usize> {
    let lines = file.source.lines();
    lines.line_at(span.start)..=lines.line_at(span.end.saturating_sub(1).max(span.start))
}

/// The lines with text that is neither well-formed word nor comment, whatever findings it has.
fn debris(file: &ParsedFile) -> Vec<usize> {
    let mut lines = Vec::new();
    let mut from = file.start;
    let mut look = |gap: Span| {
        let text = file.source.slice(gap);
        let debris = text.trim_start_matches(BLANK);
        if !debris.is_empty() {
            let start = gap.end - u32::try_from(debris.len()).unwrap_or(0);
            let length = u32::try_from(debris.trim_end_matches(BLANK).len()).unwrap_or(0);
            lines.extend(lines_of(file, Span::new(start, start + length)));
        }
    };
    for item in items(file) {
        look(Span::new(from.min(item.start), item.start));
        from = from.max(item.end);
    }
    let end = file.end.max(from);
    let star = file.source.slice(Span::new(from, end)).ends_with('*');
    look(Span::new(from, end - u32::from(star)));
    // A word whose finding is part of another one.
    let mut written = String::new();
    for word in file.all_words().map(|word| word.span(file.source.text())) {
        written.clear();
        let text = file.source.slice(word);
        if !word::is_tidy(text, Style::default()) && !word::write(text, Style::default(), &mut written) {
            lines.extend(lines_of(file, word));
        }
    }
    lines
}
