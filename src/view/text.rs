//! The text of the files, packed: most numbers in a block follow from its execution, so that a skeleton for each block,
//! the text with marks for numbers, and what cannot be foretold are enough. `web/src/data/text.ts` reads it.

use std::collections::HashMap;

use super::column::Column;
use super::rows::Rows;
use crate::dict::{AxisLetter, Micro};
use crate::sure::{Sure, small};

/// The first of the characters that stand for a number in a skeleton; they differ by [`STYLES`].
const FIRST_MARK: u32 = 0xE000;
/// The character for the block number, as written or padded with zeros to as many digits as the characters after it say.
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

/// A number as it stands in the text.
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

/// Letters whose numbers may be foretold.
const LETTERS: [char; 12] = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', 'F', 'I', 'J'];

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
    pub skeletons: Vec<String>,
    /// By block: one more than its skeleton; 0 for the last one that a block of its shape had.
    pub skeleton: Column,
    /// By letter: the numbers, and whether what execution says is to be added.
    pub numbers: Vec<(char, Column, bool)>,
    /// By file: the text before its first block.
    pub heads: Vec<String>,
}

impl Text {
    /// Takes the texts of the files of `rows` apart.
    pub fn of(rows: &Rows) -> Self {
        let mut found = Self::default();
        let mut known: HashMap<String, u32> = HashMap::new();
        let mut numbers: [Numbers; LETTERS.len()] = Default::default();
        let first_rows = first_rows(rows);
        // By shape: the skeleton that stood last, 0 at first as for the reader.
        let mut last = vec![0_u32; rows.shape_keys.len().max(1)];
        let mut skeleton = String::new();
        for file in rows.files.iter() {
            let text = file.source.text();
            let end = small(text.len());
            let head = text.get(..file.starts.first().copied().unwrap_or(end) as usize).sure();
            found.heads.push(with_plain_line_ends(head));
            let ends = file.starts.iter().skip(1).copied().chain([end]);
            for ((start, end), block) in file.starts.iter().zip(ends).zip(file.first as usize..) {
                let text = text.get(*start as usize..end as usize).sure();
                let row = first_rows.get(block).copied().unwrap_or_default() as usize;
                skeleton.clear();
                let number = rows.files.n.get(block).unwrap_or_default();
                take_apart(text, &mut skeleton, number, &mut numbers, |letter| foretold(rows, row, letter));
                let shape = usize::try_from(rows.shape.get(row).unwrap_or_default()).unwrap_or_default();
                let expected = last.get(shape).copied().unwrap_or_default();
                if found.skeletons.get(expected as usize) == Some(&skeleton) {
                    found.skeleton.push(0);
                    continue;
                }
                let index = *known.entry(skeleton.clone()).or_insert_with(|| {
                    found.skeletons.push(skeleton.clone());
                    small(found.skeletons.len() - 1)
                });
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

/// What the row of a block says of the number behind a letter, in thousandths; 0 when it says nothing.
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

/// Writes the skeleton of a block's text, and its numbers to their columns.
fn take_apart(
    text: &str,
    skeleton: &mut String,
    number: i64,
    numbers: &mut [Numbers; LETTERS.len()],
    foretold: impl Fn(char) -> i64,
) {
    let mut rest = text;
    let mut in_comment = false;
    while let Some(first) = rest.chars().next() {
        let length = first.len_utf8();
        let after = rest.get(length..).sure();
        if first == '"' {
            in_comment = !in_comment;
        }
        match first {
            '\r' => {
                skeleton.push('\n');
                rest = after.strip_prefix('\n').unwrap_or(after);
                continue;
            }
            // The marks themselves are no text.
            '\u{E000}'..='\u{E03F}' => skeleton.push('\u{FFFD}'),
            other => skeleton.push(other),
        }
        rest = after;
        if in_comment || !first.is_ascii_uppercase() {
            continue;
        }
        if let Some(written) = Written::read(rest)
            && let Some(mark) = mark(first, written, number, numbers, &foretold)
        {
            skeleton.push(mark);
            rest = rest.get(written.bytes..).sure();
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
        let mut skeleton = String::new();
        take_apart("N0010 G1 X-1.500 \"X5\" XR3\r\nF+20\n", &mut skeleton, 10, &mut numbers, |_| 0);
        assert_eq!(skeleton, "N\u{e014} G1 X\u{e006} \"X5\" XR3\nF+20\n");
        assert_eq!(numbers[0].plain.get(0), Some(-1500));
    }
}
