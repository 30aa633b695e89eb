//! From executed blocks to what a page or a still picture is made of.

use std::ops::ControlFlow;
use std::sync::Arc;

use serde_json::{Map, Value, json};

use super::files::Files;
use super::names::Naming;
use super::pack::{About, pack};
use super::picture::{Besides, Chain, JointDot, Picture, Still, as_png, as_svg};
use super::rows::{Keep, Part, Rows};
use super::times::{Dots, Expected, Times};
use crate::analysis::equidistant::Equidistant;
use crate::analysis::motion::{Basis, Model, Planner, Step, StepReader, machine};
use crate::analysis::sheet::{Extents, Size};
use crate::config::Settings;
use crate::diag::{Findings, Report, Severity};
use crate::dict::Lang;
use crate::parallel::Fold;
use crate::run::{End, Executed, Program, Sink};
use crate::syntax::{Form, ParsedFile, parse};
use crate::text::{FileId, SourceText};

/// Blocks between two looks at how much is kept.
const MEMORY: u64 = 1 << 12;

/// What a program is executed for whose picture is wanted: see [`Self::sink`].
#[derive(Debug)]
pub struct Collector {
    rows: Rows,
    reader: StepReader,
    planned: Fold<(Step, bool), (Planner, Times)>,
    equidistant: Equidistant,
    size: Size,
    errors: Errors,
    /// Tells, as execution begins, how many bytes may be kept.
    room: fn() -> usize,
    /// So many may.
    most: usize,
    too_large: bool,
    /// Whether nothing of the machine's motion is configured.
    assumed: bool,
    /// The arguments with which a command executes the program the same way.
    arguments: Vec<String>,
    machine: Value,
    program: Map<String, Value>,
    whole: bool,
}

/// The picture of a program, up to where it was executed.
#[derive(Debug)]
pub struct View {
    rows: Rows,
    times: Times,
    equidistant: Equidistant,
    size: Size,
    /// Whether nothing of the machine's motion is configured.
    assumed: bool,
    arguments: Vec<String>,
    machine: Value,
    program: Map<String, Value>,
    /// The names of its files on the page.
    names: Vec<String>,
    blocks: u64,
    whole: bool,
}

impl Collector {
    /// Nothing yet, of a program for that machine.
    pub fn new(settings: &Settings, part: Part, keep: Keep) -> Self {
        let model = Model::of(settings);
        let times = Times::new(part, keep, [model.accel, model.accel_rapid]);
        let planned = Fold::new(
            "planner",
            (Planner::new(model, false), times),
            |(planner, times), (step, again): &(Step, bool)| {
                let accel = step.motion.map_or(0.0, |motion| motion.dynamics.accel);
                times.expect(Expected { accel, again: *again });
                planner.push(step, times);
            },
        );
        Self {
            rows: Rows::new(settings, part, keep),
            reader: StepReader::new(settings),
            planned,
            equidistant: Equidistant::new(settings, true),
            size: Size::default(),
            errors: Errors::default(),
            room: || usize::MAX,
            most: usize::MAX,
            too_large: false,
            assumed: !settings.machine.motion.configured,
            arguments: settings.arguments.clone(),
            machine: machine_of(settings),
            program: program(settings),
            whole: false,
        }
    }

    /// The same; execution is given up when more bytes would have to be kept than there is room for as it begins.
    #[must_use]
    pub fn within(self, room: fn() -> usize) -> Self {
        Self { room, ..self }
    }

    /// Whether execution was given up because too much would have to be kept.
    pub const fn is_too_large(&self) -> bool {
        self.too_large
    }

    /// The bytes that the rows take, and what the page of them will take.
    fn memory(&self) -> usize {
        /// Of an executed block: its time, its numbers in columns.
        const EXECUTED: usize = 72;
        /// What is planned of a motion.
        const PLANNED: usize = 88;
        self.rows.memory() + self.rows.count() * EXECUTED + self.rows.block.len() * PLANNED
    }

