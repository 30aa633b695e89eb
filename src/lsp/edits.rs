//! Changes of documents, as the client takes them.

use gen_lsp_types::{
    CreateFile, DocumentChange, OptionalVersionedTextDocumentIdentifier, TextDocumentEdit, TextDocumentIdentifier,
    TextEdit, Uri, WorkspaceEdit,
};

use super::analysis::Analysis;
use super::places::Places;
use super::snapshot::Snapshot;
use crate::text::{SourceText, Span};

/// From this many changes on one takes their place: editors are slow with more.
pub(super) const MANY: usize = 10_000;

/// A change of the request's document: spans with their new texts, in the order of the text.
pub(super) fn document_edit<'t>(
    snapshot: &Snapshot,
    analysis: &Analysis,
    source: &SourceText,
    edits: impl ExactSizeIterator<Item = (Span, &'t str)>,
) -> Option<WorkspaceEdit> {
    let document = snapshot.files.buffer(&analysis.path)?;
    let mut places = Places::new(source, snapshot.client.unit);
    let mut edit = |(span, text): (Span, &str)| TextEdit { range: places.range(span), new_text: text.to_owned() };
    let edits: Vec<TextEdit> = if edits.len() < MANY {
        edits.map(edit).collect()
    } else {
        let (span, text) = as_one(source, edits);
        vec![edit((span, &text))]
    };
    workspace_edit(snapshot, &document.uri, None, edits)
}

/// Changes of the document `uri`, `first` a change of its file; none where the client cannot make that.
pub(super) fn workspace_edit(
    snapshot: &Snapshot,
    uri: &Uri,
    first: Option<CreateFile>,
    edits: Vec<TextEdit>,
) -> Option<WorkspaceEdit> {
    if !snapshot.client.has("/workspace/workspaceEdit/documentChanges") {
        let changes = first.is_none().then(|| [(uri.clone(), edits)].into())?;
        return Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() });
    }
    let version = snapshot.files.open().values().find(|document| document.uri == *uri).map(|document| document.version);
    let text_document = OptionalVersionedTextDocumentIdentifier {
        version,
        text_document_identifier: TextDocumentIdentifier { uri: uri.clone() },
    };
    let change = TextDocumentEdit { text_document, edits: edits.into_iter().map(Into::into).collect() };
    let first = first.map(DocumentChange::CreateFile);
    let document_changes = Some(first.into_iter().chain([DocumentChange::TextDocumentEdit(change)]).collect());
    Some(WorkspaceEdit { document_changes, ..WorkspaceEdit::default() })
}

/// All edits as one, with what stands between them.
fn as_one<'t>(source: &SourceText, edits: impl Iterator<Item = (Span, &'t str)>) -> (Span, String) {
    let mut all: Option<Span> = None;
    let mut result = String::new();
    for (span, text) in edits {
        let end = all.map_or(span.start, |all| all.end);
        result.push_str(source.slice(Span::new(end, span.start)));
        result.push_str(text);
        all = Some(all.unwrap_or(span).to(span));
    }
    (all.unwrap_or_default(), result)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_edits_as_one() {
        let source = SourceText::from_text("a", "0123456789");
        let edits = [(Span::new(2, 3), "A"), (Span::new(5, 5), "B"), (Span::new(6, 9), "")];
        assert_eq!(as_one(&source, edits.into_iter()), (Span::new(2, 9), "A34B5".to_owned()));
    }
}
