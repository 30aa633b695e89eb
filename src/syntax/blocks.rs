//! Splits a text into blocks: at every `N` that begins one.

use super::file::{self, Block};
use super::lower::Lowering;
use super::slips::{self, statement_end};
use super::{Form, Kind, Shape, Token, Word, plain, tokens};
use crate::diag::{Diagnostic, Finding, FixTitle};
use crate::dict::Address;
use crate::sure::{Sure, small};
use crate::text::{FileId, Location, Span};

/// Tokens are parsed in batches of about this many, so that they stay in the fastest cache.
const BATCH: usize = 1 << 10;

/// What stands before the first block.
#[derive(Default)]
pub(super) struct Header {
    pub(super) program: Option<Word>,
    pub(super) title: Option<Span>,
    pub(super) outside: Vec<Word>,
}

/// So few bytes behind a `%` may be blank for it to be the end of a file.
const FEW: usize = 256;

/// What a token is for the order of blocks.
enum Role {
    /// It begins a block, in that shape when it is no well-formed block number.
    Block(Option<Shape>),
    /// It stands where the `L` of a target belongs.
    JumpTarget,
    /// The `%` of the program, or of another one.
    Program,
    SecondProgram,
    Other,
}

/// Whether a token is a letter alone.
fn is_bare(bytes: &[u8], token: Token) -> bool {
    token.kind == Kind::Letter && !matches!(bytes.get(token.end as usize - 1), Some(b'+' | b'-'))
}

/// Whether a block number stands right behind G71, G72 or G73 on a line with no other word than Q behind it: in a block
/// without L it is the target.
fn is_jump_target(bytes: &[u8], before: &[Token], token: Token) -> bool {
    let Some(last) = before.last().filter(|last| last.kind == Kind::Word && token.kind == Kind::Word) else {
        return false;
    };
    let word = bytes.get(last.span().range()).sure();
    matches!(word, [b'G' | b'g', b'7', b'1'..=b'3']) && ends_line(bytes.get(token.end as usize..).sure())
}

/// Whether the line ends there, or a comment begins, but for a Q with its digits.
fn ends_line(rest: &[u8]) -> bool {
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    let mut rest = rest.iter().skip_while(|byte| is_blank(byte)).peekable();
    if rest.next_if(|byte| matches!(byte, b'Q' | b'q')).is_some() {
        while rest.next_if(|byte| byte.is_ascii_digit() || is_blank(byte)).is_some() {}
    }
    matches!(rest.next(), None | Some(b'\r' | b'\n' | b'"'))
}

/// The tokens before the first block; behind a `%` with text on its line, or a quote that ends it, all of the line is
/// one token: a title without its quotes.
fn with_whole_title(batch: &[Token], text: &str) -> Vec<Token> {
    let mut tokens = batch.to_vec();
    let is_text = |token: &Token| matches!(token.kind, Kind::Junk(Shape::Text) | Kind::Junk(Shape::Unit));
    let is_percent = |token: &Token| text.as_bytes().get(token.start as usize) == Some(&b'%');
    let Some(from) = tokens.iter().position(is_percent) else { return tokens };
    let ends = |token: &Token| {
        matches!(
            token.kind,
            Kind::LineEnd | Kind::Comment | Kind::Junk(Shape::TypographicComment) | Kind::Junk(Shape::ForeignComment)
        )
    };
    let line = tokens.iter().skip(from).position(ends).map_or(tokens.len(), |length| from + length);
    let quote = tokens.get(line).is_some_and(|end| text.get(end.span().range()).is_some_and(|end| end.trim() == "\""));
    let is_title = quote || tokens.iter().take(line).skip(from).any(is_text);
    let first = from + 1;
    let end = tokens.get(line - 1).map_or(0, |last| last.end);
    if let Some(title) = tokens.get_mut(first).filter(|_| is_title && first < line) {
        *title = Token { kind: Kind::Junk(Shape::Text), end, ..*title };
        tokens.drain(first + 1..line);
    }
    tokens
}

