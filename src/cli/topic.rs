//! What `explain` explains: findings, functions, addresses.

use super::page::{address_page, g_page, m_page, painted};
use crate::diag::{Code, Finding, explain};
use crate::dict::{Address, Dialect, GCode, Lang};

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
                Err(Unknown::Word(Finding::unknown_address(letter)))
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
        assert_eq!(Topic::find("O"), Err(Unknown::Word(Finding::unknown_address('O'))));
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
