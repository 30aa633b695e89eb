//! The grammar of a block: well-formed words over its tokens, as `grammar/part-program.ebnf` shows them.
//! [`super::slips`] explains the rest.

use super::Word;
use super::number::Number;
use super::slips::Cursor;
use super::tokens::{Kind, Token};
use crate::dict::Address;
use crate::sure::Sure;
use crate::text::Span;

/// The highest parameter is R95.
pub(super) const PARAMETERS: u8 = 96;

/// The well-formed word that begins with the token at `at`, where it stands, and how many tokens it is made of. `None`
/// when it is malformed, or when something follows that may belong to it.
pub(super) fn word(text: &str, tokens: &[Token], at: usize) -> Option<(Word, Span, usize)> {
    let mut next = Cursor::new(tokens, at);
    let first = next.when(|_| true)?;
    let byte = |at: u32| text.as_bytes().get(at as usize).copied().unwrap_or(0);
    let parameter = |token: Token| parameter_number(number(text, token));
    let (word, span) = match first.kind {
        Kind::Word => {
            let number = Number::parse(number(text, first).as_bytes())?;
            let address = Address::from_byte(byte(first.start))?;
            // `Z-24/2` divides nothing; the `/` of `Z-24/ 2` is a word.
            let divided = next.peek().is_some_and(|next| {
                let digits = next.kind == Kind::Skip && byte(next.start + 1).is_ascii_digit();
                digits && next.start == first.end && address != Address::N
            });
            let whole = next.number().is_none() && !divided;
            let word = Word::with_number(address, first.span(), number);
            return whole.then_some((word, first.span(), 1));
        }
        Kind::Skip => return Some((Word::bare(Address::Skip, first.span()), first.span(), 1)),
        Kind::Letter => {
            let address = Address::from_byte(byte(first.start))?;
            let source = next.one(Kind::Parameter)?;
            let sign = Some(byte(first.end - 1)).filter(|sign| matches!(sign, b'+' | b'-'));
            let apart = sign.is_some() && first.end != source.start;
            if apart || matches!(address, Address::N | Address::Program) {
                return None;
            }
            let span = first.span().to(source.span());
            (Word::with_parameter(address, span, parameter(source)?, sign), span)
        }
        Kind::Parameter => {
            let target = parameter(first)?;
            let equals = next.one(Kind::Equals);
            let sign = equals.and_then(|_| next.one(Kind::Sign));
            let source = equals.and_then(|_| next.one(Kind::Parameter));
            let value = source.or_else(|| next.one(Kind::Number).filter(|_| sign.is_none()))?;
            let span = first.span().to(value.span());
            let word = match source {
                Some(source) if sign.is_some_and(|sign| sign.end != source.start) => return None,
                Some(source) => {
                    Word::with_parameter(Address::R, span, parameter(source)?, sign.map(|sign| byte(sign.start)))
                }
                None => Word::with_number(Address::R, span, Number::parse(slice(text, value).as_bytes())?),
            };
            (word.assigning(target), span)
        }
        Kind::Number | Kind::Equals | Kind::Sign | Kind::Comment | Kind::LineEnd | Kind::End | Kind::Junk(_) => {
            return None;
        }
    };
    let tokens = next.taken;
    let ends = next.operands().is_empty() && next.peek().is_none_or(|next| next.kind != Kind::Equals);
    ends.then_some((word, span, tokens))
}

/// The number of a parameter, 0 to 95.
pub(super) fn parameter_number(digits: &str) -> Option<u8> {
    let whole = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|number| whole && *number < PARAMETERS)
}

fn slice(text: &str, token: Token) -> &str {
    text.get(token.span().range()).sure()
}

/// The text behind the letter of a token and its blanks.
fn number(text: &str, token: Token) -> &str {
    slice(text, token).get(1..).sure().trim_start_matches([' ', '\t'])
}
