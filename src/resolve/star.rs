//! A `*` that cuts off the rest of a file (LEX-9): the unread text after it is a hole in the structure.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use super::Unit;
use super::spelling::leading_number;
use crate::diag::{Code, Diagnostic, Star as Meant, Unread, UnreadEnd};
use crate::dict::{GCode, HIGHEST_BLOCK, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, Kind, ParsedFile, Token, tokens};
use crate::text::{Location, SourceText, Span};

/// So many bytes behind `*` are looked at.
const UNREAD: u32 = 1 << 20;

/// The `*` that ends a file.
#[derive(Clone, Debug)]
pub(super) struct Star {
    pub(super) at: Location,
    /// The text behind a `*` among words, on their line: it is not there to end anything.
    slip: Span,
    /// The last block, when it is on the line of the `*`.
    block: Option<BlockId>,
    /// The units and blocks behind it, once somebody asks.
    hidden: OnceLock<Hidden>,
}

/// The targets of calls and jumps after a `*`.
#[derive(Clone, Debug, Default)]
struct Hidden {
    /// The number of each subprogram, and the line of its G79.
    entries: BTreeMap<u32, u32>,
    blocks: BTreeSet<u32>,
}

impl Star {
    /// That of a file.
    pub(super) fn of(parsed: &ParsedFile) -> Option<Self> {
        let star = Span::new(parsed.end.checked_sub(1)?, parsed.end);
        if parsed.source.text().get(star.range()) != Some("*") {
            return None;
        }
        let last = parsed.block_count().checked_sub(1).map(BlockId);
        let in_line = |last: &BlockId| {
            parsed.n_word(*last).is_some_and(|n| line_of(parsed, n.start()) == line_of(parsed, star.start))
        };
        let slip = slip_of(&parsed.source, star);
        Some(Self { at: parsed.at(star), slip, block: last.filter(in_line), hidden: OnceLock::new() })
    }

    /// The last block, when it is on the line of the `*`: the words that it lacks may come after that.
    pub(super) const fn block(&self) -> Option<BlockId> {
        self.block
    }

    /// Whether a finding at the `*` follows from it: the rest of its line, a value or the words that are missing before
    /// it.
    pub(super) fn leads_to(&self, found: &Diagnostic) -> bool {
        found.code() != Code::W0110 || (self.slip.start..self.slip.end).contains(&found.at.span.start)
    }

    /// The G79 of subprogram `l` behind the `*`.
    pub(super) fn entry(&self, parsed: &ParsedFile, l: u32) -> Option<Unread> {
        self.hidden(parsed).entries.get(&l).map(|line| unread(parsed, *line))
    }

    /// Whether a block with that number comes after the `*`.
    pub(super) fn has_block(&self, parsed: &ParsedFile, number: u32) -> bool {
        self.hidden(parsed).blocks.contains(&number)
    }

    fn hidden(&self, parsed: &ParsedFile) -> &Hidden {
        self.hidden.get_or_init(|| {
            let mut hidden = Hidden::default();
            let mut entry = None;
            for word in unread_words(parsed) {
                let number = word.number.and_then(|number| u32::try_from(number).ok());
                if word.is('G', GCode::G79.number()) {
                    entry = Some(line_of(parsed, word.start));
                } else if let Some((line, l)) = entry.take().zip(number)
                    && word.letter == 'L'
                {
                    hidden.entries.entry(l).or_insert(line);
                }
                hidden.blocks.extend(number.filter(|_| word.letter == 'N'));
            }
            hidden
        })
    }

    /// The end of a subprogram or macrocycle without one, behind the `*` in it.
    pub(super) fn unit_end(&self, parsed: &ParsedFile, unit: &Unit) -> Option<Unread> {
        if unit.end.0 != parsed.block_count() {
            return None;
        }
        // Behind the next G79 it is the end of another one.
        let mut words = unread_words(parsed).take_while(|word| !word.is('G', GCode::G79.number()));
        let end = words.find(|word| word.is('G', GCode::G70.number()))?;
        Some(unread(parsed, line_of(parsed, end.start)))
    }

