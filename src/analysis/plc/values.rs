//! From the facts of a step to the values of signals (PLC-1 to PLC-17).

use super::dictionary::{Cell, Form, Signal, place_of};
use super::facts::Facts;
use crate::analysis::{push_digits, write_real};
use crate::config::{Gear, Machine};
use crate::dict::{
    COOLANT_12, COOLANT_12_GROUP, COOLANT_34, COOLANT_34_GROUP, Decimal, GEAR_BY_SPEED, GEAR_GROUP, Micro,
    SPINDLE_GROUP, gear_function,
};

/// The value of a signal: bits are 0 and 1, real numbers are millionths, all others the number in the cell. `None`:
/// absent.
pub type Value = Option<i64>;

/// Value of the spindle output at the greatest speed of a gear.
const FULL_OUTPUT: i64 = 0x7FFF;

/// Parts of the facts that change together; signals of a part whose facts are as before keep their values.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Part {
    Groups,
    Marks,
    Flags,
    Moves,
    Directions,
    Words,
    Length,
    Motion,
}

impl Part {
    pub(super) const ALL: [Self; 8] = [
        Self::Groups,
        Self::Marks,
        Self::Flags,
        Self::Moves,
        Self::Directions,
        Self::Words,
        Self::Length,
        Self::Motion,
    ];

    /// The part that gives a cell its value; positions are none: each is looked at by itself.
    pub(super) const fn of(cell: Cell) -> Option<Self> {
        Some(match cell {
            Cell::Group(_)
            | Cell::GroupByte(_)
            | Cell::Spindle(_)
            | Cell::Range(_)
            | Cell::Coolant12(_)
            | Cell::Coolant34(_)
            | Cell::Gear => Self::Groups,
            Cell::Mark(_) => Self::Marks,
            Cell::Flag(_) | Cell::Written(_) => Self::Flags,
            Cell::Moves(_) | Cell::Request(_) => Self::Moves,
            Cell::Backwards(_) => Self::Directions,
            Cell::Tool
            | Cell::ToolByte(_)
            | Cell::H
            | Cell::HByte
            | Cell::Delay
            | Cell::FeedProgr
            | Cell::SpindleSpeed
            | Cell::SpeedByte { .. } => Self::Words,
            Cell::BlockLen => Self::Length,
            Cell::Position(_) => return None,
            Cell::ParabAccel | Cell::LinearAccel | Cell::Stretch | Cell::TimeDist => Self::Motion,
        })
    }

    /// Whether the part is the same in both steps.
    pub(super) fn is_same(self, a: &Facts, b: &Facts) -> bool {
        match self {
            Self::Groups => a.m == b.m && a.gear == b.gear,
            Self::Marks => a.marks == b.marks,
            Self::Flags => a.flags() == b.flags() && a.written() == b.written(),
            Self::Moves => a.moves == b.moves,
            Self::Directions => a.directed == b.directed && a.negative == b.negative,
            Self::Words => {
                a.tool == b.tool
                    && a.h == b.h
                    && a.feed == b.feed
                    && a.speed == b.speed
                    && a.dwell == b.dwell
                    && a.gear == b.gear
            }
            Self::Length => a.length == b.length,
            Self::Motion => a.motion == b.motion,
        }
    }
}

