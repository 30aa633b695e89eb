//! The tokens of a part program: whole words wherever they are well formed (LEX-2…LEX-6).

use logos::Logos;

use super::number::Number;
use super::slips::look_alike;
use crate::dict::Address;
use crate::sure::{Sure, small};
use crate::text::Span;

/// The kind of a token.
#[derive(Clone, Copy, Debug, Default, Eq, Logos, PartialEq)]
#[logos(skip r"[ \t]+")]
#[logos(subpattern address = r"[A-QS-Za-qs-z&%]")]
#[logos(subpattern number = r"[0-9]+\.?[0-9]*|\.[0-9]+")]
#[logos(subpattern exponent = r"([0-9]+[.,]?[0-9]*|[.,][0-9]+)[Ee][+\-]?[0-9]+")]
#[logos(subpattern nan = r"[Nn][Aa][Nn](\([A-Za-z]*\))?")]
#[logos(subpattern infinite = r"[0-9.]*#(IND|INF|[QS]NAN)[0-9]*|(?&nan)|[Ii][Nn][Ff]([Ii][Nn][Ii][Tt][Yy])?")]
#[logos(subpattern assigned = r#"[ \t]*[+\-]*[Rr.,0-9#\[][^ \t\r\n"*]*"#)]
#[logos(subpattern square = r#"\[([^\[\]"\r\n]|\[[^\[\]"\r\n]*\])*\]"#)]
#[logos(subpattern odd = r#"[^ \t\r\nA-Za-z0-9&%"+\-.,=*/“”„(){};'`\[\]]+"#)]
#[logos(subpattern foreign = r#"[^ \t\r\nA-Za-z0-9&%"+\-.,=*/“”„({]"#)]
#[logos(subpattern letter = r"[A-Za-zÀ-ž]")]
pub enum Kind {
    /// An address other than R with a well-formed number: `X-12.5`.
    #[regex(r"(?&address)[ \t]*[+\-]?((?&number))", priority = 40)]
    Word,
    /// R and the number of a parameter: `R10`.
    #[regex(r"[Rr][ \t]*[0-9]+", priority = 40)]
    Parameter,
    /// A number without an address.
    #[regex(r"[+\-]?((?&number))", priority = 30)]
    Number,
    /// An address other than R without a number, and the sign behind it: `X`, `X-`.
    #[regex(r"(?&address)", priority = 5)]
    #[regex(r"(?&address)[ \t]*[+\-]", priority = 35)]
    Letter,
    /// `=`
    #[token("=")]
    Equals,
    /// A sign alone.
    #[regex(r"[+\-]", priority = 35)]
    Sign,
    /// `/` and the digits that are read with it (LEX-10).
    #[regex(r"/([ \t]*[0-9]+)?", priority = 40)]
    Skip,
    /// `"` to the next one or the end of the line.
    #[regex("\"[^\"\r\n]*\"?", priority = 40)]
    Comment,
    /// The end of a line.
    #[regex(r"\r\n|\n|\r", priority = 40)]
    LineEnd,
    /// `*`
    #[default]
    #[token("*")]
    End,
    /// Anything that is not part of the language, by its shape.
    #[regex(r"[Rr]", |_| Shape::BareR, priority = 5)]
    #[regex(r"(?&address)([ \t]*[+\-.,0-9]|[ \t]*[+\-]l|[Ool])[+\-.,0-9Oo]*", |_| Shape::LooseWord, priority = 20)]
    #[regex(r"(?&address)[ \t]*[+\-][+\-]+", |_| Shape::ManySigns, priority = 36)]
    #[regex(r"[A-Za-z&%][ \t]*[+\-]?(?&exponent)", |_| Shape::PrintedWord, priority = 25)]
    #[regex(r"[ABCFIJKU-Zabcfijku-z][ \t]*[+\-]?((?&infinite))", |_| Shape::PrintedWord, priority = 25)]
    #[regex(r"[DGHL-TNdghl-t&%][+\-]?((?&infinite))", |_| Shape::PrintedWord, priority = 25)]
    #[regex(r"((?&address)[ \t]*[+\-]?)?[Ff]([Mm][Aa][Xx]|[Aa][Uu][Tt][Oo])", |_| Shape::PrintedWord, priority = 25)]
    #[regex(r"[Rr]([ \t]*[0-9]+[.,Oo]|[Ool])[.,0-9Oo]*", |_| Shape::LooseParameter, priority = 20)]
    #[regex(r"[+\-.,0-9][+\-.,0-9Oo]*", |_| Shape::LooseNumber, priority = 10)]
    #[regex(r"[+\-]?((?&exponent)|(?&nan)|[Ii][Nn][Ff])", |_| Shape::LooseNumber, priority = 10)]
    #[regex(r#"(?&address)[ \t]*[0-9]*[ \t]*=((?&assigned)|[ \t]*"[^"\r\n]*"|[^ \t\r\n"*]+)"#, |_| Shape::AssignedWord, priority = 30)]
    #[regex(r#"[A-QS-Za-qs-zÀ-ž](?&letter)+[ \t]*=((?&assigned)|[^ \t\r\n"*]+)?"#, |_| Shape::NamedValue, priority = 30)]
    #[regex(r#"[Rr][A-NP-Za-km-np-zÀ-ž](?&letter)*[ \t]*=((?&assigned)|[^ \t\r\n"*]+)?"#, |_| Shape::NamedValue, priority = 30)]
    #[regex(r#"#([0-9]+|<[A-Za-z0-9_]*>|(?&square))[ \t]*=[ \t]*[^ \t\r\n"*(;]*([ \t]*[+\-/][ \t]*[^ \t\r\n"*(;]+)*"#, |_| Shape::Variable, priority = 30)]
    #[regex(r"%[ \t]*(\r\n|\n|\r)[ \t]*[Oo][0-9]+", |_| Shape::ForeignStart, priority = 45)]
    #[regex("[“”„][^\"“”„\r\n]*[\"“”„]?", |_| Shape::TypographicComment, priority = 40)]
    #[regex(r#"[A-Za-z&%]([ \t]*[+\-.,0-9]*(?&odd)[+\-.,=0-9]+|(?&odd)|[ \t]*(?&odd)[Rr][0-9]+|[ \t]*(?&square))"#, |_| Shape::GarbledWord, priority = 15)]
    #[regex(r#"[A-Za-z&%]\(([^()"\r\n]|\([^()"\r\n]*\))*\)"#, |_| Shape::GarbledWord, priority = 15)]
    #[regex(r"%(_[A-Za-z0-9_]*|[A-Za-z][A-Za-z_][A-Za-z0-9_]*|[Nn][0-9]+)", |_| Shape::GarbledWord, priority = 16)]
    #[regex(r"\([^)\r\n]*\)?|\{[^}\r\n]*\}?|'[^'\r\n]*'|`[^`\r\n]*`", |_| Shape::ForeignComment, priority = 40)]
    #[regex(r#"(''|,,)[ \t]*(?&letter)[^'",\r\n]*(''|"|,,)?"#, |_| Shape::ForeignComment, priority = 40)]
    #[regex(r"(;[ \t]*[A-Za-zÀ-ž0-9=*+\-]|#[ \t]*(?&letter)|//[ \t]*(?&letter)(?&letter))[^\r\n]*", |_| Shape::ForeignComment, priority = 40, allow_greedy = true)]
    #[regex(r"(?&letter)(?&letter)+|[Mm]/[Mm][Ii][Nn]", |_| Shape::Text, priority = 8)]
    #[regex(r"(?&foreign)+([+\-.,]*[0-9]+(?&foreign)*)*", |_| Shape::Unknown, priority = 2)]
    Junk(Shape),
}

