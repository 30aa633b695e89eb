//! The tree of one file: blocks as ranges of one arena of words.

use std::ops::Range;
use std::sync::Arc;

use super::{Form, Word};
use crate::diag::Diagnostic;
use crate::dict::{Address, GCode, HIGHEST_BLOCK};
use crate::sure::{Sure, small};
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

/// Facts about a block that need no look at its words.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct BlockFlags(pub u16);

impl BlockFlags {
    /// Carries `/`.
    pub const SKIP: Self = Self(1);
    /// Something in it has no word: characters or text that mean nothing.
    pub const DEBRIS: Self = Self(1 << 1);
    /// Has a G, M, L or Q word, a parameter, or a faulty word: more than axis words, F, S and the like, and one G00 or
    /// G01.
    pub const RICH: Self = Self(1 << 2);
    /// A comment belongs to it (BLK-9).
    pub const COMMENT: Self = Self(1 << 3);
    /// Has M02 or M30 written out.
    pub const END: Self = Self(1 << 4);
    /// Has G70 written out.
    pub const RETURN: Self = Self(1 << 5);
    /// Has G79 written out.
    pub const ENTRY: Self = Self(1 << 6);
    /// Has an axis word.
    pub const AXES: Self = Self(1 << 7);
    /// Has a word besides `N`, axis words and one G00 or G01.
    pub const OTHERS: Self = Self(1 << 8);
    /// Is two blocks: a line of it lacks its block number. Set after parsing.
    pub const MERGED: Self = Self(1 << 9);
    /// Its first G word is a G00 in digits.
    pub const RAPID: Self = Self(1 << 10);
    /// Its first G word is a G01 in digits.
    pub const LINEAR: Self = Self(1 << 11);

    /// Whether all of `flags` are set.
    pub const fn has(self, flags: Self) -> bool {
        self.0 & flags.0 == flags.0
    }

    /// Whether it is a point: a block of axis words and no others but a G00 or G01, with nothing that has no word.
    pub const fn is_point(self) -> bool {
        self.0 & !(Self::COMMENT.0 | Self::RAPID.0 | Self::LINEAR.0) == Self::AXES.0
    }

    /// Whether it is a point that has no function but, again, the one that `in_force` tells.
    const fn goes_on(self, in_force: Self) -> bool {
        self.0 & !(Self::COMMENT.0 | in_force.0) == Self::AXES.0
    }

    /// That of a function that moves straight; of others none.
    pub const fn of_straight(function: GCode) -> Self {
        match function.number() {
            0 => Self::RAPID,
            1 => Self::LINEAR,
            _ => Self(0),
        }
    }

    /// The function of [`Self::RAPID`] or [`Self::LINEAR`].
    pub const fn straight(self) -> Option<GCode> {
        if self.has(Self::RAPID) {
            Some(GCode::G00)
        } else if self.has(Self::LINEAR) {
            Some(GCode::G01)
        } else {
            None
        }
    }

    /// Takes `flags` away.
    pub const fn clear(&mut self, flags: Self) {
        self.0 &= !flags.0;
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
        let words = small(words);
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
    /// Its form.
    pub form: Form,
    /// The `%` word; `None` in a macrocycle, or when it is missing.
    pub program: Option<Word>,
    /// The title: the text of the first comment between `%` and the first `N`, trimmed, not empty (BLK-9).
    pub title: Option<Span>,
    /// The words before the first `N`, which belong to no block (BLK-2).
    pub outside: Vec<Word>,
    /// Where a second `%` with a number begins a line: what follows it is another program (LEX-1).
    pub second_program: Option<u32>,
    /// Where the part that is read begins: at `%`.
    pub start: u32,
    /// Where it ends: after `*`, or at the end of the text without its trailing Ctrl-Z and NULs.
    pub end: u32,
    pub(super) words: Vec<Word>,
    pub(super) comments: Vec<Span>,
    pub(super) blocks: Vec<Block>,
    /// The finding of addresses in lower case, which is given when all that is written has been looked at.
    pub(super) case: Option<Box<Diagnostic>>,
    /// The findings about the `*` that ends the file: the text behind it, a word without its value before it. They are
    /// given unless the structure tells that the program goes on behind the `*`.
    pub(super) at_star: Vec<Diagnostic>,
}

impl ParsedFile {
    /// The finding of addresses in lower case (LEX-11).
    pub fn take_case(&mut self) -> Option<Diagnostic> {
        self.case.take().map(|case| *case)
    }

