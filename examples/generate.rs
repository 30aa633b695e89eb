//! Writes large part programs for measuring and for trying things out.
//!
//! ```text
//! cargo run --release --example generate -- surface > samples/ok/cam-surface.nc
//! cargo run --release --example generate -- cam 1000000 > cam.nc
//! ```
//!
//! Every program is valid and free of warnings for the default dialect. All coordinates are computed in whole
//! micrometres, so that the same command gives the same bytes on every machine.

#![forbid(unsafe_code)]

use std::env;
use std::fmt;
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

/// The text for wrong calls, and for those that ask for help.
const USAGE: &str = "\
Writes part programs for the CNC8x6, CNC8x9 and CNC872 controls to standard output.

Usage: generate KIND [BLOCKS]

Kinds:
  surface       a milled surface of twenty thousand short blocks in G23
  cam BLOCKS    points N X Y Z with three decimals, as CAM systems write them;
                a rapid and a feed block every 50000 blocks
  big           the same with thirty million blocks: a gigabyte
  arcs BLOCKS   every other block an arc G02 or G03 with I and J
  rich BLOCKS   comments, parameters, M functions and many words in a block
  loops         a hundred lines that execute nearly ten million blocks

BLOCKS is the number of blocks of the program, 10 to 99999999;
underscores may group its digits.";

/// The smallest number of blocks that leaves room for the start and the end of a program.
const MIN_BLOCKS: u32 = 10;

/// Blocks of the program that is called big.
const BIG: u32 = 30_000_000;

/// The largest block number that the control knows.
const MAX_BLOCKS: u32 = 99_999_999;

/// A program that can be asked for.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Surface,
    Cam(u32),
    Arcs(u32),
    Rich(u32),
    Loops,
}

/// A length in micrometres that prints as millimetres with three decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mm(i64);

impl fmt::Display for Mm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.0 < 0 { "-" } else { "" };
        let magnitude = self.0.unsigned_abs();
        write!(f, "{sign}{}.{:03}", magnitude / 1000, magnitude % 1000)
    }
}

/// One in the fixed-point numbers of the polynomials below.
const ONE: i64 = 1_000_000;

/// The product of two fixed-point numbers, or a fixed-point part of a length, rounded to the nearest.
fn part(a: i64, b: i64) -> i64 {
    (a * b + ONE / 2).div_euclid(ONE)
}

/// A triangle wave: 0, 1 … `top`, `top` - 1 … 1, 0, 1 …
fn triangle(step: i64, top: i64) -> i64 {
    let phase = step.rem_euclid(2 * top);
    if phase <= top { phase } else { 2 * top - phase }
}

/// Height of the free-form surface, in micrometres, over `u` and `v` from -[`ONE`] to [`ONE`].
fn height(u: i64, v: i64) -> i64 {
    let (u2, v2) = (part(u, u), part(v, v));
    let (u3, uv) = (part(u2, u), part(u, v));
    let (u2v2, uv3) = (part(u2, v2), part(uv, v2));
    -2_500 - part(4_200, u2) + part(1_900, u3) - part(2_800, v2) + part(2_100, uv) - part(1_300, uv3)
        + part(1_600, u2v2)
}

/// A surface of 80 x 50 mm, finished with a ball-nose cutter in rows there and back.
fn surface(out: &mut impl Write) -> io::Result<()> {
    const ROWS: i64 = 100;
    const POINTS: i64 = 200;
    writeln!(out, "%20000 \"TVAROVA PLOCHA 80 x 50, DOKONCENI KULOVOU FREZOU\"")?;
    writeln!(out, "\" Ball-nose cutter D6, rows along X, stepover 0.5 mm, tolerance 0.005\"")?;
    writeln!(out, "\" Nula G54: stred plochy, Z0 = horni hrana polotovaru\"")?;
    writeln!(out, "N1 G54 G17 G90 G94 G40")?;
    writeln!(out, "N2 T6 M06 \"Kulova freza D6\"")?;
    writeln!(out, "N3 S9500 M03")?;
    let mut number = 4;
    for row in 0..ROWS {
        let across = (2 * row - (ROWS - 1)) * ONE / (ROWS - 1);
        let y = Mm(part(24_750, across));
        for point in 0..POINTS {
            let column = if row % 2 == 0 { point } else { POINTS - 1 - point };
            // The points do not lie evenly, as in most programs from CAM systems.
            let even = (2 * column - (POINTS - 1)) * ONE / (POINTS - 1);
            let along = even + part(150_000, part(part(even, even), even) - even);
            let x = Mm(part(40_000, along));
            let z = Mm(height(along, across));
            match (row, point) {
                (0, 0) => {
                    writeln!(out, "N{number} G00 X{x} Y{y}")?;
                    writeln!(out, "N{} Z50.000 M08", number + 1)?;
                    writeln!(out, "N{} Z5.000", number + 2)?;
                    writeln!(out, "N{} G23 I4 G01 Z{z} F600 \"dynamicka sada 4\"", number + 3)?;
                    number += 4;
                    continue;
                }
                (0, 1) => write!(out, "N{number} X{x} Z{z} F2400")?,
                (_, 0) => write!(out, "N{number} X{x} Y{y} Z{z}")?,
                _ => write!(out, "N{number} X{x} Z{z}")?,
            }
            if point == 0 && row % 10 == 0 {
                write!(out, " \"radek {row} ze {ROWS}\"")?;
            }
            writeln!(out)?;
            number += 1;
        }
    }
    writeln!(out, "N{number} G98 G00 Z50.000 M09")?;
    writeln!(out, "N{} X0.000 Y150.000 M05", number + 1)?;
    writeln!(out, "N{} M30", number + 2)?;
    writeln!(out, "*")
}

