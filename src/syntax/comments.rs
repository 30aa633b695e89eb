//! Text that is no comment, and comments as other controls write them.

use super::lower::{Lowering, PARAMETERS};
use super::number::Number;
use super::token::METRES_PER_MINUTE;
use super::{BlockFlags, Kind, Token, Word, swallowed, tokens};
use crate::diag::{Certain, Diagnostic, Edit, Finding, FixTitle, Meant, TextMeant, shown};
use crate::dict::Address;
use crate::sure::{Sure, small};
use crate::text::{Location, Span};

impl Lowering<'_> {
    /// Text that is no comment.
    pub(super) fn stray_text(&mut self, span: Span) {
        let text = self.slice(span);
        self.flags.set(BlockFlags::DEBRIS);
        let message =
            text.strip_prefix("MSG").and_then(|rest| rest.trim_start_matches([' ', '\t']).strip_prefix("(\""));
        if let Some(inner) = message.and_then(|rest| rest.strip_suffix("\")")).filter(|inner| !inner.contains('"')) {
            let end = span.end - 2;
            let start = end - small(inner.len());
            let edits = vec![
                Edit { at: self.at(Span::new(span.start, start)), text: "\"".to_owned() },
                Edit { at: self.at(Span::new(end, span.end)), text: "\"".to_owned() },
            ];
            let finding = Finding::StrayText { text: shown(text), meant: TextMeant::Message };
            self.pending.push(Diagnostic::new(finding, self.at(span)).with_offers(FixTitle::Comment, edits));
            return;
        }
        if self.quotes_off.is_some_and(|end| span.start < end) || self.beside_quote(span) {
            return;
        }
        // Words behind it on its line are executed, whatever becomes of the text.
        let behind = swallowed::words_behind(self.text, span.end);
        let words = behind.map(|words| shown(self.slice(words).trim_end()));
        let shown_text = shown(text);
        let statement = TextMeant::statement(text);
        if statement.is_some() {
            self.assigned_in_text(span);
        }
        let finding = if text.is_ascii() || statement.is_some() {
            let meant = statement.unwrap_or_else(|| match (words, behind) {
                (Some(words), Some(behind)) => {
                    let all = shown(self.slice(span.to(behind)).trim_end());
                    TextMeant::WithWords { text: shown_text.clone(), words, all }
                }
                _ => TextMeant::Comment { text: shown_text.clone() },
            });
            if meant == TextMeant::Call {
                self.called_in_text(span);
            } else if meant == TextMeant::End {
                self.push_end(Address::M, span);
            } else if meant == TextMeant::Return {
                self.push_end(Address::G, span);
            }
            Finding::StrayText { text: shown_text, meant }
        } else {
            let meant = words.map_or(Meant::Comment, |words| Meant::CommentBefore { words });
            Finding::UnknownCharacter { text: shown_text, meant }
        };
        self.report(span, finding);
    }

    /// Parameters that a statement sets, `FOR R1=1 TO 5`, are not known afterwards.
    fn assigned_in_text(&mut self, span: Span) {
        let text = self.slice(span);
        for (at, _) in text.match_indices('=') {
            let (before, behind) = text.split_at_checked(at).unwrap_or_default();
            let name = before.trim_end_matches([' ', '\t']);
            let digits = name.len() - name.trim_end_matches(|last: char| last.is_ascii_digit()).len();
            let (letters, number) = name.split_at(name.len() - digits);
            let number = number.parse().ok().filter(|number| *number < PARAMETERS);
            // `==` compares.
            let assigns = letters.ends_with(['R', 'r', '#']) && !behind.starts_with("==");
            if let Some(number) = number.filter(|_| assigns) {
                self.push(Word::bare(Address::R, span).assigning(number).faulty(), span);
            }
        }
    }

    /// A word that cannot be read, and may have been meant as the end (§13).
    fn push_end(&mut self, address: Address, span: Span) {
        self.push_void(address, span);
    }

    /// `CALL L100`: the subprogram is named, and takes no further part.
    fn called_in_text(&mut self, span: Span) {
        let digits =
            self.slice(span).split_once([' ', '\t']).map_or("", |(_, rest)| rest.trim_start_matches([' ', '\t']));
        let digits = digits.strip_prefix(['L', 'l']).unwrap_or_default();
        let count = digits.bytes().take_while(u8::is_ascii_digit).count();
        if let Some(number) = digits.get(..count).and_then(|digits| Number::parse(digits.as_bytes())) {
            self.push(Word::with_number(Address::L, span, number).faulty(), span);
        }
    }

    /// A text beside a quote that is one of an odd number: the quote before it is missing, or one within the comment before.
    fn beside_quote(&mut self, span: Span) -> bool {
        let text = self.slice(span);
        let rest = self.text.get(span.end as usize..).sure();
        let ends = |text: &str| text.is_empty() || text.starts_with(['\r', '\n']);
        let behind = rest.strip_prefix('"');
        let inner = behind.map(|rest| rest.split(['"', '\r', '\n']).next().sure());
        let inner_start = span.end + 1;
        let length = |text: &str| small(text.len());
        let before = self.comments.last().copied().filter(|comment| comment.end == span.start && comment.len() > 2);
        let swallowed = before
            .filter(|comment| self.slice(*comment).ends_with('"'))
            .and_then(|comment| swallowed::words(self.text, Span::new(comment.start + 1, comment.end - 1)));
        let place = self.at(span);
        let (meant, missing) = if let Some(words) = swallowed {
            let words_text = shown(self.slice(words).trim_end());
            (TextMeant::SwallowedBefore { words: words_text }, words.start)
        } else if let Some(inner) = inner
            && (behind.is_some_and(|rest| ends(rest.trim_start_matches([' ', '\t'])))
                || swallowed::words(self.text, Span::new(inner_start, inner_start + length(inner))).is_some())
        {
            // Quotes further on in the line are off by one too.
            self.quotes_off = Some(span.end + length(rest.split(['\r', '\n']).next().sure()));
            (TextMeant::OpenQuote { text: shown(text) }, span.start)
        } else {
            return false;
        };
        let finding = if text.is_ascii() {
            Finding::StrayText { text: shown(text), meant }
        } else {
            let meant = if let TextMeant::SwallowedBefore { words } = meant {
                Meant::SwallowedBefore { words }
            } else {
                Meant::OpenQuote { text: shown(text) }
            };
            Finding::UnknownCharacter { text: shown(text), meant }
        };
        let title = FixTitle::Insert { text: "\"".to_owned() };
        let missing = self.at(Span::empty(missing));
        self.pending.push(Diagnostic::new(finding, place).with_offer(title, missing, "\""));
        true
    }

    /// The name of a unit behind a number: `F300mm/min`.
    pub(super) fn unit(&mut self, token: Token) {
        let (span, place) = (token.span(), self.at(token.span()));
        let text = shown(self.slice(span));
        self.flags.set(BlockFlags::DEBRIS);
        let own = !text.eq_ignore_ascii_case(METRES_PER_MINUTE);
        let meant = if own { TextMeant::Unit } else { TextMeant::OtherUnit };
        let diagnostic = Diagnostic::new(Finding::StrayText { text: text.clone(), meant }, place);
        self.pending.push(if own { diagnostic.with_offer(FixTitle::Delete { text }, place, "") } else { diagnostic });
    }

    /// `Y10;5 F300`, `S12(00`: another sign than a point within a number. Neither the number is known nor what follows.
    fn sign_in_number(&mut self, span: Span, behind: Span) {
        let finding = Finding::UnknownCharacter { text: shown(self.slice(span)), meant: Meant::Number };
        self.report(span, finding);
        if let Some(word) = self.words.last_mut().filter(|word| !word.is_faulty()) {
            *word = Word::bare(word.address, word.span(self.text)).faulty();
        }
        self.void_words(tokens(self.text, behind.start, behind.end).filter(|token| token.kind == Kind::Word));
    }

    /// What the words would set is not known.
    fn void_words(&mut self, words: impl IntoIterator<Item = Token>) {
        for word in words {
            let address = Address::from_byte(self.byte(word.start)).filter(|address| *address != Address::N);
            if let Some(address) = address {
                self.push_void(address, word.span());
            }
        }
    }

    /// A comment as other controls write it: `(text)`, `; text`, `{text}`, `// text`, `# text`.
    pub(super) fn foreign_comment(&mut self, token: Token) {
        let span = token.span();
        let text = self.slice(span);
        let inner = if text.starts_with("//") {
            text.trim_start_matches('/')
        } else {
            text.trim_start_matches(['(', '{', '\'', '`', ';', '#', ','])
        };
        let opening = span.len() - small(inner.len());
        let body = if text.starts_with("''") || text.starts_with(",,") {
            inner.trim_end_matches(['\'', ',', '"'])
        } else {
            let closed = inner.ends_with([')', '}', '\'', '`']) && !text.starts_with([';', '#', '/']);
            inner.get(..inner.len() - usize::from(closed)).sure()
        };
        let blanks = body.len() - body.trim_start_matches([' ', '\t']).len();
        let start = span.start + opening + small(blanks);
        let kept = body.trim_matches([' ', '\t']);
        let end = start + small(kept.len());
        self.flags.set(BlockFlags::DEBRIS);
        let place = self.at(span);
        let edit = |from: u32, to: u32, text: &str| Edit {
            at: Location { span: Span::new(from, to), ..place },
            text: text.to_owned(),
        };
        let quotes = || vec![edit(span.start, start, "\""), edit(end, span.end, "\"")];
        let finding = |meant: Meant| Finding::UnknownCharacter { text: shown(text), meant };
        let words = swallowed::words_between(self.text, Span::new(start, end));
        let is_digit = |at: Option<u32>| at.is_some_and(|at| self.byte(at).is_ascii_digit());
        let numbered = self.words.last().is_some_and(|word| word.address != Address::N);
        if numbered && is_digit(span.start.checked_sub(1)) && is_digit(Some(span.start + opening)) {
            self.sign_in_number(span, Span::new(start, end));
            return;
        }
        let closed = text.ends_with([')', '}', '\'', '`', '"']);
        let swallowed = swallowed::words(self.text, Span::new(start, end)).filter(|_| !closed && words.is_none());
        let diagnostic = if let Some(swallowed) = swallowed {
            let meant = Meant::CommentBefore { words: shown(self.slice(swallowed).trim_end()) };
            Diagnostic::new(finding(meant), place)
        } else if body.trim().is_empty() {
            let title = FixTitle::Delete { text: shown(text) };
            Diagnostic::new(finding(Meant::Comment), place).with_offer(title, place, "")
        } else if words.is_none() && body.contains('"') {
            Diagnostic::new(finding(Meant::Comment), place)
        } else if words.is_none() {
            let certain = text.starts_with(['(', ';']) && swallowed::is_text(self.text, Span::new(start, end));
            let certain = certain.then_some(Certain::Comment);
            Diagnostic::new(finding(Meant::Comment), place).with_edits(certain, FixTitle::Comment, quotes())
        } else {
            // `; Z50`, `(Z50)`: the border of a block on other controls, or a comment. `G7; L100`: a slip.
            self.junk(Span::new(span.start, span.start + opening));
            let apart = kept.replace(';', " ").trim_end().to_owned();
            let meant = Meant::CommentOrWords { words: shown(&apart), comment: shown(&kept.replace('"', "")) };
            let diagnostic = Diagnostic::new(finding(meant), place);
            // Only signs are written: letters of a comment among the words keep their bytes.
            let signs = kept.match_indices(';').map(|(at, _)| start + small(at)).map(|at| edit(at, at + 1, " "));
            let edits = [edit(span.start, start, ""), edit(end, span.end, "")];
            let edits = edits.into_iter().filter(|edit| !edit.at.span.is_empty()).chain(signs).collect();
            let diagnostic = diagnostic.with_offers(FixTitle::Write { text: shown(&apart) }, edits);
            if body.contains('"') { diagnostic } else { diagnostic.with_offers(FixTitle::Comment, quotes()) }
        };
        self.pending.push(diagnostic);
        self.void_words(words.unwrap_or_default());
    }
}

