//! The JSON of records, written without intermediate values. Each function takes its record apart by pattern, so that a
//! new field does not compile until it is written.

use super::{
    AxisMap, BlockRecord, Call, Data, EndRecord, FileRecord, Jump, MFunctionRecord, MStop, Micro, Motion, ProgramRecord,
};
use crate::dict::{AxisLetter, Decimal};

/// A field's key with its comma and colon, as one constant.
macro_rules! key {
    ($name:literal) => {
        concat!(",\"", $name, "\":")
    };
}

/// Writes the `program` record and its line end.
pub fn write_program(out: &mut Vec<u8>, record: &ProgramRecord) {
    let ProgramRecord { schema, generator, dialect, number, title, file, axes, block_skip, optional_stop, m_functions } =
        record;
    out.extend_from_slice(br#"{"kind":"program""#);
    string_field(out, key!("schema"), schema);
    string_field(out, key!("generator"), generator);
    string_field(out, key!("dialect"), dialect);
    int_field(out, key!("number"), u64::from(*number));
    if let Some(title) = title {
        string_field(out, key!("title"), title);
    }
    string_field(out, key!("file"), file);
    key(out, key!("axes"));
    list(out, axes, |out, axis| {
        out.extend_from_slice(br#"{"letter":"#);
        string(out, &axis.letter);
        string_field(out, key!("kind"), &axis.kind);
        out.push(b'}');
    });
    flag(out, key!("block_skip"), *block_skip);
    flag(out, key!("optional_stop"), *optional_stop);
    if !m_functions.is_empty() {
        key(out, key!("m_functions"));
        list(out, m_functions, |out, function| {
            let MFunctionRecord { no, group, break_cont, break_cont_end, change_pos } = *function;
            out.extend_from_slice(br#"{"no":"#);
            int(out, u64::from(no));
            int_field(out, key!("group"), u64::from(group));
            flag(out, key!("break_cont"), break_cont);
            flag(out, key!("break_cont_end"), break_cont_end);
            flag(out, key!("change_pos"), change_pos);
            out.push(b'}');
        });
    }
    out.extend_from_slice(b"}\n");
}

/// Writes a `file` record and its line end.
pub fn write_file(out: &mut Vec<u8>, record: &FileRecord) {
    let FileRecord { index, name } = record;
    out.extend_from_slice(br#"{"kind":"file""#);
    int_field(out, key!("index"), u64::from(*index));
    string_field(out, key!("name"), name);
    out.extend_from_slice(b"}\n");
}

/// Writes the `end` record and its line end.
pub fn write_end(out: &mut Vec<u8>, record: &EndRecord) {
    let EndRecord { reason, blocks, path_mm, path_mm_by_type } = record;
    out.extend_from_slice(br#"{"kind":"end""#);
    string_field(out, key!("reason"), reason);
    int_field(out, key!("blocks"), *blocks);
    number_field(out, key!("path_mm"), *path_mm);
    if !path_mm_by_type.is_empty() {
        key(out, key!("path_mm_by_type"));
        map(out, path_mm_by_type.iter().map(|(kind, length)| (kind.name(), *length)));
    }
    out.extend_from_slice(b"}\n");
}

/// The JSON of a part of records that seldom changes from one to the next.
#[derive(Debug)]
struct Repeated<T> {
    value: T,
    json: Vec<u8>,
}

impl<T: Clone + PartialEq> Repeated<T> {
    /// Writes `value`, anew only when it is another one than before.
    #[inline]
    fn write(&mut self, out: &mut Vec<u8>, value: &T, write: impl Fn(&mut Vec<u8>, &T)) {
        if self.json.is_empty() || self.value != *value {
            self.value.clone_from(value);
            self.json.clear();
            write(&mut self.json, value);
        }
        out.extend_from_slice(&self.json);
    }
}

impl<T: Default> Default for Repeated<T> {
    fn default() -> Self {
        Self { value: T::default(), json: Vec::new() }
    }
}

/// Writes `block` records.
#[derive(Debug)]
pub struct BlockWriter {
    axes: Vec<AxisLetter>,
    calls: Repeated<Vec<Call>>,
    g: Repeated<[Option<u8>; 12]>,
    m: Repeated<[Option<u8>; 15]>,
}

impl BlockWriter {
    /// For a machine with these axes, in its order.
    pub fn new(axes: &[AxisLetter]) -> Self {
        Self { axes: axes.to_vec(), calls: Repeated::default(), g: Repeated::default(), m: Repeated::default() }
    }

    /// Writes a `block` record and its line end.
    pub fn write(&mut self, out: &mut Vec<u8>, record: &BlockRecord) {
        write_block(out, record, self);
    }
}

fn write_block(out: &mut Vec<u8>, record: &BlockRecord, writer: &mut BlockWriter) {
    let BlockWriter { axes, calls: repeated_calls, g: repeated_g, m: repeated_m } = writer;
    let BlockRecord {
        seq,
        n,
        file,
        line,
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
        data,
        words,
        params,
        comments,
    } = record;
    out.extend_from_slice(br#"{"kind":"block""#);
    int_field(out, key!("seq"), *seq);
    int_field(out, key!("n"), u64::from(*n));
    int_field(out, key!("file"), u64::from(*file));
    int_field(out, key!("line"), u64::from(*line));
    int_field(out, key!("column"), u64::from(*column));
    if !calls.is_empty() {
        repeated_calls.write(out, calls, |out, calls| {
            key(out, key!("calls"));
            list(out, calls, |out, call| write_call(out, *call));
        });
    }
    if let Some(Jump { to, left }) = *jump {
        out.extend_from_slice(br#","jump":{"to":"#);
        int(out, u64::from(to));
        if let Some(left) = left {
            int_field(out, key!("left"), u64::from(left));
        }
        out.push(b'}');
    }
    flag(out, key!("skippable"), *skippable);
    flag(out, key!("first_block"), *first_block);
    flag(out, key!("last_block"), *last_block);
    repeated_g.write(out, g, |out, g| {
        key(out, key!("g"));
        list(out, g, write_function);
    });
    numbers_field(out, key!("g_set"), g_set);
    repeated_m.write(out, m, |out, m| {
        key(out, key!("m"));
        list(out, m, write_function);
    });
    numbers_field(out, key!("m_set"), m_set);
    numbers_field(out, key!("m_changed"), m_changed);
    if let Some(MStop { spindle, coolant_12, coolant_34 }) = *m_at_stop {
        out.extend_from_slice(br#","m_at_stop":{"2":"#);
        int(out, u64::from(spindle));
        int_field(out, key!("5"), u64::from(coolant_12));
        int_field(out, key!("6"), u64::from(coolant_34));
        out.push(b'}');
    }
    flag(out, key!("break_cont"), *break_cont);
    flag(out, key!("break_cont_end"), *break_cont_end);
    flag(out, key!("change_pos"), *change_pos);
    if let Some(gear) = *gear {
        int_field(out, key!("gear"), u64::from(gear));
    }
    if let Some(motion) = motion {
        write_motion(out, motion, axes);
    }
    axis_map(out, key!("position"), position, axes);
    decimal_field(out, key!("feed"), *feed);
    flag(out, key!("rev_feed"), *rev_feed);
    flag(out, key!("const_cut_speed"), *const_cut_speed);
    decimal_field(out, key!("s"), *s);
    decimal_field(out, key!("t"), *t);
    decimal_field(out, key!("h"), *h);
    decimal_field(out, key!("p"), *p);
    decimal_field(out, key!("d"), *d);
    flag(out, key!("t_set"), *t_set);
    flag(out, key!("h_set"), *h_set);
    flag(out, key!("p_set"), *p_set);
    flag(out, key!("d_set"), *d_set);
    flag(out, key!("s_set"), *s_set);
    flag(out, key!("f_set"), *f_set);
    if let Some(digits) = *length_correction {
        string_field(out, key!("length_correction"), &format!("{digits:04}"));
    }
    if let Some(dwell) = *dwell_s {
        number_field(out, key!("dwell_s"), dwell);
    }
    flag(out, key!("stop"), *stop);
    flag(out, key!("cond_stop"), *cond_stop);
    flag(out, key!("continuous_mode"), *continuous_mode);
    if let Some(set) = *dynamic_set {
        int_field(out, key!("dynamic_set"), u64::from(set));
    }
    if let Some(data) = data {
        write_data(out, data);
    }
    letters(out, key!("words"), words);
    if !params.is_empty() {
        key(out, key!("params"));
        map(out, params.iter().map(|(parameter, value)| (format!("R{parameter}"), Micro::from(*value))));
    }
    if !comments.is_empty() {
        key(out, key!("comments"));
        list(out, comments, |out, comment| string(out, comment));
    }
    out.extend_from_slice(b"}\n");
}

fn write_function(out: &mut Vec<u8>, function: &Option<u8>) {
    match function {
        Some(number) => int(out, u64::from(*number)),
        None => out.extend_from_slice(b"null"),
    }
}

fn write_call(out: &mut Vec<u8>, call: Call) {
    let Call { by, l, file, n, pass, of } = call;
    out.extend_from_slice(br#"{"by":"#);
    string(out, by);
    int_field(out, key!("l"), u64::from(l));
    int_field(out, key!("file"), u64::from(file));
    int_field(out, key!("n"), u64::from(n));
    int_field(out, key!("pass"), u64::from(pass));
    int_field(out, key!("of"), u64::from(of));
    out.push(b'}');
}

fn write_motion(out: &mut Vec<u8>, motion: &Motion, order: &[AxisLetter]) {
    let Motion { kind, axes, delta, length_mm, length_deg, plane, center, radius_mm, sweep_deg, spindle_axis } = motion;
    out.extend_from_slice(br#","motion":{"type":""#);
    out.extend_from_slice(kind.name().as_bytes());
    out.push(b'"');
    for (place, axis) in axes.iter().enumerate() {
        out.extend_from_slice(if place == 0 { br#","axes":["# } else { b"," });
        letter(out, axis);
    }
    if axes.iter().next().is_some() {
        out.push(b']');
    }
    axis_map(out, key!("delta"), delta, order);
    if let Some(length) = *length_mm {
        number_field(out, key!("length_mm"), length);
    }
    if let Some(length) = *length_deg {
        number_field(out, key!("length_deg"), length);
    }
    if let Some([first, second]) = *plane {
        string_field(out, key!("plane"), &format!("{first}{second}"));
    }
    axis_map(out, key!("center"), center, order);
    if let Some(radius) = *radius_mm {
        number_field(out, key!("radius_mm"), radius);
    }
    if let Some(sweep) = *sweep_deg {
        number_field(out, key!("sweep_deg"), sweep);
    }
    if let Some(axis) = *spindle_axis {
        key(out, key!("spindle_axis"));
        letter(out, axis);
    }
    out.push(b'}');
}

fn write_data(out: &mut Vec<u8>, data: &Data) {
    let Data { g, origin, d, values } = data;
    out.extend_from_slice(br#","data":{"g":"#);
    int(out, u64::from(*g));
    if let Some(origin) = *origin {
        int_field(out, key!("origin"), u64::from(origin));
    }
    decimal_field(out, key!("d"), *d);
    letters(out, key!("values"), values);
    out.push(b'}');
}

#[inline]
fn key(out: &mut Vec<u8>, key: &'static str) {
    out.extend_from_slice(key.as_bytes());
}

fn flag(out: &mut Vec<u8>, name: &'static str, value: bool) {
    if value {
        key(out, name);
        out.extend_from_slice(b"true");
    }
}

fn int(out: &mut Vec<u8>, value: u64) {
    if value < 10 {
        out.push(digit(value));
        return;
    }
    let mut digits = [0_u8; 20];
    let mut rest = value;
    let mut used = 0;
    for slot in digits.iter_mut().rev() {
        *slot = digit(rest % 10);
        rest /= 10;
        used += 1;
        if rest == 0 {
            break;
        }
    }
    out.extend_from_slice(digits.get(digits.len() - used..).unwrap_or_default());
}

fn digit(value: u64) -> u8 {
    b'0' + u8::try_from(value).unwrap_or(0)
}

fn int_field(out: &mut Vec<u8>, name: &'static str, value: u64) {
    key(out, name);
    int(out, value);
}

/// A number without exponent, trailing zeros or a negative zero.
fn number(out: &mut Vec<u8>, value: Micro) {
    let millionths = value.millionths();
    if millionths < 0 {
        out.push(b'-');
    }
    let magnitude = millionths.unsigned_abs();
    int(out, magnitude / 1_000_000);
    let mut fraction = magnitude % 1_000_000;
    if fraction != 0 {
        out.push(b'.');
        let mut unit = 100_000;
        while fraction != 0 {
            out.push(digit(fraction / unit));
            fraction %= unit;
            unit /= 10;
        }
    }
}

fn number_field(out: &mut Vec<u8>, name: &'static str, value: Micro) {
    key(out, name);
    number(out, value);
}

fn decimal_field(out: &mut Vec<u8>, name: &'static str, value: Option<Decimal>) {
    if let Some(value) = value {
        number_field(out, name, Micro::from(value));
    }
}

fn list<T>(out: &mut Vec<u8>, items: &[T], write: impl Fn(&mut Vec<u8>, &T)) {
    out.push(b'[');
    for (place, item) in items.iter().enumerate() {
        if place > 0 {
            out.push(b',');
        }
        write(out, item);
    }
    out.push(b']');
}

fn numbers_field(out: &mut Vec<u8>, name: &'static str, values: &[u8]) {
    if !values.is_empty() {
        key(out, name);
        list(out, values, |out, value| int(out, u64::from(*value)));
    }
}

fn map<K: AsRef<str>>(out: &mut Vec<u8>, entries: impl Iterator<Item = (K, Micro)>) {
    out.push(b'{');
    for (place, (name, value)) in entries.enumerate() {
        if place > 0 {
            out.push(b',');
        }
        string(out, name.as_ref());
        out.push(b':');
        number(out, value);
    }
    out.push(b'}');
}

fn letters(out: &mut Vec<u8>, name: &'static str, values: &[(char, Decimal)]) {
    if !values.is_empty() {
        key(out, name);
        map(out, values.iter().map(|(letter, value)| (letter.to_string(), Micro::from(*value))));
    }
}

fn letter(out: &mut Vec<u8>, axis: AxisLetter) {
    out.push(b'"');
    out.push(u8::try_from(axis.letter()).unwrap_or(b'?'));
    out.push(b'"');
}

fn axis_map(out: &mut Vec<u8>, name: &'static str, values: &AxisMap, order: &[AxisLetter]) {
    let mut first = true;
    for &axis in order {
        let Some(value) = values.get(axis) else { continue };
        if first {
            key(out, name);
            out.push(b'{');
            first = false;
        } else {
            out.push(b',');
        }
        letter(out, axis);
        out.push(b':');
        number(out, value);
    }
    if !first {
        out.push(b'}');
    }
}

/// A JSON string. Control characters are escaped.
fn string(out: &mut Vec<u8>, text: &str) {
    out.push(b'"');
    for byte in text.bytes() {
        match byte {
            b'"' => out.extend_from_slice(b"\\\""),
            b'\\' => out.extend_from_slice(b"\\\\"),
            b'\n' => out.extend_from_slice(b"\\n"),
            b'\r' => out.extend_from_slice(b"\\r"),
            b'\t' => out.extend_from_slice(b"\\t"),
            0x00..=0x1f | 0x7f => out.extend_from_slice(format!("\\u{byte:04x}").as_bytes()),
            _ => out.push(byte),
        }
    }
    out.push(b'"');
}

fn string_field(out: &mut Vec<u8>, name: &'static str, text: &str) {
    key(out, name);
    string(out, text);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(millionths: i64) -> String {
        let mut out = Vec::new();
        number(&mut out, Micro::from_millionths(millionths));
        String::from_utf8(out).unwrap()
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
        ] {
            assert_eq!(shown(millionths), text);
        }
        assert_eq!(shown(Micro::from_f64(-1e-9).millionths()), "0");
    }

    #[test]
    fn strings() {
        let mut out = Vec::new();
        string(&mut out, "a\"\\\u{1b}ř\u{7f}");
        assert_eq!(String::from_utf8(out).unwrap(), r#""a\"\\\u001bř\u007f""#);
    }
}
