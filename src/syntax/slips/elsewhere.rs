//! Words and signs as other controls, programs and text processors write them, and their form on this control.

use super::{Around, Diagnosis, numbers, parameters, value, write};
use crate::diag::{
    AddressMeant, Certain, Edit, Finding, FixTitle, MINUS, Meant, NumberMeant, TargetMeant, ValueMeant, is_blank, shown,
};
use crate::dict::{Address, Dialect, GCode, HIGHEST_L};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, Shape, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// `E5`, `E-R1`: a letter that is no address, with what would be its value.
pub(super) fn unknown_address(around: &Around<'_>) -> Option<Diagnosis> {
    let wordlike = |kind| {
        matches!(
            kind,
            Kind::Word
                | Kind::Letter
                | Kind::Junk(
                    Shape::LooseWord | Shape::ManySigns | Shape::PrintedWord | Shape::AssignedWord | Shape::GarbledWord
                )
        )
    };
    let mut next = around.cursor();
    let first = next.when(wordlike)?;
    if around.address(first).is_some() {
        return None;
    }
    let (mut last, mut comments) = (first, Vec::new());
    if first.kind == Kind::Letter {
        let parameter = next.parameter().filter(|_| next.peek().is_none_or(|next| next.kind != Kind::Equals));
        next.taken = 1 + usize::from(parameter.is_some());
        last = parameter.or_else(|| next.one(Kind::Junk(Shape::Bracketed))).unwrap_or(first);
    }
    match next.operands().pop() {
        Some(operand) => last = operand,
        None if last.kind == Kind::Letter => comments = numbers::beyond(&mut next).unwrap_or_default(),
        None => {}
    }
    let span = first.span().to(last.span());
    let found = around.diagnostic(span, Finding::unknown_address(char::from(around.byte(first.start))));
    let diagnosis = Diagnosis { comments, ..Diagnosis::saying(next.taken, found) }.junk(span).debris();
    Some(lost_address(around, diagnosis, span))
}

/// The function that `L Z+100 R0 FMAX` means, a straight line as another control writes it.
pub(super) fn line_function(around: &Around<'_>) -> Option<GCode> {
    let lone = |word: &Word| word.address == Address::L && word.is_void() && word.span(around.text).len() == 1;
    let moves = |word: &Word| word.address.axis().is_some() && !word.is_void();
    let mut words = around.words.iter();
    // It stands before what it moves.
    let line = words.find(|word| lone(word) || moves(word)).is_some_and(lone) && words.any(moves);
    let line = line && !around.has(Address::G);
    line.then(|| if around.tokens.iter().any(|token| is_fastest(around, *token)) { GCode::G00 } else { GCode::G01 })
}

fn is_fastest(around: &Around<'_>, token: Token) -> bool {
    let name = around.slice(token.span()).to_ascii_uppercase();
    token.kind == Kind::Junk(Shape::PrintedWord) && (name.ends_with("FMAX") || name.ends_with("FAUTO"))
}

/// `L Z+100 R0 FMAX`: one finding, with the function that is meant.
pub(super) fn line(around: &Around<'_>) -> Option<Diagnosis> {
    let [letter] = around.next([Kind::Letter])?;
    let function = line_function(around).filter(|_| around.address(letter) == Some(Address::L))?;
    // `X-3LY55`: the digit 1.
    if around.is_behind_digit(letter.start) {
        return None;
    }
    let span = Some(letter.span()).filter(|span| span.len() == 1)?;
    // R0, RL, RR: whether the radius is corrected.
    let of_radius = |word: &&Word| {
        let text = around.slice(word.span(around.text));
        word.address == Address::R && word.is_void() && matches!(text, "R" | "R0" | "r" | "r0")
    };
    let radii = around.words.iter().filter(of_radius).map(|word| word.span(around.text));
    let fastest = around.tokens.iter().filter(|token| is_fastest(around, **token)).map(|token| token.span());
    let deleted = radii.chain(fastest).map(|span| Edit { at: around.place(span), text: String::new() });
    let own = Edit { at: around.place(span), text: function.to_string() };
    let mut edits: Vec<Edit> = std::iter::once(own).chain(deleted).collect();
    edits.sort_by_key(|edit| edit.at.span.start);
    let finding = Finding::MissingValue { address: "L".to_owned(), meant: ValueMeant::Line { function } };
    let found = around.diagnostic(span, finding).with_offers(write(&function.to_string()), edits);
    Some(Diagnosis::saying(1, found).void(Address::L, span).junk(span))
}

