//! Commands that the client may have executed.

use std::path::Path;

use gen_lsp_types::{ExecuteCommandParams, Uri};
use lsp_server::ErrorCode;
use serde_json::{Value, json};

use super::analysis::configuration;
use super::requests::{Answer, Refusal, Snapshot};
use crate::diag::{Report, Severity};
use crate::edit::edit_texts::EditText;
use crate::session::{Outcome, Part, Run, Session};

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
    let (settings, sources, findings) = configuration(path, files, &snapshot.client);
    let mut report = Report::new();
    report.add(&sources, findings);
    refuse_errors(snapshot, &report)?;

    // The rest of a long program is not looked at.
    let goes_on = |executed| executed <= RECORDS && !snapshot.cancel.is_cancelled();
    let session = Session { loader: files, settings: &settings, progress: Some(&goes_on) };
    let root = snapshot.client.root();
    let name = path.strip_prefix(files_root(snapshot, &root)).unwrap_or(path).to_string_lossy().into_owned();
    let mut text = Vec::new();
    let part = Part { from: 0, limit: Some(RECORDS) };
    let Run { outcome, whole } =
        session.compile(path, &name, part, &mut text).map_err(|error| Refusal::new(error.to_string()))?;
    let Outcome { sources, findings, executed, .. } = outcome;
    report.add_program(&sources, findings);
    refuse_errors(snapshot, &report)?;
    let truncated = executed > RECORDS;
    if whole.is_none() && !truncated {
        return Err(Refusal::new(EditText::NotWhole.text(snapshot.client.lang())));
    }
    Ok(json!({ "text": String::from_utf8_lossy(&text), "truncated": truncated }))
}

/// The canonical root of the workspace; paths of documents are canonical.
fn files_root(snapshot: &Snapshot, root: &Path) -> std::path::PathBuf {
    use crate::text::Loader;
    snapshot.files.canonical(root)
}

fn refuse_errors(snapshot: &Snapshot, report: &Report) -> Answer<()> {
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
