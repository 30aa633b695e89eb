//! Changes of other files that findings suggest: a level in the project file, a macrocycle that is not there yet.

use std::collections::BTreeSet;
use std::path::Path;

use gen_lsp_types::{CodeAction, CodeActionKind, CreateFile, CreateFileOptions, Range, TextEdit, Uri, WorkspaceEdit};
use serde_json::Value;

use super::analysis::{Analysis, Found};
use super::edits::workspace_edit;
use super::findings::Converter;
use super::places::{Places, span};
use super::snapshot::Snapshot;
use crate::config::{PROJECT_FILE, find_project};
use crate::diag::{Code, Edit, Finding, Report, Reported};
use crate::edit::edit_texts::EditText;
use crate::sure::Sure;
use crate::text::{Encoding, FileId, Loader, SourceText, Span};

/// The findings of a file that touch a range, and actions for them.
pub(super) struct Touched<'a> {
    report: &'a Report,
    converter: Converter<'a>,
    places: Places<'a>,
    file: FileId,
    range: Span,
}

impl<'a> Touched<'a> {
    /// Those of `source`, which is `file` in the report.
    pub(super) fn new(
        snapshot: &'a Snapshot,
        found: &'a Found,
        source: &'a SourceText,
        file: FileId,
        range: Range,
    ) -> Self {
        let Snapshot { client, files, .. } = snapshot;
        let report = &found.report;
        let converter = Converter { report, files, unit: client.unit, lang: client.lang() };
        let range = span(source, range, client.unit);
        Self { report, converter, places: Places::new(source, client.unit), file, range }
    }

    pub(super) fn items(&self) -> impl Iterator<Item = &'a Reported> + use<'a> {
        let Self { report, file, range, .. } = *self;
        report.items().filter(move |item| {
            let at = item.diagnostic.at;
            at.file == file && at.span.end >= range.start && range.end >= at.span.start
        })
    }

    pub(super) fn action(&mut self, item: &Reported, title: String, edit: Option<WorkspaceEdit>) -> CodeAction {
        CodeAction {
            title,
            kind: Some(CodeActionKind::QuickFix),
            diagnostics: Some(vec![self.converter.diagnostic(item, &mut self.places)]),
            edit,
            ..CodeAction::default()
        }
    }
}

/// The offers for findings of the document.
pub(super) fn actions(snapshot: &Snapshot, analysis: &Analysis, touched: &mut Touched<'_>) -> Vec<CodeAction> {
    let lang = snapshot.client.lang();
    let mut codes = BTreeSet::new();
    let mut actions = Vec::new();
    for item in touched.items() {
        let code = item.diagnostic.code();
        let mut add = |text: EditText, edit: Option<WorkspaceEdit>| {
            actions.extend(edit.map(|edit| touched.action(item, text.text(lang), Some(edit))));
        };
        if let Finding::UnknownMacrocycle { l, subprogram: false, .. } = item.diagnostic.finding {
            add(EditText::CreateMacrocycle { l }, create_macrocycle(snapshot, analysis, l));
        }
        if code.is_configurable() && codes.insert(code) {
            add(EditText::Allow { name: code.name() }, allow(snapshot, analysis, code));
        }
    }
    actions
}

/// The frame of a macrocycle beside the program, or in the folder that the configuration names for them.
fn create_macrocycle(snapshot: &Snapshot, analysis: &Analysis, l: u32) -> Option<WorkspaceEdit> {
    let creates = snapshot.client.lists("/workspace/workspaceEdit/resourceOperations", "create");
    let configured = analysis.settings.macrocycles.iter().find(|folder| analysis.files.is_folder(folder));
    let folder = configured.map(|folder| analysis.files.canonical(folder));
    let folder = folder.or_else(|| analysis.path.parent().map(Path::to_path_buf))?;
    let uri = Uri::from_file_path(folder.join(format!("L{l}"))).ok().filter(|_| creates)?;
    let options = CreateFileOptions { overwrite: None, ignore_if_exists: Some(true) };
    let create = CreateFile { uri: uri.clone(), options: Some(options), annotation_id: None };
    let frame = TextEdit { range: Range::default(), new_text: format!("N10 G79 L{l}\nN20 G70\n") };
    workspace_edit(snapshot, &uri, Some(create), vec![frame])
}

