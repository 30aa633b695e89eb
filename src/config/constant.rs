//! The machine constants as topics: what their decades give, made of the tables that read them.

use std::fmt::Write;

use super::constants::group_of;
use super::key::Key;
use super::motion::{MotionKey, SetKey};
use super::motion_constants::{CONSTANTS, Holds, holds};
use crate::diag::UnusedConstant;
use crate::dict::{Bilingual, Dialect, Lang};

/// A machine constant that gives something, by number.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Constant(u16);

impl Constant {
    /// Every one, ascending.
    pub fn all() -> impl Iterator<Item = Self> {
        let groups = (0..=u16::MAX).filter(|number| group_of(*number).is_some());
        let mut numbers: Vec<u16> = groups.chain(CONSTANTS.iter().map(|(number, _)| *number)).collect();
        numbers.sort_unstable();
        numbers.into_iter().map(Self)
    }

    /// The constant of that name: `R384`, in either case.
    pub fn find(name: &str) -> Option<Self> {
        let digits = name.trim().strip_prefix(['R', 'r'])?.trim_start();
        let number = digits.parse().ok().filter(|_| digits.bytes().all(|byte| byte.is_ascii_digit()))?;
        (holds(number).is_some() || group_of(number).is_some()).then_some(Self(number))
    }

    /// `R384`.
    pub fn name(self) -> String {
        format!("R{}", self.0)
    }

    /// Its page, Markdown.
    pub fn page(self, lang: Lang) -> String {
        let pick = |en, cs| Bilingual { en, cs }.get(lang);
        let held = holds(self.0).unwrap_or_default();
        let mut page = format!("# {}: {}", self.name(), pick("machine constant", "strojní konstanta"));
        let paths: Vec<String> = held.iter().filter_map(|holds| path(*holds)).collect();
        if !paths.is_empty() {
            let _ = write!(page, ", {}", paths.join(", "));
        }
        page.push_str("\n\n");
        let mut line = |words: &str, value: &str| {
            // Writing to a `String` cannot fail.
            let _ = writeln!(page, "- {words}: {value}");
        };
        line(
            pick("In", "Kde"),
            pick(
                "`cnc872c.toml`, `[machine-constants]`, on CNC8x6 and CNC8x9",
                "`cnc872c.toml`, `[machine-constants]`, u CNC8x6 a CNC8x9",
            ),
        );
        if let Some(group) = group_of(self.0) {
            line(
                pick("Eight decades", "Osm dekád"),
                &match lang {
                    Lang::En => format!("the M functions of group {group}, two digits each, 00 is none"),
                    Lang::Cs => format!("M funkce skupiny {group}, každá dvě číslice, 00 není žádná"),
                },
            );
        }
        for (decades, value) in held.iter().flat_map(|holds| decades(*holds, lang)) {
            line(&decades, &value);
        }
        line(
            pick("Decades", "Dekády"),
            pick(
                "decade 1 is the rightmost digit of eight; the control shows three decimals, so 00200008 is 200.008",
                "dekáda 1 je z osmi číslic ta nejvíc vpravo; systém zobrazuje tři desetinná místa, 00200008 je tedy \
                200.008",
            ),
        );
        if let Some(example) = self.example() {
            let _ = write!(page, "\n## {}\n\n```toml\n{example}```\n", pick("Example", "Příklad"));
        }
        page
    }

