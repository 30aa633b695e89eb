//! Explains whatever is not a well-formed word: one diagnosis for each slip, and the words of which something is known.
//!
//! Each recogniser is a pure function of the tokens from one place on and of their surroundings. The first of the table
//! that matches decides; nothing revises it later.

mod comments;
mod elsewhere;
mod forgotten;
mod functions;
mod letters;
mod numbers;
mod parameters;
mod swallowed;
mod texts;

pub(super) use functions::has_other_words;
pub(super) use letters::{look_alike, mixed_number};
pub(super) use numbers::lost_number;
pub use swallowed::swallowed_words;
pub(super) use texts::statement_end;

use super::number::Number;
use super::tokens::{Kind, Shape, Token};
use super::{Word, grammar};
use crate::diag::{Diagnostic, Finding, FixTitle, Meant, NumberMeant, shown};
use crate::dict::{Address, Dialect, GCode};
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, Span};

/// A recogniser: a diagnosis of what begins at [`Around::at`], or `None` where that is something else.
type Recogniser = fn(&Around<'_>) -> Option<Diagnosis>;
/// A recogniser, and a text that it decides.
type Row = (Recogniser, &'static str);

/// Well-formed words that may mean something else in their surroundings. Of several recognisers that match the
/// first one counts.
const AROUND_WORDS: [Row; 7] = [
    (functions::called_by_p, "G71 P100"),
    (functions::dwell, "G04 P500"),
    (functions::beside_height, "G83 Z-5 R2 Q3"),
    (letters::letter_for_last_digit, "Y3S"),
    (letters::letter_in_function, "G7N"),
    (numbers::divided, "Z-24/2"),
    (forgotten::parameter, "R10=-12 11=80"),
];

/// The same for whatever is not a well-formed word. Recognisers that look farther around come first.
const TABLE: [Row; 44] = [
    (comments::quoted, "\"text\""),
    (comments::typographic, "„text“"),
    (comments::foreign, "(text)"),
    (elsewhere::unknown_address, "E5"),
    (elsewhere::line, "L Z+100 R0 FMAX"),
    (letters::czech_word, "Xě5"),
    (letters::letter_for_digit, "G71 LI00"),
    (forgotten::exchanged_words, "80X 20Y"),
    (forgotten::exchanged_address, "X1 4Y"),
    (forgotten::address, "X70 40"),
    (numbers::many_signs, "X--R1"),
    (numbers::doubled_letter, "TT1"),
    (numbers::word, "X1,5"),
    (elsewhere::bracketed, "Z(R11)"),
    (parameters::chained, "R1 = R2 = 5"),
    (parameters::without_value, "R10= R11=80"),
    (parameters::split_number, "R1 0=5"),
    (parameters::sign_before_equals, "R10-=12"),
    (parameters::without_number, "XR"),
    (parameters::read, "X- R10"),
    (parameters::assigned, "R10=1,5"),
    (numbers::split_sign, "X-  36.12"),
    (parameters::radius, "R-5"),
    (parameters::several_equals, "R10==5"),
    (parameters::odd_value, "R10=−5"),
    (numbers::valueless, "X"),
    (elsewhere::printed, "X1.5E-05"),
    (elsewhere::assigned, "X=5"),
    (elsewhere::named, "CR=5"),
    (elsewhere::variable, "#50=0"),
    (elsewhere::program_start, "%\nO2107"),
    (elsewhere::jump_target, "G73 N20"),
    (letters::mixed, "8N0"),
    (numbers::without_n, "110 G02"),
    (letters::czech_keys, "S150é"),
    (letters::parameter_of_letters, "XRl"),
    (texts::unit, "F300mm/min"),
    (numbers::sign_first, "-X10"),
    (numbers::stray, "\"c\" 5"),
    (texts::stray, "KONTURA"),
    (elsewhere::program_name, "%_N_2107_MPF"),
    (elsewhere::garbled, "X#1"),
    (elsewhere::accented, "Ý40"),
    (elsewhere::unknown, "$"),
];

/// The explanation of some tokens of a block.
#[derive(Debug, Default)]
pub(super) struct Diagnosis {
    /// How many tokens it explains.
    pub(super) tokens: usize,
    /// The words that it sets, as far as they are known: a word without a value is poison for its address.
    pub(super) words: Vec<(Word, Span)>,
    pub(super) comments: Vec<Span>,
    pub(super) found: Option<Diagnostic>,
    /// Characters that may be part of the words that they touch: those have no value either.
    pub(super) junk: Option<Span>,
    /// Something in it has no word.
    pub(super) debris: bool,
    /// Where the line ends in which a quote is missing.
    pub(super) quotes_off: Option<u32>,
}

impl Diagnosis {
    const fn of(tokens: usize) -> Self {
        Self {
            tokens,
            words: Vec::new(),
            comments: Vec::new(),
            found: None,
            junk: None,
            debris: false,
            quotes_off: None,
        }
    }

    fn saying(tokens: usize, found: Diagnostic) -> Self {
        Self { found: Some(found), ..Self::of(tokens) }
    }

    fn with(mut self, word: Word, span: Span) -> Self {
        self.words.push((word.faulty(), span));
        self
    }

    fn void(self, address: Address, span: Span) -> Self {
        self.with(Word::bare(address, span), span)
    }

    /// A parameter whose value is not known.
    fn unknown_target(self, target: Option<u8>, span: Span) -> Self {
        let word = Word::bare(Address::R, span);
        self.with(target.map_or(word, |target| word.assigning(target)), span)
    }

    fn junk(self, span: Span) -> Self {
        Self { junk: Some(span), ..self }
    }

    fn debris(self) -> Self {
        Self { debris: true, ..self }
    }

    /// Whether it says no more than where comments are.
    const fn is_remark(&self) -> bool {
        let Self { tokens: _, words, comments: _, found, junk, debris, quotes_off } = self;
        words.is_empty() && found.is_none() && junk.is_none() && !*debris && quotes_off.is_none()
    }
}

/// The words of a block beyond this count are not looked at: nobody writes so many.
const WORDS: usize = 64;

/// A place in a block, and its surroundings.
pub(super) struct Around<'t> {
    pub(super) text: &'t str,
    pub(super) file: FileId,
    /// The tokens of the block.
    pub(super) tokens: &'t [Token],
    /// The token in question.
    pub(super) at: usize,
    /// The words of the block, as far as they are well formed.
    words: Vec<Word>,
    /// Where the line ends in which a quote is missing: texts further on in it are none.
    quotes_off: Option<u32>,
}

/// Reads a block in which something is not well formed.
pub(super) fn read(text: &str, file: FileId, tokens: &[Token], quotes_off: Option<u32>) -> Vec<Diagnosis> {
    let mut around = Around { text, file, tokens, at: 0, words: Vec::new(), quotes_off };
    around.words = around.well_formed();
    let cycle = functions::other_cycle(&around);
    let mut items: Vec<Diagnosis> = Vec::new();
    while around.at < tokens.len() {
        let item = around.item();
        let next = around.at + item.tokens.max(1);
        let behind = tokens.get(next).map_or(u32::MAX, |token| token.start);
        let begin = tokens.get(around.at).map_or(u32::MAX, |token| token.start);
        let item = cycle.iter().fold(item, |item, cycle| {
            functions::in_other_cycle(item, cycle, (begin..behind).contains(&cycle.at.span.start))
        });
        around.at = next;
        around.quotes_off = item.quotes_off.or(around.quotes_off);
        match items.last_mut() {
            // A line may hold a million comments: they need not be items of their own.
            Some(last) if item.is_remark() => last.comments.extend(item.comments),
            _ => items.push(item),
        }
    }
    items
}

/// The place of the first word in `tokens`.
pub(super) fn first_word(text: &str, tokens: &[Token]) -> Option<Span> {
    let items = read(text, FileId(0), tokens, None);
    items.first()?.words.first().map(|(_, span)| *span)
}

impl<'t> Around<'t> {
    fn item(&self) -> Diagnosis {
        if self.token().kind == Kind::LineEnd {
            return Diagnosis::of(1);
        }
        let first = |table: &[Row]| table.iter().find_map(|(recognise, _)| recognise(self));
        let word = || {
            let (word, span, tokens) = grammar::word(self.text, self.tokens, self.at)?;
            Some(Diagnosis { words: vec![(word, span)], ..Diagnosis::of(tokens) })
        };
        first(&AROUND_WORDS).or_else(word).or_else(|| first(&TABLE)).unwrap_or(Diagnosis::of(1))
    }

    fn token(&self) -> Token {
        self.tokens.get(self.at).copied().sure()
    }

    fn previous(&self) -> Option<Token> {
        self.tokens.get(self.at.checked_sub(1)?).copied()
    }

    fn cursor(&self) -> Cursor<'t> {
        Cursor { tokens: self.tokens.get(self.at..).sure(), taken: 0 }
    }

    /// The next tokens, when they have these kinds.
    fn next<const N: usize>(&self, kinds: [Kind; N]) -> Option<[Token; N]> {
        let tokens: [Token; N] = self.tokens.get(self.at..self.at + N)?.try_into().ok()?;
        tokens.iter().zip(kinds).all(|(token, kind)| token.kind == kind).then_some(tokens)
    }

    /// The token, when its junk has that shape.
    fn junk(&self, shape: Shape) -> Option<Token> {
        Some(self.token()).filter(|token| token.kind == Kind::Junk(shape))
    }

    fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).sure()
    }

    fn byte(&self, at: u32) -> u8 {
        self.text.as_bytes().get(at as usize).copied().unwrap_or(0)
    }

    fn is_behind_digit(&self, at: u32) -> bool {
        at.checked_sub(1).is_some_and(|before| self.byte(before).is_ascii_digit())
    }

    fn place(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    fn address(&self, token: Token) -> Option<Address> {
        Address::from_byte(self.byte(token.start))
    }

    /// A letter that a word may begin with, when that is what the token begins with.
    fn letter(&self, token: Token) -> Option<Address> {
        let other = matches!(token.kind, Kind::Skip | Kind::Comment | Kind::LineEnd | Kind::End);
        self.address(token).filter(|_| !other)
    }

    /// The text behind the letter and its blanks.
    fn number(&self, token: Token) -> &'t str {
        self.slice(token.span()).get(1..).sure().trim_start_matches([' ', '\t'])
    }

    fn begins_line(&self, at: u32) -> bool {
        let before = self.text.get(..at as usize).sure();
        matches!(before.trim_end_matches([' ', '\t']).chars().next_back(), None | Some('\n' | '\r'))
    }

    /// Where the word ends whose number a line break may have cut: that before digits at the beginning of a line, when
    /// nothing but the break lies between them. Else where the digits begin.
    fn cut_before(&self, digits: u32) -> u32 {
        let before = self.text.get(..digits as usize).sure();
        let line = before.strip_suffix('\n').map_or(before, |line| line.strip_suffix('\r').unwrap_or(line));
        if line.ends_with(|last: char| last.is_ascii_digit()) { small(line.len()) } else { digits }
    }

    fn is_signed(&self, token: Token) -> bool {
        token.kind == Kind::Letter && matches!(self.byte(token.end - 1), b'+' | b'-')
    }

    fn diagnostic(&self, span: Span, finding: Finding) -> Diagnostic {
        Diagnostic::new(finding, self.place(span))
    }

    /// A finding with an offer to write `text` over all of it.
    fn offering(&self, span: Span, finding: Finding, text: String) -> Diagnostic {
        self.diagnostic(span, finding).with_offer(write(&text), self.place(span), text)
    }

    /// A malformed number, with an offer to write `text` instead, which the help names too.
    fn number_as(&self, span: Span, text: String, meant: impl FnOnce(String) -> NumberMeant) -> Diagnostic {
        self.malformed(span, meant(shown(&text))).with_offer(write(&text), self.place(span), text)
    }

    /// The same of characters that the control does not know.
    fn characters_as(&self, span: Span, text: String, meant: impl FnOnce(String) -> Meant) -> Diagnostic {
        self.characters(span, meant(shown(&text))).with_offer(write(&text), self.place(span), text)
    }

    fn malformed(&self, span: Span, meant: NumberMeant) -> Diagnostic {
        self.diagnostic(span, Finding::MalformedNumber { text: shown(self.slice(span)), meant })
    }

    fn characters(&self, span: Span, meant: Meant) -> Diagnostic {
        self.diagnostic(span, Finding::UnknownCharacter { text: shown(self.slice(span)), meant })
    }

    /// The words of the block, its `N` included; what has no well-formed value is void.
    fn well_formed(&self) -> Vec<Word> {
        let mut words = Vec::new();
        let mut at = 0;
        while let Some(token) = self.tokens.get(at).filter(|_| words.len() < WORDS) {
            let word = grammar::word(self.text, self.tokens, at);
            at += word.map_or(1, |(_, _, tokens)| tokens);
            let in_place =
                if matches!(token.kind, Kind::Junk(Shape::LostNumber | Shape::NumberOfN | Shape::MixedNumber)) {
                    Some(Address::N)
                } else {
                    (token.kind == Kind::Junk(Shape::JumpTarget)).then_some(Address::L)
                };
            let wordlike = matches!(
                token.kind,
                Kind::Word
                    | Kind::Letter
                    | Kind::Parameter
                    | Kind::Junk(
                        Shape::BareR
                            | Shape::LooseWord
                            | Shape::ManySigns
                            | Shape::PrintedWord
                            | Shape::LooseParameter
                            | Shape::AssignedWord
                            | Shape::GarbledWord
                    )
            );
            let odd = || in_place.or_else(|| self.address(*token).filter(|_| wordlike));
            words.extend(word.map(|(word, _, _)| word).or_else(|| Some(Word::bare(odd()?, token.span()).faulty())));
        }
        words
    }

    fn has(&self, address: Address) -> bool {
        self.words.iter().any(|word| word.address == address)
    }

    fn functions(&self) -> impl Iterator<Item = GCode> + '_ {
        self.words.iter().filter_map(|word| word.g_code())
    }

    /// Whether the word at a place may have meant that number: its address takes it; there is such a G function, and
    /// the others of the block leave room for it.
    fn may_mean(&self, address: Address, at: u32, number: Number) -> bool {
        let mut ranges = Dialect::ALL.iter().flat_map(|dialect| address.ranges(*dialect)).flatten().peekable();
        let in_range = ranges.peek().is_none() || ranges.any(|range| range.contains(number.value));
        let whole_parameter = address == Address::R && number.value.fits_parameter();
        let point = number.point && !address.row().form.takes_point(Dialect::Cnc872);
        if point || !in_range && !whole_parameter {
            return false;
        }
        let code = number.value.as_whole().and_then(|number| u8::try_from(number).ok()).and_then(GCode::from_number);
        let mut others = self.words.iter().filter(|word| word.start() != at).filter_map(|word| word.g_code());
        address != Address::G || code.is_some_and(|code| others.all(|other| other.group() != code.group()))
    }

    /// Whether the block has an `N`, or something in its place.
    fn is_numbered(&self) -> bool {
        self.words.first().is_some_and(|first| first.address == Address::N)
    }
}

