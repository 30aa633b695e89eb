//! What one word of a block changes in the interface: for whoever reads the text.

use super::dictionary::{Cell, Flag, OneBlock, Signal, signals};
use super::facts::Facts;
use super::values::{Value, value};
use crate::config::Machine;
use crate::dict::{Address, Decimal};

/// The cells and bits that an M, H, T or S word sets, with what it sets them to; nothing for other words. What depends on
/// more than the word, the gear under M40 and the spindle output, has no value here, and is there with `[[gears]]` only.
pub fn of_word(address: Address, number: Decimal, machine: &Machine) -> Vec<(&'static Signal, Value)> {
    let mut facts = Facts::default();
    let whole = number.as_whole().and_then(|number| u8::try_from(number).ok());
    let concerns: Box<dyn Fn(Cell) -> bool> = match (address, whole) {
        (Address::M, Some(function)) => {
            let group = machine.m_functions.group(function);
            if let Some(slot) = facts.m.get_mut(usize::from(group)) {
                *slot = Some(function);
            }
            facts.mark(usize::from(group));
            facts.gear = function.checked_sub(40).filter(|gear| group == 3 && (1..=4).contains(gear));
            facts.set(Flag::Stop, function == 0);
            facts.set(Flag::CondStop, function == 1);
            if let Some(written) = OneBlock::from_number(function) {
                facts.write(written);
            }
            Box::new(move |cell| of_function(cell, function, group))
        }
        (Address::H, _) => {
            facts.h = Some(number);
            facts.set(Flag::HProg, true);
            Box::new(|cell| matches!(cell, Cell::H | Cell::HByte | Cell::Flag(Flag::HProg)))
        }
        (Address::T, _) => {
            facts.tool = Some(number);
            facts.set(Flag::TProg, true);
            Box::new(|cell| matches!(cell, Cell::Tool | Cell::ToolByte(_) | Cell::Flag(Flag::TProg)))
        }
        (Address::S, _) => {
            facts.speed = Some(number);
            Box::new(|cell| matches!(cell, Cell::SpindleSpeed | Cell::SpeedByte { .. }))
        }
        _ => return Vec::new(),
    };
    let of_control = signals().iter().filter(|signal| signal.row.is_of(machine.dialect) && concerns(signal.cell));
    let has_gears = !machine.gears.is_empty();
    let with_value = of_control.map(|signal| (signal, value(signal.cell, &facts, machine)));
    with_value.filter(|(_, value)| value.is_some() || has_gears).collect()
}

/// Whether a cell follows from an M function of a group.
fn of_function(cell: Cell, function: u8, group: u8) -> bool {
    match cell {
        Cell::Group(of) | Cell::Mark(of) | Cell::GroupByte(of) => of == group,
        Cell::Written(written) => OneBlock::from_number(function) == Some(written),
        Cell::Spindle(_) => group == 2,
        Cell::Range(_) | Cell::Gear | Cell::SpeedByte { .. } => group == 3,
        Cell::Coolant12(_) => group == 5,
        Cell::Coolant34(_) => group == 6,
        Cell::Flag(Flag::Stop) => function == 0,
        Cell::Flag(Flag::CondStop) => function == 1,
        Cell::Flag(_)
        | Cell::Moves(_)
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
        | Cell::TimeDist => false,
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
        let set = of_word(address, Decimal::whole(number), machine);
        let text = |(signal, value): &(&'static Signal, Value)| {
            let mut text = format!("{}=", signal.name);
            match value {
                Some(_) => write_value(signal, *value, &mut text),
                None => text.push('?'),
            }
            text
        };
        set.iter().map(text).collect::<Vec<_>>().join(" ")
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
        machine.gears = vec![Gear { m: 41, min: 0, max: 500 }];
        let of = |address, number| of_machine(address, number, &machine);
        assert_eq!(of(Address::S, 900), "PB11=? PB12=?");
        assert_eq!(of(Address::M, 40), "ZMM3PI=1 PB11=? PB12=? M41PI=? M42PI=? M43PI=? M44PI=? SPINDLE_GEAR_ACT_1=?");
        assert_eq!(of(Address::M, 41), "ZMM3PI=1 PB11=? PB12=? M41PI=1 M42PI=0 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=1");
        assert_eq!(of(Address::M, 3), "ZMM2PI=1 PB06=03h M03PI=1 M04PI=0 M19PI=0");
        assert_eq!(of(Address::X, 5), "");
    }
}
