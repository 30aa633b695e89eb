//! The names in the words of a block: blocks, subprograms, macrocycles, parameters.

use crate::config::Machine;
use crate::dict::{Address, FIRST_CONTROL, GCode, GGroup};
use crate::resolve::{Roles, Taker, control_word, l_number};
use crate::sure::{Sure, small};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Value, Word};
use crate::text::Span;

/// The thing that a number refers to.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub(crate) enum Name {
    /// A block of the file; its number stands once there (BLK-7).
    Block(u32),
    /// A subprogram of the file.
    Subprogram(u32),
    /// A macrocycle.
    Macrocycle(u32),
    /// A parameter.
    Parameter(u8),
}

/// What happens to what is named.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Usage {
    /// It is here: `N10`, the L of a G79.
    Definition,
    /// It is called or jumped to.
    Call,
    /// A parameter gets a value.
    Write,
    /// The value of a parameter is taken.
    Read,
}

/// One place that names something.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Naming {
    pub(crate) name: Name,
    pub(crate) usage: Usage,
    /// The number; where none is written, the word in its place.
    pub(crate) number: Span,
    /// Whether another number can be written in place of `number`.
    pub(crate) written: bool,
    /// Where a cursor means it: the word, of a word with parameters its part.
    pub(crate) around: Span,
    /// The G word that makes a number of L a name: a cursor there means it, too.
    pub(crate) function: Option<Span>,
}

impl Naming {
    /// Whether it is an operand or the result in a control word, which names parameters by nothing but digits.
    pub(crate) fn is_operand(&self) -> bool {
        matches!(self.name, Name::Parameter(_)) && self.around == self.number
    }
}

/// Whether it is not known before execution which function a G word is.
pub(crate) fn is_unknown(word: Word) -> bool {
    word.address == Address::G && (word.is_parametric() || word.is_void())
}

/// The function G26–G29 of a block.
pub(crate) fn arithmetic(words: &[Word]) -> Option<GCode> {
    words.iter().find_map(|word| word.g_code().filter(|code| code.group() == GGroup::G4))
}

/// The control words of a block with that function: the first R word of each (PAR-7).
pub(crate) fn control_words(words: &[Word], function: GCode) -> impl Iterator<Item = Word> + '_ {
    (FIRST_CONTROL..).take(function.operations()).filter_map(|parameter| {
        words.iter().copied().find(|word| word.address == Address::R && !word.is_void() && word.target() == parameter)
    })
}

/// Reads what the blocks of one file name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Names<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) file: &'a ParsedFile,
    /// The number of the macrocycle that the file holds; `None`: a program.
    pub(crate) macrocycle: Option<u32>,
}

