//! The text of the files, packed: most numbers in a block follow from its execution, so that a skeleton for each block,
//! the text with marks for numbers, and what cannot be foretold are enough. `web/src/data/text.ts` reads it.

use std::collections::HashMap;
use std::iter::Peekable;

use super::column::Column;
use super::container::Long;
use super::files::PageFile;
use super::rows::Rows;
use crate::dict::{AxisLetter, Micro};
use crate::sure::{Sure, small};
use crate::text::Span;

/// The first of the characters that replace a number in a skeleton; they differ by [`STYLES`].
const FIRST_MARK: u32 = 0xE000;
/// The character for the block number, as written or padded with zeros to as many digits as the characters after it
/// say.
const NUMBER_MARK: u32 = FIRST_MARK + 16;

/// How a number is written.
#[derive(Clone, Copy, Debug)]
struct Style {
    /// Decimals; `None`: as many as the number needs.
    decimals: Option<usize>,
    /// Whether whole numbers have a point.
    point: bool,
    /// Whether a zero stands before the point.
    zero: bool,
}

/// In the order of `text.ts`.
const STYLES: [Style; 10] = [
    Style { decimals: None, point: false, zero: true },
    Style { decimals: None, point: true, zero: true },
    Style { decimals: None, point: false, zero: false },
    Style { decimals: None, point: true, zero: false },
    Style { decimals: Some(1), point: true, zero: true },
    Style { decimals: Some(2), point: true, zero: true },
    Style { decimals: Some(3), point: true, zero: true },
    Style { decimals: Some(1), point: true, zero: false },
    Style { decimals: Some(2), point: true, zero: false },
    Style { decimals: Some(3), point: true, zero: false },
];

/// A number as the text has it.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Written<'t> {
    negative: bool,
    whole: &'t str,
    point: bool,
    fraction: &'t str,
    /// How many bytes it takes.
    bytes: usize,
}

impl<'t> Written<'t> {
    /// The number that a text begins with.
    fn read(text: &'t str) -> Option<Self> {
        let negative = text.starts_with('-');
        let rest = text.get(usize::from(negative)..)?;
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let (whole, after) = rest.split_at_checked(digits(rest))?;
        let point = after.starts_with('.');
        let fraction =
            after.get(1..).filter(|_| point).and_then(|after| after.get(..digits(after))).unwrap_or_default();
        let bytes = usize::from(negative) + whole.len() + usize::from(point) + fraction.len();
        let empty = whole.is_empty() && fraction.is_empty();
        (!empty).then_some(Self { negative, whole, point, fraction, bytes })
    }

    /// In thousandths; `None` when it is finer, or too long for a number of the language.
    fn thousandths(&self) -> Option<i64> {
        if self.fraction.len() > 3 || self.whole.len() > 12 {
            return None;
        }
        let digit = |sum: i64, byte: u8| sum * 10 + i64::from(byte - b'0');
        let padded = self.fraction.bytes().chain(std::iter::repeat(b'0')).take(3);
        let magnitude = self.whole.bytes().chain(padded).fold(0, digit);
        // A zero with a sign is no number that could be written again.
        (magnitude != 0 || !self.negative).then_some(if self.negative { -magnitude } else { magnitude })
    }

    /// Whether that style writes it so.
    fn has_style(&self, style: Style) -> bool {
        let whole_is_zero = self.whole.bytes().all(|byte| byte == b'0');
        let fraction = match style.decimals {
            Some(decimals) => self.fraction.len() == decimals,
            None => !self.fraction.ends_with('0'),
        };
        let whole = match (whole_is_zero, self.whole.len()) {
            (true, 0) => !style.zero && !self.fraction.is_empty(),
            (true, 1) => style.zero || self.fraction.is_empty(),
            (true, _) => false,
            (false, _) => !self.whole.starts_with('0'),
        };
        fraction && whole && self.point == (style.point || !self.fraction.is_empty())
    }
}

/// The character for a comment.
const COMMENT_MARK: char = '\u{E030}';

