//! Commands that the client may have executed.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gen_lsp_types::{ExecuteCommandParams, Uri};
use lsp_server::ErrorCode;
use serde_json::{Value, json};

use super::analysis::configuration;
use super::files::EditorFiles;
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::diag::{Report, Severity};
use crate::edit::edit_texts::EditText;
use crate::session::{Outcome, Part, Run, Session};
use crate::text::{Encoding, Loader, SourceText};

/// The block stream of a document: `[uri]` gives `{ "text", "truncated" }`.
pub(super) const STREAM: &str = "cnc872c.stream";

/// Most block records of a stream.
const RECORDS: u64 = 10_000;

/// `workspace/executeCommand`.
pub(super) fn execute(snapshot: &Snapshot, params: ExecuteCommandParams) -> Answer<Option<Value>> {
    let lang = snapshot.client.lang();
    let refuse = |text: EditText| Refusal { code: ErrorCode::InvalidParams, message: text.text(lang) };
    if params.command != STREAM {
        return Err(refuse(EditText::UnknownCommand { command: params.command }));
    }
    let uri = params.arguments.as_deref().and_then(|arguments| arguments.first()?.as_str());
    match uri.and_then(|uri| Uri::parse(uri).ok()) {
        Some(uri) => stream(snapshot, &snapshot.files.path_of(&uri)).map(Some),
        None => Err(refuse(EditText::NoProgram)),
    }
}

/// Compiles the program at `path`, with the changes that are not saved.
fn stream(snapshot: &Snapshot, path: &Path) -> Answer<Value> {
    let files = &snapshot.files;
    if Session::is_macrocycle_name(path) {
        return Err(Refusal::new(EditText::MacrocycleStream.text(snapshot.client.lang())));
    }
    let (settings, sources, findings) = configuration(path, files, &snapshot.client);
    let mut report = Report::new();
    report.add(&sources, findings);
    refuse_errors(snapshot, &report)?;

    // Files have the names that `compile` gives them in the folder of the workspace.
    let root = files.canonical(&snapshot.client.root());
    let below = |path: &Path| path.strip_prefix(&root).unwrap_or(path).to_path_buf();
    let rooted = Rooted { files, root: &root };
    let mut settings = settings;
    settings.macrocycles = settings.macrocycles.iter().map(|folder| below(&files.canonical(folder))).collect();
    let path = below(path);
    let name = path.to_string_lossy().into_owned();
    // The rest of a long program is not looked at.
    let goes_on = |executed| executed <= RECORDS && !snapshot.cancel.is_cancelled();
    let session = Session { loader: &rooted, settings: &settings, progress: Some(&goes_on) };
    let mut text = Vec::new();
    let part = Part { from: 0, limit: Some(RECORDS) };
    let Run { outcome, whole } =
        session.compile(&path, &name, part, &mut text).map_err(|error| Refusal::new(error.to_string()))?;
    let Outcome { sources, findings, executed, .. } = outcome;
    report.add_program(&sources, findings);
    refuse_errors(snapshot, &report)?;
    let truncated = executed > RECORDS;
    if whole.is_none() && !truncated {
        return Err(Refusal::new(EditText::NotWhole.text(snapshot.client.lang())));
    }
    Ok(json!({ "text": String::from_utf8_lossy(&text), "truncated": truncated }))
}

/// The files of the editor by their names in the folder of the workspace.
struct Rooted<'a> {
    files: &'a EditorFiles,
    /// Canonical.
    root: &'a Path,
}

impl Rooted<'_> {
    fn below(&self, paths: Vec<PathBuf>) -> Vec<PathBuf> {
        paths.into_iter().map(|path| path.strip_prefix(self.root).map(Path::to_path_buf).unwrap_or(path)).collect()
    }
}

impl Loader for Rooted<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.files.read(&self.root.join(path))
    }

    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        self.files.load(&self.root.join(path), name, fallback)
    }

    fn size(&self, path: &Path) -> Option<u64> {
        self.files.size(&self.root.join(path))
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.below(self.files.list(&self.root.join(folder)))
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.below(self.files.folders(&self.root.join(folder)))
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.files.is_folder(&self.root.join(path))
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.files.canonical(&self.root.join(path))
    }
}

/// Refuses, with the first of them, when there are errors.
pub(super) fn refuse_errors(snapshot: &Snapshot, report: &Report) -> Answer<()> {
    let Some(first) = report.items().find(|item| item.severity == Severity::Error) else { return Ok(()) };
    let lang = snapshot.client.lang();
    let at = first.diagnostic.at;
    let source = report.sources().get(at.file);
    let first = EditText::AtLine {
        file: source.map_or_else(String::new, |source| source.name().to_owned()),
        line: source.map_or(1, |source| source.line_column(at.span.start).line),
        message: first.diagnostic.finding.message(lang),
    };
    let text = EditText::CannotCompile { errors: report.errors(), first: first.text(lang) };
    Err(Refusal::new(text.text(lang)))
}