/// `name = "allow"` under `[lints]` of the project file, when there is one that writes its tables so.
fn allow(snapshot: &Snapshot, analysis: &Analysis, code: Code) -> Option<WorkspaceEdit> {
    let path = find_project(analysis.path.parent()?, &snapshot.files)?;
    let path = snapshot.files.canonical(&path);
    let source = snapshot.files.load(&path, PROJECT_FILE, Encoding::Utf8).ok()?;
    let uri = snapshot.files.uri_of(&path)?;
    let (span, new_text) = lint_edit(&source, code)?;
    let range = Places::new(&source, snapshot.client.unit).range(span);
    workspace_edit(snapshot, &uri, None, vec![TextEdit { range, new_text }])
}

/// The place in a project file for the level, and its text; none where the levels are an inline table or dotted keys:
/// a second table of that name is an error. None in a file that is not valid TOML.
fn lint_edit(source: &SourceText, code: Code) -> Option<(Span, String)> {
    source.text().parse::<toml_edit::DocumentMut>().ok()?;
    let level = format!("{} = \"allow\"", code.name());
    let line_end = source.line_end();
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
                let comment = text.find('#').and_then(|at| text.get(at..)).map(|comment| format!(" {comment}"));
                return Some((span, level + &comment.unwrap_or_default()));
            }
        }
    }
    if let Some(header) = header {
        return Some((Span::empty(header.end), format!("{line_end}{level}")));
    }
    let text = source.text();
    let gap = match text.trim_end_matches([' ', '\t']) {
        "" => 0,
        text if text.ends_with(&line_end.repeat(2)) => 0,
        text if text.ends_with('\n') => 1,
        _ => 2,
    };
    let gap = line_end.repeat(gap);
    Some((Span::empty(source.len()), format!("{gap}[lints]{line_end}{level}{line_end}")))
}

/// The quick fixes of the project file itself.
pub(super) fn in_project_file(snapshot: &Snapshot, params: &Value) -> Option<Value> {
    let file = super::project_file::of_request(snapshot, params)?;
    let found = snapshot.found.as_ref()?;
    let same = |source: &SourceText| snapshot.files.canonical(Path::new(source.name())) == file.path;
    let id = found.report.sources().iter().find_map(|(id, source)| same(source).then_some(id))?;
    let range: Range = serde_json::from_value(params.get("range")?.clone()).ok()?;
    let mut touched = Touched::new(snapshot, found, &file.source, id, range);
    let uri = snapshot.files.uri_of(&file.path)?;
    let mut actions = Vec::new();
    for item in touched.items() {
        for fix in &item.diagnostic.fixes {
            let places = &mut touched.places;
            let edit = |edit: &Edit| TextEdit { range: places.range(edit.at.span), new_text: edit.text.clone() };
            let edit = workspace_edit(snapshot, &uri, None, fix.edits.iter().map(edit).collect());
            actions.push(touched.action(item, fix.title.text(snapshot.client.lang()), edit));
        }
    }
    serde_json::to_value(actions).ok()
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
        assert_eq!(of("R1 = 2\r\n"), some("R1 = 2\r\n\r\n[lints]\r\nempty-block = \"allow\"\r\n"));
        assert_eq!(of("[lints]\r\nR1 = 2"), some("[lints]\r\nempty-block = \"allow\"\r\nR1 = 2"));
        assert_eq!(of(""), some("[lints]\nempty-block = \"allow\"\n"));
        assert_eq!(of("[lints]\n[limits]\n"), some("[lints]\nempty-block = \"allow\"\n[limits]\n"));
        assert_eq!(of("[lints]\nW0214 = \"deny\"\n"), some("[lints]\nempty-block = \"allow\"\n"));
        assert_eq!(of("[lints]\r\nW0214 = 'warn' # x\r\n"), some("[lints]\r\nempty-block = \"allow\" # x\r\n"));
        assert_eq!(of("R1 = 2\n[broken\n"), None);
        assert_eq!(of("[\"lints\"]\n'W0214' = \"deny\"\n"), some("[\"lints\"]\nempty-block = \"allow\"\n"));
        for written in ["lints = { W0601 = \"warn\" }\n", "lints.W0601 = \"warn\"\n", "\"lints\" . W0601 = \"warn\"\n"]
        {
            assert_eq!(of(written), None);
        }
    }
}
