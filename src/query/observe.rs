//! What execution makes of some blocks: how often they run, and what holds after them.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use super::analysis::Analysis;
use super::cancel::Cancel;
use super::cursor::DOCUMENT;
use super::moves::{Moves, Seen};
use super::observed::Observed;
use super::values::Values;
use crate::config::Machine;
use crate::diag::Findings;
use crate::dict::{Address, Decimal, GCode, Micro};
use crate::resolve::{ControlWord, Library, control_word};
use crate::run::{End, Executed, Length, Passed, Sink};
use crate::session::{Record, Session};
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile, Value, Word};
use crate::text::FileId;

/// Most blocks that are executed to answer a request.
pub(crate) const MOST: u64 = 2_000_000;
/// For a request that somebody waits for at the pointer, beside others: most blocks that are executed, and most that
/// are looked at one by one.
const SOON: Limits = Limits { executed: 1 << 19, looked_at: 1 << 15 };
/// The same where its motion is planned: most blocks that the program executes.
const PLANNED_SOON: u64 = 1 << 16;
/// Blocks looked at between two questions whether the answer is still wanted.
const PERIOD: u64 = 1 << 12;

/// How much of a program is executed for a request.
#[derive(Clone, Copy)]
struct Limits {
    executed: u64,
    looked_at: u64,
}

/// One execution, with what was seen of some blocks.
#[derive(Debug, Default)]
pub(crate) struct Observation {
    blocks: BTreeMap<BlockId, Observed>,
    /// Blocks executed.
    pub(crate) executed: u64,
    /// The sum of the lengths that are known.
    pub(crate) path: Micro,
    /// There are motions whose length is not known before the first that is.
    pub(crate) approaches: bool,
    /// There are such motions behind it.
    pub(crate) partly_unknown: bool,
    /// M02 or M30, when that was reached.
    pub(crate) end: Option<u8>,
    /// The number of the last executed block.
    pub(crate) last: u32,
    /// How the machine moves, where that is asked for and configured, and the program ended.
    pub(crate) moves: Option<Seen>,
    /// That was left out because the program is long.
    pub(crate) unplanned: bool,
    /// The program was not executed further because it is long.
    pub(crate) cut: bool,
}

impl Observation {
    /// What was seen of a block; `None` unless it was asked for.
    pub(crate) fn of(&self, block: BlockId) -> Option<&Observed> {
        self.blocks.get(&block)
    }
}

/// The program that shows what a document does when executed: the document itself, or, for a macrocycle, the first open
/// program that leads to it.
pub(crate) fn executing<'a>(
    open: impl IntoIterator<Item = &'a Analysis>,
    analysis: &'a Analysis,
) -> Option<&'a Analysis> {
    if analysis.executable {
        return Some(analysis);
    }
    if !Session::is_macrocycle_name(&analysis.path) {
        return None;
    }
    open.into_iter().filter(|other| other.executable && other.path != analysis.path).find(|other| {
        if is_cycle_of(other, analysis) {
            return true;
        }
        let source = other.all_sources().iter().find(|(_, source)| other.is(source.name(), analysis));
        source.is_some_and(|(_, source)| {
            analysis.resolved.file(DOCUMENT).is_some_and(|file| file.source.text() == source.text())
        })
    })
}

/// Whether a fixed cycle calls the document in the program of an analysis: execution alone tells when.
fn is_cycle_of(program: &Analysis, document: &Analysis) -> bool {
    let number = Library::number(&document.path);
    let mapped = program.settings.machine.cycles.values().find(|l| Some(**l) == number);
    mapped.is_some_and(|l| {
        let found = program.session().library(&program.path).find(*l);
        found.is_ok_and(|path| program.loader.canonical(&path) == document.path)
    })
}

/// Executes `program` and looks at `blocks` of the document. `None` when the answer is not wanted any more.
pub(crate) fn observe(
    cancel: &Cancel,
    program: &Analysis,
    document: &Analysis,
    blocks: impl IntoIterator<Item = BlockId>,
) -> Option<Observation> {
    run(cancel, program, Observer::new(cancel, program, document, blocks))
}

