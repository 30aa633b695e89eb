//! Numbers in pieces, with other characters in them, in the wrong place, or missing.

use super::letters::{is_all_letters, look_alike};
use super::{Around, Cursor, Diagnosis, functions, parameters, without_blanks, write};
use crate::diag::{Certain, CommaMeant, Diagnostic, Edit, Finding, Meant, NumberMeant, ValueMeant, shown};
use crate::dict::{Address, Decimal, Dialect, GCode, HIGHEST_Q};
use crate::sure::Sure;
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, Shape, Token};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// `&0010`
pub(super) const CORRECTION_DIGITS: usize = 4;

/// `X--R1`.
pub(super) fn many_signs(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.one(Kind::Junk(Shape::ManySigns))?;
    let parameter = next.parameter()?;
    let span = first.span().to(next.operands().last().unwrap_or(&parameter).span());
    let found = around.malformed(span, NumberMeant::Form);
    Some(Diagnosis::saying(next.taken, found).void(around.address(first)?, span))
}

/// `TT1`: an address written twice. `Ll30` is `L130` (LEX-12).
pub(super) fn doubled_letter(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.one(Kind::Junk(Shape::LooseWord))?;
    let pieces = next.numbers();
    let span = first.span().to(pieces.last().unwrap_or(&first).span());
    let (address, run) = (around.address(first)?, around.number(first));
    let letter = run.get(..1).filter(|letter| letter.eq_ignore_ascii_case(&address.to_string()) && *letter != "l")?;
    let digits = run.get(letter.len()..).sure().trim_start_matches([' ', '\t']);
    let number = Number::parse(digits.as_bytes()).filter(|_| pieces.is_empty());
    let number = number.filter(|number| around.may_mean(address, first.start, *number));
    let Some(number) = number else {
        return Some(Diagnosis::saying(next.taken, around.malformed(span, NumberMeant::Form)).void(address, span));
    };
    let written = run.to_ascii_uppercase();
    let found = around.number_as(span, written, |written| NumberMeant::LetterTwice { written });
    Some(Diagnosis::saying(next.taken, found).with(Word::with_number(address, span, number), span))
}

/// `X36.  12`, `X1,5`, `X1O0`, `X--5`: a number in pieces, or with characters in it that do not belong in one.
pub(super) fn word(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let word = |kind| matches!(kind, Kind::Word | Kind::Junk(Shape::LooseWord | Shape::ManySigns));
    let first = next.when(word)?;
    let pieces = next.numbers();
    if first.kind == Kind::Word && pieces.is_empty() {
        return None;
    }
    Some(loose(around, first, &pieces, next.taken))
}

/// `X-  36.12`: a blank behind the sign.
pub(super) fn split_sign(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.one(Kind::Letter).filter(|letter| around.is_signed(*letter))?;
    let pieces = next.numbers();
    (!pieces.is_empty()).then(|| loose(around, first, &pieces, next.taken))
}

fn loose(around: &Around<'_>, first: Token, pieces: &[Token], tokens: usize) -> Diagnosis {
    let span = first.span().to(pieces.last().unwrap_or(&first).span());
    let Some(address) = around.address(first) else { return Diagnosis::of(tokens) };
    let broken = Broken { address, prefix: &address.to_string(), run: around.number(first), pieces, span };
    let (value, found) = broken.explain(around);
    let word = value.map_or(Word::bare(address, span), |number| Word::with_number(address, span, number));
    let diagnosis = Diagnosis { found, ..Diagnosis::of(tokens) }.with(word, span);
    // `S500 3`: the second number may be that of a function.
    match pieces {
        [piece] if matches!(address, Address::S | Address::T) && piece.span().len() <= 2 => {
            diagnosis.void(Address::M, piece.span())
        }
        _ => diagnosis,
    }
}

/// Digits behind the point of a position, at most (ADR-2).
const DECIMALS: usize = 3;

