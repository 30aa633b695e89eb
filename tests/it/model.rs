//! Valid programs built from a model, and what they must do by an interpreter of the model that knows nothing of the
//! compiler: the order of blocks, the calls, the counters, the positions and the lengths.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use proptest::prelude::*;

/// A length in thousandths of a millimetre.
type Thousandths = i64;

/// An axis of the model: X, Y, Z.
type Axis = usize;

pub const LETTERS: [char; 3] = ['X', 'Y', 'Z'];

/// More executed blocks than this are not looked at.
const LONGEST: usize = 1500;

#[derive(Clone, Debug)]
pub enum Motion {
    None,
    /// G00 or G01, G90 or G91.
    Straight {
        rapid: bool,
        absolute: bool,
        words: BTreeMap<Axis, Thousandths>,
    },
    /// In G91 about a centre at a distance from the start, by quarters counter-clockwise from `axes.0` to `axes.1`.
    Arc {
        axes: (Axis, Axis),
        center: (Thousandths, Thousandths),
        quarters: u8,
        clockwise: bool,
    },
}

#[derive(Clone, Debug)]
pub enum Flow {
    None,
    /// A subprogram by index, with its Q.
    Call {
        to: usize,
        times: Option<u32>,
    },
    /// To a block of the unit by index, with its Q.
    Jump {
        to: usize,
        times: Option<u32>,
    },
}

#[derive(Clone, Debug)]
pub struct Block {
    pub motion: Motion,
    pub flow: Flow,
    pub skip: bool,
    /// M03, M04 or M05.
    pub spindle: Option<u8>,
    pub speed: Option<u32>,
    pub comment: bool,
    /// Chooses how the words are written.
    pub style: u8,
}

#[derive(Clone, Debug)]
pub struct Program {
    /// The main program, then the subprograms.
    pub units: Vec<Vec<Block>>,
    pub block_skip: bool,
    pub end: u8,
}

/// What one executed block must show in its record.
#[derive(Clone, Debug)]
pub struct Executed {
    pub n: u32,
    /// L, pass and number of passes of each open call.
    pub calls: Vec<(u32, u32, u32)>,
    /// Target and what is left of the counter.
    pub jump: Option<(u32, Option<u32>)>,
    pub position: [Thousandths; 3],
    pub length_mm: Option<f64>,
    pub sweep_deg: Option<f64>,
    pub spindle: u8,
    pub speed: Option<u32>,
}

/// Block number: of the entry or header, of block `index`, of the end.
pub fn number(unit: usize, index: usize) -> u32 {
    u32::try_from(1000 * unit + 10 * (index + 2)).unwrap()
}

pub fn first_number(unit: usize) -> u32 {
    u32::try_from(1000 * unit + 10).unwrap()
}

pub fn last_number(unit: usize) -> u32 {
    u32::try_from(1000 * unit + 999).unwrap()
}

/// The L of a subprogram.
pub fn l_of(unit: usize) -> u32 {
    u32::try_from(100 * unit).unwrap()
}

pub fn shown(value: Thousandths) -> String {
    let (whole, part) = (value.unsigned_abs() / 1000, value.unsigned_abs() % 1000);
    let sign = if value < 0 { "-" } else { "" };
    let text = if part == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part:03}") };
    if text.contains('.') { text.trim_end_matches('0').to_owned() } else { text }
}

impl Block {
    fn words(&self, unit: usize) -> Vec<String> {
        let mut words = Vec::new();
        match &self.motion {
            Motion::None => {}
            Motion::Straight { rapid, absolute, words: axes } => {
                words.push(if *rapid { "G0" } else { "G01" }.to_owned());
                words.push(if *absolute { "G90" } else { "G91" }.to_owned());
                words.extend(axes.iter().map(|(&axis, &value)| format!("{}{}", LETTERS[axis], shown(value))));
            }
            Motion::Arc { axes, center, clockwise, .. } => {
                let end = self.arc_end();
                words.push(if *clockwise { "G2" } else { "G03" }.to_owned());
                words.push("G91".to_owned());
                words.push(format!("{}{}", LETTERS[axes.0], shown(end.0)));
                words.push(format!("{}{}", LETTERS[axes.1], shown(end.1)));
                words.push(format!("I{}", shown(center.0)));
                words.push(format!("J{}", shown(center.1)));
            }
        }
        match &self.flow {
            Flow::None => {}
            Flow::Call { to, times } => words.push(format!("G71 L{}{}", l_of(*to), repeats(*times))),
            Flow::Jump { to, times } => words.push(format!("G73 L{}{}", number(unit, *to), repeats(*times))),
        }
        words.extend(self.spindle.map(|m| format!("M{m:02}")));
        words.extend(self.speed.map(|s| format!("S{s}")));
        if self.style & 1 != 0 {
            words.reverse();
        }
        if self.skip {
            words.insert(0, "/".to_owned());
        }
        words
    }

