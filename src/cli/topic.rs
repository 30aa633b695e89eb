//! What `explain` explains: findings, functions, addresses, and the pages of the latter two, made from the dictionary.

use std::fmt::Write as _;

use crate::diag::{Code, Finding, explain};
use crate::dict::{
    Address, Bilingual, Dialect, GCode, GGroup, Lang, Lasting, M_GROUPS, MRow, ValueForm, standard_m_functions,
};

/// One thing to explain.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Topic {
    Finding(Code),
    G(GCode),
    /// By number, at most 100: also those that are in no table.
    M(u8),
    Address(Address),
}

/// What a name that means nothing may be told.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Unknown {
    /// A word of another control: the finding that it would give.
    Word(Finding),
    /// An M number beyond 100.
    M(u32),
    /// Anything else, with the nearest known name.
    Name(Option<&'static str>),
}

impl Topic {
    /// What the user means: `E0306`, `duplicate-address`, `G73`, `M3`, `&`, `X`, in either case.
    pub fn find(name: &str) -> Result<Self, Unknown> {
        let name = name.trim();
        if let Some(code) = Code::find(name).or_else(|| Code::find(&name.to_ascii_lowercase())) {
            return Ok(Self::Finding(code));
        }
        if looks_like_code(name) {
            return Err(Unknown::Name(nearest(name)));
        }
        let mut rest = name.chars();
        let Some(letter) = rest.next() else { return Err(Unknown::Name(None)) };
        let rest = rest.as_str().trim_start();
        let address = u8::try_from(letter).ok().and_then(Address::from_byte);
        match (address, rest.parse::<u32>()) {
            (Some(Address::G), Ok(number)) => u8::try_from(number)
                .ok()
                .and_then(GCode::from_number)
                .map(Self::G)
                .ok_or(Unknown::Word(Finding::UnknownG { number })),
            (Some(Address::M), Ok(number)) => match u8::try_from(number) {
                Ok(number) if number <= Dialect::Cnc872.highest_m() => Ok(Self::M(number)),
                _ => Err(Unknown::M(number)),
            },
            // A G function with a fraction is none.
            (Some(Address::G | Address::M), _) if !rest.is_empty() => Err(Unknown::Name(nearest(name))),
            (Some(address), _) if rest.is_empty() || is_value(rest) => Ok(Self::Address(address)),
            (None, _) if rest.is_empty() && letter.is_ascii_alphabetic() => {
                Err(Unknown::Word(Finding::UnknownAddress { letter: letter.to_ascii_uppercase() }))
            }
            _ => Err(Unknown::Name(nearest(name))),
        }
    }

    /// The page as a terminal shows it.
    pub fn page(self, lang: Lang, colors: bool) -> String {
        match self {
            Self::Finding(code) => explain::page(code, lang, colors),
            Self::G(code) => painted(&g_page(code, lang), colors),
            Self::M(number) => painted(&m_page(number, lang), colors),
            Self::Address(address) => painted(&address_page(address, lang), colors),
        }
    }
}

/// Headings bold, without the signs that make them headings in Markdown.
fn painted(page: &str, colors: bool) -> String {
    let (on, off) = if colors { ("\u{1b}[1m", "\u{1b}[0m") } else { ("", "") };
    let line = |line: &str| match line.trim_start_matches('#').strip_prefix(' ') {
        Some(heading) if line.starts_with('#') => format!("{on}{heading}{off}\n"),
        _ => format!("{line}\n"),
    };
    page.lines().map(line).collect()
}

/// `W0306` is meant as a code, though W is an address too.
fn looks_like_code(name: &str) -> bool {
    let digits = name.strip_prefix(['E', 'e', 'W', 'w']).unwrap_or_default();
    digits.len() == 4 && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether it is a value, as of a word copied from a program.
fn is_value(text: &str) -> bool {
    text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'-' | b'+' | b' ' | b'='))
}

