//! Code actions: fix findings, one or all, and renumber the blocks.

use std::sync::Arc;

use gen_lsp_types::{
    CodeAction, CodeActionContext, CodeActionDisabled, CodeActionKind, CodeActionParams, CodeActionResponse,
    CodeActionTriggerKind,
};
use lsp_server::ErrorCode;
use serde_json::{Value, json};

use super::analysis::{Analysis, Found};
use super::edits::document_edit;
use super::offered::{self, Touched};
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::diag::Reported;
use crate::edit::compatible_edits;
use crate::edit::edit_texts::EditText;
use crate::query;
use crate::session::Session;
use crate::sure::{Sure, small};
use crate::text::{FileId, SourceText, Span};

/// Most rounds of fixes: each applies what the one before uncovered.
const MOST_ROUNDS: usize = 16;
/// The fixes of a file together.
pub(super) const FIX_ALL: &str = "source.fixAll.cnc872c";
/// New numbers for the blocks.
pub(super) const RENUMBER: &str = "source.renumber.cnc872c";

/// `textDocument/codeAction`. What concerns the whole file is offered when the user asks, not with every move of the
/// cursor.
pub(super) fn code_action(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: CodeActionParams,
) -> Answer<Option<Vec<CodeActionResponse>>> {
    if !snapshot.client.has("/textDocument/codeAction/codeActionLiteralSupport") {
        // Such a client takes commands only.
        return Ok(None);
    }
    let Some(source) = analysis.sources.get(FileId(0)) else { return Ok(None) };
    let wanted = Wanted(&params.context);
    let mut actions = Vec::new();
    let found = snapshot.found.as_ref();
    let file = found.and_then(|found| found.report.sources().find(source.name()));
    if let Some((found, file)) = found.zip(file) {
        let fixes = OfDocument { snapshot, analysis, source, found, file };
        if wanted.kind(CodeActionKind::QuickFix.as_str()) {
            let mut touched = Touched::new(snapshot, found, source, file, params.range);
            actions.extend(fixes.quick_fixes(&mut touched));
            actions.extend(offered::actions(snapshot, analysis, &mut touched));
        }
        if wanted.for_the_file(FIX_ALL) {
            actions.extend(fixes.fix_all());
        }
    }
    if wanted.for_the_file(RENUMBER) {
        actions.extend(renumber_action(snapshot, analysis, source));
    }
    Ok(Some(actions.into_iter().map(Into::into).collect()))
}

/// `codeAction/resolve`: the edits of an action that was offered without.
pub(super) fn resolve(snapshot: &Snapshot, analysis: &Analysis, mut action: CodeAction) -> Answer<CodeAction> {
    let version = snapshot.files.buffer(&analysis.path).map(|document| document.version);
    let of_version = action.data.as_ref().and_then(|data| data.get("version")).and_then(Value::as_i64);
    if of_version != version.map(i64::from) {
        return Err(Refusal { code: ErrorCode::ContentModified, message: "the document has changed".to_owned() });
    }
    if action.kind == Some(CodeActionKind::Custom(RENUMBER.into())) && action.edit.is_none() {
        let renumbering = analysis.renumbering().map_err(|why| Refusal::new(why.text(snapshot.client.lang())))?;
        if let Some(source) = analysis.sources.get(FileId(0)) {
            let edits = renumbering.edits.iter().map(|(span, text)| (*span, text.as_str()));
            action.edit = document_edit(snapshot, analysis, source, edits);
        }
    }
    Ok(action)
}

/// The kinds of action that the client asks for.
struct Wanted<'a>(&'a CodeActionContext);

impl Wanted<'_> {
    /// Whether it wants actions of that kind: `source` means `source.fixAll` too.
    fn kind(&self, kind: &str) -> bool {
        let covers = |wanted: &CodeActionKind| {
            let rest = kind.strip_prefix(wanted.as_str());
            wanted.as_str().is_empty() || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        self.0.only.as_ref().is_none_or(|only| only.iter().any(covers))
    }

    fn for_the_file(&self, kind: &str) -> bool {
        let by_itself = self.0.trigger_kind == Some(CodeActionTriggerKind::Automatic);
        self.kind(kind) && (self.0.only.is_some() || !by_itself)
    }
}

/// `text` after edits that do not overlap, in the order of the text.
fn edited(text: &str, edits: &[(Span, &str)]) -> String {
    let mut result = String::with_capacity(text.len());
    let mut done = 0;
    for (span, with) in edits {
        result.push_str(text.get(done..span.start as usize).sure());
        result.push_str(with);
        done = span.end as usize;
    }
    result.push_str(text.get(done..).sure());
    result
}

/// The part of `before` that differs from `now`, from the first such line to the last, and its new text.
fn difference<'t>(before: &'t str, now: &'t str) -> (Span, &'t str) {
    let lines = |text: &'t str| text.split_inclusive('\n');
    let same = |(a, b): &(&str, &str)| a == b;
    let start: usize = lines(before).zip(lines(now)).take_while(same).map(|(line, _)| line.len()).sum();
    let backward = lines(before).rev().zip(lines(now).rev());
    let behind: usize = backward.take_while(same).map(|(line, _)| line.len()).sum();
    let behind = behind.min(before.len().min(now.len()) - start);
    let span = Span::new(small(start), small(before.len() - behind));
    (span, now.get(start..now.len() - behind).sure())
}

