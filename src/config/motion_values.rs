//! The machine constants that give values of [`Motion`] beside the keys of `[motion]`, with the findings about values
//! that are given twice, that cannot be, or that no computation uses.

use std::collections::BTreeMap;

use super::draft::{Draft, Place, WrittenConstant};
use super::motion::{From, Given, Motion, MotionKey, Profile, SetKey, SetValue};
use super::motion_constants::{self as constants, Decades, Holds, Miswritten};
use crate::diag::{ConfigNeed, Diagnostic, Finding, Findings, FixTitle, LabelText, NotUsed, UnusedConstant};
use crate::dict::{Decimal, Dialect};
use crate::text::Location;

/// Highest acceleration that is believed of a constant, mm/s².
const BELIEVED: u32 = 50_000;
/// Highest number of a parameter that a control word may name.
const HIGHEST_PARAMETER: u32 = 94;

/// The quantities that may be given twice.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Quantity {
    Number(MotionKey),
    Recognition,
    Profile,
    Set(u8, SetKey),
}

impl Quantity {
    fn key(self) -> String {
        match self {
            Self::Number(key) => key.name().to_owned(),
            Self::Recognition => "recognition".to_owned(),
            Self::Profile => "profile".to_owned(),
            Self::Set(0, key) => format!("sets.rapid.{}", key.name()),
            Self::Set(set, key) => format!("sets.{set}.{}", key.name()),
        }
    }
}

/// Puts what the machine constants give beside the keys of `[motion]`, and judges the whole. A constant that cannot be
/// is an error where motion is computed, elsewhere a warning.
pub(super) fn assemble(draft: &mut Draft, dialect: Dialect, computes: bool, findings: &mut Findings) {
    let Draft { places, constants, settings, .. } = draft;
    let motion = &mut settings.machine.motion;
    let used: Vec<&WrittenConstant> =
        constants.iter().filter(|constant| constants::holds(constant.number).is_some()).collect();
    let mut assembly = Assembly { motion, places, given: Vec::new(), dialect, computes, findings };
    if dialect.has_channel_config() {
        assembly.not_used_here(&used);
        assembly.settle_profile();
    } else {
        assembly.motion.configured |= used.iter().any(|constant| constant.place.from == From::Key);
        assembly.constants(&used);
    }
    assembly.check_cycle();
}

/// A machine constant.
#[derive(Clone, Copy)]
struct Read {
    number: u16,
    decades: Decades,
    key: Location,
    /// Where its value stands.
    place: Location,
    from: From,
}

impl Read {
    /// Its key and its value.
    const fn places(&self) -> [Location; 2] {
        [self.key, self.place]
    }
}

struct Assembly<'a> {
    motion: &'a mut Motion,
    /// The places of the keys.
    places: &'a BTreeMap<String, Place>,
    /// What constants gave, and the constant's key.
    given: Vec<(Quantity, Location)>,
    dialect: Dialect,
    /// The command computes motion.
    computes: bool,
    findings: &'a mut Findings,
}

