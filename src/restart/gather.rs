//! Reads the blocks behind the place: which parameters they read, and the blocks of open calls and loops, to be written
//! out.

use std::ops::ControlFlow;

use super::lines::{Lines, Numbers, named};
use crate::analysis::state::Before;
use crate::config::{Machine, Settings};
use crate::diag::{CallKind, Findings};
use crate::dict::{Address, FIRST_CONTROL, GCode, GGroup, LAST_CONTROL};
use crate::resolve::control_word;
use crate::run::{End, Executed, Program, Sink, State};
use crate::syntax::{BlockFlags, BlockId, Value, Word};
use crate::text::FileId;

/// Parameters, by number.
type Parameters = [bool; 96];

/// The reader.
#[derive(Debug)]
pub(super) struct Gather {
    place: u64,
    /// The first block that is not written out, and where it stands.
    text: u64,
    block: Option<BlockId>,
    /// No block from here on is written out.
    most: u64,
    before: Before,
    pub line_end: &'static str,
    /// The preamble's lines, still empty.
    pub preamble: Lines,
    /// Blocks of open calls and loops.
    pub flat: Lines,
    /// Where the program's own text goes on.
    pub rest: Option<u32>,
    reads: Parameters,
    written: Parameters,
}

impl Gather {
    /// From the place on; from `text` on the program's own text is used. `most`: the blocks that the program executes.
    pub fn new(settings: &Settings, place: u64, text: Option<(u64, BlockId)>, most: u64) -> Self {
        Self {
            most: text.map_or(most, |(seq, _)| seq),
            place,
            text: text.map_or(u64::MAX, |(seq, _)| seq),
            block: text.map(|(_, block)| block),
            before: Before::new(settings),
            line_end: "\n",
            preamble: Lines::default(),
            flat: Lines::default(),
            rest: None,
            reads: [false; 96],
            written: [false; 96],
        }
    }

    /// The parameters whose values at the place the rest reads, ascending.
    pub fn parameters(&self) -> impl Iterator<Item = u8> + '_ {
        (0..).zip(&self.reads).filter(|(_, read)| **read).map(|(index, _)| index)
    }

    fn read(&mut self, index: u8) {
        let at = usize::from(index);
        let is_written = self.written.get(at).copied().unwrap_or(true);
        if let Some(read) = self.reads.get_mut(at).filter(|_| !is_written) {
            *read = true;
        }
    }

    /// Notes what a block reads, then what it writes; `flat`: its words are written with their values.
    fn note(&mut self, block: &Executed<'_>, flat: bool) {
        let Uses { words, others, written } = Uses::of(block, self.before.state());
        let state = self.before.state();
        let words: Vec<u8> = words.into_iter().filter(|index| !flat || state.parameter(*index).is_none()).collect();
        words.into_iter().chain(others).for_each(|index| self.read(index));
        for index in written {
            if let Some(written) = self.written.get_mut(usize::from(index)) {
                *written = true;
            }
        }
    }
}

/// The parameters that a block uses, with the values from before it.
#[derive(Debug)]
pub(super) struct Uses {
    /// Those that its words read.
    pub words: Vec<u8>,
    /// Operands, and what a macrocycle of the machine may read.
    pub others: Vec<u8>,
    pub written: Vec<u8>,
}

impl Uses {
    pub(super) fn of(block: &Executed<'_>, before: &State) -> Self {
        let words = block.file().map_or(&[][..], |file| file.words(block.at().1));
        let read = |word: &Word| match word.value() {
            Value::Parameter { index, .. } => Some(index),
            Value::None | Value::Number(_) => None,
        };
        let assigned: Vec<u8> =
            words.iter().filter(|word| word.address == Address::R).map(|word| word.target()).collect();
        let mut others = operands(block, words, before);
        others.retain(|index| !assigned.contains(index));
        let written: Vec<u8> = assigned.into_iter().chain(block.params().iter().map(|(index, _)| *index)).collect();
        // Nobody knows what a macrocycle of the machine reads: whatever the program assigned.
        if block.is_opaque() {
            let known = (0..96).filter(|index| block.state().is_assigned(*index) && !written.contains(index));
            others.extend(known);
        }
        Self { words: words.iter().filter_map(read).collect(), others, written }
    }
}

