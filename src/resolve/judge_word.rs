//! Judges one word: whether its value is one that its address takes (§2).

use super::axis_letters::bit;
use super::forms::{FormFault, check_form, feed_mode_before, with_feed_mode};
use super::functions::Functions;
use super::judge_block::BlockJudge;
use crate::config::{Machine, Settings};
use crate::diag::{Diagnostic, Finding, PointMeant};
use crate::dict::{Address, Decimal, GCode, GGroup, HIGHEST_L};
use crate::syntax::{Form, Word};

impl BlockJudge<'_> {
    /// The form of one word (§2). A word that is wrong has a finding and no value. Whether it is right.
    pub(super) fn judge_word(&mut self, word: Word, functions: &Functions) -> bool {
        if word.is_void() {
            return true;
        }
        let fits = if word.is_faulty() { self.fits(word, functions) } else { self.judge_value(word, functions) };
        // The number of a block stays what jumps lead to.
        if !fits && word.address != Address::N {
            self.judged.refused.push(word.start());
        }
        fits
    }

    /// Whether a value that a fix gives has the form of its address: the word has its finding already.
    fn fits(&self, word: Word, functions: &Functions) -> bool {
        form_of(self.settings, word, functions).is_ok()
    }

    /// Reports what is wrong with a word; whether it has a value that its address takes. One code a word, in the order
    /// of §13: axis, sign, point, digits of `&`, range, unknown G.
    fn judge_value(&mut self, word: Word, functions: &Functions) -> bool {
        let machine = &self.settings.machine;
        let address = word.address;
        if let Some(axis) = address.axis()
            && machine.axes.index(axis).is_none()
        {
            let finding = Finding::UnknownAxis { axis: axis.letter(), axes: machine.axes.letters(), limit: None };
            self.report(word, finding);
            return false;
        }
        if let Some(axis) = address.axis().filter(|_| self.surplus & bit(address) != 0) {
            self.report(word, self.around.letters.finding(machine, axis));
            return false;
        }
        if word.has_sign() && !address.takes_sign(machine.dialect) {
            self.report_value(word, Finding::SignNotAllowed { address, key: self.with_digit_of_plus(word) });
            return false;
        }
        let Some(value) = word.number() else { return true };
        let dwell = address == Address::Q && functions.roles.dwell.is_some();
        if word.has_point() && !address.row().form.takes_point(machine.dialect) {
            // GRP-5: `Q5.` is tolerated with G04; with a G word from a parameter it is not known.
            let tolerated =
                address == Address::Q && value.is_whole() && !word.is_rounded() && (dwell || functions.roles.unknown);
            if !tolerated {
                let meant = point_meant(machine, address, value, dwell);
                let meant = self.with_digits_of_point(word, meant);
                self.report_value(word, Finding::PointNotAllowed { address, meant });
                return false;
            }
        }
        let feed_mode = functions.of_group(GGroup::G6).map(|(code, _)| code);
        let zero_dwell = address == Address::Q && functions.roles.unknown;
        match check_form(machine, address, value, dwell || zero_dwell, feed_mode) {
            Ok(()) => {}
            Err(FormFault::Digits) => {
                self.report_value(word, Finding::CorrectionDigits {});
                return false;
            }
            Err(FormFault::Range(range)) => {
                // What belongs to a function of another control has its finding there.
                if !functions.takes_elsewhere(address) {
                    let call = functions.calls_elsewhere().and_then(|_| call_elsewhere(address, value, functions));
                    let place = self.file.value_place(word);
                    let (range, mode, there) = match self.range_here(word, value, feed_mode) {
                        Some((range, mode, there)) => (range, Some(mode), there),
                        None => (range, feed_mode.filter(|_| address == Address::F), None),
                    };
                    let finding = Finding::ValueOutOfRange { address, range, mode, call };
                    let diagnostic = Diagnostic::new(finding, place);
                    self.judged.findings.add(with_feed_mode(diagnostic, self.file, mode.zip(there)));
                }
                return false;
            }
            // A fraction without a point cannot be.
            Err(FormFault::Fraction) => {
                let meant = point_meant(machine, address, value, dwell);
                self.report_value(word, Finding::PointNotAllowed { address, meant });
                return false;
            }
        }
        if address == Address::G && word.g_code().is_none() {
            let number = value.as_whole().and_then(|number| u32::try_from(number).ok()).unwrap_or(0);
            self.report_value(word, Finding::UnknownG { number });
            return false;
        }
        // A control word with a fraction is none (PAR-8), however fine it is.
        let malformed = !value.is_whole() && functions.is_control_word(word);
        if word.is_rounded() && !malformed {
            self.report_value(word, Finding::FinerThanResolution { rounded: value.to_string() });
        }
        true
    }

    /// A word whose `+` was meant as the digit 1, whose key it is on Czech keyboards, where its address takes that
    /// number; else nothing.
    fn with_digit_of_plus(&self, word: Word) -> String {
        let written = self.file.source.slice(self.file.value_place(word).span);
        let digits = written.strip_prefix('+').filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()));
        let Some(number) = digits.map(|digits| format!("1{digits}")) else { return String::new() };
        let function = matches!(word.address, Address::G | Address::M);
        let fits = !function && self.taken(word, &number).is_some();
        if fits { format!("{}{number}", word.address) } else { String::new() }
    }

    /// The value of those digits, when the address of a word takes them.
    fn taken(&self, word: Word, digits: &str) -> Option<Decimal> {
        let value = Decimal::whole(digits.parse::<u32>().ok()?.into());
        check_form(&self.settings.machine, word.address, value, false, None).is_ok().then_some(value)
    }

    /// A number whose point may be one too many: `T2.0`.
    fn with_digits_of_point(&self, word: Word, meant: PointMeant) -> PointMeant {
        let PointMeant::Whole { written } = meant else { return meant };
        let number = self.file.source.slice(self.file.value_place(word).span).replace('.', "");
        let other = self.taken(word, &number).filter(|value| word.number() != Some(*value));
        let digits = format!("{}{number}", word.address);
        if other.is_some() { PointMeant::WholeOrDigits { written, digits } } else { PointMeant::Whole { written } }
    }

    /// The one range of F that holds at a word, where the block does not say it: by the last G6 function before it in
    /// the text, in a program else by that of power-up; with that function, and where it is written.
    fn range_here(&self, word: Word, value: Decimal, mode: Option<GCode>) -> Option<(String, GCode, Option<Word>)> {
        if word.address != Address::F || mode.is_some() {
            return None;
        }
        let block = self.file.block_at(word.start())?;
        let written = feed_mode_before(self.file, block).map(|(code, word)| (code, Some(word)));
        let power_up = || self.settings.machine.power_up.get(GGroup::G6.index()).copied().flatten();
        let (mode, there) =
            written.or_else(|| Some((power_up().filter(|_| self.file.form == Form::Program)?, None)))?;
        match check_form(&self.settings.machine, Address::F, value, false, Some(mode)) {
            Err(FormFault::Range(range)) => Some((range, mode, there)),
            Ok(()) | Err(FormFault::Fraction | FormFault::Digits) => None,
        }
    }
}

