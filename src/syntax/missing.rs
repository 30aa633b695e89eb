//! A number behind a word and a blank: its address was forgotten, or a blank is inside a number (LEX-3).

use super::lower::Lowering;
use super::{Kind, Word, tokens};
use crate::diag::{Code, Diagnostic, Finding, Fix, FixTitle, NumberMeant, shown};
use crate::dict::{Address, GCode, GGroup, TOOL_CHANGE};
use crate::sure::Sure;
use crate::text::Span;

/// So many bytes before a block, and from it on, show which axes the program uses.
const NEAR: usize = 1 << 12;
/// So many findings of a block are looked at for what was meant: nobody makes more slips in one.
pub(super) const SLIPS: usize = 64;
/// `&0010`
const CORRECTION_DIGITS: usize = 4;

/// A word in two pieces.
pub(super) struct Split {
    /// Where it is among the words.
    pub(super) at: usize,
    pub(super) word: Word,
    /// The digits of the first piece, as they are written.
    pub(super) number: String,
    /// The second piece.
    pub(super) loose: Span,
    text: String,
}

impl Split {
    /// Whether the second piece goes on where the first one stopped: `36.  12`, `1 000`, `10 .5`.
    fn is_continued(&self) -> bool {
        let zeros = self.text.len() > 1 && self.text.starts_with('0') && !self.text.starts_with("0.");
        let speed = self.word.address == Address::S && self.text == "00";
        let function = matches!(self.word.address, Address::G | Address::M | Address::N | Address::T | Address::S);
        let digits = self.word.address == Address::D && self.text.len() == CORRECTION_DIGITS;
        self.number.ends_with('.')
            || self.text.starts_with('.')
            || speed
            || (zeros && !digits && !(function && self.text.len() == 2))
    }

    /// Whether the second piece is a number with a point of its own: `45 10.5`, but not `1 000.5`.
    fn has_own_point(&self) -> bool {
        self.text.find('.').is_some_and(|digits| !matches!(digits, 0 | 3))
    }

    /// Two digits that are those of one function: `M0 3`.
    fn is_function(&self) -> bool {
        matches!(self.word.address, Address::G | Address::M) && self.number.len() == 1 && self.text.len() == 1
    }

    fn code(&self) -> Option<GCode> {
        self.number.parse().ok().and_then(GCode::from_number)
    }
}

