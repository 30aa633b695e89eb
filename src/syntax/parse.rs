//! Parses a file: splits its tokens at every `N` and runs the grammar on one block at a time.

use std::sync::Arc;

use super::blocks::Reader;
use super::tokens::Shape;
use super::{BlockId, Kind, ParsedFile, Token, Word, layout, plain, slips, tokens};
use crate::diag::{Diagnostic, Finding, Findings, FixTitle, ValueMeant};
use crate::dict::Address;
use crate::parallel;
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, SourceText, Span};

/// The form of a file.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Form {
    /// Begins with `%`.
    Program,
    /// Begins with `N… G79 L…`; a `%` before it is tolerated (PRG-7).
    Macrocycle,
}

/// Parses a file. What is wrong with its form goes to `findings`; the tree holds all that could be read.
pub fn parse(file: FileId, source: &Arc<SourceText>, form: Form, findings: &mut Findings) -> ParsedFile {
    let alone = source.len() < LONG || parallel::threads() == 1;
    let pieces = if alone { 1 } else { source.len() / PIECE };
    parse_in(pieces, true, file, source, form, findings)
}

/// Texts below this many bytes are read in one piece: two threads would not be done sooner.
const LONG: u32 = 1 << 20;
/// Longer ones are read in pieces of about this many bytes, side by side.
const PIECE: u32 = 1 << 16;
/// So many pieces are read before they are put together, while the next are being read: what is in pieces is little
/// beside what is together.
const AT_ONCE: usize = 16;

/// Parses in so many pieces, and, unless it is to be compared, takes the short way through plain blocks.
pub(super) fn parse_in(
    pieces: u32,
    short_way: bool,
    file: FileId,
    source: &Arc<SourceText>,
    form: Form,
    findings: &mut Findings,
) -> ParsedFile {
    let text = source.text();
    let end = layout::end_of_text(text);
    let at = |span: Span| Location { file, span };
    if source.encoding().is_utf16() {
        layout::report_utf16(file, source, findings);
    }
    let start = start_of(file, source, form, findings).min(end);
    let read = |(from, to): (u32, u32)| {
        let mut reader = Reader::new(text, file, form, from == start, (from, to));
        reader.read(from, to, short_way);
        reader
    };
    let parsed = ParsedFile {
        file,
        source: Arc::clone(source),
        form,
        program: None,
        title: None,
        outside: Vec::new(),
        second_program: None,
        start,
        end,
        words: Vec::new(),
        comments: Vec::new(),
        blocks: Vec::new(),
        case: None,
        at_star: Vec::new(),
    };
    let mut whole = Whole { parsed, findings, lowercase: Vec::new(), outside: Vec::new(), ended: false };
    if pieces < 2 {
        whole.append(read((start, end)));
    } else {
        // A word has eight characters or so; pages that are not filled cost nothing.
        whole.parsed.words.reserve((end - start) as usize / 8);
        // The lines are wanted by what follows; finding them fits beside the reading.
        parallel::join(|| whole.read_side_by_side(&piece_bounds(text, start, end, pieces), read), || source.lines());
    }
    let Whole { mut parsed, lowercase, outside, .. } = whole;
    if let Some((first, more)) = outside.split_first() {
        // All of them are one run, whatever comments stand between them (BLK-2).
        let (first, more) = (first.span(text), more.len());
        let word = crate::diag::shown(source.slice(first));
        let skip = word.starts_with('/') && more == 0;
        let number = skip.then(|| parsed.n_word(BlockId(0)).and_then(Word::whole)).flatten();
        let number = number.unwrap_or_else(|| free_number(&parsed));
        let finding = Finding::WordOutsideBlock { word, more, blocks: !parsed.blocks.is_empty(), number };
        findings.add(Diagnostic::new(finding, at(first)));
    }
    parsed.outside = outside;
    parsed.mark_commented();
    let parametric = || parsed.words.iter().filter(|word| word.is_parametric()).count();
    let addresses = if lowercase.is_empty() { 0 } else { parsed.words.len() + parametric() };
    parsed.case = layout::case_finding(file, text, &lowercase, addresses).map(Box::new);
    layout::check_lines(file, source, parsed.start, parsed.end, findings);
    parsed
}