/// A call as other controls write it with M98: `P100 L3`, `P30100`.
fn call_elsewhere(address: Address, value: Decimal, functions: &Functions) -> Option<String> {
    let l = value.as_whole().filter(|l| address == Address::P && (1..=i64::from(HIGHEST_L)).contains(l));
    let count = functions.roles.l.and_then(Word::whole).map_or_else(String::new, |count| format!(" Q{count}"));
    l.map(|l| format!("G71 L{l}{count}")).or_else(|| packed_call(address, value))
}

/// A call as other controls write it in one P, `P40010` for four times `O0010`.
fn packed_call(address: Address, value: Decimal) -> Option<String> {
    let digits = value.as_whole().filter(|digits| *digits >= 10_000)?;
    (address == Address::P && value <= Decimal::WHOLE_MAX).then_some(())?;
    let (count, l) = (digits / 10_000, digits % 10_000);
    (1..=99).contains(&count).then_some(())?;
    (l > 0).then(|| format!("G71 L{l} Q{count}"))
}

/// What was meant by a value with a point.
fn point_meant(machine: &Machine, address: Address, value: Decimal, dwell: bool) -> PointMeant {
    if dwell {
        // GRP-5: units of 10 ms.
        let units = (value.thousandths() + 5) / 10;
        let written = (0..10_000).contains(&units).then(|| format!("{address}{units}"));
        return written.map_or(PointMeant::Dwell, |written| PointMeant::Seconds { written });
    }
    let fits = check_form(machine, address, value, false, None).is_ok();
    match (address, value.as_whole().filter(|_| fits)) {
        (_, Some(whole)) => PointMeant::Whole { written: format!("{address}{whole}") },
        (Address::G, None) if value.thousandths() / 1000 == 54 => PointMeant::Origin,
        (Address::G | Address::M, None) => PointMeant::Function,
        (_, None) => PointMeant::Plain,
    }
}

/// Whether the number of a word, if it has one, is one that its address takes.
fn form_of(settings: &Settings, word: Word, functions: &Functions) -> Result<(), FormFault> {
    let dwell = word.address == Address::Q && (functions.roles.dwell.is_some() || functions.roles.unknown);
    let mode = functions.of_group(GGroup::G6).map(|(code, _)| code);
    word.number().map_or(Ok(()), |value| check_form(&settings.machine, word.address, value, dwell, mode))
}

/// Whether a word has a number out of the range of its address.
pub(super) fn is_out_of_range(settings: &Settings, word: Word, functions: &Functions) -> bool {
    !word.is_faulty() && matches!(form_of(settings, word, functions), Err(FormFault::Range(_)))
}
