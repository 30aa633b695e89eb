//! Executed blocks as rows of a page: what each was, so that its record can be made again. Executions that are equal in
//! all but their `seq`, calls and time share a row, so that the passes of a loop cost nothing.

use std::collections::HashMap;

use serde_json::{Map, Value};

use super::arcs::{self, Swept};
use super::calls::Contexts;
use super::column::Column;
use super::files::Files;
use super::hash::Hash;
use super::noted::Noter;
use super::parts::{Interned, StateKey, add_words, parts};
use super::positions::{Known, Positions};
use super::shapes::{ArcAxes, LengthUnit, ShapeKey};
use super::tally::Tally;
use super::turning::Turning;
use crate::analysis::state::Unknown;
use crate::config::Settings;
use crate::dict::{AxisLetter, Decimal, Micro};
use crate::run::{Executed, Length, Motion, MotionType};
use crate::stream::SingleRecord;
use crate::sure::small;

/// Rows that are remembered, so that equal ones are found, at most.
const REMEMBERED: usize = 1 << 21;

/// Blocks between two places whose path from the program's start is kept.
pub(super) const APART: usize = 1 << 12;

/// Which executed blocks a page holds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    /// The first.
    pub from: u64,
    /// No more than so many from the first block of the program on (R387).
    pub blocks: Option<u64>,
}

impl Part {
    /// Whether it holds an executed block.
    pub(super) fn has(&self, seq: u64) -> bool {
        seq >= self.from && self.blocks.is_none_or(|blocks| seq < blocks)
    }
}

/// What is kept of executed blocks.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Keep {
    /// All that the page shows.
    Records,
    /// What a still picture draws: where axes move.
    Geometry,
}

/// The rows of a program.
#[derive(Debug)]
pub(super) struct Rows {
    pub turning: Turning,
    pub part: Part,
    keep: Keep,
    pub letters: Vec<AxisLetter>,
    /// Places of the first three linear axes.
    linear: Vec<usize>,
    pub files: Files,
    pub states: Interned<StateKey>,
    /// By index in `states`: whether F counts hundredths, where it counts per minute.
    states_fed: Vec<Option<bool>>,
    pub extras: Interned<String>,
    /// Indices in `extras` of blocks that do nothing else than their words say.
    worded: HashMap<Vec<u8>, u32>,
    /// Room for a key of these.
    key: Vec<u8>,
    /// The parameters that the machine has at the program's start, as far as they are given.
    pub given: Map<String, Value>,
    noter: Noter,
    pub shapes: Interned<ShapeKey>,
    /// By index in `shapes`.
    pub shape_keys: Vec<ShapeKey>,
    pub contexts: Contexts,
    /// By row.
    pub block: Column,
    pub before: Column,
    pub state: Column,
    pub extra: Column,
    pub shape: Column,
    pub feed: Column,
    /// In thousandths: the parameters that blocks write, as many a row as its extra names.
    pub params: Column,
    pub positions: Positions,
    /// From start to centre, of rows whose shape has an arc.
    pub arcs: [Tally; 2],
    /// These rows, ascending.
    arc_rows: Vec<u32>,
    /// By executed block: its row, its calls, one more than the counter of its jump.
    pub row_of: Column,
    pub context_of: Column,
    pub left: Column,
    /// The known path from the program's start to every so many blocks.
    pub ways: Vec<Micro>,
    /// The same to the last executed block.
    pub way: Micro,
    /// Whether each executed block has a separate row.
    pub plain: bool,
    /// By block of the text: whether it was executed.
    visited: Vec<bool>,
    equal: HashMap<u128, u32>,
    /// Positions after the block before.
    stand: Known,
    last_row: u32,
    last: Last,
    records: SingleRecord,
}

