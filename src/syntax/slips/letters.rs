//! Letters in place of digits, and block numbers with their letter in the wrong place.

use super::functions::arc_in_force;
use super::{Around, Diagnosis, numbers, without_blanks, write};
use crate::diag::{Diagnostic, Finding, FixTitle, Meant, NumberMeant, ValueMeant, shown};
use crate::dict::{Address, HIGHEST_BLOCK};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, Shape, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// Longer words are not looked at for a letter in them.
const LONGEST: u32 = 40;

/// The digit that a letter looks like.
pub(in crate::syntax) const fn look_alike(letter: u8) -> Option<char> {
    match letter {
        b'O' | b'o' => Some('0'),
        b'I' | b'l' => Some('1'),
        b'S' => Some('5'),
        b'B' => Some('8'),
        _ => None,
    }
}

/// Whether a number is nothing but letters that are taken for digits: `O`, `Ol`.
pub(super) fn is_all_letters(number: &str) -> bool {
    !number.is_empty() && number.bytes().all(|letter| matches!(letter, b'O' | b'o' | b'l'))
}

/// Letters that hardly begin a word right behind an address: next to digits on the keyboard, or no address at all.
const fn is_unlikely(letter: u8) -> bool {
    matches!(letter, b'Q' | b'E' | b'O' | b'P' | b'T' | b'L')
}

/// `XRl`, `YRO`: a parameter whose number is nothing but letters.
pub(super) fn parameter_of_letters(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.junk(Shape::Text)?;
    let (span, address) = (token.span(), around.address(token)?);
    let letters = around.slice(span).get(1..)?.strip_prefix(['R', 'r'])?;
    let number = letters.bytes().map(look_alike).collect::<Option<String>>().filter(|_| is_all_letters(letters))?;
    grammar::parameter_number(&number)?;
    let fixed = format!("{address}R{number}");
    let finding = Finding::LetterForDigit { fixed: fixed.clone(), without: String::new(), comment: String::new() };
    Some(Diagnosis::saying(1, around.offering(span, finding, fixed)).void(address, span))
}

/// `G0I`, `X6l`, `Y3S`: a letter without a value, right behind a number, is the digit that it looks like. Of words
/// without a decimal point too the other reading is possible, so that it is offered only.
pub(super) fn letter_for_last_digit(around: &Around<'_>) -> Option<Diagnosis> {
    let [word, letter] = around.next([Kind::Word, Kind::Letter])?;
    let address = around.address(word)?;
    let numbered = !matches!(address, Address::N | Address::Program);
    // Functions have two digits.
    let room = !matches!(address, Address::G | Address::M) || word.end - word.start == 2;
    let alone = word.end == letter.start && letter.end == letter.start + 1;
    if !numbered || !room || !alone || grammar::word(around.text, around.tokens, around.at + 1).is_some() {
        return None;
    }
    let byte = around.byte(letter.start);
    let centre = || around.has(Address::J) || around.has(Address::K) || arc_in_force(around.text, letter.start);
    let digit = look_alike(byte).filter(|_| matches!(byte, b'l' | b'S' | b'B') || byte == b'I' && !centre())?;
    let written = format!("{}{digit}", around.slice(word.span()).to_ascii_uppercase());
    let span = word.span().to(letter.span());
    let number = Number::parse(written.get(1..)?.trim_start_matches([' ', '\t']).as_bytes())?;
    let without = around.slice(word.span()).to_ascii_uppercase();
    let written = Some(written).filter(|_| around.may_mean(address, word.start, number));
    let fixed = written.as_ref().map(|written| shown(written)).unwrap_or_default();
    let found =
        around.diagnostic(span, Finding::LetterForDigit { fixed, without: shown(&without), comment: String::new() });
    let found = written
        .into_iter()
        .chain([without])
        .fold(found, |found, text| found.with_offer(write(&text), around.place(span), text));
    Some(Diagnosis::saying(2, found).void(address, span).junk(letter.span()))
}

/// `G7N`: a letter without a value, right behind a function of one digit, in place of its second one. With a number `N`
/// would begin a block.
pub(super) fn letter_in_function(around: &Around<'_>) -> Option<Diagnosis> {
    let [word, letter] = around.next([Kind::Word, Kind::Letter])?;
    let function = around.address(word) == Some(Address::G) && word.end - word.start == 2;
    let glued = word.end == letter.start && letter.end == letter.start + 1;
    let n = function && glued && around.address(letter) == Some(Address::N);
    let span = word.span().to(letter.span());
    let found = n.then(|| around.malformed(span, NumberMeant::Form))?;
    let diagnosis = Diagnosis::saying(2, found).void(Address::G, word.span()).void(Address::N, letter.span());
    Some(diagnosis.junk(letter.span()))
}