    /// The end of an arc from its start: the vector from the centre to the start, turned by quarters.
    fn arc_end(&self) -> (Thousandths, Thousandths) {
        let Motion::Arc { center, quarters, .. } = &self.motion else { return (0, 0) };
        let (mut a, mut b) = (-center.0, -center.1);
        for _ in 0..*quarters {
            (a, b) = (-b, a);
        }
        (center.0 + a, center.1 + b)
    }

    fn text(&self, unit: usize, index: usize) -> String {
        let zeros = if self.style & 2 != 0 { "00" } else { "" };
        let gap = [" ", "", "\t", "\n  "][usize::from(self.style >> 2) % 4];
        let mut text = format!("N{zeros}{} {}", number(unit, index), self.words(unit).join(gap));
        if self.comment || (self.words(unit).is_empty()) {
            // On a separate line where the other would be too long (LEX-7).
            let line = text.lines().last().map_or(0, str::len);
            text += if line > 70 { "\n\"poznamka" } else { " \"poznamka" };
        }
        // Some blocks share a line; not where a `/` would stand before an `N` (BLK-6).
        text += if self.style & 16 != 0 && !text.contains('"') && !text.ends_with('/') { " " } else { "\n" };
        text
    }
}

/// Blocks as a text; those that would make a line too long begin a new one (LEX-7).
pub fn joined(blocks: &[String]) -> String {
    let mut text = String::new();
    for block in blocks {
        let line = text.len() - text.rfind('\n').map_or(0, |end| end + 1);
        if line + block.lines().next().map_or(0, str::len) > 78 {
            text.push('\n');
        }
        text += block;
    }
    text
}

fn repeats(times: Option<u32>) -> String {
    times.map(|times| format!(" Q{times}")).unwrap_or_default()
}

impl Program {
    /// The program as text, block by block, with its number and its end.
    pub fn blocks(&self) -> Vec<String> {
        let mut blocks = vec!["%1 \"MODEL\"\n".to_owned()];
        for (unit, steps) in self.units.iter().enumerate() {
            let n = first_number(unit);
            blocks.push(match unit {
                0 => format!("N{n} G90 G0 X0 Y0 Z0 F500 S500\n"),
                _ => format!("\nN{n} G79 L{}\n", l_of(unit)),
            });
            blocks.extend(steps.iter().enumerate().map(|(index, step)| step.text(unit, index)));
            let n = last_number(unit);
            blocks.push(match unit {
                0 => format!("\nN{n} M{:02}", self.end),
                _ => format!("\nN{n} G70"),
            });
        }
        blocks
    }

    pub fn text(&self) -> String {
        joined(&self.blocks())
    }

    /// The effect of the program; `None` when it is too long.
    pub fn execute(&self) -> Option<Vec<Executed>> {
        let mut interpreter = Interpreter {
            program: self,
            trace: Vec::new(),
            position: [0; 3],
            spindle: 5,
            speed: Some(500),
            calls: Vec::new(),
        };
        interpreter.unit(0)?;
        Some(interpreter.trace)
    }
}

struct Interpreter<'a> {
    program: &'a Program,
    trace: Vec<Executed>,
    position: [Thousandths; 3],
    spindle: u8,
    speed: Option<u32>,
    calls: Vec<(u32, u32, u32)>,
}

impl Interpreter<'_> {
    fn push(&mut self, n: u32) -> Option<&mut Executed> {
        if self.trace.len() == LONGEST {
            return None;
        }
        self.trace.push(Executed {
            n,
            calls: self.calls.clone(),
            jump: None,
            position: self.position,
            length_mm: None,
            sweep_deg: None,
            spindle: self.spindle,
            speed: self.speed,
        });
        self.trace.last_mut()
    }

    /// FLW-1…FLW-4 by the letter.
    fn unit(&mut self, unit: usize) -> Option<()> {
        self.push(first_number(unit))?;
        let program = self.program;
        let steps = &program.units[unit];
        let mut counters: BTreeMap<usize, u32> = BTreeMap::new();
        let mut at = 0;
        while at < steps.len() {
            let step = &steps[at];
            let here = at;
            at += 1;
            if step.skip && program.block_skip {
                continue;
            }
            self.spindle = step.spindle.unwrap_or(self.spindle);
            self.speed = step.speed.or(self.speed);
            let (length_mm, sweep_deg) = self.motion(step);
            let executed = self.push(number(unit, here))?;
            (executed.length_mm, executed.sweep_deg) = (length_mm, sweep_deg);
            match step.flow {
                Flow::None => {}
                Flow::Jump { to, times } => {
                    let forward = to > here;
                    let left = if forward && times.is_none() {
                        None
                    } else {
                        let counter = counters.entry(here).or_insert(times.unwrap_or(1));
                        if *counter == 0 {
                            counters.remove(&here);
                            continue;
                        }
                        *counter -= 1;
                        Some(*counter)
                    };
                    executed.jump = Some((number(unit, to), left));
                    at = to;
                }
                Flow::Call { to, times } => {
                    let of = times.unwrap_or(1);
                    for pass in 1..=of {
                        self.calls.push((l_of(to), pass, of));
                        self.unit(to)?;
                        self.calls.pop();
                    }
                }
            }
        }
        self.push(last_number(unit))?;
        if unit == 0 {
            // MFN-7
            self.trace.last_mut()?.spindle = 5;
        }
        Some(())
    }

    fn motion(&mut self, step: &Block) -> (Option<f64>, Option<f64>) {
        match &step.motion {
            Motion::None => (None, None),
            Motion::Straight { absolute, words, .. } => {
                let before = self.position;
                for (&axis, &value) in words {
                    self.position[axis] = if *absolute { value } else { self.position[axis] + value };
                }
                let square = |axis: Axis| ((self.position[axis] - before[axis]) as f64).powi(2);
                (Some((square(0) + square(1) + square(2)).sqrt() / 1000.0), None)
            }
            Motion::Arc { axes, center, quarters, clockwise } => {
                let end = step.arc_end();
                self.position[axes.0] += end.0;
                self.position[axes.1] += end.1;
                // The planes are named XY, YZ, ZX: from X to Z is backwards (MOT-5).
                let turned = f64::from(*quarters % 4) * 90.0;
                let counter_clockwise = *axes != (0, 2);
                let sweep = if counter_clockwise != *clockwise { turned } else { 360.0 - turned };
                let sweep = if turned == 0.0 { 360.0 } else { sweep };
                let radius = ((center.0.pow(2) + center.1.pow(2)) as f64).sqrt() / 1000.0;
                (Some(radius * sweep.to_radians()), Some(sweep))
            }
        }
    }
}

