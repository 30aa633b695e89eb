//! Values from parameters, assignments and arithmetic (§4).

use super::executor::Executor;
use super::state::{Origin, Parameter};
use super::{arithmetic, block::Valued};
use crate::diag::{ArithmeticFault, Diagnostic, Finding, LabelText, ParameterNeed};
use crate::dict::{Address, Decimal, GCode, GGroup, PROGRAM_ENDS};
use crate::resolve::{FormFault, check_form, control_word};
use crate::syntax::{Value, Word};
use crate::text::Location;

impl Executor<'_, '_> {
    /// The value of a word, from before the block (PAR-4). `feed`: the G6 function that F is read by, when it is known.
    pub(super) fn evaluate(&mut self, word: Word) -> Option<Decimal> {
        match word.value() {
            Value::Number(number) => Some(number),
            Value::None => None,
            Value::Parameter { index, negated } => {
                let place = self.word_place(word);
                let value = self.read_parameter(index, place)?;
                Some(if negated { value.negated() } else { value })
            }
        }
    }

    /// A word whose value must have the form of its address, wherever it comes from (PAR-3).
    pub(super) fn evaluate_form(&mut self, word: Word, dwell: bool, feed: Option<GCode>) -> Valued {
        let value = self.evaluate(word);
        let Some(number) = value else { return Valued { word, value } };
        let parametric = word.is_parametric();
        if !parametric && feed.is_none() && !dwell && word.address != Address::Q {
            return Valued { word, value };
        }
        match check_form(&self.settings.machine, word.address, number, dwell, feed) {
            Ok(()) => Valued { word, value },
            Err(fault) => {
                self.report_form(word, number, fault);
                Valued { word, value: None }
            }
        }
    }

    fn report_form(&mut self, word: Word, value: Decimal, fault: FormFault) {
        let address = word.address;
        let needs = match fault {
            FormFault::Fraction => ParameterNeed::Whole,
            FormFault::Digits => ParameterNeed::CorrectionDigits,
            FormFault::Range(range) if !word.is_parametric() => {
                let place = self.value_place(word);
                self.report(Diagnostic::new(Finding::ValueOutOfRange { address, range }, place));
                return;
            }
            FormFault::Range(range) => ParameterNeed::Range(range),
        };
        self.report_unusable(word, value, needs);
    }

    /// E0510 at the word, with where its parameter got the value.
    pub(super) fn report_unusable(&mut self, word: Word, value: Decimal, needs: ParameterNeed) {
        let Value::Parameter { index, .. } = word.value() else { return };
        let finding = Finding::UnusableParameterValue {
            address: word.address,
            parameter: index,
            value: value.to_string(),
            needs,
        };
        let diagnostic = Diagnostic::new(finding, self.word_place(word));
        let diagnostic = self.with_parameter_label(diagnostic, index);
        self.report(diagnostic);
    }

