//! Letters that stand for digits, and letters and numbers that changed places: one slip is one finding, and what it may
//! have been meant as is offered.

use super::lower::Lowering;
use super::missing::{SLIPS, Split};
use super::number::Number;
use super::{Kind, Token, Word, poison, tokens};
use crate::diag::{Diagnostic, Finding, Fix, FixTitle, Meant, NumberMeant, ValueMeant, shown};
use crate::dict::{Address, Decimal, GCode, HIGHEST_BLOCK};
use crate::sure::{Sure, small};
use crate::text::Span;

/// Longer words are not looked at for a letter in them.
const WORD: u32 = 40;

/// The digit that a letter looks like.
pub(super) const fn look_alike(letter: u8) -> Option<char> {
    match letter {
        b'O' | b'o' => Some('0'),
        b'I' | b'l' => Some('1'),
        b'S' => Some('5'),
        b'B' => Some('8'),
        _ => None,
    }
}

/// Letters that hardly begin a word right behind an address: next to digits on the keyboard, or no address at all.
const fn is_unlikely(letter: u8) -> bool {
    matches!(letter, b'Q' | b'E' | b'O' | b'P' | b'T' | b'L')
}

/// What stands right behind an address without a value.
struct Behind {
    /// The letter and its number.
    token: Token,
    letter: u8,
    /// A sign stands before the letter: it begins no word.
    signed: bool,
}

