//! `view`: the path of a program as a page or a picture.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::args::{PlaneName, ViewArgs};
use super::common::{overrides, print_beside};
use super::compile::{Stream, cannot_write};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::memory;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, tell};
use super::threads;
use super::words::{Words, reason};
use crate::config::Overrides;
use crate::disk::is_stdin;
use crate::session::Session;
use crate::text::{FileId, path_name};
use crate::view::{Collector, Keep, LeftOut, Naming, Part, Picture, Plane, Still, page};

/// How long is waited for what the opener comes to.
const OPENING: Duration = Duration::from_secs(2);

pub(super) fn run(args: &ViewArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = Overrides { computes_motion: true, ..overrides(&args.common, locale.lang)? };
    threads::prepare();
    let output = output(args)?;
    let form = Form::of(output.as_deref())?;
    check_usage(args, form, output.is_some())?;
    let job = Job::new(args.file.clone(), output).refusing(|file| Words::PictureIsProgram { file });
    let output = job.output();
    let mut projects = job.configure(&overrides)?;
    let mut report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &args.shown, locale));
    };
    let progress = Progress::start(Counted::Blocks, output.is_none(), locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let keep = if form == Form::Page { Keep::Records } else { Keep::Geometry };
    let part = Part { from: args.from, blocks: args.blocks };
    let mut collector = Collector::new(settings, part, keep).within(memory::room);
    let run = session.draw(&job.target().path, &job.target().name(), collector.sink());
    drop(progress);
    if collector.is_too_large() {
        return Err(Words::PictureNeedsMemory.into());
    }
    let outcome = run.outcome;
    let (lacks_file, unusable, executed) = (outcome.lacks_file(), outcome.unusable, outcome.executed);
    let naming = Naming { program: &job.target().path, loader: &job.loader };
    let view = collector.finish(outcome.sources.get(FileId(0)), naming, executed);
    job.refuse_input()?;
    report.add_program(&outcome.sources, outcome.findings);
    // What programs read on stderr holds nothing but the findings.
    let say = |words: &Words| {
        if args.shown.format.is_for_people() {
            tell(words, locale.lang);
        }
    };
    let drawn = executed > 0 && view.count() > 0;
    let empty = executed > 0 && !drawn && report.errors() == 0;
    if empty {
        say(&Words::EmptyPart { executed, last: executed - 1 });
    }
    match output {
        _ if unusable || empty => {}
        // An earlier picture shows more than one of nothing.
        Some(output) if !drawn && std::fs::metadata(output).is_ok_and(|data| data.is_file()) => {
            say(&Words::PictureKept { file: path_name(output) });
        }
        _ => {
            let picture = match form {
                Form::Page => {
                    let page = page(&view.data(&report, naming, None), None, &naming.program(), locale.chosen);
                    Picture { bytes: page.into_bytes(), left_out: LeftOut::default() }
                }
                Form::Svg => view.svg(still(args)),
                Form::Png => view.png(still(args)).ok_or(Words::PictureTooLarge)?,
            };
            write(&picture.bytes, output, locale)?;
            let assumed = form != Form::Page && !settings.machine.motion.configured;
            remarks(picture.left_out, assumed, output).iter().for_each(say);
            if let Some(output) = output.filter(|_| args.open) {
                open(output, locale)?;
            }
        }
    }
    if unusable || lacks_file {
        report.set_unusable();
    }
    print_beside(&args.shown, &report, locale);
    Ok(match report.errors() > 0 {
        _ if unusable || lacks_file || empty => Status::Unusable,
        true => Status::Faulty,
        false => Status::Fine,
    })
}