/// Where what is read of a file begins; the end of the text where a program has no `%`.
fn start_of(file: FileId, source: &SourceText, form: Form, findings: &mut Findings) -> u32 {
    let text = source.text();
    if form == Form::Macrocycle {
        return source.first_offset();
    }
    let Some(start) = memchr::memchr(b'%', text.as_bytes()).map(small) else {
        findings.add(missing_start(file, source));
        return source.len();
    };
    let Some(behind) = start_behind(text, start) else { return start };
    let finding = Finding::MissingValue { address: "%".to_owned(), meant: ValueMeant::EarlyStart };
    findings.add(Diagnostic::new(finding, Location { file, span: Span::new(start, start + 1) }));
    behind
}

/// The finding that there is no `%`: with the number that other controls write behind `O` or `:` in the first line.
fn missing_start(file: FileId, source: &SourceText) -> Diagnostic {
    let first = source.first_offset();
    let at = |from: u32, to: u32| Location { file, span: Span::new(from, to) };
    let text = source.text().get(first as usize..).sure();
    let line = text.split(['\n', '\r']).next().sure();
    let rest = line.strip_prefix(['O', 'o', ':']);
    let letter = rest.is_some();
    let rest = rest.unwrap_or(line);
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    let behind = rest.get(digits.len()..).sure().trim_start_matches([' ', '\t']);
    // `2107`, `2107 "PRIRUBA"`
    let alone = behind.is_empty() || behind.starts_with('"');
    let number = digits.parse().ok().filter(|number| (letter || alone) && (1..=HIGHEST_PROGRAM).contains(number));
    let finding = Finding::MissingProgramStart { number: number.unwrap_or(1) };
    let diagnostic = Diagnostic::new(finding, at(first, first));
    match number {
        Some(number) => {
            let title = FixTitle::Write { text: format!("%{number}") };
            diagnostic.with_offer(title, at(first, first + u32::from(letter)), "%")
        }
        None => diagnostic,
    }
}

/// Where the program begins when the first `%` is one of a remark above it: without a number, and before any block
/// there is a line that begins with `%` and its number.
fn start_behind(text: &str, start: u32) -> Option<u32> {
    let rest = text.get(start as usize + 1..)?;
    let line = rest.trim_start_matches([' ', '\t']);
    // `%` and on the next line `O2107`, `%_N_2107`, `%O1`: a start in the manner of other controls.
    let odd = line.starts_with(|first: char| first.is_ascii_digit() || "+-.,_".contains(first));
    if odd || rest.starts_with(|first: char| first.is_ascii_alphabetic()) {
        return None;
    }
    let mut at = start as usize + 1;
    for line in rest.split_inclusive(['\n', '\r']) {
        let words = line.trim_start_matches([' ', '\t']);
        let begins = at > start as usize + 1;
        match words.as_bytes() {
            [b'%', number @ ..] if begins && number.trim_ascii_start().first().is_some_and(u8::is_ascii_digit) => {
                return u32::try_from(at + line.len() - words.len()).ok();
            }
            [b'N' | b'n' | b'O' | b'o', b'0'..=b'9', ..] if begins => return None,
            _ => at += line.len(),
        }
    }
    None
}

/// Greatest number of a program (PRG-1).
const HIGHEST_PROGRAM: u32 = 999_999;

/// A block number that no block of the file has, below that of the first one where there is such: 10, 5, or another.
fn free_number(parsed: &ParsedFile) -> i64 {
    let numbers = || parsed.words.iter().filter(|word| word.address == Address::N).filter_map(|word| word.whole());
    let first = numbers().next().unwrap_or(i64::MAX);
    let free = |number: i64| !numbers().any(|taken| taken == number);
    let before = [10, 5, 1].into_iter().find(|number| *number < first && free(*number));
    before.unwrap_or_else(|| numbers().max().unwrap_or(0) / 10 * 10 + 10)
}

/// A file that is put together from its pieces.
struct Whole<'f> {
    parsed: ParsedFile,
    findings: &'f mut Findings,
    /// Where addresses in lower case stand.
    lowercase: Vec<u32>,
    outside: Vec<Word>,
    /// `*` was met: what follows it is no program, whatever later pieces hold.
    ended: bool,
}

