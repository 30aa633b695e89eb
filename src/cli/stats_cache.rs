//! Rows of programs that were executed before, by the hash of their bytes, of their configuration and of this version.
//!
//! The folder holds files of lines: an id, a check sum, an entry as JSON. Each file is written beside its place and
//! then renamed, and never changed: a run that is killed leaves the files before it. A line whose sum is wrong is no
//! entry.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::replace::Replacement;
use super::walk::Target;
use super::words::Words;
use crate::session::Session;
use crate::stats::{Row, hash, row};
use crate::text::{FileId, Overlay, Sources, path_name};

/// How the files of the cache end.
const EXTENSION: &str = "stats1";
/// More files than these are made one.
const MOST_FILES: usize = 256;
/// Characters of an id and of a sum.
const ID: usize = 64;
const SUM: usize = 16;

/// A row, and the macrocycles that it rests on: number and hash of the text.
#[derive(Deserialize, Serialize)]
struct Entry {
    row: Row,
    macrocycles: Vec<(u32, String)>,
}

/// Where an entry is.
#[derive(Clone, Copy)]
struct Place {
    file: usize,
    at: u64,
    length: usize,
}

/// Rows that are known.
pub struct Cache {
    folder: PathBuf,
    files: Vec<Mutex<File>>,
    known: HashMap<String, Place>,
    damaged: usize,
    /// Lines that are in no file yet.
    new: Mutex<Vec<String>>,
    /// Why they could not be written.
    fault: OnceLock<io::Error>,
    /// The inputs of a folder's rows besides their programs: version, configuration, list of macrocycles.
    contexts: Mutex<HashMap<PathBuf, String>>,
    /// Hashes of the texts of macrocycles.
    texts: Mutex<HashMap<PathBuf, Option<String>>>,
}

impl std::fmt::Debug for Cache {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Cache").field("folder", &self.folder).finish_non_exhaustive()
    }
}

/// The entries of a file: id, place and length of each.
struct Index {
    file: File,
    entries: Vec<(String, u64, usize)>,
    damaged: usize,
}

