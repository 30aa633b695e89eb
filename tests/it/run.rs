//! One run over one program, as the command line makes it: project file, settings, check or compile, report.

use std::path::Path;

use cnc872c::config::{configure, find_project};
use cnc872c::diag::{Code, Findings, Format, Report, Shown, render};
use cnc872c::dict::Lang;
use cnc872c::session::{Part, Session};
use cnc872c::text::{Loader, Sources};

use crate::markers::Request;

/// The results of a run.
#[derive(Debug, Default)]
pub struct Run {
    /// The findings of the configuration and of the program.
    pub report: Report,
    /// The block stream, when the request was to compile.
    pub stream: Vec<u8>,
    /// Blocks executed.
    pub executed: u64,
}

impl Run {
    /// The codes found, in the order of output.
    pub fn codes(&self) -> Vec<Code> {
        self.report.items().map(|item| item.diagnostic.code()).collect()
    }

    /// The findings as text without colour.
    pub fn text(&self, format: Format, lang: Lang) -> String {
        self.rendered(format, lang, false)
    }

    /// The findings as text in colours.
    pub fn coloured(&self, format: Format, lang: Lang) -> String {
        self.rendered(format, lang, true)
    }

    fn rendered(&self, format: Format, lang: Lang, colours: bool) -> String {
        let mut text = Vec::new();
        render(format, &self.report, Shown { lang, colour: colours, all: true }, &mut text).unwrap();
        String::from_utf8(text).unwrap()
    }

    /// The lines of the stream.
    pub fn lines(&self) -> Vec<&str> {
        std::str::from_utf8(&self.stream).unwrap().lines().collect()
    }

    /// The records of the stream.
    pub fn records(&self) -> Vec<serde_json::Value> {
        self.lines().iter().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

/// Checks or compiles `file` of the loader's folder, with the project file of that folder.
pub fn run(loader: &dyn Loader, file: &str, request: &Request) -> Run {
    let project = find_project(Path::new(""), loader);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(project.as_deref(), &request.overrides, loader, &mut sources, &mut findings);
    let mut run = Run::default();
    let broken = findings.has_errors();
    run.report.add(&sources, findings);
    if broken {
        return run;
    }
    let session = Session { loader, settings: &settings, progress: None };
    let outcome = if let Some(signals) = &request.plc {
        crate::plc::signals(&session, file, signals)
    } else if request.compile {
        session.compile(Path::new(file), file, Part::default(), &mut run.stream).unwrap().outcome
    } else {
        session.check(Path::new(file), file)
    };
    run.executed = outcome.executed;
    run.report.add_program(&outcome.sources, outcome.findings);
    run
}