    /// Collects executed blocks, up to the first that has an error.
    pub fn sink(&mut self) -> Collect<'_> {
        Collect { collector: self }
    }

    /// The result of the run: the text of the program, which may not have been executed, and how many blocks were.
    pub fn finish(self, text: Option<&Arc<SourceText>>, naming: Naming<'_>, executed: u64) -> View {
        let Self { mut rows, planned, equidistant, mut size, assumed, arguments, machine, mut program, whole, .. } =
            self;
        size.end();
        // A program that cannot be executed is shown all the same.
        if let Some(source) = text.filter(|_| rows.files.is_empty()) {
            let file = parse(FileId(0), source, Form::Program, &mut Findings::new());
            introduce(&file, &mut rows.files, &mut program);
        }
        let (mut planner, mut times) = planned.finish();
        planner.finish(&mut times);
        program.insert("name".to_owned(), json!(naming.program()));
        let names = rows.files.iter().map(|file| naming.of(file.source.name())).collect();
        View { rows, times, equidistant, size, assumed, arguments, machine, program, names, blocks: executed, whole }
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

    /// The data of the page: a deflated stream. `compared`: what another program does differently.
    pub fn data(&self, report: &Report, naming: Naming<'_>, compared: Option<Value>) -> Vec<u8> {
        let findings = self.findings(report, naming);
        let total = self.times.total();
        // With an error it stops before the end.
        let at_least = total.lacks_more_than_approach() || !self.whole;
        let about = About {
            program: self.program.clone(),
            names: &self.names,
            motion: [
                self.machine.clone(),
                json!({
                    "time_s": total.time_s,
                    "at_least": at_least,
                    "without_approach": total.approach_blocks > 0 && !at_least,
                }),
            ],
            blocks: self.blocks,
            whole: self.whole,
            findings,
            equidistant: self.equidistant_json(),
            size: [&self.size.working, &self.size.all].map(size_json),
            compared,
            arguments: &self.arguments,
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
            dots: self.dots(),
            yellow: self.times.dots().yellow_count,
            equidistant: self.chains().collect(),
        }
    }

    fn dots(&self) -> Vec<JointDot> {
        let Dots { yellow, red, .. } = self.times.dots();
        let dot = |index: u32, red: bool| {
            let row = self.rows.row(index as usize)?;
            Some(JointDot { seq: self.rows.part.from + u64::from(index), n: self.rows.n(row), row, red })
        };
        let yellow = yellow.iter().filter_map(|index| dot(*index, false));
        yellow.chain(red.iter().filter_map(|index| dot(*index, true))).collect()
    }

    /// The pieces of the equidistant that belong to executed blocks in the picture.
    fn chains(&self) -> impl Iterator<Item = Chain> + '_ {
        let part = self.rows.part;
        let pieces = self.equidistant.pieces().iter().filter(move |piece| part.has(piece.seq));
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

/// How far the axes of the planes go, in millimetres, and which go farther than that is known.
fn size_json(extents: &Extents) -> Value {
    let axes = || extents.axes().filter(|(letter, _)| letter.is_of_the_planes());
    let known = axes().filter_map(|(letter, reach)| {
        let (least, greatest) = reach.known?;
        Some((letter.to_string(), json!([least.to_f64(), greatest.to_f64()])))
    });
    let lacks: String = axes().filter(|(_, reach)| reach.lacks).map(|(letter, _)| letter.letter()).collect();
    json!({ "axes": known.collect::<Map<_, _>>(), "lacks": lacks })
}

/// Where errors are: the picture ends before the first block that has one.
#[derive(Debug, Default)]
struct Errors {
    /// Those found before execution, ascending; `None` before the first block.
    written: Option<Vec<(FileId, u32)>>,
    count: usize,
    stopped: bool,
}

impl Errors {
    /// Whether a block, or one before it, has an error.
    fn stop(&mut self, block: &Executed<'_>, findings: &Findings) -> bool {
        let Self { written, count, stopped } = self;
        let written = written.get_or_insert_with(|| {
            *count = findings.error_count();
            let errors =
                findings.items().iter().filter(|found| findings.levels().of(found.code()) == Some(Severity::Error));
            let mut places: Vec<(FileId, u32)> = errors.map(|found| (found.at.file, found.at.span.start)).collect();
            places.sort_unstable();
            places
        });
        if findings.error_count() > *count {
            *stopped = true;
        } else if !written.is_empty() && !*stopped {
            let (id, at) = block.at();
            let start = block.place().span.start;
            let end = block.file().and_then(|file| file.n_word(at.next())).map_or(u32::MAX, |word| word.start());
            let first = written.partition_point(|place| *place < (id, start));
            *stopped = written.get(first).is_some_and(|place| *place < (id, end));
        }
        *stopped
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

/// The part of the header that is known before execution.
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
        self.collector.most = (self.collector.room)();
        let Collector { rows, program, .. } = &mut *self.collector;
        if let Some(file) = start.resolved.file(FileId(0)) {
            introduce(file, &mut rows.files, program);
        }
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        let Collector { rows, reader, planned, equidistant, size, errors, .. } = &mut *self.collector;
        if errors.stop(block, findings) {
            return ControlFlow::Continue(());
        }
        let again = rows.add(block);
        // An execution that the rows have goes no farther.
        if !again && rows.part.has(block.seq()) {
            size.add(block);
        }
        planned.push((reader.read(block), again));
        equidistant.read(block, findings);
        if block.seq().is_multiple_of(MEMORY) && self.collector.memory() > self.collector.most {
            self.collector.too_large = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, findings: &mut Findings) {
        self.collector.equidistant.finish(findings);
        self.collector.whole = true;
    }
}
