//! The files of one run.

use std::sync::Arc;

use super::{FileId, Location, SourceText};
use crate::sure::small;

/// The texts of a run, by [`FileId`]; the program is file 0.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<Arc<SourceText>>,
}

impl Sources {
    /// None yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a text.
    pub fn add(&mut self, source: impl Into<Arc<SourceText>>) -> FileId {
        let id = FileId(small(self.files.len()));
        self.files.push(source.into());
        id
    }

    /// The text of a file of this run.
    pub fn get(&self, file: FileId) -> Option<&Arc<SourceText>> {
        self.files.get(file.0 as usize)
    }

    /// The file that the user named so.
    pub fn find(&self, name: &str) -> Option<FileId> {
        self.iter().find(|(_, source)| source.name() == name).map(|(id, _)| id)
    }

    /// Every file.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Arc<SourceText>)> {
        (0..).map(FileId).zip(&self.files)
    }

    /// The text at a place; empty when there is no such place.
    pub fn slice(&self, at: Location) -> &str {
        self.get(at.file).map_or("", |source| source.slice(at.span))
    }
}
