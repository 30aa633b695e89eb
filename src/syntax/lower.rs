//! From the items of the grammar to words, comments and findings.

use super::grammar::Item;
use super::misread::look_alike;
use super::number::Number;
use super::{BlockFlags, Kind, Token, Word, swallowed};
use crate::diag::{Certain, CommaMeant, Diagnostic, Edit, Finding, Findings, FixTitle, NumberMeant, ValueMeant, shown};
use crate::dict::{Address, Decimal, GCode, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, Span};

/// Where the words, comments and findings of a run of blocks are collected.
#[derive(Debug)]
pub(super) struct Lowering<'t> {
    pub(super) text: &'t str,
    pub(super) file: FileId,
    pub(super) words: Vec<Word>,
    pub(super) comments: Vec<Span>,
    /// What is known of the block in hand.
    pub(super) flags: BlockFlags,
    pub(super) findings: Findings,
    /// Findings of the block in hand: what is around them may say what was meant.
    pub(super) pending: Vec<Diagnostic>,
    /// What makes no word in the block in hand, and where junk begins that is part of other junk.
    pub(super) junk: Vec<Span>,
    pub(super) parts: Vec<u32>,
    /// Where addresses in lower case stand, in words without a finding (LEX-11).
    pub(super) lowercase: Vec<u32>,
    /// Where the first word stands.
    pub(super) first_word: Option<Span>,
    /// The block in hand has a function that other controls write with other words: its end is looked at.
    pub(super) candidate: bool,
    /// Where the line ends in which a quote is missing: texts further on in it are none.
    pub(super) quotes_off: Option<u32>,
}

/// The highest parameter is R95.
pub(super) const PARAMETERS: u8 = 96;
/// The typographic quotes (LEX-12).
const TYPOGRAPHIC: [char; 3] = ['“', '”', '„'];

/// What a word of that address makes of its block.
const fn made_of(address: Address) -> BlockFlags {
    match address {
        Address::N => BlockFlags(0),
        Address::X
        | Address::Y
        | Address::Z
        | Address::A
        | Address::B
        | Address::C
        | Address::U
        | Address::V
        | Address::W => BlockFlags::AXES,
        Address::G
        | Address::M
        | Address::L
        | Address::Q
        | Address::R
        | Address::Correction
        | Address::Skip
        | Address::Program => BlockFlags(BlockFlags::RICH.0 | BlockFlags::OTHERS.0),
        Address::I
        | Address::J
        | Address::K
        | Address::D
        | Address::F
        | Address::S
        | Address::T
        | Address::H
        | Address::P => BlockFlags::OTHERS,
    }
}

impl<'t> Lowering<'t> {
    pub(super) fn new(text: &'t str, file: FileId) -> Self {
        Self {
            text,
            file,
            words: Vec::new(),
            comments: Vec::new(),
            flags: BlockFlags::default(),
            findings: Findings::new(),
            pending: Vec::new(),
            junk: Vec::new(),
            parts: Vec::new(),
            lowercase: Vec::new(),
            first_word: None,
            candidate: false,
            quotes_off: None,
        }
    }

