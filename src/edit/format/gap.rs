//! What stands between words and comments, and each of them as it is written: the edits of a file in the order of its
//! text.

use super::block::{BLANK, Part, extent, line_ends, places, without_trailing_blanks};
use super::kept::{Kept, lines_of};
use super::{LINE, Style, word};
use crate::edit::output::Written;
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, Form, ParsedFile, Word};
use crate::text::Span;

/// What separates a word or comment from what stands before it.
#[derive(Clone, Copy, Debug)]
enum Gap {
    /// One blank.
    Blank,
    /// A line end, at most so many empty lines, and an indentation.
    Line { empty: usize, indent: usize },
    /// Nothing: it is the first of the text.
    Nothing,
}

/// The layout of one file.
pub(super) struct Layout<'a> {
    file: &'a ParsedFile,
    kept: &'a Kept,
    style: Style,
    /// The line end that most lines have.
    line_end: &'static str,
    /// Up to where the text has been laid out.
    at: u32,
    /// The line of a place shortly before.
    line: usize,
    part: Part,
    scratch: String,
}

impl<'a> Layout<'a> {
    pub(super) fn new(file: &'a ParsedFile, kept: &'a Kept, style: Style) -> Self {
        let line_end = usual_line_end(file.source.text());
        Self { file, kept, style, line_end, at: file.start, line: 0, part: Part::default(), scratch: String::new() }
    }