/// `X1.5E-05`, `S1.2E+03`, `XNaN`, `FMAX`, `XFMAX`.
pub(super) fn printed(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.junk(Shape::PrintedWord)?;
    let (span, address) = (token.span(), around.address(token)?);
    let number_text = around.slice(span).get(1..).sure();
    if is_fastest(around, token) {
        let found = line_function(around).is_none().then(|| around.malformed(span, NumberMeant::Fastest));
        return Some(Diagnosis { found, ..Diagnosis::of(1) }.void(address, span));
    }
    let meant = numbers::printed(number_text, &address.to_string());
    let exponent = matches!(meant, NumberMeant::Exponent { .. } | NumberMeant::ExponentForm);
    if exponent && address == Address::R {
        return Some(parameters::no_number(around, 1, span));
    }
    // Other words hold whole numbers without a sign, `&` four digits; `M0e3` is M03 with a letter in it.
    let fits = |value: Number| {
        let whole = !matches!(address, Address::Correction | Address::G | Address::M);
        let form = address.is_dimensional() || address == Address::F || whole && !value.point && !value.minus;
        form && around.may_mean(address, token.start, value)
    };
    let NumberMeant::Exponent { written } = meant else {
        return Some(Diagnosis::saying(1, around.malformed(span, meant)).void(address, span));
    };
    let number = Number::parse(written.get(1..).sure().as_bytes()).filter(|value| fits(*value));
    let Some(number) = number else {
        return Some(Diagnosis::saying(1, around.malformed(span, NumberMeant::ExponentForm)).void(address, span));
    };
    // Programs print a sign: `X10E2` may be a letter in place of `D`.
    let signed = number_text.split_once(['E', 'e']).is_some_and(|(_, exponent)| exponent.starts_with(['+', '-']));
    if !signed {
        let found = around.malformed(span, NumberMeant::ExponentOrAddress { written });
        return Some(Diagnosis::saying(1, found).with(Word::with_number(address, span, number), span));
    }
    let found = around.malformed(span, NumberMeant::Exponent { written: written.clone() });
    // A feed of zero is none.
    if address == Address::F && number.value.thousandths() == 0 {
        return Some(Diagnosis::saying(1, found).void(address, span));
    }
    let found = found.with_offer(write(&written), around.place(span), written);
    Some(Diagnosis::saying(1, found).with(Word::with_number(address, span, number), span))
}

/// `Z=R32`, `X=5`, `X=IC(5)`, `S1=1000`.
pub(super) fn assigned(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let token = next.one(Kind::Junk(Shape::AssignedWord))?;
    let (span, address) = (token.span(), around.address(token)?);
    let product = product(around, &mut next, span.end);
    let (name, text) = around.slice(span).split_once('=').unwrap_or_default();
    let text = text.trim_matches([' ', '\t']);
    let upper = text.to_ascii_uppercase();
    let digits = name.get(1..).sure().trim_matches([' ', '\t']);
    let numbered = matches!(address, Address::N | Address::Program);
    let word = value(address, span, text).filter(|word| !(product || numbered && word.is_parametric()));
    let takes = |number| around.may_mean(address, token.start, number);
    let word = word.filter(|word| word.is_parametric() || Number::parse(text.as_bytes()).is_some_and(takes));
    // `S1=1200`, `M1=3`: of one spindle among several.
    let of_spindle = matches!(address, Address::S | Address::M) && !digits.is_empty();
    let word = word.filter(|word| digits.is_empty() || of_spindle && !word.is_parametric());
    let diagnosis = match word {
        Some(word) => {
            let written = format!("{address}{upper}");
            let one = shown(&written);
            // The key of `=` is beside that of `-`.
            let signed = address.is_dimensional() && address.takes_sign(Dialect::Cnc872);
            let minus = (signed && digits.is_empty() && !upper.starts_with('-'))
                .then(|| format!("{address}-{}", upper.trim_start_matches('+')));
            let word = if minus.is_some() { Word::bare(address, span) } else { word };
            let meant = match &minus {
                _ if !digits.is_empty() => NumberMeant::OneSpindle { written: one },
                Some(minus) => NumberMeant::EqualsOrMinus { written: one, minus: shown(minus) },
                None => NumberMeant::Equals { written: one },
            };
            let found = around.malformed(span, meant).with_offer(write(&written), around.place(span), written);
            let found = minus
                .into_iter()
                .fold(found, |found, minus| found.with_offer(write(&minus), around.place(span), minus));
            Diagnosis::saying(next.taken, found).with(word, span)
        }
        None => {
            let computed = product || upper.contains('R') && upper.contains(['+', '-', '*', '/']);
            let of_centre = matches!(address, Address::I | Address::J | Address::K);
            let meant = match upper.get(..3) {
                Some("IC(" | "AC(") if of_centre => NumberMeant::FromStart,
                Some("IC(" | "AC(") => NumberMeant::Distance,
                _ if computed => NumberMeant::Computed,
                _ if address == Address::T && text.starts_with('"') => NumberMeant::ToolName,
                _ => NumberMeant::EqualsForm,
            };
            Diagnosis::saying(next.taken, around.malformed(span, meant)).void(address, span)
        }
    };
    // `R5v=1`, `RW5=1`
    let glued = token.start.checked_sub(1).is_some_and(|before| around.byte(before).is_ascii_alphanumeric());
    Some(if glued { diagnosis.junk(span) } else { diagnosis })
}