/// Statements of other controls: what follows one on its line belongs to it.
const STATEMENTS: [&str; 41] = [
    "IF", "ELSE", "ELSEIF", "ENDIF", "WHILE", "ENDWHILE", "FOR", "ENDFOR", "LOOP", "ENDLOOP", "REPEAT", "REPEATB",
    "UNTIL", "CASE", "END", "GOTO", "GOTOB", "GOTOF", "GOTOC", "GOTOS", "CALL", "EXTCALL", "PCALL", "MCALL", "RET",
    "TRANS", "ATRANS", "TOOL", "CYCL", "PROC", "DEF", "FN", "LBL", "CC", "STOPRE", "ROT", "AROT", "MIRROR", "AMIRROR",
    "SCALE", "ASCALE",
];
/// A comment has so many bytes at most: a line has 80 characters.
const COMMENT: usize = 240;
/// A remark has a word of so many letters.
const REMARK: usize = 3;

/// Where the text ends that begins with a token: a statement of other controls, such as `IF[#1 GT 5]GOTO 20`, a line of
/// text that begins with signs or a number, such as `--- OBRYS ---`, or a comment without its first quote. It ends before
/// a comment, or with its line.
pub(super) fn statement_end(bytes: &[u8], token: Token) -> Option<u32> {
    if matches!(token.kind, Kind::Word | Kind::LineEnd | Kind::Comment | Kind::TypographicComment | Kind::Skip) {
        return None;
    }
    let rest = bytes.get(token.start as usize..)?;
    if let Some(length) = before_lone_quote(rest, token.kind) {
        return Some(token.start + small(length));
    }
    let begins = rest.first()?.is_ascii_alphabetic();
    let is_text = if begins { is_statement(rest) } else { is_remark(bytes, token) };
    if !is_text && !is_sentence(bytes, token) {
        return None;
    }
    let line = rest.iter().take_while(|byte| !matches!(byte, b'\n' | b'\r' | b'"')).count();
    let text = rest.get(..line)?.trim_ascii_end();
    Some(token.start + small(text.len()))
}

