//! `compile`: the block stream of a program.

use std::fs::OpenOptions;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

use super::args::{CompileArgs, CompileFormat};
use super::common::overrides;
use super::job::{Ends, Job, unusable};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{Failure, Status, stdout};
use super::threads;
use super::words::Words;
#[cfg(feature = "arrow")]
use crate::columns::{BlockTable, Ipc};
#[cfg(feature = "arrow")]
use crate::config::Purpose;
use crate::dict::Lang;
use crate::run::End;
use crate::session::{Part, Run, Session};

/// Bytes that are written at once.
#[cfg(feature = "arrow")]
pub(super) const BUFFER: usize = 1 << 16;

pub(super) fn run(args: &CompileArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let job = Job::new(args.file.clone(), args.output.clone());
    let mut projects = job.configure(&overrides)?;
    let report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &args.shown(), locale));
    };
    #[cfg(feature = "arrow")]
    if args.format == CompileFormat::Arrow {
        refuse_terminal(job.output())?;
    }
    let mut stream = Stream::open(job.output(), locale.lang)?;
    let progress = Progress::start(Counted::Blocks, matches!(stream, Stream::Stdout(_)), locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let part = Part { from: args.from, limit: args.limit };
    let (path, name) = (&job.target().path, job.target().name());
    let written = match args.format {
        CompileFormat::Findings(_) => session.compile(path, &name, part, &mut stream),
        #[cfg(feature = "arrow")]
        CompileFormat::Arrow => columns(&session, path, &name, part, &mut stream),
    };
    drop(progress);
    let Run { outcome, whole } = written.map_err(|error| cannot_write(error, job.output(), locale.lang))?;
    let reason = Words::NotWhole { file: job.target().name() };
    let ends = Ends { whole: Status::Fine, broken: Status::Faulty, reason };
    job.finish(stream, (outcome, whole), report, ends, &args.shown(), locale)
}

/// The stream as columns.
#[cfg(feature = "arrow")]
fn columns(session: &Session<'_>, path: &Path, name: &str, part: Part, out: &mut Stream) -> io::Result<Run<End>> {
    let mut failed = None;
    let mut out = Ipc::new(io::BufWriter::with_capacity(BUFFER, out));
    let run = session.run(path, name, Purpose::Compile, BlockTable::new(part, &mut out, &mut failed));
    failed.map_or(Ok(run), Err)
}

/// Columns are no text.
#[cfg_attr(not(feature = "arrow"), expect(dead_code, reason = "nothing else is no text"))]
pub(super) fn refuse_terminal(output: Option<&Path>) -> Result<(), Failure> {
    if output.is_none() && io::stdout().is_terminal() { Err(Words::ColumnsOnTerminal.into()) } else { Ok(()) }
}

pub(super) fn cannot_write(error: io::Error, output: Option<&Path>, lang: Lang) -> Failure {
    match output {
        // Also a pipe after -o may be closed by its reader.
        Some(output) if error.kind() != io::ErrorKind::BrokenPipe => Words::cannot_write(output, &error, lang).into(),
        _ => Failure::Stdout(error),
    }
}

/// Where the stream goes.
pub(super) enum Stream {
    Stdout(io::Stdout),
    /// A pipe or a device, which cannot be replaced.
    Direct(std::fs::File),
    File(Box<Replacement>),
}

impl Stream {
    pub fn open(output: Option<&Path>, lang: Lang) -> Result<Self, Failure> {
        // Opened by that name, a closed one would swallow the stream.
        let Some(output) = output.filter(|output| *output != Path::new("/dev/stdout")) else {
            drop(stdout()?);
            return Ok(Self::Stdout(io::stdout()));
        };
        let opened = if is_special(output) {
            OpenOptions::new().write(true).open(output).map(Self::Direct)
        } else {
            clean_up_when_interrupted(lang);
            Replacement::begin(output).map(|file| Self::File(Box::new(file)))
        };
        opened.map_err(|error| cannot_write(error, Some(output), lang))
    }

    /// Puts the file in place, which only the stream of a whole run is.
    pub fn commit(self, _: End) -> io::Result<()> {
        self.keep()
    }
}

impl Stream {
    /// Puts the file in place, which is whole whatever programs are.
    pub fn keep(self) -> io::Result<()> {
        match self {
            Self::Stdout(_) | Self::Direct(_) => Ok(()),
            Self::File(file) => file.commit(),
        }
    }
}

/// Whether it is a pipe or a device.
fn is_special(output: &Path) -> bool {
    std::fs::metadata(output).is_ok_and(|data| !data.is_file() && !data.is_dir())
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(out) => out.write(bytes),
            Self::Direct(out) => out.write(bytes),
            Self::File(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(out) => out.flush(),
            Self::Direct(out) => out.flush(),
            Self::File(out) => out.flush(),
        }
    }
}
