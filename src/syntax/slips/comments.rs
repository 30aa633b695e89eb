//! Comments: with quotes missing, typographic quotes, or in the manner of other controls.

use super::swallowed;
use super::{Around, Diagnosis, write};
use crate::diag::{Certain, Diagnostic, Edit, Finding, FixTitle, Meant, QuoteMeant, shown};
use crate::dict::Address;
use crate::sure::{Sure, small};
use crate::syntax::tokens::{Kind, Shape, Token, tokens};
use crate::text::Span;

/// The typographic quotes (LEX-12).
const TYPOGRAPHIC: [char; 3] = ['“', '”', '„'];

/// `"text"`; without its second quote it may swallow words (LEX-6).
pub(super) fn quoted(around: &Around<'_>) -> Option<Diagnosis> {
    let [token] = around.next([Kind::Comment])?;
    let span = token.span();
    let diagnosis = Diagnosis { comments: vec![span], ..Diagnosis::of(1) };
    // A quote that closes a comment which nothing opens has a finding.
    if around.quotes_off.is_some_and(|end| span.start < end) {
        return Some(diagnosis);
    }
    let swallows = |words: Span, meant: QuoteMeant| {
        let shown_words = shown(around.slice(words).trim_end());
        around.diagnostic(words, Finding::CommentSwallowsWords { words: shown_words, meant })
    };
    let text = around.slice(span);
    if let Some(inner) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
        let digit = inner.starts_with(|first: char| first.is_ascii_digit());
        let letter = around.previous().filter(|before| before.kind == Kind::Letter && before.end == span.start);
        let words = in_number(around, token);
        let off = if digit && (words.is_some() || letter.is_some()) { is_odd(around, span.start) } else { None };
        // The finding of a text behind it says it.
        let rest = around.tokens.get(around.at..).unwrap_or_default();
        let mut line = rest.iter().take_while(|token| token.kind != Kind::LineEnd);
        if off.is_none() || letter.is_none() && line.any(|token| token.kind == Kind::Junk(Shape::Text)) {
            return Some(diagnosis);
        }
        return Some(Diagnosis {
            found: words.map(|words| swallows(words, QuoteMeant::Number)),
            quotes_off: off,
            ..diagnosis
        });
    }
    let beside = around.previous().filter(|before| !matches!(before.kind, Kind::LineEnd | Kind::Comment));
    let found = match swallowed::swallowed_words(around.text, span) {
        Some(words) if around.byte(words.start).is_ascii_digit() => Some(swallows(words, QuoteMeant::Number)),
        Some(words) => Some(swallows(words, QuoteMeant::Closed)),
        // `M06 D16"`: the quote that opens the comment is missing, or this one is a slip.
        None if text.trim_end() == "\"" && beside.is_some() => Some(swallows(span, QuoteMeant::Empty)),
        None => None,
    };
    Some(Diagnosis { found, ..diagnosis })
}

/// Nobody writes a longer line: so far is looked around for quotes.
const LONGEST: usize = 240;

/// The end of the line, if an odd number of quotes follows in it.
fn is_odd(around: &Around<'_>, from: u32) -> Option<u32> {
    let rest = around.text.get(from as usize..)?;
    let (mut quotes, mut end) = (0, rest.len());
    for (at, character) in rest.char_indices() {
        if matches!(character, '\r' | '\n') {
            end = at;
            break;
        }
        if at > LONGEST {
            return None;
        }
        quotes += usize::from(character == '"' || TYPOGRAPHIC.contains(&character));
    }
    (quotes % 2 == 1).then_some(from + small(end))
}

/// Whether another quote is on the line: it may be one too many, or swallow what stands before the comment.
fn is_beside_quote(around: &Around<'_>, span: Span) -> bool {
    let in_line = |character: &char| !matches!(character, '\r' | '\n');
    let before = around.text.get(..span.start as usize).sure().chars().rev().take(LONGEST).take_while(in_line);
    let behind = around.text.get(span.end as usize..).sure().chars().take(LONGEST).take_while(in_line);
    before.chain(behind).any(|character| character == '"')
}

/// One finding for the quotes of a comment, at the first (LEX-12).
pub(super) fn typographic(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::TypographicComment)?.span();
    let text = around.slice(span);
    let edit = |(at, quote): (usize, char)| {
        let start = span.start + small(at);
        Edit { at: around.place(Span::new(start, start + small(quote.len_utf8()))), text: "\"".to_owned() }
    };
    let quotes = text.char_indices().filter(|(_, character)| TYPOGRAPHIC.contains(character));
    let edits: Vec<Edit> = quotes.map(edit).collect();
    let (quote, first) = (text.chars().next()?, edits.first()?.at.span);
    // A plain quote may be that of the next comment.
    let (alone, plain) = (edits.len() == 1, text.ends_with('"'));
    let off = if alone && plain { is_odd(around, span.start) } else { None };
    let behind = Span::new(first.end, span.end - u32::from(plain));
    if alone && is_in_number(around, first, behind) {
        let found = around.diagnostic(first, Finding::TypographicQuote { quote, meant: QuoteMeant::Number });
        return Some(Diagnosis { quotes_off: off, ..broken_number(around, found, first, behind) });
    }
    let found = around.diagnostic(first, Finding::TypographicQuote { quote, meant: QuoteMeant::Plain });
    let diagnosis = Diagnosis { comments: vec![span], quotes_off: off, ..Diagnosis::saying(1, found) };
    if off.is_some() {
        return Some(diagnosis);
    }
    // A comment that nothing closes may have swallowed words.
    let certain = (!alone || plain || swallowed::is_text(around.text, behind)) && !is_beside_quote(around, span);
    let found =
        diagnosis.found.map(|found| found.with_edits(certain.then_some(Certain::Quotes), FixTitle::PlainQuotes, edits));
    Some(Diagnosis { found, ..diagnosis })
}