/// Remarks on a written picture.
fn remarks(left_out: LeftOut, assumed: bool, output: Option<&Path>) -> Vec<Words> {
    let LeftOut { red, yellow, motions, stale } = left_out;
    let mut remarks = Vec::new();
    if red > 0 {
        remarks.push(Words::RedLeftOut { count: red });
    }
    if yellow > 0 {
        remarks.push(Words::YellowLeftOut { count: yellow });
    }
    if motions > 0 {
        remarks.push(Words::MotionsLeftOut { count: motions });
    }
    if stale > 0 {
        remarks.push(Words::StaleMotions { count: stale });
    }
    if assumed {
        remarks.push(Words::AssumedMachine);
    }
    remarks.extend(output.map(|output| Words::PictureWritten { file: path_name(output) }));
    remarks
}

/// The form of the output.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Form {
    Page,
    Svg,
    Png,
}

impl Form {
    /// By the extension of the file; files without one, and standard output, are pages.
    fn of(output: Option<&Path>) -> Result<Self, Words> {
        let Some(extension) = output.and_then(Path::extension) else { return Ok(Self::Page) };
        match extension.to_ascii_lowercase().to_str() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            Some("html" | "htm") => Ok(Self::Page),
            Some(_) | None => Err(Words::NoSuchPicture { extension: path_name(Path::new(extension)) }),
        }
    }
}

/// Refuses options that do not concern the output.
fn check_usage(args: &ViewArgs, form: Form, has_file: bool) -> Result<(), Words> {
    let option = match (args.plane, args.size) {
        (Some(_), _) => Some("--plane"),
        (None, Some(_)) => Some("--size"),
        (None, None) => None,
    };
    match option.filter(|_| form == Form::Page) {
        Some(option) => Err(Words::OptionOfPictures { option: option.to_owned() }),
        None if args.open && !has_file => Err(Words::NothingToOpen),
        None => Ok(()),
    }
}

fn still(args: &ViewArgs) -> Still {
    let plane = args.plane.map(|plane| match plane {
        PlaneName::Xy => Plane::Xy,
        PlaneName::Xz => Plane::Xz,
        PlaneName::Yz => Plane::Yz,
        PlaneName::Zx => Plane::Zx,
        PlaneName::Iso => Plane::Iso,
    });
    let Still { width, height, .. } = Still::default();
    let (width, height) = args.size.unwrap_or((width, height));
    Still { plane, width, height }
}

/// Where the picture goes: after `-o`, else beside the program. `None`: standard output.
fn output(args: &ViewArgs) -> Result<Option<PathBuf>, Failure> {
    match &args.output {
        Some(output) if is_stdin(output) => Ok(None),
        Some(output) => Ok(Some(output.clone())),
        None if is_stdin(&args.file) => Err(Words::PictureNeedsName.into()),
        None => {
            let mut name = args.file.clone().into_os_string();
            name.push(".html");
            Ok(Some(PathBuf::from(name)))
        }
    }
}

fn write(bytes: &[u8], output: Option<&Path>, locale: Locale) -> Result<(), Failure> {
    let mut stream = Stream::open(output, locale.lang)?;
    let written = stream.write_all(bytes).and_then(|()| stream.flush()).and_then(|()| stream.keep());
    written.map_err(|error| cannot_write(error, output, locale.lang))
}

/// Opens a file with the program that the system has for it.
fn open(file: &Path, locale: Locale) -> Result<(), Failure> {
    let (program, before): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("cmd", &["/c", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let fault = |reason| {
        let (file, opener) = (path_name(file), program.to_owned());
        Words::CannotOpen { file, opener, reason }.into()
    };
    let mut opener = match Command::new(program).args(before).arg(file).stdout(Stdio::null()).spawn() {
        Ok(opener) => opener,
        Err(error) => return Err(fault(reason(&error, locale.lang))),
    };
    // One that still runs has become the viewer itself.
    let start = Instant::now();
    while start.elapsed() < OPENING {
        match opener.try_wait() {
            Ok(None) => std::thread::sleep(Duration::from_millis(10)),
            Ok(Some(status)) if !status.success() => return Err(fault(status.to_string())),
            Ok(Some(_)) | Err(_) => break,
        }
    }
    Ok(())
}
