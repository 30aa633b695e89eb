//! Values from parameters, assignments and arithmetic (§4).

use super::arithmetic;
use super::block::Block;
use super::site::Site;
use super::state::{Origin, Parameter, State};
use super::words::BlockWords;
use crate::diag::{ArithmeticFault, Diagnostic, Finding, LabelText, ParameterNeed};
use crate::dict::{Address, Decimal, FIRST_CONTROL, GCode, GGroup, LAST_CONTROL, PROGRAM_ENDS};
use crate::resolve::{
    FormFault, check_form, control_result, control_word, feed_mode_before, may_assign, missing_control_words,
    value_or_word, with_feed_mode,
};
use crate::syntax::{Value, Word};
use crate::text::Location;

/// The value of a word, from before the block (PAR-4).
fn evaluate(site: &mut Site<'_>, state: &mut State, word: Word) -> Option<Decimal> {
    match word.value() {
        Value::Number(number) => Some(number),
        Value::None => None,
        Value::Parameter { index, negated } => {
            let place = site.word_place(word);
            let value = read(site, state, index, place)?;
            Some(if negated { value.negated() } else { value })
        }
    }
}

/// The value of a word, which must have the form of its address, wherever it comes from (PAR-3). `feed`: the G6
/// function that F is read by, when it is known; `dwell`: Q belongs to G04.
#[inline]
pub(super) fn evaluate_form(
    site: &mut Site<'_>,
    state: &mut State,
    word: Word,
    dwell: bool,
    feed: Option<GCode>,
) -> Option<Decimal> {
    // What is written was looked at before execution, but for what depends on the functions in force.
    if feed.is_none()
        && word.address != Address::Q
        && let Some(number) = word.number()
    {
        return Some(number);
    }
    evaluate_in_form(site, state, word, dwell, feed)
}

fn evaluate_in_form(
    site: &mut Site<'_>,
    state: &mut State,
    word: Word,
    dwell: bool,
    feed: Option<GCode>,
) -> Option<Decimal> {
    let number = evaluate(site, state, word)?;
    match check_form(site.machine(), word.address, number, dwell, feed) {
        Ok(()) => Some(number),
        Err(fault) => {
            report_form(site, state, (word, feed), number, fault);
            None
        }
    }
}

fn report_form(
    site: &mut Site<'_>,
    state: &State,
    (word, feed): (Word, Option<GCode>),
    value: Decimal,
    fault: FormFault,
) {
    let needs = match fault {
        FormFault::Fraction => ParameterNeed::Whole,
        FormFault::Digits => ParameterNeed::CorrectionDigits,
        FormFault::Range(range) if !word.is_parametric() => {
            let finding = Finding::ValueOutOfRange { address: word.address, range, mode: feed, call: None };
            let diagnostic = Diagnostic::new(finding, site.value_place(word));
            let here =
                site.file.words(site.block).iter().any(|word| word.g_code().is_some_and(|code| Some(code) == feed));
            let there = feed_mode_before(site.file, site.block).filter(|(code, _)| !here && Some(*code) == feed);
            site.report(with_feed_mode(diagnostic, site.file, there));
            return;
        }
        FormFault::Range(range) => ParameterNeed::Range(range),
    };
    report_unusable(site, state, word, value, needs);
}

/// E0510 at the word, with where its parameter got the value.
pub(super) fn report_unusable(site: &mut Site<'_>, state: &State, word: Word, value: Decimal, needs: ParameterNeed) {
    let Value::Parameter { index, .. } = word.value() else { return };
    let value = value.to_string();
    let finding = Finding::UnusableParameterValue { address: word.address, parameter: index, value, needs };
    let diagnostic = Diagnostic::new(finding, site.word_place(word));
    site.report(with_parameter_label(state, diagnostic, index));
}

/// Adds where a parameter got its value.
fn with_parameter_label(state: &State, diagnostic: Diagnostic, index: u8) -> Diagnostic {
    let Some(parameter) = state.parameters.get(usize::from(index)) else { return diagnostic };
    let Some(value) = parameter.value.map(|value| value.to_string()) else { return diagnostic };
    match parameter.origin {
        Origin::Word(at) => diagnostic.with_label(at, LabelText::ParameterValue { parameter: index, value }),
        Origin::Configured => {
            let at = diagnostic.at;
            diagnostic.with_label(at, LabelText::ParameterGiven { parameter: index, value })
        }
        Origin::Machine => diagnostic,
    }
}

