//! What there are pages about: findings, functions, addresses, keys of the project file, signals of the PLC.

use super::functions::{add_findings, address_page, g_page, m_page};
use super::signal_page::{run_time_page, signal_page};
use crate::analysis::plc;
use crate::config::{Constant, Key};
use crate::diag::{Code, Finding, explain};
use crate::dict::{Address, Dialect, GCode, Lang, standard_m_functions};

/// Fewest letters of a name of the command block without `BLK.` before it.
const SHORTEST: usize = 4;

/// One thing to explain.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Topic {
    /// A diagnostic.
    Finding(Code),
    /// A G function.
    G(GCode),
    /// An M function by number, at most 100: also those that are in no table.
    M(u8),
    /// An address.
    Address(Address),
    /// A key or table of the project file.
    Key(Key),
    /// A machine constant.
    Constant(Constant),
    /// A signal of the PLC, by name.
    Signal(&'static str),
    /// A name of the PLC interface that a part program does not determine.
    RunTime(&'static str),
}

/// Advice for a name without meaning.
#[derive(Clone, Debug, PartialEq)]
pub enum Unknown {
    /// A word of another control: the finding that it would give.
    Word(Finding),
    /// An M number beyond 100.
    M(u32),
    /// Anything else, with the nearest known name.
    Name(Option<&'static str>),
}

impl Topic {
    /// The topics of a name: `limits.feed`, and those that `find_word` finds. `g97` is a function and a key.
    ///
    /// # Errors
    /// Advice for a name without meaning.
    pub fn find(name: &str) -> Result<Vec<Self>, Unknown> {
        let signals = Self::signals(name);
        if !signals.is_empty() {
            return Ok(signals);
        }
        if let Some(constant) = Constant::find(name) {
            let parameter = is_parameter(name).then_some(Self::Address(Address::R));
            return Ok(parameter.into_iter().chain([Self::Constant(constant)]).collect());
        }
        let bare = Self::bare_keys(name);
        if !bare.is_empty() {
            return Ok(bare);
        }
        let key = Key::find(name).map(Self::Key);
        match Self::find_word(name) {
            Ok(topic) => Ok(std::iter::once(topic).chain(key).collect()),
            Err(unknown) => key.map(|key| vec![key]).ok_or(unknown),
        }
    }

    /// The finding, function or address that a name means: `E0306`, `duplicate-address`, `G73`, `M3`, `&`, `X`, in
    /// either case.
    fn find_word(name: &str) -> Result<Self, Unknown> {
        let name = name.trim();
        let code = Code::find(name).or_else(|| Code::find(&name.to_ascii_lowercase()));
        if let Some(code) = code.or_else(|| Code::find(&four_digits(name))) {
            return Ok(Self::Finding(code));
        }
        if let Some(topic) = Self::signal(name) {
            return Ok(topic);
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
                Ok(number) if number <= Dialect::HIGHEST_M => Ok(Self::M(number)),
                _ => Err(Unknown::M(number)),
            },
            // A G function with a fraction is none.
            (Some(Address::G | Address::M), _) if !rest.is_empty() => Err(Unknown::Name(nearest(name))),
            (Some(address), _) if rest.is_empty() || is_value(rest) => Ok(Self::Address(address)),
            (None, _) if rest.is_empty() && letter.is_ascii_alphabetic() => {
                Err(Unknown::Word(Finding::unknown_address(letter)))
            }
            _ => Err(Unknown::Name(nearest(name))),
        }
    }

    /// The keys of that name without their table, when the name has a hyphen: `angle-deg`. Other words are looked for.
    fn bare_keys(name: &str) -> Vec<Self> {
        let plain = name.trim().to_ascii_lowercase().replace('_', "-");
        let has_name = |key: &Key| key.path().rsplit_once('.').is_some_and(|(_, bare)| bare == plain);
        if plain.contains('-') { Key::all().filter(has_name).map(Self::Key).collect() } else { Vec::new() }
    }

    /// The topics of a pattern with `*`: signals of the PLC, and when there are none, names that a part program does
    /// not determine.
    fn signals(name: &str) -> Vec<Self> {
        let pattern = plc::run_time::plain(name.trim());
        if !pattern.contains('*') {
            return Vec::new();
        }
        let signals = plc::dictionary::signals().iter().filter(|signal| plc::matches(&pattern, &signal.name));
        let mut found: Vec<Self> = signals.map(|signal| Self::Signal(&signal.name)).collect();
        if found.is_empty() {
            let names = plc::run_time::names().iter().filter(|known| plc::matches(&pattern, &known.name));
            found.extend(names.map(|known| Self::RunTime(&known.name)));
        }
        found
    }

    /// Names of the PLC interface have two characters or more.
    fn signal(name: &str) -> Option<Self> {
        let plain = plc::run_time::plain(name);
        if plain.len() < 2 {
            return None;
        }
        if let Some(known) = plc::run_time::find(&plain) {
            return Some(Self::RunTime(&known.name));
        }
        let signals = plc::dictionary::signals();
        let is = |signal: &&plc::Signal| {
            signal.name.eq_ignore_ascii_case(&plain) || signal.row.names.family().is_some_and(|family| family == plain)
        };
        let found = signals.iter().find(is);
        if let Some(signal) = found {
            return Some(Self::Signal(&signal.name));
        }
        let names = || plc::run_time::names().iter();
        if let Some(known) = names().find(|known| known.name.eq_ignore_ascii_case(&plain)) {
            return Some(Self::RunTime(&known.name));
        }
        Self::cell(&plain).or_else(|| {
            // The manual's tables leave the prefix out. Short names are words: M1, T.
            let block = format!("BLK.{plain}");
            let whole = || signals.iter().find(|signal| signal.name == block).map(|signal| Self::Signal(&signal.name));
            let known = || plc::run_time::find(&block).map(|known| Self::RunTime(&known.name));
            (plain.len() >= SHORTEST).then(|| whole().or_else(known).or_else(|| Self::cell(&block))).flatten()
        })
    }

    /// An array, `BLK.IPlcParams`, is its first element.
    fn cell(name: &str) -> Option<Self> {
        let is_array = |element: &str| element.split_once('[').is_some_and(|(array, _)| array == name);
        let signal = plc::dictionary::signals().iter().find(|signal| is_array(&signal.name));
        let known = || plc::run_time::names().iter().find(|known| is_array(&known.name));
        signal.map(|signal| Self::Signal(&signal.name)).or_else(|| known().map(|known| Self::RunTime(&known.name)))
    }

    /// Its name, as it is found by.
    pub fn name(self) -> String {
        match self {
            Self::Finding(code) => code.to_string(),
            Self::G(code) => code.to_string(),
            Self::M(number) => format!("M{number:02}"),
            Self::Address(address) => address.to_string(),
            Self::Key(key) => key.path(),
            Self::Constant(constant) => constant.name(),
            Self::Signal(name) | Self::RunTime(name) => name.to_owned(),
        }
    }

    /// Its description, in a line.
    pub fn title(self, lang: Lang) -> String {
        match self {
            Self::Finding(code) => explain::first_sentence(code, lang),
            Self::M(number) => {
                let mut meanings: Vec<&str> = Vec::new();
                for row in Dialect::ALL.into_iter().flat_map(standard_m_functions).filter(|row| row.number == number) {
                    let meaning = row.meaning.get(lang);
                    if !meanings.contains(&meaning) {
                        meanings.push(meaning);
                    }
                }
                meanings.join("; ")
            }
            Self::G(_) | Self::Address(_) | Self::Key(_) | Self::Constant(_) | Self::Signal(_) | Self::RunTime(_) => {
                let page = self.page(lang);
                let heading = page.lines().next().unwrap_or_default();
                heading.split_once(": ").map_or_else(String::new, |(_, title)| title.to_owned())
            }
        }
    }

    /// Its page, Markdown.
    pub fn page(self, lang: Lang) -> String {
        match self {
            Self::Finding(code) => code.page(lang).to_owned(),
            Self::G(code) => g_page(code, lang),
            Self::M(number) => m_page(number, lang),
            Self::Address(address) => address_page(address, lang),
            Self::Key(key) => {
                let mut page = key.page(Dialect::default(), lang);
                add_findings(&mut page, &format!("`{}`", key.path()), lang);
                page
            }
            Self::Constant(constant) => {
                let mut page = constant.page(lang);
                add_findings(&mut page, &format!("`{}`", constant.name()), lang);
                page
            }
            Self::Signal(name) => signal_page(name, lang),
            Self::RunTime(name) => run_time_page(name, lang),
        }
    }

    /// All there are, those of M functions only where a table has them.
    pub fn all() -> impl Iterator<Item = Self> {
        let standard = |number: &u8| {
            Dialect::ALL.into_iter().any(|dialect| standard_m_functions(dialect).any(|row| row.number == *number))
        };
        let functions = GCode::ALL.iter().map(|&code| Self::G(code));
        let functions = functions.chain((0..=Dialect::HIGHEST_M).filter(standard).map(Self::M));
        let addresses = Address::ALL.iter().map(|&address| Self::Address(address));
        functions
            .chain(addresses)
            .chain(Key::all().map(Self::Key))
            .chain(Constant::all().map(Self::Constant))
            .chain(Code::ALL.iter().map(|&code| Self::Finding(code)))
    }
}

/// R0 to R95 are parameters of programs first.
fn is_parameter(name: &str) -> bool {
    let digits = name.trim().trim_start_matches(['R', 'r']).trim_start();
    digits.parse::<u32>().is_ok_and(|number| number <= 95)
}

/// `W0306` is meant as a code, though W is an address too.
fn looks_like_code(name: &str) -> bool {
    let digits = name.strip_prefix(['E', 'e', 'W', 'w']).unwrap_or_default();
    digits.len() == 4 && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// `W801` as `W0801`.
fn four_digits(name: &str) -> String {
    let (letter, digits) = name.split_at_checked(1).unwrap_or_default();
    if digits.len() == 3 { format!("{letter}0{digits}") } else { String::new() }
}

/// Whether it is a value, as of a word copied from a program.
fn is_value(text: &str) -> bool {
    text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'-' | b'+' | b' ' | b'='))
}