/// How long the text is that begins there and ends with a quote at the end of its line, which nothing opens.
fn before_lone_quote(rest: &[u8], kind: Kind) -> Option<usize> {
    let begins = matches!(
        kind,
        Kind::Text
            | Kind::Letter
            | Kind::SignedLetter
            | Kind::ManySigns
            | Kind::Equals
            | Kind::BareR
            | Kind::Sign
            | Kind::Number
            | Kind::LooseNumber
            | Kind::Unknown
    );
    // The first `%` begins the program, wherever it stands: a quote before it is not read.
    if !begins || rest.starts_with(b"%") {
        return None;
    }
    let length = rest.iter().take(COMMENT).position(|byte| matches!(byte, b'"' | b'\n' | b'\r'))?;
    let (text, quote) = rest.split_at(length);
    let behind = quote.strip_prefix(b"\"")?;
    let ends = matches!(behind.iter().find(|byte| !matches!(byte, b' ' | b'\t')), None | Some(b'\n' | b'\r'));
    (ends && has_words(text)).then_some(length)
}

/// Whether a text has words of a language, of two letters or more, and no block number but at its end.
fn has_words(text: &[u8]) -> bool {
    let is_letter = |byte: &u8| byte.is_ascii_alphabetic() || !byte.is_ascii();
    let (mut rest, mut words) = (text, false);
    while let Some(start) = rest.iter().position(is_letter) {
        rest = rest.get(start..).sure();
        let letters = rest.iter().take_while(|byte| is_letter(byte)).count();
        let (word, behind) = rest.split_at(letters);
        // `N30`; `XR1` is an address with a parameter. `skok na N30` speaks of a block.
        let value = behind.first().is_some_and(u8::is_ascii_digit);
        let ends = behind.iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b' ' | b'\t'));
        if value && matches!(word, [b'N' | b'n']) {
            return words && ends;
        }
        words |= letters > 1 && !(value && matches!(word, [_, b'R' | b'r']));
        rest = behind;
    }
    words
}

