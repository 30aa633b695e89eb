//! From an executed block to its row in the stream.

use super::records::{AxisList, AxisMap, BlockRecord, Call, Data, Motion};
use crate::dict::{Address, AxisLetter, Decimal, GCode, GGroup};
use crate::run::Executed;
use crate::text::LastPlaces;

/// What M37 leaves of a feed.
const REDUCED: Decimal = Decimal::from_thousandths(10);

/// Where the row before a row is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Before<'r> {
    /// It is not there any more.
    Nowhere,
    /// In the place that the new one takes.
    InPlace,
    /// Beside it.
    Beside(&'r BlockRecord),
}

/// Makes rows, one from the other: hardly anything differs from one block to the next.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    places: LastPlaces,
}

impl Rows {
    /// Makes the row of a block in `row`.
    pub(crate) fn fill(&mut self, block: &Executed<'_>, row: &mut BlockRecord, before: Before<'_>) {
        let known = match before {
            Before::Nowhere => None,
            Before::InPlace => Some(row.seq),
            Before::Beside(other) => Some(other.seq),
        };
        if let Before::Beside(other) = before
            && follows(block, known)
        {
            row.clone_from(other);
        }
        self.fill_changes(block, row, known);
    }

    /// Makes in `row` what may differ from the row before, whose `seq` is `before`, and says so by `true`; else the
    /// whole row.
    pub(crate) fn fill_changes(&mut self, block: &Executed<'_>, row: &mut BlockRecord, before: Option<u64>) -> bool {
        let follows = follows(block, before);
        if !follows {
            fill_whole(block, row);
        }
        self.place(block, row);
        row.first_block = block.first();
        fill_motion(block, row);
        follows
    }

    fn place(&mut self, block: &Executed<'_>, row: &mut BlockRecord) {
        let (file, id) = block.at();
        row.seq = block.seq();
        row.n = block.n();
        row.file = block.file_index();
        if let Some(parsed) = block.file() {
            let start = parsed.n_word(id).map_or(0, |word| word.start());
            let place = self.places.of(file, &parsed.source, start);
            row.line = place.line;
            row.column = place.column;
        }
        row.comments.clear();
        row.comments.extend(block.comments().map(str::to_owned));
    }
}

/// Whether a block only moves axes, as far as rows tell, behind the row with that `seq`.
fn follows(block: &Executed<'_>, before: Option<u64>) -> bool {
    before.is_some_and(|seq| seq > 0 && seq + 1 == block.seq()) && block.moves_on()
}

/// All that does not change while blocks only move axes.
fn fill_whole(block: &Executed<'_>, row: &mut BlockRecord) {
    let calls = block.calls().map(|call| Call {
        by: call.by.name(),
        l: call.l,
        file: block.index_of(call.file),
        n: call.n,
        line: block.line_of(call.at),
        pass: call.pass,
        of: call.of,
    });
    row.calls.clear();
    row.calls.extend(calls);
    row.jump = block.jump();
    row.skippable = block.skippable();
    row.last_block = block.last();
    row.g = GGroup::ALL.map(|group| block.g(group).map(GCode::number));
    row.g_set.clear();
    row.g_set.extend(block.g_written().map(GCode::number));
    row.m = std::array::from_fn(|group| block.m(group));
    row.m_set.clear();
    row.m_set.extend_from_slice(block.m_written());
    row.m_changed.clear();
    row.m_changed.extend_from_slice(block.m_changed());
    row.m_at_stop = block.m_at_stop();
    row.break_cont = block.break_cont();
    row.break_cont_end = block.break_cont_end();
    row.change_pos = block.change_pos();
    row.gear = block.gear();
    row.feed = block.feed().map(|feed| feed.value);
    row.feed_scale = block.feed_is_hundredth().then_some(REDUCED);
    row.tool = block.tool();
    row.rev_feed = block.rev_feed();
    row.const_cut_speed = block.const_cut_speed();
    (row.s, row.t, row.h, row.p, row.d) = (block.s(), block.t(), block.h(), block.p(), block.d());
    row.f_set = block.written(Address::F);
    row.s_set = block.written(Address::S);
    row.t_set = block.written(Address::T);
    row.h_set = block.written(Address::H);
    row.p_set = block.written(Address::P);
    row.d_set = block.written(Address::D);
    row.length_correction = block.length_correction();
    row.dwell_s = block.dwell();
    row.stop = block.stop();
    row.cond_stop = block.cond_stop();
    row.continuous_mode = block.continuous_mode();
    row.dynamic_set = block.dynamic_set().filter(|_| row.continuous_mode);
    row.opaque_call = block.opaque_call();
    row.data = block.data().map(|data| Data {
        g: data.g.number(),
        origin: data.origin.map(GCode::number),
        d: data.d,
        values: data.values.to_vec(),
    });
    row.words.clear();
    row.words.extend_from_slice(block.words());
    row.params.clear();
    row.params.extend_from_slice(block.params());
}

fn fill_motion(block: &Executed<'_>, row: &mut BlockRecord) {
    row.feed_unit = block.feed().map(|_| block.feed_unit());
    row.motion = block.motion().map(|motion| {
        let mut axes = AxisList::default();
        let [mut start, mut delta, mut center] = [AxisMap::default(); 3];
        for axis in motion.axes() {
            axes.push(axis);
            if let Some(value) = motion.start(axis) {
                start.set(axis, Some(value));
            }
            if let Some(distance) = motion.delta(axis) {
                delta.set(axis, Some(distance));
            }
        }
        let arc = motion.arc();
        for (axis, value) in arc.iter().flat_map(|arc| arc.plane.into_iter().zip(arc.center.into_iter().flatten())) {
            center.set(axis, Some(value));
        }
        let length = motion.length();
        Motion {
            kind: motion.kind(),
            axes,
            start,
            delta,
            length_mm: length.mm(),
            length_deg: length.deg(),
            length_missing: length.missing(),
            plane: arc.map(|arc| arc.plane),
            center,
            radius_mm: arc.and_then(|arc| arc.radius_mm),
            sweep_deg: arc.and_then(|arc| arc.sweep_deg),
            spindle_axis: motion.spindle_axis(),
        }
    });
    let mut position = AxisMap::default();
    for letter in AxisLetter::ALL {
        if let Some(value) = block.position(letter) {
            position.set(letter, Some(value));
        }
    }
    row.position = position;
}