impl Whole<'_> {
    /// Reads pieces on all cores.
    fn read_side_by_side<'t>(&mut self, bounds: &[(u32, u32)], read: impl Fn((u32, u32)) -> Reader<'t> + Sync) {
        let mut done: Vec<Reader<'t>> = Vec::new();
        for some in bounds.chunks(AT_ONCE) {
            let next = || parallel::map(some.to_vec(), &read);
            let (next, ()) = parallel::join(next, || done.drain(..).for_each(|piece| self.append(piece)));
            done = next;
            if self.ended {
                return;
            }
        }
        done.drain(..).for_each(|piece| self.append(piece));
    }

    fn append(&mut self, piece: Reader<'_>) {
        if self.ended {
            return;
        }
        let Self { parsed, findings, lowercase, outside, ended } = self;
        lowercase.extend(piece.lowering.lowercase);
        findings.append(piece.lowering.findings);
        parsed.at_star.extend(piece.lowering.at_star);
        let empty = parsed.blocks.is_empty() && parsed.comments.is_empty();
        if empty && parsed.words.capacity() < piece.lowering.words.len() {
            (parsed.words, parsed.comments, parsed.blocks) =
                (piece.lowering.words, piece.lowering.comments, piece.blocks);
        } else {
            let words = parsed.words.len();
            parsed.words.extend(piece.lowering.words);
            parsed.comments.extend(piece.lowering.comments);
            parsed.blocks.extend(piece.blocks.into_iter().map(|block| block.shifted(words)));
        }
        if let Some(header) = piece.header {
            parsed.program = header.program;
            parsed.title = header.title;
            *outside = header.outside;
        }
        parsed.second_program = parsed.second_program.or(piece.second_program);
        if let Some(after) = piece.end {
            parsed.at_star.extend(layout::text_after_end(parsed.file, parsed.source.text(), after, parsed.end));
            parsed.end = after;
            *ended = true;
        }
    }
}

/// The span of the word that begins at `start`, read again: for words that are longer than a [`Word`] can tell.
pub(super) fn long_word(text: &str, start: u32) -> Span {
    let end = small(text.len());
    let mut parameters = 0;
    let mut item: Vec<Token> = Vec::new();
    for token in tokens(text, start, end) {
        let parameter = matches!(token.kind, Kind::Parameter | Kind::Junk(Shape::LooseParameter));
        parameters += u32::from(parameter);
        let goes_on = matches!(
            token.kind,
            Kind::Number
                | Kind::Junk(Shape::LooseNumber)
                | Kind::Sign
                | Kind::Equals
                | Kind::Junk(Shape::Operator)
                | Kind::Junk(Shape::Bracketed)
        ) || (parameter && parameters <= 2);
        if !goes_on && !item.is_empty() {
            break;
        }
        item.push(token);
    }
    // `/` is no word that a value could follow.
    slips::first_word(text, &item).or(item.first().map(|token| token.span())).unwrap_or(Span::empty(start))
}

