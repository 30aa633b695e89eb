//! The language server as clients meet it: the real program, over standard input and output.

mod changes;
mod client;
mod completion;
mod edits;
mod formatting;
mod life;
mod rename;
mod scenario;
mod tokens;
mod typing;

use client::Client;

#[test]
fn scenarios() {
    scenario::run_all();
}
