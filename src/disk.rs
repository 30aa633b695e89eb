//! Files of the disk, and standard input: a [`Loader`] of them, and what searches of folders need.

use std::collections::{BTreeMap, HashSet};
use std::fs::{self, File, FileType};
use std::io::{self, BufReader, Read, Seek};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::text::{BrokenLink, Loader, Numbered, begins_program};

/// The name of standard input among programs.
pub const STDIN: &str = "-";

/// Spans hold 32 bits.
const LIMIT: u64 = u32::MAX as u64;

/// Reads regular files, and of other kinds of files only those that the user named as programs: standard input and
/// pipes (`check <(generate)`). What it refuses comes as these kinds of error: [`io::ErrorKind::IsADirectory`],
/// `Unsupported` for all but regular files, `FileTooLarge` for 4 GiB and more, `ResourceBusy` for a file that changes
/// all the time, and [`BrokenLink`].
#[derive(Debug, Default)]
pub struct DiskLoader {
    /// Programs that may be pipes. A pipe can be read once, a program may be wanted twice: what it gave is kept.
    named: Vec<(PathBuf, OnceLock<Arc<[u8]>>)>,
    /// The files read, by the paths that led to them.
    read: Mutex<HashSet<PathBuf>>,
    /// The macrocycles of folders, looked for once in a run.
    numbered: Mutex<BTreeMap<Vec<PathBuf>, Arc<Numbered>>>,
}

impl DiskLoader {
    /// With the programs that the user named, of which those that are pipes may be read.
    pub fn new<'a>(named: impl IntoIterator<Item = &'a Path>) -> Self {
        let is_stream = |path: &&Path| is_stdin(path) || fs::metadata(path).is_ok_and(|data| is_pipe(data.file_type()));
        let named = named.into_iter().filter(is_stream).map(|path| (path.to_path_buf(), OnceLock::new())).collect();
        Self { named, ..Self::default() }
    }

    /// Whether the run has read that file, by whatever name.
    pub fn has_read(&self, file: &Path) -> bool {
        let read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        read.iter().any(|path| is_same_file(path, file))
    }

    /// Reads a program that is not wanted again: of a pipe nothing is kept.
    ///
    /// # Errors
    /// As [`Loader::read`].
    pub fn read_once(&self, path: &Path) -> io::Result<Vec<u8>> {
        if self.is_stream(path) { read_stream(path) } else { self.read(path) }
    }

    /// Whether that program is standard input or a pipe.
    pub fn is_stream(&self, path: &Path) -> bool {
        self.named.iter().any(|(named, _)| named == path)
    }
}

impl Loader for DiskLoader {
    fn is_folder(&self, path: &Path) -> bool {
        path.as_os_str().is_empty() || fs::metadata(path).is_ok_and(|data| data.is_dir())
    }

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if let Some((_, kept)) = self.named.iter().find(|(named, _)| named == path) {
            if let Some(bytes) = kept.get() {
                return Ok(bytes.to_vec());
            }
            let bytes = read_stream(path)?;
            let _ = kept.set(bytes.as_slice().into());
            return Ok(bytes);
        }
        let data = fs::metadata(path).map_err(|error| behind_link(path, error))?;
        if data.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        if !data.is_file() {
            return Err(io::ErrorKind::Unsupported.into());
        }
        self.read.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_path_buf());
        read_whole(path)
    }

    fn size(&self, path: &Path) -> Option<u64> {
        fs::metadata(path).ok().filter(fs::Metadata::is_file).map(|data| data.len())
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        let entries = entries(folder).unwrap_or_default();
        entries.into_iter().filter(|entry| !entry.is_folder()).map(|entry| entry.path).collect()
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        let entries = entries(folder).unwrap_or_default();
        entries.into_iter().filter(|entry| entry.is_folder() && !entry.is_link()).map(|entry| entry.path).collect()
    }

    fn numbered(&self, folders: &[PathBuf], number: &dyn Fn() -> Numbered) -> Arc<Numbered> {
        let mut known = self.numbered.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(known.entry(folders.to_vec()).or_insert_with(|| Arc::new(number())))
    }

    fn head(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        if !fs::metadata(path)?.is_file() {
            return Err(io::ErrorKind::Unsupported.into());
        }
        let mut bytes = Vec::new();
        open(path)?.take(limit as u64).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        if is_stdin(path) { path.to_path_buf() } else { canonical(path) }
    }
}

