//! Short blocks that are joined to their neighbours before anything else (CNT-4).

use super::joint::Piece;
use super::step::{Direction, Unit};
use crate::run::MotionType;

/// So many blocks make a piece at most: to and fro without end must not gather them.
const MOST: usize = 500;

/// Joins blocks; gives pieces in their order.
#[derive(Clone, Debug)]
pub(super) struct Merger {
    /// Shorter ones are joined; 0: nothing is.
    length: f64,
    /// The last piece: short blocks may still be added to it.
    held: Option<Piece>,
    /// Blocks of the piece that grows.
    open: Vec<Piece>,
    vector: [f64; 9],
}

/// What comes out.
#[derive(Debug)]
pub(super) enum Merged {
    /// A piece.
    Piece(Box<Piece>),
    /// The block of `slot` is part of the piece recorded at slot `of`; it comes before that piece.
    Joined { slot: u64, of: u64 },
}

impl Merger {
    pub(super) const fn new(length: f64) -> Self {
        Self { length, held: None, open: Vec::new(), vector: [0.0; 9] }
    }

    /// Takes a block; `piece.broken` has the reasons `start` … `axes`.
    pub(super) fn push(&mut self, piece: Piece, out: &mut impl FnMut(Merged)) {
        if self.length <= 0.0 {
            return out(Merged::Piece(Box::new(piece)));
        }
        if !self.open.is_empty() {
            if piece.kind == MotionType::Linear && piece.unit == Unit::Mm && piece.broken.is_none() {
                let ends = !self.is_small(&piece);
                self.vector = sum(self.vector, piece.vector);
                self.open.push(piece);
                if ends || norm(self.vector) >= self.length {
                    self.complete(out);
                } else if self.open.len() >= MOST {
                    self.stand_alone(out);
                }
                return;
            }
            self.give_up(out);
        }
        if self.is_small(&piece) {
            self.vector = piece.vector;
            self.open.push(piece);
        } else {
            self.hold(piece, out);
        }
    }

    /// No more can be joined: everything comes out.
    pub(super) fn flush(&mut self, out: &mut impl FnMut(Merged)) {
        if !self.open.is_empty() {
            self.give_up(out);
        }
        if let Some(piece) = self.held.take() {
            out(Merged::Piece(Box::new(piece)));
        }
    }

    fn is_small(&self, piece: &Piece) -> bool {
        piece.plain
            && piece.kind == MotionType::Linear
            && piece.unit == Unit::Mm
            && piece.length.is_some_and(|length| length < self.length)
    }

    fn hold(&mut self, piece: Piece, out: &mut impl FnMut(Merged)) {
        if let Some(before) = self.held.replace(piece) {
            out(Merged::Piece(Box::new(before)));
        }
    }

    /// The piece has its length, or ends with a block that is not small.
    fn complete(&mut self, out: &mut impl FnMut(Merged)) {
        let length = norm(self.vector);
        let Some(last) = self.open.pop() else { return };
        let Some(first) = self.open.first() else { return self.hold(last, out) };
        let piece = Piece {
            mode: first.mode,
            with: first.with,
            broken: first.broken,
            breaks_before: first.breaks_before,
            length: Some(length),
            from: direction(self.vector, first.from),
            to: direction(self.vector, first.from),
            vector: self.vector,
            is_piece: true,
            ..last
        };
        let of = piece.slot;
        let joined: Vec<u64> = self.open.drain(..).map(|block| block.slot).collect();
        self.hold(piece, out);
        joined.into_iter().for_each(|slot| out(Merged::Joined { slot, of }));
    }

    /// Nothing more comes for the piece that grows: it is added to the one before, or stays as it is.
    fn give_up(&mut self, out: &mut impl FnMut(Merged)) {
        let unbroken = self.open.first().is_some_and(|first| first.broken.is_none());
        if let Some(held) =
            self.held.as_mut().filter(|held| unbroken && held.kind == MotionType::Linear && held.unit == Unit::Mm)
        {
            let vector = sum(held.vector, self.vector);
            if norm(vector) > 0.0 {
                held.length = Some(norm(vector));
                (held.from, held.to) = (direction(vector, held.from), direction(vector, held.from));
                held.vector = vector;
                held.is_piece = true;
                let of = held.slot;
                self.open.drain(..).for_each(|block| out(Merged::Joined { slot: block.slot, of }));
                return;
            }
        }
        self.stand_alone(out);
    }

    /// Ends the open piece by itself; out and back, its blocks stay apart.
    fn stand_alone(&mut self, out: &mut impl FnMut(Merged)) {
        if norm(self.vector) > 0.0 {
            self.complete(out);
        } else {
            for block in std::mem::take(&mut self.open) {
                self.hold(block, out);
            }
        }
    }
}

fn sum(a: [f64; 9], b: [f64; 9]) -> [f64; 9] {
    let mut sum = a;
    sum.iter_mut().zip(b).for_each(|(sum, b)| *sum += b);
    sum
}

/// Its length; what adding up decimals leaves of nothing is nothing.
fn norm(vector: [f64; 9]) -> f64 {
    let norm = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    if norm < 1e-9 { 0.0 } else { norm }
}

/// The direction of a straight piece: its blocks' vectors hold the first three linear axes where `first` does.
fn direction(vector: [f64; 9], first: Direction) -> Direction {
    let mut along = [0.0; 3];
    along.iter_mut().zip(vector).for_each(|(along, part)| *along = part);
    match first {
        Direction::Unknown => Direction::Unknown,
        Direction::Still | Direction::Along(_) if along == [0.0; 3] => Direction::Still,
        Direction::Still | Direction::Along(_) => Direction::Along(along),
    }
}
