//! One execution that tells whether a program can start at a place, where else it can, and where its text can go on.

use std::collections::HashMap;
use std::ops::ControlFlow;

use super::approach::{Lack, Target, UnknownAxes};
use super::gather::Uses;
use super::reason::Reason;
use super::tracker::{Conversion, Options, Tracker};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::{AxisLetter, Decimal, GCode, GGroup, Micro, TOOL_CHANGE};
use crate::resolve::{Target as Leads, UnitKind};
use crate::run::{ArmedCounter, End, Executed, MotionType, Program, Sink, State};
use crate::syntax::BlockId;
use crate::text::FileId;

/// A tool change or a rapid at which a program can start.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Spot {
    /// Which executed block.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// The name of its file; empty for the program.
    pub file: String,
    /// The line of its `N`.
    pub line: u32,
    /// Which execution of it this is, from 1.
    pub pass: u64,
    /// T when the block changes the tool, else the tool in the spindle.
    pub tool: Option<Decimal>,
    /// It changes the tool.
    pub changes: bool,
}

/// Places that work unless a later block needs an axis that is not known, or works at their height: those with the same
/// unknown axes at the same height share their fate.
#[derive(Debug)]
struct Pending {
    /// The latest of them.
    seq: u64,
    unknown: UnknownAxes,
    /// The parameters that the program gave values that are not known, a bit each.
    lost: u128,
    /// See [`Target::level`].
    level: Option<Micro>,
    /// See [`super::approach::Approach::lacks`].
    lacks: Option<Reason>,
    /// Those that are listed.
    spots: Vec<Spot>,
}

impl Pending {
    /// Whether nothing that comes later matters.
    const fn is_settled(&self) -> bool {
        self.unknown.is_empty() && self.level.is_none() && self.lost == 0
    }
}

/// What was in force at the place that is asked for, beside its state.
#[derive(Clone, Debug)]
pub(super) struct There {
    pub target: Result<Target, Reason>,
    pub feed_mode: Option<GCode>,
    pub speed_mode: Option<GCode>,
    /// See [`Tracker::turning`].
    pub turning: Option<(GCode, Decimal)>,
    /// See [`Tracker::apart`].
    pub apart: Vec<(u64, u32, u8)>,
    pub conversion: Option<Conversion>,
    pub corrections: Option<u32>,
    /// Which execution of the block this is, and whether there is another.
    pub pass: u64,
    pub several: bool,
    /// The first block from which the text goes on: no counter counts there, and no jump leads before it.
    pub text: Option<(u64, BlockId)>,
    /// The latest earlier place that works.
    pub nearest: Option<u64>,
    /// Axes that are not known there, and why.
    pub unknown: Vec<(AxisLetter, Lack)>,
}

/// Where the text of the program can go on.
#[derive(Debug, Default)]
struct Text {
    /// Jumps of the main program that are written with digits, by block: the lowest target of each and of all behind
    /// it.
    lowest: Vec<(BlockId, BlockId)>,
    from: Option<(u64, BlockId)>,
    /// The jumps that counted there.
    armed: Vec<BlockId>,
}

impl Text {
    fn of(program: &Program<'_>) -> Self {
        let resolved = &program.resolved;
        let main = resolved.units().find(|(_, unit)| unit.kind == UnitKind::Main).map(|(_, unit)| *unit);
        let jumps = resolved.targets(FileId(0)).iter().filter_map(|(block, target)| match target {
            Leads::Block(target) if main.is_some_and(|main| main.contains(*block)) => Some((*block, *target)),
            Leads::Block(_) | Leads::Unit(_) => None,
        });
        let mut lowest: Vec<_> = jumps.collect();
        let mut least = BlockId(u32::MAX);
        for (_, target) in lowest.iter_mut().rev() {
            least = least.min(*target);
            *target = least;
        }
        Self { lowest, from: None, armed: Vec::new() }
    }

    /// Looks at a block of the main program; `counters`: what counts before it.
    fn look(&mut self, seq: u64, id: BlockId, counters: &[ArmedCounter]) {
        if self.from.is_some_and(|(_, from)| id < from) || self.armed.contains(&id) {
            self.from = None;
        }
        if self.from.is_some() {
            return;
        }
        self.armed.clear();
        self.armed.extend(counters.iter().filter(|counter| counter.depth == 0).map(|counter| counter.block));
        let at = self.lowest.partition_point(|(block, _)| *block < id);
        let stays = self.lowest.get(at).is_none_or(|(_, target)| *target >= id);
        if stays && !self.armed.contains(&id) {
            self.from = Some((seq, id));
        }
    }
}