/// The operands of a block's arithmetic.
fn operands(block: &Executed<'_>, words: &[Word], before: &State) -> Vec<u8> {
    let Some(function) = block.g_written().find(|code| code.group() == GGroup::G4) else { return Vec::new() };
    let machine: &Machine = &block.settings().machine;
    let controls = (FIRST_CONTROL..=LAST_CONTROL).take(function.operations());
    let mut operands = Vec::new();
    for control in controls {
        let word = words.iter().find(|word| word.address == Address::R && word.target() == control);
        let value = word.and_then(|word| value_of(*word, before));
        if let Some(Ok(control)) = value.map(|value| control_word(machine, value)) {
            operands.push(control.first);
            operands.extend(control.second);
        }
    }
    operands
}

/// The value of a word before its block is executed.
fn value_of(word: Word, before: &State) -> Option<crate::dict::Decimal> {
    match word.value() {
        Value::Number(number) => Some(number),
        Value::None => None,
        Value::Parameter { index, negated } => {
            let value = before.parameter(index)?;
            Some(if negated { value.negated() } else { value })
        }
    }
}

/// Whether a fixed cycle called the macrocycle of a block: the blocks written out call it again.
pub(super) fn is_in_cycle(block: &Executed<'_>) -> bool {
    block.calls().any(|call| matches!(call.by, CallKind::Cycle(_)))
}

/// The words of a block, written out: values in place of parameters, no calls and jumps. Empty: it does nothing else.
pub(super) fn flat_words(block: &Executed<'_>, before: &State) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    // A macrocycle that only the machine has is called again.
    let calls = block.opaque_call().is_some();
    let functions = block.g_written().filter(|code| code.group() != GGroup::G7 || (calls && *code == GCode::G72));
    words.extend(functions.map(|code: GCode| code.to_string()));
    let dwells = block.dwell().is_some();
    let written = block.file().map_or(&[][..], |file| file.words(block.at().1));
    for word in written {
        let is_flow = !calls && (word.address == Address::L || (word.address == Address::Q && !dwells));
        if is_flow || matches!(word.address, Address::G | Address::M | Address::Skip | Address::N) {
            continue;
        }
        let letter = word.address.row().letter;
        let value = match (value_of(*word, before), word.value()) {
            (Some(value), _) if word.address == Address::Correction => {
                format!("{:04}", value.as_whole().unwrap_or_default())
            }
            (Some(value), _) => value.to_string(),
            (None, Value::Parameter { index, negated }) => format!("{}R{index}", if negated { "-" } else { "" }),
            (None, _) => continue,
        };
        words.push(if word.address == Address::R {
            format!("R{}={value}", word.target())
        } else {
            letter.to_owned() + &value
        });
    }
    words.extend(block.m_written().iter().map(|number| format!("M{number:02}")));
    if !words.is_empty() && block.file().is_some_and(|file| file.flags(block.at().1).has(BlockFlags::SKIP)) {
        words.insert(0, "/".to_owned());
    }
    words
}

impl Sink for &mut Gather {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        let Some(file) = program.resolved.file(FileId(0)) else { return };
        self.line_end = file.source.line_end();
        let most = self.most.saturating_sub(self.place);
        [self.preamble, self.flat] = Numbers::of(file).lines(most, self.line_end);
        self.rest = self.block.map(|block| {
            let n = file.n_place(block).span.start;
            file.comments(block).first().map_or(n, |comment| comment.start.min(n))
        });
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.before.arrive(block);
        if block.seq() >= self.place {
            let flat = block.seq() < self.text && !is_in_cycle(block);
            self.note(block, flat);
            if flat {
                let words = flat_words(block, self.before.state());
                if !words.is_empty() {
                    self.flat.block(&words, &named(block.n(), block.file_index(), block.file_name()));
                }
            }
        }
        self.before.pass(block);
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