/// Takes the rest of a product: `X=R1*2`.
fn product(around: &Around<'_>, next: &mut super::Cursor<'_>, end: u32) -> bool {
    if next.peek().is_some_and(|next| next.kind == Kind::Junk(Shape::Operator)) {
        next.operands();
    }
    around.byte(end) == b'*'
}

/// `CR=5`, `LIMS=2000`.
pub(super) fn named(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::NamedValue)?.span();
    let name = around.slice(span).split(['=', ' ', '\t']).next().sure();
    let meant = AddressMeant::by_name(name);
    let radius = meant == AddressMeant::Radius;
    let found = around.diagnostic(span, Finding::UnknownAddress { address: shown(name), meant });
    let diagnosis = Diagnosis::saying(1, found).debris();
    Some(if radius {
        // The centre of the arc was given, in a way that is none here.
        diagnosis.void(Address::I, span)
    } else if name.starts_with(['R', 'r']) {
        // `RL=5`: a parameter, nobody knows which.
        diagnosis.void(Address::R, span)
    } else {
        diagnosis
    })
}

/// Longer expressions are none.
const EXPRESSION: usize = 240;

/// `#50=0`, `#10=#11*2`.
pub(super) fn variable(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let span = next.one(Kind::Junk(Shape::Variable))?.span();
    let (name, text) = around.slice(span).split_once('=').unwrap_or_default();
    let target = grammar::parameter_number(name.trim_matches(['#', ' ', '\t']));
    let text = text.trim_matches([' ', '\t']);
    let product = product(around, &mut next, span.end);
    let text = text.strip_prefix('#').map_or_else(|| text.to_owned(), |digits| format!("R{digits}"));
    let word = value(Address::R, span, &text).filter(|_| !product);
    if let Some((target, word)) = target.zip(word) {
        let written = format!("R{target}={}", text.to_ascii_uppercase());
        let found = around.characters_as(span, written, |written| Meant::Variable { written });
        return Some(Diagnosis::saying(next.taken, found).with(word.assigning(target), span));
    }
    let rest = around.text.as_bytes().get(span.end as usize..).sure().iter().take(EXPRESSION);
    let end = rest.take_while(|byte| product && !b" \t\r\n\"".contains(byte)).count();
    let length = if end < EXPRESSION { end } else { 0 };
    let whole = Span::new(span.start, span.end + small(length));
    let diagnosis = Diagnosis::saying(next.taken, around.characters(whole, Meant::Expression)).debris();
    Some(if target.is_some() { diagnosis.unknown_target(target, span) } else { diagnosis })
}

