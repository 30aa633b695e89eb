//! One layout for programs and macrocycles (FMT-1 to FMT-7): blanks, line ends, the case of addresses and the writing of
//! numbers change, nothing else. What could not be read stays byte for byte.

mod block;
mod gap;
mod kept;
mod word;

use std::path::Path;
use std::sync::Arc;

use super::alone;
use super::splice::{Splice, Written};
use crate::config::{Level, Settings, Style};
use crate::diag::{Code, Findings};
use crate::session::Outcome;
use crate::syntax::ParsedFile;
use crate::text::SourceText;
use gap::Layout;
use kept::Kept;

/// Most characters of a line (LEX-7).
const LINE: usize = 80;

/// A text with what formatting changes in it.
#[derive(Debug)]
pub struct Formatting {
    file: ParsedFile,
    kept: Kept,
    style: Style,
}

/// Formatting changes what it reads, and whether a line can be read may depend on the lines around it: so often it is done
/// again before it must have come to an end.
const MOST_ROUNDS: usize = 4;

impl Formatting {
    /// Reads a text to be formatted. `path` says whether it is a program or a macrocycle.
    ///
    /// # Errors
    /// The finding that keeps the file as it is.
    pub fn of(path: &Path, source: &Arc<SourceText>, settings: &Settings) -> Result<Self, Box<Outcome>> {
        let mut watchful = settings.clone();
        watchful.lints.extend(kept::WARNINGS.map(|code| (code, Level::Warn)));
        let (outcome, resolved) = alone::resolve(path, source, &watchful);
        let outcome = obstacle(outcome)?;
        let Some(file) = resolved.into_program() else { return Err(Box::default()) };
        let kept = Kept::of(&file, &outcome.findings);
        let mut formatting = Self { file, kept, style: settings.format };
        formatting.keep_lines_that_would_grow();
        Ok(formatting)
    }

    /// How many lines stay as they are because they could not be read.
    pub fn lines_left(&self) -> usize {
        self.kept.unread()
    }

    /// The edits in the order of the text.
    pub fn edits(&self, write: &mut dyn FnMut(Written<'_>)) {
        Layout::new(&self.file, &self.kept, self.style).write(write);
    }

    /// Formatting makes no line longer than 80 characters that was not: where it would, the block stays.
    fn keep_lines_that_would_grow(&mut self) {
        loop {
            let grown = Layout::new(&self.file, &self.kept, self.style).grown();
            if grown.is_empty() {
                return;
            }
            self.kept.keep(&self.file, grown);
        }
    }
}

/// The bytes of a formatted file, and how many lines stayed because they could not be read. `bytes` are those of `source`.
///
/// # Errors
/// The finding that keeps the file as it is.
pub fn format(
    path: &Path,
    source: &Arc<SourceText>,
    bytes: &[u8],
    settings: &Settings,
) -> Result<(Vec<u8>, usize), Box<Outcome>> {
    let mut formatting = Formatting::of(path, source, settings)?;
    let left = formatting.lines_left();
    let mut bytes = spliced(&formatting, source, bytes);
    for _ in 1..MOST_ROUNDS {
        if formatting.kept.is_empty() {
            break;
        }
        let Ok(again) = SourceText::decode(source.name(), bytes.clone(), source.encoding()).map(Arc::new) else {
            break;
        };
        formatting = Formatting::of(path, &again, settings)?;
        let next = spliced(&formatting, &again, &bytes);
        if next == bytes {
            break;
        }
        bytes = next;
    }
    Ok((bytes, left))
}

fn spliced(formatting: &Formatting, source: &SourceText, bytes: &[u8]) -> Vec<u8> {
    let mut splice = Splice::new(source, bytes);
    formatting.edits(&mut |edit| splice.write(edit));
    splice.finish()
}

/// What keeps a file as it is (FMT-6): UTF-16 (E0115), and programs for other controls (W0113); without a finding there is
/// nothing to format.
fn obstacle(outcome: Outcome) -> Result<Outcome, Box<Outcome>> {
    let Some(code) = [Code::E0115, Code::W0113].into_iter().find(|code| outcome.findings.has(*code)) else {
        return Ok(outcome);
    };
    let mut findings = Findings::with_levels(*outcome.findings.levels());
    outcome.findings.items().iter().filter(|item| item.code() == code).for_each(|item| findings.add(item.clone()));
    Err(Box::new(Outcome { findings, ..outcome }))
}
