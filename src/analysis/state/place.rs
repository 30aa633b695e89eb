//! Which place of a program is asked for, and which executed blocks are there.

use std::path::Path;

use crate::dict::{Decimal, TOOL_CHANGE};
use crate::resolve::Library;
use crate::run::Executed;
use crate::syntax::{BlockId, ParsedFile};
use crate::text::FileId;

/// A place as the user names it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// A block number.
    N(u32),
    /// A line, from 1.
    Line(u32),
    /// An executed block, from 0.
    Seq(u64),
    /// The M06 of a tool.
    Tool(Decimal),
}

/// A question about a place.
#[derive(Clone, Debug)]
pub struct Asked {
    /// Where.
    pub place: Place,
    /// The macrocycle that a number or line is of; the program when none.
    pub file: Option<String>,
    /// Which execution of the block, from 1.
    pub pass: Option<u64>,
    /// The state behind the block, not before it.
    pub after: bool,
}

/// A call on the way to a place.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct CallAt {
    /// `G71`, `G72`, `G81`–`G89`.
    pub by: &'static str,
    /// What was called.
    pub l: u32,
    /// Index of the file of the calling block.
    pub file: u32,
    /// The number of the calling block.
    pub n: u32,
    /// The line of its `N`.
    pub line: u32,
    /// Which pass, from 1.
    pub pass: u32,
    /// Of how many.
    pub of: u32,
}

/// One execution of a block that is asked for.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Arrival {
    /// Which executed block.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// Its line.
    pub line: u32,
    /// How execution got there, outermost first.
    pub calls: Vec<CallAt>,
}

impl Arrival {
    /// At a block.
    pub(super) fn of(block: &Executed<'_>) -> Self {
        Self { seq: block.seq(), n: block.n(), line: block.line(), calls: calls(block) }
    }
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum PlaceFault {
    /// No block there; a number near it, when one is asked for.
    Missing {
        /// The nearest block number.
        near: Option<u32>,
    },
    /// It is never executed.
    NotExecuted,
    /// The program executes fewer blocks; so many.
    Beyond {
        /// How many it executes.
        blocks: u64,
    },
    /// The program takes less; so many seconds.
    TooLate {
        /// How long it takes.
        seconds: f64,
    },
    /// It is executed fewer times.
    Passes {
        /// How often it is executed.
        count: u64,
    },
    /// Several executions; the first of them.
    Several {
        /// Those that are listed.
        arrivals: Vec<Arrival>,
        /// How many there are.
        count: u64,
    },
    /// No file of that name is executed.
    File,
}

/// The calls that led to a block.
pub(super) fn calls(block: &Executed<'_>) -> Vec<CallAt> {
    let calls = block.calls().map(|call| CallAt {
        by: call.by.name(),
        l: call.l,
        file: block.index_of(call.file),
        n: call.n,
        line: block.line_of(call.at),
        pass: call.pass,
        of: call.of,
    });
    calls.collect()
}

/// Executions of a block that are listed.
const LISTED: usize = 40;

/// Looks for a place among executed blocks.
#[derive(Debug)]
pub struct Search {
    asked: Asked,
    /// The macrocycle's number.
    macrocycle: Option<u32>,
    /// The file that is asked about, once it is executed, and its block for a number or line.
    file: Option<FileId>,
    block: Option<BlockId>,
    near: Option<u32>,
    arrivals: Vec<Arrival>,
    count: u64,
}

impl Search {
    /// For what is asked.
    pub fn new(asked: Asked) -> Self {
        let macrocycle = asked.file.as_deref().and_then(|file| Library::number(Path::new(file)));
        Self { asked, macrocycle, file: None, block: None, near: None, arrivals: Vec::new(), count: 0 }
    }

    /// The question.
    pub const fn asked(&self) -> &Asked {
        &self.asked
    }

    /// Whether the next executed block is the place.
    #[inline]
    pub fn arrives(&mut self, block: &Executed<'_>) -> bool {
        if !self.is_here(block) {
            return false;
        }
        self.count += 1;
        if self.asked.pass.is_none() && self.arrivals.len() < LISTED {
            self.arrivals.push(Arrival::of(block));
        }
        self.count == self.asked.pass.unwrap_or(1)
    }

