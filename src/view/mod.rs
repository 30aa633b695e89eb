//! The picture of an executed program: the data of the page that shows it, the page itself, still pictures.
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | collect | executed blocks | rows: each execution once, however often it is repeated | `rows`, with `parts`, `shapes`, `positions`, `arcs`, `calls`, `files` |
//! | take apart | texts | skeletons and what cannot be foretold | `text` |
//! | pack | rows | columns of whole numbers, deflated | `pack`, with `column`, `tally`, `container` |
//!
//! `web/src/data` reads what is packed here; `docs/reference/page-data.md` describes it.

mod arcs;
mod calls;
mod collect;
mod column;
mod container;
mod files;
mod pack;
mod page;
mod parts;
mod positions;
mod rows;
mod shapes;
mod tally;
mod text;

pub use collect::{Collect, View};
pub use pack::SCHEMA;
pub use page::page;
pub use rows::Part;
