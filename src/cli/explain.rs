//! `explain`: pages about findings, functions and addresses.

use std::io::{self, IsTerminal, Write};

use super::args::ExplainArgs;
use super::locale::Locale;
use super::status::{Failure, Status, complain};
use super::topic::{Topic, Unknown};
use super::words::Words;
use crate::diag::{Finding, explain};
use crate::dict::Lang;

pub(super) fn run(args: &ExplainArgs, locale: Locale) -> Result<Status, Failure> {
    let mut out = io::stdout().lock();
    let colors = locale.colors(out.is_terminal());
    let mut status = Status::Fine;
    if args.names.is_empty() {
        out.write_all(explain::list(locale.lang).as_bytes())?;
    }
    let mut separator = "";
    for name in &args.names {
        match Topic::find(name) {
            Ok(topic) => {
                writeln!(out, "{separator}{}", topic.page(locale.lang, colors).trim_end())?;
                separator = "\n";
            }
            Err(unknown) => {
                status = Status::Unusable;
                complain(&hint(name, unknown, locale.lang), locale.lang);
            }
        }
    }
    out.flush()?;
    Ok(status)
}

fn hint(name: &str, unknown: Unknown, lang: Lang) -> Words {
    let name = name.to_owned();
    match unknown {
        Unknown::Word(finding) => foreign_word(&finding, lang),
        Unknown::M(number) => Words::NoMFunction { number },
        Unknown::Name(Some(near)) => Words::NothingToExplainNear { name, near: near.to_owned() },
        Unknown::Name(None) => Words::NothingToExplain { name },
    }
}

fn foreign_word(finding: &Finding, lang: Lang) -> Words {
    let message = finding.message(lang);
    match finding.help(lang) {
        Some(help) => Words::Foreign { text: format!("{message}; {help}") },
        None => Words::Foreign { text: message },
    }
}
