//! From executed blocks to what a page or a still picture is made of.

use std::ops::ControlFlow;
use std::sync::Arc;

use serde_json::{Map, Value, json};

use super::pack::{About, pack};
use super::rows::{Part, Rows};
use crate::config::Settings;
use crate::diag::{Findings, Report, Severity};
use crate::dict::Lang;
use crate::run::{End, Executed, Program, Sink};
use crate::text::{FileId, SourceText};

/// The picture of a program, as far as it was executed.
#[derive(Debug)]
pub struct View {
    pub(super) rows: Rows,
    program: Map<String, Value>,
    blocks: u64,
    whole: bool,
}

impl View {
    /// Nothing yet, of a program for that machine.
    pub fn new(settings: &Settings, part: Part) -> Self {
        let letters = settings.machine.axes.iter().map(|axis| axis.letter).collect();
        Self { rows: Rows::new(letters, part), program: program(settings), blocks: 0, whole: false }
    }

    /// Collects executed blocks into it.
    pub fn collect(&mut self) -> Collect<'_> {
        Collect { view: self }
    }

    /// What the run came to: the text of the program, which may not have been executed, and how many blocks were.
    pub fn finish(&mut self, program: Option<&Arc<SourceText>>, name: &str, executed: u64) {
        if let Some(source) = program {
            self.rows.files.add_text(source);
        }
        self.program.insert("name".to_owned(), json!(name));
        self.blocks = executed;
    }

    /// The data of the page: a deflated stream.
    pub fn data(&self, report: &Report) -> Vec<u8> {
        let findings = self.findings(report);
        let about = About {
            program: self.program.clone(),
            motion: None,
            blocks: self.blocks,
            whole: self.whole,
            findings,
            equidistant: None,
        };
        pack(&self.rows, about)
    }

    fn findings(&self, report: &Report) -> Vec<Value> {
        let one = |found: &crate::diag::Reported| {
            let diagnostic = &found.diagnostic;
            let mut item = Map::new();
            let mut put = |name: &str, value: Value| drop(item.insert(name.to_owned(), value));
            put("code", json!(diagnostic.code().as_str()));
            put("name", json!(diagnostic.code().name()));
            put(
                "severity",
                json!(match found.severity {
                    Severity::Error => "error",
                    Severity::Warning => "warning",
                }),
            );
            let message = |lang: Lang| diagnostic.finding.message(lang);
            put("message", json!({ "en": message(Lang::En), "cs": message(Lang::Cs) }));
            if let Some(source) = report.sources().get(diagnostic.at.file) {
                let place = source.line_column(diagnostic.at.span.start);
                put("line", json!(place.line));
                put("column", json!(place.column));
                match self.rows.files.index_of(source.name()) {
                    Some(index) => put("file", json!(index)),
                    None => put("path", json!(source.name())),
                }
            }
            Value::Object(item)
        };
        report.items().map(one).collect()
    }
}

/// What the header says of the program before it is executed.
fn program(settings: &Settings) -> Map<String, Value> {
    let axes = settings.machine.axes.iter().map(
        |axis| json!({ "letter": axis.letter.to_string(), "kind": if axis.rotary { "rotary" } else { "linear" } }),
    );
    let mut program = Map::new();
    program.insert("dialect".to_owned(), json!(settings.machine.dialect.name()));
    program.insert("axes".to_owned(), axes.collect());
    program.insert("block_skip".to_owned(), json!(settings.block_skip));
    program.insert("optional_stop".to_owned(), json!(settings.optional_stop));
    program.insert("number".to_owned(), json!(0));
    program
}

/// A reader of executed blocks that fills a [`View`].
#[derive(Debug)]
pub struct Collect<'v> {
    view: &'v mut View,
}

impl Sink for Collect<'_> {
    type Whole = ();

    fn begin(&mut self, start: &Program<'_>) {
        let Some(file) = start.resolved.file(FileId(0)) else { return };
        self.view.rows.files.add(0, file);
        let number = file.program.and_then(|word| word.whole()).unwrap_or_default();
        self.view.program.insert("number".to_owned(), json!(number));
        if let Some(title) = file.title {
            self.view.program.insert("title".to_owned(), json!(file.comment_text(title)));
        }
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.view.rows.add(block);
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) {
        self.view.whole = true;
    }
}
