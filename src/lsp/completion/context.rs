//! Recognises the item that the user types, from the text before it on its line and from its block.

use crate::dict::Address;
use crate::query::cursor::block_at;
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, Kind, ParsedFile, Shape, Token, Word, tokens};
use crate::text::Span;

/// Nothing is offered further to the right than this, in bytes: no line of a program is as long.
const LONGEST_LINE: u32 = 1 << 12;

/// The kinds of item that fit at a place.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Wanted {
    /// Any word.
    Words,
    /// The rest of a word of that address.
    Address(Address),
    /// The assignment of a parameter: `R1`.
    Assignment,
    /// A parameter in place of a number; the parameter that it is assigned to.
    Value {
        /// `R11` in `R11=R1`.
        target: Option<u8>,
    },
    /// The name of a snippet: letters alone on a line.
    Name,
}

/// A place in the document with what is typed there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Context<'a> {
    pub(super) file: &'a ParsedFile,
    pub(super) wanted: Wanted,
    /// The cursor.
    pub(super) at: u32,
    /// What an item takes the place of: what is typed, and the number right behind the cursor.
    pub(super) replaced: Span,
    /// The typed part of the item.
    pub(super) typed: &'a str,
    /// Nothing else stands on the line, and what follows is no part of the block before: a block may begin here.
    pub(super) alone: bool,
    /// The block that the word belongs to.
    pub(super) block: Option<BlockId>,
}

impl<'a> Context<'a> {
    /// Reads the text before `at`; `None` where nothing can be offered.
    pub(super) fn new(file: &'a ParsedFile, at: u32) -> Option<Self> {
        let text = file.source.text();
        let lines = file.source.lines();
        let start = lines.start(lines.line_at(at))?.min(at);
        let before_program = file.program.is_some() && at <= file.start;
        let after_end = at >= file.end && text.get(..file.end as usize)?.ends_with('*');
        if at - start > LONGEST_LINE || before_program || after_end {
            return None;
        }
        let line = text.get(start as usize..at as usize)?;
        let lead = line.trim_start_matches([' ', '\t']);
        let lead_start = at - small(lead.len());
        let before: Vec<Token> = tokens(text, start, at).collect();
        let named = lead.chars().count() > 1 && lead.chars().all(char::is_alphabetic);
        let (wanted, from) = match wanted(text, &before, at) {
            // `XR` may be the begin of `XR10`.
            Some((wanted @ Wanted::Value { .. }, from)) => (wanted, from),
            _ if named => (Wanted::Name, lead_start),
            found => found?,
        };
        let block = block_at(file, from);
        let rest = text.get(at as usize..)?;
        let to = if takes_number(wanted) { at + small(number_length(rest)) } else { at };
        let behind = rest.get((to - at) as usize..)?.trim_start_matches([' ', '\t']);
        let alone = from == lead_start && (behind.is_empty() || behind.starts_with(['\r', '\n']));
        let torn = from
            .checked_sub(1)
            .and_then(|before| block_at(file, before))
            .is_some_and(|block| file.words(block).last().is_some_and(|word| word.start() >= to));
        Some(Self {
            file,
            wanted,
            at,
            replaced: Span::new(from, to),
            typed: text.get(from as usize..at as usize)?,
            alone: alone && !torn,
            block,
        })
    }

    /// Whether the word has a number already, behind the cursor.
    pub(super) fn has_number(&self) -> bool {
        let behind = self.file.source.text().get(self.at as usize..).sure();
        number_length(behind.trim_start_matches([' ', '\t'])) > 0
    }

    /// Whether the word is assigned to already, behind the cursor.
    pub(super) fn is_assigned(&self) -> bool {
        let behind = self.file.source.text().get(self.replaced.end as usize..).sure();
        behind.trim_start_matches([' ', '\t']).starts_with('=')
    }

    /// The typed text before the digits: the address, and blanks.
    pub(super) fn head(&self) -> &'a str {
        self.typed.trim_end_matches(|character: char| character.is_ascii_digit())
    }

    /// The digits typed so far; `None` when something else is among them.
    pub(super) fn digits(&self) -> Option<&'a str> {
        let head = self.head();
        let plain = head.trim_end_matches([' ', '\t']).chars().count() <= 1;
        plain.then(|| self.typed.get(head.len()..).sure())
    }

    /// The words of the block, without the one that is typed.
    pub(super) fn words(&self) -> impl Iterator<Item = Word> + 'a {
        let (text, at, from) = (self.file.source.text(), self.at, self.replaced.start);
        let words = self.block.map_or::<&[Word], _>(&[], |block| self.file.words(block));
        words.iter().copied().filter(move |word| {
            word.start() != from && !(word.start() < at && at <= word.span(text).end && from < word.span(text).end)
        })
    }

    /// The block before the place where a block would begin.
    pub(super) fn previous(&self) -> Option<BlockId> {
        previous(self.file, self.replaced.start)
    }
}