/// What junk looks like: how far it reaches, and which slips are considered.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Shape {
    /// R alone.
    BareR,
    /// An address other than R with something like a number: `X1,5`, `X1O0`, `X--5`, `Xl0`, `X.`.
    LooseWord,
    /// An address other than R with several signs and no number: `X--`.
    ManySigns,
    /// An address with a number as programs print it: `X1.5E-05`, `S1.2E+03`, `XNaN`, `D-inf`, `FMAX`, `XFMAX`.
    PrintedWord,
    /// R with something like a number: `R1O`, `R1.5`.
    LooseParameter,
    /// Something like a number without an address: `1,5`, `--5`, `1.5E-05`.
    LooseNumber,
    /// An address other than R, with `=`, as other controls write it: `Z=R32`, `X=IC(5)`, `S1=1000`.
    AssignedWord,
    /// A name with `=` and a value: `CR=5`, `LIMS=2000`. `RO=` is R with a letter for its number.
    NamedValue,
    /// A variable of other controls, with its value or without: `#50=0`.
    Variable,
    /// The block number behind `G73`, where its target belongs: `G73 N20`. The lexer reads it as a word; its place
    /// tells.
    JumpTarget,
    /// A block number with its letter inside: `8N0`. The lexer reads it as a number and a word; its place tells.
    MixedNumber,
    /// A block number without its letter: `110 G02 X70`. The lexer reads it as a number; its place tells.
    LostNumber,
    /// The same, and the `N` stands without a number before it: `F140N`, and below it `150 X1`.
    NumberOfN,
    /// `%` alone, and on the next line a program number as other controls write it: `O2107`.
    ForeignStart,
    /// A comment whose border is a typographic quote (LEX-12).
    TypographicComment,
    /// A word with characters in it that the control does not know: `X#1`, `X−5`, `X[R1+5]`, `X(5)`.
    GarbledWord,
    /// A comment as other controls write it.
    ForeignComment,
    /// Two letters or more in a row, also with `/` between them: `najezd/odjezd`.
    Text,
    /// The name of a unit: `mm/min`. The lexer reads it as a text.
    Unit,
    /// `/` or `*` between two operands of an expression: `R10=R11/2`. The lexer reads it as another sign; its place
    /// tells.
    Operator,
    /// A value between brackets: `Z(R11)`. The lexer reads it as a comment; its place tells.
    Bracketed,
    /// Characters that the control does not know.
    Unknown,
}