    pub(super) fn accept(&mut self, item: Item) {
        match item {
            Item::Word { word, pieces } => self.loose_word(word, &pieces),
            Item::Parametric { address, parameter, pieces } => self.parametric(address, parameter, &pieces),
            Item::Copy { target, sign, source, pieces } => self.copy(target, sign, source, &pieces),
            Item::Assignment { target, sign, number, pieces } => self.assignment(target, sign, number, &pieces),
            Item::SplitSign { address, number, pieces } => {
                let mut all = vec![number];
                all.extend(pieces);
                self.loose_word(address, &all);
            }
            Item::ForeignAssignment { address, number } => {
                let span = address.span().to(number.span());
                self.void_word(address, span, |text| Finding::MalformedNumber { text, meant: NumberMeant::EqualsForm });
            }
            Item::Valueless { address, end, comments } => {
                self.valueless(address, end, comments.is_some());
                for comment in comments.unwrap_or_default() {
                    self.comment(comment);
                }
            }
            Item::ManySigns { first, last } => {
                let meant = NumberMeant::Form;
                self.void_word(first, first.span().to(last.span()), |text| Finding::MalformedNumber { text, meant });
            }
            Item::Bracketed { first, last } => self.bracketed(first, last),
            Item::NoParameter { address, parameter } => self.no_parameter(address, parameter),
            Item::SplitParameter { target, value } => self.split_parameter(target, value),
            Item::Radius { first, last } => self.radius(first, first.span().to(last.span())),
            Item::SignBeforeEquals { target, sign, value } => self.sign_before_equals(target, sign, value),
            Item::SignFirst { sign, word } => self.sign_first(sign, word),
            Item::OddValue { target, value } => self.odd_value(target, value),
            Item::Foreign(token) => self.foreign(token),
            Item::Skip(token) if self.divided(token.span()) => {}
            Item::Skip(token) => {
                self.flags.set(BlockFlags::SKIP);
                self.flags.set(BlockFlags::RICH);
                self.words.push(Word::bare(Address::Skip, token.span()));
            }
            Item::Comment(token) => self.comment(token),
            Item::Stray { first, last } if self.divided(first.span().to(last.span())) => {}
            Item::Stray { first, last } => {
                let span = first.span().to(last.span());
                let text = shown(self.slice(span));
                let meant = match Number::parse(text.as_bytes()) {
                    Some(_) if self.begins_line(span) && text.bytes().all(|byte| byte.is_ascii_digit()) => {
                        NumberMeant::BlockNumber { written: format!("N{text}") }
                    }
                    Some(_) => NumberMeant::NoAddress,
                    None if text.len() > 2 && text.chars().all(|sign| "+-=. \t…".contains(sign)) => {
                        NumberMeant::Ruler
                    }
                    None if text.contains('=') => NumberMeant::EqualsForm,
                    None => NumberMeant::Form,
                };
                self.junk(span);
                if text.contains('=') {
                    // The parameter is not known.
                    self.push_void(Address::R, span);
                }
                self.debris(span, Finding::MalformedNumber { text, meant });
            }
            Item::Text { first, last } => self.stray_text(first.span().to(last.span())),
            Item::Debris(token) if token.kind == Kind::GarbledWord => self.garbled(token),
            Item::Debris(token) if token.kind == Kind::ForeignComment => self.foreign_comment(token),
            Item::Debris(token) => self.unknown(token),
        }
    }

