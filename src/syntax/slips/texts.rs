//! Text that is no comment: remarks, messages, statements of other controls, units.

use super::{Around, Diagnosis};
use super::{comments, swallowed};
use crate::diag::{Edit, Finding, FixTitle, Meant, TextMeant, shown};
use crate::dict::{Address, GCode};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, METRES_PER_MINUTE, Shape, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// Text that is no comment, with the numbers in it. `!vyjet`: signs right before it belong to it.
pub(super) fn stray(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let signs = next.one(Kind::Junk(Shape::Unknown));
    let first = next.one(Kind::Junk(Shape::Text)).filter(|text| signs.is_none_or(|signs| signs.end == text.start))?;
    let part = |kind| {
        matches!(
            kind,
            Kind::Number
                | Kind::Equals
                | Kind::Sign
                | Kind::Junk(
                    Shape::Text
                        | Shape::Unit
                        | Shape::LooseNumber
                        | Shape::Unknown
                        | Shape::ForeignComment
                        | Shape::Bracketed
                )
        )
    };
    let last = std::iter::from_fn(|| next.when(part)).last().unwrap_or(first);
    let span = signs.unwrap_or(first).span().to(last.span());
    let diagnosis = Diagnosis::of(next.taken).debris();
    if let Some(message) = message(around, span) {
        return Some(Diagnosis { found: Some(message), ..diagnosis });
    }
    if around.quotes_off.is_some_and(|end| span.start < end) {
        return Some(diagnosis);
    }
    if let Some((found, quotes_off)) = beside_quote(around, span) {
        return Some(Diagnosis { found: Some(found), quotes_off, ..diagnosis });
    }
    let text = around.slice(span);
    let shown_text = shown(text);
    // Words behind it on its line are executed, whatever becomes of the text.
    let behind = swallowed::words_behind(around.text, span.end);
    let words = behind.map(|words| shown(around.slice(words).trim_end()));
    let statement = TextMeant::statement(text);
    if statement.is_none() && !text.is_ascii() {
        let meant = words.map_or(Meant::Comment, |words| Meant::CommentBefore { words });
        return Some(Diagnosis { found: Some(around.characters(span, meant)), ..diagnosis });
    }
    let diagnosis = statement.as_ref().map_or(diagnosis, |meant| {
        let word = |diagnosis: Diagnosis, word: Word| diagnosis.with(word, span);
        set_by_statement(around, meant, span).into_iter().fold(Diagnosis::of(next.taken).debris(), word)
    });
    let address = addressed(text);
    let meant = statement.unwrap_or_else(|| match (words, behind) {
        _ if let Some(address) = address => TextMeant::Addressed { address, text: shown_text.clone() },
        (Some(words), Some(behind)) => {
            let all = shown(around.slice(span.to(behind)).trim_end());
            TextMeant::WithWords { text: shown_text.clone(), words, all }
        }
        _ => TextMeant::Comment { text: shown_text.clone() },
    });
    let found = around.diagnostic(span, Finding::StrayText { text: shown_text, meant });
    let needed = address.filter(|address| is_needed(around, *address));
    let diagnosis = needed.into_iter().fold(diagnosis, |diagnosis, word| diagnosis.void(word, span));
    Some(Diagnosis { found: Some(found), ..diagnosis })
}

/// `Xp`: an address with a letter in place of its number.
fn addressed(text: &str) -> Option<Address> {
    let &[first, _] = text.as_bytes() else { return None };
    Address::from_byte(first)
}

/// Whether a word of the address was probably meant: an axis, or what a function of the block needs: `G71 LX`, `G04
/// QX`, `G02 X5 IX`.
fn is_needed(around: &Around<'_>, address: Address) -> bool {
    let centre = matches!(address, Address::I | Address::J);
    let takes = |code: GCode| {
        address == Address::L && code.takes_l()
            || address == Address::Q && code == GCode::G04
            || centre && matches!(code, GCode::G02 | GCode::G03)
    };
    address.axis().is_some() || around.functions().any(takes)
}

