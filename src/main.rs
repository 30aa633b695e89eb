//! The program `cnc872c`: see [`cnc872c::cli`].

use std::process::ExitCode;

fn main() -> ExitCode {
    cnc872c::cli::main(std::env::args_os())
}