/// Longest name for which a near one is looked for, in bytes.
const LONGEST: usize = 100;

/// The code or name of a diagnostic, or the signal, that is most like `name`. `W0306` is E0306: numbers are known
/// better than levels.
pub fn nearest(name: &str) -> Option<&'static str> {
    if name.len() > LONGEST {
        return None;
    }
    let (upper, lower) = (name.to_ascii_uppercase(), name.to_ascii_lowercase());
    let number = |code: &str| code.get(1..).map(str::to_owned);
    if let Some(code) = Code::ALL.iter().find(|code| number(code.as_str()) == number(&upper)) {
        return Some(code.as_str());
    }
    let like = |known: &'static str, name: &str| (known, strsim::normalized_damerau_levenshtein(known, name));
    let signals = plc::dictionary::signals().iter().map(|signal| like(&signal.name, &upper));
    let codes = Code::ALL.iter().map(|code| like(code.as_str(), &upper)).chain(signals);
    let names = Code::ALL.iter().map(|code| like(code.name(), &lower));
    let (best, likeness) = codes.chain(names).max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (likeness >= 0.6).then_some(best)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_every_kind() {
        assert_eq!(Topic::find_word("e0306"), Ok(Topic::Finding(Code::E0306)));
        assert_eq!(Topic::find_word("Duplicate-Address"), Ok(Topic::Finding(Code::E0306)));
        assert_eq!(Topic::find_word("g4"), Ok(Topic::G(GCode::G04)));
        assert_eq!(Topic::find_word("M 19"), Ok(Topic::M(19)));
        assert_eq!(Topic::find_word("&"), Ok(Topic::Address(Address::Correction)));
        assert_eq!(Topic::find_word("X-12.5"), Ok(Topic::Address(Address::X)));
        assert_eq!(Topic::find_word("G"), Ok(Topic::Address(Address::G)));
    }

    #[test]
    fn patterns_of_signals() {
        let found = |pattern: &str| Topic::find(pattern).unwrap();
        assert_eq!(found("ZMM*").len(), 14);
        assert_eq!(found("BLK[0].AxNC*Move").len(), 16);
        // Of signals and names of the running machine, the signals.
        assert_eq!(found("SF_*"), [Topic::Signal("SF_DELAYINPROGR"), Topic::Signal("SF_STOP")]);
        assert_eq!(found("e0306"), [Topic::Finding(Code::E0306)]);
        assert_eq!(found("FirstBlock"), [Topic::Signal("BLK.FirstBlock")]);
        assert_eq!(found("BLK[0].M"), [Topic::Signal("BLK.M[1]")]);
        assert_eq!(found("IPlcParams"), [Topic::RunTime("BLK.IPlcParams[0]")]);
        assert_eq!(found("M2"), [Topic::M(2)]);
        assert_eq!(found("M0"), [Topic::M(0)]);
        assert_eq!(found("ZMMxPI"), [Topic::Signal("ZMM1PI")]);
        assert_eq!(found("PO_OSxPI"), [Topic::Signal("PO_OSXPI")]);
        assert_eq!(found("BLK[1].TchlOff"), [Topic::RunTime("BLK.TchlOff")]);
        assert_eq!(found("BLK[1].M11"), [Topic::Signal("BLK.M11")]);
        assert_eq!(found("AxG"), [Topic::RunTime("BLK.AxG[0]")]);
        assert_eq!(found("BLK.M0"), [Topic::RunTime("BLK.M0")]);
        assert!(Topic::find("firstblock").is_err(), "words are not names");
        assert!(Topic::find("QQQ*").is_err());
    }

    #[test]
    fn unknown_names_get_a_hint() {
        assert_eq!(Topic::find_word("G21"), Err(Unknown::Word(Finding::UnknownG { number: 21 })));
        assert_eq!(Topic::find_word("O"), Err(Unknown::Word(Finding::unknown_address('O'))));
        assert_eq!(Topic::find_word("M101"), Err(Unknown::M(101)));
        assert_eq!(Topic::find_word("duplicate-adress"), Err(Unknown::Name(Some("duplicate-address"))));
        assert_eq!(Topic::find_word("W0306"), Err(Unknown::Name(Some("E0306"))));
        assert_eq!(Topic::find_word("příruba"), Err(Unknown::Name(None)));
        assert_eq!(Topic::find_word(""), Err(Unknown::Name(None)));
    }

    #[test]
    fn a_page_of_a_function_says_group_and_how_long_it_holds() {
        let page = Topic::find_word("G73").unwrap().page(Lang::En);
        assert!(page.starts_with("# G73: jump to a block of the same unit\n"), "{page}");
        assert!(page.contains("Group G7, calls and jumps: G70+, G71x, G72x, G73x, G79(x)"), "{page}");
        assert!(page.contains("in its own block only"), "{page}");
        assert!(page.contains("- E0406 unknown-jump-target"), "{page}");
        assert!(Topic::find_word("G73").unwrap().page(Lang::Cs).contains("Skupina G7, volání a skoky"));
    }

    /// §2: axes move once; F holds.
    #[test]
    fn a_page_of_an_axis_does_not_say_that_it_holds() {
        let holds = |address| Topic::Address(address).page(Lang::En).contains("- Holds");
        assert!(!holds(Address::X) && !holds(Address::W) && holds(Address::F) && holds(Address::I));
    }

    /// Trap: M07 and M08 differ by dialect.
    #[test]
    fn a_page_of_an_m_function_tells_the_dialects_apart() {
        let page = Topic::M(7).page(Lang::En);
        assert!(page.contains("## CNC8x6, CNC8x9\n\n- Coolant 2 on"), "{page}");
        assert!(page.contains("CNC872\n\n- Coolant 1 on"), "{page}");
        assert!(Topic::M(80).page(Lang::Cs).contains("určuje výrobce stroje"));
        assert!(Topic::M(100).page(Lang::En).contains("CNC872\n"));
        assert!(!Topic::M(100).page(Lang::En).contains("CNC8x6"));
    }

    #[test]
    fn constants_and_bare_keys() {
        let names = |name: &str| Topic::find(name).unwrap().into_iter().map(Topic::name).collect::<Vec<_>>();
        assert_eq!(names("R384"), ["R384"]);
        assert_eq!(names("angle-deg"), ["motion.angle-deg"]);
        assert_eq!(names("R39"), ["R", "R39"], "a parameter of programs first");
        assert_eq!(names("R40"), ["R"]);
        assert!(Topic::find("R384").unwrap()[0].page(Lang::Cs).contains("motion.accuracy-um"));
    }

    /// A key may have the name of a function.
    #[test]
    fn a_function_and_a_key_of_one_name() {
        let found: Vec<_> = Topic::find("g97").unwrap().into_iter().map(Topic::name).collect();
        assert_eq!(found, ["G97", "g97"]);
        assert_eq!(Topic::find("limits.feed").unwrap().len(), 1);
        assert_eq!(Topic::find("x").unwrap().len(), 1);
    }

    #[test]
    fn everything_has_a_page_in_both_languages() {
        for lang in [Lang::En, Lang::Cs] {
            for topic in Topic::all() {
                assert!(topic.page(lang).lines().count() >= 3 && !topic.title(lang).is_empty(), "{topic:?}");
                assert!(Topic::find(&topic.name()).unwrap().contains(&topic), "{topic:?}");
            }
        }
    }
}
