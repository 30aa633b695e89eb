//! Changes of other files that findings suggest: a level in the project file, a macrocycle that is not there yet.

use std::collections::BTreeSet;
use std::path::Path;

use gen_lsp_types::{CodeAction, CodeActionKind, Uri, WorkspaceEdit};
use serde_json::{Value, json};

use super::analysis::{Analysis, Found};
use super::findings::Converter;
use super::places::Places;
use super::snapshot::Snapshot;
use crate::config::{PROJECT_FILE, find_project};
use crate::diag::{Code, Finding, Reported};
use crate::edit::edit_texts::EditText;
use crate::sure::Sure;
use crate::text::{Encoding, FileId, Loader, SourceText, Span};

/// The offers for findings of the document that touch a range.
pub(super) fn actions(
    snapshot: &Snapshot,
    analysis: &Analysis,
    source: &SourceText,
    found: &Found,
    range: Span,
) -> Vec<CodeAction> {
    let client = &snapshot.client;
    let document = found.report.sources().find(source.name());
    let mut codes = BTreeSet::new();
    let mut actions = Vec::new();
    let mut places = Places::new(source, client.unit);
    let converter = Converter { report: &found.report, files: &snapshot.files, unit: client.unit, lang: client.lang() };
    for item in found.report.items() {
        let at = item.diagnostic.at;
        if Some(at.file) != document || at.span.end < range.start || range.end < at.span.start {
            continue;
        }
        let code = item.diagnostic.code();
        let mut add = |text: EditText, edit: Option<WorkspaceEdit>, item: &Reported| {
            actions.extend(edit.map(|edit| CodeAction {
                title: text.text(client.lang()),
                kind: Some(CodeActionKind::QuickFix),
                diagnostics: Some(vec![converter.diagnostic(item, &mut places)]),
                edit: Some(edit),
                ..CodeAction::default()
            }));
        };
        if let Finding::UnknownMacrocycle { l, subprogram: false, .. } = item.diagnostic.finding {
            let text = EditText::CreateMacrocycle { l };
            add(text, create_macrocycle(snapshot, analysis, l), item);
        }
        if code.is_configurable() && codes.insert(code) {
            let text = EditText::Allow { name: code.name() };
            add(text, allow(snapshot, analysis, code), item);
        }
    }
    actions
}

/// An edit of one document by its URI: what stands instead of a range.
fn edit(snapshot: &Snapshot, uri: &Uri, first: Option<Value>, range: Value, text: &str) -> Option<WorkspaceEdit> {
    let edit = json!({ "range": range, "newText": text });
    if !snapshot.client.has("/workspace/workspaceEdit/documentChanges") {
        if first.is_some() {
            return None;
        }
        return serde_json::from_value(json!({ "changes": { uri.as_str(): [edit] } })).ok();
    }
    let version = snapshot.files.open().values().find(|document| document.uri == *uri).map(|document| document.version);
    let change = json!({ "textDocument": { "uri": uri, "version": version }, "edits": [edit] });
    let changes: Vec<Value> = first.into_iter().chain([change]).collect();
    serde_json::from_value(json!({ "documentChanges": changes })).ok()
}

/// The frame of a macrocycle beside the program, or in the folder that the configuration names for them.
fn create_macrocycle(snapshot: &Snapshot, analysis: &Analysis, l: u32) -> Option<WorkspaceEdit> {
    let creates = snapshot.client.lists("/workspace/workspaceEdit/resourceOperations", "create");
    let configured = analysis.settings.macrocycles.iter().find(|folder| analysis.files.is_folder(folder));
    let folder = configured.map(|folder| analysis.files.canonical(folder));
    let folder = folder.or_else(|| analysis.path.parent().map(Path::to_path_buf))?;
    let uri = Uri::from_file_path(folder.join(format!("L{l}"))).ok().filter(|_| creates)?;
    let create = json!({ "kind": "create", "uri": uri, "options": { "ignoreIfExists": true } });
    let start = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    edit(snapshot, &uri, Some(create), start, &format!("N10 G79 L{l}\nN20 G70\n"))
}

/// `name = "allow"` under `[lints]` of the project file, when there is one that writes its tables so.
fn allow(snapshot: &Snapshot, analysis: &Analysis, code: Code) -> Option<WorkspaceEdit> {
    let path = find_project(analysis.path.parent()?, &snapshot.files)?;
    let path = snapshot.files.canonical(&path);
    let source = snapshot.files.load(&path, PROJECT_FILE, Encoding::Utf8).ok()?;
    let uri = snapshot.files.uri_of(&path)?;
    let (span, text) = lint_edit(&source, code)?;
    let range = Places::new(&source, snapshot.client.unit).range(span);
    edit(snapshot, &uri, None, serde_json::to_value(range).ok()?, &text)
}

