//! Which values an address takes (§2), by control and by the other functions of the block.

use super::{Address, Decimal, Dialect, FEED_PER_REVOLUTION, FeedPer, FeedRow, GCode, HIGHEST_Q, Lang, ValueForm};

/// The unit of a value.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum ValueUnit {
    /// Nothing: it is a number or a name.
    None,
    /// Millimetres, of a rotary axis degrees.
    Axis,
    /// Millimetres.
    Millimetres,
    /// Degrees.
    Degrees,
    /// Revolutions of the spindle per minute.
    RevolutionsPerMinute,
    /// Ten milliseconds.
    TenMilliseconds,
    /// Millimetres, or degrees, per minute or revolution.
    Feed(FeedPer),
}

impl ValueUnit {
    /// As written behind a range.
    pub const fn suffix(self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::None, _) => "",
            (Self::Axis, Lang::En) => " mm or °",
            (Self::Axis, Lang::Cs) => " mm nebo °",
            (Self::Millimetres, _) => " mm",
            (Self::Degrees, _) => "°",
            (Self::RevolutionsPerMinute, Lang::En) => " rev/min",
            (Self::RevolutionsPerMinute, Lang::Cs) => " ot/min",
            (Self::TenMilliseconds, _) => " × 10 ms",
            (Self::Feed(FeedPer::Minute), _) => " mm/min",
            (Self::Feed(FeedPer::Revolution), Lang::En) => " mm/rev",
            (Self::Feed(FeedPer::Revolution), Lang::Cs) => " mm/ot",
        }
    }
}

/// In which blocks a range holds.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum When {
    /// Without another condition.
    Always,
    /// In a block with that function.
    With(GCode),
    /// Under the functions of group G6 under which F counts so.
    Feed(FeedPer),
}

impl When {
    /// As written behind a range: ` with G04`, ` under G94, G96`. `per` says what F counts under a function.
    pub fn text(self, lang: Lang, per: impl Fn(GCode) -> Option<FeedPer>) -> String {
        let (word, functions): (_, Vec<GCode>) = match (self, lang) {
            (Self::Always, _) => return String::new(),
            (Self::With(function), Lang::En) => (" with ", vec![function]),
            (Self::With(function), Lang::Cs) => (" s ", vec![function]),
            (Self::Feed(wanted), lang) => {
                let functions = GCode::ALL.iter().copied().filter(|code| per(*code) == Some(wanted)).collect();
                (if lang == Lang::En { " under " } else { " při " }, functions)
            }
        };
        word.to_owned() + &functions.iter().map(GCode::to_string).collect::<Vec<_>>().join(", ")
    }
}

/// What F counts under a function of group G6 on every machine.
fn everywhere(function: GCode) -> Option<FeedPer> {
    match FeedRow::of(function)? {
        FeedRow::Mode(mode) => Some(mode.per),
        FeedRow::Key => None,
    }
}

/// The dynamic sets that I chooses in a block with G23 (GRP-7).
pub const DYNAMIC_SETS: ValueRange = ValueRange::whole(1, 4, ValueUnit::None).when(When::With(GCode::G23));
/// The one that holds before another is chosen.
pub const FIRST_DYNAMIC_SET: u8 = 1;

/// The dwell of G04, Q (GRP-5).
pub const DWELL: ValueRange = ValueRange::whole(0, HIGHEST_Q, ValueUnit::TenMilliseconds).when(When::With(GCode::G04));

/// Values that an address takes, both ends included.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct ValueRange {
    /// Least.
    pub min: Decimal,
    /// Greatest.
    pub max: Decimal,
    /// Its unit.
    pub unit: ValueUnit,
    /// Where it holds.
    pub when: When,
}

impl ValueRange {
    const fn always(min: Decimal, max: Decimal, unit: ValueUnit) -> Self {
        Self { min, max, unit, when: When::Always }
    }

    const fn dimension(unit: ValueUnit) -> Self {
        Self::always(Decimal::DIMENSION_MAX.negated(), Decimal::DIMENSION_MAX, unit)
    }

    const fn whole(min: i64, max: i64, unit: ValueUnit) -> Self {
        Self::always(Decimal::whole(min), Decimal::whole(max), unit)
    }

    const fn feed(per: FeedPer, (min, max): (Decimal, Decimal)) -> Self {
        Self::always(min, max, ValueUnit::Feed(per)).when(When::Feed(per))
    }

    const fn when(self, when: When) -> Self {
        Self { when, ..self }
    }

    /// Whether the value is in it.
    pub fn contains(self, value: Decimal) -> bool {
        self.min <= value && value <= self.max
    }

    /// Both ends with their unit: `1–99`, `±69999.999 mm or °`.
    pub fn text(self, lang: Lang) -> String {
        let Self { min, max, unit, .. } = self;
        let ends = if min == max.negated() { format!("±{max}") } else { format!("{min}–{max}") };
        ends + unit.suffix(lang)
    }
}

impl Address {
    /// The ranges of its values on a control, unless limits are configured: as many on every control. None of `&`,
    /// whose digits are no number, and of `/`, which has no value; of R that of the value with a fraction.
    pub const fn ranges(self, dialect: Dialect) -> [Option<ValueRange>; 2] {
        let first = match self.row().form {
            ValueForm::None | ValueForm::CorrectionDigits => return [None, None],
            ValueForm::Whole { min, max } if matches!(self, Self::S) => {
                ValueRange::whole(min, max, ValueUnit::RevolutionsPerMinute)
            }
            ValueForm::Whole { min, max } => ValueRange::whole(min, max, ValueUnit::None),
            ValueForm::Dimension => ValueRange::dimension(ValueUnit::Axis),
            ValueForm::Parameter => ValueRange::dimension(ValueUnit::None),
            ValueForm::Feed => {
                let per_minute = (Decimal::whole(1), dialect.highest_feed());
                return [
                    Some(ValueRange::feed(FeedPer::Minute, per_minute)),
                    Some(ValueRange::feed(FeedPer::Revolution, FEED_PER_REVOLUTION)),
                ];
            }
            ValueForm::Auxiliary if dialect.has_real_h() => ValueRange::dimension(ValueUnit::None),
            ValueForm::Auxiliary => ValueRange::whole(1, 99, ValueUnit::None),
            ValueForm::Technological => ValueRange::whole(0, dialect.highest_m() as i64, ValueUnit::None),
        };
        if matches!(self, Self::Q) {
            [Some(first), Some(DWELL)]
        } else if matches!(self, Self::I) {
            [Some(first), Some(DYNAMIC_SETS)]
        } else {
            [Some(first), None]
        }
    }

    /// All its ranges on all controls, for people. Empty where [`Self::ranges`] is.
    pub fn ranges_text(self, lang: Lang) -> String {
        let [first, others @ ..] = Dialect::ALL;
        let mut parts = Vec::new();
        for (at, range) in self.ranges(first).into_iter().flatten().enumerate() {
            let mut part = range.text(lang) + &range.when.text(lang, everywhere);
            let differs = others.iter().filter_map(|dialect| {
                let other = (*self.ranges(*dialect).get(at)?)?;
                (other != range).then(|| format!("{}: {}", dialect.title(), other.text(lang)))
            });
            let differs: Vec<String> = differs.collect();
            if !differs.is_empty() {
                part.push_str(&format!(" ({})", differs.join(", ")));
            }
            parts.push(part);
        }
        if self == Self::F {
            parts.push(match lang {
                Lang::En => "under G97 by the key `g97`".to_owned(),
                Lang::Cs => "při G97 podle klíče `g97`".to_owned(),
            });
        }
        parts.join("; ")
    }
}
