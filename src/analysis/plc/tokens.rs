//! The tokens of a condition.

use logos::Logos;

use crate::sure::small;
use crate::text::Span;

/// The kind of a token.
#[derive(Clone, Copy, Debug, Eq, Hash, Logos, PartialEq)]
#[logos(skip r"[ \t\r\n]+")]
pub(super) enum Kind {
    /// The name of a signal, or of a function; a pattern of names, which a condition has no use for.
    #[regex(r"[A-Za-z_][A-Za-z0-9_.\[\]*]*")]
    Name,
    /// `rising`
    #[token("rising", priority = 30)]
    Rising,
    /// `falling`
    #[token("falling", priority = 30)]
    Falling,
    /// `95h`
    #[regex(r"[0-9][0-9A-Fa-f]*[hH]", priority = 20)]
    Hexadecimal,
    /// `12`, `-0.5`
    #[regex(r"[+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)", priority = 20)]
    Decimal,
    /// `not`, as other languages write `!`
    #[regex("[nN][oO][tT]", priority = 30)]
    WordNot,
    /// `and`, likewise `&`
    #[regex("[aA][nN][dD]", priority = 30)]
    WordAnd,
    /// `or`, likewise `|`
    #[regex("[oO][rR]", priority = 30)]
    WordOr,
    /// `!`
    #[token("!")]
    Not,
    /// `&`
    #[token("&")]
    And,
    /// `|`
    #[token("|")]
    Or,
    /// `==`
    #[token("==")]
    Equal,
    /// `!=`
    #[token("!=")]
    NotEqual,
    /// `<`
    #[token("<")]
    Less,
    /// `<=`
    #[token("<=")]
    AtMost,
    /// `>`
    #[token(">")]
    Greater,
    /// `>=`
    #[token(">=")]
    AtLeast,
    /// `(`
    #[token("(")]
    Open,
    /// `)`
    #[token(")")]
    Close,
    /// `&&`
    #[token("&&")]
    DoubleAnd,
    /// `||`
    #[token("||")]
    DoubleOr,
    /// `=`
    #[token("=")]
    SingleEqual,
    /// `===`
    #[token("===")]
    TripleEqual,
    /// `!==`
    #[token("!==")]
    NotTripleEqual,
    /// `<>`
    #[token("<>")]
    LessGreater,
    /// `=<`
    #[token("=<")]
    EqualLess,
    /// `=>`
    #[token("=>")]
    EqualGreater,
    /// Something like a number: `3,5`, `95x`, `1e5`.
    #[regex(r"[+\-]?[0-9.][0-9A-Za-z_.,]*", priority = 5)]
    Malformed,
    /// What has no meaning here.
    #[regex(r"[^ \t\r\nA-Za-z0-9_.!&|=<>()]", priority = 1)]
    Unknown,
}

/// A token and its place.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) span: Span,
}

/// The tokens of a condition.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    Kind::lexer(text)
        .spanned()
        .map(|(kind, range)| Token {
            kind: kind.unwrap_or(Kind::Unknown),
            span: Span::new(small(range.start), small(range.end)),
        })
        .collect()
}

impl Kind {
    /// The operator of this language for one of another language.
    pub(super) const fn meant(self) -> Option<&'static str> {
        match self {
            Self::DoubleAnd | Self::WordAnd => Some("&"),
            Self::DoubleOr | Self::WordOr => Some("|"),
            Self::WordNot => Some("!"),
            Self::SingleEqual | Self::TripleEqual => Some("=="),
            Self::LessGreater | Self::NotTripleEqual => Some("!="),
            Self::EqualLess => Some("<="),
            Self::EqualGreater => Some(">="),
            Self::Name
            | Self::Rising
            | Self::Falling
            | Self::Hexadecimal
            | Self::Decimal
            | Self::Not
            | Self::And
            | Self::Or
            | Self::Equal
            | Self::NotEqual
            | Self::Less
            | Self::AtMost
            | Self::Greater
            | Self::AtLeast
            | Self::Open
            | Self::Close
            | Self::Malformed
            | Self::Unknown => None,
        }
    }
}
