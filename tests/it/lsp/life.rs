//! The life of a server: how it begins, what it makes of nonsense, how it ends.

use serde_json::{Value, json};

use super::Client;
use crate::cli::Place;

fn open(client: &mut Client, text: &str) {
    let document = json!({ "uri": "file:///p.nc", "languageId": "cnc872", "version": 1, "text": text });
    client.notify("textDocument/didOpen", json!({ "textDocument": document }));
}

fn hover() -> Value {
    json!({ "textDocument": { "uri": "file:///p.nc" }, "position": { "line": 1, "character": 5 } })
}

#[test]
fn an_orderly_life() {
    let (client, _) = Client::initialized(json!({ "capabilities": {} }));
    assert_eq!(client.end(), 0);
}

#[test]
fn a_client_that_is_gone() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    assert_eq!(client.exit_status(), 1);
    let mut client = Client::start();
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_status(), 1);
}

#[test]
fn requests_out_of_turn() {
    let mut client = Client::start();
    assert_eq!(client.request("textDocument/hover", hover())["error"]["code"], -32002);
    client.request("initialize", json!({ "capabilities": {} }));
    assert_eq!(client.request("initialize", json!({}))["error"]["code"], -32600);
    assert_eq!(client.request("textDocument/nonsense", json!({}))["error"]["code"], -32601);
    assert_eq!(client.request("textDocument/hover", json!({ "textDocument": 7 }))["error"]["code"], -32602);
    assert_eq!(client.request("textDocument/hover", hover())["error"]["code"], -32602, "not open");
    client.request("shutdown", Value::Null);
    assert_eq!(client.request("textDocument/hover", hover())["error"]["code"], -32600);
}

/// A message that makes no sense is answered, or named in the log, and the next one works.
#[test]
fn nonsense() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    client.write(b"Content-Length: 5\r\n\r\n{\"a\":");
    assert_eq!(
        client.wait("a refusal", |message| message["id"].is_null() && message["error"].is_object())["error"]["code"],
        -32700
    );
    client.send(&json!({ "jsonrpc": "2.0", "id": { "a": 1 }, "method": "textDocument/hover" }));
    assert_eq!(client.wait("a refusal", |message| message["id"] == json!({ "a": 1 }))["error"]["code"], -32600);
    client.notify(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": "file:///none", "version": 1 }, "contentChanges": [] }),
    );
    assert!(client.said("window/logMessage")["params"]["message"].as_str().unwrap().contains("not open"));
    client.notify("textDocument/didOpen", json!({ "textDocument": 1 }));
    client.said("window/logMessage");
    client.notify("$/unknown", json!({}));
    open(&mut client, "%1\nN10 G00\nN20 M30\n");
    assert_eq!(client.findings("file:///p.nc", Some(1)), json!([]));
    assert!(client.request("textDocument/hover", hover())["result"].is_object());
    assert_eq!(client.end(), 0);
}

/// Ranges that no text has change what is nearest, or nothing.
/// Whatever the parameters are, there is an answer.
#[test]
fn requests_without_a_document() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    for params in [json!(null), json!({}), json!({ "item": {} }), json!({ "item": 1, "textDocument": {} })] {
        for method in ["textDocument/diagnostic", "textDocument/hover", "callHierarchy/incomingCalls"] {
            assert!(client.request(method, params.clone())["error"].is_object(), "{method} {params}");
        }
    }
}

#[test]
fn changes_out_of_range() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    open(&mut client, "%1\nN10 G00\n");
    let at = |line: u32, character: u32| json!({ "line": line, "character": character });
    let changes = [
        json!({ "range": { "start": at(9, 9), "end": at(99, 1) }, "text": "N20 M30\n" }),
        json!({ "range": { "start": at(1, 99), "end": at(1, 0) }, "text": "" }),
        json!({ "range": { "start": at(4_000_000_000, 4_000_000_000u32), "end": at(0, 0) }, "text": "" }),
    ];
    let document = json!({ "uri": "file:///p.nc", "version": 2 });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    assert_eq!(client.findings("file:///p.nc", Some(2)), json!([]));
}

