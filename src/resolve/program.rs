//! A resolved program: its files, its units, and where its calls and jumps lead.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

use super::axis_letters::AxisLetters;
use super::holes::may_have_block;
use super::numbers::{is_between, rises};
use super::points::Points;
use super::spelling;
use super::star::Star;
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile};
use crate::text::{FileId, Location};

/// Index of a unit of a resolved program.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub struct UnitId(pub u32);

/// The kind of a unit.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum UnitKind {
    /// The main program.
    Main,
    /// A subprogram; its L unless that is missing or malformed.
    Subprogram(Option<u32>),
    /// A macrocycle, by the number of its file.
    Macrocycle(u32),
}

/// A program unit: consecutive blocks of one file that jumps do not leave.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// The kind.
    pub kind: UnitKind,
    /// In which file.
    pub file: FileId,
    /// Its first block.
    pub first: BlockId,
    /// One past its last block.
    pub end: BlockId,
    /// The G79 word, or the first `N`, or `%`: where a missing end is reported.
    pub entry: Location,
}

impl Unit {
    /// Whether a block of the same file belongs to it.
    pub fn contains(&self, block: BlockId) -> bool {
        self.first <= block && block < self.end
    }

    /// Its blocks, in order.
    pub fn blocks(&self) -> impl Iterator<Item = BlockId> + use<> {
        (self.first.0..self.end.0).map(BlockId)
    }

    /// `main`, `L100`.
    pub fn name(&self) -> String {
        match self.kind {
            UnitKind::Main => "%".to_owned(),
            UnitKind::Subprogram(Some(l)) | UnitKind::Macrocycle(l) => format!("L{l}"),
            UnitKind::Subprogram(None) => "L?".to_owned(),
        }
    }
}

/// Where a call or jump that is written with digits leads.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Target {
    /// A subprogram or macrocycle.
    Unit(UnitId),
    /// A block of the same unit.
    Block(BlockId),
}

/// One file with its targets and numbers.
#[derive(Debug)]
pub(super) struct ResolvedFile {
    pub(super) parsed: ParsedFile,
    /// Calls and jumps written with digits, by block.
    pub(super) targets: Vec<(BlockId, Target)>,
    /// The first block of each number that a jump can reach (FLW-5: L has four digits), by number.
    pub(super) numbered: Vec<(u32, BlockId)>,
    pub(super) points: Points,
    /// The `*` that ends it.
    pub(super) star: Option<Star>,
    /// The blocks whose numbers cannot be read; looked up when a target is missing.
    unread: OnceLock<Vec<BlockId>>,
}

impl ResolvedFile {
    /// The blocks whose numbers cannot be read.
    fn unread(&self) -> &[BlockId] {
        let is_unread = |block: &BlockId| self.parsed.number(*block).is_none();
        self.unread.get_or_init(|| self.parsed.block_ids().filter(is_unread).collect())
    }
}

/// A program or macrocycle with everything that its written calls lead to. Its files have the ids that they have among
/// the sources of the run. A copy shares the files.
#[derive(Clone, Debug, Default)]
pub struct Resolved {
    /// Shared between copies; the targets of a file are set while it has one owner, before its program is resolved.
    pub(super) files: Vec<Arc<ResolvedFile>>,
    pub(super) units: Vec<Unit>,
    pub(super) subprograms: BTreeMap<u32, UnitId>,
    pub(super) macrocycles: BTreeMap<u32, UnitId>,
    /// A subprogram has no readable L: it may be the one that a call means.
    pub(super) nameless_subprogram: bool,
    pub(super) subprogram_call_warned: bool,
    /// Codes of operations that are not configured and have been reported (PAR-9).
    pub(super) unknown_operations: BTreeSet<i64>,
    /// The axis letters used, when the configuration does not list any (ADR-4).
    pub(super) letters: AxisLetters,
    /// A `*` cuts off the end of a unit.
    pub(super) cut_off: bool,
    /// Files with a finding that names the text after their `*`: a unit or block that is missing there has none.
    pub(super) told_of_star: BTreeSet<FileId>,
    /// How many units have had their calls followed.
    pub(super) followed: usize,
    /// How many files written calls lead to; those behind are loaded by parameters and the cycle map.
    pub(super) written_files: usize,
    /// M functions without a meaning on this machine that have been reported (TEC-8).
    pub(super) meaningless: BTreeSet<u8>,
    /// An S under G97 has its warning (W0116).
    pub(super) cutting_speed: bool,
}

impl Resolved {
    /// The program or macrocycle itself, without what it calls; `None` when it could not be read.
    pub fn into_program(self) -> Option<ParsedFile> {
        let first = self.files.into_iter().next()?;
        Arc::into_inner(first).map(|file| file.parsed)
    }

    /// A file; `None` for an index of another program.
    #[inline]
    pub fn file(&self, index: FileId) -> Option<&ParsedFile> {
        self.files.get(index.0 as usize).map(|file| &file.parsed)
    }

    /// All of its files.
    pub fn files(&self) -> impl Iterator<Item = &ParsedFile> {
        self.files.iter().map(|file| &file.parsed)
    }

    /// The program's file and those of the macrocycles that written calls lead to.
    pub fn written_files(&self) -> impl Iterator<Item = &ParsedFile> {
        self.files().take(self.written_files)
    }

    /// The facts about the points of a file.
    pub fn points(&self, index: FileId) -> Option<Points> {
        self.files.get(index.0 as usize).map(|file| file.points)
    }

    /// A unit; `None` for an index of another program.
    #[inline]
    pub fn unit(&self, id: UnitId) -> Option<&Unit> {
        self.units.get(id.0 as usize)
    }

