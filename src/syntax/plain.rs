//! Plain blocks, read from their bytes: a block number and words with numbers, as CAM systems write them by the
//! million.
//!
//! It is a short way through lexer and grammar for what they would read alike (decision 0010). Whatever is not plain,
//! and whatever could be part of something that is not, is left to them, from the beginning of its block.

use super::file::Block;
use super::lower::Lowering;
use super::number::Number;
use super::{BlockFlags, Word};
use crate::dict::Address;
use crate::sure::{Sure, small};
use crate::text::Span;

/// Whether a block begins at `at`, whatever stands before it on other lines: `N` and a digit are a block number or
/// something like one, but never part of a text.
#[inline]
pub(super) fn block_begins(bytes: &[u8], at: usize) -> bool {
    matches!(bytes.get(at..), Some([b'N', b'0'..=b'9', ..]))
}

/// Reads plain blocks from `start` on, up to a block that is not plain or to `end`. Gives where it stopped: at the
/// beginning of a block, or at `end`.
pub(super) fn plain_blocks(lowering: &mut Lowering<'_>, blocks: &mut Vec<Block>, start: u32, end: u32) -> u32 {
    let bytes = lowering.text.as_bytes().get(..end as usize).sure();
    let mut at = start;
    while block_begins(bytes, at as usize) {
        let first_word = lowering.words.len();
        lowering.flags = BlockFlags::default();
        let plain = plain_block(lowering, bytes, at);
        // Other controls write other words with such a function: the whole block is looked at.
        let candidate = std::mem::take(&mut lowering.candidate);
        let Some(after) = plain.filter(|_| !candidate) else {
            lowering.words.truncate(first_word);
            break;
        };
        blocks.push(Block { first_word: small(first_word), flags: lowering.flags });
        at = after;
    }
    at
}

/// Reads one plain block, and the blanks and line ends behind it; gives where the next one begins. `None` when there is
/// anything else in it than words of a letter and, without a blank, its number.
fn plain_block(lowering: &mut Lowering<'_>, bytes: &[u8], start: u32) -> Option<u32> {
    let offset = |rest: &[u8]| small(bytes.len() - rest.len());
    let mut rest = bytes.get(start as usize..)?;
    loop {
        let [letter @ b'A'..=b'Z', number @ ..] = rest else { return None };
        // R is a parameter, and an address that does not exist has a finding.
        let address = Address::from_byte(*letter).filter(|address| *address != Address::R)?;
        let (number, after) = Number::leading(number)?;
        let span = Span::new(offset(rest), offset(after));
        lowering.push(Word::with_number(address, span, number), span);
        rest = after;
        while let [b' ' | b'\t' | b'\r' | b'\n', behind @ ..] = rest {
            rest = behind;
        }
        match rest {
            [] | [b'N', b'0'..=b'9', ..] => return Some(offset(rest)),
            [b'N', ..] => return None,
            _ => {}
        }
    }
}
