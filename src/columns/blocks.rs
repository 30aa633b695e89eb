//! The block stream as columns.

use std::fmt::{self, Display};
use std::io;
use std::ops::ControlFlow;

use super::batches::{Batches, End as LastBatch, PROGRAM, Rows};
use super::beside::Records;
use super::table::Table;
use crate::analysis::Part;
use crate::analysis::Totals;
use crate::config::Axis;
use crate::diag::Findings;
use crate::dict::{AxisLetter, Decimal, Micro};
use crate::run::{End, Executed, FeedUnit, Jump, MStop, Missing, MotionType, Program, Sink};
use crate::stream::{
    AxisMap, BlockRecord, CALLS_BY, Call, Data, EndRecord, FileRecord, Motion, Record, Rows as Filler, program_record,
    record_text,
};

/// Millimetres.
pub(super) const MM: &str = "mm";
/// Degrees.
pub(super) const DEG: &str = "deg";

/// The block stream as columns: a reader of executed blocks.
pub struct BlockTable<'o> {
    rows: Rows<'o>,
    part: Part,
    totals: Totals,
    filler: Filler,
    records: Records,
    files: Vec<String>,
}

impl fmt::Debug for BlockTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("BlockTable").field("part", &self.part).finish_non_exhaustive()
    }
}

impl<'o> BlockTable<'o> {
    /// Gives record batches of a part of the blocks to `out`. What that fails with goes to `failed`, and ends the
    /// reading.
    pub fn new(part: Part, out: &'o mut (dyn Batches + Send), failed: &'o mut Option<io::Error>) -> Self {
        Self {
            rows: Rows::new(out, failed),
            part,
            totals: Totals::new(),
            filler: Filler::default(),
            records: Records::new(Vec::new()),
            files: Vec::new(),
        }
    }
}

impl Sink for BlockTable<'_> {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        let axes: Vec<Axis> = program.settings.machine.axes.iter().collect();
        put::<false>(&mut self.rows.table, &BlockRecord::default(), &axes);
        put::<true>(&mut self.rows.table, &BlockRecord::default(), &axes);
        self.records = Records::new(axes);
        self.rows.begin(PROGRAM, &record_text(&Record::Program(Box::new(program_record(program)))));
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        if usize::try_from(block.file_index()).is_ok_and(|index| index == self.files.len() + 1) {
            let record = FileRecord { index: block.file_index(), name: block.file_name().to_owned() };
            self.files.push(record_text(&Record::File(record)));
        }
        if !self.part.contains(block.seq()) {
            self.totals.add(block);
            return ControlFlow::Continue(());
        }
        let Self { rows, totals, filler, records, .. } = self;
        records.push(rows, |record, before| {
            let follows = filler.fill_changes(block, record, before);
            let motion = record.motion.as_ref();
            totals.add_motion(motion.and_then(|motion| Some((motion.kind, motion.length_mm?))));
            follows
        });
        if self.rows.goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    fn end(mut self, end: End, _: &mut Findings) -> End {
        let record = EndRecord {
            reason: end.reason(),
            blocks: end.blocks(),
            path_mm: self.totals.path(),
            path_mm_by_type: self.totals.by_type().collect(),
        };
        self.records.finish(&mut self.rows);
        self.rows.end(&LastBatch::new(&record_text(&Record::End(record)), &self.files));
        end
    }
}

/// The name of an axis behind what it is of, in lower case.
struct Of<'n>(&'n str, AxisLetter);

impl Display for Of<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.0, self.1.letter().to_ascii_lowercase())
    }
}

fn whole(value: Option<Decimal>) -> Option<u32> {
    value.and_then(Decimal::as_whole).and_then(|value| u32::try_from(value).ok())
}

fn decimal(value: Option<Decimal>) -> Option<f64> {
    value.map(|value| Micro::from(value).to_f64())
}

fn micro(value: Option<Micro>) -> Option<f64> {
    value.map(Micro::to_f64)
}

