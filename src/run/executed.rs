//! An executed block, as its readers see it: typed, borrowed from execution, and worked out only as far as asked.

use super::block::{Effect, Jump};
use super::m_functions::{MStop, at_stop, halts};
use super::moved::Motion;
use super::state::State;
use super::technology::dwell;
use super::{Interpreter, Program};
use crate::config::Settings;
use crate::diag::{CallKind, CallSite, Diagnostic, Finding};
use crate::dict::{
    Address, AxisLetter, Decimal, FeedMode, FeedPer, GCode, GGroup, Lang, M_GROUPS, Micro, OPTIONAL_STOP, PROGRAM_STOP,
};
use crate::named::named;
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, LastPlaces, LineColumn, Location};

/// One executed block: what holds in it, what it does, how execution came to it.
#[derive(Clone, Copy, Debug)]
pub struct Executed<'r> {
    pub(super) interpreter: &'r Interpreter,
    pub(super) program: &'r Program<'r>,
}

/// A call on the way to a block.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// By which function.
    pub by: CallKind,
    /// What was called.
    pub l: u32,
    /// The file of the calling block.
    pub file: FileId,
    /// The number of the calling block.
    pub n: u32,
    /// The `N` of the calling block.
    pub at: Location,
    /// Which pass this is, from 1.
    pub pass: u32,
    /// Of how many.
    pub of: u32,
}

/// F in force, with what it counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feed {
    /// As programmed.
    pub value: Decimal,
    /// Its unit in this block.
    pub unit: FeedUnit,
    /// M37 is in force: the machine moves at a hundredth of it.
    pub hundredth: bool,
}

named! {
    /// What F counts in a block (TEC-1).
    #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
    pub enum FeedUnit {
        /// mm/min.
        MmPerMinute "mm/min",
        /// mm/rev.
        MmPerRevolution "mm/rev",
        /// deg/min: only rotary axes or the spindle move.
        DegPerMinute "deg/min",
        /// deg/rev.
        DegPerRevolution "deg/rev",
    }
}

impl FeedUnit {
    /// The unit of F under a feed mode, of a path in degrees or in millimetres.
    pub const fn of(per: FeedPer, degrees: bool) -> Self {
        match (per, degrees) {
            (FeedPer::Minute, false) => Self::MmPerMinute,
            (FeedPer::Revolution, false) => Self::MmPerRevolution,
            (FeedPer::Minute, true) => Self::DegPerMinute,
            (FeedPer::Revolution, true) => Self::DegPerRevolution,
        }
    }

    /// As people read it.
    pub const fn shown(self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::MmPerRevolution, Lang::Cs) => "mm/ot",
            (Self::DegPerMinute, Lang::Cs) => "°/min",
            (Self::DegPerRevolution, Lang::Cs) => "°/ot",
            (Self::MmPerMinute, _) | (_, Lang::En) => self.name(),
        }
    }
}

/// Words that are data and move nothing (GRP-4).
#[derive(Clone, Copy, Debug)]
pub struct Data<'r> {
    /// The function that makes them data.
    pub g: GCode,
    /// The G5 function in force, for G92 and G93.
    pub origin: Option<GCode>,
    /// D, when written.
    pub d: Option<Decimal>,
    /// The words as programmed, by letter.
    pub values: &'r [(char, Decimal)],
}

impl<'r> Executed<'r> {
    /// Which executed block it is, from 0.
    pub fn seq(&self) -> u64 {
        self.interpreter.executed - 1
    }

    /// The block number.
    pub fn n(&self) -> u32 {
        self.file().map_or(0, |file| file.shown_number(self.interpreter.block.id))
    }

    /// The block in the text.
    pub const fn at(&self) -> (FileId, BlockId) {
        (self.interpreter.block.file, self.interpreter.block.id)
    }

