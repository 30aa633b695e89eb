//! Files of a folder, named as they are in it.

use std::io;
use std::path::{Path, PathBuf};

use cnc872c::text::Loader;

/// Reads below one folder, whatever the working folder is.
pub struct TestDisk {
    pub root: PathBuf,
}

impl Loader for TestDisk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        std::fs::read(self.root.join(path))
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        let mut found: Vec<PathBuf> = std::fs::read_dir(self.root.join(folder))
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| path.is_file())
            .filter_map(|path| path.strip_prefix(&self.root).ok().map(Path::to_path_buf))
            .collect();
        found.sort();
        found
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.root.join(path).is_dir()
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        let mut found: Vec<PathBuf> = std::fs::read_dir(self.root.join(folder))
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| path.is_dir())
            .filter_map(|path| path.strip_prefix(&self.root).ok().map(Path::to_path_buf))
            .collect();
        found.sort();
        found
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        let whole = self.root.join(path);
        let whole = std::fs::canonicalize(&whole).unwrap_or(whole);
        let root = std::fs::canonicalize(&self.root).unwrap_or_else(|_| self.root.clone());
        whole.strip_prefix(&root).map(Path::to_path_buf).unwrap_or(whole)
    }
}

/// Every file of a folder and the folders in it, sorted.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        if entry.is_dir() {
            found.extend(files(&entry));
        } else {
            found.push(entry);
        }
    }
    found
}
