//! What kind of client an editor is.

use cnc872c::dict::Lang;
use cnc872c::text::ColumnUnit;
use serde_json::{Value, json};

/// The client that a script chooses.
#[derive(Clone, Copy)]
pub struct Kind {
    pub client: u8,
    pub way: u8,
}

impl Kind {
    pub fn unit(self) -> ColumnUnit {
        match self.client & 3 {
            1 => ColumnUnit::Bytes,
            2 => ColumnUnit::Characters,
            _ => ColumnUnit::Utf16,
        }
    }

    pub fn pulls(self) -> bool {
        self.client & 4 != 0
    }

    pub fn configures(self) -> bool {
        self.client & 8 != 0
    }

    /// Waits for every answer before the next step.
    pub fn is_steady(self) -> bool {
        self.client & 0x40 != 0
    }

    /// Leaves without waiting.
    pub fn is_hasty(self) -> bool {
        self.way & 4 != 0
    }

    pub fn compares(self) -> bool {
        self.way & 8 != 0
    }

    pub fn locale(self) -> Lang {
        if self.way & 16 != 0 { Lang::Cs } else { Lang::En }
    }

    pub fn rooted(self) -> bool {
        self.way & 32 == 0
    }

    pub fn initialize(self, options: &Value) -> Value {
        let rich = self.client & 0x20 != 0;
        let encodings = match self.client & 3 {
            0 => Value::Null,
            1 => json!(["utf-16", "utf-8"]),
            2 => json!(["utf-32"]),
            _ => json!(["utf-16", "utf-32"]),
        };
        let mut capabilities = json!({
            "general": { "positionEncodings": encodings },
            "workspace": {
                "configuration": self.configures(),
                "didChangeWatchedFiles": { "dynamicRegistration": self.client & 0x10 != 0 },
                "diagnostics": { "refreshSupport": self.pulls() },
                "inlayHint": { "refreshSupport": rich },
                "codeLens": { "refreshSupport": rich },
                "workspaceEdit": { "documentChanges": rich },
            },
            "textDocument": {
                "codeAction": { "codeActionLiteralSupport": {}, "disabledSupport": rich },
                "rename": { "prepareSupport": rich },
                "documentSymbol": { "hierarchicalDocumentSymbolSupport": rich },
                "definition": { "linkSupport": rich },
                "completion": { "completionItem": { "snippetSupport": rich } },
                "hover": { "contentFormat": if rich { json!(["markdown"]) } else { Value::Null } },
            },
        });
        if self.pulls() {
            capabilities["textDocument"]["diagnostic"] = json!({});
        }
        if rich && self.way & 64 != 0 {
            capabilities["textDocument"]["codeAction"]["resolveSupport"] = json!({ "properties": ["edit"] });
            capabilities["textDocument"]["codeAction"]["dataSupport"] = json!(true);
        }
        let folders = if self.rooted() { json!([{ "uri": "file:///w", "name": "w" }]) } else { Value::Null };
        json!({
            "locale": if self.locale() == Lang::Cs { "cs-CZ" } else { "en" },
            "capabilities": capabilities,
            "workspaceFolders": folders,
            "initializationOptions": options,
        })
    }
}
