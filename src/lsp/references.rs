//! Every place that names the same block, subprogram, macrocycle or parameter.

use std::path::Path;

use gen_lsp_types::{DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams};

use super::analysis::Analysis;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use super::workspace;
use crate::dict::Address;
use crate::query::cursor::{DOCUMENT, block_at};
use crate::query::names::{Name, Usage};
use crate::query::reach::Reach;
use crate::syntax::{ParsedFile, Word};
use crate::text::{FileId, Span};

/// `textDocument/references`.
pub(super) fn references(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: ReferenceParams,
) -> Answer<Option<Vec<Location>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let place = offset(&file.source, params.text_document_position_params.position, snapshot.client.unit);
    let Some(naming) = Reach::of(analysis).naming_at(place) else { return Ok(None) };
    let definitions = params.context.include_declaration;
    let wanted = |usage| definitions || usage != Usage::Definition;
    Ok(Some(everywhere(snapshot, analysis, naming.name, wanted)))
}

/// `textDocument/documentHighlight`.
pub(super) fn highlight(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: DocumentHighlightParams,
) -> Answer<Option<Vec<DocumentHighlight>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let place = offset(&file.source, params.text_document_position_params.position, unit);
    let reach = Reach::of(analysis);
    let mut places = Places::new(&file.source, unit);
    let Some(naming) = reach.naming_at(place) else {
        let kind = Some(DocumentHighlightKind::Text);
        let highlight = |word: Span| DocumentHighlight { range: places.range(word), kind };
        return Ok(same_function(file, place).map(|words| words.into_iter().map(highlight).collect()));
    };
    let found = reach.occurrences(DOCUMENT, naming.name, &snapshot.cancel).into_iter();
    let highlights = found.map(|naming| DocumentHighlight {
        range: places.range(naming.number),
        kind: Some(match naming.usage {
            Usage::Definition | Usage::Write => DocumentHighlightKind::Write,
            Usage::Call | Usage::Read => DocumentHighlightKind::Read,
        }),
    });
    Ok(Some(highlights.collect()))
}

/// The words with the G or M function of the word at a place.
fn same_function(file: &ParsedFile, place: u32) -> Option<Vec<Span>> {
    let text = file.source.text();
    let is_there = |word: &&Word| word.start() <= place && place <= word.span(text).end;
    let is_function = |word: &Word| matches!(word.address, Address::G | Address::M) && word.is_plain();
    let word = file.words(block_at(file, place)?).iter().find(|word| is_function(word) && is_there(word))?;
    let same = |other: &Word| is_function(other) && (other.address, other.whole()) == (word.address, word.whole());
    Some(file.all_words().filter(same).map(|word| word.span(text)).collect())
}

/// The places, in all that is open and what it leads to, that name what `name` names in the document of `analysis`.
pub(super) fn everywhere(
    snapshot: &Snapshot,
    analysis: &Analysis,
    name: Name,
    wanted: impl Fn(Usage) -> bool,
) -> Vec<Location> {
    let mut own = Reach::of(analysis);
    let macrocycle = match name {
        Name::Block(_) | Name::Subprogram(_) => {
            return in_files(snapshot, &own, name, &wanted, &mut [DOCUMENT].into_iter());
        }
        Name::Macrocycle(l) => {
            let unit = own.macrocycle(l).and_then(|id| own.resolved().unit(id));
            unit.map(|unit| unit.file).and_then(|file| own.path(file)).map(|path| (l, path))
        }
        Name::Parameter(_) => None,
    };
    let mut found = in_files(snapshot, &own, name, &wanted, &mut own.files());
    for other in snapshot.analyses.iter().filter(|other| other.path != analysis.path) {
        let mut reach = Reach::of(other);
        let shares = match (name, &macrocycle) {
            // Of two machines each has its own L9001.
            (Name::Macrocycle(_), Some((l, path))) => calls_file(&mut reach, *l, path),
            (Name::Macrocycle(_), None) => false,
            (Name::Parameter(_) | Name::Block(_) | Name::Subprogram(_), _) => reach.file_at(&analysis.path).is_some(),
        };
        if shares {
            let files: Vec<FileId> = reach.files().collect();
            found.extend(in_files(snapshot, &reach, name, &wanted, &mut files.into_iter()));
        }
    }
    if let (Name::Macrocycle(_), Some((l, path))) = (name, &macrocycle) {
        for named in workspace::naming(snapshot, *l, path) {
            let mut places = Places::new(&named.file.source, snapshot.client.unit);
            for naming in named.namings.iter().filter(|naming| wanted(naming.usage)) {
                found.push(Location { uri: named.uri.clone(), range: places.range(naming.number) });
            }
        }
    }
    // Documents that lead to the same file both have what is in it.
    let mut seen = std::collections::BTreeSet::new();
    found.retain(|at| seen.insert((at.uri.to_string(), at.range)));
    found
}

/// Whether macrocycle `l` is the file at `path` for a program that leads to it.
fn calls_file(reach: &mut Reach<'_>, l: u32, path: &Path) -> bool {
    let known = reach.file_at(path);
    known.is_some() && reach.macrocycle(l).and_then(|id| reach.resolved().unit(id)).map(|unit| unit.file) == known
}

fn in_files(
    snapshot: &Snapshot,
    reach: &Reach<'_>,
    name: Name,
    wanted: &impl Fn(Usage) -> bool,
    files: &mut dyn Iterator<Item = FileId>,
) -> Vec<Location> {
    let mut found = Vec::new();
    for file in files {
        let uri = reach.path(file).and_then(|path| snapshot.files.uri_of(&path));
        let (Some(parsed), Some(uri)) = (reach.resolved().file(file), uri) else { continue };
        let mut places = Places::new(&parsed.source, snapshot.client.unit);
        for naming in reach.occurrences(file, name, &snapshot.cancel) {
            if wanted(naming.usage) {
                found.push(Location { uri: uri.clone(), range: places.range(naming.number) });
            }
        }
    }
    found
}
