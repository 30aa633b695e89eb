//! The interpreter: one step is one executed block.

use super::block::Block;
use super::executed::Executed;
use super::flow::{Flow, LostCall, Next, check_late_words};
use super::frames::Frame;
use super::passed::Passed;
use super::points::Run;
use super::program::Program;
use super::repeats::Repeats;
use super::site::{Site, report};
use super::state::State;
use super::{functions, m_functions, motion, parameters, reading, spindle, technology, warnings};
use crate::diag::{Diagnostic, Finding, Findings};
use crate::dict::{Decimal, GCode, GGroup};
use crate::resolve::{Target, Unit, UnitKind, may_have_end};
use crate::syntax::{BlockFlags, BlockId};
use crate::text::FileId;

/// Why execution went no further.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Stop {
    /// M02 or M30, by number.
    End(u8),
    /// A finding, or something unknown, ends the flattening.
    Halted,
}

/// Blocks of a file, one behind the other.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Stretch {
    /// In which file.
    pub file: FileId,
    /// The first.
    pub first: BlockId,
    /// One past the last.
    pub end: BlockId,
}

impl Stretch {
    /// How many blocks.
    pub const fn count(self) -> u32 {
        self.end.0 - self.first.0
    }

    /// Whether another stretch begins in this one, or right behind it.
    pub fn goes_on_with(&self, next: Self) -> bool {
        self.file == next.file && self.first <= next.first && next.first <= self.end
    }
}

/// The step between a block and the next: a call, a jump, a return.
#[derive(Clone, Debug)]
struct Pending {
    block: BlockId,
    next: Next,
    /// The block holds G70 written out.
    returns: bool,
}

/// Executes a program. Ask for blocks with [`Self::step`] until it gives none. Its memory is the state in force and the
/// open calls, however often the program repeats. A copy goes on by itself from where the original stands, over the
/// same [`Program`].
#[derive(Clone, Debug)]
pub struct Interpreter {
    pub(super) state: State,
    pub(super) frames: Vec<Frame>,
    /// The current block.
    pub(super) block: Block,
    pub(super) run: Run,
    pending: Option<Pending>,
    /// The index that streams show for each file: files are counted as their first blocks are executed.
    pub(super) shown_files: Vec<Option<u32>>,
    pub(super) executed: u64,
    /// The first call that could not be followed.
    lost: Option<LostCall>,
    /// What has multiplied so far.
    repeats: Repeats,
    stop: Option<Stop>,
}

impl Interpreter {
    /// Ready for the first block of the main program.
    pub fn new(program: &Program<'_>) -> Self {
        let resolved = &program.resolved;
        let main = resolved.main().and_then(|id| resolved.unit(id).map(|unit| Frame::new(id, *unit, None)));
        let mut state = State::new(program.settings);
        state.said.operations.clone_from(resolved.unknown_operations());
        if let Some(file) = main.as_ref().and_then(|main| resolved.file(main.unit.file)) {
            state.lose_set_by(file, &file.outside, &program.settings.machine);
        }
        Self {
            state,
            stop: main.is_none().then_some(Stop::Halted),
            frames: main.into_iter().collect(),
            block: Block::default(),
            run: Run::Unknown,
            pending: None,
            shown_files: Vec::new(),
            executed: 0,
            lost: None,
            repeats: Repeats::default(),
        }
    }

    /// The same, for a stream, which ends at a parameter without a value (PAR-5).
    #[must_use]
    pub fn compiling(mut self) -> Self {
        self.state.compiled = true;
        self
    }

