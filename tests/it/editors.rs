//! What editors are given keeps to the program: generated files, copies, the keys of the project file.

use std::fs;

use crate::markers::files;
use crate::samples::root;

#[path = "../../examples/highlighting/files.rs"]
mod highlighting;

/// Generated files are those that the program makes now, and nothing else lies beside them.
#[test]
fn generated_files() {
    let made = highlighting::files();
    let mut stale: Vec<String> = made
        .iter()
        .filter(|(name, text)| fs::read_to_string(root().join(name)).ok().as_ref() != Some(*text))
        .map(|(name, _)| name.clone())
        .collect();
    for folder in ["editors/neovim/queries", "editors/helix/runtime"] {
        for path in files(&root().join(folder)) {
            let name = path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/");
            if !made.contains_key(&name) {
                stale.push(format!("{name} (no longer made: delete it)"));
            }
        }
    }
    assert!(stale.is_empty(), "out of date: {stale:?}; write them anew with `cargo run --example highlighting`");
}
