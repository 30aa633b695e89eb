//! What executed blocks need of machine, tools and work.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use super::block_name::BlockName;
use super::extents::{Extents, Size, moved_unseen};
use crate::diag::Findings;
use crate::dict::{Address, Decimal, GCode, GGroup, Micro, TOOL_CHANGE};
use crate::run::{End, Executed, FeedUnit, Motion, MotionType, Program, Sink};
use crate::text::{FileId, Location};

/// What stands above the first block.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// The program as the user named it.
    pub name: String,
    /// The number after `%`.
    pub number: Option<u32>,
    /// The title (BLK-9).
    pub title: Option<String>,
    /// The control.
    pub dialect: &'static str,
    /// A lathe: X is given as a diameter.
    pub diameter: bool,
}

/// A path, mm.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Path {
    /// Of the motions whose lengths are known.
    pub length: Micro,
    /// Whether there are others.
    pub lacks: bool,
}

impl Path {
    /// The known part of it; `None`: nothing is known.
    pub fn known(self) -> Option<Micro> {
        (!self.lacks || self.length > Micro::ZERO).then_some(self.length)
    }

    /// Whether it is longer than its known part.
    pub fn is_lower_bound(self) -> bool {
        self.lacks && self.known().is_some()
    }

    fn add(&mut self, motion: &Motion<'_>) {
        if !motion.is_in_degrees() {
            let length = motion.length();
            self.lacks |= length.missing().is_some();
            self.length = self.length.plus(length.mm().unwrap_or_default());
        }
    }
}

/// The use of a tool.
#[derive(Clone, Debug, Default)]
pub struct ToolUse {
    /// The tool in the spindle; none before the first M06.
    pub tool: Option<Decimal>,
    /// The first block with it.
    pub first: BlockName,
    /// How often M06 is executed with it.
    pub changes: u64,
    /// Path of working motion.
    pub working: Path,
    /// Path of G00.
    pub rapid: Path,
    /// Least and greatest F of working motion as it acts, by what it counts.
    pub feeds: BTreeMap<FeedUnit, (Micro, Micro)>,
    /// Least and greatest S of working motion and of fixed cycles, rev/min.
    pub speeds: Option<(Decimal, Decimal)>,
    /// Least and greatest S under constant cutting speed.
    pub cutting_speeds: Option<(Decimal, Decimal)>,
    /// D of working motion.
    pub d: BTreeSet<Decimal>,
    /// Which of F, S and D have values that are not known, besides.
    pub undetermined: BTreeSet<Address>,
    /// How far working motion reaches.
    pub extents: Extents,
}

/// An M function.
#[derive(Clone, Copy, Debug)]
pub struct MUse {
    /// How often it is executed.
    pub count: u64,
    /// The first block with it.
    pub first: BlockName,
}

/// A parameter that the program reads before it gives it a value.
#[derive(Clone, Copy, Debug)]
pub struct ParameterUse {
    /// The value that it holds at the start, if one was given.
    pub value: Option<Decimal>,
    /// The first block that reads it.
    pub first: BlockName,
}

/// A subprogram or macrocycle.
#[derive(Clone, Copy, Debug)]
pub struct UnitUse {
    /// Its number.
    pub l: u32,
    /// Whether it is a macrocycle.
    pub macrocycle: bool,
    /// How often it runs.
    pub runs: u64,
}

/// The set-up sheet, without times.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// What stands above the first block.
    pub head: Head,
    /// How far it goes.
    pub size: Size,
    /// Tools in the order in which they come into the spindle.
    pub tools: Vec<ToolUse>,
    /// M functions by number.
    pub m_functions: BTreeMap<u8, MUse>,
    /// Parameters that the machine must hold.
    pub parameters: BTreeMap<u8, ParameterUse>,
    /// Subprograms and macrocycles, in the order in which they run first.
    pub units: Vec<UnitUse>,
}

/// A pass of a call: where it is made, of what, and which pass.
type Pass = (Location, u32, u32);

/// Reads executed blocks for the set-up sheet.
#[derive(Debug, Default)]
pub struct SheetReader {
    sheet: Sheet,
    /// The tool in the spindle, by place in the sheet.
    tool: Option<usize>,
    /// Passes that are open.
    open: Vec<Pass>,
}

impl SheetReader {
    /// Nothing is read yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Counts the passes that begin with a block.
    fn calls(&mut self, block: &Executed<'_>) {
        let mut depth = 0;
        for call in block.calls() {
            let pass = (call.at, call.l, call.pass);
            if self.open.get(depth) != Some(&pass) {
                self.open.truncate(depth);
                self.open.push(pass);
                count_runs(&mut self.sheet.units, call.l, call.by.is_macrocycle(), 1);
            }
            depth += 1;
        }
        self.open.truncate(depth);
        if let Some(l) = block.opaque_call() {
            count_runs(&mut self.sheet.units, l, true, block.call_count().into());
        }
    }

    /// Reads the words of a block.
    fn words(&mut self, block: &Executed<'_>) {
        for number in block.m_written() {
            let known = self.sheet.m_functions.entry(*number);
            let known = known.or_insert_with(|| MUse { count: 0, first: BlockName::of(block) });
            known.count += 1;
        }
        if !block.has_parameters() {
            return;
        }
        for index in (0..96).filter(|index| block.state().is_read_from_machine(*index)) {
            let value = block.settings().machine.parameters.get(&index).copied();
            let known = self.sheet.parameters.entry(index);
            known.or_insert_with(|| ParameterUse { value, first: BlockName::of(block) });
        }
    }

