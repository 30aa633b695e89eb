//! Collects the words of a block and puts its G functions into force.

use super::executor::Executor;
use super::state::Held;
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{Address, GCode, GGroup, Lasting};
use crate::syntax::{BlockId, Word};

impl Executor<'_, '_> {
    /// Reads the words of a block, all with the values from before it (PAR-4).
    pub(super) fn collect(&mut self, block: BlockId) {
        self.words.clear();
        let Some(file) = self.resolved.file(self.file) else { return };
        let mut written = std::mem::take(&mut self.written);
        written.clear();
        written.extend_from_slice(file.words(block));
        let mut late = false;
        for &word in &written {
            if let Some(axis) = self.settings.machine.axes.index_of(word.address) {
                let valued = self.evaluate_form(word, false, None);
                if let Some(slot) = self.words.axes.get_mut(axis) {
                    self.words.axis_count += usize::from(slot.is_none());
                    *slot = Some(valued);
                }
                continue;
            }
            match word.address {
                Address::G => self.collect_g(word),
                Address::M => self.collect_m(word),
                Address::R => self.words.r.push(word),
                Address::Skip => self.words.skippable = true,
                // What F and Q mean follows from G words that may come later.
                Address::F | Address::Q => late = true,
                Address::I => self.words.i = Some(self.evaluate_form(word, false, None)),
                Address::J => self.words.j = Some(self.evaluate_form(word, false, None)),
                Address::K => self.words.k = Some(self.evaluate_form(word, false, None)),
                Address::S => self.words.s = Some(self.evaluate_form(word, false, None)),
                Address::T => self.words.t = Some(self.evaluate_form(word, false, None)),
                Address::H => self.words.h = Some(self.evaluate_form(word, false, None)),
                Address::P => self.words.p = Some(self.evaluate_form(word, false, None)),
                Address::D => self.words.d = Some(self.evaluate_form(word, false, None)),
                Address::Correction => self.words.correction = Some(self.evaluate_form(word, false, None)),
                Address::L => self.words.l = Some(self.evaluate_form(word, false, None)),
                Address::X
                | Address::Y
                | Address::Z
                | Address::A
                | Address::B
                | Address::C
                | Address::U
                | Address::V
                | Address::W
                | Address::N
                | Address::Program => {}
            }
        }
        if late {
            for &word in written.iter().filter(|word| matches!(word.address, Address::F | Address::Q)) {
                self.collect_late(word);
            }
        }
        self.written = written;
    }

    fn collect_late(&mut self, word: Word) {
        if word.address == Address::F {
            // TEC-1: the G6 function in force in the block that writes F decides.
            let written = self.words.written(GGroup::G6).map(|(code, _)| code);
            let mode = written.or_else(|| self.state.modal(GGroup::G6)).filter(|_| !self.words.unknown_g);
            self.words.f = Some(self.evaluate_form(word, false, mode));
            return;
        }
        let dwell = self.words.has(GCode::G04).is_some() || self.words.unknown_g;
        self.words.q = Some(self.evaluate_form(word, dwell, None));
    }

    fn collect_g(&mut self, word: Word) {
        self.words.parametric_g |= word.is_parametric();
        let Some(code) = self.evaluate_g(word) else { return };
        if let Some((first, first_word)) = self.words.written(code.group()) {
            // Found before execution when both are written out.
            let finding = Finding::ConflictingG { first, second: code, group: code.group() };
            let diagnostic = Diagnostic::new(finding, self.word_place(word));
            let diagnostic = diagnostic.with_label(self.word_place(first_word), LabelText::First);
            let diagnostic = self.with_origin(diagnostic, word);
            let diagnostic = self.with_origin(diagnostic, first_word);
            self.report(diagnostic);
            return;
        }
        self.words.g.push((code, word));
    }

    fn collect_m(&mut self, word: Word) {
        let Some(number) = self.evaluate_m(word) else { return };
        let functions = &self.settings.machine.m_functions;
        let group = functions.group(number);
        let conflict = self.words.m.iter().copied().find(|(other, _)| functions.group(*other) == group);
        if let Some((first, first_word)) = conflict {
            let finding = Finding::ConflictingM { first, second: number, group };
            let diagnostic = Diagnostic::new(finding, self.word_place(word));
            let diagnostic = diagnostic.with_label(self.word_place(first_word), LabelText::First);
            let diagnostic = self.with_origin(diagnostic, word);
            let diagnostic = self.with_origin(diagnostic, first_word);
            self.report(diagnostic);
            return;
        }
        self.words.m.push((number, word));
    }

    /// Puts the G functions of the block into force; x functions hold in it only.
    pub(super) fn apply_g(&mut self) {
        for place in 0..self.words.g.len() {
            let Some(&(code, word)) = self.words.g.get(place) else { break };
            match code.lasting() {
                Lasting::Modal | Lasting::Default => self.state.set_modal(code),
                Lasting::Block => {}
            }
            self.warn_unmodelled(code, word);
        }
        let Self { in_force, state, record, words, .. } = self;
        // Hardly any of them changes from one block to the next.
        for ((slot, shown), held) in in_force.iter_mut().zip(&mut record.g).zip(state.g) {
            if *slot != held {
                (*slot, *shown) = (held, held.map(GCode::number));
            }
        }
        record.g_set.clear();
        for (code, _) in &words.g {
            let group = code.group().index();
            if let (Some(slot), Some(shown)) = (in_force.get_mut(group), record.g.get_mut(group)) {
                (*slot, *shown) = (Some(*code), Some(code.number()));
            }
            record.g_set.push(code.number());
        }
    }

    /// The function of a group in this block, x functions included.
    #[inline]
    pub(super) fn in_force(&self, group: GGroup) -> Option<GCode> {
        self.in_force.get(group.index()).copied().flatten()
    }

    /// GRP-8: what G05–G08 do is not modelled; said once of each.
    fn warn_unmodelled(&mut self, code: GCode, word: Word) {
        if !code.is_modelled() && !self.unmodelled_warned.contains(&code) {
            self.unmodelled_warned.push(code);
            self.report(Diagnostic::new(Finding::FunctionNotModelled { function: code }, self.word_place(word)));
        }
    }

    /// Notes whether the origin, a conversion or a correction changed since the block before (MOT-8).
    pub(super) fn track_origin(&mut self) {
        let origin = (self.in_force(GGroup::G5), self.in_force(GGroup::G11));
        let mut changed = origin != self.state.last_origin;
        self.state.last_origin = origin;
        let active = |held: Held| !matches!(held, Held::None) && held.value() != Some(crate::dict::Decimal::ZERO);
        let corrected = active(self.state.correction);
        if let Some(word) = self.words.correction {
            let new = Held::of(word.value);
            changed |= new != self.state.correction && (active(new) || corrected);
            self.state.correction = new;
        }
        if let Some(word) = self.words.d {
            let new = Held::of(word.value);
            changed |= corrected && new != self.state.d;
            self.state.d = new;
        }
        self.state.origin_changed |= changed;
    }
}
