//! Words, comments and findings of blocks, gathered as they are read.

use super::slips::{self, Diagnosis};
use super::tokens::{Kind, Token};
use super::{BlockFlags, Word, grammar};
use crate::diag::{Code, Diagnostic, Findings};
use crate::dict::{Address, GCode, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::text::{FileId, Span};

/// Where the words, comments and findings of a run of blocks are gathered.
#[derive(Debug)]
pub(super) struct Lowering<'t> {
    pub(super) text: &'t str,
    pub(super) file: FileId,
    pub(super) words: Vec<Word>,
    pub(super) comments: Vec<Span>,
    /// The facts about the current block.
    pub(super) flags: BlockFlags,
    pub(super) findings: Findings,
    /// Where addresses in lower case stand, in words without a finding (LEX-11).
    pub(super) lowercase: Vec<u32>,
    /// The current block has a function that other controls write with other words.
    pub(super) candidate: bool,
    /// Where the line ends in which a quote is missing: texts further on in it are none.
    quotes_off: Option<u32>,
    /// The `*` that ends the file, behind the last block of the piece.
    pub(super) star: Option<u32>,
    /// Findings of words that lack their value before that `*`.
    pub(super) at_star: Vec<Diagnostic>,
}

/// The flags that a word of that address sets in its block.
const fn made_of(address: Address) -> BlockFlags {
    use Address::{A, B, C, Correction, D, F, G, H, I, J, K, L, M, N, P, Program, Q, R, S, Skip, T, U, V, W, X, Y, Z};
    match address {
        N => BlockFlags(0),
        Skip => BlockFlags(BlockFlags::SKIP.0 | BlockFlags::RICH.0),
        X | Y | Z | A | B | C | U | V | W => BlockFlags::AXES,
        G | M | L | Q | R | Correction | Program => BlockFlags(BlockFlags::RICH.0 | BlockFlags::OTHERS.0),
        I | J | K | D | F | S | T | H | P => BlockFlags::OTHERS,
    }
}

impl<'t> Lowering<'t> {
    pub(super) fn new(text: &'t str, file: FileId) -> Self {
        Self {
            text,
            file,
            words: Vec::new(),
            comments: Vec::new(),
            flags: BlockFlags::default(),
            findings: Findings::new(),
            lowercase: Vec::new(),
            candidate: false,
            quotes_off: None,
            star: None,
            at_star: Vec::new(),
        }
    }

    /// Reads the tokens of a block.
    pub(super) fn block(&mut self, tokens: &[Token]) {
        let before = (self.words.len(), self.comments.len(), self.lowercase.len());
        self.flags = BlockFlags::default();
        let plain = self.well_formed(tokens);
        if !std::mem::take(&mut self.candidate) && plain {
            return;
        }
        // From its beginning again, with all that is around.
        self.words.truncate(before.0);
        self.comments.truncate(before.1);
        self.lowercase.truncate(before.2);
        self.flags = BlockFlags::default();
        self.explained(slips::read(self.text, self.file, tokens, self.quotes_off));
        self.candidate = false;
    }

