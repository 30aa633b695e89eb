//! The part of a block that is on its lines: its words, and the comments between them and behind the last one. Where
//! its lines are broken (FMT-3).

use super::{LINE, Style, word};
use crate::syntax::{BlockId, Form, ParsedFile, Word};
use crate::text::Span;

/// What separates words: blanks, tabs, line ends.
pub(super) const BLANK: [char; 4] = [' ', '\t', '\r', '\n'];

/// Every word and comment of a file, in the order of the text.
pub(super) fn items(file: &ParsedFile) -> impl Iterator<Item = Span> + '_ {
    let text = file.source.text();
    let mut words = file.all_words().map(|word| word.span(text)).peekable();
    let mut comments = file.all_comments().iter().copied().peekable();
    std::iter::from_fn(move || match (words.peek(), comments.peek()) {
        (Some(word), Some(comment)) if comment.start < word.start => comments.next(),
        (Some(_), _) => words.next(),
        (None, _) => comments.next(),
    })
}

/// The places of the `N` and the words of a block, each once: a letter that is no address is several words.
pub(super) fn places(file: &ParsedFile, block: BlockId) -> impl Iterator<Item = Span> + '_ {
    let words = file.n_word(block).into_iter().chain(file.words(block).iter().copied());
    let mut before = None;
    let spans = words.map(|word| word.span(file.source.text()));
    spans.filter(move |span| before.replace(span.start) != Some(span.start))
}

/// A word or comment of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// Without the blanks at the end of an open comment.
    pub span: Span,
    /// It is a comment.
    pub comment: bool,
    /// It begins a line of the formatted block.
    pub begins: bool,
    /// A comment that moves to a separate line before its block.
    pub moved: bool,
}

/// What of a block is on its lines; comments on lines of their own behind it are not.
#[derive(Debug, Default)]
pub(super) struct Part {
    /// The `N`, words and comments.
    pub pieces: Vec<Piece>,
    /// How many of the comments before the next block are among them.
    pub comments: usize,
    scratch: String,
}

impl Part {
    /// Reads the part of another block.
    pub(super) fn read(&mut self, file: &ParsedFile, block: BlockId) {
        self.pieces.clear();
        let mut comments = file.comments_behind(block).iter().copied().peekable();
        let mut end = file.n_word(block).map_or(file.start, Word::start);
        for span in places(file, block) {
            while let Some(comment) = comments.next_if(|comment| comment.start < span.start) {
                self.push(file, &mut end, comment, true);
            }
            self.push(file, &mut end, span, false);
        }
        while let Some(comment) = comments.next_if(|comment| line_ends(file, end, comment.start) == 0) {
            self.push(file, &mut end, comment, true);
        }
        self.comments = file.comments_behind(block).len() - comments.count();
    }

    fn push(&mut self, file: &ParsedFile, end: &mut u32, span: Span, comment: bool) {
        let ends = line_ends(file, *end, span.start);
        *end = span.end;
        let span = if comment { without_trailing_blanks(file, span) } else { span };
        self.pieces.push(Piece { span, comment, begins: ends > 0, moved: false });
    }

    /// From its first piece to its last.
    pub(super) fn span(&self) -> Span {
        let start = self.pieces.first().map_or(0, |piece| piece.span.start);
        Span::new(start, self.pieces.last().map_or(start, |piece| piece.span.end))
    }

    /// How far a line is indented that begins with that piece: a comment alone on its line is not.
    pub(super) fn indent(&self, at: usize, style: Style) -> usize {
        let alone = self.pieces.get(at).is_some_and(|piece| piece.comment)
            && self.pieces.get(at + 1).is_none_or(|next| next.begins);
        if alone { 0 } else { usize::from(style.indent) }
    }

    /// Breaks lines that are longer than 80 characters.
    pub(super) fn wrap(&mut self, file: &ParsedFile, block: BlockId, style: Style) {
        let mut width = 0;
        let first = first_comment(file, block);
        for at in 0..self.pieces.len() {
            let Some(&piece) = self.pieces.get(at) else { break };
            let own = self.width(file, piece, style);
            width = match width + 1 + own {
                _ if at == 0 => own,
                _ if piece.begins => self.indent(at, style) + own,
                fits @ ..=LINE => fits,
                _ if piece.comment && first == Some(piece.span.start) => {
                    self.change(at, |piece| piece.moved = true);
                    width
                }
                long => self.break_before(file, at, style).unwrap_or(long),
            };
        }
    }