/// Whether a statement begins there.
fn is_statement(rest: &[u8]) -> bool {
    let letters = rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let (name, behind) = rest.split_at(letters);
    // `IF=5` is a value with a name.
    let value = behind.trim_ascii_start().first() == Some(&b'=');
    !value && STATEMENTS.iter().any(|statement| statement.as_bytes().eq_ignore_ascii_case(name))
}

/// So many words of a language make a sentence, whatever else is in it.
const SENTENCE: usize = 3;

/// Whether a sentence begins there, with a line or behind a quote: at least three words of more than two letters.
fn is_sentence(bytes: &[u8], token: Token) -> bool {
    let before = bytes.get(..token.start as usize).sure();
    let before = before.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t'));
    let begins = match before {
        None | Some(b'\n' | b'\r') => matches!(token.kind, Kind::Text | Kind::Letter),
        Some(b'"') => matches!(token.kind, Kind::Text | Kind::Letter | Kind::Parameter | Kind::Number),
        Some(_) => false,
    };
    if !begins {
        return false;
    }
    let rest = bytes.get(token.start as usize..).sure();
    let line = rest.iter().take(COMMENT).take_while(|byte| !matches!(byte, b'\n' | b'\r' | b'"')).count();
    let is_word = |word: &&[u8]| {
        let letters = word.iter().take_while(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii()).count();
        letters >= REMARK && word.get(letters).is_none_or(|byte| b",.:;!?".contains(byte))
    };
    rest.get(..line).sure().split(|byte| matches!(byte, b' ' | b'\t')).filter(is_word).count() >= SENTENCE
}

