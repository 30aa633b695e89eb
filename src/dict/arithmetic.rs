//! The operations that parameter arithmetic may be configured with (PAR-9).

/// One operation of G26–G29. Angles are degrees.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Operation {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a · b
    Mul,
    /// a / b
    Div,
    /// −a
    Neg,
    /// |a|
    Abs,
    /// square root of a
    Sqrt,
    /// sine of a
    Sin,
    /// cosine of a
    Cos,
    /// tangent of a
    Tan,
    /// angle whose sine is a
    Asin,
    /// angle whose cosine is a
    Acos,
    /// angle whose tangent is a
    Atan,
    /// angle of the point y = a, x = b
    Atan2,
    /// remainder of a / b, with the sign of a
    Mod,
    /// the smaller
    Min,
    /// the larger
    Max,
    /// to the nearest whole number, halves away from zero
    Round,
    /// the whole part
    Trunc,
    /// a
    Copy,
}

impl Operation {
    /// Every operation, in the order of the specification.
    pub const ALL: [Self; 20] = [
        Self::Add,
        Self::Sub,
        Self::Mul,
        Self::Div,
        Self::Neg,
        Self::Abs,
        Self::Sqrt,
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Atan2,
        Self::Mod,
        Self::Min,
        Self::Max,
        Self::Round,
        Self::Trunc,
        Self::Copy,
    ];

    /// The name used in the project file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Sub => "sub",
            Self::Mul => "mul",
            Self::Div => "div",
            Self::Neg => "neg",
            Self::Abs => "abs",
            Self::Sqrt => "sqrt",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan => "atan",
            Self::Atan2 => "atan2",
            Self::Mod => "mod",
            Self::Min => "min",
            Self::Max => "max",
            Self::Round => "round",
            Self::Trunc => "trunc",
            Self::Copy => "copy",
        }
    }

    /// The operation of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|operation| operation.name() == name)
    }

    /// Whether the second operand is used (PAR-8: `bb` is ignored otherwise).
    pub const fn takes_two(self) -> bool {
        match self {
            Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Atan2 | Self::Mod | Self::Min | Self::Max => true,
            Self::Neg
            | Self::Abs
            | Self::Sqrt
            | Self::Sin
            | Self::Cos
            | Self::Tan
            | Self::Asin
            | Self::Acos
            | Self::Atan
            | Self::Round
            | Self::Trunc
            | Self::Copy => false,
        }
    }
}
