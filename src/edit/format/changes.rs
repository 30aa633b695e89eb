//! What formatting changes in a text, as pairs of places: for editors, which take edits instead of a new file.

use std::cmp::Ordering;

use crate::edit::output::Written;
use crate::sure::{Sure, small};
use crate::text::{SourceText, Span};

/// A part of a text that became another one.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Change {
    old: Span,
    new: Span,
}

/// A text after formatting, with what changed in it, in the order of the text.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    text: String,
    changes: Vec<Change>,
}

impl Changes {
    /// The edits: the span of the old text that each replaces, and the new text.
    pub(crate) fn edits(&self) -> impl ExactSizeIterator<Item = (Span, &str)> {
        self.changes.iter().map(|change| (change.old, self.slice(change.new)))
    }

    /// One edit for changes on the same line and on lines one below the other, so that every line is in one edit at
    /// most. `source` is the old text.
    pub(crate) fn joined(&self, source: &SourceText) -> Vec<(Span, &str)> {
        let lines = source.lines();
        let mut joined: Vec<Change> = Vec::new();
        let mut last = 0;
        for change in &self.changes {
            let first = lines.line_near(change.old.start, last);
            match joined.last_mut() {
                Some(before) if first <= last + 1 => {
                    *before = Change { old: before.old.to(change.old), new: before.new.to(change.new) };
                }
                _ => joined.push(*change),
            }
            last = lines.line_near(change.old.end, first);
        }
        joined.iter().map(|change| (change.old, self.slice(change.new))).collect()
    }

    /// Only the changes within a part of the old text. A comment that moves before its block comes there by one change
    /// and leaves by a later one: where one of them is within, both stay.
    pub(super) fn keep_within(&mut self, source: &SourceText, part: Span) {
        let quotes = |text: &str| text.bytes().filter(|byte| *byte == b'"').count();
        let mut kept: Vec<bool> =
            self.changes.iter().map(|change| part.start <= change.old.start && change.old.end <= part.end).collect();
        let mut arrival = None;
        for (at, change) in self.changes.iter().enumerate() {
            match quotes(self.slice(change.new)).cmp(&quotes(source.slice(change.old))) {
                Ordering::Greater => arrival = Some(at),
                Ordering::Less if let Some(arrived) = arrival.take() => {
                    if let Ok([arrives, leaves]) = kept.get_disjoint_mut([arrived, at]) {
                        let moves = *arrives || *leaves;
                        (*arrives, *leaves) = (moves, moves);
                    }
                }
                Ordering::Less | Ordering::Equal => {}
            }
        }
        let mut kept = kept.into_iter();
        self.changes.retain(|_| kept.next() == Some(true));
    }

    /// Whether nothing changes.
    pub(crate) const fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// The whole text after all changes.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// These changes, and then others of the text that they gave.
    pub(super) fn then(self, next: Self) -> Self {
        if next.is_empty() {
            return self;
        }
        let mut changes: Vec<Change> = Vec::with_capacity(self.changes.len() + next.changes.len());
        let (mut first, mut second) = (self.changes.into_iter().peekable(), next.changes.into_iter().peekable());
        let (mut before, mut after) = (Shift::default(), Shift::default());
        loop {
            // In the text between the two, changes that overlap or touch become one.
            let starts = [first.peek().map(|change| change.new.start), second.peek().map(|change| change.old.start)];
            let Some(start) = starts.into_iter().flatten().min() else { break };
            let (old_start, new_start) = (before.apply(start), after.apply(start));
            let mut end = start;
            loop {
                if let Some(change) = first.next_if(|change| change.new.start <= end) {
                    end = end.max(change.new.end);
                    before = Shift::between(change.new.end, change.old.end);
                } else if let Some(change) = second.next_if(|change| change.old.start <= end) {
                    end = end.max(change.old.end);
                    after = Shift::between(change.old.end, change.new.end);
                } else {
                    break;
                }
            }
            let old = Span::new(old_start, before.apply(end));
            changes.push(Change { old, new: Span::new(new_start, after.apply(end)) });
        }
        Self { text: next.text, changes }
    }

    fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).sure()
    }
}

/// By how much places of one text stand further on in another.
#[derive(Clone, Copy, Debug, Default)]
struct Shift(i64);

impl Shift {
    fn between(here: u32, there: u32) -> Self {
        Self(i64::from(there) - i64::from(here))
    }

    fn apply(self, at: u32) -> u32 {
        u32::try_from(i64::from(at) + self.0).ok().sure()
    }
}

/// Collects [`Changes`] from edits in the order of the text.
pub(super) struct Collector<'a> {
    source: &'a SourceText,
    at: u32,
    changes: Changes,
}