/// Whether a line that begins with signs or a number is text: its first letters are a word of some length.
fn is_remark(bytes: &[u8], token: Token) -> bool {
    let plain = matches!(
        token.kind,
        Kind::Sign | Kind::Equals | Kind::Number | Kind::LooseNumber | Kind::Unknown | Kind::Operator
    );
    let before = bytes.get(..token.start as usize).sure();
    let blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    if !plain || !matches!(before.iter().rev().find(|byte| !blank(byte)), None | Some(b'\n' | b'\r')) {
        return false;
    }
    let rest = bytes.get(token.start as usize..).sure();
    let signs =
        rest.iter().take_while(|byte| byte.is_ascii_digit() || blank(byte) || b"-+=.,)>:!#~_".contains(byte)).count();
    let head = rest.get(..signs).sure();
    let words = rest.get(signs..).sure();
    let letters = words.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let value = words.get(letters).is_some_and(|byte| byte.is_ascii_digit() || b"+-.".contains(byte));
    // `190 KONEC`: the number may be that of a block.
    let numbered = head.trim_ascii_end().iter().all(u8::is_ascii_digit);
    letters >= REMARK && !value && !numbered
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Text that a quote at the end of its line closes. The first `%` begins the program: a quote before it is not read.
    #[test]
    fn comments_without_their_first_quote() {
        let length = |text: &str, kind: Kind| before_lone_quote(text.as_bytes(), kind);
        assert_eq!(length("vyjezd po oblouku\"\nN20", Kind::Text), Some(17));
        assert_eq!(length("3 x 2 mm\" \t\r\n", Kind::Number), Some(8));
        assert_eq!(length("skok vpred na N150\"\n", Kind::Text), Some(18));
        assert_eq!(length("Freza D20, 3 brity\"", Kind::Text), Some(18));
        for text in [
            "% v komentari\"",
            "vyjezd\" N20 X5",
            "vyjezd \"po\" oblouku",
            "vyjezd\npo\"",
            "5\"",
            "A B C\"",
            "XR1 F100 \"",
            "TAB X100 N30 G0\"",
        ] {
            assert_eq!(length(text, Kind::Letter), None, "{text}");
        }
        assert_eq!(length("X5 vyjezd\"", Kind::Word), None);
    }
}