/// The same of one block, with the values of parameters after it.
pub(crate) fn observe_inputs(
    cancel: &Cancel,
    program: &Analysis,
    document: &Analysis,
    block: BlockId,
    inputs: &[u8],
) -> Option<Observation> {
    let mut observer = Observer::new(cancel, program, document, [block]);
    observer.watch(inputs);
    observer.limits = SOON;
    run(cancel, program, observer)
}

/// The same, with how the machine moves; `units`: from which block up to which those reach whose times are wanted;
/// `inputs`: parameters whose values after the blocks are.
pub(crate) fn observe_motion(
    cancel: &Cancel,
    program: &Analysis,
    document: &Analysis,
    blocks: impl IntoIterator<Item = BlockId>,
    units: &[(BlockId, BlockId)],
    inputs: &[u8],
) -> Option<Observation> {
    let mut observer = Observer::new(cancel, program, document, blocks);
    observer.watch(inputs);
    observer.plc = true;
    let waited_for = !observer.observation.blocks.is_empty();
    let planned = program.settings.machine.motion.configured;
    let long = waited_for && program.record.get().is_some_and(|record| record.executed() > PLANNED_SOON);
    observer.observation.unplanned = planned && long;
    if planned && !long {
        observer.moves = Some(Moves::new(&program.settings, units.len()));
        observer.units = units.to_vec();
    } else if waited_for {
        observer.limits = SOON;
    }
    run(cancel, program, observer)
}

/// Executes the blocks in question; the whole program for questions about all of it or about its motion.
fn run(cancel: &Cancel, program: &Analysis, mut observer: Observer<'_>) -> Option<Observation> {
    let whole = observer.moves.is_some() || observer.observation.blocks.is_empty();
    match program.record.get().filter(|_| !whole) {
        Some(record) => observer.look_from(record),
        None => program.observe(&mut observer),
    }
    if cancel.is_cancelled() {
        return None;
    }
    let Observer { mut observation, moves, .. } = observer;
    observation.cut |= observation.end.is_none() && observation.executed >= MOST;
    observation.moves = moves.filter(|_| observation.end.is_some()).map(Moves::finish);
    if !observation.cut {
        observation.blocks.values_mut().for_each(Observed::disarm);
    }
    Some(observation)
}

/// Looks at every executed block. What it has seen when execution stopped early counts as well.
struct Observer<'a> {
    cancel: &'a Cancel,
    program: &'a Analysis,
    document: &'a Analysis,
    machine: &'a Machine,
    observation: Observation,
    moves: Option<Moves>,
    /// Include the PLC's reading.
    plc: bool,
    /// From which block up to which units reach whose times are wanted.
    units: Vec<(BlockId, BlockId)>,
    /// The parameters that the blocks read, with their values before the next block.
    before: Vec<(u8, Option<Decimal>)>,
    /// Whether a file of the program is the document, as far as asked.
    files: Vec<Option<bool>>,
    /// After so many executed blocks there is nothing more to be seen.
    until: u64,
    /// The file that the blocks in question are in, when nothing but these is looked at.
    only: Option<FileId>,
    limits: Limits,
    /// Blocks looked at.
    looked_at: u64,
}

impl<'a> Observer<'a> {
    fn new(
        cancel: &'a Cancel,
        program: &'a Analysis,
        document: &'a Analysis,
        blocks: impl IntoIterator<Item = BlockId>,
    ) -> Self {
        let machine = &program.settings.machine;
        let mut observation = Observation::default();
        let mut before: BTreeMap<u8, Option<Decimal>> = BTreeMap::new();
        if let Some(file) = document.resolved.file(DOCUMENT) {
            for block in blocks {
                let mut observed = Observed::default();
                for &word in file.words(block) {
                    if let Value::Parameter { index, .. } = word.value() {
                        observed.reads.insert(index, Values::default());
                    }
                    if word.address == Address::R {
                        observed.writes.insert(word.target(), Values::default());
                    }
                }
                for control in control_words(machine, file, block) {
                    observed.writes.insert(control.result, Values::default());
                }
                for &index in observed.reads.keys() {
                    before.insert(index, machine.parameters.get(&index).copied());
                }
                observation.blocks.insert(block, observed);
            }
        }
        let before = before.into_iter().collect();
        Self {
            cancel,
            program,
            document,
            machine,
            observation,
            moves: None,
            plc: false,
            units: Vec::new(),
            before,
            files: Vec::new(),
            until: MOST,
            only: None,
            limits: Limits { executed: MOST, looked_at: MOST },
            looked_at: 0,
        }
    }

