//! A number behind a word and a blank: its address was forgotten or follows it, or a blank is inside a number (LEX-3).

use super::numbers::{self, Broken, CORRECTION_DIGITS};
use super::{Around, Diagnosis, write};
use crate::diag::{Diagnostic, Finding, Fix, NumberMeant, shown};
use crate::dict::{Address, GCode, GGroup, PROGRAM_ENDS, TOOL_CHANGE};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// So many bytes before a block, and from it on, show which axes and block numbers the program uses.
const NEAR: usize = 1 << 12;

/// A word in two pieces.
struct Split<'t> {
    word: Token,
    address: Address,
    /// The digits of the first piece, as they are written.
    number: &'t str,
    /// The second piece.
    loose: Token,
    text: &'t str,
    /// The two are no number together: `X10 -5`.
    apart: bool,
}

impl<'t> Split<'t> {
    fn at(around: &Around<'t>) -> Option<Self> {
        let [word, loose] = around.next([Kind::Word, Kind::Number]).filter(|_| around.is_numbered())?;
        let mut next = around.cursor();
        next.taken = 2;
        let alone = next.number().is_none();
        let (number, text) = (around.number(word), around.slice(loose.span()));
        let apart = Number::parse(format!("{number}{text}").as_bytes()).is_none();
        let address = around.address(word).filter(|_| alone)?;
        Some(Self { word, address, number, loose, text, apart })
    }

    /// Whether the second piece goes on where the first one stopped: `36.  12`, `1 000`, `10 .5`.
    fn is_continued(&self) -> bool {
        let zeros = self.text.len() > 1 && self.text.starts_with('0') && !self.text.starts_with("0.");
        let speed = self.address == Address::S && self.text == "00";
        let function = matches!(self.address, Address::G | Address::M | Address::N | Address::T | Address::S);
        let function = self.text.len() == 2 && (function || self.text != "00");
        let digits = self.address == Address::D && self.text.len() == CORRECTION_DIGITS;
        self.number.ends_with('.') || self.text.starts_with('.') || speed || (zeros && !digits && !function)
    }

    /// Two digits that are those of one function: `M0 3`.
    fn is_function(&self) -> bool {
        matches!(self.address, Address::G | Address::M) && self.number.len() == 1 && self.text.len() == 1
    }

    fn joined(&self) -> String {
        shown(&format!("{}{}{}", self.address, self.number, self.text))
    }

    /// Whether the block makes sense with the two pieces joined, where an address is `missing`.
    fn may_join(&self, around: &Around<'_>, missing: Address) -> bool {
        let arc = || around.functions().any(|code| matches!(code, GCode::G02 | GCode::G03));
        let flow = || missing == Address::G && around.has(Address::L);
        let digits = || self.text.starts_with('0') || missing == Address::T;
        let number = || digits() && !self.rises(around, &format!("{}{}", self.number, self.text));
        !(missing.axis().is_some() && arc() || flow() || self.address == Address::N && number())
    }

    /// Whether a number of the block is between those of the blocks around it.
    fn rises(&self, around: &Around<'_>, number: &str) -> bool {
        let (text, at) = (around.text, self.word.start as usize);
        let from = text.floor_char_boundary(at.saturating_sub(NEAR));
        let to = text.ceil_char_boundary(text.len().min(at + NEAR));
        let before = text.get(from..at).sure().rsplit(['\r', '\n']).find_map(numbers::number_of_line);
        let behind = text.get(at..to).sure().split(['\r', '\n']).skip(1).find_map(numbers::number_of_line);
        let number = number.parse().unwrap_or(0);
        before.unwrap_or(0) < number && behind.is_none_or(|behind| number < behind)
    }

    /// Whether the second piece is the rest of the block number: alone, the first would not rise.
    fn is_number(&self, around: &Around<'_>) -> bool {
        self.address == Address::N
            && !self.rises(around, self.number)
            && self.rises(around, &format!("{}{}", self.number, self.text))
    }