/// Letters whose numbers have columns; those of axes, F, I and J may be foretold.
const LETTERS: [char; 17] = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', 'F', 'I', 'J', 'K', 'R', 'S', 'Q', '='];

/// Skeletons longer than this are not compared with others, and written in pieces.
const LONG: usize = 1 << 14;
/// Skeletons that are compared with others have so many bytes at most.
const COMPARED: usize = 1 << 23;

/// The numbers behind one letter.
#[derive(Debug, Default)]
struct Numbers {
    /// In which style the last one was written.
    style: usize,
    /// As they are, and what they differ from what execution says.
    plain: Column,
    differing: Column,
}

/// The text of the files.
#[derive(Debug, Default)]
pub(super) struct Text {
    /// One behind the other, and how many bytes each has.
    pub skeletons: Long,
    pub skeleton_bytes: Column,
    /// By block: one more than its skeleton; 0 for the last one that a block of its shape had.
    pub skeleton: Column,
    /// The comments of blocks, one behind the other, and how many bytes each has.
    pub comments: Long,
    pub comment_bytes: Column,
    /// By letter: the numbers, and whether what execution says is to be added.
    pub numbers: Vec<(char, Column, bool)>,
    /// By file: the text before its first block.
    pub heads: Vec<Head>,
}

/// What stands before the first block of a file.
#[derive(Debug)]
pub(super) struct Head {
    pub text: String,
    /// How many comments of blocks are in it.
    pub comments: usize,
}

/// Skeletons that were met.
#[derive(Debug, Default)]
struct Known {
    index: HashMap<String, u32>,
    /// By index; nothing of those that are not compared.
    texts: Vec<Option<String>>,
    bytes: usize,
}

impl Known {
    fn is(&self, index: u32, text: &str) -> bool {
        self.texts.get(index as usize).is_some_and(|known| known.as_deref() == Some(text))
    }

    /// The index of a new one.
    fn add(&mut self, text: Option<&str>) -> u32 {
        let index = small(self.texts.len());
        let compared = text.filter(|text| self.bytes + text.len() <= COMPARED);
        self.bytes += compared.map_or(0, str::len);
        self.texts.push(compared.map(str::to_owned));
        self.index.extend(compared.map(|text| (text.to_owned(), index)));
        index
    }
}

impl Text {
    /// Takes the texts of the files of `rows` apart.
    pub fn of(rows: &Rows) -> Self {
        let mut found = Self::default();
        let mut known = Known::default();
        let mut numbers: [Numbers; LETTERS.len()] = Default::default();
        let first_rows = first_rows(rows);
        // By shape: the skeleton that stood last, 0 at first as for the reader.
        let mut last = vec![0_u32; rows.shape_keys.len().max(1)];
        for file in rows.files.iter() {
            found.head(file);
            let text = file.source.text();
            let ends = file.starts.iter().skip(1).copied().chain([small(text.len())]);
            let mut comments = file.comments.iter().copied().peekable();
            let before = file.starts.first().copied().unwrap_or(u32::MAX);
            while comments.next_if(|comment| comment.start < before).is_some() {}
            for ((start, end), block) in file.starts.iter().zip(ends).zip(file.first as usize..) {
                let row = first_rows.get(block).copied().unwrap_or_default() as usize;
                let mut apart = Apart {
                    text: text.get(..end as usize).sure(),
                    comments: &mut comments,
                    number: rows.files.n.get(block).unwrap_or_default(),
                    numbers: &mut numbers,
                    skeleton: String::new(),
                    written: 0,
                    long: &mut found.skeletons,
                };
                apart.take(*start as usize, |letter| foretold(rows, row, letter));
                let Apart { skeleton, written, .. } = apart;
                let shape = usize::try_from(rows.shape.get(row).unwrap_or_default()).unwrap_or_default();
                let expected = last.get(shape).copied().unwrap_or_default();
                if written == 0 && known.is(expected, &skeleton) {
                    found.skeleton.push(0);
                    continue;
                }
                let index = match known.index.get(&skeleton).filter(|_| written == 0) {
                    Some(index) => *index,
                    None => {
                        found.skeletons.push(skeleton.as_bytes());
                        found.skeleton_bytes.push(i64::from(small(written + skeleton.len())));
                        known.add(Some(skeleton.as_str()).filter(|_| written == 0))
                    }
                };
                found.skeleton.push(i64::from(index) + 1);
                if let Some(last) = last.get_mut(shape) {
                    *last = index;
                }
            }
        }
        for (letter, numbers) in LETTERS.into_iter().zip(numbers).filter(|(_, numbers)| numbers.plain.len() > 0) {
            let foretell = numbers.differing.cost() < numbers.plain.cost();
            let column = if foretell { numbers.differing } else { numbers.plain };
            found.numbers.push((letter, column, foretell));
        }
        found
    }