impl Lowering<'_> {
    /// `Z-24/2`, `R10/2`: nothing is divided (BLK-11). The word before has no value then. `false`: it is no such thing.
    pub(super) fn divided(&mut self, slash: Span) -> bool {
        let by = self.slice(slash).strip_prefix('/').filter(|by| by.starts_with(|digit: char| digit.is_ascii_digit()));
        let behind = slash.start.checked_sub(1).map(|at| self.byte(at));
        let number = behind.is_some_and(|byte| byte.is_ascii_digit() || byte == b'.');
        let (Some(by), true, text) = (by, number, self.text) else { return false };
        let is_before = |word: &&mut Word| word.address != Address::N && word.span(text).end == slash.start;
        let Some(word) = self.words.last_mut().filter(is_before) else { return false };
        let before = word.span(text);
        let of = before.to(slash);
        let value = word.number().filter(|_| word.address != Address::R);
        let divisor = Number::parse(by.as_bytes()).map(|by| by.value.thousandths()).filter(|by| *by != 0);
        let quotient = value.zip(divisor).and_then(|(value, by)| {
            let product = value.thousandths().checked_mul(1000)?;
            (product % by == 0).then(|| format!("{}{}", word.address, Decimal::from_thousandths(product / by)))
        });
        let void = Word::bare(word.address, of).faulty();
        *word = if word.address == Address::R { void.assigning(word.target()) } else { void };
        self.pending.retain(|found| !before.range().contains(&(found.at.span.start as usize)));
        let meant = quotient.map_or(NumberMeant::Undivided, |written| NumberMeant::Divided { written });
        self.report(of, Finding::MalformedNumber { text: shown(self.slice(of)), meant });
        true
    }

    /// `LI00`, `X-Q5`, `R10=l2`: of an address without a value, the letter right behind it that stands in place of a digit.
    /// What the two would have set is not known, but for a number that is no coordinate.
    pub(super) fn letters_for_digits(&mut self, first: usize) {
        for at in 0..self.pending.len().min(SLIPS) {
            let Some(found) = self.pending.get(at) else { return };
            if !matches!(&found.finding, Finding::MissingValue { meant: ValueMeant::Number, .. }) {
                continue;
            }
            let span = found.at.span;
            if let Some(behind) = self.behind(span)
                && let Some(slot) = (first..self.words.len())
                    .find(|slot| self.words.get(*slot).is_some_and(|word| word.start() == span.start))
            {
                self.letter_for_digit(first, (at, slot), span, &behind);
            }
        }
    }

    /// The word right behind an address without a value, which stands at `span`; of a small `l` blanks may be between.
    fn behind(&self, span: Span) -> Option<Behind> {
        let bytes = self.text.as_bytes();
        let assigns = self.slice(span).ends_with('=');
        let sign = assigns && matches!(self.byte(span.end), b'+' | b'-');
        let from = span.end + u32::from(sign);
        let rest = bytes.get(from as usize..)?;
        let blanks = rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let letter = rest.get(blanks).copied()?;
        let upper = self.byte(span.start).is_ascii_uppercase();
        if blanks > 0 && !(letter == b'l' && upper) {
            return None;
        }
        let start = from + u32::try_from(blanks).ok()?;
        let limit = small(bytes.len()).min(start + WORD);
        let limit = (start..=limit).rev().find(|limit| self.text.is_char_boundary(*limit as usize))?;
        let token = tokens(self.text, start, limit).next()?;
        let whole = token.kind == Kind::Word && token.start == start && token.end < start + WORD;
        let signed = sign || self.slice(span).ends_with(['+', '-']);
        (whole && letter.is_ascii_alphabetic()).then_some(Behind { token, letter, signed })
    }

    fn letter_for_digit(&mut self, first: usize, (at, slot): (usize, usize), span: Span, behind: &Behind) {
        let Behind { token, letter, signed } = *behind;
        let Some(word) = self.words.get(slot).copied() else { return };
        let second = Address::from_byte(letter);
        let same = |other: &&Word| Some(other.address) == second && !matches!(other.address, Address::G | Address::M);
        let repeated = self.words.get(first..).sure().iter().filter(same).count() > 1;
        let digit = look_alike(letter);
        let of_arc = letter == b'I' && !signed && !repeated && self.arc_in_force(token.start);
        let assigned = word.address == Address::R;
        if of_arc || !(digit.is_some() || is_unlikely(letter) || signed || repeated || assigned) {
            return;
        }
        let whole = span.to(token.span());
        let head = self.text.get(span.start as usize..token.start as usize).sure();
        let head: String = head.chars().filter(|character| !matches!(character, ' ' | '\t')).collect();
        let head = head.to_ascii_uppercase();
        let rest = self.slice(token.span()).get(1..).sure().trim_start_matches([' ', '\t']);
        let number = digit.map(|digit| format!("{digit}{rest}"));
        let sign = head.chars().next_back().filter(|sign| matches!(sign, '+' | '-')).map(String::from);
        let number = number.map(|number| sign.unwrap_or_default() + &number);
        let value = number.as_ref().and_then(|number| Number::parse(number.as_bytes()));
        let written = value.map(|_| format!("{}{}", head.trim_end_matches(['+', '-']), number.unwrap_or_default()));
        let function = matches!(word.address, Address::G | Address::M | Address::R | Address::Correction);
        let known = value.filter(|value| !function && !word.address.is_dimensional() && !value.point && !value.minus);
        if let Some(slot) = self.words.get_mut(slot) {
            *slot = match known {
                Some(value) => Word::with_number(word.address, span, value).faulty(),
                None => Word::bare(word.address, span).faulty().assigning(word.target()),
            };
        }
        if let Some(slot) = self.words.iter_mut().skip(first).find(|other| other.start() == token.start) {
            *slot = Word::bare(slot.address, token.span()).faulty();
        }
        self.lowercase.retain(|place| *place != token.start);
        let place = self.at(whole);
        if let (Some(written), Some(found)) = (written, self.pending.get_mut(at)) {
            if let Finding::MissingValue { meant, .. } = &mut found.finding {
                let letter = char::from(letter).to_string();
                *meant = ValueMeant::LetterForDigit { letter, written: shown(&written) };
            }
            let title = FixTitle::Write { text: shown(&written) };
            found.fixes = vec![Fix::offer(title, place, written)];
        }
        self.pending.retain(|found| found.at.span.start != token.start);
    }

    /// `N13l0 G1`: a small `l` is the address of a word (LEX-12), but behind a block number, where nothing takes an L, it is a
    /// digit.
    pub(super) fn small_l_in_number(&mut self, first: usize) {
        let (Some(n), Some(l)) = (self.words.get(first).copied(), self.words.get(first + 1).copied()) else { return };
        let small = l.address == Address::L && self.byte(l.start()) == b'l' && self.byte(n.start()) == b'N';
        if !small || n.address != Address::N || !n.is_digits() || !l.is_digits() {
            return;
        }
        let (head, tail) = (n.span(self.text), l.span(self.text));
        let others = self.words.get(first + 2..).sure();
        let takes = |word: &Word| word.g_code().is_some_and(GCode::takes_l);
        let taken = others.iter().any(takes) && !others.iter().any(|word| word.address == Address::L);
        let number = format!("{}1{}", self.slice(head), self.slice(tail).get(1..).sure());
        let value = number.get(1..).and_then(|number| Number::parse(number.as_bytes()));
        let Some(value) = value.filter(|_| !taken && head.end == tail.start) else { return };
        self.words.remove(first + 1);
        if let Some(slot) = self.words.get_mut(first) {
            *slot = Word::with_number(Address::N, head.to(tail), value).faulty();
        }
        self.lowercase.retain(|place| *place != tail.start);
        let place = self.at(head.to(tail));
        let diagnostic = Diagnostic::new(Finding::LetterForDigit { fixed: number.clone() }, place);
        self.pending.push(diagnostic.with_offer(FixTitle::Write { text: number.clone() }, place, number));
    }

    /// `80X 20Y`: several numbers before their addresses. The first was taken for a piece of the word before.
    pub(super) fn exchanged_words(&mut self, at: usize, split: &Split) -> bool {
        let Some((length, written)) = exchanged_run(self.text.get(split.loose.start as usize..).sure()) else {
            return false;
        };
        let whole = Span::new(split.loose.start, split.loose.start + length);
        let (text, place) = (shown(self.slice(whole)), self.at(whole));
        self.pending.retain({
            let mut index = 0;
            move |found| {
                index += 1;
                index - 1 == at || !(whole.start..whole.end).contains(&found.at.span.start)
            }
        });
        if let Some(found) = self.pending.get_mut(at)
            && let Finding::SplitNumber { loose, written: meant, .. } = &mut found.finding
        {
            (*loose, *meant) = (text, shown(&written));
            found.at = place;
            let title = FixTitle::Write { text: shown(&written) };
            found.fixes = vec![Fix::offer(title, place, written)];
        }
        let source = self.text;
        for word in self.words.iter_mut().skip(split.at + 1) {
            if (whole.start..whole.end).contains(&word.start()) {
                *word = Word::bare(word.address, word.span(source)).faulty();
            }
        }
        self.keep_first_piece(split);
        true
    }

    /// The word in pieces is what its first piece says.
    pub(super) fn keep_first_piece(&mut self, split: &Split) {
        let head = Span::new(split.word.start(), split.loose.start);
        let kept = Number::parse(split.number.as_bytes()).map_or_else(
            || Word::bare(split.word.address, head),
            |number| Word::with_number(split.word.address, head, number),
        );
        if let Some(slot) = self.words.get_mut(split.at) {
            *slot = kept.faulty();
        }
    }

    /// `110 G02 X70`, `(10 G02`: the letter of a block number is missing, or is another sign.
    pub(super) fn lost_number(&mut self, token: Token) {
        let span = token.span();
        self.push_void(Address::N, span);
        // The finding of that `N` says it.
        if poison::follows_n(self.text.as_bytes(), span.start) {
            return;
        }
        let text = self.slice(span);
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        let written = format!("N{digits}");
        let finding = if text.starts_with(|first: char| first.is_ascii_digit() || "+-.,".contains(first)) {
            let meant = NumberMeant::BlockNumber { written: written.clone() };
            Finding::MalformedNumber { text: shown(text), meant }
        } else {
            Finding::UnknownCharacter { text: shown(text), meant: Meant::of(text) }
        };
        let place = self.at(span);
        let title = FixTitle::Write { text: written.clone() };
        self.pending.push(Diagnostic::new(finding, place).with_offer(title, place, written));
    }

    /// `8N0`: the letter of a block number is inside it.
    pub(super) fn mixed_number(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        let written = format!("N{digits}");
        let place = self.at(span);
        let finding = Finding::SplitNumber { joined: String::new(), loose: shown(text), written: shown(&written) };
        let title = FixTitle::Write { text: shown(&written) };
        self.pending.push(Diagnostic::new(finding, place).with_offer(title, place, written));
        let start =
            text.find(['N', 'n']).and_then(|at| u32::try_from(at).ok()).map_or(span.start, |at| span.start + at);
        let of_letter = Span::new(start, span.end);
        self.push_void(Address::N, of_letter);
    }
}

