//! One layout for a document or a part of it; `edit::format` decides what that is.

use gen_lsp_types::{DocumentFormattingParams, DocumentRangeFormattingParams, TextEdit};

use super::analysis::Analysis;
use super::edits::MANY;
use super::places::{Places, span};
use super::snapshot::{Answer, Snapshot};
use crate::edit::format::{Part, changes};
use crate::query::cursor::DOCUMENT;
use crate::text::{FileId, Span};

/// `textDocument/formatting`.
pub(super) fn formatting(
    snapshot: &Snapshot,
    analysis: &Analysis,
    _: DocumentFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    Ok(edits_of(snapshot, analysis, Part::Whole))
}

/// `textDocument/rangeFormatting`: whole blocks.
pub(super) fn range_formatting(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DocumentRangeFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    let Some(source) = analysis.sources.get(FileId(0)) else { return Ok(None) };
    let part = Part::Blocks(span(source, params.range, snapshot.client.unit));
    Ok(edits_of(snapshot, analysis, part))
}

/// The edits that give a part of the document its layout. Words and blanks change by themselves, so that the cursor
/// stays where it is; editors are slow with very many edits, so these become one for each run of changed lines. `None`
/// for a text that is not formatted (FMT-6), or whose project file cannot be read: its finding says why.
pub(super) fn edits_of(snapshot: &Snapshot, analysis: &Analysis, part: Part) -> Option<Vec<TextEdit>> {
    let source = analysis.resolved.file(DOCUMENT).filter(|_| !analysis.misconfigured).map(|file| &file.source)?;
    let changes = changes(&analysis.path, source, &analysis.settings, part).ok()?;
    let mut places = Places::new(source, snapshot.client.unit);
    let edit = |(span, text): (Span, &str)| TextEdit { range: places.range(span), new_text: text.to_owned() };
    Some(if changes.edits().len() < MANY {
        changes.edits().map(edit).collect()
    } else {
        changes.joined(source).into_iter().map(edit).collect()
    })
}