/// `(text)`, `; text`, `{text}`, `// text`, `# text`: a comment as other controls write it.
pub(super) fn foreign(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::ForeignComment)?.span();
    let text = around.slice(span);
    let inner = if text.starts_with("//") {
        text.trim_start_matches('/')
    } else {
        text.trim_start_matches(['(', '{', '\'', '`', ';', '#', ','])
    };
    let opening = Span::new(span.start, span.end - small(inner.len()));
    let body = if text.starts_with("''") || text.starts_with(",,") {
        inner.trim_end_matches(['\'', ',', '"'])
    } else {
        let closed = inner.ends_with([')', '}', '\'', '`']) && !text.starts_with([';', '#', '/']);
        inner.get(..inner.len() - usize::from(closed)).sure()
    };
    let start = opening.end + small(body.len() - body.trim_start_matches([' ', '\t']).len());
    let kept = body.trim_matches([' ', '\t']);
    let inside = Span::new(start, start + small(kept.len()));
    if is_in_number(around, opening, inside) {
        return Some(broken_number(around, around.characters(span, Meant::Number), opening, inside));
    }
    let words = swallowed::words_between(around.text, inside);
    let closed = text.ends_with([')', '}', '\'', '`', '"']);
    let swallowed = swallowed::words(around.text, inside).filter(|_| !closed && words.is_none());
    let place = around.place(span);
    let edit = |from: u32, to: u32, text: &str| Edit { at: around.place(Span::new(from, to)), text: text.to_owned() };
    let quotes = || vec![edit(span.start, inside.start, "\""), edit(inside.end, span.end, "\"")];
    let comment = || around.characters(span, Meant::Comment);
    let Some(words) = words.filter(|_| !kept.is_empty()) else {
        let plain = swallowed::is_text(around.text, inside);
        let found = if let Some(swallowed) = swallowed {
            around.characters(span, Meant::CommentBefore { words: shown(around.slice(swallowed).trim_end()) })
        } else if body.trim().is_empty() {
            comment().with_offer(FixTitle::Delete { text: shown(text) }, place, "")
        } else if body.contains('"') {
            comment()
        } else {
            // A quote without a second one behind it may have lost that before the text.
            let skip = around.previous().is_some_and(|before| before.kind == Kind::Skip && before.end == span.start);
            let certain = text.starts_with(['(', ';']) && plain && !skip && !is_beside_quote(around, span);
            comment().with_edits(certain.then_some(Certain::Comment), FixTitle::Comment, quotes())
        };
        let words = tokens(around.text, inside.start, inside.end).filter(|token| token.kind == Kind::Word && !plain);
        return Some(unknown(around, Diagnosis::saying(1, found).debris(), words));
    };
    // `; Z50`, `(Z50)`: the border of a block on other controls, or a comment. `G7; L100`: a slip.
    let apart = kept.replace(';', " ").trim_end().to_owned();
    let meant = Meant::CommentOrWords { words: shown(&apart), comment: shown(&kept.replace('"', "")) };
    // Only signs are written: letters of a comment among the words keep their bytes.
    let signs = kept.match_indices(';').map(|(at, _)| start + small(at)).map(|at| edit(at, at + 1, " "));
    let edits = [edit(span.start, inside.start, ""), edit(inside.end, span.end, "")];
    let edits = edits.into_iter().filter(|edit| !edit.at.span.is_empty()).chain(signs).collect();
    let found = around.characters(span, meant).with_offers(write(&apart), edits);
    let found = if body.contains('"') { found } else { found.with_offers(FixTitle::Comment, quotes()) };
    Some(unknown(around, Diagnosis::saying(1, found).debris().junk(opening), words))
}

/// The text of a comment that opens within a number: `X1"0 Y5 "konec"`.
pub(super) fn in_number(around: &Around<'_>, comment: Token) -> Option<Span> {
    let inside = Span::new(comment.start + 1, comment.end - 1);
    divides(around, Span::new(comment.start, inside.start)).then_some(inside)
}

/// Whether another sign than a point is within a number: `Y10;5 F300`, `S12(00`, `X1“0 Y2`. Behind a block number a
/// remark may begin with a number.
fn is_in_number(around: &Around<'_>, sign: Span, behind: Span) -> bool {
    let is_word = |before: Token| around.address(before) != Some(Address::N);
    divides(around, sign)
        && around.previous().is_some_and(|before| is_word(before) || swallowed::goes_on(around.text, behind))
}

/// Whether digits are on both sides of a sign.
fn divides(around: &Around<'_>, sign: Span) -> bool {
    around.is_behind_digit(sign.start) && around.byte(sign.end).is_ascii_digit()
}

/// Neither the number that `sign` divides is known, nor the words of what follows.
fn broken_number(around: &Around<'_>, found: Diagnostic, sign: Span, behind: Span) -> Diagnosis {
    let words = tokens(around.text, behind.start, behind.end).filter(|token| token.kind == Kind::Word);
    unknown(around, Diagnosis::saying(1, found).debris().junk(sign), words)
}

/// Leaves the words without values.
fn unknown(around: &Around<'_>, diagnosis: Diagnosis, words: impl IntoIterator<Item = Token>) -> Diagnosis {
    words.into_iter().fold(diagnosis, |diagnosis, word| match around.address(word) {
        Some(address) if address != Address::N => diagnosis.void(address, word.span()),
        _ => diagnosis,
    })
}
