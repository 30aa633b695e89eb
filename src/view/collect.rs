//! From executed blocks to what a page or a still picture is made of.

use std::ops::ControlFlow;
use std::sync::Arc;

use serde_json::{Map, Value, json};

use super::files::Files;
use super::names::Naming;
use super::pack::{About, pack};
use super::picture::{Besides, Chain, Picture, Still, as_png, as_svg};
use super::rows::{Part, Rows};
use super::times::Times;
use crate::analysis::equidistant::Equidistant;
use crate::analysis::motion::{Basis, Model, Planner, Step, StepReader, machine};
use crate::config::Settings;
use crate::diag::{Findings, Report, Severity};
use crate::dict::Lang;
use crate::parallel::Fold;
use crate::run::{End, Executed, Program, Sink};
use crate::syntax::{Form, ParsedFile, parse};
use crate::text::{FileId, SourceText};

/// What a program is executed for whose picture is wanted: see [`Self::sink`].
#[derive(Debug)]
pub struct Collector {
    rows: Rows,
    reader: StepReader,
    planned: Fold<Step, (Planner, Times)>,
    equidistant: Equidistant,
    /// Whether nothing of the machine's motion is configured.
    assumed: bool,
    machine: Value,
    program: Map<String, Value>,
    whole: bool,
}

/// The picture of a program, as far as it was executed.
#[derive(Debug)]
pub struct View {
    rows: Rows,
    times: Times,
    equidistant: Equidistant,
    /// Whether nothing of the machine's motion is configured.
    assumed: bool,
    machine: Value,
    program: Map<String, Value>,
    /// What the page calls its files.
    names: Vec<String>,
    blocks: u64,
    whole: bool,
}

impl Collector {
    /// Nothing yet, of a program for that machine.
    pub fn new(settings: &Settings, part: Part) -> Self {
        let model = Model::of(settings);
        let times = Times::new(part.from, [model.accel, model.accel_rapid]);
        let planned = Fold::new("planner", (Planner::new(model, false), times), |(planner, times), step: &Step| {
            times.expect(step.motion.map_or(0.0, |motion| motion.dynamics.accel));
            planner.push(step, times);
        });
        Self {
            rows: Rows::new(&settings.machine.axes, part),
            reader: StepReader::new(settings),
            planned,
            equidistant: Equidistant::new(settings, true),
            assumed: !settings.machine.motion.configured,
            machine: machine_of(settings),
            program: program(settings),
            whole: false,
        }
    }

    /// Collects executed blocks.
    pub fn sink(&mut self) -> Collect<'_> {
        Collect { collector: self }
    }

    /// What the run came to: the text of the program, which may not have been executed, and how many blocks were.
    pub fn finish(self, text: Option<&Arc<SourceText>>, naming: Naming<'_>, executed: u64) -> View {
        let Self { mut rows, planned, equidistant, assumed, machine, mut program, whole, .. } = self;
        // A program that cannot be executed is shown all the same.
        if let Some(source) = text.filter(|_| rows.files.is_empty()) {
            let file = parse(FileId(0), source, Form::Program, &mut Findings::new());
            introduce(&file, &mut rows.files, &mut program);
        }
        let (mut planner, mut times) = planned.finish();
        planner.finish(&mut times);
        program.insert("name".to_owned(), json!(naming.program()));
        let names = rows.files.iter().map(|file| naming.of(file.source.name())).collect();
        View { rows, times, equidistant, assumed, machine, program, names, blocks: executed, whole }
    }
}

