//! Functions with the words that other controls write with them: dwells, cycles, calls, radii of arcs.

use super::{Around, Diagnosis, write};
use crate::diag::{Code, Diagnostic, DwellMeant, Finding, NumberMeant, TargetMeant, ValueMeant, shown};
use crate::dict::{Address, Decimal, GCode, GGroup, HIGHEST_P, HIGHEST_Q};
use crate::sure::{Sure, small};
use crate::syntax::number::Number;
use crate::syntax::tokens::{Kind, tokens};
use crate::syntax::{Word, grammar};
use crate::text::Span;

/// A G02 or G03 farther back than this many bytes is not looked for: a machinist would not look at it either.
const FAR: u32 = 1 << 12;
/// A dwell without a point is taken for milliseconds from here on: nobody writes so many seconds.
const MILLISECONDS: i64 = 100;

/// Whether other controls write other words with a function of that number, so that its block is looked at.
pub(in crate::syntax) const fn has_other_words(number: u8) -> bool {
    matches!(number, 4 | 70..=73 | 79)
}

fn function(around: &Around<'_>, codes: &[GCode]) -> Option<(GCode, Word)> {
    around.words.iter().find_map(|word| Some((word.g_code().filter(|code| codes.contains(code))?, *word)))
}

/// G71, G72, G73 with the words of a turning or drilling cycle of other controls, G70 with those of a finishing cycle:
/// no word of the block is what it would be here.
pub(super) fn other_cycle(around: &Around<'_>) -> Option<Diagnostic> {
    let has = |address: Address| around.has(address);
    if let Some((_, g)) = function(around, &[GCode::G70]) {
        // P up to 99 is one of this control.
        let number = around.words.iter().find(|word| word.address == Address::P).and_then(|p| p.whole());
        let is_cycle = has(Address::Q) && number.is_some_and(|number| number > HIGHEST_P);
        let finding = Finding::EndOutsideSubprogram { finishing: true };
        return is_cycle.then(|| around.diagnostic(g.span(around.text), finding));
    }
    let (function, g) = function(around, &[GCode::G71, GCode::G72, GCode::G73])?;
    let radius = around.words.iter().any(|word| word.address == Address::R && word.is_void());
    let cycle = radius || [Address::U, Address::W, Address::P].into_iter().any(has);
    if has(Address::L) || !cycle || number_in_p(around).is_some() {
        return None;
    }
    let drilling = function == GCode::G73 && has(Address::Z) && !has(Address::P);
    let meant = if drilling { TargetMeant::Drilling } else { TargetMeant::Turning };
    Some(around.diagnostic(g.span(around.text), Finding::MissingTarget { function, meant }))
}

/// The rest of an item in the block of another control's cycle: the finding is given with the item that has the G word,
/// `-G71` too.
pub(super) fn in_other_cycle(item: Diagnosis, cycle: &Diagnostic, has_g: bool) -> Diagnosis {
    let void = |(word, span): (Word, Span)| {
        let kept = if word.address == Address::N {
            word
        } else if word.g_code().is_some_and(GCode::takes_l) {
            word.faulty()
        } else {
            Word::bare(word.address, span).faulty().assigning(word.target())
        };
        (kept, span)
    };
    // Where the axes are is not known behind it anyway.
    let stays = |(word, _): &(Word, Span)| word.address.axis().is_none();
    let words: Vec<(Word, Span)> = item.words.into_iter().filter(stays).map(void).collect();
    let own = has_g.then(|| cycle.clone());
    let of_comment = item.found.filter(|found| matches!(found.code(), Code::E0105 | Code::W0114));
    Diagnosis { words, found: own.or(of_comment), ..item }
}

/// The P of a block that has nothing else but Q, a count: the number of what it calls. With another block number in Q
/// it is a cycle.
fn number_in_p(around: &Around<'_>) -> Option<Word> {
    let of = |address: Address| around.words.iter().copied().find(|word| word.address == address);
    let p = of(Address::P)?;
    let known = |word: &Word| matches!(word.address, Address::N | Address::Skip | Address::G | Address::P | Address::Q);
    let count = of(Address::Q).is_none_or(|q| q.whole().is_some_and(|q| p.whole().is_some_and(|p| q < p)));
    (around.words.iter().all(known) && count && p.is_digits()).then_some(p)
}

/// `G71 P100`, `G79 P100`: the number of a subprogram behind another address.
pub(super) fn called_by_p(around: &Around<'_>) -> Option<Diagnosis> {
    let [token] = around.next([Kind::Word])?;
    around.address(token).filter(|address| *address == Address::P)?;
    let p = number_in_p(around).filter(|p| p.start() == token.start)?;
    let (function, g) = function(around, &[GCode::G71, GCode::G72, GCode::G73, GCode::G79])?;
    let written = format!("L{}", around.number(token));
    let meant = TargetMeant::Written { written: shown(&written) };
    let found = around.diagnostic(g.span(around.text), Finding::MissingTarget { function, meant });
    let letter = around.place(Span::new(token.start, token.start + 1));
    let number = Number { value: p.number().unwrap_or_default(), ..Number::default() };
    let found = found.with_offer(write(&written), letter, "L");
    Some(Diagnosis::saying(1, found).with(Word::with_number(Address::L, token.span(), number), token.span()))
}

