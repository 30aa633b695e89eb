//! Programs and macrocycles of the workspace by name, and the units of open documents.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gen_lsp_types::{BaseSymbolInformation, Location, WorkspaceSymbol, WorkspaceSymbolParams, WorkspaceSymbolResponse};

use super::analysis::configuration;
use super::outline::symbol_kind;
use super::places::Places;
use super::snapshot::{Answer, Snapshot};
use crate::diag::Findings;
use crate::query::cursor::DOCUMENT;
use crate::query::sections::{Section, head, units};
use crate::resolve::{Library, Unit, UnitKind};
use crate::syntax::{BlockId, Form, parse};
use crate::text::{Encoding, FileId, Loader, SourceText};

/// Most symbols of an answer.
const MOST: usize = 1_000;
/// Folders within folders of the workspace.
const DEEPEST: usize = 12;
/// Most folders that are listed, and files that are looked into.
const FOLDERS: usize = 2_000;
const FILES: usize = 5_000;
/// The first bytes of a program hold its number and title.
const HEAD: usize = 1 << 13;
/// Extensions of programs.
const EXTENSIONS: [&str; 4] = ["nc", "ncp", "mpf", "txt"];
/// Folders that hold no programs.
const SKIPPED: [&str; 2] = ["target", "node_modules"];

/// `workspace/symbol`: what has the letters of the query in that order, in either case; first what has the query whole.
pub(super) fn workspace_symbol(
    snapshot: &Snapshot,
    params: WorkspaceSymbolParams,
) -> Answer<Option<WorkspaceSymbolResponse>> {
    let mut search = Search { snapshot, query: params.query.to_lowercase(), found: Vec::new() };
    for analysis in &snapshot.analyses {
        if let Some(source) = analysis.sources.get(FileId(0)) {
            for unit in units(analysis) {
                search.add(&analysis.path, source, unit);
            }
        }
    }
    let open: BTreeSet<&Path> = snapshot.analyses.iter().map(|analysis| analysis.path.as_path()).collect();
    for path in files(snapshot) {
        if snapshot.cancel.is_cancelled() || search.found.len() >= MOST {
            break;
        }
        if !open.contains(snapshot.files.canonical(&path).as_path()) {
            search.look_into(&path);
        }
    }
    let mut found = search.found;
    found.sort_by_key(|(within, _)| !within);
    let symbols: Vec<WorkspaceSymbol> = found.into_iter().take(MOST).map(|(_, symbol)| symbol).collect();
    Ok(Some(symbols.into()))
}

struct Search<'a> {
    snapshot: &'a Snapshot,
    query: String,
    /// Whether the name has the query whole, and the symbol.
    found: Vec<(bool, WorkspaceSymbol)>,
}

impl Search<'_> {
    fn add(&mut self, path: &Path, source: &SourceText, section: Section) {
        let name = section.name.to_lowercase();
        let whole = name.contains(&self.query);
        let mut rest = name.chars();
        if !whole && !self.query.chars().filter(|c| *c != ' ').all(|wanted| rest.any(|c| c == wanted)) {
            return;
        }
        let Some(uri) = self.snapshot.files.uri_of(path) else { return };
        let range = Places::new(source, self.snapshot.client.unit).range(section.head);
        let base = BaseSymbolInformation {
            name: section.name,
            kind: symbol_kind(section.kind),
            tags: None,
            container_name: path.file_name().map(|name| name.to_string_lossy().into_owned()),
        };
        let symbol =
            WorkspaceSymbol { location: Location { uri, range }.into(), data: None, base_symbol_information: base };
        self.found.push((whole, symbol));
    }

    /// Adds the program or macrocycle at `path`.
    fn look_into(&mut self, path: &Path) {
        let Ok(mut bytes) = self.snapshot.files.head(path, HEAD) else { return };
        if bytes.len() == HEAD {
            // The last line may have been cut in a character.
            let end = memchr::memrchr2(b'\n', b'\r', &bytes);
            bytes.truncate(end.unwrap_or(HEAD));
        }
        let encoding = if std::str::from_utf8(&bytes).is_ok() { Encoding::Utf8 } else { self.encoding(path) };
        let Ok(source) = SourceText::decode(path.to_string_lossy(), bytes, encoding) else { return };
        let source = Arc::new(source);
        let (kind, form) = match Library::number(path) {
            Some(l) => (UnitKind::Macrocycle(l), Form::Macrocycle),
            None => (UnitKind::Main, Form::Program),
        };
        let file = parse(FileId(0), &source, form, &mut Findings::new());
        let is_program = file.program.is_some_and(|word| word.whole().is_some());
        if kind == UnitKind::Main && !is_program {
            return;
        }
        let end = BlockId(file.block_count().min(1));
        let unit = Unit { kind, file: DOCUMENT, first: BlockId(0), end, entry: file.n_place(BlockId(0)) };
        self.add(path, &source, head(&file, &unit).0);
    }

    /// What files in the folder of `path` are encoded in.
    fn encoding(&self, path: &Path) -> Encoding {
        configuration(path, &self.snapshot.files, &self.snapshot.client).0.encoding
    }
}

/// The files of the workspace that may be programs or macrocycles, by folders, those above first.
pub(super) fn files(snapshot: &Snapshot) -> Vec<PathBuf> {
    let mut level: Vec<PathBuf> = snapshot.client.folders.clone();
    let mut seen = BTreeSet::new();
    let mut found = Vec::new();
    for _ in 0..=DEEPEST {
        let mut below = Vec::new();
        for folder in level {
            if seen.len() >= FOLDERS || found.len() >= FILES || snapshot.cancel.is_cancelled() {
                return found;
            }
            if seen.insert(snapshot.files.canonical(&folder)) {
                found.extend(snapshot.files.list(&folder).into_iter().filter(|path| may_be_program(path)));
                below.extend(snapshot.files.folders(&folder).into_iter().filter(|path| may_hold_programs(path)));
            }
        }
        level = below;
    }
    found.truncate(FILES);
    found
}

/// Whether its name is one of a program or a macrocycle.
pub(super) fn may_be_program(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    Library::number(path).is_some() || EXTENSIONS.iter().any(|known| known.eq_ignore_ascii_case(extension))
}

fn may_hold_programs(folder: &Path) -> bool {
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    !name.starts_with('.') && !SKIPPED.contains(&name)
}
