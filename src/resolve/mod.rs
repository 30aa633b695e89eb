//! From the trees of files to units with checked blocks and known targets.
//!
//! Everything that the written values tell is found here, whether a block is ever executed or not: structure, forms,
//! ranges, groups, targets, rings. What depends on values and modal state is found by `run`.

mod axis_letters;
mod control_words;
mod flow;
mod foreign;
mod forms;
mod functions;
mod holes;
mod judge_block;
mod judge_file;
mod judge_word;
mod library;
mod load;
mod misnamed;
mod numbers;
mod open_ends;
mod planes;
mod points;
mod program;
mod rings;
mod roles;
mod skips;
mod spelling;
mod star;
mod targets;
mod units;
mod unnumbered;
mod unused_l;

pub use axis_letters::usable_axes;
pub use control_words::{ControlWord, control_result, control_word};
pub use forms::{FormFault, check_form, feed_mode_before, with_feed_mode};
pub use functions::m_number;
pub use holes::{Known, may_assign, may_have_end};
pub use library::{Library, MacrocycleFault};
pub use load::resolve;
pub use misnamed::{begins_macrocycle, is_program, report_misnamed};
pub use numbers::number_as_function;
pub use planes::missing_axis;
pub use points::Points;
pub use program::{Resolved, Target, Unit, UnitId, UnitKind};
pub use rings::ring_text;
pub use roles::{Roles, Taker, l_number};
pub use targets::{
    Namesake, centers_without_use, conflicting_g, conflicting_m, has_block, jump_target, macrocycle_finding,
    missing_control_words, subprogram, value_or_word,
};