/// A faulty number: its first piece, and the others.
pub(super) struct Broken<'a> {
    pub(super) address: Address,
    /// What stands before it: `X`, `R10=`.
    pub(super) prefix: &'a str,
    pub(super) run: &'a str,
    pub(super) pieces: &'a [Token],
    pub(super) span: Span,
}

impl Broken<'_> {
    /// Reads it as its fix would write it, and says what is wrong with it. Its value is known only where that fix is
    /// certain.
    pub(super) fn explain(&self, around: &Around<'_>) -> (Option<Number>, Option<Diagnostic>) {
        let Self { address, prefix, run, pieces, span } = *self;
        let joined = pieces.iter().fold(run.to_owned(), |joined, piece| joined + around.slice(piece.span()));
        let digit = |letter: char| u8::try_from(letter).ok().and_then(look_alike).unwrap_or(letter);
        let fixed: String = joined.replace(',', ".").chars().map(digit).collect();
        // A comma behind a number parts it from the next word.
        let fixed = if joined.ends_with(',') { fixed.trim_end_matches('.') } else { fixed.as_str() };
        let number = Number::parse(fixed.as_bytes());
        let fixed = format!("{prefix}{fixed}");
        let has_digit = fixed.bytes().any(|byte| byte.is_ascii_digit() && !prefix.as_bytes().contains(&byte));
        let (mut without, mut readings) = (None, vec![fixed.clone()]);
        let (certain, finding) = match number {
            Some(number) if joined.contains(',') => return self.with_comma(around, number, &joined, fixed),
            Some(_) if joined.bytes().any(|letter| look_alike(letter).is_some()) => {
                let alone = pieces.is_empty() && is_all_letters(joined.trim_start_matches(['+', '-']));
                let certain = alone && self.is_no_text(around);
                without = if certain { None } else { self.without_letter(around, &joined) };
                let shorter = without.clone().unwrap_or_default();
                let text = alone && !certain && !matches!(address, Address::N | Address::L);
                let comment = if text { shown(around.slice(span)) } else { String::new() };
                let finding = Finding::LetterForDigit { fixed: shown(&fixed), without: shorter, comment };
                (certain.then_some(Certain::LettersAlone), finding)
            }
            Some(_) if pieces.is_empty() => return (number, None),
            Some(_) => {
                let only = matches!(pieces, [only] if only.kind == Kind::Number && around.byte(only.start) != b'-');
                // `R29 - 12`: perhaps `=` was meant, `R3+ 40.2`: perhaps another digit.
                let written = address != Address::R || around.slice(span).contains('=');
                let certain = matches!(run, "+" | "-") && only && written && address.is_dimensional();
                let pointed = self.with_point(around);
                // No position goes on behind a 0 without a point.
                readings.retain(|_| pointed.is_none() || !self.is_zero() || address == Address::F);
                readings.splice(0..0, pointed);
                let all: Vec<String> = readings.iter().map(|text| shown(text)).collect();
                (certain.then_some(Certain::BlankBehindSign), split(all.join(" / ")))
            }
            None if has_digit || joined.len() > 2 => {
                return (None, Some(around.malformed(span, printed(&joined, prefix))));
            }
            None => {
                let address = shown(prefix.trim_end_matches('='));
                let finding = Finding::MissingValue { address, meant: ValueMeant::Number };
                return (None, Some(around.diagnostic(span, finding)));
            }
        };
        // What its address does not take, or what another function of the block excludes, was not meant.
        let digits = address != Address::Correction || joined.len() == CORRECTION_DIGITS;
        let fits = number.is_none_or(|number| digits && around.may_mean(address, span.start, number));
        let fits = certain.is_some() || fits;
        let finding = if fits {
            finding
        } else if let Finding::LetterForDigit { without, .. } = finding {
            Finding::LetterForDigit { fixed: String::new(), without, comment: String::new() }
        } else {
            let loose = shown(pieces.last().map_or("", |piece| around.slice(piece.span())));
            Finding::SplitNumber { joined: String::new(), loose, written: String::new() }
        };
        let mut found = around.diagnostic(span, finding);
        for reading in readings.into_iter().filter(|_| fits) {
            let edits = vec![Edit { at: around.place(span), text: reading.clone() }];
            found = found.with_edits(certain, write(&reading), edits);
        }
        if let Some(without) = without {
            found = found.with_offer(write(&without), around.place(span), without);
        }
        (number.filter(|_| certain.is_some()), Some(found))
    }

    /// The number with a point in place of its blank, `X33 5`, when its address takes that.
    fn with_point(&self, around: &Around<'_>) -> Option<String> {
        let Self { address, prefix, run, pieces, span } = *self;
        let [piece] = pieces else { return None };
        let behind = around.slice(piece.span());
        let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let whole = is_digits(run.trim_start_matches(['+', '-'])) && is_digits(behind);
        let text = format!("{run}.{behind}");
        let number = Number::parse(text.as_bytes()).filter(|_| whole)?;
        // The control rounds to thousandths; the values of control words are whole.
        let takes = address.is_dimensional()
            && address != Address::R
            && (address != Address::F || self.is_zero())
            && behind.len() <= DECIMALS;
        (takes && around.may_mean(address, span.start, number)).then(|| format!("{prefix}{text}"))
    }

    /// Whether its first piece is 0.
    fn is_zero(&self) -> bool {
        self.run.trim_start_matches(['+', '-']) == "0"
    }

    /// Whether an address and letters, `XO`, are no word of a comment that lost a quote: `to`, `CO`, `Al`.
    fn is_no_text(&self, around: &Around<'_>) -> bool {
        let lower = around.slice(self.span).bytes().any(|letter| letter.is_ascii_lowercase() && letter != b'l');
        let axis = |token: &Token| matches!(around.byte(token.start), b'X'..=b'Z');
        let word = |next: &Token| next.kind == Kind::Word || next.kind == Kind::Junk(Shape::LooseWord) && axis(next);
        let words = || around.tokens.get(around.at + 1).is_some_and(word);
        let comment = || around.previous().is_some_and(|before| before.kind == Kind::Comment);
        let alone = matches!(self.address, Address::X | Address::Y | Address::Z | Address::R);
        let center = matches!(self.address, Address::I | Address::J | Address::K);
        // N and L are never 0: another digit was meant.
        let never = matches!(self.address, Address::N | Address::L);
        !never && (alone || !lower && (center || words() && !comment()))
    }

    /// The word without its only letter, when its address takes that.
    fn without_letter(&self, around: &Around<'_>, joined: &str) -> Option<String> {
        let Self { address, prefix, span, .. } = *self;
        // `M3O`: functions have two digits.
        let function = matches!(address, Address::G | Address::M);
        if function && joined.contains(['O', 'o']) {
            return None;
        }
        let digits: String = joined.chars().filter(|character| !character.is_ascii_alphabetic()).collect();
        let number = Number::parse(digits.as_bytes()).filter(|_| digits.len() + 1 == joined.len())?;
        around.may_mean(address, span.start, number).then(|| format!("{prefix}{digits}"))
    }

    /// A number with a comma: a decimal one, where its address takes a point, or one that parts it from the next word.
    fn with_comma(
        &self,
        around: &Around<'_>,
        number: Number,
        joined: &str,
        fixed: String,
    ) -> (Option<Number>, Option<Diagnostic>) {
        let Self { address, prefix, span, .. } = *self;
        // Either side of a blank may be a number of its own: `X7 0,5`.
        let behind = around.slice(span).get(prefix.trim_end_matches('=').len()..).sure();
        let apart = behind.trim_matches([' ', '\t', '=']).contains([' ', '\t']);
        let written = shown(&fixed);
        let whole = number.value.as_whole().filter(|_| !number.rounded);
        let border = joined.ends_with(',') && joined.matches(',').count() == 1;
        let (meant, fixed) = if (border || apart) && !address.row().form.takes_point(Dialect::Cnc872) {
            // `S118,`: the key beside is 0.
            (CommaMeant::Whole { address }, None)
        } else if border {
            (CommaMeant::Border { written }, Some(fixed))
        } else if apart {
            (CommaMeant::Apart { written }, None)
        } else if address.is_dimensional() || address == Address::H {
            (CommaMeant::Point { written }, Some(fixed))
        } else if let Some(whole) = whole {
            let written = format!("{prefix}{whole}");
            let digits = format!("{prefix}{}", joined.replace(',', ""));
            (CommaMeant::WholeWritten { written, digits }, None)
        } else {
            (in_dwell(around, address, joined).unwrap_or(CommaMeant::Whole { address }), None)
        };
        // `L1,00` may be L100, `X10,` X100; a letter may be one too many.
        let is_digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        let unsigned = joined.strip_prefix(['+', '-']).unwrap_or(joined);
        let between = unsigned
            .split_once(',')
            .is_some_and(|(before, behind)| is_digits(before) && behind.bytes().all(|byte| byte.is_ascii_digit()));
        let certain = matches!(meant, CommaMeant::Point { .. }) && between && address.is_dimensional();
        let certain = certain.then_some(Certain::DecimalComma);
        let found = around.diagnostic(span, Finding::DecimalComma { meant });
        let edit =
            |text: String| found.clone().with_edits(certain, write(&text), vec![Edit { at: around.place(span), text }]);
        (Some(number).filter(|_| certain.is_some()), Some(fixed.map_or_else(|| found.clone(), edit)))
    }
}