/// `%`, and on the next line `O2107`.
pub(super) fn program_start(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::ForeignStart)?.span();
    let digits = around.slice(span).trim_start_matches(|character: char| !character.is_ascii_digit());
    let written = format!("%{digits}");
    let meant = ValueMeant::Written { written: shown(&written) };
    let percent = Span::new(span.start, span.start + 1);
    let found = around.diagnostic(percent, Finding::MissingValue { address: "%".to_owned(), meant });
    let found = found.with_offer(write(&written), around.place(span), written);
    let word = value(Address::Program, span, digits).unwrap_or(Word::bare(Address::Program, span));
    Some(Diagnosis::saying(1, found).with(word, span))
}

/// `G73 N20`: a block number in the place of the target's `L`.
pub(super) fn jump_target(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.junk(Shape::JumpTarget)?;
    let (span, number) = (token.span(), around.number(token));
    let g = around.previous().filter(|before| around.address(*before) == Some(Address::G));
    let code = g.and_then(|g| around.number(g).parse().ok()).and_then(GCode::from_number);
    let function = code.unwrap_or(GCode::G73);
    // The number of a subprogram is not the number of a block.
    let target = function == GCode::G73 && number.parse().is_ok_and(|number: u32| (1..=HIGHEST_L).contains(&number));
    let missing =
        |meant: TargetMeant| around.diagnostic(g.map_or(span, Token::span), Finding::MissingTarget { function, meant });
    if !target {
        let meant = TargetMeant::of(function);
        let subprogram = meant == TargetMeant::Subprogram;
        let meant = if subprogram { TargetMeant::InPlace { block: shown(around.slice(span)) } } else { meant };
        return Some(Diagnosis::saying(1, missing(meant)).void(Address::L, span));
    }
    let written = format!("L{number}");
    let letter = around.place(Span::new(token.start, token.start + 1));
    let found = missing(TargetMeant::Written { written: shown(&written) }).with_offer(write(&written), letter, "L");
    Some(Diagnosis::saying(1, found).with(value(Address::L, span, number)?, span))
}

/// `Z(R11)`, `R1=(R2+1)`, `R1=SIN(30)`: a value between brackets.
pub(super) fn bracketed(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let letter = next.one(Kind::Letter);
    let first = match letter {
        Some(letter) => letter,
        None => {
            let parameter = next.parameter()?;
            next.one(Kind::Equals)?;
            next.one(Kind::Sign);
            parameter
        }
    };
    next.one(Kind::Junk(Shape::Text));
    let bracketed = next.one(Kind::Junk(Shape::Bracketed))?;
    let span = first.span().to(next.operands().last().unwrap_or(&bracketed).span());
    let text = around.slice(span);
    let (address, target, prefix, inner) = if letter.is_some() {
        let address = around.address(first)?;
        (address, None, address.to_string(), text.get(1..).sure())
    } else {
        let (target, found) = parameters::number(around, first);
        if found.is_some() {
            return Some(Diagnosis { found, ..Diagnosis::of(next.taken) }.void(Address::R, span));
        }
        (Address::R, target, format!("R{}=", target?), text.split_once('=').map_or("", |(_, value)| value))
    };
    let numbered = matches!(address, Address::N | Address::Program);
    let plain = unbracketed(inner).filter(|value| !(numbered && value.contains('R')));
    let meant = match &plain {
        Some(value) => Meant::Brackets { written: shown(&format!("{prefix}{value}")) },
        None if inner.trim_start_matches([' ', '\t']).starts_with(';') => Meant::inside(inner),
        None if inner.contains('#') => Meant::Expression,
        None if inner.contains(|character: char| character.is_ascii_digit()) => Meant::Computed,
        None => Meant::inside(inner),
    };
    let found = around.characters(span, meant);
    let written = plain.map(|value| format!("{prefix}{value}"));
    let found = written.into_iter().fold(found, |found, text| found.with_offer(write(&text), around.place(span), text));
    let word = Word::bare(address, span);
    Some(Diagnosis::saying(next.taken, found).with(target.map_or(word, |target| word.assigning(target)), span))
}

/// `R11` of `(R11)`, `-5` of `-(5)`: a value that stands alone between brackets.
fn unbracketed(text: &str) -> Option<String> {
    let text = text.trim_matches([' ', '\t']);
    let inner = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = text.get(..text.len() - inner.len())?;
    let inner = inner.trim_start_matches([' ', '\t']);
    let close = inner.chars().next_back().filter(|close| ")]}>'`".contains(*close))?;
    let inner = inner.get(1..inner.len() - close.len_utf8())?.trim_matches([' ', '\t']).to_ascii_uppercase();
    let both = !sign.is_empty() && inner.starts_with(['+', '-']);
    let whole = format!("{sign}{inner}");
    value(Address::X, Span::empty(0), &whole).filter(|_| !both).map(|_| whole)
}