    pub(super) fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).sure()
    }

    /// Whether nothing but blanks is before a place on its line.
    fn begins_line(&self, span: Span) -> bool {
        let before = self.text.get(..span.start as usize).sure();
        matches!(before.trim_end_matches([' ', '\t']).chars().next_back(), None | Some('\n' | '\r'))
    }

    pub(super) fn byte(&self, at: u32) -> u8 {
        self.text.as_bytes().get(at as usize).copied().unwrap_or(0)
    }

    pub(super) fn at(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    pub(super) fn report(&mut self, span: Span, finding: Finding) {
        self.pending.push(Diagnostic::new(finding, self.at(span)));
    }

    pub(super) fn debris(&mut self, span: Span, finding: Finding) {
        self.flags.set(BlockFlags::DEBRIS);
        self.report(span, finding);
    }

    fn comment(&mut self, token: Token) {
        self.comments.push(token.span());
        let text = self.slice(token.span());
        if token.kind == Kind::TypographicComment {
            self.typographic_comment(token, text);
        } else if text.len() < 2 || !text.ends_with('"') {
            let inner = Span::new(token.start + 1, token.end);
            // A quote that closes a comment which nothing opens has a finding.
            let closes = self.quotes_off.is_some_and(|end| token.start < end);
            if !closes && let Some(words) = swallowed::words(self.text, inner) {
                let finding = Finding::CommentSwallowsWords { words: shown(self.slice(words).trim_end()) };
                self.report(words, finding);
            }
        }
    }

    /// One finding for the quotes of a comment, at the first (LEX-12).
    fn typographic_comment(&mut self, token: Token, text: &str) {
        let mut edits = Vec::new();
        for (at, quote) in text.char_indices().filter(|(_, character)| TYPOGRAPHIC.contains(character)) {
            let start = token.start + small(at);
            let place = self.at(Span::new(start, start + small(quote.len_utf8())));
            edits.push(Edit { at: place, text: "\"".to_owned() });
        }
        if let (Some(quote), Some(place)) = (text.chars().next(), edits.first().map(|edit| edit.at)) {
            let diagnostic = Diagnostic::new(Finding::TypographicQuote { quote }, place);
            // A comment that nothing closes may have swallowed words.
            let inner = Span::new(token.start + small(quote.len_utf8()), token.end);
            let closed = edits.len() > 1 || text.ends_with('"');
            let certain = (closed || swallowed::is_text(self.text, inner)).then_some(Certain::Quotes);
            self.pending.push(diagnostic.with_edits(certain, FixTitle::PlainQuotes, edits));
        }
    }

    /// The address of a word, or the finding that there is none.
    pub(super) fn address(&mut self, start: u32, word: Span) -> Option<Address> {
        let byte = self.byte(start);
        let address = Address::from_byte(byte);
        if address.is_none() {
            self.junk(word);
            self.debris(word, Finding::unknown_address(char::from(byte)));
        }
        address
    }

    /// An address with a well-formed number.
    #[inline]
    pub(super) fn plain_word(&mut self, token: Token) {
        let Some(address) = self.address(token.start, token.span()) else { return };
        match Number::parse(self.number_text(token)) {
            Some(number) => self.push(Word::with_number(address, token.span(), number), token.span()),
            None => self.push(Word::bare(address, token.span()).faulty(), token.span()),
        }
    }

    /// The bytes of a word's number: all after its address and blanks.
    #[inline]
    fn number_text(&self, token: Token) -> &'t [u8] {
        let bytes = self.text.as_bytes().get(token.start as usize + 1..token.end as usize).sure();
        let blanks = bytes.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        bytes.get(blanks..).sure()
    }

    /// Adds a word, which stands at `span`, to the block, noting what later stages ask of every block.
    #[expect(clippy::inline_always, reason = "a word of four fields, handed over in memory, waits for its stores")]
    #[inline(always)]
    pub(super) fn push(&mut self, word: Word, span: Span) {
        self.first_word.get_or_insert(span);
        if !word.is_faulty() {
            self.note_case(span.start);
        }
        self.flags.set(made_of(word.address));
        if !word.is_plain() {
            self.flags.set(BlockFlags::RICH);
        }
        if matches!(word.address, Address::G | Address::M)
            && let Some(number) = word.whole().and_then(|number| u8::try_from(number).ok())
        {
            if word.address == Address::M {
                if PROGRAM_ENDS.contains(&number) {
                    self.flags.set(BlockFlags::END);
                }
                self.words.push(word);
                return;
            }
            self.candidate |= Self::is_candidate(number);
            if number == GCode::G70.number() {
                self.flags.set(BlockFlags::RETURN);
            } else if number == GCode::G79.number() {
                self.flags.set(BlockFlags::ENTRY);
            }
        }
        self.words.push(word);
    }

    /// Notes an address in lower case.
    #[inline]
    fn note_case(&mut self, at: u32) {
        if self.byte(at).is_ascii_lowercase() {
            self.lowercase.push(at);
        }
    }

    /// A word that no fix gives a value: it is in the block, and takes no part in what follows.
    pub(super) fn void_word(&mut self, token: Token, span: Span, finding: impl FnOnce(String) -> Finding) {
        let Some(address) = self.address(token.start, span) else { return };
        let text = shown(self.slice(span));
        self.report(span, finding(text));
        self.push(Word::bare(address, span).faulty(), span);
    }

    /// A word whose number is in pieces or holds characters that do not belong in one.
    fn loose_word(&mut self, token: Token, pieces: &[Token]) {
        let span = pieces.last().map_or(token.span(), |last| token.span().to(last.span()));
        let Some(address) = self.address(token.start, span) else { return };
        let run = String::from_utf8_lossy(self.number_text(token)).into_owned();
        let prefix = char::from(self.byte(token.start).to_ascii_uppercase()).to_string();
        // `Ll30` is `L130` (LEX-12).
        if run.get(..1).is_some_and(|letter| letter.eq_ignore_ascii_case(&prefix) && letter != "l") {
            let written = Some(run.as_str()).filter(|_| pieces.is_empty());
            self.doubled_letter(address, written, span);
            return;
        }
        match self.corrected(run, pieces, address, &prefix, span) {
            Some(number) => self.push(Word::with_number(address, span, number).faulty(), span),
            None => self.push(Word::bare(address, span).faulty(), span),
        }
    }

    /// Reads a faulty number as its fix would write it, and reports what is wrong with it. Without a fix it has no value.
    fn corrected(
        &mut self,
        run: String,
        pieces: &[Token],
        address: Address,
        prefix: &str,
        span: Span,
    ) -> Option<Number> {
        let sign = matches!(run.as_str(), "+" | "-");
        let mut joined = run;
        for piece in pieces {
            joined.push_str(self.slice(piece.span()));
        }
        let comma = joined.contains(',');
        let letter = joined.bytes().any(|letter| look_alike(letter).is_some());
        let digit = |letter: char| u8::try_from(letter).ok().and_then(look_alike).unwrap_or(letter);
        let fixed: String = joined.replace(',', ".").chars().map(digit).collect();
        // A comma behind a number parts it from the next word.
        let fixed = if joined.ends_with(',') { fixed.trim_end_matches('.') } else { fixed.as_str() };
        let number = Number::parse(fixed.as_bytes());
        let fixed = format!("{prefix}{fixed}");
        let malformed = |text: &str| {
            let meant = printed_number(joined.as_str(), prefix);
            Finding::MalformedNumber { text: shown(text), meant }
        };
        let finding = match number {
            Some(number) if comma => return self.with_comma(address, number, (&joined, fixed), prefix, span),
            Some(_) if letter => Finding::LetterForDigit { fixed: shown(&fixed) },
            Some(_) if pieces.is_empty() => return number,
            Some(_) => split(shown(&fixed)),
            None if fixed.bytes().any(|byte| byte.is_ascii_digit() && !prefix.as_bytes().contains(&byte)) => {
                malformed(self.slice(span))
            }
            None if joined.len() > 2 => malformed(self.slice(span)),
            None => {
                let address = shown(prefix.trim_end_matches('='));
                Finding::MissingValue { address, meant: ValueMeant::Number }
            }
        };
        let only = matches!(pieces, [only] if only.kind == Kind::Number && self.byte(only.start) != b'-');
        let certain = if matches!(finding, Finding::LetterForDigit { .. }) {
            // N and L are never 0: another digit was meant.
            let alone = pieces.is_empty() && is_letters(joined.trim_start_matches(['+', '-']).as_bytes());
            (alone && !matches!(address, Address::N | Address::L)).then_some(Certain::LettersAlone)
        } else {
            (sign && only && address.is_dimensional()).then_some(Certain::BlankBehindSign)
        };
        let corrected = !matches!(finding, Finding::MalformedNumber { .. } | Finding::MissingValue { .. });
        let place = self.at(span);
        let title = FixTitle::Write { text: shown(&fixed) };
        let diagnostic = Diagnostic::new(finding, place);
        self.pending.push(if corrected {
            diagnostic.with_edits(certain, title, vec![Edit { at: place, text: fixed }])
        } else {
            diagnostic
        });
        // What is only offered is not known.
        number.filter(|_| corrected && certain.is_some())
    }

    /// A number with a comma: a decimal one, where its address takes a point, or one that parts it from the next word.
    fn with_comma(
        &mut self,
        address: Address,
        number: Number,
        (joined, fixed): (&str, String),
        prefix: &str,
        span: Span,
    ) -> Option<Number> {
        let place = self.at(span);
        let pointed = address.is_dimensional() || address == Address::H;
        let text = self.slice(span);
        let apart = [", ", ",\t", " ,", "\t,"].into_iter().any(|pair| text.contains(pair));
        let (meant, fixed, value) = if joined.ends_with(',') && joined.matches(',').count() == 1 {
            (CommaMeant::Border { written: shown(&fixed) }, Some(fixed), Some(number))
        } else if apart {
            (CommaMeant::Apart { written: shown(&fixed) }, None, None)
        } else if pointed {
            (CommaMeant::Point { written: shown(&fixed) }, Some(fixed), Some(number))
        } else if let Some(whole) = number.value.as_whole().filter(|_| !number.rounded) {
            let written = format!("{prefix}{whole}");
            let number = Number { value: number.value, ..Number::default() };
            (CommaMeant::WholeWritten { written: written.clone() }, Some(written), Some(number))
        } else {
            (CommaMeant::Whole { address }, None, None)
        };
        // `L1,00` may be L100, `X10,` X100.
        let between = joined.split_once(',').is_some_and(|(before, behind)| {
            before.ends_with(|last: char| last.is_ascii_digit()) && behind.bytes().all(|byte| byte.is_ascii_digit())
        });
        let certain = matches!(meant, CommaMeant::Point { .. }) && between && address.is_dimensional();
        let certain = certain.then_some(Certain::DecimalComma);
        let diagnostic = Diagnostic::new(Finding::DecimalComma { meant }, place);
        self.pending.push(match fixed {
            Some(fixed) => {
                let title = FixTitle::Write { text: shown(&fixed) };
                diagnostic.with_edits(certain, title, vec![Edit { at: place, text: fixed }])
            }
            None => diagnostic,
        });
        value.filter(|_| certain.is_some())
    }

    /// The number of a parameter, 0–95, and whether it has a finding already.
    pub(super) fn parameter(&mut self, token: Token) -> (Option<u8>, bool) {
        let digits = self.number_text(token);
        let number_start = token.end - small(digits.len());
        let number_span = Span::new(number_start, token.end);
        let fixed: Vec<u8> = digits
            .iter()
            .map(|byte| match byte {
                b'o' | b'O' => b'0',
                b'l' => b'1',
                other => *other,
            })
            .collect();
        let number = Number::parse(&fixed)
            .filter(|number| !number.point)
            .and_then(|number| number.value.as_whole())
            .and_then(|number| u8::try_from(number).ok())
            .filter(|number| *number < PARAMETERS);
        if number.is_none() {
            self.report(number_span, Finding::ParameterNumber {});
            return (None, true);
        }
        let letters = fixed != digits;
        if letters {
            let text = String::from_utf8_lossy(&fixed).into_owned();
            let place = self.at(number_span);
            let shown = shown(&format!("R{text}"));
            let diagnostic = Diagnostic::new(Finding::LetterForDigit { fixed: shown.clone() }, self.at(token.span()));
            let certain = is_letters(digits).then_some(Certain::LettersAlone);
            let edits = vec![Edit { at: place, text }];
            self.pending.push(diagnostic.with_edits(certain, FixTitle::Write { text: shown }, edits));
        }
        (number, letters)
    }

    /// An address with a parameter in place of its number (PAR-2).
    fn parametric(&mut self, token: Token, parameter: Token, pieces: &[Token]) {
        let span = pieces.last().map_or(token.span().to(parameter.span()), |last| token.span().to(last.span()));
        let whole = token.span().to(parameter.span());
        let Some(address) = self.address(token.start, span) else { return };
        if matches!(address, Address::N | Address::Program) {
            self.report(whole, Finding::ParameterNotAllowed { address });
            self.push(Word::bare(address, whole).faulty(), whole);
            return;
        }
        let (source, faulty) = self.parameter(parameter);
        let Some(source) = source else {
            self.push(Word::bare(address, whole).faulty(), whole);
            return;
        };
        let sign = (token.kind == Kind::SignedLetter).then(|| self.byte(token.end - 1));
        let gap = sign.is_some() && token.end != parameter.start;
        let word = Word::with_parameter(address, span, source, sign);
        if !pieces.is_empty() {
            if !faulty {
                self.parameter_and_number(span, pieces);
            }
            self.push(Word::bare(address, span).faulty(), span);
            return;
        }
        if gap && !faulty {
            self.split_sign(span, Span::new(token.end, parameter.start));
        }
        self.push(if faulty || gap { word.faulty() } else { word }, span);
        if !faulty && !gap {
            self.note_case(parameter.start);
        }
    }

    /// A number behind a parameter that stands for one.
    fn parameter_and_number(&mut self, span: Span, pieces: &[Token]) {
        let text = self.slice(span);
        let computed = pieces.iter().any(|piece| b"+-*/([{<".contains(&self.byte(piece.start)));
        self.report(
            span,
            if computed {
                Finding::MalformedNumber { text: shown(text), meant: NumberMeant::Computed }
            } else {
                split(String::new())
            },
        );
    }

    /// A blank behind the sign of a parameter.
    fn split_sign(&mut self, span: Span, blanks: Span) {
        let joined: String = self.slice(span).chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
        let diagnostic = Diagnostic::new(split(shown(&joined)), self.at(span));
        let fix = FixTitle::Write { text: shown(&joined) };
        self.pending.push(diagnostic.with_fix(Certain::BlankBehindSign, fix, self.at(blanks), ""));
    }

    fn copy(&mut self, target: Token, sign: Option<Token>, source: Token, pieces: &[Token]) {
        let span = pieces.last().map_or(target.span().to(source.span()), |last| target.span().to(last.span()));
        let (target_number, target_faulty) = self.parameter(target);
        let (source_number, source_faulty) = self.parameter(source);
        let faulty = target_faulty || source_faulty;
        let void = Word::bare(Address::R, span).faulty();
        let (Some(target_number), Some(source_number)) = (target_number, source_number) else {
            self.push(target_number.map_or(void, |target| void.assigning(target)), span);
            return;
        };
        if !pieces.is_empty() {
            if !faulty {
                self.parameter_and_number(span, pieces);
            }
            self.push(void.assigning(target_number), span);
            return;
        }
        let gap = sign.is_some_and(|sign| sign.end != source.start);
        if gap && !faulty {
            self.split_sign(span, Span::new(sign.map_or(source.start, |sign| sign.end), source.start));
        }
        let sign = sign.map(|sign| self.byte(sign.start));
        let word = Word::with_parameter(Address::R, span, source_number, sign).assigning(target_number);
        self.push(if faulty || gap { word.faulty() } else { word }, span);
        if !faulty && !gap {
            self.note_case(source.start);
        }
    }

    fn assignment(&mut self, target: Token, sign: Option<Token>, number: Token, pieces: &[Token]) {
        let last = pieces.last().copied().unwrap_or(number);
        let span = target.span().to(last.span());
        let (target_number, mut faulty) = self.parameter(target);
        let Some(target_number) = target_number else {
            self.push(Word::bare(Address::R, span).faulty(), span);
            return;
        };
        let plain = number.kind == Kind::Number && sign.is_none() && pieces.is_empty();
        let value = if plain {
            Number::parse(self.slice(number.span()).as_bytes())
        } else {
            let prefix = format!("R{target_number}=");
            let first = self.slice(number.span());
            let run = sign.map_or_else(|| first.to_owned(), |sign| format!("{}{first}", self.slice(sign.span())));
            faulty = true;
            // A sign that stands apart splits the number like a blank inside it.
            let pieces = if sign.is_some() && pieces.is_empty() { &[number][..] } else { pieces };
            if sign.is_some() {
                self.mend_split_sign(&run, pieces, number, &prefix, span)
            } else {
                self.corrected(run, pieces, Address::R, &prefix, span)
            }
        };
        let word = match value {
            Some(value) => Word::with_number(Address::R, span, value),
            None => Word::bare(Address::R, span).faulty(),
        };
        let word = word.assigning(target_number);
        self.push(if faulty { word.faulty() } else { word }, span);
    }

    fn mend_split_sign(
        &mut self,
        run: &str,
        pieces: &[Token],
        number: Token,
        prefix: &str,
        span: Span,
    ) -> Option<Number> {
        let more: Vec<Token> = pieces.iter().copied().filter(|piece| *piece != number).collect();
        if more.is_empty() && matches!(number.kind, Kind::Number) && !matches!(self.byte(number.start), b'+' | b'-') {
            let joined = format!("{prefix}{run}");
            let place = self.at(span);
            let diagnostic = Diagnostic::new(split(shown(&joined)), place);
            let title = FixTitle::Write { text: shown(&joined) };
            self.pending.push(diagnostic.with_fix(Certain::BlankBehindSign, title, place, joined));
            return Number::parse(run.as_bytes());
        }
        self.corrected(run.to_owned(), &more, Address::R, prefix, span)
    }
}

