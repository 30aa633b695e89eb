//! The files of an executed program and the blocks in their texts, whether executed or not.

use std::sync::Arc;

use super::column::Column;
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile};
use crate::text::{FileId, LastPlaces, SourceText, Span};

/// One file: its text, and where its blocks begin.
#[derive(Debug)]
pub(super) struct PageFile {
    id: FileId,
    pub source: Arc<SourceText>,
    /// Index of its first block among the blocks of all files.
    pub first: u32,
    /// Where the `N` of each block stands.
    pub starts: Vec<u32>,
    /// The comments of its blocks, quotes included.
    pub comments: Vec<Span>,
}

/// The blocks of all files: file by file, in the order of the text.
#[derive(Debug, Default)]
pub(super) struct Files {
    /// By the index that streams give a file.
    files: Vec<PageFile>,
    /// Number, line and column of each block's `N`.
    pub n: Column,
    pub line: Column,
    pub column: Column,
    /// How many comments belong to each block.
    pub own: Column,
    /// Nothing but numbers is kept: for pictures without texts.
    numbers_only: bool,
}

impl Files {
    /// None yet. `numbers_only`: for pictures without texts.
    pub fn new(numbers_only: bool) -> Self {
        Self { numbers_only, ..Self::default() }
    }

    /// Takes up a file, unless it is known; files come in the order of their indices.
    pub fn add(&mut self, index: u32, parsed: &ParsedFile) {
        if index as usize >= self.files.len() {
            let first = small(self.n.len());
            let source = Arc::clone(&parsed.source);
            let (mut starts, mut comments) = (Vec::new(), Vec::new());
            let mut places = LastPlaces::default();
            for block in parsed.block_ids() {
                self.n.push(i64::from(parsed.shown_number(block)));
                if self.numbers_only {
                    continue;
                }
                let start = parsed.n_word(block).map_or(0, |word| word.start());
                let place = places.of(FileId(0), &source, start);
                self.line.push(i64::from(place.line));
                self.column.push(i64::from(place.column));
                starts.push(start);
                let own: &[Span] =
                    if parsed.flags(block).has(BlockFlags::COMMENT) { parsed.comments(block) } else { &[] };
                comments.extend_from_slice(own);
                self.own.push(i64::from(small(own.len())));
            }
            self.files.push(PageFile { id: parsed.file, source, first, starts, comments });
        }
    }

    /// The bytes that they take, without the texts.
    pub fn memory(&self) -> usize {
        let columns = [&self.n, &self.line, &self.column, &self.own].map(Column::memory).iter().sum::<usize>();
        let of = |file: &PageFile| 4 * file.starts.capacity() + 8 * file.comments.capacity();
        columns + self.files.iter().map(of).sum::<usize>()
    }

    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    pub fn iter(&self) -> impl Iterator<Item = &PageFile> {
        self.files.iter()
    }

    /// The index of a block among those of all files.
    pub fn block(&self, file: u32, block: BlockId) -> u32 {
        self.files.get(file as usize).map_or(0, |known| known.first.saturating_add(block.0))
    }

    /// The index of the block whose `N` is at an offset of a file.
    pub fn block_at(&self, file: FileId, offset: u32) -> u32 {
        let file = self.files.iter().find(|known| known.id == file);
        file.map_or(0, |file| {
            let before = file.starts.partition_point(|start| *start < offset);
            file.first.saturating_add(small(before))
        })
    }

    /// The index of a file by its name.
    pub fn index_of(&self, name: &str) -> Option<usize> {
        self.files.iter().position(|file| file.source.name() == name)
    }
}
