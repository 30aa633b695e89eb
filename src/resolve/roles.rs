//! What G04, G71, G72, G73, G79, L and Q of a block mean (FLW-1, FLW-3, FLW-6, FLW-7, GRP-5). The only reading of it:
//! checks, execution and the editor take it from here, with functions that are written out or that parameters give.

use crate::diag::{DwellMeant, Finding, TargetMeant, UnusedMeant};
use crate::dict::{Address, GCode, GGroup, HIGHEST_L};
use crate::syntax::Word;

/// What takes the L of a block.
#[derive(Clone, Copy, Debug, Default)]
pub enum Taker {
    /// No function that takes one.
    #[default]
    Nothing,
    /// G71, G72, G73 or G79.
    One(GCode, Word),
    /// Two functions of the group clash, or a G word that may be one has a number that is not known.
    Unclear,
}

impl Taker {
    /// Whether that function may be it.
    pub fn may_be(self, code: GCode) -> bool {
        match self {
            Self::Nothing => false,
            Self::One(one, _) => one == code,
            Self::Unclear => true,
        }
    }
}

/// The call, jump or unit of a block, and the functions that its L and Q belong to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Roles {
    /// What takes its L.
    pub taker: Taker,
    /// Its L, the first when there are two.
    pub l: Option<Word>,
    /// Its Q, the first when there are two.
    pub q: Option<Word>,
    /// Its G04, which takes the Q.
    pub dwell: Option<Word>,
    /// Some function is not known: a G word has no number yet, or clashes with another of its group.
    pub unknown: bool,
}

impl Roles {
    /// Of words whose G functions are written out, as far as they are.
    pub fn written(words: &[Word]) -> Self {
        let find = |address| words.iter().copied().find(|word| word.address == address);
        let functions = words.iter().filter(|word| word.address == Address::G).map(|word| (word.g_code(), *word));
        Self::of(functions, find(Address::L), find(Address::Q))
    }

    /// Of these G words with their functions, `None` where that is not known, and of L and Q.
    pub fn of(functions: impl Iterator<Item = (Option<GCode>, Word)>, l: Option<Word>, q: Option<Word>) -> Self {
        let mut seen = 0_u16;
        let (mut unknown, mut clash) = (false, 0_u16);
        let (mut taker, mut dwell) = (None, None);
        for (code, word) in functions {
            let Some(code) = code else {
                unknown = true;
                continue;
            };
            let group = 1 << code.group().index();
            clash |= seen & group;
            seen |= group;
            if code.takes_l() {
                taker = Some((code, word));
            } else if code == GCode::G04 {
                dwell = Some(word);
            }
        }
        let clashes = |group: GGroup| clash & (1 << group.index()) != 0;
        let known = seen & (1 << GGroup::G7.index()) != 0;
        let taker = match taker {
            _ if clashes(GGroup::G7) => Taker::Unclear,
            Some((code, word)) => Taker::One(code, word),
            // G70 takes no L, and excludes the other functions of its group.
            None if unknown && !known => Taker::Unclear,
            None => Taker::Nothing,
        };
        let dwell = dwell.filter(|_| !clashes(GGroup::G10));
        Self { taker, l, q, dwell, unknown: unknown || clash != 0 }
    }

    /// The function that calls or jumps.
    pub fn flow(&self) -> Option<(GCode, Word)> {
        match self.taker {
            Taker::One(code, word) if code.is_flow() => Some((code, word)),
            Taker::One(..) | Taker::Nothing | Taker::Unclear => None,
        }
    }

    /// The Q that says how often the block calls or jumps: not that of a dwell (FLW-6).
    pub fn repeat(&self) -> Option<Word> {
        self.q.filter(|_| self.dwell.is_none())
    }

    /// Whether a jump forward is taken every time: nothing counts it (FLW-3).
    pub const fn is_uncounted(&self) -> bool {
        self.q.is_none() && self.dwell.is_none()
    }

    /// What L and Q are for (FLW-7), what G04 needs (GRP-5, FLW-6), each finding at its word. `ends`: the block holds
    /// M02 or M30 (PRG-2).
    pub fn check(&self, ends: bool, mut report: impl FnMut(Word, Finding)) {
        if let Some((function, word)) = self.flow().filter(|_| ends) {
            report(word, Finding::FlowAfterEnd { function });
        }
        match (self.dwell, self.q, self.flow()) {
            (Some(dwell), None, _) => report(dwell, Finding::MissingDwell { meant: DwellMeant::Units }),
            (Some(_), Some(q), Some((function, _))) => report(q, Finding::DwellTakesRepeat { function }),
            (None, Some(q), None) if !self.unknown && !q.is_faulty() && !self.begins() => {
                report(q, Finding::UnusedRepeat {});
            }
            _ => {}
        }
        match (self.taker, self.l) {
            (Taker::One(function, word), None) => {
                report(word, Finding::MissingTarget { function, meant: TargetMeant::of(function) })
            }
            (Taker::Nothing, Some(l)) if !self.unknown && !l.is_faulty() => {
                report(l, Finding::UnusedTarget { meant: UnusedMeant::Target })
            }
            _ => {}
        }
    }

    /// Whether no function takes its L.
    pub const fn has_unused_l(&self) -> bool {
        matches!(self.taker, Taker::Nothing) && self.l.is_some()
    }

    /// Whether it begins a unit: G79, beside which other words have a finding of their own.
    fn begins(&self) -> bool {
        matches!(self.taker, Taker::One(GCode::G79, _))
    }
}

/// The number that an L word writes out, when it is in range.
pub fn l_number(word: Word) -> Option<u32> {
    let number = word.whole().and_then(|number| u32::try_from(number).ok())?;
    (1..=HIGHEST_L).contains(&number).then_some(number)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::Findings;
    use crate::syntax::{BlockId, Form, parse};
    use crate::text::{FileId, SourceText};

    fn roles(block: &str) -> Roles {
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\nN1 {block}\n")));
        Roles::written(parse(FileId(0), &source, Form::Program, &mut Findings::new()).words(BlockId(0)))
    }

    fn taker(block: &str) -> String {
        match roles(block).taker {
            Taker::Nothing => "nothing".to_owned(),
            Taker::One(code, _) => code.to_string(),
            Taker::Unclear => "unclear".to_owned(),
        }
    }

    /// FLW-7: what takes L.
    #[test]
    fn takers() {
        for (block, expected) in [
            ("G71 L5", "G71"),
            ("G1 X5 G73 L5 GR3", "G73"),
            ("G79 L5", "G79"),
            ("G70 L5", "nothing"),
            ("G70 GR3 L5", "nothing"),
            ("X5 L5", "nothing"),
            ("GR3 L5", "unclear"),
            ("G71 G73 L5", "unclear"),
            ("G0 G1 G71 L5", "G71"),
        ] {
            assert_eq!(taker(block), expected, "{block}");
        }
        assert!(roles("G0 G1 L5").unknown && !roles("G0 G90 L5").unknown);
    }

    /// FLW-6, GRP-5: with G04, Q is a dwell.
    #[test]
    fn repeats() {
        assert!(roles("G71 L5 Q3").repeat().is_some());
        assert!(roles("G71 L5 Q3 G04").repeat().is_none());
        assert!(roles("G73 L5").is_uncounted());
        assert!(!roles("G73 L5 Q3").is_uncounted() && !roles("G73 L5 G04 Q3").is_uncounted());
    }
}