impl Rows {
    /// Of a program that is executed with these settings.
    pub fn new(settings: &Settings, part: Part, keep: Keep) -> Self {
        let axes = &settings.machine.axes;
        let given = settings.machine.parameters.iter();
        let letters: Vec<AxisLetter> = axes.iter().map(|axis| axis.letter).collect();
        let linear = axes.iter().enumerate().filter(|(_, axis)| !axis.rotary).map(|(place, _)| place).take(3).collect();
        let mut rows = Self {
            turning: Turning::default(),
            part,
            keep,
            linear,
            files: Files::new(keep == Keep::Geometry),
            states: Interned::default(),
            states_fed: Vec::new(),
            extras: Interned::default(),
            worded: HashMap::new(),
            key: Vec::new(),
            given: given
                .map(|(index, value)| (format!("R{index}"), (value.thousandths() as f64 / 1000.0).into()))
                .collect(),
            noter: Noter::new(settings),
            shapes: Interned::default(),
            shape_keys: Vec::new(),
            contexts: Contexts::default(),
            block: Column::default(),
            before: Column::default(),
            state: Column::default(),
            extra: Column::default(),
            shape: Column::default(),
            feed: Column::default(),
            params: Column::default(),
            positions: Positions::new(letters.len()),
            arcs: Default::default(),
            arc_rows: Vec::new(),
            row_of: Column::default(),
            context_of: Column::default(),
            left: Column::default(),
            ways: Vec::new(),
            way: Micro::ZERO,
            plain: true,
            visited: Vec::new(),
            equal: HashMap::new(),
            stand: Known::default(),
            last_row: 0,
            last: Last::default(),
            records: SingleRecord::new(&letters),
            letters,
        };
        rows.extras.get("{}".to_owned(), || Value::Object(Map::new()));
        rows
    }

    /// From start to centre of the arc of a row, along the axes of its plane; 0 where it has none.
    pub fn to_center(&self, row: usize) -> [Micro; 2] {
        let place = u32::try_from(row).ok().and_then(|row| self.arc_rows.binary_search(&row).ok());
        let at = |tally: &Tally| place.and_then(|place| tally.get(place)).unwrap_or_default();
        let [first, second] = &self.arcs;
        [at(first), at(second)]
    }

    /// The row of an executed block.
    pub fn row(&self, index: usize) -> Option<usize> {
        self.row_of.get(index).and_then(|row| usize::try_from(row).ok())
    }

    /// The row whose positions are those before a row.
    pub fn row_before(&self, row: usize) -> usize {
        let back = self.before.get(row).and_then(|back| usize::try_from(back).ok()).unwrap_or_default();
        row.saturating_sub(1).saturating_sub(back)
    }

    pub fn shape_of(&self, row: usize) -> Option<&ShapeKey> {
        let shape = usize::try_from(self.shape.get(row)?).ok()?;
        self.shape_keys.get(shape)
    }

    /// The angle that the arc of a row turns through, in radians, positive; `None` where it has none.
    pub fn sweep(&self, row: usize) -> Option<f64> {
        let shape = self.shape_of(row)?;
        let (arc, kind) = shape.arc.zip(shape.kind)?;
        let before = self.row_before(row);
        let [to_u, to_v] = self.to_center(row);
        let at = |row: usize| [self.positions.get(arc.first, row), self.positions.get(arc.second, row)];
        let [start_u, start_v] = at(before);
        Some(arcs::sweep([start_u, start_v], at(row), [start_u.plus(to_u), start_v.plus(to_v)], kind).sweep())
    }

    /// F of a row as ten-thousandths of a mm/min or deg/min, M37 counted; `None` where it counts per revolution, or is
    /// not known.
    pub fn fed(&self, row: usize) -> Option<i64> {
        let state = self.state.get(row).and_then(|state| usize::try_from(state).ok());
        let hundredth = state.and_then(|state| self.states_fed.get(state).copied().flatten())?;
        let feed = self.feed.get(row)? * 10;
        Some(if hundredth { (feed + 50).div_euclid(100) } else { feed })
    }

