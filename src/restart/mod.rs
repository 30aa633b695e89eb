//! A program that starts another one in the middle: `restart` (RST-1 to RST-6).
//!
//! The old program is executed to the place and on to its end: what holds there, whether a start is possible, what the
//! rest needs. A preamble leads to that state, the tool comes back from above, the rest follows. Before anything is
//! given away both programs are executed side by side.

mod approach;
mod ascii;
mod gather;
mod heights;
mod lines;
mod preamble;
mod prove;
mod reason;
mod scan;
mod tracker;

use std::path::Path;
use std::sync::Arc;

use approach::Approach;
use gather::Gather;
use lines::{comment_lines, named};
use preamble::{Preamble, Sources, notes};
use prove::{Proof, prove};
use scan::{Scan, There};

use crate::analysis::state::{Asked, Found, Place, PlaceFault, Timing};
use crate::config::Purpose;
use crate::dict::Lang;
use crate::session::{Outcome, Session};
use crate::text::{FileId, Overlay, SourceText, last_name};
pub use reason::{Note, Reason, Said, refusal_text, spot_text};
pub use scan::{Places, Spot};
pub use tracker::Options;

/// Most characters of a title.
const TITLE: usize = 64;

/// Places that are tried for the nearest one, at least.
const TRIED: u64 = 8;
/// More are tried until so many blocks were executed.
const EXECUTED: u64 = 1 << 20;

/// A program that starts in the middle of another one.
#[derive(Clone, Debug)]
pub struct Restart {
    /// The number of the block at the place.
    pub n: u32,
    /// The new part: number, title, preamble, calls and loops written out; ASCII.
    pub head: String,
    /// Where the text of the old program goes on; nothing when all of the rest is written out.
    pub rest: Option<u32>,
    /// The old program.
    pub source: Arc<SourceText>,
    /// Blocks of calls and loops that are written out.
    pub written_out: u64,
    /// Blocks of the preamble.
    pub preamble: u64,
    /// The first executed block of the old program whose text is used.
    pub text_from: Option<u64>,
}

impl Restart {
    /// The whole text.
    pub fn text(&self) -> String {
        let rest = self.rest.and_then(|from| self.source.text().get(from as usize..)).unwrap_or_default();
        format!("{}{rest}", self.head)
    }

    /// The same in the old program's encoding; `bytes` are those of the old program.
    pub fn bytes(&self, bytes: &[u8]) -> Vec<u8> {
        let from = self.rest.and_then(|from| usize::try_from(self.source.byte_offset(from)).ok());
        let rest = from.and_then(|from| bytes.get(from..)).unwrap_or_default();
        [self.head.as_bytes(), rest].concat()
    }
}

/// An earlier place at which a start is possible.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    /// Which executed block.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// The name of its file, where that is a macrocycle.
    pub file: Option<String>,
    /// The line of its `N`.
    pub line: u32,
    /// How long after program start.
    pub time_s: f64,
}

/// What came of it.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The new program.
    Program(Box<Restart>),
    /// There is no start at the place.
    Refused {
        /// Why.
        reason: Reason,
        /// Where there is one, earlier.
        nearest: Option<Nearest>,
    },
    /// There is no such place, or several.
    Place(PlaceFault),
    /// The program has errors; the outcome has them.
    Broken,
}

/// The answer with what was found in the old program.
#[derive(Debug)]
pub struct Made {
    /// Findings, with the texts that they are in.
    pub outcome: Outcome,
    /// What came of it.
    pub answer: Answer,
}

/// Makes a program that starts at a place of the one at `path`, which the user calls `name`.
pub fn restart(session: &Session<'_>, path: &Path, name: &str, asked: &Asked, options: Options, lang: Lang) -> Made {
    let making = Making { session, path, name, options, lang };
    let (outcome, found) = making.look(asked.clone(), Timing::Never);
    let found = match found {
        Some(Ok(found)) if asked.after => {
            let next = Asked { place: Place::Seq(found.seq + 1), file: None, pass: None, after: false };
            making.look(next, Timing::Never).1
        }
        found => found,
    };
    let answer = match found {
        None => Answer::Broken,
        Some(Err(fault)) => Answer::Place(fault),
        Some(Ok(found)) => match (outcome.sources.get(FileId(0)), making.scan(&found)) {
            (Some(source), Some(there)) => match making.make(source, &found, &there) {
                Ok(restart) => Answer::Program(Box::new(restart)),
                Err(reason) => Answer::Refused { reason, nearest: making.nearest(source, there.nearest) },
            },
            _ => Answer::Broken,
        },
    };
    Made { outcome, answer }
}

/// The tool changes and rapids of a program at which a start is possible.
pub fn list(session: &Session<'_>, path: &Path, name: &str, options: Options) -> (Outcome, Option<Places>) {
    let mut scan = Scan::new(session.settings, options, None);
    let run = session.watch(path, name, Purpose::Report, &mut &mut scan);
    (run.outcome, run.whole.map(|_| scan.into_places()))
}

/// One request.
#[derive(Clone, Copy)]
struct Making<'a> {
    session: &'a Session<'a>,
    path: &'a Path,
    name: &'a str,
    options: Options,
    lang: Lang,
}

