//! Changes that the server offers for every sample: renumbering keeps what the program does, fixing all is what `check
//! --fix` does.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::config::{configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::dict::Address;
use cnc872c::edit::apply_fixes;
use cnc872c::session::Session;
use cnc872c::syntax::{Form, ParsedFile, Word, parse};
use cnc872c::text::{FileId, Loader, SourceText, Sources};
use serde_json::{Value, json};

use super::Client;
use super::scenario::apply;
use crate::disk::TestDisk;
use crate::disk::files;
use crate::markers::Request;
use crate::run::{Run, run};
use crate::samples::root;

/// Samples that keep their numbers, and why.
const REFUSED: [(&str, &str); 28] = [
    ("err/E0201-missing-program-start.nc", "there are no blocks"),
    ("err/E0205-no-block.nc", "there are no blocks"),
    ("err/E0304-decimal-point-not-allowed.nc", "the number of the block in line 11 cannot be read"),
    ("err/E0305-sign-not-allowed.nc", "the number of the block in line 14 cannot be read"),
    ("err/E0406-unknown-jump-target.nc", "it is not clear where the jump in line 5 leads"),
    ("err/E0407-jump-out-of-unit.nc", "it is not clear where the jump in line 5 leads"),
    ("err/E0511-parameter-not-allowed.nc", "the number of the block in line 4 cannot be read"),
    ("err/W0113-other-control.nc", "there are no blocks"),
    ("flw-namesakes/program.nc", "it is not clear where the jump in line 4 leads"),
    ("flw-parameter-macrocycle/L9085", "it is not clear where the jump in line 3 leads"),
    ("functions-by-parameter/program.nc", "line 10 jumps depends on a parameter"),
    ("rules/adr-ranges.nc", "the number of the block in line 2 cannot be read"),
    ("rules/edges-every-error.nc", "it is not clear where the jump in line 15 leads"),
    ("rules/edges-unknown-functions.nc", "line 19 jumps depends on a parameter"),
    ("rules/edges-unread-structure.nc", "the number of the block in line 8 cannot be read"),
    ("rules/flw-foreign.nc", "it is not clear where the jump in line 4 leads"),
    ("rules/flw-jump-next-unit.nc", "it is not clear where the jump in line 3 leads"),
    ("rules/flw-target-parameter.nc", "line 3 jumps depends on a parameter"),
    ("rules/flw-target-read-limit.nc", "line 7 jumps depends on a parameter"),
    ("rules/flw-target-read.nc", "line 7 jumps depends on a parameter"),
    ("rules/flw-targets.nc", "it is not clear where the jump in line 4 leads"),
    ("rules/lex-small-l.nc", "line 4 jumps depends on a parameter"),
    ("rules/par-late-end.nc", "line 3 jumps depends on a parameter"),
    ("rules/par-late-jump.nc", "line 3 jumps depends on a parameter"),
    ("rules/par-late-target.nc", "line 3 jumps depends on a parameter"),
    ("rules/par-late-words.nc", "line 5 jumps depends on a parameter"),
    ("rules/par-not-static.nc", "line 3 jumps depends on a parameter"),
    ("rules/prg-unused-jump-parameter.nc", "line 3 jumps depends on a parameter"),
];

/// A folder with one file changed.
struct Changed {
    disk: TestDisk,
    file: String,
    text: String,
}

impl Loader for Changed {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == Path::new(&self.file) { Ok(self.text.clone().into_bytes()) } else { self.disk.read(path) }
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.disk.canonical(path)
    }
}

/// A program or macrocycle among the samples, by its project's folder.
struct Sample {
    folder: PathBuf,
    file: String,
    text: String,
}

impl Sample {
    fn all() -> Vec<Self> {
        let mut samples = Vec::new();
        for folder in ["samples/ok", "samples/err", "samples/rules", "samples/projects", "docs/guide/examples"] {
            for path in files(&root().join(folder)) {
                let name = path.to_string_lossy().into_owned();
                if name.ends_with(".nc") || Session::is_macrocycle_name(&path) {
                    samples.push(Self::read(&path));
                }
            }
        }
        samples
    }

    fn read(path: &Path) -> Self {
        let above = path.ancestors().skip(1).find(|folder| folder.join("cnc872c.toml").is_file());
        let folder = above.filter(|folder| *folder != root()).unwrap_or(path.parent().unwrap()).to_path_buf();
        let file = path.strip_prefix(&folder).unwrap().to_string_lossy().replace('\\', "/");
        let disk = TestDisk { root: folder.clone() };
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let project = find_project(Path::new(""), &disk);
        let settings = configure(project.as_deref(), &Default::default(), &disk, &mut sources, &mut findings);
        let source = SourceText::decode("", fs::read(path).unwrap(), settings.encoding).unwrap();
        Self { folder, file, text: source.text().to_owned() }
    }