/// The last block that begins before a place.
pub(super) fn previous(file: &ParsedFile, at: u32) -> Option<BlockId> {
    block_at(file, at.checked_sub(1)?)
}

/// Whether a number behind the cursor belongs to what is typed.
const fn takes_number(wanted: Wanted) -> bool {
    matches!(wanted, Wanted::Address(_) | Wanted::Assignment | Wanted::Value { .. })
}

/// How long the number is that a text begins with, or the rest of one.
fn number_length(text: &str) -> usize {
    let unsigned = text.trim_start_matches(['+', '-']);
    let digits = unsigned.trim_start_matches(|character: char| character.is_ascii_digit() || ".,".contains(character));
    // A sign alone is none.
    if digits.len() == unsigned.len() { 0 } else { text.len() - digits.len() }
}

/// The kind of item that follows the tokens of a line, and where its typed part begins.
fn wanted(text: &str, before: &[Token], at: u32) -> Option<(Wanted, u32)> {
    let Some((&last, rest)) = before.split_last() else { return Some((Wanted::Words, at)) };
    let written = text.get(last.span().range())?;
    let touching = last.end == at;
    let words = Some((Wanted::Words, at));
    let signed = written.ends_with(['+', '-']);
    match last.kind {
        Kind::Comment if touching => (written.len() > 1 && written.ends_with('"')).then_some((Wanted::Words, at)),
        Kind::Junk(Shape::TypographicComment) if touching => {
            let closed = written.chars().count() > 1 && written.ends_with(['"', '“', '”', '„']);
            closed.then_some((Wanted::Words, at))
        }
        Kind::Letter if signed => None,
        Kind::Letter => address(text, last).map(|address| (Wanted::Address(address), last.start)),
        Kind::Word if touching => address(text, last).map(|address| (Wanted::Address(address), last.start)),
        Kind::Junk(Shape::BareR) => Some((value(text, rest).unwrap_or(Some(Wanted::Assignment))?, last.start)),
        Kind::Parameter if touching => Some((value(text, rest).unwrap_or(Some(Wanted::Assignment))?, last.start)),
        // `XR`: two letters, until a digit follows.
        Kind::Junk(Shape::Text) if touching && takes_parameter(written) => {
            Some((Wanted::Value { target: None }, at - 1))
        }
        Kind::Parameter => value(text, rest).flatten().and(words),
        Kind::Equals | Kind::Sign => value(text, before)?.map(|wanted| (wanted, at)),
        Kind::Number if touching => {
            let after_equals = rest.last().is_some_and(|token| token.kind == Kind::Equals);
            let digits = small(written.trim_start_matches(['+', '-']).len());
            value(text, rest).flatten().filter(|_| after_equals).map(|wanted| (wanted, at - digits))
        }
        Kind::Skip | Kind::Junk(_) if touching => None,
        Kind::End => None,
        Kind::Comment | Kind::Word | Kind::LineEnd | Kind::Number | Kind::Skip | Kind::Junk(_) => words,
    }
}

/// Whether the tokens ask for a value: `X`, `X-`, `R11=`, `R11=-`. `None` when not, `Some(None)` when no parameter can
/// be it.
fn value(text: &str, before: &[Token]) -> Option<Option<Wanted>> {
    let (last, rest) = before.split_last()?;
    match last.kind {
        Kind::Sign => value(text, rest).filter(|_| rest.last().is_some_and(|token| token.kind == Kind::Equals)),
        Kind::Equals => {
            let target = rest.last().filter(|token| token.kind == Kind::Parameter);
            let number = target.and_then(|token| text.get(token.span().range())?.get(1..)?.trim().parse().ok());
            Some(number.map(|number| Wanted::Value { target: Some(number) }))
        }
        Kind::Letter => {
            let numbered = address(text, *last).filter(|address| !matches!(address, Address::N | Address::Program));
            Some(numbered.map(|_| Wanted::Value { target: None }))
        }
        Kind::Word
        | Kind::Parameter
        | Kind::Comment
        | Kind::LineEnd
        | Kind::Number
        | Kind::Skip
        | Kind::End
        | Kind::Junk(_) => None,
    }
}

