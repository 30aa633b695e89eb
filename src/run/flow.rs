//! The calls and jumps at the end of a block (§6).

use super::block::{Block, Jump};
use super::frames::{CallInfo, Frame};
use super::motion::Moved;
use super::parameters::with_origin;
use super::program::Program;
use super::site::{Site, call_sites, report};
use super::state::State;
use super::words::BlockWords;
use crate::config::MayMove;
use crate::diag::{CallKind, Diagnostic, Finding, Findings, LabelText};
use crate::dict::{Address, Decimal, GCode, GGroup, Plane};
use crate::resolve::{
    Known, MacrocycleFault, Namesake, Roles, Target, UnitId, UnitKind, jump_target, macrocycle_finding, ring_text,
    subprogram, value_or_word,
};
use crate::syntax::{BlockId, ParsedFile, Value, Word};
use crate::text::Location;

/// A call that cannot be followed: what it would have done is not known after it.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct LostCall {
    /// The number of the calling block.
    pub n: u32,
    /// The called unit, where that is known.
    pub l: Option<u32>,
    /// That does not exist.
    pub missing: bool,
}

/// The effect of a block at its end.
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

/// What L, Q and G04 need, in a block whose G functions only execution knows (FLW-7, GRP-5, PRG-2).
pub(super) fn check_late_words(site: &mut Site<'_>, state: &State, words: &BlockWords, ends: bool) {
    if words.unknown_g || !words.parametric_g {
        return;
    }
    words.roles().check(ends, |word, finding| {
        let diagnostic = Diagnostic::new(finding, site.word_place(word));
        site.report(with_origin(state, diagnostic, word));
    });
}

/// Input of the rules of calls and jumps: one block, after all else in it.
pub(super) struct Flow<'e, 'p> {
    pub(super) program: &'e mut Program<'p>,
    pub(super) findings: &'e mut Findings,
    pub(super) frames: &'e mut Vec<Frame>,
    pub(super) state: &'e mut State,
    pub(super) block: &'e mut Block,
    /// The first call that could not be followed.
    pub(super) lost: &'e mut Option<LostCall>,
}

impl Flow<'_, '_> {
    /// Decides the continuation after the block. `ends`: it holds M02 or M30.
    pub(super) fn next(&mut self, moved: Moved, ends: bool) -> Next {
        let words = &self.block.words;
        // Nobody knows what is called, or whether something is.
        let unknown = words.clashes.has(GGroup::G7) || (words.malformed_g && words.l.is_some());
        if unknown && !ends {
            let words = self.file().map_or(&[][..], |file| file.words(self.block.id));
            let machine = words.iter().any(|word| word.address == Address::G && self.is_of_machine(*word));
            return if machine { Next::Halt } else { self.lose(None) };
        }
        let roles = if words.written(GGroup::G7).is_some() { words.roles() } else { Roles::default() };
        let flow = roles.flow();
        if let Some(cycle) = self.mapped_cycle(moved) {
            if ends {
                let place = self.cycle_place(cycle);
                self.report(Diagnostic::new(Finding::FlowAfterEnd { function: cycle }, place));
            } else if let Some((second, word)) = flow {
                let finding = Finding::ConflictingG { first: cycle, second, group: GGroup::G7, unnumbered: false };
                let place = self.cycle_place(cycle);
                let diagnostic = Diagnostic::new(finding, self.word_place(word));
                self.report(diagnostic.with_label(place, LabelText::InForce { function: cycle.to_string() }));
            } else {
                return self.call_cycle(cycle);
            }
        }
        match flow {
            // Reported with the words of the block.
            Some(_) if ends => Next::Continue,
            Some((GCode::G73, word)) => self.jump(word, &roles),
            Some((function, word)) => self.call(function, word, &roles),
            None => Next::Continue,
        }
    }

    /// The cycle that calls a macrocycle in this block (GRP-6).
    fn mapped_cycle(&self, moved: Moved) -> Option<GCode> {
        let cycle = self.block.g.of(GGroup::G8).filter(|code| code.is_cycle())?;
        let suspended = self.frames.iter().any(|frame| frame.suspended_cycle.is_some());
        let mapped = self.program.settings.machine.cycles.contains_key(&cycle.number());
        (moved == Moved::Yes && !suspended && mapped).then_some(cycle)
    }

