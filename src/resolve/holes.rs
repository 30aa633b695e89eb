//! What faults leave unknown about the structure of a program (§13).
//!
//! A question about structure has three answers. A word that cannot be read, a `*` in the middle, a line without its
//! `N`, a subprogram without its G79 are holes: a unit or block that is missing may be there. A call or jump to it gets
//! no finding, because the fault has one.

use super::{Unit, UnitKind, spelling};
use crate::diag::Diagnostic;
use crate::dict::{Address, GCode, PROGRAM_ENDS};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word, swallowed_words};
use crate::text::Span;

/// The answer to a question about the structure of a program.
#[derive(Debug)]
pub enum Known<T> {
    /// It is there.
    Yes(T),
    /// It is not there, or behind a fault that nothing has told of: the finding says so.
    No(Box<Diagnostic>),
    /// It may be there: a fault that has its finding leaves it unknown.
    Unknown,
}

/// Whether a block has a word of that address whose number cannot be used, and that may have been meant as one of
/// `numbers`.
pub(super) fn may_hold(file: &ParsedFile, block: BlockId, address: Address, numbers: &[u8]) -> bool {
    let unread = |word: &Word| {
        let number = word.whole().filter(|_| word.is_digits()).and_then(|number| u8::try_from(number).ok());
        let read = number.is_some() && (address != Address::G || word.g_code().is_some());
        word.address == address && !read && !word.is_parametric()
    };
    let mut words = file.words(block).iter().copied().filter(unread);
    words.any(|word| numbers.iter().any(|number| may_mean(file, word, u32::from(*number))))
}

/// The words that the comments of a file swallow (W0114).
pub(super) fn swallowed(file: &ParsedFile) -> impl Iterator<Item = Span> {
    let comments = file.block_ids().flat_map(|block| file.comments_behind(block));
    comments.filter_map(|comment| swallowed_words(file.source.text(), *comment))
}

/// Whether a block that cannot be read as a whole, or words that a comment swallows (W0114), write an assignment to a
/// parameter.
pub fn may_assign(file: &ParsedFile, parameter: u8) -> bool {
    let digits = parameter.to_string();
    let start = |block: BlockId| file.n_place(block).span.start;
    let unread = file.block_ids().filter(|block| file.flags(*block).has(BlockFlags::DEBRIS)).map(|block| {
        let end = if block.next().0 < file.block_count() { start(block.next()) } else { file.end };
        Span::new(start(block), end)
    });
    // Also with another letter in place of R, `E10=5`, and without `=`, `R10 5`.
    let assigns = |text: &str, (at, _): (usize, &str)| {
        let letter = text.get(..at).and_then(|before| before.chars().next_back());
        let behind = text.get(at + digits.len()..).unwrap_or_default();
        let value = behind.trim_start_matches([' ', '\t']);
        let number = value.starts_with(['+', '-', '.'])
            || value != behind && value.starts_with(|digit: char| digit.is_ascii_digit());
        letter.is_some_and(char::is_alphabetic) && value.starts_with('=') || letter == Some('R') && number
    };
    let mut texts = unread.chain(swallowed(file)).map(|span| file.source.slice(span).to_ascii_uppercase());
    // The results of arithmetic are named by control words.
    let computes = |text: &str| ["G26", "G27", "G28", "G29"].iter().any(|function| text.contains(function));
    texts.any(|text| computes(&text) || text.match_indices(&digits).any(|at| assigns(&text, at)))
}

/// Whether a unit without an end may have one that cannot be read: M02 or M30, in subprograms and macrocycles G70.
pub fn may_have_end(file: &ParsedFile, unit: &Unit) -> bool {
    let mut blocks = unit.blocks();
    match unit.kind {
        UnitKind::Main => blocks.any(|block| may_hold(file, block, Address::M, &PROGRAM_ENDS)),
        UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => {
            blocks.any(|block| may_hold(file, block, Address::G, &[GCode::G70.number()]))
        }
    }
}

/// Of so many blocks whose numbers cannot be read, one may have any number.
const MANY: usize = 1000;

/// Whether a block of the unit has a number that cannot be read, and that may be `number`; `unread`: all such blocks of
/// the file.
pub(super) fn may_have_block(parsed: &ParsedFile, unread: &[BlockId], unit: &Unit, number: u32) -> bool {
    let may_be = |block: BlockId| parsed.n_word(block).is_some_and(|word| may_mean(parsed, word, number));
    let from = unread.partition_point(|block| *block < unit.first);
    let mut inside = unread.iter().copied().skip(from).take_while(|block| unit.contains(*block));
    inside.by_ref().take(MANY).any(may_be) || inside.next().is_some()
}

/// Whether the digits of a word begin with those of `number`, or are a parameter that does not exist.
fn may_mean(file: &ParsedFile, word: Word, number: u32) -> bool {
    let text = file.source.slice(word.span(file.source.text()));
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    // One digit was replaced, inserted or lost, or none can be read; of `E30` only the letter is wrong.
    let slips = usize::from(text.bytes().next().and_then(Address::from_byte) == Some(word.address));
    if digits.is_empty() || digits.parse().is_ok_and(|read| spelling::distance(read, number).0 <= slips) {
        return true;
    }
    // `END` is the end of a program on other controls.
    let end = text.get(..3).is_some_and(|name| name.eq_ignore_ascii_case("END"));
    end || text.contains(['R', 'r']) || digits.trim_start_matches('0').starts_with(&number.to_string())
}
