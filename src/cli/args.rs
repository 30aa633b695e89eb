//! The command line as a structure. [`help`](super::help) has its texts, in both languages.

use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Arg, ArgAction, ArgMatches, Args, Command as ClapCommand, FromArgMatches, Parser, Subcommand, ValueEnum};

use crate::config::{Level, parse_position};
use crate::diag::Format;
use crate::dict::{Decimal, Dialect, HIGHEST_BLOCK, HIGHEST_L, Lang};
use crate::text::Encoding;

/// The whole command line.
#[derive(Debug, Parser)]
#[command(
    name = "cnc872c",
    version,
    disable_help_flag = true,
    disable_version_flag = true,
    disable_help_subcommand = true,
    subcommand_required = true,
    arg_required_else_help = true
)]
pub(super) struct CommandLine {
    #[command(subcommand)]
    pub command: Command,
    #[command(flatten)]
    pub global: GlobalArgs,
}

/// Options of every command.
#[derive(Debug, Args)]
pub(super) struct GlobalArgs {
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    pub color: ColorWhen,
    #[arg(long, global = true, value_name = "LANG")]
    pub lang: Option<Lang>,
    #[arg(long, short, global = true, action = ArgAction::Help)]
    help: Option<bool>,
    #[arg(long, short = 'V', action = ArgAction::Version)]
    version: Option<bool>,
}

/// When output is coloured.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum ColorWhen {
    #[default]
    Auto,
    Always,
    Never,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Check(CheckArgs),
    #[command(visible_alias = "fmt")]
    Format(FormatArgs),
    Renumber(RenumberArgs),
    Compile(CompileArgs),
    View(ViewArgs),
    Motion(MotionArgs),
    Plc(PlcArgs),
    Report(ReportArgs),
    State(StateArgs),
    Restart(RestartArgs),
    Compare(CompareArgs),
    Explain(ExplainArgs),
    Init(InitArgs),
    Lsp(LspArgs),
    Stats(StatsArgs),
    Schema(SchemaArgs),
    Completions(CompletionsArgs),
    Man(ManArgs),
    Help(HelpArgs),
}

/// `check`.
#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    #[arg(long)]
    pub fix: bool,
    #[arg(long, conflicts_with_all = ["fix", "format"])]
    pub diff: bool,
    #[arg(long)]
    pub deny_warnings: bool,
    #[arg(long)]
    pub allow_empty: bool,
    #[command(flatten)]
    pub shown: FindingsArgs,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// `format`.
#[derive(Debug, Args)]
pub(super) struct FormatArgs {
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    #[command(flatten)]
    pub rewrite: RewriteArgs,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// Whether `format` and `renumber` only show what they would change.
#[derive(Debug, Args)]
pub(super) struct RewriteArgs {
    #[arg(long)]
    pub check: bool,
    #[arg(long)]
    pub diff: bool,
}

/// `renumber`.
#[derive(Debug, Args)]
pub(super) struct RenumberArgs {
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    #[arg(long, value_name = "N", default_value_t = 10)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=i64::from(HIGHEST_BLOCK)))]
    pub step: u32,
    #[arg(long, value_name = "N", default_value_t = 10)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=i64::from(HIGHEST_BLOCK)))]
    pub start: u32,
    #[arg(long, value_name = "L100", value_parser = unit_number, conflicts_with_all = ["from", "to"])]
    pub unit: Option<u32>,
    #[arg(long, value_name = "N", value_parser = block_number)]
    pub from: Option<u32>,
    #[arg(long, value_name = "N", value_parser = block_number)]
    pub to: Option<u32>,
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=8))]
    pub width: u8,
    #[command(flatten)]
    pub rewrite: RewriteArgs,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// `120` or `N120`.
fn block_number(text: &str) -> Result<u32, String> {
    numbered(text, 'N').filter(|number| *number <= HIGHEST_BLOCK).ok_or_else(|| "N120".to_owned())
}

/// `100` or `L100`.
fn unit_number(text: &str) -> Result<u32, String> {
    numbered(text, 'L').filter(|number| *number <= HIGHEST_L).ok_or_else(|| "L100".to_owned())
}

