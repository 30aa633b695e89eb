//! Judges the words of one block together, as far as its written values go.

use std::collections::BTreeMap;

use super::axis_letters::bit;
use super::functions::{Conflict, Functions, m_number};
use super::judge_file::{Judged, JudgedFile};
use super::judge_word::is_out_of_range;
use super::missing_axis;
use super::numbers::{number_as_function, word_before};
use super::targets::{centers_without_use, missing_control_words};
use super::unnumbered::is_first_in_line;
use super::{Taker, Unit, UnitKind, control_word, l_number, unused_l};
use crate::config::Settings;
use crate::diag::{CenterPlace, Diagnostic, Finding, LabelText, OtherMeaning, ParameterNeed, TargetMeant, UnusedMeant};
use crate::dict::{
    Address, DYNAMIC_SETS, Decimal, FEED_FUNCTIONS, FIRST_CONTROL, GCode, GGroup, LAST_CONTROL, Lang, ORIENTED_STOP,
    PROGRAM_ENDS, RESERVED_PARAMETER,
};
use crate::sure::Sure;
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, Value, Word};

/// Most words of an address in one block (BLK-3, BLK-4).
const MOST_G: usize = 11;
const MOST_M: usize = 10;
const MOST_R: usize = 95;
/// In m/min: above what turning works with, so that a speed of the spindle was probably meant.
const NO_CUTTING_SPEED: i64 = 1000;
/// So many subprograms are named in a help.
const MOST_NAMED: usize = 5;

/// Judges blocks of one file.
pub(super) struct BlockJudge<'a> {
    pub(super) settings: &'a Settings,
    pub(super) file: &'a ParsedFile,
    /// The file with what surrounds its blocks.
    pub(super) around: JudgedFile<'a>,
    /// Axes that the control does not have, a bit for each address.
    pub(super) surplus: u32,
    pub(super) judged: Judged,
}

impl<'a> BlockJudge<'a> {
    /// For the blocks of a file.
    pub(super) fn new(settings: &'a Settings, around: JudgedFile<'a>) -> Self {
        let surplus = around.letters.surplus(&settings.machine);
        Self { settings, file: around.parsed, around, surplus, judged: Judged::default() }
    }

    /// The results.
    pub(super) fn finish(self) -> Judged {
        self.judged
    }

    /// Judges a block of a unit of that kind; `None`: of no unit.
    pub(super) fn judge(&mut self, block: BlockId, unit: Option<UnitKind>) {
        let flags = self.file.flags(block);
        let mut numbered = true;
        if let Some(word) = self.file.n_word(block)
            && !(word.is_digits() && self.file.number(block).is_some())
        {
            numbered = self.judge_word(word, &Functions::default());
        }
        let words = self.file.words(block);
        if !flags.has(BlockFlags::RICH) && (flags.is_point() || flags.straight().is_none()) {
            let (addresses, right) = self.judge_plain_words(block, words);
            if flags.is_point() {
                self.judged.points.add(addresses, right);
            }
            if words.is_empty() && numbered && flags == BlockFlags::default() {
                self.warn_of_empty_block(block);
            }
            return;
        }
        let mut functions = Functions::of(words, self.settings);
        let mut conflicts = std::mem::take(&mut functions.conflicts);
        conflicts.extend(Conflict::of_addresses(words));
        let lines = self.judge_conflicts(block, &conflicts);
        self.judge_functions(words);
        for &word in words {
            if self.is_lost_number(word, &lines, &functions) {
                self.judged.refused.push(word.start());
            } else {
                self.judge_word(word, &functions);
            }
            if word.address == Address::T {
                self.judge_tool(word, words);
            }
        }
        self.judge_plane(&functions);
        // Another function may have been meant by what is wrong in the block.
        let clear = !flags.has(BlockFlags::DEBRIS) && !words.iter().any(|word| word.lacks_value());
        self.judge_roles(words, &functions, flags, clear);
        self.judge_other_meanings(words, &functions);
        self.judge_dynamic_set(words, &functions);
        self.judge_parameters(words, &functions);
        if flags.has(BlockFlags::SKIP) {
            self.check_skip(block, words, &functions, flags, unit);
        }
        if !matches!(unit, Some(UnitKind::Main) | None) && flags.has(BlockFlags::END) {
            self.judge_end_in_unit(words);
        }
    }