    /// A project file with it, which can be taken as it is: default values, else those of the manual; `None` for a
    /// constant that is never used.
    pub fn example(self) -> Option<String> {
        let held = holds(self.0).unwrap_or_default();
        let own = match held.first() {
            None => "91929394",
            Some(holds) => digits(*holds)?,
        };
        let mut constants: Vec<(u16, &str)> = Vec::new();
        let set = held.iter().find_map(|holds| match holds {
            Holds::Set(set, _) | Holds::Control(set) => Some(*set),
            Holds::Whole(..) | Holds::Thousandths(_) | Holds::Recognition(_) | Holds::Profile(_) | Holds::Nothing => {
                None
            }
        });
        if let Some(set) = set {
            // Sets count with parabolic, and that needs P in set 1.
            constants.extend([(338, "00000020"), (406, "00000001"), (407, "00050000")]);
            let control = CONSTANTS.iter().find(|(_, held)| held.contains(&Holds::Control(set)));
            constants.extend(control.map(|(number, _)| (*number, "00000001")));
        }
        constants.retain(|(number, _)| *number != self.0);
        constants.push((self.0, own));
        constants.sort_unstable();
        constants.dedup();
        let criterion = held.iter().any(|holds| {
            matches!(
                holds,
                Holds::Whole(MotionKey::Accuracy | MotionKey::Overload, ..)
                    | Holds::Set(_, SetKey::Accuracy | SetKey::Overload)
            )
        });
        let mut file = format!("dialect = \"{}\"\n\n", Dialect::Cnc8x9.name());
        if criterion {
            file.push_str("[motion]\ncycle-ms = 2\n\n");
        }
        file.push_str("[machine-constants]\n");
        for (number, digits) in constants {
            let _ = writeln!(file, "R{number} = \"{digits}\"");
        }
        Some(file)
    }
}

/// The digits of an example; none for a constant that is never used.
const fn digits(holds: Holds) -> Option<&'static str> {
    Some(match holds {
        Holds::Whole(MotionKey::Accuracy, ..) => "00200008",
        Holds::Whole(MotionKey::Overload, ..) => "00010000",
        Holds::Whole(MotionKey::AccelRapid, ..) => "00001000",
        Holds::Whole(..) => "00000500",
        Holds::Thousandths(MotionKey::Angle) => "00060000",
        Holds::Thousandths(_) => "00000000",
        Holds::Recognition(_) => "00000002",
        Holds::Profile(_) => "00000010",
        Holds::Control(_) => "00000001",
        Holds::Set(_, SetKey::Parabolic) => "00050000",
        Holds::Set(_, SetKey::Linear) => "00000600",
        Holds::Set(1, SetKey::Accuracy) => "00200008",
        Holds::Set(_, SetKey::Accuracy) => "00000008",
        Holds::Set(_, SetKey::Overload) => "00010000",
        Holds::Set(_, SetKey::Centripetal) => "10004000",
        Holds::Nothing => return None,
    })
}

/// The key that says the same.
fn path(holds: Holds) -> Option<String> {
    match holds {
        Holds::Whole(key, ..) | Holds::Thousandths(key) => Some(format!("motion.{}", key.name())),
        Holds::Recognition(_) => Some("motion.recognition".to_owned()),
        Holds::Profile(_) => Some("motion.profile".to_owned()),
        Holds::Set(set, key) => Some(format!("{}.{}", set_path(set), key.name())),
        Holds::Control(set) => Some(set_path(set)),
        Holds::Nothing => None,
    }
}

fn set_path(set: u8) -> String {
    if set == 0 { "motion.sets.rapid".to_owned() } else { format!("motion.sets.{set}") }
}

