//! Which request is answered by what, and what it needs to be known first.

use lsp_server::ErrorCode;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::analysis::Analysis;
use super::snapshot::{Answer, Needs, Refusal, Snapshot};
use super::{
    code_actions, code_lens, commands, compare, completion, definition, dots, explain, folding, formatting, hierarchy,
    hover, inlay_hints, links, offered, on_type, outline, path, project_file, references, rename, restart, selection,
    semantic_tokens, signals, signature, state, workspace, workspace_findings, workspace_symbols,
};

/// Makes the result of a request from its parameters, as JSON text: a long result costs more as a tree of values.
type Run = Box<dyn Fn(&Snapshot, Value) -> Answer<String> + Send>;

/// The result where there is none.
const NULL: &str = "null";

/// How a request is answered.
pub(super) struct Handler {
    pub(super) needs: Needs,
    pub(super) run: Run,
}

/// The handler of a request; `None` for what the server does not know.
pub(super) fn handler(method: &str) -> Option<Handler> {
    of_document(method).or_else(|| of_workspace(method))
}

/// The handler of a request about one document.
fn of_document(method: &str) -> Option<Handler> {
    Some(match method {
        "textDocument/hover" => or_project_file(document(Needs::Blocks, hover::hover), project_file::hover),
        "textDocument/signatureHelp" => document(Needs::Blocks, signature::signature_help),
        "cnc872c/compare" => document(Needs::Analysis, compare::answer),
        "cnc872c/dots" => document(Needs::Run, dots::dots),
        "cnc872c/path" => document(Needs::Run, path::path),
        "cnc872c/restart" => document(Needs::Run, restart::restart),
        "cnc872c/state" => document(Needs::Run, state::state),
        "cnc872c/signals" => document(Needs::Run, signals::signals),
        "textDocument/codeLens" => document(Needs::Run, code_lens::code_lens),
        "textDocument/inlayHint" => document(Needs::Blocks, inlay_hints::inlay_hint),
        "textDocument/completion" => {
            or_project_file(document(Needs::Analysis, completion::completion), project_file::completion)
        }
        "textDocument/formatting" => document(Needs::Analysis, formatting::formatting),
        "textDocument/rangeFormatting" => document(Needs::Analysis, formatting::range_formatting),
        "textDocument/onTypeFormatting" => document(Needs::Analysis, on_type::on_type_formatting),
        "textDocument/documentSymbol" => document(Needs::Analysis, outline::document_symbol),
        "textDocument/foldingRange" => document(Needs::Analysis, folding::folding_range),
        "textDocument/selectionRange" => document(Needs::Analysis, selection::selection_range),
        "textDocument/codeAction" => {
            or_project_file(document(Needs::Findings, code_actions::code_action), |snapshot, params| {
                Ok(offered::in_project_file(snapshot, params).unwrap_or_default())
            })
        }
        "codeAction/resolve" => document(Needs::Analysis, code_actions::resolve),
        "textDocument/semanticTokens/full" => document(Needs::Analysis, semantic_tokens::full),
        "textDocument/semanticTokens/range" => document(Needs::Analysis, semantic_tokens::range),
        "textDocument/definition" => document(Needs::Everything, definition::definition),
        "textDocument/declaration" => document(Needs::Everything, definition::declaration),
        "textDocument/references" => document(Needs::Everything, references::references),
        "textDocument/documentHighlight" => document(Needs::Everything, references::highlight),
        "textDocument/prepareRename" => document(Needs::Findings, rename::prepare),
        "textDocument/rename" => document(Needs::Findings, rename::rename),
        "textDocument/documentLink" => document(Needs::Analysis, links::document_links),
        "textDocument/prepareCallHierarchy" => document(Needs::Everything, hierarchy::prepare),
        _ => return None,
    })
}

/// The handler of a request about all documents and files.
fn of_workspace(method: &str) -> Option<Handler> {
    Some(match method {
        "workspace/symbol" => workspace(Needs::Nothing, workspace_symbols::workspace_symbol),
        "workspace/diagnostic" => workspace(Needs::Nothing, workspace_findings::workspace_diagnostic),
        "workspace/willRenameFiles" => workspace(Needs::Nothing, workspace::will_rename_files),
        "workspace/executeCommand" => workspace(Needs::Nothing, commands::execute),
        "callHierarchy/incomingCalls" => workspace(Needs::Everything, hierarchy::incoming),
        "callHierarchy/outgoingCalls" => workspace(Needs::Everything, hierarchy::outgoing),
        "workspace/textDocumentContent" => workspace(Needs::Nothing, explain::text_document_content),
        _ => return None,
    })
}

/// A request about one program or macrocycle. In other documents its result is null.
fn document<P: DeserializeOwned + 'static, R: Serialize + 'static>(
    needs: Needs,
    answer: fn(&Snapshot, &Analysis, P) -> Answer<R>,
) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| {
        let params = parameters(params)?;
        match &snapshot.analysis {
            Some(analysis) => result(&answer(snapshot, analysis, params)?),
            None => Ok(NULL.to_owned()),
        }
    };
    Handler { needs, run: Box::new(run) }
}

/// The same, with an answer for the project file.
fn or_project_file(handler: Handler, answer: fn(&Snapshot, &Value) -> Answer<Value>) -> Handler {
    let Handler { needs, run } = handler;
    let run = move |snapshot: &Snapshot, params: Value| {
        if snapshot.analysis.is_none() { Ok(answer(snapshot, &params)?.to_string()) } else { run(snapshot, params) }
    };
    Handler { needs, run: Box::new(run) }
}

/// A request about everything.
fn workspace<P: DeserializeOwned + 'static, R: Serialize + 'static>(
    needs: Needs,
    answer: fn(&Snapshot, P) -> Answer<R>,
) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| result(&answer(snapshot, parameters(params)?)?);
    Handler { needs, run: Box::new(run) }
}

fn parameters<P: DeserializeOwned>(params: Value) -> Answer<P> {
    serde_json::from_value(params).map_err(Refusal::wrong_params)
}

fn result(result: &impl Serialize) -> Answer<String> {
    serde_json::to_string(result)
        .map_err(|error| Refusal { code: ErrorCode::InternalError, message: error.to_string() })
}