/// A token and its place.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Token {
    /// Its kind.
    pub kind: Kind,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Token {
    /// Its place.
    pub const fn span(self) -> Span {
        Span::new(self.start, self.end)
    }
}

/// Names of units that are the control's own; and `m/min`, which is not.
const UNITS: [&str; 11] =
    ["mm", "deg", "ot", "rpm", "mm/min", "mm/ot", "mm/rev", "mm/r", "ot/min", "rev/min", METRES_PER_MINUTE];
/// Of all units the one that is not the control's.
pub(super) const METRES_PER_MINUTE: &str = "m/min";
/// Longer words are no numbers of blocks and subprograms.
const MOST_LETTERS: usize = 5;
/// Longer runs of letters before a number are names: `CYCLE81`.
const MOST: usize = 3;

/// The tokens of `text` from `start` up to `end`.
pub fn tokens(text: &str, start: u32, end: u32) -> impl Iterator<Item = Token> + '_ {
    Tokens {
        text: text.get(..end as usize).unwrap_or(text),
        lexer: lexer_at(text, start, end),
        pending: None,
        last: None,
        in_value: false,
    }
}

fn lexer_at(text: &str, start: u32, end: u32) -> logos::Lexer<'_, Kind> {
    let mut lexer = Kind::lexer(text.get(..end as usize).unwrap_or(text));
    lexer.bump(start as usize);
    lexer
}