/// Points of three axes, all words in every block.
pub fn cam(out: &mut impl Write, blocks: u32) -> io::Result<()> {
    writeln!(out, "%1000 \"CAM, {blocks} BLOKU\"")?;
    writeln!(out, "N1 G54 G17 G90 G94 G40 G23 S9900 M03")?;
    for number in 2..=blocks - 2 {
        let step = i64::from(number);
        let row = step / 1000;
        let along = triangle(step, 1000) * 2_000 - ONE;
        let across = triangle(row, 800) * 2_500 - ONE;
        let x = Mm(part(100_000, along));
        let y = Mm(part(80_000, across) + triangle(step, 40) * 5);
        let z = Mm(height(along, across));
        match number % 50_000 {
            2 => writeln!(out, "N{number} G00 X{x} Y{y} Z50.000")?,
            3 => writeln!(out, "N{number} G01 X{x} Y{y} Z{z} F2500")?,
            _ => writeln!(out, "N{number} X{x} Y{y} Z{z}")?,
        }
    }
    writeln!(out, "N{} G98 G00 X0.000 Y0.000 Z50.000 M05", blocks - 1)?;
    writeln!(out, "N{blocks} M30")?;
    writeln!(out, "*")
}

/// The whole-number points of a circle of radius 25, counter-clockwise: arcs between them are exact.
const CIRCLE: [(i64, i64); 20] = [
    (25, 0),
    (24, 7),
    (20, 15),
    (15, 20),
    (7, 24),
    (0, 25),
    (-7, 24),
    (-15, 20),
    (-20, 15),
    (-24, 7),
    (-25, 0),
    (-24, -7),
    (-20, -15),
    (-15, -20),
    (-7, -24),
    (0, -25),
    (7, -24),
    (15, -20),
    (20, -15),
    (24, -7),
];

/// The point of [`CIRCLE`] after `steps` from the first, any number of times round.
fn on_circle(steps: usize) -> (i64, i64) {
    CIRCLE.get(steps % CIRCLE.len()).copied().unwrap_or((25, 0))
}

/// Lines and arcs in turn; radii from 1 to 8.75 mm, now and then a full circle.
pub fn arcs(out: &mut impl Write, blocks: u32) -> io::Result<()> {
    writeln!(out, "%2000 \"OBLOUKY, {blocks} BLOKU\"")?;
    writeln!(out, "N1 G54 G17 G90 G94 G40 S6000 M03")?;
    writeln!(out, "N2 G00 X0.000 Y0.000 Z2.000")?;
    writeln!(out, "N3 G01 Z-1.500 F900")?;
    let mut turn = 0_usize;
    let mut start = (0, 0);
    for number in 4..=blocks - 2 {
        if number % 2 == 0 {
            let step = i64::from(number / 2);
            start = (triangle(step, 400) * 500, triangle(step / 400, 300) * 500);
            writeln!(out, "N{number} G01 X{} Y{}", Mm(start.0), Mm(start.1))?;
            continue;
        }
        turn += 1;
        let scale = 40 + 10 * i64::from(number / 2 % 32);
        let from = turn * 7;
        let sweep = 1 + turn * 3 % CIRCLE.len();
        let clockwise = turn.is_multiple_of(3);
        let to = if clockwise { from + CIRCLE.len() - sweep } else { from + sweep };
        let ((x0, y0), (x1, y1)) = (on_circle(from), on_circle(to));
        writeln!(
            out,
            "N{number} {} X{} Y{} I{} J{}",
            if clockwise { "G02" } else { "G03" },
            Mm(start.0 + scale * (x1 - x0)),
            Mm(start.1 + scale * (y1 - y0)),
            Mm(-scale * x0),
            Mm(-scale * y0),
        )?;
    }
    writeln!(out, "N{} G00 Z50.000 M05", blocks - 1)?;
    writeln!(out, "N{blocks} M30")?;
    writeln!(out, "*")
}

