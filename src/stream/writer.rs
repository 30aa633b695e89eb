//! The JSON of records. Each function takes its record apart by pattern, so that a new field does not compile until it
//! is written.

use super::json_line::{Line, byte, key};
use super::records::{
    AxisRecord, BlockRecord, Call, Data, EndRecord, FileRecord, GearRecord, MFunctionRecord, Motion, ProgramRecord,
    Record,
};
use crate::dict::AxisLetter;
use crate::run::{Jump, MStop};

/// Writes the fields of a record in this order: a new one does not compile until it is written. Behind a field stands
/// its kind, or `so` and the code that writes it; a kind with `_if` leaves out what is not there.
macro_rules! fields {
    ($json:ident, $record:expr, $type:ident { $($name:ident: $kind:ident $({ $($code:tt)* })?),* $(,)? }) => {
        let $type { $($name),* } = $record;
        $(field!($json, $name, $kind $({ $($code)* })?);)*
    };
}

macro_rules! field {
    ($json:ident, $name:ident, so { $($code:tt)* }) => {
        $($code)*
    };
    ($json:ident, $name:ident, int) => {
        $json = $json.int_field(key!($name), u64::from(*$name));
    };
    ($json:ident, $name:ident, int_if) => {
        if let Some(value) = *$name {
            $json = $json.int_field(key!($name), u64::from(value));
        }
    };
    ($json:ident, $name:ident, number_if) => {
        if let Some(value) = *$name {
            $json = $json.number_field(key!($name), value);
        }
    };
    ($json:ident, $name:ident, decimal) => {
        $json = $json.decimal_field(key!($name), *$name);
    };
    ($json:ident, $name:ident, string) => {
        $json = $json.string_field(key!($name), $name);
    };
    ($json:ident, $name:ident, strings) => {
        if !$name.is_empty() {
            $json = $json.put(key!($name)).list($name, |json, text| json.string(text));
        }
    };
    ($json:ident, $name:ident, word_if) => {
        if let Some(value) = *$name {
            $json = $json.put(key!($name)).put(b"\"").put_all(value.name().as_bytes()).put(b"\"");
        }
    };
    ($json:ident, $name:ident, letter_if) => {
        if let Some(axis) = *$name {
            $json = $json.put(key!($name)).put(&[b'"', byte(axis.letter()), b'"']);
        }
    };
    ($json:ident, $name:ident, axes { $order:expr }) => {
        $json = $json.axis_map(key!($name), $name, $order);
    };
    ($json:ident, $name:ident, flag) => {
        $json = $json.flag(key!($name), *$name);
    };
    // Lists and maps that are written by a function of the line.
    ($json:ident, $name:ident, $kind:ident) => {
        $json = $json.$kind(key!($name), $name);
    };
}

/// Writes the `program` record and its line end.
fn write_program(out: &mut Vec<u8>, record: &ProgramRecord) {
    let mut room = Vec::new();
    let mut json = Line::new(&mut room).put(br#"{"kind":"program""#);
    fields!(json, record, ProgramRecord {
        schema: string,
        generator: string,
        dialect: string,
        number: int,
        title: so {
            if let Some(title) = title {
                json = json.string_field(key!(title), title);
            }
        },
        comments: strings,
        name: string,
        axes: so { json = json.put(key!(axes)).list(axes, axis); },
        block_skip: flag,
        optional_stop: flag,
        parameters: parameters,
        start: axes { &AxisLetter::ALL },
        gears: so {
            if !gears.is_empty() {
                json = json.put(key!(gears)).list(gears, gear);
            }
        },
        cycles: so {
            let mut before = br#","cycles":{"G"#.as_slice();
            for (cycle, macrocycle) in cycles {
                json = json.put_all(before).int(u64::from(*cycle)).put(b"\":").int(u64::from(*macrocycle));
                before = b",\"G";
            }
            if !cycles.is_empty() {
                json = json.put(b"}");
            }
        },
        g97: string,
        arc_centers: string,
        arc_tolerance: so { json = json.decimal_field(key!(arc_tolerance), Some(*arc_tolerance)); },
        spindle_axis: letter_if,
        m_functions: so {
            if !m_functions.is_empty() {
                json = json.put(key!(m_functions)).list(m_functions, m_function);
            }
        },
    });
    out.extend_from_slice(json.put(b"}\n").text());
}

fn axis<'r>(json: Line<'r>, AxisRecord { letter, kind }: &AxisRecord) -> Line<'r> {
    json.put(br#"{"letter":"#).string(letter).string_field(key!(kind), kind).put(b"}")
}

