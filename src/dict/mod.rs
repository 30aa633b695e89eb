//! The language as data: addresses, G functions, M functions, dialects, and the exact numbers of words.
//!
//! Every row says what it is in English and Czech, and cites its rule. The parser, the checks, `explain` and the
//! reference pages read these rows. M functions that rules of execution name are constants beside the rows; so are
//! limits.

mod address;
mod arithmetic;
mod decimal;
mod dialect;
mod feed_mode;
mod gcode;
mod lang;
mod mcode;
mod micro;
mod plane;
mod range;

pub use address::{
    Address, AddressRow, AxisLetter, FEED_PER_REVOLUTION, FIRST_CONTROL, HIGHEST_BLOCK, HIGHEST_L, HIGHEST_P,
    HIGHEST_PARAMETER, HIGHEST_Q, HIGHEST_S, LAST_CONTROL, RESERVED_PARAMETER, ValueForm,
};
pub use arithmetic::Operation;
pub use decimal::Decimal;
pub use dialect::Dialect;
pub use feed_mode::{FeedMode, FeedPer, FeedRow};
pub use gcode::{GCode, GGroup, Lasting};
pub use lang::{Bilingual, Lang};
pub(crate) use lang::{bilingual, capitalized};
pub use mcode::{
    BUILDER_GROUPS, CALL_ELSEWHERE, CLAMP_GROUP, COOLANT_12, COOLANT_12_GROUP, COOLANT_34, COOLANT_34_GROUP,
    FEED_FUNCTIONS, FEED_GROUP, GEAR_BY_SPEED, GEAR_GROUP, GEARS, HELD_AT_STOP, M_GROUPS, MOMENTARY_GROUPS, MRow,
    OPTIONAL_STOP, ORIENTED_STOP, OTHER_GROUP, PROGRAM_ENDS, PROGRAM_GROUP, PROGRAM_STOP, REDUCED_FEED, SPINDLE_GROUP,
    SPINDLE_STOP, SPINDLE_TURNS, TOOL_CHANGE, gear_function, standard_m_functions,
};
pub use micro::Micro;
pub use plane::{Plane, PlaneAxis};
pub use range::{DWELL, DYNAMIC_SETS, FIRST_DYNAMIC_SET, ValueRange, ValueUnit, When};