fn coordinate() -> impl Strategy<Value = Thousandths> {
    prop_oneof![-60_000..60_000_i64, (-60..60_i64).prop_map(|whole| whole * 1000), Just(0)]
}

fn motion() -> impl Strategy<Value = Motion> {
    let straight = (any::<bool>(), any::<bool>(), prop::collection::btree_map(0..3_usize, coordinate(), 1..=3))
        .prop_map(|(rapid, absolute, words)| Motion::Straight { rapid, absolute, words });
    let axes = prop::sample::select(&[(0, 1), (1, 2), (0, 2)][..]);
    let arc = (axes, (coordinate(), coordinate()), 0..4_u8, any::<bool>())
        .prop_filter("a centre", |(_, center, ..)| *center != (0, 0))
        .prop_map(|(axes, center, quarters, clockwise)| Motion::Arc { axes, center, quarters, clockwise });
    prop_oneof![2 => Just(Motion::None), 4 => straight, 3 => arc]
}

/// A block whose target is still open: a kind, where to, how often.
fn block() -> impl Strategy<Value = (Block, u8, u32, Option<u32>)> {
    let spindle = prop::option::weighted(0.2, prop::sample::select(&[3_u8, 4, 5][..]));
    let speed = prop::option::weighted(0.2, 1..5000_u32);
    let times = prop::option::of(1..4_u32);
    let flags = (prop::bool::weighted(0.15), prop::bool::weighted(0.2), any::<u8>());
    (motion(), spindle, speed, flags, 0..8_u8, any::<u32>(), times).prop_map(
        |(motion, spindle, speed, (skip, comment, style), kind, to, times)| {
            (Block { motion, flow: Flow::None, skip, spindle, speed, comment, style }, kind, to, times)
        },
    )
}

/// A program without any finding.
pub fn program() -> impl Strategy<Value = Program> {
    let unit = || prop::collection::vec(block(), 1..8);
    let units = prop::collection::vec(unit(), 1..4);
    (units, any::<bool>(), prop::sample::select(&[2_u8, 30][..])).prop_map(|(units, block_skip, end)| {
        let count = units.len();
        let mut called = vec![false; count];
        let mut result: Vec<Vec<Block>> = Vec::new();
        for (unit, steps) in units.into_iter().enumerate() {
            let length = steps.len();
            let tie = |(mut block, kind, to, times): (Block, u8, u32, Option<u32>)| {
                let to = usize::try_from(to).unwrap();
                match kind {
                    // Subprograms are called from the main program (W0414).
                    0 if unit == 0 && count > 1 => {
                        let to = 1 + to % (count - 1);
                        called[to] = true;
                        block.flow = Flow::Call { to, times };
                    }
                    1 | 2 => block.flow = Flow::Jump { to: to % length, times },
                    _ => {}
                }
                block
            };
            result.push(steps.into_iter().map(tie).collect());
        }
        for to in (1..count).filter(|unit| !called[*unit]) {
            let flow = Flow::Call { to, times: Some(2) };
            let (motion, style) = (Motion::None, 0);
            let block = Block { motion, flow, skip: false, spindle: None, speed: None, comment: false, style };
            result[0].push(block);
        }
        Program { units: result, block_skip, end }
    })
}

/// The program as a report shows it.
pub fn listing(program: &Program) -> String {
    let mut text = String::new();
    for (line, content) in program.text().lines().enumerate() {
        writeln!(text, "{:3} {content}", line + 1).unwrap();
    }
    text
}