/// The reader.
#[derive(Debug)]
pub(super) struct Scan {
    tracker: Tracker,
    /// The place; nothing when all are listed.
    place: Option<u64>,
    pending: Vec<Pending>,
    /// The latest earlier place that works whatever comes.
    nearest: Option<u64>,
    spots: Vec<Spot>,
    passes: HashMap<(FileId, BlockId), u64>,
    /// The block that is asked for, to count its executions.
    block: Option<(u32, u32)>,
    pass: u64,
    count: u64,
    text: Text,
    there: Option<There>,
    /// The parameters that the program gave values that are not known, before the next block.
    lost: u128,
    /// Places that `--safe` would open.
    without_safe: u64,
    /// Why the first of the other places is none.
    refused: Option<Reason>,
}

/// The places at which a program can start.
#[derive(Clone, Debug)]
pub struct Places {
    /// In the order of execution.
    pub spots: Vec<Spot>,
    /// How many more there would be with `--safe`.
    pub with_safe: u64,
    /// Why there is none at the first tool change or rapid that is left out for another reason.
    pub refused: Option<Reason>,
}

impl Scan {
    /// `place`: its seq, the index of its file and its number; without one all places are listed.
    pub fn new(settings: &Settings, options: Options, place: Option<(u64, u32, u32)>) -> Self {
        Self {
            tracker: Tracker::new(settings, options),
            place: place.map(|(seq, _, _)| seq),
            pending: Vec::new(),
            nearest: None,
            spots: Vec::new(),
            passes: HashMap::new(),
            block: place.map(|(_, file, n)| (file, n)),
            pass: 0,
            count: 0,
            text: Text::default(),
            there: None,
            lost: 0,
            without_safe: 0,
            refused: None,
        }
    }

    /// The place that was asked for.
    pub fn finish(mut self) -> Option<There> {
        self.settle_all();
        let mut there = self.there?;
        there.nearest = self.nearest;
        there.text = self.text.from;
        there.several = self.count > 1;
        Some(there)
    }

    /// All tool changes and rapids at which a start is possible, in the order of execution.
    pub fn into_places(mut self) -> Places {
        self.settle_all();
        self.spots.sort_by_key(|spot| spot.seq);
        Places { spots: self.spots, with_safe: self.without_safe, refused: self.refused }
    }

    /// Nothing more comes: what waited for it works.
    fn settle_all(&mut self) {
        for pending in std::mem::take(&mut self.pending) {
            self.works(pending);
        }
    }

    fn works(&mut self, pending: Pending) {
        if let Some(reason) = pending.lacks.clone() {
            self.lack_safe(&pending, reason);
            return;
        }
        if self.place != Some(pending.seq) {
            self.nearest = self.nearest.max(Some(pending.seq));
        }
        self.spots.extend(pending.spots);
    }

    /// Before a block: is it a place to start at?
    fn arrive(&mut self, block: &Executed<'_>) {
        let seq = block.seq();
        if self.block == Some((block.file_index(), block.n())) {
            self.count += 1;
        }
        if self.place.is_some_and(|place| seq > place) {
            return;
        }
        let is_place = self.place == Some(seq);
        let lists = self.place.is_none();
        let spot = if lists { self.spot(block) } else { None };
        if lists && spot.is_none() {
            return;
        }
        let judged = self.tracker.judge(block);
        if is_place {
            self.pass = self.count;
            self.there = Some(self.there(block, judged.clone()));
        }
        let target = match judged {
            Ok(target) => target,
            Err(reason) => {
                self.refused.get_or_insert(reason);
                return;
            }
        };
        let Target { unknown, level, approach } = target;
        let lost = self.lost;
        let pending = Pending { seq, unknown, lost, level, lacks: approach.lacks, spots: spot.into_iter().collect() };
        if !is_place && pending.is_settled() {
            self.works(pending);
        } else {
            self.wait(pending);
        }
    }

