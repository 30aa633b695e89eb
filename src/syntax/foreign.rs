//! Whether a text is a program for another control, and for which one: by shapes that nobody writes for this one.
//!
//! It is asked only about texts in which something is wrong, and looks at their heads. In a program without findings
//! none of the shapes stands, and a slip in a program for this control is not enough of them.

use std::sync::LazyLock;

use crate::diag::OtherControl;
use crate::sure::{Sure, small};
use crate::text::Span;

/// So many bytes are looked at.
const HEAD: usize = 1 << 15;
/// Longer lines are looked at up to here, blanks not counted.
const LINE: usize = 200;
/// Least weight of all shapes together in a text with block numbers.
const ENOUGH: i32 = 3;
/// Least weight of a control's own shapes before it is named.
const NAMED: i32 = 2;
/// So many lines with words and no block number among them: a program without block numbers.
const UNNUMBERED: usize = 5;

/// Evidence for a control. A row counts once, however often one of its shapes is found.
struct Row {
    speaks_for: Speaks,
    weight: i32,
    /// With blanks between them.
    shapes: &'static str,
}

#[derive(Clone, Copy, PartialEq)]
enum Speaks {
    /// For one of the controls of [`NAMES`].
    For(usize),
    /// For Fanuc or LinuxCNC: what they have in common.
    Iso,
    /// For any other control.
    Any,
    /// For this control: a program with faults in it.
    Own,
}

const FANUC: Speaks = Speaks::For(0);
const LINUXCNC: Speaks = Speaks::For(1);
const SINUMERIK: Speaks = Speaks::For(2);
const HEIDENHAIN: Speaks = Speaks::For(3);
const NAMES: [OtherControl; 4] =
    [OtherControl::Fanuc, OtherControl::LinuxCnc, OtherControl::Sinumerik, OtherControl::Heidenhain];

const fn row(speaks_for: Speaks, weight: i32, shapes: &'static str) -> Row {
    Row { speaks_for, weight, shapes }
}

