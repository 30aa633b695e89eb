//! From text to the tree of one file: tokens, the grammar of a block, the explanation of slips, words in one arena.
//!
//! Nothing here knows a machine. Parsing never fails: every fault becomes a finding, and its block's other words and
//! the other blocks stay unharmed. Comments and layout survive: each word and comment knows its span.

#[cfg(any(test, fuzzing))]
mod agreement;
mod blocks;
mod file;
mod foreign;
mod grammar;
mod layout;
mod lower;
mod number;
mod parse;
mod plain;
mod slips;
mod tokens;
mod word;

#[cfg(fuzzing)]
pub use agreement::short_way_agrees;
pub use file::{Block, BlockFlags, BlockId, ParsedFile};
pub use foreign::{Foreign, foreign, is_suspicious};
pub use parse::{Form, parse};
pub use slips::swallowed_words;
pub use tokens::{Kind, Shape, Token, tokens};
pub use word::{Value, Word, WordParts};
