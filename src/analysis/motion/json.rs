//! The JSON of the motion stream: its records, filled.

use super::basis::{Basis, BasisValue, InForce, Table};
use super::records::{
    BlockRecord, Digits, DotsRecord, JointRecord, JointsRecord, MachineRecord, NumberOrParameter, Record, SCHEMA,
    SetRecord, TotalRecord,
};
use super::summary::Summary;
use super::times::{BlockTimes, Break, Dot, Joint, Limit, Phase};
use crate::analysis::Number;
use crate::analysis::json::{GENERATOR, Pairs, push, text};
use crate::config::{MotionKey, SetKey};
use crate::dict::Decimal;

/// From velocities in a second to those in a minute.
pub(crate) const PER_MINUTE: f64 = 60.0;

/// The dynamic sets in the order of the record.
const SETS: [(usize, &str); 5] = [(1, "1"), (2, "2"), (3, "3"), (4, "4"), (0, "rapid")];

/// The first record, with its line end.
pub fn machine(basis: &Basis, name: &str) -> String {
    let of = |table: Table| basis.values.iter().filter(move |value| value.table == table);
    let sets = SETS.into_iter().filter_map(|(place, name)| {
        let mut values = of(Table::Set(place)).peekable();
        values.peek()?;
        let mut record = SetRecord::default();
        values.for_each(|value| put_in_set(&mut record, value));
        Some((name, record))
    });
    let times = of(Table::Times).filter_map(|value| match value.value {
        BasisValue::Number(number) => Some((snake(&value.key), number.into())),
        BasisValue::Name(_) | BasisValue::Axes(_) | BasisValue::Parameter(_) => None,
    });
    let from = basis.values.iter().map(|value| (snake(&value.path()), value.from.as_str()));
    let mut record = MachineRecord {
        schema: SCHEMA,
        generator: GENERATOR,
        name,
        assumed: basis.assumed,
        sets: Pairs::some(sets),
        times: Pairs::some(times),
        from: Pairs(from.collect()),
        ..MachineRecord::default()
    };
    for value in of(Table::Motion) {
        match &value.value {
            BasisValue::Name(name) if value.key == "profile" => record.profile = name,
            BasisValue::Name(name) => record.recognition = name,
            BasisValue::Number(number) => put_number(&mut record, &value.key, *number),
            BasisValue::Axes(axes) => {
                let axes = axes.iter().map(|(letter, number)| (letter.letter().to_string(), Number::from(*number)));
                record.rapid_axes_mm_min = Pairs::some(axes);
            }
            BasisValue::Parameter(_) => {}
        }
    }
    text(&Record::Machine(&record), false) + "\n"
}

fn snake(key: &str) -> String {
    key.replace('-', "_")
}

fn put_number(record: &mut MachineRecord<'_>, key: &str, number: Decimal) {
    let field = match MotionKey::ALL.into_iter().find(|known| known.name() == key) {
        Some(MotionKey::Cycle) => &mut record.cycle_ms,
        Some(MotionKey::Angle) => &mut record.angle_deg,
        Some(MotionKey::Accel) => &mut record.accel_mm_s2,
        Some(MotionKey::AccelContinuous) => &mut record.accel_continuous_mm_s2,
        Some(MotionKey::AccelRapid) => &mut record.accel_rapid_mm_s2,
        Some(MotionKey::ShortestBlock) => &mut record.shortest_block_ms,
        Some(MotionKey::BreakLength) => &mut record.break_length_mm,
        Some(MotionKey::MergeLength) => &mut record.merge_length_mm,
        Some(MotionKey::Accuracy) => &mut record.accuracy_um,
        Some(MotionKey::Red) => &mut record.red_percent,
        Some(MotionKey::Overload) => &mut record.overload_mm_s2,
        Some(MotionKey::RaiseLength) => &mut record.raise_length_mm,
        Some(MotionKey::Raise) => &mut record.raise_ms,
        Some(MotionKey::LookAhead) => &mut record.look_ahead,
        Some(MotionKey::Centripetal) => &mut record.centripetal_mm_s2,
        Some(MotionKey::ConstantCutting) => &mut record.constant_cutting_rpm,
        Some(MotionKey::Settle) => &mut record.settle_ms,
        Some(MotionKey::BlockGap) => &mut record.block_gap_ms,
        // The one number that is no such key: the velocity of G00 along the path.
        None => &mut record.rapid_mm_min,
    };
    *field = Some(number.into());
}

fn put_in_set(record: &mut SetRecord, value: &InForce) {
    let field = match SetKey::ALL.into_iter().find(|known| known.name() == value.key) {
        Some(SetKey::Parabolic) => &mut record.parabolic,
        Some(SetKey::Linear) => &mut record.linear_mm_s2,
        Some(SetKey::Accuracy) => &mut record.accuracy_um,
        Some(SetKey::Overload) => &mut record.overload_mm_s2,
        Some(SetKey::Centripetal) => &mut record.centripetal_mm_s2,
        None => return,
    };
    *field = match &value.value {
        BasisValue::Number(number) => Some(NumberOrParameter::Number((*number).into())),
        BasisValue::Parameter(number) => Some(NumberOrParameter::Parameter(format!("R{number}"))),
        BasisValue::Name(_) | BasisValue::Axes(_) => None,
    };
}

