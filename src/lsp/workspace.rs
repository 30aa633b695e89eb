//! What names a macrocycle in all programs and macrocycles of the workspace, open or not, and its renaming there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use gen_lsp_types::Uri;
use serde_json::{Value, json};

use super::analysis::configuration;
use super::places::Places;
use super::snapshot::{Answer, Snapshot};
use super::workspace_symbols::{files, may_be_program};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::GCode;
use crate::edit::line_length::first_long_line;
use crate::query::names::{Name, Names, Naming, Usage};
use crate::query::navigation_texts::NavigationText;
use crate::resolve::{Library, MacrocycleFault, Roles, Taker, l_number};
use crate::session::Session;
use crate::syntax::{BlockId, Form, ParsedFile, Value as WordValue, parse};
use crate::text::{FileId, Loader};

/// Longest file that is looked into, in bytes.
const LONGEST: u64 = 1 << 26;

/// A file with the places in it that name a macrocycle.
pub(super) struct Named {
    pub(super) uri: Uri,
    pub(super) file: ParsedFile,
    pub(super) namings: Vec<Naming>,
    /// Why it is not known which macrocycle it calls.
    doubt: Option<NavigationText>,
}

/// The files of the workspace, and the open ones, that name macrocycle `l`, where that is the file at `target`.
pub(super) fn naming(snapshot: &Snapshot, l: u32, target: &Path) -> Vec<Named> {
    naming_of(snapshot, l, l, target)
}

/// The same of the files for which macrocycle `l` is the file at `target`, with the places that name `wanted`.
fn naming_of(snapshot: &Snapshot, l: u32, wanted: u32, target: &Path) -> Vec<Named> {
    let mut settings: BTreeMap<PathBuf, Settings> = BTreeMap::new();
    let mut found = Vec::new();
    for path in candidates(snapshot, target) {
        if snapshot.cancel.is_cancelled() {
            break;
        }
        if snapshot.files.size(&path).is_none_or(|size| size > LONGEST) {
            continue;
        }
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let settings =
            settings.entry(folder).or_insert_with(|| configuration(&path, &snapshot.files, &snapshot.client).0);
        found.extend(named(snapshot, &path, settings, [l, wanted], target));
    }
    found
}

/// The files that may call the macrocycle at `target`, each once.
fn candidates(snapshot: &Snapshot, target: &Path) -> Vec<PathBuf> {
    // As they are typed: an analysis may still be under way. What lies beside them may call it in no workspace, too.
    let open = snapshot.files.open();
    let folders: BTreeSet<&Path> = open.keys().map(PathBuf::as_path).chain([target]).filter_map(Path::parent).collect();
    let beside = folders.into_iter().flat_map(|folder| snapshot.files.list(folder));
    let beside: Vec<PathBuf> = beside.filter(|path| may_be_program(path)).collect();
    let all = open.keys().cloned().chain(files(snapshot)).chain(beside).chain([target.to_path_buf()]);
    let mut seen: BTreeSet<PathBuf> = BTreeSet::new();
    let canonical = all.map(|path| snapshot.files.canonical(&path));
    canonical.filter(|path| seen.insert(path.clone())).collect()
}

/// Whether programs for which macrocycle `l` is the file at `target` find a file that is `new`, in whatever folder.
fn is_taken(snapshot: &Snapshot, [l, new]: [u32; 2], target: &Path) -> bool {
    let mut folders: BTreeSet<PathBuf> = BTreeSet::new();
    candidates(snapshot, target).into_iter().any(|path| {
        if snapshot.cancel.is_cancelled() || !folders.insert(path.parent().unwrap_or(Path::new("")).to_path_buf()) {
            return false;
        }
        let settings = configuration(&path, &snapshot.files, &snapshot.client).0;
        let session = Session { loader: &snapshot.files, settings: &settings, progress: None };
        let mut library = session.library(&path);
        leads_to(snapshot, &mut library, l, target)
            && !matches!(library.find(new), Err(MacrocycleFault::Missing { .. }))
    })
}

/// Whether macrocycle `l` is the file at `target` there.
fn leads_to(snapshot: &Snapshot, library: &mut Library<'_>, l: u32, target: &Path) -> bool {
    library.find(l).is_ok_and(|found| snapshot.files.canonical(&found) == target)
}

