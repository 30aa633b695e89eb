//! The edits that the help of a finding names where they are not beyond doubt: editors offer them, nothing applies them
//! by itself.

use std::collections::BTreeMap;

use crate::diag::{
    Diagnostic, DwellMeant, Edit, Finding, Findings, Fix, FixTitle, PointMeant, TargetMeant, UnusedMeant,
};
use crate::dict::{Address, GCode, HIGHEST_BLOCK};
use crate::resolve::{Resolved, Roles, Taker, Target, Unit, UnitKind, number_as_function};
use crate::sure::{Sure, small};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, Span};

/// The usual distance of block numbers.
const STEP: u32 = 10;

/// Of how many findings of a run something is offered.
const MOST: usize = 2_000;

/// Adds what can be offered to those findings that have no fix.
pub(super) fn add(findings: &mut Findings, resolved: &Resolved) {
    let mut offers = Offers { resolved, certain: !findings.prevent_execution(), numbers: BTreeMap::new() };
    findings.offer(MOST, |found| offers.of(found).unwrap_or_default());
}

/// Makes offers for one program.
struct Offers<'a> {
    resolved: &'a Resolved,
    /// Structure and flow have no errors: what nothing leads to is known.
    certain: bool,
    /// The numbers of the blocks of a file, sorted, once they are asked for.
    numbers: BTreeMap<FileId, Vec<u32>>,
}

/// One change that is offered.
fn offer(title: FixTitle, file: &ParsedFile, span: Span, text: impl Into<String>) -> Vec<Fix> {
    vec![Fix::offer(title, file.at(span), text)]
}

/// A change of a text into another that is written at its place.
fn write(file: &ParsedFile, span: Span, text: String) -> Vec<Fix> {
    offer(FixTitle::Write { text: text.clone() }, file, span, text)
}

