//! What `--help` says, in both languages: the one table of it. Shell completions and manual pages are made from it too.

use clap::builder::Styles;
use clap::{Arg, Command, CommandFactory};

use super::args::CommandLine;
use crate::dict::{Bilingual, Lang};

/// The command line with its help in `lang`.
pub(super) fn command(lang: Lang) -> Command {
    let command = localized(CommandLine::command(), lang);
    match lang {
        Lang::En => command,
        Lang::Cs => with_czech_usage(command),
    }
}

/// Under which heading the help shows an argument.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Heading {
    Arguments,
    Options,
    Machine,
    Levels,
    Everywhere,
}

impl Heading {
    const fn text(self) -> Bilingual {
        match self {
            Self::Arguments => Bilingual { en: "Arguments", cs: "Argumenty" },
            Self::Options => Bilingual { en: "Options", cs: "Volby" },
            Self::Machine => Bilingual { en: "Machine and execution", cs: "Stroj a provádění" },
            Self::Levels => Bilingual { en: "Levels of findings", cs: "Úrovně hlášení" },
            Self::Everywhere => Bilingual { en: "Options of every command", cs: "Volby všech příkazů" },
        }
    }
}

struct CommandText {
    name: &'static str,
    about: Bilingual,
    examples: Bilingual,
}

const fn about(name: &'static str, en: &'static str, cs: &'static str, examples: Bilingual) -> CommandText {
    CommandText { name, about: Bilingual { en, cs }, examples }
}