    /// Whether the first piece is a function with two digits: nothing goes on with it.
    fn is_full_function(&self) -> bool {
        matches!(self.address, Address::G | Address::M) && self.number.len() > 1
    }

    /// The finding that the second piece is part of `loose`, which was meant as `written`, or goes on with the first.
    fn instead(&self, around: &Around<'_>, loose: Span, written: String) -> Diagnostic {
        // What is behind it would be left without a number, or without a function that takes it.
        let rest = around.slice(loose);
        let flow = self.address == Address::N && (around.has(Address::L) || around.has(Address::Q));
        let whole = rest.ends_with(|last: char| last.is_ascii_digit()) && !flow;
        let base = numbers::word(around).and_then(|base| base.found).filter(|found| whole && !found.fixes.is_empty());
        let (joined, joining) = match base.map(|base| (base.finding, base.fixes)) {
            Some((Finding::SplitNumber { joined, .. }, fixes)) => (joined, fixes),
            Some((_, fixes)) => (self.joined(), fixes),
            None => (String::new(), Vec::new()),
        };
        let finding = Finding::SplitNumber { joined, loose: shown(around.slice(loose)), written: shown(&written) };
        let mut found = around.offering(loose, finding, written);
        found.fixes.extend(joining);
        found
    }

    /// The word in pieces as its first piece says it.
    fn first_piece(&self, diagnosis: Diagnosis) -> Diagnosis {
        let head = self.word.span();
        let word = Number::parse(self.number.as_bytes())
            .map_or_else(|| Word::bare(self.address, head), |number| Word::with_number(self.address, head, number));
        diagnosis.with(word, head)
    }
}

/// `80X 20Y`: several numbers before their addresses. The first was taken for a piece of the word before.
pub(super) fn exchanged_words(around: &Around<'_>) -> Option<Diagnosis> {
    let split = Split::at(around)?;
    let (length, written) = exchanged_run(around.text.get(split.loose.start as usize..).sure())?;
    let whole = Span::new(split.loose.start, split.loose.start + length);
    let found = if split.apart {
        around.malformed(split.word.span().to(split.loose.span()), NumberMeant::Form)
    } else {
        split.instead(around, whole, written)
    };
    let inside = |token: &&Token| token.start < whole.end;
    let tokens: Vec<Token> = around.tokens.iter().skip(around.at + 1).take_while(inside).copied().collect();
    let words = tokens.iter().filter(|token| matches!(token.kind, Kind::Word | Kind::Letter));
    let diagnosis = split.first_piece(Diagnosis::saying(1 + tokens.len(), found));
    Some(words.fold(diagnosis, |diagnosis, word| match around.address(*word) {
        Some(address) => diagnosis.void(address, word.span()),
        None => diagnosis,
    }))
}

/// `4Y0`: the address follows the first digits of its number. The number that the second piece was taken for goes on
/// with the word before it.
pub(super) fn exchanged_address(around: &Around<'_>) -> Option<Diagnosis> {
    let split = Split::at(around).filter(|split| !split.apart)?;
    let next = around.tokens.get(around.at + 2).copied().filter(|next| next.start == split.loose.end)?;
    let address = around.letter(next).filter(|address| !matches!(address, Address::R | Address::N))?;
    let number = around.tokens.get(around.at + 3).is_some_and(|more| more.kind == Kind::Number);
    if number || next.kind == Kind::Letter && grammar::word(around.text, around.tokens, around.at + 2).is_some() {
        return None;
    }
    let rest = around.slice(next.span()).get(1..)?;
    if !split.text.bytes().all(|byte| byte.is_ascii_digit())
        || !rest.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
    {
        return None;
    }
    // `G0 2X10`, `Y4 0I15`: it goes on with the number before it.
    // `Z50 0M9`: a function has two digits.
    let zero = split.text.starts_with('0') && rest.starts_with(|first: char| first.is_ascii_digit());
    if split.is_function() || zero && !matches!(address, Address::G | Address::M) {
        return None;
    }
    // `N18 0G71`: a function has two digits already. `F1 50X3`: one slip exchanges two characters.
    let exchanged = format!("{}{rest}", split.text);
    // `G71 L10 3x`: how often.
    let flow = split.address == Address::L && around.functions().any(GCode::takes_l) && !around.has(Address::Q);
    let times = around.byte(next.start) == b'x' && rest.is_empty() && !split.text.starts_with('0');
    let address = if flow && times { Address::Q } else { address };
    let takes = |number| around.may_mean(address, next.start, number);
    if matches!(address, Address::G | Address::M) && exchanged.len() > 2
        || !rest.is_empty() && split.text.len() > 1
        || !Number::parse(exchanged.as_bytes()).is_none_or(takes)
    {
        return None;
    }
    let whole = split.loose.span().to(next.span());
    let found = split.instead(around, whole, format!("{address}{exchanged}"));
    let diagnosis = split.first_piece(Diagnosis::saying(3, found)).void(address, next.span());
    Some(if rest.is_empty() { diagnosis.junk(next.span()) } else { diagnosis })
}