/// Programs as people write them: many kinds of words, comments, parameters.
pub fn rich(out: &mut impl Write, blocks: u32) -> io::Result<()> {
    const KINDS: u32 = 16;
    writeln!(out, "%3000 \"RŮZNÉ BLOKY, {blocks} BLOKŮ\"")?;
    writeln!(out, "N1 G54 G17 G90 G94 G40 G80 M40 M48")?;
    for number in 2..=blocks - 2 {
        let pass = number / KINDS;
        let step = i64::from(pass);
        let x = triangle(step, 700) * 250 + 1_500;
        let y = triangle(step / 7, 400) * 250 - 50_000;
        let (xm, ym) = (Mm(x), Mm(y));
        write!(out, "N{number} ")?;
        match number % KINDS {
            2 => writeln!(out, "G{} G00 X{xm} Y{ym} Z80.000 M53 \"operace {pass}\"", 54 + pass % 4)?,
            3 => writeln!(out, "T{} D{} M06 \"nástroj číslo {0}, korekce v tabulce\"", 1 + pass % 24, 1 + pass % 99)?,
            4 => writeln!(out, "S{} F{} M03 M08 M51 M49 \"otáčky a chlazení\"", 800 + pass % 5000, 200 + pass % 900)?,
            5 => writeln!(out, "R10={xm} R11=-{} R14={} \"parametry\"", Mm(500 + 250 * (step % 20)), 150 + pass % 600)?,
            6 => writeln!(out, "G00 X{} Y{} Z5.000", Mm(x - 10_000), Mm(y - 10_000))?,
            7 => writeln!(out, "G01 Z R11 F R14 \"hloubka z parametru\"")?,
            8 => writeln!(out, "G41 XR10 Y{ym} D{}", 1 + pass % 99)?,
            9 => writeln!(out, "G03 X{} Y{} I0 J5.000", Mm(x + 5_000), Mm(y + 5_000))?,
            10 => writeln!(out, "G01 X{} \"konec oblouku\" Y{} F{}", Mm(x + 5_250), Mm(y + 12_500), 300 + pass % 400)?,
            11 => writeln!(out, "G40 G91 X-2.500 Y1.250 Z.5 \"přírůstek\"")?,
            12 => writeln!(out, "G90 X {xm} Y {ym} H{} P{} M{}", 1 + pass % 99, 1 + pass % 9, 41 + pass % 4)?,
            13 => writeln!(out, "G04 Q{} \"prodleva\"", 5 + pass % 200)?,
            14 => writeln!(out, "/ M01 \"měření\"")?,
            15 => writeln!(out, "R15=R10 R16=-R11 R17=0.125")?,
            0 => writeln!(out, "G00 Z80.000 M09 M52 M48")?,
            _ => writeln!(out, "M05 \"konec operace\"")?,
        }
    }
    writeln!(out, "N{} G90 G40 G00 Z80.000 M05", blocks - 1)?;
    writeln!(out, "N{blocks} M30 \"hotovo\"")?;
    writeln!(out, "*")
}

