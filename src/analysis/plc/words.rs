//! Changes of the interface by one word of a block, for readers of the program text.

use super::blocks::Blocks;
use super::dictionary::{Cell, Flag, OneBlock, Signal, signals};
use super::facts::{Facts, STOPPED};
use super::values::{Value, value};
use crate::config::Machine;
use crate::dict::{
    Address, COOLANT_12_GROUP, COOLANT_34_GROUP, Decimal, GEAR_BY_SPEED, GEAR_GROUP, GEARS, OPTIONAL_STOP,
    PROGRAM_ENDS, PROGRAM_GROUP, PROGRAM_STOP, SPINDLE_GROUP,
};
use crate::run::Executed;

/// The PLC's reading of the M, H, T and S words of an executed block.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct WordsRead {
    step: Facts,
    /// While the program stands after it (PLC-16).
    stop: Option<Facts>,
}

impl WordsRead {
    /// Of a block that was just executed.
    pub fn of(block: &Executed<'_>) -> Self {
        let mut step = Facts::default();
        let stop = Blocks::new(&block.settings().machine, &[]).read(block, None, &mut step);
        Self { step: step.without_motion(), stop: stop.map(Facts::without_motion) }
    }
}

/// A signal with its different values, in the order in which they came.
pub type SetSignal = (&'static Signal, Vec<Value>);

/// The signals that a word sets.
#[derive(Debug, Default)]
pub struct WordSets {
    /// In its block.
    pub step: Vec<SetSignal>,
    /// What changes while the program stands after it.
    pub stop: Vec<SetSignal>,
}

/// An M, H, T or S word.
#[derive(Clone, Copy)]
struct Word<'m> {
    address: Address,
    /// Of M: the function, and its group.
    function: Option<(u8, u8)>,
    machine: &'m Machine,
}

/// The cells and bits that an M, H, T or S word sets, with what it sets them to; nothing for other words. `seen`: what
/// the PLC read of its block, at different executions. Without any, what depends on more than the word, the gear under
/// M40 and the spindle output, has no value here, and is there with `[[gears]]` only.
pub fn of_word(address: Address, number: Decimal, machine: &Machine, seen: &[WordsRead]) -> WordSets {
    let whole = number.as_whole().and_then(|number| u8::try_from(number).ok());
    let function = whole.filter(|_| address == Address::M).map(|number| (number, machine.m_functions.group(number)));
    let word = Word { address, function, machine };
    if !matches!(address, Address::H | Address::T | Address::S) && function.is_none() {
        return WordSets::default();
    }
    let alone = [WordsRead { step: word.facts(number), stop: None }];
    let reads = if seen.is_empty() { &alone } else { seen };
    let of_control = || signals().iter().filter(|signal| signal.row.is_of(machine.dialect));
    let values = |signal: &'static Signal, of: &dyn Fn(&WordsRead) -> Option<Value>| {
        let mut values: Vec<Value> = Vec::new();
        for value in reads.iter().filter_map(of) {
            if !values.contains(&value) {
                values.push(value);
            }
        }
        (signal, values)
    };
    let has_gears = !machine.gears.is_empty();
    let step = of_control().map(|signal| {
        values(signal, &|read| word.sets(signal.cell, &read.step).then(|| value(signal.cell, &read.step, machine)))
    });
    let is_shown = |values: &[Value]| values.iter().any(|value| value.is_some() || has_gears);
    let stop = of_control().map(|signal| {
        values(signal, &|read| {
            let stop = read.stop.as_ref().filter(|_| word.sets_at_stop(signal.cell))?;
            let [before, now] = [&read.step, stop].map(|facts| value(signal.cell, facts, machine));
            (before != now).then_some(now)
        })
    });
    WordSets {
        step: step.filter(|(_, values)| is_shown(values)).collect(),
        stop: stop.filter(|(_, values)| !values.is_empty()).collect(),
    }
}

