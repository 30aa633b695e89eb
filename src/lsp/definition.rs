//! Where a number comes from: `N` of a jump, G79 of a call, the file of a macrocycle, the assignments of a parameter.

use gen_lsp_types::{
    DeclarationParams, DeclarationResponse, DefinitionParams, DefinitionResponse, Location, LocationLink, Range,
    TextDocumentPositionParams,
};

use super::analysis::Analysis;
use super::places::{Places, offset};
use super::references::everywhere;
use super::snapshot::{Answer, Snapshot};
use crate::query::cursor::DOCUMENT;
use crate::query::names::{Name, Usage};
use crate::query::reach::{Reach, block_span};
use crate::resolve::UnitId;
use crate::text::{FileId, Span};

/// A place to go to.
struct Place {
    file: FileId,
    all: Span,
    selection: Span,
}

/// `textDocument/definition`.
pub(super) fn definition(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DefinitionParams,
) -> Answer<Option<DefinitionResponse>> {
    let links = links(snapshot, analysis, &params.text_document_position_params);
    Ok(links.map(|links| {
        if snapshot.client.has("/textDocument/definition/linkSupport") {
            DefinitionResponse::DefinitionLinkList(links)
        } else {
            DefinitionResponse::Definition(links.into_iter().map(location).collect::<Vec<_>>().into())
        }
    }))
}

/// `textDocument/declaration`: the same.
pub(super) fn declaration(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DeclarationParams,
) -> Answer<Option<DeclarationResponse>> {
    let links = links(snapshot, analysis, &params.text_document_position_params);
    Ok(links.map(|links| {
        if snapshot.client.has("/textDocument/declaration/linkSupport") {
            DeclarationResponse::DeclarationLinkList(links)
        } else {
            DeclarationResponse::Declaration(links.into_iter().map(location).collect::<Vec<_>>().into())
        }
    }))
}

fn location(link: LocationLink) -> Location {
    Location { uri: link.target_uri, range: link.target_selection_range }
}

fn links(snapshot: &Snapshot, analysis: &Analysis, at: &TextDocumentPositionParams) -> Option<Vec<LocationLink>> {
    let unit = snapshot.client.unit;
    let mut reach = Reach::of(analysis);
    let source = &analysis.resolved.file(DOCUMENT)?.source;
    let naming = reach.naming_at(offset(source, at.position, unit))?;
    let origin = Places::new(source, unit).range(naming.around);
    if let Name::Parameter(_) = naming.name {
        let writes = everywhere(snapshot, analysis, naming.name, |usage| usage == Usage::Write);
        let links = writes.into_iter().map(|at| link(origin, at.uri, at.range, at.range));
        return Some(links.collect()).filter(|links: &Vec<_>| !links.is_empty());
    }
    let place = definition_of(&mut reach, naming.name)?;
    let source = &reach.resolved().file(place.file)?.source;
    let mut places = Places::new(source, unit);
    let all = places.range(place.all);
    Some(vec![link(
        origin,
        snapshot.files.uri_of(&reach.path(place.file)?)?,
        all,
        Places::new(source, unit).range(place.selection),
    )])
}

fn link(origin: Range, target_uri: gen_lsp_types::Uri, all: Range, selection: Range) -> LocationLink {
    LocationLink {
        origin_selection_range: Some(origin),
        target_uri,
        target_range: all,
        target_selection_range: selection,
    }
}

/// Where what the name names is; of two blocks or subprograms of one number the first.
fn definition_of(reach: &mut Reach<'_>, name: Name) -> Option<Place> {
    match name {
        Name::Block(number) => {
            let file = reach.resolved().file(DOCUMENT)?;
            let first = || file.block_ids().find(|block| file.number(*block) == Some(number));
            let block = reach.resolved().numbered(DOCUMENT, number).or_else(first)?;
            let selection = file.n_word(block)?.span(file.source.text());
            Some(Place { file: DOCUMENT, all: block_span(file, block), selection })
        }
        Name::Subprogram(l) => {
            let unit = reach.resolved().subprogram(l)?;
            unit_place(reach, unit)
        }
        Name::Macrocycle(l) => {
            let unit = reach.macrocycle(l)?;
            unit_place(reach, unit)
        }
        Name::Parameter(_) => None,
    }
}

fn unit_place(reach: &Reach<'_>, unit: UnitId) -> Option<Place> {
    let unit = reach.resolved().unit(unit)?;
    let (all, selection) = reach.unit_place(unit)?;
    Some(Place { file: unit.file, all, selection })
}