/// One hundred lines with nested jumps and calls: 9760269 executed blocks.
pub fn loops(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "%4000 \"VNORENE SKOKY A VOLANI\"")?;
    writeln!(out, "\" Kazdy podprogram ma dva skoky v sobe: 2 + 10 x (10 x 5 + 4) = 542 bloku.\"")?;
    writeln!(out, "\" Vnitrni skok hlavniho programu: 20 x (6 x (1 + 5 x 542) + 1) bloku,\"")?;
    writeln!(out, "\" vnejsi tricetkrat; s posuvem rady a skokem dohromady 9760269 bloku.\"")?;
    for line in ["N1 G54 G17 G90 G94 G40", "N2 T5 M06", "N3 S9000 M03", "N4 G00 X0 Y0", "N5 Z2", "N6 G01 Z-1 F1500"] {
        writeln!(out, "{line}")?;
    }
    writeln!(out, "\"--- sest tvaru, kazdy petkrat ---\"")?;
    for shape in 1..=6 {
        writeln!(out, "N{} G71 L{} Q5", 10 * shape, 100 * shape)?;
    }
    for line in ["N70 G73 L10 Q19", "\"--- dalsi rada ---\"", "N80 G91 G01 Y1", "N90 G73 L10 Q29"] {
        writeln!(out, "{line}")?;
    }
    for line in [
        "\"--- konec ---\"",
        "N100 G90 G00 Z50",
        "N110 X0 Y0 M05",
        "N120 M30",
        "\"\"",
        "\" Podprogramy: posuvy jsou prirustkove a jejich soucet je nula.\"",
    ] {
        writeln!(out, "{line}")?;
    }
    for shape in 1..=6_i64 {
        let base = 1000 * shape;
        let side = Mm(100 * shape);
        writeln!(out, "\"--- tvar {shape}: {} ---\"", if shape % 2 == 0 { "kruh" } else { "ctverec" })?;
        writeln!(out, "N{base} G79 L{}", 100 * shape)?;
        if shape % 2 == 0 {
            writeln!(out, "N{} G91 G02 X{side} Y{side} I{side} J0", base + 10)?;
            writeln!(out, "N{} X{side} Y-{side} I0 J-{side}", base + 20)?;
            writeln!(out, "N{} X-{side} Y-{side} I-{side} J0", base + 30)?;
            writeln!(out, "N{} X-{side} Y{side} I0 J{side}", base + 40)?;
        } else {
            writeln!(out, "N{} G91 G01 X{side}", base + 10)?;
            writeln!(out, "N{} Y{side}", base + 20)?;
            writeln!(out, "N{} X-{side}", base + 30)?;
            writeln!(out, "N{} Y-{side}", base + 40)?;
        }
        writeln!(out, "N{} G73 L{} Q9", base + 50, base + 10)?;
        writeln!(out, "N{} G01 X{side} Y0.2", base + 60)?;
        writeln!(out, "N{} X-{side}", base + 70)?;
        writeln!(out, "N{} Y-0.2", base + 80)?;
        writeln!(out, "N{} G73 L{} Q9", base + 90, base + 10)?;
        writeln!(out, "N{} G70", base + 100)?;
    }
    writeln!(out, "*")
}

/// Reads a number of blocks from the command line.
fn block_count(text: &str) -> Result<u32, String> {
    let digits: String = text.chars().filter(|&c| c != '_').collect();
    match digits.parse::<u32>() {
        Ok(count) if (MIN_BLOCKS..=MAX_BLOCKS).contains(&count) => Ok(count),
        _ => Err(format!("BLOCKS must be a whole number from {MIN_BLOCKS} to {MAX_BLOCKS}, not '{text}'")),
    }
}

/// Reads the command line; `None` when help was asked for.
fn arguments(words: &[String]) -> Result<Option<Kind>, String> {
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["-h" | "--help" | "help"] => Ok(None),
        ["surface"] => Ok(Some(Kind::Surface)),
        ["loops"] => Ok(Some(Kind::Loops)),
        ["big"] => Ok(Some(Kind::Cam(BIG))),
        ["cam", count] => Ok(Some(Kind::Cam(block_count(count)?))),
        ["arcs", count] => Ok(Some(Kind::Arcs(block_count(count)?))),
        ["rich", count] => Ok(Some(Kind::Rich(block_count(count)?))),
        [kind @ ("cam" | "arcs" | "rich")] => Err(format!("'{kind}' needs the number of blocks")),
        [kind @ ("surface" | "loops" | "big" | "cam" | "arcs" | "rich"), ..] => {
            Err(format!("too many arguments for '{kind}'"))
        }
        [] => Err("no kind of program given".to_owned()),
        [other, ..] => Err(format!("unknown kind of program '{other}'")),
    }
}

/// Writes the program to standard output.
fn write_program(kind: Kind) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    match kind {
        Kind::Surface => surface(&mut out)?,
        Kind::Cam(blocks) => cam(&mut out, blocks)?,
        Kind::Arcs(blocks) => arcs(&mut out, blocks)?,
        Kind::Rich(blocks) => rich(&mut out, blocks)?,
        Kind::Loops => loops(&mut out)?,
    }
    out.flush()
}

fn main() -> ExitCode {
    let words: Vec<String> = env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let kind = match arguments(&words) {
        Ok(Some(kind)) => kind,
        Ok(None) => {
            return match writeln!(io::stdout(), "{USAGE}") {
                Ok(()) => ExitCode::SUCCESS,
                Err(_) => ExitCode::FAILURE,
            };
        }
        Err(message) => {
            // Nothing can be done about a standard error stream that cannot be written to.
            let _ = writeln!(io::stderr(), "generate: {message}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match write_program(kind) {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read the program has seen enough, as `head` does.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(io::stderr(), "generate: cannot write the program: {error}");
            ExitCode::FAILURE
        }
    }
}
