//! The machine that a program is for: project file, ChannelConfig and machine constants become one validated [`Machine`].

mod machine;
mod mfunctions;

pub use machine::{Axes, Axis, Gear, Level, Limits, Machine, Purpose, Settings};
pub use mfunctions::{MFunction, MFunctions};