    /// Judges the `%` word: it has the form of its address like every word.
    pub(super) fn judge_program_word(&mut self) {
        if let Some(word) = self.file.program.filter(|_| self.file.form == Form::Program) {
            self.judge_word(word, &Functions::default());
        }
    }

    /// A block of axis, feed and the like: its words are plain numbers, and nothing else can be wrong with it. Gives
    /// the addresses of its words, and whether each is an axis word, I, J or the G of a point, with which nothing is
    /// wrong.
    #[inline]
    fn judge_plain_words(&mut self, block: BlockId, words: &[Word]) -> (u32, bool) {
        let mut seen = 0_u32;
        let mut repeated = false;
        let mut all_simple = true;
        for &word in words {
            let bit = bit(word.address);
            repeated |= seen & bit != 0;
            seen |= bit;
            let in_range = word.number().is_some_and(|number| number.abs() <= Decimal::DIMENSION_MAX);
            let simple = in_range
                && !word.is_rounded()
                && self.surplus & bit == 0
                // A G is the G00 or G01 of a point.
                && (matches!(word.address, Address::G | Address::I | Address::J)
                    || self.settings.machine.axes.index_of(word.address).is_some());
            if !simple {
                all_simple = false;
                self.judge_word(word, &Functions::default());
                if word.address == Address::T {
                    self.judge_tool(word, words);
                }
            }
        }
        if repeated {
            self.judge_conflicts(block, &Conflict::of_addresses(words));
        }
        (seen, all_simple && !repeated)
    }

    /// Warns of a block without words (W0214), unless its line lacks another block number, a letter without a value
    /// stands before it, `Mn03`, or the words come after the `*` in it.
    fn warn_of_empty_block(&mut self, block: BlockId) {
        let place = self.file.n_place(block);
        let lines = self.file.source.lines();
        let unnumbered = self.around.unnumbered(self.settings).line_before(place.span.start);
        if unnumbered.is_some_and(|line| lines.line_at(line) == lines.line_at(place.span.start)) {
            return;
        }
        if word_before(self.file, block).is_some_and(Word::is_void) {
            return;
        }
        let function = number_as_function(self.file, block);
        let warning = Diagnostic::new(Finding::EmptyBlock { block: self.file.shown_number(block), function }, place);
        if self.around.at_star == Some(block) {
            self.judged.at_star.push(warning);
        } else {
            self.judged.empty.push((block, warning));
        }
    }

    /// Reports words that conflict (BLK-3, GRP-1, MFN-1). Conflicts with the lines above one that lacks its block
    /// number are one fault: the first of them says so. Gives these lines.
    fn judge_conflicts(&mut self, block: BlockId, conflicts: &[Conflict]) -> Vec<u32> {
        if conflicts.is_empty() {
            return Vec::new();
        }
        let unnumbered = self.around.unnumbered(self.settings);
        let mut first: BTreeMap<u32, u32> = BTreeMap::new();
        for conflict in conflicts {
            if let Some(line) = unnumbered.line_between(conflict) {
                let place = first.entry(line).or_insert(u32::MAX);
                *place = conflict.second.start().min(*place);
            }
        }
        for conflict in conflicts {
            let line = unnumbered.line_between(conflict);
            if line.is_none_or(|line| first.get(&line) == Some(&conflict.second.start())) {
                self.judged.findings.add(conflict.diagnostic(self.file, &self.settings.machine, line.is_some()));
            }
        }
        self.judged.merged.extend(first.keys().map(|line| (*line, block)));
        first.into_keys().collect()
    }

    /// Whether a word is the number of a block behind another letter, `M1400 G79 L200`, on one of those lines or where
    /// a subprogram begins.
    fn is_lost_number(&self, word: Word, lines: &[u32], functions: &Functions) -> bool {
        let in_line = || self.around.unnumbered(self.settings).line_before(word.start());
        let crowded = || self.around.crowded.contains(&self.file.word_place(word));
        (!lines.is_empty() || !self.around.crowded.is_empty())
            && (in_line().is_some_and(|line| lines.binary_search(&line).is_ok()) || crowded())
            && is_first_in_line(self.file, word)
            && is_out_of_range(self.settings, word, functions)
    }

