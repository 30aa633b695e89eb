//! A language client that says what a test wants and waits for what comes back.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Longer than any answer takes, on any machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A running server and what it said.
pub struct Client {
    process: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// Messages that were passed over while another was waited for.
    kept: VecDeque<Value>,
    requests: i64,
    /// The capabilities that it declared.
    capabilities: Option<Value>,
}

impl Client {
    /// Starts a server and sends nothing yet.
    pub fn start() -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_cnc872c"))
            .args(["lsp", "--stdio"])
            .env("LC_ALL", "C")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut output = BufReader::new(process.stdout.take().unwrap());
        let (sender, messages) = channel();
        thread::spawn(move || {
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        Self { input: process.stdin.take(), process, messages, kept: VecDeque::new(), requests: 0, capabilities: None }
    }

    /// Starts a server and initializes it; its capabilities.
    pub fn initialized(params: Value) -> (Self, Value) {
        let mut client = Self::start();
        let result = client.request("initialize", params);
        client.notify("initialized", json!({}));
        let capabilities = result["result"]["capabilities"].clone();
        client.capabilities = Some(capabilities.clone());
        (client, capabilities)
    }

    /// Writes bytes as they are.
    pub fn write(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().unwrap();
        input.write_all(bytes).unwrap();
        input.flush().unwrap();
    }

    /// Sends a message.
    pub fn send(&mut self, message: &Value) {
        let content = message.to_string();
        self.write(format!("Content-Length: {}\r\n\r\n{content}", content.len()).as_bytes());
    }

    /// Sends a notification.
    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request; its id.
    ///
    /// # Panics
    /// When it is one that the server does not say it answers: no editor would send it.
    pub fn ask(&mut self, method: &str, params: Value) -> i64 {
        if let (Some(capabilities), Some(wanted)) = (&self.capabilities, capability(method)) {
            let said = capabilities.pointer(wanted).unwrap_or(&Value::Null);
            assert!(!matches!(said, Value::Null | Value::Bool(false)), "{method} without {wanted}");
        }
        self.requests += 1;
        self.send(&json!({ "jsonrpc": "2.0", "id": self.requests, "method": method, "params": params }));
        self.requests
    }

    /// The answer to the request of that id.
    pub fn answer(&mut self, id: i64) -> Value {
        self.wait(&format!("the answer to {id}"), |message| message["id"] == id && message.get("method").is_none())
    }

    /// Sends a request and waits for its answer.
    pub fn request(&mut self, method: &str, params: Value) -> Value {
        let id = self.ask(method, params);
        self.answer(id)
    }

    /// The next notification or request of the server of that method.
    pub fn said(&mut self, method: &str) -> Value {
        self.wait(method, |message| message["method"] == method)
    }

    /// The methods of all messages so far that end so; they are forgotten.
    #[allow(dead_code, reason = "the benchmark needs less")]
    pub fn said_so_far(&mut self, end: &str) -> Vec<String> {
        let method =
            |message: &Value| message["method"].as_str().filter(|method| method.ends_with(end)).map(str::to_owned);
        let said = self.kept.iter().filter_map(method).collect();
        self.kept.retain(|message| method(message).is_none());
        said
    }

    /// The findings of a document of that version (of a file that is not open: `None`), all older ones passed over.
    pub fn findings(&mut self, uri: &str, version: Option<i64>) -> Value {
        let message = self.wait(&format!("findings of {uri} {version:?}"), |message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == uri
                && message["params"].get("version").and_then(Value::as_i64) == version
        });
        message["params"]["diagnostics"].clone()
    }

    /// Drops the messages that nobody has asked for.
    #[allow(dead_code, reason = "for the tests")]
    pub fn forget(&mut self) {
        self.kept.clear();
    }

    /// The first message, of those kept and those to come, that is wanted.
    pub fn wait(&mut self, what: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.kept.iter().position(&wanted) {
            return self.kept.remove(at).unwrap();
        }
        let until = Instant::now() + PATIENCE;
        loop {
            match self.messages.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(message) if wanted(&message) => return message,
                Ok(message) => self.kept.push_back(message),
                Err(RecvTimeoutError::Timeout) => panic!("{what} did not come; came {:#?}", self.kept),
                Err(RecvTimeoutError::Disconnected) => panic!("the server ended before {what}: {:#?}", self.kept),
            }
        }
    }

    /// The server's process, for what the operating system knows of it.
    #[allow(dead_code, reason = "for the benchmark")]
    pub fn process_id(&self) -> u32 {
        self.process.id()
    }

    /// Ends the server as clients do; its exit status.
    pub fn end(mut self) -> i32 {
        self.request("shutdown", Value::Null);
        self.notify("exit", Value::Null);
        self.exit_status()
    }

    /// Closes the server's input; its exit status.
    pub fn exit_status(&mut self) -> i32 {
        self.input = None;
        self.process.wait().unwrap().code().unwrap()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The capability that a server declares for requests of that method; `None` for those that need none.
///
/// # Panics
/// Of a method that is not in the list.
fn capability(method: &str) -> Option<&'static str> {
    Some(match method {
        "textDocument/hover" => "/hoverProvider",
        "textDocument/signatureHelp" => "/signatureHelpProvider",
        "textDocument/codeLens" => "/codeLensProvider",
        "textDocument/inlayHint" => "/inlayHintProvider",
        "textDocument/completion" => "/completionProvider",
        "textDocument/formatting" => "/documentFormattingProvider",
        "textDocument/rangeFormatting" => "/documentRangeFormattingProvider",
        "textDocument/onTypeFormatting" => "/documentOnTypeFormattingProvider",
        "textDocument/documentSymbol" => "/documentSymbolProvider",
        "textDocument/foldingRange" => "/foldingRangeProvider",
        "textDocument/selectionRange" => "/selectionRangeProvider",
        "textDocument/codeAction" => "/codeActionProvider",
        "codeAction/resolve" => "/codeActionProvider/resolveProvider",
        "textDocument/semanticTokens/full" => "/semanticTokensProvider/full",
        "textDocument/semanticTokens/range" => "/semanticTokensProvider/range",
        "textDocument/definition" => "/definitionProvider",
        "textDocument/declaration" => "/declarationProvider",
        "textDocument/references" => "/referencesProvider",
        "textDocument/documentHighlight" => "/documentHighlightProvider",
        "textDocument/prepareRename" => "/renameProvider/prepareProvider",
        "textDocument/rename" => "/renameProvider",
        "textDocument/documentLink" => "/documentLinkProvider",
        "textDocument/diagnostic" => "/diagnosticProvider",
        "workspace/diagnostic" => "/diagnosticProvider/workspaceDiagnostics",
        "textDocument/prepareCallHierarchy" | "callHierarchy/incomingCalls" | "callHierarchy/outgoingCalls" => {
            "/callHierarchyProvider"
        }
        "workspace/symbol" => "/workspaceSymbolProvider",
        "workspace/willRenameFiles" => "/workspace/fileOperations/willRename",
        "workspace/executeCommand" => "/executeCommandProvider",
        "workspace/textDocumentContent" => "/workspace/textDocumentContent",
        "initialize" | "shutdown" | "textDocument/nonsense" => return None,
        own if own.starts_with("cnc872c/") => return None,
        other => panic!("{other}: what does a server say that answers it?"),
    })
}

fn read(output: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim().split_once(':') {
            Some((_, value)) => length = value.trim().parse().ok()?,
            None => break,
        }
    }
    let mut content = vec![0; length];
    output.read_exact(&mut content).ok()?;
    serde_json::from_slice(&content).ok()
}