/// A shape is compared with a line in upper case and without blanks, of whose comments only the first sign is left:
/// `"`, `(` or `;`. In it stand, in lower case, `d` for a digit, `n` for digits, `v` for a number with or without sign
/// and point, `x` for letters, digits, `_` and `-`, `i` for a name of two letters or more, `t` for anything; `|` at its
/// ends for the ends of the line. Block numbers and `/` before the line's words are not looked at, unless the shape
/// begins with `||`. A shape that begins with `(` or `;` is compared with the line's comments too.
const ROWS: &[Row] = &[
    row(FANUC, 2, "||On| ||On(| ||:n| ||:n(|"),
    row(FANUC, 2, "||<x>| ||<x>(|"),
    row(FANUC, 3, "|IF[t]GOTO |IF[t]THEN |WHILE[t]DOd #3000= #3006= DPRNT["),
    row(FANUC, 3, "G65Pddd G66Pddd M98Pddd"),
    row(FANUC, 2, "G71UvRn| G71UvRn. G71UvR. G72WvRn| G72WvRn. G72WvR."),
    row(FANUC, 2, "G70PnQn G71PnQnU G72PnQnU G73PnQnU G76Pddd G75Rn."),
    row(FANUC, 2, "G5.1Q G05.1Q G05Pddd G43.4H G68.2 G54.1P G12.1| G13.1| G50.1 G51.1 G112|"),
    row(FANUC, 1, "G28U0| G28U0. G28U0W G28W0| G28W0. G50S G68X G51X"),
    row(LINUXCNC, 3, "|OnSUB |OnENDSUB |OnCALL |OnIF[ |OnWHILE[ |OnREPEAT[ |OnDO| |O<x>"),
    row(LINUXCNC, 3, "#<x> (MSG, (DEBUG, (PRINT, (LOG, (LOGOPEN, (PROBEOPEN"),
    row(LINUXCNC, 2, "G38.d G33.1 G61.1 G92.1 G92.2 G92.3 G43.1 G43.2 G59.d G28.1 G30.1"),
    row(LINUXCNC, 2, "G5.2 G5.3 G64P"),
    row(LINUXCNC, 2, "@v^v M66PnLn M66En M67En M68En"),
    row(SINUMERIK, 3, "||%_N_ ||%MPFn ||%SPFn ;$PATH= $P_ $AA_ $AC_ $A_ $TC_ $MC_ $MN_"),
    row(SINUMERIK, 3, "CYCLEn( POCKETn( HOLESn( SLOTn( LONGHOLE( WORKPIECE( |MCALL"),
    row(SINUMERIK, 2, "MSG( SETAL( |EXTERNi |PROCi |RET|"),
    row(SINUMERIK, 2, "|DEFREAL |DEFINT |DEFBOOL |DEFSTRING |CASEi |UNTILi |FORi=vTO"),
    row(SINUMERIK, 2, "GOTOFi GOTOBi |ENDIF| |ENDWHILE| |ENDFOR| |ENDLOOP| |LOOP| |REPEAT| |i:"),
    row(SINUMERIK, 2, "|TRAORI |TRAFOOF |TRANSMIT |TRACYL( |ORIWKS SUPAG |STOPRE |SETMS |COMPCAD"),
    row(SINUMERIK, 2, "DIAMON DIAM90 LIMS= SPOS= SPOS[ FGROUP( |FFWON |SOFT |BRISK"),
    row(SINUMERIK, 2, "CR= RND=v CHF=v CHR=v TURN=v AP= RP="),
    row(SINUMERIK, 2, "=IC( =AC( =DC( |CIPX |CTX AR=v"),
    row(SINUMERIK, 2, "|TRANSX |TRANSY |TRANSZ |TRANS| |ATRANS |AROTX |AROTY |AROTZ |ROT| |ROTZ"),
    row(SINUMERIK, 1, "=Rn* =Rn+ =Rn- =Rn/ X= Y= Z= |T= G5dd G33dZ F=R"),
    row(HEIDENHAIN, 3, "|BEGINPGM |ENDPGM |BLKFORM ||%xG71* ||%xG70* Nn%xG71*"),
    row(HEIDENHAIN, 3, "|TOOLCALL |TOOLDEF |CYCLDEF |CYCLCALL |CALLLBL |CALLPGM |TCHPROBE |FNn:"),
    row(HEIDENHAIN, 2, "|LXv |LYv |LZv |LIXv |LIYv |LIZv |LPPR |CCXv |CXvYvDR |CPIPA"),
    row(HEIDENHAIN, 2, "R0FMAX FMAX| |LBLn| DR+| DR-|"),
    row(HEIDENHAIN, 2, "|DnQnPn+ |DnQnPn- |DnPn+"),
    row(Speaks::Iso, 2, "#n #[ X[ Y[ Z[ =["),
    row(Speaks::Iso, 2, "G10L2P G10L1P G10L20P G10L10P G10L11P G10L12P"),
    row(Speaks::Iso, 1, "G43 G44H G49 G20 G21 G99 G91G28 G28G91"),
    row(Speaks::Iso, 1, "(i"),
    row(Speaks::Iso, 1, "||%|"),
    row(Speaks::Iso, 1, "Rn. R.n"),
    row(Speaks::Any, 1, ";i"),
    row(Speaks::Own, 1, "||%n| ||%n\""),
    row(Speaks::Own, 2, "||\" v\""),
    row(Speaks::Own, 3, "G79Ln G71Ln G72Ln G73Ln"),
];

/// A shape, ready to be looked for.
struct Shape {
    row: usize,
    text: &'static [u8],
    /// The bytes that it needs, a bit each: most shapes need one that a line does not have.
    bytes: u128,
}

