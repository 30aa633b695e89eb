//! Language and colours: what the command line says, else the environment.

use std::ffi::{OsStr, OsString};

use clap::ValueEnum;

use super::args::ColorWhen;
use crate::dict::Lang;
use crate::sure::Sure;

/// Language and colours, found out before the command line is parsed: the messages of the parser need them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Locale {
    pub lang: Lang,
    /// That of `--lang`, when it is given.
    pub chosen: Option<Lang>,
    pub color: ColorWhen,
}

impl Locale {
    /// From the arguments, of which wrong ones are ignored here, and the environment.
    pub fn find(arguments: &[OsString]) -> Self {
        let lang = option(arguments, "--lang").and_then(|value| Lang::from_str(&value, false).ok());
        let color = option(arguments, "--color").and_then(|value| ColorWhen::from_str(&value, false).ok());
        Self {
            lang: lang.unwrap_or_else(|| from_environment(environment)),
            chosen: lang,
            color: color.unwrap_or_default(),
        }
    }

    /// Whether to colour a stream.
    pub fn colors(self, is_terminal: bool) -> bool {
        self.colors_in(is_terminal, environment)
    }

    fn colors_in(self, is_terminal: bool, variable: impl Fn(&str) -> Option<OsString>) -> bool {
        match self.color {
            ColorWhen::Always => true,
            ColorWhen::Never => false,
            ColorWhen::Auto => {
                is_terminal && variable("NO_COLOR").is_none() && variable("TERM").is_none_or(|term| term != "dumb")
            }
        }
    }

    /// The same for clap.
    pub fn clap_color(self) -> clap::ColorChoice {
        match self.color {
            ColorWhen::Always => clap::ColorChoice::Always,
            ColorWhen::Never => clap::ColorChoice::Never,
            ColorWhen::Auto => clap::ColorChoice::Auto,
        }
    }
}

/// The language of the first of `LC_ALL`, `LC_MESSAGES` and `LANG` that is set.
fn from_environment(variable: impl Fn(&str) -> Option<OsString>) -> Lang {
    let set = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().find_map(variable).unwrap_or_default();
    let bytes = set.as_encoded_bytes();
    let language = bytes.split(|byte| matches!(byte, b'_' | b'.' | b'@' | b'-')).next().sure();
    if language.eq_ignore_ascii_case(b"cs") { Lang::Cs } else { Lang::En }
}

/// A variable of the environment; one that is set to nothing counts as not set.
#[expect(clippy::disallowed_methods, reason = "this is where the command line reads the environment")]
fn environment(name: &str) -> Option<OsString> {
    std::env::var_os(name).filter(|value| !value.is_empty())
}

/// The value of a long option, as `--name value` or `--name=value`.
fn option(arguments: &[OsString], name: &str) -> Option<String> {
    let mut arguments = arguments.iter().map(OsString::as_os_str).take_while(|&argument| argument != "--");
    while let Some(argument) = arguments.next() {
        if argument == name {
            return arguments.next().and_then(OsStr::to_str).map(str::to_owned);
        }
        let value = argument.to_str().and_then(|text| text.strip_prefix(name)?.strip_prefix('='));
        if let Some(value) = value {
            return Some(value.to_owned());
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn get(set: &[(&str, &str)], name: &str) -> Option<OsString> {
        set.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).into())
    }

    fn lang(set: &[(&str, &str)]) -> Lang {
        from_environment(|name| get(set, name))
    }

    #[test]
    fn colours_are_for_terminals_that_want_them() {
        let colors = |color, is_terminal, set: &[(&str, &str)]| {
            Locale { lang: Lang::En, chosen: None, color }.colors_in(is_terminal, |name| get(set, name))
        };
        assert!(colors(ColorWhen::Auto, true, &[("TERM", "xterm")]));
        assert!(!colors(ColorWhen::Auto, true, &[("TERM", "xterm"), ("NO_COLOR", "1")]));
        assert!(!colors(ColorWhen::Auto, true, &[("TERM", "dumb")]));
        assert!(!colors(ColorWhen::Auto, false, &[]));
        assert!(colors(ColorWhen::Always, false, &[("NO_COLOR", "1")]));
        assert!(!colors(ColorWhen::Never, true, &[]));
    }

    #[test]
    fn the_first_variable_that_is_set_counts() {
        assert_eq!(lang(&[]), Lang::En);
        assert_eq!(lang(&[("LANG", "cs_CZ.UTF-8")]), Lang::Cs);
        assert_eq!(lang(&[("LANG", "cs_CZ.UTF-8"), ("LC_ALL", "C")]), Lang::En);
        assert_eq!(lang(&[("LANG", "en_US.UTF-8"), ("LC_MESSAGES", "cs")]), Lang::Cs);
        assert_eq!(lang(&[("LANG", "csb_PL")]), Lang::En);
    }

    #[test]
    fn options_are_found_before_parsing() {
        let line = |words: &[&str]| words.iter().map(OsString::from).collect::<Vec<_>>();
        assert_eq!(option(&line(&["cnc872c", "check", "--lang", "cs"]), "--lang").as_deref(), Some("cs"));
        assert_eq!(option(&line(&["cnc872c", "--lang=cs", "check"]), "--lang").as_deref(), Some("cs"));
        assert_eq!(option(&line(&["cnc872c", "check", "--", "--lang=cs"]), "--lang"), None);
        assert_eq!(option(&line(&["cnc872c", "--language=cs"]), "--lang"), None);
    }
}
