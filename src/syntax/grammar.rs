//! The grammar of what stands between two `N`: chumsky parsers over the tokens of one block.
//!
//! It accepts every sequence of tokens: what is malformed has productions of its own, so that one mistake becomes one
//! item and the words around it stay what they are. `grammar/part-program.ebnf` shows the well-formed part.

use chumsky::extra;
use chumsky::input::{InputRef, MapExtra};
use chumsky::inspector::SimpleState;
use chumsky::prelude::*;

use super::lower::Lowering;
use super::{Kind, Token};

/// One thing in a block, as the tokens it is made of. Well-formed words and line ends are none of them: they are nearly
/// everything, and go without this form.
#[derive(Clone, Debug)]
pub(super) enum Item {
    /// An address and its number; more numbers after blanks are its pieces. One of the two is malformed.
    Word { word: Token, pieces: Vec<Token> },
    /// An address, and a parameter in place of its number (PAR-2).
    Parametric { address: Token, parameter: Token, pieces: Vec<Token> },
    /// `R11=R10`, `R11=-R10` (PAR-1).
    Copy { target: Token, sign: Option<Token>, source: Token, pieces: Vec<Token> },
    /// `R10=25.5`, `R10 25.5` (PAR-1).
    Assignment { target: Token, sign: Option<Token>, number: Token, pieces: Vec<Token> },
    /// An address with a sign, blanks, and a number.
    SplitSign { address: Token, number: Token, pieces: Vec<Token> },
    /// A parameter with several `=`.
    ForeignAssignment { address: Token, number: Token },
    /// An address with several signs and a parameter: `X--R1`.
    ManySigns { first: Token, last: Token },
    /// An address, and R without the number of the parameter: `XR`.
    NoParameter { address: Token, parameter: Token },
    /// A blank in the number of a parameter: `R1 0=5`.
    SplitParameter { target: Token, value: Token },
    /// R and what is no number of a parameter: `R-5`, `R-1=5`, `R=5`.
    Radius { first: Token, last: Token },
    /// A sign before the `=` of a parameter: `R10-=12`.
    SignBeforeEquals { target: Token, sign: Token, value: Token },
    /// A sign before a word: `-X10`.
    SignFirst { sign: Token, word: Token },
    /// A parameter with `=` and characters that the control does not know: `R10=−5`.
    OddValue { target: Token, value: Token },
    /// An address or a parameter with `=`, and a value between brackets or of a function: `Z(R11)`, `R1=SIN(30)`.
    Bracketed { first: Token, last: Token },
    /// A word, or something like one, that a single token holds: [`Kind::PrintedWord`] and the like.
    Foreign(Token),
    /// An address or R word without a value; a number beyond a line end or comments (then they are `Some`) was meant
    /// for it.
    Valueless { address: Token, end: Token, comments: Option<Vec<Token>> },
    /// `/`
    Skip(Token),
    /// A comment.
    Comment(Token),
    /// Numbers, signs or `=` that belong to nothing.
    Stray { first: Token, last: Token },
    /// Text that is no comment, with the numbers in it.
    Text { first: Token, last: Token },
    /// Characters that mean nothing.
    Debris(Token),
}

type Extra<'x, 'l> = extra::Full<EmptyErr, SimpleState<&'l mut Lowering<'x>>, ()>;