/// The title of an offer.
fn write(text: &str) -> FixTitle {
    FixTitle::Write { text: shown(text) }
}

fn without_blanks(text: &str) -> String {
    text.chars().filter(|character| !matches!(character, ' ' | '\t')).collect()
}

/// The value of a number or a parameter, when nothing else is in `text`, as a word of that address.
fn value(address: Address, span: Span, text: &str) -> Option<Word> {
    if let Some(number) = Number::parse(text.as_bytes()) {
        return Some(Word::with_number(address, span, number));
    }
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = text.as_bytes().first().copied().filter(|_| unsigned.len() < text.len());
    let source = grammar::parameter_number(unsigned.strip_prefix(['R', 'r'])?)?;
    Some(Word::with_parameter(address, span, source, sign))
}

/// Takes tokens one by one.
pub(super) struct Cursor<'t> {
    tokens: &'t [Token],
    /// How many were taken.
    pub(super) taken: usize,
}

impl<'t> Cursor<'t> {
    pub(super) fn new(tokens: &'t [Token], at: usize) -> Self {
        Self { tokens: tokens.get(at..).unwrap_or_default(), taken: 0 }
    }

    pub(super) fn peek(&self) -> Option<Token> {
        self.tokens.get(self.taken).copied()
    }

    pub(super) fn when(&mut self, wanted: impl Fn(Kind) -> bool) -> Option<Token> {
        let token = self.peek().filter(|token| wanted(token.kind))?;
        self.taken += 1;
        Some(token)
    }

