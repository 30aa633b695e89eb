//! The meaning of a word, and the effect of its block in execution.

use gen_lsp_types::{Contents, Hover, HoverParams, MarkupContent, MarkupKind};

use super::analysis::Analysis;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::{DOCUMENT, block_at, word_at};
use crate::query::meaning::Subject;
use crate::query::observe::{executing, observe_motion};
use crate::query::page::Page;

/// `textDocument/hover`. At a comment or a blank: the execution of the block; before the first block: the program.
pub(super) fn hover(snapshot: &Snapshot, analysis: &Analysis, params: HoverParams) -> Answer<Option<Hover>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let client = &snapshot.client;
    let place = offset(&file.source, params.text_document_position_params.position, client.unit);
    if place < file.start || place > file.end {
        return Ok(None);
    }
    let found = word_at(file, place);
    let block = found.map_or_else(|| block_at(file, place), |found| found.block);
    let program = executing(snapshot.open(), analysis);
    let subject = Subject { analysis, file, lang: client.lang() };
    let inputs = block.map(|block| subject.inputs(block)).unwrap_or_default();
    let observation = match program {
        Some(program) => match observe_motion(&snapshot.cancel, program, analysis, block, &[], &inputs) {
            Some(observation) => Some((program, observation)),
            None => return Ok(None),
        },
        None => None,
    };
    // The form that the client names first.
    let markdown = client.first("/textDocument/hover/contentFormat") != Some("plaintext");
    let mut page = Page::new(markdown);
    match (block, file.program) {
        (Some(block), _) => {
            let observed = observation.as_ref().and_then(|(_, observation)| observation.of(block));
            if let Some(found) = found {
                subject.word(&mut page, block, found.word, observed);
                page.rule();
            }
            match &observation {
                Some((program, observation)) => {
                    subject.execution(&mut page, program, observation, block, found.map(|found| found.word));
                }
                None => subject.no_execution(&mut page),
            }
        }
        (None, Some(word)) => {
            subject.program(&mut page, word, observation.as_ref().map(|(_, observation)| observation));
        }
        (None, None) => return Ok(None),
    }
    let kind = if markdown { MarkupKind::Markdown } else { MarkupKind::PlainText };
    Ok(Some(Hover {
        contents: Contents::MarkupContent(MarkupContent { kind, value: page.finish() }),
        range: found.map(|found| Places::new(&file.source, client.unit).range(found.span)),
    }))
}
