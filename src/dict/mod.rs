//! The language as data: addresses, G functions, M functions, dialects, and the exact numbers of words.
//!
//! Every row says what it is in English and Czech and which rule it comes from. The parser, the checks, `explain` and the
//! reference pages read these rows; nothing else knows the functions by number.

mod address;
mod arithmetic;
mod decimal;
mod dialect;
mod gcode;
mod lang;
mod mcode;
mod micro;
mod plane;

pub use address::{Address, AddressRow, AxisLetter, ValueForm};
pub use arithmetic::Operation;
pub use decimal::Decimal;
pub use dialect::Dialect;
pub use gcode::{GCode, GGroup, Lasting};
pub(crate) use lang::bilingual;
pub use lang::{Bilingual, Lang};
pub use mcode::{M_GROUPS, MOMENTARY_GROUPS, MRow, PROGRAM_ENDS, REDUCED_FEED, standard_m_functions};
pub use micro::Micro;
pub use plane::{Plane, PlaneAxis};
