//! Which values an address takes on a machine.

use super::Machine;
use crate::dict::{Address, Decimal, FeedPer, Lang, ValueRange, ValueUnit};

impl Machine {
    /// The ranges of an address, as [`Address::ranges`] has them: with the limits of this machine, and the units of its
    /// axes.
    pub fn ranges(&self, address: Address) -> [Option<ValueRange>; 2] {
        address.ranges(self.dialect).map(|range| range.map(|range| self.range(address, range)))
    }

    fn range(&self, address: Address, range: ValueRange) -> ValueRange {
        match range.unit {
            ValueUnit::Feed(FeedPer::Minute) => ValueRange { max: self.limits.feed, ..range },
            ValueUnit::RevolutionsPerMinute => {
                ValueRange { max: Decimal::whole(i64::from(self.limits.speed)), ..range }
            }
            ValueUnit::Axis => {
                let axis = self.axes.index_of(address).and_then(|axis| self.axes.get(axis));
                let rotary = axis.is_some_and(|axis| axis.rotary);
                ValueRange { unit: if rotary { ValueUnit::Degrees } else { ValueUnit::Millimetres }, ..range }
            }
            ValueUnit::None
            | ValueUnit::Millimetres
            | ValueUnit::Degrees
            | ValueUnit::TenMilliseconds
            | ValueUnit::Feed(FeedPer::Revolution) => range,
        }
    }

    /// The ranges of an address, for people: with the functions under which each holds on this machine.
    pub fn ranges_text(&self, address: Address, lang: Lang) -> String {
        let under = |range: ValueRange| range.when.text(lang, |code| self.feed_mode(code).map(|mode| mode.per));
        let ranges = self.ranges(address).into_iter().flatten();
        ranges.map(|range| range.text(lang) + &under(range)).collect::<Vec<_>>().join("; ")
    }
}