    /// The tool of a block.
    fn tool(&mut self, block: &Executed<'_>) -> Option<&mut ToolUse> {
        let tool = block.tool();
        let tools = &mut self.sheet.tools;
        let same = self.tool.filter(|at| tools.get(*at).is_some_and(|known| known.tool == tool));
        let at = match same.or_else(|| tools.iter().position(|known| known.tool == tool)) {
            Some(at) => at,
            None => {
                tools.push(ToolUse { tool, first: BlockName::of(block), ..ToolUse::default() });
                tools.len() - 1
            }
        };
        self.tool = Some(at);
        tools.get_mut(at)
    }

    /// Where a fixed cycle that is not mapped leads, or a macrocycle of the machine, and how far, nobody knows.
    fn unknown_motion(&mut self, block: &Executed<'_>) {
        let letters = moved_unseen(block);
        if letters.is_empty() {
            return;
        }
        let name = BlockName::of(block);
        if let Some(tool) = self.tool(block) {
            letters.iter().for_each(|letter| tool.extents.lack(*letter, name));
            tool.working.lacks = true;
            tool.rapid.lacks = true;
            tool.cuts(block);
        }
    }

    fn motion(&mut self, block: &Executed<'_>, motion: &Motion<'_>) {
        self.sheet.head.diameter |= block.g(GGroup::G10) == Some(GCode::G74);
        let kind = motion.kind();
        let Some(tool) = self.tool(block) else { return };
        match kind {
            MotionType::Rapid => tool.rapid.add(motion),
            MotionType::Linear | MotionType::ArcCw | MotionType::ArcCcw => {
                tool.working.add(motion);
                tool.extents.add_motion(motion, block);
                tool.extents.add_standing(block, motion);
            }
            MotionType::Thread | MotionType::Reference => {}
        }
        // F, S and D are those of the block before.
        if kind != MotionType::Rapid && kind != MotionType::Reference && !block.moves_on() {
            tool.cuts(block);
        }
    }
}

/// Counts runs of a subprogram or macrocycle.
fn count_runs(units: &mut Vec<UnitUse>, l: u32, macrocycle: bool, runs: u64) {
    match units.iter_mut().find(|unit| unit.l == l && unit.macrocycle == macrocycle) {
        Some(unit) => unit.runs += runs,
        None => units.push(UnitUse { l, macrocycle, runs }),
    }
}

impl ToolUse {
    /// Takes up F, S and D of a block that cuts.
    fn cuts(&mut self, block: &Executed<'_>) {
        // That of a thread is its pitch, which is no feed per minute, and which M37 does not reduce.
        let threads = block.motion().is_some_and(|motion| motion.kind() == MotionType::Thread);
        if let Some(feed) = block.feed().filter(|feed| !threads || feed.unit == FeedUnit::MmPerRevolution) {
            let value = Micro::from(feed.value);
            let value = if feed.hundredth && !threads { value.hundredth() } else { value };
            let (least, greatest) = self.feeds.entry(feed.unit).or_insert((value, value));
            *least = (*least).min(value);
            *greatest = (*greatest).max(value);
        }
        if let Some(s) = block.s() {
            let speeds = if block.const_cut_speed() { &mut self.cutting_speeds } else { &mut self.speeds };
            let (least, greatest) = speeds.unwrap_or((s, s));
            *speeds = Some((least.min(s), greatest.max(s)));
        }
        self.d.extend(block.d().filter(|d| *d != Decimal::ZERO));
        let cutting = [Address::F, Address::S, Address::D];
        self.undetermined.extend(block.state().undetermined().filter(|address| cutting.contains(address)));
    }
}

impl Sink for SheetReader {
    type Whole = Sheet;

    fn begin(&mut self, program: &Program<'_>) {
        let file = program.resolved.file(FileId(0));
        let number = file.and_then(|file| file.program).and_then(|word| word.whole());
        self.sheet.head = Head {
            name: program.name().to_owned(),
            number: number.and_then(|number| u32::try_from(number).ok()),
            title: file.and_then(|file| file.title.map(|title| file.comment_text(title).to_owned())),
            dialect: program.settings.machine.dialect.name(),
            diameter: program.settings.machine.power_up.contains(&Some(GCode::G74)),
        };
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.sheet.size.add(block);
        if block.moves_on()
            && let Some(motion) = block.motion()
        {
            self.motion(block, &motion);
            return ControlFlow::Continue(());
        }
        self.calls(block);
        self.words(block);
        if block.tool().is_some()
            && block.m_written().contains(&TOOL_CHANGE)
            && let Some(tool) = self.tool(block)
        {
            tool.changes += 1;
        }
        match block.motion() {
            Some(motion) => self.motion(block, &motion),
            None => {
                // The place of the tool in the order is that of its change.
                if block.tool().is_some() {
                    self.tool(block);
                }
            }
        }
        self.unknown_motion(block);
        ControlFlow::Continue(())
    }

    fn end(mut self, _: End, _: &mut Findings) -> Sheet {
        let Sheet { size, tools, .. } = &mut self.sheet;
        tools.iter_mut().for_each(|tool| tool.extents.end(&size.all));
        size.end();
        if self.sheet.head.diameter {
            let tools = self.sheet.tools.iter_mut().map(|tool| &mut tool.extents);
            let Size { working, all } = &mut self.sheet.size;
            [working, all].into_iter().chain(tools).for_each(Extents::in_diameters);
        }
        self.sheet
    }
}
