//! From text to the tree of one file: logos tokens, the chumsky grammar of a block, words in one arena.
//!
//! Nothing here knows a machine. Parsing never fails: every fault becomes a finding, and its block's other words and the
//! other blocks stay unharmed. Comments and layout survive: each word and comment knows its span.

#[cfg(any(test, fuzzing))]
mod agreement;
mod comments;
mod file;
mod foreign;
mod foreign_words;
mod grammar;
mod idioms;
mod layout;
mod lower;
mod misread;
mod missing;
mod number;
mod parse;
mod plain;
mod poison;
mod swallowed;
mod token;
mod word;

#[cfg(fuzzing)]
pub use agreement::short_way_agrees;
pub use file::{Block, BlockFlags, BlockId, ParsedFile};
pub use foreign::{Foreign, foreign, is_suspicious};
pub use parse::{Form, parse};
pub use token::{Kind, Token, tokens};
pub use word::{Value, Word, WordParts};