/// The code or name of a diagnostic that is most like `name`. `W0306` is E0306: numbers are known better than levels.
pub(super) fn nearest(name: &str) -> Option<&'static str> {
    let (upper, lower) = (name.to_ascii_uppercase(), name.to_ascii_lowercase());
    let number = |code: &str| code.get(1..).map(str::to_owned);
    if let Some(code) = Code::ALL.iter().find(|code| number(code.as_str()) == number(&upper)) {
        return Some(code.as_str());
    }
    let like = |known: &'static str, name: &str| (known, strsim::normalized_damerau_levenshtein(known, name));
    let codes = Code::ALL.iter().map(|code| like(code.as_str(), &upper));
    let names = Code::ALL.iter().map(|code| like(code.name(), &lower));
    let (best, likeness) = codes.chain(names).max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (likeness >= 0.6).then_some(best)
}

fn pick(lang: Lang, en: &'static str, cs: &'static str) -> &'static str {
    Bilingual { en, cs }.get(lang)
}

fn g_page(code: GCode, lang: Lang) -> String {
    let group = code.group();
    let members: Vec<String> = GCode::ALL
        .iter()
        .filter(|other| other.group() == group)
        .map(|other| format!("{other}{}", mark(other.lasting())))
        .collect();
    let mut page = format!("# {code}: {}\n\n", code.meaning().get(lang));
    let word = pick(lang, "Group", "Skupina");
    let _ = writeln!(page, "- {word} {group}, {}: {}", g_group(group).get(lang), members.join(", "));
    let _ = writeln!(page, "- {}", lasts(code.lasting(), lang));
    let once = pick(lang, "One function of the group in a block", "Z jedné skupiny smí být v bloku jediná funkce");
    let _ = writeln!(page, "- {once}");
    add_findings(&mut page, &code.to_string(), lang);
    page
}

fn m_page(number: u8, lang: Lang) -> String {
    let row = |dialect| standard_m_functions(dialect).find(|row| row.number == number);
    let alike = |a: Option<&MRow>, b: Option<&MRow>| match (a, b) {
        (Some(a), Some(b)) => a.meaning == b.meaning && a.group == b.group && a.lasting == b.lasting,
        (None, None) => true,
        _ => false,
    };
    let mut parts: Vec<(Vec<&str>, Option<&MRow>)> = Vec::new();
    for dialect in Dialect::ALL.into_iter().filter(|dialect| number <= dialect.highest_m()) {
        match parts.iter_mut().find(|(_, other)| alike(*other, row(dialect))) {
            Some((dialects, _)) => dialects.push(display_name(dialect)),
            None => parts.push((vec![display_name(dialect)], row(dialect))),
        }
    }
    let free = pick(lang, "by the machine builder", "podle výrobce stroje");
    let mut page = match parts.as_slice() {
        [(_, only)] => format!("# M{number:02}: {}\n", only.map_or(free, |row| row.meaning.get(lang))),
        _ => format!("# M{number:02}\n"),
    };
    for (dialects, row) in &parts {
        let _ = writeln!(page, "\n## {}\n", dialects.join(", "));
        match row {
            Some(row) => {
                if parts.len() > 1 {
                    let _ = writeln!(page, "- {}", capitalized(row.meaning.get(lang)));
                }
                let dialect = Dialect::ALL.into_iter().find(|&dialect| dialects.contains(&display_name(dialect)));
                let mut members: Vec<String> = dialect
                    .into_iter()
                    .flat_map(standard_m_functions)
                    .filter(|other| other.group == row.group)
                    .map(|other| format!("M{:02}{}", other.number, mark(other.lasting)))
                    .collect();
                members.sort();
                let group = match lang {
                    Lang::En => format!("M group {}", row.group),
                    Lang::Cs => format!("{}. skupina M funkcí", row.group),
                };
                let _ = writeln!(page, "- {group}: {}", members.join(", "));
                let _ = writeln!(page, "- {}", lasts(row.lasting, lang));
            }
            None => {
                let (rest, old) = (M_GROUPS - 1, dialects.contains(&display_name(Dialect::Cnc8x6)));
                let text = match (lang, old) {
                    (Lang::En, true) => format!(
                        "No standard function: what it does is up to the machine builder. M group {rest}, or by machine \
                         constants R56–R59 a group from 10 to 13"
                    ),
                    (Lang::Cs, true) => format!(
                        "Není to pevná funkce: co dělá, určuje výrobce stroje. {rest}. skupina M funkcí, nebo podle \
                         strojních konstant R56–R59 skupina 10 až 13"
                    ),
                    (Lang::En, false) => format!(
                        "No standard function: what it does is up to the machine builder. M group {rest}, or what \
                         MFunctions of the ChannelConfig say"
                    ),
                    (Lang::Cs, false) => format!(
                        "Není to pevná funkce: co dělá, určuje výrobce stroje. {rest}. skupina M funkcí, nebo jak říká \
                         MFunctions v ChannelConfig"
                    ),
                };
                let _ = writeln!(page, "- {text}");
            }
        }
    }
    add_findings(&mut page, &format!("M{number:02}"), lang);
    page
}