    fn uri(&self) -> String {
        let path = fs::canonicalize(self.folder.join(&self.file)).unwrap();
        format!("file://{}", path.display().to_string().replace(' ', "%20"))
    }

    fn run(&self, text: &str, compile: bool) -> Run {
        let disk = TestDisk { root: self.folder.clone() };
        let loader = Changed { disk, file: self.file.clone(), text: text.to_owned() };
        run(&loader, &self.file, &Request { compile, ..Request::default() })
    }

    fn is_macrocycle(&self) -> bool {
        Session::is_macrocycle_name(Path::new(&self.file))
    }

    fn parse(&self, text: &str) -> ParsedFile {
        let form = if self.is_macrocycle() { Form::Macrocycle } else { Form::Program };
        parse(FileId(0), &Arc::new(SourceText::from_text("", text)), form, &mut Findings::new())
    }

    /// The findings in the sample itself: the code, and which word they begin at. Renumbering corrects numbers of
    /// blocks: findings about these are left out.
    fn found(&self, text: &str) -> Vec<(String, usize)> {
        let parsed = self.parse(text);
        let words: Vec<Word> = parsed.all_words().collect();
        let run = self.run(text, false);
        let own = run.report.sources().find(&self.file);
        let items = run.report.items().filter(|item| Some(item.diagnostic.at.file) == own);
        items
            .map(|item| {
                let word = words.partition_point(|word| word.start() <= item.diagnostic.at.span.start);
                (item.diagnostic.code().to_string(), word)
            })
            .filter(|(code, word)| {
                let number = word.checked_sub(1).is_some_and(|at| words[at].address == Address::N);
                !(number && ["E0204", "E0302", "E0304", "E0305"].contains(&code.as_str()))
            })
            .collect()
    }
}

/// A server with one document open.
struct Server {
    client: Client,
    version: i64,
}

impl Server {
    fn start() -> Self {
        let action = json!({
            "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } },
            "disabledSupport": true,
        });
        let (client, _) = Client::initialized(json!({ "capabilities": { "textDocument": { "codeAction": action } } }));
        Self { client, version: 1 }
    }

