//! The three controls (§12 of the language).

/// Which control a program is for.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[cfg_attr(feature = "cli", value(rename_all = "lower"))]
pub enum Dialect {
    /// CNC8x6: six axes, machine constants R56–R59 for M groups 10–13.
    Cnc8x6,
    /// CNC8x9 (DUAL): as CNC8x6 for the language.
    Cnc8x9,
    /// CNC872: sixteen axes, M functions by ChannelConfig.
    #[default]
    Cnc872,
}

impl Dialect {
    /// Every dialect.
    pub const ALL: [Self; 3] = [Self::Cnc8x6, Self::Cnc8x9, Self::Cnc872];

    /// As written in options, the project file and the stream.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cnc8x6 => "cnc8x6",
            Self::Cnc8x9 => "cnc8x9",
            Self::Cnc872 => "cnc872",
        }
    }

    /// Most axes that a machine may be configured with (§12, §13 Configuration).
    pub const fn axes(self) -> usize {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => 6,
            Self::Cnc872 => 16,
        }
    }

    /// Whether the sixth axis, the third that is not X, Y or Z, may have that letter (§2, §13 More).
    pub const fn takes_sixth_axis(self, letter: super::AxisLetter) -> bool {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => letter.is_rotary_by_default(),
            Self::Cnc872 => true,
        }
    }

    /// Whether M groups are configured by a ChannelConfig (else by machine constants R56–R59).
    pub const fn has_channel_config(self) -> bool {
        matches!(self, Self::Cnc872)
    }

    /// Highest M number (§2).
    pub const fn highest_m(self) -> u8 {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => 99,
            Self::Cnc872 => 100,
        }
    }

    /// Whether the counts of G and M words in a block are limited (BLK-4).
    pub const fn limits_words(self) -> bool {
        !matches!(self, Self::Cnc872)
    }

    /// Highest feed per minute in mm/min, unless configured (TEC-1).
    pub const fn highest_feed(self) -> super::Decimal {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => super::Decimal::whole(24_000),
            Self::Cnc872 => super::Decimal::whole(99_999),
        }
    }
}