impl View {
    /// The paths of its files, by the index that the data give them.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.rows.files.iter().map(|file| file.source.name())
    }

    /// How many executed blocks it holds.
    pub fn count(&self) -> usize {
        self.rows.count()
    }

    /// The data of the page: a deflated stream.
    pub fn data(&self, report: &Report, naming: Naming<'_>) -> Vec<u8> {
        let findings = self.findings(report, naming);
        let (time_s, unknown) = self.times.total();
        let about = About {
            program: self.program.clone(),
            names: &self.names,
            motion: [self.machine.clone(), json!({ "time_s": time_s, "lower_bound": unknown })],
            blocks: self.blocks,
            whole: self.whole,
            findings,
            equidistant: self.equidistant_json(),
        };
        pack(&self.rows, &self.times, about)
    }

    /// A still picture as SVG.
    pub fn svg(&self, still: Still) -> Picture {
        as_svg(&self.rows, still, &self.besides())
    }

    /// A still picture as PNG. `None`: there is not enough memory for one of that size.
    pub fn png(&self, still: Still) -> Option<Picture> {
        as_png(&self.rows, still, &self.besides())
    }

    fn besides(&self) -> Besides {
        let of = |name: &str| self.program.get(name).and_then(Value::as_str).unwrap_or_default();
        Besides {
            title: [of("name"), of("title")].join(" ").trim_end().to_owned(),
            whole: self.whole && self.rows.count() as u64 == self.blocks,
            assumed: self.assumed,
            dots: self.times.dots(&self.rows),
            equidistant: self.chains().collect(),
        }
    }

    /// The pieces of the equidistant that belong to executed blocks in the picture.
    fn chains(&self) -> impl Iterator<Item = Chain> + '_ {
        let Part { from, blocks } = self.rows.part;
        let inside = move |seq: u64| seq >= from && blocks.is_none_or(|blocks| seq < blocks);
        let pieces = self.equidistant.pieces().iter().filter(move |piece| inside(piece.seq));
        pieces.map(|piece| Chain { seq: piece.seq, points: piece.points.clone(), collides: piece.collides })
    }

    fn equidistant_json(&self) -> Option<Value> {
        let rounded = |value: f64| (value * 10_000.0).round() / 10_000.0;
        let pieces: Vec<Value> = self
            .chains()
            .map(|chain| {
                let points: Vec<f64> = chain.points.iter().flatten().map(|value| rounded(*value)).collect();
                if chain.collides {
                    json!({ "seq": chain.seq, "points": points, "bad": true })
                } else {
                    json!({ "seq": chain.seq, "points": points })
                }
            })
            .collect();
        (!pieces.is_empty()).then(|| json!({ "pieces": pieces }))
    }

    fn findings(&self, report: &Report, naming: Naming<'_>) -> Vec<Value> {
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
            let finding = naming.in_finding(&diagnostic.finding);
            let message = |lang: Lang| finding.message(lang);
            put("message", json!({ "en": message(Lang::En), "cs": message(Lang::Cs) }));
            if let Some(source) = report.sources().get(diagnostic.at.file) {
                let place = source.line_column(diagnostic.at.span.start);
                put("line", json!(place.line));
                put("column", json!(place.column));
                match self.rows.files.index_of(source.name()) {
                    Some(index) => put("file", json!(index)),
                    None => put("path", json!(naming.of(source.name()))),
                }
            }
            Value::Object(item)
        };
        report.items().map(one).collect()
    }
}

/// Takes up the file of the program, and what the header says of it.
fn introduce(file: &ParsedFile, files: &mut Files, program: &mut Map<String, Value>) {
    files.add(0, file);
    let number = file.program.and_then(|word| word.whole()).unwrap_or_default();
    program.insert("number".to_owned(), json!(number));
    if let Some(title) = file.title {
        program.insert("title".to_owned(), json!(file.comment_text(title)));
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

/// The record of the machine as the motion stream has it, without what the page does not read.
fn machine_of(settings: &Settings) -> Value {
    let record = machine(&Basis::of(settings), "");
    let mut record: Map<String, Value> = serde_json::from_str(&record).unwrap_or_default();
    record.retain(|name, _| !matches!(name.as_str(), "kind" | "schema" | "generator" | "name" | "from" | "times"));
    Value::Object(record)
}

/// A reader of executed blocks that fills a [`Collector`].
#[derive(Debug)]
pub struct Collect<'c> {
    collector: &'c mut Collector,
}

impl Sink for Collect<'_> {
    type Whole = ();

    fn begin(&mut self, start: &Program<'_>) {
        let Collector { rows, program, .. } = &mut *self.collector;
        if let Some(file) = start.resolved.file(FileId(0)) {
            introduce(file, &mut rows.files, program);
        }
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        let Collector { rows, reader, planned, equidistant, .. } = &mut *self.collector;
        planned.push(reader.read(block));
        rows.add(block);
        equidistant.read(block, findings);
        ControlFlow::Continue(())
    }

    fn end(self, _: End, findings: &mut Findings) {
        self.collector.equidistant.finish(findings);
        self.collector.whole = true;
    }
}
