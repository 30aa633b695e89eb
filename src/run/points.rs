//! Blocks of axis words and nothing else but, again, the G00 or G01 in force: nearly all blocks of long programs. What
//! they do follows from what is in force, which is looked up once for a run of them; the rules of motion are those of
//! every block.

use super::arrival::{arrive, is_silent};
use super::block::{Block, Effect};
use super::frames::Frame;
use super::interpreter::Stretch;
use super::motion::{kind_in_force, settle_origin};
use super::moved::{MotionType, Moving};
use super::passed::{Points, last_words};
use super::program::Program;
use super::site::Site;
use super::state::{AxisSet, State};
use super::travel::{Reading, Travel};
use super::warnings::may_lack;
use super::words::Valued;
use super::{functions, m_functions, spindle};
use crate::dict::{Address, GCode, GGroup};
use crate::syntax::{BlockFlags, BlockId};

/// What blocks of axis words do while no other word comes between them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Run {
    /// Not known: the block before may have changed what is in force.
    #[default]
    Unknown,
    /// More than move straight.
    Involved,
    /// They move straight, and nothing but positions changes.
    Straight(Moving, Reading),
}

impl Run {
    /// Executes a point, with the function that it writes, when it only moves axes straight. `false`: it does more, and
    /// nothing is done yet.
    #[inline]
    pub(super) fn execute(
        &mut self,
        site: &mut Site<'_>,
        state: &mut State,
        block: &mut Block,
        written: Option<GCode>,
    ) -> bool {
        if written.is_some() && written != state.modal(GGroup::G0) {
            return false;
        }
        let settled = !matches!(self, Self::Unknown);
        if !settled {
            *self = Self::settle(site, state, block);
        }
        let Self::Straight(moving, reading) = *self else { return false };
        if !read_travels(site, state, reading, &mut block.travels) {
            return false;
        }
        let stale = settle_origin(state, &block.travels, None);
        let moving = Moving { stale, ..moving };
        block.effect = Effect::Motion(moving);
        // The unit of the feed may differ from the point before.
        let degrees = moving.is_in_degrees(&block.travels);
        let word = written.and_then(|function| Some((function, site.file.g_word(site.block)?)));
        block.moves_on = block.words.write_again(word) && settled && degrees == block.degrees;
        block.degrees = degrees;
        if let Some((_, word)) = word {
            state.origins.note_motion(site.file, site.block, word);
        }
        state.corrects = None;
        arrive(site, state, &block.travels);
        true
    }

    /// Finds out what a block of axis words will do: brings state and block to what a block without words leaves.
    #[inline(never)]
    fn settle(site: &mut Site<'_>, state: &mut State, block: &mut Block) -> Self {
        state.lose_moved_unseen();
        block.clear();
        block.words.clear();
        functions::apply(site, state, &block.words, &mut block.g);
        functions::track_origin(state, &block.words, &block.g);
        m_functions::apply(site, state, &block.words, &block.g, &mut block.m);
        let kind = kind_in_force(&block.g);
        let straight = match kind {
            MotionType::Rapid => true,
            MotionType::Thread => !may_lack(site, state, &block.g, true),
            MotionType::Linear => !may_lack(site, state, &block.g, false),
            MotionType::ArcCw | MotionType::ArcCcw | MotionType::Reference => false,
        };
        let cycle = block.g.of(GGroup::G8).is_some_and(GCode::is_cycle);
        let axis = spindle::axis(site.machine(), state);
        let unknown = !block.g.unknown.is_empty();
        if !straight || cycle || unknown || axis.is_some() || spindle::turns(site.machine(), state) {
            return Self::Involved;
        }
        let moving = Moving { kind, stale: AxisSet::default(), spindle: axis, arc: None };
        Self::Straight(moving, Reading::of(site.machine(), state, &block.g))
    }

    /// Executes the points (see [`BlockFlags::is_point`]) that come next but the last of them, at most `most`, all at
    /// once: axes are where the last word of each has them, when no rule of motion has anything to say of any. With
    /// `None` nothing is done.
    pub(super) fn pass_over(
        self,
        program: &Program<'_>,
        frame: &mut Frame,
        state: &mut State,
        most: u64,
    ) -> Option<Points> {
        let Self::Straight(moving, reading) = self else { return None };
        let machine = &program.settings.machine;
        let points = program.resolved.points(frame.unit.file).filter(|points| points.are_right())?;
        let file = program.resolved.file(frame.unit.file)?;
        // A word of an axis that moves by its value says nothing of where the axis is then.
        if reading.is_incremental() || !is_silent(machine, reading) {
            return None;
        }
        let first = frame.next;
        let most = u32::try_from(most).unwrap_or(u32::MAX).saturating_add(1);
        let before = BlockId(frame.unit.end.0.min(first.0.saturating_add(most)));
        let in_force = state.modal(GGroup::G0).map_or(BlockFlags::default(), BlockFlags::of_straight);
        let passed = file.points_in_a_row(first, before, in_force).saturating_sub(1);
        if passed == 0 {
            return None;
        }
        frame.next = BlockId(first.0 + passed);
        let has_function = points.may_have(Address::G) && in_force != BlockFlags::default();
        let function = if has_function { file.last_straight(first..frame.next, in_force) } else { None };
        if let Some((block, word)) = function {
            state.origins.note_motion(file, block, word);
        }
        let (positions, unsettled) = (state.positions, state.unsettled);
        let addresses = Address::ALL.iter().filter(|address| points.may_have(**address));
        let axes = addresses.filter_map(|address| machine.axes.index_of(*address)).collect();
        let last = last_words(file, machine, first..frame.next, axes);
        for (axis, last) in last.iter().enumerate() {
            let Some((_, word)) = last else { continue };
            state.set_position(axis, reading.target(axis, word.number()));
            state.unsettled.remove(axis);
        }
        let last = last.map(|last| last.map(|(block, _)| block));
        let stretch = Stretch { file: frame.unit.file, first, end: frame.next };
        let function = function.map(|(block, _)| block);
        Some(Points { stretch, kind: moving.kind, reading, positions, unsettled, last, function })
    }