/// Writes the record of a block and its line end.
pub fn write_block(out: &mut Vec<u8>, block: &BlockTimes) {
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
    let motion = motion.as_ref();
    let velocities = motion.and_then(|motion| motion.velocities);
    let cap = motion.and_then(|motion| motion.cap);
    let record = BlockRecord {
        seq: *seq,
        n: *n,
        file: *file,
        line: *line,
        start_s: (*start_s).into(),
        duration_s: (*duration_s).into(),
        programmed: motion.and_then(|motion| motion.programmed).map(per_minute),
        cap: cap.map(|(cap, _)| per_minute(cap)),
        cap_by: cap.map(|(_, by)| by.name()),
        start: velocities.map(|velocities| per_minute(velocities.start)),
        peak: velocities.map(|velocities| per_minute(velocities.peak)),
        end: velocities.map(|velocities| per_minute(velocities.end)),
        time_dist_s: motion.and_then(|motion| motion.stretch?.time_dist_s).map(Number::from),
        merged: motion.and_then(|motion| motion.merged.then_some(true)),
        piece_mm: motion.filter(|motion| motion.is_piece).and_then(|motion| motion.length).map(Number::from),
        joint: motion.and_then(|motion| motion.joint.as_ref()).map(joint_record),
        phases: motion.filter(|motion| !motion.phases.is_empty()).map(|motion| phase_records(&motion.phases)),
    };
    push(out, &Record::Block(&record), false);
    out.push(b'\n');
}

fn per_minute(velocity: f64) -> Number {
    (velocity * PER_MINUTE).into()
}

fn phase_records(phases: &[Phase]) -> Vec<[Digits; 4]> {
    let lasting = phases.iter().filter(|phase| phase.lasts());
    lasting.map(|phase| [phase.duration_s, phase.velocity, phase.acceleration, phase.jerk].map(Digits)).collect()
}

fn joint_record(joint: &Joint) -> JointRecord {
    let Joint { with, angle_deg, broken_by, velocity, limited_by, dot, .. } = joint;
    JointRecord {
        with: *with,
        angle_deg: angle_deg.map(Number::from),
        continuous: broken_by.is_none().then_some(true),
        broken_by: broken_by.map(Break::name),
        feed: per_minute(*velocity),
        limited_by: broken_by.map(Break::name).or(limited_by.map(Limit::name)),
        dot: dot.map(Dot::name),
    }
}

/// The last record, with its line end.
pub fn total(summary: &Summary) -> String {
    let tools =
        summary.by_tool.iter().filter_map(|(tool, total)| Some((tool.as_ref()?.to_string(), total.time_s.into())));
    let [yellow, red] = summary.dots;
    let record = TotalRecord {
        time_s: summary.total.time_s.into(),
        ideal_s: summary.ideal_s.into(),
        no_jerk_s: summary.no_jerk_s.map(Number::from),
        lower_bound: summary.total.is_lower_bound().then_some(true),
        unknown_blocks: Some(summary.total.unknown_blocks),
        time_by_type: Pairs::some(summary.types().map(|(kind, seconds)| (kind.name().to_owned(), seconds.into()))),
        dwell_s: summary.dwell_s.into(),
        function_s: summary.function_s.into(),
        settle_s: summary.settle_s.into(),
        gap_s: summary.gap_s.into(),
        time_by_tool: Pairs::some(tools),
        joints: JointsRecord {
            continuous: summary.continuous,
            broken: Pairs::some(summary.breaks().map(|(reason, count)| (reason.name(), count))),
        },
        limited: Pairs::some(summary.limits().map(|(limit, count)| (limit.name(), count))),
        dots: DotsRecord { yellow, red },
        mean_feed: summary.mean_feed().map(Number::from),
    };
    text(&Record::Total(&record), false) + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phases_that_rounding_leaves() {
        let phase = |duration_s: f64, jerk: f64| Phase { duration_s, velocity: 5.0, acceleration: 0.0, jerk };
        let phases = phase_records(&[phase(2.5e-16, 9e9), phase(0.5, 2.0), phase(1e-13, -9e9), phase(1e-9, 0.0)]);
        assert_eq!(text(&phases, false), "[[0.5,5,0,2],[0.000000001,5,0,0]]");
    }

    #[test]
    fn twelve_significant_digits() {
        let table = [(1.0 / 3.0, "0.333333333333"), (-0.0, "0"), (1e-7, "0.0000001"), (2e15 / 3.0, "666666666667000")];
        for (value, digits) in table {
            assert_eq!(text(&Digits(value), false), digits);
        }
    }
}