/// `G04 Q0,5`: seconds.
fn in_dwell(around: &Around<'_>, address: Address, number: &str) -> Option<CommaMeant> {
    let dwell = address == Address::Q && around.functions().any(|code| code == GCode::G04);
    let seconds = Number::parse(without_blanks(number).replace(',', ".").as_bytes()).filter(|_| dwell)?;
    let units = Some((seconds.value.thousandths() + 5) / 10).filter(|units| (1..=HIGHEST_Q).contains(units))?;
    Some(CommaMeant::Dwell { written: format!("Q{units}") })
}

/// A blank inside a number.
pub(super) const fn split(joined: String) -> Finding {
    Finding::SplitNumber { joined, loose: String::new(), written: String::new() }
}

/// What something that is no number may mean, `prefix` before it: programs print numbers with exponents.
pub(super) fn printed(run: &str, prefix: &str) -> NumberMeant {
    let run = without_blanks(run);
    let lower = run.to_ascii_lowercase();
    if lower.contains("nan") || lower.contains("in") {
        return NumberMeant::NotANumber;
    }
    if !lower.contains('e') {
        let sum = run.chars().zip(run.chars().skip(1)).any(|(one, next)| one.is_ascii_digit() && "+-".contains(next));
        let computed = sum || run.contains(['*', '/', '(', '[', '{', '<']);
        return if computed && prefix.starts_with('R') { NumberMeant::Computed } else { NumberMeant::Form };
    }
    let thousandths = run.replace(',', ".").parse::<f64>().ok().map(|value| (value * 1000.0).round());
    #[allow(clippy::cast_possible_truncation, reason = "what is too large for it is the largest number, and refused")]
    let written = thousandths.map(|value| Decimal::from_thousandths(value as i64));
    match written.filter(|written| written.abs() <= Decimal::DIMENSION_MAX) {
        Some(written) => NumberMeant::Exponent { written: format!("{prefix}{written}") },
        None => NumberMeant::ExponentForm,
    }
}