/// Whether digits stand right before the block number in `token`: `8N0`, `1N30`.
pub(super) fn is_mixed_number(bytes: &[u8], before: &[Token], token: Token) -> bool {
    let Some((number, others)) = before.split_last() else { return false };
    // `R65 51N20`: the number is the value of a parameter (PAR-1).
    let value = others.last().is_some_and(|last| matches!(last.kind, Kind::Parameter | Kind::Equals | Kind::Sign));
    if number.kind != Kind::Number || number.end != token.start || value {
        return false;
    }
    let digits = |from: u32, to: u32| {
        bytes.get(from as usize..to as usize).is_some_and(|digits| digits.iter().all(u8::is_ascii_digit))
    };
    let apart = number.start.checked_sub(1).and_then(|at| bytes.get(at as usize)).is_none_or(u8::is_ascii_whitespace);
    let length = (token.end - number.start - 1) as usize;
    let zero = bytes.get(number.start as usize) == Some(&b'0');
    token.kind == Kind::Word
        && apart
        && !zero
        && digits(number.start, number.end)
        && digits(token.start + 1, token.end)
        && length <= HIGHEST_BLOCK.to_string().len()
}

/// `80X 20Y`: two numbers or more, each with its address right behind it, and no number behind the last; how long it is, and
/// what was meant.
fn exchanged_run(text: &str) -> Option<(u32, String)> {
    let bytes = text.as_bytes();
    let mut written: Vec<String> = Vec::new();
    let (mut at, mut end) = (0, 0);
    while written.len() < SLIPS {
        let rest = bytes.get(at..).sure();
        let length = rest.iter().take_while(|byte| byte.is_ascii_digit() || b"+-.".contains(byte)).count();
        if length == 0 {
            break;
        }
        let number = text.get(at..at + length).filter(|number| Number::parse(number.as_bytes()).is_some())?;
        let address = rest.get(length).copied().and_then(Address::from_byte)?;
        if matches!(address, Address::N | Address::R | Address::Skip | Address::Program) {
            return None;
        }
        written.push(format!("{address}{number}"));
        end = at + length + 1;
        let behind = bytes.get(end..).sure();
        let blanks = behind.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        if blanks == 0 && !matches!(behind.first(), None | Some(b'\r' | b'\n' | b'"' | b'*')) {
            return None;
        }
        at = end + blanks;
    }
    (written.len() > 1).then(|| (small(end), written.join(" ")))
}
