//! The account of a program's motion for people.

use super::basis::{Basis, InForce};
use super::summary::{RedJoint, Summary, Total};
use super::times::{Break, Untimed};
use super::trimmed;
use super::words::{Help, Words};
use crate::diag::terminal_safe;
use crate::dict::{Decimal, Lang};
use crate::run::MotionType;
use crate::text::Sources;

/// `h:mm:ss.s`.
pub fn clock(seconds: f64) -> String {
    // Casting saturates: no program takes that long.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "times are positive")]
    let tenths = (seconds.max(0.0) * 10.0).round() as u64;
    let (whole, tenth) = (tenths / 10, tenths % 10);
    format!("{}:{:02}:{:02}.{tenth}", whole / 3600, whole / 60 % 60, whole % 60)
}

impl Total {
    /// `0:00:16.7`, with how many blocks it lacks where it is a lower bound.
    pub fn text(&self, lang: Lang) -> String {
        let time = clock(self.time_s);
        let words = match self.unknown_blocks {
            0 if self.has_loose_limits() => Words::AtLeastSo { time },
            0 => Words::Whole { time },
            blocks if blocks == self.approach_blocks && self.has_loose_limits() => {
                Words::AtLeastWithoutApproach { time }
            }
            blocks if blocks == self.approach_blocks => Words::WithoutApproach { time },
            blocks => Words::AtLeast { time, blocks },
        };
        words.text(lang)
    }
}

/// The data of a program's account.
#[derive(Clone, Copy, Debug)]
pub struct Account<'a> {
    /// The program, as the user named it.
    pub name: &'a str,
    /// The values that the estimate rests on.
    pub basis: &'a Basis,
    /// Times and joints of the program.
    pub summary: &'a Summary,
    /// The configured machine, and what the program takes there, when other values are tried.
    pub configured: Option<(&'a Basis, Option<&'a Summary>)>,
    /// The texts that places are in.
    pub sources: &'a Sources,
}

/// Columns of names; the longest and a blank.
const NAME: usize = 46;
/// Columns of values.
const VALUE: usize = 10;

/// Lines under way.
struct Lines {
    text: String,
    lang: Lang,
}

impl Lines {
    fn add(&mut self, line: &str) {
        self.text.push_str(line.trim_end());
        self.text.push('\n');
    }

    fn head(&mut self, words: &Words) {
        self.text.push('\n');
        let line = words.text(self.lang);
        self.add(&line);
    }

    /// A name, and values that stand below one another.
    fn row(&mut self, name: &str, value: &str, rest: &str) {
        let pad = NAME.saturating_sub(name.chars().count());
        let line = format!("  {name}{:pad$}{value:>VALUE$}{rest}", "");
        self.add(&line);
    }
}

