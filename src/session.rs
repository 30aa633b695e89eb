//! One run over one program or macrocycle: load, resolve, execute, report. What the command line and the editor call.

use std::io::Write;
use std::path::Path;

use crate::config::Settings;
use crate::diag::Findings;
use crate::text::{Loader, Sources};

/// Which block records of a stream are written; `program`, `file` and `end` always are.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    /// First `seq`.
    pub from: u64,
    /// Most block records; all when `None`.
    pub limit: Option<u64>,
}

/// What a run found, with the texts that the places are in.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The files read; the program is file 0.
    pub sources: Sources,
    /// The findings, unsorted, levels not yet applied.
    pub findings: Findings,
    /// Whether the program itself could not be read, or is not what the command takes (exit status 2).
    pub unusable: bool,
}

/// Runs programs with one loader and one configuration.
#[derive(Clone, Copy)]
pub struct Session<'a> {
    /// Where files come from.
    pub loader: &'a dyn Loader,
    /// The configuration.
    pub settings: &'a Settings,
    /// Called from time to time during long work with the number of blocks executed; `false` stops the run.
    pub progress: Option<&'a (dyn Fn(u64) -> bool + Sync)>,
}

impl Session<'_> {
    /// Checks the program or macrocycle at `path`, which the user calls `name`: everything that `check` finds.
    pub fn check(&self, path: &Path, name: &str) -> Outcome {
        let _ = (path, name);
        Outcome::default()
    }

    /// Compiles the program at `path` to `out`. When the outcome has errors, the stream has no `end` record.
    ///
    /// # Errors
    /// What writing to `out` gives.
    pub fn compile(&self, path: &Path, name: &str, part: Part, out: &mut dyn Write) -> std::io::Result<Outcome> {
        let _ = (path, name, part, out);
        Ok(Outcome::default())
    }

    /// Whether the name is that of a macrocycle file: `L` and its number, with no extension, `.NC`, `.NCP`, `.MRC` or
    /// `.TXT`, in either case (PRG-6).
    pub fn is_macrocycle_name(path: &Path) -> bool {
        macrocycle_number(path).is_some()
    }
}

/// The number of the macrocycle that a file of that name holds (PRG-6).
pub fn macrocycle_number(path: &Path) -> Option<u32> {
    let name = path.file_name()?.to_str()?.to_ascii_uppercase();
    let digits = name.strip_prefix('L')?;
    let digits = [".NC", ".NCP", ".MRC", ".TXT"]
        .into_iter()
        .find_map(|extension| digits.strip_suffix(extension))
        .unwrap_or(digits);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    digits.trim_start_matches('0').parse().ok().filter(|number| (1..=9999).contains(number))
}