    /// How many blocks come before one that may be the place, from `next` on, after so many executed blocks.
    pub fn spares(&self, (file, block): (FileId, BlockId), executed: u64) -> u64 {
        match self.asked.place {
            Place::Seq(seq) => seq.checked_sub(executed).unwrap_or(u64::MAX),
            // No point changes the tool.
            Place::Tool(_) => u64::MAX,
            Place::N(_) | Place::Line(_) => match (self.file, self.block) {
                (None, _) => 0,
                (Some(of), Some(wanted)) if of == file => wanted.0.checked_sub(block.0).map_or(u64::MAX, u64::from),
                (Some(_), _) => u64::MAX,
            },
        }
    }

    /// Whether the block is at the place.
    fn is_here(&mut self, block: &Executed<'_>) -> bool {
        match self.asked.place {
            Place::Seq(seq) => block.seq() == seq,
            Place::Tool(tool) => block.m_written().contains(&TOOL_CHANGE) && block.tool() == Some(tool),
            Place::N(_) | Place::Line(_) => {
                let (file, id) = block.at();
                if self.file.is_none() {
                    self.look(block, file);
                }
                self.file == Some(file) && self.block == Some(id)
            }
        }
    }

    /// Notes the file that is asked about when this is its first executed block.
    fn look(&mut self, block: &Executed<'_>, file: FileId) {
        let is_it = match (&self.asked.file, self.macrocycle) {
            (None, _) => file == FileId(0),
            (Some(_), Some(l)) => file != FileId(0) && Library::number(Path::new(block.file_name())) == Some(l),
            (Some(name), None) => block.file_name() == name,
        };
        let Some(parsed) = block.file().filter(|_| is_it) else { return };
        self.file = Some(file);
        match self.asked.place {
            Place::N(n) => {
                self.block = parsed.block_ids().find(|id| parsed.number(*id) == Some(n));
                if self.block.is_none() {
                    let numbers = parsed.block_ids().filter_map(|id| parsed.number(id));
                    self.near = numbers.min_by_key(|number| (number.abs_diff(n), *number));
                }
            }
            Place::Line(line) => self.block = block_on_line(parsed, line),
            Place::Seq(_) | Place::Tool(_) => {}
        }
    }

    /// Why the place is none, or not one, after all executed blocks; so many were there.
    pub fn fault(&self, blocks: u64) -> Option<PlaceFault> {
        let is_missing = || match (self.asked.place, self.file, self.block) {
            (Place::Seq(_), ..) => PlaceFault::Beyond { blocks },
            (Place::N(_) | Place::Line(_), None, _) => PlaceFault::File,
            (Place::N(_) | Place::Line(_), Some(_), None) => PlaceFault::Missing { near: self.near },
            (Place::N(_) | Place::Line(_), Some(_), Some(_)) | (Place::Tool(_), ..) => PlaceFault::NotExecuted,
        };
        match (self.asked.pass, self.count) {
            (_, 0) => Some(is_missing()),
            (None, 1) => None,
            (None, count) => Some(PlaceFault::Several { arrivals: self.arrivals.clone(), count }),
            (Some(pass), count) => (pass == 0 || pass > count).then_some(PlaceFault::Passes { count }),
        }
    }
}

/// The first block whose `N` stands on a line, from 1; without one, the block whose words go on there.
pub fn block_on_line(file: &ParsedFile, line: u32) -> Option<BlockId> {
    let index = (line as usize).checked_sub(1)?;
    let lines = file.source.lines();
    let start = lines.start(index)?;
    let end = lines.start(index + 1).unwrap_or(u32::MAX);
    let starts_at = |id: BlockId| file.n_place(id).span.start;
    let before = start.checked_sub(1).and_then(|offset| file.block_at(offset));
    let first = before.map_or(BlockId(0), BlockId::next);
    if first.0 < file.block_count() && starts_at(first) < end {
        return Some(first);
    }
    let goes_on = |id: &BlockId| file.words(*id).iter().any(|word| (start..end).contains(&word.start()));
    before.filter(goes_on)
}