    /// Looks at the blocks from the checkpoints before them, at most at so many executed blocks.
    fn look_from(&mut self, record: &Record) {
        let blocks: BTreeSet<BlockId> = self.observation.blocks.keys().copied().collect();
        let read = (record.resolved(), record.sources());
        let mut left = self.limits.executed;
        for (index, (_, source)) in record.sources().iter().enumerate() {
            let file = FileId(small(index));
            if !self.program.is(source.name(), self.document) {
                continue;
            }
            self.only = Some(file);
            for (checkpoint, until) in record.visits(file, &blocks) {
                self.until = until.min(checkpoint.executed() + left);
                left -= self.until - checkpoint.executed();
                if self.until > checkpoint.executed() {
                    self.observation.executed = checkpoint.executed();
                    for (index, value) in &mut self.before {
                        *value = checkpoint.parameter(*index);
                    }
                    self.program.session().observe_from(&self.program.path, read, checkpoint, &mut *self);
                }
                self.observation.cut |= self.until < until;
                if self.observation.cut {
                    break;
                }
            }
        }
        self.observation.last = record.last();
        self.observation.end = None;
        // Of a part of the execution it counts how far that was looked at.
        if !self.observation.cut {
            (self.observation.executed, self.observation.end) = (record.executed(), record.end());
        }
    }

    /// Looks at the values of those parameters after each block, too.
    fn watch(&mut self, inputs: &[u8]) {
        for observed in self.observation.blocks.values_mut() {
            observed.inputs = inputs.iter().map(|index| (*index, Values::default())).collect();
        }
    }

    fn look(&mut self, executed: &Executed<'_>) {
        self.observation.executed = executed.seq() + 1;
        self.observation.last = executed.n();
        self.observation.end = executed.end();
        match executed.motion().map(|motion| motion.length()) {
            Some(Length::Mm(length)) => self.observation.path = self.observation.path.plus(length),
            Some(Length::Missing(_)) if self.observation.path == Micro::ZERO => self.observation.approaches = true,
            Some(Length::Missing(_)) => self.observation.partly_unknown = true,
            Some(Length::Deg(_)) => {}
            None => self.observation.partly_unknown |= executed.is_unmapped_cycle(),
        }
        let (file, block) = executed.at();
        let document = self.is_document(file, executed);
        if let Some(moves) = &mut self.moves {
            let asked = Some(block).filter(|block| document && self.observation.blocks.contains_key(block));
            let unit = self.units.iter().position(|(first, end)| document && *first <= block && block < *end);
            moves.push(executed, asked, unit);
        }
        if document && let Some(observed) = self.observation.blocks.get_mut(&block) {
            for (index, value) in &self.before {
                if let Some(values) = observed.reads.get_mut(index) {
                    values.add(*value);
                }
            }
            for (index, values) in &mut observed.writes {
                values.add(executed.parameter(*index));
            }
            for (index, values) in &mut observed.inputs {
                values.add(executed.parameter(*index));
            }
            observed.take(executed, self.machine);
            if self.plc {
                observed.take_words(executed);
            }
        }
        for (index, value) in &mut self.before {
            *value = executed.parameter(*index);
        }
    }

    fn is_document(&mut self, file: FileId, executed: &Executed<'_>) -> bool {
        let place = file.0 as usize;
        if let Some(Some(known)) = self.files.get(place) {
            return *known;
        }
        let answer = self.program.is(executed.file_name(), self.document);
        if self.files.len() <= place {
            self.files.resize(place + 1, None);
        }
        if let Some(slot) = self.files.get_mut(place) {
            *slot = Some(answer);
        }
        answer
    }
}

