//! The motion planner: closed forms, invariances, constraints that a separate verifier checks.

mod build;
mod closed;
mod command;
mod constants;
mod invariance;
mod joints;
mod merging;
mod optimal;
mod programs;
mod random;
mod sets;
mod trying;
mod verify;