/// Which decades, and what they are.
fn decades(holds: Holds, lang: Lang) -> Vec<(String, String)> {
    let pick = |en: &'static str, cs: &'static str| Bilingual { en, cs }.get(lang).to_owned();
    let from_to = |first: u32, last: u32| match lang {
        Lang::En => format!("Decades {first} to {last}"),
        Lang::Cs => format!("Dekády {first} až {last}"),
    };
    let one = |decade: u32| match lang {
        Lang::En => format!("Decade {decade}"),
        Lang::Cs => format!("Dekáda {decade}"),
    };
    let meaning = || {
        let path = path(holds).unwrap_or_default();
        let key = Key::find(&path).map(|key| key.meaning(lang).to_owned());
        key.map_or_else(|| format!("`{path}`"), |meaning| format!("`{path}`: {meaning}"))
    };
    let correction = || (one(8), format!("{} (W0707)", UnusedConstant::LengthCorrection.text(lang)));
    match holds {
        Holds::Whole(MotionKey::Overload, first, last) => vec![(from_to(first, last), meaning()), correction()],
        Holds::Whole(_, first, last) => vec![(from_to(first, last), meaning())],
        Holds::Thousandths(MotionKey::BreakLength | MotionKey::MergeLength | MotionKey::RaiseLength) => {
            let decades = pick("With three decimals, and a sign", "Se třemi desetinnými místy a se znaménkem");
            vec![(decades, meaning())]
        }
        Holds::Thousandths(_) => vec![(pick("With three decimals", "Se třemi desetinnými místy"), meaning())],
        Holds::Recognition(decade) => {
            vec![(one(decade), format!("{}; {}", pick("1 manual, 2 automatic", "1 ruční, 2 automatické"), meaning()))]
        }
        Holds::Profile(decade) => {
            vec![(one(decade), format!("0 ramps, 1 linear, 2 parabolic; {}", meaning()))]
        }
        Holds::Control(set) => {
            let last = if set == 0 { 3 } else { 6 };
            let by_parameter = match lang {
                Lang::En => "1: the constant next in the row holds the number of a parameter, R0 to R94",
                Lang::Cs => "1: příslušná další konstanta udává číslo parametru, R0 až R94",
            };
            vec![
                (one(1), format!("{}; {}", pick("1 enables the set", "1 sadu zapíná"), meaning())),
                (from_to(2, last), by_parameter.to_owned()),
            ]
        }
        Holds::Set(_, SetKey::Parabolic) => {
            let smaller = pick("2, 3: P is 100, 1000 times smaller", "2, 3: P je 100krát, 1000krát menší");
            vec![(from_to(1, 7), meaning()), (one(8), smaller)]
        }
        Holds::Set(_, SetKey::Linear) => vec![(from_to(1, 8), meaning())],
        Holds::Set(_, SetKey::Accuracy) => vec![(from_to(1, 4), meaning())],
        Holds::Set(_, SetKey::Overload) => vec![(from_to(1, 7), meaning()), correction()],
        Holds::Set(_, SetKey::Centripetal) => {
            let tenths = pick("in tenths of mm/s²", "v desetinách mm/s²");
            let eighth = pick(
                "1: the digits count; 0: they are a percentage, which no source explains (W0707)",
                "1: číslice platí; 0: jsou procentem, které příručky systému nevysvětlují (W0707)",
            );
            vec![(from_to(1, 7), format!("{tenths}; {}", meaning())), (one(8), eighth)]
        }
        Holds::Nothing => {
            let why = UnusedConstant::Circles.text(lang);
            vec![(pick("Not used", "Nepoužívá se"), format!("{why} (W0707)"))]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn found_by_number() {
        let name = |name: &str| Constant::find(name).map(Constant::name);
        assert_eq!(name("r384").as_deref(), Some("R384"));
        assert_eq!(
            [name("R10"), name("R384.5"), name("R-384"), name("384"), name("R")],
            [None, None, None, None, None]
        );
        for constant in Constant::all() {
            assert_eq!(Constant::find(&constant.name()), Some(constant));
        }
        let page = Constant(384).page(Lang::En);
        assert!(page.contains("Decades 5 to 6: `motion.red-percent`"), "{page}");
        assert!(Constant(56).page(Lang::Cs).contains("skupiny 10"));
    }

    #[test]
    fn decades_are_named() {
        let says = |number: u16, lang: Lang, text: &str| {
            let page = Constant(number).page(lang);
            assert!(page.contains(text), "{text}\n{page}");
        };
        says(386, Lang::En, "With three decimals, and a sign: `motion.raise-length-mm`");
        says(232, Lang::Cs, "Nepoužívá se: jak R232 omezuje rychlost");
        for number in [407, 413, 431] {
            says(number, Lang::En, "Decade 8: 2, 3: P is 100, 1000 times smaller");
            says(number, Lang::Cs, "Dekáda 8: 2, 3: P je 100krát, 1000krát menší");
        }
        says(411, Lang::En, "Decades 1 to 7: in tenths of mm/s²;");
        says(411, Lang::Cs, "Dekáda 8: 1: číslice platí;");
        says(382, Lang::En, "With three decimals, and a sign: ");
        says(383, Lang::Cs, "Se třemi desetinnými místy a se znaménkem: ");
        says(385, Lang::En, "Decade 8: how decade 8 corrects");
        says(406, Lang::En, "Decades 2 to 6: 1:");
        says(430, Lang::En, "Decades 2 to 3: 1:");
        says(430, Lang::Cs, "Dekády 2 až 3: 1:");
    }
}