fn gear<'r>(json: Line<'r>, gear: &GearRecord) -> Line<'r> {
    let GearRecord { m, min, max, output } = *gear;
    let json = json.put(br#"{"m":"#).int(u64::from(m)).int_field(key!(min), u64::from(min));
    json.int_field(key!(max), u64::from(max)).decimal_field(key!(output), output).put(b"}")
}

fn m_function<'r>(json: Line<'r>, function: &MFunctionRecord) -> Line<'r> {
    let MFunctionRecord { no, group, break_cont, break_cont_end, change_pos } = *function;
    let json = json.put(br#"{"no":"#).int(u64::from(no)).int_field(key!(group), u64::from(group));
    let json = json.flag(key!(break_cont), break_cont).flag(key!(break_cont_end), break_cont_end);
    json.flag(key!(change_pos), change_pos).put(b"}")
}

/// Writes a `file` record and its line end.
fn write_file(out: &mut Vec<u8>, record: &FileRecord) {
    let mut room = Vec::new();
    let mut json = Line::new(&mut room).put(br#"{"kind":"file""#);
    fields!(json, record, FileRecord { index: int, name: string });
    out.extend_from_slice(json.put(b"}\n").text());
}

/// Writes the `end` record and its line end.
fn write_end(out: &mut Vec<u8>, record: &EndRecord) {
    let mut room = Vec::new();
    let mut json = Line::new(&mut room).put(br#"{"kind":"end""#);
    fields!(json, record, EndRecord {
        reason: string,
        blocks: int,
        path_mm: so { json = json.number_field(key!(path_mm), *path_mm); },
        path_mm_by_type: so {
            let mut before = br#","path_mm_by_type":{"#.as_slice();
            for &(kind, length) in path_mm_by_type {
                json = json.put_all(before).string(kind.name()).put(b":").number(length);
                before = b",";
            }
            if !path_mm_by_type.is_empty() {
                json = json.put(b"}");
            }
        },
    });
    out.extend_from_slice(json.put(b"}\n").text());
}

/// The JSON of a part of records that seldom changes from one to the next.
#[derive(Debug)]
struct Repeated<T> {
    value: T,
    json: Vec<u8>,
}

impl<T: Clone + PartialEq> Repeated<T> {
    /// The JSON of `value`, written anew only when it is another one than before.
    #[inline]
    fn of(&mut self, value: &T, write: impl Fn(Line<'_>, &T) -> usize) -> &[u8] {
        if self.json.is_empty() || self.value != *value {
            self.value.clone_from(value);
            let end = write(Line::new(&mut self.json), value);
            self.json.truncate(end);
        }
        &self.json
    }
}

impl<T: Default> Default for Repeated<T> {
    fn default() -> Self {
        Self { value: T::default(), json: Vec::new() }
    }
}

/// Writes records.
#[derive(Debug)]
pub(super) struct Writer {
    axes: Vec<AxisLetter>,
    /// Room for a line.
    room: Vec<u8>,
    parts: Parts,
}

/// Parts of records that seldom change.
#[derive(Debug, Default)]
struct Parts {
    calls: Repeated<Vec<Call>>,
    g: Repeated<[Option<u8>; 12]>,
    m: Repeated<[Option<u8>; 15]>,
}

impl Writer {
    /// For a machine with these axes, in its order.
    pub(super) fn new(axes: &[AxisLetter]) -> Self {
        Self { axes: axes.to_vec(), room: Vec::new(), parts: Parts::default() }
    }

    /// Writes a record and its line end.
    pub(super) fn write_record(&mut self, out: &mut Vec<u8>, record: &Record) {
        match record {
            Record::Program(record) => write_program(out, record),
            Record::File(record) => write_file(out, record),
            Record::Block(record) => self.write(out, record),
            Record::End(record) => write_end(out, record),
        }
    }

    /// Writes a `block` record and its line end.
    pub(super) fn write(&mut self, out: &mut Vec<u8>, record: &BlockRecord) {
        let Self { axes, room, parts } = self;
        out.extend_from_slice(block(Line::new(room), record, axes, parts).text());
    }
}

/// A record alone, without its line end.
#[cfg(feature = "arrow")]
pub(crate) fn record_text(record: &Record) -> String {
    let mut out = Vec::new();
    Writer::new(&AxisLetter::ALL).write_record(&mut out, record);
    String::from_utf8(out).unwrap_or_default().trim_end().to_owned()
}

fn block<'r>(mut json: Line<'r>, record: &BlockRecord, order: &[AxisLetter], parts: &mut Parts) -> Line<'r> {
    json = json.put(br#"{"kind":"block""#);
    fields!(json, record, BlockRecord {
        seq: int,
        n: int,
        file: int,
        line: int,
        column: int,
        calls: so {
            if !calls.is_empty() {
                json = json.put_all(parts.calls.of(calls, |json, calls| json.put(key!(calls)).list(calls, call).at));
            }
        },
        jump: so {
            if let Some(jumped) = *jump {
                json = self::jump(json, jumped);
            }
        },
        skippable: flag,
        first_block: flag,
        last_block: flag,
        g: so { json = json.put_all(parts.g.of(g, |json, g| json.put(key!(g)).functions(g).at)); },
        g_set: numbers,
        m: so { json = json.put_all(parts.m.of(m, |json, m| json.put(key!(m)).functions(m).at)); },
        m_set: numbers,
        m_changed: numbers,
        m_at_stop: so {
            if let Some(functions) = *m_at_stop {
                json = self::m_at_stop(json, functions);
            }
        },
        break_cont: flag,
        break_cont_end: flag,
        change_pos: flag,
        gear: int_if,
        motion: so {
            if let Some(moved) = motion {
                json = self::motion(json, moved, order);
            }
        },
        position: axes { order },
        feed: decimal,
        feed_unit: word_if,
        feed_scale: decimal,
        tool: decimal,
        rev_feed: flag,
        const_cut_speed: flag,
        s: decimal,
        t: decimal,
        h: decimal,
        p: decimal,
        d: decimal,
        t_set: flag,
        h_set: flag,
        p_set: flag,
        d_set: flag,
        s_set: flag,
        f_set: flag,
        length_correction: so {
            if let Some(digits) = *length_correction {
                json = json.string_field(key!(length_correction), &format!("{digits:04}"));
            }
        },
        dwell_s: number_if,
        stop: flag,
        cond_stop: flag,
        continuous_mode: flag,
        dynamic_set: int_if,
        opaque_call: int_if,
        data: so {
            if let Some(words) = data {
                json = self::data(json, words);
            }
        },
        words: letters,
        params: parameters,
        comments: strings,
    });
    json.put(b"}\n")
}

fn jump<'r>(json: Line<'r>, Jump { to, left }: Jump) -> Line<'r> {
    let json = json.put(br#","jump":{"to":"#).int(u64::from(to));
    match left {
        Some(left) => json.int_field(key!(left), u64::from(left)).put(b"}"),
        None => json.put(b"}"),
    }
}

fn m_at_stop<'r>(json: Line<'r>, MStop { spindle, coolant_12, coolant_34 }: MStop) -> Line<'r> {
    let json = json.put(br#","m_at_stop":{"2":"#).int(u64::from(spindle)).int_field(key!("5"), u64::from(coolant_12));
    json.int_field(key!("6"), u64::from(coolant_34)).put(b"}")
}

