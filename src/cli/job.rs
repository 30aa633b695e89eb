//! A command over one program whose output may take the place of a file: what `compile`, `motion`, `plc`, `report` and
//! `view` have in common.

use std::path::{Path, PathBuf};

use super::args::FindingsArgs;
use super::common::{Origins, Projects, is_input, print_beside};
use super::compile::{Stream, cannot_write};
use super::locale::Locale;
use super::status::{Failure, Status, complain};
use super::walk::Target;
use super::words::Words;
use crate::config::Overrides;
use crate::diag::Report;
use crate::disk::{DiskLoader, is_stdin};
use crate::run::End;
use crate::session::Outcome;
use crate::text::path_name;

/// One program, and where what is made of it goes.
pub(super) struct Job {
    targets: [Target; 1],
    /// Reads the program, its macrocycles and its configuration.
    pub loader: DiskLoader,
    /// `None`: standard output.
    output: Option<PathBuf>,
    /// Message when the output is one of the files that are read.
    refusal: fn(String) -> Words,
}

/// How a run that could be made ends.
pub(super) struct Ends {
    /// When the program ended by M02 or M30, without errors.
    pub whole: Status,
    /// When not.
    pub broken: Status,
    /// Message when not, and no finding says why.
    pub reason: Words,
}

impl Job {
    /// The program at `file`; `-` as `output` is standard output.
    pub fn new(file: PathBuf, output: Option<PathBuf>) -> Self {
        let loader = DiskLoader::new([file.as_path()]);
        let refusal = |file| Words::OutputIsProgram { file };
        let output = output.filter(|output| !is_stdin(output));
        Self { targets: [Target::named(file)], loader, output, refusal }
    }

    /// With other words for an output that is read.
    pub fn refusing(self, refusal: fn(String) -> Words) -> Self {
        Self { refusal, ..self }
    }

    /// The program.
    pub const fn target(&self) -> &Target {
        let [target] = &self.targets;
        target
    }

    /// The file that is written.
    pub fn output(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// Refuses an output that has been read, or is to be. Asked after each step that reads.
    pub fn refuse_input(&self) -> Result<(), Failure> {
        match self.output().filter(|output| is_input(output, self.target(), &self.loader)) {
            Some(output) => Err((self.refusal)(path_name(output)).into()),
            None => Ok(()),
        }
    }

    /// The configuration of the program.
    pub fn configure(&self, overrides: &Overrides) -> Result<Projects, Failure> {
        self.refuse_input()?;
        let mut projects = Projects::default();
        projects.configure(&self.targets, Origins { overrides, loader: &self.loader })?;
        self.refuse_input()?;
        Ok(projects)
    }

    /// Shows what was found, and puts the output in its place when the run is whole.
    pub fn finish(
        &self,
        stream: Stream,
        (outcome, whole): (Outcome, Option<End>),
        mut report: Report,
        ends: Ends,
        shown: &FindingsArgs,
        locale: Locale,
    ) -> Result<Status, Failure> {
        let lacks_file = outcome.lacks_file();
        outcome.add_to(&mut report);
        self.refuse_input()?;
        let status = match whole {
            Some(whole) => {
                stream.commit(whole).map_err(|error| cannot_write(error, self.output(), locale.lang))?;
                ends.whole
            }
            None if lacks_file => Status::Unusable,
            None => ends.broken,
        };
        if status == Status::Unusable {
            report.set_unusable();
        }
        print_beside(shown, &report, locale);
        if whole.is_none() && report.errors() == 0 {
            complain(&ends.reason, locale.lang);
        }
        Ok(status)
    }
}

/// The end of a run that could not be made.
pub(super) fn unusable(mut report: Report, shown: &FindingsArgs, locale: Locale) -> Status {
    report.set_unusable();
    print_beside(shown, &report, locale);
    Status::Unusable
}