    /// Takes up the comments of a file, and what stands before its first block.
    fn head(&mut self, file: &PageFile) {
        let text = file.source.text();
        let end = file.starts.first().copied().unwrap_or(small(text.len()));
        let comments = file.comments.iter().take_while(|comment| comment.start < end).count();
        let head = text.get(..end as usize).sure();
        self.heads.push(Head { text: with_plain_line_ends(head), comments });
        for comment in &file.comments {
            let comment = file.source.slice(*comment);
            self.comments.push(comment.as_bytes());
            self.comment_bytes.push(i64::from(small(comment.len())));
        }
    }
}

/// By block: the row of its first execution, 0 without one.
fn first_rows(rows: &Rows) -> Vec<u32> {
    let mut first = vec![0; rows.files.n.len()];
    for row in (1..rows.block.len()).rev() {
        let block = rows.block.get(row).and_then(|block| usize::try_from(block).ok());
        if let Some(slot) = block.and_then(|block| first.get_mut(block)) {
            *slot = small(row);
        }
    }
    first
}

/// The row's value of the number behind a letter, in thousandths; 0 when it has none.
fn foretold(rows: &Rows, row: usize, letter: char) -> i64 {
    let rounded = |value: Micro| (value.millionths() + 500).div_euclid(1000);
    if letter == 'F' {
        return rows.feed.get(row).unwrap_or_default();
    }
    let shape = rows.shape.get(row).and_then(|shape| rows.shape_keys.get(usize::try_from(shape).ok()?));
    let Some(shape) = shape else { return 0 };
    if let 'I' | 'J' = letter {
        let Some(arc) = shape.arc else { return 0 };
        let swapped = arc.first > arc.second;
        let [first, second] = rows.to_center(row);
        return rounded(if (letter == 'I') == swapped { second } else { first });
    }
    let axis = AxisLetter::from_letter(letter).and_then(|letter| rows.letters.iter().position(|axis| *axis == letter));
    let known = axis.filter(|axis| shape.known & (1 << axis) != 0);
    known.map_or(0, |axis| rounded(rows.positions.get(axis, row)))
}

/// The text of one block, being taken apart.
struct Apart<'a, C: Iterator<Item = Span>> {
    /// The file's text up to the end of the block.
    text: &'a str,
    /// Comments from the block on.
    comments: &'a mut Peekable<C>,
    number: i64,
    numbers: &'a mut [Numbers; LETTERS.len()],
    /// What of the skeleton is not written yet.
    skeleton: String,
    /// How many bytes of it are written, because it is long.
    written: usize,
    long: &'a mut Long,
}