/// The value of a cell in a step.
pub fn value(cell: Cell, facts: &Facts, machine: &Machine) -> Value {
    let group = |group: usize| facts.m.get(group).copied().flatten();
    let bit = |holds: bool| Some(i64::from(holds));
    let at = |mask: u16, place: u8| mask.checked_shr(u32::from(place)).unwrap_or(0) & 1 == 1;
    let place = |name: u8| place_of(name, machine).and_then(|place| u8::try_from(place).ok());
    match cell {
        Cell::Group(number) => group(usize::from(number)).map(|function| bcd(i64::from(function))),
        Cell::Mark(number) => bit(at(facts.marks, number)),
        Cell::Flag(flag) => bit(facts.has(flag)),
        Cell::Moves(place) => bit(at(facts.moves, place)),
        Cell::Request(name) => bit(place(name).is_some_and(|place| at(facts.moves, place))),
        Cell::Backwards(name) => {
            let place = place(name).filter(|place| at(facts.directed, *place))?;
            bit(at(facts.negative, place))
        }
        Cell::Tool => facts.tool.and_then(Decimal::as_whole).map(bcd),
        Cell::H => facts.h.map(decimal),
        Cell::Delay => facts.dwell.map(Micro::millionths),
        Cell::Position(place) => facts.positions.get(usize::from(place)).copied().flatten().map(Micro::millionths),
        Cell::BlockLen => facts.length.map(Micro::millionths),
        Cell::FeedProgr => facts.feed.map(decimal),
        Cell::SpindleSpeed => facts.speed.map(decimal),
        Cell::ParabAccel => facts.motion.parabolic.map(Micro::millionths),
        Cell::LinearAccel => facts.motion.linear.map(Micro::millionths),
        Cell::GroupByte(number) => group(usize::from(number)).map(i64::from).map(byte),
        Cell::HByte => facts.h.map(|h| if fits_byte(h) { h.as_whole().map_or(0, byte) } else { 0 }),
        Cell::ToolByte(pair) => {
            let tool = facts.tool.and_then(Decimal::as_whole)?;
            let pair = tool / 100_i64.pow(u32::from(pair)) % 100;
            Some(bcd(pair))
        }
        Cell::SpeedByte { high } => {
            output(facts, &machine.gears).map(|word| if high { word >> 8 } else { word & 0xFF })
        }
        Cell::Written(function) => bit(facts.is_written(function)),
        Cell::Spindle(function) => group(SPINDLE_GROUP).map(|in_force| i64::from(in_force == function)),
        // Under M40 by the gear; other functions of the group are none of these ranges.
        Cell::Range(range) => match group(GEAR_GROUP)? {
            GEAR_BY_SPEED => facts.gear.map(|gear| i64::from(gear == range)),
            function => bit(function == gear_function(range)),
        },
        Cell::Coolant12(function) => {
            group(COOLANT_12_GROUP).map(|in_force| i64::from([function, COOLANT_12[0]].contains(&in_force)))
        }
        Cell::Coolant34(function) => {
            group(COOLANT_34_GROUP).map(|in_force| i64::from([function, COOLANT_34[0]].contains(&in_force)))
        }
        Cell::Gear => facts.gear.map(i64::from),
        Cell::Stretch => facts.motion.in_stretch.map(i64::from),
        Cell::TimeDist => facts.motion.time_dist_ms.map(i64::from),
    }
}

fn decimal(value: Decimal) -> i64 {
    Micro::from(value).millionths()
}

/// A whole number from 0 to 99999999 in BCD.
const fn bcd(number: i64) -> i64 {
    let (mut rest, mut shift, mut result) = (number, 0, 0);
    while rest > 0 && shift < 32 {
        result |= (rest % 10) << shift;
        rest /= 10;
        shift += 4;
    }
    result
}

/// A number as a byte in BCD: what has more than two digits is 00h (PLC-7).
const fn byte(number: i64) -> i64 {
    if number > 99 { 0 } else { bcd(number) }
}

/// Whether an H fits a byte in BCD: whole, from 0 to 99 (PLC-7).
pub fn fits_byte(h: Decimal) -> bool {
    h.as_whole().is_some_and(|whole| (0..=99).contains(&whole))
}

/// S as a part of the greatest speed of the gear in force and of its voltage, 0–7FFFh (PLC-8); a speed beyond it is
/// full output.
fn output(facts: &Facts, gears: &[Gear]) -> Value {
    let gear = facts.gear?;
    let gear = gears.iter().find(|row| row.m == gear_function(gear)).filter(|row| row.max > 0)?;
    let speed = i128::from(facts.speed?.as_whole()?);
    // Thousandths; halves away from zero; S has no sign.
    let (part, whole) = (i128::from(gear.output.thousandths()), i128::from(gear.max) * 1000);
    let word = (2 * speed * part * i128::from(FULL_OUTPUT) + whole) / (2 * whole);
    Some(i64::try_from(word).map_or(FULL_OUTPUT, |word| word.min(FULL_OUTPUT)))
}

