//! What a block calls and where it jumps, at its end (§6).

use super::executor::{Executor, Stop};
use super::frames::{CallInfo, Frame};
use super::motion::Moved;
use crate::diag::{CallKind, Diagnostic, Finding, LabelText};
use crate::dict::{GCode, GGroup};
use crate::ir::Jump;
use crate::resolve::{MacrocycleFault, Target, UnitId, UnitKind, macrocycle_finding, ring_text};
use crate::syntax::{BlockId, Word};
use crate::text::Location;

/// What a block does at its end.
#[derive(Clone, Debug)]
pub(super) enum Next {
    /// The next block.
    Continue,
    /// A block of the same unit.
    Jump(BlockId),
    /// A unit.
    Call { unit: UnitId, call: CallInfo, cycle: bool },
    /// Nothing more can be executed.
    Halt,
}

impl Executor<'_, '_> {
    /// What the block does at its end, everything else in it being done.
    pub(super) fn next(&mut self, block: BlockId, moved: Moved, ends: bool) -> Next {
        if self.words.parametric_g {
            self.check_late_words();
        }
        let flow = self.words.flow();
        if let Some(cycle) = self.mapped_cycle(moved) {
            if ends {
                let place = self.cycle_place(cycle);
                self.report(Diagnostic::new(Finding::FlowAfterEnd { function: cycle }, place));
            } else if let Some((second, word)) = flow {
                let finding = Finding::ConflictingG { first: cycle, second, group: GGroup::G7 };
                let place = self.cycle_place(cycle);
                let diagnostic = Diagnostic::new(finding, self.word_place(word));
                self.report(diagnostic.with_label(place, LabelText::InForce { function: cycle.to_string() }));
            } else {
                return self.call_cycle(cycle);
            }
        }
        match flow {
            Some((function, word)) if ends => {
                // Found before execution when both are written out.
                self.report(Diagnostic::new(Finding::FlowAfterEnd { function }, self.word_place(word)));
                Next::Continue
            }
            Some((GCode::G73, word)) => self.jump(block, word),
            Some((function, word)) => self.call(function, word),
            None => Next::Continue,
        }
    }

    /// FLW-7 and GRP-5 for blocks whose G functions only execution knows.
    fn check_late_words(&mut self) {
        if self.words.unknown_g {
            return;
        }
        let taker = self.words.written(GGroup::G7).filter(|(code, _)| *code != GCode::G70);
        match (taker, self.words.l) {
            (Some((function, word)), None) if word.is_parametric() => {
                let diagnostic = Diagnostic::new(Finding::MissingTarget { function }, self.word_place(word));
                let diagnostic = self.with_origin(diagnostic, word);
                self.report(diagnostic);
            }
            (None, Some(l)) => self.report(Diagnostic::new(Finding::UnusedTarget {}, self.word_place(l.word))),
            _ => {}
        }
        let dwell = self.words.has(GCode::G04);
        match (dwell, self.words.q, self.words.flow()) {
            (Some(word), None, _) if word.is_parametric() => {
                let diagnostic = Diagnostic::new(Finding::MissingDwell {}, self.word_place(word));
                let diagnostic = self.with_origin(diagnostic, word);
                self.report(diagnostic);
            }
            (Some(_), Some(q), Some((function, _))) => {
                self.report(Diagnostic::new(Finding::DwellTakesRepeat { function }, self.word_place(q.word)));
            }
            (None, Some(q), None) => {
                self.report(Diagnostic::new(Finding::UnusedRepeat {}, self.word_place(q.word)));
            }
            _ => {}
        }
    }

    /// The cycle that calls a macrocycle in this block (GRP-6).
    fn mapped_cycle(&self, moved: Moved) -> Option<GCode> {
        let cycle = self.in_force(GGroup::G8).filter(|code| code.is_cycle())?;
        let suspended = self.frames.iter().any(|frame| frame.suspended_cycle.is_some());
        let calls = moved == Moved::Yes && !suspended && self.settings.machine.cycles.contains_key(&cycle.number());
        calls.then_some(cycle)
    }

    /// The cycle's G word, else the `N` of the block.
    fn cycle_place(&self, cycle: GCode) -> Location {
        self.words.has(cycle).map_or_else(|| self.block_place(), |word| self.word_place(word))
    }

