//! The machine that a program is for: project file, ChannelConfig and machine constants become one validated [`Machine`].

mod channel;
mod constants;
mod keys;
mod machine;
mod mfunctions;
mod names;
mod near;
mod number;
mod overrides;
mod project;
mod reader;
mod sections;
mod takes;
mod toml_problem;
mod xml;

pub use machine::{Axes, Axis, Gear, Level, Limits, Machine, Settings};
pub use mfunctions::{MFunction, MFunctions};
pub use number::{ParameterFault, parse_decimal, parse_parameter};
pub use overrides::Overrides;
use takes::Takes;
