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
    let mut run = Run::default();
    for token in tokens(text, start, comment.end) {
        run.take(text, token);
    }
    (run.words >= LEAST && run.telling && !run.open).then(|| Span::new(run.start, run.end))
}

/// The words at the end of what was read.
#[derive(Default)]
struct Run {
    start: u32,
    end: u32,
    words: usize,
    /// N, G, M or an axis is among them.
    telling: bool,
    /// An address still wants its parameter, a parameter its value.
    open: bool,
}

impl Run {
    fn take(&mut self, text: &str, token: Token) {
        let byte = |at: u32| text.as_bytes().get(at as usize).copied().unwrap_or(b' ');
        let letter = byte(token.start).to_ascii_uppercase();
        let apart = token.start == 0 || matches!(byte(token.start - 1), b' ' | b'\t' | b'"');
        let follows = self.words > 0 && self.end == token.start;
        let begins = !self.open && (apart || follows);
        let addressed = matches!(token.kind, Kind::Word | Kind::Letter | Kind::SignedLetter);
        if addressed && begins && Address::from_byte(letter).is_some() {
            self.word(token, is_telling(letter));
            self.open = token.kind != Kind::Word;
        } else if token.kind == Kind::Parameter && begins {
            self.word(token, false);
            self.open = true;
        } else if matches!(token.kind, Kind::Parameter | Kind::Number) && self.open {
            self.open = false;
            self.end = token.end;
        } else if (token.kind == Kind::Equals && self.open) || (token.kind == Kind::Skip && self.words > 0) {
            self.end = token.end;
        } else {
            *self = Self::default();
        }
    }

    fn word(&mut self, token: Token, telling: bool) {
        if self.words == 0 {
            self.start = token.start;
        }
        self.words += 1;
        self.telling |= telling;
        self.end = token.end;
    }
}

/// Whether a word of that address is one of N, G, M or an axis.
const fn is_telling(letter: u8) -> bool {
    matches!(letter, b'N' | b'G' | b'M' | b'A'..=b'C' | b'U'..=b'Z')
}
