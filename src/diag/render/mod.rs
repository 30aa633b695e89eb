//! The forms in which findings leave the program: for people, for editors, for other programs.

mod edits;
#[cfg(feature = "cli")]
mod excerpt;
mod few;
#[cfg(feature = "cli")]
mod frame;
mod github;
#[cfg(feature = "cli")]
mod human;
#[cfg(all(test, feature = "cli"))]
mod human_tests;
mod json;
mod json_text;
mod places;
#[cfg(test)]
mod samples;
mod sarif;
mod short;
#[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "for the form for people"))]
pub(super) mod style;
#[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "for the form for people"))]
mod words;

use std::io::{self, Write};

pub use json::schema;

use super::Report;
use crate::dict::Lang;

/// A form of the findings of a run.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Format {
    /// For people: the lines of the program, why, and what to write. With the feature `cli`.
    #[cfg(feature = "cli")]
    Human,
    /// One line each, as editors and grep read them: `path:line:column: error[E0306]: message`.
    Short,
    /// One JSON object, after the schema `cnc872c.diagnostics/1`.
    Json,
    /// SARIF 2.1.0, for code scanning services.
    Sarif,
    /// Workflow commands of GitHub Actions.
    Github,
}

impl Format {
    /// Whether people read it: other text may surround it.
    pub const fn is_for_people(self) -> bool {
        match self {
            #[cfg(feature = "cli")]
            Self::Human => true,
            Self::Short => true,
            Self::Json | Self::Sarif | Self::Github => false,
        }
    }
}

/// How the findings are shown.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shown {
    /// In which language.
    pub lang: Lang,
    /// In colours, in the form for people.
    pub colour: bool,
    /// All of them; else the forms for people show a few of each code and file.
    pub all: bool,
}

/// How many findings are counted only, in words, when the form itself has no place to say so: for standard error.
pub fn unshown(format: Format, report: &Report, lang: Lang) -> Option<String> {
    let silent = format == Format::Github && report.suppressed() > 0;
    silent.then(|| words::suppressed(report.suppressed(), lang))
}

/// Writes the findings to `out`.
///
/// # Errors
/// What writing to `out` gives.
pub fn render(format: Format, report: &Report, shown: Shown, out: &mut dyn Write) -> io::Result<()> {
    let lang = shown.lang;
    let mut out = io::BufWriter::new(out);
    match format {
        #[cfg(feature = "cli")]
        Format::Human => human::write(report, shown, &mut out)?,
        Format::Short => short::write(report, shown, &mut out)?,
        Format::Json => json::write(report, lang, &mut out)?,
        Format::Sarif => sarif::write(report, lang, &mut out)?,
        Format::Github => github::write(report, lang, &mut out)?,
    }
    out.flush()
}
