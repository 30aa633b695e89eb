//! Which programs the user means: files as named, and what a search of the named folders finds.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use super::disk::{canonical, entries, holds_byte, is_stdin};
use crate::session::Session;

/// Extensions of files that may be programs, in either case.
const EXTENSIONS: [&str; 4] = ["nc", "ncp", "mpf", "txt"];

/// Files of this extension hold notes as often as programs.
const NOTES: &str = "txt";

/// One file to look at.
#[derive(Debug)]
pub struct Target {
    /// The file.
    pub path: PathBuf,
    /// Why it cannot be looked at, when that is known already: a folder that cannot be searched.
    pub problem: Option<io::Error>,
}

impl Target {
    /// The file as the user named it.
    pub fn name(&self) -> String {
        self.path.to_string_lossy().into_owned()
    }

    /// The folder whose project file and macrocycles it uses; that of the working directory is empty.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }
}

/// The programs that `paths` mean, each file once: in the order named, those of a folder sorted. Also the folders among
/// them that hold none.
pub fn targets(paths: &[PathBuf]) -> (Vec<Target>, Vec<PathBuf>) {
    let mut search = Search::default();
    let mut barren = Vec::new();
    for path in paths {
        let before = search.found.len();
        if !is_stdin(path) && path.is_dir() {
            // What is found in the working folder is named as it is there.
            search.folder(if path.as_os_str() == "." { Path::new("") } else { path });
            if search.found.len() == before && !search.met_again {
                barren.push(path.clone());
            }
        } else {
            search.add(path.clone());
        }
    }
    (search.found, barren)
}

#[derive(Default)]
struct Search {
    found: Vec<Target>,
    files: BTreeSet<PathBuf>,
    folders: BTreeSet<PathBuf>,
    /// Whether the folder searched last held something found before.
    met_again: bool,
}

impl Search {
    /// Adds a program that the user named.
    fn add(&mut self, path: PathBuf) {
        let identity = if is_stdin(&path) { path.clone() } else { canonical(&path) };
        self.add_once(path, identity);
    }

    fn add_once(&mut self, path: PathBuf, identity: PathBuf) {
        if self.files.insert(identity) {
            self.found.push(Target { path, problem: None });
        } else {
            self.met_again = true;
        }
    }

    /// Searches a folder and those in it, links followed, each once. Hidden ones are left out: what is in `.git` is not
    /// meant.
    fn folder(&mut self, root: &Path) {
        self.met_again = false;
        let mut open = vec![root.to_path_buf()];
        let mut found = Vec::new();
        while let Some(folder) = open.pop() {
            let identity = canonical(&folder);
            if !self.folders.insert(identity.clone()) {
                self.met_again = true;
                continue;
            }
            let entries = match entries(&folder) {
                Ok(entries) => entries,
                Err(error) => {
                    found.push((folder, Err(error)));
                    continue;
                }
            };
            for entry in entries.into_iter().filter(|entry| !is_hidden(&entry.path)) {
                if entry.is_folder() {
                    open.push(entry.path);
                } else if is_program_name(&entry.path) && entry.is_file() && !is_mere_text(&entry.path) {
                    let identity = match entry.path.file_name() {
                        Some(name) if !entry.is_link() => identity.join(name),
                        _ => canonical(&entry.path),
                    };
                    found.push((entry.path, Ok(identity)));
                }
            }
        }
        found.sort_by(|(a, _), (b, _)| a.cmp(b));
        for (path, identity) in found {
            match identity {
                Ok(identity) => self.add_once(path, identity),
                Err(error) => self.found.push(Target { path, problem: Some(error) }),
            }
        }
    }
}

fn is_program_name(path: &Path) -> bool {
    EXTENSIONS.into_iter().any(|extension| has_extension(path, extension)) || Session::is_macrocycle_name(path)
}

/// Whether it is no program after all: a `.txt` without `%` that is no macrocycle.
fn is_mere_text(path: &Path) -> bool {
    has_extension(path, NOTES) && !Session::is_macrocycle_name(path) && matches!(holds_byte(path, b'%'), Ok(false))
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree(files: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for file in files {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            put(&path, "%1 N1 M30");
        }
        folder
    }

    #[expect(clippy::disallowed_methods, reason = "a test makes the files it searches")]
    fn put(path: &Path, text: &str) {
        std::fs::write(path, text).unwrap();
    }

    fn names(folder: &Path, found: &[Target]) -> Vec<String> {
        found
            .iter()
            .map(|target| target.path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/"))
            .collect()
    }

    #[test]
    fn a_folder_is_searched_for_programs_and_macrocycles() {
        let files = ["b.nc", "a/z.MPF", "a/L9001", "a/L1.mrc", "L0", "x.NcP", "notes.txt", "image.png", ".git/L100"];
        let folder = tree(&files);
        let (found, barren) = targets(&[folder.path().to_path_buf()]);
        assert_eq!(names(folder.path(), &found), ["a/L1.mrc", "a/L9001", "a/z.MPF", "b.nc", "notes.txt", "x.NcP"]);
        assert!(barren.is_empty());
    }

    #[test]
    fn each_file_once_and_named_files_as_named() {
        let folder = tree(&["a.nc", "sub/b.nc", "c.odd"]);
        let at = |name: &str| folder.path().join(name);
        let (found, barren) = targets(&[at("c.odd"), at("sub/b.nc"), at("."), at("sub"), at("sub/../a.nc")]);
        assert_eq!(names(folder.path(), &found), ["c.odd", "sub/b.nc", "a.nc"]);
        assert!(barren.is_empty());
    }

    #[test]
    fn a_folder_without_programs_is_told() {
        let folder = tree(&["readme.md"]);
        let (found, barren) = targets(&[folder.path().to_path_buf()]);
        assert!(found.is_empty());
        assert_eq!(barren, [folder.path().to_path_buf()]);
    }

    #[test]
    fn texts_without_a_program_start_are_left_out_when_searched() {
        let folder = tree(&[]);
        for (name, text) in [("notes.txt", "buy oil"), ("part.txt", "text % 1"), ("L5.txt", "N1 G79 L5")] {
            put(&folder.path().join(name), text);
        }
        let (found, _) = targets(&[folder.path().to_path_buf()]);
        assert_eq!(names(folder.path(), &found), ["L5.txt", "part.txt"]);
        let (named, _) = targets(&[folder.path().join("notes.txt")]);
        assert_eq!(names(folder.path(), &named), ["notes.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn rings_of_links_end() {
        let folder = tree(&["a/part.nc"]);
        std::os::unix::fs::symlink(folder.path(), folder.path().join("a/up")).unwrap();
        std::os::unix::fs::symlink("self", folder.path().join("self")).unwrap();
        let (found, _) = targets(&[folder.path().to_path_buf()]);
        assert_eq!(names(folder.path(), &found), ["a/part.nc"]);
    }
}
