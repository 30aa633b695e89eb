//! `completions`, `man`, `help`: what is made from the definition of the command line.

use std::io::{self, IsTerminal, Write};

use clap::Command;

use super::args::{CompletionsArgs, HelpArgs, ManArgs};
use super::help;
use super::locale::Locale;
use super::status::{Failure, Status, stdout};
use super::words::Words;

const NAME: &str = "cnc872c";

pub(super) fn completions(args: &CompletionsArgs, locale: Locale) -> Result<Status, Failure> {
    // Into memory first: the generator panics when it cannot write.
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut help::command(locale.lang), NAME, &mut script);
    put(&script)
}

pub(super) fn man(args: &ManArgs, locale: Locale) -> Result<Status, Failure> {
    let command = find(args.command.as_deref(), locale)?;
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page)?;
    put(&page)
}

pub(super) fn help(args: &HelpArgs, locale: Locale) -> Result<Status, Failure> {
    let mut command = find(args.command.as_deref(), locale)?;
    let help = command.render_help();
    if locale.colors(io::stdout().is_terminal()) {
        put(help.ansi().to_string().as_bytes())
    } else {
        put(help.to_string().as_bytes())
    }
}

/// The whole command line, or one command of it, with the options of every command.
fn find(name: Option<&str>, locale: Locale) -> Result<Command, Failure> {
    let mut command = help::command(locale.lang);
    command.build();
    let Some(name) = name else { return Ok(command) };
    match command.find_subcommand(name) {
        Some(found) => Ok(found.clone()),
        None => Err(Words::NoCommand { name: name.to_owned() }.into()),
    }
}

fn put(bytes: &[u8]) -> Result<Status, Failure> {
    let mut out = stdout()?;
    out.write_all(bytes)?;
    out.flush()?;
    Ok(Status::Fine)
}