    pub(super) fn one(&mut self, kind: Kind) -> Option<Token> {
        self.when(|next| next == kind)
    }

    pub(super) fn number(&mut self) -> Option<Token> {
        self.when(|kind| matches!(kind, Kind::Number | Kind::Junk(Shape::LooseNumber)))
    }

    pub(super) fn parameter(&mut self) -> Option<Token> {
        self.when(|kind| matches!(kind, Kind::Parameter | Kind::Junk(Shape::LooseParameter)))
    }

    /// Numbers in a row.
    pub(super) fn numbers(&mut self) -> Vec<Token> {
        std::iter::from_fn(|| self.number()).collect()
    }

    /// `=`, a sign and a value, of which only `=` has to be there; gives the last of them.
    pub(super) fn assigned_value(&mut self) -> Option<Token> {
        let equals = self.one(Kind::Equals)?;
        let sign = self.one(Kind::Sign);
        Some(self.number().or_else(|| self.parameter()).or(sign).unwrap_or(equals))
    }

    /// What may follow the parameter of an assignment: numbers, and values with signs or operators before them,
    /// `R51+R52`.
    pub(super) fn operands(&mut self) -> Vec<Token> {
        let mut operands = self.numbers();
        let between = |kind: Kind| matches!(kind, Kind::Sign | Kind::Junk(Shape::Operator));
        loop {
            let start = self.taken;
            let Some(operator) = self.when(between) else { return operands };
            self.when(between);
            let value = self.parameter().or_else(|| self.number()).or_else(|| self.one(Kind::Junk(Shape::Bracketed)));
            let Some(value) = value else {
                self.taken = start;
                return operands;
            };
            operands.extend([operator, value]);
            operands.extend(self.numbers());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::tokens::tokens;

    /// The tokens of a block, with the shapes that the splitter gives them by their places.
    fn block(text: &str) -> Vec<Token> {
        let mut block: Vec<Token> = Vec::new();
        for mut token in tokens(text, 0, u32::try_from(text.len()).unwrap()) {
            if mixed_number(text.as_bytes(), &block, token) {
                token = Token { kind: Kind::Junk(Shape::MixedNumber), start: block.pop().unwrap().start, ..token };
            } else if let Some(shape) = lost_number(text.as_bytes(), &block, token) {
                token.kind = Kind::Junk(shape);
            } else if text.starts_with("G73") && token.start > 0 {
                token.kind = Kind::Junk(Shape::JumpTarget);
            }
            block.push(token);
        }
        block
    }

    /// Each recogniser decides its example: no other one before it matches there.
    #[test]
    fn examples() {
        let around_words = AROUND_WORDS.iter().map(|row| (row, true));
        let mut undecided = Vec::new();
        for ((recognise, example), first) in around_words.chain(TABLE.iter().map(|row| (row, false))) {
            // Some are asked for behind a block number only, others never there.
            let decides = [format!("N10 {example}"), (*example).to_owned()].iter().any(|text| {
                let tokens = block(text);
                let mut around =
                    Around { text, file: FileId(0), tokens: &tokens, at: 0, words: Vec::new(), quotes_off: None };
                around.words = around.well_formed();
                while around.at < tokens.len() {
                    let matches = |(recognise, _): &Row| recognise(&around).is_some();
                    let row = recognise(&around).is_some();
                    let table = if first { &AROUND_WORDS[..] } else { &TABLE[..] };
                    let earlier = table.iter().take_while(|(_, other)| other != example).any(matches);
                    if row && !earlier && (first || !AROUND_WORDS.iter().any(matches)) {
                        return true;
                    }
                    around.at += around.item().tokens.max(1);
                }
                false
            });
            if !decides {
                undecided.push(*example);
            }
        }
        assert!(undecided.is_empty(), "{undecided:#?}");
    }
}