    fn call_cycle(&mut self, cycle: GCode) -> Next {
        let Some(&l) = self.settings.machine.cycles.get(&cycle.number()) else { return Next::Continue };
        let place = self.cycle_place(cycle);
        let unit = match self.load_macrocycle(l) {
            Ok(unit) => unit,
            Err(fault) => return self.no_macrocycle(fault, l, place, None),
        };
        self.enter(unit, CallKind::Cycle(cycle.number()), l, 1, place, true, None)
    }

    /// G71 and G72 (FLW-1).
    fn call(&mut self, function: GCode, word: Word) -> Next {
        let Some(l) = self.words.l else { return Next::Halt };
        let Some(number) = l.value.and_then(|value| value.as_whole()).and_then(|value| u32::try_from(value).ok())
        else {
            return Next::Halt;
        };
        let (Some(count), place) = (self.repeats(), self.value_or_word(l.word)) else { return Next::Halt };
        let known = (!word.is_parametric() && !l.word.is_parametric())
            .then(|| self.resolved.target(self.file, self.block))
            .flatten();
        let by = if function == GCode::G71 { CallKind::Subprogram } else { CallKind::Macrocycle };
        let unit = match known {
            Some(Target::Unit(unit)) => unit,
            _ if function == GCode::G71 => match self.find_subprogram(number, l.word, place) {
                Some(unit) => unit,
                None => return Next::Halt,
            },
            _ => match self.load_macrocycle(number) {
                Ok(unit) => unit,
                Err(fault) => return self.no_macrocycle(fault, number, place, Some(l.word)),
            },
        };
        let at = self.word_place(l.word);
        self.enter(unit, by, number, count, at, false, Some(l.word))
    }

    /// How many times a call is made: Q, once without it or with G04 (FLW-1, FLW-6). `None`: unknown.
    fn repeats(&self) -> Option<u32> {
        if self.words.has(GCode::G04).is_some() {
            return Some(1);
        }
        match self.words.q {
            None => Some(1),
            Some(q) => q.value.and_then(|value| value.as_whole()).and_then(|value| u32::try_from(value).ok()),
        }
    }

    fn find_subprogram(&mut self, l: u32, word: Word, place: Location) -> Option<UnitId> {
        let from_macrocycle =
            self.frames.last().is_some_and(|frame| matches!(frame.unit.kind, UnitKind::Macrocycle(_)));
        if let (Some(unit), false) = (self.resolved.subprogram(l), from_macrocycle) {
            return Some(unit);
        }
        let finding = Finding::UnknownSubprogram {
            l,
            near: self.resolved.nearest_subprogram(l),
            macrocycle: self.library.find(l).is_ok(),
            from_macrocycle,
            without_entry: None,
        };
        let diagnostic = self.with_origin(Diagnostic::new(finding, place), word);
        self.report(diagnostic);
        None
    }

    fn load_macrocycle(&mut self, l: u32) -> Result<UnitId, MacrocycleFault> {
        let faults = self.findings.fault_count();
        let unit = self.resolved.load_macrocycle(l, self.settings, self.library, self.sources, self.findings);
        self.broken_macrocycle |= self.findings.fault_count() > faults;
        unit
    }

    fn no_macrocycle(&mut self, fault: MacrocycleFault, l: u32, place: Location, word: Option<Word>) -> Next {
        let subprogram = self.resolved.subprogram(l).is_some();
        let mut diagnostic = Diagnostic::new(macrocycle_finding(fault, l, subprogram, 1), place);
        if let Some(word) = word {
            diagnostic = self.with_origin(diagnostic, word);
        }
        self.report(diagnostic);
        Next::Halt
    }

    /// Calls a unit, unless it still runs or too many calls are open (FLW-2).
    #[expect(clippy::too_many_arguments, reason = "the facts of one call")]
    fn enter(
        &mut self,
        unit: UnitId,
        by: CallKind,
        l: u32,
        of: u32,
        place: Location,
        cycle: bool,
        word: Option<Word>,
    ) -> Next {
        if self.broken_macrocycle {
            return Next::Halt;
        }
        if let Some(ring) = self.ring(unit) {
            let mut diagnostic = Diagnostic::new(Finding::RecursiveCall { ring }, place);
            if let Some(word) = word {
                diagnostic = self.with_origin(diagnostic, word);
            }
            self.report(diagnostic);
            return Next::Halt;
        }
        let limit = self.settings.machine.limits.nesting;
        if self.frames.len() > limit as usize {
            self.report(Diagnostic::new(Finding::NestingTooDeep { limit }, place));
            return Next::Halt;
        }
        let n = self.block_number();
        let call = CallInfo { by, l, file: self.file, n, at: self.block_place(), pass: 1, of };
        Next::Call { unit, call, cycle }
    }