impl Account<'_> {
    /// The text in `lang`; every line ends.
    pub fn text(&self, lang: Lang) -> String {
        let mut lines = Lines { text: String::new(), lang };
        let Self { summary, basis, .. } = self;
        let total = summary.total.text(lang);
        lines.add(&format!("{}: {total}", terminal_safe(self.name)));
        if summary.total.jerk_free_blocks > 0 {
            lines.add(&Words::JerkFree { blocks: summary.total.jerk_free_blocks }.text(lang));
        }
        if summary.total.lacks_cycle {
            lines.add(&Words::LacksCycle.text(lang));
        }
        self.add_basis(basis, &mut lines);
        let zero = Untimed::ALL.into_iter().zip(summary.untimed).filter(|(_, untimed)| *untimed);
        let zero: Vec<String> = zero.map(|(what, _)| what.text(lang)).collect();
        if !zero.is_empty() {
            lines.add(&Words::CountAsZero { what: zero.join(", ") }.text(lang));
        }
        self.add_changes(&mut lines);
        self.add_times(summary, &mut lines);
        self.add_joints(summary, &mut lines);
        self.add_red(summary, &mut lines);
        lines.text
    }

    fn add_basis(&self, basis: &Basis, lines: &mut Lines) {
        let lang = lines.lang;
        let list = |wanted: &dyn Fn(&InForce) -> bool| {
            let values = basis.values.iter().filter(|value| wanted(value)).map(|value| {
                let constant = if value.from.starts_with('R') || value.from.starts_with('-') {
                    format!(" ({})", value.from)
                } else {
                    String::new()
                };
                format!("{} {}{constant}", value.path(), value.value)
            });
            values.collect::<Vec<_>>().join(", ")
        };
        if basis.values.iter().all(|value| value.assumed) {
            let words = if basis.assumed { Words::Assumed } else { Words::AllAssumed };
            lines.add(&format!("{}:", words.text(lang)));
            lines.add(&format!("  {}, {}", list(&|_| true), Words::Override.text(lang)));
            return;
        }
        lines.add(&Words::Configured { values: list(&|value| !value.assumed) }.text(lang));
        let assumed = [list(&|value| value.assumed), Words::Override.text(lang)];
        lines.add(&Words::AlsoAssumed { values: assumed.join(", ") }.text(lang));
    }

    fn add_changes(&self, lines: &mut Lines) {
        let Some((configured, before)) = self.configured else { return };
        let lang = lines.lang;
        lines.head(&Words::Changed);
        let changes = self.basis.changes(configured);
        if changes.is_empty() {
            lines.add(&format!("  {}", Words::Nothing.text(lang)));
            return;
        }
        for (key, before, after) in changes {
            let shown = |value: Option<super::BasisValue>| {
                value.map_or_else(|| Words::Off.text(lang), |value| value.to_string())
            };
            lines.add(&format!("  {key} {} → {}", shown(before), shown(after)));
        }
        if let Some(before) = before {
            let after = self.summary;
            let change = after.total.time_s - before.total.time_s;
            let sign = if change > 0.0 { "+" } else { "" };
            let words = [
                Words::TimeBefore {
                    before: clock(before.total.time_s),
                    after: clock(after.total.time_s),
                    change: format!("{sign}{}", trimmed(change, 3)),
                },
                Words::JointsBefore { before: before.continuous, after: after.continuous },
                Words::DotsBefore { before: before.dots[1], after: after.dots[1] },
            ];
            words.iter().for_each(|words| lines.add(&format!("  {}", words.text(lang))));
        }
    }

    fn add_times(&self, summary: &Summary, lines: &mut Lines) {
        let lang = lines.lang;
        let part = |seconds: f64| {
            let percent = if summary.total.time_s > 0.0 { seconds / summary.total.time_s * 100.0 } else { 0.0 };
            format!("{percent:7.1} %")
        };
        lines.head(&Words::Time);
        for (kind, seconds) in summary.types() {
            lines.row(motion_name(kind), &clock(seconds), &part(seconds));
        }
        let others = [
            (Words::Dwell, summary.dwell_s),
            (Words::Functions, summary.function_s),
            (Words::Settle, summary.settle_s),
            (Words::Gaps, summary.gap_s),
        ];
        for (words, seconds) in others.iter().filter(|(_, seconds)| *seconds > 0.0) {
            lines.row(&words.text(lang), &clock(*seconds), &part(*seconds));
        }
        lines.row(&Words::Ideal.text(lang), &clock(summary.ideal_s), "");
        if let Some(seconds) = summary.no_jerk_s {
            lines.row(&Words::NoJerk.text(lang), &clock(seconds), "");
        }
        if summary.by_tool.keys().any(Option::is_some) {
            lines.head(&Words::Tools);
            // An unknown time is shown with its tool. Before the first tool change, an approach alone has no row.
            let counts = |tool: Option<Decimal>, total: &Total| match tool {
                Some(_) => !total.is_nothing(),
                None => total.time_s > 0.0 || total.lacks_more_than_approach(),
            };
            for (tool, total) in summary.by_tool.iter().filter(|(tool, total)| counts(**tool, total)) {
                let name = tool.map_or_else(|| Words::NoTool.text(lang), |tool| format!("T{tool}"));
                let least = if total.lacks_more_than_approach() { Words::Least.text(lang) } else { String::new() };
                let part = part(total.time_s);
                lines.row(&name, &clock(total.time_s), [part, least].join("  ").trim_end());
            }
        }
    }

    fn add_joints(&self, summary: &Summary, lines: &mut Lines) {
        let lang = lines.lang;
        lines.head(&Words::Joints);
        lines.row(&Words::Continuous.text(lang), &summary.continuous.to_string(), "");
        for (reason, count) in summary.breaks() {
            let words = Words::BrokenBy { reason: reason.text(lang) };
            lines.row(&words.text(lang), &count.to_string(), "");
        }
        if summary.limits().next().is_some() {
            lines.head(&Words::Limits);
            for (limit, count) in summary.limits() {
                lines.row(&limit.text(lang), &count.to_string(), "");
            }
        }
        let [yellow, red] = summary.dots;
        if yellow + red > 0 {
            lines.head(&Words::Dots);
            lines.row(&Words::Yellow.text(lang), &yellow.to_string(), "");
            lines.row(&Words::Red.text(lang), &red.to_string(), "");
        }
        if let Some(feed) = summary.mean_feed() {
            lines.head(&Words::MeanFeed { feed: trimmed(feed, 1) });
        }
    }

    fn add_red(&self, summary: &Summary, lines: &mut Lines) {
        let [yellow, red] = summary.dots;
        if yellow + red == 0 {
            return;
        }
        if red == 0 {
            lines.head(&Words::NoRed);
            return;
        }
        lines.head(&Words::RedJoints);
        let (joints, more) = summary.costly();
        for joint in &joints {
            let line = self.red(joint, lines.lang);
            lines.add(&line);
        }
        if more {
            lines.add(&format!("  {}", Words::MoreRed.text(lines.lang)));
        }
    }

    fn red(&self, red: &RedJoint, lang: Lang) -> String {
        let joint = &red.joint;
        let file = self.sources.get(red.place.file).map_or("", |source| source.name());
        let mut parts = Vec::new();
        if let Some(angle) = joint.angle_deg {
            parts.push(Words::Angle { angle: trimmed(angle, 3) }.text(lang));
        }
        let help = match (joint.broken_by, joint.limited_by) {
            (Some(reason), _) => {
                // `mode` comes before it in the record (CNT-2), and no mode helps.
                let reason = if joint.beside_rapid { Break::Rapid } else { reason };
                parts.push(format!("{}: {}", Words::Stops.text(lang), reason.text(lang)));
                Help::of_break(reason)
            }
            (None, limit) => {
                let feed = Words::Feed {
                    feed: trimmed(joint.velocity * 60.0, 1),
                    programmed: trimmed(red.programmed.unwrap_or(0.0) * 60.0, 1),
                };
                parts.push(feed.text(lang));
                parts.extend(limit.map(|limit| limit.text(lang)));
                limit.map(Help::of_limit)
            }
        };
        parts.extend(help.map(|help| help.text(lang)));
        if red.cost_s >= 0.0005 {
            parts.push(Words::Costs { seconds: trimmed(red.cost_s, 3) }.text(lang));
        }
        if red.times > 1 {
            parts.push(Words::Times { times: red.times }.text(lang));
        }
        let blocks = Words::After { n: red.n, with: joint.with_n.unwrap_or(0) }.text(lang);
        format!("  {}:{}  {blocks}: {}", terminal_safe(file), red.line, parts.join("; "))
    }
}

