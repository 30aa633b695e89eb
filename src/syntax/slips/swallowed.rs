//! Words that a comment without closing quote swallows (LEX-6).

use crate::sure::{Sure, small};
use crate::syntax::grammar;
use crate::syntax::tokens::{Kind, Shape, Token, tokens};
use crate::text::Span;

/// So many bytes at the end of a comment are looked at: a line has 80 characters.
const TAIL: u32 = 240;
/// So many words are more than a remark such as `viz N30`.
const LEAST: usize = 2;

/// Where words of a block end the text of a comment that no quote closes, if there are two or more, one of them N, G, M
/// or an axis.
pub(super) fn words(text: &str, comment: Span) -> Option<Span> {
    let mut start = comment.start.max(comment.end.saturating_sub(TAIL));
    while !text.is_char_boundary(start as usize) {
        start += 1;
    }
    let tail = as_fixed(text.get(start as usize..comment.end as usize)?);
    // Where it begins with words, a comment may follow them, as other controls write it.
    let whole = |words: &Span| tail.get(..words.start as usize).sure().trim().is_empty() && start == comment.start;
    let before_comment = || at_end(tail.get(..tail.find(['(', ';'])?)?).filter(whole);
    let found = at_end(&tail).or_else(before_comment)?;
    Some(Span::new(start + found.start, start + found.end))
}

/// The words that end a text.
fn at_end(text: &str) -> Option<Span> {
    let text = text.trim_end_matches([' ', '\t', ',', ';', '-', '+']);
    // A sign that was meant to close the comment ends its text.
    let closed = text.rmatch_indices(['“', '”', '\'', ';']).next().map_or(0, |(at, sign)| at + sign.len());
    let tokens: Vec<Token> = tokens(text, small(closed), small(text.len())).collect();
    // Behind a typographic quote one word is enough: it was meant to close the comment.
    let typographic = text.get(..closed).is_some_and(|before| before.ends_with(['“', '”']));
    let least = if typographic { 1 } else { LEAST };
    let ends = |from: usize| telling(text, tokens.get(from..).sure(), least, None) == Some(true);
    let from = (0..tokens.len()).find(|from| ends(*from))?;
    Some(Span::new(tokens.get(from)?.start, tokens.last()?.end))
}

/// A text whose words are read as fixes would make them good, each byte in its place: with decimal commas, typographic
/// signs, fixed blanks, blanks behind a sign, letters for digits, `=` behind an address.
fn as_fixed(text: &str) -> String {
    let text = text.replace(['−', '–'], "  -").replace('\u{a0}', "  ");
    let mut bytes = text.into_bytes();
    for at in 0..bytes.len() {
        let byte = |at: Option<usize>| at.and_then(|at| bytes.get(at)).copied().unwrap_or(b' ');
        let (before, here, behind) = (byte(at.checked_sub(1)), byte(Some(at)), byte(Some(at + 1)));
        let alone = before.is_ascii_alphabetic() && !byte(at.checked_sub(2)).is_ascii_alphabetic();
        // `DO X5` is text.
        let begins = alone && matches!(before, b'G' | b'X' | b'Y' | b'Z');
        let in_number = (before.is_ascii_digit() || begins) && behind.is_ascii() && !behind.is_ascii_alphabetic();
        let fixed = match here {
            b',' if before.is_ascii_digit() && behind.is_ascii_digit() => b'.',
            b'O' if in_number => b'0',
            b'l' if in_number => b'1',
            b'=' if alone && !matches!(before, b'R' | b'r') => b' ',
            b'+' | b'-' if matches!(behind, b' ' | b'\t') => {
                let blanks = bytes.iter().skip(at + 1).take_while(|byte| matches!(byte, b' ' | b'\t')).count();
                let number = byte(Some(at + 1 + blanks));
                if number.is_ascii_digit() || matches!(number, b'.' | b'R' | b'r') {
                    bytes.swap(at, at + blanks);
                }
                continue;
            }
            _ => continue,
        };
        if let Some(byte) = bytes.get_mut(at) {
            *byte = fixed;
        }
    }
    String::from_utf8(bytes).unwrap_or_default()
}

