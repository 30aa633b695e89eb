//! A `*` that cuts off the rest of the program (LEX-9): what follows from it is one finding.

use std::collections::BTreeMap;

use super::{Resolved, Unit};
use crate::diag::{Code, Diagnostic, Finding, Findings, Label, LabelText, Star, Unread, UnreadEnd};
use crate::dict::{GCode, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, Kind, ParsedFile, Token, tokens};
use crate::text::{FileId, Location, SourceText, Span};

/// So many bytes behind `*` are looked at.
const UNREAD: u32 = 1 << 20;
/// A block number has so many digits at most.
const BLOCK_DIGITS: usize = 8;

/// A `*` that cuts off the rest of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct CutOff {
    pub(super) star: Location,
    /// What stands behind a `*` among words, on their line: it is not there to end anything.
    slip: Span,
    /// The block before it.
    last: Location,
}

impl CutOff {
    /// That at the end of what is read; `last`: the block before it.
    fn before(parsed: &ParsedFile, last: Location) -> Option<Self> {
        let star = Span::new(parsed.end.checked_sub(1)?, parsed.end);
        let is_star = parsed.source.text().get(star.range()) == Some("*");
        is_star.then(|| Self { star: parsed.at(star), slip: slip_of(&parsed.source, star), last })
    }

    /// Whether a finding follows from it: targets that are not read, what the block before lacks, the rest of its line.
    fn leads_to(&self, found: &Diagnostic) -> bool {
        let Self { star, slip, last } = *self;
        let at = found.at;
        let code = found.code();
        let follows = matches!(code, Code::E0404 | Code::E0406)
            || code == Code::W0110 && (slip.start..slip.end).contains(&at.span.start)
            || code == Code::E0103 && at.span.end == star.span.start
            || matches!(code, Code::E0206 | Code::W0214) && at == last;
        at.file == star.file && follows
    }
}

/// What stands on the line of `star` behind it, when there are words before it, or those of a block right behind it; else
/// nothing.
fn slip_of(source: &SourceText, star: Span) -> Span {
    let is_end = |character: char| matches!(character, '\n' | '\r');
    let text = source.text();
    let before = text.get(..star.start as usize).sure().rsplit(is_end).next().sure();
    let behind = text.get(star.end as usize..).sure().split(is_end).next().sure();
    let block = matches!(behind.as_bytes(), [b'0'..=b'9', ..] | [b'N' | b'n', b'0'..=b'9', ..]);
    let length = if before.trim().is_empty() && !block { 0 } else { behind.len() };
    Span::new(star.end, star.end + small(length))
}

/// The `*` within a subprogram or macrocycle without an end, behind which the end stands, and that end.
pub(super) fn subprogram(parsed: &ParsedFile, unit: &Unit) -> Option<(CutOff, Unread)> {
    let last = unit.end.0.checked_sub(1).map(BlockId)?;
    let cut = CutOff::before(parsed, parsed.n_place(last)).filter(|_| unit.end.0 == parsed.block_count())?;
    let end = unread_words(parsed).find(|word| word.is('G', GCode::G70.number()))?;
    Some((cut, Unread { line: line_of(parsed, end.start), star: star_meant(parsed) }))
}

/// The `*` that cuts off the end of a program whose last block is at `last`, and that end: the first M02 or M30 that
/// follows a block number.
pub(super) fn program_end(parsed: &ParsedFile, last: Location) -> Option<(CutOff, UnreadEnd)> {
    let cut = CutOff::before(parsed, last)?;
    // `N20* M30`, and `*20 M30` with the star in place of N.
    let line = if cut.slip.is_empty() { 0 } else { line_of(parsed, parsed.end) };
    let mut numbered = false;
    // A second program has an end of its own.
    for word in unread_words(parsed).take_while(|word| word.letter != '%') {
        numbered |= word.letter == 'N';
        let end = PROGRAM_ENDS.into_iter().find(|&function| word.is('M', function));
        let own_line = line_of(parsed, word.start);
        if let Some(function) = end.filter(|_| numbered || own_line == line) {
            let unread = Unread { line: own_line, star: star_meant(parsed) };
            return Some((cut, UnreadEnd { function, unread }));
        }
    }
    None
}

