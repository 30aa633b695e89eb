//! The machine that a program is for: project file, ChannelConfig and machine constants become one validated
//! [`Machine`].

mod channel;
mod client;
mod configure;
mod constant;
mod constants;
mod draft;
mod find;
mod format;
mod init;
mod key;
mod keys;
mod machine;
mod mfunctions;
mod modes;
mod motion;
mod motion_constants;
mod motion_keys;
mod motion_values;
mod names;
mod near;
mod number;
mod overrides;
mod ranges;
mod reader;
mod reference;
mod row;
mod schema;
mod sections;
mod takes;
mod toml_problem;
mod tried;
mod xml;

pub use client::{client_keys, client_overrides};
pub use configure::configure;
pub use constant::Constant;
pub use find::{PROJECT_FILE, find_project};
pub use format::{Codes, Numbers, Style};
pub use init::{Surroundings, initial};
pub use key::Key;
pub use machine::{Axes, Axis, EXTENSIONS, Gear, Level, Limits, Machine, MayMove, Purpose, Settings};
pub use mfunctions::{MFunction, MFunctions};
pub use modes::{ArcCenters, G97, SpindleAxis};
pub use motion::{
    DynamicSet, From as GivenBy, Given, Motion, MotionKey, Profile, Rapid, Recognition, SetKey, SetValue, TimedFunction,
};
pub use number::{ParameterFault, parse_decimal, parse_parameter, parse_position};
pub use overrides::Overrides;
pub use reference::reference;
pub use schema::schema;
#[cfg(test)]
pub(crate) use sections::options;
pub use tried::{TriedFault, tried_fault};

#[cfg(test)]
mod row_tests;
#[cfg(test)]
mod sample_tests;
#[cfg(test)]
mod schema_tests;
#[cfg(test)]
mod tests;
