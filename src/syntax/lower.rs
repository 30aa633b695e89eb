//! From the items of the grammar to words, comments and findings.

use super::grammar::Item;
use super::number::Number;
use super::{BlockFlags, Kind, Token, Word};
use crate::diag::{Diagnostic, Finding, Findings, FixTitle, Meant, shown};
use crate::dict::{Address, GCode, PROGRAM_ENDS};
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
    pub(super) lowercase: bool,
    /// Where the first word stands.
    pub(super) first_word: Option<Span>,
}

/// The highest parameter is R95.
const PARAMETERS: u8 = 96;

impl<'t> Lowering<'t> {
    pub(super) fn new(text: &'t str, file: FileId) -> Self {
        Self {
            text,
            file,
            words: Vec::new(),
            comments: Vec::new(),
            flags: BlockFlags::default(),
            findings: Findings::new(),
            lowercase: false,
            first_word: None,
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
                self.void_word(address, span, |text| Finding::MalformedNumber { text });
            }
            Item::Valueless { address, end, comments } => {
                let name = self.slice(address.span()).to_ascii_uppercase();
                let name: String =
                    name.chars().filter(|character| !matches!(character, ' ' | '\t' | '+' | '-' | '.' | ',')).collect();
                let finding = Finding::MissingValue { address: name, beyond: comments.is_some() };
                self.void_word(address, address.span().to(end.span()), |_| finding);
                for comment in comments.unwrap_or_default() {
                    self.comment(comment);
                }
            }
            Item::Skip(token) => {
                self.flags.set(BlockFlags::SKIP);
                self.flags.set(BlockFlags::RICH);
                self.words.push(Word::bare(Address::Skip, token.span()));
            }
            Item::Comment(token) => self.comment(token),
            Item::Stray { first, last } => {
                let span = first.span().to(last.span());
                let text = shown(self.slice(span));
                self.debris(span, Finding::MalformedNumber { text });
            }
            Item::Text { first, last } => {
                let span = first.span().to(last.span());
                let text = self.slice(span);
                let finding = if text.is_ascii() {
                    Finding::StrayText { text: shown(text) }
                } else {
                    Finding::UnknownCharacter { text: shown(text), meant: Meant::Comment }
                };
                self.debris(span, finding);
            }
            Item::Debris(token) if token.kind == Kind::GarbledWord => {
                let text = self.slice(token.span());
                let meant = Meant::inside(text.get(1..).unwrap_or_default());
                self.void_word(token, token.span(), |text| Finding::UnknownCharacter { text, meant });
            }
            Item::Debris(token) => {
                let text = self.slice(token.span());
                let foreign = token.kind == Kind::ForeignComment;
                let meant = if foreign { Meant::Comment } else { Meant::of(text) };
                self.debris(token.span(), Finding::UnknownCharacter { text: shown(text), meant });
            }
        }
    }

    fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).unwrap_or_default()
    }

    fn byte(&self, at: u32) -> u8 {
        self.text.as_bytes().get(at as usize).copied().unwrap_or(0)
    }

    fn at(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    fn report(&mut self, span: Span, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, self.at(span)));
    }

    fn debris(&mut self, span: Span, finding: Finding) {
        self.flags.set(BlockFlags::DEBRIS);
        self.report(span, finding);
    }

    fn comment(&mut self, token: Token) {
        self.comments.push(token.span());
        if token.kind == Kind::TypographicComment {
            let text = self.slice(token.span());
            for (at, quote) in text.char_indices().filter(|(_, character)| matches!(character, '“' | '”' | '„')) {
                let start = token.start + u32::try_from(at).unwrap_or(0);
                let place = self.at(Span::new(start, start + u32::try_from(quote.len_utf8()).unwrap_or(0)));
                let diagnostic = Diagnostic::new(Finding::TypographicQuote { quote }, place);
                self.findings.add(diagnostic.with_fix(FixTitle::PlainQuote, place, "\""));
            }
        }
    }

    /// The address of a word, or the finding that there is none.
    fn address(&mut self, start: u32, word: Span) -> Option<Address> {
        let byte = self.byte(start);
        self.lowercase |= byte.is_ascii_lowercase();
        let address = Address::from_byte(byte);
        if address.is_none() {
            let letter = char::from(byte.to_ascii_uppercase());
            self.debris(word, Finding::UnknownAddress { letter });
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
        let bytes = self.text.as_bytes().get(token.start as usize + 1..token.end as usize).unwrap_or_default();
        let blanks = bytes.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        bytes.get(blanks..).unwrap_or_default()
    }

    /// Adds a word, which stands at `span`, to the block, noting what later stages ask of every block.
    #[inline]
    pub(super) fn push(&mut self, word: Word, span: Span) {
        self.first_word.get_or_insert(span);
        let speaks_of_flow = matches!(
            word.address,
            Address::G
                | Address::M
                | Address::L
                | Address::Q
                | Address::R
                | Address::Correction
                | Address::Skip
                | Address::Program
        );
        if speaks_of_flow || !word.is_plain() {
            self.flags.set(BlockFlags::RICH);
        }
        if matches!(word.address, Address::G | Address::M)
            && let Some(number) = word.whole().and_then(|number| u8::try_from(number).ok())
        {
            if word.address == Address::M {
                if PROGRAM_ENDS.contains(&number) {
                    self.flags.set(BlockFlags::END);
                }
            } else if number == GCode::G70.number() {
                self.flags.set(BlockFlags::RETURN);
            } else if number == GCode::G79.number() {
                self.flags.set(BlockFlags::ENTRY);
            }
        }
        self.words.push(word);
    }

    /// A word that no fix gives a value: it is in the block, and takes no part in what follows.
    fn void_word(&mut self, token: Token, span: Span, finding: impl FnOnce(String) -> Finding) {
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
        match self.mend(run, pieces, &prefix, span) {
            Some(number) => self.push(Word::with_number(address, span, number).faulty(), span),
            None => self.push(Word::bare(address, span).faulty(), span),
        }
    }

    /// Reads a faulty number as its fix would write it, and reports what is wrong with it.
    fn mend(&mut self, run: String, pieces: &[Token], prefix: &str, span: Span) -> Option<Number> {
        let mut joined = run;
        for piece in pieces {
            joined.push_str(self.slice(piece.span()));
        }
        let comma = joined.contains(',');
        let letter = joined.contains(['o', 'O', 'l']);
        let fixed = joined.replace(',', ".").replace(['o', 'O'], "0").replace('l', "1");
        let number = Number::parse(fixed.as_bytes());
        let fixed = format!("{prefix}{fixed}");
        let finding = match number {
            Some(_) if comma => Finding::DecimalComma { fixed: shown(&fixed) },
            Some(_) if letter => Finding::LetterForDigit { fixed: shown(&fixed) },
            Some(_) if pieces.is_empty() => return number,
            Some(_) => Finding::SplitNumber { joined: shown(&fixed) },
            None if fixed.bytes().any(|byte| byte.is_ascii_digit() && !prefix.as_bytes().contains(&byte)) => {
                Finding::MalformedNumber { text: shown(self.slice(span)) }
            }
            None if joined.len() > 2 => Finding::MalformedNumber { text: shown(self.slice(span)) },
            None => Finding::MissingValue { address: shown(prefix.trim_end_matches('=')), beyond: false },
        };
        let mended = !matches!(finding, Finding::MalformedNumber { .. } | Finding::MissingValue { .. });
        let place = self.at(span);
        let mut diagnostic = Diagnostic::new(finding, place);
        if mended {
            diagnostic = diagnostic.with_fix(FixTitle::Write { text: shown(&fixed) }, place, fixed);
        }
        self.findings.add(diagnostic);
        number.filter(|_| mended)
    }

    /// The number of a parameter, 0–95, and whether it has a finding already.
    fn parameter(&mut self, token: Token) -> (Option<u8>, bool) {
        self.lowercase |= self.byte(token.start).is_ascii_lowercase();
        let digits = self.number_text(token);
        let number_start = token.end - u32::try_from(digits.len()).unwrap_or(0);
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
            self.findings.add(diagnostic.with_fix(FixTitle::Write { text: shown }, place, text));
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
        let (source, mut faulty) = self.parameter(parameter);
        let Some(source) = source else {
            self.push(Word::bare(address, whole).faulty(), whole);
            return;
        };
        let sign = (token.kind == Kind::SignedLetter).then(|| self.byte(token.end - 1));
        let gap = sign.is_some() && token.end != parameter.start;
        if !faulty && (gap || !pieces.is_empty()) {
            self.split_parameter(span, pieces, gap && pieces.is_empty(), Span::new(token.end, parameter.start));
            faulty = true;
        }
        let word = Word::with_parameter(address, span, source, sign);
        self.push(if faulty { word.faulty() } else { word }, span);
    }

    /// A blank after the sign of a parameter, or a number after a parameter that stands for one.
    fn split_parameter(&mut self, span: Span, pieces: &[Token], gap: bool, blanks: Span) {
        if pieces.iter().any(|piece| matches!(self.byte(piece.start), b'+' | b'-')) {
            self.report(span, Finding::MalformedNumber { text: shown(self.slice(span)) });
            return;
        }
        let joined: String = self.slice(span).chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
        let mut diagnostic = Diagnostic::new(Finding::SplitNumber { joined: shown(&joined) }, self.at(span));
        if gap {
            diagnostic = diagnostic.with_fix(FixTitle::Write { text: shown(&joined) }, self.at(blanks), "");
        }
        self.findings.add(diagnostic);
    }

    fn copy(&mut self, target: Token, sign: Option<Token>, source: Token, pieces: &[Token]) {
        let span = pieces.last().map_or(target.span().to(source.span()), |last| target.span().to(last.span()));
        let (target_number, target_faulty) = self.parameter(target);
        let (source_number, source_faulty) = self.parameter(source);
        let mut faulty = target_faulty || source_faulty;
        let (Some(target_number), Some(source_number)) = (target_number, source_number) else {
            self.push(Word::bare(Address::R, span).faulty(), span);
            return;
        };
        let gap = sign.is_some_and(|sign| sign.end != source.start);
        if !faulty && (gap || !pieces.is_empty()) {
            let blanks = Span::new(sign.map_or(source.start, |sign| sign.end), source.start);
            self.split_parameter(span, pieces, gap && pieces.is_empty(), blanks);
            faulty = true;
        }
        let sign = sign.map(|sign| self.byte(sign.start));
        let word = Word::with_parameter(Address::R, span, source_number, sign).assigning(target_number);
        self.push(if faulty { word.faulty() } else { word }, span);
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
                self.mend(run, pieces, &prefix, span)
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
            let diagnostic = Diagnostic::new(Finding::SplitNumber { joined: shown(&joined) }, place);
            self.findings.add(diagnostic.with_fix(FixTitle::Write { text: shown(&joined) }, place, joined));
            return Number::parse(run.as_bytes());
        }
        self.mend(run.to_owned(), &more, prefix, span)
    }
}
