//! What holds at a place, as a table for people.

use super::clock::{Progress, Timing};
use super::found::{CounterAt, Found};
use super::words::Words;
use super::writers::{Slot, Written};
use crate::analysis::motion::{clock, trimmed};
use crate::config::Settings;
use crate::diag::terminal_safe;
use crate::dict::{AxisLetter, GCode, GGroup, Lang, M_GROUPS, Micro, standard_m_functions};

/// The table: a title, then sections of rows with a name, a value, and who wrote it.
pub fn text(found: &Found, name: &str, settings: &Settings, lang: Lang) -> String {
    let (n, line, seq) = (found.n, found.line, found.seq);
    let place = if found.file == 0 {
        Words::Block { n, line, seq }
    } else {
        Words::BlockIn { n, file: found.file_name.clone(), line, seq }
    };
    let (place, name) = (place.text(lang), name.to_owned());
    let title = if found.after { Words::Behind { place, name } } else { Words::Before { place, name } };
    let table = Table { found, settings, lang };
    let mut lines = vec![title.text(lang)];
    let sections = [
        (Words::Calls, table.calls()),
        (Words::Counters, table.counters()),
        (Words::Position, table.positions()),
        (Words::GFunctions, table.g_functions()),
        (Words::MFunctions, table.m_functions()),
        (Words::Values, table.values()),
        (Words::Parameters, table.parameters()),
        (Words::Progress, table.progress()),
    ];
    for (heading, rows) in sections {
        if rows.is_empty() {
            continue;
        }
        lines.push(String::new());
        lines.push(heading.text(lang));
        lines.extend(columns(&rows));
    }
    lines.iter().map(|line| format!("{}\n", terminal_safe(line.trim_end()))).collect()
}

type Row = Vec<String>;

/// Rows below one another.
fn columns(rows: &[Row]) -> impl Iterator<Item = String> + '_ {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        // What stands last in its row needs no room.
        let cells = rows.iter().filter(|row| row.len() > column + 1).filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..count).map(width).collect();
    rows.iter().map(move |row| {
        let pad = |(cell, width): (&String, &usize)| {
            format!("{cell}{:pad$}", "", pad = width.saturating_sub(cell.chars().count()))
        };
        format!("  {}", row.iter().zip(&widths).map(pad).collect::<Vec<_>>().join("  "))
    })
}

struct Table<'f> {
    found: &'f Found,
    settings: &'f Settings,
    lang: Lang,
}

