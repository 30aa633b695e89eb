//! Feed, speed, tool, auxiliary and M functions of a block (§8, §9).

use super::executor::Executor;
use super::state::{Held, Position};
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{Address, Decimal, GCode, GGroup, M_GROUPS, Micro, PROGRAM_ENDS};
use crate::ir::MStop;
use crate::text::Location;

/// Groups whose value is shown only in the block that programs them (MFN-6).
const MOMENTARY: [usize; 3] = [1, 7, 9];

impl Executor<'_, '_> {
    /// F, S, T, H, P (D and `&` belong to the origin).
    pub(super) fn apply_words(&mut self) {
        let (words, state) = (&self.words, &mut self.state);
        let hold = |word: Option<super::block::Valued>, held: &mut Held| {
            if let Some(word) = word {
                *held = Held::of(word.value);
            }
        };
        hold(words.f, &mut state.feed);
        hold(words.s, &mut state.speed);
        hold(words.t, &mut state.tool);
        hold(words.h, &mut state.h);
        hold(words.p, &mut state.p);
    }

    /// The M functions of the block (MFN-6…MFN-10). Gives the program end, when one of them is.
    pub(super) fn apply_m(&mut self) -> Option<u8> {
        if self.words.m.is_empty() && self.words.s.is_none() && self.m_settled {
            self.moves_by_m = false;
            return None;
        }
        self.m_settled = self.words.m.is_empty();
        let mut end = None;
        let mut stop = None;
        let mut changed = [false; M_GROUPS];
        let mut moves = false;
        if self.wants_records {
            self.record.m_set.clear();
            self.record.m_changed.clear();
            (self.record.break_cont, self.record.break_cont_end) = (false, false);
        }
        for place in 0..self.words.m.len() {
            let Some(&(number, word)) = self.words.m.get(place) else { break };
            let Some(function) = self.settings.machine.m_functions.get(number) else { continue };
            let group = usize::from(function.group);
            if let (Some(held), Some(changed)) = (self.state.m.get_mut(group), changed.get_mut(group)) {
                *held = Some(number);
                *changed = true;
            }
            moves |= function.change_pos;
            if self.wants_records {
                self.record.m_set.push(number);
                self.record.break_cont |= function.break_cont;
                self.record.break_cont_end |= function.break_cont_end;
            }
            match number {
                0 | 1 => stop = Some(number),
                6 => self.state.in_spindle = self.state.tool,
                19 if !self.settings.machine.oriented_stop => {
                    self.report(Diagnostic::new(Finding::OrientedStopUnavailable {}, self.word_place(word)));
                }
                number if PROGRAM_ENDS.contains(&number) => end = Some(number),
                _ => {}
            }
        }
        if end.is_some() {
            self.reset_m(&mut changed);
        }
        self.check_gear();
        if self.wants_records {
            self.record.m = self.state.m;
            self.record.m_changed.extend((0..15).filter(|group| changed.get(usize::from(*group)) == Some(&true)));
            self.record.change_pos = moves;
            self.record.stop = stop == Some(0);
            self.record.cond_stop = stop == Some(1);
            let halts = stop == Some(0) || (stop == Some(1) && self.settings.optional_stop);
            self.record.m_at_stop = halts.then(|| self.m_at_stop());
            self.record.gear = self.gear();
        }
        for group in MOMENTARY {
            if let Some(held) = self.state.m.get_mut(group) {
                *held = None;
            }
        }
        self.moves_by_m = moves;
        end
    }

    /// M02 and M30 set the groups to their `+` values, and mark those that change (MFN-6, MFN-7).
    fn reset_m(&mut self, changed: &mut [bool; M_GROUPS]) {
        let defaults = *self.settings.machine.m_functions.defaults();
        for ((held, default), changed) in self.state.m.iter_mut().zip(defaults).zip(changed) {
            if let Some(default) = default {
                *changed |= *held != Some(default);
                *held = Some(default);
            }
        }
    }

    fn m_at_stop(&self) -> MStop {
        let default = |group: usize| self.settings.machine.m_functions.defaults().get(group).copied().flatten();
        MStop {
            spindle: default(2).unwrap_or(5),
            coolant_12: default(5).unwrap_or(9),
            coolant_34: default(6).unwrap_or(53),
        }
    }

    /// The range in force, or the one that M40 chooses by S (MFN-9).
    fn gear(&self) -> Option<u8> {
        match self.state.m(3) {
            Some(m @ 41..=44) => Some(m - 40),
            Some(40) => {
                let speed = self.state.speed.value()?.as_whole()?;
                let gears = &self.settings.machine.gears;
                let fits = |gear: &&crate::config::Gear| i64::from(gear.min) <= speed && speed <= i64::from(gear.max);
                gears.iter().filter(fits).map(|gear| gear.m - 40).min()
            }
            Some(_) | None => None,
        }
    }