fn named(snapshot: &Snapshot, path: &Path, settings: &Settings, [l, number]: [u32; 2], target: &Path) -> Option<Named> {
    let own = Library::number(path);
    let source = snapshot.files.load(path, &path.to_string_lossy(), settings.encoding).ok()?;
    let digits = number.to_string();
    let mapped = settings.machine.cycles.values().any(|mapped| *mapped == number);
    let text = source.text();
    if !mapped && !text.contains(&digits) && !calls_by_parameter(text) {
        return None;
    }
    let session = Session { loader: &snapshot.files, settings, progress: None };
    if path != target && !leads_to(snapshot, &mut session.library(path), l, target) {
        return None;
    }
    let form = if own.is_some() { Form::Macrocycle } else { Form::Program };
    let file = parse(FileId(0), &source, form, &mut Findings::new());
    let names = Names { machine: &settings.machine, file: &file, macrocycle: own };
    let wanted = |name| name == Name::Macrocycle(number);
    // Another file of that number names itself in its first block.
    let is_meant = |naming: &Naming| path == target || naming.usage != Usage::Definition;
    let namings = file.block_ids().flat_map(|block| names.of_block(block, wanted)).filter(is_meant).collect();
    let doubt = file.block_ids().find_map(|block| doubt_of(&file, block, number));
    let uri = snapshot.files.uri_of(path)?;
    Some(Named { uri, file, namings, doubt })
}

/// Whether some L of a text takes its number from a parameter: `G72 LR10`.
fn calls_by_parameter(text: &str) -> bool {
    let mut behind = text.split(['L', 'l']).skip(1);
    behind.any(|rest| rest.trim_start_matches([' ', '\t', '+']).starts_with(['R', 'r']))
}

/// Why it is not known whether a block calls macrocycle `l`.
fn doubt_of(file: &ParsedFile, block: BlockId, l: u32) -> Option<NavigationText> {
    let roles = Roles::written(file.words(block));
    let word = roles.l.filter(|_| roles.taker.may_be(GCode::G72))?;
    let n = file.shown_number(block);
    match word.value() {
        WordValue::Parameter { index: r, .. } => Some(NavigationText::CallByParameter { n, r }),
        WordValue::Number(_) => {
            let is_it = matches!(roles.taker, Taker::Unclear) && l_number(word) == Some(l);
            is_it.then_some(NavigationText::Unclear { n, l })
        }
        WordValue::None => None,
    }
}

/// The edits that give macrocycle `l` another number wherever it is named, by document.
///
/// # Errors
/// Why it cannot have another one.
fn edits(snapshot: &Snapshot, l: u32, new: u32, target: &Path) -> Result<Vec<(Value, Vec<Value>)>, NavigationText> {
    let mut changes = Vec::new();
    for Named { uri, file, namings, doubt } in naming(snapshot, l, target) {
        if let Some(doubt) = doubt {
            return Err(doubt);
        }
        if namings.iter().any(|naming| !naming.written) {
            return Err(NavigationText::MacrocycleFile { l });
        }
        let digits = new.to_string();
        if let Some(line) = first_long_line(&file, namings.iter().map(|naming| (naming.number, digits.len()))) {
            return Err(NavigationText::LineTooLong { line });
        }
        if namings.is_empty() {
            continue;
        }
        let mut places = Places::new(&file.source, snapshot.client.unit);
        let edits: Vec<Value> =
            namings.iter().map(|naming| json!({ "range": places.range(naming.number), "newText": digits })).collect();
        let open = snapshot.files.open().values().find(|document| document.uri == uri);
        let version = open.map(|document| document.version);
        changes.push((json!({ "uri": uri, "version": version }), edits));
    }
    Ok(changes)
}

fn text_edit((document, edits): (Value, Vec<Value>)) -> Value {
    json!({ "textDocument": document, "edits": edits })
}

/// Whether the client can do what renaming a macrocycle takes.
pub(super) fn can_rename(snapshot: &Snapshot) -> bool {
    snapshot.client.has("/workspace/workspaceEdit/documentChanges")
        && snapshot.client.lists("/workspace/workspaceEdit/resourceOperations", "rename")
}

/// Another number for the macrocycle in the file at `target`: its calls, its own G79, and its file.
///
/// # Errors
/// Why it cannot have that.
pub(super) fn rename(snapshot: &Snapshot, l: u32, new: u32, target: &Path) -> Result<Value, NavigationText> {
    let renamed = renamed(target, l, new).ok_or(NavigationText::MacrocycleFile { l })?;
    against(snapshot, l, new, target, &[]).map_or(Ok(()), Err)?;
    let mut changes: Vec<Value> = edits(snapshot, l, new, target)?.into_iter().map(text_edit).collect();
    let uris = snapshot.files.uri_of(target).zip(Uri::from_file_path(renamed).ok());
    if let Some((old, new)) = uris {
        changes.push(json!({ "kind": "rename", "oldUri": old, "newUri": new }));
    }
    Ok(json!({ "documentChanges": changes }))
}

