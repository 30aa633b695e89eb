//! Enter: the line that was left is formatted, and the next block gets its number.

use gen_lsp_types::{DocumentOnTypeFormattingParams, TextEdit};

use super::analysis::Analysis;
use super::completion::{next_numbers, written};
use super::formatting::edits_of;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::dict::Address;
use crate::edit::format::Part;
use crate::query::cursor::{DOCUMENT, block_at, unit_of};
use crate::resolve::UnitKind;
use crate::syntax::{BlockFlags, Kind, ParsedFile, Shape, tokens};
use crate::text::Span;

/// `textDocument/onTypeFormatting`, after a line end: the line before it in its layout, and `N40 ` on the new line,
/// when a block may begin there.
pub(super) fn on_type_formatting(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DocumentOnTypeFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let (source, unit) = (&file.source, snapshot.client.unit);
    let at = offset(source, params.position, unit);
    if params.ch != "\n" {
        return Ok(None);
    }
    let line = source.lines().line_at(at);
    let left = line.checked_sub(1).and_then(|left| edits_of(snapshot, analysis, Part::Line(left)));
    let mut edits = left.unwrap_or_default();
    let begins = begins_block(analysis, file, at);
    if let Some(&number) = begins.then(|| next_numbers(analysis, file, at, 1)).flatten().iter().flatten().next() {
        // The editor may have indented the new line as the one before; blocks are not indented.
        let indentation = Span::new(source.line_span(line).start, at);
        let range = Places::new(source, unit).range(indentation);
        edits.push(TextEdit { range, new_text: format!("{} ", written(file, at, number)) });
    }
    Ok((!edits.is_empty()).then_some(edits))
}

/// Whether the line of `at` is empty, the one before is one of a block that is not the last of its unit, or that of
/// `%`, and the one behind is empty too, or begins with `N`.
fn begins_block(analysis: &Analysis, file: &ParsedFile, at: u32) -> bool {
    let source = &file.source;
    let line = source.lines().line_at(at);
    let span_of = |line: usize| (line < source.lines().count()).then(|| source.line_span(line));
    let is_empty = |span: Span| source.slice(span).trim().is_empty();
    let (Some(here), Some(before)) = (span_of(line), line.checked_sub(1).and_then(span_of)) else { return false };
    let next_is_free = span_of(line + 1).is_none_or(|next| is_empty(next) || begins_with_n(file, next));
    if !is_empty(here) || at < here.start || at > here.end || !next_is_free {
        return false;
    }
    let inside = file.start < before.end;
    let ended = at >= file.end && source.text().get(..file.end as usize).is_some_and(|read| read.ends_with('*'));
    let has_words = tokens(source.text(), before.start, before.end)
        .any(|token| matches!(token.kind, Kind::Word | Kind::Parameter | Kind::Skip | Kind::Junk(Shape::LooseWord)));
    if !inside || ended || !has_words {
        return false;
    }
    let Some(block) = block_at(file, before.end) else { return file.program.is_some() };
    let goes_on = file.words(block).last().is_some_and(|word| word.start() >= here.start);
    let closes = unit_of(analysis, block).is_none_or(|(_, unit)| {
        let end = match unit.kind {
            UnitKind::Main => BlockFlags::END,
            UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => BlockFlags::RETURN,
        };
        file.flags(block).has(end)
    });
    !goes_on && !closes
}

fn begins_with_n(file: &ParsedFile, line: Span) -> bool {
    let text = file.source.slice(line).trim_start_matches([' ', '\t']);
    text.bytes().next().and_then(Address::from_byte) == Some(Address::N)
}