    /// Executes the next block. `None` at the end of the program, or where it cannot go on; [`Self::end`] gives which.
    #[inline]
    pub fn step<'r>(&'r mut self, program: &'r mut Program<'_>, findings: &mut Findings) -> Option<Executed<'r>> {
        while self.stop.is_none() {
            match self.advance(program, findings) {
                Ok(true) => return Some(Executed { interpreter: self, program }),
                Ok(false) => {}
                Err(stop) => {
                    self.stop = Some(stop);
                    if matches!(stop, Stop::End(_)) {
                        return Some(Executed { interpreter: self, program });
                    }
                }
            }
        }
        None
    }

    /// Executes at once what comes next of a run of blocks that only move axes straight, at most `most` of them and all
    /// but the last of the run, when nothing is to be found in them. For a program that nobody looks at block by block.
    /// Gives what these did.
    #[inline]
    pub fn pass_over<'r>(&'r mut self, program: &'r Program<'_>, most: u64) -> Option<Passed<'r>> {
        let (None, None, Some(frame)) = (self.stop, &self.pending, self.frames.last_mut()) else { return None };
        let most = most.min(program.settings.machine.limits.records.saturating_sub(self.executed + 1));
        let points = self.run.pass_over(program, frame, &mut self.state, most)?;
        self.executed += u64::from(points.stretch.count());
        Some(Passed { interpreter: self, program, points })
    }

    /// The block of the text that comes next where no call, jump or return is under way.
    pub fn next(&self) -> Option<(FileId, BlockId)> {
        self.frames.last().map(|frame| (frame.unit.file, frame.next))
    }

    /// How the program ended; `None` while it runs.
    pub const fn end(&self) -> Option<Stop> {
        self.stop
    }

    /// The first call that could not be followed: positions are not known after it.
    pub const fn lost_call(&self) -> Option<LostCall> {
        self.lost
    }

    /// Blocks executed so far.
    pub const fn executed(&self) -> u64 {
        self.executed
    }

    /// The value of a parameter after the last step; `None` when that is not known (PAR-5).
    pub fn parameter(&self, index: u8) -> Option<Decimal> {
        self.state.parameter(index)
    }

    /// The state after the last step.
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// One block: executed (`true`) or skipped.
    #[inline]
    fn advance(&mut self, program: &mut Program<'_>, findings: &mut Findings) -> Result<bool, Stop> {
        if self.pending.is_some()
            && let Some(pending) = self.pending.take()
        {
            self.proceed(program, pending)?;
        }
        let Some(frame) = self.frames.last_mut() else { return Err(Stop::Halted) };
        let (unit, block) = (frame.unit, frame.next);
        self.block.file = unit.file;
        self.block.id = block;
        let Some(file) = program.resolved.file(unit.file) else { return Err(Stop::Halted) };
        if block >= unit.end {
            self.report_missing_end(program, unit, findings);
            if self.frames.len() < 2 {
                return Err(Stop::Halted);
            }
            // A unit without its G70 ends with its last block. What was to come is not known.
            let call = self.frames.last().and_then(|frame| frame.call);
            let cut = call.map(|call| LostCall { n: call.n, l: Some(call.l), missing: false });
            self.lost = self.lost.or(cut);
            self.state.lose_by_cut(file, &unit, &program.settings.machine);
            self.run = Run::Unknown;
            self.leave();
            return Ok(false);
        }
        let flags = file.flags(block);
        if program.settings.block_skip && flags.has(BlockFlags::SKIP) {
            frame.next = block.next();
            return Ok(false);
        }
        if self.executed == program.settings.machine.limits.records {
            self.report_limit(program, findings);
            return Err(Stop::Halted);
        }
        self.count_file(unit.file);
        if flags.is_point() {
            let Self { state, frames, block: in_hand, run, .. } = self;
            let mut site =
                Site { resolved: &program.resolved, file, block, settings: program.settings, frames, findings };
            if run.execute(&mut site, state, in_hand, flags.straight()) {
                self.executed += 1;
                if let Some(frame) = self.frames.last_mut() {
                    frame.next = block.next();
                }
                return Ok(true);
            }
        }
        let stop = self.execute(program, findings, flags);
        self.executed += 1;
        self.run.unsettle(flags, &self.block);
        stop
    }

    /// Executes a block by all the rules, in their order.
    fn execute(&mut self, program: &mut Program<'_>, findings: &mut Findings, flags: BlockFlags) -> Result<bool, Stop> {
        let Self { state, frames, block, lost, .. } = self;
        let Some(file) = program.resolved.file(block.file) else { return Err(Stop::Halted) };
        let mut site =
            Site { resolved: &program.resolved, file, block: block.id, settings: program.settings, frames, findings };
        block.clear();
        state.lose_moved_unseen();
        if std::mem::take(&mut state.orients) {
            spindle::orient(site.machine(), state);
        }
        reading::read(&mut site, state, &mut block.words);
        warnings::note_retraction(&site, state, &block.words);
        functions::apply(&mut site, state, &block.words, &mut block.g);
        functions::track_origin(state, &block.words, &block.g);
        technology::hold(&site, state, &block.words);
        m_functions::apply(&mut site, state, &block.words, &block.g, &mut block.m);
        warnings::check_tool(&mut site, state, &block.words, &block.g);
        let moved = motion::apply(&mut site, state, block);
        warnings::check_correction(&mut site, state, block);
        m_functions::finish(&site, state, &block.m);
        parameters::apply(&mut site, state, block);
        let end = block.m.end;
        check_late_words(&mut site, state, &block.words, end.is_some());
        let (id, returns) = (block.id, flags.has(BlockFlags::RETURN) && frames.len() > 1);
        let next = Flow { program, findings, frames, state, block, lost }.next(moved, end.is_some());
        match end {
            Some(end) => return Err(Stop::End(end)),
            // The block itself was executed; what would follow is not.
            None if matches!(next, Next::Halt) => self.stop = Some(Stop::Halted),
            None if matches!(next, Next::Continue) && !returns => {
                if let Some(frame) = self.frames.last_mut() {
                    frame.next = id.next();
                }
            }
            None => self.pending = Some(Pending { block: id, next, returns }),
        }
        Ok(true)
    }

    /// Puts what a block does at its end into effect.
    fn proceed(&mut self, program: &Program<'_>, pending: Pending) -> Result<(), Stop> {
        let Pending { block, next, returns } = pending;
        let Some(frame) = self.frames.last_mut() else { return Err(Stop::Halted) };
        match next {
            Next::Halt => return Err(Stop::Halted),
            Next::Continue => {
                frame.next = block.next();
                if returns {
                    self.leave();
                }
            }
            // A jump leaves the unit nowhere, and so the block's G70 has nothing to end.
            Next::Jump(target) => {
                frame.next = target;
                // As its counter is armed.
                let armed = frame.counters.get(&block).filter(|counter| counter.left + 1 == counter.of);
                if let Some(counter) = armed.filter(|_| target <= block) {
                    let n = program.resolved.file(frame.unit.file).map_or(0, |file| file.shown_number(block));
                    self.repeats.note_jump(frame.unit.file, n, counter.of);
                }
            }
            Next::Call { unit, call, cycle } => {
                frame.next = block.next();
                frame.returns |= returns;
                self.repeats.note_call(&call);
                let Some(&called) = program.resolved.unit(unit) else { return Err(Stop::Halted) };
                let mut frame = Frame::new(unit, called, Some(call));
                if cycle {
                    frame.suspended_cycle = self.state.modal(GGroup::G8);
                    self.state.set_modal(GCode::G80);
                }
                self.frames.push(frame);
                self.state.said.arc_mode = false;
            }
        }
        Ok(())
    }

    /// Ends a pass of the current unit: the next pass, or back behind the call.
    fn leave(&mut self) {
        loop {
            let Some(frame) = self.frames.last_mut() else { return };
            frame.returns = false;
            if frame.next_pass() {
                return;
            }
            if let Some(cycle) = frame.suspended_cycle.take() {
                self.state.set_modal(cycle);
            }
            self.frames.pop();
            // A block that calls a macrocycle by the cycle map may itself end its unit.
            match self.frames.last() {
                Some(caller) if caller.returns => {}
                _ => return,
            }
        }
    }

    /// Gives a file its index in streams, when this is its first block.
    #[inline]
    fn count_file(&mut self, file: FileId) {
        let at = file.0 as usize;
        if !matches!(self.shown_files.get(at), Some(Some(_))) {
            self.count_new_file(at);
        }
    }

    #[cold]
    fn count_new_file(&mut self, at: usize) {
        let shown = self.shown_files.iter().flatten().count();
        if self.shown_files.len() <= at {
            self.shown_files.resize(at + 1, None);
        }
        if let Some(slot) = self.shown_files.get_mut(at) {
            *slot = u32::try_from(shown).ok();
        }
    }

    /// BLK-10: a skipped end is a missing end.
    fn report_missing_end(&self, program: &Program<'_>, unit: Unit, findings: &mut Findings) {
        let Some(file) = program.resolved.file(unit.file) else { return };
        let end = if unit.kind == UnitKind::Main { BlockFlags::END } else { BlockFlags::RETURN };
        let skipped = |block: BlockId| file.flags(block).has(end) && file.flags(block).has(BlockFlags::SKIP);
        // One that is missing was found before execution.
        if may_have_end(file, &unit) || !unit.blocks().any(skipped) {
            return;
        }
        let (finding, at) = match unit.kind {
            UnitKind::Main => {
                let last = BlockId(unit.end.0.saturating_sub(1));
                let at = program.resolved.file(unit.file).map_or(unit.entry, |file| file.n_place(last));
                (Finding::MissingProgramEnd { skipped: true, late: None, instead: None, unread: None }, at)
            }
            UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => {
                let macrocycle = matches!(unit.kind, UnitKind::Macrocycle(_));
                let (skipped, last, instead, unread) = (true, false, None, None);
                let finding = Finding::UnterminatedSubprogram { macrocycle, skipped, last, instead, unread };
                (finding, unit.entry)
            }
        };
        report(&self.frames, Diagnostic::new(finding, at), findings);
    }

    /// FLW-9: names the calls and jumps that multiply: those under way, then those that are over.
    fn report_limit(&self, program: &Program<'_>, findings: &mut Findings) {
        let mut repeats = Repeats::default();
        for frame in &self.frames {
            if let Some(call) = frame.call {
                repeats.note_call(&call);
            }
            for (block, counter) in &frame.counters {
                let target = program.resolved.target(frame.unit.file, *block);
                // A jump forward repeats nothing.
                if !matches!(target, Some(Target::Block(target)) if target > *block) {
                    let n = program.resolved.file(frame.unit.file).map_or(0, |file| file.shown_number(*block));
                    repeats.note_jump(frame.unit.file, n, counter.of);
                }
            }
        }
        let repeats = repeats.with(&self.repeats);
        let limit = program.settings.machine.limits.records;
        let finding = Finding::ExpansionLimit { limit, repeats };
        let at = program.resolved.file(self.block.file).map(|file| file.n_place(self.block.id)).unwrap_or_default();
        report(&self.frames, Diagnostic::new(finding, at), findings);
    }
}