impl Lowering<'_> {
    /// Says which address was forgotten before a number, in the block whose words begin at `first`, and leaves unknown what
    /// the two words would have set (§13). A coordinate keeps the value that joining gives, where no address is missing.
    pub(super) fn forgotten_addresses(&mut self, first: usize) {
        if self.words.get(first).is_none_or(|word| word.address != Address::N) {
            return;
        }
        for at in 0..self.pending.len().min(SLIPS) {
            let Some(found) = self.pending.get(at) else { return };
            let span = found.at.span;
            let signed = matches!(&found.finding, Finding::MalformedNumber { meant: NumberMeant::Form, .. });
            if !signed && !matches!(&found.finding, Finding::SplitNumber { joined, .. } if !joined.is_empty()) {
                continue;
            }
            if let Some(split) = self.split_at(first, span) {
                self.forgotten_address(first, at, &split, signed);
            } else if !signed {
                self.forgotten_parameter(at, span);
            }
        }
    }

    /// The word in pieces that stands at `span`.
    fn split_at(&self, first: usize, span: Span) -> Option<Split> {
        let words = self.words.get(first..)?;
        let at = first + words.iter().position(|word| word.start() == span.start && word.address != Address::R)?;
        let word = *self.words.get(at)?;
        let mut pieces = tokens(self.text, span.start, span.end);
        let (head, tail) = (pieces.next()?, pieces.next()?);
        if head.kind != Kind::Word || tail.kind != Kind::Number || pieces.next().is_some() {
            return None;
        }
        let number = self.slice(head.span()).get(1..)?.trim_start_matches([' ', '\t']).to_owned();
        let text = self.slice(tail.span()).to_owned();
        Some(Split { at, word, number, loose: tail.span(), text })
    }

    fn forgotten_address(&mut self, first: usize, at: usize, split: &Split, signed: bool) {
        let word = split.word;
        if self.exchanged_words(at, split) || !signed && self.exchanged_address(at, split) {
            return;
        }
        // `G7L1 100`: digits and letters are mixed up from the function on.
        if let Some(before) = split.at.checked_sub(1).filter(|before| *before > first)
            && let Some(function) = self.words.get(before).copied().filter(|word| word.address == Address::G)
            && function.span(self.text).end == word.start()
            && function.span(self.text).len() == 2
        {
            let unknown = Word::bare(Address::G, function.span(self.text)).faulty();
            self.words.splice(before..=before, [unknown]);
        }
        if !signed && (split.is_continued() || split.is_function()) {
            return;
        }
        let missing = self.missing_address(first, split);
        if signed && missing.is_none() {
            return;
        }
        let written = missing.map(|address| format!("{address}{}", split.text)).unwrap_or_default();
        let place = self.at(split.loose);
        if let Some(found) = self.pending.get_mut(at) {
            if let Finding::SplitNumber { loose, written: meant, .. } = &mut found.finding
                && (missing.is_some() || !word.address.is_dimensional())
            {
                (*loose, *meant) = (shown(&split.text), shown(&written));
            } else if let Finding::MalformedNumber { meant, .. } = &mut found.finding {
                *meant = NumberMeant::AddressMissing { loose: shown(&split.text), written: shown(&written) };
            }
            // Joining is less likely than what is missing: `X7040` for `X70 40` would be a wrong move.
            if written.is_empty() {
                found.fixes.retain(|_| word.address.is_dimensional() && !split.has_own_point());
            } else {
                let title = FixTitle::Write { text: shown(&written) };
                found.fixes = vec![Fix::offer(title, place, written)];
            }
        }
        let unknown = missing.is_some() || !word.address.is_dimensional() || split.has_own_point();
        if let Some(slot) = self.words.get_mut(split.at).filter(|_| unknown) {
            *slot = Word::bare(word.address, word.span(self.text)).faulty();
        }
        self.leave_unknown(first, split, missing);
    }

    /// `4Y0`: the address stands behind the first digits of its number. The number that the second piece was taken for goes
    /// on with the word before it.
    fn exchanged_address(&mut self, at: usize, split: &Split) -> bool {
        let digits = split.text.bytes().all(|byte| byte.is_ascii_digit());
        let behind = self.words.get(split.at + 1).copied().filter(|next| next.start() == split.loose.end);
        let Some(next) =
            behind.filter(|next| digits && !matches!(next.address, Address::R | Address::N | Address::Skip))
        else {
            return false;
        };
        let span = next.span(self.text);
        let whole = split.loose.to(span);
        let Some(rest) =
            self.slice(span).get(1..).filter(|rest| rest.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.'))
        else {
            return false;
        };
        // `G0 2X10`, `Y4 0I15`: it goes on with the number before it.
        if split.is_function() || split.text.starts_with('0') && rest.starts_with(|first: char| first.is_ascii_digit())
        {
            return false;
        }
        // `N18 0G71`: a function has two digits already.
        let function = matches!(next.address, Address::G | Address::M);
        if function && rest.len() + split.text.len() > 2 {
            return false;
        }
        let written = format!("{}{}{rest}", next.address, split.text);
        let (text, place, of_letter) = (shown(self.slice(whole)), self.at(whole), self.at(span));
        if let Some(found) = self.pending.get_mut(at)
            && let Finding::SplitNumber { loose, written: meant, .. } = &mut found.finding
        {
            (*loose, *meant) = (text, shown(&written));
            found.at = place;
            let title = FixTitle::Write { text: shown(&written) };
            found.fixes = vec![Fix::offer(title, place, written)];
        }
        self.pending.retain(|found| found.code() != Code::E0103 || found.at.span != of_letter.span);
        self.keep_first_piece(split);
        if let Some(slot) = self.words.get_mut(split.at + 1) {
            *slot = Word::bare(next.address, span).faulty();
        }
        true
    }

    /// The address that was probably forgotten before the second piece.
    fn missing_address(&mut self, first: usize, split: &Split) -> Option<Address> {
        let words = self.words.get(first..).sure();
        let has = |address: Address| words.iter().any(|word| word.address == address);
        let others = words.iter().filter(|word| !matches!(word.address, Address::N | Address::Skip)).count();
        let code = |word: &Word| word.g_code();
        let working = words.iter().filter_map(code).any(|code| matches!(code, GCode::G01 | GCode::G02 | GCode::G03));
        let plain = split.text.bytes().all(|byte| byte.is_ascii_digit());
        let function = split.text.parse().ok().filter(|_| plain && split.text.len() == 2).and_then(GCode::from_number);
        let of_group = |group: GGroup| words.iter().filter_map(code).any(|code| code.group() == group);
        let function = function.filter(|code| !of_group(code.group()));
        let two = plain && split.text.len() == 2;
        let feed = |wanted: bool| (wanted && plain && split.text.len() > 1 && !has(Address::F)).then_some(Address::F);
        let first_axis = [Address::X, Address::Y, Address::Z]
            .into_iter()
            .find(|axis| !has(*axis))
            .filter(|axis| *axis == Address::X);
        let address = split.word.address;
        let wanted = |wanted: bool, address: Address| wanted.then_some(address);
        let flow = plain && matches!(split.text.as_str(), "71" | "72" | "73") && !of_group(GGroup::G7);
        if flow && has(Address::L) && address != Address::L {
            Some(Address::G)
        } else if address == Address::N {
            if words.iter().any(|word| word.is_m(TOOL_CHANGE)) && !has(Address::T) && plain {
                Some(Address::T)
            } else if others == 0 {
                None
            } else if function.is_some() {
                Some(Address::G)
            } else {
                first_axis.filter(|_| !plain)
            }
        } else if address == Address::G {
            let code = split.code()?;
            if code.takes_l() {
                wanted(!has(Address::L) && plain, Address::L)
            } else if code == GCode::G04 {
                wanted(!has(Address::Q) && plain, Address::Q)
            } else if function.is_some_and(|function| function.group() != code.group()) {
                wanted(code.group() != GGroup::G0 || has(Address::X), Address::G)
            } else {
                first_axis.filter(|_| code.group() == GGroup::G0)
            }
        } else if address == Address::M && !two {
            wanted(plain && !has(Address::S), Address::S)
        } else if two && matches!(address, Address::M | Address::T | Address::S)
            || address == Address::T && split.text == "6"
            || two && address == Address::F && split.text.starts_with('0')
        {
            Some(Address::M)
        } else if address == Address::L {
            wanted(plain && !has(Address::Q), Address::Q)
        } else if address == Address::D {
            let digits = plain && split.text.len() == CORRECTION_DIGITS;
            wanted(digits && !has(Address::Correction), Address::Correction)
        } else if address == Address::X && !has(Address::Y) && self.uses(split, b'Y') {
            Some(Address::Y)
        } else if matches!(address, Address::X | Address::Y)
            && !has(Address::Z)
            && (address == Address::X && !has(Address::Y) || address == Address::Y && !working)
            && self.uses(split, b'Z')
        {
            Some(Address::Z)
        } else if address == Address::I && !has(Address::J) {
            Some(Address::J)
        } else {
            feed(working && matches!(address, Address::X | Address::Y | Address::Z | Address::J))
        }
    }

    /// Whether words of an axis stand near the block.
    fn uses(&self, split: &Split, axis: u8) -> bool {
        let at = split.word.start() as usize;
        let bytes = self.text.as_bytes();
        let near = bytes.get(at.saturating_sub(NEAR)..bytes.len().min(at + NEAR)).sure();
        near.windows(2).any(|pair| {
            matches!(pair, [letter, value] if *letter == axis && (value.is_ascii_digit() || b"+-.".contains(value)))
        })
    }

    /// What the second piece would have set is not known, whichever address it lacks.
    fn leave_unknown(&mut self, first: usize, split: &Split, missing: Option<Address>) {
        const OF_A_BLOCK: [Address; 9] = [
            Address::G,
            Address::M,
            Address::T,
            Address::S,
            Address::F,
            Address::D,
            Address::X,
            Address::Y,
            Address::Z,
        ];
        const AXES: [Address; 3] = [Address::X, Address::Y, Address::Z];
        let wanted: &[Address] = match (missing.as_ref(), split.word.address) {
            (Some(address), _) => std::slice::from_ref(address),
            (None, Address::N) => &OF_A_BLOCK,
            (None, Address::G) => &AXES,
            (None, _) => &[],
        };
        let words = self.words.get(first..).sure();
        let moves = words.iter().any(|word| word.address.axis().is_some());
        let lacks = |address: &Address| {
            let function = matches!(address, Address::G | Address::M);
            let axis = address.axis().is_some() && missing.is_none() && moves;
            !axis && (function || !words.iter().any(|word| word.address == *address))
        };
        let unknown: Vec<Word> =
            wanted.iter().copied().filter(lacks).map(|address| Word::bare(address, split.loose).faulty()).collect();
        let behind = split.at + 1;
        self.words.splice(behind..behind, unknown);
    }

    /// `R10=-12 11=80`: an R forgotten before the second parameter.
    fn forgotten_parameter(&mut self, at: usize, span: Span) {
        let value = |found: &Diagnostic| {
            found.at.span.start == span.end
                && matches!(&found.finding, Finding::MalformedNumber { meant: NumberMeant::EqualsForm, .. })
        };
        let Some(behind) = self.pending.iter().position(value) else { return };
        let Some(last) = tokens(self.text, span.start, span.end).last().filter(|last| last.kind == Kind::Number) else {
            return;
        };
        let Some(target) = self.slice(last.span()).parse().ok().filter(|target| *target < super::lower::PARAMETERS)
        else {
            return;
        };
        let end = self.pending.get(behind).map_or(span.end, |found| found.at.span.end);
        let whole = Span::new(last.start, end);
        let (text, written) = (shown(self.slice(whole)), format!("R{}", self.slice(whole)));
        let place = self.at(Span::new(last.start, last.start));
        if let Some(found) = self.pending.get_mut(at)
            && let Finding::SplitNumber { loose, written: meant, .. } = &mut found.finding
        {
            (*loose, *meant) = (text, shown(&written));
            let title = FixTitle::Write { text: shown(&written) };
            found.fixes = vec![Fix::offer(title, place, "R")];
        }
        self.pending.remove(behind);
        let start = span.start;
        if let Some(index) = self.words.iter().rposition(|word| word.start() == start && word.address == Address::R)
            && let Some(word) = self.words.get(index).copied()
        {
            let known = Word::bare(Address::R, word.span(self.text)).assigning(word.target()).faulty();
            if let Some(slot) = self.words.get_mut(index) {
                *slot = known;
            }
            let loose = Word::bare(Address::R, last.span()).assigning(target).faulty();
            self.words.insert(index + 1, loose);
        }
    }
}