#[expect(clippy::disallowed_methods, reason = "the cache is no program")]
fn index(path: &Path) -> io::Result<Index> {
    let mut reader = BufReader::with_capacity(1 << 16, File::open(path)?);
    let (mut line, mut at) = (Vec::new(), 0);
    let (mut entries, mut damaged) = (Vec::new(), 0);
    loop {
        line.clear();
        let length = reader.read_until(b'\n', &mut line)?;
        if length == 0 {
            return Ok(Index { file: reader.into_inner(), entries, damaged });
        }
        match read_line(&line) {
            Some((id, entry)) => {
                entries.push((id.to_owned(), at + (length - 1 - entry.len()) as u64, entry.len()));
            }
            None => damaged += 1,
        }
        at += length as u64;
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The row of a program, made anew, with the texts that were read.
pub fn fresh(session: &Session<'_>, path: &Path, name: &str, bytes: &[u8]) -> (Row, Sources) {
    let loader = Overlay { below: session.loader, path, bytes };
    row(&Session { loader: &loader, ..*session }, path, name, hash(bytes))
}

impl Cache {
    /// The cache in a folder, which is made when it is not there.
    ///
    /// # Errors
    /// When it cannot be made or read.
    pub fn open(folder: &Path) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        let mut cache = Self {
            folder: folder.to_path_buf(),
            files: Vec::new(),
            known: HashMap::new(),
            damaged: 0,
            new: Mutex::default(),
            fault: OnceLock::new(),
            contexts: Mutex::default(),
            texts: Mutex::default(),
        };
        let paths = cache.paths()?;
        let read: Vec<_> = paths.par_iter().map(|path| index(path)).collect();
        for read in read {
            let Index { file, entries, damaged } = read?;
            let number = cache.files.len();
            cache.known.extend(entries.into_iter().map(|(id, at, length)| (id, Place { file: number, at, length })));
            cache.files.push(Mutex::new(file));
            cache.damaged += damaged;
        }
        if paths.len() > MOST_FILES || cache.damaged > 0 {
            cache.join(&paths)?;
        }
        Ok(cache)
    }

    /// What to say of damaged entries, where there were any.
    pub fn damage(&self) -> Option<Words> {
        let folder = path_name(&self.folder);
        (self.damaged > 0).then_some(Words::CacheDamaged { folder, count: self.damaged })
    }

    /// The files, oldest first: of two entries with one id the later one counts.
    #[expect(clippy::disallowed_methods, reason = "the cache is no program")]
    fn paths(&self) -> io::Result<Vec<PathBuf>> {
        let entries = fs::read_dir(&self.folder)?;
        let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        paths.retain(|path| path.extension().is_some_and(|extension| extension == EXTENSION));
        let written = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).ok();
        paths.sort_by_cached_key(|path| (written(path), path.clone()));
        Ok(paths)
    }

    /// Makes one file of the entries, without what is damaged.
    fn join(&self, paths: &[PathBuf]) -> io::Result<()> {
        let mut ids: Vec<&str> = self.known.keys().map(String::as_str).collect();
        ids.sort_unstable();
        let lines = ids.iter().filter_map(|id| Some(line(id, &self.text(id)?)));
        let written = self.write_lines(&ids.concat(), lines)?;
        // Another run may be doing the same: what is gone is gone.
        paths.iter().filter(|path| **path != written).for_each(|path| drop(fs::remove_file(path)));
        Ok(())
    }

    fn text(&self, id: &str) -> Option<String> {
        let place = self.known.get(id)?;
        let mut file = lock(self.files.get(place.file)?);
        file.seek(SeekFrom::Start(place.at)).ok()?;
        let mut text = vec![0; place.length];
        file.read_exact(&mut text).ok()?;
        String::from_utf8(text).ok()
    }

    /// The row of a program: known, or made anew.
    pub fn row(&self, session: &Session<'_>, target: &Target, name: &str, bytes: &[u8]) -> Row {
        let program = hash(bytes);
        let id = hash(format!("{}{program}", self.context(session, target)).as_bytes());
        let known = self.text(&id).and_then(|text| serde_json::from_str::<Entry>(&text).ok());
        if let Some(entry) = known.filter(|entry| self.holds(session, target, &entry.macrocycles)) {
            return Row { path: name.to_owned(), ..entry.row };
        }
        let (row, sources) = fresh(session, &target.path, name, bytes);
        if !row.findings.contains_key("E0112")
            && let Some(macrocycles) = macrocycles(&sources)
        {
            let entry = Entry { row: Row { path: String::new(), ..row.clone() }, macrocycles };
            if let Ok(text) = serde_json::to_string(&entry) {
                lock(&self.new).push(line(&id, &text));
            }
        }
        row
    }

    fn context(&self, session: &Session<'_>, target: &Target) -> String {
        let folder = target.folder();
        if let Some(known) = lock(&self.contexts).get(folder) {
            return known.clone();
        }
        let listing = session.library(&target.path).listing();
        let text = format!("{} {:?} {listing}", env!("CARGO_PKG_VERSION"), session.settings);
        let context = hash(text.as_bytes());
        lock(&self.contexts).insert(folder.to_path_buf(), context.clone());
        context
    }

    /// Whether the macrocycles are what they were.
    fn holds(&self, session: &Session<'_>, target: &Target, macrocycles: &[(u32, String)]) -> bool {
        let mut library = session.library(&target.path);
        macrocycles.iter().all(|(l, before)| {
            let Ok(path) = library.find(*l) else { return false };
            let mut texts = lock(&self.texts);
            let now = texts.entry(path).or_insert_with_key(|path| {
                let source = library.load(path, "", session.settings.encoding).ok()?;
                Some(hash(source.text().as_bytes()))
            });
            now.as_ref() == Some(before)
        })
    }

    /// Writes the new rows to a new file; [`Self::into_fault`] says why that failed.
    pub fn write(&self) {
        let lines = std::mem::take(&mut *lock(&self.new));
        if !lines.is_empty()
            && let Err(error) = self.write_lines(&lines.concat(), lines.iter().cloned())
        {
            let _ = self.fault.set(error);
        }
    }

    /// Why new rows could not be written. The table has them nevertheless.
    pub fn into_fault(self) -> Option<io::Error> {
        self.fault.into_inner()
    }

    /// Writes a file, named after a text that no other file is named after.
    fn write_lines(&self, named_after: &str, lines: impl Iterator<Item = String>) -> io::Result<PathBuf> {
        let path = self.folder.join(format!("{}.{EXTENSION}", hash(named_after.as_bytes())));
        let mut file = BufWriter::new(Replacement::begin(&path)?);
        for line in lines {
            file.write_all(line.as_bytes())?;
        }
        file.into_inner()?.commit()?;
        Ok(path)
    }
}

/// The macrocycles that were read; `None` when one has no number.
fn macrocycles(sources: &Sources) -> Option<Vec<(u32, String)>> {
    let others = sources.iter().filter(|(file, _)| *file != FileId(0));
    let of = |(_, source): (FileId, &std::sync::Arc<crate::text::SourceText>)| {
        let number = crate::resolve::Library::number(Path::new(source.name()))?;
        Some((number, hash(source.text().as_bytes())))
    };
    others.map(of).collect()
}

/// A line of the cache.
fn line(id: &str, entry: &str) -> String {
    let mut line = String::with_capacity(ID + SUM + 3 + entry.len());
    let _ = writeln!(line, "{id} {} {entry}", sum(id, entry));
    line
}

fn sum(id: &str, entry: &str) -> String {
    let mut sum = hash(format!("{id}{entry}").as_bytes());
    sum.truncate(SUM);
    sum
}

/// The id and the entry of a line; `None` when it is damaged.
fn read_line(line: &[u8]) -> Option<(&str, &str)> {
    let text = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
    let (id, rest) = text.split_at_checked(ID)?;
    let (found, entry) = rest.strip_prefix(' ')?.split_once(' ')?;
    (found == sum(id, entry)).then_some((id, entry))
}