    /// Keeps places together with those that have the same unknown axes. The place that is asked for waits alone.
    fn wait(&mut self, pending: Pending) {
        let asked = self.place;
        let is_asked = |pending: &Pending| asked == Some(pending.seq);
        let key = |of: &Pending| (of.unknown, of.lost, of.level, of.lacks.clone());
        let alike = |other: &Pending| key(other) == key(&pending);
        let same = |other: &&mut Pending| alike(other) && !is_asked(other) && !is_asked(&pending);
        match self.pending.iter_mut().find(same) {
            Some(other) => {
                other.seq = other.seq.max(pending.seq);
                other.spots.extend(pending.spots);
            }
            None => self.pending.push(pending),
        }
    }

    /// The block as a tool change or a rapid.
    fn spot(&mut self, block: &Executed<'_>) -> Option<Spot> {
        let pass = self.passes.entry(block.at()).or_default();
        *pass += 1;
        let changes = block.m_written().contains(&TOOL_CHANGE);
        let rapid = block.motion().is_some_and(|motion| motion.kind() == MotionType::Rapid);
        let file = if block.file_index() == 0 { String::new() } else { block.file_name().to_owned() };
        (changes || rapid).then(|| Spot {
            seq: block.seq(),
            n: block.n(),
            file,
            line: block.line(),
            pass: *pass,
            tool: block.tool(),
            changes,
        })
    }

    fn there(&self, block: &Executed<'_>, target: Result<Target, Reason>) -> There {
        let Tracker { feed_mode, speed_mode, turning, corrections, .. } = self.tracker;
        let axes = block.settings().machine.axes.iter().enumerate();
        let unknown = axes.filter_map(|(at, axis)| Some((axis.letter, self.tracker.lack(at, axis)?)));
        There {
            target,
            feed_mode,
            speed_mode,
            turning,
            apart: self.tracker.apart.clone(),
            conversion: self.tracker.conversion.clone(),
            corrections,
            pass: self.pass,
            several: false,
            text: None,
            nearest: None,
            unknown: unknown.collect(),
        }
    }

    /// Judges the waiting places by how a block uses their unknown axes.
    fn use_axes(&mut self, block: &Executed<'_>) {
        if self.pending.is_empty() {
            return;
        }
        let used = Used::of(block, self.tracker.state());
        let heights = self.tracker.heights();
        let (changes, works_at) = (heights.changes(block), heights.works_at(block, self.tracker.state()));
        let uses = (block.has_parameters() || block.is_opaque()).then(|| Uses::of(block, self.tracker.state()));
        let [reads, writes] =
            uses.map_or([0; 2], |uses| [mask(uses.words.into_iter().chain(uses.others)), mask(uses.written)]);
        for mut pending in std::mem::take(&mut self.pending) {
            if pending.lost & reads != 0 {
                let name = format!("R{}", (pending.lost & reads).trailing_zeros());
                self.refused.get_or_insert(Reason::Value { name });
                continue;
            }
            pending.lost &= !writes;
            pending.level = pending.level.filter(|_| !changes);
            if pending.level.is_some_and(|level| works_at >= Some(level)) {
                self.lack_safe(&pending, self.tracker.no_safe());
                continue;
            }
            let UnknownAxes { fresh, from_start, lost, turned } = &mut pending.unknown;
            // Where both programs change the origin, neither has the length.
            *turned &= !used.unsettled;
            if *turned & used.moved != 0 {
                if self.place == Some(pending.seq) {
                    self.set_reason(Reason::Length { n: block.n() });
                }
                continue;
            }
            let cut = (*from_start | *lost) & used.cut_from;
            let needed = (*fresh | *from_start | *lost) & used.from_there | cut;
            let stays = if used.moved == 0 { 0 } else { *lost & !used.moved };
            if needed | stays != 0 {
                if self.place == Some(pending.seq) {
                    self.refuse(block, needed, stays);
                }
                continue;
            }
            for axes in [fresh, from_start, lost] {
                *axes &= !used.known;
            }
            if pending.is_settled() && self.place != Some(pending.seq) {
                self.works(pending);
            } else {
                self.wait(pending);
            }
        }
    }