/// `Z-24/2`, `R10/2`: nothing is divided (BLK-11).
pub(super) fn divided(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let (first, address, target) = if let Some(parameter) = next.parameter() {
        (parameter, Address::R, grammar::parameter_number(around.number(parameter)))
    } else {
        let word = next.one(Kind::Word)?;
        (word, around.address(word).filter(|address| *address != Address::N)?, None)
    };
    let slash = next.when(|kind| matches!(kind, Kind::Skip | Kind::Junk(Shape::Operator)))?;
    let rest = std::iter::from_fn(|| next.when(is_stray)).last().filter(|_| slash.kind != Kind::Skip);
    let span = first.span().to(rest.unwrap_or(slash).span());
    let by = around.slice(Span::new(first.end, span.end)).strip_prefix('/')?;
    let by = Some(by).filter(|by| by.starts_with(|digit: char| digit.is_ascii_digit()))?;
    let divisor = Number::parse(by.as_bytes()).map(|by| by.value.thousandths()).filter(|by| *by != 0);
    let value = Number::parse(around.number(first).as_bytes()).filter(|_| address != Address::R);
    let quotient = value.zip(divisor).and_then(|(number, by)| {
        let product = number.value.thousandths().checked_mul(1000)?;
        (product % by == 0).then(|| format!("{address}{}", Decimal::from_thousandths(product / by)))
    });
    let meant = quotient.map_or(NumberMeant::Undivided, |written| NumberMeant::Divided { written });
    let tokens = if slash.kind == Kind::Skip { 2 } else { next.taken };
    let word = Word::bare(address, span);
    let word = target.map_or(word, |target| word.assigning(target));
    Some(Diagnosis::saying(tokens, around.malformed(span, meant)).with(word, span))
}