    /// How many of the formatted lines are longer than 80 characters, and the length of the last one.
    pub(super) fn long_lines(&mut self, file: &ParsedFile, style: Style) -> (usize, usize) {
        let (mut long, mut length) = (0, 0);
        for at in 0..self.pieces.len() {
            let Some(&piece) = self.pieces.get(at).filter(|piece| !piece.moved) else { continue };
            let own = self.width(file, piece, style);
            let before = length;
            length = match at {
                0 => own,
                _ if piece.begins => own + self.indent(at, style),
                _ => before + 1 + own,
            };
            long += usize::from(length > LINE && (before <= LINE || piece.begins));
        }
        (long, length)
    }

    /// Breaks the line before a piece that does not fit on it: a word goes to the next line, a comment or `/` takes the
    /// word before it along, where that helps. The length of the new line.
    fn break_before(&mut self, file: &ParsedFile, at: usize, style: Style) -> Option<usize> {
        let piece = *self.pieces.get(at)?;
        let is_skip = |piece: Piece| file.source.slice(piece.span).starts_with('/');
        let mut length = usize::from(style.indent) + self.width(file, piece, style);
        let mut first = at;
        if piece.comment || is_skip(piece) {
            let stays = |before: &usize| self.pieces.get(*before).is_some_and(|piece| !piece.moved);
            first = (1..at).rev().find(stays)?;
            // A `/` that begins its line reads as that of another block (W0213).
            let takes_along = |piece: &&Piece| !piece.comment && !piece.begins && !is_skip(**piece);
            let word = *self.pieces.get(first).filter(takes_along)?;
            length += 1 + self.width(file, word, style);
        }
        let helps = length <= LINE || first == at;
        self.change(first, |piece| piece.begins |= helps);
        helps.then_some(length)
    }

    fn change(&mut self, at: usize, change: impl FnOnce(&mut Piece)) {
        if let Some(piece) = self.pieces.get_mut(at) {
            change(piece);
        }
    }

    /// How many characters a piece has when it is formatted.
    fn width(&mut self, file: &ParsedFile, piece: Piece, style: Style) -> usize {
        let text = file.source.slice(piece.span);
        if piece.comment && text.is_ascii() || word::is_tidy(text, style) {
            return text.len();
        }
        self.scratch.clear();
        if piece.comment || !word::write(text, style, &mut self.scratch) {
            return text.chars().count();
        }
        self.scratch.len()
    }
}

/// Where the comment begins that may go before its block and stays the same comment of the same block (BLK-9).
fn first_comment(file: &ParsedFile, block: BlockId) -> Option<u32> {
    let first_of_program = block == BlockId(0) && file.form == Form::Program;
    file.comments(block).first().map(|first| first.start).filter(|_| !first_of_program)
}

/// A comment without the blanks at its end, where it is open: those at the end of its line.
pub(super) fn without_trailing_blanks(file: &ParsedFile, comment: Span) -> Span {
    let text = file.source.slice(comment);
    if text.len() > 1 && text.ends_with('"') {
        return comment;
    }
    let blanks = text.len() - text.trim_end_matches([' ', '\t']).len();
    Span::new(comment.start, comment.end - u32::try_from(blanks).unwrap_or(0))
}

/// The part of a block from its first piece to its last.
pub(super) fn extent(file: &ParsedFile, block: BlockId) -> Span {
    let text = file.source.text();
    let n = file.n_word(block).map_or(Span::empty(file.start), |word| word.span(text));
    let mut end = file.words(block).last().map_or(n.end, |word| word.span(text).end);
    for comment in file.comments_behind(block) {
        if comment.start > end && line_ends(file, end, comment.start) > 0 {
            break;
        }
        end = end.max(comment.end);
    }
    Span::new(n.start, end)
}

/// How many lines end between two places.
pub(super) fn line_ends(file: &ParsedFile, from: u32, to: u32) -> usize {
    let text = match file.source.slice(Span::new(from.min(to), to)).as_bytes() {
        b"" | b" " => return 0,
        b"\n" | b"\r\n" => return 1,
        text => text,
    };
    let feeds = text.iter().filter(|byte| **byte == b'\n').count();
    let returns = text.iter().enumerate().filter(|(at, byte)| **byte == b'\r' && text.get(at + 1) != Some(&b'\n'));
    feeds + returns.count()
}
