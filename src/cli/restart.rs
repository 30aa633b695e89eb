//! `restart`: a program that starts at a place of another one.

use std::io::Write;

use super::args::{FindingsArgs, RestartArgs};
use super::common::{overrides, print_beside};
use super::compile::{Stream, cannot_write};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::place::Named;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, complain, stdout, tell};
use super::threads;
use super::words::Words;
use crate::analysis::state::{Asked, AtTime, Place, PlaceFault, fault_text};
use crate::config::Purpose;
use crate::diag::{Format, terminal_safe};
use crate::dict::Lang;
use crate::restart::{Answer, Made, Options, Places, Restart, Said, list, refusal_text, restart, spot_text};
use crate::session::{Outcome, Session};
use crate::text::Loader;

pub(super) fn run(args: &RestartArgs, locale: Locale) -> Result<Status, Failure> {
    let named = if args.list { None } else { Some(Named::of(&args.place, args.after)?) };
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let job = Job::new(args.file.clone(), args.output.clone()).refusing(|file| Words::RestartIsProgram { file });
    let mut projects = job.configure(&overrides)?;
    let mut report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &shown, locale));
    };
    let progress = Progress::start(Counted::Blocks, job.output().is_none(), locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let options = Options { safe: args.safe, clearance: args.clearance, all_m: args.all_m };
    let (path, name) = (&job.target().path, job.target().name());
    let (outcome, end) = match named {
        None => {
            let (outcome, places) = list(&session, path, &name, options);
            (outcome, places.map(End::List))
        }
        Some(named) => match place(&session, &job, named, locale.lang) {
            Ok(asked) => {
                let Made { outcome, answer } = restart(&session, path, &name, &asked, options, locale.lang);
                (outcome, End::of(answer, &asked, locale))
            }
            Err((outcome, said)) => (*outcome, said.map(|said| End::Said(said, Status::Unusable))),
        },
    };
    let outcome = if end.is_none() { session.why_unfinished(path, &name, outcome) } else { outcome };
    drop(progress);
    job.refuse_input()?;
    let status = match end {
        _ if outcome.unusable || outcome.lacks_file() => Status::Unusable,
        None => Status::Faulty,
        Some(End::Said(said, status)) => {
            let mut lines = said.lines().map(|line| Words::Place { text: line.to_owned() });
            lines.next().into_iter().for_each(|line| complain(&line, locale.lang));
            lines.for_each(|line| tell(&line, locale.lang));
            return Ok(status);
        }
        Some(End::List(Places { spots, with_safe: more, refused })) => {
            let mut out = stdout()?;
            for spot in &spots {
                writeln!(out, "{}", terminal_safe(&spot_text(spot, locale.lang)))?;
            }
            out.flush()?;
            let why = refused.map(|reason| reason.text(locale.lang));
            let none = spots.is_empty().then(|| why.map_or(Said::NoPlaces, |why| Said::NoPlacesBecause { why }));
            let more = (more > 0).then_some(Said::MoreWithSafe { more });
            none.into_iter().chain(more).for_each(|said| {
                tell(&Words::Place { text: said.text(locale.lang) }, locale.lang);
            });
            Status::Fine
        }
        Some(End::Program(made)) => {
            write(&made, &job, locale)?;
            Status::Fine
        }
    };
    outcome.add_to(&mut report);
    if status == Status::Unusable {
        report.set_unusable();
    }
    if status != Status::Fine {
        print_beside(&shown, &report, locale);
    }
    Ok(status)
}

/// The end of the command.
enum End {
    Program(Box<Restart>),
    List(Places),
    Said(String, Status),
}

impl End {
    /// `None`: the program has errors.
    fn of(answer: Answer, asked: &Asked, locale: Locale) -> Option<Self> {
        match answer {
            Answer::Broken => None,
            Answer::Program(made) => Some(Self::Program(made)),
            Answer::Place(fault) => Some(Self::Said(fault_text(&fault, asked, locale.lang), Status::Unusable)),
            Answer::Refused { reason, nearest } => {
                let status = if reason.asks_for_safe() { Status::Unusable } else { Status::Faulty };
                Some(Self::Said(refusal_text(&reason, nearest.as_ref(), locale.lang), status))
            }
        }
    }
}

/// The place, also one that is a time; else what was found, and why there is none.
fn place(session: &Session<'_>, job: &Job, named: Named, lang: Lang) -> Result<Asked, (Box<Outcome>, Option<String>)> {
    let (seconds, asked) = match named {
        Named::At(asked) => return Ok(asked),
        Named::Time(seconds, asked) => (seconds, asked),
    };
    let mut at_time = AtTime::new(session.settings, seconds);
    let run = session.watch(&job.target().path, &job.target().name(), Purpose::Report, &mut &mut at_time);
    match at_time.found() {
        Ok(seq) => Ok(Asked { place: Place::Seq(seq), ..asked }),
        Err(seconds) => {
            let fault = fault_text(&PlaceFault::TooLate { seconds }, &asked, lang);
            Err((Box::new(run.outcome), run.whole.map(|_| fault)))
        }
    }
}

/// Writes the new program, in the encoding of the old one.
fn write(made: &Restart, job: &Job, locale: Locale) -> Result<(), Failure> {
    let cannot = |error| cannot_write(error, job.output(), locale.lang);
    let bytes = job.loader.read(&job.target().path).map_err(cannot)?;
    let mut stream = Stream::open(job.output(), locale.lang)?;
    stream.write_all(&made.bytes(&bytes)).and_then(|()| stream.flush()).map_err(cannot)?;
    stream.keep().map_err(cannot)?;
    if made.written_out > 0 {
        let said = Said::Written { written_out: made.written_out };
        tell(&Words::Place { text: said.text(locale.lang) }, locale.lang);
    }
    Ok(())
}
