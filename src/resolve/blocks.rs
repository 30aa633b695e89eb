//! The checks of one block, as far as its written values go.

use super::forms::{FormFault, check_form, feed_mode_before, with_feed_mode};
use super::judged::Judged;
use super::letters::{Letters, bit};
use super::planes::missing_axis;
use super::points::Points;
use super::roles::{Roles, Taker};
use super::targets::{conflicting_g, conflicting_m, missing_control_words};
use super::{Unit, UnitKind, unused};
use crate::config::Settings;
use crate::diag::{
    Diagnostic, Finding, Findings, FixTitle, LabelText, OtherMeaning, ParameterNeed, PointMeant, TargetMeant,
    UnusedMeant,
};
use crate::dict::{
    Address, CALL_ELSEWHERE, Decimal, FIRST_CONTROL, GCode, GGroup, HIGHEST_L, LAST_CONTROL, M_GROUPS, PROGRAM_ENDS,
    RESERVED_PARAMETER,
};
use crate::sure::Sure;
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, Value, Word};
use crate::text::{Location, Span};

/// Most words of an address in one block (BLK-3, BLK-4).
const MOST_G: usize = 11;
const MOST_M: usize = 10;
const MOST_R: usize = 95;
/// So many subprograms are named in a help.
const MOST_NAMED: usize = 5;

/// Checks blocks of one file.
pub(super) struct BlockChecker<'a> {
    pub(super) settings: &'a Settings,
    pub(super) file: &'a ParsedFile,
    pub(super) findings: &'a mut Findings,
    letters: &'a Letters,
    /// The units of the file, for what helps name.
    pub(super) units: &'a [Unit],
    /// Axes that the control does not have, a bit for each address.
    surplus: u32,
    /// Where words begin whose values are not what their addresses take.
    refused: Vec<u32>,
    /// Control words whose operation is not configured, by its code.
    operations: Vec<(i64, Diagnostic)>,
    /// M functions without a meaning on this machine, by number, the first word of each.
    pub(super) meaningless: Vec<(u8, Diagnostic)>,
    points: Points,
}

/// The G and M functions written in a block, and the words that go with them.
#[derive(Default)]
pub(super) struct Functions {
    g: [Option<(GCode, Word)>; 12],
    /// Groups of which two functions are written (E0307): which of them was meant is not known.
    clash: [bool; 12],
    m: [Option<(u8, Word)>; M_GROUPS],
    /// What L and Q belong to.
    pub(super) roles: Roles,
    g_words: usize,
    m_words: usize,
    r_words: usize,
    /// A G function of other controls is written that takes words of its own: a call or a cycle.
    foreign: bool,
}

impl Functions {
    /// The one function of that group.
    pub(super) fn of(&self, group: GGroup) -> Option<(GCode, Word)> {
        let clash = self.clash.get(group.index()).copied().unwrap_or(false);
        self.g.get(group.index()).copied().flatten().filter(|_| !clash)
    }

    /// M98, which calls a subprogram on other controls.
    pub(super) fn calls_elsewhere(&self) -> Option<Word> {
        self.m.iter().flatten().find(|(number, _)| *number == CALL_ELSEWHERE).map(|(_, word)| *word)
    }

    /// Whether the block calls a subprogram by M98 and P.
    fn is_call_elsewhere(&self, words: &[Word]) -> bool {
        let p = words.iter().find(|word| word.address == Address::P).and_then(|word| word.whole());
        self.calls_elsewhere().is_some() && self.roles.l.is_none() && p.is_some_and(|p| (1..=99).contains(&p))
    }

    /// Whether a word of that address belongs to what a function means on other controls: the time of a dwell, the words
    /// of a call or a cycle.
    fn takes_elsewhere(&self, address: Address) -> bool {
        let dwell = address == Address::P && self.roles.dwell.is_some() && self.roles.q.is_none();
        dwell || (self.foreign && matches!(address, Address::P | Address::Q | Address::L | Address::D | Address::H))
    }

    /// Whether the word assigns a parameter that the arithmetic of the block takes as a control word (PAR-7).
    fn is_control_word(&self, word: Word) -> bool {
        let count = self.of(GGroup::G4).map_or(0, |(function, _)| function.operations());
        let at = word.target().checked_sub(FIRST_CONTROL).filter(|_| word.address == Address::R);
        at.is_some_and(|at| usize::from(at) < count)
    }
}