    /// The cycle's G word, else the `N` of the block.
    fn cycle_place(&self, cycle: GCode) -> Location {
        self.block.words.has(cycle).map_or_else(|| self.block_place(), |word| self.word_place(word))
    }

    fn call_cycle(&mut self, cycle: GCode) -> Next {
        let Some(&l) = self.program.settings.machine.cycles.get(&cycle.number()) else { return Next::Continue };
        self.warn_of_plunge(cycle, l);
        let place = self.cycle_place(cycle);
        match self.load_macrocycle(l) {
            Ok(unit) => self.enter(unit, self.call_info(CallKind::Cycle(cycle.number()), l, 1), place, None),
            Err(fault) => self.no_macrocycle(fault, l, place, None),
        }
    }

    /// W0626: the block's own motion goes to the depth of the cycle first, in rapid.
    fn warn_of_plunge(&mut self, cycle: GCode, l: u32) {
        let g = &self.block.g;
        let plane = g.of(GGroup::G1).and_then(Plane::of).filter(|_| g.of(GGroup::G0) == Some(GCode::G00));
        let Some(axis) = plane.and_then(Plane::perpendicular) else { return };
        let place = self.program.settings.machine.axes.index(axis);
        let Some(Some(word)) = place.and_then(|place| self.block.words.axes.get(place)) else { return };
        let at = self.word_place(word.word);
        self.report(Diagnostic::new(Finding::CycleBlockPlunges { cycle, axis: axis.letter(), l }, at));
    }

    /// G71 and G72 (FLW-1).
    fn call(&mut self, function: GCode, word: Word, roles: &Roles) -> Next {
        let Some(l) = self.block.words.l else { return self.lose(None) };
        let (Some(number), Some(count)) = (whole(l.value), self.repeats(roles)) else {
            let machine = self.is_of_machine(l.word) || self.repeat_is_of_machine(roles);
            return if machine { Next::Halt } else { self.lose(whole(l.value)) };
        };
        self.block.call_count = count;
        let place = self.file().map(|file| value_or_word(file, l.word)).unwrap_or_default();
        let by = if function == GCode::G71 { CallKind::Subprogram } else { CallKind::Macrocycle };
        if function == GCode::G71 && word.is_parametric() {
            self.warn_of_inner_call(number, word);
        }
        let unit = match self.written_target(word, l.word) {
            Some(Target::Unit(unit)) => unit,
            _ if function == GCode::G72 && self.program.library.is_of_machine(number) => {
                return self.call_opaque(number, place, Some(l.word));
            }
            // Found before execution.
            _ if !word.is_parametric() && !l.word.is_parametric() => return self.lose_missing(number),
            _ if function == GCode::G71 => match self.find_subprogram(number, l.word, place) {
                Some(unit) => unit,
                None => return self.lose_missing(number),
            },
            _ => match self.load_macrocycle(number) {
                Ok(unit) => unit,
                Err(fault) => return self.no_macrocycle(fault, number, place, Some(l.word)),
            },
        };
        self.enter(unit, self.call_info(by, number, count), self.word_place(l.word), Some(l.word))
    }

    /// FLW-2: a subprogram called from a subprogram by a G71 that a parameter gives; the written ones are found before.
    fn warn_of_inner_call(&mut self, l: u32, word: Word) {
        let Some(UnitKind::Subprogram(own)) = self.frames.last().map(|frame| frame.unit.kind) else { return };
        if own != Some(l) && self.program.resolved.is_first_inner_call() {
            let finding = Finding::SubprogramCallsSubprogram { l: Some(l) };
            let diagnostic = Diagnostic::new(finding, self.word_place(word));
            self.report(with_origin(self.state, diagnostic, word));
        }
    }

    /// Where the call or jump leads, when `resolve` knows it: function and target are written with digits.
    fn written_target(&self, function: Word, l: Word) -> Option<Target> {
        let written = !function.is_parametric() && !l.is_parametric();
        written.then(|| self.program.resolved.target(self.block.file, self.block.id)).flatten()
    }

