//! A `*` that cuts off the rest of the program (LEX-9): what follows from it is one finding.

use std::collections::{BTreeMap, BTreeSet};

use super::lines::leading_number;
use super::{Resolved, Unit};
use crate::diag::{Code, Diagnostic, Finding, Findings, Label, LabelText, Star, Unread, UnreadEnd};
use crate::dict::{GCode, HIGHEST_BLOCK, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, Kind, ParsedFile, Token, tokens};
use crate::text::{FileId, Location, SourceText, Span};

/// So many bytes behind `*` are looked at.
const UNREAD: u32 = 1 << 20;

/// A `*` that cuts off the rest of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct CutOff {
    pub(super) star: Location,
    /// What stands behind a `*` among words, on their line: it is not there to end anything.
    slip: Span,
    /// The block on its line, when there is one.
    block: Option<Location>,
}

impl CutOff {
    /// That at the end of what is read; `last`: the block before it.
    fn before(parsed: &ParsedFile, last: Location) -> Option<Self> {
        let star = Span::new(parsed.end.checked_sub(1)?, parsed.end);
        let is_star = parsed.source.text().get(star.range()) == Some("*");
        let in_line = line_of(parsed, last.span.start) == line_of(parsed, star.start);
        let block = Some(last).filter(|_| in_line);
        is_star.then(|| Self { star: parsed.at(star), slip: slip_of(&parsed.source, star), block })
    }

    /// Whether a finding follows from it: targets that are not read, what its block lacks, the rest of its line.
    fn leads_to(&self, found: &Diagnostic, unread: &Targets) -> bool {
        let at = found.at;
        let code = found.code();
        let follows = unread.has(&found.finding)
            || code == Code::W0110 && (self.slip.start..self.slip.end).contains(&at.span.start)
            || code == Code::E0103 && at.span.end == self.star.span.start
            || matches!(code, Code::E0206 | Code::W0214) && Some(at) == self.block;
        at.file == self.star.file && follows
    }
}

/// What calls and jumps would lead to behind `*`.
#[derive(Debug, Default)]
struct Targets {
    /// The subprograms: the number of each, and the line of its G79.
    entries: BTreeMap<u32, u32>,
    blocks: BTreeSet<u32>,
}

impl Targets {
    fn unread(parsed: &ParsedFile) -> Self {
        let mut targets = Self::default();
        let mut entry = None;
        for word in unread_words(parsed) {
            let number = word.number.and_then(|number| u32::try_from(number).ok());
            if word.is('G', GCode::G79.number()) {
                entry = Some(line_of(parsed, word.start));
            } else if let Some((line, l)) = entry.take().zip(number)
                && word.letter == 'L'
            {
                targets.entries.entry(l).or_insert(line);
            }
            targets.blocks.extend(number.filter(|_| word.letter == 'N'));
        }
        targets
    }

    fn has(&self, finding: &Finding) -> bool {
        if let Finding::UnknownJumpTarget { l, .. } = finding {
            self.blocks.contains(l)
        } else {
            self.entry_of(finding).is_some()
        }
    }

    /// The line of the G79 that a call would lead to.
    fn entry_of(&self, finding: &Finding) -> Option<u32> {
        let Finding::UnknownSubprogram { l, from_macrocycle: false, macrocycle: false, .. } = finding else {
            return None;
        };
        self.entries.get(l).copied()
    }
}

/// What stands on the line of `star` behind it, when there are words before it, or those of a block right behind it; else
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

/// The `*` within a subprogram or macrocycle without an end, behind which the end stands, and that end.
pub(super) fn subprogram(parsed: &ParsedFile, unit: &Unit) -> Option<(CutOff, Unread)> {
    let last = unit.end.0.checked_sub(1).map(BlockId)?;
    let cut = CutOff::before(parsed, parsed.n_place(last)).filter(|_| unit.end.0 == parsed.block_count())?;
    // Behind the next G79 it is the end of another one.
    let mut words = unread_words(parsed).take_while(|word| !word.is('G', GCode::G79.number()));
    let end = words.find(|word| word.is('G', GCode::G70.number()))?;
    Some((cut, unread(parsed, line_of(parsed, end.start))))
}

