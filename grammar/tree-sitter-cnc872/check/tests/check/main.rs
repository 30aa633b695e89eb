//! The grammar against cnc872c, its dictionary and its samples.

use std::fs;
use std::path::{Path, PathBuf};

mod corpus;
mod generated;
mod highlighting;
mod recovery;
mod words;

/// The folder of the grammar.
fn grammar() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a folder")
}

/// The folder of the main package.
fn root() -> &'static Path {
    grammar().ancestors().nth(2).expect("a folder")
}

/// All files in a folder and the folders in it, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        if entry.is_dir() { found.extend(files(&entry)) } else { found.push(entry) }
    }
    found
}

/// Whether files are to be written anew instead of compared.
fn write() -> bool {
    std::env::var_os("CHECK").is_some_and(|value| value == "write")
}

/// Compares a committed file with what it should be, or writes it.
fn compare(path: &Path, now: &str) {
    if write() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, now).unwrap();
        return;
    }
    let name = path.strip_prefix(root()).unwrap().display();
    let committed = fs::read_to_string(path).unwrap_or_default();
    if committed != now {
        let line = committed.lines().zip(now.lines()).take_while(|(old, new)| old == new).count();
        let show = |text: &str| text.lines().nth(line).unwrap_or("(end of the file)").to_owned();
        panic!(
            "{name} is out of date, line {}:\n  it says  {}\n  now it is {}\nwrite it anew with \
             `CHECK=write grammar/tree-sitter-cnc872/ci`",
            line + 1,
            show(&committed),
            show(now)
        );
    }
}
