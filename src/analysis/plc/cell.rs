//! The sources of the values of signals.

/// The source of a signal's value.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Cell {
    /// Value of an M group, in BCD.
    Group(u8),
    /// Change mark of an M group.
    Mark(u8),
    /// A fact of the block that is true or not.
    Flag(Flag),
    /// The axis at that place moves.
    Moves(u8),
    /// The axis of that name in [`AXIS_NAMES`](super::dictionary::AXIS_NAMES) moves.
    Request(u8),
    /// The axis of that name moves in the negative direction.
    Backwards(u8),
    /// T, in BCD.
    Tool,
    /// H.
    H,
    /// The dwell, in seconds.
    Delay,
    /// Position of the axis at that place, in mm or degrees.
    Position(u8),
    /// Length of the block, in mm or degrees.
    BlockLen,
    /// F.
    FeedProgr,
    /// S, in rev/min.
    SpindleSpeed,
    /// P/500 of the dynamic set in force.
    ParabAccel,
    /// Linear acceleration of the dynamic set in force, in mm/s².
    LinearAccel,
    /// Value of an M group as a byte in BCD.
    GroupByte(u8),
    /// H as a byte in BCD.
    HByte,
    /// Two digits of T, from the lowest.
    ToolByte(u8),
    /// Low or high byte of the spindle output.
    SpeedByte {
        /// The high one.
        high: bool,
    },
    /// Whether the block has this M function.
    Written(OneBlock),
    /// Whether this function of group 2 is in force.
    Spindle(u8),
    /// Whether this range is in force, chosen by M41–M44 or under M40.
    Range(u8),
    /// Whether the coolant of M07 or M08 runs.
    Coolant12(u8),
    /// Whether the coolant of M50 or M51 runs.
    Coolant34(u8),
    /// The gear, 1–4.
    Gear,
    /// Whether the block lies in a continuous stretch of two blocks or more.
    Stretch,
    /// Time to the end of the stretch, in whole ms.
    TimeDist,
}

impl Cell {
    /// The unit of its numbers; empty where they have none, or where it depends on the axes that move.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Delay => "s",
            Self::SpindleSpeed => "rev/min",
            Self::LinearAccel => "mm/s2",
            Self::TimeDist => "ms",
            Self::Group(_)
            | Self::Mark(_)
            | Self::Flag(_)
            | Self::Moves(_)
            | Self::Request(_)
            | Self::Backwards(_)
            | Self::Tool
            | Self::H
            | Self::Position(_)
            | Self::BlockLen
            | Self::FeedProgr
            | Self::ParabAccel
            | Self::GroupByte(_)
            | Self::HByte
            | Self::ToolByte(_)
            | Self::SpeedByte { .. }
            | Self::Written(_)
            | Self::Spindle(_)
            | Self::Range(_)
            | Self::Coolant12(_)
            | Self::Coolant34(_)
            | Self::Gear
            | Self::Stretch => "",
        }
    }
}

/// Facts of a block that are true or not.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
#[repr(u8)]
pub enum Flag {
    /// First executed block.
    First,
    /// Last executed block.
    Last,
    /// M00.
    Stop,
    /// M01.
    CondStop,
    /// H written.
    HProg,
    /// T written.
    TProg,
    /// Feed per revolution.
    RevFeed,
    /// G23 in force.
    ContinuousMode,
    /// Constant cutting speed.
    ConstCutSpeed,
    /// G00 in force.
    Rapid,
    /// G33 in force.
    Thread,
    /// Automatic mode: always.
    Automatic,
    /// A dwell above 0.
    Dwell,
    /// The program waits at M00 or M01.
    Standing,
    /// G30 written.
    Reference,
}

/// M functions whose bits last one block.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
#[repr(u8)]
#[expect(missing_docs, reason = "the functions themselves")]
pub enum OneBlock {
    M00,
    M01,
    M02,
    M30,
    M10,
    M11,
    M06,
    M60,
}

impl OneBlock {
    /// The function of that number, when its bit lasts one block.
    pub const fn from_number(number: u8) -> Option<Self> {
        match number {
            0 => Some(Self::M00),
            1 => Some(Self::M01),
            2 => Some(Self::M02),
            30 => Some(Self::M30),
            10 => Some(Self::M10),
            11 => Some(Self::M11),
            6 => Some(Self::M06),
            60 => Some(Self::M60),
            _ => None,
        }
    }
}

/// How wide a signal is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Form {
    /// 0 or 1.
    Bit,
    /// 8 bits.
    Byte,
    /// 16 bits.
    Word,
    /// 32 bits.
    DWord,
    /// A real number; values have at most six decimals.
    Real,
}

impl Form {
    /// As S0 names it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bit => "bit",
            Self::Byte => "byte",
            Self::Word => "word",
            Self::DWord => "dword",
            Self::Real => "real",
        }
    }
}
