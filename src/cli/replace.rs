//! Files written beside their target and put in its place when complete: a reader sees the old file or the new one,
//! whole, whatever happens in between.

use std::collections::BTreeSet;
use std::fs::{self, File, Metadata};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use tempfile::NamedTempFile;

use super::words::{Words, error_prefix};
use crate::dict::Lang;

/// Exit status after an interruption where no signal ends a run: 128 and the number of SIGINT, as shells count.
#[cfg(not(unix))]
const INTERRUPTED: i32 = 130;

/// The unfinished files of this run. The lock is held while one appears or gets its final name, so that its holder
/// sees them all.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on an interruption (Ctrl-C, the end of the terminal's session) removes unfinished files, says so, and ends
/// the run as that signal does. Signals that are ignored on purpose (`nohup`) stay ignored.
pub fn clean_up_when_interrupted(lang: Lang) {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        // Without a handler the worst is an unfinished file left behind, under a temporary name.
        #[cfg(unix)]
        handle_signals(lang);
        #[cfg(not(unix))]
        let _ = ctrlc::try_set_handler(move || {
            let _files = clean_up(lang);
            end();
        });
    });
}

/// Handles those of the signals that are not ignored. Where the system does not say which these are, the end of the
/// session may be ignored, and is not handled.
#[cfg(unix)]
#[expect(clippy::disallowed_methods, reason = "what the system says of this process is no file of a run")]
fn handle_signals(lang: Lang) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(1 << (SIGHUP - 1));
    let handled = [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| ignored & (1 << (signal - 1)) == 0);
    if let Ok(mut signals) = signal_hook::iterator::Signals::new(handled) {
        std::thread::spawn(move || {
            if let Some(signal) = signals.forever().next() {
                let _files = clean_up(lang);
                // The signal's default effect: it ends the run.
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            }
        });
    }
}

#[cfg(not(unix))]
#[expect(clippy::disallowed_methods, reason = "an interruption ends the run from a thread that is not the main one")]
fn end() {
    std::process::exit(INTERRUPTED);
}

/// Removes unfinished files and says so. As long as the lock is held, no file appears or gets its final name.
fn clean_up(lang: Lang) -> MutexGuard<'static, BTreeSet<PathBuf>> {
    let files = unfinished();
    for file in files.iter() {
        let _ = fs::remove_file(file);
    }
    // The line may have a progress bar.
    let clear = if io::stderr().is_terminal() { "\r\u{1b}[K" } else { "" };
    let _ = writeln!(io::stderr(), "{clear}{}: {}", error_prefix(lang), Words::Interrupted.text(lang));
    files
}

/// A file being written in the place of another.
#[derive(Debug)]
pub struct Replacement {
    /// `None` once it has its final name, or is removed.
    file: Option<NamedTempFile>,
    target: PathBuf,
    old: Option<Metadata>,
}

impl Replacement {
    /// Begins the file that replaces `target`, behind links. An existing one is kept until [`Self::commit`].
    ///
    /// # Errors
    /// When the folder cannot be written to, when the existing file is read-only, or is no regular file.
    pub fn begin(target: &Path) -> io::Result<Self> {
        let target = behind_links(target);
        let old = match fs::metadata(&target) {
            Ok(data) => Some(data),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        if let Some(data) = &old {
            if data.is_dir() {
                return Err(io::ErrorKind::IsADirectory.into());
            }
            if !data.is_file() {
                return Err(io::ErrorKind::Unsupported.into());
            }
            // A rename would not ask.
            if data.permissions().readonly() {
                return Err(io::ErrorKind::PermissionDenied.into());
            }
        }
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let mut unfinished = unfinished();
        let file = builder().tempfile_in(folder)?;
        unfinished.insert(file.path().to_path_buf());
        Ok(Self { file: Some(file), target, old })
    }

    /// Puts the file in place, with the permissions of the one before it.
    ///
    /// # Errors
    /// When that cannot be done; the old file is then as it was.
    pub fn commit(mut self) -> io::Result<()> {
        let Some(mut file) = self.file.take() else { return Ok(()) };
        let mut unfinished = unfinished();
        let path = file.path().to_path_buf();
        let result = file
            .flush()
            .and_then(|()| self.old.as_ref().map_or(Ok(()), |old| keep_owner_and_permissions(file.as_file(), old)))
            .and_then(|()| file.persist(&self.target).map(drop).map_err(|error| error.error));
        unfinished.remove(&path);
        result
    }

    /// Like [`Self::commit`], when the bytes are on the disk: not even a power cut loses both files.
    ///
    /// # Errors
    /// When that cannot be done; the old file is then as it was.
    pub fn commit_safely(self) -> io::Result<()> {
        if let Some(file) = &self.file {
            file.as_file().sync_all()?;
        }
        self.commit()
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.as_mut().map_or(Ok(0), |file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_mut().map_or(Ok(()), NamedTempFile::flush)
    }
}

impl Drop for Replacement {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            let mut unfinished = unfinished();
            unfinished.remove(file.path());
            drop(file);
        }
    }
}

/// New files get the permissions that any new file gets: what the umask leaves.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cnc872c-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

fn keep_owner_and_permissions(file: &File, old: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        // Only root may give a file away; for others it is theirs now, as an editor leaves it.
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

/// The file that a path leads to through symbolic links, also one that does not exist yet.
fn behind_links(path: &Path) -> PathBuf {
    let mut target = path.to_path_buf();
    for _ in 0..40 {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => break,
        }
    }
    target
}