    /// The end of the program behind the `*`: the first M02 or M30 that follows a block number.
    pub(super) fn program_end(&self, parsed: &ParsedFile) -> Option<UnreadEnd> {
        // `N20* M30`, and `*20 M30` with the star in place of N.
        let line = if self.slip.is_empty() { 0 } else { line_of(parsed, parsed.end) };
        let mut numbered = false;
        for word in unread_words(parsed) {
            numbered |= word.letter == 'N';
            let end = PROGRAM_ENDS.into_iter().find(|&function| word.is('M', function));
            let own_line = line_of(parsed, word.start);
            if let Some(function) = end.filter(|_| numbered || own_line == line) {
                return Some(UnreadEnd { function, unread: unread(parsed, own_line) });
            }
        }
        None
    }
}

/// The text on the line of `star` behind it, when words stand before it, or those of a block right behind it; else
/// nothing.
fn slip_of(source: &SourceText, star: Span) -> Span {
    let is_end = |character: char| matches!(character, '\n' | '\r');
    let text = source.text();
    let before = text.get(..star.start as usize).sure().rsplit(is_end).next().sure();
    let behind = text.get(star.end as usize..).sure().split(is_end).next().sure();
    let block = begins_block_number(behind.strip_prefix(['N', 'n']).unwrap_or(behind));
    let length = if before.trim().is_empty() && !block { 0 } else { behind.len() };
    Span::new(star.end, star.end + small(length))
}

/// A word that is not read.
#[derive(Clone, Copy)]
struct UnreadWord {
    start: u32,
    letter: char,
    number: Option<i64>,
}

impl UnreadWord {
    fn is(self, letter: char, number: u8) -> bool {
        self.letter == letter && self.number == Some(i64::from(number))
    }
}

/// The words behind `*`, not those of a second program.
fn unread_words(parsed: &ParsedFile) -> impl Iterator<Item = UnreadWord> {
    let text = parsed.source.text();
    let mut end = parsed.source.len().min(parsed.end.saturating_add(UNREAD));
    while !text.is_char_boundary(end as usize) {
        end -= 1;
    }
    let read = |token: Token| {
        let word = text.get(token.span().range())?;
        let letter = word.chars().next()?.to_ascii_uppercase();
        let number = word.get(1..)?.trim_start_matches([' ', '\t']).parse().ok();
        Some(UnreadWord { start: token.start, letter, number })
    };
    let words = tokens(text, parsed.end, end).filter(|token| token.kind == Kind::Word).filter_map(read);
    words.take_while(|word| word.letter != '%')
}

fn line_of(parsed: &ParsedFile, at: u32) -> u32 {
    small(parsed.source.lines().line_at(at) + 1)
}

/// The hole after the `*`, with a line in it.
fn unread(parsed: &ParsedFile, line: u32) -> Unread {
    let own = line == line_of(parsed, parsed.end);
    let star = match star_meant(parsed) {
        Meant::Number { .. } => Meant::Number { own },
        Meant::Block if own => Meant::Slip,
        star @ (Meant::Block | Meant::Line | Meant::Product | Meant::Slip) => star,
    };
    Unread { line, star }
}

/// The probable meaning of the `*` at the end of the file.
fn star_meant(parsed: &ParsedFile) -> Meant {
    let text = parsed.source.text();
    let before = text.get(..(parsed.end as usize).saturating_sub(1)).sure();
    let behind = text.get(parsed.end as usize..).sure();
    let factor = |byte: Option<&u8>| byte.is_some_and(|byte| byte.is_ascii_digit() || b"Rr])".contains(byte));
    let before = before.trim_end_matches([' ', '\t']);
    if before.ends_with(['\n', '\r']) {
        match behind.strip_prefix(['N', 'n']) {
            Some(number) if begins_block_number(number) => Meant::Block,
            None if begins_block_number(behind) => Meant::Number { own: false },
            Some(_) | None => Meant::Line,
        }
    } else if factor(before.as_bytes().last()) && factor(behind.as_bytes().first()) {
        Meant::Product
    } else {
        Meant::Slip
    }
}

/// Whether a text begins with digits that a block number may have.
fn begins_block_number(text: &str) -> bool {
    leading_number(text).is_some_and(|(number, _)| number <= HIGHEST_BLOCK)
}