impl<'a> BlockChecker<'a> {
    /// For blocks of `file`; `letters` are the axes that its program uses.
    pub(super) fn new(
        settings: &'a Settings,
        file: &'a ParsedFile,
        letters: &'a Letters,
        findings: &'a mut Findings,
    ) -> Self {
        let surplus = letters.surplus(&settings.machine);
        Self {
            settings,
            file,
            findings,
            letters,
            surplus,
            units: &[],
            refused: Vec::new(),
            operations: Vec::new(),
            meaningless: Vec::new(),
            points: Points::default(),
        }
    }

    /// What the look at the blocks gave besides findings.
    pub(super) fn finish(self) -> Judged {
        Judged {
            refused: self.refused,
            operations: self.operations,
            meaningless: self.meaningless,
            points: self.points,
        }
    }

    /// Checks a block of a unit of that kind; `None`: of no unit.
    pub(super) fn check(&mut self, block: BlockId, unit: Option<UnitKind>) {
        let flags = self.file.flags(block);
        let mut numbered = true;
        if let Some(word) = self.file.n_word(block)
            && !(word.is_digits() && self.file.number(block).is_some())
        {
            numbered = self.check_word(word, &Functions::default());
        }
        let words = self.file.words(block);
        if !flags.has(BlockFlags::RICH) {
            let (addresses, right) = self.check_plain_words(words);
            if flags.is_point() {
                self.points.add(addresses, right);
            }
            if words.is_empty() && numbered && flags == BlockFlags::default() {
                let finding = Finding::EmptyBlock { block: self.file.shown_number(block) };
                self.findings.add(Diagnostic::new(finding, self.file.n_place(block)));
            }
            return;
        }
        let functions = self.collect(words);
        for &word in words {
            self.check_word(word, &functions);
        }
        self.check_repeated(words);
        self.check_plane(&functions);
        self.check_roles(words, &functions, flags);
        self.check_other_meanings(words, &functions);
        self.check_parameters(words, &functions);
        if flags.has(BlockFlags::SKIP) {
            self.check_skip(block, words, &functions, flags, unit);
        }
        if !matches!(unit, Some(UnitKind::Main) | None) && flags.has(BlockFlags::END) {
            self.check_end_in_unit(words);
        }
    }

    /// `%` has the form of its address like every word.
    pub(super) fn check_program_word(&mut self, word: Word) {
        self.check_word(word, &Functions::default());
    }