impl Names<'_> {
    /// Every place in a block that names something that is wanted, N first.
    pub(crate) fn of_block(&self, block: BlockId, wanted: impl Fn(Name) -> bool) -> Vec<Naming> {
        let mut found = Vec::new();
        let mut add = |name: Name, naming: &dyn Fn() -> Naming| {
            if wanted(name) {
                found.push(naming());
            }
        };
        if let (Some(number), Some(word)) = (self.file.number(block), self.file.n_word(block)) {
            let name = Name::Block(number);
            add(name, &|| self.of_word(name, Usage::Definition, word, None));
        }
        if !self.file.flags(block).has(BlockFlags::RICH) {
            return found;
        }
        let words = self.file.words(block);
        let roles = Roles::written(words);
        if let (Taker::One(code, g), Some(l)) = (roles.taker, roles.l)
            && let Some(number) = l_number(l)
            && let Some((name, usage)) = self.named_by(code, number, block)
        {
            add(name, &|| self.of_word(name, usage, l, Some(g)));
        }
        for &word in words {
            if let Some(l) = self.mapped(word) {
                let span = self.span(word);
                let name = Name::Macrocycle(l);
                add(name, &|| Naming {
                    name,
                    usage: Usage::Call,
                    number: span,
                    written: false,
                    around: span,
                    function: None,
                });
            }
            if word.address == Address::R
                && let Some(index) = self.target(word)
            {
                let name = Name::Parameter(index);
                add(name, &|| self.of_target(name, word));
            }
            if let Value::Parameter { index, .. } = word.value() {
                let name = Name::Parameter(index);
                add(name, &|| self.of_source(name, word));
            }
        }
        if let Some(function) = arithmetic(words) {
            for word in control_words(words, function) {
                for (name, usage, place) in self.fields(word) {
                    add(name, &|| self.of_field(name, usage, word, place));
                }
            }
        }
        found
    }

    fn span(&self, word: Word) -> Span {
        word.span(self.file.source.text())
    }

    /// What an L with that function names.
    fn named_by(&self, code: GCode, l: u32, block: BlockId) -> Option<(Name, Usage)> {
        let called = [
            (GCode::G71, Name::Subprogram(l), self.macrocycle.is_none()),
            (GCode::G72, Name::Macrocycle(l), true),
            (GCode::G73, Name::Block(l), true),
        ];
        if let Some((_, name, is_known)) = called.into_iter().find(|(of, ..)| *of == code) {
            return is_known.then_some((name, Usage::Call));
        }
        match self.macrocycle {
            None => Some((Name::Subprogram(l), Usage::Definition)),
            Some(own) => (own == l && block == BlockId(0)).then_some((Name::Macrocycle(l), Usage::Definition)),
        }
    }

    /// The macrocycle that the cycle map gives for a G word (GRP-6).
    pub(crate) fn mapped(&self, word: Word) -> Option<u32> {
        let cycle = word.g_code().filter(|code| code.is_cycle())?;
        self.machine.cycles.get(&cycle.number()).copied()
    }

    /// The parameter that an R word assigns; also of one without a value.
    fn target(&self, word: Word) -> Option<u8> {
        if !word.is_void() {
            return Some(word.target());
        }
        let digits = self.file.source.slice(word.parts(self.file.source.text()).target?);
        digits.parse().ok().filter(|index| *index <= 95)
    }

    fn of_word(&self, name: Name, usage: Usage, word: Word, function: Option<Word>) -> Naming {
        let parts = word.parts(self.file.source.text());
        let function = function.map(|word| self.span(word));
        Naming { name, usage, number: self.digits(parts.value), written: true, around: parts.word, function }
    }

    /// The digits of a whole number, without what its address does not take; all of a number that is malformed.
    fn digits(&self, value: Span) -> Span {
        let text = self.file.source.slice(value);
        let unsigned = text.trim_start_matches(['+', '-']);
        let behind = unsigned.trim_start_matches(|character: char| character.is_ascii_digit());
        if behind.trim_matches(['.', '0']).is_empty() && behind.len() < unsigned.len() {
            part(value, text.len() - unsigned.len(), text.len() - behind.len())
        } else {
            value
        }
    }

    fn of_target(&self, name: Name, word: Word) -> Naming {
        let parts = word.parts(self.file.source.text());
        let number = parts.target.unwrap_or(parts.word);
        let around = Span::new(parts.word.start, number.end);
        Naming { name, usage: Usage::Write, number, written: parts.target.is_some(), around, function: None }
    }

    /// `R10`, `-R10`: the number behind the R.
    fn of_source(&self, name: Name, word: Word) -> Naming {
        let around = word.parts(self.file.source.text()).value;
        let text = self.file.source.slice(around);
        let from = text.rfind(['R', 'r']).map_or(0, |at| at + 1);
        let behind = text.get(from..).sure();
        let number = behind.trim_start_matches([' ', '\t']);
        let length = number.find(|character: char| !character.is_ascii_alphanumeric()).unwrap_or(number.len());
        let start = from + behind.len() - number.len();
        let number = part(around, start, start + length);
        Naming { name, usage: Usage::Read, number, written: !number.is_empty(), around, function: None }
    }

    /// The parameters that a control word `oo aa bb rr` names, each with its place from the right (PAR-8).
    fn fields(&self, word: Word) -> Vec<(Name, Usage, usize)> {
        let control = word.number().filter(|_| !word.is_faulty()).map(|value| control_word(self.machine, value));
        let Some(Ok(control)) = control else { return Vec::new() };
        let first = (Name::Parameter(control.first), Usage::Read, 2);
        let second = control.second.map(|second| (Name::Parameter(second), Usage::Read, 1));
        let result = (Name::Parameter(control.result), Usage::Write, 0);
        [Some(first), second, Some(result)].into_iter().flatten().collect()
    }

    /// Two digits of a control word; leading zeros may be left out.
    fn of_field(&self, name: Name, usage: Usage, word: Word, place: usize) -> Naming {
        let value = word.parts(self.file.source.text()).value;
        let text = self.file.source.slice(value);
        let begin = text.find(|character: char| character.is_ascii_digit()).unwrap_or(0);
        let end = text.find('.').unwrap_or(text.len());
        let to = end.saturating_sub(2 * place).max(begin);
        let from = to.saturating_sub(2).max(begin);
        let written = from < to;
        let number = if written { part(value, from, to) } else { value };
        Naming { name, usage, number, written, around: number, function: None }
    }
}

/// A part of a span, by bytes from its start.
fn part(span: Span, from: usize, to: usize) -> Span {
    let place = |at: usize| span.start.saturating_add(small(at)).min(span.end);
    Span::new(place(from), place(to))
}