    /// How many times a call is made: Q, once without it or with G04 (FLW-1, FLW-6). `None`: unknown.
    fn repeats(&self, roles: &Roles) -> Option<u32> {
        match roles.repeat() {
            Some(_) => whole(self.block.words.q.and_then(|q| q.value)),
            None => Some(1),
        }
    }

    fn find_subprogram(&mut self, l: u32, word: Word, place: Location) -> Option<UnitId> {
        let unit = self.frames.last()?.unit;
        let Program { resolved, library, .. } = self.program;
        match subprogram(resolved, library, &unit, l, place) {
            Known::Yes(unit) => Some(unit),
            Known::No(diagnostic) => {
                self.report(with_origin(self.state, *diagnostic, word));
                None
            }
            Known::Unknown => None,
        }
    }

    fn load_macrocycle(&mut self, l: u32) -> Result<UnitId, MacrocycleFault> {
        self.program.macrocycle(l, self.findings)
    }

    fn no_macrocycle(&mut self, fault: MacrocycleFault, l: u32, place: Location, word: Option<Word>) -> Next {
        if matches!(fault, MacrocycleFault::OfMachine { .. }) {
            return self.call_opaque(l, place, word);
        }
        if self.state.said.no_macrocycle.insert(l) && !self.is_said(l) {
            let subprogram = self.program.resolved.subprogram(l).is_some();
            let namesake = Namesake { subprogram, block: false };
            let diagnostic = Diagnostic::new(macrocycle_finding(fault, l, namesake, 1), place);
            self.report(self.with_origin_of(diagnostic, word));
        }
        self.lose_missing(l)
    }

    /// A macrocycle that only the machine has: the axes that it may move are unknown after it (FLW-12).
    fn call_opaque(&mut self, l: u32, place: Location, word: Option<Word>) -> Next {
        let machine = &self.program.settings.machine;
        let may_move = machine.macrocycles.get(&l);
        if let Some(may) = may_move {
            for (place, _) in machine.axes.iter().enumerate().filter(|(_, axis)| may.moves(axis.letter)) {
                self.state.moved_unseen.insert(place);
            }
        }
        self.block.opaque_call = Some(l);
        if self.state.said.of_machine.insert(l) {
            let axes_named = may_move.is_some_and(MayMove::names_axes);
            let fault = MacrocycleFault::OfMachine { axes_named };
            let diagnostic = Diagnostic::new(macrocycle_finding(fault, l, Namesake::default(), 1), place);
            let mut diagnostic = self.with_origin_of(diagnostic, word);
            diagnostic.calls = call_sites(self.frames);
            self.findings.add_of_machine(diagnostic);
        }
        Next::Continue
    }

    /// Calls a unit, unless it still runs or too many calls are open (FLW-2). `word`: what names it.
    fn enter(&mut self, unit: UnitId, call: CallInfo, place: Location, word: Option<Word>) -> Next {
        if let Some(ring) = self.ring(unit) {
            let diagnostic = Diagnostic::new(Finding::RecursiveCall { ring }, place);
            self.report(self.with_origin_of(diagnostic, word));
            return self.lose(Some(call.l));
        }
        if self.program.resolved.unit(unit).is_some_and(|unit| unit.first == unit.end) {
            return self.lose(Some(call.l));
        }
        let limit = self.program.settings.machine.limits.nesting;
        if self.frames.len() > limit as usize {
            self.report(Diagnostic::new(Finding::NestingTooDeep { limit }, place));
            return Next::Halt;
        }
        Next::Call { unit, call, cycle: matches!(call.by, CallKind::Cycle(_)) }
    }

    fn call_info(&self, by: CallKind, l: u32, of: u32) -> CallInfo {
        let n = self.file().map_or(0, |file| file.shown_number(self.block.id));
        CallInfo { by, l, file: self.block.file, n, at: self.block_place(), pass: 1, of }
    }

    /// The units from `unit` on to it again, when it still runs.
    fn ring(&self, unit: UnitId) -> Option<String> {
        let from = self.frames.iter().position(|frame| frame.id == unit)?;
        let units: Vec<UnitId> = self.frames.iter().skip(from).map(|frame| frame.id).chain([unit]).collect();
        Some(ring_text(&self.program.resolved, &units))
    }

