//! The JSON of the motion stream.

use std::fmt::Write;

use super::basis::{Basis, BasisValue, InForce, Table};
use super::records::SCHEMA;
use super::summary::Summary;
use super::times::{BlockTimes, Joint, MotionTimes, Phase};
use crate::dict::Micro;

/// From velocities in a second to those in a minute.
pub(crate) const PER_MINUTE: f64 = 60.0;

/// An object under way.
struct Object<'o> {
    out: &'o mut String,
    empty: bool,
}

impl<'o> Object<'o> {
    fn new(out: &'o mut String) -> Self {
        out.push('{');
        Self { out, empty: true }
    }

    /// Begins a field.
    fn key(&mut self, key: &str) -> &mut String {
        if !std::mem::take(&mut self.empty) {
            self.out.push(',');
        }
        push_text(self.out, key);
        self.out.push(':');
        self.out
    }

    fn text(&mut self, key: &str, value: &str) {
        push_text(self.key(key), value);
    }

    fn whole(&mut self, key: &str, value: u64) {
        let _ = write!(self.key(key), "{value}");
    }

    fn number(&mut self, key: &str, value: f64) {
        push_number(self.key(key), value);
    }

    fn present(&mut self, key: &str, value: Option<f64>) {
        if let Some(value) = value {
            self.number(key, value);
        }
    }

    fn flag(&mut self, key: &str, value: bool) {
        if value {
            self.key(key).push_str("true");
        }
    }

    /// An object of numbers; none when there are none.
    fn numbers(&mut self, key: &str, numbers: impl Iterator<Item = (impl AsRef<str>, f64)>) {
        let mut numbers = numbers.peekable();
        if numbers.peek().is_some() {
            let mut table = self.object(key);
            numbers.for_each(|(key, value)| table.number(key.as_ref(), value));
            table.end();
        }
    }

    /// An object of counts; none when there are none.
    fn counts(&mut self, key: &str, counts: impl Iterator<Item = (&'static str, u64)>) {
        let mut counts = counts.peekable();
        if counts.peek().is_some() {
            let mut table = self.object(key);
            counts.for_each(|(key, count)| table.whole(key, count));
            table.end();
        }
    }

    fn object(&mut self, key: &str) -> Object<'_> {
        Object::new(self.key(key))
    }

    fn end(self) {
        self.out.push('}');
    }
}

/// Rounded to six decimals, without exponent and trailing zeros.
pub(super) fn push_number(out: &mut String, value: f64) {
    let millionths = Micro::from_f64(value).millionths();
    if millionths < 0 {
        out.push('-');
    }
    let millionths = millionths.unsigned_abs();
    let (whole, mut fraction) = (millionths / 1_000_000, millionths % 1_000_000);
    let _ = write!(out, "{whole}");
    if fraction > 0 {
        let mut digits = 6;
        while fraction.is_multiple_of(10) {
            fraction /= 10;
            digits -= 1;
        }
        let _ = write!(out, ".{fraction:0digits$}");
    }
}

/// With twelve significant digits.
pub(crate) fn twelve_digits(value: f64) -> f64 {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    // A negative zero is a zero.
    rounded + 0.0
}

/// Twelve significant digits, without exponent.
fn push_digits(out: &mut String, value: f64) {
    let _ = write!(out, "{}", twelve_digits(value));
}

fn push_text(out: &mut String, text: &str) {
    out.push_str(&serde_json::Value::from(text).to_string());
}