/// Splits a text at lines where a block begins into at most `count` pieces of about the same length.
fn piece_bounds(text: &str, start: u32, end: u32, count: u32) -> Vec<(u32, u32)> {
    let bytes = text.as_bytes();
    let length = (end - start) / count;
    let mut bounds = Vec::new();
    let mut from = start;
    for piece in 1..count {
        let about = (start + length * piece).max(from) as usize;
        let next = memchr::memchr2_iter(b'\n', b'\r', bytes.get(about..end as usize).sure())
            .map(|at| about + at + 1)
            .find(|at| plain::block_begins(bytes, *at));
        let Some(next) = next.and_then(|next| u32::try_from(next).ok()).filter(|next| *next < end) else { break };
        bounds.push((from, next));
        from = next;
    }
    bounds.push((from, end));
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::BlockFlags;

    fn codes(text: &str) -> Vec<(String, String)> {
        let source = Arc::new(SourceText::from_text("t.nc", text));
        let mut findings = Findings::new();
        parse(FileId(0), &source, Form::Program, &mut findings);
        findings
            .into_sorted()
            .iter()
            .map(|found| (found.code().to_string(), source.slice(found.at.span).to_owned()))
            .collect()
    }

    fn one(text: &str, code: &str, place: &str) {
        assert_eq!(codes(&format!("%1\n{text}")), [(code.to_owned(), place.to_owned())], "{text}");
    }

    /// One mistake, one finding, at the whole word.
    #[test]
    fn faulty_words() {
        one("N10 X36.  12 Y5", "E0102", "X36.  12");
        one("N10 X-  36.12", "E0102", "X-  36.12");
        one("N10 XR10 25.5", "E0102", "XR10 25.5");
        one("N10 X- R10", "E0102", "X- R10");
        one("N10 R10= - 5", "E0102", "R10= - 5");
        one("N10 X Y5", "E0103", "X");
        one("N10 X- Y5", "E0103", "X-");
        one("N10 X-- Y5", "E0103", "X--");
        one("N10 X--- Y5", "E0106", "X---");
        one("N10 X. Y5", "E0103", "X.");
        one("N10 X\n5 Y5", "E0103", "X");
        one("N10 X \"c\" 5 Y5", "E0103", "X");
        one("N10 R10", "E0103", "R10");
        one("N10 X36,12", "E0104", "X36,12");
        one("N10 X1.2.3", "E0106", "X1.2.3");
        one("N10 X--5", "E0106", "X--5");
        one("N10 X10 -5", "E0106", "X10 -5");
        one("N10 5", "E0102", "N10 5");
        one("N10 G0 \"a\" 5", "E0106", "5");
        one("N10 X=5", "E0106", "X=5");
        one("N10 XO", "E0107", "XO");
        one("N10 X1O0", "E0107", "X1O0");
        one("N10 Xl0", "E0107", "Xl0");
        one("N10 E5", "E0301", "E5");
        one("N10 G26 E R5=65010203", "E0301", "E");
        one("N10 X R5=2", "E0103", "X");
        one("N10 ERROR X5", "E0111", "ERROR");
        one("N10 #", "E0101", "#");
        one("N10 ř X5", "E0101", "ř");
        one("N10 XR96", "E0501", "96");
        one("NR1 X5", "E0511", "NR1");
    }

    /// A comment between an address and its number is one nevertheless, a line end is none.
    #[test]
    fn comments_before_a_number() {
        let source = Arc::new(SourceText::from_text("t.nc", "%1\nN10 X \"c\"\n5 Y1"));
        let parsed = parse(FileId(0), &source, Form::Program, &mut Findings::new());
        let comments: Vec<&str> = parsed.comments(BlockId(0)).iter().map(|comment| source.slice(*comment)).collect();
        assert_eq!(comments, ["\"c\""]);
    }

    /// BLK-9: whose each comment is.
    #[test]
    fn comments_of_blocks() {
        let owned = |text: &str, form: Form| {
            let source = Arc::new(SourceText::from_text("t.nc", text));
            let parsed = parse(FileId(0), &source, form, &mut Findings::new());
            let texts = |block| {
                let comments = parsed.comments(block);
                assert_eq!(parsed.flags(block).has(BlockFlags::COMMENT), !comments.is_empty(), "{text:?}");
                comments.iter().map(|comment| parsed.comment_text(*comment)).collect::<String>()
            };
            let program: String = parsed.program_comments().collect();
            let blocks: Vec<String> = parsed.block_ids().map(texts).collect();
            format!("{program}|{}", blocks.join("|"))
        };
        for (text, expected) in [
            ("\"z\" %1 \"a\"\n\"b\"\n\"\" N1 X1", "ab|"),
            ("%1\n\"a\"", "a|"),
            ("%1\nN1 X1 \"a\"\nN2 M30", "|a|"),
            ("%1\nN1 X1 \"a\" \"b\" N2 M30", "|ab|"),
            ("%1\nN1 X1\n\"a\" N2 M30", "||a"),
            ("%1\nN1 X1\r\n\"a\"\r\n\r\n\"b\"\r\nN2 M30", "||ab"),
            ("%1\nN1 \"a\"\n\"b\"\nX1 \"c\"\n\"d\"\nN2 M30\n\"e\"", "|abc|de"),
            ("%1\nN1\n\"a\"\nN2\n\"b\"\nN3 M30", "||a|b"),
            ("%1\nN1 X \"a\"\n5 \"b\" Y1\nN2", "|ab|"),
            ("%1\nN1 X1 \"a\" * \"b\"", "|a"),
        ] {
            assert_eq!(owned(text, Form::Program), expected, "{text:?}");
        }
        assert_eq!(owned("\"a\"\n%1 \"b\"\nN1 G79 L1\n\"c\"\nN2 G70", Form::Macrocycle), "b|ab|c");
    }

    #[test]
    fn well_formed() {
        for text in [
            "N10 R65 51N20 G0",
            "N10 R65 = 51N20",
            "N10 XR1R2=5 R3=R4R5=4",
            "N10 X R10",
            "N10 R10 25.5",
            "N10 R10-5 R11=-R10",
            "N10/5 X1",
        ] {
            assert_eq!(codes(&format!("%1\n{text}")), [], "{text}");
        }
    }
}