    /// Places of the first three linear axes among all.
    pub fn linear(&self) -> impl Iterator<Item = usize> {
        self.linear.iter().copied()
    }

    /// The number of the block of a row.
    pub fn n(&self, row: usize) -> u32 {
        let block = self.block.get(row).and_then(|block| usize::try_from(block).ok());
        let n = block.and_then(|block| self.files.n.get(block));
        n.and_then(|n| u32::try_from(n).ok()).unwrap_or_default()
    }

    /// How many executed blocks it holds.
    pub fn count(&self) -> usize {
        self.row_of.len()
    }

    /// The bytes that it takes, roughly.
    pub fn memory(&self) -> usize {
        /// Of a part of records, as JSON; of a row that is remembered.
        const INTERNED: usize = 1000;
        let columns = [&self.block, &self.before, &self.state, &self.extra, &self.shape, &self.feed, &self.params];
        let by_seq = [&self.row_of, &self.context_of, &self.left];
        let interned = self.states.len() + self.extras.len() + self.shapes.len();
        columns.into_iter().chain(by_seq).map(Column::memory).sum::<usize>()
            + self.positions.memory()
            + self.contexts.memory()
            + self.files.memory()
            + self.arcs.iter().map(|tally| tally.column().memory()).sum::<usize>()
            + self.equal.capacity() * 33
            + interned * INTERNED
    }

    /// The next executed block of the program; gives whether it is an execution that the rows had.
    pub fn add(&mut self, block: &Executed<'_>) -> bool {
        let inside = self.part.has(block.seq());
        if let Some(file) = block.file() {
            self.files.add(block.file_index(), file);
        }
        if inside && self.block.len() == 0 {
            self.begin(block);
        }
        let after = self.known_after(block);
        if self.keep == Keep::Records {
            self.noter.arrive(block);
            if inside && self.count().is_multiple_of(APART) {
                self.ways.push(self.way);
            }
            let length = block.motion().and_then(|motion| motion.length().mm());
            self.way = self.way.plus(length.unwrap_or_default());
        }
        let again = inside && self.add_row(block, &after);
        if self.keep == Keep::Records {
            self.noter.pass(block);
        }
        self.stand = after;
        again
    }

    /// Row 0: what holds before the first block.
    fn begin(&mut self, block: &Executed<'_>) {
        if block.seq() == 0 {
            for (axis, letter) in self.letters.iter().enumerate() {
                let motion = block.motion().filter(|motion| motion.moves(*letter));
                let value = motion.map_or_else(|| block.position(*letter), |motion| motion.start(*letter));
                self.stand.set(axis, value);
            }
        }
        let stand = self.stand;
        let key = ShapeKey { known: stand.bits(), coded: stand.bits(), ..ShapeKey::default() };
        let shape = self.shape(key, block);
        let state = if self.keep == Keep::Records { self.state(block) } else { 0 };
        self.push_row(0, 0, state, 0, shape, 0, &stand);
    }

    fn known_after(&self, block: &Executed<'_>) -> Known {
        let mut known = Known::default();
        for (axis, letter) in self.letters.iter().enumerate() {
            known.set(axis, block.position(*letter));
        }
        known
    }