    /// G73 (FLW-3, FLW-4).
    fn jump(&mut self, word: Word, roles: &Roles) -> Next {
        let block = self.block.id;
        let Some(l) = self.block.words.l else { return Next::Continue };
        let Some(number) = whole(l.value) else {
            return if self.is_of_machine(l.word) { Next::Halt } else { Next::Continue };
        };
        let target = match self.written_target(word, l.word) {
            Some(Target::Block(target)) => target,
            // Found before execution.
            _ if !word.is_parametric() && !l.word.is_parametric() => return Next::Continue,
            _ => match self.find_block(number, l.word) {
                Some(target) => target,
                None => return Next::Continue,
            },
        };
        if target > block && roles.is_uncounted() {
            self.block.jump = Some(Jump { to: number, left: None });
            return Next::Jump(target);
        }
        let armed = self.frames.last().is_some_and(|frame| frame.counters.contains_key(&block));
        // Q is read when the counter is armed (§13 Parameters).
        let count = match self.repeats(roles) {
            Some(count) => count,
            None if armed => 0,
            None if self.repeat_is_of_machine(roles) => return Next::Halt,
            None => return Next::Continue,
        };
        let Some(left) = self.frames.last_mut().and_then(|frame| frame.arrive(block, || count)) else {
            return Next::Continue;
        };
        self.block.jump = Some(Jump { to: number, left: Some(left) });
        Next::Jump(target)
    }

    /// Goes on behind a call that cannot be followed: nothing that it may have set is known (§13).
    fn lose(&mut self, l: Option<u32>) -> Next {
        self.lose_to(l, false)
    }

    /// The same, because what it calls does not exist.
    fn lose_missing(&mut self, l: u32) -> Next {
        self.lose_to(Some(l), true)
    }

    fn lose_to(&mut self, l: Option<u32>, missing: bool) -> Next {
        let n = self.file().map_or(0, |file| file.shown_number(self.block.id));
        self.lost.get_or_insert(LostCall { n, l, missing });
        self.state.lose_by_call();
        Next::Continue
    }

    /// Whether a word has the value of a parameter that only the machine knows (PAR-5).
    fn is_of_machine(&self, word: Word) -> bool {
        let Value::Parameter { index, .. } = word.value() else { return false };
        let parameter = self.state.parameters.get(usize::from(index));
        !word.is_void() && parameter.is_none_or(|parameter| parameter.value.is_none())
    }

    fn repeat_is_of_machine(&self, roles: &Roles) -> bool {
        roles.repeat().is_some() && self.block.words.q.is_some_and(|q| self.is_of_machine(q.word))
    }

    /// Whether that a macrocycle is missing was found before execution.
    fn is_said(&self, l: u32) -> bool {
        let of = |found: &Diagnostic| {
            let (Finding::UnknownMacrocycle { l: known, .. } | Finding::DuplicateMacrocycle { l: known, .. }) =
                &found.finding
            else {
                return false;
            };
            *known == l
        };
        self.findings.items().iter().any(of)
    }

    /// The block of the current unit with that number, which a parameter gave.
    fn find_block(&mut self, number: u32, word: Word) -> Option<BlockId> {
        let unit = self.frames.last()?.unit;
        let place = self.file().map(|file| value_or_word(file, word)).unwrap_or_default();
        match jump_target(&self.program.resolved, &unit, number, place) {
            Known::Yes(block) => Some(block),
            Known::No(diagnostic) => {
                self.report(with_origin(self.state, *diagnostic, word));
                None
            }
            Known::Unknown => None,
        }
    }

    fn file(&self) -> Option<&ParsedFile> {
        self.program.resolved.file(self.block.file)
    }

    fn block_place(&self) -> Location {
        self.file().map(|file| file.n_place(self.block.id)).unwrap_or_default()
    }

    fn word_place(&self, word: Word) -> Location {
        self.file().map(|file| file.word_place(word)).unwrap_or_default()
    }

    fn with_origin_of(&self, diagnostic: Diagnostic, word: Option<Word>) -> Diagnostic {
        match word {
            Some(word) => with_origin(self.state, diagnostic, word),
            None => diagnostic,
        }
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        report(self.frames, diagnostic, self.findings);
    }
}

fn whole(value: Option<Decimal>) -> Option<u32> {
    value.and_then(Decimal::as_whole).and_then(|value| u32::try_from(value).ok())
}
