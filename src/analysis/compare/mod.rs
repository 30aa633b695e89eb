//! Two programs compared by what they do (the rules CMP).
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | read | executed blocks | [`Steps`]: motions, and the words between them | [`StepReader`] |
//! | align | steps of both | pairs, and what is without one | `align` |
//! | group | pairs | [`Change`]s with counts and places | `changes` |
//! | show | changes | text, JSON, what the page lists | `text`, `json` |

mod align;
mod changes;
mod json;
mod near;
mod reader;
mod steps;
mod table;
mod text;
mod unknown;
mod words;

pub use changes::{Blocks, Change, ChangeKind, Comparison, Tolerances, compare};
pub use json::{SCHEMA, Side, for_page, json, schema};
pub use reader::StepReader;
pub use steps::{Context, Event, Steps, Value};
pub use table::{Row, Verdict, table};
pub use text::text;