struct Tokens<'t> {
    text: &'t str,
    lexer: logos::Lexer<'t, Kind>,
    pending: Option<Token>,
    /// The token before.
    last: Option<Token>,
    /// It belongs to a parameter or to the value of one, where an expression may be written.
    in_value: bool,
}

impl Iterator for Tokens<'_> {
    type Item = Token;

    #[inline]
    fn next(&mut self) -> Option<Token> {
        if let Some(token) = self.pending.take() {
            self.note(token);
            return Some(token);
        }
        let kind = self.lexer.next()?.unwrap_or(Kind::Junk(Shape::Unknown));
        let span = self.lexer.span();
        let token = Token { kind, start: small(span.start), end: small(span.end) };
        let token = if kind == Kind::Junk(Shape::Text) {
            self.text_token(token)
        } else if matches!(kind, Kind::Skip | Kind::End) && self.is_operator(token) {
            self.restart(token.start + 1);
            Token { kind: Kind::Junk(Shape::Operator), end: token.start + 1, ..token }
        } else if kind == Kind::Skip {
            self.skip_token(token)
        } else if matches!(kind, Kind::Junk(Shape::ForeignComment) | Kind::Junk(Shape::Unknown))
            && let Some(bracketed) = self.bracketed(token)
        {
            bracketed
        } else if kind == Kind::Junk(Shape::ForeignComment) {
            self.comment_token(token)
        } else if kind == Kind::Junk(Shape::GarbledWord) {
            self.garbled_token(token)
        } else if kind == Kind::Junk(Shape::LooseWord) {
            self.word_before_text(token)
        } else {
            token
        };
        self.note(token);
        Some(token)
    }
}

/// Longer texts between brackets are no values.
const BRACKETED: usize = 200;

