//! What a word means, and what execution makes of its block.

use gen_lsp_types::{Contents, Hover, HoverParams, MarkupContent, MarkupKind};

use super::analysis::Analysis;
use super::cursor::{DOCUMENT, word_at};
use super::places::{Places, offset};
use super::requests::{Answer, Snapshot};

/// `textDocument/hover`.
pub(super) fn hover(snapshot: &Snapshot, analysis: &Analysis, params: HoverParams) -> Answer<Option<Hover>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let place = offset(&file.source, params.text_document_position_params.position, unit);
    let Some(found) = word_at(file, place) else { return Ok(None) };
    let meaning = found.word.address.row().meaning.get(snapshot.client.lang());
    Ok(Some(Hover {
        contents: Contents::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value: meaning.to_owned() }),
        range: Some(Places::new(&file.source, unit).range(found.span)),
    }))
}
