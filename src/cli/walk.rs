//! Which programs the user means: files as named, and what a search of the named folders finds.

use std::collections::HashSet;
use std::io;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::disk::{self, canonical, entries, is_stdin};
use crate::session::Session;
use crate::sure::Sure;
use crate::text::{BrokenLink, path_name};

/// One file to look at.
#[derive(Debug)]
pub struct Target {
    /// The file.
    pub path: PathBuf,
    /// How it was found.
    pub origin: Origin,
    /// Why it cannot be looked at, when that is known already: a folder that cannot be searched, a link to no file.
    pub problem: Option<io::Error>,
}

/// How a file was found. Files that nobody named are changed with more care.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Origin {
    /// The user named it.
    Named,
    /// A search of a folder found it.
    Searched,
    /// A search of a folder found a link to it, or to a folder that it is in.
    Linked,
}

impl Origin {
    fn is_linked(self) -> bool {
        self == Self::Linked
    }
}

impl Target {
    /// A file that the user named.
    pub const fn named(path: PathBuf) -> Self {
        Self { path, origin: Origin::Named, problem: None }
    }

    /// The file as the user named it.
    pub fn name(&self) -> String {
        path_name(&self.path)
    }

    /// The folder whose project file and macrocycles it uses; that of the working directory is empty.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }
}

/// The files that the user means.
#[derive(Debug, Default)]
pub struct Found {
    /// The programs, each file once: in the order named, those of a folder sorted.
    pub targets: Vec<Target>,
    /// Named folders that hold none.
    pub barren: Vec<PathBuf>,
    /// Links that were not followed: they lead out of the folder that is searched.
    pub outward: Vec<PathBuf>,
    /// Links that lead nowhere and have no name of a program; one that has is a target with a problem.
    pub dangling: Vec<PathBuf>,
    /// Pipes and devices that have the name of a program.
    pub special: Vec<PathBuf>,
}

/// The programs that `paths` mean. `extensions` gives those of the programs of a folder, without points.
pub fn targets(paths: &[PathBuf], extensions: &mut dyn FnMut(&Path) -> Vec<String>) -> Found {
    let mut search = Search::default();
    for path in paths {
        let before = search.found.targets.len();
        if !is_stdin(path) && path.is_dir() {
            // Files in the working folder have the names that they have there.
            search.folder(if path.as_os_str() == "." { Path::new("") } else { path }, extensions);
            if search.found.targets.len() == before && !search.met_again {
                search.found.barren.push(path.clone());
            }
        } else {
            search.add(path.clone());
        }
    }
    search.found
}

#[derive(Default)]
struct Search {
    found: Found,
    files: HashSet<PathBuf>,
    folders: HashSet<PathBuf>,
    /// Whether the folder searched last held something found before.
    met_again: bool,
}

impl Search {
    /// Adds a program that the user named.
    fn add(&mut self, path: PathBuf) {
        let identity = if is_stdin(&path) { path.clone() } else { canonical(&path) };
        self.add_once(Target::named(path), identity);
    }

    fn add_once(&mut self, target: Target, identity: PathBuf) {
        if self.files.insert(identity) {
            self.found.targets.push(target);
        } else {
            self.met_again = true;
        }
    }

    /// Searches a folder and those in it, each once, and links that stay in it. Hidden ones are left out: what is in
    /// `.git` is not meant.
    fn folder(&mut self, root: &Path, extensions: &mut dyn FnMut(&Path) -> Vec<String>) {
        self.met_again = false;
        let border = canonical(root);
        let mut open = vec![(root.to_path_buf(), Origin::Searched)];
        // Folders behind links come last: what can be reached without a link is.
        let mut linked = Vec::new();
        let mut found: Vec<(Target, PathBuf)> = Vec::new();
        while let Some((folder, origin)) = open.pop().or_else(|| linked.pop()) {
            let identity = canonical(&folder);
            if !self.folders.insert(identity.clone()) {
                self.met_again = true;
                continue;
            }
            let entries = match entries(&folder) {
                Ok(entries) => entries,
                Err(error) => {
                    found.push((Target { path: folder, origin, problem: Some(error) }, identity));
                    continue;
                }
            };
            let extensions = extensions(&folder);
            for entry in entries.into_iter().filter(|entry| !is_hidden(&entry.path)) {
                let (identity, origin) = match entry.path.file_name() {
                    Some(name) if !entry.is_link() => (identity.join(name), origin),
                    _ => (canonical(&entry.path), Origin::Linked),
                };
                let named_so = Session::is_macrocycle_name(&entry.path) || has_extension(&entry.path, &extensions);
                let outward = entry.is_link() && !identity.starts_with(&border);
                if outward && (entry.is_folder() || (named_so && entry.is_file())) {
                    self.found.outward.push(entry.path);
                    continue;
                }
                if entry.is_folder() {
                    if origin.is_linked() { &mut linked } else { &mut open }.push((entry.path, origin));
                } else if entry.is_dangling() {
                    if named_so {
                        let problem = Some(BrokenLink::error());
                        found.push((Target { path: entry.path, origin, problem }, identity));
                    } else {
                        self.found.dangling.push(entry.path);
                    }
                } else if named_so && entry.is_file() {
                    found.push((Target { path: entry.path, origin, problem: None }, identity));
                } else if named_so && entry.is_special() {
                    self.found.special.push(entry.path);
                }
            }
        }
        let is_wanted = |(target, _): &(Target, PathBuf)| target.problem.is_some() || is_program(&target.path);
        let mut found: Vec<_> = found.into_par_iter().filter(is_wanted).collect();
        // Of a file and the links to it the file counts, whatever their names.
        let by_path = |a: &Target, b: &Target| a.path.cmp(&b.path);
        found.par_sort_by(|(a, _), (b, _)| a.origin.is_linked().cmp(&b.origin.is_linked()).then_with(|| by_path(a, b)));
        let before = self.found.targets.len();
        for (target, identity) in found {
            if target.problem.is_some() {
                self.found.targets.push(target);
            } else {
                self.add_once(target, identity);
            }
        }
        self.found.targets.get_mut(before..).sure().sort_by(by_path);
        self.found.outward.sort_unstable();
        self.found.dangling.sort_unstable();
        self.found.special.sort_unstable();
    }
}