/// Whether a text is an address and the letter of a parameter: `XR`.
fn takes_parameter(written: &str) -> bool {
    let &[address, b'R' | b'r'] = written.as_bytes() else { return false };
    Address::from_byte(address).is_some_and(|address| !matches!(address, Address::N | Address::Program | Address::R))
}

fn address(text: &str, token: Token) -> Option<Address> {
    text.as_bytes().get(token.start as usize).copied().and_then(Address::from_byte)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::Findings;
    use crate::syntax::{Form, parse};
    use crate::text::{FileId, SourceText};

    /// The kind of item at `|` in the block `text`, and its typed part.
    fn at(text: &str) -> Option<(Wanted, String, bool)> {
        let at = text.find('|').unwrap();
        let text = text.replace('|', "");
        let source = Arc::new(SourceText::from_text("t.nc", text));
        let file = parse(FileId(0), &source, Form::Program, &mut Findings::new());
        let context = Context::new(&file, u32::try_from(at).unwrap())?;
        Some((context.wanted, source.slice(context.replaced).to_owned(), context.alone))
    }

    fn in_block(text: &str) -> Option<(Wanted, String)> {
        at(&format!("%1\nN10 {text}\nN20 M30\n")).map(|(wanted, typed, _)| (wanted, typed))
    }

    #[test]
    fn words_and_their_parts() {
        let some = |wanted: Wanted, typed: &str| Some((wanted, typed.to_owned()));
        for text in ["|", "G1 |", "X1 | Y2", "\"a\"|", "XR1 |", "R1=5 |", "X1.. |", "ABC |"] {
            assert_eq!(in_block(text), some(Wanted::Words, ""), "{text}");
        }
        for (text, typed) in [("G|", "G"), ("g0|", "g0"), ("X1 G 1|", "G 1"), ("G |", "G "), ("X1G0|1 Y5", "G01")] {
            assert_eq!(in_block(text), some(Wanted::Address(Address::G), typed), "{text}");
        }
        for (text, typed) in [("F|1.5 X1", "F1.5"), ("F1|.5", "F1.5"), ("F|-1,25X1", "F-1,25"), ("F|-R1", "F")] {
            assert_eq!(in_block(text), some(Wanted::Address(Address::F), typed), "{text}");
        }
        assert_eq!(in_block("XR|10 Y1"), some(Wanted::Value { target: None }, "R10"));
        assert_eq!(in_block("R10=1|1"), some(Wanted::Value { target: Some(10) }, "11"));
        assert_eq!(in_block("G71 L|"), some(Wanted::Address(Address::L), "L"));
        assert_eq!(in_block("R|"), some(Wanted::Assignment, "R"));
        assert_eq!(in_block("X1 R1|"), some(Wanted::Assignment, "R1"));
        for text in ["XR|", "X R|", "X-R|"] {
            assert_eq!(in_block(text), some(Wanted::Value { target: None }, "R"), "{text}");
        }
        assert_eq!(at("%1\nN10 X1\nXR|").map(|found| found.0), Some(Wanted::Value { target: None }));
        assert_eq!(in_block("R11=R1|"), some(Wanted::Value { target: Some(11) }, "R1"));
        assert_eq!(in_block("R 5 = |"), some(Wanted::Value { target: Some(5) }, ""));
        assert_eq!(in_block("R5=-|"), some(Wanted::Value { target: Some(5) }, ""));
        assert_eq!(in_block("R5=-01|"), some(Wanted::Value { target: Some(5) }, "01"));
        for text in ["\"|", "\"G|\"", "„G|", "NR|", "X-|", "X1,|", "R1 |", "R1 5|", "5|", "#|", "/|", "X=|", "* G|"] {
            assert_eq!(in_block(text), None, "{text}");
        }
    }

    #[test]
    fn where_a_block_may_begin() {
        let alone = |text: &str| at(text).is_some_and(|(.., alone)| alone);
        assert!(alone("%1\nN10 X1\n|\nN20 M30"));
        assert!(alone("%1\nN10 X1\n  N|"));
        assert!(alone("%1\nN10 X1\nloo|\nN20"));
        assert!(alone("|"));
        assert!(!alone("%1\nN10 X1\n|\nY1\nN20 M30"), "Y1 would be torn from its block");
        assert!(!alone("%1\nN10 X1\nG1 |\nN20 M30"));
        assert!(!alone("%1\nN10 X1\n| G1\nN20 M30"));
        assert_eq!(at("abc |\n%1\n"), None);
        assert_eq!(at("%1\nN10 M30\n*\n|"), None);
    }
}