impl Word<'_> {
    /// What follows from the word alone.
    fn facts(self, number: Decimal) -> Facts {
        let mut facts = Facts::default();
        match (self.address, self.function) {
            (_, Some((function, group))) => {
                if let Some(slot) = facts.m.get_mut(usize::from(group)) {
                    *slot = Some(function);
                }
                facts.mark(usize::from(group));
                let of_gears = usize::from(group) == GEAR_GROUP;
                facts.gear = (of_gears && GEARS.contains(&function)).then(|| function - GEAR_BY_SPEED);
                facts.set(Flag::Stop, function == PROGRAM_STOP);
                facts.set(Flag::CondStop, function == OPTIONAL_STOP);
                facts.set(Flag::Last, PROGRAM_ENDS.contains(&function));
                if let Some(written) = OneBlock::from_number(function) {
                    facts.write(written);
                }
            }
            (Address::H, None) => {
                facts.h = Some(number);
                facts.set(Flag::HProg, true);
            }
            (Address::T, None) => {
                facts.tool = Some(number);
                facts.set(Flag::TProg, true);
            }
            _ => facts.speed = Some(number),
        }
        facts
    }

    /// Whether a cell follows from the word in a block with these facts.
    fn sets(self, cell: Cell, facts: &Facts) -> bool {
        match (self.address, self.function) {
            (_, Some((function, group))) => {
                let of_group = group_of(cell);
                of_group == Some(usize::from(group))
                    || self.is_own(cell, function)
                    || (PROGRAM_ENDS.contains(&function) && of_group.is_some_and(|group| self.is_reset(group, facts)))
            }
            (Address::H, None) => matches!(cell, Cell::H | Cell::HByte | Cell::Flag(Flag::HProg)),
            (Address::T, None) => matches!(cell, Cell::Tool | Cell::ToolByte(_) | Cell::Flag(Flag::TProg)),
            // Under M40 the gear follows from S (MFN-9).
            _ => {
                let of_gear = matches!(cell, Cell::Range(_) | Cell::Gear)
                    || matches!(cell, Cell::Mark(group) if usize::from(group) == GEAR_GROUP && facts.is_marked(GEAR_GROUP));
                matches!(cell, Cell::SpindleSpeed | Cell::SpeedByte { .. }) || (of_gear && goes_by_speed(facts))
            }
        }
    }

    /// Bits of the function itself.
    fn is_own(self, cell: Cell, function: u8) -> bool {
        if let Cell::Written(written) = cell {
            return OneBlock::from_number(function) == Some(written);
        }
        cell == Cell::Flag(Flag::Stop) && function == PROGRAM_STOP
            || cell == Cell::Flag(Flag::CondStop) && function == OPTIONAL_STOP
            || cell == Cell::Flag(Flag::Last) && PROGRAM_ENDS.contains(&function)
    }

    /// Whether the end of the program sends a group (MFN-6, MFN-7).
    fn is_reset(self, group: usize, facts: &Facts) -> bool {
        let default = self.machine.m_power_up.get(group).copied().flatten();
        default.is_some() && facts.is_marked(group)
    }

    /// Whether a cell changes while the program waits at M00 or M01, because of the wait.
    fn sets_at_stop(self, cell: Cell) -> bool {
        let Some((function @ (PROGRAM_STOP | OPTIONAL_STOP), _)) = self.function else { return false };
        let of_group = group_of(cell);
        self.is_own(cell, function) || of_group.is_some_and(|group| group == PROGRAM_GROUP || STOPPED.contains(&group))
    }
}

/// Whether M40 is in force.
fn goes_by_speed(facts: &Facts) -> bool {
    facts.m.get(GEAR_GROUP).copied().flatten() == Some(GEAR_BY_SPEED)
}