/// Reads one piece of a text.
pub(super) struct Reader<'t> {
    pub(super) lowering: Lowering<'t>,
    pub(super) blocks: Vec<Block>,
    form: Form,
    /// The piece begins the file.
    first: bool,
    /// A `%` was met, or stands in another piece.
    program_seen: bool,
    pub(super) header: Option<Header>,
    /// Where a second `%` with a number begins a line.
    pub(super) second_program: Option<u32>,
    /// Where `*` ends the program, when it stands in this piece.
    pub(super) end: Option<u32>,
    /// Tokens that are being gathered, and where blocks begin among them: kept for their memory.
    batch: Vec<Token>,
    cuts: Vec<usize>,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str, file: FileId, form: Form, first: bool, (from, to): (u32, u32)) -> Self {
        let mut lowering = Lowering::new(text, file);
        lowering.words.reserve((to - from) as usize / 8);
        Self {
            lowering,
            blocks: Vec::new(),
            form,
            first,
            program_seen: !first,
            header: None,
            second_program: None,
            end: None,
            batch: Vec::new(),
            cuts: Vec::new(),
        }
    }

    /// Reads what stands from `start` to `end`.
    pub(super) fn read(&mut self, start: u32, end: u32, short_way: bool) {
        let mut at = start;
        // What stands before the first block goes by tokens.
        if !self.first && short_way {
            at = plain::plain_blocks(&mut self.lowering, &mut self.blocks, at, end);
        }
        loop {
            at = self.read_tokens(at, end, short_way);
            if at >= end {
                return;
            }
            at = plain::plain_blocks(&mut self.lowering, &mut self.blocks, at, end);
        }
    }

    /// Reads tokens from `start` on, to `end` or, when a short way may be taken, to a line where a block begins. Gives
    /// where it stopped.
    fn read_tokens(&mut self, start: u32, end: u32, short_way: bool) -> u32 {
        let text = self.lowering.text;
        let bytes = text.as_bytes().get(..end as usize).sure();
        let mut batch = std::mem::take(&mut self.batch);
        batch.clear();
        let mut cuts = std::mem::take(&mut self.cuts);
        cuts.clear();
        let mut stopped = end;
        let mut taken = start;
        // Of the current block.
        let mut has_l = false;
        for mut token in tokens(text, start, end) {
            if token.start < taken {
                continue;
            }
            if let Some(whole) = statement_end(bytes, token) {
                (token.kind, token.end, taken) = (Kind::Junk(Shape::Text), whole, whole);
            }
            if token.kind == Kind::End {
                self.end = Some(token.end);
                self.lowering.star = Some(token.start);
                break;
            }
            match self.role(bytes, (&batch, &cuts), token, has_l) {
                Role::Block(shape) => {
                    if batch.len() >= BATCH && shape.is_none() {
                        self.parse_batch(&batch, &cuts);
                        batch.clear();
                        cuts.clear();
                    }
                    if shape == Some(Shape::MixedNumber)
                        && let Some(digits) = batch.pop()
                    {
                        token.start = digits.start;
                    }
                    token.kind = shape.map_or(token.kind, Kind::Junk);
                    cuts.push(batch.len());
                    has_l = false;
                }
                Role::JumpTarget => token.kind = Kind::Junk(Shape::JumpTarget),
                Role::SecondProgram => {
                    self.second_program_start(token);
                    // `%N30`: a slip before a block number.
                    let Some([b'%', b'N' | b'n', b'0'..=b'9', ..]) = bytes.get(token.span().range()) else { continue };
                    (token.kind, token.start) = (Kind::Word, token.start + 1);
                    cuts.push(batch.len());
                    has_l = false;
                }
                Role::Program => self.program_seen = true,
                Role::Other => {}
            }
            has_l |= matches!(bytes.get(token.start as usize), Some(b'L' | b'l'));
            batch.push(token);
            if short_way && token.kind == Kind::LineEnd && plain::block_begins(bytes, token.end as usize) {
                stopped = token.end;
                break;
            }
        }
        self.parse_batch(&batch, &cuts);
        (self.batch, self.cuts) = (batch, cuts);
        stopped
    }

    /// What a token is for the order of blocks, behind the tokens of `batch`, whose blocks begin at its cuts.
    fn role(&self, bytes: &[u8], (batch, cuts): (&[Token], &[usize]), token: Token, has_l: bool) -> Role {
        let header = self.first && self.before_blocks(cuts);
        if (self.program_seen || self.form == Form::Macrocycle)
            && let Some(shape) = slips::lost_number(bytes, batch, token)
            && (!header || self.below_program(bytes, batch, token))
        {
            return Role::Block(Some(shape));
        }
        let with_address = matches!(
            token.kind,
            Kind::Word
                | Kind::Letter
                | Kind::Junk(
                    Shape::LooseWord
                        | Shape::ManySigns
                        | Shape::GarbledWord
                        | Shape::AssignedWord
                        | Shape::PrintedWord
                        | Shape::ForeignStart
                )
        );
        // `G7N`: a slip in a word, not the beginning of a block.
        let in_word = |last: &Token| last.kind == Kind::Word && last.end == token.start;
        match bytes.get(token.start as usize).filter(|_| with_address) {
            Some(b'N' | b'n') if !has_l && is_jump_target(bytes, batch, token) => Role::JumpTarget,
            Some(b'N' | b'n') if is_bare(bytes, token) && batch.last().is_some_and(in_word) => Role::Other,
            Some(b'N' | b'n') => Role::Block(slips::mixed_number(bytes, batch, token).then_some(Shape::MixedNumber)),
            Some(b'%') if self.program_seen || (self.form == Form::Macrocycle && !self.before_blocks(cuts)) => {
                Role::SecondProgram
            }
            Some(b'%') => Role::Program,
            _ => Role::Other,
        }
    }

    /// Whether a token before the first block stands below the line of `%`.
    fn below_program(&self, bytes: &[u8], batch: &[Token], token: Token) -> bool {
        let program = batch.iter().find(|token| bytes.get(token.start as usize) == Some(&b'%'));
        program.is_some_and(|program| {
            let between = bytes.get(program.end as usize..token.start as usize).sure();
            between.iter().any(|byte| matches!(byte, b'\n' | b'\r'))
        })
    }

    fn before_blocks(&self, cuts: &[usize]) -> bool {
        cuts.is_empty() && self.blocks.is_empty()
    }

    fn second_program_start(&mut self, token: Token) {
        let before = self.lowering.text.get(..token.start as usize).sure().trim_end_matches([' ', '\t']);
        if token.kind == Kind::Word && before.ends_with(['\n', '\r']) && self.second_program.is_none() {
            self.second_program = Some(token.start);
        }
        let place = Location { file: self.lowering.file, span: token.span() };
        let bare = is_bare(self.lowering.text.as_bytes(), token);
        let mut diagnostic = Diagnostic::new(Finding::SecondProgramStart { bare }, place);
        let rest = self.lowering.text.get(token.end as usize..).sure();
        // Other controls end a file with it.
        let block = matches!(self.lowering.text.as_bytes().get(token.start as usize + 1), Some(b'N' | b'n'));
        if block {
            let percent = Location { span: Span::new(token.start, token.start + 1), ..place };
            diagnostic = diagnostic.with_offer(FixTitle::Delete { text: "%".to_owned() }, percent, "");
        } else if bare && rest.bytes().take(FEW).all(|byte| byte.is_ascii_whitespace()) && rest.len() < FEW {
            diagnostic = diagnostic.with_offer(FixTitle::Delete { text: "%".to_owned() }, place, "");
        }
        self.lowering.findings.add(diagnostic);
    }

    /// Parses the blocks of a batch: each begins at a cut. What stands before the first cut of the file is its header.
    fn parse_batch(&mut self, batch: &[Token], cuts: &[usize]) {
        let first = cuts.first().copied().unwrap_or(batch.len());
        if self.first && self.header.is_none() {
            self.parse_header(batch.get(..first).sure());
        }
        let Self { lowering, blocks, .. } = self;
        blocks.reserve(cuts.len());
        let ends = cuts.iter().skip(1).copied().chain(std::iter::once(batch.len()));
        for (&from, to) in cuts.iter().zip(ends) {
            let first_word = small(lowering.words.len());
            lowering.block(batch.get(from..to).sure());
            blocks.push(Block { first_word, flags: lowering.flags });
        }
    }

    /// The `%` word, the title, and words that belong to no block (BLK-2).
    fn parse_header(&mut self, batch: &[Token]) {
        let mut header = Header::default();
        let text = self.lowering.text;
        self.lowering.block(&with_whole_title(batch, text));
        let file = self.lowering.file;
        let mut after_program = self.form == Form::Macrocycle;
        let mut program_end = 0;
        let words: Vec<Word> = self.lowering.words.drain(..).collect();
        for word in words {
            let span = word.span(text);
            if word.address == Address::Program {
                header.program = Some(word);
                after_program = true;
                program_end = span.end;
                if self.form == Form::Macrocycle {
                    self.report(Location { file, span }, Finding::ProgramStartInMacrocycle {});
                }
            } else if !word.is_faulty() && after_program {
                header.outside.push(word);
            }
        }
        let first = self.lowering.comments.iter().copied().find(|comment| comment.start >= program_end);
        header.title = first.filter(|comment| !file::comment_text(text.get(comment.range()).sure()).is_empty());
        self.header = Some(header);
    }

    fn report(&mut self, at: Location, finding: Finding) {
        self.lowering.findings.add(Diagnostic::new(finding, at));
    }
}