/// G04 with its time in another word than Q: `G04 P500`, `G04 X0.5`, `G04 F0.5` (GRP-5).
pub(super) fn dwell(around: &Around<'_>) -> Option<Diagnosis> {
    let (_, g) = function(around, &[GCode::G04])?;
    let mut others = around
        .words
        .iter()
        .filter(|word| !matches!(word.address, Address::N | Address::G | Address::M | Address::Skip));
    let (Some(time), None) = (others.next().filter(|time| time.start() == around.token().start), others.next()) else {
        return None;
    };
    // Words of other controls that are something else here too.
    let other = matches!(time.address, Address::H | Address::K | Address::S);
    let known = other || matches!(time.address, Address::P | Address::X | Address::U | Address::F);
    let value = time.number().filter(|value| known && value.thousandths() > 0)?;
    let seconds = time.has_point() || time.address == Address::F;
    let units = match value.as_whole() {
        Some(whole) if !seconds && !other && whole >= MILLISECONDS => (whole + 5) / 10,
        Some(whole) if !seconds => whole * 100,
        Some(_) | None => (value.thousandths() + 5) / 10,
    };
    let span = time.span(around.text);
    // A block with G04 may move: a whole X may be a coordinate.
    let maybe_target = matches!(time.address, Address::X | Address::U) && !time.has_point();
    let in_seconds = other || !seconds && value < Decimal::whole(MILLISECONDS);
    let at_g = |meant: DwellMeant| around.diagnostic(g.span(around.text), Finding::MissingDwell { meant });
    if !(1..=HIGHEST_Q).contains(&units) {
        return Some(Diagnosis::saying(1, at_g(DwellMeant::Units)).void(Address::Q, span));
    }
    let written = format!("Q{units}");
    let meant = if in_seconds {
        DwellMeant::Seconds { address: time.address, written: written.clone() }
    } else if maybe_target {
        DwellMeant::Perhaps { address: time.address, written: written.clone() }
    } else {
        DwellMeant::Written { written: written.clone() }
    };
    let found = at_g(meant).with_offer(write(&written), around.place(span), written);
    let number = Number { value: Decimal::whole(units), ..Number::default() };
    Some(Diagnosis::saying(1, found).with(Word::with_number(Address::Q, span, number), span))
}

/// R without the form of a parameter is meant as the radius in a block with an arc, and as the height of a fixed cycle.
pub(super) fn radius(around: &Around<'_>, diagnosis: Diagnosis) -> Diagnosis {
    let Some(found) = diagnosis.found.clone() else { return diagnosis };
    let span = found.at.span;
    let in_line = matches!(&found.finding, Finding::MissingValue { address, .. } if address == "R" || address == "R0");
    if in_line && super::elsewhere::line_function(around).is_some() {
        return Diagnosis { found: None, ..diagnosis };
    }
    if around.tokens.last().is_some_and(|last| arc_in_force(around.text, last.end)) {
        let finding = if let Finding::MissingValue { address, .. } = found.finding {
            Finding::MissingValue { address, meant: ValueMeant::Radius }
        } else {
            Finding::MalformedNumber { text: shown(around.slice(span)), meant: NumberMeant::Radius }
        };
        let diagnosis = Diagnosis { found: Some(around.diagnostic(span, finding)), ..diagnosis };
        // The centre was given, in a way that is none here.
        let centred = around.has(Address::I) || around.has(Address::J);
        return if centred { diagnosis } else { diagnosis.void(Address::I, span) };
    }
    let Some(cycle) = around.functions().find(|code| code.is_cycle()) else { return diagnosis };
    let missing = if let Finding::MissingValue { address, .. } = found.finding { Some(address) } else { None };
    let address = missing.unwrap_or_else(|| shown(around.slice(span)));
    let finding = Finding::MissingValue { address, meant: ValueMeant::Height { cycle } };
    Diagnosis { found: Some(around.diagnostic(span, finding)), ..diagnosis }
}

/// What else other controls write beside the height of a fixed cycle is part of it.
pub(super) fn beside_height(around: &Around<'_>) -> Option<Diagnosis> {
    let (word, span, tokens) = grammar::word(around.text, around.tokens, around.at)?;
    let part = matches!(word.address, Address::Q | Address::P | Address::K | Address::L);
    let height = |word: &Word| word.address == Address::R && word.is_void();
    let cycle = part && around.functions().any(GCode::is_cycle) && around.words.iter().any(height);
    let end = around.tokens.last().map_or(span.end, |last| last.end);
    (cycle && !arc_in_force(around.text, end)).then(|| Diagnosis::of(tokens).void(word.address, span))
}

/// Whether the last function of group G0 before `end`, in the order of the text, is G02 or G03. It is asked of the
/// text, not of the words that were read: another part of a long text is read at the same time.
pub(super) fn arc_in_force(text: &str, end: u32) -> bool {
    let bytes = text.as_bytes();
    let least = end.saturating_sub(FAR) as usize;
    let mut to = end as usize;
    // Most slips have no G near: nothing is read then.
    while memchr::memrchr2(b'G', b'g', bytes.get(least..to).sure()).is_some() {
        let head = bytes.get(least..to.saturating_sub(1)).sure();
        let from = memchr::memrchr2(b'\n', b'\r', head).map_or(least, |at| least + at + 1);
        if let Some(code) = last_motion(text, from, to) {
            return matches!(code, GCode::G02 | GCode::G03);
        }
        to = from;
    }
    false
}

/// The last function of group G0 in a line.
fn last_motion(text: &str, from: usize, to: usize) -> Option<GCode> {
    let from = (from..to).find(|at| text.is_char_boundary(*at))?;
    let codes = tokens(text, small(from), small(to)).filter_map(|token| {
        let word = text.get(token.span().range()).filter(|_| token.kind == Kind::Word)?;
        let number = word.strip_prefix(['G', 'g'])?.trim_matches([' ', '\t']);
        let code = number.parse().ok().and_then(GCode::from_number)?;
        (code.group() == GGroup::G0).then_some(code)
    });
    codes.last()
}