    /// How many words of an address a block may have (BLK-3, BLK-4), and M functions that the machine does not have
    /// (MFN-10, TEC-8).
    fn judge_functions(&mut self, words: &[Word]) {
        let machine = &self.settings.machine;
        let limits = [(Address::G, MOST_G), (Address::M, MOST_M), (Address::R, MOST_R)];
        for (address, limit) in limits.into_iter().filter(|(_, limit)| words.len() > *limit) {
            let limited = address == Address::R || machine.dialect.limits_words();
            let mut of_address = words.iter().filter(|word| word.address == address);
            if let Some(word) = of_address.nth(limit).filter(|_| limited) {
                self.report(*word, Finding::TooManyWords { address, limit });
            }
        }
        for &word in words {
            let Some(m) = m_number(word, self.settings) else { continue };
            if m == ORIENTED_STOP && !machine.oriented_stop {
                self.report(word, Finding::OrientedStopUnavailable {});
            }
            if machine.m_functions.is_meaningless(m) && self.judged.meaningless.iter().all(|(known, _)| *known != m) {
                let finding = Finding::FunctionWithoutMeaning { m, feed: FEED_FUNCTIONS.contains(&m) };
                self.judged.meaningless.push((m, Diagnostic::new(finding, self.file.word_place(word))));
            }
        }
    }

    pub(super) fn report(&mut self, word: Word, finding: Finding) {
        self.judged.findings.add(Diagnostic::new(finding, self.file.word_place(word)));
    }

    pub(super) fn report_value(&mut self, word: Word, finding: Finding) {
        self.judged.findings.add(Diagnostic::new(finding, self.file.value_place(word)));
    }

    /// A plane with an axis that the machine does not have (GRP-2).
    fn judge_plane(&mut self, functions: &Functions) {
        if let Some((function, word)) = functions.of_group(GGroup::G1)
            && let Some(finding) = missing_axis(&self.settings.machine.axes, function)
        {
            self.report(word, finding);
        }
    }

    /// What L and Q are for (FLW-7), what G04 needs (GRP-5), and that the L of G79 is written out (PRG-3). `clear`:
    /// nothing else is wrong with the block that a function may explain.
    fn judge_roles(&mut self, words: &[Word], functions: &Functions, flags: BlockFlags, clear: bool) {
        functions.roles.check(flags.has(BlockFlags::END), |word, finding| {
            let unused_l = matches!(finding, Finding::UnusedTarget { .. });
            let unused_q = matches!(finding, Finding::UnusedRepeat {});
            // `G+3 L30 Q2`: another function is meant.
            let refused = |word: &Word| word.address == Address::G && self.is_refused(*word);
            if (unused_l || unused_q) && (!clear || words.iter().any(refused)) {
                return;
            }
            if let Finding::MissingTarget { function: function @ GCode::G71, meant } = finding {
                let only_g = words.iter().all(|word| word.address == Address::G);
                let known = || self.known_subprograms().unwrap_or(meant);
                let meant = if only_g { TargetMeant::Millimetres } else { known() };
                self.report(word, Finding::MissingTarget { function, meant });
            } else if unused_l && !self.is_explained(word) {
                self.judge_unused_l(words, functions, word);
            } else if !unused_l && !(unused_q && (self.is_explained(word) || self.is_call(words, functions))) {
                self.report(word, finding);
            }
        });
        if let Taker::One(GCode::G79, _) = functions.roles.taker
            && let Some(l) = functions.roles.l.filter(|l| !l.is_faulty())
            && let Value::Parameter { index, .. } = l.value()
        {
            let needs = ParameterNeed::WrittenOut("L".to_owned());
            let value = String::new();
            let finding = Finding::UnusableParameterValue { address: Address::L, parameter: index, value, needs };
            self.report(l, finding);
            self.judged.refused.push(l.start());
        }
    }

    /// Whether a word of the block that is being judged has a value that its address does not take.
    fn is_refused(&self, word: Word) -> bool {
        /// So many words of a block are looked at.
        const WORDS: usize = 64;
        self.judged.refused.iter().rev().take(WORDS).any(|start| *start == word.start())
    }

    /// The only word of an address in the block that is being judged, when its value is one that the address takes.
    fn right(&self, words: &[Word], address: Address) -> Option<Word> {
        let mut of_address = words.iter().copied().filter(|word| word.address == address);
        let word = of_address.next().filter(|_| of_address.next().is_none())?;
        (!word.is_void() && !self.is_refused(word)).then_some(word)
    }