/// The words that a comment swallows, which begins with a quote (W0114).
pub fn swallowed_words(text: &str, comment: Span) -> Option<Span> {
    let inner = text.get(comment.range())?.strip_prefix('"')?;
    let inside = Span::new(comment.start + 1, comment.end);
    if inner.ends_with('"') { None } else { rest_of_number(text, inside).or_else(|| words(text, inside)) }
}

/// The rest of a number and the words behind it, where a quote that nothing closes is within the number: `X1"0 Y2`.
fn rest_of_number(text: &str, inside: Span) -> Option<Span> {
    let word = text.get(..inside.start as usize)?.strip_suffix('"').filter(|before| before.ends_with(is_of_number))?;
    let rest = text.get(inside.range())?.trim_end();
    let whole = Span::new(inside.start, inside.start + small(rest.len()));
    if rest.trim_start_matches(is_of_number).is_empty() {
        // `N10"2`, `T5"12`: a remark.
        let letter = word.trim_end_matches(is_of_number).chars().next_back();
        return (!rest.is_empty() && !matches!(letter, Some('N' | 'n' | 'T' | 't'))).then_some(whole);
    }
    let is_number = rest.starts_with(is_of_number);
    let words = words_of_number(text, whole)?;
    let byte = |word: &Token| text.as_bytes().get(word.start as usize).copied().unwrap_or(b' ').to_ascii_uppercase();
    // `T5"D16`: a remark.
    (is_number || words.iter().any(|word| is_telling(byte(word)))).then_some(whole)
}

const fn is_of_number(character: char) -> bool {
    character.is_ascii_digit() || character == '.'
}

/// The words behind the rest of a number, when nothing else is there.
fn words_of_number(text: &str, span: Span) -> Option<Vec<Token>> {
    let inner = text.get(span.range())?.trim_end();
    let behind = inner.trim_start_matches(is_of_number);
    let end = span.start + small(inner.len());
    only_words(text, Span::new(end - small(behind.len()), end)).filter(|words| !words.is_empty())
}

/// Whether a number goes on in `span`, with words behind it.
pub(super) fn goes_on(text: &str, span: Span) -> bool {
    words_of_number(text, span).is_some()
}

/// The words that `span` holds, when nothing but words and comments is in it.
pub(super) fn only_words(text: &str, span: Span) -> Option<Vec<Token>> {
    if span.len() > TAIL {
        return None;
    }
    let mut words: Vec<Token> = tokens(text, span.start, span.end).collect();
    words.retain(|token| token.kind != Kind::Comment);
    telling(text, &words, 1, words.first().map(|first| first.start))?;
    words.retain(|token| matches!(token.kind, Kind::Word | Kind::Letter | Kind::Parameter));
    Some(words)
}

/// The words that `span` holds, as [`only_words`], also with `;` between them.
pub(super) fn words_between(text: &str, span: Span) -> Option<Vec<Token>> {
    let inner = text.get(span.range())?;
    let mut words = Vec::new();
    let mut at = span.start;
    for part in inner.split(';') {
        let end = at + small(part.len());
        if !part.trim().is_empty() {
            words.extend(only_words(text, Span::new(at, end))?);
        }
        at = end + 1;
    }
    Some(words)
}