fn address_page(address: Address, lang: Lang) -> String {
    let row = address.row();
    let mut page = format!("# {}: {}\n\n", row.letter, row.meaning.get(lang));
    let _ = writeln!(page, "- {}", value(address, lang));
    if row.form != ValueForm::None {
        let sign = pick(lang, "A sign", "Znaménko");
        let point = pick(lang, "A decimal point", "Desetinná tečka");
        let _ = writeln!(page, "- {sign}: {}", allowed(|dialect| address.takes_sign(dialect), lang));
        let _ = writeln!(page, "- {point}: {}", allowed(|dialect| row.form.takes_point(dialect), lang));
    }
    let grouped = matches!(address, Address::G | Address::M);
    let lasting = if grouped {
        pick(lang, "How long it holds depends on its group", "Jak dlouho platí, závisí na skupině")
    } else if row.lasts_until_changed {
        pick(lang, "Holds until changed", "Platí do změny")
    } else {
        pick(lang, "Holds in its own block", "Platí ve svém bloku")
    };
    let times = if grouped {
        pick(lang, "One of each group in a block", "V bloku jedna z každé skupiny")
    } else if address == Address::R {
        pick(lang, "Each parameter once in a block", "V bloku každý parametr jednou")
    } else {
        pick(lang, "Once in a block", "V bloku jednou")
    };
    if !matches!(address, Address::Program | Address::N) {
        let _ = write!(page, "- {lasting}\n- {times}\n");
    }
    add_findings(&mut page, &format!("`{}`", row.letter), lang);
    page
}

fn value(address: Address, lang: Lang) -> String {
    let whole = |min: i64, max: i64| match lang {
        Lang::En => format!("A whole number from {min} to {max}"),
        Lang::Cs => format!("Celé číslo od {min} do {max}"),
    };
    let text = match address.row().form {
        ValueForm::Whole { max, .. } if address == Address::Q => {
            let dwell = pick(lang, "as the dwell of G04", "jako prodleva G04");
            return format!("{}; {dwell} 0–{max}", whole(1, max));
        }
        ValueForm::Whole { min, max } => return whole(min, max),
        ValueForm::None => pick(
            lang,
            "Has no value; digits after it are read and not evaluated",
            "Nemá hodnotu; číslice za ní se přečtou, ale nevyhodnocují",
        ),
        ValueForm::Dimension => pick(
            lang,
            "A number, ±69999.999, in mm or degrees; without a point whole units: X3620 is 3620 mm",
            "Číslo ±69999.999, v mm nebo ve stupních; bez tečky celé jednotky: X3620 je 3620 mm",
        ),
        ValueForm::Parameter => pick(
            lang,
            "The number of the parameter, 0 to 95, and its value: ±69999.999, or a whole number of up to eight digits. \
             R10=25.5 assigns, XR10 uses",
            "Číslo parametru 0 až 95 a hodnota: ±69999.999, nebo celé číslo nejvýše o osmi číslicích. R10=25.5 přiřadí, \
             XR10 použije",
        ),
        ValueForm::Feed => pick(
            lang,
            "Under G94 and G96 from 1 to 24000 mm/min, on CNC872 to 99999; under G95 and G97 from 0.001 to 99.999 mm/rev",
            "Při G94 a G96 od 1 do 24000 mm/min, na CNC872 do 99999; při G95 a G97 od 0.001 do 99.999 mm/ot",
        ),
        ValueForm::Auxiliary => pick(
            lang,
            "A whole number from 1 to 99; on CNC872 a number, ±69999.999",
            "Celé číslo od 1 do 99; na CNC872 číslo ±69999.999",
        ),
        ValueForm::CorrectionDigits => pick(
            lang,
            "Four digits, one for each axis: 0 no correction, 1 or 2 its direction",
            "Čtyři číslice, každé ose jedna: 0 bez korekce, 1 nebo 2 směr",
        ),
        ValueForm::Technological => {
            pick(lang, "A whole number from 0 to 99, on CNC872 to 100", "Celé číslo od 0 do 99, na CNC872 do 100")
        }
    };
    text.to_owned()
}

