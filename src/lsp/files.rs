//! The files that the editor has open, over those of the disk.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use gen_lsp_types::Uri;

use crate::text::{Encoding, Loader, SourceText, has_way_back};

/// The loader under the buffers: the disk.
pub(super) type Disk = Arc<dyn Loader + Send + Sync>;

/// One open document.
#[derive(Clone, Debug)]
pub(super) struct Document {
    /// As the client named it.
    pub(super) uri: Uri,
    /// As the client counts.
    pub(super) version: i32,
    /// Its text now, named after its path.
    pub(super) source: Arc<SourceText>,
}

/// How long answers of the disk about folders and paths are used again. A client that watches files reports changes at
/// once ([`EditorFiles::forget`]); one that does not sees a new macrocycle with the first edit after this time.
const FRESH: Duration = Duration::from_secs(2);

/// The last answers of the disk: every keystroke asks for the same folders and the same paths, on a network share too.
#[derive(Debug)]
struct Remembered {
    since: Instant,
    lists: BTreeMap<PathBuf, Arc<[PathBuf]>>,
    canonical: BTreeMap<PathBuf, PathBuf>,
}

impl Default for Remembered {
    fn default() -> Self {
        Self { since: Instant::now(), lists: BTreeMap::new(), canonical: BTreeMap::new() }
    }
}

/// Every file as the user sees it at one moment: buffers where there are some, else the disk. Copies are cheap.
#[derive(Clone)]
pub(super) struct EditorFiles {
    disk: Disk,
    /// The root of the workspace, where documents that are no files are thought to be.
    root: Arc<PathBuf>,
    /// By canonical path.
    open: Arc<BTreeMap<PathBuf, Document>>,
    /// Shared by all copies: it says nothing of buffers.
    remembered: Arc<Mutex<Remembered>>,
}

impl EditorFiles {
    pub(super) fn new(disk: Disk) -> Self {
        Self { disk, root: Arc::default(), open: Arc::default(), remembered: Arc::default() }
    }

    /// Files came, went or changed: the disk is asked again.
    pub(super) fn forget(&self) {
        self.remembered(|remembered| *remembered = Remembered::default());
    }

    fn remembered<T>(&self, look: impl FnOnce(&mut Remembered) -> T) -> T {
        let mut remembered = self.remembered.lock().unwrap_or_else(PoisonError::into_inner);
        if remembered.since.elapsed() > FRESH {
            *remembered = Remembered::default();
        }
        look(&mut remembered)
    }

    /// Sets the root of the workspace.
    pub(super) fn set_root(&mut self, root: PathBuf) {
        self.root = Arc::new(root);
    }

    /// The open documents, by canonical path.
    pub(super) fn open(&self) -> &BTreeMap<PathBuf, Document> {
        &self.open
    }

    /// The same, to be changed; copies made before do not change.
    pub(super) fn open_mut(&mut self) -> &mut BTreeMap<PathBuf, Document> {
        Arc::make_mut(&mut self.open)
    }

    /// The path of a document: the canonical one, unless the same file is open under another name. What is no file
    /// (`untitled:`) gets a path in the root of the workspace; what is a file as it was (`git:`) gets one below its
    /// folder.
    pub(super) fn path_of(&self, uri: &Uri) -> PathBuf {
        if let Some((path, _)) = self.open.iter().find(|(_, document)| document.uri == *uri) {
            return path.clone();
        }
        // `git:` has a path too, and is another text.
        let file = Some(uri).filter(|uri| uri.scheme().eq_ignore_ascii_case("file")).map(|uri| uri.to_file_path());
        let Some(Ok(path)) = file else {
            let path = self
                .root
                .join(uri.to_file_path().map_or_else(|_| PathBuf::from(uri.path()), |path| path.to_path_buf()));
            return match (path.parent(), path.file_name()) {
                (Some(folder), Some(name)) if Path::new(uri.path()).has_root() => {
                    let version = uri.as_str().split_once('?').map_or("", |(_, version)| version);
                    folder.join(format!("{}:{version}", uri.scheme()).replace(['/', '\\'], "_")).join(name)
                }
                _ => path,
            };
        };
        let canonical = self.canonical(&path);
        if self.open.contains_key(&canonical) { path.to_path_buf() } else { canonical }
    }