fn numbered(text: &str, letter: char) -> Option<u32> {
    let digits = text.strip_prefix([letter, letter.to_ascii_lowercase()]).unwrap_or(text);
    digits.parse().ok().filter(|number| *number > 0)
}

/// `compile`.
#[derive(Debug, Args)]
pub(super) struct CompileArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "SEQ", default_value_t = 0)]
    pub from: u64,
    #[arg(long, value_name = "N")]
    pub limit: Option<u64>,
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: CompileFormat,
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// How `compile` shows findings, or that it writes columns.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum CompileFormat {
    /// The stream is JSON; findings have this form.
    Findings(Format),
    /// The stream is Arrow; findings are for people.
    #[cfg(feature = "arrow")]
    Arrow,
}

impl ValueEnum for CompileFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::Findings(Format::Human),
            Self::Findings(Format::Short),
            Self::Findings(Format::Json),
            Self::Findings(Format::Sarif),
            Self::Findings(Format::Github),
            #[cfg(feature = "arrow")]
            Self::Arrow,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Findings(format) => format.to_possible_value(),
            #[cfg(feature = "arrow")]
            Self::Arrow => Some(PossibleValue::new("arrow")),
        }
    }
}

impl CompileArgs {
    /// How findings are shown.
    pub const fn shown(&self) -> FindingsArgs {
        match self.format {
            CompileFormat::Findings(format) => FindingsArgs { format, all: self.all },
            #[cfg(feature = "arrow")]
            CompileFormat::Arrow => FindingsArgs { format: Format::Human, all: self.all },
        }
    }
}

/// `view`.
#[derive(Debug, Args)]
pub(super) struct ViewArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long)]
    pub open: bool,
    #[arg(long, value_name = "PLANE", ignore_case = true)]
    pub plane: Option<PlaneName>,
    #[arg(long, value_name = "WxH", value_parser = picture_size)]
    pub size: Option<(u32, u32)>,
    #[arg(long, value_name = "SEQ", default_value_t = 0)]
    pub from: u64,
    #[arg(long, value_name = "N")]
    pub blocks: Option<u64>,
    #[command(flatten)]
    pub shown: FindingsArgs,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// The plane of a still picture.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub(super) enum PlaneName {
    #[value(name = "XY")]
    Xy,
    #[value(name = "XZ")]
    Xz,
    #[value(name = "YZ")]
    Yz,
    #[value(name = "ZX")]
    Zx,
    #[value(name = "iso")]
    Iso,
}

/// Largest side of a still picture, in pixels.
const LARGEST: u32 = 20_000;
/// Most pixels of a still picture: some 8 bytes of memory each.
const MOST_PIXELS: u32 = 100_000_000;

/// `1600x1000`: width and height of a still picture, in pixels.
fn picture_size(text: &str) -> Result<(u32, u32), String> {
    let side = |text: &str| text.parse().ok().filter(|side| (64..=LARGEST).contains(side));
    let sides = text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let small = sides.filter(|(width, height)| width * height <= MOST_PIXELS);
    small.ok_or_else(|| format!("1600x1000 (64–{LARGEST}, ≤ {MOST_PIXELS} px)"))
}

/// `motion`.
#[derive(Debug, Args)]
pub(super) struct MotionArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: MotionFormat,
    #[arg(long)]
    pub phases: bool,
    #[arg(long)]
    pub all: bool,
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// In which form `motion` writes.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum MotionFormat {
    #[default]
    Human,
    Json,
    Csv,
    #[cfg(feature = "arrow")]
    Arrow,
}

