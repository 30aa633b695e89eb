//! Applies fixes to the bytes of a file. All that no fix touches stays as it was, byte by byte, in whatever encoding
//! and with whatever line ends.

use std::collections::BTreeMap;

use super::splice::Splice;
use crate::diag::{Edit, Fix};
use crate::sure::small;
use crate::text::{FileId, SourceText, Span};

/// A file after some of its fixes.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Fixed {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Which fixes were applied, by their places among those given. Those that overlap others wait for a next round.
    pub applied: Vec<usize>,
}

/// Applies `fixes` to `bytes`, of which `source` is the text and `file` its number in the places. A fix is applied as a
/// whole or not at all: not when one of its edits is in another file, overlaps one that was taken before, or writes
/// letters that are not ASCII where they do not stand yet.
pub fn apply_fixes<'a>(
    source: &SourceText,
    file: FileId,
    bytes: &[u8],
    fixes: impl IntoIterator<Item = &'a Fix>,
) -> Fixed {
    let (edits, applied) = take(source, file, fixes);
    let mut splice = Splice::new(source, bytes);
    for (&start, &(end, text)) in &edits {
        splice.write(Span::new(start, end), text);
    }
    Fixed { bytes: splice.finish(), applied }
}

/// The edits that [`apply_fixes`] would make, in the order of the text.
pub fn compatible_edits<'a>(
    source: &SourceText,
    file: FileId,
    fixes: impl IntoIterator<Item = &'a Fix>,
) -> impl Iterator<Item = (Span, &'a str)> {
    let (edits, _) = take(source, file, fixes);
    edits.into_iter().map(|(start, (end, text))| (Span::new(start, end), text))
}

/// The edits of those fixes that can be applied together, by where they begin, and which fixes these are.
fn take<'a>(
    source: &SourceText,
    file: FileId,
    fixes: impl IntoIterator<Item = &'a Fix>,
) -> (BTreeMap<u32, (u32, &'a str)>, Vec<usize>) {
    let mut taken = Taken::default();
    let fixes = fixes.into_iter().enumerate();
    let applied = fixes.filter(|(_, fix)| taken.take(source, file, &fix.edits)).map(|(at, _)| at).collect();
    (taken.edits, applied)
}

/// Edits that do not overlap, by where they begin: where they end, and the text.
#[derive(Default)]
struct Taken<'a> {
    edits: BTreeMap<u32, (u32, &'a str)>,
}

impl<'a> Taken<'a> {
    /// Takes the edits, when all of them can be taken.
    fn take(&mut self, source: &SourceText, file: FileId, edits: &'a [Edit]) -> bool {
        let usable = |edit: &'a Edit| {
            let Span { start, end } = edit.at.span;
            let boundary = |offset: u32| source.text().is_char_boundary(offset as usize);
            let inside = edit.at.file == file && start <= end && boundary(start) && boundary(end);
            inside.then(|| writable(source, edit)).flatten()
        };
        let usable: Option<Vec<_>> = edits.iter().map(usable).collect();
        let Some(usable) = usable.filter(|usable| !usable.is_empty()) else { return false };
        let mut added = Vec::with_capacity(usable.len());
        for (span, text) in usable {
            if !self.is_free(span) {
                for start in added {
                    self.edits.remove(&start);
                }
                return false;
            }
            added.push(span.start);
            self.edits.insert(span.start, (span.end, text));
        }
        true
    }

    /// Whether no edit covers a part of the span, nor begins or inserts where it does.
    fn is_free(&self, span: Span) -> bool {
        let before = self.edits.range(..=span.start).next_back();
        let after = self.edits.range(span.start..).next();
        before.is_none_or(|(&start, &(end, _))| start < span.start && end <= span.start)
            && after.is_none_or(|(&start, _)| span.end <= start && start != span.start)
    }
}

/// The text of the edit, and its place; `None` when it has letters that are not ASCII.
fn writable<'a>(source: &SourceText, edit: &'a Edit) -> Option<(Span, &'a str)> {
    if source.encoding().is_utf16() {
        // A file in UTF-16 is only written anew as a whole, in UTF-8.
        let whole = edit.at.span == Span::new(0, source.len());
        return whole.then_some((edit.at.span, &edit.text));
    }
    if edit.text.is_ascii() {
        return Some((edit.at.span, &edit.text));
    }
    // A part of a line written again without its bracket: the letters that both have keep their bytes.
    let (span, text) = without_common_ends(source.slice(edit.at.span), edit);
    text.is_ascii().then_some((span, text))
}

