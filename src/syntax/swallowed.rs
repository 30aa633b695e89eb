//! Words that a comment without closing quote swallows (LEX-6).

use super::{Kind, Token, tokens};
use crate::dict::Address;
use crate::sure::{Sure, small};
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
    // A sign that was meant to close the comment ends its text.
    let tail = text.get(start as usize..comment.end as usize)?;
    let closed = tail.rmatch_indices(['“', '”', '\'', ';']).next().map_or(0, |(at, sign)| at + sign.len());
    let tokens: Vec<Token> = tokens(text, start + small(closed), comment.end).collect();
    let ends = |from: usize| Run { text, tokens: tokens.get(from..).sure() }.whole(LEAST, None) == Some(true);
    let from = (0..tokens.len()).find(|from| ends(*from))?;
    Some(Span::new(tokens.get(from)?.start, tokens.last()?.end))
}

/// The words that `span` holds, when nothing but words and comments is in it.
pub(super) fn only_words(text: &str, span: Span) -> Option<Vec<Token>> {
    if span.len() > TAIL {
        return None;
    }
    let mut words: Vec<Token> = tokens(text, span.start, span.end).collect();
    words.retain(|token| token.kind != Kind::Comment);
    Run { text, tokens: &words }.whole(1, words.first().map(|first| first.start))?;
    words.retain(|token| matches!(token.kind, Kind::Word | Kind::Letter | Kind::SignedLetter | Kind::Parameter));
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

/// Whether `span` holds a text without a word of a block, so that it is a comment whatever is around it. A number at its
/// beginning may be one that lost its address.
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
                    | Kind::LooseWord
                    | Kind::Parameter
                    | Kind::LooseParameter
                    | Kind::PrintedWord
                    | Kind::AssignedWord
                    | Kind::NamedValue
                    | Kind::Variable
                    | Kind::GarbledWord
                    | Kind::Comment
                    | Kind::TypographicComment
            )
    };
    begins && !tokens(text, span.start, span.end).any(|token| is_word(&token))
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
        matches!(token.kind, Kind::Word | Kind::Letter | Kind::SignedLetter | Kind::Parameter)
            && !matches!(letter, b'N' | b'n')
    };
    let mut behind = tokens(text, start, end).take_while(is_word);
    let first = behind.next().filter(|first| first.kind == Kind::Word)?;
    let last = behind.last().unwrap_or(first);
    Some(first.span().to(last.span()))
}

/// What may be words up to the end of a comment.
struct Run<'t> {
    text: &'t str,
    tokens: &'t [Token],
}

impl Run<'_> {
    /// Whether one of the words is N, G, M or an axis; `None` when it is not nothing but words, or fewer than `least`.
    /// `end`: where a word may begin without a blank before it.
    fn whole(mut self, least: usize, mut end: Option<u32>) -> Option<bool> {
        let (mut words, mut telling) = (0, false);
        while let Some(&first) = self.tokens.first() {
            if end != Some(first.start) && !self.is_apart(first) {
                return None;
            }
            if first.kind == Kind::Skip || words > 0 && first.kind == Kind::End {
                self.next();
                end = Some(first.end);
                continue;
            }
            let last = self.word()?;
            words += 1;
            telling |= is_telling(self.letter(first));
            end = Some(last.end);
        }
        (words >= least).then_some(telling)
    }

    /// Takes one word; gives its last token.
    fn word(&mut self) -> Option<Token> {
        let first = self.next()?;
        if first.kind == Kind::Parameter {
            // `R5=3`, `R5=-R3`
            self.next().filter(|token| token.kind == Kind::Equals)?;
            let value = self.next()?;
            let value = if value.kind == Kind::Sign { self.next()? } else { value };
            return matches!(value.kind, Kind::Number | Kind::Parameter).then_some(value);
        }
        Address::from_byte(self.letter(first))?;
        if first.kind == Kind::Word {
            return Some(first);
        }
        // `XR5`
        let address = matches!(first.kind, Kind::Letter | Kind::SignedLetter);
        self.next().filter(|token| address && token.kind == Kind::Parameter)
    }

    fn next(&mut self) -> Option<Token> {
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        Some(*first)
    }

    fn letter(&self, token: Token) -> u8 {
        self.text.as_bytes().get(token.start as usize).copied().unwrap_or(b' ').to_ascii_uppercase()
    }

    /// Whether a blank or the border of the comment is before it.
    fn is_apart(&self, token: Token) -> bool {
        let before = (token.start as usize).checked_sub(1).and_then(|before| self.text.as_bytes().get(before));
        before.is_none_or(|byte| matches!(byte, b' ' | b'\t' | b'"'))
    }
}

/// Whether a word of that address is one of N, G, M or an axis.
const fn is_telling(letter: u8) -> bool {
    matches!(letter, b'N' | b'G' | b'M' | b'A'..=b'C' | b'U'..=b'Z')
}
