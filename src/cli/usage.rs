//! Wrong usage, in both languages. clap's own words are English, and repeat arguments as they came, control characters
//! included.

use std::ffi::OsStr;
use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::words::error_prefix;
use crate::config::EXTENSIONS;
use crate::diag::terminal_safe;
use crate::dict::Lang;

/// What clap found wrong, for stderr, with the usage of the command.
pub(super) fn message(error: &clap::Error, lang: Lang, colors: bool) -> String {
    let (on, off) = if colors { ("\u{1b}[1;31m", "\u{1b}[0m") } else { ("", "") };
    let mut text = format!("{on}{}:{off} {}\n", error_prefix(lang), terminal_safe(&what(error, lang)));
    let (tip, usage, more) = match lang {
        Lang::En => ("perhaps this is meant", "Usage", "Help: --help"),
        Lang::Cs => ("možná mělo být", "Použití", "Nápověda: --help"),
    };
    for kind in [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue] {
        // The best one comes last.
        let near = match error.get(kind) {
            Some(ContextValue::Strings(texts)) => texts.last().cloned().unwrap_or_default(),
            _ => context(error, kind),
        };
        if !near.is_empty() {
            text.push_str(&format!("  {tip}: {}\n", terminal_safe(&near)));
        }
    }
    if error.kind() == ErrorKind::InvalidSubcommand
        && let Some(file) = Some(context(error, ContextKind::InvalidSubcommand)).filter(|name| is_program(name))
    {
        text.push_str(&format!("  {tip}: cnc872c check {}\n", terminal_safe(&file)));
    }
    let line = context(error, ContextKind::Usage);
    let line = line.trim_start_matches("Usage: ").trim();
    if line.is_empty() {
        text.push_str(&format!("\n{more}\n"));
    } else {
        text.push_str(&format!("\n{usage}: {line}\n{more}\n"));
    }
    text
}

/// Whether the command line has a file in the place of the command.
fn is_program(name: &str) -> bool {
    let path = Path::new(name);
    let named_so = |extension: &str| EXTENSIONS.iter().any(|own| own.eq_ignore_ascii_case(extension));
    path.extension().and_then(OsStr::to_str).is_some_and(named_so) || path.is_file()
}

#[expect(clippy::wildcard_enum_match_arm, reason = "clap may add kinds of errors")]
fn what(error: &clap::Error, lang: Lang) -> String {
    let argument = context(error, ContextKind::InvalidArg);
    let value = context(error, ContextKind::InvalidValue);
    let choices = context(error, ContextKind::ValidValue);
    let text = |en: String, cs: String| match lang {
        Lang::En => en,
        Lang::Cs => cs,
    };
    match error.kind() {
        ErrorKind::InvalidValue if value.is_empty() => text(
            format!("{argument} lacks its value{}", list(&choices)),
            format!("za {argument} chybí hodnota{}", list(&choices)),
        ),
        ErrorKind::InvalidValue => text(
            format!("{argument} does not take `{value}`{}", list(&choices)),
            format!("za {argument} nemůže být „{value}“{}", list(&choices)),
        ),
        ErrorKind::ValueValidation => {
            let why = std::error::Error::source(error).map(|why| reason(&why.to_string(), lang));
            let why = why.unwrap_or_default();
            text(format!("{argument} does not take `{value}`{why}"), format!("za {argument} nemůže být „{value}“{why}"))
        }
        ErrorKind::UnknownArgument if argument.len() == 2 && argument.ends_with(char::is_alphabetic) => text(
            format!("unexpected argument `{argument}`; a file whose name begins with `-` is given as `./-…`"),
            format!("argument „{argument}“ je navíc; soubor, jehož název začíná pomlčkou, se zadává jako „./-…“"),
        ),
        ErrorKind::UnknownArgument => {
            text(format!("unexpected argument `{argument}`"), format!("argument „{argument}“ je navíc"))
        }
        ErrorKind::InvalidSubcommand => {
            let command = context(error, ContextKind::InvalidSubcommand);
            text(format!("there is no command `{command}`"), format!("příkaz „{command}“ neexistuje"))
        }
        // One of the group of places.
        ErrorKind::MissingRequiredArgument if argument == "--n <N>" => text(
            "the place is missing: --n, --line, --seq, --time or --at-tool".to_owned(),
            "chybí místo: --n, --line, --seq, --time nebo --at-tool".to_owned(),
        ),
        ErrorKind::MissingRequiredArgument => text(format!("{argument} is missing"), format!("chybí {argument}")),
        ErrorKind::MissingSubcommand => text("the command is missing".to_owned(), "chybí příkaz".to_owned()),
        ErrorKind::ArgumentConflict => {
            let other = context(error, ContextKind::PriorArg);
            if other == argument || other.is_empty() {
                text(format!("{argument} is given more than once"), format!("{argument} je zadáno vícekrát"))
            } else {
                text(format!("{argument} cannot be used with {other}"), format!("{argument} nelze použít s {other}"))
            }
        }
        ErrorKind::TooManyValues | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues => {
            text(format!("{argument} takes another number of values"), format!("{argument} má jiný počet hodnot"))
        }
        ErrorKind::InvalidUtf8 => text("an argument is not UTF-8".to_owned(), "argument není v UTF-8".to_owned()),
        _ => error.kind().as_str().unwrap_or("wrong usage").to_owned(),
    }
}

