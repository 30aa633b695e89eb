//! The grammar as a language of the `tree-sitter` crate.

use tree_sitter::{Language, Parser, Tree};
use tree_sitter_language::LanguageFn;

unsafe extern "C" {
    fn tree_sitter_cnc872() -> *const ();
}

/// The language.
pub fn language() -> Language {
    // SAFETY: the function is the one that the generated parser defines.
    Language::new(unsafe { LanguageFn::from_raw(tree_sitter_cnc872) })
}

/// The tree of `text`.
///
/// # Panics
/// When the parser does not fit the library.
pub fn parse(text: &str) -> Tree {
    let mut parser = Parser::new();
    parser.set_language(&language()).expect("a language of a version that the library knows");
    parser.parse(text, None).expect("a tree: no time limit is set")
}
