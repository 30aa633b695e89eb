//! Blocks of axis words and nothing else: nearly all blocks of long programs. What they do follows from what is in force,
//! which is looked up once for a run of them; the rules of motion are those of every block.

use super::block::Valued;
use super::executor::Executor;
use super::motion::{Reading, Travel, motion_type};
use super::state::Held;
use crate::dict::{GCode, GGroup};
use crate::ir::MotionType;
use crate::syntax::BlockId;

/// What blocks of axis words do while no other word comes between them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Run {
    /// Not known: the block before may have changed what is in force.
    #[default]
    Unknown,
    /// More than move straight.
    Involved,
    /// They move straight, and nothing but positions changes.
    Straight(MotionType, Reading),
}

impl Executor<'_, '_> {
    /// Executes a block that has no G, M, L, Q, R, `/` or `&` word and no parameter, when it only moves axes straight.
    /// `false`: it does more, and nothing is done yet.
    #[inline]
    pub(super) fn run_point(&mut self, block: BlockId) -> bool {
        if matches!(self.run, Run::Unknown) {
            self.settle();
        }
        let Run::Straight(kind, reading) = self.run else { return false };
        if !self.wants_records && !reading.is_incremental() {
            return self.pass_point(block, reading);
        }
        let mut travels = std::mem::take(&mut self.travels);
        let straight = self.read_point(block, reading, &mut travels);
        if straight {
            self.begin_record(block);
            let stale = std::mem::take(&mut self.state.origin_changed);
            self.stale = stale;
            self.run_straight(kind, stale, &travels);
            if self.wants_records {
                for travel in &travels {
                    self.record.position.set(travel.definition.letter, travel.after.known());
                }
            }
        }
        self.travels = travels;
        straight
    }

    /// The same where nobody asks for the motion: the axes are where the words say.
    #[inline]
    fn pass_point(&mut self, block: BlockId, reading: Reading) -> bool {
        let Some(file) = self.resolved.file(self.file) else { return false };
        let (words, axes) = (file.words(block), &self.settings.machine.axes);
        if words.is_empty() || words.iter().any(|word| axes.index_of(word.address).is_none()) {
            return false;
        }
        for word in words {
            if let Some(axis) = axes.index_of(word.address) {
                self.state.set_position(axis, reading.target(axis, word.number()));
            }
        }
        self.state.origin_changed = false;
        true
    }

    /// The motions of a block's words. `false`: there is another word.
    #[inline]
    fn read_point(&self, block: BlockId, reading: Reading, travels: &mut Vec<Travel>) -> bool {
        travels.clear();
        let Some(file) = self.resolved.file(self.file) else { return false };
        for &word in file.words(block) {
            let Some(axis) = self.settings.machine.axes.index_of(word.address) else { return false };
            let Some(travel) = self.travel(axis, Valued { word, value: word.number() }, reading) else { return false };
            // In machine order; of words for the same axis the last one counts.
            if travels.last().is_none_or(|last| last.axis < axis) {
                travels.push(travel);
                continue;
            }
            let at = travels.partition_point(|known| known.axis < axis);
            match travels.get_mut(at) {
                Some(known) if known.axis == axis => *known = travel,
                _ => travels.insert(at, travel),
            }
        }
        !travels.is_empty()
    }

    /// Finds out what a block of axis words will do: puts into force, and into the record, what a block without words has.
    #[inline(never)]
    fn settle(&mut self) {
        self.words.clear();
        self.apply_g();
        self.track_origin();
        self.apply_m();
        self.record.data = None;
        self.record.words.clear();
        self.finish_record(false);
        let kind = self.in_force(GGroup::G0).and_then(motion_type).unwrap_or(MotionType::Rapid);
        let straight = match kind {
            MotionType::Rapid | MotionType::Thread => true,
            MotionType::Linear => !self.lacks_technology(),
            MotionType::ArcCw | MotionType::ArcCcw | MotionType::Reference => false,
        };
        let cycle = self.in_force(GGroup::G8).is_some_and(GCode::is_cycle);
        self.run = if straight && !cycle { Run::Straight(kind, self.reading()) } else { Run::Involved };
    }

    /// Whether a working motion may have something to say about F and S (TEC-2, TEC-3).
    fn lacks_technology(&self) -> bool {
        let state = &self.state;
        (state.feed == Held::None && !self.feed_warned)
            || (state.speed == Held::None && !self.speed_warned && self.speed_reader().is_some())
    }

    /// What is known of the blocks of axis words after a block that did more. `plain`: it has no G, M or other word that
    /// changes what is in force.
    #[inline]
    pub(super) fn unsettle(&mut self, plain: bool) {
        let lasts = matches!(self.run, Run::Involved) && plain && self.words.f.is_none() && self.words.s.is_none();
        if !lasts {
            self.run = Run::Unknown;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use proptest::prelude::*;

    use crate::config::{Purpose, Settings};
    use crate::diag::Findings;
    use crate::resolve::{Library, resolve_program};
    use crate::run::{Checkpoint, Executor};
    use crate::text::{MemoryLoader, SourceText, Sources};

    /// What is known after each block of a program, and the findings.
    fn run(body: &str, purpose: Purpose) -> (Vec<Checkpoint>, Vec<String>) {
        let (loader, settings) = (MemoryLoader::new(), Settings::default());
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\nN1 G54 G90\n{body}\nN9000 M30")));
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let mut resolved = resolve_program(&source, &settings, &mut library, &mut sources, &mut findings);
        let mut executor = Executor::new(&mut resolved, &settings, &mut library, &mut sources, &mut findings, purpose);
        let mut known = Vec::new();
        while executor.step().is_some() {
            known.push(executor.checkpoint());
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
        /// Checking looks at less of a motion than compiling, and knows the same after it.
        #[test]
        fn checking_knows_what_compiling_knows(picks in proptest::collection::vec(0..BLOCKS.len(), 0..30)) {
            let block = |(at, pick): (usize, &usize)| format!("N{} {}\n", at + 2, BLOCKS[*pick]);
            let body: String = picks.iter().enumerate().map(block).collect();
            let (checked, compiled) = (run(&body, Purpose::Check), run(&body, Purpose::Compile));
            prop_assert!(!checked.0.is_empty());
            prop_assert_eq!(checked, compiled, "{}", body);
        }
    }
}