fn call<'r>(json: Line<'r>, call: &Call) -> Line<'r> {
    let Call { by, l, file, n, line, pass, of } = *call;
    json.put(br#"{"by":"#)
        .string(by)
        .int_field(key!(l), u64::from(l))
        .int_field(key!(file), u64::from(file))
        .int_field(key!(n), u64::from(n))
        .int_field(key!(line), u64::from(line))
        .int_field(key!(pass), u64::from(pass))
        .int_field(key!(of), u64::from(of))
        .put(b"}")
}

#[inline]
fn motion<'r>(mut json: Line<'r>, motion: &Motion, order: &[AxisLetter]) -> Line<'r> {
    fields!(json, motion, Motion {
        kind: so { json = json.put(br#","motion":{"type":""#).put_all(kind.name().as_bytes()).put(b"\""); },
        axes: so {
            let mut open = false;
            for axis in axes.iter() {
                json = if open { json.put(b",") } else { json.put(br#","axes":["#) };
                json = json.put(&[b'"', byte(axis.letter()), b'"']);
                open = true;
            }
            if open {
                json = json.put(b"]");
            }
        },
        start: axes { order },
        delta: axes { order },
        length_mm: number_if,
        length_deg: number_if,
        length_missing: word_if,
        plane: so {
            if let Some([first, second]) = *plane {
                json = json.put(key!(plane)).put(&[b'"', byte(first.letter()), byte(second.letter()), b'"']);
            }
        },
        center: axes { order },
        radius_mm: number_if,
        sweep_deg: number_if,
        spindle_axis: letter_if,
    });
    json.put(b"}")
}

fn data<'r>(mut json: Line<'r>, data: &Data) -> Line<'r> {
    fields!(json, data, Data {
        g: so { json = json.put(br#","data":{"g":"#).int(u64::from(*g)); },
        origin: int_if,
        d: decimal,
        values: letters,
    });
    json.put(b"}")
}