/// `X70 40`: which address was forgotten before a number. What the two words would have set is not known (§13).
pub(super) fn address(around: &Around<'_>) -> Option<Diagnosis> {
    let split = Split::at(around)?;
    let base = numbers::word(around)?;
    // `G7L1 100`: digits and letters are mixed up from the function on.
    let mixed = around.at > 1
        && around.previous().is_some_and(|before| {
            let function = before.kind == Kind::Word && around.address(before) == Some(Address::G);
            function && before.end == split.word.start && before.end - before.start == 2
        });
    let base = if mixed { base.junk(Span::empty(split.word.start)) } else { base };
    if !split.apart && (split.is_continued() || split.is_function()) {
        return Some(base);
    }
    // An end of the program, with words behind it, is a block number without its N.
    let goes_on = || around.tokens.iter().skip(around.at + 2).any(|token| token.kind == Kind::Word);
    let ends = |address: Address, number: Number| {
        let end = PROGRAM_ENDS.iter().any(|end| number.value.as_whole() == Some(i64::from(*end)));
        address == Address::M && end && goes_on()
    };
    let takes = |address: &Address| {
        let number = Number::parse(split.text.as_bytes());
        number.is_none_or(|number| around.may_mean(*address, split.loose.start, number) && !ends(*address, number))
    };
    let missing = missing(around, &split).filter(takes);
    // `N1 00 X5` between N90 and N110.
    let whole = missing.is_none_or(|missing| split.may_join(around, missing)) && split.is_number(around);
    let missing = missing.filter(|_| !whole);
    let dimensional = split.address.is_dimensional();
    let written = missing.map(|address| format!("{address}{}", split.text)).unwrap_or_default();
    let (loose, shown_written) = (shown(split.text), shown(&written));
    let base_found = base.found.clone()?;
    let joins = match missing {
        _ if split.is_full_function() => false,
        Some(missing) => split.may_join(around, missing),
        // Nothing goes on with a block number that fits.
        None => whole || split.address != Address::N || !split.rises(around, split.number),
    };
    let finding = if let Finding::SplitNumber { joined, .. } = &base_found.finding
        && (missing.is_some() || !dimensional && !whole)
    {
        let joined = if joins { joined.clone() } else { String::new() };
        Finding::SplitNumber { joined, loose, written: shown_written }
    } else if let Finding::MalformedNumber { text, .. } = &base_found.finding
        && missing.is_some()
    {
        let meant = NumberMeant::AddressMissing { loose, written: shown_written };
        Finding::MalformedNumber { text: text.clone(), meant }
    } else {
        base_found.finding.clone()
    };
    // What is missing is more likely than a blank too many: `X7040` for `X70 40` would be a wrong move.
    let missing_word = missing.map(|_| Fix::offer(write(&written), around.place(split.loose.span()), written));
    // `G71 1100`: the 1 may be a small l.
    let small_l = split.text.strip_prefix('1').filter(|_| missing == Some(Address::L));
    let small_l = small_l.filter(|rest| rest.starts_with(|first: char| matches!(first, '1'..='9')));
    let small_l = small_l.map(|rest| format!("L{rest}"));
    let small_l = small_l.map(|written| Fix::offer(write(&written), around.place(split.loose.span()), written));
    let joining = base_found.fixes.into_iter().filter(|_| joins);
    let fixes = missing_word.into_iter().chain(small_l).chain(joining).collect();
    let diagnosis = Diagnosis { found: Some(Diagnostic { finding, fixes, ..base_found }), ..base };
    if split.apart && missing.is_none() {
        return Some(diagnosis);
    }
    Some(
        unknown(around, &split, missing)
            .into_iter()
            .fold(diagnosis, |diagnosis, address| diagnosis.void(address, split.loose.span())),
    )
}

