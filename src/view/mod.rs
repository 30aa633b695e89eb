//! The picture of an executed program: the data of the page that shows it, the page itself, still pictures.
//!
//! | stage | from | to | by |
//! |---|---|---|---|
//! | collect | executed blocks | rows: each execution once, however often it is repeated | `rows`, with `parts`, `noted`, `shapes`, `positions`, `arcs`, `calls`, `files` |
//! | plan | executed blocks | velocities, joints, times | `analysis::motion`, read by `times` |
//! | take apart | texts | skeletons and what cannot be foretold | `text` |
//! | pack | rows | columns of whole numbers, deflated | `pack`, with `column`, `tally`, `container`; `page` puts them into HTML |
//! | lay out | rows | a still picture: lines, dots, texts | `picture`, with `lines`, `chains`, `projection`, `display` |
//! | write | a still picture | SVG, PNG | `svg`; `png` with `scan` and `glyphs` |
//!
//! What is kept is bounded by what is drawn: a still picture has no records, equal executions share rows and plans,
//! texts are deflated as they come (`container::Long`), and [`Collector::within`] gives up before memory runs out.
//! `names` keeps folders out of the page.
//!
//! `web/src/data` reads what is packed here; `docs/reference/page-data.md` describes it.

mod arcs;
mod calls;
mod chains;
mod collect;
mod column;
mod container;
mod display;
mod files;
mod foretold;
mod glyphs;
mod hash;
mod lines;
mod names;
mod noted;
mod pack;
mod page;
mod parts;
mod picture;
mod png;
mod positions;
mod projection;
mod rows;
mod scan;
mod shapes;
mod svg;
mod tally;
mod tangents;
mod text;
mod times;
mod turning;

pub use collect::{Collect, Collector, View};
pub use names::Naming;
pub use pack::SCHEMA;
pub use page::page;
pub use picture::{LeftOut, Picture, Still};
pub use projection::Plane;
pub use rows::{Keep, Part};