/// On which controls something is allowed.
fn allowed(on: impl Fn(Dialect) -> bool, lang: Lang) -> String {
    let dialects: Vec<&str> = Dialect::ALL.into_iter().filter(|&dialect| on(dialect)).map(display_name).collect();
    match dialects.len() {
        0 => pick(lang, "no", "ne").to_owned(),
        count if count == Dialect::ALL.len() => pick(lang, "yes", "ano").to_owned(),
        _ => format!("{} {}", pick(lang, "on", "na"), dialects.join(", ")),
    }
}

/// As people write it.
const fn display_name(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Cnc8x6 => "CNC8x6",
        Dialect::Cnc8x9 => "CNC8x9",
        Dialect::Cnc872 => "CNC872",
    }
}

/// As in the manual's tables.
const fn mark(lasting: Lasting) -> &'static str {
    match lasting {
        Lasting::Modal => "",
        Lasting::Default => "+",
        Lasting::Block => "x",
    }
}

fn lasts(lasting: Lasting, lang: Lang) -> &'static str {
    match lasting {
        Lasting::Modal => pick(lang, "Holds until another of its group", "Platí do další funkce skupiny"),
        Lasting::Default => pick(
            lang,
            "Holds until another of its group, and (+) after power-up, M02 and M30",
            "Platí do další funkce skupiny a (+) po zapnutí, M02 a M30",
        ),
        Lasting::Block => pick(
            lang,
            "Holds in its own block only (x); what was in force before holds again after it",
            "Platí jen ve svém bloku (x); co platilo před ním, platí zase po něm",
        ),
    }
}

const fn g_group(group: GGroup) -> Bilingual {
    let (en, cs) = match group {
        GGroup::G0 => ("interpolation", "interpolace"),
        GGroup::G1 => ("plane", "rovina"),
        GGroup::G2 => ("joining of blocks, copying, helix", "napojování bloků, kopírování, šroubovice"),
        GGroup::G3 => ("radius correction", "korekce na poloměr"),
        GGroup::G4 => ("parameter arithmetic", "aritmetika parametrů"),
        GGroup::G5 => ("zero offsets", "posunutí nulového bodu"),
        GGroup::G6 => ("unit of feed", "jednotka posuvu"),
        GGroup::G7 => ("calls and jumps", "volání a skoky"),
        GGroup::G8 => ("fixed cycles", "pevné cykly"),
        GGroup::G9 => ("absolute or incremental", "absolutně nebo přírůstkově"),
        GGroup::G10 => ("dwell, tables, diameters", "prodleva, tabulky, průměry"),
        GGroup::G11 => ("conversions of coordinates", "přepočty souřadnic"),
    };
    Bilingual { en, cs }
}

/// Adds the diagnostics whose pages speak of that word.
fn add_findings(page: &mut String, word: &str, lang: Lang) {
    let about: Vec<String> = Code::ALL
        .iter()
        .filter(|code| prose(code.page(lang)).any(|line| holds_word(line, word)))
        .map(|code| format!("- {code} {}", code.name()))
        .collect();
    if !about.is_empty() {
        let title = pick(lang, "Findings that speak of it", "Hlášení, která o ní mluví");
        let _ = write!(page, "\n## {title}\n\n{}\n", about.join("\n"));
    }
}

