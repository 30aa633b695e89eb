//! `workspace/diagnostic`: findings in the programs of the workspace that are not open. A program is checked again when
//! its text changes, or what programs depend on: configuration and macrocycles.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::PoisonError;

use gen_lsp_types::{Diagnostic, Uri};
use serde_json::{Value, json};

use super::analysis::configuration;
use super::checked::{Known, Program};
use super::findings::by_file;
use super::snapshot::{Answer, Snapshot};
use super::workspace_symbols::files;
use crate::config::Settings;
use crate::diag::Report;
use crate::query::reach::Reach;
use crate::session::Session;
use crate::text::{Loader, begins_program};

/// Most programs that are checked, and the longest of them, in bytes.
const PROGRAMS: usize = 2_000;
const LONGEST: u64 = 1 << 24;
/// Most blocks of a program that are executed.
const BLOCKS: u64 = 200_000;

fn hash(value: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

/// Answers the request with what the client does not have yet.
pub(super) fn workspace_diagnostic(snapshot: &Snapshot, params: Value) -> Answer<Value> {
    let mut known = snapshot.checked.known.lock().unwrap_or_else(PoisonError::into_inner);
    if known.seen != Some(snapshot.checked.files) && look(snapshot, &mut known) {
        known.seen = Some(snapshot.checked.files);
    }
    let previous = params.get("previousResultIds").and_then(Value::as_array).into_iter().flatten();
    let previous: BTreeMap<&str, &str> =
        previous.filter_map(|one| Some((one.get("uri")?.as_str()?, one.get("value")?.as_str()?))).collect();
    let mut items = Vec::new();
    let mut there = BTreeSet::new();
    for program in known.programs.values() {
        there.insert(program.uri.as_str());
        let before = previous.get(program.uri.as_str());
        let nothing = before.is_none() && program.items.as_array().is_none_or(Vec::is_empty);
        if !nothing && before != Some(&program.id.as_str()) {
            items.push(report(program.uri.as_str(), Some(&program.id), &program.items));
        }
    }
    for (uri, found) in in_macrocycles(snapshot, &known) {
        let found = serde_json::to_value(found).unwrap_or_default();
        let id = format!("{:x}", hash(found.to_string()));
        if previous.get(uri.as_str()) != Some(&id.as_str()) {
            items.push(report(uri.as_str(), Some(&id), &found));
        }
        there.insert(uri.as_str());
    }
    for uri in previous.keys().filter(|uri| !there.contains(*uri)) {
        items.push(report(uri, None, &json!([])));
    }
    Ok(json!({ "items": items }))
}

/// The findings in macrocycles that only programs call that are not open: those of others the client has already.
fn in_macrocycles<'k>(snapshot: &Snapshot, known: &'k Known) -> BTreeMap<&'k Uri, Vec<&'k Diagnostic>> {
    let mut all: BTreeMap<&Uri, Vec<&Diagnostic>> = BTreeMap::new();
    for (uri, found) in known.programs.values().flat_map(|program| &program.called) {
        let leads_there = |path: &PathBuf| snapshot.open().any(|open| Reach::of(open).file_at(path).is_some());
        if uri.to_file_path().is_ok_and(|path| leads_there(&snapshot.files.canonical(&path))) {
            continue;
        }
        let all = all.entry(uri).or_default();
        for diagnostic in found {
            if !all.iter().any(|other| other.range == diagnostic.range && other.code == diagnostic.code) {
                all.push(diagnostic);
            }
        }
    }
    all
}

fn report(uri: &str, id: Option<&str>, items: &Value) -> Value {
    let mut report = json!({ "kind": "full", "uri": uri, "version": null, "items": items });
    if let (Some(id), Some(report)) = (id, report.as_object_mut()) {
        report.insert("resultId".to_owned(), id.into());
    }
    report
}

/// Checks the programs that changed. Whether all were looked at.
fn look(snapshot: &Snapshot, known: &mut Known) -> bool {
    let Known { revision, programs, .. } = known;
    let mut settings: BTreeMap<PathBuf, Settings> = BTreeMap::new();
    let mut there = BTreeSet::new();
    for path in files(snapshot) {
        if snapshot.cancel.is_cancelled() {
            return false;
        }
        let path = snapshot.files.canonical(&path);
        let open = snapshot.files.open().contains_key(&path);
        if open || there.len() >= PROGRAMS || there.contains(&path) {
            continue;
        }
        if snapshot.files.size(&path).is_none_or(|size| size > LONGEST) {
            continue;
        }
        let Ok(bytes) = snapshot.files.read(&path) else { continue };
        let text = hash(&bytes);
        let environment = snapshot.checked.environment;
        let same = |program: &Program| program.text == text && program.environment == environment;
        if programs.get(&path).is_some_and(same) {
            there.insert(path);
            continue;
        }
        if !begins_program(bytes.as_slice()).unwrap_or(false) || Session::is_macrocycle(&path, &snapshot.files) {
            continue;
        }
        let Some(uri) = snapshot.files.uri_of(&path) else { continue };
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let settings =
            settings.entry(folder).or_insert_with(|| configuration(&path, &snapshot.files, &snapshot.client).0);
        let (items, called) = check(snapshot, &path, settings, &uri);
        // The same findings as before need not be sent again.
        let before = programs.get(&path).filter(|before| before.items == items).map(|before| before.id.clone());
        *revision += 1;
        let id = before.unwrap_or_else(|| revision.to_string());
        programs.insert(path.clone(), Program { environment, text, uri, id, items, called });
        there.insert(path);
    }
    programs.retain(|path, _| there.contains(path));
    true
}

/// The findings in one program, and those in macrocycles that it calls.
fn check(snapshot: &Snapshot, path: &Path, settings: &Settings, uri: &Uri) -> (Value, BTreeMap<Uri, Vec<Diagnostic>>) {
    let goes_on = |executed| executed <= BLOCKS && !snapshot.cancel.is_cancelled();
    let session = Session { loader: &snapshot.files, settings, progress: Some(&goes_on) };
    let outcome = session.check(path, &path.to_string_lossy());
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    let client = &snapshot.client;
    let mut found = by_file(&report, &snapshot.files, client.unit, client.lang());
    let own = found.remove(uri).unwrap_or_default();
    (serde_json::to_value(own).unwrap_or_default(), found)
}