static SHAPES: LazyLock<Vec<Shape>> = LazyLock::new(|| {
    let literal = |byte: &u8| !byte.is_ascii_lowercase() && *byte != b'|';
    let shape = |row: usize, text: &'static str| Shape {
        row,
        text: text.as_bytes(),
        bytes: text.bytes().filter(literal).fold(0, |bytes, byte| bytes | bit(byte)),
    };
    (0..).zip(ROWS).flat_map(|(at, row)| row.shapes.split(' ').map(move |text| shape(at, text))).collect()
});

const fn bit(byte: u8) -> u128 {
    if byte.is_ascii() { 1 << byte } else { 0 }
}

/// What was recognised.
#[derive(Clone, Debug)]
pub struct Foreign {
    /// The control.
    pub control: OtherControl,
    /// The line that says most.
    pub line: Span,
}

/// The control that the text from `start` on is written for, when that is not this one.
pub fn foreign(text: &str, start: u32) -> Option<Foreign> {
    let (found, lines) = weigh(text, start);
    let rows = || ROWS.iter().zip(&found).filter_map(|(row, line)| Some((row, (*line)?)));
    let weight =
        |whom: Speaks| -> i32 { rows().filter(|(row, _)| row.speaks_for == whom).map(|(row, _)| row.weight).sum() };
    let unnumbered = lines.numbered == 0 && lines.with_words >= UNNUMBERED;
    let controls: [i32; NAMES.len()] = std::array::from_fn(|at| weight(Speaks::For(at)));
    let most = controls.into_iter().max().unwrap_or(0);
    let best = controls.into_iter().position(|weight| weight == most).map_or(Speaks::Iso, Speaks::For);
    // Shapes that Fanuc and LinuxCNC share count for both of them, and not for the others.
    let iso = weight(Speaks::Iso);
    let common = if most == 0 || best == FANUC || best == LINUXCNC { most + iso } else { most.max(iso) };
    let all = common + weight(Speaks::Any) - weight(Speaks::Own);
    // Rows of little weight may be slips, even several of them.
    let clear = rows().any(|(row, _)| row.speaks_for != Speaks::Own && row.weight > 1);
    let told = if unnumbered { all >= -1 } else { all >= ENOUGH && clear };
    if !told {
        return None;
    }
    let alone = controls.into_iter().filter(|weight| *weight == most).count() == 1;
    let control = match best {
        Speaks::For(at) if alone && most >= NAMED => NAMES.get(at)?.clone(),
        Speaks::For(_) | Speaks::Iso | Speaks::Any | Speaks::Own => OtherControl::Iso,
    };
    let line = rows()
        .filter(|(row, _)| row.speaks_for != Speaks::Own)
        .max_by_key(|(row, line)| (row.speaks_for == best, row.weight, std::cmp::Reverse(line.start)))
        .map(|(_, line)| line);
    Some(Foreign { control, line: line.or(lines.first)? })
}

/// Whether anything in the text speaks for another control.
pub fn is_suspicious(text: &str) -> bool {
    let (weights, _) = weigh(text, 0);
    ROWS.iter().zip(weights).any(|(row, found)| row.speaks_for != Speaks::Own && found.is_some())
}

/// What was seen of the lines.
#[derive(Default)]
struct Lines {
    /// With words, and no block number.
    with_words: usize,
    /// With a block number.
    numbered: usize,
    /// The first with words.
    first: Option<Span>,
}