/// The edit without the characters that both its ends have already.
fn without_common_ends<'a>(before: &str, edit: &'a Edit) -> (Span, &'a str) {
    let same = |pairs: &mut dyn Iterator<Item = (char, char)>| -> usize {
        pairs.take_while(|(old, new)| old == new).map(|(same, _)| same.len_utf8()).sum()
    };
    let text = edit.text.as_str();
    let tail = same(&mut before.chars().rev().zip(text.chars().rev()));
    let (before, text) = (&before[..before.len() - tail], &text[..text.len() - tail]);
    let head = same(&mut before.chars().zip(text.chars()));
    let Span { start, end } = edit.at.span;
    (Span::new(start + small(head), end - small(tail)), &text[head..])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Certain, FixTitle};
    use crate::text::{Encoding, Location};

    fn edit(start: usize, end: usize, text: &str) -> Edit {
        let span = Span::new(u32::try_from(start).unwrap(), u32::try_from(end).unwrap());
        Edit { at: Location { file: FileId(0), span }, text: text.to_owned() }
    }

    fn fix(edits: impl Into<Vec<Edit>>) -> Fix {
        Fix { title: FixTitle::UpperCase, edits: edits.into(), certain: Some(Certain::LowerCase) }
    }

    fn applied(bytes: &[u8], fixes: &[Fix]) -> (Vec<u8>, usize) {
        let source = SourceText::decode("a.nc", bytes.to_vec(), Encoding::Cp852).unwrap();
        let fixed = apply_fixes(&source, FileId(0), bytes, fixes);
        (fixed.bytes, fixed.applied.len())
    }

    /// LEX-13: what stands around a fix keeps its bytes, in UTF-8 and in a code page.
    #[test]
    fn encodings_and_line_ends_are_kept() {
        let dos = b"%1 \"p\xfd\xa1ruba\"\r\nn10 \"\xfd\" x5\r\n\x1a";
        let source = SourceText::decode("a.nc", dos.to_vec(), Encoding::Cp852).unwrap();
        let at = |text: &str| source.text().find(text).unwrap();
        let fixes = [fix([edit(at("n10"), at("n10") + 1, "N"), edit(at("x5"), at("x5") + 1, "X")])];
        assert_eq!(applied(dos, &fixes), (b"%1 \"p\xfd\xa1ruba\"\r\nN10 \"\xfd\" X5\r\n\x1a".to_vec(), 1));

        let utf8 = "\u{feff}%1 \"ř\" n10\r";
        let at = utf8.find("n10").unwrap();
        let fixed = applied(utf8.as_bytes(), &[fix([edit(at, at + 1, "N")])]);
        assert_eq!(fixed, ("\u{feff}%1 \"ř\" N10\r".as_bytes().to_vec(), 1));
    }

    /// LEX-13: letters of a code page that a fix repeats keep their bytes; others are not written.
    #[test]
    fn repeated_letters_keep_their_bytes() {
        let dos = b"N1 (X0 \"\xfd\xfd\"";
        assert_eq!(applied(dos, &[fix([edit(3, 13, "X0 \"řř\"")])]), (b"N1 X0 \"\xfd\xfd\"".to_vec(), 1));
        assert_eq!(applied(dos, &[fix([edit(3, 13, "X0 \"řřř\"")])]), (dos.to_vec(), 0));
        assert_eq!(applied(b"N1 (X0", &[fix([edit(3, 6, "\u{159}")])]), (b"N1 (X0".to_vec(), 0));
    }

    /// LEX-13: a file in UTF-16 is written anew in UTF-8.
    #[test]
    fn utf16_becomes_utf8() {
        let text = "\u{feff}%1 \"ř\" n10";
        let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(applied(&bytes, &[fix([edit(0, text.len(), &text[3..])])]), (text.as_bytes()[3..].to_vec(), 1));
        // A byte too much at the end is half a character.
        let odd = [bytes.as_slice(), b"X"].concat();
        let whole = fix([edit(0, text.len() + 3, &text[3..])]);
        assert_eq!(applied(&odd, &[whole]), (text.as_bytes()[3..].to_vec(), 1));
    }

    #[test]
    fn overlapping_fixes_wait() {
        let whole = fix([edit(0, 4, "wxyz")]);
        let inner = fix([edit(4, 5, "E"), edit(1, 2, "B")]);
        let behind = fix([edit(4, 6, "")]);
        assert_eq!(applied(b"abcdef", &[whole.clone(), inner.clone(), behind.clone()]), (b"wxyz".to_vec(), 2));
        assert_eq!(applied(b"abcdef", &[inner, whole, behind]), (b"aBcdEf".to_vec(), 1));
    }

    #[test]
    fn insertions_at_one_place_wait() {
        let insert = |text| fix([edit(2, 2, text)]);
        assert_eq!(applied(b"abcd", &[insert("1"), insert("2")]), (b"ab1cd".to_vec(), 1));
        assert_eq!(applied(b"abcd", &[insert("1"), fix([edit(2, 3, "C")])]), (b"ab1cd".to_vec(), 1));
        assert_eq!(applied(b"abcd", &[fix([edit(1, 3, "-")]), insert("1")]), (b"a-d".to_vec(), 1));
        assert_eq!(applied(b"abcd", &[fix([edit(0, 2, "-")]), insert("1")]), (b"-1cd".to_vec(), 2));
    }

    #[test]
    fn edits_that_cannot_be_made_are_left() {
        let mut elsewhere = edit(0, 1, "x");
        elsewhere.at.file = FileId(1);
        let fixes = [fix([elsewhere, edit(1, 2, "y")]), fix([edit(1, 2, "ř")]), fix([edit(3, 9, "")]), fix([])];
        assert_eq!(applied(b"abcd", &fixes), (b"abcd".to_vec(), 0));
        assert_eq!(applied("ář".as_bytes(), &[fix([edit(1, 2, "x")])]), ("ář".as_bytes().to_vec(), 0));
    }
}