/// Why macrocycle `l` in the file at `target` cannot be number `new`: another one has it, or something means it
/// already. `renamed`: the numbers that get others at the same time.
fn against(snapshot: &Snapshot, l: u32, new: u32, target: &Path, renamed: &[u32]) -> Option<NavigationText> {
    if new == l {
        return None;
    }
    let machine = configuration(target, &snapshot.files, &snapshot.client).0.machine;
    if machine.cycles.values().any(|mapped| *mapped == l) {
        return Some(NavigationText::MacrocycleFile { l });
    }
    if renamed.contains(&new) {
        return None;
    }
    let folder = target.parent().unwrap_or(Path::new(""));
    let beside = snapshot.files.list(folder).iter().any(|path| Library::number(path) == Some(new));
    if beside || is_taken(snapshot, [l, new], target) || machine.macrocycles.contains_key(&new) {
        return Some(NavigationText::MacrocycleExists { l: new });
    }
    // The file itself may name that number too.
    let means = |named: &Named| !named.namings.is_empty() || named.doubt.is_some();
    let named = naming_of(snapshot, l, new, target).into_iter().find(means)?;
    if named.namings.is_empty() {
        return named.doubt;
    }
    let name = named.file.source.name();
    let file = Path::new(name).file_name().map_or(name.into(), |name| name.to_string_lossy());
    Some(NavigationText::WouldLeadHere { call: format!("L{new} ({file})") })
}

/// The file of a macrocycle with another number.
fn renamed(path: &Path, l: u32, new: u32) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let (letter, rest) = name.split_at_checked(1)?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = rest.split_at_checked(digits)?;
    (number.parse() == Ok(l)).then(|| path.with_file_name(format!("{letter}{new}{rest}")))
}

/// `workspace/willRenameFiles`: the calls of a macrocycle follow its file.
pub(super) fn will_rename_files(snapshot: &Snapshot, params: Value) -> Answer<Value> {
    let renamed = |file: &Value| {
        let path = |key: &str| Uri::parse(file.get(key)?.as_str()?).ok()?.to_file_path().ok();
        let (old, new) = (path("oldUri")?, path("newUri")?);
        let (l, number) = (Library::number(&old)?, Library::number(&new)?);
        // In another folder it may be another machine's.
        (l != number && old.parent() == new.parent()).then_some((old, l, number))
    };
    let files = params.get("files").and_then(Value::as_array);
    let files: Vec<(PathBuf, u32, u32)> = files.into_iter().flatten().filter_map(renamed).collect();
    let numbers: Vec<u32> = files.iter().map(|(_, l, _)| *l).collect();
    // One entry a document: the places of all its edits are those before any of them.
    let mut documents: Vec<(Value, Vec<Value>)> = Vec::new();
    for (old, l, number) in files {
        let target = snapshot.files.canonical(&old);
        // All or none: calls of two files that exchange their numbers would else meet. The files get their names all
        // the same.
        let edits = match against(snapshot, l, number, &target, &numbers) {
            None => edits(snapshot, l, number, &target),
            Some(why) => Err(why),
        };
        let Ok(edits) = edits else { return Ok(Value::Null) };
        for (document, edits) in edits {
            match documents.iter_mut().find(|(known, _)| *known == document) {
                Some((_, known)) => known.extend(edits),
                None => documents.push((document, edits)),
            }
        }
    }
    let changes: Vec<Value> = documents.into_iter().map(text_edit).collect();
    if changes.is_empty() || !snapshot.client.has("/workspace/workspaceEdit/documentChanges") {
        return Ok(Value::Null);
    }
    Ok(json!({ "documentChanges": changes }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files() {
        let new = |path: &str| renamed(Path::new(path), 9001, 9100).map(|path| path.to_string_lossy().into_owned());
        assert_eq!(new("/m/L9001").as_deref(), Some("/m/L9100"));
        assert_eq!(new("/m/l9001.txt").as_deref(), Some("/m/l9100.txt"));
        assert_eq!(new("/m/L9002"), None);
    }
}
