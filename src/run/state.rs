//! Everything that execution knows between two blocks.

use std::collections::BTreeSet;

use super::unknown::Groups;
use crate::config::{Machine, Settings};
use crate::dict::{
    Address, Decimal, FIRST_DYNAMIC_SET, FeedPer, GCode, GGroup, M_GROUPS, Micro, SPINDLE_GROUP, SPINDLE_STOP,
};
use crate::resolve::Unit;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::{FileId, Location};

/// What is known of an axis's position.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) enum Position {
    /// Nothing yet, or nothing any more (MOT-2, MOT-7, MFN-4).
    #[default]
    Unknown,
    /// It depends on a parameter that only the machine knows (PAR-5): no finding follows from that.
    Undetermined,
    /// There.
    Known(Micro),
}

impl Position {
    pub(super) const fn known(self) -> Option<Micro> {
        match self {
            Self::Known(value) => Some(value),
            Self::Unknown | Self::Undetermined => None,
        }
    }
}

/// Where a parameter got its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Origin {
    /// Nowhere: the machine's table has it.
    Machine,
    /// The configuration or the command line.
    Configured,
    /// A word of the program.
    Word(Location),
}

/// A parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parameter {
    /// `None`: not known (PAR-5).
    pub(super) value: Option<Decimal>,
    pub(super) origin: Origin,
}

/// A value that stays until changed: not yet programmed, programmed but unknown, or known.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) enum Held {
    #[default]
    None,
    Undetermined,
    Value(Decimal),
}

impl Held {
    pub(super) const fn value(self) -> Option<Decimal> {
        match self {
            Self::Value(value) => Some(value),
            Self::None | Self::Undetermined => None,
        }
    }

    pub(super) const fn of(value: Option<Decimal>) -> Self {
        match value {
            Some(value) => Self::Value(value),
            None => Self::Undetermined,
        }
    }
}

/// Places that texts of findings name.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Origins {
    /// The F in force.
    pub(super) feed: Option<Location>,
    /// The number of the block that wrote the G0 function in force, and its word.
    pub(super) motion: Option<(u32, Location)>,
    /// The M function that moved the machine last (MFN-4), and its word.
    pub(super) moved: Option<(u8, Location)>,
}

impl Origins {
    /// A block writes a G0 function, in force from it on.
    #[inline]
    pub(super) fn note_motion(&mut self, file: &ParsedFile, block: BlockId, word: Word) {
        self.motion = Some((file.shown_number(block), file.word_place(word)));
    }
}

/// Axes, a bit for each place in machine order.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct AxisSet(u16);

impl AxisSet {
    /// Every axis.
    pub(super) const ALL: Self = Self(u16::MAX);

    /// Whether no axis is in it.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The places of its axes.
    pub fn places(self) -> impl Iterator<Item = usize> {
        let mut left = self.0;
        std::iter::from_fn(move || {
            let place = left.trailing_zeros() as usize;
            left &= left.wrapping_sub(1);
            (place < 16).then_some(place)
        })
    }

    /// Gives whether it was not in the set.
    pub(super) const fn insert(&mut self, axis: usize) -> bool {
        let new = !self.contains(axis);
        self.0 |= 1 << axis;
        new
    }

    pub(super) const fn remove(&mut self, axis: usize) {
        self.0 &= !(1 << axis);
    }

    /// Whether the axis at a place in machine order is in it.
    pub const fn contains(self, axis: usize) -> bool {
        self.0 & (1 << axis) != 0
    }
}

impl FromIterator<usize> for AxisSet {
    fn from_iter<I: IntoIterator<Item = usize>>(axes: I) -> Self {
        let mut set = Self::default();
        axes.into_iter().for_each(|axis| _ = set.insert(axis));
        set
    }
}

/// Words of the spindle in a program and the macrocycles that it names.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) struct SpindleWords {
    /// M03, M04, M05, M19 or S.
    pub(super) any: bool,
    /// S.
    pub(super) speed: bool,
}