    /// A block of axis, feed and the like: its words are plain numbers, and nothing else can be wrong with it. Gives the
    /// addresses of its words, and whether each is an axis word, or I or J, with which nothing is wrong.
    #[inline]
    fn check_plain_words(&mut self, words: &[Word]) -> (u32, bool) {
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
                && (word.address == Address::I
                    || word.address == Address::J
                    || self.settings.machine.axes.index_of(word.address).is_some());
            if !simple {
                all_simple = false;
                self.check_word(word, &Functions::default());
            }
        }
        if repeated {
            self.check_repeated(words);
        }
        (seen, all_simple && !repeated)
    }

    fn collect(&mut self, words: &[Word]) -> Functions {
        let mut functions = Functions { roles: Roles::written(words), ..Functions::default() };
        let limited = self.settings.machine.dialect.limits_words();
        for &word in words {
            match word.address {
                Address::G => self.collect_g(word, &mut functions, limited),
                Address::M => self.collect_m(word, &mut functions, limited),
                Address::R => {
                    functions.r_words += 1;
                    if functions.r_words == MOST_R + 1 {
                        self.too_many(word, MOST_R);
                    }
                }
                Address::Program
                | Address::L
                | Address::Q
                | Address::N
                | Address::Skip
                | Address::X
                | Address::Y
                | Address::Z
                | Address::A
                | Address::B
                | Address::C
                | Address::U
                | Address::V
                | Address::W
                | Address::I
                | Address::J
                | Address::K
                | Address::Correction
                | Address::D
                | Address::F
                | Address::S
                | Address::H
                | Address::P
                | Address::T => {}
            }
        }
        functions
    }

    fn collect_g(&mut self, word: Word, functions: &mut Functions, limited: bool) {
        functions.g_words += 1;
        if limited && functions.g_words == MOST_G + 1 {
            self.too_many(word, MOST_G);
        }
        functions.foreign |= word.whole().is_some_and(|number| matches!(number, 65 | 66 | 76 | 77));
        let Some(code) = word.g_code() else { return };
        match functions.g.get_mut(code.group().index()) {
            Some(Some((first, first_word))) => {
                let diagnostic = conflicting_g(self.file, (*first, *first_word), (code, word));
                self.findings.add(diagnostic);
                if let Some(clash) = functions.clash.get_mut(code.group().index()) {
                    *clash = true;
                }
            }
            Some(slot) => *slot = Some((code, word)),
            None => {}
        }
    }

    fn collect_m(&mut self, word: Word, functions: &mut Functions, limited: bool) {
        functions.m_words += 1;
        if limited && functions.m_words == MOST_M + 1 {
            self.too_many(word, MOST_M);
        }
        let Some(number) = m_number(word, self.settings) else { return };
        self.check_m_meaning(number, word);
        let group = self.settings.machine.m_functions.group(number);
        match functions.m.get_mut(usize::from(group)) {
            Some(Some((first, first_word))) => {
                let diagnostic =
                    conflicting_m(self.file, (*first, *first_word), (number, word), &self.settings.machine);
                self.findings.add(diagnostic);
            }
            Some(slot) => *slot = Some((number, word)),
            None => {}
        }
    }

    fn too_many(&mut self, word: Word, limit: usize) {
        self.report(word, Finding::TooManyWords { address: word.address, limit });
    }

    fn report(&mut self, word: Word, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, self.file.word_place(word)));
    }

    fn report_value(&mut self, word: Word, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, self.file.value_place(word)));
    }

    fn report_with_first(&mut self, word: Word, finding: Finding, first: Word) {
        let diagnostic = Diagnostic::new(finding, self.file.word_place(word));
        let place = self.file.word_place(first);
        let what = crate::diag::shown(self.file.source.slice(place.span));
        self.findings.add(diagnostic.with_label(place, LabelText::First { what }));
    }

    /// The form of one word (§2). What is wrong with it has its finding, and the word no value. Whether it is right.
    fn check_word(&mut self, word: Word, functions: &Functions) -> bool {
        if word.is_void() {
            return true;
        }
        let fits = if word.is_faulty() { self.fits(word, functions) } else { self.judge(word, functions) };
        // The number of a block stays what jumps lead to.
        if !fits && word.address != Address::N {
            self.refused.push(word.start());
        }
        fits
    }

    /// Whether a value that a fix gives has the form of its address: the word has its finding already.
    fn fits(&self, word: Word, functions: &Functions) -> bool {
        let dwell = word.address == Address::Q && (functions.roles.dwell.is_some() || functions.roles.unknown);
        let mode = functions.of(GGroup::G6).map(|(code, _)| code);
        let form = |value| check_form(&self.settings.machine, word.address, value, dwell, mode);
        word.number().is_none_or(|value| form(value).is_ok())
    }

    /// Reports what is wrong with a word; whether it has a value that its address takes. One code a word, in the order of
    /// §13: axis, sign, point, digits of `&`, range, unknown G.
    fn judge(&mut self, word: Word, functions: &Functions) -> bool {
        let machine = &self.settings.machine;
        let address = word.address;
        if let Some(axis) = address.axis()
            && machine.axes.index(axis).is_none()
        {
            let finding = Finding::UnknownAxis { axis: axis.letter(), axes: machine.axes.letters(), limit: None };
            self.report(word, finding);
            return false;
        }
        if let Some(axis) = address.axis().filter(|_| self.surplus & bit(address) != 0) {
            self.report(word, self.letters.finding(machine, axis));
            return false;
        }
        if word.has_sign() && !address.takes_sign(machine.dialect) {
            self.report_value(word, Finding::SignNotAllowed { address });
            return false;
        }
        let Some(value) = word.number() else { return true };
        let dwell = address == Address::Q && functions.roles.dwell.is_some();
        if word.has_point() && !address.row().form.takes_point(machine.dialect) {
            // GRP-5: `Q5.` is tolerated with G04; with a G word from a parameter it is not known.
            let tolerated =
                address == Address::Q && value.is_whole() && !word.is_rounded() && (dwell || functions.roles.unknown);
            if !tolerated {
                let meant = point_meant(address, value, dwell);
                self.report_value(word, Finding::PointNotAllowed { address, meant });
                return false;
            }
        }
        let feed_mode = functions.of(GGroup::G6).map(|(code, _)| code);
        let zero_dwell = address == Address::Q && functions.roles.unknown;
        match check_form(machine, address, value, dwell || zero_dwell, feed_mode) {
            Ok(()) => {}
            Err(FormFault::Digits) => {
                self.report_value(word, Finding::CorrectionDigits {});
                return false;
            }
            Err(FormFault::Range(range)) => {
                // What belongs to a function of another control has its finding there.
                if !functions.takes_elsewhere(address) {
                    let call = functions.calls_elsewhere().and_then(|_| call_elsewhere(address, value, functions));
                    let place = self.file.value_place(word);
                    let (range, mode, there) = match self.range_here(word, value, feed_mode) {
                        Some((range, mode, there)) => (range, Some(mode), there),
                        None => (range, feed_mode.filter(|_| address == Address::F), None),
                    };
                    let finding = Finding::ValueOutOfRange { address, range, mode, call };
                    let diagnostic = Diagnostic::new(finding, place);
                    self.findings.add(with_feed_mode(diagnostic, self.file, mode.zip(there)));
                }
                return false;
            }
            // A fraction without a point cannot be.
            Err(FormFault::Fraction) => {
                let meant = point_meant(address, value, dwell);
                self.report_value(word, Finding::PointNotAllowed { address, meant });
                return false;
            }
        }
        if address == Address::G && word.g_code().is_none() {
            let number = value.as_whole().and_then(|number| u32::try_from(number).ok()).unwrap_or(0);
            self.report_value(word, Finding::UnknownG { number });
            return false;
        }
        // A control word with a fraction is none (PAR-8), however fine it is.
        let malformed = !value.is_whole() && functions.is_control_word(word);
        if word.is_rounded() && !malformed {
            self.report_value(word, Finding::FinerThanResolution { rounded: value.to_string() });
        }
        true
    }

    /// The one range of F that holds at a word, where the block does not say it: by the last G6 function before it in the
    /// text, in a program else by that of power-up; with that function, and where it is written.
    fn range_here(&self, word: Word, value: Decimal, mode: Option<GCode>) -> Option<(String, GCode, Option<Word>)> {
        if word.address != Address::F || mode.is_some() {
            return None;
        }
        let block = self.file.block_at(word.start())?;
        let written = feed_mode_before(self.file, block).map(|(code, word)| (code, Some(word)));
        let power_up = || self.settings.machine.power_up.get(GGroup::G6.index()).copied().flatten();
        let (mode, there) =
            written.or_else(|| Some((power_up().filter(|_| self.file.form == Form::Program)?, None)))?;
        match check_form(&self.settings.machine, Address::F, value, false, Some(mode)) {
            Err(FormFault::Range(range)) => Some((range, mode, there)),
            Ok(()) | Err(FormFault::Fraction | FormFault::Digits) => None,
        }
    }

    /// Each address once (BLK-3); G and M by group, R by parameter.
    fn check_repeated(&mut self, words: &[Word]) {
        let mut addresses: [Option<Word>; Address::ALL.len()] = [None; Address::ALL.len()];
        let mut parameters: [Option<Word>; 96] = [None; 96];
        for &word in words {
            if matches!(word.address, Address::G | Address::M) {
                continue;
            }
            let is_parameter = word.address == Address::R;
            let slot = if is_parameter {
                parameters.get_mut(usize::from(word.target()))
            } else {
                addresses.get_mut(word.address as usize)
            };
            let usable = !word.is_void() || word.address == Address::Skip;
            let Some(slot) = slot.filter(|_| usable) else { continue };
            match *slot {
                None => *slot = Some(word),
                Some(first) => {
                    let address = if is_parameter { format!("R{}", word.target()) } else { word.address.to_string() };
                    self.report_with_first(word, Finding::DuplicateAddress { address, unnumbered: false }, first);
                }
            }
        }
    }

    /// A plane with an axis that the machine does not have (GRP-2).
    fn check_plane(&mut self, functions: &Functions) {
        if let Some((function, word)) = functions.of(GGroup::G1)
            && let Some(finding) = missing_axis(&self.settings.machine.axes, function)
        {
            self.report(word, finding);
        }
    }

    /// What L and Q are for (FLW-7), what G04 needs (GRP-5), and that the L of G79 is written out (PRG-3).
    fn check_roles(&mut self, words: &[Word], functions: &Functions, flags: BlockFlags) {
        let only_g = words.iter().all(|word| word.address == Address::G);
        functions.roles.check(flags.has(BlockFlags::END), |word, mut finding| {
            if let Finding::MissingTarget { function: GCode::G71, meant } = &mut finding {
                let known = || self.known_subprograms().unwrap_or_else(|| meant.clone());
                *meant = if only_g { TargetMeant::Millimetres } else { known() };
            }
            let exchanged = unused::exchanged_call(self.units, words, functions)
                .filter(|(code, l)| *code != GCode::G71 || unused::is_unit(self.units, *l));
            let unused = matches!(finding, Finding::UnusedRepeat {} | Finding::UnusedTarget { .. });
            if unused && self.is_refused(word) {
                return;
            }
            if matches!(finding, Finding::UnusedRepeat {})
                && (functions.is_call_elsewhere(words)
                    || exchanged.is_some()
                    || unused::is_call_alone(self.file, self.units, words))
            {
                return;
            }
            let called = || words.iter().find(|word| word.address == Address::P).and_then(|word| word.whole());
            let is_target = matches!(finding, Finding::UnusedTarget { .. });
            if is_target && functions.calls_elsewhere().is_some() && called().is_some_and(|p| !(1..=99).contains(&p)) {
                // The P has its finding, with what is written here.
                return;
            }
            if let Finding::UnusedTarget { meant } = &mut finding {
                *meant = match exchanged {
                    Some((code, l)) => {
                        let count = functions.roles.q.and_then(Word::whole);
                        let count = count.map_or_else(String::new, |count| format!(" Q{count}"));
                        UnusedMeant::Exchanged { written: format!("{code} L{l}{count}") }
                    }
                    None => {
                        let meant = unused::meant(words, functions, word);
                        let lost = || unused::lost_function(self.file, self.units, words, word);
                        if meant == UnusedMeant::Target { lost() } else { meant }
                    }
                };
            }
            self.report(word, finding);
        });
        if let Taker::One(GCode::G79, _) = functions.roles.taker
            && let Some(l) = functions.roles.l.filter(|l| !l.is_faulty())
            && let Value::Parameter { index, .. } = l.value()
        {
            let needs = ParameterNeed::WrittenOut("L".to_owned());
            let value = String::new();
            let finding = Finding::UnusableParameterValue { address: Address::L, parameter: index, value, needs };
            self.report(l, finding);
            self.refused.push(l.start());
        }
    }

    /// Whether a word of the block in hand has a finding about its value.
    fn is_refused(&self, word: Word) -> bool {
        /// So many words of a block are looked at.
        const WORDS: usize = 64;
        self.refused.iter().rev().take(WORDS).any(|start| *start == word.start())
    }

    /// The first subprograms of the file, when there are any.
    fn known_subprograms(&self) -> Option<TargetMeant> {
        let number = |unit: &Unit| match unit.kind {
            UnitKind::Subprogram(l) => l,
            UnitKind::Main | UnitKind::Macrocycle(_) => None,
        };
        let known: Vec<String> =
            self.units.iter().filter_map(number).take(MOST_NAMED).map(|l| format!("L{l}")).collect();
        (!known.is_empty()).then(|| TargetMeant::OneOf { known: known.join(", ") })
    }

    /// Words that are legal here, but are written for what they mean on other controls.
    fn check_other_meanings(&mut self, words: &[Word], functions: &Functions) {
        let of = |address: Address| words.iter().copied().find(|word| word.address == address);
        if let (Some(m), true, Some(p)) =
            (functions.calls_elsewhere(), functions.is_call_elsewhere(words), of(Address::P))
            && let Some(number) = p.whole()
        {
            let count = functions.roles.q.and_then(|q| q.whole());
            self.report(m, Finding::OtherMeaning { meant: OtherMeaning::Call { l: number }, count });
        }
        // `T0101`: the tool and its offset.
        if let Some(t) = of(Address::T).filter(|t| !t.is_faulty())
            && let Some(tool) = t.whole().filter(|tool| (101..1000).contains(tool) && tool / 100 == tool % 100)
        {
            let written = self.file.source.slice(t.span(self.file.source.text()));
            if written.get(1..).sure().trim_start_matches([' ', '\t']).starts_with('0') {
                let written = written.to_ascii_uppercase();
                self.report(
                    t,
                    Finding::OtherMeaning { meant: OtherMeaning::ToolWithOffset { written, tool }, count: None },
                );
            }
        }
        let table = functions.of(GGroup::G10).is_some_and(|(code, _)| code == GCode::G92);
        let moves = words.iter().any(|word| word.address.axis().is_some());
        if let (Some(f), Some((_, g))) = (of(Address::F).filter(|_| table && moves), functions.of(GGroup::G10))
            && !f.is_faulty()
        {
            self.report(g, Finding::OtherMeaning { meant: OtherMeaning::Thread, count: None });
        }
        let only_speed = !words.iter().any(|word| word.address.axis().is_some() || word.address == Address::D);
        if let Some(s) = of(Address::S).filter(|s| table && only_speed && !s.is_faulty()) {
            self.report(s, Finding::OtherMeaning { meant: OtherMeaning::SpeedLimit, count: None });
        }
    }

    /// Parameters: R95, what is assigned and read, control words (PAR-4, PAR-7…PAR-9).
    fn check_parameters(&mut self, words: &[Word], functions: &Functions) {
        if functions.r_words == 0 && functions.of(GGroup::G4).is_none() {
            return;
        }
        let mut assigned: [Option<Word>; 96] = [None; 96];
        let mut void = false;
        for &word in words.iter().filter(|word| word.address == Address::R) {
            void |= word.is_void();
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
                self.findings.add(if elsewhere { diagnostic.with_label(assigned, label) } else { diagnostic });
            }
        }
        if let Some((function, g_word)) = functions.of(GGroup::G4) {
            // G28 approaches the reference point on other controls.
            let axes = words.iter().any(|word| word.address.axis().is_some());
            let reference = function == GCode::G28 && functions.r_words == 0 && axes;
            self.check_control_words((function, g_word), &assigned, void, reference);
        }
    }

    fn check_control_words(
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
                        && let Err(finding) = super::structure::control_word(&self.settings.machine, value)
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
    fn report_control_word(&mut self, word: Word, finding: Finding) {
        if let Finding::UnknownOperation { operation, .. } = finding {
            let diagnostic = Diagnostic::new(finding, self.file.value_place(word));
            self.operations.push((operation, diagnostic));
        } else {
            self.report_value(word, finding);
        }
    }

    /// `/` where it is not what was meant (BLK-6), or in a block that gives structure (BLK-10).
    fn check_skip(
        &mut self,
        block: BlockId,
        words: &[Word],
        functions: &Functions,
        flags: BlockFlags,
        unit: Option<UnitKind>,
    ) {
        let Some(&skip) = words.iter().find(|word| word.address == Address::Skip) else { return };
        let ends = match functions.m.get(1).copied().flatten() {
            Some((number, _)) if PROGRAM_ENDS.contains(&number) => Some(format!("M{number:02}")),
            _ if flags.has(BlockFlags::RETURN) && !matches!(unit, Some(UnitKind::Main)) => Some("G70".to_owned()),
            _ => None,
        };
        // Of a `/` that was meant for the next block one finding is enough.
        let mut before_next = false;
        for (place, _) in words.iter().enumerate().filter(|(_, word)| word.address == Address::Skip) {
            before_next |= self.check_skip_place(block, words, place);
        }
        if let Some(function) = ends
            && !flags.has(BlockFlags::ENTRY)
            && !before_next
        {
            self.report(skip, Finding::SkippableStructure { function });
        }
    }

    /// Warns of a `/` that begins its line or stands directly before an `N` on the same line (BLK-6). Gives whether it is
    /// such an `N`.
    fn check_skip_place(&mut self, block: BlockId, words: &[Word], place: usize) -> bool {
        let Some(&skip) = words.get(place) else { return false };
        let source = &self.file.source;
        let line = source.line_span(source.lines().line_at(skip.start()));
        let before = place.checked_sub(1).and_then(|before| words.get(before).copied()).or(self.file.n_word(block));
        let begins_line = before.is_none_or(|word| word.span(source.text()).end <= line.start);
        let is_last = place + 1 == words.len();
        let on_line = |at: u32| line.start <= at && at < line.end;
        let next = self.file.n_word(block.next()).filter(|next| is_last && on_line(next.start()));
        if !begins_line && next.is_none() {
            return false;
        }
        let place = self.file.word_place(skip);
        let entry = next.is_some() && self.file.flags(block.next()).has(BlockFlags::ENTRY);
        let finding = Finding::SkipBeforeBlockNumber { block: self.file.shown_number(block), entry };
        let mut diagnostic = Diagnostic::new(finding, place);
        if let Some(next) = next.filter(|_| !entry && self.takes_skip(block.next(), line)) {
            let text = source.slice(place.span);
            let behind = Span::empty(next.span(source.text()).end);
            diagnostic = diagnostic.with_offer(
                FixTitle::MoveSkip { block: self.file.shown_number(block.next()) },
                Location { span: behind, ..place },
                format!(" {text}"),
            );
            let mut removed = place;
            // The blanks behind it go too, so that the block number takes its place.
            if source.slice(Span::new(place.span.end, next.start())).bytes().all(|byte| matches!(byte, b' ' | b'\t')) {
                removed.span.end = next.start();
            }
            if let Some(fix) = diagnostic.fixes.first_mut() {
                fix.edits.insert(0, crate::diag::Edit { at: removed, text: String::new() });
            }
        }
        self.findings.add(diagnostic);
        next.is_some()
    }

    /// Whether a `/` can move into the block, which is on that line: the block has none, or one that moves on itself, and
    /// the `/` will not stand before the next `N` again.
    fn takes_skip(&self, mut block: BlockId, line: Span) -> bool {
        /// Blocks looked at: more in one line are no program.
        const MOST: usize = 16;
        for _ in 0..MOST {
            let words = self.file.words(block);
            let followed = self.file.n_word(block.next()).is_some_and(|next| next.start() < line.end);
            let is_skip = |word: &Word| word.address == Address::Skip;
            let Some((last, others)) = words.split_last() else { return !followed };
            if others.iter().any(is_skip) {
                return false;
            }
            if !is_skip(last) {
                return true;
            }
            if !followed || others.is_empty() {
                return false;
            }
            block = block.next();
        }
        true
    }

    /// M02 and M30 in a subprogram or macrocycle (PRG-5).
    fn check_end_in_unit(&mut self, words: &[Word]) {
        for &word in words {
            if let Some(function) = m_number(word, self.settings).filter(|number| PROGRAM_ENDS.contains(number)) {
                self.report(word, Finding::ProgramEndInSubprogram { function });
            }
        }
    }
}

