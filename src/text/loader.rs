//! How files arrive: from disk, from memory in tests, from an editor's buffers.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Encoding, SourceText};

/// Where bytes come from. The core reads files through this and in no other way.
pub trait Loader: Sync {
    /// The bytes of a file.
    ///
    /// # Errors
    /// What the operating system says; [`io::ErrorKind::NotFound`] when there is no such file.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The text of a program or macrocycle, called `name`; `fallback` decodes what is not UTF-8 (LEX-13). A loader that
    /// has the text decoded already, as an editor's buffer is, gives that.
    ///
    /// # Errors
    /// Those of [`Self::read`], and [`io::ErrorKind::FileTooLarge`] from 4 GiB on.
    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        let bytes = self.read(path)?;
        let source = SourceText::decode(name, bytes, fallback).map_err(|_| io::ErrorKind::FileTooLarge)?;
        Ok(Arc::new(source))
    }

    /// The files of a folder (not of folders in it), sorted; none when the folder cannot be read.
    fn list(&self, folder: &Path) -> Vec<PathBuf>;

    /// One name for each file, by whatever path it is reached.
    fn canonical(&self, path: &Path) -> PathBuf;
}

/// Files in memory: for tests, and for callers that have texts and no disk.
#[derive(Clone, Debug, Default)]
pub struct MemoryLoader {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl MemoryLoader {
    /// No files.
    pub fn new() -> Self {
        Self::default()
    }

    /// With one more file.
    #[must_use]
    pub fn with(mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.insert(path.into(), bytes.into());
        self
    }
}

impl Loader for MemoryLoader {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.files.get(path).cloned().ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.files.keys().filter(|path| path.parent() == Some(folder)).cloned().collect()
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}
