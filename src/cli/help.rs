//! The command line with its help in the user's language. Shell completions and manual pages are made from it too.

use clap::builder::Styles;
use clap::{Arg, Command, CommandFactory};

use super::args::CommandLine;
use super::help_texts::{ArgumentText, CommandText};
use super::{help_places, help_rewrites, help_texts};
use crate::dict::Lang;

/// The command line with its help in `lang`.
pub(super) fn command(lang: Lang) -> Command {
    let command = localized(CommandLine::command(), lang);
    match lang {
        Lang::En => command,
        Lang::Cs => with_czech_usage(command),
    }
}

fn commands() -> impl Iterator<Item = &'static CommandText> {
    help_texts::COMMANDS.iter().chain(help_places::COMMANDS).chain(help_rewrites::COMMANDS)
}

fn arguments() -> impl Iterator<Item = &'static ArgumentText> {
    help_texts::ARGUMENTS.iter().chain(help_places::ARGUMENTS).chain(help_rewrites::ARGUMENTS)
}

fn localized(command: Command, lang: Lang) -> Command {
    let name = command.get_name().to_owned();
    let command = match commands().find(|text| text.name == name) {
        Some(text) if text.examples.en.is_empty() => command.about(text.about.get(lang)),
        Some(text) => command.about(text.about.get(lang)).after_help(examples(text, lang)),
        None => command,
    };
    let styles = Styles::styled();
    let usage = styles.get_usage();
    let [usage_word, commands, value] = match lang {
        Lang::En => ["Usage:", "Commands", "COMMAND"],
        Lang::Cs => ["Použití:", "Příkazy", "PŘÍKAZ"],
    };
    command
        .help_template(format!(
            "{{about-with-newline}}\n{usage}{usage_word}{usage:#} {{usage}}\n\n{{all-args}}{{after-help}}"
        ))
        .subcommand_help_heading(commands)
        .subcommand_value_name(value)
        .mut_args(|argument| localized_argument(argument, &name, lang))
        .mut_subcommands(|subcommand| localized(subcommand, lang))
}

/// The examples of a command, without those that this build does not take, and what is said of it: a paragraph is one
/// line, which the terminal's width breaks.
fn examples(text: &CommandText, lang: Lang) -> String {
    let lines = text.examples.get(lang).trim_end().lines();
    let taken = lines.filter(|line| cfg!(feature = "arrow") || !line.contains("--format arrow"));
    let (mut joined, mut goes_on) = (String::new(), false);
    for line in taken {
        let is_text = !line.is_empty() && !line.starts_with(' ');
        joined.push_str(if goes_on && is_text { " " } else { "\n" });
        joined.push_str(line);
        goes_on = is_text && !line.ends_with(':');
    }
    joined.trim_start_matches('\n').to_owned()
}

fn localized_argument(argument: Arg, command: &str, lang: Lang) -> Arg {
    let Some(text) = row(command, argument.get_id().as_str()) else { return argument };
    let mut help = text.help.get(lang).to_owned();
    let takes_values = argument.get_action().takes_values();
    if takes_values {
        let choices = argument.get_possible_values();
        if !choices.is_empty() {
            let names: Vec<&str> = choices.iter().map(clap::builder::PossibleValue::get_name).collect();
            help.push_str(&format!(" [{}]", names.join(", ")));
        }
        if let [default] = argument.get_default_values() {
            let word = match lang {
                Lang::En => "default",
                Lang::Cs => "výchozí",
            };
            help.push_str(&format!(" [{word}: {}]", default.to_string_lossy()));
        }
    }
    let value = argument.get_value_names().and_then(|names| names.first()).and_then(|name| {
        let mut values = help_texts::VALUES.iter().chain(help_places::VALUES);
        let known = values.find(|value| value.en == name.as_str())?;
        Some(known.get(lang))
    });
    let argument = argument
        .help(help)
        .help_heading(text.heading.text().get(lang))
        .hide_possible_values(takes_values)
        .hide_default_value(takes_values);
    match value {
        Some(value) => argument.value_name(value),
        None => argument,
    }
}

fn row(command: &str, id: &str) -> Option<&'static ArgumentText> {
    let is_it = |text: &&ArgumentText| text.id == id && (text.command.is_empty() || text.command == command);
    // The text of a command comes before the one that all share.
    arguments().filter(is_it).max_by_key(|text| !text.command.is_empty())
}

/// clap's own words in the line that shows the usage.
fn with_czech_usage(command: Command) -> Command {
    let mut built = command.clone();
    built.build();
    let usage = |built: &Command| {
        let usage = built.clone().render_usage().to_string();
        usage.trim_start_matches("Usage: ").replace("[OPTIONS]", "[VOLBY]")
    };
    let root = usage(&built);
    command.override_usage(root).mut_subcommands(|subcommand| match built.find_subcommand(subcommand.get_name()) {
        Some(built) => subcommand.override_usage(usage(built)),
        None => subcommand,
    })
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::cli::args::CommonArgs;

    fn built() -> Command {
        let mut command = CommandLine::command();
        command.build();
        command
    }

    #[test]
    fn the_command_line_is_consistent_in_both_languages() {
        command(Lang::En).debug_assert();
        command(Lang::Cs).debug_assert();
    }

    #[test]
    fn every_command_and_argument_has_its_row_and_every_row_its_use() {
        let built = built();
        let all: Vec<&Command> = std::iter::once(&built).chain(built.get_subcommands()).collect();
        let mut used: Vec<(&str, &str)> = Vec::new();
        for command in &all {
            assert!(commands().any(|text| text.name == command.get_name()), "{}", command.get_name());
            for argument in command.get_arguments() {
                let found = row(command.get_name(), argument.get_id().as_str());
                let found = found.unwrap_or_else(|| panic!("{} {}", command.get_name(), argument.get_id()));
                used.push((found.command, found.id));
            }
        }
        assert_eq!(commands().count(), all.len());
        for text in arguments() {
            assert!(used.contains(&(text.command, text.id)), "{} {}", text.command, text.id);
        }
    }

    #[test]
    fn both_languages_say_something_of_their_own() {
        for text in arguments() {
            assert_ne!(text.help.en, text.help.cs, "{}", text.id);
        }
        for text in commands() {
            assert_ne!(text.about.en, text.about.cs, "{}", text.name);
        }
        let mut czech = command(Lang::Cs);
        czech.build();
        for command in std::iter::once(czech.clone()).chain(czech.get_subcommands().cloned()) {
            let help = command.clone().render_help().to_string();
            for word in ["Usage", "OPTIONS", "Options", "Arguments", "default", "possible", "Print"] {
                assert!(!help.contains(word), "{}: {word}\n{help}", command.get_name());
            }
        }
    }

    /// What `check` and `compile` can say over the project file is what the table of its keys says they can.
    #[test]
    fn options_are_those_of_the_keys() {
        #[derive(Parser)]
        struct Common {
            #[command(flatten)]
            common: CommonArgs,
        }
        // How to show findings, and which project file.
        let own = ["--all", "--format", "--config", "-h"];
        let command = Common::command();
        let name = |arg: &Arg| match (arg.get_long(), arg.get_short()) {
            (Some(long), _) => format!("--{long}"),
            (None, Some(short)) => format!("-{short}"),
            (None, None) => arg.get_id().to_string(),
        };
        let mut given: Vec<_> =
            command.get_arguments().map(name).filter(|name| !own.contains(&name.as_str())).collect();
        let mut expected = crate::config::options();
        given.sort_unstable();
        expected.sort_unstable();
        assert_eq!(given, expected);
    }
}