/// The block that something was said of last. Where the next one has it for the same reason, it is not said again.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LastBlock(Option<(FileId, BlockId)>);

impl LastBlock {
    /// Whether this was said of the block before `block`; notes it of this one.
    pub(super) fn goes_on(&mut self, file: FileId, block: BlockId) -> bool {
        let before = self.0.replace((file, block));
        before.is_some_and(|(last_file, last)| last_file == file && last.next() == block)
    }
}

/// Findings that come once, and were given already.
#[derive(Clone, Debug)]
pub(super) struct Said {
    /// A working motion without F (TEC-2).
    pub(super) feed: bool,
    /// A working motion without S (TEC-3).
    pub(super) speed: bool,
    /// W0615, for the F in force.
    pub(super) feed_unit: bool,
    /// W0622.
    pub(super) speed_zero: bool,
    /// W0618.
    pub(super) no_entry: bool,
    /// W0619.
    pub(super) spindle_stopped: bool,
    /// W0620.
    pub(super) no_tool: bool,
    /// An arc that fits under the other of G90 and G91 (E0603), until one of them is written, an arc fits under the one
    /// in force or under neither, or a unit is called.
    pub(super) arc_mode: bool,
    /// Axes that were unknown at the start of an arc (W0606) and have not moved since.
    pub(super) arc_starts: AxisSet,
    /// The axes of the last arc that lay in other axes than those of the plane in force (W0616), until a plane is
    /// written.
    pub(super) other_axes: Option<[usize; 2]>,
    /// E0602, or E0611 of an arc without I and J.
    pub(super) no_center: LastBlock,
    /// E0609 of I, J and K that no function takes.
    pub(super) stray_centers: LastBlock,
    /// An axis moved from an unknown position (MOT-2), by place in machine order.
    pub(super) incremental: [bool; 9],
    /// Macrocycles that execution did not find, by number.
    pub(super) no_macrocycle: BTreeSet<u32>,
    /// Macrocycles that only the machine has, by number (FLW-12).
    pub(super) of_machine: BTreeSet<u32>,
    /// Functions that are not modelled (GRP-8).
    pub(super) unmodelled: Vec<GCode>,
    /// Parameters that were read before the program assigned them (PAR-5).
    pub(super) read_outside: [bool; 96],
    /// Codes of operations that are not configured (PAR-9).
    pub(super) operations: BTreeSet<i64>,
}

impl Default for Said {
    fn default() -> Self {
        Self {
            feed: false,
            speed: false,
            feed_unit: false,
            speed_zero: false,
            no_entry: false,
            spindle_stopped: false,
            no_tool: false,
            arc_mode: false,
            arc_starts: AxisSet::default(),
            other_axes: None,
            no_center: LastBlock::default(),
            stray_centers: LastBlock::default(),
            incremental: [false; 9],
            no_macrocycle: BTreeSet::new(),
            of_machine: BTreeSet::new(),
            unmodelled: Vec::new(),
            read_outside: [false; 96],
            operations: BTreeSet::new(),
        }
    }
}

/// Whether a G53 in place of a zero offset of the work, written with Z alone as other controls retract, is in force.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Retracted {
    /// No.
    No,
    /// It is, and the program has not worked since.
    ByG53,
    /// It is, and the program works by it, which was said.
    Said,
}

