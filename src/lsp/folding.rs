//! What can be folded: units, their sections, loops, comments of several lines.

use gen_lsp_types::{FoldingRange, FoldingRangeKind, FoldingRangeParams};

use super::analysis::Analysis;
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::DOCUMENT;
use crate::query::extents::{adjoin, content_end, loops, stands_alone, words_span};
use crate::query::sections::{Section, SectionKind, sections, units_of};
use crate::resolve::{Unit, UnitKind};
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile};
use crate::text::Span;

/// Most ranges of a document, and of them most loops; editors take no more.
const MOST: usize = 5_000;

/// `textDocument/foldingRange`, by lines, the longer first where two begin in one line. Ranges that cross others, as
/// loops may, are left out: editors cannot fold them.
pub(super) fn folding_range(
    _: &Snapshot,
    analysis: &Analysis,
    _: FoldingRangeParams,
) -> Answer<Option<Vec<FoldingRange>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let lines = file.source.lines();
    let line = |offset: u32| small(lines.line_at(offset));
    let units = units_of(analysis).map(|unit| (unit_words(file, unit), FoldingRangeKind::Region));
    let of_loop = |(first, jump)| Span::new(words_span(file, first).start, words_span(file, jump).end);
    let loops = loops(analysis).map(|blocks| (of_loop(blocks), FoldingRangeKind::Region));
    let comments = comment_runs(file).map(|run| (run, FoldingRangeKind::Comment));
    let sections = sections(analysis).into_iter().flat_map(|unit| tool_spans(file, &unit.parts));
    let sections = sections.map(|span| (span, FoldingRangeKind::Region));
    let all = units.chain(loops).chain(sections).chain(comments);
    let folded = all.map(|(span, kind)| (line(span.start), line(span.end), kind));
    let mut folded: Vec<_> = folded.filter(|(start, end, _)| start < end).take(MOST).collect();
    folded.sort_by_key(|(start, end, _)| (*start, std::cmp::Reverse(*end)));
    Ok(Some(nested(folded)))
}

/// The sections of a unit by tool; without a tool change, those of its headings. The headings directly before a tool
/// change stay with it.
fn tool_spans(file: &ParsedFile, parts: &[Section]) -> Vec<Span> {
    let by_tool = parts.iter().any(|part| part.kind == SectionKind::Tool);
    let wanted = if by_tool { SectionKind::Tool } else { SectionKind::Heading };
    let blank = |from: u32, to: u32| from <= to && file.source.slice(Span::new(from, to)).trim().is_empty();
    let mut spans: Vec<Span> = Vec::new();
    let mut before: Option<&Section> = None;
    for part in parts {
        if part.kind == wanted {
            let led = before.filter(|before| by_tool && before.kind == SectionKind::Heading);
            let led = led.filter(|before| blank(before.head.end, part.head.start));
            let start = led.map_or(part.head.start, |before| before.head.start);
            if let Some(last) = spans.last_mut() {
                last.end = content_end(file, start).max(last.start);
            }
            spans.push(Span::new(part.head.start, part.span.end));
        } else if let Some(last) = spans.last_mut() {
            last.end = part.span.end;
        }
        before = Some(part);
    }
    spans
}

/// A unit from its beginning to its last word.
fn unit_words(file: &ParsedFile, unit: &Unit) -> Span {
    let start = match unit.kind {
        UnitKind::Main => file.start,
        UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => words_span(file, unit.first).start,
    };
    let last = unit.end.0.checked_sub(1).map(BlockId);
    Span::new(start, last.map_or(start, |last| words_span(file, last).end).max(start))
}

/// Comments in lines that follow each other, two at least.
fn comment_runs(file: &ParsedFile) -> impl Iterator<Item = Span> + '_ {
    let text = file.source.text();
    let mut lines = file.all_comments().iter().filter(|comment| stands_alone(text, **comment)).peekable();
    std::iter::from_fn(move || {
        let mut run = *lines.next()?;
        while let Some(next) = lines.next_if(|next| adjoin(text, run.end, next.start)) {
            run.end = next.end;
        }
        Some(run)
    })
}

/// Those of sorted ranges that lie within or beside all others.
fn nested(sorted: Vec<(u32, u32, FoldingRangeKind)>) -> Vec<FoldingRange> {
    let mut open: Vec<u32> = Vec::new();
    let mut result = Vec::new();
    for (start_line, end_line, kind) in sorted {
        while open.pop_if(|end| *end < start_line).is_some() {}
        if open.last().is_some_and(|end| *end < end_line) {
            continue;
        }
        open.push(end_line);
        result.push(FoldingRange { start_line, end_line, kind: Some(kind), ..FoldingRange::default() });
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossing_ranges_are_left_out() {
        let all = [(0, 9), (1, 5), (2, 3), (4, 7), (6, 8), (6, 7), (7, 8)];
        let all = all.map(|(start, end)| (start, end, FoldingRangeKind::Region)).to_vec();
        let lines: Vec<_> = nested(all).iter().map(|range| (range.start_line, range.end_line)).collect();
        assert_eq!(lines, [(0, 9), (1, 5), (2, 3), (6, 8), (6, 7)]);
    }
}