/// Whether a number is nothing but letters that are taken for digits: `O`, `Ol`.
fn is_letters(number: &[u8]) -> bool {
    !number.is_empty() && number.iter().all(|letter| matches!(letter, b'O' | b'o' | b'l'))
}

/// A blank inside a number; which address is missing is said at the end of the block.
pub(super) const fn split(joined: String) -> Finding {
    Finding::SplitNumber { joined, loose: String::new(), written: String::new() }
}

/// What something that is no number may mean, `prefix` standing before it: programs print numbers with exponents.
pub(super) fn printed_number(run: &str, prefix: &str) -> NumberMeant {
    let run: String = run.chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
    if run.to_ascii_lowercase().contains("nan") || run.to_ascii_lowercase().contains("in") {
        return NumberMeant::NotANumber;
    }
    if !run.contains(['e', 'E']) {
        let sum = run.chars().zip(run.chars().skip(1)).any(|(one, next)| one.is_ascii_digit() && "+-".contains(next));
        let computed = sum || run.contains(['*', '/', '(', '[', '{', '<']);
        return if computed && prefix.starts_with('R') { NumberMeant::Computed } else { NumberMeant::Form };
    }
    let thousandths = run.replace(',', ".").parse::<f64>().ok().map(|value| (value * 1000.0).round());
    #[allow(clippy::cast_possible_truncation, reason = "what is too large for it is the largest number, and refused")]
    let written = thousandths.map(|value| Decimal::from_thousandths(value as i64));
    match written.filter(|written| written.abs() <= Decimal::DIMENSION_MAX) {
        Some(written) => NumberMeant::Exponent { written: format!("{prefix}{written}") },
        None => NumberMeant::ExponentForm,
    }
}