/// The value as tables show it; absent is empty.
pub fn write_value(signal: &Signal, value: Value, out: &mut String) {
    let Some(number) = value else { return };
    if signal.form() == Form::Real {
        write_real(number, out);
    } else if signal.is_hexadecimal() {
        out.push_str(&format!("{number:02X}h"));
    } else {
        push_digits(number.unsigned_abs(), 1, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::plc::dictionary::find;

    fn shown(name: &str, value: Value) -> String {
        let mut text = String::new();
        write_value(find(name).unwrap(), value, &mut text);
        text
    }

    #[test]
    fn cells_as_tables_show_them() {
        assert_eq!(shown("BLK.M[11]", Some(0x95)), "95h");
        assert_eq!(shown("BLK.M[2]", Some(5)), "05h");
        assert_eq!(shown("BLK.M[14]", Some(0x100)), "100h");
        assert_eq!(shown("PB11", Some(0xFF)), "FFh");
        assert_eq!(shown("TIME_DIST", Some(95)), "95");
        assert_eq!(shown("SPINDLE_GEAR_ACT_1", Some(4)), "4");
        assert_eq!(shown("BLK.H", Some(-12_500_000)), "-12.5");
        assert_eq!(shown("BLK.BlockLen", Some(1)), "0.000001");
        assert_eq!(shown("BLK.AxNC[0]", Some(0)), "0");
        for (millionths, text) in [
            (1_500_000, "1.5"),
            (-50_000, "-0.05"),
            (7_000, "0.007"),
            (120_300, "0.1203"),
            (12_000_010, "12.00001"),
            (-999_999_999, "-999.999999"),
            (340_000_000, "340"),
        ] {
            assert_eq!(shown("BLK.AxNC[0]", Some(millionths)), text);
        }
        assert_eq!(shown("M03PI", Some(1)), "1");
        assert_eq!(shown("M03PI", None), "");
    }

    /// PLC-1, PLC-6: T has up to eight decades.
    #[test]
    fn bcd_of_numbers() {
        assert_eq!([bcd(0), bcd(7), bcd(95), bcd(100), bcd(69_999_999)], [0, 7, 0x95, 0x100, 0x6999_9999]);
    }

    /// PLC-7: two decades; M100, an H above 99, with a fraction or a sign, are 00h.
    #[test]
    fn bytes() {
        assert_eq!([byte(0), byte(99), byte(100)], [0, 0x99, 0]);
        let h = |thousandths| fits_byte(Decimal::from_thousandths(thousandths));
        assert_eq!([h(0), h(99_000), h(100_000), h(500), h(-1_000)], [true, true, false, false, false]);
    }

    /// PLC-8: exact, halves away from zero.
    #[test]
    fn spindle_output() {
        let gears = |max| vec![Gear { m: 41, min: 0, max, output: Decimal::whole(1) }];
        let facts = |speed, gear| Facts { speed: Some(Decimal::whole(speed)), gear, ..Facts::default() };
        let at = |speed, max| output(&facts(speed, Some(1)), &gears(max));
        assert_eq!([at(0, 500), at(500, 500), at(250, 500)], [Some(0), Some(0x7FFF), Some(0x4000)]);
        // 1/2 of 32767 is 16383.5; 1/3 of it 10922.33.
        assert_eq!([at(1, 2), at(1, 3), at(600, 500)], [Some(16_384), Some(10_922), Some(0x7FFF)]);
        assert_eq!([at(1, 0), output(&facts(1, Some(2)), &gears(5)), output(&facts(1, None), &gears(5))], [None; 3]);
        assert_eq!(output(&Facts { gear: Some(1), ..Facts::default() }, &gears(5)), None);
        // Half the voltage at the greatest speed.
        let half = vec![Gear { m: 41, min: 0, max: 500, output: Decimal::from_thousandths(500) }];
        assert_eq!(output(&facts(500, Some(1)), &half), Some(0x4000));
        assert_eq!(output(&facts(2_000_000, Some(1)), &half), Some(0x7FFF));
    }
}
