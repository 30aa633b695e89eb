//! What editors are given keeps to the program: generated files, copies, the keys of the project file.

use std::fs;

use crate::disk::files;
use crate::samples::root;

#[path = "../../examples/highlighting/files.rs"]
mod highlighting;

/// Generated files are those that the program makes now, and their folder has no others.
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

/// The piece of Helix's configuration is TOML, and all that it names exists.
#[test]
fn helix() {
    let text = fs::read_to_string(root().join("editors/helix/languages.toml")).unwrap();
    let document: toml_edit::DocumentMut = text.parse().unwrap();
    let server = &document["language-server"]["cnc872c"];
    assert_eq!(server["command"].as_str(), Some("cnc872c"));
    assert_eq!(server["args"][0].as_str(), Some("lsp"));
    assert_eq!(server["config"]["language"].as_str(), Some("auto"));
    let language = document["language"].as_array_of_tables().unwrap().get(0).unwrap();
    let grammar = document["grammar"].as_array_of_tables().unwrap().get(0).unwrap();
    assert_eq!(language["language-servers"][0].as_str(), Some("cnc872c"));
    for name in [&language["name"], &grammar["name"]] {
        assert!(root().join("editors/helix/runtime/queries").join(name.as_str().unwrap()).is_dir());
    }
    let place = grammar["source"]["path"].as_str().unwrap().strip_prefix("/path/to/").unwrap();
    assert!(root().join(place).join("grammar.js").is_file());
}

/// Links in the documents of the editors and the grammar lead somewhere.
#[test]
fn links_lead_somewhere() {
    for folder in ["editors/neovim", "editors/helix", "grammar/tree-sitter-cnc872"] {
        let text = fs::read_to_string(root().join(folder).join("README.md")).unwrap();
        let links = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        for link in links.filter(|link| !link.starts_with("http")) {
            assert!(root().join(folder).join(link).exists(), "{folder}/README.md: {link}");
        }
    }
}