impl Sink for &mut Observer<'_> {
    type Whole = ();

    fn spares(&self, (file, next): (FileId, BlockId)) -> u64 {
        let Some(only) = self.only else { return 0 };
        let asked = self.observation.blocks.range(next..).next().filter(|_| file == only);
        let ahead = asked.map_or(u64::MAX, |(block, _)| u64::from(block.0 - next.0));
        ahead.min(self.until.saturating_sub(self.observation.executed + 1))
    }

    fn passed(&mut self, points: &Passed<'_>) {
        self.observation.executed = points.first_seq() + u64::from(points.stretch().count());
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.look(block);
        self.looked_at += 1;
        let over = self.observation.executed >= self.until;
        self.observation.cut |= !over && self.looked_at >= self.limits.looked_at;
        let unwanted = self.looked_at.is_multiple_of(PERIOD) && self.cancel.is_cancelled();
        if over || self.observation.cut || unwanted { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn end(self, _: End, _: &mut Findings) {}
}

/// The G functions that a block writes out.
pub(crate) fn g_functions(file: &ParsedFile, block: BlockId) -> impl Iterator<Item = (GCode, Word)> + '_ {
    file.words(block).iter().filter_map(|word| Some((word.g_code()?, *word)))
}

/// The control word that an R word of a block is (PAR-7), when G26–G29 and the word are written out.
pub(crate) fn control_of(machine: &Machine, file: &ParsedFile, block: BlockId, word: Word) -> Option<ControlWord> {
    let operations = g_functions(file, block).map(|(code, _)| code.operations()).max()?;
    let place = word.target().checked_sub(5).filter(|_| word.address == Address::R)?;
    if usize::from(place) >= operations {
        return None;
    }
    control_word(machine, word.number()?).ok()
}