    /// The units from `unit` on to it again, when it still runs.
    fn ring(&self, unit: UnitId) -> Option<String> {
        let from = self.frames.iter().position(|frame| frame.id == unit)?;
        let units: Vec<UnitId> = self.frames.iter().skip(from).map(|frame| frame.id).chain([unit]).collect();
        Some(ring_text(self.resolved, &units))
    }

    /// G73 (FLW-3, FLW-4).
    fn jump(&mut self, block: BlockId, word: Word) -> Next {
        let Some(l) = self.words.l else { return Next::Halt };
        let Some(number) = l.value.and_then(|value| value.as_whole()).and_then(|value| u32::try_from(value).ok())
        else {
            return Next::Halt;
        };
        let known = (!word.is_parametric() && !l.word.is_parametric())
            .then(|| self.resolved.target(self.file, block))
            .flatten();
        let target = match known {
            Some(Target::Block(target)) => target,
            _ => match self.find_block(number, l.word) {
                Some(target) => target,
                None => return Next::Halt,
            },
        };
        let forward = target > block;
        let dwell = self.words.has(GCode::G04).is_some();
        if forward && self.words.q.is_none() && !dwell {
            self.record.jump = Some(Jump { to: number, left: None });
            return Next::Jump(target);
        }
        let armed = self.frames.last().is_some_and(|frame| frame.counters.contains_key(&block));
        // Q is read when the counter is armed (§13 Parameters).
        let count = match self.repeats() {
            Some(count) => count,
            None if armed => 0,
            None => return Next::Halt,
        };
        let Some(left) = self.frames.last_mut().and_then(|frame| frame.arrive(block, || count)) else {
            return Next::Continue;
        };
        self.record.jump = Some(Jump { to: number, left: Some(left) });
        Next::Jump(target)
    }

    /// The block of the unit in hand with that number, which a parameter gave.
    fn find_block(&mut self, number: u32, word: Word) -> Option<BlockId> {
        let unit = self.frames.last()?.unit;
        let found = self.resolved.numbered(self.file, number);
        let place = self.word_place(word);
        let diagnostic = match found {
            Some(block) if unit.contains(block) => return Some(block),
            Some(block) => {
                let there = self.resolved.file(self.file).map(|file| file.n_place(block)).unwrap_or_default();
                Diagnostic::new(Finding::JumpOutOfUnit { l: number }, place)
                    .with_label(there, LabelText::BlockHere { block: number })
            }
            None => {
                let near = self.resolved.nearest_block(&unit, number);
                Diagnostic::new(Finding::UnknownJumpTarget { l: number, near }, place)
            }
        };
        let diagnostic = self.with_origin(diagnostic, word);
        self.report(diagnostic);
        None
    }

    /// Puts what a block does at its end into effect. `returns`: the block holds G70.
    pub(super) fn proceed(&mut self, block: BlockId, next: Next, returns: bool) -> Result<(), Stop> {
        match next {
            Next::Halt => return Err(Stop::Halted),
            Next::Continue => {
                if let Some(frame) = self.frames.last_mut() {
                    frame.next = block.next();
                }
            }
            Next::Jump(target) => {
                if let Some(frame) = self.frames.last_mut() {
                    frame.next = target;
                }
                // A jump leaves the unit nowhere, and so the block's G70 has nothing to end.
                return Ok(());
            }
            Next::Call { unit, call, cycle } => {
                if let Some(frame) = self.frames.last_mut() {
                    frame.next = block.next();
                    frame.returns |= returns;
                }
                let Some(&called) = self.resolved.unit(unit) else { return Err(Stop::Halted) };
                let mut frame = Frame::new(unit, called, Some(call));
                if cycle {
                    frame.suspended_cycle = self.state.modal(GGroup::G8);
                    self.state.set_modal(GCode::G80);
                }
                self.frames.push(frame);
                self.calls_changed = true;
                return Ok(());
            }
        }
        if returns {
            self.leave();
        }
        Ok(())
    }

    /// Ends a pass of the unit in hand: the next pass, or back behind the call.
    fn leave(&mut self) {
        loop {
            self.calls_changed = true;
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
}