/// `LI00`, `X-Q5`, `R10=l2`, `Xq0`: of an address without a value, the letter right behind it in place of a digit.
/// Neither word has a value.
pub(super) fn letter_for_digit(around: &Around<'_>) -> Option<Diagnosis> {
    let alone = numbers::without_value(around)?;
    let found = alone.found.as_ref()?;
    if !matches!(&found.finding, Finding::MissingValue { meant: ValueMeant::Number, .. }) {
        return None;
    }
    let span = found.at.span;
    let behind = around.tokens.get(around.at + alone.tokens).copied().filter(|token| token.kind == Kind::Word)?;
    let head = around.slice(Span::new(span.start, behind.start));
    let blanks = head.len() - head.trim_end_matches([' ', '\t']).len();
    let head = without_blanks(head).to_ascii_uppercase();
    let (letter, second) = (around.byte(behind.start), around.address(behind));
    let upper = around.byte(span.start).is_ascii_uppercase();
    if behind.end - behind.start >= LONGEST
        || blanks > 0 && !(letter == b'l' && upper)
        || head.contains(['\n', '\r', '"'])
    {
        return None;
    }
    let signed = head.ends_with(['+', '-']);
    let same = |other: &&Word| Some(other.address) == second && !matches!(other.address, Address::G | Address::M);
    let repeated = around.words.iter().filter(same).count() > 1;
    // A speed of its own, unless the block has another one.
    let digit = look_alike(letter).filter(|_| letter != b'S' || signed || repeated);
    let digit = digit.or_else(|| key_below(letter).filter(|_| upper));
    let assigned = head.contains('=');
    let of_arc = letter == b'I' && !signed && !repeated && arc_in_force(around.text, behind.start);
    if of_arc || !(digit.is_some() || is_unlikely(letter) || signed || repeated || assigned) {
        return None;
    }
    let sign = head.chars().next_back().filter(|sign| matches!(sign, '+' | '-')).map(String::from).unwrap_or_default();
    let address = Address::from_byte(around.byte(span.start));
    // A parameter is assigned by `=`.
    let digit = digit.filter(|_| assigned || address != Some(Address::R));
    let number = digit.map(|digit| format!("{sign}{digit}{}", around.number(behind)));
    let number = number.filter(|number| {
        Number::parse(number.as_bytes())
            .is_some_and(|number| address.is_none_or(|address| around.may_mean(address, span.start, number)))
    });
    let found = match number.map(|number| format!("{}{number}", head.trim_end_matches(['+', '-']))) {
        Some(written) => {
            let meant = ValueMeant::LetterForDigit { letter: char::from(letter).to_string(), written: shown(&written) };
            let Finding::MissingValue { address, .. } = &found.finding else { return None };
            let finding = Finding::MissingValue { address: address.clone(), meant };
            let whole = around.place(span.to(behind.span()));
            around.diagnostic(span, finding).with_offer(write(&written), whole, written)
        }
        None => found.clone(),
    };
    let diagnosis = Diagnosis { tokens: alone.tokens + 1, found: Some(found), ..alone };
    Some(match second {
        Some(second) => diagnosis.void(second, behind.span()),
        None => diagnosis.debris().junk(span.to(behind.span())),
    })
}

/// The digit above the key of a small letter: `Xq0`.
fn key_below(letter: u8) -> Option<char> {
    // The keys of `y` and `z` are exchanged on Czech keyboards.
    let at = b"pqwertyuio".iter().position(|key| *key == if letter == b'z' { b'y' } else { letter })?;
    char::from_digit(u32::try_from(at).ok()?, 10)
}

/// The digit whose key on a Czech keyboard has that letter, or `+`, without Shift.
fn digit_of_key(key: char) -> Option<char> {
    const KEYS: &str = "é+ěščřžýáí";
    let at = KEYS.chars().position(|known| key.to_lowercase().eq([known]))?;
    char::from_digit(u32::try_from(at).ok()?, 10)
}

