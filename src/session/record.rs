//! The record of an execution: a question about some blocks need not execute the program from its first block.

use std::collections::BTreeSet;

use crate::resolve::Resolved;
use crate::run::{Executed, Interpreter, Stop, Stretch};
use crate::syntax::BlockId;
use crate::text::{FileId, Sources};

/// Executed blocks between two checkpoints. Fuzzing has short programs.
const STRIDE: u64 = if cfg!(fuzzing) { 2 } else { 1 << 13 };
/// Most checkpoints. When there are more, every second one goes, and the distance between them doubles.
const MOST: usize = 1 << 10;
/// Most stretches of blocks that a part tells apart.
const STRETCHES: usize = 16;

/// One execution of a program: checkpoints, from which it can go on, and which blocks are executed between them. Its
/// memory does not depend on how long the program is.
#[derive(Debug)]
pub struct Record {
    resolved: Resolved,
    sources: Sources,
    parts: Vec<Part>,
    stop: Option<Stop>,
    executed: u64,
    last: u32,
}

/// The execution from one checkpoint up to the next.
#[derive(Debug)]
struct Part {
    from: Interpreter,
    visited: Vec<Stretch>,
}

impl Record {
    /// The program with the macrocycles that execution loaded.
    pub fn resolved(&self) -> &Resolved {
        &self.resolved
    }

    /// The texts of its files.
    pub fn sources(&self) -> &Sources {
        &self.sources
    }

    /// M02 or M30, when that was reached.
    pub fn end(&self) -> Option<u8> {
        match self.stop {
            Some(Stop::End(m)) => Some(m),
            Some(Stop::Halted) | None => None,
        }
    }

    /// Blocks executed.
    pub fn executed(&self) -> u64 {
        self.executed
    }

    /// The number of the last executed block; 0 when there is none.
    pub fn last(&self) -> u32 {
        self.last
    }

    /// Where execution must go on from to come by all executions of some blocks, and after how many executed blocks
    /// each time it has come by them.
    pub fn visits(&self, file: FileId, blocks: &BTreeSet<BlockId>) -> Vec<(&Interpreter, u64)> {
        let mut visits: Vec<(&Interpreter, u64)> = Vec::new();
        for (at, part) in self.parts.iter().enumerate() {
            let visited =
                |stretch: &Stretch| stretch.file == file && blocks.range(stretch.first..stretch.end).next().is_some();
            if !part.visited.iter().any(visited) {
                continue;
            }
            let end = self.parts.get(at + 1).map_or(self.executed, |next| next.from.executed());
            match visits.last_mut() {
                // Parts in a row are gone through at once.
                Some((_, before)) if *before == part.from.executed() => *before = end,
                _ => visits.push((&part.from, end)),
            }
        }
        visits
    }
}

/// Makes a [`Record`] while a program is executed.
#[derive(Debug)]
pub(super) struct Recorder {
    parts: Vec<Part>,
    stride: u64,
    /// The stretch of the last part that the last block is in.
    current: usize,
    /// The last executed block.
    last: Option<(FileId, BlockId)>,
}

impl Recorder {
    /// Ready for the first block.
    pub(super) fn new(interpreter: Interpreter) -> Self {
        Self { parts: vec![Part { from: interpreter, visited: Vec::new() }], stride: STRIDE, current: 0, last: None }
    }

    /// How many blocks may be executed at once after so many.
    pub(super) const fn room(&self, executed: u64) -> u64 {
        self.stride - executed % self.stride
    }

    /// The next executed block.
    pub(super) fn block(&mut self, block: &Executed<'_>) {
        let (file, id) = block.at();
        self.visit(Stretch { file, first: id, end: id.next() });
        self.last = Some((file, id));
        let executed = block.seq() + 1;
        if executed.is_multiple_of(self.stride) {
            self.parts.push(Part { from: block.checkpoint(), visited: Vec::new() });
            self.current = 0;
            if self.parts.len() > MOST {
                self.thin_out();
            }
        }
    }

    /// Blocks that were executed at once.
    pub(super) fn visit(&mut self, stretch: Stretch) {
        let Some(part) = self.parts.last_mut() else { return };
        if let Some(known) = part.visited.get_mut(self.current)
            && known.goes_on_with(stretch)
        {
            known.end = known.end.max(stretch.end);
            return;
        }
        if let Some(at) = part.visited.iter().position(|known| known.goes_on_with(stretch)) {
            self.current = at;
            if let Some(known) = part.visited.get_mut(at) {
                known.end = known.end.max(stretch.end);
            }
            return;
        }
        part.add(stretch);
        self.current = part.visited.len() - 1;
    }

    /// Leaves out every second checkpoint.
    fn thin_out(&mut self) {
        let parts = std::mem::take(&mut self.parts);
        for part in parts {
            if part.from.executed().is_multiple_of(self.stride * 2) || self.parts.is_empty() {
                self.parts.push(part);
            } else if let Some(before) = self.parts.last_mut() {
                part.visited.into_iter().for_each(|stretch| before.add(stretch));
            }
        }
        self.stride *= 2;
    }

    /// The record of an execution that `interpreter` has come to the end of.
    pub(super) fn finish(self, interpreter: &Interpreter, resolved: &Resolved, sources: &Sources) -> Record {
        let last = self.last.and_then(|(file, id)| Some(resolved.file(file)?.shown_number(id)));
        Record {
            resolved: resolved.clone(),
            sources: sources.clone(),
            parts: self.parts,
            stop: interpreter.end(),
            executed: interpreter.executed(),
            last: last.unwrap_or_default(),
        }
    }
}

impl Part {
    /// Adds a stretch. When there are too many, all of its file become one.
    fn add(&mut self, stretch: Stretch) {
        self.visited.push(stretch);
        if self.visited.len() > STRETCHES {
            let (same, others): (Vec<Stretch>, Vec<Stretch>) =
                self.visited.drain(..).partition(|known| known.file == stretch.file);
            self.visited = others;
            self.visited.extend(same.into_iter().reduce(|all, next| Stretch {
                file: all.file,
                first: all.first.min(next.first),
                end: all.end.max(next.end),
            }));
        }
    }
}