    /// The findings about the `*` that ends the file, which the structure may explain (LEX-9).
    pub fn take_findings_at_star(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.at_star)
    }

    /// Number of blocks.
    pub fn block_count(&self) -> u32 {
        small(self.blocks.len())
    }

    /// All blocks, in the order of the text.
    pub fn block_ids(&self) -> impl DoubleEndedIterator<Item = BlockId> + use<> {
        (0..self.block_count()).map(BlockId)
    }

    /// One past the last block of the file's own program: what follows a second `%` with a number is another one.
    pub fn program_end(&self) -> BlockId {
        let end = self.second_program.map_or(self.blocks.len(), |second| {
            self.blocks
                .partition_point(|block| self.words.get(block.first_word as usize).is_some_and(|n| n.start() < second))
        });
        BlockId(small(end))
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
        u32::try_from(number).ok().filter(|number| (1..=HIGHEST_BLOCK).contains(number))
    }

    /// The number of a block for a message; 0 when it has none.
    pub fn shown_number(&self, block: BlockId) -> u32 {
        self.number(block).unwrap_or(0)
    }

    /// The block that a place is in: from its `N` up to the next one.
    pub fn block_at(&self, offset: u32) -> Option<BlockId> {
        let starts = |block: &Block| self.words.get(block.first_word as usize).is_some_and(|n| n.start() <= offset);
        let behind = self.blocks.partition_point(starts);
        behind.checked_sub(1).and_then(|at| u32::try_from(at).ok()).map(BlockId)
    }

    /// The words of a block after its `N`.
    #[inline]
    pub fn words(&self, block: BlockId) -> &[Word] {
        let range = self.word_range(block);
        self.words.get(range.start as usize + 1..range.end as usize).sure()
    }

    fn word_range(&self, block: BlockId) -> Range<u32> {
        let start = self.blocks.get(block.index()).map_or(0, |block| block.first_word);
        let end = self.blocks.get(block.index() + 1).map_or_else(|| small(self.words.len()), |next| next.first_word);
        start..end
    }

    /// The comments that belong to a block, quotes included, in the order of the text (BLK-9): those between its words
    /// and behind them on the same line, and those on lines of their own above it. Behind the last block all are its
    /// own.
    pub fn comments(&self, block: BlockId) -> &[Span] {
        let start = self.comments_owned_before(block);
        let end = self.comments_owned_before(block.next());
        self.comments.get(start..end).sure()
    }

    /// How many comments belong to the program or to blocks before this one; all of them when there is no such block.
    /// Comments are few: whose they are follows from their places.
    fn comments_owned_before(&self, block: BlockId) -> usize {
        let Some(n) = self.n_word(block) else { return self.comments.len() };
        let Some(before) = block.0.checked_sub(1) else {
            return if self.form == Form::Macrocycle { 0 } else { self.comments_before(block) };
        };
        let mut line_to = self.words_end(BlockId(before));
        let mut count = self.comments.partition_point(|comment| comment.start < line_to);
        // Those behind the last word on its line are still of the block before.
        while let Some(comment) = self.comments.get(count).filter(|comment| comment.start < n.start()) {
            if self.breaks_line(line_to, comment.start) {
                break;
            }
            line_to = comment.end;
            count += 1;
        }
        count
    }

    /// Whether a line ends between two places.
    fn breaks_line(&self, from: u32, to: u32) -> bool {
        let between = self.source.slice(Span::new(from.min(to), to));
        memchr::memchr2(b'\n', b'\r', between.as_bytes()).is_some()
    }

    /// Where the last word of a block ends.
    fn words_end(&self, block: BlockId) -> u32 {
        let last = self.words(block).last().copied().or(self.n_word(block));
        last.map_or(self.start, |word| word.span(self.source.text()).end)
    }