/// The first record.
pub fn machine(basis: &Basis, name: &str) -> String {
    let mut out = String::new();
    let mut record = Object::new(&mut out);
    record.text("kind", "machine");
    record.text("schema", SCHEMA);
    record.text("generator", concat!("cnc872c ", env!("CARGO_PKG_VERSION")));
    record.text("name", name);
    record.flag("assumed", basis.assumed);
    let of = |table: Table| basis.values.iter().filter(move |value| value.table == table);
    for value in of(Table::Motion) {
        put(&mut record, value);
    }
    if basis.values.iter().any(|value| matches!(value.table, Table::Set(_))) {
        let mut sets = record.object("sets");
        for (place, name) in [(1, "1"), (2, "2"), (3, "3"), (4, "4"), (0, "rapid")] {
            let mut values = of(Table::Set(place)).peekable();
            if values.peek().is_some() {
                let mut set = sets.object(name);
                values.for_each(|value| put(&mut set, value));
                set.end();
            }
        }
        sets.end();
    }
    let mut times = of(Table::Times).peekable();
    if times.peek().is_some() {
        let mut table = record.object("times");
        times.for_each(|value| put(&mut table, value));
        table.end();
    }
    let mut from = record.object("from");
    for value in &basis.values {
        from.text(&snake(&value.path()), &value.from);
    }
    from.end();
    record.end();
    out.push('\n');
    out
}

fn snake(key: &str) -> String {
    key.replace('-', "_")
}

fn put(record: &mut Object<'_>, value: &InForce) {
    let key = snake(&value.key);
    match &value.value {
        BasisValue::Number(number) => {
            let _ = write!(record.key(&key), "{number}");
        }
        BasisValue::Name(name) => record.text(&key, name),
        BasisValue::Parameter(number) => record.text(&key, &format!("R{number}")),
        BasisValue::Axes(axes) if axes.is_empty() => {}
        BasisValue::Axes(axes) => {
            let mut table = record.object("rapid_axes_mm_min");
            for (letter, number) in axes {
                let _ = write!(table.key(letter.letter().to_string().as_str()), "{number}");
            }
            table.end();
        }
    }
}

/// Writes the record of a block and its line end.
pub fn write_block(out: &mut String, block: &BlockTimes) {
    let BlockTimes {
        seq,
        n,
        file,
        line,
        place: _,
        start_s,
        duration_s,
        dwell_s: _,
        function_s: _,
        settle_s: _,
        gap_s: _,
        unknown: _,
        approach: _,
        tool: _,
        untimed: _,
        lacks_cycle: _,
        motion,
    } = block;
    let mut record = Object::new(out);
    record.text("kind", "block");
    record.whole("seq", *seq);
    record.whole("n", u64::from(*n));
    record.whole("file", u64::from(*file));
    record.whole("line", u64::from(*line));
    record.number("start_s", *start_s);
    record.number("duration_s", *duration_s);
    if let Some(motion) = motion {
        put_motion(&mut record, motion);
    }
    record.end();
    out.push('\n');
}

fn put_motion(record: &mut Object<'_>, motion: &MotionTimes) {
    let MotionTimes {
        kind: _,
        unit: _,
        length,
        motion_s: _,
        programmed,
        cap,
        velocities,
        merged,
        is_piece,
        joint,
        accel: _,
        jerk_free: _,
        stretch,
        joined_in: _,
        phases,
    } = motion;
    record.present("programmed", programmed.map(|velocity| velocity * PER_MINUTE));
    if let Some((cap, by)) = cap {
        record.number("cap", cap * PER_MINUTE);
        record.text("cap_by", by.name());
    }
    if let Some(velocities) = velocities {
        record.number("start", velocities.start * PER_MINUTE);
        record.number("peak", velocities.peak * PER_MINUTE);
        record.number("end", velocities.end * PER_MINUTE);
    }
    record.present("time_dist_s", stretch.and_then(|stretch| stretch.time_dist_s));
    record.flag("merged", *merged);
    record.present("piece_mm", length.filter(|_| *is_piece));
    if let Some(joint) = joint {
        put_joint(record.object("joint"), joint);
    }
    if !phases.is_empty() {
        push_phases(record.key("phases"), phases);
    }
}