const COMMANDS: &[CommandText] = &[
    about(
        "cnc872c",
        "Checks and compiles part programs of the CNC8x6, CNC8x9 and CNC872 controls",
        "Kontroluje a překládá partprogramy řídicích systémů CNC8x6, CNC8x9 a CNC872",
        Bilingual {
            en: "\
Examples:
  cnc872c check flange.nc                    every mistake, at its place
  cnc872c compile flange.nc -o flange.jsonl  the blocks as the control executes them
  cnc872c explain E0306                      what a finding means
  cnc872c explain G73                        what a function does

Exit status: 0 no errors, 1 the programs have errors, 2 it could not run.",
            cs: "\
Příklady:
  cnc872c check priruba.nc                     všechny chyby, každá na svém místě
  cnc872c compile priruba.nc -o priruba.jsonl  bloky tak, jak je systém provede
  cnc872c explain E0306                        co hlášení znamená
  cnc872c explain G73                          co funkce dělá

Návratový kód: 0 bez chyb, 1 programy mají chyby, 2 nebylo možné pracovat.",
        },
    ),
    about(
        "check",
        "Checks programs and macrocycles",
        "Zkontroluje programy a makrocykly",
        Bilingual {
            en: "\
Examples:
  cnc872c check flange.nc               one program
  cnc872c check .                       all programs in this folder and the folders in it
  cnc872c check --fix flange.nc         also mends what has one clear fix
  cnc872c check -L macros flange.nc     macrocycles L… are in the folder macros
  cnc872c check --param R10=25.5 a.nc   R10 comes from the machine's table
  cnc872c check -A empty-block -D W0414 a.nc
  cnc872c check --format json . > findings.json
  postprocessor | cnc872c check -       from standard input

Findings go to standard output. Exit status: 0 no errors, 1 errors found (or warnings, with
--deny-warnings), 2 a file cannot be read, or the configuration or the command line is wrong.",
            cs: "\
Příklady:
  cnc872c check priruba.nc              jeden program
  cnc872c check .                       všechny programy v této složce a ve složkách v ní
  cnc872c check --fix priruba.nc        a také opraví, co má jedinou jasnou opravu
  cnc872c check -L makra priruba.nc     makrocykly L… jsou ve složce makra
  cnc872c check --param R10=25.5 a.nc   R10 má hodnotu z tabulky stroje
  cnc872c check -A empty-block -D W0414 a.nc
  cnc872c check --format json . > hlaseni.json
  postprocesor | cnc872c check -        ze standardního vstupu

Hlášení jdou na standardní výstup. Návratový kód: 0 bez chyb, 1 nalezeny chyby (s --deny-warnings
i varování), 2 soubor nelze přečíst, nebo je chyba v konfiguraci či na příkazovém řádku.",
        },
    ),
    about(
        "compile",
        "Writes the block stream of a program: each executed block, in order, as a line of JSON",
        "Zapíše proud bloků programu: každý provedený blok v pořadí jako řádek JSON",
        Bilingual {
            en: "\
Examples:
  cnc872c compile flange.nc                          to standard output
  cnc872c compile flange.nc -o flange.jsonl          to a file: complete, or not at all
  cnc872c compile flange.nc --from 1000 --limit 20   blocks 1000 to 1019 only
  cnc872c compile flange.nc --param R10=25.5         R10 comes from the machine's table
  cnc872c compile flange.nc | jq 'select(.kind == \"block\") | .position'

Findings go to standard error. A stream is complete when its last record is `end`. Exit status:
0 complete, 1 the program has errors, 2 it could not run; then FILE stays as it was.",
            cs: "\
Příklady:
  cnc872c compile priruba.nc                          na standardní výstup
  cnc872c compile priruba.nc -o priruba.jsonl         do souboru: celý, nebo vůbec
  cnc872c compile priruba.nc --from 1000 --limit 20   jen bloky 1000 až 1019
  cnc872c compile priruba.nc --param R10=25.5         R10 má hodnotu z tabulky stroje
  cnc872c compile priruba.nc | jq 'select(.kind == \"block\") | .position'

Hlášení jdou na standardní chybový výstup. Proud je úplný, když končí záznamem „end“. Návratový
kód: 0 úplný, 1 program má chyby, 2 nebylo možné pracovat; SOUBOR pak zůstane, jak byl.",
        },
    ),
    about(
        "explain",
        "Explains findings, functions and addresses",
        "Vysvětlí hlášení, funkce a adresy",
        Bilingual {
            en: "\
Examples:
  cnc872c explain                     the list of all findings
  cnc872c explain E0306               a finding by its code
  cnc872c explain duplicate-address   or by its name
  cnc872c explain G73 M19             functions
  cnc872c explain '&' X               addresses",
            cs: "\
Příklady:
  cnc872c explain                     seznam všech hlášení
  cnc872c explain E0306               hlášení podle kódu
  cnc872c explain duplicate-address   nebo podle názvu
  cnc872c explain G73 M19             funkce
  cnc872c explain '&' X               adresy",
        },
    ),
    about(
        "schema",
        "Prints the JSON Schema of what the other commands write and read",
        "Vypíše JSON Schema toho, co ostatní příkazy zapisují a čtou",
        Bilingual {
            en: "\
Examples:
  cnc872c schema              of a line of the block stream (compile)
  cnc872c schema diagnostics  of check --format json
  cnc872c schema config       of cnc872c.toml, for editors that complete it",
            cs: "\
Příklady:
  cnc872c schema              řádku proudu bloků (compile)
  cnc872c schema diagnostics  výstupu check --format json
  cnc872c schema config       souboru cnc872c.toml, pro napovídání v editoru",
        },
    ),
    about(
        "completions",
        "Prints a script that lets a shell complete this command line",
        "Vypíše skript, se kterým shell doplňuje tento příkazový řádek",
        Bilingual {
            en: "\
Examples:
  cnc872c completions bash > ~/.local/share/bash-completion/completions/cnc872c
  cnc872c completions fish > ~/.config/fish/completions/cnc872c.fish",
            cs: "\
Příklady:
  cnc872c completions bash > ~/.local/share/bash-completion/completions/cnc872c
  cnc872c completions fish > ~/.config/fish/completions/cnc872c.fish",
        },
    ),
    about(
        "man",
        "Prints the manual page of the program, or of a command",
        "Vypíše manuálovou stránku programu, nebo příkazu",
        Bilingual {
            en: "\
Examples:
  cnc872c man > cnc872c.1
  cnc872c man check > cnc872c-check.1",
            cs: "\
Příklady:
  cnc872c man > cnc872c.1
  cnc872c man check > cnc872c-check.1",
        },
    ),
    about(
        "help",
        "Prints this help, or that of a command",
        "Vypíše tuto nápovědu, nebo nápovědu k příkazu",
        Bilingual { en: "", cs: "" },
    ),
];