    fn open(&mut self, sample: &Sample) {
        let document = json!({ "uri": sample.uri(), "languageId": "cnc872", "version": 1, "text": sample.text });
        self.version = 1;
        self.client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    fn change(&mut self, sample: &Sample, text: &str) {
        self.version += 1;
        let document = json!({ "uri": sample.uri(), "version": self.version });
        let changes = json!([{ "text": text }]);
        self.client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    fn close(&mut self, sample: &Sample) {
        self.client.notify("textDocument/didClose", json!({ "textDocument": { "uri": sample.uri() } }));
    }

    /// The one action of that kind.
    fn action(&mut self, sample: &Sample, kind: &str) -> Option<Value> {
        let start = json!({ "line": 0, "character": 0 });
        let params = json!({
            "textDocument": { "uri": sample.uri() },
            "range": { "start": start, "end": start },
            "context": { "diagnostics": [], "only": [kind] },
        });
        let answer = self.client.request("textDocument/codeAction", params);
        let actions = answer["result"].as_array().unwrap_or_else(|| panic!("{answer}"));
        assert!(actions.len() < 2);
        actions.first().cloned()
    }
}

/// The text after an action's edits.
fn edited(sample: &Sample, action: &Value) -> String {
    let edits = action["edit"]["changes"][&sample.uri()].as_array().unwrap();
    let change = |edit: &Value| json!({ "range": edit["range"], "text": edit["newText"] });
    let changes: Vec<Value> = edits.iter().rev().map(change).collect();
    // A text of lines that end with CR alone has no lines for `apply`.
    let mut text = sample.text.clone();
    apply(&mut text, &changes);
    text
}

/// A record with the numbers of the program's own blocks replaced, and without lines and columns.
fn normal(mut record: Value, numbers: &BTreeMap<u64, u64>) -> Value {
    let new = |n: &mut Value| {
        if let Some(number) = n.as_u64().and_then(|n| numbers.get(&n)) {
            *n = json!(number);
        }
    };
    for call in record["calls"].as_array_mut().into_iter().flatten() {
        if call["file"] == 0 {
            new(&mut call["n"]);
        }
    }
    if let Some(block) = record.as_object_mut().filter(|record| record["kind"] == "block") {
        if block["file"] == 0 {
            new(&mut block["n"]);
            block.remove("line");
            block.remove("column");
            if let Some(jump) = block.get_mut("jump") {
                new(&mut jump["to"]);
            }
        }
    } else if record["calls"].is_null() {
        record.as_object_mut().unwrap().remove("calls");
    }
    record
}

/// Codes of what could not be read.
const UNREAD: [&str; 10] = ["E0101", "E0102", "E0103", "E0104", "E0105", "E0106", "E0107", "E0111", "E0115", "E0203"];

#[test]
fn renumbering_keeps_what_the_program_does() {
    let mut server = Server::start();
    let mut refused = BTreeMap::new();
    let mut renumbered = 0;
    for sample in Sample::all() {
        let name = format!("{}/{}", sample.folder.file_name().unwrap().display(), sample.file);
        if sample.text.contains('\r') && !sample.text.contains('\n') {
            continue;
        }
        server.open(&sample);
        let Some(action) = server.action(&sample, "source.renumber") else { panic!("{name}: no action") };
        let disabled = action["disabled"]["reason"].as_str();
        // REN-5: what cannot be read cannot be renumbered.
        let unread = sample.found(&sample.text).iter().any(|(code, _)| UNREAD.contains(&code.as_str()));
        let is_said = |reason: &str| reason.starts_with("line ") && reason.contains(" cannot be read (");
        assert_eq!(disabled.is_some_and(is_said), unread, "{name}: {disabled:?}");
        if let Some(reason) = disabled.filter(|_| unread) {
            assert!(UNREAD.iter().any(|code| reason.ends_with(&format!("({code})"))), "{name}: {reason}");
            server.close(&sample);
            continue;
        }
        if let Some(reason) = disabled {
            if reason != "the blocks have these numbers already" {
                // Which block and parameter it is, scenarios show.
                let jump = reason.strip_prefix("where ").and_then(|rest| rest.split_once(" in "));
                let reason = jump.map_or(reason, |(_, rest)| rest.split(':').next().unwrap());
                refused.insert(name, reason.to_owned());
            }
            server.close(&sample);
            continue;
        }
        renumbered += 1;
        let text = edited(&sample, &action);
        let (before, after) = (sample.parse(&sample.text), sample.parse(&text));
        let numbers =
            |file: &ParsedFile| -> Vec<u64> { file.block_ids().map(|block| file.shown_number(block).into()).collect() };
        let (old, new) = (numbers(&before), numbers(&after));
        assert_eq!(old.len(), new.len(), "{name}");
        assert!(new.windows(2).all(|pair| pair[1] - pair[0] == new[0]), "{name}: {new:?}");
        let numbers: BTreeMap<u64, u64> = old.into_iter().zip(new).collect();

        assert_eq!(sample.found(&sample.text), sample.found(&text), "{name}:\n{text}");
        let duplicates = numbers.len() < before.block_count() as usize;
        if !sample.is_macrocycle() && !duplicates {
            let records = |text, numbers| -> Vec<Value> {
                sample.run(text, true).records().into_iter().map(|record| normal(record, numbers)).collect()
            };
            assert!(records(&sample.text, &numbers) == records(&text, &BTreeMap::new()), "{name}");
        }
        server.change(&sample, &text);
        let again = server.action(&sample, "source.renumber").unwrap();
        assert_eq!(again["disabled"]["reason"], "the blocks have these numbers already", "{name}");
        server.close(&sample);
    }
    assert!(renumbered > 50, "{renumbered}");
    let expected = REFUSED.map(|(name, why)| (name.to_owned(), why.to_owned()));
    assert_eq!(refused, BTreeMap::from(expected));
}

#[test]
fn fixing_all_is_check_fix() {
    let mut server = Server::start();
    let mut fixed = 0;
    for sample in Sample::all() {
        let mut expected = sample.text.clone();
        for _ in 0..16 {
            let run = sample.run(&expected, false);
            let source = SourceText::from_text("", expected.clone());
            let own = run.report.sources().find(&sample.file);
            let items = run.report.items().filter(|item| Some(item.diagnostic.at.file) == own);
            let fixes = items.filter_map(|item| item.diagnostic.fixes.first().filter(|fix| fix.certain.is_some()));
            let fixed = apply_fixes(&source, own.unwrap_or_default(), expected.as_bytes(), fixes);
            if fixed.applied.is_empty() {
                break;
            }
            expected = String::from_utf8(fixed.bytes).unwrap();
        }
        server.open(&sample);
        match server.action(&sample, "source.fixAll") {
            Some(action) => {
                fixed += 1;
                assert_eq!(edited(&sample, &action), expected, "{}", sample.file);
            }
            None => assert_eq!(sample.text, expected, "{}", sample.file),
        }
        server.close(&sample);
    }
    assert!(fixed > 10, "{fixed}");
}
