//! The executor: one step is one executed block.

use std::ops::ControlFlow;

use super::block::BlockWords;
use super::executed::Executed;
use super::flow::Next;
use super::frames::Frame;
use super::lines::Lines;
use super::motion::Travel;
use super::points::Run;
use super::sink::Sink;
use super::state::{Position, State};
use crate::config::{Purpose, Settings};
use crate::diag::{CallSite, Diagnostic, Finding, Findings};
use crate::dict::{AxisLetter, Decimal, GCode};
use crate::ir::{AxisMap, BlockRecord, Call};
use crate::resolve::{Library, Resolved, UnitKind};
use crate::syntax::{BlockFlags, BlockId, Word};
use crate::text::{FileId, Location, Sources};

/// Why execution went no further.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Stop {
    /// M02 or M30, by number.
    End(u8),
    /// A finding, or something unknown, ends the flattening.
    Halted,
}

/// Executes a program. Ask for blocks with [`Executor::step`] until it gives none.
pub struct Executor<'a, 'l> {
    pub(super) resolved: &'a mut Resolved,
    pub(super) settings: &'a Settings,
    pub(super) library: &'a mut Library<'l>,
    pub(super) sources: &'a mut Sources,
    pub(super) findings: &'a mut Findings,
    pub(super) wants_records: bool,
    pub(super) state: State,
    pub(super) frames: Vec<Frame>,
    pub(super) words: BlockWords,
    /// Room for the words of the block in hand.
    pub(super) written: Vec<Word>,
    /// Room for the motions of its axes.
    pub(super) travels: Vec<Travel>,
    pub(super) run: Run,
    /// The block before had no M word: M functions and their part of the record stay as they are in the next such block.
    pub(super) m_settled: bool,
    pub(super) record: BlockRecord,
    /// G functions of the block in hand, x functions included.
    pub(super) in_force: [Option<GCode>; 12],
    pub(super) file: FileId,
    pub(super) block: BlockId,
    pub(super) calls_changed: bool,
    pub(super) moves_by_m: bool,
    /// The motion of the block began where the tool does not stand (MOT-8).
    pub(super) stale: bool,
    /// What the block in hand calls, or where it jumps: put into effect before the next one.
    pending: Option<(BlockId, Next, bool)>,
    pub(super) feed_warned: bool,
    pub(super) speed_warned: bool,
    pub(super) incremental_warned: [bool; 9],
    pub(super) unmodelled_warned: Vec<GCode>,
    pub(super) unassigned_warned: [bool; 96],
    /// A macrocycle that execution loaded has errors: it cannot be executed.
    pub(super) broken_macrocycle: bool,
    lines: Lines,
    /// The index that records show for each file: files are counted as their first records come.
    shown_files: Vec<Option<u32>>,
    files_shown: u32,
    letters: Vec<AxisLetter>,
    executed: u64,
    stop: Option<Stop>,
}

impl<'a, 'l> Executor<'a, 'l> {
    /// Ready for the first block of the main program. The program has no error so far.
    pub fn new(
        resolved: &'a mut Resolved,
        settings: &'a Settings,
        library: &'a mut Library<'l>,
        sources: &'a mut Sources,
        findings: &'a mut Findings,
        purpose: Purpose,
    ) -> Self {
        let main = resolved.main().and_then(|id| resolved.unit(id).map(|unit| Frame::new(id, *unit, None)));
        Self {
            resolved,
            settings,
            library,
            sources,
            findings,
            wants_records: purpose == Purpose::Compile,
            state: State::new(settings),
            stop: main.is_none().then_some(Stop::Halted),
            frames: main.into_iter().collect(),
            words: BlockWords::default(),
            written: Vec::new(),
            travels: Vec::new(),
            run: Run::Unknown,
            m_settled: false,
            record: BlockRecord::default(),
            in_force: [None; 12],
            file: FileId(0),
            block: BlockId(0),
            calls_changed: true,
            moves_by_m: false,
            stale: false,
            pending: None,
            feed_warned: false,
            speed_warned: false,
            incremental_warned: [false; 9],
            unmodelled_warned: Vec::new(),
            unassigned_warned: [false; 96],
            broken_macrocycle: false,
            lines: Lines::default(),
            shown_files: Vec::new(),
            files_shown: 0,
            letters: settings.machine.axes.iter().map(|axis| axis.letter).collect(),
            executed: 0,
        }
    }

    /// Executes the next block. `None` at the end of the program, or where it cannot go on; [`Self::end`] tells which.
    pub fn step(&mut self) -> Option<&BlockRecord> {
        while self.stop.is_none() {
            match self.advance() {
                Ok(true) => return Some(&self.record),
                Ok(false) => {}
                Err(stop) => {
                    self.stop = Some(stop);
                    if matches!(stop, Stop::End(_)) {
                        return Some(&self.record);
                    }
                }
            }
        }
        None
    }

    /// How the program ended; `None` while it runs.
    pub const fn end(&self) -> Option<Stop> {
        self.stop
    }