impl<C: Iterator<Item = Span>> Apart<'_, C> {
    /// Makes the skeleton of the block that begins at a place of the text, and puts its numbers into their columns.
    fn take(&mut self, mut at: usize, foretold: impl Fn(char) -> i64) {
        let mut in_comment = false;
        while let Some(first) = self.text.get(at..).and_then(|rest| rest.chars().next()) {
            if self.skeleton.len() >= LONG {
                self.written += self.skeleton.len();
                self.long.push(self.skeleton.as_bytes());
                self.skeleton.clear();
            }
            if let Some(comment) = self.comments.next_if(|comment| comment.start as usize <= at) {
                self.skeleton.push(COMMENT_MARK);
                at = (comment.end as usize).max(at);
                in_comment = false;
                continue;
            }
            at += first.len_utf8();
            if first == '"' {
                in_comment = !in_comment;
            }
            let rest = self.text.get(at..).unwrap_or_default();
            match first {
                '\r' => {
                    self.skeleton.push('\n');
                    at += usize::from(rest.starts_with('\n'));
                    continue;
                }
                // The marks themselves are no text.
                '\u{E000}'..='\u{E03F}' => self.skeleton.push('\u{FFFD}'),
                other => self.skeleton.push(other),
            }
            if in_comment || !(first.is_ascii_uppercase() || first == '=') {
                continue;
            }
            if let Some(written) = Written::read(rest)
                && let Some(mark) = mark(first, written, self.number, self.numbers, &foretold)
            {
                self.skeleton.push(mark);
                at += written.bytes;
            }
        }
    }
}

/// The mark for a number behind a letter, whose value is taken up; `None` when it stays in the skeleton.
fn mark(
    letter: char,
    written: Written<'_>,
    number: i64,
    numbers: &mut [Numbers; LETTERS.len()],
    foretold: impl Fn(char) -> i64,
) -> Option<char> {
    if letter == 'N' {
        let value = written.thousandths().filter(|_| !written.point && !written.negative)?;
        let width = if written.whole.starts_with('0') { u32::try_from(written.whole.len()).ok()? } else { 0 };
        return char::from_u32(NUMBER_MARK + width).filter(|_| value == number * 1000 && width < 32);
    }
    let place = LETTERS.iter().position(|known| *known == letter)?;
    let numbers = numbers.get_mut(place)?;
    let value = written.thousandths()?;
    let has = |style: usize| STYLES.get(style).is_some_and(|known| written.has_style(*known));
    if !has(numbers.style) {
        numbers.style = (0..STYLES.len()).find(|style| has(*style))?;
    }
    numbers.plain.push(value);
    numbers.differing.push(value - foretold(letter));
    char::from_u32(FIRST_MARK + u32::try_from(numbers.style).ok()?)
}

fn with_plain_line_ends(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn styles(text: &str) -> Vec<usize> {
        let written = Written::read(text).unwrap();
        (0..STYLES.len()).filter(|style| written.has_style(STYLES[*style])).collect()
    }

    #[test]
    fn how_numbers_are_written() {
        assert_eq!(styles("12"), [0, 2]);
        assert_eq!(styles("12."), [1, 3]);
        assert_eq!(styles("-12.5"), [0, 1, 2, 3, 4, 7]);
        assert_eq!(styles("0.5"), [0, 1, 4]);
        assert_eq!(styles(".5"), [2, 3, 7]);
        assert_eq!(styles("12.500"), [6, 9]);
        assert_eq!(styles("0"), [0, 2]);
        assert_eq!(styles("0.000"), [6]);
        assert_eq!(styles("012"), Vec::<usize>::new());
    }

    #[test]
    fn numbers_and_comments() {
        let mut numbers: [Numbers; LETTERS.len()] = Default::default();
        let text = "N0010 G1 X-1.500 \"X5\" XR3\r\nF+20 R1=2.5\n";
        let comment = Span::new(17, 21);
        let mut apart = Apart {
            text,
            comments: &mut [comment].into_iter().peekable(),
            number: 10,
            numbers: &mut numbers,
            skeleton: String::new(),
            written: 0,
            long: &mut Long::default(),
        };
        apart.take(0, |_| 0);
        let skeleton = "N\u{e014} G1 X\u{e006} \u{e030} XR\u{e000}\nF+20 R\u{e000}=\u{e000}\n";
        assert_eq!(apart.skeleton, skeleton);
        assert_eq!(numbers[0].plain.get(0), Some(-1500));
    }
}
