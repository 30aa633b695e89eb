//! Advice about the values of words, in both languages.

use super::NumberMeant;
use crate::dict::{Address, GCode, Lang};

/// Facts about an address without a value (E0103).
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum ValueMeant {
    /// Its number is missing, or the value of a parameter.
    Number,
    /// It stands beyond a line end or a comment.
    Beyond,
    /// R in a block with an arc.
    Radius,
    /// R in a block with a fixed cycle.
    Height {
        /// The cycle.
        cycle: GCode,
    },
    /// L before the target of a straight line.
    Line {
        /// The function that is meant.
        function: GCode,
    },
    /// The number of the parameter behind an address: `XR`.
    Parameter,
    /// What to write.
    Written {
        /// The word.
        written: String,
    },
    /// A letter behind it may be a digit: `LI00`.
    LetterForDigit {
        /// The letter.
        letter: String,
        /// The word with the digit.
        written: String,
    },
    /// A `%` before the line with the number of the program.
    EarlyStart,
}

impl ValueMeant {
    /// What to write.
    pub(super) fn help(&self, address: &str, lang: Lang) -> String {
        match (self, lang) {
            (Self::Written { written }, Lang::En) => format!("write `{written}`"),
            (Self::Written { written }, Lang::Cs) => format!("napsat „{written}“"),
            (Self::LetterForDigit { letter, written }, Lang::En) => {
                format!(
                    "if `{letter}` is there in place of a digit, write `{written}`; if not, write a value for \
                    `{address}`, or delete the letter that is one too many"
                )
            }
            (Self::LetterForDigit { letter, written }, Lang::Cs) => {
                format!(
                    "je-li {letter} omylem místo číslice, napsat „{written}“; jinak doplnit hodnotu adresy {address}, \
                    nebo vymazat písmeno, které je navíc"
                )
            }
            (Self::EarlyStart, Lang::En) => "delete it; in a remark spell the word `percent`".to_owned(),
            (Self::EarlyStart, Lang::Cs) => "vymazat ho; v komentáři vypsat slovo procent".to_owned(),
            (Self::Radius, _) => NumberMeant::Radius.text(lang),
            (Self::Height { cycle }, Lang::En) => format!(
                "{cycle} takes the position of the hole; heights, depths and pecks go into the parameters that its \
                macrocycle reads: `R10=2`; `[cycles]` in the project file says which one that is"
            ),
            (Self::Height { cycle }, Lang::Cs) => format!(
                "{cycle} má jen polohu díry; výšky, hloubky a kroky vrtání se zadávají do parametrů, které čte jeho \
                makrocyklus: „R10=2“; který to je, určuje [cycles] v projektovém souboru"
            ),
            (Self::Line { function: GCode::G00 }, Lang::En) => {
                "a straight line in rapid is programmed by `G00`, without `L`; at a feed by `G01`".to_owned()
            }
            (Self::Line { function: GCode::G00 }, Lang::Cs) => {
                "přímkový pohyb rychloposuvem programuje „G00“, bez L; pracovním posuvem „G01“".to_owned()
            }
            (Self::Line { function }, Lang::En) => {
                format!("a straight line is programmed by `{function}`, without `L`; in rapid by `G00`")
            }
            (Self::Line { function }, Lang::Cs) => {
                format!("přímkový pohyb programuje „{function}“, bez L; rychloposuvem „G00“")
            }
            (Self::Beyond | Self::Parameter, _) => value_wanted(address, lang),
            (Self::Number, _) if address.len() > 1 || address == "%" => value_wanted(address, lang),
            (Self::Number, Lang::En) => {
                format!("{}; if the letter is one too many, delete it", value_wanted(address, lang))
            }
            (Self::Number, Lang::Cs) => format!("{}; je-li písmeno navíc, vymazat ho", value_wanted(address, lang)),
        }
    }