/// The G function of a motion.
pub(super) const fn motion_name(kind: MotionType) -> &'static str {
    match kind {
        MotionType::Rapid => "G00",
        MotionType::Linear => "G01",
        MotionType::ArcCw => "G02",
        MotionType::ArcCcw => "G03",
        MotionType::Thread => "G33",
        MotionType::Reference => "G30",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::motion::{Break, Limit};

    /// Counts form one column, whatever breaks joints.
    #[test]
    fn names_fit() {
        for lang in [Lang::En, Lang::Cs] {
            let broken = Break::ALL.map(|reason| Words::BrokenBy { reason: reason.text(lang) });
            let limits = Limit::ALL.map(|limit| limit.text(lang));
            let others = [Words::Ideal, Words::NoJerk, Words::Settle, Words::Gaps, Words::NoTool];
            let names = broken.iter().chain(&others).map(|words| words.text(lang)).chain(limits);
            for name in names {
                assert!(name.chars().count() < NAME, "{name}");
            }
        }
    }

    #[test]
    fn totals_say_what_they_lack() {
        let text = |unknown_blocks: u64, approach_blocks: u64, jerk_free_blocks: u64| {
            Total { time_s: 0.6, unknown_blocks, approach_blocks, jerk_free_blocks, lacks_cycle: false }.text(Lang::En)
        };
        assert_eq!(text(0, 0, 0), "0:00:00.6");
        assert_eq!(text(9, 1, 0), "at least 0:00:00.6; blocks of unknown time: 9");
        assert_eq!(text(2, 2, 0), "0:00:00.6 without the approach");
        assert_eq!(text(2, 2, 1), "at least 0:00:00.6, without the approach");
        assert_eq!(text(0, 0, 1), "at least 0:00:00.6");
    }

    #[test]
    fn clocks() {
        let table = [(0.0, "0:00:00.0"), (59.96, "0:01:00.0"), (3661.24, "1:01:01.2"), (36_000.0, "10:00:00.0")];
        for (seconds, text) in table {
            assert_eq!(clock(seconds), text);
        }
    }
}
