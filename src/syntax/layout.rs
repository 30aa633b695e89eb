//! Checks by lines and characters: length, case, and text behind the end.

use super::{Kind, Shape, tokens};
use crate::diag::{AfterEndMeant, Certain, Diagnostic, Edit, Finding, Findings, FixTitle, shown};
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, SourceText, Span};

/// Most characters of a line (LEX-7).
const LINE: usize = 80;

/// Reports lines of more than 80 characters, from that of `start` to that of `end`, of which only what stands before
/// `end` counts (LEX-7).
pub(super) fn check_lines(file: FileId, source: &SourceText, start: u32, end: u32, findings: &mut Findings) {
    let lines = source.lines();
    let first = lines.line_at(start);
    let last = lines.line_at(end);
    for line in first..=last {
        let (Some(from), to) = (lines.start(line), lines.start(line + 1).unwrap_or(end).min(end)) else { continue };
        if to.saturating_sub(from) as usize <= LINE {
            continue;
        }
        let span = Span::new(from, source.line_span(line).end.min(end));
        let text = source.slice(span);
        let Some((at, character)) = text.char_indices().nth(LINE) else { continue };
        let start = from + small(at);
        let span = Span::new(start, start + u32::try_from(character.len_utf8()).unwrap_or(1));
        let length = text.chars().count();
        findings.add(Diagnostic::new(Finding::LineTooLong { length }, Location { file, span }));
    }
}

/// Reports a file in UTF-16, with a fix that writes all of it in UTF-8 where that loses nothing (LEX-13).
pub(super) fn report_utf16(file: FileId, source: &SourceText, findings: &mut Findings) {
    let at = |span: Span| Location { file, span };
    let text = source.text().get(source.first_offset() as usize..).sure();
    let diagnostic = Diagnostic::new(Finding::Utf16 {}, at(Span::empty(source.first_offset())));
    // Where bytes are no character, the text would lose them. With zeros in it the file is in UTF-32 or something else,
    // and in UTF-8 it could pass for UTF-16 again.
    findings.add(match source.is_exact() && !text.contains('\0') {
        true => diagnostic.with_fix(Certain::Utf16, FixTitle::Utf8, at(Span::new(0, source.len())), text),
        false => diagnostic,
    });
}

/// Where the text ends that is read: before a trailing run of blanks and line ends that holds a Ctrl-Z or NUL (LEX-8).
pub(super) fn end_of_text(text: &str) -> u32 {
    let kept = text.trim_end_matches(['\u{1a}', '\0', ' ', '\t', '\r', '\n']);
    let run = text.get(kept.len()..).sure();
    let end = if run.contains(['\u{1a}', '\0']) { kept.len() } else { text.len() };
    small(end)
}

/// The finding at the first line after `*` that is no comment (LEX-9). A `%` there begins a second program.
pub(super) fn text_after_end(file: FileId, text: &str, after: u32, end: u32) -> Option<Diagnostic> {
    let is_text = |kind: Kind| !matches!(kind, Kind::Comment | Kind::Junk(Shape::TypographicComment) | Kind::LineEnd);
    let mut rest = tokens(text, after, end).skip_while(|token| !is_text(token.kind));
    let first = rest.next()?;
    let last = rest.by_ref().take_while(|token| is_text(token.kind)).last().unwrap_or(first);
    let span = first.span().to(last.span());
    let starts = |start: u32| text.as_bytes().get(start as usize) == Some(&b'%');
    let program = starts(first.start) || rest.take(FAR).any(|token| starts(token.start));
    // `R50=R50*2`: nothing but the star is between two factors.
    let factor = |at: Option<&u8>| at.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'R' | b'[' | b']'));
    let before = text.get(..(after as usize).saturating_sub(1)).sure().trim_end_matches([' ', '\t']);
    let product =
        first.start == after && factor(before.as_bytes().last()) && factor(text.as_bytes().get(first.start as usize));
    // `*** KONTURA ***`
    let line = text.get(first.start as usize..end as usize).sure();
    let line = line.split(['\n', '\r']).next().sure().trim_end_matches([' ', '\t']);
    let separator = first.start == after && line.starts_with('*');
    let meant = match (program, product) {
        (true, _) => AfterEndMeant::Program,
        (false, _) if separator => AfterEndMeant::Separator { line: shown(&format!("*{line}").replace('"', "")) },
        (false, true) => AfterEndMeant::Product,
        (false, false) => AfterEndMeant::Text,
    };
    Some(Diagnostic::new(Finding::TextAfterEnd { meant }, Location { file, span }))
}

/// So many tokens behind `*` are looked at for a second program.
const FAR: usize = 1 << 12;

/// The finding of lower-case addresses, one for all of them (LEX-11): `places` are theirs, `addresses` counts those of
/// the file. Changing them all is certain where they are the rule; a few of them may stand for something else, as in
/// `X18y.924`.
pub(super) fn case_finding(file: FileId, text: &str, places: &[u32], addresses: usize) -> Option<Diagnostic> {
    let edit = |&place: &u32| {
        let letter = text.as_bytes().get(place as usize).copied().unwrap_or(b'?');
        let at = Location { file, span: Span::new(place, place + 1) };
        Edit { at, text: char::from(letter.to_ascii_uppercase()).to_string() }
    };
    let edits: Vec<Edit> = places.iter().map(edit).collect();
    let first = edits.first().map(|edit| edit.at)?;
    let finding = Finding::LowercaseAddress { count: edits.len() };
    let certain = (edits.len() * 2 > addresses).then_some(Certain::LowerCase);
    Some(Diagnostic::new(finding, first).with_edits(certain, FixTitle::UpperCase, edits))
}