/// A cancelled request is answered at once, and once.
#[test]
fn cancelled() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    let long = "%1\nN10 G01 F100 X1\n".to_owned() + &"N20 G91 X1\n".repeat(200_000) + "N30 M30\n";
    open(&mut client, &long);
    let id = client.ask("textDocument/hover", hover());
    client.notify("$/cancelRequest", json!({ "id": id }));
    let answer = client.answer(id);
    assert!(answer["error"]["code"] == -32800 || answer["result"].is_object(), "{answer}");
    client.notify("$/cancelRequest", json!({ "id": id }));
    client.notify("$/cancelRequest", json!({ "id": "never" }));
    assert_eq!(client.end(), 0);
}

/// While one document takes long, another is answered.
#[test]
fn nothing_blocks() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    // Nested jumps: a hundred million blocks.
    let loops = "%2\nN1 G01 F100 X1\nN2 G73 L1 Q9999\nN3 G73 L1 Q9999\nN4 M30\n";
    let document = json!({ "uri": "file:///long.nc", "languageId": "cnc872", "version": 1, "text": loops });
    client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    open(&mut client, "%1\nN10 G00 X1\nN20 M30\n");
    assert!(client.request("textDocument/hover", hover())["result"].is_object());
    assert_eq!(client.findings("file:///p.nc", Some(1)), json!([]));
    let of_the_long = json!({ "textDocument": { "uri": "file:///long.nc" } });
    assert!(client.request("textDocument/documentSymbol", of_the_long)["result"].is_array(), "needs no execution");
}