/// An address or a parameter without a value.
pub(super) fn valueless(around: &Around<'_>) -> Option<Diagnosis> {
    let diagnosis = without_value(around)?;
    let open = |finding: &Finding| {
        let Finding::MissingValue { address, meant } = finding else { return false };
        address.starts_with('R') && matches!(meant, ValueMeant::Number | ValueMeant::Beyond)
    };
    Some(if diagnosis.found.as_ref().is_some_and(|found| open(&found.finding)) {
        functions::radius(around, diagnosis)
    } else {
        diagnosis
    })
}

/// An address or a parameter without a value, whatever is around it. A number beyond a line end or comments was meant
/// for it.
pub(super) fn without_value(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let (first, end) = if let Some(letter) = next.one(Kind::Letter) {
        (letter, letter)
    } else if let Some(letter) = next.one(Kind::Junk(Shape::BareR)) {
        (letter, next.one(Kind::Sign).unwrap_or(letter))
    } else {
        let parameter = next.parameter()?;
        let equals = next.one(Kind::Equals);
        next.one(Kind::Sign);
        (parameter, equals.unwrap_or(parameter))
    };
    let span = first.span().to(end.span());
    let text = around.slice(first.span());
    if first.kind == Kind::Junk(Shape::LooseParameter) && text.contains(['.', ',']) {
        return Some(parameters::no_number(around, next.taken, span));
    }
    let sign = |character: &char| !matches!(character, ' ' | '\t' | '+' | '-' | '.' | ',');
    let name: String = text.chars().filter(sign).map(|character| character.to_ascii_uppercase()).collect();
    let digits = name.strip_prefix('R').unwrap_or_default();
    let target = grammar::parameter_number(digits);
    if !digits.is_empty() && target.is_none() {
        let (_, found) = parameters::number(around, first);
        return Some(Diagnosis { found, ..Diagnosis::of(next.taken) }.void(Address::R, span));
    }
    let beyond = if is_assignment(&next) { None } else { beyond(&mut next) };
    let meant = match (number_behind_skip(around, first, end), &beyond) {
        (Some(written), _) => ValueMeant::Written { written },
        (None, Some(_)) => ValueMeant::Beyond,
        (None, None) => ValueMeant::Number,
    };
    let word = Word::bare(around.address(first)?, span);
    let found = around.diagnostic(span, Finding::MissingValue { address: name, meant });
    let diagnosis = Diagnosis { comments: beyond.unwrap_or_default(), ..Diagnosis::saying(next.taken, found) };
    Some(diagnosis.junk(span).with(target.map_or(word, |target| word.assigning(target)), span))
}