impl Making<'_> {
    /// What holds at a place; nothing in a program with errors.
    fn look(&self, asked: Asked, timing: Timing) -> (Outcome, Option<Result<Box<Found>, PlaceFault>>) {
        let run = self.session.state(self.path, self.name, asked, timing);
        (run.outcome, run.whole.then_some(run.found))
    }

    /// Whether a program can start there.
    fn scan(&self, found: &Found) -> Option<There> {
        let mut scan = Scan::new(self.session.settings, self.options, Some((found.seq, found.file, found.n)));
        self.session.watch(self.path, self.name, Purpose::Report, &mut &mut scan);
        scan.finish()
    }

    /// The new program.
    fn make(&self, source: &Arc<SourceText>, found: &Found, there: &There) -> Result<Restart, Reason> {
        let settings = self.session.settings;
        let approach: &Approach = match &there.target {
            Ok(target) => &target.approach,
            Err(reason) => return Err(reason.clone()),
        };
        let blocks = found.blocks.done + found.blocks.left;
        let written_out = there.text.map_or(blocks, |(seq, _)| seq).saturating_sub(found.seq);
        let limit = settings.machine.limits.records;
        if written_out > limit {
            return Err(Reason::TooLong { blocks: written_out, limit });
        }
        let mut gather = Gather::new(settings, found.seq, there.text, blocks);
        self.session.watch(self.path, self.name, Purpose::Report, &mut &mut gather);
        let parameters: Vec<u8> = gather.parameters().collect();
        if let Some(lost) = parameters.iter().find(|index| found.state.is_lost(**index)) {
            return Err(Reason::Value { name: format!("R{lost}") });
        }
        let Gather { preamble, flat, rest, line_end, .. } = gather;
        let written_out = flat.blocks;
        let from = Sources { settings, found, there, approach, options: self.options, lang: self.lang };
        let mut head = self.title(source, found, there, line_end);
        for note in notes(from, &parameters, written_out) {
            head.push_str(&comment_lines(&note.comment(self.lang), line_end));
        }
        let lines = Preamble::new(from, preamble).write(&parameters)?;
        let preamble = lines.blocks;
        head.push_str(&lines.text);
        head.push_str(&flat.text);
        let text_from = there.text.map(|(seq, _)| seq);
        let restart = Restart { n: found.n, head, rest, source: Arc::clone(source), written_out, preamble, text_from };
        self.prove(&restart, found)?;
        Ok(restart)
    }

    /// The number of the program, and what this one is.
    fn title(&self, source: &SourceText, found: &Found, there: &There, line_end: &str) -> String {
        let name =
            Path::new(self.name).file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let title = |name: String| {
            let (place, pass) = (named(found.n, found.file, &found.file_name), there.pass);
            let note =
                if there.several { Note::TitleOfPass { name, place, pass } } else { Note::Title { name, place } };
            note.comment(self.lang)
        };
        // The place is what tells titles of one program apart.
        let room = TITLE.saturating_sub(title(String::new()).chars().count());
        let title = title(name.chars().take(room).collect());
        let number = source.text().split_once('%').map_or("", |(_, behind)| behind.trim_start_matches([' ', '\t']));
        let number: String = number.chars().take_while(char::is_ascii_digit).collect();
        format!("%{number} \"{title}\"{line_end}")
    }

    /// RST-5, before anything is given away.
    fn prove(&self, restart: &Restart, found: &Found) -> Result<(), Reason> {
        let text = restart.text();
        let overlay = Overlay { below: self.session.loader, path: self.path, bytes: text.as_bytes() };
        // `[start]` does not hold for an axis whose position at the place is not known.
        let mut settings = self.session.settings.clone();
        let axes = settings.machine.axes.iter().enumerate();
        for (_, axis) in axes.filter(|(at, _)| found.state.axis_position(*at).is_none()) {
            settings.machine.start.remove(&axis.letter);
        }
        let session = Session { loader: &overlay, settings: &settings, progress: None };
        let old = self.session.open(self.path, self.name, Purpose::Report);
        let new = session.open(self.path, self.name, Purpose::Report);
        let (Ok(old), Ok(new)) = (old, new) else { return Err(Reason::Fails { code: String::new() }) };
        let text = restart.text_from.unwrap_or(u64::MAX);
        let proof = Proof { place: found.seq, text, all_m: self.options.all_m, preamble: restart.preamble };
        prove(old, new, proof)
    }

    /// The nearest place at which a start is proved; `seq`: the first that may be one.
    fn nearest(&self, source: &Arc<SourceText>, mut seq: Option<u64>) -> Option<Nearest> {
        let (mut tried, mut executed) = (0, 0);
        while tried < TRIED || executed < EXECUTED {
            let asked = Asked { place: Place::Seq(seq?), file: None, pass: None, after: false };
            let found = self.look(asked.clone(), Timing::Never).1?.ok()?;
            let there = self.scan(&found)?;
            (tried, executed) = (tried + 1, executed + found.blocks.done + found.blocks.left);
            if self.make(source, &found, &there).is_ok() {
                let found = self.look(asked, Timing::Always).1?.ok()?;
                let file = (found.file != 0).then(|| last_name(Path::new(&found.file_name)));
                let time_s = found.times?.seconds.done;
                return Some(Nearest { seq: found.seq, n: found.n, file, line: found.line, time_s });
            }
            seq = there.nearest;
        }
        None
    }
}
