//! The motion planner: closed forms, invariances, constraints checked by a verifier of its own.

mod build;
mod closed;
mod random;
mod verify;