/// The place in a project file for the level, and its text; none where the levels are an inline table or dotted keys:
/// a second table of that name is an error.
fn lint_edit(source: &SourceText, code: Code) -> Option<(Span, String)> {
    let level = format!("{} = \"allow\"", code.name());
    let mut table = "";
    let mut header = None;
    for line in 0..source.lines().count() {
        let span = source.line_span(line);
        let text = source.slice(span).trim();
        if let Some(name) = text.strip_prefix('[') {
            table = name.split(']').next().sure().trim().trim_matches(['"', '\'']);
            if table == "lints" {
                header = Some(span);
            }
        } else if let Some((name, _)) = text.split_once('=') {
            let first = name.split('.').next().sure().trim().trim_matches(['"', '\'']);
            if table.is_empty() && first == "lints" {
                return None;
            }
            if table == "lints" && Code::find(first) == Some(code) {
                return Some((span, level));
            }
        }
    }
    if let Some(header) = header {
        return Some((Span::empty(header.end), format!("\n{level}")));
    }
    let text = source.text();
    let gap = match text.trim_end_matches([' ', '\t']) {
        "" => "",
        text if text.ends_with("\n\n") => "",
        text if text.ends_with('\n') => "\n",
        _ => "\n\n",
    };
    Some((Span::empty(source.len()), format!("{gap}[lints]\n{level}\n")))
}

/// The quick fixes of the project file itself.
pub(super) fn in_project_file(snapshot: &Snapshot, params: &Value) -> Option<Value> {
    let file = super::project_file::of_request(snapshot, params)?;
    let found = snapshot.found.as_ref()?;
    let client = &snapshot.client;
    let id: FileId = found
        .report
        .sources()
        .iter()
        .find_map(|(id, source)| (snapshot.files.canonical(Path::new(source.name())) == file.path).then_some(id))?;
    let range: gen_lsp_types::Range = serde_json::from_value(params.get("range")?.clone()).ok()?;
    let range = super::places::span(&file.source, range, client.unit);
    let converter = Converter { report: &found.report, files: &snapshot.files, unit: client.unit, lang: client.lang() };
    let uri = snapshot.files.uri_of(&file.path)?;
    let mut places = Places::new(&file.source, client.unit);
    let mut actions = Vec::new();
    for item in found.report.items().filter(|item| item.diagnostic.at.file == id) {
        let at = item.diagnostic.at.span;
        if at.end < range.start || range.end < at.start {
            continue;
        }
        for fix in &item.diagnostic.fixes {
            let Some(change) = fix.edits.first() else { continue };
            let range = serde_json::to_value(places.range(change.at.span)).ok()?;
            let action = CodeAction {
                title: fix.title.text(client.lang()),
                kind: Some(CodeActionKind::QuickFix),
                diagnostics: Some(vec![converter.diagnostic(item, &mut places)]),
                edit: edit(snapshot, &uri, None, range, &change.text),
                ..CodeAction::default()
            };
            actions.push(serde_json::to_value(action).ok()?);
        }
    }
    Some(Value::Array(actions))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels() {
        let of = |text: &str| {
            let mut source = SourceText::from_text("", text);
            let (span, with) = lint_edit(&source, Code::W0214)?;
            source.replace(span, &with);
            Some(source.text().to_owned())
        };
        let some = |text: &str| Some(text.to_owned());
        assert_eq!(of("dialect = \"cnc872\"\n"), some("dialect = \"cnc872\"\n\n[lints]\nempty-block = \"allow\"\n"));
        assert_eq!(of(""), some("[lints]\nempty-block = \"allow\"\n"));
        assert_eq!(of("[lints]\n[limits]\n"), some("[lints]\nempty-block = \"allow\"\n[limits]\n"));
        assert_eq!(of("[lints]\nW0214 = \"deny\"\n"), some("[lints]\nempty-block = \"allow\"\n"));
        assert_eq!(of("[\"lints\"]\n'W0214' = \"deny\"\n"), some("[\"lints\"]\nempty-block = \"allow\"\n"));
        for written in ["lints = { W0601 = \"warn\" }\n", "lints.W0601 = \"warn\"\n", "\"lints\" . W0601 = \"warn\"\n"]
        {
            assert_eq!(of(written), None);
        }
    }
}