    /// Reads well-formed words and closed comments; `false` where there is anything else.
    fn well_formed(&mut self, tokens: &[Token]) -> bool {
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let bytes = self.text.as_bytes();
            let closed = token.end - token.start > 1 && bytes.get(token.end as usize - 1) == Some(&b'"');
            if token.kind == Kind::Comment && closed {
                self.comments.push(token.span());
            } else if token.kind != Kind::LineEnd {
                let Some((word, span, count)) = grammar::word(self.text, tokens, at) else { return false };
                self.push(word, span);
                at += count;
                continue;
            }
            at += 1;
        }
        true
    }

    /// Takes what a block was explained as. Words that touch junk are not known, and junk behind other junk belongs to
    /// it.
    fn explained(&mut self, items: Vec<Diagnosis>) {
        let mut runs: Vec<Span> = Vec::new();
        for item in &items {
            let Some(junk) = item.junk else { continue };
            match runs.last_mut() {
                // Nothing parts them but a word, as in `R1b2=12`.
                Some(run) if junk.start <= run.end || is_glued(self.text, run.end, junk.start) => {
                    run.end = run.end.max(junk.end);
                }
                _ => runs.push(junk),
            }
        }
        for item in items {
            for (word, span) in item.words {
                let unknown = self.beside_junk(word, span, &runs);
                if unknown.is_some() {
                    // Even so it may begin or end a unit.
                    self.note(word);
                }
                let (word, span) = unknown.unwrap_or((word, span));
                self.push(word, span);
            }
            self.comments.extend(item.comments);
            self.quotes_off = item.quotes_off.or(self.quotes_off);
            if item.debris {
                self.flags.set(BlockFlags::DEBRIS);
            }
            let part = |at: u32| run_at(&runs, at).is_some_and(|run| run.start < at);
            let of_junk = |code: Code| matches!(code, Code::E0101 | Code::E0103 | Code::E0106 | Code::E0301);
            let belongs = item.junk.is_some_and(|junk| part(junk.start));
            if let Some(found) = item.found.filter(|found| !belongs || !of_junk(found.code())) {
                if found.code() == Code::E0103 && Some(found.at.span.end) == self.star {
                    self.at_star.push(found);
                } else {
                    self.findings.add(found);
                }
            }
        }
    }

    /// A word that touches junk has no value. A number that goes on behind the junk may be any that begins so.
    fn beside_junk(&self, word: Word, span: Span, runs: &[Span]) -> Option<(Word, Span)> {
        let run = run_at(runs, span.start).filter(|run| run.start <= span.end && !word.is_void())?;
        let digits = self.text.as_bytes().get(run.end as usize..).sure();
        let digits = digits.iter().take(8).take_while(|byte| byte.is_ascii_digit()).count();
        let numbered = matches!(word.address, Address::N | Address::L | Address::G | Address::M);
        // A word stays in its line.
        let breaks = self.text.get(run.range()).sure().contains(['\n', '\r']);
        let end = if numbered && !breaks { span.end.max(run.end + small(digits)) } else { span.end };
        let span = Span::new(span.start, end);
        Some((Word::bare(word.address, span).faulty().assigning(word.target()), span))
    }

    /// Adds a word, which stands at `span`, to the block.
    #[expect(clippy::inline_always, reason = "a word of four fields, handed over in memory, waits for its stores")]
    #[inline(always)]
    pub(super) fn push(&mut self, word: Word, span: Span) {
        if !word.is_faulty() {
            self.note_case(span.start);
            if word.is_parametric() {
                self.note_source_case(span);
            }
        }
        self.note(word);
        self.words.push(word);
    }

    /// Notes what later stages ask of every block.
    #[expect(clippy::inline_always, reason = "a word of four fields, handed over in memory, waits for its stores")]
    #[inline(always)]
    fn note(&mut self, word: Word) {
        if word.address == Address::G && word.is_digits() && self.flags.straight().is_none() {
            let straight = word.g_code().map_or(BlockFlags::default(), BlockFlags::of_straight);
            if straight != BlockFlags::default() {
                self.flags.set(straight);
                return;
            }
        }
        self.flags.set(made_of(word.address));
        if !word.is_plain() {
            self.flags.set(BlockFlags::RICH);
        }
        if !matches!(word.address, Address::G | Address::M) {
            return;
        }
        let Some(number) = word.whole().and_then(|number| u8::try_from(number).ok()) else { return };
        if word.address == Address::M {
            if PROGRAM_ENDS.contains(&number) {
                self.flags.set(BlockFlags::END);
            }
            return;
        }
        self.candidate |= slips::has_other_words(number);
        if number == GCode::G70.number() {
            self.flags.set(BlockFlags::RETURN);
        } else if number == GCode::G79.number() {
            self.flags.set(BlockFlags::ENTRY);
        }
    }

    /// Notes an address in lower case.
    #[inline]
    fn note_case(&mut self, at: u32) {
        if self.text.as_bytes().get(at as usize).is_some_and(u8::is_ascii_lowercase) {
            self.lowercase.push(at);
        }
    }

    /// Notes the `r` of a parameter that is the value of the word at `span`.
    fn note_source_case(&mut self, span: Span) {
        let source = self.text.get(span.range()).and_then(|word| word.rfind(['R', 'r']));
        self.note_case(span.start + small(source.unwrap_or(0)));
    }
}

/// The first run that does not end before `at`.
fn run_at(runs: &[Span], at: u32) -> Option<&Span> {
    runs.get(runs.partition_point(|run| run.end < at))
}

/// Whether neither blanks nor line ends stand in a short text.
fn is_glued(text: &str, from: u32, to: u32) -> bool {
    let between = text.as_bytes().get(from as usize..to as usize).unwrap_or_default();
    between.len() < 16 && !between.iter().any(|byte| byte.is_ascii_whitespace() || *byte == b'"')
}
