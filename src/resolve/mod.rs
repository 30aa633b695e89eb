//! From the trees of files to units with checked blocks and known targets.
//!
//! Everything that the written values tell is found here, whether a block is ever executed or not: structure, forms,
//! ranges, groups, targets, rings. What depends on values and modal state is found by `run`.

mod blocks;
mod checks;
mod cut;
mod flow;
mod foreign;
mod forms;
mod judged;
mod letters;
mod library;
mod lines;
mod m_words;
mod meant;
mod misnamed;
mod numbers;
mod pending;
mod planes;
mod points;
mod program;
mod rings;
mod roles;
mod spelling;
mod structure;
mod targets;
mod unused;

pub use blocks::m_number;
pub use forms::{FormFault, check_form, feed_mode_before, with_feed_mode};
pub use library::{Library, MacrocycleFault};
pub use meant::may_have_end;
pub use misnamed::{is_program, report_misnamed};
pub use planes::missing_axis;
pub use points::Points;
pub use program::{Resolved, Target, Unit, UnitId, UnitKind};
pub use rings::ring_text;
pub use roles::{Roles, Taker};
pub use structure::{ControlWord, control_result, control_word, l_number, resolve_macrocycle, resolve_program};
pub use targets::{
    Namesake, conflicting_g, conflicting_m, has_block, jump_target, macrocycle_finding, missing_control_words,
    report_of_machine, subprogram, value_or_word,
};