impl<'a> Collector<'a> {
    pub(super) fn new(source: &'a SourceText) -> Self {
        let text = String::with_capacity(source.len() as usize + source.len() as usize / 16);
        Self { source, at: 0, changes: Changes { text, changes: Vec::new() } }
    }

    /// One more edit.
    pub(super) fn write(&mut self, edit: Written<'_>) {
        let text = &mut self.changes.text;
        text.push_str(self.source.slice(Span::new(self.at, edit.span.start)));
        let start = small(text.len());
        text.push_str(edit.before);
        text.push_str(edit.copied.map_or("", |copied| self.source.slice(copied)));
        text.push_str(edit.after);
        self.at = edit.span.end;
        self.take(Change { old: edit.span, new: Span::new(start, small(self.changes.text.len())) });
    }

    /// Splits a change at its first and last line end: a line whose
    /// neighbours change stays untouched, and no edit ends within a line end of two characters.
    fn take(&mut self, change: Change) {
        let Change { old, new } = change;
        match (line_ends(self.source.slice(old), old.start), line_ends(self.changes.slice(new), new.start)) {
            (Some(from), Some(to)) => {
                self.push(Change { old: Span::new(old.start, from.start), new: Span::new(new.start, to.start) });
                self.push(Change { old: from, new: to });
                self.push(Change { old: Span::new(from.end, old.end), new: Span::new(to.end, new.end) });
            }
            _ => self.push(change),
        }
    }

    fn push(&mut self, change: Change) {
        if self.source.slice(change.old) != self.changes.slice(change.new) {
            self.changes.changes.push(change);
        }
    }

    pub(super) fn finish(mut self) -> Changes {
        self.changes.text.push_str(self.source.slice(Span::new(self.at, self.source.len())));
        self.changes
    }
}

/// From the first line end in a text that begins at `start` to behind the last one.
fn line_ends(text: &str, start: u32) -> Option<Span> {
    let first = text.find(['\n', '\r'])?;
    let last = text.rfind(['\n', '\r'])?;
    Some(Span::new(start + small(first), start + small(last) + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changes(source: &SourceText, edits: &[(u32, u32, &str)]) -> Changes {
        let mut collector = Collector::new(source);
        for &(start, end, text) in edits {
            collector.write(Written { span: Span::new(start, end), before: text, copied: None, after: "" });
        }
        collector.finish()
    }

    fn applied(source: &SourceText, changes: &Changes) -> String {
        let mut text = source.text().to_owned();
        let edits: Vec<_> = changes.edits().collect();
        for (span, new) in edits.into_iter().rev() {
            text.replace_range(span.range(), new);
        }
        text
    }

    /// Lines between changed ones are in no edit, and neither is half of a CR LF.
    #[test]
    fn changes_end_at_lines() {
        let source = SourceText::from_text("a", "N1 \r\n  N2\r\n\r\n\r\nN3");
        let changes = changes(&source, &[(2, 7, "\r\n"), (9, 15, "\r\n\r\n")]);
        let edits: Vec<_> = changes.edits().collect();
        assert_eq!(edits, [(Span::new(2, 3), ""), (Span::new(5, 7), ""), (Span::new(9, 15), "\r\n\r\n")]);
        assert_eq!(changes.text(), "N1\r\nN2\r\n\r\nN3");
        assert_eq!(applied(&source, &changes), changes.text());
    }

    /// Changes of what changes gave are changes of the first text.
    #[test]
    fn changes_in_a_row() {
        let source = SourceText::from_text("a", "0123456789");
        let first = changes(&source, &[(1, 2, "abc"), (4, 4, "x"), (6, 8, "")]);
        let between = SourceText::from_text("a", first.text());
        assert_eq!(between.text(), "0abc23x4589");
        for edits in [vec![(0, 1, "")], vec![(2, 3, "B"), (7, 9, "-")], vec![(0, 11, "!")], vec![(11, 11, ".")], vec![]]
        {
            let first = changes(&source, &[(1, 2, "abc"), (4, 4, "x"), (6, 8, "")]);
            let both = first.then(changes(&between, &edits));
            assert_eq!(applied(&source, &both), both.text(), "{edits:?}");
        }
    }

    #[test]
    fn lines_below_one_another_are_one_edit() {
        let source = SourceText::from_text("a", "a b\nc d\ne f\ng h\ni j");
        let changes = changes(&source, &[(1, 2, ""), (5, 6, ""), (7, 7, "!"), (17, 18, "")]);
        assert_eq!(changes.joined(&source), [(Span::new(1, 7), "b\ncd!"), (Span::new(17, 18), "")]);
    }
}
