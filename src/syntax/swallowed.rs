//! Words that a comment without closing quote swallows (LEX-6).

use super::{Kind, Token, tokens};
use crate::dict::Address;
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
    let tokens: Vec<Token> = tokens(text, start, comment.end).collect();
    let ends = |from: usize| Run { text, tokens: tokens.get(from..).unwrap_or_default() }.whole();
    let from = (0..tokens.len()).find(|from| ends(*from))?;
    Some(Span::new(tokens.get(from)?.start, tokens.last()?.end))
}

/// What may be words up to the end of a comment.
struct Run<'t> {
    text: &'t str,
    tokens: &'t [Token],
}

impl Run<'_> {
    /// Whether it is nothing but words, and enough of them.
    fn whole(mut self) -> bool {
        let (mut words, mut telling) = (0, false);
        let mut end = None;
        while let Some(&first) = self.tokens.first() {
            if words > 0 && matches!(first.kind, Kind::Skip | Kind::End) {
                self.next();
                continue;
            }
            if end != Some(first.start) && !self.is_apart(first) {
                return false;
            }
            let Some(last) = self.word() else { return false };
            words += 1;
            telling |= is_telling(self.letter(first));
            end = Some(last.end);
        }
        words >= LEAST && telling
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
