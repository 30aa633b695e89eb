//! Words and signs as other controls, programs and text processors write them: each is one finding, with what is written
//! here instead.

use super::lower::{Lowering, PARAMETERS, printed_number, split};
use super::number::Number;
use super::{BlockFlags, Kind, Token, Word};
use crate::diag::{
    AddressMeant, Certain, Diagnostic, Finding, FixTitle, MINUS, Meant, NumberMeant, TargetMeant, ValueMeant, is_blank,
    shown,
};
use crate::dict::{Address, GCode, HIGHEST_L};
use crate::sure::{Sure, small};
use crate::text::Span;

/// What stands where a number should.
enum Written {
    Number(Number),
    /// A parameter, and the sign before it.
    Parameter(u8, Option<u8>),
}

/// The value that `text` is, when nothing else is in it.
fn written(text: &str) -> Option<Written> {
    if let Some(number) = Number::parse(text.as_bytes()) {
        return Some(Written::Number(number));
    }
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = text.as_bytes().first().copied().filter(|_| unsigned.len() < text.len());
    let digits = unsigned.strip_prefix(['R', 'r'])?;
    parameter_number(digits).map(|number| Written::Parameter(number, sign))
}

/// A word whose address has an accent, and what it is without: `Ý40`.
fn accented_word(text: &str) -> Option<(Address, String)> {
    const LETTERS: [(char, char); 15] = [
        ('Á', 'A'),
        ('Č', 'C'),
        ('Ď', 'D'),
        ('Í', 'I'),
        ('Ľ', 'L'),
        ('Ĺ', 'L'),
        ('Š', 'S'),
        ('Ť', 'T'),
        ('Ú', 'U'),
        ('Ů', 'U'),
        ('Ý', 'Y'),
        ('Ž', 'Z'),
        ('Ć', 'C'),
        ('Ź', 'Z'),
        ('Ż', 'Z'),
    ];
    let first = text.chars().next()?;
    let upper = first.to_uppercase().next()?;
    let (_, letter) = LETTERS.into_iter().find(|(accented, _)| *accented == upper)?;
    let number = text.get(first.len_utf8()..).filter(|number| Number::parse(number.as_bytes()).is_some())?;
    Some((Address::from_byte(u8::try_from(letter).ok()?)?, format!("{letter}{number}")))
}

fn parameter_number(digits: &str) -> Option<u8> {
    let whole = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|number| whole && *number < PARAMETERS)
}

/// `R11` of `(R11)`, `-5` of `-(5)`: a value that stands alone between brackets.
fn unbracketed(value: &str) -> Option<String> {
    let value = value.trim_matches([' ', '\t']);
    let inner = value.strip_prefix(['+', '-']).unwrap_or(value);
    let sign = value.get(..value.len() - inner.len())?;
    let inner = inner.trim_start_matches([' ', '\t']);
    let close = inner.chars().next_back().filter(|close| ")]}>'`".contains(*close))?;
    let inner = inner.get(1..inner.len() - close.len_utf8())?.trim_matches([' ', '\t']).to_ascii_uppercase();
    let both = !sign.is_empty() && inner.starts_with(['+', '-']);
    let whole = format!("{sign}{inner}");
    written(&whole).filter(|_| !both).map(|_| whole)
}

