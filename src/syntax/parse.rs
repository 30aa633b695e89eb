//! Parses a file: splits its tokens at every `N` and runs the grammar on one block at a time.

use std::sync::Arc;

use chumsky::Parser;
use chumsky::inspector::SimpleState;

use super::file::Block;
use super::lower::Lowering;
use super::{BlockFlags, Kind, ParsedFile, Token, Word, file, grammar, layout, tokens};
use crate::diag::{Diagnostic, Finding, Findings};
use crate::dict::Address;
use crate::text::{FileId, Location, SourceText, Span};

/// What a file is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Form {
    /// Begins with `%`.
    Program,
    /// Begins with `N… G79 L…`; a `%` before it is tolerated (PRG-7).
    Macrocycle,
}

/// Tokens are parsed in batches of about this many, so that memory for them stays small.
const BATCH: usize = 1 << 15;

/// Parses a file. What is wrong with its form goes to `findings`; the tree holds all that could be read.
pub fn parse(file: FileId, source: &Arc<SourceText>, form: Form, findings: &mut Findings) -> ParsedFile {
    let text = source.text();
    let end = layout::end_of_text(text);
    let at = |span: Span| Location { file, span };
    let start = match form {
        Form::Macrocycle => source.first_offset(),
        Form::Program => match memchr::memchr(b'%', text.as_bytes()) {
            Some(start) => u32::try_from(start).unwrap_or(u32::MAX),
            None => {
                findings.add(Diagnostic::new(Finding::MissingProgramStart {}, at(Span::empty(source.first_offset()))));
                end
            }
        },
    };
    let mut parsed = ParsedFile {
        file,
        source: Arc::clone(source),
        program: None,
        title: None,
        start: start.min(end),
        end,
        words: Vec::new(),
        comments: Vec::new(),
        blocks: Vec::new(),
    };
    let mut reader = Reader { lowering: Lowering::new(text, file), blocks: Vec::new(), header: None, form };
    parsed.end = reader.read(parsed.start, end);
    let Reader { lowering, blocks, header, .. } = reader;
    let header = header.unwrap_or_default();
    parsed.program = header.program;
    parsed.title = header.title;
    parsed.words = lowering.words;
    parsed.comments = lowering.comments;
    parsed.blocks = blocks;
    findings.append(lowering.findings);
    if lowering.lowercase {
        layout::check_case(file, text, parsed.start, parsed.end, findings);
    }
    layout::check_lines(file, source, parsed.start, parsed.end, findings);
    parsed
}

/// What stands before the first block.
#[derive(Default)]
struct Header {
    program: Option<Word>,
    title: Option<Span>,
}

struct Reader<'t> {
    lowering: Lowering<'t>,
    blocks: Vec<Block>,
    header: Option<Header>,
    form: Form,
}

