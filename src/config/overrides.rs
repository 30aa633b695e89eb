//! The options of the command line or of the editor that override the project file.

use std::path::PathBuf;

use super::Level;
use crate::diag::Code;
use crate::dict::{Decimal, Dialect};
use crate::text::{Encoding, last_name};

/// Settings that win over the project file, value by value (§13 Configuration). What is `None` or empty is left to the
/// file, and then to the defaults.
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    /// `--config`: the project file, in place of that of the program's folder.
    pub project: Option<PathBuf>,
    /// `--dialect`.
    pub dialect: Option<Dialect>,
    /// `--channel-config`: as given, relative to the working folder.
    pub channel_config: Option<PathBuf>,
    /// `-L`: folders as given; when there is one, the project's `macrocycles` do not count.
    pub macrocycles: Vec<PathBuf>,
    /// `--param`: R0–R95 and its value; the last of one number wins. Others of the project's parameters stay.
    pub parameters: Vec<(u8, Decimal)>,
    /// `--block-skip` (BLK-6).
    pub block_skip: Option<bool>,
    /// `--optional-stop` (MFN-8).
    pub optional_stop: Option<bool>,
    /// `--encoding`: of files that are not UTF-8 (LEX-13).
    pub encoding: Option<Encoding>,
    /// `--max-blocks`: most records of a stream (FLW-9).
    pub max_blocks: Option<u64>,
    /// `--set`: keys of `[motion]` or machine constants, each with a value as TOML or a plain text.
    pub motion: Vec<(String, String)>,
    /// The command computes motion: a machine constant that cannot be is an error (E0702), elsewhere a warning (W0707).
    pub computes_motion: bool,
    /// `-D`, `-W`, `-A`: the last of one code wins. Codes whose level is fixed ([`Code::is_configurable`]) are left
    /// out; the command line refuses them itself.
    pub lints: Vec<(Code, Level)>,
}

impl Overrides {
    /// What changes the execution, as arguments of the command line; files and folders by their names alone.
    pub(super) fn arguments(&self) -> Vec<String> {
        let option = |option: &str, value: Option<String>| value.map(|value| [option.to_owned(), value]);
        let folders = self.macrocycles.iter().map(|folder| option("-L", Some(last_name(folder))));
        let parameters = self.parameters.iter().map(|(r, value)| option("--param", Some(format!("R{r}={value}"))));
        let valued = [
            option("--dialect", self.dialect.map(|dialect| dialect.name().to_owned())),
            option("--config", self.project.as_deref().map(last_name)),
            option("--channel-config", self.channel_config.as_deref().map(last_name)),
            option("--encoding", self.encoding.map(|encoding| encoding.name().to_owned())),
            option("--max-blocks", self.max_blocks.map(|most| most.to_string())),
        ];
        let flags = [("--block-skip", self.block_skip), ("--optional-stop", self.optional_stop)];
        let flags = flags.into_iter().filter(|(_, on)| *on == Some(true)).map(|(flag, _)| flag.to_owned());
        valued.into_iter().chain(folders).chain(parameters).flatten().flatten().chain(flags).collect()
    }
}
