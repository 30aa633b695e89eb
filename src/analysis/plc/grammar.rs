//! The grammar of conditions: chumsky parsers over their tokens. `!` binds closest, then comparisons, `&`, `|`.

use chumsky::extra;
use chumsky::prelude::*;

use super::tokens::{Kind, Token};
use crate::text::Span;

/// How two values are compared.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Comparison {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    Greater,
    /// `>=`
    AtLeast,
}

impl Comparison {
    pub(super) const fn of(kind: Kind) -> Option<Self> {
        Some(match kind {
            Kind::Equal | Kind::SingleEqual | Kind::TripleEqual => Self::Equal,
            Kind::NotEqual | Kind::LessGreater | Kind::NotTripleEqual => Self::NotEqual,
            Kind::Less => Self::Less,
            Kind::AtMost | Kind::EqualLess => Self::AtMost,
            Kind::Greater => Self::Greater,
            Kind::AtLeast | Kind::EqualGreater => Self::AtLeast,
            Kind::Name
            | Kind::Rising
            | Kind::Falling
            | Kind::Hexadecimal
            | Kind::Decimal
            | Kind::WordNot
            | Kind::WordAnd
            | Kind::WordOr
            | Kind::Not
            | Kind::And
            | Kind::Or
            | Kind::Open
            | Kind::Close
            | Kind::DoubleAnd
            | Kind::DoubleOr
            | Kind::Malformed
            | Kind::Unknown => return None,
        })
    }
}

/// A condition as written.
#[derive(Clone, Debug)]
pub(super) enum Tree {
    /// A name alone, or compared.
    Signal { name: Token, compared: Option<(Comparison, Token)> },
    /// `!`
    Not { at: Span, of: Box<Tree> },
    /// `&` between two or more.
    And(Vec<Tree>),
    /// `|` between two or more.
    Or(Vec<Tree>),
    /// In parentheses.
    Group(Box<Tree>),
    /// `rising(…)`, `falling(…)`
    Edge { at: Span, rising: bool, of: Box<Tree> },
}

/// Parentheses and `!` that may stand within one another: trees are read and evaluated by recursion.
pub(super) const DEEPEST: usize = 100;

/// The first token that stands within more than [`DEEPEST`] parentheses and `!`.
pub(super) fn too_deep(tokens: &[Token]) -> Option<Token> {
    // For each parenthesis that is open, how deep it stands.
    let mut outside = Vec::new();
    let mut depth = 0;
    tokens.iter().copied().find(|token| {
        if matches!(token.kind, Kind::Not | Kind::WordNot) {
            depth += 1;
        } else if token.kind == Kind::Open {
            outside.push(depth);
            depth += 1;
        } else if token.kind == Kind::Close {
            depth = outside.pop().unwrap_or(0);
        } else {
            // The next operand is outside the parentheses again.
            depth = outside.last().map_or(0, |depth| depth + 1);
        }
        depth > DEEPEST
    })
}

/// The condition that the tokens are, or the index of the first token that has no place; their number when the end
/// comes too early.
pub(super) fn parse(tokens: &[Token]) -> Result<Tree, usize> {
    let (tree, errors) = condition().parse(tokens).into_output_errors();
    match (tree, errors.first()) {
        (Some(tree), None) => Ok(tree),
        (_, error) => Err(error.map_or(tokens.len(), |error| error.span().start)),
    }
}

type Extra<'t> = extra::Err<Rich<'t, Token, SimpleSpan>>;

fn condition<'t>() -> impl Parser<'t, &'t [Token], Tree, Extra<'t>> {
    let one = |kind: Kind| any().filter(move |token: &Token| token.kind == kind);
    let operand = any().filter(|token: &Token| matches!(token.kind, Kind::Name | Kind::Hexadecimal | Kind::Decimal));
    let comparison = any().filter(|token: &Token| Comparison::of(token.kind).is_some());
    recursive(|whole| {
        let group = whole.delimited_by(one(Kind::Open), one(Kind::Close)).boxed();
        let signal = one(Kind::Name).then(comparison.then(operand).or_not()).map(|(name, compared)| Tree::Signal {
            name,
            compared: compared.and_then(|(by, with): (Token, Token)| Some((Comparison::of(by.kind)?, with))),
        });
        let edge = one(Kind::Rising).or(one(Kind::Falling)).then(group.clone()).map(|(edge, of): (Token, Tree)| {
            Tree::Edge { at: edge.span, rising: edge.kind == Kind::Rising, of: Box::new(of) }
        });
        let primary = choice((signal, edge, group.map(|of| Tree::Group(Box::new(of)))));
        let not = one(Kind::Not)
            .or(one(Kind::WordNot))
            .repeated()
            .foldr(primary, |not: Token, of| Tree::Not { at: not.span, of: Box::new(of) });
        let and = choice((one(Kind::And), one(Kind::DoubleAnd), one(Kind::WordAnd)));
        let all = not.separated_by(and).at_least(1).collect().map(|trees| one_of(trees, Tree::And));
        let or = choice((one(Kind::Or), one(Kind::DoubleOr), one(Kind::WordOr)));
        all.separated_by(or).at_least(1).collect().map(|trees| one_of(trees, Tree::Or))
    })
    .then_ignore(end())
}

/// The only tree, or what joins several.
fn one_of(mut trees: Vec<Tree>, join: fn(Vec<Tree>) -> Tree) -> Tree {
    match trees.pop() {
        Some(only) if trees.is_empty() => only,
        last => {
            trees.extend(last);
            join(trees)
        }
    }
}