impl Assembly<'_> {
    /// Where a quantity was given at last: its key.
    fn place(&self, quantity: Quantity) -> Location {
        let constant = self.given.iter().rev().find(|(other, _)| *other == quantity).map(|(_, place)| *place);
        constant.or(self.key(quantity).map(|place| place.key)).unwrap_or_default()
    }

    /// The place of the key that gives a quantity.
    fn key(&self, quantity: Quantity) -> Option<Place> {
        self.places.get(&format!("motion.{}", quantity.key())).copied()
    }

    fn set(&mut self, set: u8, key: SetKey, value: Given<SetValue>) {
        if let Some(slot) = self.motion.sets.get_mut(usize::from(set)) {
            slot.get_or_insert_default().set(key, value);
        }
    }

    /// CNC872 has no such constants: said at the first one of the file and of the command line.
    fn not_used_here(&mut self, used: &[&WrittenConstant]) {
        for from in [From::Key, From::Set] {
            let of_layer = used.iter().filter(|constant| constant.place.from == from);
            if let Some(constant) = of_layer.min_by_key(|constant| constant.place.key) {
                let problem = UnusedConstant::Dialect { dialect: self.dialect.name().to_owned() };
                self.not_used(constant.number, problem, constant.place.key);
            }
        }
    }

    fn not_used(&mut self, number: u16, why: UnusedConstant, at: Location) {
        self.warn(format!("R{number}"), why, at);
    }

    fn warn(&mut self, name: String, why: UnusedConstant, at: Location) {
        self.findings.add(Diagnostic::new(Finding::ConstantNotUsed { name, why: NotUsed::Why(why) }, at));
    }

    /// A constant that cannot be: its default counts, or what else gives the quantity.
    fn need(&mut self, number: u16, needs: ConfigNeed, [key, value]: [Location; 2]) {
        let diagnostic = self.needing(number, needs, [key, value]);
        self.findings.add(diagnostic);
    }

    fn needing(&self, number: u16, needs: ConfigNeed, [key, value]: [Location; 2]) -> Diagnostic {
        if self.computes {
            let finding = Finding::ConfigurationValue { key: format!("machine-constants.R{number}"), needs };
            Diagnostic::new(finding, value)
        } else {
            let finding = Finding::ConstantNotUsed { name: format!("R{number}"), why: NotUsed::Needs(needs) };
            Diagnostic::new(finding, key)
        }
    }

    /// The constants of the file and the command line; one of the command line replaces that of the file.
    fn constants(&mut self, used: &[&WrittenConstant]) {
        let mut read: Vec<Read> = Vec::new();
        for &WrittenConstant { number, ref written, place: Place { key, at, from } } in used.iter().copied() {
            let holds = constants::holds(number).unwrap_or_default();
            let signed = holds.iter().any(|holds| matches!(holds, Holds::Thousandths(key) if *key != MotionKey::Angle));
            match Decades::read(written, signed) {
                Ok(decades) => {
                    read.retain(|other| other.number != number);
                    let from = if from == From::Key { From::Constant(number) } else { From::Set };
                    read.push(Read { number, decades, key, place: at, from });
                }
                Err(Miswritten::Digits) => self.need(number, ConfigNeed::EightDigits, [key, at]),
                Err(Miswritten::Sign) => self.need(number, ConfigNeed::NoSign, [key, at]),
            }
        }
        let control = |set: u8| {
            let word = constants::CONSTANTS.iter().find(|(_, holds)| holds.contains(&Holds::Control(set)))?.0;
            read.iter().find(|other| other.number == word).map(|other| other.decades)
        };
        let controls: Vec<Option<Decades>> = (0..5).map(control).collect();
        let control = |set: u8| controls.get(usize::from(set)).copied().flatten();
        // The keys that sets replace depend on the profile, which depends on P in set 1.
        let all = || {
            read.iter().flat_map(|one| {
                constants::holds(one.number).unwrap_or_default().iter().map(move |holds| (*one, *holds))
            })
        };
        for (one, holds) in all().filter(|(_, holds)| !holds.is_number()) {
            self.constant(one, holds, &control);
        }
        let kept = self.settle_profile();
        let sets_on = kept && control(1).is_some_and(|word| word.part(1, 1) == 1);
        for (one, holds) in all().filter(|(_, holds)| holds.is_number()) {
            self.number_constant(one, holds, sets_on);
        }
        self.check_close(&read);
    }

    /// S3 A6.2 asks for a continuous acceleration at least 100 mm/s² below that of other working motion.
    fn check_close(&mut self, read: &[Read]) {
        let constant = |number: u16| read.iter().find(|one| one.number == number);
        let (Some(working), Some(continuous)) = (constant(52), constant(236)) else { return };
        let digits = |one: &Read| one.decades.part(1, 8);
        let given = |key| self.motion.given(key).from != From::Default;
        if digits(continuous) > 0
            && digits(continuous) + 100 > digits(working)
            && given(MotionKey::Accel)
            && given(MotionKey::AccelContinuous)
        {
            self.not_used(236, UnusedConstant::CloseToWorking, continuous.key);
        }
    }

    /// What one constant gives.
    fn constant(&mut self, one: Read, holds: Holds, control: &dyn Fn(u8) -> Option<Decades>) {
        let Read { number, decades, key: at, from, .. } = one;
        match holds {
            Holds::Nothing => self.not_used(number, UnusedConstant::Circles, at),
            Holds::Recognition(decade) => {
                let digit = decades.part(decade, decade);
                match constants::recognition(digit) {
                    Some(value) => {
                        if self.give(one, Quantity::Recognition) {
                            self.motion.recognition = Given { value, from };
                        }
                    }
                    None if digit == 0 => self.not_used(number, UnusedConstant::Recognition, at),
                    None => self.need(number, ConfigNeed::Recognition, one.places()),
                }
            }
            Holds::Profile(decade) => match constants::profile(decades.part(decade, decade)) {
                Ok(value) => {
                    if self.give(one, Quantity::Profile) {
                        self.motion.profile = Given { value, from };
                    }
                }
                Err(digits) => self.need(number, decade_of(decade, digits), one.places()),
            },
            Holds::Control(set) => self.control(one, set),
            Holds::Whole(..) | Holds::Thousandths(_) => {}
            Holds::Set(set, key) => {
                let word = control(set);
                self.set_constant(one, (set, key), word);
            }
        }
    }

    fn number_constant(&mut self, one: Read, holds: Holds, sets_on: bool) {
        let Read { number, decades, key: at, from, .. } = one;
        let Some((key, value)) = constants::number(holds, decades) else { return };
        let percent = key == MotionKey::Red;
        // The sets replace these three, and their percentage that of R384.
        if (sets_on && [236, 384, 385].contains(&number) && !percent)
            || (number == 409 && (!sets_on || value == Decimal::ZERO))
        {
            return;
        }
        if percent && number == 384 && self.motion.given(key).from == From::Constant(409) {
            return;
        }
        if key == MotionKey::Overload && decades.part(8, 8) != 0 {
            self.not_used(number, UnusedConstant::LengthCorrection, at);
        }
        let accel = matches!(key, MotionKey::Accel | MotionKey::AccelContinuous | MotionKey::AccelRapid);
        if accel && !self.is_believed(one) {
            return;
        }
        if matches!(key, MotionKey::Accel | MotionKey::AccelRapid) && value == Decimal::ZERO {
            self.need(number, ConfigNeed::AboveZero, one.places());
            return;
        }
        if key == MotionKey::Angle && value > Decimal::whole(180) {
            self.need(number, ConfigNeed::Number { min: "0".to_owned(), max: "180".to_owned() }, one.places());
            return;
        }
        // Without digits for it a percentage beside the key is not given twice.
        let beside = percent && value == Decimal::ZERO && self.key(Quantity::Number(key)).is_some();
        let second = number == 409 && self.motion.given(key).from == From::Constant(384);
        if !beside && (second || self.give(one, Quantity::Number(key))) {
            self.motion.set_number(key, value, from);
        }
    }

    fn set_constant(&mut self, one: Read, (set, key): (u8, SetKey), control: Option<Decades>) {
        let Read { number, decades, key: at, from, .. } = one;
        let on = control.is_some_and(|word| word.part(1, 1) == 1);
        let decade = 2 + key as u32;
        let by_parameter = control.is_some_and(|word| word.part(decade, decade) == 1);
        if on && by_parameter {
            let parameter = decades.part(1, 8);
            match u8::try_from(parameter) {
                Ok(parameter) if u32::from(parameter) <= HIGHEST_PARAMETER => {
                    if self.give(one, Quantity::Set(set, key)) {
                        self.set(set, key, Given { value: SetValue::Parameter(parameter), from });
                    }
                }
                _ => self.need(number, ConfigNeed::ParameterNumber, one.places()),
            }
            return;
        }
        let digits = match constants::set_value(key, decades) {
            Ok(digits) => digits,
            Err(choices) => return self.need(number, decade_of(8, choices), one.places()),
        };
        // R411 is also the key `centripetal-mm-s2`.
        let also_key = number == 411 && !by_parameter && digits.value > Decimal::ZERO;
        if !on && number != 411 {
            return;
        }
        if digits.unused {
            let problem =
                if key == SetKey::Overload { UnusedConstant::LengthCorrection } else { UnusedConstant::Percentage };
            self.not_used(number, problem, at);
        }
        if key == SetKey::Linear && !self.is_believed(one) {
            return;
        }
        if also_key && self.give(one, Quantity::Number(MotionKey::Centripetal)) {
            self.motion.set_number(MotionKey::Centripetal, digits.value, from);
        }
        if on && digits.value > Decimal::ZERO && self.give(one, Quantity::Set(set, key)) {
            self.set(set, key, Given { value: SetValue::Number(digits.value), from });
        }
    }

    /// A control word: its decades are 0 or 1. A set that it enables is there.
    fn control(&mut self, one: Read, set: u8) {
        let Read { number, decades, .. } = one;
        for decade in 1..=6 {
            if decades.part(decade, decade) > 1 {
                return self.need(number, decade_of(decade, "0, 1"), one.places());
            }
        }
        if decades.part(1, 1) == 1
            && let Some(slot) = self.motion.sets.get_mut(usize::from(set))
        {
            slot.get_or_insert_default();
        }
    }

    /// Whether an acceleration is one; else the point is probably in the wrong place.
    fn is_believed(&mut self, one: Read) -> bool {
        let digits = one.decades.part(1, 8);
        if digits <= BELIEVED {
            return true;
        }
        let mut meant = digits / 1000;
        while meant > BELIEVED {
            meant /= 1000;
        }
        let shown = format!("{}.{:03}", meant / 1000, meant % 1000);
        let why = NotUsed::Why(UnusedConstant::TooFast { accel: digits, meant, shown });
        let finding = Finding::ConstantNotUsed { name: format!("R{}", one.number), why };
        let text = format!("\"{meant:08}\"");
        let diagnostic = Diagnostic::new(finding, one.key);
        self.findings.add(match one.from {
            From::Set => diagnostic,
            From::Default | From::Key | From::Constant(_) => {
                diagnostic.with_offer(FixTitle::Write { text: text.clone() }, one.place, text)
            }
        });
        false
    }

    /// Whether a constant gives a quantity: what a key of the same layer gives already is an error, and one of the
    /// command line wins.
    fn give(&mut self, one: Read, quantity: Quantity) -> bool {
        if let Some(Place { at, from, .. }) = self.key(quantity) {
            match (from, one.from) {
                (From::Set, From::Constant(_)) => return false,
                (From::Key, From::Set) => {}
                _ => {
                    let needs = ConfigNeed::GivenTwice { key: quantity.key() };
                    let diagnostic = self.needing(one.number, needs, [one.key, one.key]);
                    self.findings.add(diagnostic.with_label(at, LabelText::First { what: quantity.key() }));
                    return false;
                }
            }
        }
        self.given.push((quantity, one.key));
        true
    }

    /// Whether a value has another finding: then it is unknown.
    fn is_wrong(&self, names: &[&str]) -> bool {
        let is_one = |finding: &Finding| {
            if let Finding::ConfigurationValue { key, .. } = finding {
                names.contains(&key.as_str())
            } else if let Finding::ConstantNotUsed { name, .. } = finding {
                names.contains(&format!("machine-constants.{name}").as_str())
            } else {
                false
            }
        };
        self.findings.items().iter().any(|found| is_one(&found.finding))
    }

    fn is_on(&self, set: u8, key: SetKey) -> bool {
        let set = self.motion.sets.get(usize::from(set)).and_then(Option::as_ref);
        match set.and_then(|set| set.get(key)).map(|given| given.value) {
            Some(SetValue::Number(number)) => number > Decimal::ZERO,
            Some(SetValue::Parameter(_)) => true,
            None => false,
        }
    }

    /// A profile that this control does not have, or that lacks P, gives way to another one (W0707). Whether the
    /// profile that was asked for holds.
    fn settle_profile(&mut self) -> bool {
        let Given { value, from } = self.motion.profile;
        let (held, why) = match value {
            Profile::Linear | Profile::Parabolic if self.dialect == Dialect::Cnc8x6 => {
                (Profile::Ramps, Some(UnusedConstant::Envelope { dialect: self.dialect.name().to_owned() }))
            }
            Profile::Parabolic if !self.is_on(1, SetKey::Parabolic) => {
                let said = ["motion.sets.1.parabolic", "machine-constants.R406", "machine-constants.R407"];
                (Profile::Linear, (!self.is_wrong(&said)).then_some(UnusedConstant::ParabolicSet))
            }
            Profile::Ramps | Profile::Linear | Profile::Parabolic => return true,
        };
        self.motion.profile.value = held;
        if let Some(why) = why {
            let name =
                if let From::Constant(number) = from { format!("R{number}") } else { "motion.profile".to_owned() };
            self.warn(name, why, self.place(Quantity::Profile));
        }
        false
    }

    /// Without the cycle the criterion of accuracy and the dynamic criterion limit nothing: said at the first that
    /// is on (W0707).
    fn check_cycle(&mut self) {
        let profile = self.motion.profile.value;
        if profile == Profile::Ramps || self.motion.given(MotionKey::Cycle).value.is_some() {
            return;
        }
        let mut criteria = Vec::new();
        for (key, of_set) in [(MotionKey::Accuracy, SetKey::Accuracy), (MotionKey::Overload, SetKey::Overload)] {
            // Set 1 stands before the key.
            let hidden = profile == Profile::Parabolic && self.is_on(1, of_set);
            criteria.push((Quantity::Number(key), !hidden && self.motion.number(key) > Decimal::ZERO));
        }
        if profile == Profile::Parabolic {
            for set in 1..=4_u8 {
                for key in [SetKey::Accuracy, SetKey::Overload] {
                    criteria.push((Quantity::Set(set, key), self.is_on(set, key)));
                }
            }
        }
        let Some((first, _)) = criteria.into_iter().find(|(_, on)| *on) else { return };
        self.motion.lacks_cycle = true;
        if !self.is_wrong(&["motion.cycle-ms"]) {
            let from = match first {
                Quantity::Number(key) => self.motion.given(key).from,
                Quantity::Set(set, key) => {
                    let set = self.motion.sets.get(usize::from(set)).and_then(Option::as_ref);
                    set.and_then(|set| set.get(key)).map_or(From::Default, |given| given.from)
                }
                Quantity::Recognition | Quantity::Profile => From::Default,
            };
            let name = if let From::Constant(number) = from {
                format!("R{number}")
            } else {
                format!("motion.{}", first.key())
            };
            self.warn(name, UnusedConstant::CycleTime, self.place(first));
        }
    }
}

fn decade_of(decade: u32, digits: &str) -> ConfigNeed {
    ConfigNeed::Decade { decade, digits: digits.to_owned() }
}