    /// Whether another finding explains an L or Q without use: that of its value, of an `N` without a number, which may
    /// be one letter too many in the block before, or of the line that it begins, which lacks its block number.
    fn is_explained(&self, word: Word) -> bool {
        let n = || self.file.n_word(self.file.block_at(word.start())?);
        self.is_refused(word)
            || n().is_some_and(Word::is_void)
            || self.around.unnumbered(self.settings).line_before(word.start()) == Some(word.start())
    }

    /// Whether the words of a block are a call or jump that lost its function, which has its finding.
    fn is_call(&self, words: &[Word], functions: &Functions) -> bool {
        functions.is_call_elsewhere(words)
            || self.exchanged_call(words, functions).is_some()
            || unused_l::is_call_alone(self.file, self.around.units, words)
    }

    /// An L without use (W0402), with what was probably meant.
    fn judge_unused_l(&mut self, words: &[Word], functions: &Functions, word: Word) {
        let called = || words.iter().find(|word| word.address == Address::P).and_then(|word| word.whole());
        if functions.calls_elsewhere().is_some() && called().is_some_and(|p| !(1..=99).contains(&p)) {
            // The P has its finding, which gives the call in the words of this control.
            return;
        }
        let meant = match self.exchanged_call(words, functions) {
            Some((code, l)) => {
                let count = functions.roles.q.and_then(Word::whole);
                let count = count.map_or_else(String::new, |count| format!(" Q{count}"));
                UnusedMeant::Exchanged { written: format!("{code} L{l}{count}") }
            }
            None => {
                let meant = unused_l::meant(words, functions, word);
                let lost = || unused_l::lost_function(self.file, self.around.units, words, word);
                if meant == UnusedMeant::Target { lost() } else { meant }
            }
        };
        let lost = l_number(word).filter(|_| meant == UnusedMeant::Target);
        let diagnostic = Diagnostic::new(Finding::UnusedTarget { meant }, self.file.word_place(word));
        match lost {
            Some(l) => self.judged.lost_calls.push((l, diagnostic)),
            None => self.judged.findings.add(diagnostic),
        }
    }

    /// The call or jump of a block whose digits are exchanged.
    fn exchanged_call(&self, words: &[Word], functions: &Functions) -> Option<(GCode, u32)> {
        let units = self.around.units;
        let jumps = |l| words.first().is_some_and(|word| unused_l::has_block_near(self.file, units, *word, l));
        unused_l::exchanged_call(units, words, functions)
            .filter(|(code, l)| if *code == GCode::G71 { unused_l::is_unit(units, *l) } else { jumps(*l) })
    }

    /// The first subprograms of the file, when there are any.
    fn known_subprograms(&self) -> Option<TargetMeant> {
        let number = |unit: &Unit| match unit.kind {
            UnitKind::Subprogram(l) => l,
            UnitKind::Main | UnitKind::Macrocycle(_) => None,
        };
        let known: Vec<String> =
            self.around.units.iter().filter_map(number).take(MOST_NAMED).map(|l| format!("L{l}")).collect();
        (!known.is_empty()).then(|| TargetMeant::OneOf { known: known.join(", ") })
    }

    /// Words that are legal here, but are written for what they mean on other controls.
    fn judge_other_meanings(&mut self, words: &[Word], functions: &Functions) {
        let of = |address: Address| words.iter().copied().find(|word| word.address == address);
        if let (Some(m), true, Some(p)) =
            (functions.calls_elsewhere(), functions.is_call_elsewhere(words), of(Address::P))
            && let Some(number) = p.whole()
        {
            let count = functions.roles.q.and_then(|q| q.whole());
            self.report(m, Finding::OtherMeaning { meant: OtherMeaning::Call { l: number }, count });
        }
        if let (Some((GCode::G73, _)), None, None, Some(p)) =
            (functions.of_group(GGroup::G7), functions.roles.q, functions.roles.dwell, self.right(words, Address::P))
            && let Some(count) = p.whole()
        {
            self.report(p, Finding::OtherMeaning { meant: OtherMeaning::RepeatByP { p: count }, count: None });
        }
        if let (Some((GCode::G97, _)), Some(s)) = (functions.of_group(GGroup::G6), self.right(words, Address::S))
            && let Some(speed) = s.whole().filter(|speed| *speed >= NO_CUTTING_SPEED)
            && self.settings.machine.feed_mode(GCode::G97).is_some_and(|mode| mode.constant_cut)
            && self.judged.cutting_speed.is_none()
        {
            let finding = Finding::OtherMeaning { meant: OtherMeaning::CuttingSpeed { s: speed }, count: None };
            self.judged.cutting_speed = Some(Diagnostic::new(finding, self.file.word_place(s)));
        }
        if let Some((table @ (GCode::G92 | GCode::G93), g)) = functions.of_group(GGroup::G10) {
            self.judge_table(words, table, g, functions.of_group(GGroup::G5).is_some());
        }
    }

