//! Calls of macrocycles as links to their files.

use std::collections::BTreeMap;

use gen_lsp_types::{DocumentLink, DocumentLinkParams, Uri};

use super::analysis::Analysis;
use super::places::Places;
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::DOCUMENT;
use crate::query::names::{Name, Usage};
use crate::query::navigation_texts::NavigationText;
use crate::query::reach::Reach;

/// `textDocument/documentLink`.
pub(super) fn document_links(
    snapshot: &Snapshot,
    analysis: &Analysis,
    _: DocumentLinkParams,
) -> Answer<Option<Vec<DocumentLink>>> {
    let reach = Reach::of(analysis);
    let Some(names) = reach.names(DOCUMENT) else { return Ok(None) };
    let session = analysis.session();
    let mut library = session.library(&analysis.path);
    let mut files: BTreeMap<u32, Option<Uri>> = BTreeMap::new();
    let mut places = Places::new(&names.file.source, snapshot.client.unit);
    let mut links = Vec::new();
    for block in names.file.block_ids() {
        if snapshot.cancel.is_cancelled() {
            break;
        }
        let calls = names.of_block(block, |name| matches!(name, Name::Macrocycle(_)));
        for call in calls.into_iter().filter(|naming| naming.usage == Usage::Call) {
            let Name::Macrocycle(l) = call.name else { continue };
            let file = files.entry(l).or_insert_with(|| {
                let path = library.find(l).ok()?;
                snapshot.files.uri_of(&path)
            });
            if let Some(target) = file.clone() {
                links.push(DocumentLink {
                    range: places.range(call.number),
                    target: Some(target),
                    tooltip: Some(NavigationText::OpenMacrocycle { l }.text(snapshot.client.lang())),
                    data: None,
                });
            }
        }
    }
    Ok(Some(links))
}