/// The fixable findings of the document.
struct OfDocument<'a> {
    snapshot: &'a Snapshot,
    analysis: &'a Analysis,
    source: &'a SourceText,
    found: &'a Found,
    /// The document in the report.
    file: FileId,
}

impl<'a> OfDocument<'a> {
    fn items(&self) -> impl Iterator<Item = &'a Reported> {
        let file = self.file;
        let of_document = move |item: &&Reported| item.diagnostic.file() == file;
        self.found.report.items().filter(of_document).filter(|item| !item.diagnostic.fixes.is_empty())
    }

    /// The fixes of the findings that touch a range.
    fn quick_fixes(&self, touched: &mut Touched<'_>) -> Vec<CodeAction> {
        let mut actions = Vec::new();
        for item in touched.items() {
            let fixes = &item.diagnostic.fixes;
            for fix in fixes {
                let mut edits: Vec<(Span, &str)> =
                    fix.edits.iter().map(|edit| (edit.at.span, edit.text.as_str())).collect();
                edits.sort_by_key(|(span, _)| *span);
                let edit = document_edit(self.snapshot, self.analysis, self.source, edits.into_iter());
                let action = touched.action(item, fix.title.text(self.snapshot.client.lang()), edit);
                let is_preferred = (fixes.len() == 1 && fix.certain.is_some()).then_some(true);
                actions.push(CodeAction { is_preferred, ..action });
            }
        }
        actions
    }

    /// All fixes, of several of one finding the first. Fixes that overlap others wait for a next round, as in `check
    /// --fix`.
    fn fix_all(&self) -> Option<CodeAction> {
        let fixes = self.items().filter_map(|item| item.diagnostic.certain_fix());
        let edits: Vec<(Span, &str)> = compatible_edits(self.source, self.file, fixes).collect();
        if edits.is_empty() {
            return None;
        }
        let once = edited(self.source.text(), &edits);
        let fixed = self.next_rounds(&once);
        let edit = if fixed == once {
            document_edit(self.snapshot, self.analysis, self.source, edits.into_iter())
        } else {
            let (span, text) = difference(self.source.text(), &fixed);
            document_edit(self.snapshot, self.analysis, self.source, [(span, text)].into_iter())
        };
        Some(CodeAction {
            title: EditText::FixAll.text(self.snapshot.client.lang()),
            kind: Some(CodeActionKind::Custom(FIX_ALL.into())),
            edit,
            ..CodeAction::default()
        })
    }

    /// The text after further rounds of fixes.
    fn next_rounds(&self, once: &str) -> String {
        let query::analysis::Analysis { path, settings, .. } = &**self.analysis;
        let name = self.source.name();
        let mut files = self.analysis.files.clone();
        let mut now = once.to_owned();
        for _ in 1..MOST_ROUNDS {
            let Some(document) = files.open_mut().get_mut(path) else { break };
            let source = Arc::new(SourceText::from_text(name, now.as_str()));
            document.source = Arc::clone(&source);
            let outcome = Session { loader: &files, settings, progress: None }.check(path, name);
            let shown = outcome.findings.items().iter().filter(|item| settings.severity(item.code()).is_some());
            let fixes = shown.filter(|item| item.file() == FileId(0)).filter_map(|item| item.certain_fix());
            let edits: Vec<(Span, &str)> = compatible_edits(&source, FileId(0), fixes).collect();
            if edits.is_empty() {
                break;
            }
            now = edited(&now, &edits);
        }
        now
    }
}

/// Renumbering, or why it cannot be done.
fn renumber_action(snapshot: &Snapshot, analysis: &Analysis, source: &SourceText) -> Option<CodeAction> {
    let client = &snapshot.client;
    let kind = Some(CodeActionKind::Custom(RENUMBER.into()));
    let title = |step| EditText::Renumber { step }.text(client.lang());
    let renumbering = match analysis.renumbering() {
        Ok(renumbering) => renumbering,
        Err(why) => {
            let disabled = Some(CodeActionDisabled { reason: why.text(client.lang()) });
            let action = CodeAction { title: title(10), kind, disabled, ..CodeAction::default() };
            return client.has("/textDocument/codeAction/disabledSupport").then_some(action);
        }
    };
    let action = CodeAction { title: title(renumbering.step), kind, ..CodeAction::default() };
    let later = ["resolveSupport", "dataSupport"].map(|part| format!("/textDocument/codeAction/{part}"));
    if later.iter().all(|capability| client.has(capability)) {
        let document = snapshot.files.buffer(&analysis.path)?;
        let data = json!({ "uri": document.uri, "version": document.version });
        return Some(CodeAction { data: Some(data), ..action });
    }
    let edits = renumbering.edits.iter().map(|(span, text)| (*span, text.as_str()));
    Some(CodeAction { edit: document_edit(snapshot, analysis, source, edits), ..action })
}