    /// Places do not work without another `--safe`.
    fn lack_safe(&mut self, pending: &Pending, reason: Reason) {
        self.without_safe += pending.spots.len() as u64;
        if self.place == Some(pending.seq) {
            self.set_reason(reason);
        }
    }

    /// The place does not work: the block needs axes that are not known, or moves others while such ones stand.
    fn refuse(&mut self, block: &Executed<'_>, needed: u16, stays: u16) {
        let of = |axes: u16| {
            let axis = block.settings().machine.axes.get(axes.trailing_zeros() as usize);
            axis.map_or_else(String::new, |axis| axis.letter.to_string())
        };
        let n = block.n();
        let reason = match needed {
            0 => Reason::Stands { axis: of(stays), n },
            _ => Reason::Needed { axis: of(needed), n },
        };
        self.set_reason(reason);
    }

    fn set_reason(&mut self, reason: Reason) {
        if let Some(there) = &mut self.there {
            there.target = Err(reason);
        }
    }
}

/// Parameters, a bit each.
fn mask(indices: impl IntoIterator<Item = u8>) -> u128 {
    indices.into_iter().filter(|index| *index < 96).fold(0, |all, index| all | 1 << index)
}

/// How a block uses axes, a bit for each place in machine order.
#[derive(Clone, Copy, Debug, Default)]
struct Used {
    /// It goes on from where they stand: G91, an arc, a thread, an origin by G93.
    from_there: u16,
    /// It cuts from where they stand to a programmed position, or a macrocycle of the machine begins there.
    cut_from: u16,
    /// It moves them.
    moved: u16,
    /// Where they stand after it does not depend on where they stood.
    known: u16,
    /// Their programmed positions are not where the tool stands (MOT-8): before its motion, or behind it.
    unsettled: u16,
}

impl Used {
    fn of(block: &Executed<'_>, before: &State) -> Self {
        let mut used = Self::default();
        let machine = &block.settings().machine;
        let incremental = block.g(GGroup::G9) == Some(GCode::G91);
        let bit = |letter: AxisLetter| machine.axes.index(letter).map_or(0, |at| 1_u16 << at);
        if let Some(motion) = block.motion() {
            let kind = motion.kind();
            for letter in motion.axes() {
                used.moved |= bit(letter);
                if kind == MotionType::Reference {
                    continue;
                }
                if incremental || kind.is_arc() || kind == MotionType::Thread {
                    used.from_there |= bit(letter);
                } else if kind.is_working() {
                    used.cut_from |= bit(letter);
                }
            }
        }
        let letters = |list: &[(char, Decimal)]| {
            let axes =
                machine.axes.iter().filter(|axis| list.iter().any(|(letter, _)| *letter == axis.letter.letter()));
            axes.fold(0, |all, axis| all | bit(axis.letter))
        };
        if block.is_unmapped_cycle() {
            let named = letters(block.words());
            used.moved |= named;
            used.cut_from |= named;
            used.from_there |= if incremental { named } else { 0 };
        }
        if let Some(data) = block.data().filter(|data| data.g == GCode::G93) {
            used.from_there |= letters(data.values);
        }
        for (at, _) in machine.axes.iter().enumerate() {
            let found = before.axis_position(at).is_none() && block.state().axis_position(at).is_some();
            used.known |= if found { 1 << at } else { 0 };
            let unsettled = before.is_unsettled(at) || block.state().is_unsettled(at);
            used.unsettled |= if unsettled { 1 << at } else { 0 };
        }
        // What a macrocycle of the machine does may depend on where it begins.
        let unseen = block.moved_unseen().fold(0, |all, axis| all | bit(axis));
        used.moved |= unseen;
        used.cut_from |= unseen;
        used.moved |= if block.change_pos() { u16::MAX } else { 0 };
        used.known |= used.moved;
        used
    }
}

impl Sink for &mut Scan {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        self.text = Text::of(program);
        self.tracker.begin(program);
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.tracker.arrive(block);
        self.arrive(block);
        if self.place.is_some_and(|place| block.seq() >= place) && block.depth() == 0 {
            self.text.look(block.seq(), block.at().1, self.tracker.before().counters());
        }
        self.use_axes(block);
        self.tracker.pass(block);
        if !block.moves_on() {
            self.lost = mask((0..96).filter(|index| self.tracker.state().is_lost(*index)));
        }
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