/// Leaves out what follows from a `*`. Calls of subprograms that stand behind one become one finding, at the first of them.
pub(super) fn join(resolved: &Resolved, findings: &mut Findings) {
    if let Some(cut) = &resolved.cut_off {
        findings.revise(|found| !cut.leads_to(found));
        return;
    }
    let called = |found: &Diagnostic| {
        let Finding::UnknownSubprogram { l, from_macrocycle: false, macrocycle: false, .. } = found.finding else {
            return None;
        };
        Some(l)
    };
    if findings.items().iter().all(|found| called(found).is_none()) {
        return;
    }
    let Some(parsed) = resolved.file(FileId(0)) else { return };
    let last = parsed.block_count().checked_sub(1).map(|last| parsed.n_place(BlockId(last)));
    let Some(cut) = CutOff::before(parsed, last.unwrap_or_default()) else { return };
    let entries = unread_entries(parsed);
    let unread = |found: &Diagnostic| called(found).and_then(|l| entries.get(&l).copied());
    let first = findings.items().iter().filter(|found| unread(found).is_some()).map(|found| found.at).min();
    let Some(first) = first else { return };
    let star = star_meant(parsed);
    findings.revise(|found| {
        let line = unread(found);
        if line.is_some() && found.at == first {
            if let Finding::UnknownSubprogram { near, without_entry, unread, .. } = &mut found.finding {
                (*near, *without_entry, *unread) = (None, None, line.map(|line| Unread { line, star }));
            }
            found.labels = vec![Label { at: cut.star, text: LabelText::FileEnds }];
            return true;
        }
        line.is_none() && (found.code() == Code::E0404 || !cut.leads_to(found))
    });
}

/// The subprograms that begin behind `*`: the number of each, and the line of its G79.
fn unread_entries(parsed: &ParsedFile) -> BTreeMap<u32, u32> {
    let mut entries = BTreeMap::new();
    let mut entry = None;
    for word in unread_words(parsed).take_while(|word| word.letter != '%') {
        if word.is('G', GCode::G79.number()) {
            entry = Some(line_of(parsed, word.start));
        } else if let Some((line, l)) = entry.take().zip(word.number.and_then(|number| u32::try_from(number).ok()))
            && word.letter == 'L'
        {
            entries.entry(l).or_insert(line);
        }
    }
    entries
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

/// The words behind `*`.
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
    tokens(text, parsed.end, end).filter(|token| token.kind == Kind::Word).filter_map(read)
}

fn line_of(parsed: &ParsedFile, at: u32) -> u32 {
    small(parsed.source.lines().line_at(at) + 1)
}

/// What the `*` at the end of what is read was probably meant as.
fn star_meant(parsed: &ParsedFile) -> Star {
    let text = parsed.source.text();
    let before = text.get(..(parsed.end as usize).saturating_sub(1)).sure();
    let behind = text.get(parsed.end as usize..).sure();
    let factor = |byte: Option<&u8>| byte.is_some_and(|byte| byte.is_ascii_digit() || b"Rr])".contains(byte));
    if before.trim_end_matches([' ', '\t']).ends_with(['\n', '\r']) {
        let number = behind.bytes().take_while(u8::is_ascii_digit).count();
        match behind.as_bytes() {
            _ if (1..=BLOCK_DIGITS).contains(&number) => Star::Number,
            [b'N' | b'n', b'0'..=b'9', ..] => Star::Block,
            _ => Star::Line,
        }
    } else if factor(before.as_bytes().last()) && factor(behind.as_bytes().first()) {
        Star::Product
    } else {
        Star::Slip
    }
}
