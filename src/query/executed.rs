//! What execution makes of a block or a program, as a part of a hover.

use super::analysis::Analysis;
use super::hover_texts::Said;
use super::meaning::{Subject, file_name};
use super::moves::{JoinedBy, Moved};
use super::observe::Observation;
use super::observed::Observed;
use super::page::Page;
use super::shown::{count, rounded, speed_unit};
use super::values::Values;
use crate::dict::{Address, AxisLetter, Decimal, Lang, Micro};
use crate::session::Session;
use crate::syntax::{BlockId, Value, Word};

/// Parameters of one block that are shown.
const PARAMETERS: usize = 12;
/// The number of the group of calls and jumps, where G70 says nothing.
const CALLS: usize = 7;

impl Subject<'_> {
    /// Adds what was seen of a block. `word`: the one that is asked for.
    pub(crate) fn execution(
        &self,
        page: &mut Page,
        program: &Analysis,
        observation: &Observation,
        block: BlockId,
        word: Option<Word>,
    ) {
        let Some(observed) = observation.of(block) else { return };
        let n = self.file.shown_number(block);
        let mut title = match observed.runs {
            0 if observation.end.is_none() => Said::RunsUnknown { n },
            0 => Said::NeverRuns { n },
            runs => Said::Runs { n, runs: count(runs) },
        }
        .text(self.lang);
        if program.path != self.analysis.path {
            let file = page.user(&file_name(&program.path.to_string_lossy()));
            title = format!("{title}, {}", Said::InProgram { file }.text(self.lang));
        }
        page.title(&self.qualified(title, observation));
        if observed.runs > 0 {
            self.parameters(page, observed, word);
            self.state(page, program, observed);
            if let Some(moved) = observation.moves.as_ref().and_then(|seen| seen.blocks.get(&block)) {
                self.moved(page, moved);
            }
            if observation.unplanned {
                let command = page.code("cnc872c motion");
                page.item(&Said::BlockTime.text(self.lang), &Said::Unplanned { command }.text(self.lang));
            }
        }
    }

    /// Why nothing is known of the execution of the document.
    pub(crate) fn no_execution(&self, page: &mut Page) {
        let macrocycle = Session::is_macrocycle_name(&self.analysis.path);
        let said = if macrocycle { Said::NoProgram } else { Said::HasErrors };
        page.line(&said.text(self.lang));
    }

    /// Adds the notes on the whole program.
    pub(crate) fn program(&self, page: &mut Page, word: Word, observation: Option<&Observation>) {
        let title = self.file.title.map(|title| self.file.comment_text(title)).unwrap_or_default();
        let meaning = Address::Program.row().meaning.get(self.lang);
        page.heading(&super::shown::word(word, ""), meaning);
        if !title.is_empty() {
            page.line(&Said::Title { title: page.user(title) }.text(self.lang));
        }
        page.item(&Said::Axes.text(self.lang), &self.analysis.settings.machine.axes.letters());
        let Some(observation) = observation else {
            page.rule();
            self.no_execution(page);
            return;
        };
        page.item(&Said::Executed.text(self.lang), &self.qualified(count(observation.executed), observation));
        page.item(&Said::Path.text(self.lang), &path(observation, self.lang));
        if let Some(seen) = &observation.moves {
            page.item(&Said::BlockTime.text(self.lang), &seen.total.text(self.lang));
        }
        if let Some(end) = observation.end {
            page.item(&Said::End.text(self.lang), &page.code(&format!("M{end:02}")));
        }
    }

    /// With a remark when execution did not come to the end.
    fn qualified(&self, text: String, observation: &Observation) -> String {
        let remark = match observation.end {
            Some(_) => return text,
            None if observation.cut => Said::Cut { most: count(observation.executed) },
            None => Said::NoFurther { last: observation.last },
        };
        format!("{text}, {}", remark.text(self.lang))
    }

    /// The parameters that the word, else the block, reads and writes.
    fn parameters(&self, page: &mut Page, observed: &Observed, word: Option<Word>) {
        let asked = word.filter(|word| word.is_parametric() || word.address == Address::R);
        let read = asked.and_then(|word| match word.value() {
            Value::Parameter { index, negated } => Some((index, negated)),
            Value::None | Value::Number(_) => None,
        });
        let wanted_read = |index: u8| asked.is_none() || read.is_some_and(|(read, _)| read == index);
        for (index, values) in observed.reads.iter().filter(|(index, _)| wanted_read(**index)).take(PARAMETERS) {
            page.item(&Said::Before { r: *index }.text(self.lang), &self.values(values));
        }
        if let Some((index, true)) = read
            && let Some(values) = observed.reads.get(&index).filter(|values| values.is_known())
        {
            page.item(&Said::Here.text(self.lang), &self.values(&values.map(Decimal::negated)));
        }
        let wanted_write = |_: u8| asked.is_none_or(|word| word.address == Address::R);
        for (index, values) in observed.writes.iter().filter(|(index, _)| wanted_write(**index)).take(PARAMETERS) {
            page.item(&Said::After { r: *index }.text(self.lang), &self.values(values));
        }
    }

    fn values(&self, values: &Values<Decimal>) -> String {
        if values.is_known() { values.list(|value| value) } else { Said::Unknown.text(self.lang) }
    }

    /// Positions, the motion, the dwell, what is in force.
    fn state(&self, page: &mut Page, program: &Analysis, observed: &Observed) {
        let label = |said: Said| said.text(self.lang);
        page.item(&label(Said::Position), &self.positions(program, observed));
        let lengths = [(&observed.length_mm, "mm"), (&observed.length_deg, "°")];
        for (values, unit) in lengths.into_iter().filter(|(values, _)| !values.is_empty()) {
            let text =
                if values.is_known() { format!("{} {unit}", values.list(rounded)) } else { label(Said::Unknown) };
            page.item(&label(Said::Length), &text);
        }
        if observed.dwell_s.is_known() {
            page.item(&label(Said::DwellTime), &format!("{} s", observed.dwell_s.list(|value| value)));
        }
        if observed.jumps > 0 {
            page.item(&label(Said::Taken), &format!("{}×", count(observed.jumps)));
        }
        let g = observed.g.iter().enumerate().filter(|(group, values)| *group != CALLS || values.first() != Some(70));
        page.item(&label(Said::GInForce), &functions(page, 'G', g.map(|(_, values)| values)));
        page.item(&label(Said::MInForce), &functions(page, 'M', &observed.m));
        let technology = self.technology(observed);
        if !technology.is_empty() {
            page.item(&label(Said::Technology), &technology.join("; "));
        }
    }

    /// How the machine moves through the block.
    fn moved(&self, page: &mut Page, moved: &Moved) {
        let [start, peak, end] = &moved.velocities;
        if start.is_known() {
            let unit = if moved.in_degrees { "°/min" } else { "mm/min" };
            let [start, peak, end] = [start, peak, end].map(|values| values.list(|value| value));
            page.item(&Said::Velocities.text(self.lang), &format!("{start} / {peak} / {end} {unit}"));
        }
        if moved.joined.is_known() {
            let joined = moved.joined.list(|joined| match joined {
                JoinedBy::Broken(reason) => Said::JointStops { reason: reason.text(self.lang) }.text(self.lang),
                JoinedBy::Limited(limit) => Said::JointLimited { limit: limit.text(self.lang) }.text(self.lang),
            });
            page.item(&Said::JointBefore.text(self.lang), &joined);
        }
        if moved.time_s.list(|value| value) != "0" && moved.time_s.is_known() {
            page.item(&Said::BlockTime.text(self.lang), &format!("{} s", moved.time_s.list(|value| value)));
        }
    }

    fn positions(&self, program: &Analysis, observed: &Observed) -> String {
        let axes = program.settings.machine.axes.iter();
        let known = axes.filter_map(|axis| {
            let place = AxisLetter::ALL.into_iter().position(|letter| letter == axis.letter)?;
            let values = observed.positions.get(place).filter(|values| values.is_known())?;
            let mut text =
                format!("{} {} {}", axis.letter, values.list(|value| value), if axis.rotary { "°" } else { "mm" });
            if axis.letter == AxisLetter::X && observed.diameters.only() == Some(true) {
                text.push_str(&format!(" (Ø {})", values.map(|radius| radius.plus(radius)).list(|value| value)));
            }
            Some(text)
        });
        let known: Vec<String> = known.collect();
        if known.is_empty() { Said::Unknown.text(self.lang) } else { known.join("; ") }
    }

    fn technology(&self, observed: &Observed) -> Vec<String> {
        let unit = observed.feed_unit.only().map_or("", |unit| unit.shown(self.lang));
        let speed = match observed.cuts.only() {
            Some(true) => format!("({})", Said::CuttingSpeed.text(self.lang)),
            Some(false) => speed_unit(self.lang).to_owned(),
            None => String::new(),
        };
        let rows = [
            ("F", &observed.feed, unit),
            ("S", &observed.speed, speed.as_str()),
            ("T", &observed.tool, ""),
            ("H", &observed.h, ""),
            ("P", &observed.p, ""),
            ("D", &observed.d, ""),
        ];
        let rows = rows.into_iter().filter(|(_, values, _)| values.is_known());
        let mut shown: Vec<String> = rows
            .map(|(letter, values, unit)| match (values.list(|value| value), unit) {
                (values, "") => format!("{letter}{values}"),
                (values, unit) => format!("{letter} {values} {unit}"),
            })
            .collect();
        if observed.correction.is_known() {
            shown.push(format!("&{}", observed.correction.list(|digits| format!("{digits:04}"))));
        }
        shown
    }
}

/// The path of a program: `12.5 mm`, or that nothing is known of it.
pub(crate) fn path(observation: &Observation, lang: Lang) -> String {
    let known = format!("{} mm", rounded(observation.path));
    let Observation { path, approaches, partly_unknown, .. } = observation;
    if *path == Micro::ZERO && (*approaches || *partly_unknown) {
        return Said::Unknown.text(lang);
    }
    if *partly_unknown { Said::AtLeast { path: known }.text(lang) } else { known }
}

/// `G01 G17 G90/G91 …`: one of each group, those of different passes behind one another.
fn functions<'a>(page: &Page, letter: char, groups: impl IntoIterator<Item = &'a Values<u8>>) -> String {
    let groups = groups.into_iter().filter(|values| values.is_known());
    let shown: Vec<String> =
        groups.map(|values| values.list(|number| format!("{letter}{number:02}")).replace(", ", "/")).collect();
    page.code(&shown.join(" "))
}