impl Offers<'_> {
    fn of(&mut self, found: &Diagnostic) -> Option<Vec<Fix>> {
        let file = self.resolved.file(found.at.file)?;
        let at = found.at.span;
        self.flow(file, found).or_else(|| self.structure(file, found)).or_else(|| of_word(file, at, &found.finding))
    }

    /// Calls and jumps that lead nowhere, or are missing their target.
    fn flow(&self, file: &ParsedFile, found: &Diagnostic) -> Option<Vec<Fix>> {
        let at = found.at.span;
        let (block, word) = word_at(file, at)?;
        let called = |code: GCode| {
            let Taker::One(taker, g) = Roles::written(file.words(block)).taker else { return None };
            (taker == code && g.is_plain()).then_some(g)
        };
        let text = file.source.text();
        if let Finding::UnknownSubprogram { l, near, macrocycle, from_macrocycle, without_entry, block: jump, .. } =
            found.finding
        {
            let g = called(GCode::G71)?;
            if macrocycle {
                return Some(offer(FixTitle::Write { text: format!("G72 L{l}") }, file, g.span(text), "G72"));
            }
            let near = near.filter(|_| !from_macrocycle && !jump && without_entry.is_none() && word.is_plain())?;
            // `G71 Q100 L2`: the two are exchanged.
            let q = file.words(block).iter().find(|other| other.address == Address::Q);
            if let Some(q) = q.filter(|q| q.is_plain() && q.whole() == Some(i64::from(near))) {
                let swapped = |span: Span, text: String| Edit { at: file.at(span), text };
                let edits = vec![swapped(q.span(text), format!("Q{l}")), swapped(at, near.to_string())];
                let title = FixTitle::Write { text: format!("G71 L{near} Q{l}") };
                return Some(vec![Fix { title, edits, certain: None }]);
            }
            return Some(offer(FixTitle::Write { text: format!("G71 L{near}") }, file, at, near.to_string()));
        }
        if let Finding::UnknownMacrocycle { l, subprogram: true, .. } = found.finding {
            let g = called(GCode::G72)?;
            return Some(offer(FixTitle::Write { text: format!("G71 L{l}") }, file, g.span(text), "G71"));
        }
        if let Finding::UnknownJumpTarget { near: Some(near), .. } = found.finding
            && word.is_plain()
            && file.number(block) != Some(near)
        {
            return Some(offer(FixTitle::Write { text: format!("G73 L{near}") }, file, at, near.to_string()));
        }
        if let Finding::MissingTarget { function: GCode::G71, meant } = &found.finding
            // The number is there, behind another address, or no call is meant.
            && !matches!(meant, TargetMeant::InPlace { .. } | TargetMeant::Turning | TargetMeant::Drilling)
        {
            return self.missing_target(file, block, word, meant);
        }
        None
    }

    /// G71 without L: the only subprogram of the file, or nothing at all.
    fn missing_target(&self, file: &ParsedFile, block: BlockId, g: Word, meant: &TargetMeant) -> Option<Vec<Fix>> {
        let own = self.unit_of(file, block).map(|unit| unit.kind);
        let mut subprograms = self.resolved.units().filter_map(|(_, unit)| match unit.kind {
            UnitKind::Subprogram(Some(l)) if own != Some(unit.kind) => Some(l),
            UnitKind::Subprogram(_) | UnitKind::Main | UnitKind::Macrocycle(_) => None,
        });
        let span = g.span(file.source.text());
        let mut fixes = Vec::new();
        if matches!(meant, TargetMeant::Millimetres) {
            fixes.extend(delete_word(file, block, g).unwrap_or_default());
        }
        if let (Some(only), None) = (subprograms.next(), subprograms.next()) {
            let text = format!("{} L{only}", file.source.slice(span));
            fixes.extend(offer(FixTitle::Write { text }, file, Span::empty(span.end), format!(" L{only}")));
        }
        Some(fixes)
    }

    /// Ends that are missing, numbers that are there twice, blocks and units without use.
    fn structure(&mut self, file: &ParsedFile, found: &Diagnostic) -> Option<Vec<Fix>> {
        let at = found.at.span;
        let place = found.labels.first().map(|label| label.at.span);
        if let Finding::MissingProgramEnd { skipped: false, late: None, instead, unread: None } = found.finding {
            let main = self.main(file)?;
            return if instead.is_some() { instead_of_return(file, main) } else { self.end_of(file, main, "M30") };
        }
        if let Finding::UnterminatedSubprogram { skipped: false, instead, unread: None, .. } = found.finding {
            return match (instead, place) {
                (Some(_), Some(place)) => Some(write(file, place, "G70".to_owned())),
                (_, _) => self.end_of(file, self.unit_at(file, at)?, "G70"),
            };
        }
        if let Finding::DuplicateBlockNumber { last: None, block: number, copied } = found.finding {
            let block = file.block_at(at.start)?;
            if file.words(block).is_empty() {
                return Some(self.empty_block(file, block, at));
            }
            // `N40 N40 X5`: the number is written twice.
            let before = block.0.checked_sub(1).map(BlockId)?;
            if file.number(before) == Some(number) && file.words(before).is_empty() {
                let empty = Span::new(file.n_word(before)?.start(), at.start);
                let alone = file.comments_behind(before).is_empty();
                return alone.then(|| offer(FixTitle::Delete { text: format!("N{number}") }, file, empty, ""));
            }
            // Which of the two a jump means, nobody knows.
            let is_it = |to: BlockId| file.number(to) == Some(number);
            let targets = self.resolved.targets(file.file);
            if targets.iter().any(|(_, target)| matches!(target, Target::Block(to) if is_it(*to))) {
                return None;
            }
            // A second end or beginning of a unit is wrong under any number.
            let flags = file.flags(block);
            let bounds = [BlockFlags::ENTRY, BlockFlags::END].into_iter().any(|flag| flags.has(flag)) && copied;
            let free = self.free_behind(file, before).filter(|_| !bounds);
            let renumber = free.map(|free| write(file, at, format!("N{free}")));
            // Where the first one stands in a gap of the steps, its number is the wrong one.
            let first = place.and_then(|place| file.block_at(place.start)?.0.checked_sub(1));
            let gap = first.and_then(|before| self.free_behind(file, BlockId(before)));
            let odd = free.is_some_and(|free| free % STEP != 0);
            let gap = gap.filter(|gap| odd && *gap < number && *gap % STEP == 0).zip(place);
            let renumber_first = gap.map(|(gap, place)| write(file, place, format!("N{gap}")));
            let whole = || whole_lines(file.source.text(), Span::new(at.start, words_end(file, block)));
            let copy = if copied { whole() } else { None };
            let delete = copy.map(|copy| offer(FixTitle::DeleteBlock { block: number }, file, copy, ""));
            return Some(delete.into_iter().chain(renumber_first).chain(renumber).flatten().collect());
        }
        if let Finding::MacrocycleNumberMismatch { expected, found, .. } = found.finding {
            let ends = || file.block_ids().any(|block| file.flags(block).has(BlockFlags::RETURN));
            let entry = format!("G79 L{expected}");
            return match found {
                Some(_) => Some(offer(FixTitle::Write { text: entry }, file, at, expected.to_string())),
                None => ends().then(|| self.before_first(file, &entry)).flatten(),
            };
        }
        if let Finding::EmptyBlock { .. } = found.finding {
            return Some(self.empty_block(file, file.block_at(at.start)?, at));
        }
        if let Finding::UnusedSubprogram { l } = found.finding
            && self.certain
        {
            return self.unused_subprogram(file, self.unit_at(file, at)?, l);
        }
        None
    }

    fn main(&self, file: &ParsedFile) -> Option<Unit> {
        let main = self.resolved.main().and_then(|id| self.resolved.unit(id));
        main.filter(|unit| unit.file == file.file).copied()
    }

    /// The unit whose entry is at a place.
    fn unit_at(&self, file: &ParsedFile, at: Span) -> Option<Unit> {
        self.resolved.units().map(|(_, unit)| *unit).find(|unit| unit.entry == file.at(at))
    }

    fn unit_of(&self, file: &ParsedFile, block: BlockId) -> Option<Unit> {
        self.resolved.units().map(|(_, unit)| *unit).find(|unit| unit.file == file.file && unit.contains(block))
    }

    /// A block with that function behind the last one of a unit.
    fn end_of(&mut self, file: &ParsedFile, unit: Unit, function: &str) -> Option<Vec<Fix>> {
        let last = unit.end.0.checked_sub(1).map(BlockId).filter(|last| unit.contains(*last))?;
        let text = file.source.text();
        let end = words_end(file, last);
        let line = line_of(text, end);
        let next = file.n_word(last.next()).map_or(u32::MAX, Word::start);
        let rest = file.source.slice(Span::new(end, line.end));
        // Another block in the line, or the end of the file.
        if next < line.end || rest.contains('*') {
            return None;
        }
        let block = format!("N{} {function}", self.free_behind(file, last)?);
        let title = FixTitle::Insert { text: block.clone() };
        Some(offer(title, file, Span::empty(line.end), format!("{}{block}", line_break(text, line.end))))
    }

    /// A block with those words before the first one.
    fn before_first(&mut self, file: &ParsedFile, words: &str) -> Option<Vec<Fix>> {
        let text = file.source.text();
        let first = file.n_word(BlockId(0))?.start();
        let line = line_of(text, first);
        if !file.source.slice(Span::new(line.start, first)).trim().is_empty() {
            return None;
        }
        let number = file.number(BlockId(0))?;
        let below = [STEP / 2, 1].into_iter().find(|step| number > *step).map(|step| number - step);
        let free = below.map_or_else(|| self.free_at_end(file), Some)?;
        let block = format!("N{free} {words}");
        let inserted = format!("{block}{}", line_break(text, line.end));
        Some(offer(FixTitle::Insert { text: block }, file, Span::empty(line.start), inserted))
    }

    /// The function that its number may be, and the program without it.
    fn empty_block(&self, file: &ParsedFile, block: BlockId, at: Span) -> Vec<Fix> {
        let function = number_as_function(file, block).map(|function| write(file, at, function));
        function.into_iter().chain(self.without_block(file, block, at)).flatten().collect()
    }

    fn without_block(&self, file: &ParsedFile, block: BlockId, at: Span) -> Option<Vec<Fix>> {
        let jumps = self.resolved.targets(file.file).iter().any(|(_, target)| *target == Target::Block(block));
        let unit = self.unit_of(file, block)?;
        // A unit keeps its first and its last block: they begin and end it.
        if jumps || unit.first == block || unit.end == block.next() || !file.comments_behind(block).is_empty() {
            return None;
        }
        let span = whole_lines(file.source.text(), at).unwrap_or(at);
        Some(offer(FixTitle::DeleteBlock { block: file.shown_number(block) }, file, span, ""))
    }

    /// All blocks of a unit, with the comments directly above them.
    fn unused_subprogram(&self, file: &ParsedFile, unit: Unit, l: u32) -> Option<Vec<Fix>> {
        let calls = |(block, target): &(BlockId, Target)| unit.contains(*block) && matches!(target, Target::Unit(_));
        // A function or number that comes from a parameter may lead there.
        let leads = |word: Word| matches!(word.address, Address::G | Address::L);
        let unknown = |word: Word| leads(word) && (word.is_parametric() || word.is_void());
        if self.resolved.targets(file.file).iter().any(calls) || file.all_words().any(unknown) {
            return None;
        }
        let text = file.source.text();
        let last = unit.end.0.checked_sub(1).map(BlockId).filter(|last| unit.contains(*last))?;
        let next = file.n_word(unit.end).map_or(u32::MAX, Word::start);
        let span = whole_lines(text, Span::new(file.n_word(unit.first)?.start(), words_end(file, last)));
        let mut span = span.filter(|span| span.end <= next)?;
        while let Some(above) = span.start.checked_sub(1).map(|end| line_of(text, end)) {
            let line = file.source.slice(above).trim();
            if !line.starts_with('"') || above.start <= file.start || above.start >= span.start {
                break;
            }
            span.start = above.start;
        }
        Some(offer(FixTitle::DeleteSubprogram { l }, file, span, ""))
    }

    /// A number that no block has: between that of a block and the next one, where there is room.
    fn free_behind(&mut self, file: &ParsedFile, block: BlockId) -> Option<u32> {
        let before = file.number(block)?;
        let next = file.number(block.next()).filter(|next| *next > before);
        let room = next.map_or(u32::MAX, |next| next - before);
        let mut near = [STEP, STEP / 2, 2, 1]
            .into_iter()
            .filter(|step| *step < room)
            .filter_map(|step| before.checked_add(step).filter(|number| *number <= HIGHEST_BLOCK));
        match near.find(|number| !self.is_taken(file, *number)) {
            Some(number) => Some(number),
            None => self.free_at_end(file),
        }
    }

    /// A number above all others.
    fn free_at_end(&mut self, file: &ParsedFile) -> Option<u32> {
        let highest = self.numbers(file).last().copied().unwrap_or(0);
        (highest / STEP).checked_add(1)?.checked_mul(STEP).filter(|number| *number <= HIGHEST_BLOCK)
    }

    fn is_taken(&mut self, file: &ParsedFile, number: u32) -> bool {
        self.numbers(file).binary_search(&number).is_ok()
    }

    fn numbers(&mut self, file: &ParsedFile) -> &[u32] {
        self.numbers.entry(file.file).or_insert_with(|| {
            let mut numbers: Vec<u32> = file.block_ids().filter_map(|block| file.number(block)).collect();
            numbers.sort_unstable();
            numbers
        })
    }
}