/// One line of 20,000 blocks: it opens, changes and is formatted, each time with one answer about the whole.
#[test]
fn one_long_line() {
    const BLOCKS: u32 = 20_000;
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    let blocks: String = (2..=BLOCKS).map(|n| format!("N{n}0 X1 ")).collect();
    open(&mut client, &format!("%1\nN10 G00 X0 {blocks}N999999 M30\n"));
    let codes = |found: &Value| -> Vec<String> {
        found.as_array().unwrap().iter().map(|one| one["code"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(codes(&client.findings("file:///p.nc", Some(1))), ["E0109"], "it is long, and that is all");
    assert!(client.request("textDocument/hover", hover())["result"].is_object());
    // A second X in the first block, far before the others.
    let at = json!({ "line": 1, "character": 10 });
    let change = json!({ "range": { "start": at, "end": at }, "text": " X9" });
    let document = json!({ "uri": "file:///p.nc", "version": 2 });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    assert_eq!(codes(&client.findings("file:///p.nc", Some(2))), ["E0306", "E0109"]);
    let params =
        json!({ "textDocument": { "uri": "file:///p.nc" }, "options": { "tabSize": 4, "insertSpaces": true } });
    let edits = client.request("textDocument/formatting", params)["result"].clone();
    let lines: usize =
        edits.as_array().unwrap().iter().map(|edit| edit["newText"].as_str().unwrap().matches('\n').count()).sum();
    assert!(lines >= 20_000, "each block has a line of its own: {lines}");
    assert_eq!(client.end(), 0);
}

/// A change of a part whose place makes no sense is refused: it is no new text.
#[test]
fn a_change_without_a_place_is_refused() {
    let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
    open(&mut client, "%1\nN10 X1\nN30 M30\n");
    let document = json!({ "uri": "file:///p.nc", "version": 2 });
    let range = json!({ "start": { "line": -1, "character": 0 }, "end": { "line": 0, "character": 0 } });
    let change = json!({ "range": range, "text": "x" });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    assert!(client.said("window/logMessage")["params"]["message"].as_str().unwrap().contains("didChange: range"));
    assert!(client.request("textDocument/hover", hover())["result"].is_object(), "the text is the one that was opened");
    assert_eq!(client.end(), 0);
}

/// A macrocycle that is not there can be made, by clients that create files.
#[test]
fn missing_macrocycles_are_created() {
    let workspace = json!({ "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create"] } });
    let literal = json!({ "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } });
    let capabilities = json!({ "workspace": workspace, "textDocument": { "codeAction": literal } });
    let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
    open(&mut client, "%1\nN10 G72 L9001\nN20 M30\n");
    let range = json!({ "start": { "line": 1, "character": 9 }, "end": { "line": 1, "character": 9 } });
    let params = json!({ "textDocument": { "uri": "file:///p.nc" }, "range": range, "context": { "diagnostics": [] } });
    let answer = client.request("textDocument/codeAction", params);
    let action = answer["result"].as_array().unwrap().iter().find(|one| one["title"] == "create macrocycle L9001");
    let changes = &action.unwrap()["edit"]["documentChanges"];
    assert_eq!(changes[0]["kind"], "create", "{changes}");
    assert_eq!(changes[0]["uri"], "file:///L9001");
    assert_eq!(changes[1]["edits"][0]["newText"], "N10 G79 L9001\nN20 G70\n");
}

/// A folder whose name is no UTF-8, as an old share has it, keeps no finding from its document.
#[cfg(target_os = "linux")]
#[test]
fn a_path_that_is_no_text() {
    for pull in [false, true] {
        let capabilities = if pull { json!({ "textDocument": { "diagnostic": {} } }) } else { json!({}) };
        let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
        let uri = "file:///parts/d%A7l/q.nc";
        let text = "%1\nN1 X5,1\nN2 M30\n";
        let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": text });
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        let found = if pull {
            client.request("textDocument/diagnostic", json!({ "textDocument": { "uri": uri } }))["result"]["items"]
                .clone()
        } else {
            client.findings(uri, Some(0))
        };
        assert_eq!(found[0]["code"], "E0104", "{pull}: {found}");
        assert_eq!(client.end(), 0);
    }
}

/// A text as it was (`git:`) has the path of the file, and is another document: findings and edits stay with their own.
#[test]
fn versions_of_a_file_are_documents_of_their_own() {
    let (file, git) = ("file:///parts/q.nc", "git:/parts/q.nc?ref=HEAD");
    let texts = [(file, "%1\nN1 G0 X1 X2\nN2 M30\n"), (git, "%1\nN1 g0 X1\nN2 M30\n")];
    for order in [[0, 1], [1, 0]] {
        let literal = json!({ "codeActionLiteralSupport": { "codeActionKind": { "valueSet": ["quickfix"] } } });
        let capabilities = json!({ "textDocument": { "codeAction": literal } });
        let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
        for (uri, text) in order.map(|at| texts[at]) {
            let document = json!({ "uri": uri, "languageId": "cnc872", "version": 1, "text": text });
            client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        }
        assert_eq!(client.findings(file, Some(1))[0]["code"], "E0306");
        assert_eq!(client.findings(git, Some(1))[0]["code"], "W0108");
        let line = json!({ "start": { "line": 1, "character": 0 }, "end": { "line": 1, "character": 8 } });
        let asked = json!({ "textDocument": { "uri": git }, "range": line, "context": { "diagnostics": [] } });
        let actions = client.request("textDocument/codeAction", asked).to_string();
        assert!(actions.contains(git) && !actions.contains(file), "{actions}");
        // What changes in one is nothing to the other.
        let change = |uri: &str, text: &str| json!({ "textDocument": { "uri": uri, "version": 2 }, "contentChanges": [{ "text": text }] });
        client.notify("textDocument/didChange", change(git, "%1\nN1 G0 X1\nN2 M30\n"));
        assert_eq!(client.findings(git, Some(2)), json!([]));
        client.notify("textDocument/didClose", json!({ "textDocument": { "uri": git } }));
        client.notify("textDocument/didChange", change(file, "%1\nN1 G0 Y1 Y2\nN2 M30\n"));
        assert_eq!(client.findings(file, Some(2))[0]["code"], "E0306");
        let symbols = client.request("textDocument/documentSymbol", json!({ "textDocument": { "uri": file } }));
        assert!(symbols["error"].is_null(), "{symbols}");
        assert_eq!(client.end(), 0);
    }
}

/// One change of a macrocycle makes the views and findings of all its callers old: the client is asked once.
#[test]
fn one_refresh_for_a_change() {
    let workspace = json!({
        "inlayHint": { "refreshSupport": true }, "codeLens": { "refreshSupport": true },
        "diagnostics": { "refreshSupport": true },
    });
    let capabilities = json!({ "workspace": workspace, "textDocument": { "diagnostic": {} } });
    let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
    let open = |client: &mut Client, name: &str, text: &str| {
        let document =
            json!({ "uri": format!("file:///refresh/{name}"), "languageId": "cnc872", "version": 1, "text": text });
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    };
    let pull = |client: &mut Client, name: &str| {
        let uri = format!("file:///refresh/{name}");
        client.request("textDocument/diagnostic", json!({ "textDocument": { "uri": uri } }))
    };
    open(&mut client, "L9001", "N1 G79 L9001\nN2 X1\nN3 G70\n");
    for number in 0..8 {
        open(&mut client, &format!("{number}.nc"), "%1\nN1 G00 X0\nN2 G72 L9001\nN3 M30\n");
    }
    for number in 0..8 {
        pull(&mut client, &format!("{number}.nc"));
    }
    let hover =
        || json!({ "textDocument": { "uri": "file:///refresh/L9001" }, "position": { "line": 1, "character": 3 } });
    client.request("textDocument/hover", hover());
    client.said_so_far("refresh");
    let at = json!({ "line": 1, "character": 4 });
    let change = json!({ "range": { "start": at, "end": at }, "text": "2" });
    let document = json!({ "uri": "file:///refresh/L9001", "version": 2 });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    for number in 0..8 {
        pull(&mut client, &format!("{number}.nc"));
    }
    client.request("textDocument/hover", hover());
    let mut said = client.said_so_far("refresh");
    said.sort();
    assert_eq!(said, ["codeLens", "diagnostic", "inlayHint"].map(|what| format!("workspace/{what}/refresh")));
}

/// Documents in a folder of the disk.
struct Folder {
    place: Place,
    client: Client,
}

impl Folder {
    fn with(files: &[(&str, &[u8])]) -> Self {
        let (client, _) = Client::initialized(json!({ "capabilities": {} }));
        Self { place: Place::with(files), client }
    }

    fn uri(&self, name: &str) -> String {
        format!("file://{}", self.place.path(name).canonicalize().unwrap().display())
    }

    fn open(&mut self, name: &str, text: &str) {
        let document = json!({ "uri": self.uri(name), "languageId": "cnc872", "version": 1, "text": text });
        self.client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    fn codes(&mut self, name: &str) -> Vec<Value> {
        let params = json!({ "textDocument": { "uri": self.uri(name) } });
        let items = self.client.request("textDocument/diagnostic", params)["result"]["items"].clone();
        items.as_array().unwrap().iter().map(|item| item["code"].clone()).collect()
    }
}

/// A program is read anew when a macrocycle changes while it is read for the first time: until then nobody knows which
/// files it reads.
#[test]
fn a_macrocycle_that_changes_while_its_program_is_read() {
    let good = "N10 G79 L9001\nN20 G00 X0 Y0\nN25 G02 X10 Y0 I5 J0 F100\nN30 G70\n";
    let wrong = good.replace("I5", "I4");
    let moves: String = (0..20_000).map(|index| format!("N{} G01 X{index} F100\n", index + 20)).collect();
    let program = format!("%2\nN10 G72 L9001\n{moves}N999999 M30\n");
    for (pause, (first, then, expected)) in [0, 20, 60, 120, 250]
        .into_iter()
        .flat_map(|pause| [(pause, (good, wrong.as_str(), 1)), (pause, (wrong.as_str(), good, 0))])
    {
        let mut folder = Folder::with(&[("L9001", first.as_bytes()), ("b.nc", program.as_bytes())]);
        folder.open("L9001", first);
        assert_eq!(folder.codes("L9001"), [Value::Null; 0]);
        folder.open("b.nc", &program);
        std::thread::sleep(std::time::Duration::from_millis(pause));
        let document = json!({ "uri": folder.uri("L9001"), "version": 2 });
        let params = json!({ "textDocument": document, "contentChanges": [{ "text": then }] });
        folder.client.notify("textDocument/didChange", params);
        assert_eq!(folder.codes("b.nc"), [Value::Null; 0]);
        let found = folder.codes("L9001");
        assert_eq!(found.iter().filter(|code| *code == "E0603").count(), expected, "after {pause} ms: {found:?}");
    }
}

/// The same while a program is executed: which macrocycles parameters and cycles lead to is known at the end.
#[test]
fn a_macrocycle_that_changes_while_its_program_is_executed() {
    let call = "%1\nN1 R3=1 F100 S100 M03 G00 X0 Y0 Z0\nN2 X1\nN3 G73 L2 Q9999\nN4 G73 L2 Q40\n";
    let programs = [("N10 G72 LR3\n", ""), ("N10 R4=72\nN11 GR4 L1\n", ""), ("N10 G81 X5\n", "[cycles]\nG81 = 1\n")];
    let macrocycle = |body: &str| format!("N10 G79 L1\n{body}N30 G70\n");
    for (last, configuration) in programs {
        let program = format!("{call}{last}N20 G80 M30\n");
        let first = macrocycle("N20 R25=5\n");
        let configuration = ("cnc872c.toml", configuration.as_bytes());
        let files = [("L1", first.as_bytes()), ("a.nc", program.as_bytes()), configuration];
        let mut folder = Folder::with(&files);
        folder.open("L1", &first);
        folder.open("a.nc", &program);
        assert_eq!(folder.codes("L1"), [Value::Null; 0]);
        let texts = [macrocycle("N20 R25=5 G73 L30 Q\n"), macrocycle("N20 R25=50000 G73 L30 QR25\nN25 QR26 G73 L30\n")];
        for (version, text) in (2..).zip(texts) {
            let document = json!({ "uri": folder.uri("L1"), "version": version });
            let params = json!({ "textDocument": document, "contentChanges": [{ "text": text }] });
            folder.client.notify("textDocument/didChange", params);
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        folder.codes("a.nc");
        assert_eq!(folder.codes("L1"), ["W0503", "W0504", "W0503"], "{last}");
    }
}

/// Editors take a byte-order mark off: places in files that are not open count from behind it.
#[test]
fn a_byte_order_mark() {
    let macrocycle = "\u{feff}N10 G79 L9001 \"m\"\nN20 G70\n";
    let mut folder = Folder::with(&[("L9001", macrocycle.as_bytes()), ("a.nc", b"%1\n")]);
    folder.open("a.nc", "%1\nN10 G72 L9001\nN20 M30\n");
    let position = json!({ "line": 1, "character": 10 });
    let params = json!({ "textDocument": { "uri": folder.uri("a.nc") }, "position": position });
    let answer = folder.client.request("textDocument/definition", params)["result"].clone();
    let place = if answer.is_array() { answer[0].clone() } else { answer };
    assert_eq!(place["uri"], folder.uri("L9001"));
    let range = json!({ "start": { "line": 0, "character": 9 }, "end": { "line": 0, "character": 13 } });
    assert_eq!(place["range"], range);
}

/// What the editor says of a place in a long program is what `state` says, times too, with and without `[motion]`.
#[test]
fn state_of_a_long_program() {
    let text = "%3\nN10 G90 G24 G01 X0 F1000\nN20 X1\nN30 X0\nN40 G73 L20 Q999\nN50 G73 L20 Q39\nN60 M30\n";
    for project in ["", "[motion]\naccel-mm-s2 = 300.0\n"] {
        let mut folder = Folder::with(&[("a.nc", text.as_bytes()), ("cnc872c.toml", project.as_bytes())]);
        folder.open("a.nc", text);
        let params =
            json!({ "textDocument": { "uri": folder.uri("a.nc") }, "position": { "line": 6, "character": 0 } });
        let mut answer = folder.client.request("cnc872c/state", params)["result"]["state"].take();
        let run = folder.place.run(&["state", "a.nc", "--n", "60", "--format", "json"]).ends(0);
        let mut expected: Value = serde_json::from_str(&run.stdout).unwrap();
        for state in [&mut answer, &mut expected] {
            state["name"].take();
        }
        assert!(expected["progress"]["blocks"].as_u64() > Some(100_000) && expected["progress"]["time_s"].is_f64());
        assert_eq!(answer, expected);
    }
}