/// The M group that a cell follows from.
fn group_of(cell: Cell) -> Option<usize> {
    match cell {
        Cell::Group(group) | Cell::Mark(group) | Cell::GroupByte(group) => Some(usize::from(group)),
        Cell::Spindle(_) => Some(SPINDLE_GROUP),
        Cell::Range(_) | Cell::Gear | Cell::SpeedByte { .. } => Some(GEAR_GROUP),
        Cell::Coolant12(_) => Some(COOLANT_12_GROUP),
        Cell::Coolant34(_) => Some(COOLANT_34_GROUP),
        Cell::Flag(_)
        | Cell::Written(_)
        | Cell::Moves(_)
        | Cell::Request(_)
        | Cell::Backwards(_)
        | Cell::Tool
        | Cell::H
        | Cell::Delay
        | Cell::Position(_)
        | Cell::BlockLen
        | Cell::FeedProgr
        | Cell::SpindleSpeed
        | Cell::ParabAccel
        | Cell::LinearAccel
        | Cell::HByte
        | Cell::ToolByte(_)
        | Cell::Stretch
        | Cell::TimeDist => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::plc::write_value;
    use crate::config::Gear;
    use crate::dict::Dialect;

    fn shown(address: Address, number: i64, dialect: Dialect) -> String {
        of_machine(address, number, &Machine::new(dialect))
    }

    fn of_machine(address: Address, number: i64, machine: &Machine) -> String {
        let set = of_word(address, Decimal::whole(number), machine, &[]);
        assert!(set.stop.is_empty());
        let text = |(signal, values): &SetSignal| {
            let mut text = format!("{}=", signal.name);
            match values.as_slice() {
                [value @ Some(_)] => write_value(signal, *value, &mut text),
                _ => text.push('?'),
            }
            text
        };
        set.step.iter().map(text).collect::<Vec<_>>().join(" ")
    }

    /// PLC-1, PLC-2, PLC-7, PLC-9, PLC-10, PLC-12: by the group of the function.
    #[test]
    fn words() {
        let of = |address, number| shown(address, number, Dialect::Cnc8x6);
        assert_eq!(of(Address::M, 3), "ZMM2PI=1 PB06=03h M03PI=1 M04PI=0 M19PI=0");
        assert_eq!(of(Address::M, 0), "ZMM1PI=1 M00_PID=1");
        assert_eq!(of(Address::M, 42), "ZMM3PI=1 M41PI=0 M42PI=1 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=2");
        assert_eq!(of(Address::M, 40), "ZMM3PI=1");
        assert_eq!(of(Address::M, 77), "ZMM14PI=1 PB16=77h");
        assert_eq!(of(Address::T, 1234), "PB07=34h PB08=12h PB09=00h PB10=00h ZMSTPI=1");
        assert_eq!(of(Address::X, 5), "");
        assert_eq!(shown(Address::M, 1, Dialect::Cnc872), "BLK.M[1]=01h BLK.M1=1 BLK.CondStop=1 ZMM1PI=1 M01_PID=1");
        assert_eq!(shown(Address::H, 5, Dialect::Cnc872), "BLK.HProg=1 BLK.H=5 PB05=05h ZMSHPI=1");
        assert_eq!(shown(Address::S, 900, Dialect::Cnc872), "BLK.SpindleSpeed=900");
    }

    /// PLC-8, PLC-10, PLC-13: with gears the spindle output and, under M40, the gear depend on more than the word.
    #[test]
    fn words_with_gears() {
        let mut machine = Machine::new(Dialect::Cnc8x9);
        machine.gears = vec![Gear { m: 41, min: 0, max: 500, output: Decimal::whole(1) }];
        let of = |address, number| of_machine(address, number, &machine);
        assert_eq!(of(Address::S, 900), "PB11=? PB12=?");
        assert_eq!(of(Address::M, 40), "ZMM3PI=1 PB11=? PB12=? M41PI=? M42PI=? M43PI=? M44PI=? SPINDLE_GEAR_ACT_1=?");
        assert_eq!(of(Address::M, 41), "ZMM3PI=1 PB11=? PB12=? M41PI=1 M42PI=0 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=1");
        assert_eq!(of(Address::M, 3), "ZMM2PI=1 PB06=03h M03PI=1 M04PI=0 M19PI=0");
        assert_eq!(of(Address::X, 5), "");
    }
}
