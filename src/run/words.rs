//! One block's words with their values, as execution finds them.

use super::site::Site;
use super::unknown::Groups;
use crate::dict::{Decimal, GCode, GGroup, Lasting};
use crate::resolve::Roles;
use crate::syntax::Word;
use crate::text::Location;

/// A word with its value; `None`: it depends on something unknown (PAR-5), or is unusable and reported.
#[derive(Clone, Copy, Debug)]
pub(super) struct Valued {
    pub(super) word: Word,
    pub(super) value: Option<Decimal>,
}

/// The words of the current block. One is reused for all blocks.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockWords {
    /// By place in machine order.
    pub(super) axes: [Option<Valued>; 9],
    pub(super) axis_count: usize,
    pub(super) i: Option<Valued>,
    pub(super) j: Option<Valued>,
    pub(super) k: Option<Valued>,
    pub(super) f: Option<Valued>,
    pub(super) s: Option<Valued>,
    pub(super) t: Option<Valued>,
    pub(super) h: Option<Valued>,
    pub(super) p: Option<Valued>,
    pub(super) d: Option<Valued>,
    pub(super) correction: Option<Valued>,
    pub(super) l: Option<Valued>,
    pub(super) q: Option<Valued>,
    /// In written order.
    pub(super) g: Vec<(GCode, Word)>,
    /// The groups of these.
    g_groups: Groups,
    pub(super) m: Vec<(u8, Word)>,
    /// R words, in written order.
    pub(super) r: Vec<Word>,
    /// A word of an axis that the machine does not have (E0311): which axis was meant, nobody knows.
    pub(super) other_axis: bool,
    /// A G word whose value is not known.
    pub(super) unknown_g: bool,
    /// A G word that is malformed, or whose parameter has no value of use: it may be any function.
    pub(super) malformed_g: bool,
    /// The same of an M word.
    pub(super) malformed_m: bool,
    /// G groups of which two functions are written (E0307), those in which one of the two lasts.
    pub(super) clashes: Groups,
    pub(super) lasting_clashes: Groups,
    /// M groups of which two functions are written (E0308).
    pub(super) m_clashes: Vec<u8>,
    /// A G word takes its number from a parameter: what L and Q are for could not be told before.
    pub(super) parametric_g: bool,
}

impl BlockWords {
    /// Forgets the block before, touching as little memory as that takes: it is done for every block.
    pub(super) fn clear(&mut self) {
        let Self {
            axes,
            axis_count,
            i,
            j,
            k,
            f,
            s,
            t,
            h,
            p,
            d,
            correction,
            l,
            q,
            g,
            g_groups,
            m,
            r,
            other_axis,
            unknown_g,
            malformed_g,
            malformed_m,
            clashes,
            lasting_clashes,
            m_clashes,
            parametric_g,
        } = self;
        if *axis_count > 0 {
            axes.fill(None);
        }
        (*axis_count, *i, *j, *k) = (0, None, None, None);
        (*f, *s, *t, *h, *p, *d, *correction, *l, *q) = (None, None, None, None, None, None, None, None, None);
        g.clear();
        m.clear();
        r.clear();
        (*other_axis, *unknown_g, *malformed_g, *malformed_m, *parametric_g) = (false, false, false, false, false);
        (*g_groups, *clashes, *lasting_clashes) = Default::default();
        m_clashes.clear();
    }

    /// Two functions of one group are written: nobody knows which was meant.
    pub(super) fn clash(&mut self, first: GCode, second: GCode) {
        let group = first.group();
        self.clashes = self.clashes.with(group);
        if [first, second].into_iter().any(|code| code.lasting() != Lasting::Block) {
            self.lasting_clashes = self.lasting_clashes.with(group);
        }
        self.g.retain(|(code, _)| code.group() != group);
        self.g_groups = self.g_groups.without(group);
    }

    /// Takes a G word of a group of which none is written yet.
    pub(super) fn push_g(&mut self, code: GCode, word: Word) {
        self.g.push((code, word));
        self.g_groups = self.g_groups.with(code.group());
    }

    /// Takes the function in force that a point writes, or writes no more, in place of that of the point before. Gives
    /// whether both write one, or neither does.
    #[inline]
    pub(super) fn write_again(&mut self, function: Option<(GCode, Word)>) -> bool {
        let same = function.is_some() != self.g.is_empty();
        self.g.clear();
        self.g_groups = Groups::default();
        if let Some((code, word)) = function {
            self.push_g(code, word);
        }
        same
    }

    /// The function of a group written in this block.
    #[inline]
    pub(super) fn written(&self, group: GGroup) -> Option<(GCode, Word)> {
        if self.g_groups.has(group) { self.find(|code| code.group() == group) } else { None }
    }

    /// The word that writes a function.
    #[inline]
    pub(super) fn has(&self, code: GCode) -> Option<Word> {
        if self.g_groups.has(code.group()) { self.find(|written| written == code).map(|(_, word)| word) } else { None }
    }

    fn find(&self, wanted: impl Fn(GCode) -> bool) -> Option<(GCode, Word)> {
        self.g.iter().copied().find(|(code, _)| wanted(*code))
    }

    /// The first written function that makes the words data (GRP-4).
    pub(super) fn data(&self) -> Option<GCode> {
        self.g.iter().map(|(code, _)| *code).find(|code| code.makes_words_data())
    }

    /// What L and Q belong to, with the functions that parameters give.
    pub(super) fn roles(&self) -> Roles {
        let functions = self.g.iter().map(|(code, word)| (Some(*code), *word));
        Roles::of(functions, self.l.map(|valued| valued.word), self.q.map(|valued| valued.word))
    }

    /// The axis word that comes first in the text.
    pub(super) fn first_axis_word(&self) -> Option<Word> {
        self.axes.iter().flatten().map(|valued| valued.word).min_by_key(|word| word.start())
    }

    /// Where a finding about an arc or a motion stands: its G word if written, else its first axis word.
    pub(super) fn place_of_motion(&self, site: &Site<'_>) -> Location {
        let written = self.written(GGroup::G0).map(|(_, word)| word);
        let center = || self.i.or(self.j).map(|valued| valued.word);
        let word = written.or_else(|| self.first_axis_word()).or_else(center);
        word.map_or_else(|| site.block_place(), |word| site.word_place(word))
    }

    /// Axis words with their places in machine order.
    pub(super) fn axis_words(&self) -> impl Iterator<Item = (usize, Valued)> + '_ {
        self.axes.iter().enumerate().filter_map(|(axis, valued)| valued.map(|valued| (axis, valued)))
    }
}