    /// S outside the range of the gear programmed (MFN-9): in blocks that write S or M41–M44.
    fn check_gear(&mut self) {
        let Some(m @ 41..=44) = self.state.m(3) else { return };
        let m_word = self.words.m.iter().find(|(number, _)| (41..=44).contains(number)).map(|(_, word)| *word);
        let s_word = self.words.s.map(|valued| valued.word);
        let Some(word) = s_word.or(m_word) else { return };
        let gear = self.settings.machine.gears.iter().copied().find(|gear| gear.m == m);
        let speed = self.state.speed.value().and_then(Decimal::as_whole).and_then(|speed| u32::try_from(speed).ok());
        let (Some(gear), Some(s)) = (gear, speed) else { return };
        if gear.min <= s && s <= gear.max {
            return;
        }
        let finding = Finding::SpeedOutsideGear { s, m, min: gear.min, max: gear.max };
        let mut diagnostic = Diagnostic::new(finding, self.word_place(word));
        if let (Some(m_word), Some(_)) = (m_word, s_word) {
            diagnostic = diagnostic.with_label(self.word_place(m_word), LabelText::GearHere { m });
        }
        let diagnostic = self.with_origin(diagnostic, word);
        self.report(diagnostic);
    }

    /// After a block that moves the machine by an M function all positions are unknown (MFN-4).
    pub(super) fn forget_positions(&mut self) {
        if self.moves_by_m {
            self.state.positions = [Position::Unknown; 9];
        }
    }

    /// The dwell, in units of 10 ms (GRP-5).
    pub(super) fn dwell(&mut self) -> Option<Micro> {
        self.words.has(GCode::G04)?;
        let units = self.words.q?.value?.as_whole()?;
        Some(Micro::from_millionths(units * 10_000))
    }

    /// What F and S a working motion needs (TEC-2, TEC-3); each said once a program.
    pub(super) fn check_working_motion(&mut self, at: Location) {
        if self.state.feed == Held::None && !self.feed_warned {
            self.feed_warned = true;
            self.report(Diagnostic::new(Finding::MissingFeed {}, at));
        }
        let Some(function) = self.speed_reader() else { return };
        if self.state.speed == Held::None && !self.speed_warned {
            self.speed_warned = true;
            self.report(Diagnostic::new(Finding::MissingSpindleSpeed { function }, at));
        }
    }

    /// The G6 function in force, when a working motion under it needs S (TEC-3).
    pub(super) fn speed_reader(&self) -> Option<GCode> {
        self.in_force(GGroup::G6).filter(|mode| matches!(mode, GCode::G95 | GCode::G96 | GCode::G97))
    }

    /// What is in force of technology, into the record.
    pub(super) fn record_technology(&mut self) {
        let (words, state, record) = (&self.words, &self.state, &mut self.record);
        record.feed = state.feed.value();
        record.s = state.speed.value();
        record.t = state.tool.value();
        record.h = state.h.value();
        record.p = state.p.value();
        record.d = state.d.value();
        record.f_set = words.f.is_some();
        record.s_set = words.s.is_some();
        record.t_set = words.t.is_some();
        record.h_set = words.h.is_some();
        record.p_set = words.p.is_some();
        record.d_set = words.d.is_some();
        record.length_correction =
            state.correction.value().and_then(Decimal::as_whole).and_then(|digits| u16::try_from(digits).ok());
        let mode = self.in_force.get(GGroup::G6.index()).copied().flatten();
        record.rev_feed = matches!(mode, Some(GCode::G95 | GCode::G97));
        record.const_cut_speed = matches!(mode, Some(GCode::G96 | GCode::G97));
        record.continuous_mode = self.in_force.get(GGroup::G2.index()).copied().flatten() == Some(GCode::G23);
        record.dynamic_set = state.dynamic_set;
    }

    /// I as the dynamic set of G23 (GRP-7): whether the word was used so.
    pub(super) fn choose_dynamic_set(&mut self) -> bool {
        let (Some(i), Some(_)) = (self.words.i, self.words.has(GCode::G23)) else { return false };
        let Some(value) = i.value else { return true };
        match value.as_whole() {
            Some(set @ 1..=4) => self.state.dynamic_set = u8::try_from(set).ok(),
            _ if i.word.is_parametric() => {
                let needs = if value.is_whole() {
                    crate::diag::ParameterNeed::Range("1–4".to_owned())
                } else {
                    crate::diag::ParameterNeed::Whole
                };
                self.report_unusable(i.word, value, needs);
            }
            _ => {
                let finding = Finding::ValueOutOfRange { address: Address::I, range: "1–4 (G23)".to_owned() };
                self.report(Diagnostic::new(finding, self.value_place(i.word)));
            }
        }
        true
    }
}
