//! Times of blocks as CSV (RFC 4180): a row a block, empty where a block has no such value. Columns are named as the
//! fields of the motion stream.

use std::fmt::Write;

use super::json::PER_MINUTE;
use super::times::BlockTimes;
use crate::analysis::write_real;
use crate::dict::Micro;

/// The first line.
pub const CSV_HEAD: &str = "seq,n,file,line,start_s,duration_s,motion,programmed,cap,cap_by,start,peak,end,time_dist_s,\
                            merged,piece_mm,with,angle_deg,continuous,broken_by,feed,limited_by,dot\r\n";

/// Writes the row of a block and its line end.
pub fn write_csv(out: &mut String, block: &BlockTimes) {
    let _ = write!(out, "{},{},{},{},", block.seq, block.n, block.file, block.line);
    push_number(out, block.start_s);
    out.push(',');
    push_number(out, block.duration_s);
    let motion = block.motion.as_ref();
    let joint = motion.and_then(|motion| motion.joint);
    let velocities = motion.and_then(|motion| motion.velocities);
    let minute = |value: f64| value * PER_MINUTE;
    text(out, motion.map(|motion| motion.kind.name()));
    number(out, motion.and_then(|motion| motion.programmed).map(minute));
    number(out, motion.and_then(|motion| motion.cap).map(|(cap, _)| minute(cap)));
    text(out, motion.and_then(|motion| motion.cap).map(|(_, by)| by.name()));
    number(out, velocities.map(|velocities| minute(velocities.start)));
    number(out, velocities.map(|velocities| minute(velocities.peak)));
    number(out, velocities.map(|velocities| minute(velocities.end)));
    number(out, motion.and_then(|motion| motion.stretch?.time_dist_s));
    text(out, motion.filter(|motion| motion.merged).map(|_| "true"));
    number(out, motion.filter(|motion| motion.is_piece).and_then(|motion| motion.length));
    out.push(',');
    if let Some(with) = joint.and_then(|joint| joint.with) {
        let _ = write!(out, "{with}");
    }
    number(out, joint.and_then(|joint| joint.angle_deg));
    text(out, joint.map(|joint| if joint.broken_by.is_none() { "true" } else { "false" }));
    let broken = joint.and_then(|joint| joint.broken_by).map(super::Break::name);
    text(out, broken);
    number(out, joint.map(|joint| minute(joint.velocity)));
    text(out, broken.or(joint.and_then(|joint| joint.limited_by).map(super::Limit::name)));
    text(out, joint.and_then(|joint| joint.dot).map(super::Dot::name));
    out.push_str("\r\n");
}

/// Rounded to six decimals, without exponent and trailing zeros.
fn push_number(out: &mut String, value: f64) {
    write_real(Micro::from_f64(value).millionths(), out);
}

fn text(out: &mut String, value: Option<&str>) {
    out.push(',');
    out.push_str(value.unwrap_or_default());
}

fn number(out: &mut String, value: Option<f64>) {
    out.push(',');
    if let Some(value) = value {
        push_number(out, value);
    }
}
