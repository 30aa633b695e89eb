//! Why a number cannot get another: what the text does not show may mean it, too.

use super::cancel::Cancel;
use super::cursor::{DOCUMENT, block_at};
use super::names::{Name, Naming, Usage, arithmetic, control_words, is_unknown};
use super::navigation_texts::NavigationText;
use super::reach::Reach;
use crate::diag::{Code, Diagnostic, Finding, Report};
use crate::dict::{Address, GCode, HIGHEST_L, RESERVED_PARAMETER};
use crate::resolve::{Roles, Taker, UnitId, UnitKind, control_word, l_number};
use crate::session::Session;
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Value, Word};
use crate::text::Span;

/// The parameters of control words (PAR-7).
const CONTROL: std::ops::RangeInclusive<u8> = 5..=8;

/// Looks for reasons against another number in place of `name`.
pub(crate) struct Doubts<'a> {
    /// What was found in the document.
    pub(crate) found: Option<&'a Report>,
    pub(crate) cancel: &'a Cancel,
    pub(crate) reach: &'a Reach<'a>,
    pub(crate) name: Name,
}

impl Doubts<'_> {
    /// Why it cannot get any other.
    pub(crate) fn against_any(&self) -> Option<NavigationText> {
        match self.name {
            Name::Block(number) => {
                let unit = self.unit_of_block(number)?;
                let unread = || self.unread_number(number);
                self.parametric(GCode::G73, Some(unit)).or_else(|| self.unclear(GCode::G73, number)).or_else(unread)
            }
            Name::Subprogram(l) => {
                let unread = || self.unread_number(l);
                self.parametric(GCode::G71, None).or_else(|| self.unclear(GCode::G71, l)).or_else(unread)
            }
            Name::Macrocycle(l) => Some(match self.key_of_macrocycle(l) {
                Some(key) => NavigationText::MacrocycleConfigured { l, key },
                None => NavigationText::MacrocycleFile { l },
            }),
            Name::Parameter(r) => self.parameter(r),
        }
    }

    /// Why it cannot be `new`, when the places in `meant` change.
    pub(crate) fn against(&self, new: Name, meant: &[Naming]) -> Option<NavigationText> {
        let known = self.reach.occurrences(DOCUMENT, new, self.cancel);
        let exists = known.iter().any(|naming| naming.usage == Usage::Definition);
        let dangling = known.first().map(|naming| self.would_lead_here(naming));
        match new {
            Name::Block(n) => {
                let jumps = meant.iter().any(|naming| naming.usage == Usage::Call);
                let (Name::Block(old), false) = (self.name, exists) else {
                    return Some(NavigationText::BlockExists { n });
                };
                let unreachable = (jumps && n > HIGHEST_L).then_some(NavigationText::ReachableBlock { n: old });
                dangling.or(unreachable).or_else(|| self.unclear(GCode::G73, n))
            }
            Name::Subprogram(l) if exists => Some(NavigationText::SubprogramExists { l }),
            Name::Subprogram(l) => dangling.or_else(|| self.unclear(GCode::G71, l)),
            Name::Macrocycle(l) => Some(NavigationText::MacrocycleFile { l }),
            Name::Parameter(r) => self.special(r).or_else(|| {
                let used = |file| !self.reach.occurrences(file, new, self.cancel).is_empty();
                self.reach.files().any(used).then_some(NavigationText::ParameterUsed { r })
            }),
        }
    }

    /// The key of the project file that names a macrocycle.
    fn key_of_macrocycle(&self, l: u32) -> Option<String> {
        let machine = &self.reach.analysis.settings.machine;
        let cycle = machine.cycles.iter().find(|(_, mapped)| **mapped == l);
        let cycle = cycle.map(|(number, _)| format!("cycles.G{number}"));
        cycle.or_else(|| machine.macrocycles.contains_key(&l).then(|| format!("machine-macrocycles.L{l}")))
    }

    fn document(&self) -> Option<&ParsedFile> {
        self.reach.resolved().file(DOCUMENT)
    }

    fn unit_of_block(&self, number: u32) -> Option<UnitId> {
        let file = self.document()?;
        let first = || file.block_ids().find(|block| file.number(*block) == Some(number));
        let block = self.reach.resolved().numbered(DOCUMENT, number).or_else(first)?;
        self.reach.unit_of(DOCUMENT, block).map(|(id, _)| id)
    }

    fn would_lead_here(&self, naming: &Naming) -> NavigationText {
        let slice = |span| self.document().map(|file| file.source.slice(span).to_owned()).unwrap_or_default();
        let function = naming.function.map(slice).unwrap_or_default();
        NavigationText::WouldLeadHere { call: format!("{function} {}", slice(naming.around)) }
    }

    /// The blocks of the document, or of one of its units, that have words worth a look, with what takes their L.
    fn flows(&self, unit: Option<UnitId>) -> impl Iterator<Item = (BlockId, Taker, Word)> + '_ {
        let unit = unit.and_then(|id| self.reach.resolved().unit(id));
        let inside = move |block: &BlockId| unit.is_none_or(|unit| unit.contains(*block));
        rich_blocks(self.document()).filter(move |(block, _)| inside(block)).filter_map(|(block, words)| {
            let roles = Roles::written(words);
            Some((block, roles.taker, roles.l?))
        })
    }

    fn shown(&self, block: BlockId) -> u32 {
        self.document().map_or(0, |file| file.shown_number(block))
    }

    /// A jump or call whose number comes from a parameter, or cannot be read, may lead there.
    fn parametric(&self, code: GCode, unit: Option<UnitId>) -> Option<NavigationText> {
        self.flows(unit).filter(|(_, taker, _)| taker.may_be(code)).find_map(|(block, _, l)| {
            let n = self.shown(block);
            match l.value() {
                Value::Parameter { index: r, .. } if code == GCode::G73 => {
                    Some(NavigationText::JumpByParameter { n, r })
                }
                Value::Parameter { index: r, .. } => Some(NavigationText::CallByParameter { n, r }),
                Value::None => self.has_digit(l).then_some(NavigationText::Unread { n }),
                Value::Number(_) => None,
            }
        })
    }

    /// Whether a word of the document has a number, in whatever form, or one follows it on another line.
    fn has_digit(&self, word: Word) -> bool {
        let digit = |character: char| character.is_ascii_digit();
        self.document().is_some_and(|file| {
            let text = file.source.text();
            let span = word.span(text);
            let behind = text.get(span.end as usize..).unwrap_or_default().trim_start();
            file.source.slice(span).contains(digit) || behind.starts_with(digit)
        })
    }

    /// A number may or may not be that of a jump or call.
    fn unclear(&self, code: GCode, number: u32) -> Option<NavigationText> {
        let mut flows = self.flows(None);
        let unclear = flows.find(|(_, taker, l)| {
            matches!(taker, Taker::Unclear) && taker.may_be(code) && l_number(*l) == Some(number)
        });
        unclear.map(|(block, ..)| NavigationText::Unclear { n: self.shown(block), l: number })
    }

    /// Parameters that something else than the program's words uses.
    fn special(&self, r: u8) -> Option<NavigationText> {
        let configured = self.reach.analysis.settings.machine.parameters.contains_key(&r);
        if r == RESERVED_PARAMETER {
            Some(NavigationText::Reserved { r })
        } else if configured {
            Some(NavigationText::Configured { r })
        } else if CONTROL.contains(&r) && self.everywhere(calculates) {
            Some(NavigationText::ControlParameter)
        } else {
            None
        }
    }

    fn everywhere(&self, is: fn(&[Word]) -> bool) -> bool {
        self.reach.files().any(|file| rich_blocks(self.reach.resolved().file(file)).any(|(_, words)| is(words)))
    }

    fn parameter(&self, r: u8) -> Option<NavigationText> {
        self.special(r)
            .or_else(|| self.hidden_uses())
            .or_else(|| self.unread_use(format!("R{r}"), |text| names_parameter(text, r)))
            .or_else(|| self.uses(r))
    }

    /// A use in what cannot be read, as in `X-R10/2`.
    fn unread_use(&self, what: String, is_named: impl Fn(&str) -> bool) -> Option<NavigationText> {
        let report = self.found?;
        let unread = report.items().filter(|item| item.diagnostic.code().is_malformed());
        let mut places = unread.map(|item| item.diagnostic.at);
        let at = places.find(|at| is_named(report.sources().slice(*at)))?;
        let source = report.sources().get(at.file)?;
        let line = small(source.lines().line_at(at.span.start) + 1);
        Some(NavigationText::UnreadUse { what, line })
    }

    /// The number of a block or subprogram in what cannot be read, or behind the end of the program.
    fn unread_number(&self, number: u32) -> Option<NavigationText> {
        let what = number.to_string();
        self.unread_use(what.clone(), |text| has_number(text, number)).or_else(|| {
            let file = self.document()?;
            let lines = file.source.lines();
            let behind = |line: usize| {
                let span = file.source.line_span(line);
                file.source.slice(Span::new(span.start.max(file.end).min(span.end), span.end))
            };
            let line = (lines.line_at(file.end)..lines.count()).find(|line| has_number(behind(*line), number))?;
            Some(NavigationText::UnreadUse { what, line: small(line + 1) })
        })
    }

    /// The program's use of the parameter: only one that it assigns and reads itself is local.
    fn uses(&self, r: u8) -> Option<NavigationText> {
        let (mut assigned, mut read) = (false, false);
        for file in self.reach.files() {
            let found = self.reach.occurrences(file, Name::Parameter(r), self.cancel);
            let macrocycle = self.reach.names(file).and_then(|names| names.macrocycle);
            if let (Some(l), false) = (macrocycle, found.is_empty()) {
                return Some(NavigationText::UsedInMacrocycle { r, l });
            }
            assigned |= found.iter().any(|naming| naming.usage == Usage::Write);
            read |= found.iter().any(|naming| naming.usage == Usage::Read);
            // A control word whose leading zeros are left out has no digits for it.
            if let Some(naming) = found.iter().find(|naming| !naming.written) {
                let block = block_at(self.document()?, naming.number.start);
                return Some(NavigationText::UnknownControlWord { n: block.map_or(0, |block| self.shown(block)) });
            }
        }
        if !self.reach.analysis.certain {
            Some(NavigationText::NotExecuted)
        } else if !assigned {
            Some(NavigationText::NeverAssigned { r })
        } else if !read {
            Some(NavigationText::NeverRead { r })
        } else {
            self.read_before_assigned(r).then_some(NavigationText::ReadBeforeAssigned { r })
        }
    }

    /// What execution found (PAR-5); when nobody wants to know that, what it would find.
    fn read_before_assigned(&self, r: u8) -> bool {
        let analysis = self.reach.analysis;
        let is_it = |diagnostic: &Diagnostic| matches!(diagnostic.finding, Finding::UnassignedParameter { parameter, .. } if parameter == r);
        if analysis.settings.severity(Code::W0503).is_some() {
            let found = self.found.iter().flat_map(|report| report.items());
            return found.into_iter().any(|item| is_it(&item.diagnostic));
        }
        let goes_on = |_| !self.cancel.is_cancelled();
        let session = Session { progress: Some(&goes_on), ..analysis.session() };
        let outcome = session.check(&analysis.path, "");
        outcome.findings.items().iter().any(is_it)
    }

    /// Uses of parameters that cannot be seen: in macrocycles that are not known, and by control words.
    fn hidden_uses(&self) -> Option<NavigationText> {
        if self.reach.misses {
            return Some(NavigationText::MissingMacrocycle);
        }
        for file in self.reach.files() {
            let Some(parsed) = self.reach.resolved().file(file) else { continue };
            for (block, words) in rich_blocks(Some(parsed)) {
                let n = parsed.shown_number(block);
                if self.calls_unknown(words) {
                    return Some(NavigationText::UnknownMacrocycle { n });
                }
                if self.calls_missing(words) {
                    return Some(NavigationText::MissingMacrocycle);
                }
                if self.calculates_unknown(words) {
                    return Some(NavigationText::UnknownControlWord { n });
                }
            }
        }
        None
    }

    /// Whether a block may call a macrocycle of a number that is not written, or that may be no call.
    fn calls_unknown(&self, words: &[Word]) -> bool {
        let roles = Roles::written(words);
        let cycles = !self.reach.analysis.settings.machine.cycles.is_empty();
        let by_l = match (roles.taker, roles.l) {
            (Taker::Unclear, Some(_)) => true,
            (Taker::One(code, _), Some(l)) => code == GCode::G72 && l_number(l).is_none(),
            (Taker::Nothing, _) | (_, None) => false,
        };
        by_l || (cycles && words.iter().any(|word| is_unknown(*word)))
    }

    fn calls_missing(&self, words: &[Word]) -> bool {
        let roles = Roles::written(words);
        let (Taker::One(GCode::G72, _), Some(l)) = (roles.taker, roles.l) else { return false };
        l_number(l).is_some_and(|l| {
            let mut units = self.reach.resolved().units();
            !units.any(|(_, unit)| unit.kind == UnitKind::Macrocycle(l))
        })
    }

    /// Whether a block computes with parameters that its control words do not tell.
    fn calculates_unknown(&self, words: &[Word]) -> bool {
        let machine = &self.reach.analysis.settings.machine;
        let known = |word: Word| {
            let value = word.number().filter(|_| !word.is_faulty());
            value.is_some_and(|value| control_word(machine, value).is_ok())
        };
        match arithmetic(words) {
            Some(function) => control_words(words, function).any(|word| !known(word)),
            None => calculates(words),
        }
    }
}

