//! Answers about a program as plain data: the word at a place, the names in it, the reach of things, the
//! results of execution at a block. Nothing here knows of editors; `lsp` turns the answers into those of its protocol.

pub(crate) mod analysis;
pub(crate) mod callee;
pub(crate) mod cancel;
pub(crate) mod cursor;
pub(crate) mod executed;
pub(crate) mod extents;
pub(crate) mod flow;
pub(crate) mod hover_texts;
pub(crate) mod meaning;
pub(crate) mod moves;
pub(crate) mod names;
pub(crate) mod navigation_texts;
pub(crate) mod observe;
pub(crate) mod observed;
pub(crate) mod page;
pub(crate) mod reach;
pub(crate) mod rename_doubts;
pub(crate) mod sections;
pub(crate) mod shown;
pub(crate) mod state;
pub(crate) mod values;