/// The state between two blocks.
#[derive(Clone, Debug)]
pub struct State {
    /// Lasting G functions, by group.
    pub(super) g: [Option<GCode>; 12],
    /// Groups of which nobody knows the function, after a fault, until it is written again.
    pub(super) unknown: Groups,
    /// M functions in force, by group.
    pub(super) m: [Option<u8>; M_GROUPS],
    /// By place in machine order.
    pub(super) positions: [Position; 9],
    pub(super) parameters: [Parameter; 96],
    pub(super) feed: Held,
    pub(super) speed: Held,
    pub(super) tool: Held,
    /// T at the last M06 (TEC-4).
    pub(super) in_spindle: Held,
    pub(super) h: Held,
    pub(super) p: Held,
    pub(super) d: Held,
    /// The digits of `&` (§2).
    pub(super) correction: Held,
    /// GRP-7; `None`: not known.
    pub(super) dynamic_set: Option<u8>,
    /// START orients the spindle before the next block (MFN-10).
    pub(super) orients: bool,
    /// The axes that a macrocycle of the machine may move before the next block (FLW-12).
    pub(super) moved_unseen: AxisSet,
    /// The axes whose programmed position is not where the tool stands (MOT-8).
    pub(super) unsettled: AxisSet,
    /// Per minute or per revolution: how the F in force was written; `None` when not known (W0615).
    pub(super) feed_per: Option<FeedPer>,
    /// F counts a hundredth (M37, TEC-6), in the current block, before M02 and M30 reset it.
    pub(super) feed_reduced: bool,
    /// The gear of the block before (MFN-6).
    pub(super) gear: Option<u8>,
    /// The program's words of the spindle, once they were looked up (TEC-7, TEC-8).
    pub(super) spindle_words: Option<SpindleWords>,
    /// The G3 function that was changed to, until the next motion (TEC-9).
    pub(super) corrects: Option<GCode>,
    /// The T that no M06 followed so far, and its word (W0628).
    pub(super) named_tool: Option<(Decimal, Location)>,
    /// Whether a G53 that is written for one block is in force (W0116).
    pub(super) retracted: Retracted,
    /// G53 is an origin of the work: the program wrote it by G92, or worked by it without retracting under it.
    pub(super) works_by_g53: bool,
    /// A stream is written: a parameter without a value ends it (PAR-5).
    pub(super) compiled: bool,
    /// For texts.
    pub(super) origins: Origins,
    /// The G5 and G11 functions of the block before, x functions included (MOT-8).
    pub(super) last_origin: (Option<GCode>, Option<GCode>),
    pub(super) said: Said,
}

impl State {
    /// Whether the machine moves at a hundredth of F (M37, TEC-6).
    pub const fn feed_is_hundredth(&self) -> bool {
        self.feed_reduced
    }

    /// After power-up.
    pub fn new(settings: &Settings) -> Self {
        let machine = &settings.machine;
        let mut parameters = [Parameter { value: None, origin: Origin::Machine }; 96];
        for (&index, &value) in &machine.parameters {
            if let Some(parameter) = parameters.get_mut(usize::from(index)) {
                *parameter = Parameter { value: Some(value), origin: Origin::Configured };
            }
        }
        let mut positions = [Position::Unknown; 9];
        for (letter, value) in &machine.start {
            if let Some(slot) = machine.axes.index(*letter).and_then(|axis| positions.get_mut(axis)) {
                *slot = Position::Known(Micro::from(*value));
            }
        }
        let mut state = Self {
            g: machine.power_up,
            unknown: Groups::default(),
            m: machine.m_power_up,
            positions,
            parameters,
            feed: Held::None,
            speed: Held::None,
            tool: Held::None,
            in_spindle: Held::None,
            h: Held::None,
            p: Held::None,
            d: Held::None,
            correction: Held::None,
            dynamic_set: Some(FIRST_DYNAMIC_SET),
            orients: false,
            moved_unseen: AxisSet::default(),
            unsettled: AxisSet::default(),
            feed_per: None,
            feed_reduced: false,
            gear: None,
            spindle_words: None,
            corrects: None,
            named_tool: None,
            retracted: Retracted::No,
            works_by_g53: false,
            compiled: false,
            origins: Origins::default(),
            last_origin: (None, None),
            said: Said::default(),
        };
        state.last_origin = (state.modal(GGroup::G5), state.modal(GGroup::G11));
        state
    }

    /// The lasting function of a group.
    pub(super) fn modal(&self, group: GGroup) -> Option<GCode> {
        self.g.get(group.index()).copied().flatten().filter(|_| !self.unknown.has(group))
    }