/// What concerns one word alone.
fn of_word(file: &ParsedFile, at: Span, finding: &Finding) -> Option<Vec<Fix>> {
    let (block, word) = word_at(file, at)?;
    let text = file.source.text();
    let letter = || file.source.slice(Span::new(word.start(), at.start)).trim_end().to_owned();
    if let Finding::PointNotAllowed { meant: PointMeant::Whole { written } | PointMeant::Seconds { written }, .. } =
        finding
    {
        Some(write(file, word.span(text), written.clone()))
    } else if let Finding::PointNotAllowed { meant: PointMeant::WholeOrDigits { written, digits }, .. } = finding {
        let readings = [written, digits].into_iter();
        Some(readings.flat_map(|reading| write(file, word.span(text), reading.clone())).collect())
    } else if let Finding::SignNotAllowed { key, .. } = finding {
        let number = file.source.slice(at).trim_start_matches(['+', '-', ' ', '\t']);
        let title = FixTitle::Write { text: format!("{}{number}", letter()) };
        // Of functions, and of 0, it is not sure enough that the number is right; a minus may be that of another
        // letter.
        let meant = number.bytes().all(|byte| byte.is_ascii_digit()) && number.bytes().any(|byte| byte != b'0');
        let function = matches!(word.address, Address::G | Address::M) || file.source.slice(at).starts_with('-');
        let digit = (!key.is_empty()).then(|| write(file, word.span(text), key.clone()));
        (meant && !function)
            .then(|| offer(title, file, at, number).into_iter().chain(digit.into_iter().flatten()).collect())
    } else if let Finding::FinerThanResolution { rounded } = finding {
        Some(offer(FixTitle::Write { text: format!("{}{rounded}", letter()) }, file, at, rounded.clone()))
    } else if matches!(finding, Finding::MissingDwell { meant: DwellMeant::Units }) && file.words(block).len() == 1 {
        let written = format!("{} Q100", file.source.slice(at));
        Some(offer(FixTitle::Write { text: written }, file, Span::empty(at.end), " Q100"))
    } else if matches!(
        finding,
        Finding::UnusedTarget { meant: UnusedMeant::Target }
            | Finding::UnusedRepeat {}
            | Finding::SuperfluousControlWord { .. }
    ) {
        delete_word(file, block, word)
    } else {
        None
    }
}

