//! The command line: one file a command. Data goes to stdout, words to stderr; nothing else in the program prints.

mod args;
mod check;
mod common;
mod compare;
mod compile;
mod diff;
mod explain;
mod fix;
mod format;
mod help;
mod help_places;
mod help_rewrites;
mod help_texts;
mod init;
mod job;
mod locale;
mod lsp;
mod memory;
mod motion;
mod place;
mod plc;
mod progress;
mod renumber;
mod replace;
mod report;
mod restart;
mod rewrite;
mod schema;
mod shell;
mod state;
mod stats;
pub mod stats_cache;
mod status;
mod threads;
mod usage;
mod view;
pub mod walk;
mod words;

use std::ffi::OsString;
use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

use clap::FromArgMatches;
use clap::error::ErrorKind;

use args::{Command, CommandLine};
use locale::Locale;
use status::{Failure, Status, exit_code, stdout};

/// Runs the command line `arguments`, the name of the program first. The exit status: 0 no errors, 1 the programs have
/// errors, 2 it could not run.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    // A file beyond `ulimit -f` is output that cannot be written, not the end of the process.
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
    ExitCode::from(status(arguments))
}

/// The same, with the exit status as a number: for programs that have the command line within them.
pub fn status(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let locale = Locale::find(&arguments);
    let matches = help::command(locale.lang).color(locale.clap_color()).try_get_matches_from(arguments);
    let end = match matches.and_then(|matches| CommandLine::from_arg_matches(&matches)) {
        Ok(line) => run(&line.command, locale),
        Err(error) => answer(&error, locale),
    };
    exit_code(end, locale.lang)
}

fn run(command: &Command, locale: Locale) -> Result<Status, Failure> {
    match command {
        Command::Check(args) => check::run(args, locale),
        Command::Compile(args) => compile::run(args, locale),
        Command::Format(args) => format::run(args, locale),
        Command::Renumber(args) => renumber::run(args, locale),
        Command::View(args) => view::run(args, locale),
        Command::Report(args) => report::run(args, locale),
        Command::Compare(args) => compare::run(args, locale),
        Command::Restart(args) => restart::run(args, locale),
        Command::State(args) => state::run(args, locale),
        Command::Explain(args) => explain::run(args, locale),
        Command::Init(args) => init::run(args, locale),
        Command::Lsp(_) => lsp::run(locale),
        Command::Motion(args) => motion::run(args, locale),
        Command::Plc(args) => plc::run(args, locale),
        Command::Stats(args) => stats::run(args, locale),
        Command::Schema(args) => schema::run(args),
        Command::Completions(args) => shell::completions(args, locale),
        Command::Man(args) => shell::man(args, locale),
        Command::Help(args) => shell::help(args, locale),
    }
}

/// Help and version that were asked for go to stdout; what is wrong with the command line goes to stderr.
fn answer(error: &clap::Error, locale: Locale) -> Result<Status, Failure> {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        drop(stdout()?);
        error.print()?;
        io::stdout().flush()?;
        return Ok(Status::Fine);
    }
    // Nobody can be told that stderr is gone.
    let _ = if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        error.print()
    } else {
        let colors = locale.colors(io::stderr().is_terminal());
        io::stderr().lock().write_all(usage::message(error, locale.lang, colors).as_bytes())
    };
    Ok(Status::Unusable)
}