    /// Blocks executed so far.
    pub const fn executed(&self) -> u64 {
        self.executed
    }

    /// The findings so far.
    pub fn findings(&self) -> &Findings {
        self.findings
    }

    /// The record of the block in hand: of the last step, complete when the purpose is to compile.
    pub const fn record(&self) -> &BlockRecord {
        &self.record
    }

    /// The block in hand, as its readers see it.
    pub fn block(&self) -> Executed<'_> {
        Executed {
            record: &self.record,
            resolved: self.resolved,
            settings: self.settings,
            state: &self.state,
            in_force: &self.in_force,
            travels: &self.travels,
            frames: &self.frames,
            stale: self.stale,
            file: self.file,
            block: self.block,
        }
    }

    /// Shows the block in hand to a sink.
    pub fn show(&mut self, sink: &mut impl Sink) -> ControlFlow<()> {
        let block = Executed {
            record: &self.record,
            resolved: self.resolved,
            settings: self.settings,
            state: &self.state,
            in_force: &self.in_force,
            travels: &self.travels,
            frames: &self.frames,
            stale: self.stale,
            file: self.file,
            block: self.block,
        };
        sink.block(&block, self.findings)
    }

    /// Where the block in hand stands.
    pub const fn place(&self) -> (FileId, BlockId) {
        (self.file, self.block)
    }

    /// The program.
    pub const fn resolved(&self) -> &Resolved {
        self.resolved
    }

    /// What R`index` holds after the block in hand; `None` when it is not known (PAR-5).
    pub fn parameter(&self, index: u8) -> Option<Decimal> {
        self.state.parameters.get(usize::from(index)).and_then(|parameter| parameter.value)
    }

    /// The name of the file of the block in hand.
    pub fn source_name(&self) -> Option<&str> {
        self.resolved.file(self.file).map(|file| file.source.name())
    }

    /// The axes in machine order.
    pub fn axes(&self) -> &[AxisLetter] {
        &self.letters
    }

    /// One block: executed (`true`) or skipped.
    fn advance(&mut self) -> Result<bool, Stop> {
        if let Some((block, next, returns)) = self.pending.take() {
            self.proceed(block, next, returns)?;
        }
        let Some(frame) = self.frames.last() else { return Err(Stop::Halted) };
        let (unit, block) = (frame.unit, frame.next);
        self.file = unit.file;
        self.block = block;
        if block >= unit.end {
            self.report_missing_end();
            return Err(Stop::Halted);
        }
        let Some(flags) = self.resolved.file(unit.file).map(|file| file.flags(block)) else { return Err(Stop::Halted) };
        if self.settings.block_skip && flags.has(BlockFlags::SKIP) {
            if let Some(frame) = self.frames.last_mut() {
                frame.next = block.next();
            }
            return Ok(false);
        }
        if self.executed == self.settings.machine.limits.records {
            self.report_limit();
            return Err(Stop::Halted);
        }
        self.execute(block, flags)
    }

    fn execute(&mut self, block: BlockId, flags: BlockFlags) -> Result<bool, Stop> {
        let plain = !flags.has(BlockFlags::RICH);
        if plain && self.run_point(block) {
            self.executed += 1;
            if let Some(frame) = self.frames.last_mut() {
                frame.next = block.next();
            }
            return Ok(true);
        }
        let executed = self.execute_any(block, flags);
        self.unsettle(plain);
        executed
    }

    /// Executes a block by all the rules.
    fn execute_any(&mut self, block: BlockId, flags: BlockFlags) -> Result<bool, Stop> {
        self.begin_record(block);
        self.collect(block);
        self.apply_g();
        self.track_origin();
        self.apply_words();
        let end = self.apply_m();
        let moved = self.run_motion();
        self.forget_positions();
        self.run_parameters();
        let next = self.next(block, moved, end.is_some());
        let halted = matches!(next, Next::Halt);
        self.finish_record(end.is_some());
        self.executed += 1;
        if let Some(end) = end {
            return Err(Stop::End(end));
        }
        let returns = flags.has(BlockFlags::RETURN) && self.frames.len() > 1;
        if halted {
            // The block itself was executed; what would follow is not.
            self.stop = Some(Stop::Halted);
        } else {
            self.pending = Some((block, next, returns));
        }
        Ok(true)
    }

    /// What a record shows of the block as written, and of the way to it.
    #[inline]
    pub(super) fn begin_record(&mut self, block: BlockId) {
        self.record.jump = None;
        if !self.wants_records {
            return;
        }
        let Some(file) = self.resolved.file(self.file) else { return };
        let flags = file.flags(block);
        let at = self.file.0 as usize;
        let shown_file = match self.shown_files.get(at) {
            Some(Some(shown)) => *shown,
            _ => show_file(&mut self.shown_files, &mut self.files_shown, at),
        };
        let place = self.lines.of(self.file, file, block);
        let record = &mut self.record;
        record.seq = self.executed;
        record.n = file.shown_number(block);
        record.file = shown_file;
        record.line = place.line;
        record.column = place.column;
        record.first_block = self.executed == 0;
        record.skippable = flags.has(BlockFlags::SKIP);
        record.params.clear();
        record.comments.clear();
        if flags.has(BlockFlags::COMMENT) {
            let texts = file.comments(block).iter().map(|comment| file.comment_text(*comment));
            record.comments.extend(texts.filter(|text| !text.is_empty()).map(str::to_owned));
        }
        if self.calls_changed {
            self.calls_changed = false;
            record.calls.clear();
            record.calls.extend(self.frames.iter().filter_map(|frame| frame.call).map(|call| Call {
                by: call.by.name(),
                l: call.l,
                // The calling block was executed, and so its file has a number.
                file: self.shown_files.get(call.file.0 as usize).copied().flatten().unwrap_or(0),
                n: call.n,
                pass: call.pass,
                of: call.of,
            }));
        }
    }

    pub(super) fn finish_record(&mut self, ends: bool) {
        if !self.wants_records {
            return;
        }
        self.record.last_block = ends;
        self.record.dwell_s = self.dwell();
        self.record_technology();
        let mut positions = AxisMap::default();
        for (axis, letter) in self.letters.iter().enumerate() {
            if let Position::Known(value) = self.state.position(axis) {
                positions.set(*letter, Some(value));
            }
        }
        self.record.position = positions;
    }

    /// BLK-10: a skipped end is a missing end.
    fn report_missing_end(&mut self) {
        let Some(frame) = self.frames.last() else { return };
        let unit = frame.unit;
        let (finding, at) = match unit.kind {
            UnitKind::Main => {
                let last = BlockId(unit.end.0.saturating_sub(1));
                let at = self.resolved.file(unit.file).map(|file| file.n_place(last)).unwrap_or(unit.entry);
                (Finding::MissingProgramEnd { skipped: true, late: None }, at)
            }
            UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => {
                let macrocycle = matches!(unit.kind, UnitKind::Macrocycle(_));
                let finding = Finding::UnterminatedSubprogram { macrocycle, skipped: true, last: false, instead: None };
                (finding, unit.entry)
            }
        };
        self.report(Diagnostic::new(finding, at));
    }

    /// FLW-9: names the calls and jumps that multiply.
    fn report_limit(&mut self) {
        let mut repeats = Vec::new();
        for frame in &self.frames {
            if let Some(call) = frame.call.filter(|call| call.of > 1) {
                repeats.push(format!("N{} {} L{} ×{}", call.n, call.by.name(), call.l, call.of));
            }
            for (block, counter) in &frame.counters {
                let n = self.resolved.file(frame.unit.file).map_or(0, |file| file.shown_number(*block));
                repeats.push(format!("N{n} G73 ×{}", counter.of));
            }
        }
        repeats.truncate(12);
        let limit = self.settings.machine.limits.records;
        let finding = Finding::ExpansionLimit { limit, repeats: repeats.join(", ") };
        self.report(Diagnostic::new(finding, self.block_place()));
    }

    pub(super) fn block_place(&self) -> Location {
        self.resolved.file(self.file).map(|file| file.n_place(self.block)).unwrap_or_default()
    }

    pub(super) fn block_number(&self) -> u32 {
        self.resolved.file(self.file).map_or(0, |file| file.shown_number(self.block))
    }

    pub(super) fn word_place(&self, word: Word) -> Location {
        self.resolved.file(self.file).map(|file| file.word_place(word)).unwrap_or_default()
    }

    pub(super) fn value_place(&self, word: Word) -> Location {
        self.resolved.file(self.file).map(|file| file.value_place(word)).unwrap_or_default()
    }

    /// The number of a word; the whole word when a parameter stands for it.
    pub(super) fn value_or_word(&self, word: Word) -> Location {
        if word.is_parametric() { self.word_place(word) } else { self.value_place(word) }
    }

    /// Adds a finding with the calls that led to the block.
    pub(super) fn report(&mut self, mut diagnostic: Diagnostic) {
        diagnostic.calls = self
            .frames
            .iter()
            .filter_map(|frame| frame.call)
            .map(|call| CallSite { by: call.by, l: call.l, n: call.n, at: call.at })
            .collect();
        self.findings.add(diagnostic);
    }
}

/// Gives a file the next index that records show.
#[cold]
fn show_file(shown_files: &mut Vec<Option<u32>>, files_shown: &mut u32, file: usize) -> u32 {
    let shown = *files_shown;
    *files_shown += 1;
    if shown_files.len() <= file {
        shown_files.resize(file + 1, None);
    }
    if let Some(slot) = shown_files.get_mut(file) {
        *slot = Some(shown);
    }
    shown
}

impl std::fmt::Debug for Executor<'_, '_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Executor").field("executed", &self.executed).field("frames", &self.frames.len()).finish()
    }
}