/// The lines of a page outside its examples.
fn prose(page: &str) -> impl Iterator<Item = &str> {
    page.lines().scan(false, |inside, line| {
        let fence = line.starts_with("```");
        *inside ^= fence;
        Some(if fence || *inside { "" } else { line })
    })
}

fn holds_word(line: &str, word: &str) -> bool {
    line.match_indices(word).any(|(at, _)| {
        let before = line.get(..at).and_then(|text| text.chars().next_back());
        let after = line.get(at + word.len()..).and_then(|text| text.chars().next());
        let joined = |character: Option<char>| character.is_some_and(|character| character.is_ascii_alphanumeric());
        !joined(before) && !joined(after)
    })
}

fn capitalized(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_every_kind() {
        assert_eq!(Topic::find("e0306"), Ok(Topic::Finding(Code::E0306)));
        assert_eq!(Topic::find("Duplicate-Address"), Ok(Topic::Finding(Code::E0306)));
        assert_eq!(Topic::find("g4"), Ok(Topic::G(GCode::G04)));
        assert_eq!(Topic::find("M 19"), Ok(Topic::M(19)));
        assert_eq!(Topic::find("&"), Ok(Topic::Address(Address::Correction)));
        assert_eq!(Topic::find("X-12.5"), Ok(Topic::Address(Address::X)));
        assert_eq!(Topic::find("G"), Ok(Topic::Address(Address::G)));
    }

    #[test]
    fn unknown_names_get_a_hint() {
        assert_eq!(Topic::find("G21"), Err(Unknown::Word(Finding::UnknownG { number: 21 })));
        assert_eq!(Topic::find("O"), Err(Unknown::Word(Finding::UnknownAddress { letter: 'O' })));
        assert_eq!(Topic::find("M101"), Err(Unknown::M(101)));
        assert_eq!(Topic::find("duplicate-adress"), Err(Unknown::Name(Some("duplicate-address"))));
        assert_eq!(Topic::find("W0306"), Err(Unknown::Name(Some("E0306"))));
        assert_eq!(Topic::find("příruba"), Err(Unknown::Name(None)));
        assert_eq!(Topic::find(""), Err(Unknown::Name(None)));
    }

    #[test]
    fn a_page_of_a_function_says_group_and_how_long_it_holds() {
        let page = Topic::find("G73").unwrap().page(Lang::En, false);
        assert!(page.starts_with("G73: jump to a block of the same unit\n"), "{page}");
        assert!(page.contains("Group G7, calls and jumps: G70+, G71x, G72x, G73x, G79x"), "{page}");
        assert!(page.contains("in its own block only"), "{page}");
        assert!(page.contains("- E0406 unknown-jump-target"), "{page}");
        assert!(Topic::find("G73").unwrap().page(Lang::Cs, false).contains("Skupina G7, volání a skoky"));
    }

    /// Trap: M07 and M08 differ by dialect.
    #[test]
    fn a_page_of_an_m_function_tells_the_dialects_apart() {
        let page = Topic::M(7).page(Lang::En, false);
        assert!(page.contains("CNC8x6, CNC8x9\n\n- Coolant 2 on"), "{page}");
        assert!(page.contains("CNC872\n\n- Coolant 1 on"), "{page}");
        assert!(Topic::M(80).page(Lang::Cs, false).contains("určuje výrobce stroje"));
        assert!(Topic::M(100).page(Lang::En, false).contains("CNC872\n"));
        assert!(!Topic::M(100).page(Lang::En, false).contains("CNC8x6"));
    }

    #[test]
    fn every_function_and_address_has_a_page_in_both_languages() {
        for lang in [Lang::En, Lang::Cs] {
            let topics = GCode::ALL.iter().map(|&code| Topic::G(code));
            let topics = topics.chain((0..=100).map(Topic::M)).chain(Address::ALL.iter().map(|&a| Topic::Address(a)));
            for topic in topics {
                assert!(topic.page(lang, false).lines().count() >= 3, "{topic:?}");
            }
        }
    }
}