    /// Forgets the facts about blocks of axis words after a block that did more.
    #[inline]
    pub(super) fn unsettle(&mut self, flags: BlockFlags, block: &Block) {
        // Such a block has no G, M or other word that changes what is in force.
        let plain = !flags.has(BlockFlags::RICH) && flags.straight().is_none();
        let lasts = matches!(self, Self::Involved) && plain && block.words.f.is_none() && block.words.s.is_none();
        if !lasts {
            *self = Self::Unknown;
        }
    }
}

/// The motions of a block's words. `false`: there is another word.
#[inline]
fn read_travels(site: &Site<'_>, state: &State, reading: Reading, travels: &mut Vec<Travel>) -> bool {
    travels.clear();
    let machine = site.machine();
    for &word in site.file.words(site.block) {
        // The function in force.
        if word.address == Address::G {
            continue;
        }
        let Some(axis) = machine.axes.index_of(word.address) else { return false };
        let valued = Valued { word, value: word.number() };
        let Some(travel) = reading.travel(machine, state, axis, valued) else { return false };
        // In machine order.
        if travels.last().is_none_or(|last| last.axis < axis) {
            travels.push(travel);
            continue;
        }
        let at = travels.partition_point(|known| known.axis < axis);
        match travels.get_mut(at) {
            // Nobody knows which of the two was meant.
            Some(known) if known.axis == axis => return false,
            _ => travels.insert(at, travel),
        }
    }
    !travels.is_empty()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::path::Path;
    use std::sync::Arc;

    use proptest::prelude::*;

    use super::*;
    use crate::config::{Axes, Axis, Settings};
    use crate::diag::Findings;
    use crate::dict::{Decimal, Micro};
    use crate::resolve::{Library, resolve};
    use crate::run::{Interpreter, PointPath, Program};
    use crate::text::{MemoryLoader, SourceText, Sources};

    /// The state after each block of a program, how each moves, and the findings.
    fn run(body: &str, by_all_rules: bool) -> (Vec<String>, Vec<String>) {
        let settings = Settings::default();
        with_program(body, &settings, |program, findings| {
            let mut interpreter = Interpreter::new(program);
            let mut known = Vec::new();
            loop {
                if by_all_rules {
                    interpreter.run = Run::Involved;
                }
                let Some(block) = interpreter.step(program, findings) else { break };
                let written = (block.g_written().collect::<Vec<_>>(), block.m_written());
                let facts = (block.motion(), block.feed(), written, block.m_changed(), block.dwell());
                // When the words of the spindle are looked up decides nothing.
                let state = State { spindle_words: None, ..block.state().clone() };
                known.push(format!("{:?} {facts:?} {state:?} {:?}", block.at(), block.data()));
            }
            known
        })
    }

    /// The state at the end of a program, after how many blocks and what path, the last block that moved each axis, and
    /// the findings: with points passed over, at most so many at a time, their path in parts, or without.
    fn end(body: &str, settings: &Settings, most: Option<u64>, parts: u32) -> (String, Vec<String>) {
        with_program(body, settings, |program, findings| {
            let mut interpreter = Interpreter::new(program);
            let (mut path, mut last) = (Micro::ZERO, BTreeMap::new());
            loop {
                if let Some(points) = most.and_then(|most| interpreter.pass_over(program, most)) {
                    let parts = points.path().unwrap().parts(parts);
                    path = parts.into_iter().map(PointPath::length).fold(path, Micro::plus);
                    last.extend(points.axes());
                }
                let Some(block) = interpreter.step(program, findings) else { break };
                path = path.plus(block.motion().and_then(|motion| motion.length().mm()).unwrap_or_default());
                last.extend(
                    block.motion().into_iter().flat_map(|motion| motion.axes()).map(|axis| (axis, block.at().1)),
                );
            }
            let (state, end, executed) = (interpreter.state(), interpreter.end(), interpreter.executed());
            format!("{state:?} {end:?} {executed} {path:?} {last:?}")
        })
    }

    /// What `run` makes of a program, and the findings.
    fn with_program<T>(
        body: &str,
        settings: &Settings,
        run: impl FnOnce(&mut Program<'_>, &mut Findings) -> T,
    ) -> (T, Vec<String>) {
        let loader = MemoryLoader::new();
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\nN1 G54 G90\n{body}\nN9000 M30")));
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let resolved = resolve(&source, None, settings, &mut library, &mut sources, &mut findings);
        let mut program = Program { resolved, settings, library, sources };
        let made = run(&mut program, &mut findings);
        (made, findings.items().iter().map(|finding| format!("{finding:?}")).collect())
    }

    fn body(blocks: &[&str]) -> String {
        blocks.iter().zip(2..).map(|(block, n)| format!("N{n} {block}\n")).collect()
    }

    /// A machine without configured travel, and one with it.
    fn machines() -> [Settings; 2] {
        let (plain, mut limited) = (Settings::default(), Settings::default());
        let limit = Some(Decimal::from_thousandths(4000));
        let axes = limited.machine.axes.iter().map(|axis| Axis { max: limit, ..axis });
        limited.machine.axes = Axes::new(axes.collect::<Vec<_>>());
        [plain, limited]
    }

    const BLOCKS: [&str; 38] = [
        "",
        "F",
        "X1.5",
        "Y-2 X3",
        "Z+3 Y1",
        "X1 A5",
        "X2 Z.5",
        "G0 X3",
        "X4 G1",
        "G01 Y5 Z1",
        "G1 X6 A2",
        "G91",
        "G1 X7 F50",
        "G0 G1 X8",
        "G1 G40 X9",
        "G1. X2",
        "G2 G0 X3",
        "G1 X3 X4",
        "G33 X2 F1",
        "G90",
        "G0",
        "G1",
        "F100 S500 M3",
        "X3 F200",
        "G2 X1 Y1 I1",
        "R1=5",
        "XR1",
        "YR30",
        "G74",
        "G75",
        "G92 X5",
        "G54",
        "G30 Z0",
        "X5 I2",
        "B5 X0",
        "X1 X2",
        "X99999999999",
        "/ X7",
    ];

    /// How many of five points behind one that was executed are passed over.
    fn passed(points: [&str; 6], settings: &Settings) -> u64 {
        let blocks = [&["G90 G0"], points.as_slice()].concat();
        let (passed, _) = with_program(&body(&blocks), settings, |program, findings| {
            let mut interpreter = Interpreter::new(program);
            while interpreter.executed() < 3 {
                interpreter.step(program, findings);
            }
            interpreter.pass_over(program, u64::MAX);
            interpreter.executed() - 3
        });
        passed
    }

    #[test]
    fn points_are_passed_over_where_no_rule_speaks() {
        let [plain, limited] = machines();
        assert_eq!(passed(["X1", "X2", "Y1", "Z1 X5", "X6", "Y7"], &plain), 4);
        assert_eq!(passed(["X1", "X2", "Y1", "F100", "X6", "Y7"], &plain), 1);
        assert_eq!(passed(["X1", "X2", "Y1", "Z1 X5", "X6", "Y7"], &limited), 0);
        assert_eq!(passed(["X1", "X2", "Y1", "X5 X5", "X6", "Y7"], &plain), 0);
        assert_eq!(passed(["X1", "G0 X2", "Y1", "G00 Z1 X5", "X6", "Y7"], &plain), 4);
        assert_eq!(passed(["X1", "G0 X2", "Y1", "G1 Z1 X5", "X6", "Y7"], &plain), 1);
        assert_eq!(passed(["X1", "G0 X2", "Y1", "G0 X5 F1", "X6", "Y7"], &plain), 1);
    }

    proptest! {
        /// Blocks of axis words do what they do by all the rules.
        #[test]
        fn points_follow_all_rules(blocks in proptest::collection::vec(proptest::sample::select(&BLOCKS), 0..30)) {
            let body = body(&blocks);
            let (quick, full) = (run(&body, false), run(&body, true));
            prop_assert!(!quick.0.is_empty());
            prop_assert_eq!(quick, full, "{}", body);
        }

        /// Points that are passed over leave the same state as block by block.
        #[test]
        fn passing_over_leaves_the_same(
            mut blocks in proptest::collection::vec(proptest::sample::select(&BLOCKS), 0..12),
            points in proptest::collection::vec(proptest::sample::select(&BLOCKS[2..11]), 0..12),
            at in 0..12_usize,
            most in 0..12_u64,
            limit in proptest::option::of(0..20_u64),
            parts in 1..5_u32,
        ) {
            let at = at.min(blocks.len());
            blocks.splice(at..at, points);
            let body = body(&blocks);
            for mut settings in machines() {
                settings.machine.limits.records = limit.unwrap_or(settings.machine.limits.records);
                prop_assert_eq!(
                    end(&body, &settings, Some(most), parts),
                    end(&body, &settings, None, parts),
                    "{}", body
                );
            }
        }
    }
}