/// Letters with their values, by name.
fn letters(values: &[(char, Decimal)]) -> impl Iterator<Item = (String, f64)> {
    values.iter().map(|(letter, value)| (letter.to_string(), Micro::from(*value).to_f64()))
}

/// Marks a field that may differ in a row that follows the one before.
const MOVES: bool = true;

/// Puts the fields of a record into their columns: a new field does not compile until it has its column. Behind a field
/// stands the kind of its column, with its unit, or `so` and the code that puts it. A row that follows the one before
/// has only the fields with the mark [`MOVES`].
macro_rules! columns {
    ($follows:ident, $table:ident, $record:ident {
        $($name:ident $($moves:ident)?: $kind:ident $(($unit:literal))? $({ $($code:tt)* })?),* $(,)?
    }) => {
        let BlockRecord { $($name),* } = $record;
        $(if !$follows $(|| $moves)? {
            column!($table, $name, $kind $(($unit))? $({ $($code)* })?);
        })*
    };
}

macro_rules! column {
    ($table:ident, $name:ident, so { $($code:tt)* }) => {
        $($code)*
    };
    ($table:ident, $name:ident, whole) => {
        $table.whole(stringify!($name), "", Some(*$name));
    };
    ($table:ident, $name:ident, whole_of($unit:literal)) => {
        $table.whole(stringify!($name), $unit, whole(*$name));
    };
    ($table:ident, $name:ident, decimal) => {
        $table.number(stringify!($name), "", decimal(*$name));
    };
    ($table:ident, $name:ident, by_value $kind:ident) => {
        $table.$kind(stringify!($name), *$name);
    };
    ($table:ident, $name:ident, flag) => {
        column!($table, $name, by_value flag);
    };
    ($table:ident, $name:ident, byte) => {
        column!($table, $name, by_value byte);
    };
    ($table:ident, $name:ident, $kind:ident) => {
        $table.$kind(stringify!($name), $name);
    };
}

/// Puts a record into the next row. `FOLLOWS`: only what may differ from the row before.
pub(super) fn put<const FOLLOWS: bool>(table: &mut Table, record: &BlockRecord, axes: &[Axis]) {
    table.begin_row(FOLLOWS);
    columns!(FOLLOWS, table, record {
        seq MOVES: so { table.long("seq", Some(*seq)); },
        n MOVES: whole,
        file MOVES: whole,
        line MOVES: whole,
        column MOVES: whole,
        calls: so { put_calls(table, calls); },
        jump: so {
            table.whole("jump_to", "", jump.map(|Jump { to, left: _ }| to));
            table.whole("jump_left", "", jump.and_then(|jump| jump.left));
        },
        skippable: flag,
        first_block MOVES: flag,
        last_block: flag,
        g: fixed,
        g_set: bytes,
        m: fixed,
        m_set: bytes,
        m_changed: bytes,
        m_at_stop: so { put_m_at_stop(table, *m_at_stop); },
        break_cont: flag,
        break_cont_end: flag,
        change_pos: flag,
        gear: byte,
        motion MOVES: so { put_motion(table, motion.as_ref(), axes); },
        position MOVES: so { put_axes(table, "", Some(position), axes); },
        feed: decimal,
        feed_unit MOVES: so {
            let units = || FeedUnit::ALL.into_iter().map(FeedUnit::name);
            table.name("feed_unit", units, feed_unit.map(|unit| unit as usize));
        },
        feed_scale: decimal,
        tool: whole_of(""),
        rev_feed: flag,
        const_cut_speed: flag,
        s: whole_of("rev/min"),
        t: whole_of(""),
        h: decimal,
        p: whole_of(""),
        d: whole_of(""),
        t_set: flag,
        h_set: flag,
        p_set: flag,
        d_set: flag,
        s_set: flag,
        f_set: flag,
        length_correction: so {
            let digits = length_correction.map(|digits| format!("{digits:04}"));
            table.text("length_correction", digits.as_deref());
        },
        dwell_s: so { table.number("dwell_s", "s", micro(*dwell_s)); },
        stop: flag,
        cond_stop: flag,
        continuous_mode: flag,
        dynamic_set: byte,
        opaque_call: so { table.whole("opaque_call", "", *opaque_call); },
        data: so { put_data(table, data.as_ref()); },
        words: so { table.map("words", "", letters(words)); },
        params: so {
            let value = |(index, value): &(u8, Decimal)| (format!("R{index}"), Micro::from(*value).to_f64());
            table.map("params", "", params.iter().map(value));
        },
        comments MOVES: texts,
    });
}

