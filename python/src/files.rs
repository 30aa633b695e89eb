//! What programs are read from.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::disk::DiskLoader;
use cnc872c::text::{Loader, Numbered};

/// Files of the disk, some of them replaced by texts.
pub struct Files {
    disk: DiskLoader,
    given: Vec<(PathBuf, Arc<[u8]>)>,
}

impl Files {
    /// With the programs that are asked for, of which pipes may be read.
    pub fn new<'a>(programs: impl IntoIterator<Item = &'a Path>) -> Self {
        let named = programs.into_iter().filter(|path| !cnc872c::disk::is_stdin(path));
        Self { disk: DiskLoader::new(named), given: Vec::new() }
    }

    /// Puts a text in the place of a file.
    pub fn give(&mut self, path: PathBuf, text: Arc<[u8]>) {
        self.given.push((path, text));
    }

    fn given(&self, path: &Path) -> Option<&Arc<[u8]>> {
        self.given.iter().find(|(given, _)| given == path).map(|(_, text)| text)
    }
}

impl Loader for Files {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.given(path).map_or_else(|| self.disk.read(path), |text| Ok(text.to_vec()))
    }

    fn size(&self, path: &Path) -> Option<u64> {
        self.given(path).map_or_else(|| self.disk.size(path), |text| Some(text.len() as u64))
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.disk.is_folder(path)
    }

    fn numbered(&self, folders: &[PathBuf], number: &dyn Fn() -> Numbered) -> Arc<Numbered> {
        self.disk.numbered(folders, number)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        if self.given(path).is_some() { path.to_path_buf() } else { self.disk.canonical(path) }
    }
}