/// For each row the first line in which it is found.
fn weigh(text: &str, start: u32) -> ([Option<Span>; ROWS.len()], Lines) {
    let mut found = [None; ROWS.len()];
    let mut lines = Lines::default();
    let mut line = Line::default();
    let mut at = start as usize;
    let end = text.len().min(at.saturating_add(HEAD));
    let head = text.as_bytes().get(at..end).sure();
    for bytes in head.split_inclusive(|byte| matches!(byte, b'\n' | b'\r')) {
        let trimmed = bytes.trim_ascii();
        let indent = bytes.len() - bytes.trim_ascii_start().len();
        let begin = at + indent;
        at += bytes.len();
        if trimmed.is_empty() {
            continue;
        }
        let span = Span::new(small(begin), small(begin + trimmed.len()));
        line.read(trimmed);
        let words = line.words();
        if matches!(line.code.first(), Some(b'N')) && matches!(line.code.get(1), Some(b'0'..=b'9')) {
            lines.numbered += 1;
        } else if words.split_first().is_some_and(|(first, rest)| first.is_ascii_uppercase() && fits(b"v", rest)) {
            lines.with_words += 1;
            lines.first = lines.first.or(Some(span));
        }
        for shape in SHAPES.iter().filter(|shape| shape.bytes & !line.bytes == 0) {
            if let Some(found) = found.get_mut(shape.row).filter(|found| found.is_none())
                && line.has(shape.text)
            {
                *found = Some(span);
            }
        }
    }
    (found, lines)
}

/// A line in upper case, without blanks.
#[derive(Default)]
struct Line {
    /// Up to its first `"`.
    whole: Vec<u8>,
    /// Of comments, only the sign that begins them.
    code: Vec<u8>,
    /// Where, in `code`, the words behind the block number begin.
    words: usize,
    /// The bytes of `whole`, as in [`Shape::bytes`].
    bytes: u128,
}

impl Line {
    fn read(&mut self, line: &[u8]) {
        self.whole.clear();
        self.code.clear();
        self.bytes = 0;
        let mut depth = 0_u32;
        let mut comment = false;
        for byte in line.iter().filter(|byte| !matches!(byte, b' ' | b'\t')).take(LINE) {
            let byte = byte.to_ascii_uppercase();
            self.whole.push(byte);
            self.bytes |= bit(byte);
            if depth == 0 && !comment {
                self.code.push(byte);
            }
            match byte {
                b'"' if depth == 0 && !comment => break,
                b'(' => depth += 1,
                b')' => depth = depth.saturating_sub(1),
                b';' if depth == 0 => comment = true,
                _ => {}
            }
        }
        let mut at = self.code.iter().take_while(|byte| **byte == b'/').count();
        let numbered = self.code.get(at) == Some(&b'N') && self.code.get(at + 1).is_some_and(u8::is_ascii_digit);
        at += usize::from(numbered);
        let rest = self.code.get(at..).sure();
        at += rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        self.words = at;
    }

    fn words(&self) -> &[u8] {
        self.code.get(self.words..).sure()
    }

    fn has(&self, shape: &[u8]) -> bool {
        match shape {
            [b'|', b'|', shape @ ..] => fits(shape, &self.code),
            [b'|', shape @ ..] => fits(shape, self.words()),
            [b'(' | b';', ..] => anywhere(shape, &self.whole),
            shape => anywhere(shape, &self.code),
        }
    }
}

fn anywhere(shape: &[u8], text: &[u8]) -> bool {
    (0..text.len()).any(|at| text.get(at..).is_some_and(|text| fits(shape, text)))
}

/// Whether `text` begins with `shape`.
fn fits(shape: &[u8], text: &[u8]) -> bool {
    let Some((&first, shape)) = shape.split_first() else { return true };
    let (least, belongs): (usize, fn(&u8) -> bool) = match first {
        b'd' => return text.split_first().is_some_and(|(byte, text)| byte.is_ascii_digit() && fits(shape, text)),
        b'|' => return text.is_empty(),
        b'n' => (1, u8::is_ascii_digit),
        b'v' => (1, |byte| byte.is_ascii_digit() || b"+-.".contains(byte)),
        b'x' => (1, |byte| byte.is_ascii_alphanumeric() || b"_-".contains(byte)),
        b'i' => (2, |byte| byte.is_ascii_alphabetic() || *byte == b'_'),
        b't' => (0, |_| true),
        literal => return text.split_first().is_some_and(|(byte, text)| *byte == literal && fits(shape, text)),
    };
    let most = text.iter().take_while(|byte| belongs(byte)).count();
    (least..=most).any(|count| text.get(count..).is_some_and(|text| fits(shape, text)))
}
