//! What is told at the end of a block: the words of one mistake become one finding, and what stands around a word says
//! what was meant by it.

use super::lower::Lowering;
use super::misread::look_alike;
use super::missing::SLIPS;
use super::{BlockFlags, Kind, Word, tokens};
use crate::diag::{
    Code, CommaMeant, Diagnostic, DwellMeant, Edit, Finding, FixTitle, NumberMeant, TargetMeant, ValueMeant, shown,
};
use crate::dict::{Address, Decimal, GCode, GGroup, HIGHEST_Q};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::text::{Location, Span};

/// So far back a G02 or G03 is looked for: what is farther is not what a machinist looks at.
const FAR: u32 = 1 << 12;
/// A dwell without a point is taken for milliseconds from here on: nobody writes so many seconds.
const MILLISECONDS: i64 = 100;

impl Lowering<'_> {
    /// Whether a word of the block in hand may be written as other controls do, so that its end has to be looked at.
    pub(super) const fn is_candidate(number: u8) -> bool {
        matches!(number, 4 | 70..=73 | 79)
    }

    /// Ends a block whose words begin at `first` in the arena, its `N` included.
    pub(super) fn finish_block(&mut self, first: usize) {
        if std::mem::take(&mut self.candidate) {
            self.turning_cycle(first);
            self.dwell(first);
            self.dwell_with_comma(first);
        }
        self.small_l_in_number(first);
        if self.pending.is_empty() {
            return;
        }
        self.letters_for_digits(first);
        self.forgotten_addresses(first);
        self.letters_for_last_digits(first);
        self.letters_in_functions(first);
        self.radius_in_arc(first);
        self.line_elsewhere(first);
        self.height_of_cycle(first);
        self.poison(first);
        let parts = std::mem::take(&mut self.parts);
        for diagnostic in self.pending.drain(..) {
            let is_junk = matches!(diagnostic.code(), Code::E0101 | Code::E0103 | Code::E0106 | Code::E0301);
            if !(is_junk && parts.contains(&diagnostic.at.span.start)) {
                self.findings.add(diagnostic);
            }
        }
    }

    fn block_words(&self, first: usize) -> &[Word] {
        self.words.get(first..).sure()
    }

    fn g_word(&self, first: usize, codes: &[GCode]) -> Option<(usize, GCode, Word)> {
        let words = (first..).zip(self.block_words(first));
        let mut found = words.filter_map(|(at, word)| {
            let code = word.g_code().filter(|_| !word.is_faulty())?;
            codes.contains(&code).then_some((at, code, *word))
        });
        found.next()
    }

    /// G71, G72, G73 with the words of a turning or drilling cycle of other controls, G70 with those of a finishing cycle.
    fn turning_cycle(&mut self, first: usize) {
        let has = |address: Address| self.block_words(first).iter().any(|word| word.address == address);
        let radius = self.block_words(first).iter().any(|word| word.address == Address::R && word.is_void());
        let place = |word: Word| self.at(word.span(self.text));
        let diagnostic = if let Some((_, _, g)) = self.g_word(first, &[GCode::G70]) {
            if !has(Address::P) || !has(Address::Q) {
                return;
            }
            Diagnostic::new(Finding::EndOutsideSubprogram { finishing: true }, place(g))
        } else if let Some((_, function, g)) = self.g_word(first, &[GCode::G71, GCode::G72, GCode::G73]) {
            let cycle = radius || [Address::U, Address::W, Address::P].into_iter().any(has);
            if has(Address::L) || !cycle {
                return;
            }
            if let Some(number) = self.called_by_p(first) {
                let place = place(g);
                self.called_in_place(first, function, place, number);
                return;
            }
            let drilling = function == GCode::G73 && has(Address::Z) && !has(Address::P);
            let meant = if drilling { TargetMeant::Drilling } else { TargetMeant::Turning };
            Diagnostic::new(Finding::MissingTarget { function, meant }, place(g))
        } else {
            self.entry_by_p(first);
            return;
        };
        self.pending.retain(|found| is_about_comments(found.code()));
        self.pending.push(diagnostic);
        self.flags.clear(BlockFlags::RETURN);
        let text = self.text;
        for word in self.words.iter_mut().skip(first).filter(|word| word.address != Address::N) {
            *word = Word::bare(word.address, word.span(text)).faulty().assigning(word.target());
        }
    }

    /// `G79 P100`: the number of a subprogram behind another address.
    fn entry_by_p(&mut self, first: usize) {
        let Some((_, function, g)) = self.g_word(first, &[GCode::G79]) else { return };
        if let Some(number) = self.called_by_p(first) {
            let place = self.at(g.span(self.text));
            self.called_in_place(first, function, place, number);
        }
    }

    /// The P of a block that has nothing else but Q, a count: the number of what it calls. With another block number in Q it
    /// is a cycle.
    fn called_by_p(&self, first: usize) -> Option<Word> {
        let of = |address: Address| self.block_words(first).iter().copied().find(|word| word.address == address);
        let p = of(Address::P)?;
        let known =
            |word: &Word| matches!(word.address, Address::N | Address::Skip | Address::G | Address::P | Address::Q);
        let alone = self.block_words(first).iter().all(known);
        let count = of(Address::Q).is_none_or(|q| q.whole().is_some_and(|q| p.whole().is_some_and(|p| q < p)));
        (alone && count && p.is_digits()).then_some(p)
    }

    /// `G71 P100`: the number of a subprogram behind another address.
    fn called_in_place(&mut self, first: usize, function: GCode, place: Location, p: Word) {
        let span = p.span(self.text);
        let letter = self.at(Span::new(span.start, span.start + 1));
        let text = self.slice(span).to_ascii_uppercase();
        let written = format!("L{}", text.get(1..).sure().trim_start_matches([' ', '\t']));
        let meant = TargetMeant::Written { written: shown(&written) };
        let diagnostic = Diagnostic::new(Finding::MissingTarget { function, meant }, place);
        self.pending.push(diagnostic.with_offer(FixTitle::Write { text: shown(&written) }, letter, "L"));
        let number = Number { value: p.number().unwrap_or_default(), ..Number::default() };
        if let Some(slot) = self.words.iter_mut().skip(first).find(|word| word.start() == span.start) {
            *slot = Word::with_number(Address::L, span, number).faulty();
        }
    }

    /// G04 with its time in another word than Q: `G04 P500`, `G04 X0.5`, `G04 F0.5` (GRP-5).
    fn dwell(&mut self, first: usize) {
        let Some((_, _, g)) = self.g_word(first, &[GCode::G04]) else { return };
        let mut others = (first..)
            .zip(self.block_words(first))
            .filter(|(_, word)| !matches!(word.address, Address::N | Address::G | Address::M | Address::Skip));
        let (Some((at, &time)), None) = (others.next(), others.next()) else { return };
        // Words of other controls that are something else here too.
        let other = matches!(time.address, Address::H | Address::K | Address::S);
        let known = other || matches!(time.address, Address::P | Address::X | Address::U | Address::F);
        let Some(value) = time.number().filter(|value| known && !time.is_faulty() && value.thousandths() > 0) else {
            return;
        };
        let seconds = time.has_point() || time.address == Address::F;
        let units = match value.as_whole() {
            Some(whole) if !seconds && !other && whole >= MILLISECONDS => Some((whole + 5) / 10),
            Some(whole) if !seconds => Some(whole * 100),
            Some(_) | None => Some((value.thousandths() + 5) / 10),
        };
        let units = units.filter(|units| (1..=HIGHEST_Q).contains(units));
        let span = time.span(self.text);
        let place = self.at(span);
        let text = units.map(|units| format!("Q{units}"));
        // A block with G04 may move: a whole X may be a coordinate.
        let maybe_target = matches!(time.address, Address::X | Address::U) && !time.has_point();
        let in_seconds = other || !seconds && value < Decimal::whole(MILLISECONDS);
        let meant = match &text {
            Some(text) if in_seconds => DwellMeant::Seconds { address: time.address, written: text.clone() },
            Some(text) if maybe_target => DwellMeant::Perhaps { address: time.address, written: text.clone() },
            Some(text) => DwellMeant::Written { written: text.clone() },
            None => DwellMeant::Units,
        };
        let mut diagnostic = Diagnostic::new(Finding::MissingDwell { meant }, self.at(g.span(self.text)));
        if let Some(text) = text {
            let title = FixTitle::Write { text: shown(&text) };
            diagnostic = diagnostic.with_offer(title, place, text);
        }
        self.pending.retain(|found| is_about_comments(found.code()));
        self.pending.push(diagnostic);
        let word = match units {
            Some(units) => {
                let number = Number { value: Decimal::whole(units), ..Number::default() };
                Word::with_number(Address::Q, span, number)
            }
            None => Word::bare(Address::Q, span),
        };
        if let Some(slot) = self.words.get_mut(at) {
            *slot = word.faulty();
        }
    }

    /// `G04 Q0,5`: seconds.
    fn dwell_with_comma(&mut self, first: usize) {
        if self.g_word(first, &[GCode::G04]).is_none() {
            return;
        }
        let text = self.text;
        let of_dwell = |found: &&mut Diagnostic| {
            matches!(found.finding, Finding::DecimalComma { meant: CommaMeant::Whole { address: Address::Q } })
        };
        for found in self.pending.iter_mut().filter(of_dwell) {
            let number = text.get(found.at.span.range()).and_then(|word| word.get(1..)).unwrap_or_default();
            let number: String = number.chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
            let units = Number::parse(number.replace(',', ".").as_bytes()).map(|n| (n.value.thousandths() + 5) / 10);
            if let Some(units) = units.filter(|units| (1..=HIGHEST_Q).contains(units)) {
                found.finding = Finding::DecimalComma { meant: CommaMeant::Dwell { written: format!("Q{units}") } };
            }
        }
    }

    /// `G0I`, `X6l`, `Y3S`: a letter without a value, right behind a number, is the digit that it looks like. Of words
    /// without a decimal point too the other reading is possible, so that it is offered only.
    fn letters_for_last_digits(&mut self, first: usize) {
        for _ in 0..SLIPS {
            let Some(at) = (first + 2..self.words.len()).find(|at| self.is_letter_for_digit(first, *at)) else {
                return;
            };
            let (Some(word), Some(letter)) = (self.words.get(at - 1).copied(), self.words.get(at).copied()) else {
                return;
            };
            let (word_span, letter_span) = (word.span(self.text), letter.span(self.text));
            let span = word_span.to(letter_span);
            let Some(digit) = look_alike(self.byte(letter_span.start)) else { return };
            let text = format!("{}{digit}", self.slice(word_span).to_ascii_uppercase());
            let number = text.get(1..).sure().trim_start_matches([' ', '\t']);
            let Some(number) = Number::parse(number.as_bytes()) else { return };
            self.words.remove(at);
            if let Some(slot) = self.words.get_mut(at - 1) {
                // A coordinate may have been meant otherwise.
                let known = !word.address.is_dimensional();
                let word =
                    if known { Word::with_number(word.address, span, number) } else { Word::bare(word.address, span) };
                *slot = word.faulty();
            }
            let about_letter = |found: &Diagnostic| found.code() == Code::E0103 && found.at.span == letter_span;
            self.pending.retain(|found| !about_letter(found));
            let place = self.at(span);
            let diagnostic = Diagnostic::new(Finding::LetterForDigit { fixed: shown(&text) }, place);
            self.pending.push(diagnostic.with_offer(FixTitle::Write { text: shown(&text) }, place, text));
        }
    }

    /// `G5A`: a letter without a value, right behind a function of one digit, stands in place of its second one.
    fn letters_in_functions(&mut self, first: usize) {
        for at in first + 1..self.words.len() {
            let (Some(word), Some(letter)) = (self.words.get(at - 1).copied(), self.words.get(at).copied()) else {
                return;
            };
            let (word_span, letter_span) = (word.span(self.text), letter.span(self.text));
            let behind = word_span.end == letter_span.start && letter_span.len() == 1 && word_span.len() == 2;
            if behind && letter.is_void() && letter.is_faulty() && word.is_plain() && word.address == Address::G {
                let unknown = Word::bare(Address::G, word_span).faulty();
                if let Some(slot) = self.words.get_mut(at - 1) {
                    *slot = unknown;
                }
                // `G7N` with a number would begin a block.
                let whole = word_span.to(letter_span);
                let place = self.at(whole);
                let text = shown(self.slice(whole));
                let of_number = |found: &&mut Diagnostic| {
                    letter.address == Address::N && found.code() == Code::E0103 && found.at.span == letter_span
                };
                if let Some(found) = self.pending.iter_mut().take(SLIPS).find(of_number) {
                    *found = Diagnostic::new(Finding::MalformedNumber { text, meant: NumberMeant::Form }, place);
                }
            }
        }
    }

    /// `L Z+100 R0 FMAX`: a straight line as another control writes it, one finding with the function that is meant.
    fn line_elsewhere(&mut self, first: usize) {
        let lone = |word: &&Word| word.address == Address::L && word.is_void() && word.is_faulty();
        let Some(letter) = self.block_words(first).iter().find(lone).map(|word| word.span(self.text)) else { return };
        let moves = self.block_words(first).iter().any(|word| word.address.axis().is_some() && !word.is_void());
        let has_function = self.block_words(first).iter().any(|word| word.address == Address::G);
        if !moves || has_function || letter.len() != 1 {
            return;
        }
        let is_fastest =
            |found: &Diagnostic| matches!(&found.finding, Finding::MalformedNumber { meant: NumberMeant::Fastest, .. });
        let function = if self.pending.iter().any(is_fastest) { GCode::G00 } else { GCode::G01 };
        // R0, RL, RR: whether the radius is corrected.
        let of_radius = |found: &Diagnostic| matches!(&found.finding, Finding::MissingValue { address, .. } if address == "R0" || address == "R");
        let (dropped, kept) = self.pending.drain(..).partition(|found| is_fastest(found) || of_radius(found));
        self.pending = kept;
        let dropped: Vec<Diagnostic> = dropped;
        let of_letter = |found: &&mut Diagnostic| found.code() == Code::E0103 && found.at.span == letter;
        let place = self.at(letter);
        let deleted = dropped.into_iter().map(|found| Edit { at: found.at, text: String::new() });
        let edits = std::iter::once(Edit { at: place, text: function.to_string() }).chain(deleted).collect();
        if let Some(found) = self.pending.iter_mut().find(of_letter) {
            let finding = Finding::MissingValue { address: "L".to_owned(), meant: ValueMeant::Line { function } };
            *found = Diagnostic::new(finding, place).with_offers(FixTitle::Write { text: function.to_string() }, edits);
        }
    }

    /// R without `=` beside a fixed cycle is meant as its height; then what else other controls write there is part of it.
    fn height_of_cycle(&mut self, first: usize) {
        let of_cycle = |word: &Word| word.g_code().filter(|code| code.is_cycle());
        let Some(cycle) = self.block_words(first).iter().find_map(of_cycle) else { return };
        let mut height = false;
        for found in &mut self.pending {
            if let Finding::MissingValue { address, meant: meant @ (ValueMeant::Number | ValueMeant::Beyond) } =
                &mut found.finding
                && address.starts_with('R')
            {
                *meant = ValueMeant::Height { cycle };
                height = true;
            } else if let Finding::MalformedNumber { meant: NumberMeant::Parameter, .. } = &found.finding {
                let address = shown(self.text.get(found.at.span.range()).sure());
                found.finding = Finding::MissingValue { address, meant: ValueMeant::Height { cycle } };
                height = true;
            }
        }
        let text = self.text;
        for word in self.words.iter_mut().skip(first).filter(|_| height) {
            if matches!(word.address, Address::Q | Address::P | Address::K | Address::L) {
                *word = Word::bare(word.address, word.span(text)).faulty();
            }
        }
    }

    /// Whether the word at `at` is a letter for the last digit of the word before it, in a block whose words begin at `first`.
    fn is_letter_for_digit(&mut self, first: usize, at: usize) -> bool {
        let (Some(word), Some(letter)) = (self.words.get(at - 1).copied(), self.words.get(at).copied()) else {
            return false;
        };
        if !letter.is_void()
            || !letter.is_faulty()
            || !matches!(letter.address, Address::I | Address::L | Address::S | Address::B)
        {
            return false;
        }
        let (word_span, letter_span) = (word.span(self.text), letter.span(self.text));
        let behind = word.is_plain() && word_span.end == letter_span.start && letter_span.len() == 1;
        let numbered = !matches!(word.address, Address::R | Address::N | Address::Skip | Address::Program);
        // Functions have two digits.
        let room = !matches!(word.address, Address::G | Address::M) || word_span.len() == 2;
        let center = |word: &Word| matches!(word.address, Address::J | Address::K);
        behind
            && numbered
            && room
            && match self.byte(letter_span.start) {
                b'l' | b'S' | b'B' => true,
                b'I' => !self.block_words(first).iter().any(center) && !self.arc_in_force(letter_span.start),
                _ => false,
            }
    }

    /// R without `=` in a block with an arc is meant as its radius.
    fn radius_in_arc(&mut self, first: usize) {
        let is_radius = |diagnostic: &Diagnostic| {
            matches!(&diagnostic.finding, Finding::MissingValue { address, meant: ValueMeant::Number | ValueMeant::Beyond } if address.starts_with('R'))
                || matches!(&diagnostic.finding, Finding::MalformedNumber { meant: NumberMeant::Parameter, .. })
        };
        let Some(span) = self.pending.iter().find(|found| is_radius(found)).map(|found| found.at.span) else { return };
        let end = self.words.last().map_or(span, |last| last.span(self.text)).end;
        if !self.arc_in_force(end) {
            return;
        }
        for diagnostic in &mut self.pending {
            if !is_radius(diagnostic) {
                continue;
            }
            if let Finding::MissingValue { meant, .. } = &mut diagnostic.finding {
                *meant = ValueMeant::Radius;
            } else if let Finding::MalformedNumber { meant, .. } = &mut diagnostic.finding {
                *meant = NumberMeant::Radius;
            }
        }
        let centered = self.block_words(first).iter().any(|word| matches!(word.address, Address::I | Address::J));
        if !centered {
            // The centre was given, in a way that is none here.
            self.push(Word::bare(Address::I, span).faulty(), span);
        }
    }

    /// Whether the last function of group G0 before `end`, in the order of the text, is G02 or G03. It is asked of the
    /// text, not of the words that were read: another part of a long text is read beside this one.
    pub(super) fn arc_in_force(&self, end: u32) -> bool {
        let bytes = self.text.as_bytes();
        let least = end.saturating_sub(FAR) as usize;
        let mut to = end as usize;
        while to > least {
            let head = bytes.get(least..to.saturating_sub(1)).sure();
            let from = memchr::memrchr2(b'\n', b'\r', head).map_or(least, |at| least + at + 1);
            if let Some(code) = last_motion(self.text, from, to) {
                return matches!(code, GCode::G02 | GCode::G03);
            }
            to = from;
        }
        false
    }
}

/// The last function of group G0 in a line.
fn last_motion(text: &str, from: usize, to: usize) -> Option<GCode> {
    let from = (from..to).find(|at| text.is_char_boundary(*at))?;
    let codes = tokens(text, small(from), small(to)).filter_map(|token| {
        let word = text.get(token.span().range()).filter(|_| token.kind == Kind::Word)?;
        let number = word.strip_prefix(['G', 'g'])?.trim_matches([' ', '\t']);
        let code = number.parse().ok().and_then(GCode::from_number)?;
        (code.group() == GGroup::G0).then_some(code)
    });
    codes.last()
}

/// Whether a finding is about a comment, not about a word.
const fn is_about_comments(code: Code) -> bool {
    matches!(code, Code::E0105 | Code::W0114)
}