    fn add_row(&mut self, block: &Executed<'_>, after: &Known) -> bool {
        let (_, id) = block.at();
        let index = self.files.block(block.file_index(), id);
        let moved = block.motion().map(|motion| self.moved(block, motion, after));
        let moved = moved.unwrap_or_default();
        if let Some(motion) = block.motion() {
            self.turning.read(block, motion);
        }
        let (known, coded) = (after.bits(), after.changed_from(&self.stand));
        let why = self.why(block, known);
        let key = ShapeKey { known, coded, why, opaque: block.is_opaque(), ..moved.shape };
        let shape = self.shape(key, block);
        let Last { state, extra, feed, context } = match self.keep {
            Keep::Records => self.parts(block, moved.special),
            Keep::Geometry => Last::default(),
        };
        let mut params = block.params();
        if self.keep == Keep::Records {
            self.context_of.push(i64::from(context));
            self.left.push(block.jump().and_then(|jump| jump.left).map_or(0, |left| i64::from(left) + 1));
        } else {
            params = &[];
        }
        let equal = self.equal_row(index, [shape, state, extra], feed, after, moved.to_center, params);
        let row = equal.unwrap_or_else(|| {
            params.iter().for_each(|(_, value)| self.params.push(value.thousandths()));
            let row = self.push_row(index, self.last_row, state, extra, shape, feed, after);
            if let Some(to_center) = moved.to_center {
                self.arc_rows.push(row);
                for (column, value) in self.arcs.iter_mut().zip(to_center) {
                    column.push(value);
                }
            }
            row
        });
        self.plain &= row as usize == self.row_of.len() + 1;
        self.row_of.push(i64::from(row));
        self.last_row = row;
        equal.is_some()
    }

    /// The part of the block that it shares with others. One that only moves on differs in nothing from the block
    /// before.
    fn parts(&mut self, block: &Executed<'_>, special: Special) -> Last {
        let moves_on = block.moves_on() && self.count() > 0;
        let Last { state, feed, context, .. } = if moves_on {
            self.last
        } else {
            let state = self.state(block);
            let feed = block.feed().map_or(0, |feed| feed.value.thousandths());
            Last { state, extra: 0, feed, context: self.contexts.find(block, &self.files) }
        };
        let has_extra = special != Special::default() || block.g_written().next().is_some();
        let extra = if moves_on && !has_extra { 0 } else { self.extra(block, special) };
        self.last = Last { state, extra, feed, context };
        self.last
    }

    /// The row of an equal execution, when there is one; else the next row is remembered.
    fn equal_row(
        &mut self,
        index: u32,
        parts: [u32; 3],
        feed: i64,
        after: &Known,
        to_center: Option<[Micro; 2]>,
        params: &[(u8, Decimal)],
    ) -> Option<u32> {
        let place = index as usize;
        if self.visited.len() <= place {
            self.visited.resize(place + 1, false);
        }
        let again = self.visited.get_mut(place).is_some_and(|visited| std::mem::replace(visited, true));
        // The first pass over a text is never equal to anything; what is repeated is remembered from its second pass
        // on.
        if !again {
            return None;
        }
        let mut hash = Hash::new();
        hash.add(u64::from(index));
        for part in parts {
            hash.add(u64::from(part));
        }
        hash.add(feed.cast_unsigned());
        for known in [&self.stand, after] {
            hash.add(u64::from(known.bits()));
            for value in known.values() {
                hash.add(value.millionths().cast_unsigned());
            }
        }
        for value in to_center.into_iter().flatten() {
            hash.add(value.millionths().cast_unsigned());
        }
        for (index, value) in params {
            hash.add(u64::from(*index));
            hash.add(value.thousandths().cast_unsigned());
        }
        let next = small(self.block.len());
        let full = self.equal.len() >= REMEMBERED;
        match self.equal.get(&hash.value()) {
            Some(row) => Some(*row),
            None if full => None,
            None => {
                self.equal.insert(hash.value(), next);
                None
            }
        }
    }

    #[expect(clippy::too_many_arguments, reason = "one for each column")]
    fn push_row(
        &mut self,
        block: u32,
        before: u32,
        state: u32,
        extra: u32,
        shape: u32,
        feed: i64,
        stand: &Known,
    ) -> u32 {
        let row = small(self.block.len());
        self.block.push(i64::from(block));
        self.before.push(if row == 0 { 0 } else { i64::from(row) - 1 - i64::from(before) });
        self.state.push(i64::from(state));
        self.extra.push(i64::from(extra));
        self.shape.push(i64::from(shape));
        self.feed.push(feed);
        self.positions.push(stand);
        row
    }