/// The parser of one block's tokens. Each item goes to the [`Lowering`] as it is recognised; nothing is kept.
pub(super) fn block<'t, 'x: 'l, 'l>() -> impl Parser<'t, &'t [Token], (), Extra<'x, 'l>> {
    let one = |kind: Kind| any().filter(move |token: &Token| token.kind == kind);
    let number = any().filter(|token: &Token| matches!(token.kind, Kind::Number | Kind::LooseNumber));
    let parameter = any().filter(|token: &Token| matches!(token.kind, Kind::Parameter | Kind::LooseParameter));
    let address = any().filter(|token: &Token| matches!(token.kind, Kind::Letter | Kind::SignedLetter));
    let pieces = number.repeated().collect::<Vec<Token>>();
    // What follows the parameter of an assignment, `R51+R52` too.
    let between = any().filter(|token: &Token| matches!(token.kind, Kind::Sign | Kind::Operator));
    let operand = between
        .then(between.or_not())
        .then(parameter.or(number).or(one(Kind::Bracketed)))
        .map(|((operator, _), value)| vec![operator, value]);
    let operands = number
        .map(|number| vec![number])
        .or(operand)
        .repeated()
        .collect::<Vec<Vec<Token>>>()
        .map(|operands| operands.concat());
    let value = number.or(parameter);
    let assigned_value = one(Kind::Equals)
        .then(one(Kind::Sign).or_not())
        .then(value.or_not())
        .map(|((equals, sign), value): ((Token, Option<Token>), Option<Token>)| value.or(sign).unwrap_or(equals));
    // A number beyond a line end or a comment: the value that an address lacks.
    let beyond = any()
        .filter(|token: &Token| matches!(token.kind, Kind::LineEnd | Kind::Comment))
        .repeated()
        .at_least(1)
        .collect::<Vec<Token>>()
        .then_ignore(number.or(assigned_value))
        .or_not()
        .map(|tokens: Option<Vec<Token>>| {
            tokens.map(|tokens| tokens.into_iter().filter(|token| token.kind == Kind::Comment).collect::<Vec<_>>())
        });

    let well_formed = custom(|input: &mut InputRef<'t, '_, &'t [Token], Extra<'x, 'l>>| {
        let here = input.cursor();
        let tokens = input.slice_from(&here..);
        let count = well_formed(tokens, input.state().0);
        (0..count).for_each(|_| input.skip());
        if count == 0 { Err(EmptyErr::default()) } else { Ok(()) }
    });
    let word = any()
        .filter(|token: &Token| matches!(token.kind, Kind::Word | Kind::LooseWord | Kind::ManySigns))
        .then(pieces)
        .map(|(word, pieces)| Item::Word { word, pieces });
    let comment =
        any().filter(|token: &Token| matches!(token.kind, Kind::Comment | Kind::TypographicComment)).map(Item::Comment);
    let assigned = parameter.then_ignore(one(Kind::Equals)).then(one(Kind::Sign).or_not());
    let copy = assigned.then(parameter).then(operands).map(|(((target, sign), source), pieces)| Item::Copy {
        target,
        sign,
        source,
        pieces,
    });
    let assignment = assigned.then(number).then(operands).map(|(((target, sign), number), pieces)| Item::Assignment {
        target,
        sign,
        number,
        pieces,
    });
    let short_assignment = parameter
        .then(one(Kind::Sign).or_not())
        .then(number)
        .then(operands)
        .map(|(((target, sign), number), pieces)| Item::Assignment { target, sign, number, pieces });
    let of_function = one(Kind::Text).or_not().then(one(Kind::Bracketed)).map(|(_, value)| value);
    let bracketed =
        assigned.map(|(target, _)| target).or(address).then(of_function).then(operands).map(
            |((first, value), operands)| Item::Bracketed { first, last: operands.last().copied().unwrap_or(value) },
        );
    // `X R10=5`: the letter has no value, and the parameter gets one.
    let read = parameter.then_ignore(one(Kind::Equals).not());
    let parametric = address.then(read).then(operands).map(|((address, parameter), pieces)| Item::Parametric {
        address,
        parameter,
        pieces,
    });
    let split_sign = one(Kind::SignedLetter)
        .then(number)
        .then(pieces)
        .map(|((address, number), pieces)| Item::SplitSign { address, number, pieces });
    let radius = one(Kind::BareR)
        .then(number.or(assigned_value))
        .foldl(assigned_value.repeated(), |(first, _), last| (first, last))
        .map(|(first, last)| Item::Radius { first, last });
    let many_signs = one(Kind::ManySigns)
        .then(parameter)
        .then(operands)
        .map(|((first, last), operands)| Item::ManySigns { first, last: operands.last().copied().unwrap_or(last) });
    let no_parameter = address
        .then(one(Kind::BareR))
        .then_ignore(number.or(one(Kind::Equals)).not())
        .map(|(address, parameter)| Item::NoParameter { address, parameter });
    let split_parameter = parameter
        .then_ignore(number.then(one(Kind::Equals)).then(one(Kind::Sign).or_not()))
        .then(value)
        .map(|(target, value)| Item::SplitParameter { target, value });
    // `R10= R11=80`: the value that R10 should get is missing.
    let unassigned = parameter
        .then(one(Kind::Equals))
        .then_ignore(parameter.then(one(Kind::Equals)).rewind())
        .map(|(address, end)| Item::Valueless { address, end, comments: None });
    let sign_first = one(Kind::Sign).then(one(Kind::Word)).map(|(sign, word)| Item::SignFirst { sign, word });
    let sign_before_equals = parameter
        .then(one(Kind::Sign))
        .then_ignore(one(Kind::Equals))
        .then(value)
        .then_ignore(operands)
        .map(|((target, sign), value)| Item::SignBeforeEquals { target, sign, value });
    let odd_value = parameter
        .then_ignore(one(Kind::Equals))
        .then(one(Kind::Unknown))
        .map(|(target, value)| Item::OddValue { target, value });
    let single = any()
        .filter(|token: &Token| {
            matches!(
                token.kind,
                Kind::PrintedWord
                    | Kind::AssignedWord
                    | Kind::NamedValue
                    | Kind::Variable
                    | Kind::ForeignStart
                    | Kind::JumpTarget
                    | Kind::MixedNumber
                    | Kind::LostNumber
                    | Kind::Unit
            )
        })
        // `X=R1*2`
        .then_ignore(one(Kind::Operator).rewind().then(operands).or_not())
        .map(Item::Foreign);
    let double = parameter
        .then_ignore(one(Kind::Equals).repeated().at_least(2))
        .then(number)
        .map(|(address, number)| Item::ForeignAssignment { address, number });
    let valueless = address
        .map(|address| (address, address))
        .or(one(Kind::BareR).then(one(Kind::Sign).or_not()).map(|(address, sign)| (address, sign.unwrap_or(address))))
        .or(parameter
            .then(one(Kind::Equals).or_not())
            .then_ignore(one(Kind::Sign).or_not())
            .map(|(parameter, equals): (Token, Option<Token>)| (parameter, equals.unwrap_or(parameter))))
        .then(beyond)
        .map(|((address, end), comments)| Item::Valueless { address, end, comments });
    let stray_token = any().filter(|token: &Token| {
        matches!(token.kind, Kind::Number | Kind::LooseNumber | Kind::Sign | Kind::Equals | Kind::Operator)
    });
    let stray = stray_token
        .map(|token| (token, token))
        .foldl(stray_token.repeated(), |(first, _), last| (first, last))
        .map(|(first, last)| Item::Stray { first, last });

    let text_token = any().filter(|token: &Token| {
        matches!(
            token.kind,
            Kind::Text
                | Kind::Unit
                | Kind::Number
                | Kind::LooseNumber
                | Kind::Unknown
                | Kind::Equals
                | Kind::Sign
                | Kind::ForeignComment
                | Kind::Bracketed
        )
    });
    // `!vyjet`: signs right before a text belong to it.
    let signs = one(Kind::Unknown)
        .then(one(Kind::Text).rewind())
        .filter(|(signs, text): &(Token, Token)| signs.end == text.start)
        .map(|(signs, _)| signs);
    let text = signs
        .or_not()
        .then(one(Kind::Text))
        .map(|(signs, token)| (signs.unwrap_or(token), token))
        .foldl(text_token.repeated(), |(first, _), last| (first, last))
        .map(|(first, last)| Item::Text { first, last });

    let odd = choice((
        comment,
        many_signs,
        word,
        choice((bracketed, unassigned, split_parameter, sign_before_equals, no_parameter)),
        copy,
        assignment,
        short_assignment,
        parametric,
        split_sign,
        radius,
        double,
        odd_value,
        valueless,
        single,
        one(Kind::Skip).map(Item::Skip),
        sign_first,
        stray,
        text,
        any().map(Item::Debris),
    ));
    let odd = odd.map_with(|item, extra: &mut MapExtra<'t, '_, &'t [Token], Extra<'x, 'l>>| {
        extra.state().0.accept(item);
    });
    // At the end of the block, none of them has to be tried.
    let odd = any().rewind().ignore_then(odd);
    let item = choice((well_formed, odd));
    // A fold, because a bare `repeated()` would not look at what the items are.
    empty().foldl(item.repeated(), |(), ()| ())
}

/// Takes the well-formed words and line ends at the beginning of `tokens`, nearly everything there is: in one step,
/// because a step for each would be the larger part of all reading. Gives the number of tokens taken.
fn well_formed(tokens: &[Token], lowering: &mut Lowering<'_>) -> usize {
    let mut tokens_left = tokens.iter().peekable();
    let mut taken = 0;
    while let Some(token) = tokens_left.next() {
        // A number behind a word belongs to it, or is meant to.
        let number_next = tokens_left.peek().is_some_and(|next| matches!(next.kind, Kind::Number | Kind::LooseNumber));
        if token.kind == Kind::Word && !number_next {
            lowering.plain_word(*token);
        } else if token.kind != Kind::LineEnd {
            break;
        }
        taken += 1;
    }
    taken
}