/// M30 in place of the M function that ends a program on other controls, in the last block of the unit.
fn instead_of_return(file: &ParsedFile, unit: Unit) -> Option<Vec<Fix>> {
    let last = unit.end.0.checked_sub(1).map(BlockId)?;
    let mut m_words = file.words(last).iter().filter(|word| word.address == Address::M && word.is_plain());
    let (Some(word), None) = (m_words.next(), m_words.next()) else { return None };
    Some(write(file, word.span(file.source.text()), "M30".to_owned()))
}

/// Without a word and the blanks before it; not when nothing else is in its block, nor right behind a number, of which
/// its letter may be a digit: `Z-7.l25`.
fn delete_word(file: &ParsedFile, block: BlockId, word: Word) -> Option<Vec<Fix>> {
    let words = file.words(block);
    let twice =
        words.iter().filter(|other| other.address == word.address && other.target() == word.target()).count() > 1;
    if words.len() < 2 || twice {
        return None;
    }
    let text = file.source.text();
    let span = word.span(text);
    let before = text.get(..span.start as usize)?.trim_end_matches([' ', '\t']);
    let with_blanks = Span::new(u32::try_from(before.len()).ok()?, span.end);
    if with_blanks == span && before.ends_with(|last: char| last.is_ascii_digit() || last == '.') {
        return None;
    }
    Some(offer(FixTitle::Delete { text: file.source.slice(span).to_owned() }, file, with_blanks, ""))
}

