//! Blocks of axis words and nothing else: nearly all blocks of long programs. What they do follows from what is in force,
//! which is looked up once for a run of them; the rules of motion are those of every block.

use super::block::{Block, Effect};
use super::motion::{arrive, kind_in_force, settle_origin};
use super::moved::{MotionType, Moving};
use super::site::Site;
use super::state::State;
use super::travel::{Reading, Travel};
use super::warnings::may_lack;
use super::words::Valued;
use super::{functions, m_functions, spindle};
use crate::dict::{GCode, GGroup};
use crate::syntax::BlockFlags;

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
    /// Executes a block that has no G, M, L, Q, R, `/` or `&` word and no parameter, when it only moves axes straight.
    /// `false`: it does more, and nothing is done yet.
    #[inline]
    pub(super) fn execute(&mut self, site: &mut Site<'_>, state: &mut State, block: &mut Block) -> bool {
        let settled = !matches!(self, Self::Unknown);
        if !settled {
            *self = Self::settle(site, state, block);
        }
        let Self::Straight(moving, reading) = *self else { return false };
        if !read_travels(site, state, reading, &mut block.travels) {
            return false;
        }
        let stale = settle_origin(state, &block.travels, None);
        block.effect = Effect::Motion(Moving { stale, ..moving });
        // What the feed counts may differ from the point before.
        let degrees = moving.is_in_degrees(&block.travels);
        block.moves_on = settled && degrees == block.degrees;
        block.degrees = degrees;
        arrive(site, state, &block.travels, true);
        true
    }

    /// Finds out what a block of axis words will do: brings state and block to what a block without words leaves.
    #[inline(never)]
    fn settle(site: &mut Site<'_>, state: &mut State, block: &mut Block) -> Self {
        block.clear();
        block.words.clear();
        block.g = functions::apply(site, state, &block.words);
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
        let moving = Moving { kind, stale: false, spindle: axis, arc: None };
        Self::Straight(moving, Reading::of(site.machine(), state, &block.g))
    }

    /// What is known of the blocks of axis words after a block that did more.
    #[inline]
    pub(super) fn unsettle(&mut self, flags: BlockFlags, block: &Block) {
        // A block that is not rich has no G, M or other word that changes what is in force.
        let plain = !flags.has(BlockFlags::RICH);
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
    use std::path::Path;
    use std::sync::Arc;

    use proptest::prelude::*;

    use super::*;
    use crate::config::Settings;
    use crate::diag::Findings;
    use crate::resolve::{Library, resolve_program};
    use crate::run::{Interpreter, Program};
    use crate::text::{MemoryLoader, SourceText, Sources};

    /// What is known after each block of a program, how each moves, and the findings.
    fn run(body: &str, by_all_rules: bool) -> (Vec<String>, Vec<String>) {
        let (loader, settings) = (MemoryLoader::new(), Settings::default());
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\nN1 G54 G90\n{body}\nN9000 M30")));
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let resolved = resolve_program(&source, &settings, &mut library, &mut sources, &mut findings);
        let mut program = Program { resolved, settings: &settings, library, sources };
        let mut interpreter = Interpreter::new(&program);
        let mut known = Vec::new();
        loop {
            if by_all_rules {
                interpreter.run = Run::Involved;
            }
            let Some(block) = interpreter.step(&mut program, &mut findings) else { break };
            let facts = (block.motion(), block.feed(), block.m_written(), block.m_changed(), block.dwell());
            // When it is looked up whether the program starts the spindle decides nothing.
            let state = State { turns_spindle: None, ..block.state().clone() };
            known.push(format!("{:?} {facts:?} {state:?} {:?}", block.at(), block.data()));
        }
        (known, findings.items().iter().map(|finding| format!("{finding:?}")).collect())
    }

    const BLOCKS: [&str; 24] = [
        "",
        "F",
        "X1.5",
        "Y-2 X3",
        "Z+3 Y1",
        "X1 A5",
        "X2 Z.5",
        "G91",
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
    ];

    proptest! {
        /// Blocks of axis words do what they do by all the rules.
        #[test]
        fn points_follow_all_rules(picks in proptest::collection::vec(0..BLOCKS.len(), 0..30)) {
            let block = |(at, pick): (usize, &usize)| format!("N{} {}\n", at + 2, BLOCKS[*pick]);
            let body: String = picks.iter().enumerate().map(block).collect();
            let (quick, full) = (run(&body, false), run(&body, true));
            prop_assert!(!quick.0.is_empty());
            prop_assert_eq!(quick, full, "{}", body);
        }
    }
}
