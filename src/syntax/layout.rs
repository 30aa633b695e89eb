//! What is judged by lines and characters: their length, case, and what follows the end.

use super::{Kind, tokens};
use crate::diag::{Diagnostic, Edit, Finding, Findings, Fix, FixTitle};
use crate::text::{FileId, Location, SourceText, Span};

/// Most characters of a line (LEX-7).
const LINE: usize = 80;

/// Reports lines of more than 80 characters, from that of `start` to that of `end`, of which only what stands before `end`
/// counts (LEX-7).
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
        let start = from + u32::try_from(at).unwrap_or(0);
        let span = Span::new(start, start + u32::try_from(character.len_utf8()).unwrap_or(1));
        let length = text.chars().count();
        findings.add(Diagnostic::new(Finding::LineTooLong { length }, Location { file, span }));
    }
}

/// Where the text ends that is read: before a trailing run of blanks and line ends that holds a Ctrl-Z or NUL (LEX-8).
pub(super) fn end_of_text(text: &str) -> u32 {
    let kept = text.trim_end_matches(['\u{1a}', '\0', ' ', '\t', '\r', '\n']);
    let run = text.get(kept.len()..).unwrap_or_default();
    let end = if run.contains(['\u{1a}', '\0']) { kept.len() } else { text.len() };
    u32::try_from(end).unwrap_or(u32::MAX)
}

/// Reports the first line of what stands after `*` and is no comment (LEX-9).
pub(super) fn check_after_end(file: FileId, text: &str, after: u32, end: u32, findings: &mut Findings) {
    let is_text = |kind: Kind| !matches!(kind, Kind::Comment | Kind::TypographicComment | Kind::LineEnd);
    let mut rest = tokens(text, after, end).skip_while(|token| !is_text(token.kind));
    if let Some(first) = rest.next() {
        let last = rest.take_while(|token| is_text(token.kind)).last().unwrap_or(first);
        let span = first.span().to(last.span());
        findings.add(Diagnostic::new(Finding::TextAfterEnd {}, Location { file, span }));
    }
}

/// Reports lower-case addresses, once, with a fix of them all (LEX-11). Called when there is one.
pub(super) fn check_case(file: FileId, text: &str, start: u32, end: u32, findings: &mut Findings) {
    let mut edits = Vec::new();
    for token in tokens(text, start, end) {
        if token.kind == Kind::End {
            break;
        }
        let has_address = matches!(
            token.kind,
            Kind::Word
                | Kind::Parameter
                | Kind::Letter
                | Kind::BareR
                | Kind::SignedLetter
                | Kind::LooseWord
                | Kind::LooseParameter
        );
        let letter = text.as_bytes().get(token.start as usize).copied().unwrap_or(0);
        if has_address && letter.is_ascii_lowercase() {
            let at = Location { file, span: Span::new(token.start, token.start + 1) };
            edits.push(Edit { at, text: char::from(letter.to_ascii_uppercase()).to_string() });
        }
    }
    if let Some(first) = edits.first().map(|edit| edit.at) {
        let mut diagnostic = Diagnostic::new(Finding::LowercaseAddress { count: edits.len() }, first);
        diagnostic.fixes.push(Fix { title: FixTitle::UpperCase, edits });
        findings.add(diagnostic);
    }
}