/// `MSG("text")`
fn message(around: &Around<'_>, span: Span) -> Option<crate::diag::Diagnostic> {
    let text = around.slice(span);
    let inner = text.strip_prefix("MSG")?.trim_start_matches([' ', '\t']).strip_prefix("(\"")?.strip_suffix("\")")?;
    let end = span.end - 2;
    let start = end - small(inner.len());
    let quote = |from: u32, to: u32| Edit { at: around.place(Span::new(from, to)), text: "\"".to_owned() };
    let found = around.diagnostic(span, Finding::StrayText { text: shown(text), meant: TextMeant::Message });
    let edits = vec![quote(span.start, start), quote(end, span.end)];
    (!inner.contains('"')).then(|| found.with_offers(FixTitle::Comment, edits))
}

/// The words that a statement would set: parameters, `FOR R1=1 TO 5`; a call, `CALL L100`; the end.
fn set_by_statement(around: &Around<'_>, meant: &TextMeant, span: Span) -> Vec<Word> {
    let text = around.slice(span);
    let target = |(at, _): (usize, &str)| {
        let (before, behind) = text.split_at_checked(at)?;
        let name = before.trim_end_matches([' ', '\t']);
        let letters = name.trim_end_matches(|last: char| last.is_ascii_digit());
        // `==` compares.
        let assigns = letters.ends_with(['R', 'r', '#']) && !behind.starts_with("==");
        grammar::parameter_number(name.get(letters.len()..)?).filter(|_| assigns)
    };
    let targets = text.match_indices('=').filter_map(target);
    let mut words: Vec<Word> = targets.map(|target| Word::bare(Address::R, span).assigning(target)).collect();
    if *meant == TextMeant::Call {
        let (_, name) = text.split_once([' ', '\t']).unwrap_or_default();
        let digits = name.trim_start_matches([' ', '\t']).strip_prefix(['L', 'l']).unwrap_or_default();
        let count = digits.bytes().take_while(u8::is_ascii_digit).count();
        let number = digits.get(..count).and_then(|digits| Number::parse(digits.as_bytes()));
        words.extend(number.map(|number| Word::with_number(Address::L, span, number)));
    } else if *meant == TextMeant::End {
        words.push(Word::bare(Address::M, span));
    } else if *meant == TextMeant::Return {
        words.push(Word::bare(Address::G, span));
    }
    words
}

/// A text beside a quote that is one of an odd number: the quote before it is missing, or one within the comment
/// before. Gives the end of the line whose other quotes are off by one too.
fn beside_quote(around: &Around<'_>, span: Span) -> Option<(crate::diag::Diagnostic, Option<u32>)> {
    let text = around.slice(span);
    let rest = around.text.get(span.end as usize..).sure();
    let length = |text: &str| small(text.len());
    let before = around.previous().filter(|before| before.kind == Kind::Comment && before.end == span.start);
    let before = before.filter(|before| before.end - before.start > 2 && around.byte(before.end - 1) == b'"');
    let inside = before.map(|before| Span::new(before.start + 1, before.end - 1));
    // `T2" M6 "vrtak"`: a quote too many made a comment of words, and of nothing else.
    let whole = inside.filter(|inside| swallowed::only_words(around.text, *inside).is_some());
    let swallowed = whole.or_else(|| inside.and_then(|inside| swallowed::words(around.text, inside)));
    let off = || Some(span.end + length(rest.split(['\r', '\n']).next().sure()));
    let ascii = text.is_ascii();
    let (finding, missing) = if let Some(words) = swallowed {
        let start = words.start;
        let words = shown(around.slice(words).trim_matches([' ', '\t']));
        let finding = match ascii {
            true => Finding::StrayText { text: shown(text), meant: TextMeant::SwallowedBefore { words } },
            false => Finding::UnknownCharacter { text: shown(text), meant: Meant::SwallowedBefore { words } },
        };
        (finding, start)
    } else {
        let behind = rest.strip_prefix('"')?;
        let inner = behind.split(['"', '\r', '\n']).next().sure();
        let after = behind.trim_start_matches([' ', '\t']);
        let ends = after.is_empty() || after.starts_with(['\r', '\n']);
        let inner = Span::new(span.end + 1, span.end + 1 + length(inner));
        if !ends && swallowed::words(around.text, inner).is_none() {
            return None;
        }
        if let Some(inside) = before.and_then(|before| comments::in_number(around, before)) {
            let words = shown(around.slice(inside).trim_end());
            let finding = match ascii {
                true => Finding::StrayText { text: shown(text), meant: TextMeant::InNumber { words } },
                false => Finding::UnknownCharacter { text: shown(text), meant: Meant::Comment },
            };
            return Some((around.diagnostic(span, finding), off()));
        }
        let finding = match ascii {
            true => Finding::StrayText { text: shown(text), meant: TextMeant::OpenQuote { text: shown(text) } },
            false => Finding::UnknownCharacter { text: shown(text), meant: Meant::OpenQuote { text: shown(text) } },
        };
        (finding, behind_gap(around, span.start))
    };
    let found = around.diagnostic(span, finding);
    let quote = "\"".to_owned();
    let found = match whole {
        Some(inside) => {
            let place = around.place(Span::new(inside.start - 1, inside.start));
            found.with_offer(FixTitle::Delete { text: quote }, place, "")
        }
        None => found.with_offer(FixTitle::Insert { text: quote }, around.place(Span::empty(missing)), "\""),
    };
    Some((found, off()))
}