/// Whether the file is a macrocycle by its name, or holds the start of a program. What cannot be read is left to those
/// who say why.
fn is_program(path: &Path) -> bool {
    Session::is_macrocycle_name(path) || disk::is_program(path).unwrap_or(true)
}

/// Whether the name of the file has one of these extensions.
pub(super) fn has_extension(path: &Path, extensions: &[impl AsRef<str>]) -> bool {
    path.extension().is_some_and(|own| extensions.iter().any(|extension| own.eq_ignore_ascii_case(extension.as_ref())))
}

fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::EXTENSIONS;

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

    fn targets(paths: &[PathBuf]) -> (Vec<Target>, Vec<PathBuf>) {
        let found = search(paths);
        (found.targets, found.barren)
    }

    fn search(paths: &[PathBuf]) -> Found {
        super::targets(paths, &mut |_| EXTENSIONS.iter().map(|&extension| extension.to_owned()).collect())
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

    /// A line that begins with `%` and a digit, as UTF-16 too; macrocycles are known by their names.
    #[test]
    fn texts_without_a_program_start_are_left_out_when_searched() {
        let folder = tree(&[]);
        let utf16: String = "\u{feff}%1\r\nN1 M30".chars().map(|c| format!("{c}\0")).collect();
        for (name, text, is_program) in [
            ("1.txt", "buy oil", false),
            ("2.txt", "done 80 %, 5 holes left\n100 % 5", false),
            ("3.nc", "N10 X1\nN20 M30", false),
            ("4.nc", "header\r%1 N1 M30", true),
            ("5.txt", "\u{feff}%123", true),
            ("6.ncp", "x\n% 5 N1 M30", true),
            ("7.mpf", "%\nO2107", false),
            ("8.nc", utf16.as_str(), true),
            ("9.nc", "  %1 N1 M30", true),
            ("L5.txt", "N1 G79 L5", true),
        ] {
            put(&folder.path().join(name), text);
            let (found, _) = targets(&[folder.path().to_path_buf()]);
            assert_eq!(names(folder.path(), &found).contains(&name.to_owned()), is_program, "{name}");
        }
        let (named, _) = targets(&[folder.path().join("1.txt")]);
        assert_eq!(names(folder.path(), &named), ["1.txt"]);
    }

    #[test]
    fn each_folder_has_its_extensions() {
        let folder = tree(&["a.tap", "a.nc", "sub/b.TAP", "sub/b.nc"]);
        let mut extensions = |folder: &Path| vec![if folder.ends_with("sub") { "tap" } else { "nc" }.to_owned()];
        let found = super::targets(&[folder.path().to_path_buf()], &mut extensions);
        assert_eq!(names(folder.path(), &found.targets), ["a.nc", "sub/b.TAP"]);
    }

    #[cfg(unix)]
    #[test]
    fn links_that_stay_in_the_folder_are_followed() {
        use std::os::unix::fs::symlink;
        let outside = tree(&["part.nc", "more/c.nc"]);
        let folder = tree(&["in/a.nc", "b.nc"]);
        let at = |name: &str| folder.path().join(name);
        symlink(folder.path(), at("in/up")).unwrap();
        symlink("self", at("self")).unwrap();
        symlink("nothing", at("gone.nc")).unwrap();
        symlink("in/a.nc", at("link.nc")).unwrap();
        symlink(outside.path().join("part.nc"), at("out.nc")).unwrap();
        symlink(outside.path().join("part.nc"), at("out.sh")).unwrap();
        symlink(outside.path().join("more"), at("more")).unwrap();
        let found = search(&[folder.path().to_path_buf()]);
        assert_eq!(names(folder.path(), &found.targets), ["b.nc", "gone.nc", "in/a.nc"]);
        let origins: Vec<_> = found.targets.iter().map(|target| (target.origin, target.problem.is_some())).collect();
        assert_eq!(origins, [(Origin::Searched, false), (Origin::Linked, true), (Origin::Searched, false)]);
        assert_eq!(found.outward, [at("more"), at("out.nc")]);
        assert_eq!(found.dangling, [at("self")]);
        // One that is named is read wherever it leads.
        let (named, _) = targets(&[at("out.nc"), at("link.nc")]);
        assert_eq!(names(folder.path(), &named), ["out.nc", "link.nc"]);
    }

    /// Whichever name comes first.
    #[cfg(unix)]
    #[test]
    fn a_file_is_not_found_through_a_link_to_it() {
        use std::os::unix::fs::symlink;
        let folder = tree(&["plate.nc", "parts/b.nc"]);
        let at = |name: &str| folder.path().join(name);
        for name in ["a.nc", "z.nc", "L9001"] {
            symlink("plate.nc", at(name)).unwrap();
        }
        for name in ["a", "z"] {
            symlink("parts", at(name)).unwrap();
        }
        let (found, _) = targets(&[folder.path().to_path_buf()]);
        assert_eq!(names(folder.path(), &found), ["parts/b.nc", "plate.nc"]);
        assert!(found.iter().all(|target| target.origin == Origin::Searched));
    }
}