impl Lowering<'_> {
    pub(super) fn foreign(&mut self, token: Token) {
        let handle = [
            (Kind::PrintedWord, Self::printed_word as fn(&mut Self, Token)),
            (Kind::AssignedWord, Self::assigned_word),
            (Kind::NamedValue, Self::named_value),
            (Kind::Variable, Self::variable),
            (Kind::ForeignStart, Self::foreign_start),
            (Kind::JumpTarget, Self::jump_target),
            (Kind::MixedNumber, Self::mixed_number),
            (Kind::LostNumber, Self::lost_number),
            (Kind::Unit, Self::unit),
        ];
        if let Some((_, handle)) = handle.into_iter().find(|(kind, _)| *kind == token.kind) {
            handle(self, token);
        }
    }

    /// A finding with an offer to write `text` over all of it.
    fn report_with_text(&mut self, span: Span, finding: Finding, text: String) {
        let place = self.at(span);
        let title = FixTitle::Write { text: shown(&text) };
        self.pending.push(Diagnostic::new(finding, place).with_offer(title, place, text));
    }

    /// A finding about a typographic minus or a foreign blank in a number, fixed by `text` over all of it.
    fn report_sign(&mut self, span: Span, finding: Finding, text: String) {
        let place = self.at(span);
        let title = FixTitle::Write { text: shown(&text) };
        self.pending.push(Diagnostic::new(finding, place).with_fix(Certain::Minus, title, place, text));
    }

    fn push_written(&mut self, address: Address, span: Span, written: &Written) {
        let word = match written {
            Written::Number(number) => Word::with_number(address, span, *number),
            Written::Parameter(number, sign) => Word::with_parameter(address, span, *number, *sign),
        };
        self.push(word.faulty(), span);
    }

    pub(super) fn push_void(&mut self, address: Address, span: Span) {
        self.push(Word::bare(address, span).faulty(), span);
    }

    /// `X1.5E-05`, `S1.2E+03`, `XNaN`, `FMAX`.
    fn printed_word(&mut self, token: Token) {
        let span = token.span();
        let Some(address) = self.address(token.start, span) else { return };
        let text = self.slice(span);
        let number = text.get(1..).sure();
        let prefix = address.to_string();
        let fastest = ["max", "auto"].iter().any(|name| number.eq_ignore_ascii_case(name));
        let meant = if fastest { NumberMeant::Fastest } else { printed_number(number, &prefix) };
        let exponent = matches!(meant, NumberMeant::Exponent { .. } | NumberMeant::ExponentForm);
        let meant = if exponent && address == Address::R { NumberMeant::Parameter } else { meant };
        let value_of = |written: &str| Number::parse(written.get(1..).sure().as_bytes());
        // Other words hold whole numbers without a sign, `&` four digits.
        let fits = |value: Number| {
            address.is_dimensional()
                || address == Address::F
                || (address != Address::Correction && !value.point && !value.minus)
        };
        let unfit = matches!(&meant, NumberMeant::Exponent { written } if !value_of(written).is_some_and(fits));
        let meant = if unfit { NumberMeant::ExponentForm } else { meant };
        let finding = Finding::MalformedNumber { text: shown(text), meant: meant.clone() };
        if let NumberMeant::Exponent { written } = meant
            && let Some(value) = value_of(&written)
            // A feed of zero is none.
            && (address != Address::F || value.value.thousandths() != 0)
        {
            self.report_with_text(span, finding, written);
            self.push_written(address, span, &Written::Number(value));
        } else {
            self.report(span, finding);
            self.push_void(address, span);
        }
    }

    /// `Z=R32`, `X=5`, `X=IC(5)`, `S1=1000`.
    fn assigned_word(&mut self, token: Token) {
        let span = token.span();
        let Some(address) = self.address(token.start, span) else { return };
        let text = self.slice(span);
        if token.start.checked_sub(1).is_some_and(|before| self.byte(before).is_ascii_alphanumeric()) {
            // `R5v=1`, `RW5=1`
            self.junk(span);
        }
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let value = value.trim_matches([' ', '\t']);
        let plain = name.trim_end_matches([' ', '\t']).len() == 1;
        let numbered = matches!(address, Address::N | Address::Program);
        let product = self.byte(span.end) == b'*';
        let value_written = written(value)
            .filter(|written| plain && !product && !(numbered && matches!(written, Written::Parameter(..))));
        let upper = value.to_ascii_uppercase();
        if let Some(written) = value_written {
            let text_here = format!("{address}{upper}");
            let meant = NumberMeant::Equals { written: shown(&text_here) };
            let finding = Finding::MalformedNumber { text: shown(text), meant };
            self.report_with_text(span, finding, text_here);
            self.push_written(address, span, &written);
            return;
        }
        let digits = name.get(1..).sure().trim_matches([' ', '\t']);
        // `S1=1200`, `M1=3`: of one spindle among several.
        let of_spindle = matches!(address, Address::S | Address::M) && !digits.is_empty() && !product;
        if let Some(Written::Number(number)) = written(value).filter(|_| of_spindle) {
            let text_here = format!("{address}{upper}");
            let meant = NumberMeant::OneSpindle { written: shown(&text_here) };
            let place = self.at(span);
            let diagnostic = Diagnostic::new(Finding::MalformedNumber { text: shown(text), meant }, place);
            self.pending.push(diagnostic.with_offer(FixTitle::Write { text: shown(&text_here) }, place, text_here));
            self.push_written(address, span, &Written::Number(number));
            return;
        }
        let computed = product || upper.contains('R') && upper.contains(['+', '-', '*', '/']);
        let meant = if upper.starts_with("IC(") || upper.starts_with("AC(") {
            let of_center = matches!(address, Address::I | Address::J | Address::K);
            if of_center { NumberMeant::FromStart } else { NumberMeant::Distance }
        } else if computed {
            NumberMeant::Computed
        } else if address == Address::T && value.starts_with('"') {
            NumberMeant::ToolName
        } else {
            NumberMeant::EqualsForm
        };
        self.report(span, Finding::MalformedNumber { text: shown(text), meant });
        self.push_void(address, span);
    }

    /// `CR=5`, `LIMS=2000`.
    fn named_value(&mut self, token: Token) {
        let span = token.span();
        let name = self.slice(span).split(['=', ' ', '\t']).next().sure();
        let meant = AddressMeant::by_name(name);
        let radius = meant == AddressMeant::Radius;
        self.debris(span, Finding::UnknownAddress { address: shown(name), meant });
        if radius {
            // The centre of the arc was given, in a way that is none here.
            self.push_void(Address::I, span);
        } else if name.starts_with(['R', 'r']) {
            // `RL=5`: a parameter, nobody knows which.
            self.push_void(Address::R, span);
        }
    }

    /// `#50=0`.
    fn variable(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let target = parameter_number(name.trim_matches(['#', ' ', '\t']));
        let value = value.trim_matches([' ', '\t']);
        if self.byte(span.end) == b'*' {
            // `#10=#11*2`
            let rest = self.text.get(span.end as usize..).sure();
            let length = rest.find([' ', '\t', '\r', '\n', '"']).unwrap_or(rest.len());
            let whole = Span::new(span.start, span.end + small(length));
            let finding = Finding::UnknownCharacter { text: shown(self.slice(whole)), meant: Meant::Expression };
            self.debris(whole, finding);
            if let Some(target) = target {
                self.push(Word::bare(Address::R, span).assigning(target).faulty(), span);
            }
            return;
        }
        let as_parameter = value.strip_prefix('#').map(|digits| format!("R{digits}"));
        let value = as_parameter.as_deref().unwrap_or(value);
        if let (Some(target), Some(written)) = (target, written(value)) {
            let text_here = format!("R{target}={}", value.to_ascii_uppercase());
            let meant = Meant::Variable { written: shown(&text_here) };
            self.report_with_text(span, Finding::UnknownCharacter { text: shown(text), meant }, text_here);
            let word = match written {
                Written::Number(number) => Word::with_number(Address::R, span, number),
                Written::Parameter(number, sign) => Word::with_parameter(Address::R, span, number, sign),
            };
            self.push(word.assigning(target).faulty(), span);
            return;
        }
        self.debris(span, Finding::UnknownCharacter { text: shown(text), meant: Meant::Expression });
        if let Some(target) = target {
            self.push(Word::bare(Address::R, span).assigning(target).faulty(), span);
        }
    }

    /// `%`, and on the next line `O2107`.
    fn foreign_start(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let digits = text.trim_start_matches(|character: char| !character.is_ascii_digit());
        let text_here = format!("%{digits}");
        let percent = self.at(Span::new(token.start, token.start + 1));
        let fixed = shown(&text_here);
        let meant = ValueMeant::Written { written: fixed.clone() };
        let finding = Finding::MissingValue { address: "%".to_owned(), meant };
        let title = FixTitle::Write { text: fixed };
        self.pending.push(Diagnostic::new(finding, percent).with_offer(title, self.at(span), text_here));
        match Number::parse(digits.as_bytes()) {
            Some(number) => self.push_written(Address::Program, span, &Written::Number(number)),
            None => self.push_void(Address::Program, span),
        }
    }

    /// The block number that stands behind G71, G72 or G73, where the `L` of its target belongs.
    fn jump_target(&mut self, token: Token) {
        let span = token.span();
        let number = self.slice(span).get(1..).sure().trim_start_matches([' ', '\t']);
        let last = self.words.last().copied().filter(|word| word.address == Address::G);
        let code = last.and_then(|word| word.whole()).and_then(|number| u8::try_from(number).ok());
        let function = code.and_then(GCode::from_number).unwrap_or(GCode::G73);
        let place = self.at(last.map_or(span, |word| word.span(self.text)));
        let target = Number::parse(number.as_bytes()).filter(|_| {
            // A subprogram has a number of its own, which is not that of a block.
            function == GCode::G73 && number.parse().is_ok_and(|number: u32| (1..=HIGHEST_L).contains(&number))
        });
        let Some(target) = target else {
            let meant = TargetMeant::of(function);
            let subprogram = meant == TargetMeant::Subprogram;
            let meant = if subprogram { TargetMeant::InPlace { block: shown(self.slice(span)) } } else { meant };
            self.pending.push(Diagnostic::new(Finding::MissingTarget { function, meant }, place));
            self.push_void(Address::L, span);
            return;
        };
        let text = format!("L{number}");
        let meant = TargetMeant::Written { written: shown(&text) };
        let title = FixTitle::Write { text: shown(&text) };
        let letter = self.at(Span::new(token.start, token.start + 1));
        let diagnostic = Diagnostic::new(Finding::MissingTarget { function, meant }, place);
        self.pending.push(diagnostic.with_offer(title, letter, "L"));
        self.push_written(Address::L, span, &Written::Number(target));
    }

    /// An address or a parameter without a value.
    pub(super) fn valueless(&mut self, address: Token, end: Token, beyond: bool) {
        let span = address.span().to(end.span());
        let text = self.slice(address.span());
        if address.kind == Kind::LooseParameter && text.contains(['.', ',']) {
            self.radius(address, span);
            return;
        }
        let name: String = text
            .chars()
            .filter(|character| !matches!(character, ' ' | '\t' | '+' | '-' | '.' | ','))
            .map(|character| character.to_ascii_uppercase())
            .collect();
        let digits = name.strip_prefix('R').unwrap_or_default();
        let target = parameter_number(digits);
        if !digits.is_empty() && target.is_none() {
            self.parameter(address);
            self.push_void(Address::R, span);
            return;
        }
        let skipped = self.number_behind_skip(address, end);
        let meant = match skipped {
            Some(written) => ValueMeant::Written { written },
            None if beyond => ValueMeant::Beyond,
            None => ValueMeant::Number,
        };
        let finding = Finding::MissingValue { address: name, meant };
        let Some(address) = self.address(address.start, span) else { return };
        self.junk(span);
        self.report(span, finding);
        let word = Word::bare(address, span).faulty();
        self.push(target.map_or(word, |target| word.assigning(target)), span);
    }

    /// `N/30`: the block number behind the `/` that belongs behind it.
    fn number_behind_skip(&self, address: Token, end: Token) -> Option<String> {
        let rest = self.text.get(end.end as usize..)?.strip_prefix('/')?;
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        let numbered = matches!(self.byte(address.start), b'N' | b'n') && !digits.is_empty();
        numbered.then(|| format!("N{digits} /"))
    }

    /// `XR`: an address, and R without the number of the parameter.
    pub(super) fn no_parameter(&mut self, address: Token, parameter: Token) {
        let span = address.span().to(parameter.span());
        let Some(address) = self.address(address.start, span) else { return };
        let finding = Finding::MissingValue { address: "R".to_owned(), meant: ValueMeant::Parameter };
        self.report(parameter.span(), finding);
        self.push_void(address, span);
    }

    /// `R1 0=5`: a blank in the number of a parameter.
    pub(super) fn split_parameter(&mut self, target: Token, value: Token) {
        let span = target.span().to(value.span());
        let joined: String = self.slice(span).chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
        let joined = joined.to_ascii_uppercase();
        let (name, text) = joined.split_once('=').unwrap_or((&joined, ""));
        let number = name.strip_prefix('R').and_then(parameter_number);
        let (Some(number), Some(written)) = (number, written(text)) else {
            self.radius(target, span);
            return;
        };
        let word = match written {
            Written::Number(value) => Word::with_number(Address::R, span, value),
            Written::Parameter(source, sign) => Word::with_parameter(Address::R, span, source, sign),
        };
        self.report_with_text(span, split(shown(&joined)), joined);
        self.push(word.assigning(number).faulty(), span);
    }

    /// A value between brackets: `Z(R11)`, `R1=(R2+1)`.
    pub(super) fn bracketed(&mut self, first: Token, last: Token) {
        let span = first.span().to(last.span());
        let text = self.slice(span);
        let is_parameter = matches!(first.kind, Kind::Parameter | Kind::LooseParameter);
        let (target, prefix, value) = if is_parameter {
            let (target, faulty) = self.parameter(first);
            let Some(target) = target.filter(|_| !faulty) else {
                self.push_void(Address::R, span);
                return;
            };
            let value = text.split_once('=').map_or("", |(_, value)| value);
            (Some(target), format!("R{target}="), value)
        } else {
            let Some(address) = self.address(first.start, span) else { return };
            (None, address.to_string(), text.get(1..).sure())
        };
        let address = if is_parameter { Some(Address::R) } else { Address::from_byte(self.byte(first.start)) };
        let Some(address) = address else { return };
        let numbered = matches!(address, Address::N | Address::Program);
        let plain = unbracketed(value).filter(|value| !(numbered && value.contains('R')));
        let place = self.at(span);
        let finding = |meant: Meant| Finding::UnknownCharacter { text: shown(text), meant };
        self.pending.push(if let Some(value) = plain {
            let written = format!("{prefix}{value}");
            let diagnostic = Diagnostic::new(finding(Meant::Brackets { written: shown(&written) }), place);
            diagnostic.with_offer(FixTitle::Write { text: shown(&written) }, place, written)
        } else if value.trim_start_matches([' ', '\t']).starts_with(';') {
            Diagnostic::new(finding(Meant::inside(value)), place)
        } else if value.contains('#') {
            Diagnostic::new(finding(Meant::Expression), place)
        } else if value.contains(|character: char| character.is_ascii_digit()) {
            Diagnostic::new(finding(Meant::Computed), place)
        } else {
            Diagnostic::new(finding(Meant::inside(value)), place)
        });
        let word = Word::bare(address, span).faulty();
        self.push(target.map_or(word, |target| word.assigning(target)), span);
    }

    /// `TT1`: an address written twice.
    pub(super) fn doubled_letter(&mut self, address: Address, word: Option<&str>, span: Span) {
        let written_here = word.map(str::to_ascii_uppercase).unwrap_or_default();
        let number = written_here.get(1..).unwrap_or_default().trim_start_matches([' ', '\t']);
        let text = shown(self.slice(span));
        match Number::parse(number.as_bytes()) {
            Some(number) => {
                let meant = NumberMeant::LetterTwice { written: shown(&written_here) };
                self.report_with_text(span, Finding::MalformedNumber { text, meant }, written_here);
                self.push_written(address, span, &Written::Number(number));
            }
            None => {
                self.report(span, Finding::MalformedNumber { text, meant: NumberMeant::Form });
                self.push_void(address, span);
            }
        }
    }

    /// R and something that is no number of a parameter: `R5.5`, `R-5`.
    pub(super) fn radius(&mut self, address: Token, span: Span) {
        self.void_word(address, span, |text| Finding::MalformedNumber { text, meant: NumberMeant::Parameter });
    }

    /// `R10-=12`: nothing is computed with `=`, and a sign stands behind it.
    pub(super) fn sign_before_equals(&mut self, target: Token, sign: Token, value: Token) {
        let span = target.span().to(value.span());
        let (number, faulty) = self.parameter(target);
        let Some(number) = number else {
            self.push_void(Address::R, span);
            return;
        };
        let value = self.slice(value.span()).to_ascii_uppercase();
        let text_here = format!("R{number}={}{value}", self.slice(sign.span()));
        let place = self.at(span);
        let written = written(&value).filter(|_| !value.starts_with(['+', '-'])).map(|_| text_here);
        let meant = match &written {
            Some(written) => NumberMeant::SignBeforeEquals { written: shown(written) },
            None => NumberMeant::Computed,
        };
        if !faulty {
            let diagnostic = Diagnostic::new(Finding::MalformedNumber { text: shown(self.slice(span)), meant }, place);
            self.pending.push(match written {
                Some(written) => diagnostic.with_offer(FixTitle::Write { text: shown(&written) }, place, written),
                None => diagnostic,
            });
        }
        self.push(Word::bare(Address::R, span).assigning(number).faulty(), span);
    }

    /// `-X10`.
    pub(super) fn sign_first(&mut self, sign: Token, word: Token) {
        let span = sign.span().to(word.span());
        let Some(address) = self.address(word.start, span) else { return };
        let minus = self.byte(sign.start) == b'-';
        let text = self.slice(word.span());
        let number = text.get(1..).sure().trim_start_matches([' ', '\t']);
        let signed = if minus { format!("-{number}") } else { number.to_owned() };
        let value = Number::parse(signed.as_bytes()).filter(|_| address.is_dimensional());
        match value {
            Some(value) => {
                let text_here = format!("{address}{signed}");
                let meant = NumberMeant::SignBehind { written: shown(&text_here) };
                let finding = Finding::MalformedNumber { text: shown(self.slice(span)), meant };
                self.report_with_text(span, finding, text_here);
                self.push_written(address, span, &Written::Number(value));
            }
            None => {
                let finding = Finding::MalformedNumber { text: shown(self.slice(span)), meant: NumberMeant::Form };
                self.report(span, finding);
                self.push_void(address, span);
            }
        }
    }

    /// `R10=−5`.
    pub(super) fn odd_value(&mut self, target: Token, value: Token) {
        let span = target.span().to(value.span());
        let (number, _) = self.parameter(target);
        let Some(number) = number else {
            self.push_void(Address::R, span);
            return;
        };
        let text = self.slice(value.span());
        let plain = text.replace(MINUS, "-");
        match Number::parse(plain.as_bytes()) {
            Some(value_here) => {
                let finding = Finding::UnknownCharacter { text: shown(text), meant: Meant::of(text) };
                self.report_sign(value.span(), finding, plain);
                self.push(Word::with_number(Address::R, span, value_here).assigning(number).faulty(), span);
            }
            None => {
                let finding = Finding::UnknownCharacter { text: shown(text), meant: Meant::of(text) };
                self.report(value.span(), finding);
                self.push(Word::bare(Address::R, span).assigning(number).faulty(), span);
            }
        }
    }

    /// `%_N_2107_MPF`, `%MPF2107`: a program that is named as other controls do.
    fn program_name(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let mut numbers = text.split(|character: char| !character.is_ascii_digit()).filter(|digits| !digits.is_empty());
        let number = numbers.next().filter(|digits| digits.len() <= 6 && digits.bytes().any(|digit| digit != b'0'));
        let written = number.filter(|_| numbers.next().is_none()).map(|digits| format!("%{digits}"));
        let meant = Meant::ProgramName { written: written.clone().unwrap_or_else(|| "%1".to_owned()) };
        let place = self.at(span);
        let diagnostic = Diagnostic::new(Finding::UnknownCharacter { text: shown(text), meant }, place);
        self.pending.push(match written {
            Some(written) => diagnostic.with_offer(FixTitle::Write { text: written.clone() }, place, written),
            None => diagnostic,
        });
        self.push_void(Address::Program, span);
    }

    /// A word with characters in it that the control does not know.
    pub(super) fn garbled(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let rest = text.get(1..).sure();
        if text.starts_with('%') && rest.starts_with(|first: char| first == '_' || first.is_ascii_alphabetic()) {
            self.program_name(token);
            return;
        }
        let blank = |character: char| is_blank(character) || matches!(character, ' ' | '\t');
        let number = rest.trim_start_matches(blank).replace(MINUS, "-");
        let number = match number.strip_prefix('#') {
            Some(digits) if parameter_number(digits).is_some() => format!("R{digits}"),
            _ => number,
        };
        let letter = self.byte(token.start).to_ascii_uppercase();
        let address = Address::from_byte(letter).filter(|address| {
            *address != Address::R && !(number.starts_with('R') && matches!(address, Address::N | Address::Program))
        });
        // `X#1*2`: it goes on.
        let goes_on = number.starts_with('R') && matches!(self.byte(span.end), b'*' | b'#' | b'/' | b'+' | b'-' | b'[');
        if let (Some(address), Some(written), false) = (address, written(&number), goes_on) {
            let text_here = format!("{address}{number}");
            let meant = if number.starts_with('R') {
                Meant::Variable { written: shown(&text_here) }
            } else {
                Meant::inside(rest).with_word(&text_here)
            };
            let finding = Finding::UnknownCharacter { text: shown(text), meant };
            if number.starts_with('R') {
                self.report_with_text(span, finding, text_here);
            } else {
                self.report_sign(span, finding, text_here);
            }
            self.push_written(address, span, &written);
            return;
        }
        let meant = Meant::inside(rest);
        self.void_word(token, span, |text| Finding::UnknownCharacter { text, meant });
    }

    /// Characters that mean nothing.
    pub(super) fn unknown(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        self.flags.set(BlockFlags::DEBRIS);
        let rest = self.text.get(span.end as usize..).sure();
        let line_ends = rest.trim_start_matches([' ', '\t']).starts_with(['\r', '\n']) || rest.trim().is_empty();
        let finding = |meant: Meant| Finding::UnknownCharacter { text: shown(text), meant };
        let place = self.at(span);
        if let Some((address, written)) = accented_word(text) {
            let diagnostic = Diagnostic::new(finding(Meant::Accent { written: written.clone() }), place);
            self.pending.push(diagnostic.with_offer(FixTitle::Write { text: written.clone() }, place, written));
            self.push_void(address, span);
            return;
        }
        let certain = text.chars().all(is_blank) || text.chars().all(|sign| MINUS.contains(&sign));
        if !(certain || text == ";" && line_ends) {
            self.junk(span);
            self.lost_address(span);
        }
        self.pending.push(if text == ";" && line_ends {
            let title = FixTitle::Delete { text: ";".to_owned() };
            Diagnostic::new(finding(Meant::BlockEnd), place).with_offer(title, place, "")
        } else if text.chars().all(is_blank) {
            Diagnostic::new(finding(Meant::of(text)), place).with_fix(Certain::Blank, FixTitle::PlainBlank, place, " ")
        } else if text.chars().all(|character| MINUS.contains(&character)) && text.chars().count() == 1 {
            let title = FixTitle::Write { text: "-".to_owned() };
            let diagnostic = Diagnostic::new(finding(Meant::Minus), place);
            let signs = rest.starts_with(|first: char| first.is_ascii_alphanumeric() || first == '.');
            if signs { diagnostic.with_fix(Certain::Minus, title, place, "-") } else { diagnostic }
        } else {
            Diagnostic::new(finding(Meant::of(text)), place)
        });
    }
}