impl Reader<'_> {
    /// Reads the tokens from `start` to `end`, and returns where the part that counts ends.
    fn read(&mut self, start: u32, end: u32) -> u32 {
        let text = self.lowering.text;
        let bytes = text.as_bytes();
        let mut batch: Vec<Token> = Vec::with_capacity(BATCH + 64);
        let mut cuts: Vec<usize> = Vec::new();
        let mut program_seen = false;
        let mut end_of_program = end;
        for token in tokens(text, start, end) {
            if token.kind == Kind::End {
                end_of_program = token.end;
                layout::check_after_end(self.lowering.file, text, token.end, end, &mut self.lowering.findings);
                break;
            }
            let with_address = matches!(token.kind, Kind::Word | Kind::LooseWord | Kind::Letter | Kind::SignedLetter);
            match bytes.get(token.start as usize).filter(|_| with_address) {
                Some(b'N' | b'n') => {
                    if batch.len() >= BATCH {
                        self.parse_batch(&batch, &cuts);
                        batch.clear();
                        cuts.clear();
                    }
                    cuts.push(batch.len());
                }
                Some(b'%') if program_seen || (self.form == Form::Macrocycle && !self.before_blocks(&cuts)) => {
                    self.second_program_start(token);
                    continue;
                }
                Some(b'%') => program_seen = true,
                _ => {}
            }
            batch.push(token);
        }
        self.parse_batch(&batch, &cuts);
        if self.header.is_none() {
            self.header = Some(Header::default());
        }
        end_of_program
    }

    fn before_blocks(&self, cuts: &[usize]) -> bool {
        cuts.is_empty() && self.blocks.is_empty()
    }

    fn second_program_start(&mut self, token: Token) {
        let place = Location { file: self.lowering.file, span: token.span() };
        self.lowering.findings.add(Diagnostic::new(Finding::SecondProgramStart {}, place));
    }

    /// Parses the blocks of a batch: each begins at a cut. What stands before the first cut of the file is its header.
    fn parse_batch(&mut self, batch: &[Token], cuts: &[usize]) {
        let first = cuts.first().copied().unwrap_or(batch.len());
        if self.header.is_none() {
            self.parse_header(batch.get(..first).unwrap_or_default());
        }
        let parser = grammar::block();
        let Self { lowering, blocks, .. } = self;
        blocks.reserve(cuts.len());
        let ends = cuts.iter().skip(1).copied().chain(std::iter::once(batch.len()));
        let mut state = SimpleState(lowering);
        for (&from, to) in cuts.iter().zip(ends) {
            let first_word = u32::try_from(state.words.len()).unwrap_or(u32::MAX);
            let first_comment = u32::try_from(state.comments.len()).unwrap_or(u32::MAX);
            state.flags = BlockFlags::default();
            // Accepts every sequence of tokens, so there is no error to look at.
            let _ = parser.parse_with_state(batch.get(from..to).unwrap_or_default(), &mut state);
            blocks.push(Block { first_word, first_comment, flags: state.flags });
        }
    }

    /// The `%` word, the title, and words that belong to no block (BLK-2).
    fn parse_header(&mut self, batch: &[Token]) {
        let mut header = Header::default();
        {
            let parser = grammar::block();
            let mut state = SimpleState(&mut self.lowering);
            let _ = parser.parse_with_state(batch, &mut state);
        }
        let text = self.lowering.text;
        let file = self.lowering.file;
        let mut after_program = self.form == Form::Macrocycle;
        let mut program_end = 0;
        for word in std::mem::take(&mut self.lowering.words) {
            let span = word.span(text);
            if word.address == Address::Program {
                header.program = Some(word);
                after_program = true;
                program_end = span.end;
                if self.form == Form::Macrocycle {
                    self.report(Location { file, span }, Finding::ProgramStartInMacrocycle {});
                }
            } else if !word.is_faulty() && after_program {
                let shown = crate::diag::shown(text.get(span.range()).unwrap_or_default());
                self.report(Location { file, span }, Finding::WordOutsideBlock { word: shown });
            }
        }
        let first = self.lowering.comments.iter().copied().find(|comment| comment.start >= program_end);
        header.title =
            first.filter(|comment| !file::comment_text(text.get(comment.range()).unwrap_or_default()).is_empty());
        self.header = Some(header);
    }

    fn report(&mut self, at: Location, finding: Finding) {
        self.lowering.findings.add(Diagnostic::new(finding, at));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        one("N10 ERROR X5", "E0111", "ERROR");
        one("N10 #", "E0101", "#");
        one("N10 ř X5", "E0101", "ř");
        one("N10 XR96", "E0501", "96");
        one("NR1 X5", "E0511", "NR1");
    }

    #[test]
    fn well_formed() {
        for text in ["N10 XR1R2=5 R3=R4R5=4", "N10 X R10", "N10 R10 25.5", "N10 R10-5 R11=-R10", "N10/5 X1"] {
            assert_eq!(codes(&format!("%1\n{text}")), [], "{text}");
        }
    }
}