/// Blanks in a row that set a comment apart from words.
const GAP: &str = "   ";

/// Where a comment begins whose text is at `at`: behind a gap in the line, `X5      D45 roughing"`, else there.
fn behind_gap(around: &Around<'_>, at: u32) -> u32 {
    let before = around.text.get(..at as usize).sure();
    let line = before.rsplit(['\r', '\n']).next().sure();
    let gap = line.rfind(GAP).filter(|gap| !line.get(..*gap).sure().trim_start().is_empty());
    gap.map_or(at, |gap| at - small(line.get(gap..).sure().trim_start().len()))
}

/// The name of a unit behind a number: `F300mm/min`.
pub(super) fn unit(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::Unit)?.span();
    let text = shown(around.slice(span));
    let own = !text.eq_ignore_ascii_case(METRES_PER_MINUTE);
    let meant = if own { TextMeant::Unit } else { TextMeant::OtherUnit };
    let found = around.diagnostic(span, Finding::StrayText { text: text.clone(), meant });
    let found = if own { found.with_offer(FixTitle::Delete { text }, around.place(span), "") } else { found };
    Some(Diagnosis::saying(1, found).debris())
}

/// Statements of other controls: what follows one on its line belongs to it.
const STATEMENTS: [&str; 41] = [
    "IF", "ELSE", "ELSEIF", "ENDIF", "WHILE", "ENDWHILE", "FOR", "ENDFOR", "LOOP", "ENDLOOP", "REPEAT", "REPEATB",
    "UNTIL", "CASE", "END", "GOTO", "GOTOB", "GOTOF", "GOTOC", "GOTOS", "CALL", "EXTCALL", "PCALL", "MCALL", "RET",
    "TRANS", "ATRANS", "TOOL", "CYCL", "PROC", "DEF", "FN", "LBL", "CC", "STOPRE", "ROT", "AROT", "MIRROR", "AMIRROR",
    "SCALE", "ASCALE",
];
/// A comment has so many bytes at most: a line has 80 characters.
const COMMENT: usize = 240;
/// A remark has a word of so many letters.
const REMARK: usize = 3;