struct ArgumentText {
    /// Empty: of every command that has it.
    command: &'static str,
    id: &'static str,
    heading: Heading,
    help: Bilingual,
}

const fn arg(
    command: &'static str,
    id: &'static str,
    heading: Heading,
    en: &'static str,
    cs: &'static str,
) -> ArgumentText {
    ArgumentText { command, id, heading, help: Bilingual { en, cs } }
}

use Heading::{Arguments, Everywhere, Levels, Machine, Options};

const ARGUMENTS: &[ArgumentText] = &[
    arg(
        "check",
        "paths",
        Arguments,
        "Programs, macrocycles, folders to search for them, or - for standard input. A folder is searched with the \
         folders in it for .nc .ncp .mpf .txt and macrocycles L…, hidden files left out",
        "Programy, makrocykly, složky k prohledání, nebo - pro standardní vstup. Ve složce a ve složkách v ní se \
         hledají soubory .nc .ncp .mpf .txt a makrocykly L…, skryté soubory se vynechají",
    ),
    arg(
        "compile",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is compiled with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se překládá s programem, který ho volá",
    ),
    arg(
        "explain",
        "names",
        Arguments,
        "Codes or names of findings, functions, addresses. None: the list of all findings",
        "Kódy nebo názvy hlášení, funkce, adresy. Nic: seznam všech hlášení",
    ),
    arg("schema", "schema", Arguments, "Of what", "Čeho"),
    arg("completions", "shell", Arguments, "For which shell", "Pro který shell"),
    arg("", "command", Arguments, "Of which command", "Ke kterému příkazu"),
    arg(
        "check",
        "fix",
        Options,
        "Change the files where a finding has one clear fix, then report what is left. Encoding and line ends stay",
        "Upravit soubory tam, kde má hlášení jedinou jasnou opravu, a vypsat, co zbývá. Kódování a konce řádků zůstanou",
    ),
    arg(
        "check",
        "deny_warnings",
        Options,
        "Exit with status 1 when there are warnings",
        "Skončit kódem 1 i při varováních",
    ),
    arg(
        "compile",
        "output",
        Options,
        "Write to this file. It is replaced when the stream is complete, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je proud úplný, jinak zůstane, jak byl",
    ),
    arg("compile", "from", Options, "Leave out the blocks before this seq", "Vynechat bloky před tímto seq"),
    arg("compile", "limit", Options, "Write at most so many blocks", "Zapsat nejvýše tolik bloků"),
    arg("", "format", Options, "How findings are shown", "Jak se hlášení vypíšou"),
    arg(
        "",
        "dialect",
        Machine,
        "The control, else `dialect` of the project file, else cnc872",
        "Řídicí systém; jinak dialect z projektu, jinak cnc872",
    ),
    arg(
        "",
        "config",
        Machine,
        "The project file, else cnc872c.toml in the program's folder or the nearest folder above it",
        "Soubor projektu; jinak cnc872c.toml ve složce programu nebo v nejbližší nad ní",
    ),
    arg(
        "",
        "channel_config",
        Machine,
        "The ChannelConfig XML whose MFunctions the machine has (cnc872)",
        "ChannelConfig (XML), jehož MFunctions stroj má (cnc872)",
    ),
    arg(
        "",
        "macrocycles",
        Machine,
        "A folder with macrocycles; may be given again, searched in this order. Else the program's folder",
        "Složka s makrocykly; lze opakovat, hledá se v tomto pořadí. Jinak složka programu",
    ),
    arg(
        "",
        "param",
        Machine,
        "The value of a parameter at program start; may be given again",
        "Hodnota parametru na začátku programu; lze opakovat",
    ),
    arg("", "block_skip", Machine, "Leave out the blocks with /", "Vynechat bloky s /"),
    arg("", "optional_stop", Machine, "M01 stops", "M01 zastavuje"),
    arg(
        "",
        "encoding",
        Machine,
        "Code page of files that are not UTF-8; cp852 unless configured",
        "Kódová stránka souborů, které nejsou v UTF-8; není-li nastavena, cp852",
    ),
    arg(
        "",
        "max_blocks",
        Machine,
        "Most blocks that a program may execute; 10000000 unless configured",
        "Kolik bloků smí program nejvýše provést; není-li nastaveno, 10000000",
    ),
    arg(
        "",
        "deny",
        Levels,
        "Make this warning an error, by code or name; of several about one the last counts",
        "Z tohoto varování udělat chybu, podle kódu nebo názvu; při opakování platí poslední",
    ),
    arg("", "warn", Levels, "Make it a warning", "Udělat z něj varování"),
    arg("", "allow", Levels, "Do not show it", "Nevypisovat ho"),
    arg(
        "",
        "color",
        Everywhere,
        "Colours; auto: on a terminal, unless NO_COLOR is set",
        "Barvy; auto: na terminálu, není-li nastaveno NO_COLOR",
    ),
    arg(
        "",
        "lang",
        Everywhere,
        "Language of texts, else by LC_ALL, LC_MESSAGES, LANG",
        "Jazyk textů; jinak podle LC_ALL, LC_MESSAGES, LANG",
    ),
    arg("", "help", Everywhere, "Print help", "Vypsat nápovědu"),
    arg("", "version", Everywhere, "Print the version", "Vypsat verzi"),
];