fn put_calls(table: &mut Table, calls: &[Call]) {
    let row = |call: &Call| {
        let Call { by, l, file, n, line, pass, of } = *call;
        (CALLS_BY.iter().position(|name| *name == by).unwrap_or(0), [l, file, n, line, pass, of])
    };
    let rows = (!calls.is_empty()).then(|| calls.iter().map(row));
    table.structs("calls", || ("by", CALLS_BY.into_iter()), &["l", "file", "n", "line", "pass", "of"], rows);
}

fn put_m_at_stop(table: &mut Table, m_at_stop: Option<MStop>) {
    let groups = m_at_stop.map(|MStop { spindle, coolant_12, coolant_34 }| {
        [("2", spindle), ("5", coolant_12), ("6", coolant_34)].map(|(group, m)| (group, u64::from(m)))
    });
    table.counts("m_at_stop", groups.into_iter().flatten());
}

fn put_axes(table: &mut Table, name: &str, values: Option<&AxisMap>, axes: &[Axis]) {
    for axis in axes {
        let unit = if axis.rotary { DEG } else { MM };
        table.number(Of(name, axis.letter), unit, micro(values.and_then(|values| values.get(axis.letter))));
    }
}

fn put_data(table: &mut Table, data: Option<&Data>) {
    table.byte("data_g", data.map(|Data { g, origin: _, d: _, values: _ }| *g));
    table.byte("data_origin", data.and_then(|data| data.origin));
    table.whole("data_d", "", whole(data.and_then(|data| data.d)));
    table.map("data_values", "", letters(data.map_or(&[], |data| data.values.as_slice())));
}

fn put_motion(table: &mut Table, motion: Option<&Motion>, axes: &[Axis]) {
    let names = || AxisLetter::ALL.into_iter().map(AxisLetter::name);
    let kinds = || MotionType::ALL.into_iter().map(MotionType::name);
    table.name("motion_type", kinds, motion.map(|motion| motion.kind as usize));
    let moved = motion.filter(|motion| motion.axes.iter().next().is_some());
    let moved = moved.map(|motion| motion.axes.iter().map(|axis| axis as usize));
    table.names("motion_axes", names, moved);
    put_axes(table, "motion_start_", motion.map(|motion| &motion.start), axes);
    put_axes(table, "motion_delta_", motion.map(|motion| &motion.delta), axes);
    table.number("motion_length_mm", MM, micro(motion.and_then(|motion| motion.length_mm)));
    table.number("motion_length_deg", DEG, micro(motion.and_then(|motion| motion.length_deg)));
    let missing = motion.and_then(|motion| motion.length_missing).map(|missing| missing as usize);
    table.name("motion_length_missing", || Missing::ALL.into_iter().map(Missing::name), missing);
    let plane = motion
        .and_then(|motion| motion.plane)
        .map(|[first, second]| first as usize * AxisLetter::ALL.len() + second as usize);
    let pairs =
        || AxisLetter::ALL.into_iter().flat_map(|first| AxisLetter::ALL.map(|second| format!("{first}{second}")));
    table.name("motion_plane", pairs, plane);
    put_axes(table, "motion_center_", motion.map(|motion| &motion.center), axes);
    table.number("motion_radius_mm", MM, micro(motion.and_then(|motion| motion.radius_mm)));
    table.number("motion_sweep_deg", DEG, micro(motion.and_then(|motion| motion.sweep_deg)));
    let spindle = motion.and_then(|motion| motion.spindle_axis).map(|axis| axis as usize);
    table.name("motion_spindle_axis", names, spindle);
}