/// Where the text ends that begins with a token: a statement of other controls, such as `IF[#1 GT 5]GOTO 20`, a line of
/// text that begins with signs or a number, such as `--- OBRYS ---`, or a comment without its first quote. It ends
/// before a comment, or with its line.
pub(in crate::syntax) fn statement_end(bytes: &[u8], token: Token) -> Option<u32> {
    if matches!(
        token.kind,
        Kind::Word | Kind::LineEnd | Kind::Comment | Kind::Junk(Shape::TypographicComment) | Kind::Skip
    ) {
        return None;
    }
    let rest = bytes.get(token.start as usize..)?;
    if !is_of_parameter(bytes, token)
        && let Some(length) = before_lone_quote(rest, token.kind)
    {
        return Some(token.start + small(length));
    }
    let begins = rest.first()?.is_ascii_alphabetic();
    let is_text = if begins { is_statement(rest) } else { is_remark(bytes, token) };
    if !is_text && !is_sentence(bytes, token) {
        return None;
    }
    let line = rest.iter().take_while(|byte| !matches!(byte, b'\n' | b'\r' | b'"')).count();
    let text = rest.get(..line)?.trim_ascii_end();
    Some(token.start + small(text.len()))
}

/// Whether a token belongs to a word with a parameter: `XR1`, what follows the number in `R1 = 5`.
fn is_of_parameter(bytes: &[u8], token: Token) -> bool {
    let (before, rest) = bytes.split_at_checked(token.start as usize).sure();
    let end = rest.iter().take(COMMENT).take_while(|byte| !matches!(byte, b'"' | b'\n' | b'\r')).count();
    let line = rest.get(..end).sure();
    if matches!(line, [b'A'..=b'Z', b'R', digit, ..] if digit.is_ascii_digit()) {
        return !line.contains(&b'=');
    }
    let before = before.trim_ascii_end();
    let digits = before.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
    let parameter = digits > 0 && before.get(..before.len() - digits).sure().ends_with(b"R");
    let value = line.strip_prefix(b"=").unwrap_or_default().trim_ascii_start();
    let number = value.first().is_some_and(|byte| byte.is_ascii_digit() || b"+-.R".contains(byte));
    before.ends_with(b"=") || token.kind == Kind::Equals && parameter && number
}

/// How long the text is that begins there and ends with a quote at the end of its line, which nothing opens.
fn before_lone_quote(rest: &[u8], kind: Kind) -> Option<usize> {
    let begins = matches!(
        kind,
        Kind::Junk(Shape::Text)
            | Kind::Letter
            | Kind::Junk(Shape::ManySigns)
            | Kind::Equals
            | Kind::Junk(Shape::BareR)
            | Kind::Sign
            | Kind::Number
            | Kind::Junk(Shape::LooseNumber)
            | Kind::Junk(Shape::Unknown)
    );
    // The first `%` begins the program, wherever it stands: a quote before it is not read.
    if !begins || rest.starts_with(b"%") {
        return None;
    }
    let length = rest.iter().take(COMMENT).position(|byte| matches!(byte, b'"' | b'\n' | b'\r'))?;
    let (text, quote) = rest.split_at(length);
    let behind = quote.strip_prefix(b"\"")?;
    let ends = matches!(behind.iter().find(|byte| !matches!(byte, b' ' | b'\t')), None | Some(b'\n' | b'\r'));
    (ends && has_words(text)).then_some(length)
}

/// Whether a text has words of a language, of two letters or more, and no block number but at its end.
fn has_words(text: &[u8]) -> bool {
    let is_letter = |byte: &u8| byte.is_ascii_alphabetic() || !byte.is_ascii();
    let (mut rest, mut words) = (text, false);
    while let Some(start) = rest.iter().position(is_letter) {
        rest = rest.get(start..).sure();
        let letters = rest.iter().take_while(|byte| is_letter(byte)).count();
        let (word, behind) = rest.split_at(letters);
        // `N30`; `XR1` is an address with a parameter. `skok na N30` names a block.
        let value = behind.first().is_some_and(u8::is_ascii_digit);
        let ends = behind.iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b' ' | b'\t'));
        if value && matches!(word, [b'N' | b'n']) {
            return words && ends;
        }
        words |= letters > 1 && !(value && matches!(word, [_, b'R' | b'r']));
        rest = behind;
    }
    words
}