    /// The URI of the file at `path`: as the client names it, when it is open.
    pub(super) fn uri_of(&self, path: &Path) -> Option<Uri> {
        match self.buffer(path) {
            Some(document) => Some(document.uri.clone()),
            None if has_way_back(path) => Uri::from_file_path(self.canonical(path)).ok(),
            None => Uri::from_file_path(path).ok(),
        }
    }

    /// The bytes of a file as they are saved, whatever its buffer holds.
    pub(super) fn saved(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.disk.read(path)
    }

    /// The open document at `path`, or of that name: the name of a file whose path is not UTF-8 is not its path.
    pub(super) fn buffer(&self, path: &Path) -> Option<&Document> {
        let name = || path.to_str().filter(|name| name.contains(char::REPLACEMENT_CHARACTER));
        let named = || name().and_then(|name| self.open.values().find(|document| document.source.name() == name));
        self.open.get(path).or_else(|| self.open.get(&self.canonical(path))).or_else(named)
    }
}

impl Loader for EditorFiles {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.buffer(path) {
            Some(document) => Ok(document.source.text().as_bytes().to_vec()),
            None => self.disk.read(path),
        }
    }

    fn load(&self, path: &Path, name: &str, fallback: Encoding) -> io::Result<Arc<SourceText>> {
        match self.buffer(path) {
            Some(document) if document.source.name() == name => Ok(Arc::clone(&document.source)),
            Some(document) => Ok(Arc::new(SourceText::from_text(name, document.source.text()))),
            // Editors take a byte-order mark off, and count from behind it.
            None => self.disk.load(path, name, fallback).map(|source| match source.first_offset() {
                0 => source,
                _ => Arc::new(source.without_mark()),
            }),
        }
    }

    fn size(&self, path: &Path) -> Option<u64> {
        match self.buffer(path) {
            Some(document) => Some(u64::from(document.source.len())),
            None => self.disk.size(path),
        }
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        let known = self.remembered(|remembered| remembered.lists.get(folder).cloned());
        let listed = known.unwrap_or_else(|| {
            let listed: Arc<[PathBuf]> = self.disk.list(folder).into();
            self.remembered(|remembered| remembered.lists.insert(folder.to_path_buf(), Arc::clone(&listed)));
            listed
        });
        let canonical = self.canonical(folder);
        let mut files = listed.to_vec();
        // A buffer of a file that is not on the disk yet.
        let mut names: Option<BTreeSet<PathBuf>> = None;
        for path in self.open.keys().filter(|path| path.parent() == Some(&canonical)) {
            let here = path.file_name().map(|name| folder.join(name));
            if here.is_some_and(|here| listed.binary_search(&here).is_ok()) {
                continue;
            }
            let names = names.get_or_insert_with(|| listed.iter().map(|file| self.canonical(file)).collect());
            if !names.contains(path) {
                files.push(path.clone());
            }
        }
        files.sort();
        files
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.disk.is_folder(path)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn head(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        match self.buffer(path) {
            Some(document) => {
                let bytes = document.source.text().as_bytes();
                Ok(bytes.get(..limit).unwrap_or(bytes).to_vec())
            }
            None => self.disk.head(path, limit),
        }
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        if let Some(known) = self.remembered(|remembered| remembered.canonical.get(path).cloned()) {
            return known;
        }
        let canonical = self.disk.canonical(path);
        self.remembered(|remembered| remembered.canonical.insert(path.to_path_buf(), canonical.clone()));
        canonical
    }
}

impl std::fmt::Debug for EditorFiles {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("EditorFiles").field("open", &self.open.keys()).finish_non_exhaustive()
    }
}