/// What stands for a value, in both languages. Those not listed are the same in both.
const VALUES: &[Bilingual] = &[
    Bilingual { en: "PATH", cs: "CESTA" },
    Bilingual { en: "FILE", cs: "SOUBOR" },
    Bilingual { en: "DIR", cs: "SLOŽKA" },
    Bilingual { en: "NAME", cs: "NÁZEV" },
    Bilingual { en: "CODE", cs: "KÓD" },
    Bilingual { en: "COMMAND", cs: "PŘÍKAZ" },
    Bilingual { en: "FORMAT", cs: "FORMÁT" },
    Bilingual { en: "DIALECT", cs: "SYSTÉM" },
    Bilingual { en: "ENCODING", cs: "KÓDOVÁNÍ" },
    Bilingual { en: "WHEN", cs: "KDY" },
    Bilingual { en: "LANG", cs: "JAZYK" },
    Bilingual { en: "SCHEMA", cs: "SCHÉMA" },
];

fn localized(command: Command, lang: Lang) -> Command {
    let name = command.get_name().to_owned();
    let command = match COMMANDS.iter().find(|text| text.name == name) {
        Some(text) if text.examples.en.is_empty() => command.about(text.about.get(lang)),
        Some(text) => command.about(text.about.get(lang)).after_help(text.examples.get(lang)),
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
        let known = VALUES.iter().find(|value| value.en == name.as_str())?;
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
    ARGUMENTS.iter().find(|text| text.id == id && (text.command.is_empty() || text.command == command))
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
    use super::*;

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
        let commands: Vec<&Command> = std::iter::once(&built).chain(built.get_subcommands()).collect();
        let mut used: Vec<(&str, &str)> = Vec::new();
        for command in &commands {
            assert!(COMMANDS.iter().any(|text| text.name == command.get_name()), "{}", command.get_name());
            for argument in command.get_arguments() {
                let found = row(command.get_name(), argument.get_id().as_str());
                let found = found.unwrap_or_else(|| panic!("{} {}", command.get_name(), argument.get_id()));
                used.push((found.command, found.id));
            }
        }
        assert_eq!(COMMANDS.len(), commands.len());
        for text in ARGUMENTS {
            assert!(used.contains(&(text.command, text.id)), "{} {}", text.command, text.id);
        }
    }

    #[test]
    fn both_languages_say_something_of_their_own() {
        for text in ARGUMENTS {
            assert_ne!(text.help.en, text.help.cs, "{}", text.id);
        }
        for text in COMMANDS {
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
}