    fn state(&mut self, block: &Executed<'_>) -> u32 {
        let Self { states, states_fed, records, .. } = self;
        let key = StateKey::of(block);
        states.get(key, || {
            states_fed.push(key.fed());
            let mut state = parts(records.of(block)).state;
            state.extend(key.held().map(|held| ("held".to_owned(), held)));
            Value::Object(state)
        })
    }

    fn shape(&mut self, key: ShapeKey, block: &Executed<'_>) -> u32 {
        let Self { shapes, shape_keys, records, letters, .. } = self;
        shapes.get(key, || {
            shape_keys.push(key);
            let mut motion = if key.kind.is_some() { parts(records.of(block)).motion } else { Map::new() };
            for computed in ["start", "delta", "length_mm", "length_deg", "center", "radius_mm", "sweep_deg"] {
                motion.remove(computed);
            }
            key.json(letters, motion)
        })
    }

    fn extra(&mut self, block: &Executed<'_>, special: Special) -> u32 {
        let mut key = std::mem::take(&mut self.key);
        key.clear();
        let worded = special == Special::default() && add_words(block, &mut key);
        if worded {
            self.noter.add_key(block, &mut key);
            if let Some(known) = self.worded.get(&key).copied() {
                self.key = key;
                return known;
            }
        }
        let params = block.params();
        let mut parts = parts(self.records.of(block));
        if !params.is_empty() {
            parts.does.insert("params".to_owned(), params_named(params));
        }
        let mut motion = std::mem::take(&mut parts.motion);
        motion.retain(|name, _| match name.as_str() {
            "start" => special.start,
            "delta" => special.delta,
            "length_mm" | "length_deg" => special.length,
            "center" | "radius_mm" | "sweep_deg" => special.arc,
            _ => false,
        });
        if !motion.is_empty() {
            parts.does.insert("motion".to_owned(), Value::Object(motion));
        }
        let written = self.noter.written(block);
        if !written.is_empty() {
            parts.does.insert("written".to_owned(), written.into());
        }
        let value = Value::Object(parts.does);
        let extra = self.extras.get(value.to_string(), || value);
        if worded {
            self.worded.insert(key, extra);
        }
        extra
    }

    /// Why axes are not known behind a block. Of a call of the machine's macrocycle the record says where they stand
    /// before it.
    fn why(&self, block: &Executed<'_>, known: u16) -> [Unknown; AxisLetter::ALL.len()] {
        let mut why = [Unknown::default(); AxisLetter::ALL.len()];
        if self.keep == Keep::Records {
            let unseen = |letter: AxisLetter| block.moved_unseen().any(|unseen| unseen == letter);
            for (axis, (letter, why)) in self.letters.iter().zip(&mut why).enumerate() {
                if known & (1 << axis) == 0 || unseen(*letter) {
                    *why = self.noter.why(*letter);
                }
            }
        }
        why
    }