/// The same for a word, when its value comes from a parameter.
pub(super) fn with_origin(state: &State, diagnostic: Diagnostic, word: Word) -> Diagnostic {
    match word.value() {
        Value::Parameter { index, .. } => with_parameter_label(state, diagnostic, index),
        Value::None | Value::Number(_) => diagnostic,
    }
}

/// The value of a parameter read at `place`; notes the first read of one that the program never assigned, and reports
/// it when nobody gave it a value (PAR-5).
fn read(site: &mut Site<'_>, state: &mut State, index: u8, place: Location) -> Option<Decimal> {
    let parameter = state.parameters.get(usize::from(index)).copied()?;
    if matches!(parameter.origin, Origin::Machine | Origin::Configured)
        && let Some(read @ false) = state.said.read_outside.get_mut(usize::from(index))
    {
        *read = true;
        if parameter.value.is_some() {
            return parameter.value;
        }
        // What cannot be read has its finding.
        if !state.compiled && site.resolved.files().any(|file| may_assign(file, index)) {
            return None;
        }
        site.found(Finding::UnassignedParameter { parameter: index, compiled: state.compiled }, place);
    }
    parameter.value
}

fn assign(state: &mut State, params: &mut Vec<(u8, Decimal)>, index: u8, value: Option<Decimal>, at: Location) {
    if let Some(slot) = state.parameters.get_mut(usize::from(index)) {
        *slot = Parameter { value, origin: Origin::Word(at) };
    }
    let place = params.partition_point(|(parameter, _)| *parameter < index);
    if params.get(place).is_some_and(|(parameter, _)| *parameter == index) {
        params.remove(place);
    }
    if let Some(value) = value {
        params.insert(place, (index, value));
    }
}

/// The block's assignments, from the values before it, then its arithmetic (PAR-4, PAR-7).
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, block: &mut Block) {
    let Block { words, params, .. } = block;
    let function = words.written(GGroup::G4);
    let clash = words.clashes.has(GGroup::G4);
    if words.r.is_empty() && function.is_none() && !clash {
        return;
    }
    let mut times = state.parameters.each_ref().map(|_| 0_u32);
    for word in &words.r {
        if let Some(times) = times.get_mut(usize::from(word.target())) {
            *times += 1;
        }
    }
    let mut values = Vec::with_capacity(words.r.len());
    for &word in &words.r {
        let value = evaluate(site, state, word);
        // Of a parameter that is assigned twice (E0306) nobody knows which was meant.
        let twice = times.get(usize::from(word.target())).is_some_and(|times| *times > 1);
        values.push((word, value.filter(|_| !twice)));
    }
    for &(word, value) in &values {
        assign(state, params, word.target(), value, site.word_place(word));
    }
    let control = |parameter: u8| values.iter().copied().find(|(word, _)| word.target() == parameter);
    let controlled = (FIRST_CONTROL..=LAST_CONTROL).any(|parameter| control(parameter).is_some());
    // An R without a number of its own, and arithmetic of which nobody knows the operations, may assign any parameter.
    let nameless = words.r.iter().any(|word| usize::from(word.target()) >= state.parameters.len());
    let mut anything = nameless || clash || (words.unknown_g && controlled);
    if let Some((function, g_word)) = function {
        for parameter in (FIRST_CONTROL..).take(function.operations()) {
            if let Some((word, value)) = control(parameter)
                && operate(site, state, params, word, value) == Told::Nothing
            {
                anything = true;
                // The next operation reads what this one may have assigned.
                forget_others(state, params, &values, site.block_place());
            }
        }
        if let Some(finding) = missing_control_words(function, |parameter| control(parameter).is_some()) {
            anything = true;
            // Found before execution when the function is written out.
            if g_word.is_parametric() {
                site.found(finding, site.word_place(g_word));
            }
        } else if g_word.is_parametric() {
            let used = FIRST_CONTROL + u8::try_from(function.operations()).unwrap_or(0);
            for parameter in used..=LAST_CONTROL {
                if let Some((word, _)) = control(parameter).filter(|(word, _)| !word.is_void()) {
                    let finding = Finding::SuperfluousControlWord { function, parameter };
                    let diagnostic = Diagnostic::new(finding, site.word_place(word));
                    site.report(with_origin(state, diagnostic, g_word));
                }
            }
        }
    }
    if anything {
        forget_others(state, params, &values, site.block_place());
    }
}