    /// Marks the blocks that comments belong to.
    pub(super) fn mark_commented(&mut self) {
        let mut behind: Option<BlockId> = None;
        // The end of what is read of the line of that block's last word; `None` once the line has ended.
        let mut line: Option<u32> = None;
        for at in 0..self.comments.len() {
            let Some(comment) = self.comments.get(at).copied() else { break };
            let mut next = behind.map_or(BlockId(0), BlockId::next);
            while self.n_word(next).is_some_and(|n| n.start() <= comment.start) {
                behind = Some(next);
                line = Some(self.words_end(next));
                next = next.next();
            }
            line = line.filter(|end| *end > comment.start || !self.breaks_line(*end, comment.start));
            let owner = match (behind, line) {
                (None, _) if self.form == Form::Program => continue,
                (Some(block), Some(end)) => {
                    line = Some(end.max(comment.end));
                    block
                }
                (Some(block), None) if next.0 >= self.block_count() => block,
                (_, _) => next,
            };
            if let Some(block) = self.blocks.get_mut(owner.index()) {
                block.flags.set(BlockFlags::COMMENT);
            }
        }
    }

    /// The comments between the `N` of a block and the next one, quotes included, whichever block they belong to.
    pub fn comments_behind(&self, block: BlockId) -> &[Span] {
        let start = self.comments_before(block);
        let end = self.comments_before(block.next());
        self.comments.get(start..end).sure()
    }

    /// How many comments stand before the `N` of a block; all of them when there is no such block.
    fn comments_before(&self, block: BlockId) -> usize {
        let before = |n: Word| self.comments.partition_point(|comment| comment.start < n.start());
        self.n_word(block).map_or(self.comments.len(), before)
    }

    /// The comments before the first block, quotes included.
    pub fn comments_before_blocks(&self) -> &[Span] {
        self.comments.get(..self.comments_before(BlockId(0))).sure()
    }

    /// The texts of the program's comments: those between its number and the first `N`, the title included, trimmed,
    /// empty ones left out (BLK-9).
    pub fn program_comments(&self) -> impl Iterator<Item = &str> {
        let number_end = self.program.map_or(u32::MAX, |word| word.span(self.source.text()).end);
        self.comments_before_blocks()
            .iter()
            .filter(move |comment| comment.start >= number_end)
            .map(|comment| self.comment_text(*comment))
            .filter(|text| !text.is_empty())
    }

    /// Every comment of the file, quotes included, in the order of the text.
    pub fn all_comments(&self) -> &[Span] {
        &self.comments
    }

    /// How many points (see [`BlockFlags::is_point`]) follow each other from a block on, before another one, that have
    /// no function but, again, the one that `in_force` tells.
    pub fn points_in_a_row(&self, from: BlockId, before: BlockId, in_force: BlockFlags) -> u32 {
        let blocks = self.blocks.get(from.index()..before.index()).sure();
        let count = blocks.iter().take_while(|block| block.flags.goes_on(in_force)).count();
        small(count)
    }

    /// The last of some blocks whose function these flags tell, with its word.
    pub fn last_straight(&self, blocks: Range<BlockId>, function: BlockFlags) -> Option<(BlockId, Word)> {
        let found = self.blocks.get(blocks.start.index()..blocks.end.index()).sure();
        let last = found.iter().rposition(|block| block.flags.has(function))?;
        let block = BlockId(blocks.start.0 + small(last));
        Some((block, self.g_word(block)?))
    }

    /// The first G word of a block.
    pub fn g_word(&self, block: BlockId) -> Option<Word> {
        self.words(block).iter().copied().find(|word| word.address == Address::G)
    }

    /// The facts about a block.
    #[inline]
    pub fn flags(&self, block: BlockId) -> BlockFlags {
        self.blocks.get(block.index()).map_or(BlockFlags::default(), |block| block.flags)
    }

    /// The text between the quotes of a comment, trimmed of blanks and tabs.
    pub fn comment_text(&self, comment: Span) -> &str {
        comment_text(self.source.slice(comment))
    }

    /// Takes the value away from the words that begin at those places: it is not one that their addresses take.
    pub fn refuse(&mut self, starts: &[u32]) {
        for start in starts {
            let at = self.words.partition_point(|word| word.start() < *start);
            if let Some(word) = self.words.get_mut(at).filter(|word| word.start() == *start) {
                *word = word.refused();
            }
        }
    }

    /// Notes that these blocks are two each.
    pub fn mark_merged(&mut self, blocks: impl Iterator<Item = BlockId>) {
        for block in blocks {
            if let Some(block) = self.blocks.get_mut(block.index()) {
                block.flags.set(BlockFlags::MERGED);
            }
        }
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

/// The text of a comment token: without its quotes, trimmed of blanks and tabs.
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