impl Tokens<'_> {
    #[inline]
    fn note(&mut self, token: Token) {
        let begins = matches!(
            token.kind,
            Kind::Parameter | Kind::Junk(Shape::LooseParameter | Shape::AssignedWord | Shape::Variable)
        );
        // Text may be the name of a function: `R1=SIN(30)`.
        let goes_on = matches!(
            token.kind,
            Kind::Equals
                | Kind::Sign
                | Kind::Number
                | Kind::Junk(Shape::LooseNumber | Shape::Operator | Shape::Bracketed | Shape::Text)
        );
        self.in_value = begins || goes_on && self.in_value;
        self.last = Some(token);
    }

    /// Whether `/` or `*` stands right between two operands, the first of which is a parameter or the value of one.
    fn is_operator(&self, token: Token) -> bool {
        let operand = |last: &Token| {
            last.end == token.start
                && matches!(
                    last.kind,
                    Kind::Parameter
                        | Kind::Junk(Shape::LooseParameter)
                        | Kind::Number
                        | Kind::Junk(Shape::LooseNumber)
                        | Kind::Junk(Shape::Bracketed)
                )
        };
        let product = |last: &Token| {
            last.end == token.start
                && matches!(last.kind, Kind::Junk(Shape::AssignedWord) | Kind::Junk(Shape::Variable))
        };
        let star = token.kind == Kind::End;
        if !self.in_value || !self.last.as_ref().is_some_and(|last| operand(last) || star && product(last)) {
            return false;
        }
        let rest = self.text.as_bytes().get(token.start as usize + 1..).sure();
        let rest = rest.strip_prefix(b"-").or_else(|| rest.strip_prefix(b"+")).unwrap_or(rest);
        match rest {
            [b'0'..=b'9' | b'.' | b'(' | b'[' | b'#', ..] => true,
            [b'R' | b'r', digits @ ..] => {
                let count = digits.iter().take_while(|byte| byte.is_ascii_digit()).count();
                let behind = digits.get(count..).sure().trim_ascii_start();
                // `/R10=5` assigns (PAR-2).
                count > 0 && behind.first() != Some(&b'=')
            }
            _ => false,
        }
    }

    /// What stands between brackets where a value is expected, up to the bracket that closes it.
    fn bracketed(&mut self, token: Token) -> Option<Token> {
        let last = self.last?;
        let blanks = self.text.as_bytes().get(last.end as usize..token.start as usize)?;
        let glued = blanks.is_empty();
        let near = blanks.iter().all(|byte| matches!(byte, b' ' | b'\t'));
        let square = self.text.as_bytes().get(token.start as usize) == Some(&b'[');
        let letter = matches!(last.kind, Kind::Letter);
        let sign = matches!(last.kind, Kind::Equals | Kind::Sign | Kind::Junk(Shape::Operator));
        let wanted = letter && (glued || square && near)
            || self.in_value && (sign && near || last.kind == Kind::Junk(Shape::Text) && glued);
        let end = if wanted {
            self.closed_at(token.start)?
        } else {
            return None;
        };
        self.restart(end);
        Some(Token { kind: Kind::Junk(Shape::Bracketed), end, ..token })
    }

    /// Where the text ends that begins with a bracket at `start`, closed on its line.
    fn closed_at(&self, start: u32) -> Option<u32> {
        let rest = self.text.as_bytes().get(start as usize..)?;
        let open = *rest.first()?;
        let close = match open {
            b'(' => b')',
            b'[' => b']',
            b'{' => b'}',
            b'<' => b'>',
            b'\'' | b'`' => open,
            // `Z;50`
            b';' => {
                let number =
                    rest.iter().skip(1).take_while(|byte| byte.is_ascii_digit() || b"+-.".contains(byte)).count();
                return (number > 0).then(|| start + small(number + 1));
            }
            _ => return None,
        };
        let mut depth = 1_u32;
        let line = rest.iter().take(BRACKETED).take_while(|byte| !matches!(byte, b'\n' | b'\r' | b'"'));
        for (at, byte) in line.enumerate().skip(1) {
            if *byte == close {
                depth -= 1;
            } else if *byte == open {
                depth += 1;
            }
            if depth == 0 {
                return Some(start + small(at + 1));
            }
        }
        None
    }

    /// `Z(R11)`, `Z [R11]`: the address, so that the value between the brackets follows. `X−R1=5`: what is before the
    /// assignment.
    fn garbled_token(&mut self, token: Token) -> Token {
        let text = self.text.get(token.span().range()).sure();
        let behind = self.text.get(token.end as usize..).sure();
        let digits = text.trim_end_matches(|last: char| last.is_ascii_digit());
        let at = digits.len().saturating_sub(1);
        if at > 0 && digits.ends_with(['R', 'r']) && behind.trim_start_matches([' ', '\t']).starts_with('=') {
            let end = token.start + small(at);
            self.restart(end);
            return Token { end, ..token };
        }
        let [letter, rest @ ..] = text.as_bytes() else { return token };
        let blanks = rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let bracket = matches!(rest.get(blanks), Some(b'[')) || matches!(rest.first(), Some(b'(' | b'<'));
        let address = letter.is_ascii_alphabetic() && !matches!(letter, b'R' | b'r');
        if !bracket || !address || self.closed_at(token.start + 1 + small(blanks)).is_none() {
            return token;
        }
        let end = token.start + 1;
        self.restart(end);
        Token { kind: Kind::Letter, end, ..token }
    }

    /// `Q500otvor`: the word before a text that begins with an O.
    fn word_before_text(&mut self, token: Token) -> Token {
        let text = self.text.get(token.span().range()).sure();
        let word = text.trim_end_matches(['O', 'o']);
        let mut behind = self.text.get(token.end as usize..).sure().chars();
        let is_text = behind.by_ref().take(2).filter(|character| character.is_alphabetic()).count() == 2;
        let well_formed = Number::parse(word.get(1..).unwrap_or_default().as_bytes()).is_some();
        if word.len() == text.len() || !is_text || !well_formed {
            return token;
        }
        let end = token.start + small(word.len());
        self.restart(end);
        Token { kind: Kind::Word, end, ..token }
    }

    /// `//` at the beginning of a line makes a comment of it, as in other languages.
    fn skip_token(&mut self, token: Token) -> Token {
        let bytes = self.text.as_bytes();
        if token.end != token.start + 1 || bytes.get(token.end as usize) != Some(&b'/') {
            return token;
        }
        if !self.begins_line(token.start) {
            return token;
        }
        let rest = bytes.get(token.end as usize..).sure();
        let end = token.end + small(rest.iter().take_while(|byte| !matches!(byte, b'\n' | b'\r')).count());
        self.restart(end);
        Token { kind: Kind::Junk(Shape::ForeignComment), end, ..token }
    }

    /// `;` between words and a block number may be the border of two blocks: what follows it stays in the program.
    fn comment_token(&mut self, token: Token) -> Token {
        let text = self.text.get(token.span().range()).sure();
        let glued = self.last.is_some_and(|last| last.end == token.start && last.kind != Kind::Comment);
        if glued && text.starts_with(['(', '{']) && !text.ends_with([')', '}']) {
            // A slip in a word, no comment.
            let digits = text.bytes().skip(1).take_while(u8::is_ascii_digit).count();
            let end = token.start + 1 + small(digits);
            self.restart(end);
            return Token { kind: Kind::Junk(Shape::Unknown), end, ..token };
        }
        let inner = text.strip_prefix(';').map(|inner| inner.trim_start_matches([' ', '\t']).as_bytes());
        if !matches!(inner, Some([b'N' | b'n', b'0'..=b'9', ..])) || self.begins_line(token.start) {
            return token;
        }
        let end = token.start + 1;
        self.restart(end);
        Token { kind: Kind::Junk(Shape::Unknown), end, ..token }
    }

    /// Whether nothing but blanks is before `at` in its line.
    fn begins_line(&self, at: u32) -> bool {
        let before = self.text.as_bytes().get(..at as usize).sure();
        let before = before.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t'));
        matches!(before, None | Some(b'\n' | b'\r'))
    }

    /// A run of letters is text, but its last letter may be the address of a word (`XYZ5`), and letters O after the
    /// first may stand for digits (`GOOX10`).
    fn text_token(&mut self, token: Token) -> Token {
        if let Some(token) = self.whole_text(token).or_else(|| self.two_letters(token)) {
            return token;
        }
        if self.is_number_in_letters(token) {
            return Token { kind: Kind::Junk(Shape::LooseWord), ..token };
        }
        let bytes = self.text.as_bytes();
        let run = bytes.get(token.span().range()).sure();
        let letters = self.text.get(token.span().range()).sure().chars().take(MOST + 1).count();
        let rest = bytes.get(token.end as usize..).sure();
        let follows = rest.iter().find(|byte| !matches!(byte, b' ' | b'\t'));
        let is_address = run.last().is_some_and(u8::is_ascii_alphabetic)
            && follows.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.'))
            && (rest.first() == follows || letters <= MOST);
        if !is_address {
            return token;
        }
        let kept = Token { end: token.end - 1, ..token };
        if letters == 2 {
            // A letter without a value, then a word.
            self.restart(kept.end);
            return Token { kind: letter_kind(bytes, kept.start), ..kept };
        }
        let zeros = run.get(1..run.len() - 1).is_some_and(|run| run.iter().all(|byte| matches!(byte, b'o' | b'O')));
        let first_is_address = run.first().is_some_and(u8::is_ascii_alphabetic);
        if first_is_address && zeros {
            self.restart(kept.end);
            return Token { kind: Kind::Junk(Shape::LooseWord), ..kept };
        }
        if letters > MOST {
            // `CYCLE81` is a name; digits behind one belong to it.
            return token;
        }
        if !run.is_ascii() {
            self.restart(kept.end);
            return kept;
        }
        // Two letters without values, then a word.
        self.restart(kept.end);
        let second = Token { kind: letter_kind(bytes, kept.start + 1), start: kept.start + 1, end: kept.end };
        self.pending = Some(second);
        Token { kind: letter_kind(bytes, kept.start), start: kept.start, end: kept.start + 1 }
    }

    /// Letters with `/` between them, which is no block skip there, and the names of units.
    fn whole_text(&mut self, token: Token) -> Option<Token> {
        let bytes = self.text.as_bytes();
        let mut end = token.end;
        while let Some([b'/', rest @ ..]) = bytes.get(end as usize..) {
            let letters = rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
            let name = letters > 1 || matches!(rest.first(), Some(b'R' | b'r'));
            let behind = rest.get(letters);
            let value = behind.is_some_and(|byte| byte.is_ascii_digit() || b"+-.=".contains(byte));
            if !name || letters == 0 || value {
                break;
            }
            end += 1 + small(letters);
        }
        let name = self.text.get(token.start as usize..end as usize).sure();
        let value = bytes.get(end as usize).is_some_and(|byte| byte.is_ascii_digit() || b"+-.=".contains(byte));
        let unit = !value && UNITS.iter().any(|unit| unit.eq_ignore_ascii_case(name));
        if end != token.end {
            self.restart(end);
        }
        let kind = if unit { Kind::Junk(Shape::Unit) } else { Kind::Junk(Shape::Text) };
        (unit || name.contains('/')).then_some(Token { kind, end, ..token })
    }

    /// Two letters alone that are a word with a slip in it: `XR`, `TI`, `TT1`.
    fn two_letters(&mut self, token: Token) -> Option<Token> {
        let bytes = self.text.as_bytes();
        let Some(&[first, second]) = bytes.get(token.span().range()) else { return None };
        Address::from_byte(first).filter(|address| *address != Address::R)?;
        let rest = bytes.get(token.end as usize..).sure();
        let blanks = rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let behind = rest.get(blanks..).sure();
        if first.eq_ignore_ascii_case(&second) {
            let number = behind.iter().take_while(|byte| byte.is_ascii_digit() || b"+-.".contains(byte)).count();
            let digits = behind.get(..number)?.iter().any(u8::is_ascii_digit);
            let end = token.end + small(blanks + number);
            return digits.then(|| {
                self.restart(end);
                Token { kind: Kind::Junk(Shape::LooseWord), end, ..token }
            });
        }
        let value = behind.first().is_some_and(|byte| byte.is_ascii_digit() || b"+-.=".contains(byte));
        let text = matches!(behind, [one, next, ..] if one.is_ascii_alphabetic() && next.is_ascii_alphabetic())
            || behind.first().is_some_and(|byte| !byte.is_ascii());
        if value || text || self.last.is_some_and(|last| last.kind == Kind::Junk(Shape::Text)) {
            return None;
        }
        match second {
            b'R' | b'r' if b"XYZUVWIJKLQFSGM".contains(&first.to_ascii_uppercase()) => {
                self.restart(token.end);
                let start = token.start + 1;
                self.pending = Some(Token { kind: Kind::Junk(Shape::BareR), start, end: token.end });
                Some(Token { kind: Kind::Letter, end: start, ..token })
            }
            b'I' if !matches!(first, b'N' | b'n') => Some(Token { kind: Kind::Junk(Shape::LooseWord), ..token }),
            _ => None,
        }
    }

    /// `NSO Y40` at the beginning of a line, `G71 LIOO`: letters that look like digits, all of them.
    fn is_number_in_letters(&self, token: Token) -> bool {
        let bytes = self.text.as_bytes();
        let Some([first, digits @ ..]) = bytes.get(token.span().range()) else { return false };
        if digits.len() >= MOST_LETTERS || !digits.iter().all(|letter| look_alike(*letter).is_some()) {
            return false;
        }
        let behind = bytes.get(token.end as usize..).sure();
        let apart = matches!(behind.first(), None | Some(b' ' | b'\t' | b'\r' | b'\n' | b'"'));
        let blanks = behind.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let word = matches!(behind.get(blanks..), Some([letter, value, ..])
            if letter.is_ascii_uppercase() && (value.is_ascii_digit() || b"+-.".contains(value)));
        let flow = |last: Token| {
            let word = bytes.get(last.span().range()).sure();
            last.kind == Kind::Word && matches!(word, [b'G', b'7', b'1'..=b'3' | b'9'])
        };
        match first {
            b'N' => apart && word && self.begins_line(token.start),
            b'L' => apart && self.last.is_some_and(flow),
            _ => false,
        }
    }

    fn restart(&mut self, at: u32) {
        self.lexer = lexer_at(self.text, at, small(self.text.len()));
    }
}