/// A call as other controls write it with M98: `P100 L3`, `P30100`.
fn call_elsewhere(address: Address, value: Decimal, functions: &Functions) -> Option<String> {
    let l = value.as_whole().filter(|l| address == Address::P && (1..=i64::from(HIGHEST_L)).contains(l));
    let count = functions.roles.l.and_then(Word::whole).map_or_else(String::new, |count| format!(" Q{count}"));
    l.map(|l| format!("G71 L{l}{count}")).or_else(|| packed_call(address, value))
}

/// A call as other controls write it in one P, `P40010` for four times `O0010`.
fn packed_call(address: Address, value: Decimal) -> Option<String> {
    let digits = value.as_whole().filter(|digits| *digits >= 10_000)?;
    (address == Address::P && value <= Decimal::WHOLE_MAX).then_some(())?;
    let (count, l) = (digits / 10_000, digits % 10_000);
    (1..=99).contains(&count).then_some(())?;
    (l > 0).then(|| format!("G71 L{l} Q{count}"))
}

/// What was meant by a value with a point.
fn point_meant(address: Address, value: Decimal, dwell: bool) -> PointMeant {
    if dwell {
        // GRP-5: units of 10 ms.
        let units = (value.thousandths() + 5) / 10;
        let written = (0..10_000).contains(&units).then(|| format!("{address}{units}"));
        return written.map_or(PointMeant::Dwell, |written| PointMeant::Seconds { written });
    }
    match (address, value.as_whole()) {
        (_, Some(whole)) => PointMeant::Whole { written: format!("{address}{whole}") },
        (Address::G, None) if value.thousandths() / 1000 == 54 => PointMeant::Origin,
        (Address::G | Address::M, None) => PointMeant::Function,
        (_, None) => PointMeant::Plain,
    }
}

/// The number of the M function that a word writes out, when the dialect has it.
pub fn m_number(word: Word, settings: &Settings) -> Option<u8> {
    if word.address != Address::M {
        return None;
    }
    let number = word.whole().and_then(|number| u8::try_from(number).ok())?;
    (number <= settings.machine.dialect.highest_m()).then_some(number)
}