    /// `T0101`: the tool and its offset, without D.
    fn judge_tool(&mut self, t: Word, words: &[Word]) {
        if words.iter().any(|word| word.address == Address::D) {
            return;
        }
        let pair = |tool: &i64| (101..1000).contains(tool) && tool / 100 == tool % 100;
        let Some(tool) = t.whole().filter(pair) else { return };
        let written = self.file.source.slice(t.span(self.file.source.text())).to_ascii_uppercase();
        if written.get(1..).sure().trim_start_matches([' ', '\t']).starts_with('0') {
            self.report(
                t,
                Finding::OtherMeaning { meant: OtherMeaning::ToolWithOffset { written, tool }, count: None },
            );
        }
    }

    /// G92 or G93 with words that mean something else on other controls, or without values for the table (GRP-4).
    /// `origin`: with a function of origin.
    fn judge_table(&mut self, words: &[Word], table: GCode, g: Word, origin: bool) {
        let of = |address: Address| words.iter().copied().find(|word| word.address == address);
        let (axes, s) = (words.iter().any(|word| word.address.axis().is_some()), of(Address::S));
        let meant = |meant: OtherMeaning| Finding::OtherMeaning { meant, count: None };
        let of_thread = of(Address::Z).is_some() && of(Address::Y).is_none() && of(Address::D).is_none();
        if table == GCode::G92 && of_thread && !origin && of(Address::F).is_some_and(|f| !f.is_faulty()) {
            self.report(g, meant(OtherMeaning::Thread));
        }
        if let Some(s) = s.filter(|s| table == GCode::G92 && !axes && of(Address::D).is_none() && !s.is_faulty()) {
            self.report(s, meant(OtherMeaning::SpeedLimit));
        }
        if !axes && s.is_none() {
            self.report(g, Finding::TableWithoutValues { function: table });
        }
        let centers = [(Address::I, 'I'), (Address::J, 'J'), (Address::K, 'K')];
        let useless = centers.into_iter().filter_map(|(address, letter)| {
            let word = self.right(words, address)?;
            Some((letter, self.file.word_place(word)))
        });
        if let Some((finding, at)) = centers_without_use(&useless.collect::<Vec<_>>(), CenterPlace::InTableBlock) {
            self.judged.findings.add(Diagnostic::new(finding, at));
        }
    }

    /// I as the dynamic set of G23, in a block that is no arc whatever is in force (GRP-7).
    fn judge_dynamic_set(&mut self, words: &[Word], functions: &Functions) {
        let Some((GCode::G23, _)) = functions.of_group(GGroup::G2) else { return };
        let moves = words.iter().any(|word| word.address.axis().is_some());
        let line = functions.of_group(GGroup::G0).is_some_and(|(code, _)| !matches!(code, GCode::G02 | GCode::G03));
        let set = self.right(words, Address::I).filter(|_| line || !moves);
        let wrong = |set: &Word| set.number().is_some_and(|set| !set.is_whole() || !DYNAMIC_SETS.contains(set));
        if let Some(set) = set.filter(wrong) {
            let (range, mode) = (DYNAMIC_SETS.text(Lang::En), Some(GCode::G23));
            self.report_value(set, Finding::ValueOutOfRange { address: Address::I, range, mode, call: None });
        }
    }

