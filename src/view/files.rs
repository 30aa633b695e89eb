//! The files of an executed program and the blocks in their texts, whether executed or not.

use std::sync::Arc;

use super::column::Column;
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile};
use crate::text::{FileId, SourceText};

/// One file: its text, and where its blocks begin.
#[derive(Debug)]
pub(super) struct PageFile {
    id: FileId,
    pub source: Arc<SourceText>,
    /// Index of its first block among the blocks of all files.
    pub first: u32,
    /// Where the `N` of each block stands.
    pub starts: Vec<u32>,
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
}

impl Files {
    /// Takes up a file, unless it is known; files come in the order of their indices.
    pub fn add(&mut self, index: u32, parsed: &ParsedFile) {
        if index as usize >= self.files.len() {
            let first = small(self.n.len());
            let source = Arc::clone(&parsed.source);
            let mut starts = Vec::with_capacity(parsed.block_count() as usize);
            let mut line = 0;
            for block in parsed.block_ids() {
                let start = parsed.n_word(block).map_or(0, |word| word.start());
                line = source.lines().line_near(start, line);
                let place = source.column_in(line, start);
                self.n.push(i64::from(parsed.shown_number(block)));
                self.line.push(i64::from(place.line));
                self.column.push(i64::from(place.column));
                starts.push(start);
            }
            self.files.push(PageFile { id: parsed.file, source, first, starts });
        }
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

    /// The index of the block whose `N` stands at an offset of a file.
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
