//! The files of another loader, with one text in the place of a file.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::text::{Encoding, Loader, Numbered, SourceText};

/// One text over other files.
pub(super) struct Overlay<'a> {
    below: &'a dyn Loader,
    path: &'a Path,
    text: String,
}

impl<'a> Overlay<'a> {
    /// `text` stands at `path`.
    pub fn new(below: &'a dyn Loader, path: &'a Path, text: String) -> Self {
        Self { below, path, text }
    }
}

impl Loader for Overlay<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == self.path { Ok(self.text.clone().into_bytes()) } else { self.below.read(path) }
    }

    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        if path == self.path {
            return Ok(Arc::new(SourceText::from_text(name, self.text.clone())));
        }
        self.below.load(path, name, fallback)
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.below.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.below.folders(folder)
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.below.is_folder(path)
    }

    fn numbered(&self, folders: &[PathBuf], number: &dyn Fn() -> Numbered) -> Arc<Numbered> {
        self.below.numbered(folders, number)
    }

    fn head(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        self.below.head(path, limit)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.below.canonical(path)
    }
}
