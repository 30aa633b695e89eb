//! Which request is answered by what, and what it needs to be known first.

use gen_lsp_types::Request;
use lsp_server::ErrorCode;
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
    use gen_lsp_types as lsp;
    Some(match method {
        "textDocument/hover" => {
            or_project_file(document::<lsp::HoverRequest>(Needs::Blocks, hover::hover), project_file::hover)
        }
        "textDocument/signatureHelp" => untyped(Needs::Blocks, signature::signature_help),
        "cnc872c/compare" => document::<compare::CompareRequest>(Needs::Analysis, compare::answer),
        "cnc872c/dots" => document::<dots::DotsRequest>(Needs::Run, dots::dots),
        "cnc872c/path" => document::<path::PathRequest>(Needs::Run, path::path),
        "cnc872c/restart" => untyped(Needs::Run, restart::restart),
        "cnc872c/state" => untyped(Needs::Run, state::state),
        "cnc872c/signals" => document::<signals::SignalsRequest>(Needs::Run, signals::signals),
        "textDocument/codeLens" => document::<lsp::CodeLensRequest>(Needs::Run, code_lens::code_lens),
        "textDocument/inlayHint" => document::<lsp::InlayHintRequest>(Needs::Blocks, inlay_hints::inlay_hint),
        "textDocument/completion" => or_project_file(
            document::<lsp::CompletionRequest>(Needs::Analysis, completion::completion),
            project_file::completion,
        ),
        "textDocument/formatting" => {
            document::<lsp::DocumentFormattingRequest>(Needs::Analysis, formatting::formatting)
        }
        "textDocument/rangeFormatting" => {
            document::<lsp::DocumentRangeFormattingRequest>(Needs::Analysis, formatting::range_formatting)
        }
        "textDocument/onTypeFormatting" => {
            document::<lsp::DocumentOnTypeFormattingRequest>(Needs::Analysis, on_type::on_type_formatting)
        }
        "textDocument/documentSymbol" => {
            document::<lsp::DocumentSymbolRequest>(Needs::Analysis, outline::document_symbol)
        }
        "textDocument/foldingRange" => document::<lsp::FoldingRangeRequest>(Needs::Analysis, folding::folding_range),
        "textDocument/selectionRange" => {
            document::<lsp::SelectionRangeRequest>(Needs::Analysis, selection::selection_range)
        }
        "textDocument/codeAction" => or_project_file(
            document::<lsp::CodeActionRequest>(Needs::Findings, code_actions::code_action),
            |snapshot, params| Ok(offered::in_project_file(snapshot, params).unwrap_or_default()),
        ),
        "codeAction/resolve" => document::<lsp::CodeActionResolveRequest>(Needs::Analysis, code_actions::resolve),
        "textDocument/semanticTokens/full" => {
            document::<lsp::SemanticTokensRequest>(Needs::Analysis, semantic_tokens::full)
        }
        "textDocument/semanticTokens/range" => {
            document::<lsp::SemanticTokensRangeRequest>(Needs::Analysis, semantic_tokens::range)
        }
        "textDocument/definition" => document::<lsp::DefinitionRequest>(Needs::Everything, definition::definition),
        "textDocument/declaration" => document::<lsp::DeclarationRequest>(Needs::Everything, definition::declaration),
        "textDocument/references" => document::<lsp::ReferencesRequest>(Needs::Everything, references::references),
        "textDocument/documentHighlight" => {
            document::<lsp::DocumentHighlightRequest>(Needs::Everything, references::highlight)
        }
        "textDocument/prepareRename" => document::<lsp::PrepareRenameRequest>(Needs::Findings, rename::prepare),
        "textDocument/rename" => document::<lsp::RenameRequest>(Needs::Findings, rename::rename),
        "textDocument/documentLink" => document::<lsp::DocumentLinkRequest>(Needs::Analysis, links::document_links),
        "textDocument/prepareCallHierarchy" => {
            document::<lsp::CallHierarchyPrepareRequest>(Needs::Everything, hierarchy::prepare)
        }
        _ => return None,
    })
}

/// The handler of a request about all documents and files.
fn of_workspace(method: &str) -> Option<Handler> {
    use gen_lsp_types as lsp;
    Some(match method {
        "workspace/symbol" => {
            workspace::<lsp::WorkspaceSymbolRequest>(Needs::Nothing, workspace_symbols::workspace_symbol)
        }
        "workspace/diagnostic" => untyped_workspace(workspace_findings::workspace_diagnostic),
        "workspace/willRenameFiles" => untyped_workspace(workspace::will_rename_files),
        "workspace/executeCommand" => workspace::<lsp::ExecuteCommandRequest>(Needs::Nothing, commands::execute),
        "callHierarchy/incomingCalls" => {
            workspace::<lsp::CallHierarchyIncomingCallsRequest>(Needs::Everything, hierarchy::incoming)
        }
        "callHierarchy/outgoingCalls" => {
            workspace::<lsp::CallHierarchyOutgoingCallsRequest>(Needs::Everything, hierarchy::outgoing)
        }
        "workspace/textDocumentContent" => {
            workspace::<lsp::TextDocumentContentRequest>(Needs::Nothing, explain::text_document_content)
        }
        _ => return None,
    })
}

/// A request about one program or macrocycle. In other documents its result is null.
fn document<R: Request>(needs: Needs, answer: fn(&Snapshot, &Analysis, R::Params) -> Answer<R::Result>) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| {
        let params = parameters::<R>(params)?;
        match &snapshot.analysis {
            Some(analysis) => result::<R>(answer(snapshot, analysis, params)?),
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

/// A request about one program or macrocycle whose parameters and result are taken as JSON.
fn untyped(needs: Needs, answer: fn(&Snapshot, &Analysis, &Value) -> Answer<Value>) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| match &snapshot.analysis {
        Some(analysis) => Ok(answer(snapshot, analysis, &params)?.to_string()),
        None => Ok(NULL.to_owned()),
    };
    Handler { needs, run: Box::new(run) }
}

/// A request about everything whose parameters and result are taken as JSON.
fn untyped_workspace(answer: fn(&Snapshot, &Value) -> Answer<Value>) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| Ok(answer(snapshot, &params)?.to_string());
    Handler { needs: Needs::Nothing, run: Box::new(run) }
}

/// A request about everything.
fn workspace<R: Request>(needs: Needs, answer: fn(&Snapshot, R::Params) -> Answer<R::Result>) -> Handler {
    let run = move |snapshot: &Snapshot, params: Value| result::<R>(answer(snapshot, parameters::<R>(params)?)?);
    Handler { needs, run: Box::new(run) }
}

fn parameters<R: Request>(params: Value) -> Answer<R::Params> {
    serde_json::from_value(params).map_err(Refusal::wrong_params)
}

fn result<R: Request>(result: R::Result) -> Answer<String> {
    serde_json::to_string(&result)
        .map_err(|error| Refusal { code: ErrorCode::InternalError, message: error.to_string() })
}
