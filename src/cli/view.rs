//! `view`: the path of a program as a page or a picture.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::args::ViewArgs;
use super::common::{Origins, Projects, overrides, print_beside};
use super::disk::{DiskLoader, canonical, is_stdin};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{Failure, Status, tell};
use super::walk::Target;
use super::words::{Words, reason};
use crate::config::Purpose;
use crate::session::Session;
use crate::text::FileId;
use crate::view::{Part, View, page};

pub(super) fn run(args: &ViewArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = overrides(&args.common, locale.lang)?;
    let targets = [Target::named(args.file.clone())];
    let [target] = &targets;
    let loader = DiskLoader::new([target.path.as_path()]);
    let output = output(args)?;
    let refuse = |output: &Path| Words::PictureIsProgram { file: output.to_string_lossy().into_owned() };
    if let Some(output) = &output
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
    let progress = Progress::start(Counted::Blocks, output.is_none(), locale.lang);
    let count = |blocks: u64| {
        progress.set(blocks);
        true
    };
    let session = Session { loader: &loader, settings, progress: Some(&count) };
    let mut view = View::new(settings, Part { from: args.from, blocks: args.blocks });
    let run = session.run(&target.path, &target.name(), Purpose::Compile, view.collect());
    drop(progress);
    let outcome = run.outcome;
    let lacks_file = outcome.lacks_file() && outcome.executed == 0;
    view.finish(outcome.sources.get(FileId(0)), &target.name(), outcome.executed);
    if let Some(output) = &output
        && outcome.sources.iter().any(|(_, source)| canonical(Path::new(source.name())) == canonical(output))
    {
        return Err(refuse(output).into());
    }
    let unusable = outcome.unusable;
    report.add_program(&outcome.sources, outcome.findings);
    if !unusable {
        let page = page(&view.data(&report), &target.name(), locale.chosen);
        write(page.as_bytes(), output.as_deref(), locale)?;
        if let Some(output) = &output {
            tell(&Words::PictureWritten { file: output.to_string_lossy().into_owned() }, locale.lang);
            if args.open {
                open(output, locale)?;
            }
        }
    }
    if unusable || lacks_file {
        report.set_unusable();
    }
    print_beside(&args.common, &report, locale);
    Ok(match report.errors() > 0 {
        _ if unusable || lacks_file => Status::Unusable,
        true => Status::Faulty,
        false => Status::Fine,
    })
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
    let Some(output) = output else {
        let mut out = io::stdout().lock();
        return out.write_all(bytes).and_then(|()| out.flush()).map_err(Failure::Stdout);
    };
    clean_up_when_interrupted(locale.lang);
    let written = Replacement::begin(output).and_then(|mut file| file.write_all(bytes).and_then(|()| file.commit()));
    written.map_err(|error| {
        let file = output.to_string_lossy().into_owned();
        Words::CannotWrite { file, reason: reason(&error, locale.lang) }.into()
    })
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
    let started = std::process::Command::new(program).args(before).arg(file).spawn();
    started.map(drop).map_err(|error| {
        let file = file.to_string_lossy().into_owned();
        Words::CannotOpen { file, reason: reason(&error, locale.lang) }.into()
    })
}
