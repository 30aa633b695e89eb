//! The motion planner: closed forms, invariances, constraints checked by a verifier of its own.

mod build;
mod closed;
mod command;
mod constants;
mod invariance;
mod joints;
mod merging;
mod optimal;
mod random;
mod sets;
mod trying;
mod verify;