/// Whether `span` holds a text without a word of a block, so that it is a comment whatever is around it. A number at
/// its beginning may be one that lost its address.
pub(super) fn is_text(text: &str, span: Span) -> bool {
    let inner = text.get(span.range()).sure();
    let begins = inner.chars().find(|character| character.is_alphanumeric()).is_some_and(char::is_alphabetic);
    let is_word = |token: &Token| {
        // `KUS 2`: the lexer may take the last letter for an address.
        let before = text.get(span.start as usize..token.start as usize).sure().chars().next_back();
        !before.is_some_and(char::is_alphabetic)
            && matches!(
                token.kind,
                Kind::Word
                    | Kind::Junk(Shape::LooseWord)
                    | Kind::Parameter
                    | Kind::Junk(Shape::LooseParameter)
                    | Kind::Junk(Shape::PrintedWord)
                    | Kind::Junk(Shape::AssignedWord)
                    | Kind::Junk(Shape::NamedValue)
                    | Kind::Junk(Shape::Variable)
                    | Kind::Junk(Shape::GarbledWord)
                    | Kind::Comment
                    | Kind::Junk(Shape::TypographicComment)
            )
    };
    begins && !has_word(inner) && !tokens(text, span.start, span.end).any(|token| is_word(&token))
}

/// Whether a letter alone stands before something like a number, whatever is around: `Y- 5`, `X O`, `(dira; Y5`.
fn has_word(text: &str) -> bool {
    let characters: Vec<char> = text.chars().collect();
    let at = |at: usize| characters.get(at).copied().unwrap_or(' ');
    (0..characters.len()).any(|place| {
        // Blanks are passed from letters alone: a comment may have a million of them.
        if !at(place).is_ascii_alphabetic() || place.checked_sub(1).is_some_and(|before| at(before).is_alphabetic()) {
            return false;
        }
        let between = |character: &&char| matches!(character, ' ' | '\t' | '\u{a0}' | '+' | '-' | '−' | '–' | '=');
        let number = place + 1 + characters.iter().skip(place + 1).take_while(between).count();
        let behind = at(number + 1);
        match at(number) {
            '0'..='9' => true,
            '.' | ',' | 'R' | 'r' => behind.is_ascii_digit(),
            'O' | 'o' | 'l' => !behind.is_alphabetic(),
            _ => false,
        }
    })
}

/// Where words stand that follow a text on its line, up to a comment or the next block.
pub(super) fn words_behind(text: &str, start: u32) -> Option<Span> {
    let rest = text.as_bytes().get(start as usize..)?;
    let line = rest.iter().take(TAIL as usize).take_while(|byte| !matches!(byte, b'\n' | b'\r')).count();
    let mut end = start + small(line);
    while !text.is_char_boundary(end as usize) {
        end -= 1;
    }
    let is_word = |token: &Token| {
        let letter = text.as_bytes().get(token.start as usize).copied().unwrap_or(b' ');
        matches!(token.kind, Kind::Word | Kind::Letter | Kind::Parameter) && !matches!(letter, b'N' | b'n')
    };
    let mut behind = tokens(text, start, end).take_while(is_word);
    let first = behind.next().filter(|first| first.kind == Kind::Word)?;
    let last = behind.last().unwrap_or(first);
    Some(first.span().to(last.span()))
}

/// Whether one of the words is N, G, M or an axis; `None` where there is anything but words, or fewer than `least`.
/// `end`: where a word may begin without a blank before it.
fn telling(text: &str, tokens: &[Token], least: usize, mut end: Option<u32>) -> Option<bool> {
    let byte = |at: u32| text.as_bytes().get(at as usize).copied().unwrap_or(b' ');
    let (mut at, mut words, mut telling) = (0, 0, false);
    while let Some(first) = tokens.get(at) {
        let apart = first.start.checked_sub(1).is_none_or(|before| matches!(byte(before), b' ' | b'\t' | b'"'));
        if end != Some(first.start) && !apart {
            return None;
        }
        if first.kind == Kind::Skip || words > 0 && first.kind == Kind::End {
            at += 1;
            end = Some(first.end);
            continue;
        }
        let (_, span, tokens) = grammar::word(text, tokens, at)?;
        at += tokens;
        words += 1;
        telling |= is_telling(byte(first.start).to_ascii_uppercase());
        end = Some(span.end);
    }
    (words >= least).then_some(telling)
}

/// Whether a word of that address is one of N, G, M or an axis.
const fn is_telling(letter: u8) -> bool {
    matches!(letter, b'N' | b'G' | b'M' | b'A'..=b'C' | b'U'..=b'Z')
}
