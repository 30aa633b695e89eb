//! The three controls (§12 of the language).

use crate::named::named;

named! {
    /// Which control a program is for, the newest last.
    #[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
    #[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
    #[cfg_attr(feature = "cli", value(rename_all = "lower"))]
    pub enum Dialect {
        /// CNC8x6: six axes, machine constants R56–R59 for M groups 10–13.
        Cnc8x6 "cnc8x6",
        /// CNC8x9 (DUAL): as CNC8x6 for the language.
        Cnc8x9 "cnc8x9",
        /// CNC872: sixteen axes, M functions by ChannelConfig.
        #[default]
        Cnc872 "cnc872",
    }
}

impl Dialect {
    /// As people write it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Cnc8x6 => "CNC8x6",
            Self::Cnc8x9 => "CNC8x9",
            Self::Cnc872 => "CNC872",
        }
    }

    /// Highest M number of any dialect.
    pub const HIGHEST_M: u8 = {
        let mut highest = 0;
        let mut dialects: &[Self] = &Self::ALL;
        while let [dialect, rest @ ..] = dialects {
            if dialect.highest_m() > highest {
                highest = dialect.highest_m();
            }
            dialects = rest;
        }
        highest
    };

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
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => false,
            Self::Cnc872 => true,
        }
    }

    /// Whether the PLC reads the command block, whose signals begin with `BLK.`.
    pub const fn has_command_block(self) -> bool {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => false,
            Self::Cnc872 => true,
        }
    }

    /// Whether H has a sign and a decimal point (ADR-1).
    pub const fn has_real_h(self) -> bool {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => false,
            Self::Cnc872 => true,
        }
    }

    /// Whether the control reads lines longer than 80 characters (LEX-7).
    pub const fn reads_long_lines(self) -> bool {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => false,
            Self::Cnc872 => true,
        }
    }

    /// Shortest time of a block in a continuous stretch, in ms, unless configured (CNT-2, VEL-6).
    pub const fn shortest_block_ms(self) -> i64 {
        match self {
            Self::Cnc8x6 => 60,
            Self::Cnc8x9 | Self::Cnc872 => 4,
        }
    }

    /// Shortest time of a block that G24 joins tightly, in ms (S3 A2; CNC872 as CNC8x9).
    pub const fn shortest_tight_block_ms(self) -> u32 {
        match self {
            Self::Cnc8x6 => 30,
            Self::Cnc8x9 | Self::Cnc872 => 2,
        }
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
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => true,
            Self::Cnc872 => false,
        }
    }

    /// Highest feed per minute in mm/min, unless configured (TEC-1).
    pub const fn highest_feed(self) -> super::Decimal {
        match self {
            Self::Cnc8x6 | Self::Cnc8x9 => super::Decimal::whole(24_000),
            Self::Cnc872 => super::Decimal::whole(99_999),
        }
    }
}