/// Why a value cannot be read, for the end of the message: the library speaks English only, parsers of values give an
/// example.
fn reason(why: &str, lang: Lang) -> String {
    let (en, cs) = match why.rsplit_once(" is not in ").and_then(|(_, range)| range.split_once("..")) {
        // The greatest number of the computer is no limit that a user knows.
        Some((least, most)) => match most.trim_start_matches('=').parse() {
            Ok(most @ 0..u32::MAX) => (format!(": it is {least} to {most}"), format!(": smí to být {least} až {most}")),
            Ok(u32::MAX) | Err(_) => (format!(": it is at least {least}"), format!(": nejmenší hodnota je {least}")),
        },
        None if why.contains("invalid digit") || why.contains("from empty string") => {
            (": it is a whole number".to_owned(), ": má to být celé číslo".to_owned())
        }
        None if why.starts_with("number too large") => {
            (": it is too large".to_owned(), ": číslo je příliš velké".to_owned())
        }
        None => (format!("; for example {why}"), format!("; například {why}")),
    };
    match lang {
        Lang::En => en,
        Lang::Cs => cs,
    }
}

fn list(choices: &str) -> String {
    if choices.is_empty() { String::new() } else { format!(" [{choices}]") }
}

fn context(error: &clap::Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        Some(ContextValue::StyledStr(text)) => text.to_string(),
        Some(ContextValue::StyledStrs(texts)) => texts.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "),
        Some(ContextValue::Number(number)) => number.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::help;

    fn said(lang: Lang, line: &[&str]) -> String {
        let error = help::command(lang).try_get_matches_from(line).unwrap_err();
        message(&error, lang, false)
    }

    #[test]
    fn in_both_languages() {
        let wrong = ["cnc872c", "compile", "a.nc", "--dialect", "cnc827"];
        assert_eq!(
            said(Lang::En, &wrong),
            "error: --dialect <DIALECT> does not take `cnc827` [cnc8x6, cnc8x9, cnc872]\n  perhaps this is meant: \
             cnc872\n\nHelp: --help\n"
        );
        assert!(said(Lang::Cs, &wrong).starts_with("chyba: za --dialect <SYSTÉM> nemůže být „cnc827“"));
        assert!(said(Lang::Cs, &["cnc872c", "check"]).contains("chybí <CESTA>"));
        let limit = |value| said(Lang::Cs, &["cnc872c", "check", "a.nc", "--max-blocks", value]);
        assert!(limit("0").contains("nemůže být „0“: nejmenší hodnota je 1\n"), "{}", limit("0"));
        assert!(limit("x").contains("nemůže být „x“: má to být celé číslo\n"), "{}", limit("x"));
        assert!(limit("99999999999999999999").contains(": číslo je příliš velké\n"));
        let tolerance = |lang| said(lang, &["cnc872c", "compare", "a.nc", "b.nc", "--tolerance", "0,01"]);
        assert!(tolerance(Lang::En).contains("does not take `0,01`; for example 0.01\n"), "{}", tolerance(Lang::En));
        assert!(tolerance(Lang::Cs).contains("nemůže být „0,01“; například 0.01\n"), "{}", tolerance(Lang::Cs));
        assert!(said(Lang::Cs, &["cnc872c", "check"]).contains("Použití: cnc872c check"));
        assert!(said(Lang::En, &["cnc872c", "check", "-x.nc"]).contains("given as `./-…`"));
        assert!(said(Lang::Cs, &["cnc872c", "check", "-x.nc"]).contains("zadává jako „./-…“"));
        assert!(said(Lang::En, &["cnc872c", "chekc"]).contains("perhaps this is meant: check"));
        assert!(said(Lang::En, &["cnc872c", "celo.nc"]).contains("perhaps this is meant: cnc872c check celo.nc\n"));
        assert!(said(Lang::Cs, &["cnc872c", "check", "a", "--fix", "--diff"]).contains("nelze použít s"));
        assert!(said(Lang::En, &["cnc872c", "check", "a", "--fux"]).contains("--fix"));
    }

    #[test]
    fn control_characters_do_not_reach_the_terminal() {
        for line in [["cnc872c", "\u{1b}[2J", "x"], ["cnc872c", "check", "--\u{1b}[2J"]] {
            assert!(!said(Lang::En, &line).contains('\u{1b}'));
        }
    }
}