/// `plc`.
#[derive(Debug, Args)]
pub(super) struct PlcArgs {
    #[arg(value_name = "FILE", required_unless_present = "list")]
    pub file: Option<PathBuf>,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT", default_value = "table")]
    pub format: PlcFormat,
    #[arg(long, value_name = "SIGNALS")]
    pub signals: Option<String>,
    #[arg(long)]
    pub compat: bool,
    #[arg(long)]
    pub all: bool,
    #[arg(long, value_name = "CONDITION", conflicts_with_all = ["format", "signals", "compat"])]
    pub find: Option<String>,
    #[arg(long, conflicts_with_all = ["output", "signals", "compat", "all", "find", "from", "limit"])]
    pub list: bool,
    #[arg(long, value_name = "SEQ", default_value_t = 0)]
    pub from: u64,
    #[arg(long, value_name = "N")]
    pub limit: Option<u64>,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// In which form `plc` writes.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum PlcFormat {
    #[default]
    Table,
    Json,
    Csv,
    Vcd,
    #[cfg(feature = "arrow")]
    Arrow,
}

/// `report`.
#[derive(Debug, Args)]
pub(super) struct ReportArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT")]
    pub format: Option<ReportFormat>,
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// In which form `report` writes.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub(super) enum ReportFormat {
    Human,
    Json,
    Markdown,
    Html,
}

/// A place of a program: one of the first five.
#[derive(Debug, Args)]
#[group(skip)]
pub(super) struct PlaceArgs {
    #[arg(long, group = "place", required_unless_present = "place", value_name = "N")]
    pub n: Option<String>,
    #[arg(long, group = "place", value_name = "LINE", value_parser = clap::value_parser!(u32).range(1..))]
    pub line: Option<u32>,
    #[arg(long, group = "place", value_name = "SEQ")]
    pub seq: Option<u64>,
    #[arg(long, group = "place", value_name = "TIME")]
    pub time: Option<String>,
    #[arg(long, group = "place", value_name = "T")]
    pub at_tool: Option<String>,
    #[arg(long = "file", value_name = "L", conflicts_with_all = ["seq", "time", "at_tool"])]
    pub file_of: Option<String>,
    #[arg(long, value_name = "PASS", value_parser = clap::value_parser!(u64).range(1..))]
    #[arg(conflicts_with_all = ["seq", "time"])]
    pub pass: Option<u64>,
}

/// `state`.
#[derive(Debug, Args)]
pub(super) struct StateArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub place: PlaceArgs,
    #[arg(long)]
    pub after: bool,
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: StateFormat,
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// `restart`.
#[derive(Debug, Args)]
pub(super) struct RestartArgs {
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub place: PlaceArgs,
    #[arg(long)]
    pub after: bool,
    #[arg(long, group = "place", conflicts_with_all = ["after", "output"])]
    pub list: bool,
    #[arg(long, value_name = "MM", allow_hyphen_values = true, value_parser = thousandths)]
    pub safe: Option<Decimal>,
    #[arg(long, value_name = "MM", default_value = "2", value_parser = positive_thousandths)]
    pub clearance: Decimal,
    #[arg(long)]
    pub all_m: bool,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// A position in thousandths, as a program can have it.
fn thousandths(text: &str) -> Result<Decimal, String> {
    parse_position(text).ok_or_else(|| "100.5".to_owned())
}

/// The same, above zero.
fn positive_thousandths(text: &str) -> Result<Decimal, String> {
    thousandths(text).and_then(|value| if value > Decimal::ZERO { Ok(value) } else { Err("2".to_owned()) })
}

/// `stats`.
#[derive(Debug, Args)]
pub(super) struct StatsArgs {
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: StatsFormat,
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// In which form `state` answers.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum StateFormat {
    #[default]
    Human,
    Json,
}

/// In which form `stats` writes.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum StatsFormat {
    #[default]
    Human,
    Json,
    Csv,
    #[cfg(feature = "arrow")]
    Arrow,
}

/// `compare`.
#[derive(Debug, Args)]
pub(super) struct CompareArgs {
    #[arg(value_name = "OLD", display_order = 1)]
    pub old: PathBuf,
    #[arg(value_name = "NEW", display_order = 2)]
    pub new: PathBuf,
    #[arg(long, value_name = "MM", default_value_t = 0.001, value_parser = not_negative)]
    pub tolerance: f64,
    #[arg(long, value_name = "%", default_value_t = 0.0, value_parser = not_negative)]
    pub feed_tolerance: f64,
    #[arg(long)]
    pub parameters: bool,
    #[arg(long)]
    pub partial: bool,
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: StateFormat,
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long)]
    pub all: bool,
    #[command(flatten)]
    pub common: CommonArgs,
}

