//! The tree of one file: blocks as ranges of one arena of words.

use std::ops::Range;
use std::sync::Arc;

use super::Word;
use crate::text::{FileId, Location, SourceText, Span};

/// Index of a block in its file.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub struct BlockId(pub u32);

impl BlockId {
    /// The block after this one.
    #[must_use]
    pub const fn next(self) -> Self {
        Self(self.0 + 1)
    }

    /// As an index.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// What is known of a block without looking at its words. Set while parsing and by the first look of `resolve`.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct BlockFlags(pub u8);

impl BlockFlags {
    /// Carries `/`.
    pub const SKIP: Self = Self(1);
    /// Something in it has no word: characters or text that mean nothing.
    pub const DEBRIS: Self = Self(1 << 1);
    /// Has a G, M, L or Q word, a parameter, or a faulty word: more than axis words, F, S and the like.
    pub const RICH: Self = Self(1 << 2);
    /// Has a comment.
    pub const COMMENT: Self = Self(1 << 3);
    /// Has M02 or M30 written out.
    pub const END: Self = Self(1 << 4);
    /// Has G70 written out.
    pub const RETURN: Self = Self(1 << 5);
    /// Has G79 written out.
    pub const ENTRY: Self = Self(1 << 6);

    /// Whether all of `flags` are set.
    pub const fn has(self, flags: Self) -> bool {
        self.0 & flags.0 == flags.0
    }

    /// Sets `flags`.
    pub const fn set(&mut self, flags: Self) {
        self.0 |= flags.0;
    }
}

/// A block: its first word is `N`, the others follow up to the next block's.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub(super) first_word: u32,
    pub(super) flags: BlockFlags,
}

impl Block {
    /// The same block when its file's arena begins with `words` words more.
    pub(super) fn shifted(self, words: usize) -> Self {
        let words = u32::try_from(words).unwrap_or(u32::MAX);
        Self { first_word: self.first_word.saturating_add(words), flags: self.flags }
    }
}

/// A parsed file: what stands before its first block, and its blocks.
#[derive(Debug)]
pub struct ParsedFile {
    /// Which file.
    pub file: FileId,
    /// Its text.
    pub source: Arc<SourceText>,
    /// The `%` word; `None` in a macrocycle, or when it is missing.
    pub program: Option<Word>,
    /// The title: the text of the first comment between `%` and the first `N`, trimmed, not empty (BLK-9).
    pub title: Option<Span>,
    /// Where the part that is read begins: at `%`.
    pub start: u32,
    /// Where it ends: after `*`, or at the end of the text without its trailing Ctrl-Z and NULs.
    pub end: u32,
    pub(super) words: Vec<Word>,
    pub(super) comments: Vec<Span>,
    pub(super) blocks: Vec<Block>,
}

impl ParsedFile {
    /// Number of blocks.
    pub fn block_count(&self) -> u32 {
        u32::try_from(self.blocks.len()).unwrap_or(u32::MAX)
    }

    /// All blocks, in the order of the text.
    pub fn block_ids(&self) -> impl DoubleEndedIterator<Item = BlockId> + use<> {
        (0..self.block_count()).map(BlockId)
    }

    /// The `N` word of a block.
    pub fn n_word(&self, block: BlockId) -> Option<Word> {
        let first = self.blocks.get(block.index())?.first_word;
        self.words.get(first as usize).copied()
    }

    /// The number of a block; `None` when it is missing or malformed.
    #[inline]
    pub fn number(&self, block: BlockId) -> Option<u32> {
        let number = self.n_word(block)?.whole()?;
        u32::try_from(number).ok().filter(|number| (1..=99_999_999).contains(number))
    }

    /// The number of a block for a message; 0 when it has none.
    pub fn shown_number(&self, block: BlockId) -> u32 {
        self.number(block).unwrap_or(0)
    }

    /// The words of a block after its `N`.
    #[inline]
    pub fn words(&self, block: BlockId) -> &[Word] {
        let range = self.word_range(block);
        self.words.get(range.start as usize + 1..range.end as usize).unwrap_or_default()
    }

    fn word_range(&self, block: BlockId) -> Range<u32> {
        let start = self.blocks.get(block.index()).map_or(0, |block| block.first_word);
        let end = self
            .blocks
            .get(block.index() + 1)
            .map_or_else(|| u32::try_from(self.words.len()).unwrap_or(u32::MAX), |next| next.first_word);
        start..end
    }

    /// The comments of a block, quotes included (BLK-9).
    pub fn comments(&self, block: BlockId) -> &[Span] {
        let start = self.comments_before(block);
        let end = self.comments_before(block.next());
        self.comments.get(start..end).unwrap_or_default()
    }

    /// How many comments stand before a block; all of them when there is no such block. Comments are few: what they belong to
    /// is told by their places.
    fn comments_before(&self, block: BlockId) -> usize {
        let before = |n: Word| self.comments.partition_point(|comment| comment.start < n.start());
        self.n_word(block).map_or(self.comments.len(), before)
    }

    /// The comments before the first block, quotes included.
    pub fn comments_before_blocks(&self) -> &[Span] {
        self.comments.get(..self.comments_before(BlockId(0))).unwrap_or_default()
    }

    /// What is known of a block.
    #[inline]
    pub fn flags(&self, block: BlockId) -> BlockFlags {
        self.blocks.get(block.index()).map_or(BlockFlags::default(), |block| block.flags)
    }

    /// The text between the quotes of a comment, trimmed of blanks and tabs.
    pub fn comment_text(&self, comment: Span) -> &str {
        comment_text(self.source.slice(comment))
    }

    /// A place in this file.
    pub const fn at(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    /// The place of a block's `N` word.
    pub fn n_place(&self, block: BlockId) -> Location {
        self.at(self.n_word(block).map_or(Span::empty(self.start), |word| word.span(self.source.text())))
    }

    /// The place of a word.
    pub fn word_place(&self, word: Word) -> Location {
        self.at(word.span(self.source.text()))
    }

    /// The place of a word's value.
    pub fn value_place(&self, word: Word) -> Location {
        self.at(word.parts(self.source.text()).value)
    }

    /// Every word of the file, `%` and `N` words included, in the order of the text.
    pub fn all_words(&self) -> impl Iterator<Item = Word> + '_ {
        self.program.into_iter().chain(self.words.iter().copied())
    }
}

/// What a comment token says: without its quotes, trimmed of blanks and tabs.
pub(super) fn comment_text(token: &str) -> &str {
    let quote = |character: char| matches!(character, '"' | '“' | '”' | '„');
    // A comment that begins with `"` ends with `"` only: other quotes in it are text (LEX-6).
    let inner = match token.strip_prefix('"') {
        Some(inner) => inner.strip_suffix('"').unwrap_or(inner),
        None => {
            let inner = token.strip_prefix(quote).unwrap_or(token);
            inner.strip_suffix(quote).unwrap_or(inner)
        }
    };
    inner.trim_matches([' ', '\t'])
}
