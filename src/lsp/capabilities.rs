//! What the server says it can do.

use gen_lsp_types::{
    DiagnosticOptions, DiagnosticProvider, HoverProvider, PositionEncodingKind, ServerCapabilities, TextDocumentSync,
    TextDocumentSyncKind, TextDocumentSyncOptions, WorkDoneProgressOptions,
};
use serde_json::{Value, json};

use super::client::Client;
use super::findings::SCHEME;
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
        hover_provider: Some(HoverProvider::Bool(true)),
        diagnostic_provider: Some(DiagnosticProvider::DiagnosticOptions(DiagnosticOptions {
            identifier: Some("cnc872c".to_owned()),
            inter_file_dependencies: true,
            workspace_diagnostics: false,
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        ..ServerCapabilities::default()
    };
    let mut capabilities = serde_json::to_value(capabilities).unwrap_or_default();
    if let Some(capabilities) = capabilities.as_object_mut() {
        capabilities.insert(
            "workspace".to_owned(),
            json!({
                "workspaceFolders": { "supported": true, "changeNotifications": true },
                "textDocumentContent": { "schemes": [SCHEME] },
            }),
        );
    }
    capabilities
}

/// What the client is asked to watch: files that findings depend on and that other programs change.
pub(super) fn registrations() -> Value {
    let globs = ["**/cnc872c.toml", "**/*.[xX][mM][lL]", "**/*.{nc,NC,ncp,NCP,mrc,MRC}", "**/[lL][0-9]*"];
    let watchers: Vec<Value> = globs.iter().map(|glob| json!({ "globPattern": glob })).collect();
    json!({
        "registrations": [{
            "id": "files",
            "method": "workspace/didChangeWatchedFiles",
            "registerOptions": { "watchers": watchers },
        }],
    })
}
