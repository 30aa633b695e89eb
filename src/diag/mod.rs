//! Findings: one registry of codes and texts, the findings of a run, and their renderings.
//!
//! A [`Finding`] is a row of the registry with its fields filled in; a [`Diagnostic`] is a finding at a place. There is
//! no other way to tell a user that something is wrong with a program.

mod advice;
mod after_end;
mod details;
mod diagnostic;
pub mod explain;
mod findings;
mod geometry;
mod labels;
mod levels;
mod other_controls;
mod registry;
mod render;
mod report;
mod settings;
mod shown;
mod values;

pub use advice::{
    AddressMeant, CommaMeant, DwellMeant, NumberMeant, PointMeant, QuoteMeant, TargetMeant, TextMeant, UnusedMeant,
};
pub use after_end::{AfterEndMeant, Star, Unread, UnreadEnd};
pub use details::{
    ArithmeticFault, CenterPlace, EarlyEnd, JointBreak, JointLimit, MINUS, Meant, OtherControl, ParameterNeed, Problem,
    Unmodelled, is_blank,
};
pub use details::{ConditionProblem, RunTimeReason, SignalProblem};
pub use diagnostic::{CallKind, CallSite, Certain, Diagnostic, Edit, Fix, Label};
pub use findings::{Findings, LIMIT_PER_CODE};
pub use geometry::{ArcMeant, ArcPoints, Centers, PlaneFault, SpindleFault};
pub use labels::{FixTitle, LabelText};
pub use levels::Levels;
pub use other_controls::OtherMeaning;
pub use registry::{Code, Finding, Severity};
pub use render::{Format, Shown, render, schema, unshown};
pub use report::{NotExecuted, Report, Reported, StayedUnknown};
pub use settings::{ConfigNeed, ConfigProblem, ConstantProblem, KnownNames, NameKind, NotUsed, UnusedConstant};
pub use shown::{shown, terminal_safe};
pub use values::ValueMeant;