fn control_words<'a>(
    machine: &'a Machine,
    file: &'a ParsedFile,
    block: BlockId,
) -> impl Iterator<Item = ControlWord> + 'a {
    file.words(block).iter().filter_map(move |word| control_of(machine, file, block, *word))
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::{Arc, OnceLock};

    use super::*;
    use crate::config::Settings;
    use crate::text::MemoryLoader;

    /// A program whose execution has more blocks than stand between checkpoints, with a part that is executed often,
    /// one that is seldom, and a macrocycle that only execution finds.
    fn analysis() -> Analysis {
        let mut text = "%1\nN1 G01 F100 X0 R1=0 R2=1 R20=9001\nN2 G71 L100 Q300\nN3 X5 R3=7\n".to_owned();
        (10..9000).for_each(|n| text += &format!("N{n} X{}.5 Y{}\n", n % 90, n % 7));
        text += "N9000 G26 R10=R1 R11=R2 R15=1112\nN9001 G73 L8990 Q700\nN9002 XR1 G72 LR20\nN9003 M30\n";
        text += "N9100 G79 L100\nN9101 G91 X1\nN9102 G26 R10=R1 R11=R2 R15=1112\n";
        (9110..9150).for_each(|n| text += &format!("N{n} G90 Y{}\n", n % 9));
        text += "N9200 G70\n";
        let loader = MemoryLoader::new().with("part.nc", text).with("L9001", "N1 G79 L9001\nN2 X9\nN3 G70\n");
        recorded(loader).unwrap()
    }

    /// A program with the record of its execution.
    fn recorded(loader: MemoryLoader) -> Option<Analysis> {
        let path = PathBuf::from("part.nc");
        let (loader, settings) = (Arc::new(loader), Settings::default());
        let session = Session { loader: &*loader, settings: &settings, progress: None };
        let (outcome, resolved) = session.resolve(&path, "part.nc");
        let sources = outcome.sources.clone();
        let (_, record) = session.execute_recorded(&path, resolved.clone(), outcome);
        let record = Arc::new(OnceLock::from(record?));
        let state = Arc::default();
        Some(Analysis { path, loader, settings, sources, resolved, executable: true, certain: true, record, state })
    }

    /// Also of programs that have no end, or stop before it.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the samples are files")]
    fn from_checkpoints_in_samples() {
        let mut compared = 0;
        for folder in ["err", "ok", "rules", "slips"] {
            let entries = std::fs::read_dir(format!("{}/samples/{folder}", env!("CARGO_MANIFEST_DIR"))).unwrap();
            for path in entries.map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
                let bytes = std::fs::read(&path).unwrap();
                let Some(analysis) = recorded(MemoryLoader::new().with("part.nc", bytes)) else { continue };
                let blind = from_beginning(&analysis);
                let Some(file) = analysis.resolved.file(DOCUMENT) else { continue };
                for block in file.block_ids().take(60).step_by(7) {
                    assert_eq!(seen(&analysis, block), seen(&blind, block), "{} {block:?}", path.display());
                    compared += 1;
                }
            }
        }
        assert!(compared > 300, "{compared}");
    }

    /// What execution makes of blocks is the same from checkpoints as from the beginning.
    #[test]
    fn from_checkpoints() {
        let analysis = analysis();
        assert!(analysis.record.get().unwrap().executed() > 3 << 13);
        let blind = from_beginning(&analysis);
        let file = analysis.resolved.file(DOCUMENT).unwrap();
        for n in [1, 2, 3, 10, 8191, 8193, 8990, 8995, 9000, 9001, 9002, 9003, 9101, 9102, 9130, 9200] {
            let block = file.block_ids().find(|block| file.number(*block) == Some(n)).unwrap();
            assert_eq!(seen(&analysis, block), seen(&blind, block), "N{n}");
        }
    }

    /// A loop that is executed more often than is looked at: what is seen of its blocks is that of many passes.
    #[test]
    fn a_long_loop() {
        let body: String = (10..60).map(|n| format!("N{n} X{}\n", n % 9)).collect();
        let each = |g: &str| {
            format!("%1\nN1 G01 F100 X0\n{}N70 G73 L10 Q9999\nN71 G73 L10 Q4\nN80 M30\n", body.replace(" X", g))
        };
        for (text, most) in [(each(" X"), 10 * SOON.looked_at), (each(" G90 X"), SOON.looked_at)] {
            let analysis = recorded(MemoryLoader::new().with("part.nc", text)).unwrap();
            let seen = observe_inputs(&Cancel::default(), &analysis, &analysis, BlockId(5), &[]).unwrap();
            assert!(seen.cut && seen.end.is_none() && seen.executed >= most, "{}", seen.executed);
            let observed = seen.of(BlockId(5)).unwrap();
            assert!(observed.runs.abs_diff(seen.executed / 51) <= 2, "{} of {}", observed.runs, seen.executed);
        }
    }

    /// The motion of a long program is not planned for a note at a block; for the program it is.
    #[test]
    fn a_plan_of_a_long_program() {
        for (jumps, long) in [("Q99", false), ("Q9999\nN5 G73 L2 Q2", true)] {
            let text = format!("%1\nN1 G01 F100 X0\nN2 X5\nN3 X7\nN4 G73 L2 {jumps}\nN6 M30\n");
            let mut analysis = recorded(MemoryLoader::new().with("part.nc", text)).unwrap();
            analysis.settings.machine.motion.configured = true;
            for (block, left_out) in [(Some(BlockId(1)), long), (None, false)] {
                let seen = observe_motion(&Cancel::default(), &analysis, &analysis, block, &[], &[]).unwrap();
                assert_eq!((seen.unplanned, seen.moves.is_some()), (left_out, !left_out), "{jumps} {block:?}");
            }
        }
    }

    /// What is seen of a block.
    fn seen(program: &Analysis, block: BlockId) -> String {
        let seen = observe_inputs(&Cancel::default(), program, program, block, &[1, 3]).unwrap();
        format!("{:?} {} {:?} {}", seen.blocks, seen.executed, seen.end, seen.last)
    }

    fn from_beginning(analysis: &Analysis) -> Analysis {
        Analysis {
            path: analysis.path.clone(),
            loader: Arc::clone(&analysis.loader),
            settings: analysis.settings.clone(),
            sources: analysis.sources.clone(),
            resolved: analysis.resolved.clone(),
            executable: true,
            certain: true,
            record: Arc::default(),
            state: Arc::default(),
        }
    }
}