/// The address that was probably forgotten before the second piece.
fn missing(around: &Around<'_>, split: &Split<'_>) -> Option<Address> {
    let has = |address: Address| around.has(address);
    let working = around.functions().any(|code| matches!(code, GCode::G01 | GCode::G02 | GCode::G03));
    let plain = split.text.bytes().all(|byte| byte.is_ascii_digit());
    let two = plain && split.text.len() == 2;
    let of_group = |group: GGroup| around.functions().any(|code| code.group() == group);
    let function = split.text.parse().ok().filter(|_| two).and_then(GCode::from_number);
    let function = function.filter(|code| !of_group(code.group()));
    // Which one, only another axis tells.
    let first_axis = (!has(Address::X) && (has(Address::Y) || has(Address::Z))).then_some(Address::X);
    let wanted = |wanted: bool, address: Address| wanted.then_some(address);
    let flow = plain && matches!(split.text, "71" | "72" | "73") && !of_group(GGroup::G7);
    match split.address {
        address if flow && has(Address::L) && address != Address::L => Some(Address::G),
        Address::N => {
            let other = |word: &Word| !matches!(word.address, Address::N | Address::Skip);
            if around.words.iter().any(|word| word.is_m(TOOL_CHANGE)) && !has(Address::T) && plain {
                Some(Address::T)
            } else if !around.words.iter().any(other) {
                None
            } else if function.is_some() {
                Some(Address::G)
            } else {
                first_axis.filter(|_| !plain)
            }
        }
        Address::G => {
            let code = split.number.parse().ok().and_then(GCode::from_number)?;
            if code.takes_l() {
                wanted(!has(Address::L) && plain, Address::L)
            } else if code == GCode::G04 {
                wanted(!has(Address::Q) && plain, Address::Q)
            } else if function.is_some_and(|function| function.group() != code.group()) {
                wanted(code.group() != GGroup::G0 || has(Address::X), Address::G)
            } else {
                first_axis.filter(|_| code.group() == GGroup::G0)
            }
        }
        _ if is_function_behind(around, split) => Some(Address::M),
        Address::M if !two => wanted(plain && !has(Address::S), Address::S),
        Address::M => Some(Address::M),
        Address::T | Address::S if two => Some(Address::M),
        Address::T if split.text == "6" => Some(Address::M),
        Address::L => wanted(plain && !split.text.starts_with('0') && !has(Address::Q), Address::Q),
        Address::D => {
            let digits = plain && split.text.len() == CORRECTION_DIGITS;
            wanted(digits && !has(Address::Correction), Address::Correction)
        }
        Address::X if !has(Address::Y) && uses(around, split, b'Y') => Some(Address::Y),
        address @ (Address::X | Address::Y)
            if !has(Address::Z)
                && (address == Address::X && !has(Address::Y) || address == Address::Y && !working)
                && uses(around, split, b'Z') =>
        {
            Some(Address::Z)
        }
        Address::I if !has(Address::J) => Some(Address::J),
        Address::X | Address::Y | Address::Z | Address::J => {
            wanted(working && plain && split.text.len() > 1 && !has(Address::F), Address::F)
        }
        Address::A
        | Address::B
        | Address::C
        | Address::U
        | Address::V
        | Address::W
        | Address::I
        | Address::K
        | Address::F
        | Address::S
        | Address::T
        | Address::H
        | Address::P
        | Address::Q
        | Address::R
        | Address::Correction
        | Address::Skip
        | Address::Program => None,
    }
}