fn push_phases(out: &mut String, phases: &[Phase]) {
    out.push('[');
    for (at, phase) in phases.iter().filter(|phase| phase.lasts()).enumerate() {
        let Phase { duration_s, velocity, acceleration, jerk } = *phase;
        if at > 0 {
            out.push(',');
        }
        for (at, value) in [duration_s, velocity, acceleration, jerk].into_iter().enumerate() {
            out.push(if at == 0 { '[' } else { ',' });
            push_digits(out, value);
        }
        out.push(']');
    }
    out.push(']');
}

fn put_joint(mut record: Object<'_>, joint: &Joint) {
    let Joint { with, angle_deg, broken_by, velocity, limited_by, dot, .. } = joint;
    if let Some(with) = with {
        record.whole("with", *with);
    }
    record.present("angle_deg", *angle_deg);
    record.flag("continuous", broken_by.is_none());
    if let Some(reason) = broken_by {
        record.text("broken_by", reason.name());
    }
    record.number("feed", velocity * PER_MINUTE);
    if let Some(limit) = broken_by.map(super::Break::name).or(limited_by.map(super::Limit::name)) {
        record.text("limited_by", limit);
    }
    if let Some(dot) = dot {
        record.text("dot", dot.name());
    }
    record.end();
}

/// The last record.
pub fn total(summary: &Summary) -> String {
    let mut out = String::new();
    let mut record = Object::new(&mut out);
    record.text("kind", "total");
    record.number("time_s", summary.total.time_s);
    record.number("ideal_s", summary.ideal_s);
    record.present("no_jerk_s", summary.no_jerk_s);
    record.flag("lower_bound", summary.total.is_lower_bound());
    record.whole("unknown_blocks", summary.total.unknown_blocks);
    record.numbers("time_by_type", summary.types().map(|(kind, seconds)| (kind.name(), seconds)));
    record.number("dwell_s", summary.dwell_s);
    record.number("function_s", summary.function_s);
    record.number("settle_s", summary.settle_s);
    record.number("gap_s", summary.gap_s);
    let tools = summary.by_tool.iter().filter_map(|(tool, total)| Some((tool.as_ref()?.to_string(), total.time_s)));
    record.numbers("time_by_tool", tools);
    let mut joints = record.object("joints");
    joints.whole("continuous", summary.continuous);
    joints.counts("broken", summary.breaks().map(|(reason, count)| (reason.name(), count)));
    joints.end();
    record.counts("limited", summary.limits().map(|(limit, count)| (limit.name(), count)));
    let [yellow, red] = summary.dots;
    let mut dots = record.object("dots");
    dots.whole("yellow", yellow);
    dots.whole("red", red);
    dots.end();
    record.present("mean_feed", summary.mean_feed());
    record.end();
    out.push('\n');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(push: fn(&mut String, f64), value: f64) -> String {
        let mut out = String::new();
        push(&mut out, value);
        out
    }

    #[test]
    fn phases_that_rounding_leaves() {
        let phase = |duration_s: f64, jerk: f64| Phase { duration_s, velocity: 5.0, acceleration: 0.0, jerk };
        let mut out = String::new();
        push_phases(&mut out, &[phase(2.5e-16, 9e9), phase(0.5, 2.0), phase(1e-13, -9e9), phase(1e-9, 0.0)]);
        assert_eq!(out, "[[0.5,5,0,2],[0.000000001,5,0,0]]");
    }

    #[test]
    fn numbers() {
        let table = [(0.0, "0"), (-0.0, "0"), (1.5, "1.5"), (-2.000_000_4, "-2"), (0.000_001, "0.000001")];
        for (value, text) in table {
            assert_eq!(shown(push_number, value), text);
        }
        assert_eq!(shown(push_number, 1_234_567.891_234_5), "1234567.891235");
        let table = [(1.0 / 3.0, "0.333333333333"), (-0.0, "0"), (1e-7, "0.0000001"), (2e15 / 3.0, "666666666667000")];
        for (value, text) in table {
            assert_eq!(shown(push_digits, value), text);
        }
    }
}