/// One name for each file, by whatever path it is reached.
pub fn canonical(path: &Path) -> PathBuf {
    fs::canonicalize(here(path)).unwrap_or_else(|_| path.to_path_buf())
}

/// Whether the program is standard input.
pub fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == STDIN
}

/// One thing in a folder.
#[derive(Debug)]
pub struct Entry {
    /// Its path, through the folder.
    pub path: PathBuf,
    /// Its kind, as the folder has it; `None` where only a look behind a link tells.
    kind: Option<FileType>,
}

impl Entry {
    /// Whether it is a folder, behind links.
    pub fn is_folder(&self) -> bool {
        self.kind.map_or_else(|| self.path.is_dir(), |kind| kind.is_dir())
    }

    /// Whether it is a regular file, behind links.
    pub fn is_file(&self) -> bool {
        self.kind.map_or_else(|| self.path.is_file(), |kind| kind.is_file())
    }

    /// Whether it is a link that leads to nothing, or round in a circle.
    pub fn is_dangling(&self) -> bool {
        self.is_link() && fs::metadata(&self.path).is_err()
    }

    /// Whether it is a pipe or a device, behind links.
    pub fn is_special(&self) -> bool {
        fs::metadata(&self.path).is_ok_and(|data| !data.is_file() && !data.is_dir())
    }

    /// Whether it is a symbolic link, or may be one.
    pub const fn is_link(&self) -> bool {
        self.kind.is_none()
    }
}

/// The entries of a folder, sorted.
///
/// # Errors
/// When it cannot be read.
#[expect(clippy::disallowed_methods, reason = "this is the disk loader")]
pub fn entries(folder: &Path) -> io::Result<Vec<Entry>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(here(folder))? {
        let entry = entry?;
        found.push((entry.file_name(), entry.file_type().ok().filter(|kind| !kind.is_symlink())));
    }
    // Names are compared much faster than paths.
    found.sort_unstable_by(|(a, _), (b, _)| a.cmp(b));
    Ok(found.into_iter().map(|(name, kind)| Entry { path: folder.join(name), kind }).collect())
}

/// Whether the file holds the start of a program.
///
/// # Errors
/// When it cannot be read.
pub fn is_program(path: &Path) -> io::Result<bool> {
    begins_program(BufReader::new(open(path)?))
}

/// Why there is no file: names a link that leads nowhere, or round in a circle.
fn behind_link(path: &Path, error: io::Error) -> io::Error {
    let denied = error.kind() == io::ErrorKind::PermissionDenied;
    let is_link = !denied && fs::symlink_metadata(path).is_ok_and(|data| data.is_symlink());
    if is_link { BrokenLink::error() } else { error }
}

#[expect(clippy::disallowed_methods, reason = "this is the disk loader")]
fn open(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// Whether two paths lead to one file: through links and hard links, and whatever bytes its name has.
#[cfg(unix)]
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |path| fs::metadata(path).ok().map(|data| (data.dev(), data.ino()));
    identity(one).is_some_and(|one| identity(other) == Some(one))
}

/// Whether two paths lead to one file.
#[cfg(not(unix))]
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    fs::canonicalize(one).is_ok_and(|one| fs::canonicalize(other).is_ok_and(|other| one == other))
}

/// How often a file is read anew that changes meanwhile.
const ATTEMPTS: usize = 5;

/// Wait before a file is read again.
const PAUSE: Duration = Duration::from_millis(20);
/// A file written to so short a time ago may be in the middle of being written, because a writer pauses between its
/// pieces; and clocks of files tick every few milliseconds. It is read once more when it has rested that long.
const FRESH: Duration = Duration::from_millis(100);
/// The same where times of files are whole seconds, or every other one.
const FRESH_OF_SECONDS: Duration = Duration::from_secs(2);

