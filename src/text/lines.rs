//! Where the lines of a text begin. Lines end with CR LF, LF or CR, and with nothing else (LEX-8).

use crate::sure::{Sure, small};

/// A place as users count it: both from 1, the column in characters.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub struct LineColumn {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// The offsets at which lines begin.
#[derive(Clone, Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
}

impl LineIndex {
    /// Indexes `text`, whose first line begins at `first` (after a byte-order mark).
    pub fn new(text: &str, first: u32) -> Self {
        let bytes = text.as_bytes();
        let mut starts = vec![first];
        for at in memchr::memchr2_iter(b'\n', b'\r', bytes) {
            let crlf_middle = bytes.get(at) == Some(&b'\r') && bytes.get(at + 1) == Some(&b'\n');
            if !crlf_middle {
                starts.push(small(at + 1));
            }
        }
        Self { starts }
    }

    /// Follows a change: the bytes of `text` from `from` to `inserted_end` replace those that were between `from` and
    /// `removed_end`.
    pub(super) fn replaced(&mut self, text: &str, from: u32, removed_end: u32, inserted_end: u32) {
        // The byte before the change may be the CR of a CR LF that comes to be or is no more, and so may the one
        // behind.
        let window = self.line_at(from.saturating_sub(1));
        let kept_to = self.starts.partition_point(|&start| start <= removed_end.saturating_add(1));
        let behind = self.starts.split_off(kept_to);
        self.starts.truncate(window + 1);
        let begin = self.starts.last().copied().unwrap_or(0);
        let end = (inserted_end as usize + 1).min(text.len());
        let bytes = text.as_bytes();
        for at in memchr::memchr2_iter(b'\n', b'\r', bytes.get(begin as usize..end).sure()) {
            let at = begin as usize + at;
            if !(bytes.get(at) == Some(&b'\r') && bytes.get(at + 1) == Some(&b'\n')) {
                self.starts.push(small(at + 1));
            }
        }
        let last = self.starts.last().copied().unwrap_or(0);
        let moved = behind.into_iter().map(|start| (start - removed_end).saturating_add(inserted_end));
        self.starts.extend(moved.filter(|&start| start > last));
    }

    /// Index from 0 of the line that holds `offset`.
    pub fn line_at(&self, offset: u32) -> usize {
        self.starts.partition_point(|&start| start <= offset).saturating_sub(1)
    }

    /// Like [`Self::line_at`], quick when `hint` is the line of a place shortly before: execution mostly moves on.
    pub fn line_near(&self, offset: u32, hint: usize) -> usize {
        let mut line = hint;
        for _ in 0..4 {
            let here = self.starts.get(line).is_some_and(|&start| start <= offset);
            let before_next = self.starts.get(line + 1).is_none_or(|&next| offset < next);
            match (here, before_next) {
                (true, true) => return line,
                (true, false) => line += 1,
                (false, _) => break,
            }
        }
        self.line_at(offset)
    }

    /// Where line `line` (from 0) begins.
    pub fn start(&self, line: usize) -> Option<u32> {
        self.starts.get(line).copied()
    }

    /// Number of lines; a text that ends with a line end has an empty last one.
    pub fn count(&self) -> usize {
        self.starts.len()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// A changed index is the index of the changed text, whatever happens to CR LF at the borders.
        #[test]
        fn follows_changes(text in "[a\r\n]{0,12}", inserted in "[b\r\n]{0,4}", from in 0_usize..13, length in 0_usize..5) {
            let from = from.min(text.len());
            let to = (from + length).min(text.len());
            let mut index = LineIndex::new(&text, 0);
            let mut changed = text.clone();
            changed.replace_range(from..to, &inserted);
            let place = |at: usize| u32::try_from(at).unwrap();
            index.replaced(&changed, place(from), place(to), place(from + inserted.len()));
            prop_assert_eq!(index.starts, LineIndex::new(&changed, 0).starts);
        }
    }

    /// LEX-8: only CR and LF end lines; VT, FF, NEL and U+2028 do not.
    #[test]
    fn line_ends() {
        let index = LineIndex::new("a\r\nb\rc\n\u{b}\u{c}\u{85}\u{2028}d\n", 0);
        assert_eq!(index.starts, [0, 3, 5, 7, 16]);
        assert_eq!(index.line_at(4), 1);
        assert_eq!(index.line_near(5, 0), 2);
        assert_eq!(index.line_near(0, 3), 0);
    }
}
