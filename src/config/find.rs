//! The project file of a program: in its folder, or in the nearest folder above.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::text::{Loader, way_back};

/// Name of the project file.
pub const PROJECT_FILE: &str = "cnc872c.toml";

/// The project file of the programs in `start_folder`: that of the folder itself or of the nearest folder above it, by
/// the folder's absolute path. From a relative path a relative one comes back: through the folders that it names, else
/// upwards from the working folder. So messages name files as the user would, and streams name them alike on every
/// machine.
///
/// A file that exists and cannot be read counts, so that [`configure`](super::configure()) reports it.
pub fn find_project(start_folder: &Path, loader: &dyn Loader) -> Option<PathBuf> {
    let start = canonical(start_folder, loader);
    let folder = start.ancestors().find(|folder| exists(&folder.join(PROJECT_FILE), loader))?;
    let named = start_folder.ancestors().find(|named| canonical(named, loader) == folder).map(Path::to_path_buf);
    let named = named.or_else(|| if start_folder.is_absolute() { None } else { upwards(folder, loader) });
    Some(named.unwrap_or_else(|| folder.to_path_buf()).join(PROJECT_FILE))
}

/// The way from the working folder up to one above it.
fn upwards(folder: &Path, loader: &dyn Loader) -> Option<PathBuf> {
    let here = canonical(Path::new(""), loader);
    let below = here.strip_prefix(folder).ok()?;
    Some(way_back(below))
}

/// The canonical path of a folder; the working folder, which is an empty path here, is `.` to the operating system.
fn canonical(folder: &Path, loader: &dyn Loader) -> PathBuf {
    let here = Path::new(".");
    let path = loader.canonical(if folder.as_os_str().is_empty() { here } else { folder });
    if path == here { PathBuf::new() } else { path }
}

fn exists(path: &Path, loader: &dyn Loader) -> bool {
    match loader.read(path) {
        Ok(_) => true,
        Err(error) => !matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory | ErrorKind::IsADirectory),
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::*;
    use crate::text::MemoryLoader;

    /// Files in memory seen from the working folder `/work`.
    struct From {
        files: MemoryLoader,
    }

    impl Loader for From {
        fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
            if path.starts_with("/locked") {
                return Err(io::Error::from(ErrorKind::PermissionDenied));
            }
            self.files.read(&self.canonical(path))
        }

        fn list(&self, folder: &Path) -> Vec<PathBuf> {
            self.files.list(folder)
        }

        fn folders(&self, folder: &Path) -> Vec<PathBuf> {
            self.files.folders(folder)
        }

        fn canonical(&self, path: &Path) -> PathBuf {
            Path::new("/shop").join(path).components().collect()
        }
    }

    fn found(start: &str, project: &str) -> Option<PathBuf> {
        find_project(Path::new(start), &From { files: MemoryLoader::new().with(project, "") })
    }

    #[test]
    fn in_the_folder_or_above() {
        for (start, project, expected) in [
            ("", "/shop/cnc872c.toml", "cnc872c.toml"),
            ("samples", "/shop/samples/cnc872c.toml", "samples/cnc872c.toml"),
            ("samples/err", "/shop/samples/cnc872c.toml", "samples/cnc872c.toml"),
            ("samples/err", "/shop/cnc872c.toml", "cnc872c.toml"),
            ("samples", "/cnc872c.toml", "../cnc872c.toml"),
            ("", "/cnc872c.toml", "../cnc872c.toml"),
            ("/shop/a", "/shop/cnc872c.toml", "/shop/cnc872c.toml"),
            ("/locked/a", "/nothing", "/locked/a/cnc872c.toml"),
        ] {
            assert_eq!(found(start, project), Some(PathBuf::from(expected)), "{start} {project}");
        }
    }

    #[test]
    fn none_beside_or_below() {
        assert_eq!(found("samples", "/shop/other/cnc872c.toml"), None);
        assert_eq!(found("", "/shop/samples/cnc872c.toml"), None);
    }

    #[test]
    fn the_nearest_counts() {
        let files = MemoryLoader::new().with("/cnc872c.toml", "").with("/shop/a/cnc872c.toml", "");
        let found = find_project(Path::new("a/b/c"), &From { files });
        assert_eq!(found, Some(PathBuf::from("a/cnc872c.toml")));
    }

    #[test]
    fn in_memory_without_absolute_paths() {
        let files = MemoryLoader::new().with("cnc872c.toml", "");
        assert_eq!(find_project(Path::new("a/b"), &files), Some(PathBuf::from("cnc872c.toml")));
    }
}
