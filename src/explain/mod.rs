//! Pages about everything that has a name: findings, functions, addresses, keys of the project file. The command line
//! prints them, the editor opens them.

mod functions;
mod m_usage;
mod search;
mod signal_page;
mod topic;
mod usage;

pub use search::{Hit, search, search_stems};
pub use topic::{Topic, Unknown, nearest};
