//! How a command ends.

use std::io::{self, StdoutLock, Write};

use super::words::{self, Words, error_prefix};
use crate::diag::{Format, Report, unshown};
use crate::dict::Lang;

/// The end of a command that ran.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Status {
    /// No errors.
    Fine,
    /// The programs have errors.
    Faulty,
    /// A file could not be read, or the configuration is wrong; findings say so.
    Unusable,
}

/// Why a command ended early.
#[derive(Debug)]
pub(super) enum Failure {
    /// Standard output does not take more. When its reader went away, that is no failure at all.
    Stdout(io::Error),
    /// Something to say.
    Said(Words),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Stdout(error)
    }
}

impl From<Words> for Failure {
    fn from(words: Words) -> Self {
        Self::Said(words)
    }
}

/// Standard output, for data.
///
/// # Errors
/// When it was closed before the program started: output to it would be lost in silence.
pub(super) fn stdout() -> Result<StdoutLock<'static>, Failure> {
    #[cfg(target_os = "linux")]
    if cnc872c_start::stdout_was_closed() {
        return Err(Words::StdoutClosed.into());
    }
    Ok(io::stdout().lock())
}

/// Says why a command failed, and gives its exit status: 0 no errors, 1 the programs have errors, 2 it could not run.
pub(super) fn exit_code(end: Result<Status, Failure>, lang: Lang) -> u8 {
    match end {
        Ok(Status::Fine) => 0,
        Ok(Status::Faulty) => 1,
        Ok(Status::Unusable) => 2,
        Err(Failure::Stdout(error)) if error.kind() == io::ErrorKind::BrokenPipe => 0,
        Err(Failure::Stdout(error)) => {
            complain(&Words::CannotWriteStdout { reason: words::reason(&error, lang) }, lang);
            2
        }
        Err(Failure::Said(words)) => {
            complain(&words, lang);
            2
        }
    }
}

/// Says what went wrong, on stderr.
pub(super) fn complain(words: &Words, lang: Lang) {
    // Nobody can be told that stderr is gone.
    let _ = writeln!(io::stderr().lock(), "{}: {}", error_prefix(lang), words.shown(lang));
}

/// Says on stderr how many findings are only counted, where the form of the findings does not.
pub(super) fn tell_unshown(format: Format, report: &Report, lang: Lang) {
    if let Some(words) = unshown(format, report, lang) {
        let _ = writeln!(io::stderr().lock(), "{words}");
    }
}

/// Says what was done, on stderr.
pub(super) fn tell(words: &Words, lang: Lang) {
    let _ = writeln!(io::stderr().lock(), "{}", words.shown(lang));
}