/// The `*` that cuts off the end of a program whose last block is at `last`, and that end: the first M02 or M30 that
/// follows a block number.
pub(super) fn program_end(parsed: &ParsedFile, last: Location) -> Option<(CutOff, UnreadEnd)> {
    let cut = CutOff::before(parsed, last)?;
    // `N20* M30`, and `*20 M30` with the star in place of N.
    let line = if cut.slip.is_empty() { 0 } else { line_of(parsed, parsed.end) };
    let mut numbered = false;
    for word in unread_words(parsed) {
        numbered |= word.letter == 'N';
        let end = PROGRAM_ENDS.into_iter().find(|&function| word.is('M', function));
        let own_line = line_of(parsed, word.start);
        if let Some(function) = end.filter(|_| numbered || own_line == line) {
            return Some((cut, UnreadEnd { function, unread: unread(parsed, own_line) }));
        }
    }
    None
}

/// Leaves out what follows from a `*`. Calls of subprograms that stand behind one become one finding, at the first of them.
pub(super) fn join(resolved: &Resolved, findings: &mut Findings) {
    let Some(parsed) = resolved.file(FileId(0)) else { return };
    if let Some(cut) = &resolved.cut_off {
        let targets = Targets::unread(parsed);
        findings.revise(|found| !cut.leads_to(found, &targets));
        return;
    }
    if findings.items().iter().all(|found| found.code() != Code::E0404) {
        return;
    }
    let last = parsed.block_count().checked_sub(1).map(|last| parsed.n_place(BlockId(last)));
    let Some(cut) = CutOff::before(parsed, last.unwrap_or_default()) else { return };
    let targets = Targets::unread(parsed);
    let led = findings.items().iter().filter(|found| targets.entry_of(&found.finding).is_some());
    let Some(first) = led.map(|found| found.at).min() else { return };
    findings.revise(|found| {
        let Some(line) = targets.entry_of(&found.finding) else { return !cut.leads_to(found, &targets) };
        if let Finding::UnknownSubprogram { near, without_entry, unread: behind, .. } = &mut found.finding {
            (*near, *without_entry, *behind) = (None, None, Some(unread(parsed, line)));
        }
        found.labels = vec![Label { at: cut.star, text: LabelText::FileEnds }];
        found.at == first
    });
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

/// What stands in that line behind the `*` at the end of what is read.
fn unread(parsed: &ParsedFile, line: u32) -> Unread {
    let own = line == line_of(parsed, parsed.end);
    let star = match star_meant(parsed) {
        Star::Number { .. } => Star::Number { own },
        Star::Block if own => Star::Slip,
        star @ (Star::Block | Star::Line | Star::Product | Star::Slip) => star,
    };
    Unread { line, star }
}

/// What the `*` at the end of what is read was probably meant as.
fn star_meant(parsed: &ParsedFile) -> Star {
    let text = parsed.source.text();
    let before = text.get(..(parsed.end as usize).saturating_sub(1)).sure();
    let behind = text.get(parsed.end as usize..).sure();
    let factor = |byte: Option<&u8>| byte.is_some_and(|byte| byte.is_ascii_digit() || b"Rr])".contains(byte));
    if before.trim_end_matches([' ', '\t']).ends_with(['\n', '\r']) {
        match behind.strip_prefix(['N', 'n']) {
            Some(number) if begins_block_number(number) => Star::Block,
            None if begins_block_number(behind) => Star::Number { own: false },
            Some(_) | None => Star::Line,
        }
    } else if factor(before.as_bytes().last()) && factor(behind.as_bytes().first()) {
        Star::Product
    } else {
        Star::Slip
    }
}

/// Whether a text begins with digits that a block number may have.
fn begins_block_number(text: &str) -> bool {
    leading_number(text).is_some_and(|(number, _)| number <= HIGHEST_BLOCK)
}
