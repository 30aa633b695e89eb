//! The JSON of records, written without intermediate values. Each function takes its record apart by pattern, so that a
//! new field does not compile until it is written.

use super::records::{
    AxisMap, AxisRecord, BlockRecord, Call, Data, EndRecord, FileRecord, GearRecord, MFunctionRecord, Motion,
    ProgramRecord, Record,
};
use crate::dict::{AxisLetter, Decimal, Micro};
use crate::run::{Jump, MStop};
use crate::sure::Sure;
use crate::text::is_unsafe;

/// A field's key with its comma and colon, as bytes of known length.
macro_rules! key {
    ($name:literal) => {{
        const KEY: &str = concat!(",\"", $name, "\":");
        const BYTES: &[u8; KEY.len()] = match KEY.as_bytes().first_chunk() {
            Some(bytes) => bytes,
            None => &[0; KEY.len()],
        };
        BYTES
    }};
}

/// Writes the `program` record and its line end.
fn write_program(out: &mut Vec<u8>, record: &ProgramRecord) {
    let ProgramRecord {
        schema,
        generator,
        dialect,
        number,
        title,
        comments,
        name,
        axes,
        block_skip,
        optional_stop,
        parameters,
        start,
        gears,
        cycles,
        g97,
        arc_centers,
        arc_tolerance,
        spindle_axis,
        m_functions,
    } = record;
    let mut room = Vec::new();
    let mut line = Line::new(&mut room);
    line = line.put(br#"{"kind":"program""#);
    line = line.string_field(key!("schema"), schema);
    line = line.string_field(key!("generator"), generator);
    line = line.string_field(key!("dialect"), dialect);
    line = line.int_field(key!("number"), u64::from(*number));
    if let Some(title) = title {
        line = line.string_field(key!("title"), title);
    }
    if !comments.is_empty() {
        line = line.put(key!("comments")).list(comments, |line, comment| line.string(comment));
    }
    line = line.string_field(key!("name"), name);
    line = line.put(key!("axes")).list(axes, |line, axis| {
        let AxisRecord { letter, kind } = axis;
        line.put(br#"{"letter":"#).string(letter).string_field(key!("kind"), kind).put(b"}")
    });
    line = line.flag(key!("block_skip"), *block_skip);
    line = line.flag(key!("optional_stop"), *optional_stop);
    line = line.parameters(key!("parameters"), parameters);
    line = line.axis_map(key!("start"), start, &AxisLetter::ALL);
    if !gears.is_empty() {
        line = line.put(key!("gears")).list(gears, |line, gear| {
            let GearRecord { m, min, max } = *gear;
            line.put(br#"{"m":"#)
                .int(u64::from(m))
                .int_field(key!("min"), u64::from(min))
                .int_field(key!("max"), u64::from(max))
                .put(b"}")
        });
    }
    if !cycles.is_empty() {
        line = line.put(key!("cycles"));
        let mut before = b"{\"G";
        for (cycle, macrocycle) in cycles {
            line = line.put(before).int(u64::from(*cycle)).put(b"\":").int(u64::from(*macrocycle));
            before = b",\"G";
        }
        line = line.put(b"}");
    }
    line = line.string_field(key!("g97"), g97);
    line = line.string_field(key!("arc_centers"), arc_centers);
    line = line.decimal_field(key!("arc_tolerance"), Some(*arc_tolerance));
    if let Some(axis) = *spindle_axis {
        line = line.put(key!("spindle_axis")).put(&[b'"', byte(axis.letter()), b'"']);
    }
    if !m_functions.is_empty() {
        line = line.put(key!("m_functions")).list(m_functions, |line, function| {
            let MFunctionRecord { no, group, break_cont, break_cont_end, change_pos } = *function;
            line.put(br#"{"no":"#)
                .int(u64::from(no))
                .int_field(key!("group"), u64::from(group))
                .flag(key!("break_cont"), break_cont)
                .flag(key!("break_cont_end"), break_cont_end)
                .flag(key!("change_pos"), change_pos)
                .put(b"}")
        });
    }
    out.extend_from_slice(line.put(b"}\n").text());
}

/// Writes a `file` record and its line end.
fn write_file(out: &mut Vec<u8>, record: &FileRecord) {
    let FileRecord { index, name } = record;
    let mut room = Vec::new();
    let line = Line::new(&mut room).put(br#"{"kind":"file""#);
    let line = line.int_field(key!("index"), u64::from(*index)).string_field(key!("name"), name);
    out.extend_from_slice(line.put(b"}\n").text());
}

/// Writes the `end` record and its line end.
fn write_end(out: &mut Vec<u8>, record: &EndRecord) {
    let EndRecord { reason, blocks, path_mm, path_mm_by_type } = record;
    let mut room = Vec::new();
    let mut line = Line::new(&mut room).put(br#"{"kind":"end""#);
    line = line.string_field(key!("reason"), reason);
    line = line.int_field(key!("blocks"), *blocks);
    line = line.number_field(key!("path_mm"), *path_mm);
    if !path_mm_by_type.is_empty() {
        line = line.put(key!("path_mm_by_type"));
        let mut before = b"{";
        for &(kind, length) in path_mm_by_type {
            line = line.put(before).string(kind.name()).put(b":").number(length);
            before = b",";
        }
        line = line.put(b"}");
    }
    out.extend_from_slice(line.put(b"}\n").text());
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

fn block<'r>(mut line: Line<'r>, record: &BlockRecord, axes: &[AxisLetter], parts: &mut Parts) -> Line<'r> {
    let BlockRecord {
        seq,
        n,
        file,
        line: line_number,
        column,
        calls,
        jump,
        skippable,
        first_block,
        last_block,
        g,
        g_set,
        m,
        m_set,
        m_changed,
        m_at_stop,
        break_cont,
        break_cont_end,
        change_pos,
        gear,
        motion,
        position,
        feed,
        feed_unit,
        feed_scale,
        tool,
        rev_feed,
        const_cut_speed,
        s,
        t,
        h,
        p,
        d,
        t_set,
        h_set,
        p_set,
        d_set,
        s_set,
        f_set,
        length_correction,
        dwell_s,
        stop,
        cond_stop,
        continuous_mode,
        dynamic_set,
        opaque_call,
        data,
        words,
        params,
        comments,
    } = record;
    line = line.put(br#"{"kind":"block""#);
    line = line.int_field(key!("seq"), *seq);
    line = line.int_field(key!("n"), u64::from(*n));
    line = line.int_field(key!("file"), u64::from(*file));
    line = line.int_field(key!("line"), u64::from(*line_number));
    line = line.int_field(key!("column"), u64::from(*column));
    if !calls.is_empty() {
        let write = |line: Line<'_>, calls: &Vec<Call>| line.put(key!("calls")).list(calls, call).at;
        line = line.put_all(parts.calls.of(calls, write));
    }
    if let Some(Jump { to, left }) = *jump {
        line = line.put(br#","jump":{"to":"#).int(u64::from(to));
        if let Some(left) = left {
            line = line.int_field(key!("left"), u64::from(left));
        }
        line = line.put(b"}");
    }
    line = line.flag(key!("skippable"), *skippable);
    line = line.flag(key!("first_block"), *first_block);
    line = line.flag(key!("last_block"), *last_block);
    line = line.put_all(parts.g.of(g, |line, g| line.put(key!("g")).functions(g).at));
    line = line.numbers_field(key!("g_set"), g_set);
    line = line.put_all(parts.m.of(m, |line, m| line.put(key!("m")).functions(m).at));
    line = line.numbers_field(key!("m_set"), m_set);
    line = line.numbers_field(key!("m_changed"), m_changed);
    if let Some(MStop { spindle, coolant_12, coolant_34 }) = *m_at_stop {
        line = line.put(br#","m_at_stop":{"2":"#).int(u64::from(spindle));
        line = line.int_field(key!("5"), u64::from(coolant_12));
        line = line.int_field(key!("6"), u64::from(coolant_34)).put(b"}");
    }
    line = line.flag(key!("break_cont"), *break_cont);
    line = line.flag(key!("break_cont_end"), *break_cont_end);
    line = line.flag(key!("change_pos"), *change_pos);
    if let Some(gear) = *gear {
        line = line.int_field(key!("gear"), u64::from(gear));
    }
    if let Some(moved) = motion {
        line = self::motion(line, moved, axes);
    }
    line = line.axis_map(key!("position"), position, axes);
    line = line.decimal_field(key!("feed"), *feed);
    if let Some(unit) = *feed_unit {
        line = line.put(key!("feed_unit")).put(b"\"").put_all(unit.name().as_bytes()).put(b"\"");
    }
    line = line.decimal_field(key!("feed_scale"), *feed_scale);
    line = line.decimal_field(key!("tool"), *tool);
    line = line.flag(key!("rev_feed"), *rev_feed);
    line = line.flag(key!("const_cut_speed"), *const_cut_speed);
    line = line.decimal_field(key!("s"), *s);
    line = line.decimal_field(key!("t"), *t);
    line = line.decimal_field(key!("h"), *h);
    line = line.decimal_field(key!("p"), *p);
    line = line.decimal_field(key!("d"), *d);
    line = line.flag(key!("t_set"), *t_set);
    line = line.flag(key!("h_set"), *h_set);
    line = line.flag(key!("p_set"), *p_set);
    line = line.flag(key!("d_set"), *d_set);
    line = line.flag(key!("s_set"), *s_set);
    line = line.flag(key!("f_set"), *f_set);
    if let Some(digits) = *length_correction {
        line = line.string_field(key!("length_correction"), &format!("{digits:04}"));
    }
    if let Some(dwell) = *dwell_s {
        line = line.number_field(key!("dwell_s"), dwell);
    }
    line = line.flag(key!("stop"), *stop);
    line = line.flag(key!("cond_stop"), *cond_stop);
    line = line.flag(key!("continuous_mode"), *continuous_mode);
    if let Some(set) = *dynamic_set {
        line = line.int_field(key!("dynamic_set"), u64::from(set));
    }
    if let Some(l) = *opaque_call {
        line = line.int_field(key!("opaque_call"), u64::from(l));
    }
    if let Some(words) = data {
        line = self::data(line, words);
    }
    line = line.letters(key!("words"), words);
    line = line.parameters(key!("params"), params);
    if !comments.is_empty() {
        line = line.put(key!("comments")).list(comments, |line, comment| line.string(comment));
    }
    line.put(b"}\n")
}

fn call<'r>(line: Line<'r>, call: &Call) -> Line<'r> {
    let Call { by, l, file, n, line: line_number, pass, of } = *call;
    line.put(br#"{"by":"#)
        .string(by)
        .int_field(key!("l"), u64::from(l))
        .int_field(key!("file"), u64::from(file))
        .int_field(key!("n"), u64::from(n))
        .int_field(key!("line"), u64::from(line_number))
        .int_field(key!("pass"), u64::from(pass))
        .int_field(key!("of"), u64::from(of))
        .put(b"}")
}

#[inline]
fn motion<'r>(mut line: Line<'r>, motion: &Motion, order: &[AxisLetter]) -> Line<'r> {
    let Motion {
        kind,
        axes,
        start,
        delta,
        length_mm,
        length_deg,
        length_missing,
        plane,
        center,
        radius_mm,
        sweep_deg,
        spindle_axis,
    } = motion;
    line = line.put(br#","motion":{"type":""#).put_all(kind.name().as_bytes()).put(b"\"");
    let mut open = false;
    for axis in axes.iter() {
        line = if open { line.put(b",") } else { line.put(br#","axes":["#) };
        line = line.put(&[b'"', byte(axis.letter()), b'"']);
        open = true;
    }
    if open {
        line = line.put(b"]");
    }
    line = line.axis_map(key!("start"), start, order);
    line = line.axis_map(key!("delta"), delta, order);
    if let Some(length) = *length_mm {
        line = line.number_field(key!("length_mm"), length);
    }
    if let Some(length) = *length_deg {
        line = line.number_field(key!("length_deg"), length);
    }
    if let Some(missing) = *length_missing {
        line = line.put(key!("length_missing")).put(b"\"").put_all(missing.name().as_bytes()).put(b"\"");
    }
    if let Some([first, second]) = *plane {
        line = line.put(key!("plane")).put(&[b'"', byte(first.letter()), byte(second.letter()), b'"']);
    }
    line = line.axis_map(key!("center"), center, order);
    if let Some(radius) = *radius_mm {
        line = line.number_field(key!("radius_mm"), radius);
    }
    if let Some(sweep) = *sweep_deg {
        line = line.number_field(key!("sweep_deg"), sweep);
    }
    if let Some(axis) = *spindle_axis {
        line = line.put(key!("spindle_axis")).put(&[b'"', byte(axis.letter()), b'"']);
    }
    line.put(b"}")
}

fn data<'r>(mut line: Line<'r>, data: &Data) -> Line<'r> {
    let Data { g, origin, d, values } = data;
    line = line.put(br#","data":{"g":"#).int(u64::from(*g));
    if let Some(origin) = *origin {
        line = line.int_field(key!("origin"), u64::from(origin));
    }
    line.decimal_field(key!("d"), *d).letters(key!("values"), values).put(b"}")
}

/// The letter of an address, which is ASCII.
fn byte(letter: char) -> u8 {
    u8::try_from(letter).unwrap_or(b'?')
}

/// More than eight digits hold.
const EIGHT: u64 = 100_000_000;
/// Eight characters `0`.
const ZEROS: u64 = 0x3030_3030_3030_3030;
/// Four of them.
const FOUR_ZEROS: u32 = 0x3030_3030;

/// The digits of a number below 10000, a byte each, the first one in the lowest byte.
#[inline]
const fn four_digits(value: u32) -> u32 {
    let (high, low) = (value / 100, value % 100);
    (high / 10) | ((high % 10) << 8) | ((low / 10) << 16) | ((low % 10) << 24)
}

/// The eight digits of a number below [`EIGHT`], a byte each, the first one in the lowest byte.
#[inline]
const fn digits(value: u32) -> u64 {
    four_digits(value / 10_000) as u64 | ((four_digits(value % 10_000) as u64) << 32)
}

/// A line being written. It is handed on by value, so that its end stays in a register: there are sixty things to write in
/// a record, each of which would wait for the one before.
struct Line<'r> {
    /// Its beginning, and room for more.
    room: &'r mut Vec<u8>,
    /// Its end.
    at: usize,
}

impl<'r> Line<'r> {
    /// An empty line. `room`: used again for the next.
    fn new(room: &'r mut Vec<u8>) -> Self {
        Self { room, at: 0 }
    }

    /// The text written up to now.
    fn text(&self) -> &[u8] {
        self.room.get(..self.at).sure()
    }

    /// Writes text of a length known beforehand.
    #[inline(always)]
    fn put<const N: usize>(self, text: &[u8; N]) -> Self {
        let end = self.at + N;
        if end > self.room.len() {
            make_room(self.room, end);
        }
        if let Some(place) = self.room.get_mut(self.at..end) {
            place.copy_from_slice(text);
        }
        Self { at: end, ..self }
    }

    /// Writes text of any length.
    #[inline]
    fn put_all(self, text: &[u8]) -> Self {
        let end = self.at + text.len();
        if end > self.room.len() {
            make_room(self.room, end);
        }
        if let Some(place) = self.room.get_mut(self.at..end) {
            place.copy_from_slice(text);
        }
        Self { at: end, ..self }
    }

    #[inline(always)]
    fn flag<const N: usize>(self, key: &[u8; N], value: bool) -> Self {
        if value { self.put(key).put(b"true") } else { self }
    }

    #[inline(always)]
    fn int(self, value: u64) -> Self {
        // Most have one digit or two.
        match u8::try_from(value) {
            Ok(value @ 0..=9) => self.put(&[b'0' + value]),
            Ok(value @ 10..=99) => self.put(&[b'0' + value / 10, b'0' + value % 10]),
            _ => self.long_int(value),
        }
    }

    fn long_int(self, value: u64) -> Self {
        // All digits are put down, without those before the first that counts, and the end is then taken back: a copy of
        // fixed length is quicker than one that fits.
        if let Some(value) = u32::try_from(value).ok().filter(|value| *value < 10_000) {
            let digits = four_digits(value);
            let unused = (digits.trailing_zeros() / 8).min(3);
            let line = self.put(&((digits | FOUR_ZEROS) >> (8 * unused)).to_le_bytes());
            return Self { at: line.at - unused as usize, ..line };
        }
        let (high, low) = (value / EIGHT, u32::try_from(value % EIGHT).unwrap_or(0));
        if high > 0 {
            return self.int(high).put(&(digits(low) | ZEROS).to_le_bytes());
        }
        let digits = digits(low);
        let unused = (digits.trailing_zeros() / 8).min(7);
        let line = self.put(&((digits | ZEROS) >> (8 * unused)).to_le_bytes());
        Self { at: line.at - unused as usize, ..line }
    }

    #[inline(always)]
    fn int_field<const N: usize>(self, key: &[u8; N], value: u64) -> Self {
        self.put(key).int(value)
    }

    /// A number without exponent, trailing zeros or a negative zero.
    fn number(self, value: Micro) -> Self {
        let millionths = value.millionths();
        let line = if millionths < 0 { self.put(b"-") } else { self };
        let magnitude = millionths.unsigned_abs();
        let line = line.int(magnitude / 1_000_000);
        let fraction = u32::try_from(magnitude % 1_000_000).unwrap_or(0);
        if fraction == 0 {
            return line;
        }
        if fraction.is_multiple_of(1000) {
            // As programmed.
            let digits = four_digits(fraction / 100);
            let unused = digits.leading_zeros() / 8;
            let line = line.put(b".").put(&(digits | FOUR_ZEROS).to_le_bytes());
            return Self { at: line.at - unused as usize, ..line };
        }
        let digits = digits(fraction * 100);
        let unused = digits.leading_zeros() / 8;
        let line = line.put(b".").put(&(digits | ZEROS).to_le_bytes());
        Self { at: line.at - unused as usize, ..line }
    }

    #[inline(always)]
    fn number_field<const N: usize>(self, key: &[u8; N], value: Micro) -> Self {
        self.put(key).number(value)
    }

    #[inline(always)]
    fn decimal_field<const N: usize>(self, key: &[u8; N], value: Option<Decimal>) -> Self {
        match value {
            Some(value) => self.number_field(key, Micro::from(value)),
            None => self,
        }
    }

    fn list<T>(self, items: &[T], write: impl Fn(Self, &T) -> Self) -> Self {
        let mut line = self.put(b"[");
        for (place, item) in items.iter().enumerate() {
            line = write(if place > 0 { line.put(b",") } else { line }, item);
        }
        line.put(b"]")
    }

    /// A list of functions by group, `null` where none is in force.
    fn functions(self, functions: &[Option<u8>]) -> Self {
        self.list(functions, |line, function| match *function {
            Some(number) => line.int(u64::from(number)),
            None => line.put(b"null"),
        })
    }

    #[inline]
    fn numbers_field<const N: usize>(self, key: &[u8; N], values: &[u8]) -> Self {
        if values.is_empty() {
            return self;
        }
        self.put(key).list(values, |line, value| line.int(u64::from(*value)))
    }

    #[inline]
    fn letters<const N: usize>(self, key: &[u8; N], values: &[(char, Decimal)]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b'{';
        for &(letter, value) in values {
            line = line.put(&[before, b'"', byte(letter), b'"', b':']).number(Micro::from(value));
            before = b',';
        }
        line.put(b"}")
    }

    #[inline]
    fn parameters<const N: usize>(self, key: &[u8; N], values: &[(u8, Decimal)]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b"{\"R";
        for (parameter, value) in values {
            line = line.put(before).int(u64::from(*parameter)).put(b"\":").number(Micro::from(*value));
            before = b",\"R";
        }
        line.put(b"}")
    }

    #[inline]
    fn axis_map<const N: usize>(self, key: &[u8; N], values: &AxisMap, order: &[AxisLetter]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b'{';
        for &axis in order {
            let Some(value) = values.get(axis) else { continue };
            line = line.put(&[before, b'"', byte(axis.letter()), b'"', b':']).number(value);
            before = b',';
        }
        line.put(b"}")
    }

    /// A JSON string. What a terminal might act on is escaped.
    fn string(self, text: &str) -> Self {
        let mut line = self.put(b"\"");
        let mut rest = text;
        while let Some(at) = rest.bytes().position(|byte| matches!(byte, b'"' | b'\\' | 0x00..=0x1f | 0x7f..)) {
            let (before, after) = rest.split_at(at);
            line = line.put_all(before.as_bytes());
            let character = after.chars().next().unwrap_or_default();
            let (of_it, behind) = after.split_at(character.len_utf8());
            line = match character {
                '"' => line.put(b"\\\""),
                '\\' => line.put(b"\\\\"),
                '\n' => line.put(b"\\n"),
                '\r' => line.put(b"\\r"),
                '\t' => line.put(b"\\t"),
                _ if is_unsafe(character) => character
                    .encode_utf16(&mut [0; 2])
                    .iter()
                    .fold(line, |line, unit| line.put_all(format!("\\u{unit:04x}").as_bytes())),
                _ => line.put_all(of_it.as_bytes()),
            };
            rest = behind;
        }
        line.put_all(rest.as_bytes()).put(b"\"")
    }

    fn string_field<const N: usize>(self, key: &[u8; N], text: &str) -> Self {
        self.put(key).string(text)
    }
}

/// Makes the room of a line hold at least `end` bytes.
#[cold]
fn make_room(room: &mut Vec<u8>, end: usize) {
    room.resize(end.next_power_of_two().max(1024), 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(millionths: i64) -> String {
        let mut room = Vec::new();
        let line = Line::new(&mut room).number(Micro::from_millionths(millionths));
        String::from_utf8(line.text().to_vec()).unwrap()
    }

    #[test]
    fn numbers() {
        for (millionths, text) in [
            (0, "0"),
            (-1, "-0.000001"),
            (1_500_000, "1.5"),
            (-20_000_000, "-20"),
            (69_999_999_000, "69999.999"),
            (100, "0.0001"),
            (9_000_000, "9"),
            (10_000_000, "10"),
            (100_000_000, "100"),
            (99_999_999_999_999, "99999999.999999"),
            (100_000_000_000_000, "100000000"),
            (1_000_000_020_300_000_000, "1000000020300"),
            (i64::MAX, "9223372036854.775807"),
            (i64::MIN, "-9223372036854.775808"),
        ] {
            assert_eq!(shown(millionths), text);
        }
        assert_eq!(shown(Micro::from_f64(-1e-9).millionths()), "0");
    }

    #[test]
    fn strings() {
        let mut room = Vec::new();
        let line = Line::new(&mut room).string("a\"\\\u{1b}ř\u{7f}ž\u{9b}\u{202e}\u{e0041}日");
        let expected = r#""a\"\\\u001bř\u007fž\u009b\u202e\udb40\udc41日""#;
        assert_eq!(std::str::from_utf8(line.text()).unwrap(), expected);
    }
}
