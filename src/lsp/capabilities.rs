//! The capabilities of the server.

use gen_lsp_types::{
    CallHierarchyProvider, CodeActionKind, CodeActionOptions, CodeActionProvider, CodeLensOptions, CompletionOptions,
    DeclarationProvider, DefinitionProvider, DiagnosticOptions, DiagnosticProvider, DocumentFormattingProvider,
    DocumentHighlightProvider, DocumentLinkOptions, DocumentOnTypeFormattingOptions, DocumentRangeFormattingProvider,
    ExecuteCommandOptions, HoverProvider, PositionEncodingKind, ReferencesProvider, RenameOptions, RenameProvider,
    SemanticTokensProvider, ServerCapabilities, SignatureHelpOptions, TextDocumentSync, TextDocumentSyncKind,
    TextDocumentSyncOptions, WorkDoneProgressOptions,
};
use serde_json::{Value, json};

use super::client::Client;
use super::code_actions::{FIX_ALL, RENUMBER};
use super::commands::STREAM;
use super::completion::TRIGGERS;
use super::findings::SCHEME;
use super::{semantic_tokens, signature};
use crate::config::EXTENSIONS;
use crate::text::ColumnUnit;

/// The capabilities for that client.
pub(super) fn capabilities(client: &Client) -> Value {
    let capabilities = ServerCapabilities {
        position_encoding: Some(match client.unit {
            ColumnUnit::Bytes => PositionEncodingKind::UTF8,
            ColumnUnit::Utf16 => PositionEncodingKind::UTF16,
            ColumnUnit::Characters => PositionEncodingKind::UTF32,
        }),
        text_document_sync: Some(TextDocumentSync::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::Incremental),
            save: Some(true.into()),
            ..TextDocumentSyncOptions::default()
        })),
        code_lens_provider: Some(CodeLensOptions::default()),
        inlay_hint_provider: Some(true.into()),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(TRIGGERS.map(str::to_owned).to_vec()),
            ..CompletionOptions::default()
        }),
        document_formatting_provider: Some(DocumentFormattingProvider::Bool(true)),
        document_range_formatting_provider: Some(DocumentRangeFormattingProvider::Bool(true)),
        document_on_type_formatting_provider: Some(DocumentOnTypeFormattingOptions {
            first_trigger_character: "\n".to_owned(),
            more_trigger_character: None,
        }),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: Some(signature::TRIGGERS.map(str::to_owned).to_vec()),
            ..SignatureHelpOptions::default()
        }),
        hover_provider: Some(HoverProvider::Bool(true)),
        document_symbol_provider: Some(true.into()),
        workspace_symbol_provider: Some(true.into()),
        folding_range_provider: Some(true.into()),
        selection_range_provider: Some(true.into()),
        code_action_provider: Some(CodeActionProvider::CodeActionOptions(CodeActionOptions {
            code_action_kinds: Some(vec![
                CodeActionKind::QuickFix,
                CodeActionKind::Custom(FIX_ALL.into()),
                CodeActionKind::Custom(RENUMBER.into()),
            ]),
            resolve_provider: Some(true),
            ..CodeActionOptions::default()
        })),
        semantic_tokens_provider: Some(SemanticTokensProvider::SemanticTokensOptions(semantic_tokens::options())),
        execute_command_provider: Some(ExecuteCommandOptions {
            commands: vec![STREAM.to_owned()],
            ..ExecuteCommandOptions::default()
        }),
        definition_provider: Some(DefinitionProvider::Bool(true)),
        declaration_provider: Some(DeclarationProvider::Bool(true)),
        references_provider: Some(ReferencesProvider::Bool(true)),
        document_highlight_provider: Some(DocumentHighlightProvider::Bool(true)),
        rename_provider: Some(if client.has("/textDocument/rename/prepareSupport") {
            RenameProvider::RenameOptions(RenameOptions {
                prepare_provider: Some(true),
                work_done_progress_options: WorkDoneProgressOptions::default(),
            })
        } else {
            RenameProvider::Bool(true)
        }),
        call_hierarchy_provider: Some(CallHierarchyProvider::Bool(true)),
        document_link_provider: Some(DocumentLinkOptions::default()),
        diagnostic_provider: Some(DiagnosticProvider::DiagnosticOptions(DiagnosticOptions {
            identifier: Some("cnc872c".to_owned()),
            inter_file_dependencies: true,
            workspace_diagnostics: true,
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        ..ServerCapabilities::default()
    };
    let mut capabilities = serde_json::to_value(capabilities).unwrap_or_default();
    if let Some(capabilities) = capabilities.as_object_mut() {
        capabilities.insert("workspace".to_owned(), workspace());
    }
    capabilities
}

/// The capabilities about folders and files.
fn workspace() -> Value {
    json!({
        "workspaceFolders": { "supported": true, "changeNotifications": true },
        "fileOperations": {
            "willRename": { "filters": [{ "pattern": { "glob": "**/[lL][0-9]*" } }] },
        },
        "textDocumentContent": { "schemes": [SCHEME] },
    })
}

/// The watchers that the client should register: for files that findings depend on and that other programs change.
pub(super) fn registrations() -> Value {
    let extensions = ["xml", "mrc"].iter().chain(EXTENSIONS).map(|extension| {
        let either = |letter: char| format!("[{letter}{}]", letter.to_ascii_uppercase());
        format!("**/*.{}", extension.chars().map(either).collect::<String>())
    });
    let globs = ["**/cnc872c.toml", "**/[lL][0-9]*"].map(str::to_owned).into_iter().chain(extensions);
    let watchers: Vec<Value> = globs.map(|glob| json!({ "globPattern": glob })).collect();
    json!({
        "registrations": [{
            "id": "files",
            "method": "workspace/didChangeWatchedFiles",
            "registerOptions": { "watchers": watchers },
        }],
    })
}