fn letter_kind(bytes: &[u8], at: u32) -> Kind {
    match bytes.get(at as usize) {
        Some(b'R' | b'r') => Kind::Junk(Shape::BareR),
        Some(byte) if byte.is_ascii() => Kind::Letter,
        _ => Kind::Junk(Shape::Unknown),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<(Kind, &str)> {
        let end = u32::try_from(text.len()).unwrap();
        tokens(text, 0, end).map(|token| (token.kind, &text[token.span().range()])).collect()
    }

    #[test]
    fn well_formed_words() {
        let expected = [(Kind::Word, "N10"), (Kind::Word, "X  -36.12"), (Kind::Parameter, "R 5"), (Kind::Equals, "=")];
        assert_eq!(kinds("N10X  -36.12\tR 5 ="), expected);
        assert_eq!(kinds("g71l100"), [(Kind::Word, "g71"), (Kind::Word, "l100")]);
        assert_eq!(kinds("GL5"), [(Kind::Letter, "G"), (Kind::Word, "L5")]);
    }

    #[test]
    fn faulty_words_stay_whole() {
        for text in ["X1,5", "X1O0", "XO", "Xl0", "X--5", "X1.2.3", "X.", "GOO"] {
            assert_eq!(kinds(text), [(Kind::Junk(Shape::LooseWord), text)]);
        }
        assert_eq!(kinds("GOOX1"), [(Kind::Junk(Shape::LooseWord), "GOO"), (Kind::Word, "X1")]);
        assert_eq!(kinds("X-R1"), [(Kind::Letter, "X-"), (Kind::Parameter, "R1")]);
        assert_eq!(kinds("R10-5"), [(Kind::Parameter, "R10"), (Kind::Number, "-5")]);
    }

    /// LEX-13: the stack does not grow with a token; builds without optimisation have no tail calls.
    #[test]
    fn long_tokens() {
        let length = 1 << 20;
        for (text, kind) in [
            ("€", Kind::Junk(Shape::Unknown)),
            ("Á", Kind::Junk(Shape::Text)),
            ("1", Kind::Number),
            ("+", Kind::Junk(Shape::LooseNumber)),
        ] {
            let text = text.repeat(length);
            assert_eq!(kinds(&text), [(kind, text.as_str())]);
        }
        let comment = format!("\"{}\"", "é".repeat(length));
        assert_eq!(kinds(&comment), [(Kind::Comment, comment.as_str())]);
    }

    #[test]
    fn text_and_comments() {
        assert_eq!(kinds("KONTURA X5"), [(Kind::Junk(Shape::Text), "KONTURA"), (Kind::Word, "X5")]);
        assert_eq!(kinds("\"a\nN1"), [(Kind::Comment, "\"a"), (Kind::LineEnd, "\n"), (Kind::Word, "N1")]);
        assert_eq!(kinds("„a“"), [(Kind::Junk(Shape::TypographicComment), "„a“")]);
        assert_eq!(kinds("XYZ5"), [(Kind::Letter, "X"), (Kind::Letter, "Y"), (Kind::Word, "Z5")]);
    }
}