/// Whether a statement begins there.
fn is_statement(rest: &[u8]) -> bool {
    let letters = rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let (name, behind) = rest.split_at(letters);
    // `IF=5` is a value with a name.
    let value = behind.trim_ascii_start().first() == Some(&b'=');
    !value && STATEMENTS.iter().any(|statement| statement.as_bytes().eq_ignore_ascii_case(name))
}

/// So many words of a language make a sentence, whatever else is in it.
const SENTENCE: usize = 3;

/// Whether a sentence begins there, with a line or behind a quote: at least three words of more than two letters.
fn is_sentence(bytes: &[u8], token: Token) -> bool {
    let before = bytes.get(..token.start as usize).sure();
    let before = before.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t'));
    let begins = matches!(before, None | Some(b'\n' | b'\r' | b'"'));
    if !begins || matches!(token.kind, Kind::Sign | Kind::Equals) {
        return false;
    }
    let rest = bytes.get(token.start as usize..).sure();
    let line = rest.iter().take(COMMENT).take_while(|byte| !matches!(byte, b'\n' | b'\r' | b'"')).count();
    let is_word = |word: &&[u8]| {
        let letters = word.iter().take_while(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii()).count();
        letters >= REMARK && word.get(letters).is_none_or(|byte| b",.:;!?".contains(byte))
    };
    rest.get(..line).sure().split(|byte| matches!(byte, b' ' | b'\t')).filter(is_word).count() >= SENTENCE
}

/// Whether a line that begins with signs or a number is text: its first letters are a word of some length.
fn is_remark(bytes: &[u8], token: Token) -> bool {
    let plain = matches!(
        token.kind,
        Kind::Sign
            | Kind::Equals
            | Kind::Number
            | Kind::Junk(Shape::LooseNumber)
            | Kind::Junk(Shape::Unknown)
            | Kind::Junk(Shape::Operator)
    );
    let before = bytes.get(..token.start as usize).sure();
    let blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    if !plain || !matches!(before.iter().rev().find(|byte| !blank(byte)), None | Some(b'\n' | b'\r')) {
        return false;
    }
    let rest = bytes.get(token.start as usize..).sure();
    let signs =
        rest.iter().take_while(|byte| byte.is_ascii_digit() || blank(byte) || b"-+=.,)>:!#~_".contains(byte)).count();
    let head = rest.get(..signs).sure();
    let words = rest.get(signs..).sure();
    let letters = words.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let value = words.get(letters).is_some_and(|byte| byte.is_ascii_digit() || b"+-.".contains(byte));
    // `190 KONEC`: the number may be that of a block.
    let numbered = head.trim_ascii_end().iter().all(u8::is_ascii_digit);
    letters >= REMARK && !value && !numbered
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Text that a quote at the end of its line closes. The first `%` begins the program: a quote before it is not
    /// read.
    #[test]
    fn comments_without_their_first_quote() {
        let length = |text: &str, kind: Kind| before_lone_quote(text.as_bytes(), kind);
        assert_eq!(length("vyjezd po oblouku\"\nN20", Kind::Junk(Shape::Text)), Some(17));
        assert_eq!(length("3 x 2 mm\" \t\r\n", Kind::Number), Some(8));
        assert_eq!(length("skok vpred na N150\"\n", Kind::Junk(Shape::Text)), Some(18));
        assert_eq!(length("Freza D20, 3 brity\"", Kind::Junk(Shape::Text)), Some(18));
        for text in [
            "% v komentari\"",
            "vyjezd\" N20 X5",
            "vyjezd \"po\" oblouku",
            "vyjezd\npo\"",
            "5\"",
            "A B C\"",
            "XR1 F100 \"",
            "TAB X100 N30 G0\"",
        ] {
            assert_eq!(length(text, Kind::Letter), None, "{text}");
        }
        assert_eq!(length("X5 vyjezd\"", Kind::Word), None);
    }
}