    /// Adds where a parameter got its value.
    pub(super) fn with_parameter_label(&self, diagnostic: Diagnostic, index: u8) -> Diagnostic {
        let Some(parameter) = self.state.parameters.get(usize::from(index)) else { return diagnostic };
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
    pub(super) fn with_origin(&self, diagnostic: Diagnostic, word: Word) -> Diagnostic {
        match word.value() {
            Value::Parameter { index, .. } => self.with_parameter_label(diagnostic, index),
            Value::None | Value::Number(_) => diagnostic,
        }
    }

    /// The value of a parameter read at `place`; reports the first read of one that the program never assigned (PAR-5).
    fn read_parameter(&mut self, index: u8, place: Location) -> Option<Decimal> {
        let parameter = self.state.parameters.get(usize::from(index)).copied()?;
        if parameter.value.is_none() && matches!(parameter.origin, Origin::Machine) {
            let warned = self.unassigned_warned.get_mut(usize::from(index));
            if let Some(warned @ false) = warned {
                *warned = true;
                self.report(Diagnostic::new(Finding::UnassignedParameter { parameter: index }, place));
            }
        }
        parameter.value
    }

    fn assign(&mut self, index: u8, value: Option<Decimal>, at: Location) {
        if let Some(slot) = self.state.parameters.get_mut(usize::from(index)) {
            *slot = Parameter { value, origin: Origin::Word(at) };
        }
        if self.wants_records {
            match self.record.params.binary_search_by_key(&index, |(parameter, _)| *parameter) {
                Ok(place) => {
                    self.record.params.remove(place);
                    self.note_parameter(index, value);
                }
                Err(_) => self.note_parameter(index, value),
            }
        }
    }

    fn note_parameter(&mut self, index: u8, value: Option<Decimal>) {
        if let Some(value) = value {
            let place = self.record.params.partition_point(|(parameter, _)| *parameter < index);
            self.record.params.insert(place, (index, value));
        }
    }

    /// The block's assignments, from the values before it, then its arithmetic (PAR-4, PAR-7).
    pub(super) fn run_parameters(&mut self) {
        if self.words.r.is_empty() && self.words.written(GGroup::G4).is_none() {
            return;
        }
        let r_words = std::mem::take(&mut self.words.r);
        let mut values = Vec::with_capacity(r_words.len());
        for &word in &r_words {
            values.push(self.evaluate(word));
        }
        for (&word, &value) in r_words.iter().zip(&values) {
            let at = self.word_place(word);
            self.assign(word.target(), value, at);
        }
        if let Some((function, g_word)) = self.words.written(GGroup::G4) {
            self.run_arithmetic(function, g_word, &r_words, &values);
        }
        self.words.r = r_words;
    }

    fn run_arithmetic(&mut self, function: GCode, g_word: Word, r_words: &[Word], values: &[Option<Decimal>]) {
        let mut missing = Vec::new();
        for parameter in (5..).take(function.operations()) {
            let control = r_words.iter().zip(values).find(|(word, _)| word.target() == parameter);
            match control {
                None => missing.push(format!("R{parameter}")),
                Some((&word, &value)) => self.run_operation(word, value),
            }
        }
        // Found before execution when the function is written out.
        if !missing.is_empty() && g_word.is_parametric() {
            let finding = Finding::MissingControlWord { function, missing: missing.join(", ") };
            self.report(Diagnostic::new(finding, self.word_place(g_word)));
        }
    }

    /// One operation of G26–G29.
    fn run_operation(&mut self, word: Word, value: Option<Decimal>) {
        let Some(value) = value else { return };
        let parametric = word.is_parametric();
        let place = if parametric { self.word_place(word) } else { self.value_place(word) };
        let control = match control_word(&self.settings.machine, value) {
            Ok(control) => control,
            Err(finding) => {
                let diagnostic = Diagnostic::new(finding, place);
                let diagnostic = self.with_origin(diagnostic, word);
                self.report(diagnostic);
                return;
            }
        };
        let first = self.read_parameter(control.first, place);
        let second = match control.second {
            Some(index) => self.read_parameter(index, place),
            None => Some(Decimal::ZERO),
        };
        let result = match (first, second) {
            (Some(first), Some(second)) => match arithmetic::compute(control.operation, first, second, control.whole) {
                Ok(result) => Some(result),
                Err(what) => {
                    self.report_arithmetic(place, what, control.first, control.second);
                    None
                }
            },
            _ => None,
        };
        let at = self.word_place(word);
        self.assign(control.result, result, at);
    }

    fn report_arithmetic(&mut self, place: Location, what: ArithmeticFault, first: u8, second: Option<u8>) {
        let diagnostic = Diagnostic::new(Finding::ArithmeticError { what }, place);
        let mut diagnostic = self.with_parameter_label(diagnostic, first);
        if let Some(second) = second.filter(|second| *second != first) {
            diagnostic = self.with_parameter_label(diagnostic, second);
        }
        self.report(diagnostic);
    }

    /// The G function that a word gives, also from a parameter (PAR-3, BLK-10).
    pub(super) fn evaluate_g(&mut self, word: Word) -> Option<GCode> {
        let Some(value) = self.evaluate(word) else {
            self.words.unknown_g = true;
            return None;
        };
        let number = value.as_whole().and_then(|number| u8::try_from(number).ok()).filter(|number| *number <= 99);
        let Some(number) = number else {
            let needs = if value.is_whole() { ParameterNeed::Range("0–99".to_owned()) } else { ParameterNeed::Whole };
            self.report_unusable(word, value, needs);
            self.words.unknown_g = true;
            return None;
        };
        let Some(code) = GCode::from_number(number) else {
            let diagnostic = Diagnostic::new(Finding::UnknownG { number: u32::from(number) }, self.word_place(word));
            let diagnostic = self.with_origin(diagnostic, word);
            self.report(diagnostic);
            self.words.unknown_g = true;
            return None;
        };
        if word.is_parametric() && matches!(code, GCode::G70 | GCode::G79) {
            self.report_unusable(word, value, ParameterNeed::WrittenOut(code.to_string()));
            return None;
        }
        Some(code)
    }

    /// The M function that a word gives, also from a parameter (PAR-3, BLK-10).
    pub(super) fn evaluate_m(&mut self, word: Word) -> Option<u8> {
        let valued = self.evaluate_form(word, false, None);
        let value = valued.value?;
        let number = value.as_whole().and_then(|number| u8::try_from(number).ok())?;
        if word.is_parametric() && PROGRAM_ENDS.contains(&number) {
            self.report_unusable(word, value, ParameterNeed::WrittenOut(format!("M{number:02}")));
            return None;
        }
        Some(number)
    }
}