/// Nobody knows any more what the parameters hold that the block does not assign (§13).
fn forget_others(
    state: &mut State,
    params: &mut Vec<(u8, Decimal)>,
    assigned: &[(Word, Option<Decimal>)],
    at: Location,
) {
    for index in (0..).take(state.parameters.len()) {
        if !assigned.iter().any(|(word, _)| word.target() == index) {
            assign(state, params, index, None, at);
        }
    }
}

/// A control word, decoded.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Told {
    /// Which parameter receives the result, at least.
    Result,
    /// Not even that.
    Nothing,
}

/// The least control word: an operation, and two digits for each parameter.
const SHORTEST: i64 = 1_000_000;

/// One operation of G26–G29.
fn operate(
    site: &mut Site<'_>,
    state: &mut State,
    params: &mut Vec<(u8, Decimal)>,
    word: Word,
    value: Option<Decimal>,
) -> Told {
    let Some(value) = value else { return Told::Nothing };
    let place = value_or_word(site.file, word);
    let control = match control_word(site.machine(), value) {
        Ok(control) => control,
        Err(finding) => {
            // Found before execution when it is written out; an operation that is not configured is said once.
            let new = if let Finding::UnknownOperation { operation, .. } = finding {
                state.said.operations.insert(operation)
            } else {
                true
            };
            if word.is_parametric() && new {
                site.report(with_origin(state, Diagnostic::new(finding, place), word));
            }
            // Less than seven digits have no operation: the others may be anything.
            let short = value.abs() < Decimal::whole(SHORTEST);
            let Some(result) = control_result(value).filter(|_| !short) else { return Told::Nothing };
            assign(state, params, result, None, site.word_place(word));
            return Told::Result;
        }
    };
    let first = read(site, state, control.first, place);
    let second = match control.second {
        Some(index) => read(site, state, index, place),
        None => Some(Decimal::ZERO),
    };
    let result = match (first, second) {
        (Some(first), Some(second)) => match arithmetic::compute(control.operation, first, second, control.whole) {
            Ok(result) => Some(result),
            Err(what) => {
                report_arithmetic(site, state, place, what, control.first, control.second);
                None
            }
        },
        _ => None,
    };
    assign(state, params, control.result, result, site.word_place(word));
    Told::Result
}

fn report_arithmetic(
    site: &mut Site<'_>,
    state: &State,
    place: Location,
    what: ArithmeticFault,
    first: u8,
    second: Option<u8>,
) {
    let diagnostic = Diagnostic::new(Finding::ArithmeticError { what }, place);
    let mut diagnostic = with_parameter_label(state, diagnostic, first);
    if let Some(second) = second.filter(|second| *second != first) {
        diagnostic = with_parameter_label(state, diagnostic, second);
    }
    site.report(diagnostic);
}

/// The G function that a word gives, also from a parameter (PAR-3, BLK-10).
pub(super) fn evaluate_g(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) -> Option<GCode> {
    let Some(value) = evaluate(site, state, word) else {
        (words.unknown_g, words.malformed_g) = (true, true);
        return None;
    };
    let number = value.as_whole().and_then(|number| u8::try_from(number).ok()).filter(|number| *number <= 99);
    let Some(number) = number else {
        let needs = if value.is_whole() { ParameterNeed::Range("0–99".to_owned()) } else { ParameterNeed::Whole };
        report_unusable(site, state, word, value, needs);
        (words.unknown_g, words.malformed_g) = (true, true);
        return None;
    };
    let Some(code) = GCode::from_number(number) else {
        let diagnostic = Diagnostic::new(Finding::UnknownG { number: u32::from(number) }, site.word_place(word));
        site.report(with_origin(state, diagnostic, word));
        words.unknown_g = true;
        return None;
    };
    if word.is_parametric() && matches!(code, GCode::G70 | GCode::G79) {
        report_unusable(site, state, word, value, ParameterNeed::WrittenOut(code.to_string()));
        words.unknown_g = true;
        return None;
    }
    Some(code)
}

/// The M function that a word gives, also from a parameter (PAR-3, BLK-10).
pub(super) fn evaluate_m(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) -> Option<u8> {
    let value = evaluate_form(site, state, word, false, None);
    let whole = |value: Decimal| Some((value, u8::try_from(value.as_whole()?).ok()?));
    let Some((value, number)) = value.and_then(whole) else {
        words.malformed_m = true;
        return None;
    };
    if word.is_parametric() && PROGRAM_ENDS.contains(&number) {
        report_unusable(site, state, word, value, ParameterNeed::WrittenOut(format!("M{number:02}")));
        return None;
    }
    Some(number)
}
