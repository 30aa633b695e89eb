//! Selections that grow: value, word, block, loops, unit, file.

use gen_lsp_types::{SelectionRange, SelectionRangeParams};

use super::analysis::Analysis;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::{DOCUMENT, block_at, unit_of, word_at};
use crate::query::extents::{block_span, loops, unit_span, words_span};
use crate::sure::small;
use crate::text::{FileId, SourceText, Span};

/// `textDocument/selectionRange`: one for each position.
pub(super) fn selection_range(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: SelectionRangeParams,
) -> Answer<Option<Vec<SelectionRange>>> {
    let Some(source) = analysis.sources.get(FileId(0)) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let mut places = Places::new(source, unit);
    let mut around = |position| {
        let mut range = None;
        for span in spans(analysis, source, offset(source, position, unit)).into_iter().rev() {
            range = Some(SelectionRange { range: places.range(span), parent: range.map(Box::new) });
        }
        range
    };
    Ok(Some(params.positions.into_iter().filter_map(&mut around).collect()))
}

/// What lies around a place, each within the next; the last is the file.
fn spans(analysis: &Analysis, source: &SourceText, place: u32) -> Vec<Span> {
    let mut around: Vec<Span> = Vec::new();
    if let Some(file) = analysis.resolved.file(DOCUMENT) {
        if let Some(found) = word_at(file, place) {
            around.extend([file.value_place(found.word).span, found.span]);
        }
        if let Some(block) = block_at(file, place) {
            let comment = file.comments_behind(block).iter().copied().find(|comment| covers(*comment, place));
            around.extend(comment.into_iter().flat_map(|comment| [within_quotes(source, comment), comment]));
            around.extend([words_span(file, block), block_span(file, block)]);
            let mut outer: Vec<Span> = loops(analysis)
                .filter(|(first, jump)| (first..=jump).contains(&&block))
                .map(|(first, jump)| Span::new(words_span(file, first).start, block_span(file, jump).end))
                .collect();
            outer.sort_by_key(|span| span.len());
            around.extend(outer);
            around.extend(unit_of(analysis, block).map(|(_, unit)| unit_span(file, unit)));
        }
    }
    around.push(Span::new(0, source.len()));
    let mut growing: Vec<Span> = Vec::new();
    for span in around.into_iter().filter(|span| covers(*span, place)) {
        let grows = |inner: &Span| span.start <= inner.start && inner.end <= span.end && span != *inner;
        if growing.last().is_none_or(grows) {
            growing.push(span);
        }
    }
    growing
}

fn covers(span: Span, place: u32) -> bool {
    span.start <= place && place <= span.end
}

/// What stands between the quotes of a comment.
fn within_quotes(source: &SourceText, comment: Span) -> Span {
    let text = source.slice(comment);
    let quote = |c: char| matches!(c, '"' | '“' | '”' | '„');
    let length = |text: &str| small(text.len());
    let from = text.strip_prefix(quote).unwrap_or(text);
    let inner = from.strip_suffix(quote).unwrap_or(from);
    let start = comment.start + length(text) - length(from);
    Span::new(start, start + length(inner))
}