/// `%_N_2107_MPF`, `%MPF2107`: a program that is named as other controls do.
pub(super) fn program_name(around: &Around<'_>) -> Option<Diagnosis> {
    let span = around.junk(Shape::GarbledWord)?.span();
    let text = around.slice(span);
    let named = |first: char| first == '_' || first.is_ascii_alphabetic();
    text.strip_prefix('%').filter(|rest| rest.starts_with(named))?;
    let mut numbers = text.split(|character: char| !character.is_ascii_digit()).filter(|digits| !digits.is_empty());
    let number = numbers.next().filter(|digits| digits.len() <= 6 && digits.bytes().any(|digit| digit != b'0'));
    let written = number.filter(|_| numbers.next().is_none()).map(|digits| format!("%{digits}"));
    let meant = Meant::ProgramName { written: written.clone().unwrap_or_else(|| "%1".to_owned()) };
    let found = around.characters(span, meant);
    let found = written.into_iter().fold(found, |found, text| found.with_offer(write(&text), around.place(span), text));
    Some(Diagnosis::saying(1, found).void(Address::Program, span))
}

/// `X#1`, `X−5`, `X−R1`, `X[R1+5]`: a word with characters in it that the control does not know.
pub(super) fn garbled(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.junk(Shape::GarbledWord)?;
    let (span, address) = (token.span(), around.address(token)?);
    let rest = around.slice(span).get(1..).sure();
    let blank = |character: char| is_blank(character) || matches!(character, ' ' | '\t');
    let number = rest.trim_start_matches(blank).replace(MINUS, "-");
    let source = number.strip_prefix('#').filter(|digits| grammar::parameter_number(digits).is_some());
    let number = source.map_or(number.clone(), |digits| format!("R{digits}"));
    let parametric = number.trim_start_matches('-').starts_with(['R', 'r']);
    // `X#1*2`, `X−R1.5`: it goes on.
    let goes_on = matches!(around.byte(span.end), b'*' | b'#' | b'/' | b'+' | b'-' | b'[' | b'.');
    let other = address == Address::R || parametric && (goes_on || matches!(address, Address::N | Address::Program));
    let Some(word) = value(address, span, &number).filter(|_| !other) else {
        // `R[5]=3`
        let mut next = around.cursor();
        next.one(token.kind);
        let span = next.assigned_value().map_or(span, |last| span.to(last.span()));
        let found = around.characters(span, Meant::inside(rest));
        return Some(Diagnosis::saying(next.taken, found).void(address, span));
    };
    let written = format!("{address}{number}");
    let found = if source.is_some() {
        around.characters_as(span, written, |written| Meant::Variable { written })
    } else {
        let found = around.characters(span, Meant::inside(rest).with_word(&written));
        // A blank may be there in place of the sign or of a digit.
        let certain = (!rest.contains(is_blank)).then_some(Certain::Minus);
        let edit = Edit { at: around.place(span), text: written.clone() };
        found.with_edits(certain, write(&written), vec![edit])
    };
    Some(Diagnosis::saying(1, found).with(word, span))
}

/// `Ý40`: an address with an accent.
pub(super) fn accented(around: &Around<'_>) -> Option<Diagnosis> {
    const ACCENTED: &str = "ÁČĎÍĽĹŠŤÚŮÝŽĆŹŻ";
    const PLAIN: &str = "ACDILLSTUUYZCZZ";
    let span = around.token().span();
    let text = around.slice(span);
    // `2á.8`: the key of a digit.
    let first = text.chars().next().filter(|_| !around.is_behind_digit(span.start))?;
    let upper = first.to_uppercase().next()?;
    let (_, letter) = ACCENTED.chars().zip(PLAIN.chars()).find(|(accented, _)| *accented == upper)?;
    let number = text.get(first.len_utf8()..).filter(|number| Number::parse(number.as_bytes()).is_some())?;
    let written = format!("{letter}{number}");
    let found = around.characters_as(span, written, |written| Meant::Accent { written });
    Some(Diagnosis::saying(1, found).void(Address::from_byte(u8::try_from(letter).ok()?)?, span).debris())
}