    /// The values that the page computes of a motion, and those where it would be wrong.
    fn moved(&self, block: &Executed<'_>, motion: Motion<'_>, after: &Known) -> Moved {
        let mut found = Moved::default();
        let shape = &mut found.shape;
        shape.kind = Some(motion.kind());
        shape.spindle = motion.spindle_axis();
        shape.stale = motion.is_stale();
        let axes = &block.settings().machine.axes;
        let is_rotary =
            |axis: usize| axes.get(axis).is_some_and(|axis| axis.rotary || motion.spindle_axis() == Some(axis.letter));
        let arc = motion.arc();
        let mut linear = false;
        for (axis, letter) in self.letters.iter().enumerate().filter(|(_, letter)| motion.moves(**letter)) {
            shape.axes |= 1 << axis;
            linear |= !is_rotary(axis);
            found.special.delta |= motion.delta(*letter).is_some();
            if let Some(start) = motion.start(*letter) {
                shape.started |= 1 << axis;
                found.special.start |= self.stand.get(axis) != Some(start);
            }
        }
        if found.special.start {
            shape.started = 0;
        }
        for axis in (0..self.letters.len()).filter(|axis| shape.axes & (1 << axis) != 0) {
            if is_rotary(axis) != linear {
                shape.measured |= 1 << axis;
            }
        }
        let length = motion.length();
        shape.missing = match length {
            Length::Missing(why) => Some(why),
            Length::Mm(_) | Length::Deg(_) => None,
        };
        let swept = arc.and_then(|arc| self.swept(&arc, shape, after, motion));
        if let Some(arc) = arc {
            shape.plane = self.place(arc.plane[0]).zip(self.place(arc.plane[1]));
            match swept {
                Some(swept) => {
                    shape.arc = shape.plane.map(|(first, second)| ArcAxes { first, second });
                    found.to_center = Some(swept.to_center);
                    found.special.arc =
                        arc.radius_mm != Some(swept.radius()) || arc.sweep_deg != Some(swept.sweep_deg());
                }
                None => found.special.arc = arc.radius_mm.is_some() || arc.center.is_some(),
            }
        }
        let (written, unit) = match length {
            Length::Mm(length) => (length, LengthUnit::Mm),
            Length::Deg(length) => (length, LengthUnit::Deg),
            Length::Missing(_) => return found,
        };
        if self.length(shape, after, swept) == Some(written) {
            shape.length = Some(unit);
        } else {
            found.special.length = true;
        }
        found
    }

    /// The place of an axis among all.
    pub fn place(&self, letter: AxisLetter) -> Option<usize> {
        self.letters.iter().position(|known| *known == letter)
    }

    /// The arc as the page computes it.
    fn swept(&self, arc: &crate::run::ArcPath, shape: &ShapeKey, after: &Known, motion: Motion<'_>) -> Option<Swept> {
        let center = arc.center?;
        let [u, v] = [self.place(arc.plane[0])?, self.place(arc.plane[1])?];
        let bits = (1 << u) | (1 << v);
        // A full circle without axis words moves both axes of its plane.
        if shape.axes & !shape.started & bits != 0 {
            return None;
        }
        let start = [self.stand.get(u)?, self.stand.get(v)?];
        let end = [after.get(u)?, after.get(v)?];
        Some(arcs::sweep(start, end, center, motion.kind()))
    }

    /// The length as the page computes it; `None` when it cannot.
    fn length(&self, shape: &ShapeKey, after: &Known, swept: Option<Swept>) -> Option<Micro> {
        let is_arc = shape.kind.is_some_and(MotionType::is_arc);
        if is_arc && swept.is_none() {
            return None;
        }
        let path = swept.map_or(0.0, |swept| swept.path());
        let mut sum = path * path;
        let mut others = false;
        let in_arc = |axis: usize| shape.arc.is_some_and(|arc| axis == arc.first || axis == arc.second);
        for axis in (0..self.letters.len()).filter(|axis| shape.measured & (1 << axis) != 0 && !in_arc(*axis)) {
            if shape.started & (1 << axis) == 0 {
                return None;
            }
            let distance = after.get(axis)?.minus(self.stand.get(axis)?).to_f64();
            sum += distance * distance;
            others = true;
        }
        Some(Micro::from_f64(if others { sum.sqrt() } else { path }))
    }
}

/// The part of a row that comes from a block's motion.
#[derive(Clone, Copy, Debug, Default)]
struct Moved {
    shape: ShapeKey,
    to_center: Option<[Micro; 2]>,
    special: Special,
}

/// Where the page would compute something else than the record has: that is kept as written.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
struct Special {
    start: bool,
    length: bool,
    arc: bool,
    delta: bool,
}

/// The parameters that a block writes, without their values.
fn params_named(params: &[(u8, Decimal)]) -> Value {
    params.iter().map(|(index, _)| Value::from(format!("R{index}"))).collect()
}

/// The part of a row that it shares with others.
#[derive(Clone, Copy, Debug, Default)]
struct Last {
    state: u32,
    extra: u32,
    feed: i64,
    context: u32,
}