    /// Writes the edits.
    pub(super) fn write(mut self, write: &mut dyn FnMut(Written<'_>)) {
        self.header(write);
        for block in self.file.block_ids() {
            self.block(block, write);
        }
        self.end(write);
    }

    /// What stands before the first block.
    fn header(&mut self, write: &mut dyn FnMut(Written<'_>)) {
        let mut first = true;
        for (span, _) in header(self.file) {
            let gap = self.apart(span, first);
            let stays = self.stays(span.start);
            self.lay(span, gap, stays, None, write);
            first = false;
        }
    }

    /// A block, and the comments on lines of their own behind it.
    fn block(&mut self, block: BlockId, write: &mut dyn FnMut(Written<'_>)) {
        if let Some(end) = self.end_of_tidy(block) {
            self.at = end;
            return;
        }
        if self.bare_block(block, write) {
            return;
        }
        let mut part = std::mem::take(&mut self.part);
        part.read(self.file, block);
        let stays = self.stays(part.span().start);
        if !stays && self.may_be_long(part.span(), part.pieces.len()) {
            part.wrap(self.file, block, self.style);
        }
        let mut moved = part.pieces.iter().find(|piece| piece.moved).map(|piece| piece.span);
        let first_item = self.at == self.file.start && self.file.form == Form::Macrocycle;
        for (at, piece) in part.pieces.iter().enumerate() {
            let gap = match at {
                0 if first_item => Gap::Nothing,
                0 => Gap::Line { empty: self.empty_lines(block), indent: 0 },
                _ if piece.begins => {
                    Gap::Line { empty: self.empty_lines(block.next()), indent: part.indent(at, self.style) }
                }
                _ => Gap::Blank,
            };
            if piece.moved {
                write(Written { span: Span::new(self.at, piece.span.end), before: "", copied: None, after: "" });
                self.at = piece.span.end;
            } else {
                self.lay(piece.span, gap, stays, moved.take(), write);
            }
        }
        let comments = self.file.comments_behind(block);
        for comment in comments.get(part.comments..).sure() {
            let span = without_trailing_blanks(self.file, *comment);
            let gap = self.apart(span, false);
            let stays = self.stays(span.start);
            self.lay(span, gap, stays, None, write);
        }
        self.part = part;
    }

    /// Where a block ends that is a whole line as it is to be, by a quick look: many that are get `None`.
    fn end_of_tidy(&self, block: BlockId) -> Option<u32> {
        let start = self.file.n_word(block)?.start();
        let next = self.file.n_word(block.next())?.start();
        let before = self.file.source.slice(Span::new(self.at.min(start), start));
        let line = self.file.source.slice(Span::new(start, next)).strip_suffix(self.line_end)?;
        let is_so = before == self.line_end
            && line.len() <= LINE
            && line.split(' ').all(|word| word::is_tidy(word, self.style));
        is_so.then(|| start + small(line.len()))
    }

    /// A block without comments whose words are on one line, and that fits on one however it is formatted; `false`, and
    /// nothing is written, for others.
    fn bare_block(&mut self, block: BlockId, write: &mut dyn FnMut(Written<'_>)) -> bool {
        let file = self.file;
        let (Some(n), Some(next)) = (file.n_word(block), file.n_word(block.next())) else { return false };
        let (text, words) = (file.source.text(), file.words(block));
        let span = Span::new(n.start(), words.last().unwrap_or(&n).span(text).end);
        let bare = self.at > file.start
            && !self.stays(n.start())
            && !self.may_be_long(span, 1 + words.len())
            && memchr::memchr2(b'\n', b'\r', file.source.slice(span).as_bytes()).is_none()
            && memchr::memchr(b'"', file.source.slice(Span::new(n.start(), next.start())).as_bytes()).is_none();
        if bare {
            let mut gap = Gap::Line { empty: self.empty_lines(block), indent: 0 };
            for span in places(file, block) {
                self.lay(span, gap, false, None, write);
                gap = Gap::Blank;
            }
        }
        bare
    }

    /// The gap before something that keeps its line.
    fn apart(&self, span: Span, first: bool) -> Gap {
        match line_ends(self.file, self.at, span.start) {
            _ if first => Gap::Nothing,
            0 => Gap::Blank,
            _ => Gap::Line { empty: self.empty_lines_before(span.start), indent: 0 },
        }
    }

    /// How many empty lines may stand before a block: none before the first of a macrocycle (FMT-4).
    fn empty_lines(&self, block: BlockId) -> usize {
        let first = self.file.form == Form::Macrocycle && block == BlockId(0);
        if first { 0 } else { usize::from(self.style.blank_lines) }
    }

    fn empty_lines_before(&self, at: u32) -> usize {
        let first = self.file.n_word(BlockId(0)).is_none_or(|n| at < n.start());
        self.empty_lines(BlockId(u32::from(!first)))
    }

    /// Whether a line of the block may be longer than 80 characters when it is formatted: each piece grows by a blank
    /// and a digit at most, and by its indentation.
    fn may_be_long(&self, span: Span, pieces: usize) -> bool {
        span.len() as usize + pieces * 2 + usize::from(self.style.indent) > LINE
    }

    /// Whether all up to the next block fits on one line, however it is formatted.
    fn is_short(&self, block: BlockId) -> bool {
        let start = |block| self.file.n_word(block).map(Word::start);
        let (Some(start), Some(next)) = (start(block), start(block.next())) else { return false };
        let span = Span::new(start, next);
        // Each comment has a quote.
        let comments = memchr::memchr_iter(b'"', self.file.source.slice(span).as_bytes()).count();
        !self.may_be_long(span, 1 + self.file.words(block).len() + comments)
    }

    /// Whether the line at a place stays as it is: with one line of a block all of them do.
    fn stays(&mut self, at: u32) -> bool {
        self.kept.has(self.file, at, &mut self.line)
    }

    /// The end of the text: a blank before `*`, a line end behind all else.
    fn end(mut self, write: &mut dyn FnMut(Written<'_>)) {
        let rest = Span::new(self.at, self.file.end.max(self.at));
        let text = self.file.source.slice(rest);
        let some = self.at > self.file.start;
        if let Some(before) = text.strip_suffix('*') {
            if before.trim_matches(BLANK).is_empty() && some {
                let star = Span::new(rest.end - 1, rest.end);
                // A blank that would make the line too long is left out.
                let room = |layout: &mut Self| layout.last_length() + 1 + layout.tail().unwrap_or(0) <= LINE;
                let long = is_long(self.file, self.file.source.lines().line_at(star.start));
                if !before.is_empty() || long || room(&mut self) {
                    let gap = self.apart(star, false);
                    let stays = self.stays(star.start);
                    self.lay(star, gap, stays, None, write);
                }
            }
        } else if some && text.trim_matches(BLANK).is_empty() && self.file.end == self.file.source.len() {
            let stays = self.stays(self.at.saturating_sub(1));
            let trail = if stays { first_line(text) } else { "" };
            let ended = trail.ends_with(['\n', '\r']);
            let (before, after) = (trail.to_owned(), if ended { "" } else { self.line_end });
            if text != format!("{before}{after}") {
                write(Written { span: rest, before: &before, copied: None, after });
            }
        }
    }

    /// Lays out one word or comment with the gap before it. A comment that moves to the line before it is `moved`.
    fn lay(&mut self, span: Span, gap: Gap, stays: bool, moved: Option<Span>, write: &mut dyn FnMut(Written<'_>)) {
        self.gap(span.start, gap, stays, moved, write);
        self.at = span.end;
        let text = self.file.source.slice(span);
        if stays || text.starts_with('"') || word::is_tidy(text, self.style) {
            return;
        }
        self.scratch.clear();
        if word::write(text, self.style, &mut self.scratch) && self.scratch != text {
            write(Written { span, before: &self.scratch, copied: None, after: "" });
        }
    }

    fn gap(&mut self, to: u32, gap: Gap, stays: bool, moved: Option<Span>, write: &mut dyn FnMut(Written<'_>)) {
        let whole = Span::new(self.at.min(to), to);
        // Behind characters that are no word.
        let from = whole.start + small(self.file.source.slice(whole).trim_end_matches(BLANK).len());
        if from > whole.start && moved.is_none() {
            return;
        }
        let span = Span::new(from, to);
        let text = self.file.source.slice(span);
        let is_so = match gap {
            Gap::Blank => text == " ",
            Gap::Line { indent, .. } => indent == 0 && text == self.line_end,
            Gap::Nothing => text.is_empty(),
        };
        if is_so && moved.is_none() {
            return;
        }
        let ends = line_ends(self.file, span.start, span.end);
        if stays && ends == 0 {
            return;
        }
        if ends == 0 && moved.is_none() && matches!(gap, Gap::Blank) {
            write(Written { span, before: " ", copied: None, after: "" });
            return;
        }
        let before_stays = span.start > self.file.start && self.stays(span.start - 1);
        let mut new = String::new();
        match gap {
            Gap::Nothing => {}
            Gap::Blank => new.push(' '),
            Gap::Line { empty, .. } => {
                new.push_str(if before_stays { first_line(text) } else { "" });
                let ended = usize::from(new.ends_with(['\n', '\r']));
                for _ in ended..=ends.saturating_sub(1).min(empty) {
                    new.push_str(self.line_end);
                }
            }
        }
        let indent = match gap {
            _ if stays => text.rsplit(['\n', '\r']).next().sure().to_owned(),
            Gap::Line { indent, .. } => " ".repeat(indent),
            Gap::Blank | Gap::Nothing => String::new(),
        };
        let after = if moved.is_some() { format!("{}{indent}", self.line_end) } else { indent };
        if moved.is_some() || text.strip_prefix(new.as_str()) != Some(after.as_str()) {
            write(Written { span, before: &new, copied: moved, after: &after });
        }
    }

    /// The lines of what would get longer than 80 characters and is not: they stay.
    pub(super) fn grown(mut self) -> Vec<usize> {
        let mut grown = Vec::new();
        let mut rows = Rows::default();
        for (span, comment) in header(self.file) {
            rows.add(self.file, self.style, span, comment, &mut grown);
        }
        for block in self.file.block_ids() {
            if self.is_short(block) {
                continue;
            }
            let comments = self.file.comments_behind(block);
            let span = extent(self.file, block);
            let pieces = 1 + self.file.words(block).len() + comments.len();
            if self.may_be_long(span, pieces) && !self.stays(span.start) {
                self.part.read(self.file, block);
                self.part.wrap(self.file, block, self.style);
                let (long, _) = self.part.long_lines(self.file, self.style);
                let lines = lines_of(self.file, span);
                if long > 0 && long > lines.clone().filter(|line| is_long(self.file, *line)).count() {
                    grown.extend(lines);
                }
            }
            let mut rows = Rows::default();
            for comment in comments.iter().filter(|comment| comment.start >= span.end) {
                rows.add(self.file, self.style, without_trailing_blanks(self.file, *comment), true, &mut grown);
            }
        }
        if self.tail().is_some_and(|tail| self.last_length() + tail > LINE) {
            let line = self.file.source.lines().line_at(self.file.end);
            grown.extend((!is_long(self.file, line)).then_some(line));
        }
        grown.retain(|line| !self.kept.line(*line));
        grown
    }

    /// The length of what stays behind the last word or comment on its line: `*` with the text behind it, and a blank
    /// before it where there is some. `None` without, or where `*` has another line.
    fn tail(&self) -> Option<usize> {
        let source = &self.file.source;
        let star =
            self.file.end.checked_sub(1).filter(|at| source.text().as_bytes().get(*at as usize) == Some(&b'*'))?;
        let line = source.line_span(source.lines().line_at(star));
        let before = source.slice(Span::new(line.start, star));
        let blank = before.ends_with([' ', '\t']);
        let behind = source.slice(Span::new(star, line.end)).chars().count();
        (!before.trim_matches(BLANK).is_empty()).then_some(behind + usize::from(blank))
    }

    /// The length of the last line of words and comments when it is formatted.
    fn last_length(&mut self) -> usize {
        let (file, style, mut rows) = (self.file, self.style, Rows::default());
        let Some(last) = file.block_ids().next_back() else {
            header(file).for_each(|(span, comment)| rows.add(file, style, span, comment, &mut Vec::new()));
            return rows.length;
        };
        self.part.read(file, last);
        self.part.wrap(file, last, style);
        let comments = file.comments_behind(last).get(self.part.comments..).sure();
        for comment in comments {
            rows.add(file, style, without_trailing_blanks(file, *comment), true, &mut Vec::new());
        }
        if comments.is_empty() { self.part.long_lines(file, style).1 } else { rows.length }
    }
}

/// The length of a line of comments as it grows.
#[derive(Default)]
struct Rows {
    end: u32,
    length: usize,
    /// The line in the text of what came last, and whether it is long there: it may hold very many comments.
    before: Option<(usize, bool)>,
}

impl Rows {
    fn add(&mut self, file: &ParsedFile, style: Style, span: Span, comment: bool, grown: &mut Vec<usize>) {
        let text = file.source.slice(span);
        let mut written = String::new();
        let own = if !comment && word::write(text, style, &mut written) { written.len() } else { text.chars().count() };
        let same = self.end > 0 && line_ends(file, self.end, span.start) == 0;
        self.length = if same { self.length + 1 + own } else { own };
        self.end = span.end;
        let line = file.source.lines().line_at(span.start);
        if self.length > LINE {
            let known = self.before.filter(|(before, _)| *before == line).map(|(_, is_long)| is_long);
            let is_long = known.unwrap_or_else(|| is_long(file, line));
            self.before = Some((line, is_long));
            grown.extend((!is_long).then_some(line));
        }
    }
}

/// The words and comments before the first block, and whether it is a comment.
fn header(file: &ParsedFile) -> impl Iterator<Item = (Span, bool)> + '_ {
    let first = file.n_word(BlockId(0)).map_or(u32::MAX, Word::start);
    super::block::items(file).take_while(move |span| span.start < first).map(|span| {
        let comment = file.source.slice(span).starts_with('"');
        (if comment { without_trailing_blanks(file, span) } else { span }, comment)
    })
}

fn is_long(file: &ParsedFile, line: usize) -> bool {
    let span = file.source.line_span(line);
    span.len() as usize > LINE && file.source.slice(span).chars().count() > LINE
}

/// Up to the first line end, with it.
fn first_line(text: &str) -> &str {
    let Some(at) = text.find(['\n', '\r']) else { return text };
    let length = if text.get(at..).sure().starts_with("\r\n") { 2 } else { 1 };
    text.get(..at + length).sure()
}

/// The line end that most lines have; CR LF where none is most.
fn usual_line_end(text: &str) -> &'static str {
    let bytes = text.as_bytes();
    let (mut both, mut feeds, mut returns) = (0_usize, 0_usize, 0_usize);
    let mut before = None;
    for at in memchr::memchr2_iter(b'\n', b'\r', bytes) {
        match bytes.get(at) {
            Some(b'\n') if before == at.checked_sub(1) && before.is_some() => (both, returns) = (both + 1, returns - 1),
            Some(b'\n') => feeds += 1,
            _ => returns += 1,
        }
        before = (bytes.get(at) == Some(&b'\r')).then_some(at);
    }
    match both.max(feeds).max(returns) {
        most if most == both => "\r\n",
        most if most == feeds => "\n",
        _ => "\r",
    }
}