/// Characters that mean nothing.
pub(super) fn unknown(around: &Around<'_>) -> Option<Diagnosis> {
    let token = around.token();
    let language = matches!(token.kind, Kind::Word | Kind::Skip | Kind::LineEnd);
    let span = Some(token.span()).filter(|_| !language)?;
    let (text, place) = (around.slice(span), around.place(span));
    let rest = around.text.get(span.end as usize..).sure();
    let line_ends = rest.trim_start_matches([' ', '\t']).starts_with(['\r', '\n']) || rest.trim().is_empty();
    let blanks = text.chars().all(is_blank);
    let minus = text.chars().all(|sign| MINUS.contains(&sign));
    // `X1)0`, `R1=2á.8`
    let in_number = around.is_behind_digit(span.start) && text.contains(|within: char| within.is_ascii_digit());
    let meant = Meant::of(text);
    let meant = if in_number && meant == Meant::Nothing { Meant::Number } else { meant };
    let found = around.characters(span, meant);
    Some(if text == ";" && line_ends {
        let found = around.characters(span, Meant::BlockEnd);
        let title = FixTitle::Delete { text: ";".to_owned() };
        Diagnosis::saying(1, found.with_offer(title, place, "")).debris()
    } else if blanks {
        let certain = between_words(around, span).then_some(Certain::Blank);
        let edit = Edit { at: place, text: " ".to_owned() };
        Diagnosis::saying(1, found.with_edits(certain, FixTitle::PlainBlank, vec![edit])).debris()
    } else if minus && text.chars().count() == 1 {
        let signs = rest.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '.' | 'R' | 'r'));
        let found = if signs { found.with_fix(Certain::Minus, write("-"), place, "-") } else { found };
        Diagnosis::saying(1, found).debris()
    } else if minus {
        Diagnosis::saying(1, found).debris()
    } else {
        lost_address(around, Diagnosis::saying(1, found).debris().junk(span), span)
    })
}

/// Whether a character stands where a blank does: directly between two words of a block that has blanks between others.
/// Elsewhere it may be there in place of a character that is meant: the sign in `Z 1.5`, a digit in `X5  Y3`.
fn between_words(around: &Around<'_>, span: Span) -> bool {
    let near = || around.tokens.iter().skip(around.at.saturating_sub(4)).take(9);
    let apart = near().zip(near().skip(1)).any(|(one, next)| one.end < next.start);
    let blank = |token: &Token| token.start != span.start && around.slice(token.span()).chars().all(is_blank);
    let others = apart || near().any(blank);
    let before = around.text.get(..span.start as usize).and_then(|text| text.chars().next_back());
    let behind = around.text.get(span.end as usize..).and_then(|text| text.chars().next());
    let word_ends = before.is_some_and(|last| last.is_ascii_digit() || last == '"');
    others && word_ends && behind.is_some_and(|first| first.is_ascii_alphabetic() || first == '"')
}

/// A sign or another letter with a number, in place of an address and its number: what it would have set.
fn lost_address(around: &Around<'_>, diagnosis: Diagnosis, span: Span) -> Diagnosis {
    use Address::{F, G, I, J, L, M, Q, S, X, Y, Z};
    let text = around.slice(span);
    let number = text.trim_start_matches(|sign: char| !sign.is_ascii_digit() && !"+-.".contains(sign));
    let digits = number.bytes().all(|byte| byte.is_ascii_digit());
    let lacks = |takes: fn(GCode) -> bool, address| around.functions().any(takes) && !around.has(address);
    let addresses: &[Address] = match number.len() {
        0 => return diagnosis,
        _ if lacks(GCode::takes_l, L) => &[L],
        _ if lacks(|code| code == GCode::G04, Q) => &[Q],
        1 | 2 if digits => &[G, M, X, Y, Z],
        _ if digits => &[L, S, F, X, Y, Z],
        _ => &[X, Y, Z],
    };
    let arc = super::functions::arc_in_force(around.text, span.start);
    let centre: &[Address] = if arc { &[I, J] } else { &[] };
    addresses.iter().chain(centre).fold(diagnosis, |diagnosis, address| diagnosis.void(*address, span))
}