/// Whether the second piece is a function that lost its M behind a position: `Z100 09`.
fn is_function_behind(around: &Around<'_>, split: &Split<'_>) -> bool {
    let function = matches!(split.text.as_bytes(), [b'0', digit] if digit.is_ascii_digit());
    function && split.address.is_dimensional() && !around.has(Address::M)
}

/// Whether words of an axis stand near the block.
fn uses(around: &Around<'_>, split: &Split<'_>, axis: u8) -> bool {
    let at = split.word.start as usize;
    let bytes = around.text.as_bytes();
    let near = bytes.get(at.saturating_sub(NEAR)..bytes.len().min(at + NEAR)).sure();
    near.windows(2).any(
        |pair| matches!(pair, [letter, value] if *letter == axis && (value.is_ascii_digit() || b"+-.".contains(value))),
    )
}

/// The addresses that the second piece may have set.
fn unknown(around: &Around<'_>, split: &Split<'_>, missing: Option<Address>) -> Vec<Address> {
    use Address::{D, F, G, M, N, S, T, X, Y, Z};
    let wanted: &[Address] = match (missing.as_ref(), split.address) {
        (Some(address), _) => std::slice::from_ref(address),
        (None, N) => &[G, M, T, S, F, D, X, Y, Z],
        (None, G) => &[X, Y, Z],
        (None, _) => &[],
    };
    let moves = around.words.iter().any(|word| word.address.axis().is_some());
    let lacks = |address: &Address| {
        let axis = address.axis().is_some() && missing.is_none() && moves;
        !axis && (matches!(address, G | M) || !around.has(*address))
    };
    wanted.iter().copied().filter(lacks).collect()
}

/// `R10=-12 11=80`: an R forgotten before the second parameter.
pub(super) fn parameter(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.one(Kind::Parameter).filter(|_| around.is_numbered())?;
    next.one(Kind::Equals);
    let sign = next.one(Kind::Sign);
    let value = next.number()?;
    let last = next.one(Kind::Number)?;
    let end = next.peek().filter(|equals| equals.start == last.end)?;
    let stray = |kind| matches!(kind, Kind::Number | Kind::Sign | Kind::Equals);
    next.one(Kind::Equals)?;
    let end = std::iter::from_fn(|| next.when(stray)).last().unwrap_or(end);
    let number = grammar::parameter_number(around.number(first))?;
    let target = grammar::parameter_number(around.slice(last.span()))?;
    let (span, whole) = (first.span().to(last.span()), last.span().to(end.span()));
    let pieces = if sign.is_some() { vec![value, last] } else { vec![last] };
    let run = around.slice(sign.unwrap_or(value).span());
    let prefix = format!("R{number}=");
    let broken = Broken { address: Address::R, prefix: &prefix, run, pieces: &pieces, span };
    let (_, found) = broken.explain(around);
    let Finding::SplitNumber { joined, .. } = found?.finding else { return None };
    let written = format!("R{}", around.slice(whole));
    let loose = shown(around.slice(whole));
    let finding = Finding::SplitNumber { joined, loose, written: shown(&written) };
    let place = around.place(Span::empty(last.start));
    let found = around.diagnostic(span, finding).with_offer(write(&written), place, "R");
    let diagnosis = Diagnosis::saying(next.taken, found).unknown_target(Some(number), span);
    let diagnosis = diagnosis.unknown_target(Some(target), last.span());
    Some(diagnosis.junk(Span::new(last.end, end.end)).debris())
}

/// `80X 20Y`: two numbers or more, each with its address right behind it, and no number behind the last; how long it
/// is, and what was meant.
fn exchanged_run(text: &str) -> Option<(u32, String)> {
    let bytes = text.as_bytes();
    let mut written: Vec<String> = Vec::new();
    let (mut at, mut end) = (0, 0);
    while written.len() < super::WORDS {
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