/// The word that a finding is about, `N` left out, with its block.
fn word_at(file: &ParsedFile, at: Span) -> Option<(BlockId, Word)> {
    let block = file.block_at(at.start)?;
    let text = file.source.text();
    let covers = |word: &&Word| {
        let span = word.span(text);
        span.start <= at.start && at.end <= span.end
    };
    file.words(block).iter().find(covers).map(|word| (block, *word))
}

fn words_end(file: &ParsedFile, block: BlockId) -> u32 {
    let text = file.source.text();
    let n = file.n_word(block).map_or(file.start, |word| word.span(text).end);
    file.words(block).last().map_or(n, |word| word.span(text).end)
}

/// The line of a place, without its end.
fn line_of(text: &str, offset: u32) -> Span {
    let (before, behind) = text.split_at_checked(offset as usize).unwrap_or((text, ""));
    let start = before.rfind(['\r', '\n']).map_or(0, |at| at + 1);
    let end = before.len() + behind.find(['\r', '\n', '\u{1a}', '\0']).unwrap_or(behind.len());
    Span::new(small(start), small(end))
}

/// How lines end at that place, or in the line before it.
fn line_break(text: &str, at: u32) -> &'static str {
    let (before, behind) = text.split_at_checked(at as usize).unwrap_or((text, ""));
    let around = before.rfind(['\r', '\n']).and_then(|at| before.get(at.saturating_sub(1)..=at)).unwrap_or("\n");
    if behind.starts_with("\r\n") || (behind.is_empty() && around == "\r\n") {
        "\r\n"
    } else if behind.starts_with('\r') || (behind.is_empty() && around.ends_with('\r')) {
        "\r"
    } else {
        "\n"
    }
}

/// The lines of a span, when nothing else but blanks is in them.
fn whole_lines(text: &str, span: Span) -> Option<Span> {
    // Most places have words before them in their line, which may be long.
    let blank = |character: char| character.is_whitespace() && !matches!(character, '\r' | '\n');
    let before = text.get(..span.start as usize)?.trim_end_matches(blank);
    if !(before.is_empty() || before.ends_with(['\r', '\n'])) {
        return None;
    }
    let (first, last) = (line_of(text, span.start), line_of(text, span.end));
    let behind = text.get(last.end as usize..)?;
    let rest = if behind.starts_with("\r\n") { 2 } else { u32::from(behind.starts_with(['\r', '\n'])) };
    let behind = text.get(span.end as usize..last.end as usize).sure().trim();
    // A comment behind the words goes with them.
    let alone = behind.is_empty() || (behind.starts_with('"') && behind.len() > 1 && behind.ends_with('"'));
    alone.then(|| Span::new(first.start, last.end + rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines() {
        let text = "%1\r\nN10 X5\r\nN20 M30\r\n\u{1a}";
        assert_eq!(line_of(text, 6), Span::new(4, 10));
        assert_eq!(whole_lines(text, Span::new(4, 10)), Some(Span::new(4, 12)));
        assert_eq!(whole_lines(text, Span::new(8, 10)), None);
        assert_eq!((line_break(text, 10), line_break("a\rb", 3), line_break("a", 1)), ("\r\n", "\r", "\n"));
    }
}