    /// All units, the main program first.
    pub fn units(&self) -> impl Iterator<Item = (UnitId, &Unit)> {
        (0..).map(UnitId).zip(&self.units)
    }

    /// The main program; `None` when a macrocycle was resolved, or the file has no `%`.
    pub fn main(&self) -> Option<UnitId> {
        self.units().find(|(_, unit)| unit.kind == UnitKind::Main).map(|(id, _)| id)
    }

    /// Whether no call of a subprogram from a subprogram was reported before; it counts as reported now (FLW-2).
    pub const fn is_first_inner_call(&mut self) -> bool {
        !std::mem::replace(&mut self.subprogram_call_warned, true)
    }

    /// The codes of operations that are not configured and have been reported (PAR-9).
    pub const fn unknown_operations(&self) -> &BTreeSet<i64> {
        &self.unknown_operations
    }

    /// Whether a `*` cuts off the end of a unit: the blocks behind it are not executed.
    pub const fn is_cut_off(&self) -> bool {
        self.cut_off
    }

    /// Notes a finding that names the end of a unit after the `*` of a file.
    pub(super) fn tell_of_star(&mut self, file: FileId) {
        self.told_of_star.insert(file);
        self.cut_off |= file == FileId(0);
    }

    /// The `*` that ends a file.
    pub(super) fn star(&self, file: FileId) -> Option<&Star> {
        self.files.get(file.0 as usize)?.star.as_ref()
    }

    /// The `*` of a file, when a finding names the text after it.
    pub(super) fn told_star(&self, file: FileId) -> Option<&Star> {
        self.star(file).filter(|_| self.told_of_star.contains(&file))
    }

    /// Whether a block with that number comes after such a `*`.
    pub(super) fn is_behind_told_star(&self, file: FileId, number: u32) -> bool {
        let star = self.told_star(file).zip(self.file(file));
        star.is_some_and(|(star, parsed)| star.has_block(parsed, number))
    }

    /// The subprogram of that number.
    pub fn subprogram(&self, l: u32) -> Option<UnitId> {
        self.subprograms.get(&l).copied()
    }

    /// The number of a subprogram that is nearest to `l` by spelling, but not the one that is called from.
    pub fn nearest_subprogram(&self, l: u32, from: Option<u32>) -> Option<u32> {
        let others = self.subprograms.keys().copied().filter(|number| Some(*number) != from);
        others.min_by_key(|number| spelling::distance(*number, l))
    }

    /// Where the call or jump of a block leads, when it is written with digits and exists.
    pub fn target(&self, file: FileId, block: BlockId) -> Option<Target> {
        let targets = &self.files.get(file.0 as usize)?.targets;
        targets
            .binary_search_by_key(&block, |(block, _)| *block)
            .ok()
            .and_then(|at| targets.get(at))
            .map(|found| found.1)
    }

    /// The calls and jumps of a file that are written with digits, by block, and where they lead.
    pub fn targets(&self, file: FileId) -> &[(BlockId, Target)] {
        self.files.get(file.0 as usize).map_or(&[], |file| &file.targets)
    }

    /// The first block of a file with that number.
    pub fn numbered(&self, file: FileId, number: u32) -> Option<BlockId> {
        let numbered = &self.files.get(file.0 as usize)?.numbered;
        let at = numbered.binary_search_by_key(&number, |(number, _)| *number).ok()?;
        numbered.get(at).map(|(_, block)| *block)
    }

    /// Whether a block of the unit has a number that cannot be read, and that may be `number`.
    pub(super) fn may_have_block(&self, unit: &Unit, number: u32) -> bool {
        self.files
            .get(unit.file.0 as usize)
            .is_some_and(|file| may_have_block(&file.parsed, file.unread(), unit, number))
    }

    /// The number of a block of the unit that is nearest to `number` by spelling; when all differ in more than one
    /// digit, the one that is nearest in value.
    pub fn nearest_block(&self, unit: &Unit, number: u32) -> Option<u32> {
        let file = self.files.get(unit.file.0 as usize)?;
        let inside = |(_, block): &&(u32, BlockId)| unit.contains(*block);
        let exists = |number: &u32| self.numbered(unit.file, *number).is_some_and(|block| unit.contains(block));
        let slip = spelling::slips(number).filter(exists).min_by_key(|slip| spelling::distance(*slip, number));
        if slip.is_some() {
            return slip;
        }
        let (below, above) = file.numbered.split_at(file.numbered.partition_point(|(found, _)| *found <= number));
        let below = below.iter().rev().find(inside);
        let above = above.iter().find(inside);
        below.into_iter().chain(above).map(|(found, _)| *found).min_by_key(|found| found.abs_diff(number))
    }

    /// A block of the unit whose number is one slip from `number`, which fits between its neighbours, where its own
    /// does not.
    pub(super) fn misnumbered_block(&self, unit: &Unit, number: u32) -> Option<u32> {
        let file = self.file(unit.file)?;
        let fits = |at: BlockId| is_between(file, at, number) && !rises(file, at);
        let wrong = |slip: &u32| self.numbered(unit.file, *slip).is_some_and(|at| unit.contains(at) && fits(at));
        spelling::slips(number).find(wrong)
    }

    pub(super) fn add_unit(&mut self, unit: Unit) -> UnitId {
        let id = UnitId(small(self.units.len()));
        self.nameless_subprogram |= unit.kind == UnitKind::Subprogram(None);
        self.units.push(unit);
        id
    }

    pub(super) fn add_file(
        &mut self,
        parsed: ParsedFile,
        star: Option<Star>,
        numbered: Vec<(u32, BlockId)>,
        points: Points,
    ) {
        let (targets, unread) = (Vec::new(), OnceLock::new());
        self.files.push(Arc::new(ResolvedFile { parsed, targets, numbered, points, star, unread }));
    }
}
