//! Motions before words: where motions and the words between them changed places, the motions are the same ones, and the
//! words stand elsewhere (CMP-4).

use super::align::Aligned;
use super::steps::{Step, Steps};

/// So many steps are looked at together: a word that moved farther is matched by its motions.
const MOST: usize = 64;

/// Gives aligned steps on. Of motions of one program, words of both, and the same motions of the other program it makes
/// words of one, motions of both, words of the other.
pub(super) struct Straight<'s, F> {
    /// The old program and the new one.
    steps: [&'s Steps; 2],
    /// Steps of one program alone.
    alone: Vec<usize>,
    /// Of which.
    side: usize,
    /// Words of both behind them.
    words: Vec<[usize; 2]>,
    /// Behind these, steps of the other program that are the same as the first ones alone.
    back: Vec<usize>,
    give: F,
}

impl<'s, F: FnMut(Aligned)> Straight<'s, F> {
    pub const fn new(steps: [&'s Steps; 2], give: F) -> Self {
        Self { steps, alone: Vec::new(), side: 0, words: Vec::new(), back: Vec::new(), give }
    }

    /// The next steps.
    pub fn push(&mut self, aligned: Aligned) {
        match aligned {
            Aligned::Old(at) => self.push_alone(0, at),
            Aligned::New(at) => self.push_alone(1, at),
            Aligned::Both(old, new) => {
                let is_word = self.step(0, old).is_some_and(|step| !Steps::is_motion(step));
                let goes_on = !self.alone.is_empty() && self.back.is_empty() && self.words.len() < MOST;
                if is_word && goes_on {
                    self.words.push([old, new]);
                } else {
                    self.flush();
                    (self.give)(aligned);
                }
            }
        }
    }

    fn push_alone(&mut self, side: usize, at: usize) {
        if self.words.is_empty() {
            if side != self.side || self.alone.len() == MOST {
                self.flush();
            }
            self.side = side;
            self.alone.push(at);
            return;
        }
        let token = self.step(side, at).map(|step| step.token);
        let is_same = |alone: &usize| self.step(self.side, *alone).map(|step| step.token) == token;
        let same = if self.back.is_empty() {
            self.alone.iter().rposition(is_same)
        } else {
            self.alone.get(self.back.len()).and_then(|alone| is_same(alone).then_some(0))
        };
        let Some(from) = same.filter(|_| side != self.side) else {
            self.flush();
            return self.push_alone(side, at);
        };
        for before in self.alone.drain(..from) {
            (self.give)(of(self.side, before));
        }
        self.back.push(at);
        if self.back.len() == self.alone.len() {
            self.straighten();
        }
    }

    /// All of them came back.
    fn straighten(&mut self) {
        if !self.alone.iter().any(|at| self.step(self.side, *at).is_some_and(Steps::is_motion)) {
            return self.flush();
        }
        let (side, other) = (self.side, 1 - self.side);
        let words = std::mem::take(&mut self.words);
        let of_side = |side: usize| words.iter().filter_map(move |word| Some(of(side, *word.get(side)?)));
        of_side(other).for_each(&mut self.give);
        for (alone, back) in self.alone.drain(..).zip(self.back.drain(..)) {
            (self.give)(if side == 0 { Aligned::Both(alone, back) } else { Aligned::Both(back, alone) });
        }
        of_side(side).for_each(&mut self.give);
    }

    /// Nothing more belongs to what is kept.
    pub fn flush(&mut self) {
        self.alone.drain(..).map(|at| of(self.side, at)).for_each(&mut self.give);
        self.words.drain(..).map(|[old, new]| Aligned::Both(old, new)).for_each(&mut self.give);
        self.back.drain(..).map(|at| of(1 - self.side, at)).for_each(&mut self.give);
    }

    fn step(&self, side: usize, at: usize) -> Option<&'s Step> {
        self.steps.get(side).and_then(|steps| steps.step(at))
    }
}

/// A step of one program alone.
const fn of(side: usize, at: usize) -> Aligned {
    if side == 0 { Aligned::Old(at) } else { Aligned::New(at) }
}
