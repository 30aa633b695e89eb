//! How files arrive: from disk, from memory in tests, from an editor's buffers.

use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, BufRead};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{DecodeError, Encoding, SourceText};

/// The error of a loader when a path is a link that leads to no file, in contrast to a file that does not exist.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct BrokenLink;

impl fmt::Display for BrokenLink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the link leads to no file")
    }
}

impl std::error::Error for BrokenLink {}

impl BrokenLink {
    /// As an error of [`Loader::read`].
    pub fn error() -> io::Error {
        io::Error::other(Self)
    }

    /// Whether the error says this.
    pub fn is(error: &io::Error) -> bool {
        error.get_ref().is_some_and(|inner| inner.is::<Self>())
    }
}

/// The error of a file that must be in UTF-8 and is not: the first byte that is not valid, and its line.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct NotUtf8 {
    /// The line, from 1.
    pub line: usize,
    /// The byte.
    pub byte: u8,
}

impl NotUtf8 {
    /// Of the byte at `at`.
    pub(super) fn at(bytes: &[u8], at: usize) -> Self {
        let before = bytes.get(..at).unwrap_or_default();
        let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
        Self { line, byte: bytes.get(at).copied().unwrap_or_default() }
    }

    /// Reads these details back from a loader's error.
    pub fn of(error: &io::Error) -> Option<Self> {
        error.get_ref()?.downcast_ref().copied()
    }
}

impl fmt::Display for NotUtf8 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "byte {:02X}h in line {} is not UTF-8", self.byte, self.line)
    }
}

impl std::error::Error for NotUtf8 {}

impl From<DecodeError> for io::Error {
    fn from(error: DecodeError) -> Self {
        match error {
            DecodeError::TooLarge => io::ErrorKind::FileTooLarge.into(),
            DecodeError::NotUtf8(byte) => Self::new(io::ErrorKind::InvalidData, byte),
        }
    }
}

/// Files of some folders by the number that their names say.
pub type Numbered = BTreeMap<u32, Vec<PathBuf>>;

/// Where bytes come from. The core reads files through this and in no other way.
pub trait Loader: Sync {
    /// The bytes of a file.
    ///
    /// # Errors
    /// The operating system's error; [`io::ErrorKind::NotFound`] when there is no such file, [`BrokenLink::error`] when
    /// there is a link that leads to none.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The text of a program or macrocycle, called `name`; `fallback` decodes what is not UTF-8 (LEX-13). A loader that
    /// has the text decoded already, as an editor's buffer is, gives that.
    ///
    /// # Errors
    /// Those of [`Self::read`], [`io::ErrorKind::FileTooLarge`] from 4 GiB on, and [`NotUtf8`] where `fallback` is
    /// UTF-8.
    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        let bytes = self.read(path)?;
        let source = SourceText::decode(name, bytes, fallback)?;
        Ok(Arc::new(source))
    }

    /// How many bytes a file has; `None` when it cannot be read.
    fn size(&self, path: &Path) -> Option<u64> {
        self.read(path).ok().map(|bytes| bytes.len() as u64)
    }

    /// The files of a folder (not of folders in it), sorted; none when the folder cannot be read.
    fn list(&self, folder: &Path) -> Vec<PathBuf>;

    /// The folders in a folder, sorted; links to folders are left out. None when the folder cannot be read.
    fn folders(&self, folder: &Path) -> Vec<PathBuf>;

    /// Whether there is a folder at that path; the empty path is the working folder. A loader that cannot tell an empty
    /// folder from none may say no to it.
    fn is_folder(&self, path: &Path) -> bool {
        path.as_os_str().is_empty() || !self.list(path).is_empty() || !self.folders(path).is_empty()
    }

    /// What `number` makes of the files of these folders. A loader that serves one run keeps it for the next program
    /// that asks: with many programs in one folder, looking at all files for each of them takes time by the square.
    fn numbered(&self, _folders: &[PathBuf], number: &dyn Fn() -> Numbered) -> Arc<Numbered> {
        Arc::new(number())
    }

    /// The first bytes of a file, at most `limit`.
    ///
    /// # Errors
    /// Those of [`Self::read`].
    fn head(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        let mut bytes = self.read(path)?;
        bytes.truncate(limit);
        Ok(bytes)
    }

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

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        let inner = |path: &PathBuf| {
            let within = path.ancestors().skip(1).find(|above| above.parent() == Some(folder))?;
            Some(within.to_path_buf())
        };
        let mut found: Vec<PathBuf> = self.files.keys().filter_map(inner).collect();
        found.dedup();
        found
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// The files of another loader, with these bytes for one of them.
pub struct Overlay<'a> {
    /// Where other files come from.
    pub below: &'a dyn Loader,
    /// The file.
    pub path: &'a Path,
    /// Its bytes.
    pub bytes: &'a [u8],
}

impl fmt::Debug for Overlay<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Overlay").field("path", &self.path).finish_non_exhaustive()
    }
}

impl Overlay<'_> {
    /// Whether a path is one of the file's.
    fn is_it(&self, path: &Path) -> bool {
        path == self.path || self.below.canonical(path) == self.below.canonical(self.path)
    }
}

impl Loader for Overlay<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if self.is_it(path) { Ok(self.bytes.to_vec()) } else { self.below.read(path) }
    }

    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        if self.is_it(path) {
            return Ok(Arc::new(SourceText::decode(name, self.bytes.to_vec(), fallback)?));
        }
        self.below.load(path, name, fallback)
    }

    fn size(&self, path: &Path) -> Option<u64> {
        if self.is_it(path) { Some(self.bytes.len() as u64) } else { self.below.size(path) }
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

    fn canonical(&self, path: &Path) -> PathBuf {
        self.below.canonical(path)
    }
}

/// Whether a line begins with `%` and a digit, blanks between them allowed. Zeros and byte-order marks are passed over,
/// so that a program in UTF-16 is one too. Reads no further than there.
///
/// # Errors
/// When the text cannot be read.
pub fn begins_program(text: impl BufRead) -> io::Result<bool> {
    // Whether a line begins here, and whether `%` was there.
    let (mut begins, mut percent) = (true, false);
    for byte in text.bytes() {
        match byte? {
            b'0'..=b'9' if percent => return Ok(true),
            0 => {}
            0xef | 0xbb | 0xbf | 0xff | 0xfe if begins => {}
            b' ' | b'\t' if percent || begins => {}
            b'\r' | b'\n' => (begins, percent) = (true, false),
            b'%' if begins => (begins, percent) = (false, true),
            _ => (begins, percent) = (false, false),
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_in_memory() {
        let files = ["/w/a.nc", "/w/b/c.nc", "/w/b/d/e.nc", "/w/f/g/h.nc", "/x/y.nc"];
        let loader = files.into_iter().fold(MemoryLoader::new(), |loader, path| loader.with(path, "%1 N1"));
        assert_eq!(loader.folders(Path::new("/w")), [PathBuf::from("/w/b"), PathBuf::from("/w/f")]);
        assert_eq!(loader.folders(Path::new("/x")), Vec::<PathBuf>::new());
        assert_eq!(loader.head(Path::new("/w/a.nc"), 2).unwrap(), b"%1");
    }
}