    pub(super) fn set_modal(&mut self, code: GCode) {
        self.unknown = self.unknown.without(code.group());
        if let Some(slot) = self.g.get_mut(code.group().index()) {
            *slot = Some(code);
        }
    }

    pub(super) fn position(&self, axis: usize) -> Position {
        self.positions.get(axis).copied().unwrap_or_default()
    }

    pub(super) fn set_position(&mut self, axis: usize, position: Position) {
        if let Some(slot) = self.positions.get_mut(axis) {
            *slot = position;
        }
        if position != Position::Unknown {
            self.said.arc_starts.remove(axis);
        }
    }

    /// The machine moved, nobody knows where.
    pub(super) fn lose_positions(&mut self) {
        for (axis, position) in self.positions.iter_mut().enumerate() {
            if std::mem::replace(position, Position::Unknown) != Position::Unknown {
                self.said.arc_starts.remove(axis);
            }
        }
    }

    /// Where a macrocycle of the machine left the axes that it may move is not known (FLW-12).
    pub(super) fn lose_moved_unseen(&mut self) {
        if self.moved_unseen.is_empty() {
            return;
        }
        let moved = std::mem::take(&mut self.moved_unseen);
        for axis in (0..self.positions.len()).filter(|axis| moved.contains(*axis)) {
            self.set_position(axis, Position::Undetermined);
        }
    }

    /// A call could not be followed: where the axes are is not known, nor what it may have written first (§13).
    pub(super) fn lose_by_call(&mut self) {
        self.positions = [Position::Undetermined; 9];
        self.said.arc_starts = AxisSet::default();
        self.corrects = None;
        for held in [&mut self.feed, &mut self.speed, &mut self.tool, &mut self.in_spindle, &mut self.d] {
            if *held == Held::None {
                *held = Held::Undetermined;
            }
        }
        if let Some(spindle) = self.m.get_mut(SPINDLE_GROUP) {
            *spindle = spindle.filter(|m| *m != SPINDLE_STOP);
        }
    }

    /// A call ended without the G70 of its unit: what its functions set may have been set back behind them.
    pub(super) fn lose_by_cut(&mut self, file: &ParsedFile, unit: &Unit, machine: &Machine) {
        self.lose_by_call();
        let words = unit.blocks().flat_map(|block| file.words(block));
        let functions = words.filter(|word| matches!(word.address, Address::G | Address::M));
        self.lose_set_by(file, functions, machine);
    }

    /// What words before the first block would have set is not known (BLK-2).
    pub(super) fn lose_set_by<'w>(
        &mut self,
        file: &ParsedFile,
        words: impl IntoIterator<Item = &'w Word>,
        machine: &Machine,
    ) {
        for word in words {
            let Self { feed, speed, tool, h, p, d, .. } = self;
            let held = [
                (Address::F, feed),
                (Address::S, speed),
                (Address::T, tool),
                (Address::H, h),
                (Address::P, p),
                (Address::D, d),
            ];
            let of_word = held.into_iter().filter(|(address, _)| *address == word.address);
            of_word.for_each(|(_, held)| *held = Held::Undetermined);
            if word.address == Address::G {
                let groups = word.g_code().map_or_else(Groups::lasting, |code| Groups::default().with(code.group()));
                self.unknown = self.unknown.and(groups);
            } else if word.address == Address::M {
                (self.m, self.in_spindle) = ([None; M_GROUPS], Held::Undetermined);
            } else if word.address == Address::R {
                if let Some(slot) = self.parameters.get_mut(usize::from(word.target())) {
                    *slot = Parameter { value: None, origin: Origin::Word(file.word_place(*word)) };
                }
            } else if let Some(axis) = machine.axes.index_of(word.address) {
                self.set_position(axis, Position::Undetermined);
            }
        }
    }

    /// The function of an M group.
    pub(super) fn m(&self, group: usize) -> Option<u8> {
        self.m.get(group).copied().flatten()
    }
}
