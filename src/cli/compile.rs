//! `compile`: the block stream of a program.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::Path;

use super::args::CompileArgs;
use super::common::{Origins, Projects, overrides, print_beside};
use super::disk::{DiskLoader, canonical, is_stdin};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{Failure, Status, complain};
use super::walk::Target;
use super::words::{Words, reason};
use crate::dict::Lang;
use crate::run::End;
use crate::session::{Part, Run, Session};

pub(super) fn run(args: &CompileArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = overrides(&args.common, locale.lang)?;
    let targets = [Target::named(args.file.clone())];
    let [target] = &targets;
    let loader = DiskLoader::new([target.path.as_path()]);
    let output = args.output.as_deref().filter(|output| !is_stdin(output));
    let refuse = |output: &Path| Words::OutputIsProgram { file: output.to_string_lossy().into_owned() };
    if let Some(output) = output
        && canonical(output) == canonical(&target.path)
    {
        return Err(refuse(output).into());
    }
    let mut projects = Projects::default();
    let named = args.common.config.as_deref();
    projects.configure(&targets, Origins { named, overrides: &overrides, loader: &loader })?;
    let mut report = projects.report();
    let settings = projects.settings(target).filter(|_| report.errors() == 0);
    let Some(settings) = settings else {
        report.set_unusable();
        print_beside(&args.common, &report, locale);
        return Ok(Status::Unusable);
    };
    let mut stream = Stream::open(output, locale.lang)?;
    let progress = Progress::start(Counted::Blocks, matches!(stream, Stream::Stdout(_)), locale.lang);
    let count = |blocks: u64| {
        progress.set(blocks);
        true
    };
    let session = Session { loader: &loader, settings, progress: Some(&count) };
    let part = Part { from: args.from, limit: args.limit };
    let written = session.compile(&target.path, &target.name(), part, &mut stream);
    drop(progress);
    let Run { outcome, whole } = written.map_err(|error| cannot_write(error, output, locale.lang))?;
    let lacks_file = outcome.lacks_file();
    report.add_program(&outcome.sources, outcome.findings);
    outcome.not_executed.into_iter().for_each(|program| report.add_not_executed(program));
    if let Some(output) = output
        && outcome.sources.iter().any(|(_, source)| canonical(Path::new(source.name())) == canonical(output))
    {
        return Err(refuse(output).into());
    }
    let status = match whole {
        Some(whole) => {
            stream.commit(whole).map_err(|error| cannot_write(error, output, locale.lang))?;
            Status::Fine
        }
        None if lacks_file => Status::Unusable,
        None => Status::Faulty,
    };
    if status == Status::Unusable {
        report.set_unusable();
    }
    print_beside(&args.common, &report, locale);
    if whole.is_none() && report.errors() == 0 {
        complain(&Words::NotWhole { file: target.name() }, locale.lang);
    }
    Ok(status)
}

fn cannot_write(error: io::Error, output: Option<&Path>, lang: Lang) -> Failure {
    match output {
        // Also a pipe after -o may be closed by its reader.
        Some(output) if error.kind() != io::ErrorKind::BrokenPipe => {
            Words::CannotWrite { file: output.to_string_lossy().into_owned(), reason: reason(&error, lang) }.into()
        }
        _ => Failure::Stdout(error),
    }
}

/// Where the stream goes.
enum Stream {
    Stdout(io::Stdout),
    /// A pipe or a device, which cannot be replaced.
    Direct(std::fs::File),
    File(Box<Replacement>),
}

impl Stream {
    fn open(output: Option<&Path>, lang: Lang) -> Result<Self, Failure> {
        let Some(output) = output else {
            return Ok(Self::Stdout(io::stdout()));
        };
        let special = std::fs::metadata(output).is_ok_and(|data| !data.is_file() && !data.is_dir());
        let opened = if special {
            OpenOptions::new().write(true).open(output).map(Self::Direct)
        } else {
            clean_up_when_interrupted(lang);
            Replacement::begin(output).map(|file| Self::File(Box::new(file)))
        };
        opened.map_err(|error| cannot_write(error, Some(output), lang))
    }

    /// Puts the file in place, which only the stream of a whole run is.
    fn commit(self, _: End) -> io::Result<()> {
        match self {
            Self::Stdout(_) | Self::Direct(_) => Ok(()),
            Self::File(file) => file.commit(),
        }
    }
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