    /// Why it is so.
    pub(super) fn note(&self, address: &str, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::Beyond, Lang::En) => {
                "a line end or a comment between an address and its number leaves the address without a value"
            }
            (Self::Beyond, Lang::Cs) => "konec řádku nebo komentář mezi adresou a číslem nechá adresu bez hodnoty",
            (Self::EarlyStart, Lang::En) => "the program begins with the first `%`, even one between quotes",
            (Self::EarlyStart, Lang::Cs) => "program začíná prvním %, i když je v uvozovkách",
            (Self::Number | Self::Radius | Self::Height { .. }, Lang::En) if address.starts_with('R') => {
                "R is a parameter on this control, never a radius or a height"
            }
            (Self::Number | Self::Radius | Self::Height { .. }, Lang::Cs) if address.starts_with('R') => {
                "R je v tomto systému parametr, nikdy poloměr ani výška"
            }
            (
                Self::Number
                | Self::Radius
                | Self::Height { .. }
                | Self::Line { .. }
                | Self::Parameter
                | Self::LetterForDigit { .. }
                | Self::Written { .. },
                _,
            ) => "",
        }
    }
}

/// What to write after an address without a value.
fn value_wanted(address: &str, lang: Lang) -> String {
    let (en, cs) = ("write its number on the same line", "napsat číslo na tentýž řádek");
    let example = match address {
        "L" => "100",
        "Q" => "2",
        "F" => "200",
        "&" => "0010",
        "N" | "%" | "G" | "M" | "D" | "H" | "P" => "1",
        "R" => {
            return match lang {
                Lang::En => "write the number of the parameter: `R10`".to_owned(),
                Lang::Cs => "doplnit číslo parametru: „R10“".to_owned(),
            };
        }
        parameter if parameter.starts_with('R') => {
            return match lang {
                Lang::En => format!("write the value that the parameter gets: `{parameter}=…`"),
                Lang::Cs => format!("doplnit hodnotu, kterou má parametr dostat: „{parameter}=…“"),
            };
        }
        _ => {
            return match lang {
                Lang::En => format!("{en}: `{address}0` if zero is meant"),
                Lang::Cs => format!("{cs}; je-li míněna nula: „{address}0“"),
            };
        }
    };
    match lang {
        Lang::En => format!("{en}, for example `{address}{example}`"),
        Lang::Cs => format!("{cs}, například „{address}{example}“"),
    }
}

/// A range in Czech.
pub(super) fn range_cs(range: &str) -> String {
    range.replace("/rev", "/ot").replace("rev/", "ot/")
}

/// `ze 3.`, `z 8.`: a group of M functions by number, in the genitive with its preposition.
pub(super) fn of_group(group: u8) -> String {
    let preposition = if matches!(group, 3 | 4 | 7 | 13 | 14) { "ze" } else { "z" };
    format!("{preposition} {group}.")
}

/// The digits of a control word as it is read: `00 01 50 43`.
pub(super) fn control_digits(digits: i64) -> String {
    let pair = |unit: i64| format!("{:02}", (digits / unit) % 100);
    [1_000_000, 10_000, 100, 1].map(pair).join(" ")
}

/// What was probably meant by a feed that does not fit its range.
fn other_feed(range: &str, mode: Option<GCode>) -> (&'static str, &'static str) {
    if range.contains("/min") && range.contains("/rev") {
        (
            "mm/rev holds under G95; under G94 the feed is in mm per minute",
            "mm/ot platí při G95; při G94 je posuv v mm za minutu",
        )
    } else if range.ends_with("/rev") {
        (
            "the feed is in mm per revolution here: a quarter of a millimetre is `F0.25`; under G94 it is in mm per \
            minute",
            "posuv je zde v mm na otáčku: čtvrt milimetru je „F0.25“; při G94 je v mm za minutu",
        )
    } else if mode == Some(GCode::G96) {
        (
            "the feed is in mm per minute here; with constant cutting speed it is in mm per revolution under G97, where \
            the key `g97` is `per-revolution`",
            "posuv je zde v mm za minutu; v mm na otáčku je při konstantní řezné rychlosti s G97, má-li klíč g97 \
            hodnotu per-revolution",
        )
    } else if mode == Some(GCode::G97) {
        (
            "the feed is in mm per minute here, as the key `g97` says; under G95 it is 0.001–99.999 mm/rev",
            "posuv je zde v mm za minutu, jak určuje klíč g97; při G95 má rozsah 0.001–99.999 mm/ot",
        )
    } else {
        (
            "the feed is in mm per minute here; under G95 it is 0.001–99.999 mm/rev",
            "posuv je zde v mm za minutu; při G95 má rozsah 0.001–99.999 mm/ot",
        )
    }
}

