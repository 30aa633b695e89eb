//! What a fault leaves unknown beside it. A sign or a letter without a value, directly behind a number or before an address,
//! may be a digit or an address that a slip replaced: then neither word is known, and neither gives a finding (§13).

use super::lower::Lowering;
use super::{Kind, Token, Word};
use crate::dict::Address;
use crate::sure::Sure;
use crate::text::Span;

impl Lowering<'_> {
    /// Notes characters of the block in hand that make no word, and whose finding comes next.
    pub(super) fn junk(&mut self, span: Span) {
        self.junk.push(span);
    }

    /// Leaves unknown the words that stand directly beside junk. Junk directly behind other junk is part of that, and has no
    /// finding of its own. The words of the block begin at `first`.
    pub(super) fn poison(&mut self, first: usize) {
        let mut junk = std::mem::take(&mut self.junk);
        junk.sort_unstable_by_key(|span| span.start);
        let text = self.text;
        let mut runs: Vec<Span> = Vec::new();
        for span in junk.drain(..) {
            match runs.last_mut() {
                // Nothing parts them but a word, as in `R1b2=12`.
                Some(run) if span.start <= run.end || is_glued(text, run.end, span.start) => {
                    self.parts.extend((span.start > run.start).then_some(span.start));
                    run.end = run.end.max(span.end);
                }
                _ => runs.push(span),
            }
        }
        self.junk = junk;
        for word in self.words.iter_mut().skip(first) {
            let span = word.span(text);
            let beside = |run: &&Span| run.start <= span.end && span.start <= run.end;
            let Some(run) = runs.iter().find(beside).filter(|_| !word.is_void()) else { continue };
            // A number that goes on behind the junk may be any that begins so.
            let whole = if matches!(word.address, Address::N | Address::L | Address::G | Address::M) {
                Span::new(span.start, span.end.max(end_of_run(text, run.end)))
            } else {
                span
            };
            *word = Word::bare(word.address, whole).faulty().assigning(word.target());
            let start = span.start;
            self.lowercase.retain(|place| *place != start);
        }
    }

    /// A sign with a number, in place of an address and its number: what it would have set.
    pub(super) fn lost_address(&mut self, span: Span) {
        let text = self.slice(span);
        let number = text.trim_start_matches(|sign: char| !sign.is_ascii_digit() && !"+-.".contains(sign));
        let digits = number.bytes().all(|byte| byte.is_ascii_digit());
        let addresses: &[Address] = if number.is_empty() {
            &[]
        } else if digits && number.len() < 3 {
            &[Address::G, Address::M, Address::X, Address::Y, Address::Z]
        } else if digits {
            &[Address::L, Address::S, Address::F, Address::X, Address::Y, Address::Z]
        } else {
            &[Address::X, Address::Y, Address::Z]
        };
        addresses.iter().for_each(|address| self.push_void(*address, span));
        if !addresses.is_empty() && self.arc_in_force(span.start) {
            [Address::I, Address::J].into_iter().for_each(|address| self.push_void(address, span));
        }
    }
}

/// Whether neither blanks nor line ends stand in a short text.
fn is_glued(text: &str, from: u32, to: u32) -> bool {
    let between = text.as_bytes().get(from as usize..to as usize).unwrap_or_default();
    between.len() < 16 && !between.iter().any(|byte| byte.is_ascii_whitespace() || *byte == b'"')
}

/// Where the digits end that begin at `at`.
fn end_of_run(text: &str, at: u32) -> u32 {
    let rest = text.as_bytes().get(at as usize..).sure();
    let length = rest.iter().take_while(|byte| byte.is_ascii_digit()).take(8).count();
    at + u32::try_from(length).unwrap_or(0)
}

/// Whether a number, or a sign and a number, begins a line in place of a block number: words follow it on the line, and
/// what stands before it lacks no number.
pub(super) fn is_lost_number(bytes: &[u8], before: &[Token], token: Token) -> bool {
    if !matches!(token.kind, Kind::Number | Kind::LooseNumber | Kind::Unknown) {
        return false;
    }
    let above = bytes.get(..token.start as usize).sure();
    let line = above.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t'));
    let line = matches!(line, None | Some(b'\n' | b'\r'));
    let word = bytes.get(token.span().range()).sure();
    let signs = word.iter().take_while(|byte| !byte.is_ascii_digit()).count();
    let (signs, digits) = word.split_at_checked(signs).unwrap_or_default();
    let number = signs.len() < 2 && (1..=6).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    let behind = bytes.get(token.end as usize..).sure();
    let blanks = behind.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    let words =
        matches!(behind.get(blanks..), Some([b'A'..=b'M' | b'P'..=b'Z', b'0'..=b'9' | b'+' | b'-' | b'.' | b'R', ..]));
    let lacking = before.iter().rev().find(|token| !matches!(token.kind, Kind::LineEnd | Kind::Comment));
    let lacking = lacking.is_some_and(|last| {
        !matches!(last.kind, Kind::Word | Kind::Number | Kind::Skip | Kind::Text | Kind::Unknown | Kind::LooseWord)
    });
    line && number && blanks > 0 && words && (!lacking || follows_n(bytes, token.start))
}

/// Whether an `N` without a number stands right before `at`, on the same line or one above: `F140N`, and below it `150 X1`.
pub(super) fn follows_n(bytes: &[u8], at: u32) -> bool {
    matches!(bytes.get(..at as usize).sure().trim_ascii_end().last(), Some(b'N' | b'n'))
}