    /// Parameters: R95, what is assigned and read, control words (PAR-4, PAR-7…PAR-9).
    fn judge_parameters(&mut self, words: &[Word], functions: &Functions) {
        let has_r = words.iter().any(|word| word.address == Address::R);
        if !has_r && functions.of_group(GGroup::G4).is_none() {
            return;
        }
        let mut assigned: [Option<Word>; 96] = [None; 96];
        // A word of another letter may be one of them, as `P5=3021517` is.
        let text = |word: Word| self.file.source.slice(self.file.word_place(word).span);
        let is_unread = |word: &Word| word.is_void() && (word.address == Address::R || text(*word).contains('='));
        let void = words.iter().any(is_unread);
        for &word in words.iter().filter(|word| word.address == Address::R) {
            if let Some(slot) = assigned.get_mut(usize::from(word.target()))
                && !word.is_void()
                && slot.is_none()
            {
                *slot = Some(word);
            }
            if word.target() == RESERVED_PARAMETER && !word.is_void() {
                self.report(word, Finding::ReservedParameter {});
            }
        }
        let mut warned = [false; 96];
        for &word in words {
            let Value::Parameter { index, .. } = word.value() else { continue };
            let place = usize::from(index);
            if let (Some(Some(first)), Some(warned @ false)) = (assigned.get(place), warned.get_mut(place)) {
                *warned = true;
                let (read, assigned) = (self.file.word_place(word), self.file.word_place(*first));
                let diagnostic = Diagnostic::new(Finding::AssignedAndRead { parameter: index }, read);
                // `R50=R50` needs no mark: the word itself shows both.
                let elsewhere = read.span != assigned.span;
                let label = LabelText::AssignedHere { parameter: index };
                self.judged.findings.add(if elsewhere { diagnostic.with_label(assigned, label) } else { diagnostic });
            }
        }
        if let Some((function, g_word)) = functions.of_group(GGroup::G4) {
            // G28 approaches the reference point on other controls.
            let axes = words.iter().any(|word| word.address.axis().is_some());
            let reference = function == GCode::G28 && !has_r && axes;
            self.judge_control_words((function, g_word), &assigned, void, reference);
        }
    }

    fn judge_control_words(
        &mut self,
        (function, g_word): (GCode, Word),
        assigned: &[Option<Word>; 96],
        void: bool,
        reference: bool,
    ) {
        let mut superfluous = Vec::new();
        let used = FIRST_CONTROL..FIRST_CONTROL + u8::try_from(function.operations()).unwrap_or(0);
        for parameter in FIRST_CONTROL..=LAST_CONTROL {
            let word = assigned.get(usize::from(parameter)).copied().flatten();
            match (used.contains(&parameter), word) {
                (false, Some(word)) => superfluous.push((word, parameter)),
                (true, Some(word)) => {
                    if let (Some(value), false) = (word.number(), word.is_faulty())
                        && value.fits_parameter()
                        && let Err(finding) = control_word(&self.settings.machine, value)
                    {
                        self.report_control_word(word, finding);
                    }
                }
                (_, None) => {}
            }
        }
        let has = |parameter: u8| assigned.get(usize::from(parameter)).is_some_and(Option::is_some);
        match missing_control_words(function, has) {
            None => {
                for (word, parameter) in superfluous {
                    self.report(word, Finding::SuperfluousControlWord { function, parameter });
                }
            }
            // Control words in the wrong parameters are part of it.
            Some(mut finding) if !void => {
                if let Finding::MissingControlWord { reference: meant, .. } = &mut finding {
                    *meant = reference;
                }
                self.report(g_word, finding);
            }
            Some(_) => {}
        }
    }

    /// An operation that is not configured is reported once for each code.
    fn report_control_word(&mut self, word: Word, mut finding: Finding) {
        if let Finding::UnknownOperation { operation, written, .. } = &mut finding {
            let (operation, place) = (*operation, self.file.value_place(word));
            *written = self.file.source.slice(place.span).bytes().filter(u8::is_ascii_digit).count();
            let diagnostic = Diagnostic::new(finding, place);
            self.judged.operations.push((operation, diagnostic));
        } else {
            self.report_value(word, finding);
        }
    }

    /// M02 and M30 in a subprogram or macrocycle (PRG-5).
    fn judge_end_in_unit(&mut self, words: &[Word]) {
        for &word in words {
            if let Some(function) = m_number(word, self.settings).filter(|number| PROGRAM_ENDS.contains(number)) {
                self.report(word, Finding::ProgramEndInSubprogram { function });
            }
        }
    }
}
