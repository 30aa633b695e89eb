//! The files that the editor has open, over those of the disk.

use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use gen_lsp_types::Uri;

use crate::text::{Encoding, Loader, SourceText};

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

/// Every file as the user sees it at one moment: buffers where there are some, else the disk. Copies are cheap.
#[derive(Clone)]
pub(super) struct EditorFiles {
    disk: Disk,
    /// The root of the workspace, where documents that are no files are thought to be.
    root: Arc<PathBuf>,
    /// By canonical path.
    open: Arc<BTreeMap<PathBuf, Document>>,
}

impl EditorFiles {
    pub(super) fn new(disk: Disk) -> Self {
        Self { disk, root: Arc::default(), open: Arc::default() }
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

    /// The canonical path of a document. What is no file (`untitled:`) gets a path in the root of the workspace.
    pub(super) fn path_of(&self, uri: &Uri) -> PathBuf {
        match uri.to_file_path() {
            Ok(path) => self.canonical(&path),
            Err(()) => self.root.join(uri.path()),
        }
    }

    /// The URI of the file at `path`: as the client names it, when it is open.
    pub(super) fn uri_of(&self, path: &Path) -> Option<Uri> {
        match self.buffer(path) {
            Some(document) => Some(document.uri.clone()),
            None if path.components().any(|part| part == Component::ParentDir) => {
                Uri::from_file_path(self.canonical(path)).ok()
            }
            None => Uri::from_file_path(path).ok(),
        }
    }

    /// The open document at `path`.
    pub(super) fn buffer(&self, path: &Path) -> Option<&Document> {
        self.open.get(path).or_else(|| self.open.get(&self.disk.canonical(path)))
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
            None => self.disk.load(path, name, fallback),
        }
    }

    fn size(&self, path: &Path) -> Option<u64> {
        match self.buffer(path) {
            Some(document) => Some(u64::from(document.source.len())),
            None => self.disk.size(path),
        }
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        let mut files = self.disk.list(folder);
        let canonical = self.disk.canonical(folder);
        for path in self.open.keys().filter(|path| path.parent() == Some(&canonical)) {
            if !files.iter().any(|file| self.disk.canonical(file) == *path) {
                files.push(path.clone());
            }
        }
        files.sort();
        files
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
        self.disk.canonical(path)
    }
}

impl std::fmt::Debug for EditorFiles {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("EditorFiles").field("open", &self.open.keys()).finish_non_exhaustive()
    }
}
