//! Parameters: their numbers, assignments to them, and words that read them.

use super::letters::is_all_letters;
use super::numbers::{Broken, split};
use super::{Around, Diagnosis, functions, numbers, value, without_blanks, write};
use crate::diag::{Certain, Diagnostic, Edit, Finding, MINUS, Meant, NumberMeant, ValueMeant, shown};
use crate::dict::Address;
use crate::sure::small;
use crate::syntax::tokens::{Kind, Shape, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// The number of a parameter, 0–95, and what is wrong with it.
pub(super) fn number(around: &Around<'_>, token: Token) -> (Option<u8>, Option<Diagnostic>) {
    let digits = around.number(token);
    let place = Span::new(token.end - small(digits.len()), token.end);
    let fixed = digits.replace(['o', 'O'], "0").replace('l', "1");
    let number = grammar::parameter_number(&fixed);
    if number.is_none() {
        return (None, Some(around.diagnostic(place, Finding::ParameterNumber {})));
    }
    let letters = (fixed != digits).then(|| {
        let written = shown(&format!("R{fixed}"));
        let found = around.diagnostic(
            token.span(),
            Finding::LetterForDigit { fixed: written.clone(), without: String::new(), comment: String::new() },
        );
        let certain = is_all_letters(digits).then_some(Certain::LettersAlone);
        found.with_edits(certain, write(&written), vec![Edit { at: around.place(place), text: fixed }])
    });
    (number, letters)
}

/// `R1 = R2 = 5`: one `=` too many. With a blank behind the first alone the value of R1 is missing.
pub(super) fn chained(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.parameter()?;
    let equals = next.one(Kind::Equals)?;
    let second = next.parameter().filter(|second| (equals.start > first.end) == (second.start > equals.end))?;
    let last = next.assigned_value()?;
    let found = around.malformed(first.span().to(last.span()), NumberMeant::EqualsForm);
    let [(one, _), (other, _)] = [first, second].map(|parameter| number(around, parameter));
    let diagnosis = Diagnosis::saying(next.taken, found).unknown_target(one, first.span());
    Some(diagnosis.unknown_target(other, second.span()).debris())
}

/// `R10= R11=80`: the value that R10 should get is missing.
pub(super) fn without_value(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    next.parameter()?;
    next.one(Kind::Equals)?;
    next.parameter()?;
    next.one(Kind::Equals).and_then(|_| numbers::valueless(around))
}

/// `R1 0=5`: a blank in the number of a parameter.
pub(super) fn split_number(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let target = next.parameter()?;
    next.number()?;
    next.one(Kind::Equals)?;
    next.one(Kind::Sign);
    let last = next.number().or_else(|| next.parameter())?;
    let span = target.span().to(last.span());
    let joined = without_blanks(around.slice(span)).to_ascii_uppercase();
    let (name, text) = joined.split_once('=').unwrap_or((&joined, ""));
    let number = name.strip_prefix('R').and_then(grammar::parameter_number);
    let (Some(number), Some(word)) = (number, value(Address::R, span, text)) else {
        return Some(no_number(around, next.taken, span));
    };
    let found = around.offering(span, split(shown(&joined)), joined);
    Some(Diagnosis::saying(next.taken, found).with(word.assigning(number), span))
}

/// `R10-=12`: `=` computes nothing, and a sign follows it.
pub(super) fn sign_before_equals(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let target = next.parameter()?;
    let sign = next.one(Kind::Sign)?;
    next.one(Kind::Equals)?;
    let last = next.number().or_else(|| next.parameter())?;
    next.operands();
    let span = target.span().to(last.span());
    let (number, wrong) = number(around, target);
    let text = around.slice(last.span()).to_ascii_uppercase();
    let plain = value(Address::R, span, &text).filter(|_| !text.starts_with(['+', '-']));
    let written = number.zip(plain).map(|(number, _)| format!("R{number}={}{text}", around.slice(sign.span())));
    let found = wrong.unwrap_or_else(|| match written {
        Some(written) => around.number_as(span, written, |written| NumberMeant::SignBeforeEquals { written }),
        None => around.malformed(span, NumberMeant::Computed),
    });
    Some(Diagnosis::saying(next.taken, found).unknown_target(number, span))
}

/// `XR`: an address, and R without the number of the parameter.
pub(super) fn without_number(around: &Around<'_>) -> Option<Diagnosis> {
    let [letter, parameter] = around.next([Kind::Letter, Kind::Junk(Shape::BareR)])?;
    let mut next = around.cursor();
    next.taken = 2;
    if next.number().or_else(|| next.one(Kind::Equals)).is_some() {
        return None;
    }
    let finding = Finding::MissingValue { address: "R".to_owned(), meant: ValueMeant::Parameter };
    let found = around.diagnostic(parameter.span(), finding);
    Some(Diagnosis::saying(2, found).void(around.address(letter)?, letter.span().to(parameter.span())))
}

/// `XR96`, `X- R10`, `R10=-R11+5`: a parameter in place of a number (PAR-1, PAR-2).
pub(super) fn read(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let letter = next.one(Kind::Letter);
    let target = if letter.is_some() { None } else { Some(next.parameter()?) };
    let sign = target.and_then(|_| next.one(Kind::Equals).map(|_| next.one(Kind::Sign)));
    if target.is_some() && sign.is_none() {
        return None;
    }
    let source = next.parameter()?;
    if letter.is_some() && next.peek().is_some_and(|next| next.kind == Kind::Equals) {
        return None;
    }
    let first = letter.or(target)?;
    let address = letter.map_or(Some(Address::R), |letter| around.address(letter))?;
    let operands = next.operands();
    let whole = first.span().to(source.span());
    let span = first.span().to(operands.last().unwrap_or(&source).span());
    if matches!(address, Address::N | Address::Program) {
        let found = around.diagnostic(whole, Finding::ParameterNotAllowed { address });
        return Some(Diagnosis::saying(next.taken, found).void(address, whole));
    }
    let (target, wrong_target) = target.map_or((None, None), |target| number(around, target));
    let (number, wrong) = number(around, source);
    let wrong = wrong_target.or(wrong);
    let place = if number.is_none() { whole } else { span };
    let known = |word: Word| target.map_or(word, |target| word.assigning(target));
    let signs = match (letter, sign.flatten()) {
        (Some(letter), _) if around.is_signed(letter) => Some((letter.end - 1, letter.end)),
        (_, Some(sign)) => Some((sign.start, sign.end)),
        (_, None) => None,
    };
    let (word, found) = match number {
        Some(source_number) if operands.is_empty() && (letter.is_some() || target.is_some()) => {
            let gap = signs.map(|(_, end)| Span::new(end, source.start)).filter(|gap| !gap.is_empty());
            let word = Word::with_parameter(address, span, source_number, signs.map(|(at, _)| around.byte(at)));
            (word, wrong.or_else(|| gap.map(|gap| behind_sign(around, span, gap))))
        }
        Some(_) if !operands.is_empty() => {
            let bare = Word::bare(address, place);
            (bare, wrong.or_else(|| Some(parameter_and_number(around, span, &operands))))
        }
        _ => (Word::bare(address, place), wrong),
    };
    found.map(|found| Diagnosis::saying(next.taken, found).with(known(word), place))
}

/// A number behind a parameter in its place.
fn parameter_and_number(around: &Around<'_>, span: Span, operands: &[Token]) -> Diagnostic {
    let computed = operands.iter().any(|operand| b"+-*/([{<".contains(&around.byte(operand.start)));
    if computed { around.malformed(span, NumberMeant::Computed) } else { around.diagnostic(span, split(String::new())) }
}

/// A blank behind the sign of a parameter.
fn behind_sign(around: &Around<'_>, span: Span, blanks: Span) -> Diagnostic {
    let joined = shown(&without_blanks(around.slice(span)));
    let found = around.diagnostic(span, split(joined.clone()));
    found.with_fix(Certain::BlankBehindSign, write(&joined), around.place(blanks), "")
}

/// `R96=5`, `R10=1,5`, `R10= - 5`: an assigned number.
pub(super) fn assigned(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let target = next.parameter()?;
    next.one(Kind::Equals);
    let sign = next.one(Kind::Sign);
    let first = next.number()?;
    let operands = next.operands();
    let span = target.span().to(operands.last().unwrap_or(&first).span());
    let (number, wrong) = number(around, target);
    let Some(number) = number else {
        return Some(Diagnosis { found: wrong, ..Diagnosis::of(next.taken) }.void(Address::R, span));
    };
    // A sign with a blank behind it splits the number like a blank inside it.
    let pieces = if sign.is_some() { [&[first], operands.as_slice()].concat() } else { operands };
    let run = around.slice(sign.unwrap_or(first).span());
    let broken = Broken { address: Address::R, prefix: &format!("R{number}="), run, pieces: &pieces, span };
    let (value, found) = broken.explain(around);
    let found = wrong.or(found)?;
    let word = value.map_or(Word::bare(Address::R, span), |value| Word::with_number(Address::R, span, value));
    Some(Diagnosis::saying(next.taken, found).with(word.assigning(number), span))
}

/// R and something that is no number of a parameter: `R-5`, `R-1=5`, `R=5`.
pub(super) fn radius(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.one(Kind::Junk(Shape::BareR))?;
    let mut last = next.number().or_else(|| next.assigned_value())?;
    while let Some(value) = next.assigned_value() {
        last = value;
    }
    Some(no_number(around, next.taken, first.span().to(last.span())))
}

/// R with what is no number of a parameter.
pub(super) fn no_number(around: &Around<'_>, tokens: usize, span: Span) -> Diagnosis {
    let found = around.malformed(span, NumberMeant::Parameter);
    functions::radius(around, Diagnosis::saying(tokens, found).void(Address::R, span))
}

/// `R10==5`.
pub(super) fn several_equals(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let target = next.parameter()?;
    next.one(Kind::Equals)?;
    std::iter::from_fn(|| next.one(Kind::Equals)).last()?;
    let span = target.span().to(next.number()?.span());
    Some(Diagnosis::saying(next.taken, around.malformed(span, NumberMeant::EqualsForm)).void(Address::R, span))
}

/// `R10=−5`, `R10=−R11`.
pub(super) fn odd_value(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let target = next.parameter()?;
    next.one(Kind::Equals)?;
    let odd = next.one(Kind::Junk(Shape::Unknown))?;
    let source = next.peek().filter(|source| source.kind == Kind::Parameter && source.start == odd.end);
    let value_span = odd.span().to(source.and_then(|_| next.parameter()).unwrap_or(odd).span());
    let span = target.span().to(value_span);
    let (number, wrong) = number(around, target);
    let plain = around.slice(value_span).replace(MINUS, "-");
    let known = value(Address::R, span, &plain).filter(|_| number.is_some());
    let found = around.characters(value_span, Meant::of(around.slice(odd.span())));
    let found = match known {
        Some(_) => found.with_fix(Certain::Minus, write(&plain), around.place(value_span), plain),
        None => found,
    };
    let word = known.unwrap_or(Word::bare(Address::R, span));
    let word = number.map_or(word, |number| word.assigning(number));
    let found = if number.is_none() { wrong.unwrap_or(found) } else { found };
    Some(Diagnosis::saying(next.taken, found).with(word, span))
}
