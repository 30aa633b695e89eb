//! What execution makes of one block: how often it runs, and what holds in it and after it.

use std::collections::BTreeMap;

use super::values::Values;
use crate::analysis::plc::WordsRead;
use crate::config::Machine;
use crate::dict::{Address, AxisLetter, Decimal, GCode, GGroup, M_GROUPS, Micro};
use crate::run::{Executed, FeedUnit, Jump, Length, Missing};

/// Different things that the PLC reads in one block, as many as are kept.
const READS: usize = 4;

/// What was seen of one block.
#[derive(Clone, Debug, Default)]
pub(crate) struct Observed {
    /// How often it was executed.
    pub(crate) runs: u64,
    /// How often its jump was taken.
    pub(crate) jumps: u64,
    /// How often the jump was taken each time that its counter was armed (FLW-4).
    pub(crate) taken: Values<u64>,
    /// Jumps since the counter was armed, and what it held after the last; `None`: it is not armed.
    armed: Option<(u64, u32)>,
    /// After the block, by letter.
    pub(crate) positions: [Values<Micro>; AxisLetter::ALL.len()],
    /// Whether programs write twice the position of X (G74).
    pub(crate) diameters: Values<bool>,
    /// In the block, by group.
    pub(crate) g: [Values<u8>; GGroup::ALL.len()],
    /// After the block, by group.
    pub(crate) m: [Values<u8>; M_GROUPS],
    /// Of its motions; unknown ones too.
    pub(crate) length_mm: Values<Micro>,
    /// Of motions of rotary axes only.
    pub(crate) length_deg: Values<Micro>,
    pub(crate) feed: Values<Decimal>,
    pub(crate) feed_unit: Values<FeedUnit>,
    pub(crate) speed: Values<Decimal>,
    /// Whether the speed is a constant cutting speed.
    pub(crate) cuts: Values<bool>,
    pub(crate) tool: Values<Decimal>,
    pub(crate) h: Values<Decimal>,
    pub(crate) p: Values<Decimal>,
    pub(crate) d: Values<Decimal>,
    pub(crate) correction: Values<u16>,
    pub(crate) dwell_s: Values<Micro>,
    /// Parameters that the block reads: their values before it.
    pub(crate) reads: BTreeMap<u8, Values<Decimal>>,
    /// Parameters that it writes: their values after it.
    pub(crate) writes: BTreeMap<u8, Values<Decimal>>,
    /// Parameters that the called unit takes: their values when it begins.
    pub(crate) inputs: BTreeMap<u8, Values<Decimal>>,
    /// The PLC's reading of its M, H, T and S words: the first few different ones, on request.
    pub(crate) plc: Vec<WordsRead>,
    /// There are more.
    pub(crate) more_plc: bool,
}

impl Observed {
    pub(super) fn take(&mut self, executed: &Executed<'_>, machine: &Machine) {
        self.runs += 1;
        self.take_jump(executed.jump());
        for (letter, values) in AxisLetter::ALL.into_iter().zip(&mut self.positions) {
            if machine.axes.index(letter).is_some() {
                values.add(executed.position(letter));
            }
        }
        self.diameters.add(Some(executed.state().g_in_force(GGroup::G10) == Some(GCode::G74)));
        for (values, group) in self.g.iter_mut().zip(GGroup::ALL) {
            values.add(executed.g(group).map(GCode::number));
        }
        for (group, values) in self.m.iter_mut().enumerate() {
            values.add(executed.m(group));
        }
        if let Some(motion) = executed.motion() {
            match motion.length() {
                Length::Deg(length) => self.length_deg.add(Some(length)),
                Length::Missing(Missing::Reference) => {}
                Length::Mm(length) => self.length_mm.add(Some(length)),
                Length::Missing(Missing::Start | Missing::Origin) => self.length_mm.add(None),
            }
        }
        self.feed_unit.add(Some(executed.feed_unit()));
        self.feed.add(executed.feed().map(|feed| feed.value));
        self.speed.add(executed.s());
        self.cuts.add(Some(executed.const_cut_speed()));
        self.tool.add(executed.t());
        self.h.add(executed.h());
        self.p.add(executed.p());
        self.d.add(executed.d());
        self.correction.add(executed.length_correction());
        if executed.dwell().is_some() {
            self.dwell_s.add(executed.dwell());
        }
    }

    /// Takes what the PLC reads of the words.
    pub(super) fn take_words(&mut self, executed: &Executed<'_>) {
        let written = |address| executed.written(address);
        if executed.m_written().is_empty() && ![Address::H, Address::T, Address::S].into_iter().any(written) {
            return;
        }
        let read = WordsRead::of(executed);
        if self.plc.contains(&read) {
            return;
        }
        if self.plc.len() < READS {
            self.plc.push(read);
        } else {
            self.more_plc = true;
        }
    }

    /// Follows the counter: armed at an arrival, lowered at each, disarmed where execution falls through.
    fn take_jump(&mut self, jump: Option<Jump>) {
        self.jumps += u64::from(jump.is_some());
        let left = jump.and_then(|jump| jump.left);
        match (self.armed, left) {
            // Lowered by one since the last arrival: the same counter.
            (Some((jumps, before)), Some(left)) if left.checked_add(1) == Some(before) => {
                self.armed = Some((jumps + 1, left));
            }
            // Armed; before that, the unit may have been left with the counter armed.
            (_, Some(left)) => {
                self.disarm();
                self.armed = Some((1, left));
            }
            (Some((_, 0)), None) => self.disarm(),
            // Armed with nothing to count, and disarmed.
            (_, None) => {
                self.disarm();
                self.taken.add(Some(0));
            }
        }
    }

    pub(super) fn disarm(&mut self) {
        if let Some((jumps, _)) = self.armed.take() {
            self.taken.add(Some(jumps));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(arrivals: &[Option<u32>]) -> String {
        let mut observed = Observed::default();
        for left in arrivals {
            observed.take_jump(left.map(|left| Jump { to: 1, left: Some(left) }));
        }
        observed.disarm();
        observed.taken.list(|value| value)
    }

    /// FLW-4: one row of jumps for each time that the counter is armed.
    #[test]
    fn counters() {
        assert_eq!(taken(&[Some(2), Some(1), Some(0), None]), "3");
        assert_eq!(taken(&[Some(0), None, Some(1), Some(0), None]), "1, 2");
        // Left by another jump, then reached anew.
        assert_eq!(taken(&[Some(2), Some(1), Some(2), Some(1), Some(0), None]), "2, 3");
        // Forward: not reached again.
        assert_eq!(taken(&[Some(0)]), "1");
        assert_eq!(taken(&[None]), "0");
    }
}
