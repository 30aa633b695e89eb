//! The machine constants as topics: what their decades give, made of the tables that read them.

use std::fmt::Write;

use super::constants::group_of;
use super::key::Key;
use super::motion_constants::{CONSTANTS, Holds, holds};
use crate::dict::{Bilingual, Lang};

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
        for holds in held {
            let (decades, value) = decades(*holds, lang);
            line(&decades, &value);
        }
        line(
            pick("Decades", "Dekády"),
            pick(
                "decade 1 is the rightmost digit of eight; the control shows three decimals, so 00200008 is 200.008",
                "dekáda 1 je z osmi číslic ta nejvíc vpravo; systém zobrazuje tři desetinná místa, 00200008 je tedy 200.008",
            ),
        );
        let _ = write!(page, "\n## {}\n\n```toml\n[machine-constants]\n", pick("Example", "Příklad"));
        let _ = write!(page, "{} = \"00000000\"\n```\n", self.name());
        page
    }
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
fn decades(holds: Holds, lang: Lang) -> (String, String) {
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
    match holds {
        Holds::Whole(_, first, last) => (from_to(first, last), meaning()),
        Holds::Thousandths(_) => (pick("With three decimals", "Se třemi desetinnými místy"), meaning()),
        Holds::Recognition(decade) => {
            (one(decade), format!("{}; {}", pick("1 manual, 2 automatic", "1 ruční, 2 automatické"), meaning()))
        }
        Holds::Profile(decade) => (
            one(decade),
            format!("{}; {}", pick("0 ramps, 1 linear, 2 parabolic", "0 ramps, 1 linear, 2 parabolic"), meaning()),
        ),
        Holds::Control(_) => (
            one(1),
            format!(
                "{}; {}",
                pick(
                    "1 enables the set; decades 2 to 6, where 1, say that the next constants hold numbers of parameters",
                    "1 sadu zapíná; 1 v dekádách 2 až 6 znamená, že další konstanty drží čísla parametrů",
                ),
                meaning()
            ),
        ),
        Holds::Set(..) => (pick("Value of the set", "Hodnota sady"), meaning()),
        Holds::Nothing => (
            pick("Not used", "Nepoužívá se"),
            pick("the sources give no formula for it (W0707)", "podklady k ní neudávají vzorec (W0707)"),
        ),
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
}
