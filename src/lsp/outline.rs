//! The outline of a document.

use gen_lsp_types::{
    BaseSymbolInformation, DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation,
    SymbolKind,
};

use super::analysis::Analysis;
use super::places::Places;
use super::snapshot::{Answer, Snapshot};
use crate::query::sections::{Section, SectionKind, UnitSections, sections};

/// `textDocument/documentSymbol`: the units, and within them the sections.
pub(super) fn document_symbol(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DocumentSymbolParams,
) -> Answer<Option<DocumentSymbolResponse>> {
    let Some(source) = analysis.sources.get(crate::text::FileId(0)) else { return Ok(None) };
    let mut places = Places::new(source, snapshot.client.unit);
    let units = sections(analysis);
    if snapshot.client.has("/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport") {
        let symbols: Vec<DocumentSymbol> = units
            .iter()
            .map(|UnitSections { unit, parts }| {
                let children = parts.iter().map(|part| symbol(part, None, &mut places)).collect();
                symbol(unit, Some(children), &mut places)
            })
            .collect();
        return Ok(Some(symbols.into()));
    }
    let uri = params.text_document.uri;
    let mut flat: Vec<SymbolInformation> = Vec::new();
    for UnitSections { unit, parts } in &units {
        let with_container = std::iter::once((unit, None)).chain(parts.iter().map(|part| (part, Some(&unit.name))));
        for (section, container) in with_container {
            let location = Location { uri: uri.clone(), range: places.range(section.span) };
            let (name, container_name) = (section.name.clone(), container.cloned());
            let base = BaseSymbolInformation { name, kind: symbol_kind(section.kind), tags: None, container_name };
            flat.push(SymbolInformation::new(None, location, base));
        }
    }
    Ok(Some(flat.into()))
}

/// The kind of symbol that a section is.
pub(super) const fn symbol_kind(kind: SectionKind) -> SymbolKind {
    match kind {
        SectionKind::Program => SymbolKind::Module,
        SectionKind::Subprogram => SymbolKind::Function,
        SectionKind::Tool => SymbolKind::Event,
        SectionKind::Heading => SymbolKind::String,
    }
}

fn symbol(section: &Section, children: Option<Vec<DocumentSymbol>>, places: &mut Places<'_>) -> DocumentSymbol {
    let (range, selection) = (places.range(section.span), places.range(section.head));
    DocumentSymbol::new(section.name.clone(), None, symbol_kind(section.kind), None, None, range, selection, children)
}