/// Whether an assignment begins there.
fn is_assignment(next: &Cursor<'_>) -> bool {
    let mut next = Cursor { ..*next };
    next.parameter().is_some() && next.one(Kind::Equals).is_some()
}

/// Takes a number or an assigned value beyond line ends or comments; gives the comments.
pub(super) fn beyond(next: &mut Cursor<'_>) -> Option<Vec<Span>> {
    let start = next.taken;
    let between = |kind| matches!(kind, Kind::LineEnd | Kind::Comment);
    let between: Vec<Token> = std::iter::from_fn(|| next.when(between)).collect();
    let value = if between.is_empty() { None } else { next.number().or_else(|| next.assigned_value()) };
    if value.is_none() {
        next.taken = start;
        return None;
    }
    Some(between.into_iter().filter(|token| token.kind == Kind::Comment).map(Token::span).collect())
}

/// `N/30`: the block number behind the `/` that belongs behind it.
fn number_behind_skip(around: &Around<'_>, address: Token, end: Token) -> Option<String> {
    let rest = around.text.get(end.end as usize..)?.strip_prefix('/')?;
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    let numbered = around.address(address) == Some(Address::N) && !digits.is_empty();
    numbered.then(|| format!("N{digits} /"))
}

/// `-X10`.
pub(super) fn sign_first(around: &Around<'_>) -> Option<Diagnosis> {
    let [sign, word] = around.next([Kind::Sign, Kind::Word])?;
    let (address, span) = (around.address(word)?, sign.span().to(word.span()));
    let minus = around.byte(sign.start) == b'-';
    let signed = format!("{}{}", if minus { "-" } else { "" }, around.number(word));
    let Some(value) = Number::parse(signed.as_bytes()).filter(|_| address.is_dimensional()) else {
        return Some(Diagnosis::saying(2, around.malformed(span, NumberMeant::Form)).void(address, span));
    };
    let written = format!("{address}{signed}");
    let found = around.number_as(span, written, |written| NumberMeant::SignBehind { written });
    Some(Diagnosis::saying(2, found).with(Word::with_number(address, span, value), span))
}

const fn is_stray(kind: Kind) -> bool {
    matches!(kind, Kind::Number | Kind::Sign | Kind::Equals | Kind::Junk(Shape::LooseNumber | Shape::Operator))
}

/// Numbers, signs or `=` that belong to nothing.
pub(super) fn stray(around: &Around<'_>) -> Option<Diagnosis> {
    let mut next = around.cursor();
    let first = next.when(is_stray)?;
    let last = std::iter::from_fn(|| next.when(is_stray)).last().unwrap_or(first);
    let span = first.span().to(last.span());
    let text = shown(around.slice(span));
    let meant = match Number::parse(text.as_bytes()) {
        Some(number)
            if around.begins_line(span.start)
                && text.bytes().all(|byte| byte.is_ascii_digit())
                && number.value != Decimal::ZERO =>
        {
            NumberMeant::BlockNumber { written: format!("N{text}") }
        }
        Some(_) => NumberMeant::NoAddress,
        None if text.len() > 2 && text.chars().all(|sign| "+-=. \t…".contains(sign)) => NumberMeant::Ruler,
        None if text.contains('=') => NumberMeant::EqualsForm,
        None => NumberMeant::Form,
    };
    let junk = Span::new(around.cut_before(span.start), span.end);
    let diagnosis = Diagnosis::saying(next.taken, around.malformed(span, meant)).junk(junk).debris();
    // The parameter is not known.
    Some(if text.contains('=') { diagnosis.void(Address::R, span) } else { diagnosis })
}

/// The number of the block that a line begins with.
pub(super) fn number_of_line(line: &str) -> Option<u32> {
    let number = line.trim_start_matches([' ', '\t']).strip_prefix(['N', 'n'])?;
    number.split(|end: char| !end.is_ascii_digit()).next()?.parse().ok()
}

