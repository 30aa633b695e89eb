//! A part program as the PLC program reads it: the command block of CNC872, the compatible one of CNC8x6 and CNC8x9,
//! and the requests to move (S0 8.1–8.4).
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | read | an executed block | [`Facts`] of one step, or of two where the program stands | `blocks` |
//! | cells | the facts of one step after another | [`Step`]: values of the chosen signals, and which changed | [`Tracker`] |
//! | write | steps | a table, JSON Lines, CSV, a value change dump | [`Writer`], in a thread [`beside()`] execution |
//! | find | steps | those in which a condition holds | [`Condition`] |
//!
//! The signals are data: [`dictionary`], and in [`run_time`] the names that a program does not determine.

mod beside;
mod blocks;
mod cell;
mod choose;
mod condition;
pub mod dictionary;
mod facts;
mod find;
mod fits;
mod grammar;
mod json;
mod list;
mod reader;
pub mod run_time;
mod steps;
mod table;
mod tokens;
mod value_texts;
mod values;
mod wave;
mod words;

pub use beside::beside;
pub use choose::{NoSignal, Why, default, matches, named, nearest, why_none, with_compatible};
pub use condition::{Condition, signal_problem};
pub use dictionary::{Cell, Flag, Form, Signal, signals};
pub use facts::{Facts, MotionFacts, StepTimes};
pub use find::Finder;
pub use json::{Json, SCHEMA, schema};
#[cfg(feature = "arrow")]
pub(crate) use json::{end_text, file_text, header_text};
pub use list::{list_json, list_table};
pub use reader::{Header, Reader, Writer};
pub use steps::{Place, Step, Tracker};
pub use table::{Csv, Table};
pub use values::{Value, write_value};
pub use wave::Wave;
pub use words::{SetSignal, WordSets, WordsRead, of_word};