/// `Xě5`, `N+žé`, `X-áé`: a word whose digits were typed without Shift.
pub(super) fn czech_word(around: &Around<'_>) -> Option<Diagnosis> {
    let first = around.token();
    let address = around.letter(first)?;
    let text = around.text.get(first.start as usize + 1..)?;
    let is_key = |key: &char| !key.is_ascii() && digit_of_key(*key).is_some();
    let of_number = |(at, key): &(usize, char)| {
        is_key(key) || key.is_ascii_digit() || matches!(key, '.' | ',' | '+') || *at == 0 && *key == '-'
    };
    let run: String = text.char_indices().take(LONGEST as usize).take_while(of_number).map(|(_, key)| key).collect();
    let span = Span::new(first.start, first.start + 1 + small(run.len()));
    let tokens = around.tokens.iter().skip(around.at).take_while(|token| token.start < span.end);
    let (tokens, end) = tokens.fold((0, 0), |(count, _), token| (count + 1, token.end));
    if !run.chars().any(|key| is_key(&key)) || end != span.end {
        return None;
    }
    let digit = |key: char| digit_of_key(key).unwrap_or(key);
    let digits: String = run.replace(',', ".").chars().map(digit).collect();
    let number = Number::parse(digits.as_bytes())?;
    // A `+` may be a sign.
    let signed = run.strip_prefix('+').filter(|rest| !rest.is_empty() && address.is_dimensional());
    let signed = signed.map(|_| format!("{address}+{}", digits.get(1..).sure()));
    let function = matches!(address, Address::G | Address::M) && digits.len() > 2;
    let found = if function || !around.may_mean(address, span.start, number) {
        around.characters(span, Meant::Number)
    } else {
        let readings: Vec<String> = signed.into_iter().chain([format!("{address}{digits}")]).collect();
        let meant = Meant::CzechKeys { written: shown(&readings.join(" / ")) };
        let offer = |found: Diagnostic, text: String| found.with_offer(write(&text), around.place(span), text);
        readings.into_iter().fold(around.characters(span, meant), offer)
    };
    Some(Diagnosis::saying(tokens, found).void(address, span))
}

/// `S150é`: the last digits of a number, typed without Shift.
pub(super) fn czech_keys(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.token();
    let before = around.previous()?;
    let behind = matches!(token.kind, Kind::Junk(Shape::Unknown | Shape::Text))
        && around.text.get(..token.start as usize)?.ends_with(|last: char| last.is_ascii_digit() || last == '.');
    if !behind {
        return None;
    }
    let (span, keys) = (token.span(), around.slice(token.span()));
    let digit = |key: char| digit_of_key(key).filter(|_| !key.is_ascii()).or(Some(key).filter(char::is_ascii_digit));
    let digits = keys.chars().map(digit).collect::<Option<String>>()?;
    let written = format!("{}{digits}", around.slice(before.span()));
    let address = written.bytes().next().and_then(Address::from_byte)?;
    let number = Number::parse(written.get(1..)?.trim_start_matches([' ', '\t']).as_bytes())?;
    let function = matches!(address, Address::G | Address::M);
    let fits = around.may_mean(address, before.start, number) && !(function && written.len() > 3);
    // The fixed blank of Windows-1250 is `á` in CP852.
    let blank = keys == "á";
    let meant = match (fits, blank) {
        (true, true) => Meant::CzechKeyOrBlank { written: written.clone() },
        (true, false) => Meant::CzechKeys { written: written.clone() },
        (false, true) => Meant::BlankOfWindows,
        (false, false) => Meant::Number,
    };
    let mut found = around.characters(span, meant);
    if fits {
        found = found.with_offer(write(&written), around.place(span), digits);
    }
    if blank {
        found = found.with_offer(FixTitle::PlainBlank, around.place(span), " ");
    }
    Some(Diagnosis::saying(1, found).debris().junk(span))
}

/// `8N0`: the letter of a block number is inside it.
pub(super) fn mixed(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::MixedNumber)?.span();
    let text = around.slice(span);
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    let written = format!("N{digits}");
    let finding = Finding::SplitNumber { joined: String::new(), loose: shown(text), written: shown(&written) };
    let letter = text.find(['N', 'n']).and_then(|at| u32::try_from(at).ok()).unwrap_or(0);
    let found = around.offering(span, finding, written);
    Some(Diagnosis::saying(1, found).void(Address::N, Span::new(span.start + letter, span.end)))
}

/// Whether digits stand right before the block number in `token`: `8N0`, `1N30`.
pub(in crate::syntax) fn mixed_number(bytes: &[u8], before: &[Token], token: Token) -> bool {
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