/// What was probably meant by a value that the address does not take.
pub(super) fn other_range(address: Address, range: &str, mode: Option<GCode>, lang: Lang) -> &'static str {
    let (en, cs) = match address {
        Address::P => (
            "P is an auxiliary function here; a call takes `L`, the dwell of G04 is `Q`",
            "P je zde pomocná funkce; volání má „L“, prodlevu G04 udává „Q“",
        ),
        Address::F => other_feed(range, mode),
        Address::L => (
            "subprograms, macrocycles and targets of jumps have numbers of at most four digits",
            "podprogramy, makrocykly a cíle skoků mají nejvýše čtyřmístná čísla",
        ),
        Address::D => (
            "the table of corrections has no other entries; corrections are switched off by `&0000` and G40",
            "jiné položky tabulka korekcí nemá; korekce se vypínají pomocí „&0000“ a G40",
        ),
        Address::G => ("functions have two digits", "funkce mají dvě číslice"),
        Address::M if range.ends_with("100") => {
            ("functions have two digits; only M100 has three", "funkce mají dvě číslice; jen M100 má tři")
        }
        Address::M => ("functions have two digits", "funkce mají dvě číslice"),
        Address::N => (
            "blocks are numbered from N1 on, with at most eight digits",
            "bloky se číslují od N1, nejvýše osmi číslicemi",
        ),
        Address::Program => (
            "a program has a number of one to six digits, not zero",
            "číslo programu má jednu až šest číslic a není nula",
        ),
        Address::Q if range.contains("ms") => (
            "the dwell is in units of 10 ms: `Q100` is one second",
            "prodleva je v jednotkách po 10 ms: „Q100“ je jedna sekunda",
        ),
        Address::Q => (
            "`Q` is the number of calls or jumps; to leave out the block, write `/` after its number",
            "Q je počet volání nebo skoků; má-li se blok vynechat, napsat za jeho číslo /",
        ),
        Address::T => (
            "a tool has a number of at most eight digits; its correction is chosen by `D`",
            "číslo nástroje má nejvýše osm číslic; korekce se volí adresou D",
        ),
        Address::I if mode == Some(GCode::G23) => ("I chooses the dynamic set", "I volí sadu dynamiky"),
        Address::I | Address::J | Address::K => (
            "a number without a decimal point counts whole millimetres, not thousandths",
            "číslo bez desetinné tečky jsou celé milimetry, ne tisíciny",
        ),
        Address::R => (
            "a number with decimal places goes up to 69999.999, a whole one up to 99999999",
            "číslo s desetinnými místy smí být nejvýše 69999.999, celé číslo nejvýše 99999999",
        ),
        // The limit can be set no higher.
        Address::S if range.contains("99999") => ("speeds have at most five digits", "otáčky mají nejvýše pět číslic"),
        Address::S => (
            "for a machine that turns faster set `speed` under [limits] in cnc872c.toml",
            "má-li stroj vyšší otáčky, nastavit speed v [limits] v souboru cnc872c.toml",
        ),
        address if address.axis().is_some() => (
            "a number without a decimal point counts whole millimetres or degrees, not thousandths",
            "číslo bez desetinné tečky jsou celé milimetry nebo stupně, ne tisíciny",
        ),
        Address::Skip
        | Address::X
        | Address::Y
        | Address::Z
        | Address::A
        | Address::B
        | Address::C
        | Address::U
        | Address::V
        | Address::W
        | Address::Correction
        | Address::H => ("", ""),
    };
    match lang {
        Lang::En => en,
        Lang::Cs => cs,
    }
}