impl Table<'_> {
    fn say(&self, words: &Words) -> String {
        words.text(self.lang)
    }

    /// Who wrote something last; `otherwise`, when nobody did.
    fn by(&self, slot: Slot, otherwise: &Words) -> String {
        let Some(Written { n, line, call, .. }) = self.found.writer(slot) else { return self.say(otherwise) };
        let (n, line) = (*n, *line);
        self.say(&match call {
            Some((_, l)) => Words::ByIn { n, line, l: *l },
            None => Words::By { n, line },
        })
    }

    fn calls(&self) -> Vec<Row> {
        let calls = self.found.calls.iter().map(|call| {
            let (by, l) = (call.by.to_owned(), call.l);
            vec![self.say(&Words::Call { l, by, n: call.n, line: call.line, pass: call.pass, of: call.of })]
        });
        calls.collect()
    }

    fn counters(&self) -> Vec<Row> {
        let counters = self.found.counters.iter();
        let row = |counter: &CounterAt| {
            let (n, line, left, of) = (counter.n, counter.line, counter.left, counter.of);
            vec![self.say(&Words::Counter { n, line, left, of })]
        };
        counters.map(row).collect()
    }

    fn positions(&self) -> Vec<Row> {
        let axes = self.settings.machine.axes.iter().enumerate();
        let row = |(place, axis): (usize, crate::config::Axis)| {
            let letter = axis.letter.to_string();
            if let Some(position) = self.found.state.axis_position(place) {
                let by = self.by(Slot::Axis(axis.letter), &Words::PowerUp);
                // Programs write twice the position (G74).
                let doubled =
                    axis.letter == AxisLetter::X && self.found.state.g_in_force(GGroup::G10) == Some(GCode::G74);
                let diameter = if doubled { format!(" (Ø {})", position.plus(position)) } else { String::new() };
                return Some(vec![letter, format!("{position}{diameter}"), by]);
            }
            let (_, why) = self.found.unknown.iter().find(|(unknown, _)| *unknown == axis.letter)?;
            let why = why.text(self.lang);
            Some(vec![letter, self.say(&Words::NotKnown { why })])
        };
        axes.filter_map(row).collect()
    }

    fn g_functions(&self) -> Vec<Row> {
        let in_force = GGroup::ALL.into_iter().filter_map(|group| self.found.state.g_in_force(group));
        let row = |code: GCode| {
            let by = self.by(Slot::G(code.group().index()), &Words::PowerUp);
            vec![code.to_string(), code.meaning().get(self.lang).to_owned(), by]
        };
        let power_up = self.settings.machine.power_up;
        let lost = |group: GGroup| {
            let at_first = power_up.get(group.index()).copied().flatten();
            at_first.is_some() && self.found.state.g_in_force(group).is_none()
        };
        in_force.map(row).chain(self.others_not_known(GGroup::ALL.into_iter().any(lost))).collect()
    }

    /// A row for functions in force of which nobody knows which they are.
    fn others_not_known(&self, there_are: bool) -> Option<Row> {
        there_are.then(|| vec![self.say(&Words::OthersNotKnown), self.say(&Words::ValueNotKnown)])
    }

    fn m_functions(&self) -> Vec<Row> {
        let groups = (1..M_GROUPS).filter_map(|group| Some((group, self.found.state.m_in_force(group)?)));
        let row = |(group, number): (usize, u8)| {
            let mut rows = standard_m_functions(self.settings.machine.dialect);
            let known = rows.find(|row| row.number == number && usize::from(row.group) == group);
            let meaning = known.map_or_else(String::new, |row| row.meaning.get(self.lang).to_owned());
            vec![format!("M{number:02}"), meaning, self.by(Slot::M(group), &Words::PowerUp)]
        };
        let power_up = &self.settings.machine.m_power_up;
        let lost = |group: usize| {
            let at_first = power_up.get(group).copied().flatten();
            at_first.is_some() && self.found.state.m_in_force(group).is_none()
        };
        groups.map(row).chain(self.others_not_known((1..M_GROUPS).any(lost))).collect()
    }

    fn values(&self) -> Vec<Row> {
        let state = &self.found.state;
        let feed = state.feed(&self.settings.machine).map(|feed| {
            let scale = if feed.hundredth { " × 0.01 (M37)" } else { "" };
            format!("{} {}{scale}", feed.value, feed.unit.shown(self.lang))
        });
        let text = |value: Option<crate::dict::Decimal>| value.map(|value| value.to_string());
        // It stays behind G23, until the next one with I.
        let is_chosen = state.dynamic_set().is_some() || self.found.writer(Slot::value("dynamic_set")).is_some();
        let set = state.chosen_dynamic_set().filter(|_| is_chosen).map(|set| set.to_string());
        let digits = state.length_correction().map(|digits| format!("{digits:04}"));
        let always = [
            ("F".to_owned(), feed, "feed"),
            ("S".to_owned(), text(state.s()), "s"),
            ("T".to_owned(), text(state.t()), "t"),
            (self.say(&Words::Tool), text(state.tool_in_spindle()).map(|tool| format!("T{tool}")), "tool"),
        ];
        let sometimes = [
            (self.say(&Words::Gear), state.gear_in_force().map(|gear| gear.to_string()), "gear"),
            ("H".to_owned(), text(state.h()), "h"),
            ("P".to_owned(), text(state.p()), "p"),
            ("D".to_owned(), text(state.d()), "d"),
            ("&".to_owned(), digits, "length_correction"),
            (self.say(&Words::DynamicSet), set, "dynamic_set"),
        ];
        let is_written = |slot: &str| self.found.writer(Slot::value(slot)).is_some();
        let sometimes = sometimes.into_iter().filter(|(_, value, slot)| value.is_some() || is_written(slot));
        let row = |(name, value, slot): (String, Option<String>, &str)| match value {
            Some(value) => vec![name, value, self.by(Slot::value(slot), &Words::PowerUp)],
            None if is_written(slot) => {
                vec![name, self.say(&Words::ValueNotKnown), self.by(Slot::value(slot), &Words::PowerUp)]
            }
            None => vec![name, self.say(&Words::NotProgrammed)],
        };
        always.into_iter().chain(sometimes).map(row).collect()
    }

    fn parameters(&self) -> Vec<Row> {
        let state = &self.found.state;
        let row = |index: u8| match state.parameter(index) {
            Some(value) => Some(vec![format!("R{index}"), value.to_string(), self.by(Slot::R(index), &Words::PowerUp)]),
            None if state.is_lost(index) => Some(vec![
                format!("R{index}"),
                self.say(&Words::ValueNotKnown),
                self.by(Slot::R(index), &Words::PowerUp),
            ]),
            None if state.is_read_from_machine(index) => Some(vec![format!("R{index}"), self.say(&Words::FromMachine)]),
            None => None,
        };
        (0..96).filter_map(row).collect()
    }

    fn progress(&self) -> Vec<Row> {
        let Found { blocks, path, times, .. } = self.found;
        let row = |name: Words, cells: [String; 4]| [vec![self.say(&name)], cells.to_vec()].concat();
        let seconds = |progress: Progress<f64>| parts(progress).map(clock);
        let lengths = |progress: Progress<Micro>| parts(progress).map(|length| trimmed(length.to_f64(), 3));
        let tool = |words: &Words| format!("{}, {}", self.say(words), self.say(&Words::ThisTool));
        let head = [self.say(&Words::Done), self.say(&Words::Left), tool(&Words::Done), tool(&Words::Left)];
        let mut rows = vec![
            [vec![String::new()], head.to_vec()].concat(),
            row(Words::Blocks, parts(*blocks).map(|count| count.to_string())),
            row(Words::Path, lengths(*path)),
        ];
        rows.extend(times.map(|times| row(Words::Time, seconds(times.seconds))));
        if times.is_none() {
            let many = blocks.done + blocks.left > Timing::ASSUMED;
            let why = if many { Words::NoTimes { blocks: Timing::ASSUMED } } else { Words::NoMotion };
            rows.push(vec![self.say(&why)]);
        }
        if times.is_some_and(|times| times.lower_bound) || !self.found.whole {
            rows.push(vec![self.say(&Words::AtLeast)]);
        }
        let next = [
            self.found.next_tool_change.map(|seq| Words::NextToolChange { seq }),
            self.found.next_stop.map(|seq| Words::NextStop { seq }),
            self.found.next_rapid.map(|seq| Words::NextRapid { seq }),
        ];
        rows.extend(next.into_iter().flatten().map(|words| vec![self.say(&words)]));
        rows
    }
}

/// Done, left, and the same of the tool.
fn parts<T: Copy>(progress: Progress<T>) -> [T; 4] {
    [progress.done, progress.left, progress.tool_done, progress.tool_left]
}