/// Reads a file. One that is written to meanwhile would be halves of two versions: it is read anew.
fn read_whole(path: &Path) -> io::Result<Vec<u8>> {
    for attempt in 0..ATTEMPTS {
        if attempt > 0 {
            std::thread::sleep(PAUSE);
        }
        let mut file = open(path)?;
        let before = file.metadata()?;
        let bytes = read_bounded(&file, before.len())?;
        let is_same = |file: &File| Ok::<_, io::Error>(is_unchanged(&before, &file.metadata()?));
        if bytes.len() as u64 != before.len() || !is_same(&file)? {
            continue;
        }
        if !is_fresh(&before) {
            return Ok(bytes);
        }
        std::thread::sleep(FRESH);
        file.rewind()?;
        if holds(&file, &bytes)? && is_same(&file)? {
            return Ok(bytes);
        }
    }
    Err(io::ErrorKind::ResourceBusy.into())
}

/// Whether nothing was written to a file between two looks at it, as far as its times tell.
fn is_unchanged(before: &fs::Metadata, after: &fs::Metadata) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        // The time of the last change of any kind cannot be set back, as that of the content can.
        let changed = |data: &fs::Metadata| (data.ctime(), data.ctime_nsec());
        if changed(before) != changed(after) {
            return false;
        }
    }
    before.len() == after.len() && before.modified().ok() == after.modified().ok()
}

/// Whether a file was written to just now, so that its times may not tell of more.
fn is_fresh(data: &fs::Metadata) -> bool {
    let Ok(modified) = data.modified() else { return true };
    let in_seconds = modified.duration_since(UNIX_EPOCH).is_ok_and(|since| since.subsec_nanos() == 0);
    let fresh = if in_seconds { FRESH_OF_SECONDS } else { FRESH };
    let now = SystemTime::now();
    now.duration_since(modified).or_else(|_| modified.duration_since(now)).is_ok_and(|age| age < fresh)
}

/// Whether the rest of a file is these bytes.
fn holds(mut file: &File, mut bytes: &[u8]) -> io::Result<bool> {
    let mut piece = vec![0; 1 << 16];
    loop {
        let length = match file.read(&mut piece) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            read => read?,
        };
        if length == 0 {
            return Ok(bytes.is_empty());
        }
        match piece.get(..length).and_then(|read| bytes.strip_prefix(read)) {
            Some(rest) => bytes = rest,
            None => return Ok(false),
        }
    }
}

/// Reads standard input or a pipe.
fn read_stream(path: &Path) -> io::Result<Vec<u8>> {
    if is_stdin(path) { read_bounded(io::stdin().lock(), 0) } else { read_bounded(open(path)?, 0) }
}

/// Reads to the end, but not 4 GiB.
fn read_bounded(source: impl Read, expected: u64) -> io::Result<Vec<u8>> {
    if expected > LIMIT {
        return Err(io::ErrorKind::FileTooLarge.into());
    }
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(usize::try_from(expected).unwrap_or(0)).map_err(|_| io::ErrorKind::OutOfMemory)?;
    source.take(LIMIT + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LIMIT {
        return Err(io::ErrorKind::FileTooLarge.into());
    }
    Ok(bytes)
}

/// The folder of a bare file name is the current one.
fn here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

#[cfg(unix)]
fn is_pipe(kind: FileType) -> bool {
    use std::os::unix::fs::FileTypeExt;
    kind.is_fifo()
}

#[cfg(not(unix))]
fn is_pipe(_: FileType) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// A run over many programs of a folder looks at its files once.
    #[test]
    fn macrocycles_are_looked_for_once() {
        let loader = DiskLoader::default();
        let looked = Cell::new(0);
        let number = || {
            looked.set(looked.get() + 1);
            Numbered::from([(looked.get(), vec![])])
        };
        let [a, b] = ["a", "b"].map(|folder| vec![PathBuf::from(folder)]);
        let found: Vec<u32> = [&a, &b, &a, &b]
            .into_iter()
            .flat_map(|folders| loader.numbered(folders, &number).keys().copied().collect::<Vec<_>>())
            .collect();
        assert_eq!(found, [1, 2, 1, 2]);
    }
}