/// `110 G02 X70`, `(10 G02`: the letter of a block number is missing, or is another sign.
pub(super) fn without_n(around: &Around<'_>) -> Option<Diagnosis> {
    // The finding of that `N` says it.
    if let Some(token) = around.junk(Shape::NumberOfN) {
        return Some(Diagnosis::of(1).void(Address::N, token.span()));
    }
    let span = around.junk(Shape::LostNumber)?.span();
    let text = around.slice(span);
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    let written = format!("N{digits}");
    // `N40 G0`, and `1 Z-2` below: a line break within the number. A block number would rise.
    let cut = around.cut_before(span.start);
    let above = || number_of_line(around.text.get(..cut as usize)?.rsplit(['\r', '\n']).next()?);
    if cut != span.start && above().is_some_and(|above| digits.parse().is_ok_and(|own: u32| own <= above)) {
        let found = around.malformed(span, NumberMeant::NoAddress);
        return Some(Diagnosis::saying(1, found).void(Address::N, span));
    }
    let found = if text.starts_with(|first: char| first.is_ascii_digit() || "+-.,".contains(first)) {
        around.malformed(span, NumberMeant::BlockNumber { written: written.clone() })
    } else {
        around.characters(span, Meant::of(text))
    };
    let found = found.with_offer(write(&written), around.place(span), written);
    Some(Diagnosis::saying(1, found).void(Address::N, span))
}

/// The shape of a number, or a sign and a number, that begins a line in place of a block number: words follow it on the
/// line, and what stands before it lacks no number but `N`.
pub(in crate::syntax) fn lost_number(bytes: &[u8], before: &[Token], token: Token) -> Option<Shape> {
    if !matches!(token.kind, Kind::Number | Kind::Junk(Shape::LooseNumber | Shape::Unknown)) {
        return None;
    }
    let above = bytes.get(..token.start as usize).sure();
    let line = above.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t'));
    let line = matches!(line, None | Some(b'\n' | b'\r'));
    let word = bytes.get(token.span().range()).sure();
    let signs = word.iter().take_while(|byte| !byte.is_ascii_digit()).count();
    let (signs, digits) = word.split_at_checked(signs).unwrap_or_default();
    let sign = signs.len() < 2 && !matches!(signs, b"." | b",");
    let whole = (1..=6).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    // No block has the number 0.
    let number = sign && whole && digits.iter().any(|digit| *digit != b'0');
    let behind = bytes.get(token.end as usize..).sure();
    let blanks = |text: &[u8]| text.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    let apart = blanks(behind) > 0;
    let behind = behind.get(blanks(behind)..).sure();
    // `190 /G01 X7`: the block is one that can be skipped.
    let behind = behind.strip_prefix(b"/").map_or(behind, |words| words.get(blanks(words)..).sure());
    let at = |place: usize| behind.get(place).map(u8::to_ascii_uppercase);
    let words = matches!(at(0), Some(b'A'..=b'M' | b'P'..=b'Z'))
        && matches!(at(1), Some(b'0'..=b'9' | b'+' | b'-' | b'.' | b'R'));
    let whole = |last: &Token| {
        matches!(
            last.kind,
            Kind::Word | Kind::Number | Kind::Skip | Kind::Junk(Shape::Text | Shape::Unknown | Shape::LooseWord)
        )
    };
    if !(line && number && (apart || digits.len() > 1) && words) {
        return None;
    }
    let mut last = before.iter().rev().filter(|token| token.kind != Kind::LineEnd).peekable();
    let letter = last.peek().filter(|last| last.kind == Kind::Letter).and_then(|last| bytes.get(last.start as usize));
    if letter.is_some_and(|letter| letter.eq_ignore_ascii_case(&b'N')) {
        return Some(Shape::NumberOfN);
    }
    last.find(|token| token.kind != Kind::Comment).is_none_or(whole).then_some(Shape::LostNumber)
}