    /// Its file.
    pub fn file(&self) -> Option<&'r ParsedFile> {
        self.program.resolved.file(self.interpreter.block.file)
    }

    /// Its words as they stand in the file.
    pub fn source_words(&self) -> &'r [Word] {
        self.file().map_or(&[], |file| file.words(self.interpreter.block.id))
    }

    /// The name of its file, as found.
    pub fn file_name(&self) -> &'r str {
        self.file().map_or("", |file| file.source.name())
    }

    /// The index that streams give its file: files are counted as their first blocks are executed; the program is 0.
    pub fn file_index(&self) -> u32 {
        self.index_of(self.interpreter.block.file)
    }

    /// Where its `N` stands.
    pub fn place(&self) -> Location {
        self.file().map(|file| file.n_place(self.interpreter.block.id)).unwrap_or_default()
    }

    /// Line and column of its `N`, from 1; the column in characters.
    pub fn line_column(&self) -> LineColumn {
        let start = self.place().span.start;
        self.file().map_or(LineColumn { line: 1, column: 1 }, |file| file.source.line_column(start))
    }

    /// The same, where the last places of each file are remembered: quick.
    pub fn line_column_from(&self, places: &mut LastPlaces) -> LineColumn {
        let at = self.place();
        self.file().map_or(LineColumn { line: 1, column: 1 }, |file| places.of(at.file, &file.source, at.span.start))
    }

    /// The line of its `N`, from 1.
    pub fn line(&self) -> u32 {
        self.line_after(0)
    }

    /// The same, quick when the line of the block before was line `before`: execution mostly moves on.
    pub fn line_after(&self, before: u32) -> u32 {
        let start = self.place().span.start;
        let line = |file: &ParsedFile| file.source.lines().line_near(start, before.saturating_sub(1) as usize);
        self.file().map_or(1, |file| small(line(file) + 1))
    }

    /// Axis words under a fixed cycle that is not mapped, and that moves nothing here: nobody knows what moves (TIM-3).
    pub fn is_unmapped_cycle(&self) -> bool {
        let mapped = &self.settings().machine.cycles;
        let unmapped = |code: GCode| code.is_cycle() && !mapped.contains_key(&code.number());
        let has_axes = || {
            let words = self.file().into_iter().flat_map(|file| file.words(self.interpreter.block.id));
            words.into_iter().any(|word| word.address.axis().is_some())
        };
        self.g(GGroup::G8).is_some_and(unmapped) && self.motion().is_none() && self.data().is_none() && has_axes()
    }

    /// The macrocycle that it calls at its end and that only the machine has (FLW-12).
    pub const fn opaque_call(&self) -> Option<u32> {
        self.interpreter.block.opaque_call
    }

    /// How often it makes its call: its Q, else once.
    pub const fn call_count(&self) -> u32 {
        self.interpreter.block.call_count
    }

    /// Whether something moves in it, or at its end, that nobody knows (TIM-3): a fixed cycle, a macrocycle of the
    /// machine.
    pub fn is_opaque(&self) -> bool {
        self.opaque_call().is_some() || self.is_unmapped_cycle()
    }

    /// The axes that the macrocycle of [`Self::opaque_call`] may move, in machine order.
    pub fn moved_unseen(&self) -> impl Iterator<Item = AxisLetter> + use<'r> {
        let machine = &self.settings().machine;
        let may = self.opaque_call().and_then(|l| machine.macrocycles.get(&l));
        let moved = machine.axes.iter().map(|axis| axis.letter);
        moved.filter(move |axis| may.is_some_and(|may| may.moves(*axis)))
    }

    /// The calls that led to it, outermost first.
    pub fn calls(&self) -> impl Iterator<Item = Call> + use<'r> {
        let calls = self.interpreter.frames.iter().filter_map(|frame| frame.call);
        calls.map(|call| Call {
            by: call.by,
            l: call.l,
            file: call.file,
            n: call.n,
            at: call.at,
            pass: call.pass,
            of: call.of,
        })
    }

    /// A finding that this execution of the block gives, with the calls that led here.
    pub fn found(&self, finding: Finding, at: Location) -> Diagnostic {
        let mut diagnostic = Diagnostic::new(finding, at);
        diagnostic.calls =
            self.calls().map(|call| CallSite { by: call.by, l: call.l, n: call.n, at: call.at }).collect();
        diagnostic
    }

    /// The jump that is taken at its end.
    pub fn jump(&self) -> Option<Jump> {
        self.interpreter.block.jump
    }

    /// Whether it carries `/`.
    pub fn skippable(&self) -> bool {
        self.flags().has(BlockFlags::SKIP)
    }

    /// Whether it is the first executed block of the program.
    pub fn first(&self) -> bool {
        self.seq() == 0
    }

    /// Whether it is the last one: it holds M02 or M30.
    pub fn last(&self) -> bool {
        self.end().is_some()
    }

    /// M02 or M30 of the last block.
    pub fn end(&self) -> Option<u8> {
        self.interpreter.block.m.end
    }

    /// The function of a group in this block, functions that hold for one block included.
    pub fn g(&self, group: GGroup) -> Option<GCode> {
        self.interpreter.block.g.of(group)
    }

    /// The G functions written in it, in written order.
    pub fn g_written(&self) -> impl Iterator<Item = GCode> + use<'r> {
        self.interpreter.block.words.g.iter().map(|(code, _)| *code)
    }

    /// The M function of a group, 1–14, after this block; of groups 1, 7 and 9 only one that is written in it.
    pub fn m(&self, group: usize) -> Option<u8> {
        self.interpreter.block.m.in_force.get(group).copied().flatten()
    }

    /// The same of all groups, by number; 0 is not used.
    pub const fn m_of_groups(&self) -> &'r [Option<u8>; M_GROUPS] {
        &self.interpreter.block.m.in_force
    }

    /// The M functions written in it, in written order.
    pub fn m_written(&self) -> &'r [u8] {
        &self.interpreter.block.m.written
    }

    /// The M groups with a change bit (MFN-6), ascending.
    pub fn m_changed(&self) -> &'r [u8] {
        &self.interpreter.block.m.changed
    }

    /// What M groups 2, 5 and 6 hold while the program stands after this block (MFN-8): M00, or M01 with optional stop.
    pub fn m_at_stop(&self) -> Option<MStop> {
        halts(self.settings(), &self.interpreter.block.m).then(|| at_stop(&self.settings().machine))
    }

    /// Whether an M function of it breaks continuous motion at its start.
    pub fn break_cont(&self) -> bool {
        self.interpreter.block.m.break_cont
    }

    /// Whether an M function of it breaks continuous motion at its end.
    pub fn break_cont_end(&self) -> bool {
        self.interpreter.block.m.break_cont_end
    }

    /// Whether an M function of it moves the machine.
    pub fn change_pos(&self) -> bool {
        self.interpreter.block.m.moves_before || self.interpreter.block.m.moves_after
    }

    /// The gear in force, 1–4 (MFN-9).
    pub const fn gear(&self) -> Option<u8> {
        self.interpreter.state.gear
    }

    /// How it moves.
    pub fn motion(&self) -> Option<Motion<'r>> {
        let block = &self.interpreter.block;
        match &block.effect {
            Effect::Motion(moving) => Some(Motion { moving, travels: &block.travels }),
            Effect::None | Effect::Data(_) => None,
        }
    }

    /// Where an axis is after it, in programmed coordinates; `None` when that is not known.
    pub fn position(&self, axis: AxisLetter) -> Option<Micro> {
        let place = self.settings().machine.axes.index(axis)?;
        self.interpreter.state.position(place).known()
    }

    /// F in force.
    pub fn feed(&self) -> Option<Feed> {
        let value = self.interpreter.state.feed.value()?;
        Some(Feed { value, unit: self.feed_unit(), hundredth: self.interpreter.state.feed_reduced })
    }

    /// What F counts in this block, or would count (TEC-1): degrees when only rotary axes or the spindle move, per
    /// minute when the spindle does (MFN-10).
    pub fn feed_unit(&self) -> FeedUnit {
        match self.motion().filter(Motion::is_in_degrees) {
            Some(motion) if motion.spindle_axis().is_some() => FeedUnit::DegPerMinute,
            motion => FeedUnit::of(self.feed_mode().map_or(FeedPer::Minute, |mode| mode.per), motion.is_some()),
        }
    }

    /// The meaning of the G6 function in force; `None` when it is not known which one that is.
    pub fn feed_mode(&self) -> Option<FeedMode> {
        self.g(GGroup::G6).and_then(|function| self.settings().machine.feed_mode(function))
    }

    /// Whether the machine moves at a hundredth of F (M37, TEC-6).
    pub const fn feed_is_hundredth(&self) -> bool {
        self.interpreter.state.feed_reduced
    }

    /// The line of a place in the program or a macrocycle, from 1.
    pub fn line_of(&self, at: Location) -> u32 {
        self.program.resolved.file(at.file).map_or(1, |file| small(file.source.lines().line_at(at.span.start) + 1))
    }

    /// RevFeed: F counts per revolution of the spindle.
    pub fn rev_feed(&self) -> bool {
        self.feed_mode().is_some_and(|mode| match mode.per {
            FeedPer::Minute => false,
            FeedPer::Revolution => true,
        })
    }

    /// ConstCutSpeed: the cutting speed is constant.
    pub fn const_cut_speed(&self) -> bool {
        self.feed_mode().is_some_and(|mode| mode.constant_cut)
    }

    /// S in force.
    pub fn s(&self) -> Option<Decimal> {
        self.interpreter.state.speed.value()
    }

    /// T in force.
    pub fn t(&self) -> Option<Decimal> {
        self.interpreter.state.tool.value()
    }

    /// The tool in the spindle: T at the last M06 (TEC-4). `None` before the first M06.
    pub fn tool(&self) -> Option<Decimal> {
        self.interpreter.state.in_spindle.value()
    }

    /// H in force.
    pub fn h(&self) -> Option<Decimal> {
        self.interpreter.state.h.value()
    }

    /// P in force.
    pub fn p(&self) -> Option<Decimal> {
        self.interpreter.state.p.value()
    }

    /// D in force.
    pub fn d(&self) -> Option<Decimal> {
        self.interpreter.state.d.value()
    }

    /// Whether a word of that address is written in it. Of G and M words, ask [`Self::g_written`] and
    /// [`Self::m_written`].
    pub fn written(&self, address: Address) -> bool {
        let block = self.interpreter.block.id;
        self.file().is_some_and(|file| file.words(block).iter().any(|word| word.address == address))
    }

    /// The four digits of `&` in force, as a number.
    pub fn length_correction(&self) -> Option<u16> {
        let digits = self.interpreter.state.correction.value().and_then(Decimal::as_whole);
        digits.and_then(|digits| u16::try_from(digits).ok())
    }

    /// The dwell of G04, in seconds (GRP-5).
    pub fn dwell(&self) -> Option<Micro> {
        dwell(&self.interpreter.block.words)
    }

    /// Whether it holds M00.
    pub fn stop(&self) -> bool {
        self.interpreter.block.m.stop == Some(PROGRAM_STOP)
    }

    /// Whether it holds M01; with optional stop that halts, see [`Self::m_at_stop`].
    pub fn cond_stop(&self) -> bool {
        self.interpreter.block.m.stop == Some(OPTIONAL_STOP)
    }

    /// ContinuousMode: G23 in force.
    pub fn continuous_mode(&self) -> bool {
        self.g(GGroup::G2) == Some(GCode::G23)
    }

    /// The dynamic set that holds in G23, 1–4; `None` when that is not known (GRP-7).
    pub fn dynamic_set(&self) -> Option<u8> {
        self.interpreter.state.dynamic_set
    }

    /// Its words that are data (GRP-4).
    pub fn data(&self) -> Option<Data<'r>> {
        let block = &self.interpreter.block;
        match block.effect {
            Effect::Data(data) => Some(Data { g: data.g, origin: data.origin, d: data.d, values: &block.values }),
            Effect::None | Effect::Motion(_) => None,
        }
    }

    /// I, J and K as written, where they are no centre of an arc (GRP-8).
    pub fn words(&self) -> &'r [(char, Decimal)] {
        &self.interpreter.block.centers
    }

    /// The parameters that it wrote, ascending, with their values after its arithmetic; without those not known.
    pub fn params(&self) -> &'r [(u8, Decimal)] {
        &self.interpreter.block.params
    }

    /// The texts of its comments, trimmed; empty ones left out.
    pub fn comments(&self) -> impl Iterator<Item = &'r str> + use<'r> {
        let block = self.interpreter.block.id;
        // Nearly no block of a long program has one, and whose they are is looked up.
        let comments = self
            .file()
            .filter(|file| file.flags(block).has(BlockFlags::COMMENT))
            .into_iter()
            .flat_map(move |file| file.comments(block).iter().map(move |comment| file.comment_text(*comment)));
        comments.filter(|text| !text.is_empty())
    }

    /// The value of a parameter after it; `None` when that is not known (PAR-5).
    pub fn parameter(&self, index: u8) -> Option<Decimal> {
        self.interpreter.parameter(index)
    }

    /// The configuration that it was executed with.
    pub const fn settings(&self) -> &'r Settings {
        self.program.settings
    }

    /// The index that streams give to a file with executed blocks; 0 for another.
    pub fn index_of(&self, file: FileId) -> u32 {
        self.interpreter.shown_files.get(file.0 as usize).copied().flatten().unwrap_or(0)
    }

    /// An interpreter behind this block, from which execution can go on.
    pub fn checkpoint(&self) -> Interpreter {
        self.interpreter.clone()
    }

    /// The state after it.
    pub const fn state(&self) -> &'r State {
        &self.interpreter.state
    }

    /// Whether it differs from the block executed before it in place, motion, positions and comments alone: a reader
    /// that keeps what it made of that one need not make the rest anew.
    pub(crate) const fn moves_on(&self) -> bool {
        self.interpreter.block.moves_on
    }

    fn flags(&self) -> BlockFlags {
        self.file().map(|file| file.flags(self.interpreter.block.id)).unwrap_or_default()
    }
}