/// A number that is not negative.
fn not_negative(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 0.0);
    number.ok_or_else(|| "0.01".to_owned())
}

/// How findings are shown.
#[derive(Debug, Args)]
pub(super) struct FindingsArgs {
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub format: Format,
    #[arg(long)]
    pub all: bool,
}

/// Options that the commands which execute programs have in common: how to read and execute one, and which findings to
/// show.
#[derive(Debug, Args)]
pub(super) struct CommonArgs {
    #[arg(long, value_name = "DIALECT", ignore_case = true)]
    pub dialect: Option<Dialect>,
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    pub channel_config: Option<PathBuf>,
    #[arg(short = 'L', value_name = "DIR")]
    pub macrocycles: Vec<PathBuf>,
    #[arg(long, value_name = "R10=5")]
    pub param: Vec<String>,
    #[arg(long)]
    pub block_skip: bool,
    #[arg(long)]
    pub optional_stop: bool,
    #[arg(long, value_name = "ENCODING", ignore_case = true)]
    pub encoding: Option<Encoding>,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub max_blocks: Option<u64>,
    #[command(flatten)]
    pub levels: LevelArgs,
}

/// `-D`, `-W` and `-A`, in the order of the line.
#[derive(Debug, Default)]
pub(super) struct LevelArgs(pub Vec<LevelArg>);

/// One of `-D`, `-W`, `-A`, with what it names.
#[derive(Debug)]
pub(super) struct LevelArg {
    pub option: &'static str,
    pub level: Level,
    pub name: String,
}

/// The three options: identifier, letter, level.
const LEVELS: [(&str, char, &str, Level); 3] =
    [("deny", 'D', "-D", Level::Deny), ("warn", 'W', "-W", Level::Warn), ("allow", 'A', "-A", Level::Allow)];

impl Args for LevelArgs {
    fn augment_args(command: ClapCommand) -> ClapCommand {
        command.args(
            LEVELS.map(|(id, letter, ..)| Arg::new(id).short(letter).value_name("NAME").action(ArgAction::Append)),
        )
    }

    fn augment_args_for_update(command: ClapCommand) -> ClapCommand {
        Self::augment_args(command)
    }
}

impl FromArgMatches for LevelArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut found = Vec::new();
        for (id, _, option, level) in LEVELS {
            let names = matches.get_many::<String>(id).into_iter().flatten();
            let places = matches.indices_of(id).into_iter().flatten();
            found.extend(places.zip(names).map(|(at, name)| (at, LevelArg { option, level, name: name.clone() })));
        }
        found.sort_by_key(|(at, _)| *at);
        Ok(Self(found.into_iter().map(|(_, level)| level).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// `explain`.
#[derive(Debug, Args)]
pub(super) struct ExplainArgs {
    #[arg(value_name = "CODE")]
    pub names: Vec<String>,
}

/// `init`.
#[derive(Debug, Args)]
pub(super) struct InitArgs {
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    #[arg(long, value_name = "DIALECT", ignore_case = true)]
    pub dialect: Option<Dialect>,
}

/// `lsp`.
#[derive(Debug, Args)]
pub(super) struct LspArgs {
    #[arg(long)]
    pub stdio: bool,
}

/// `schema`.
#[derive(Debug, Args)]
pub(super) struct SchemaArgs {
    #[arg(value_name = "SCHEMA", default_value = "blocks")]
    pub schema: SchemaName,
}

/// Which schema.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, ValueEnum)]
pub(super) enum SchemaName {
    #[default]
    Blocks,
    Diagnostics,
    Config,
    Motion,
    Plc,
    Report,
    State,
    Stats,
    Compare,
}

/// `completions`.
#[derive(Debug, Args)]
pub(super) struct CompletionsArgs {
    #[arg(value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

/// `man`.
#[derive(Debug, Args)]
pub(super) struct ManArgs {
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

/// `help`.
#[derive(Debug, Args)]
pub(super) struct HelpArgs {
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}