/// Whether a text names a parameter: `R` and its number, blanks between them allowed.
fn names_parameter(text: &str, r: u8) -> bool {
    text.split(['R', 'r']).skip(1).any(|rest| {
        let rest = rest.trim_start();
        let digits = rest.find(|character: char| !character.is_ascii_digit()).map_or(rest, |end| rest.split_at(end).0);
        digits.parse() == Ok(r)
    })
}

/// Whether a text has a number among others.
fn has_number(text: &str, number: u32) -> bool {
    text.split(|character: char| !character.is_ascii_digit()).any(|digits| digits.parse() == Ok(number))
}

/// Whether a block uses R5–R8 as control words, or may.
fn calculates(words: &[Word]) -> bool {
    let control = |word: &Word| word.address == Address::R && CONTROL.contains(&word.target());
    arithmetic(words).is_some() || (words.iter().any(|word| is_unknown(*word)) && words.iter().any(control))
}

/// The blocks that have more than axis words and the like.
fn rich_blocks(file: Option<&ParsedFile>) -> impl Iterator<Item = (BlockId, &[Word])> + '_ {
    file.into_iter().flat_map(|file| {
        let blocks = file.block_ids().filter(|block| file.flags(*block).has(BlockFlags::RICH));
        blocks.map(|block| (block, file.words(block)))
    })
}
