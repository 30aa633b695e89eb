//! The operations that parameter arithmetic may be configured with (PAR-9).

use crate::named::named;

named! {
    /// One operation of G26–G29. Angles are degrees.
    #[derive(Clone, Copy, Debug, Eq, PartialEq)]
    pub enum Operation {
        /// a + b
        Add "add",
        /// a − b
        Sub "sub",
        /// a · b
        Mul "mul",
        /// a / b
        Div "div",
        /// −a
        Neg "neg",
        /// |a|
        Abs "abs",
        /// square root of a
        Sqrt "sqrt",
        /// sine of a
        Sin "sin",
        /// cosine of a
        Cos "cos",
        /// tangent of a
        Tan "tan",
        /// angle whose sine is a
        Asin "asin",
        /// angle whose cosine is a
        Acos "acos",
        /// angle whose tangent is a
        Atan "atan",
        /// angle of the point y = a, x = b
        Atan2 "atan2",
        /// remainder of a / b, with the sign of a
        Mod "mod",
        /// the smaller
        Min "min",
        /// the larger
        Max "max",
        /// to the nearest whole number, halves away from zero
        Round "round",
        /// the whole part
        Trunc "trunc",
        /// a
        Copy "copy",
    }
}

impl Operation {
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
