//! The blocks that lead to the state at the place, in the order of RST-1.

use super::approach::{Approach, Height, Lack};
use super::lines::Lines;
use super::reason::{Note, Reason};
use super::scan::There;
use super::tracker::Options;
use crate::analysis::state::{Found, Slot, Written};
use crate::config::Settings;
use crate::dict::{
    AxisLetter, BUILDER_GROUPS, Decimal, FIRST_DYNAMIC_SET, FeedMode, GCode, GEAR_BY_SPEED, GEAR_GROUP, GGroup, Lang,
    M_GROUPS, MOMENTARY_GROUPS, OTHER_GROUP, SPINDLE_GROUP, standard_m_functions,
};

/// What the preamble is made of.
#[derive(Clone, Copy)]
pub(super) struct Sources<'a> {
    pub settings: &'a Settings,
    pub found: &'a Found,
    pub there: &'a There,
    pub approach: &'a Approach,
    pub options: Options,
    pub lang: Lang,
}

/// Writes the preamble.
pub(super) struct Preamble<'a> {
    from: Sources<'a>,
    lines: Lines,
    /// The functions in force so far.
    now: [Option<GCode>; 12],
}

/// Groups of which the function in force is restored at the end, behind the approach.
const LATE: [GGroup; 3] = [GGroup::G0, GGroup::G2, GGroup::G9];

impl<'a> Preamble<'a> {
    pub fn new(from: Sources<'a>, lines: Lines) -> Self {
        Self { from, lines, now: from.settings.machine.power_up }
    }

    /// All of it; `parameters`: those that the rest reads.
    ///
    /// # Errors
    /// When a value or a position cannot be written.
    pub fn write(mut self, parameters: &[u8]) -> Result<Lines, Reason> {
        self.parameters(parameters);
        self.functions();
        self.tool();
        // F of a constant cutting speed, or beside one, before the spindle turns: S would count otherwise.
        let before = self.feed_function().is_some_and(|function| self.cuts_otherwise(function));
        if before {
            self.feed();
        }
        self.spindle();
        let state = &self.from.found.state;
        let auxiliary = [("H", state.h()), ("P", state.p())];
        let words = auxiliary.into_iter().filter_map(|(letter, value)| Some(format!("{letter}{}", value?)));
        self.block(words.collect(), &Note::Auxiliary);
        self.m_functions();
        self.dynamic_set();
        if !before {
            self.feed();
        }
        self.approach()?;
        self.last();
        Ok(self.lines)
    }

    fn block(&mut self, words: Vec<String>, note: &Note) {
        if !words.is_empty() {
            self.lines.block(&words, &note.comment(self.from.lang));
        }
    }

    /// The block that wrote something last.
    fn writer(&self, slot: Slot) -> Option<&'a Written> {
        self.from.found.writer(slot)
    }

    fn in_force(&self, group: GGroup) -> Option<GCode> {
        self.from.found.state.g_in_force(group)
    }

    /// A word for a function that is not in force yet.
    fn word(&mut self, function: Option<GCode>) -> Option<String> {
        let function = function?;
        let now = self.now.get_mut(function.group().index())?;
        (now.replace(function) != Some(function)).then(|| function.to_string())
    }

    fn parameters(&mut self, parameters: &[u8]) {
        let state = &self.from.found.state;
        let word = |index: &u8| Some(format!("R{index}={}", state.parameter(*index)?));
        let words: Vec<String> = parameters.iter().filter_map(word).collect();
        for words in words.chunks(PARAMETERS) {
            self.block(words.to_vec(), &Note::Parameters);
        }
    }

    fn functions(&mut self) {
        let mut words = Vec::new();
        for group in GGroup::ALL {
            let late = LATE.contains(&group) && !self.is_early(group);
            if !late && group != GGroup::G11 {
                let function = self.in_force(group);
                words.extend(self.word(function));
            }
        }
        // The approach is written so.
        if self.now.get(GGroup::G9.index()) != Some(&Some(GCode::G90)) {
            words.extend(self.word(Some(GCode::G90)));
        }
        self.block(words, &Note::Functions);
        let conversion = self.in_force(GGroup::G11);
        let Some(word) = self.word(conversion) else { return };
        let of_last = self.from.there.conversion.iter().filter(|last| Some(last.function) == conversion);
        let values = of_last.flat_map(|last| last.values.iter().map(|(letter, value)| format!("{letter}{value}")));
        let words = [word].into_iter().chain(values).collect();
        self.block(words, &Note::Functions);
    }

    /// G24 and the like may be in force before the approach, G23 only behind it.
    fn is_early(&self, group: GGroup) -> bool {
        group == GGroup::G2 && self.in_force(group) != Some(GCode::G23)
    }

    fn tool(&mut self) {
        let state = &self.from.found.state;
        let tool = state.tool_in_spindle();
        let mut words: Vec<String> = tool.or_else(|| state.t()).map(|t| format!("T{t}")).into_iter().collect();
        words.extend(state.d().map(|d| format!("D{d}")));
        words.extend(state.length_correction().map(|digits| format!("&{digits:04}")));
        words.extend(tool.map(|_| "M06".to_owned()));
        let note = match (tool, self.writer(Slot::value("tool"))) {
            (Some(_), Some(written)) => Note::ToolChangeOf { n: written.n },
            (Some(_), None) => Note::ToolChange,
            (None, _) => Note::Tool,
        };
        self.block(words, &note);
        let next = state.t().filter(|t| tool.is_some_and(|tool| tool != *t));
        self.block(next.map(|t| format!("T{t}")).into_iter().collect(), &Note::NextTool);
    }

    /// Whether the function of an M group is not the one of power-up.
    fn m_to_restore(&self, group: usize) -> Option<u8> {
        let power_up = self.from.settings.machine.m_power_up.get(group).copied().flatten();
        self.from.found.state.m_in_force(group).filter(|number| Some(*number) != power_up)
    }

    fn mode(&self, function: GCode) -> Option<FeedMode> {
        self.from.settings.machine.feed_mode(function)
    }

    /// Whether S counts otherwise under a function of group 6 than under the one in force.
    fn cuts_otherwise(&self, function: GCode) -> bool {
        let cuts = |function: GCode| self.mode(function).is_some_and(|mode| mode.constant_cut);
        self.in_force(GGroup::G6).is_some_and(|in_force| cuts(in_force) != cuts(function))
    }

    /// The function that F has to be written under, where F counts otherwise under the one in force.
    fn feed_function(&self) -> Option<GCode> {
        let per = |function: GCode| self.mode(function).map(|mode| mode.per);
        let in_force = self.in_force(GGroup::G6);
        self.from.there.feed_mode.filter(|function| in_force.and_then(per) != per(*function))
    }

    /// The speed that the gear follows from, with its G6 function, where S is a cutting speed (MFN-9).
    fn turning(&self) -> Option<(GCode, Decimal)> {
        let of_cut = self.from.there.speed_mode.is_some_and(|function| !self.cuts_otherwise(function));
        let follows = self.from.found.state.m_in_force(GEAR_GROUP) == Some(GEAR_BY_SPEED);
        let geared = self.from.found.state.gear_in_force().is_some() && follows;
        self.from.there.turning.filter(|(function, _)| geared && of_cut && self.cuts_otherwise(*function))
    }

    fn spindle(&mut self) {
        let state = &self.from.found.state;
        let speed = state.s();
        let mut words: Vec<String> = self.m_to_restore(GEAR_GROUP).map(|m| format!("M{m:02}")).into_iter().collect();
        if let Some((function, s)) = self.turning() {
            words.extend(self.word(Some(function)));
            words.push(format!("S{s}"));
            self.block(std::mem::take(&mut words), &Note::Gear);
            let in_force = self.in_force(GGroup::G6);
            words.extend(self.word(in_force));
        }
        words.extend(speed.map(|s| format!("S{s}")));
        let function = self.from.there.speed_mode.filter(|function| speed.is_some() && self.cuts_otherwise(*function));
        if let Some(word) = self.word(function) {
            words.insert(0, word);
            self.block(std::mem::take(&mut words), &Note::Spindle);
            let in_force = self.in_force(GGroup::G6);
            words.extend(self.word(in_force));
        }
        words.extend(self.m_to_restore(SPINDLE_GROUP).map(|m| format!("M{m:02}")));
        let note = match self.writer(Slot::M(SPINDLE_GROUP)) {
            Some(written) => Note::SpindleOf { n: written.n },
            None => Note::Spindle,
        };
        self.block(words, &note);
    }

    /// The other M groups, in the order of their last writing.
    fn m_functions(&mut self) {
        let mut functions: Vec<(u64, u32, u8)> = Vec::new();
        let apart = [SPINDLE_GROUP, GEAR_GROUP, usize::from(OTHER_GROUP)];
        for group in (0..M_GROUPS).filter(|group| !apart.contains(group)) {
            let momentary = MOMENTARY_GROUPS.iter().any(|momentary| usize::from(*momentary) == group);
            let builder = BUILDER_GROUPS.contains(&group) && !self.from.options.all_m;
            if let Some(number) = self.m_to_restore(group).filter(|_| !momentary && !builder) {
                let (seq, n) = self.writer(Slot::M(group)).map_or((0, 0), |written| (written.seq, written.n));
                functions.push((seq, n, number));
            }
        }
        let (m_functions, all_m) = (&self.from.settings.machine.m_functions, self.from.options.all_m);
        let restored = |(_, _, number): &&(u64, u32, u8)| all_m || m_functions.group(*number) != OTHER_GROUP;
        functions.extend(self.from.there.apart.iter().filter(restored).copied());
        functions.sort_unstable();
        for (_, n, number) in functions {
            let machine = &self.from.settings.machine;
            let group = machine.m_functions.group(number);
            let row = standard_m_functions(machine.dialect).find(|row| row.number == number && row.group == group);
            let note = match row {
                Some(row) => Note::Function { meaning: row.meaning.get(self.from.lang).to_owned(), n },
                None => Note::FunctionOf { n },
            };
            self.block(vec![format!("M{number:02}")], &note);
        }
    }

    /// The set that the next G23 takes, where G23 is not in force.
    fn dynamic_set(&mut self) {
        let set = self.from.found.state.chosen_dynamic_set().filter(|set| *set != FIRST_DYNAMIC_SET);
        let Some(set) = set.filter(|_| self.in_force(GGroup::G2) != Some(GCode::G23)) else { return };
        let function = self.in_force(GGroup::G2);
        let words = self.word(Some(GCode::G23)).into_iter().chain([format!("I{set}")]).collect();
        self.block(words, &Note::Set);
        let words = self.word(function).into_iter().collect();
        self.block(words, &Note::Set);
    }

    fn feed(&mut self) {
        let state = &self.from.found.state;
        if let Some(feed) = state.feed(&self.from.settings.machine) {
            let function = self.feed_function();
            let mut words: Vec<String> = self.word(function).into_iter().collect();
            words.push(format!("F{}", feed.value));
            let note = match self.writer(Slot::value("feed")) {
                Some(written) => Note::FeedOf { n: written.n },
                None => Note::Feed,
            };
            self.block(words, &note);
        }
        let mode = self.in_force(GGroup::G6);
        let words = self.word(mode).into_iter().collect();
        self.block(words, &Note::Mode);
    }

    /// RST-2.
    fn approach(&mut self) -> Result<(), Reason> {
        let approach = self.from.approach;
        let position = |axis, at| Ok(format!("{axis}{}", approach.written(axis, at)?));
        let tool_axis = self.from.settings.machine.tool_axis.unwrap_or(AxisLetter::Z);
        let references = approach.reference.clone();
        let (tool_first, others): (Vec<AxisLetter>, Vec<AxisLetter>) =
            references.into_iter().partition(|axis| *axis == tool_axis);
        for axis in tool_first {
            self.reference(axis);
        }
        if let Some((axis, _)) = approach.tool {
            let note = match approach.height {
                Height::Safe => Note::Safe,
                Height::Place => Note::Level,
                Height::Highest => Note::Highest,
            };
            let words = vec![self.rapid(), "G90".to_owned(), position(axis, approach.top)?];
            self.block(words, &note);
        }
        for axis in others {
            self.reference(axis);
        }
        let words = approach.others.iter().map(|(axis, at)| position(*axis, *at)).collect::<Result<Vec<_>, _>>()?;
        if !words.is_empty() {
            let words = [self.rapid()].into_iter().chain(words).collect();
            self.block(words, &Note::Across);
        }
        let Some((axis, place)) = approach.tool.filter(|(_, place)| *place < approach.top) else { return Ok(()) };
        if let Some(down) = approach.down() {
            let clearance = self.from.options.clearance.to_string();
            let words = vec![self.rapid(), position(axis, down)?];
            self.block(words, &Note::Down { clearance });
        }
        self.word(Some(GCode::G01));
        self.block(vec![GCode::G01.to_string(), position(axis, place)?], &Note::Place);
        Ok(())
    }

    fn rapid(&mut self) -> String {
        self.word(Some(GCode::G00));
        GCode::G00.to_string()
    }

    fn reference(&mut self, axis: AxisLetter) {
        let words = vec![GCode::G30.to_string(), format!("{axis}0")];
        self.block(words, &Note::Reference { axis: axis.to_string() });
    }

    /// What holds at the place and would have disturbed the approach.
    fn last(&mut self) {
        let mut words = Vec::new();
        for group in LATE {
            let function = self.in_force(group);
            words.extend(self.word(function));
            let continuous = group == GGroup::G2 && function == Some(GCode::G23);
            let set = self.from.found.state.chosen_dynamic_set().filter(|set| continuous && *set != FIRST_DYNAMIC_SET);
            if let Some(set) = set {
                // It takes the I in its own block only, also where it is in force from power-up on.
                words.extend(Some(GCode::G23.to_string()).filter(|g23| !words.contains(g23)));
                words.push(format!("I{set}"));
            }
        }
        // Comments before the first block would be those of the program.
        if words.is_empty() && self.lines.blocks == 0 {
            words.extend(self.in_force(GGroup::G9).map(|function| function.to_string()));
        }
        self.block(words, &Note::AsThere);
    }
}

/// So many parameters are written in a block.
const PARAMETERS: usize = 24;

/// So many M functions are named in a comment.
const NAMED: usize = 8;

/// What the preamble does not restore, as comments (RST-6).
pub(super) fn notes(from: Sources<'_>, parameters: &[u8], written_out: u64) -> Vec<Note> {
    let state = &from.found.state;
    let mut notes = Vec::new();
    if written_out > 0 {
        notes.push(Note::WrittenOut { blocks: written_out });
    }
    if written_out > 0 && from.settings.block_skip {
        notes.push(Note::Skipped);
    }
    if let Some(axis) = from.approach.descends().filter(|_| from.approach.lathe) {
        notes.push(Note::Lathe { axis: axis.to_string() });
    }
    let is_moved = |axis| from.found.unknown.iter().any(|(letter, _)| *letter == axis);
    let Approach { tool, others, reference, .. } = from.approach;
    // Other axes move in rapid, and the program never says where the tool's axis is.
    let is_blind = tool.is_none() && !others.is_empty();
    let blind = is_blind.then(|| from.settings.machine.tool_axis.unwrap_or(AxisLetter::Z));
    let blind = blind.filter(|axis| !reference.contains(axis));
    let unknown =
        from.there.unknown.iter().copied().filter(|(axis, _)| Some(*axis) != blind && !reference.contains(axis));
    let (unseen, unknown): (Vec<_>, Vec<_>) = unknown.partition(|(_, lack)| *lack == Lack::Unseen);
    for (axis, lack) in unknown.into_iter().chain(blind.map(|axis| (axis, Lack::Lost))) {
        let letter = axis.to_string();
        match lack {
            Lack::Fresh if !is_moved(axis) => {}
            Lack::Turned => {}
            Lack::Fresh | Lack::FromStart => notes.push(Note::Fresh { axis: letter }),
            Lack::Lost | Lack::Unseen => notes.push(Note::Stands { axis: letter }),
        }
    }
    if !unseen.is_empty() {
        let axes: Vec<String> = unseen.iter().map(|(axis, _)| axis.to_string()).collect();
        notes.push(Note::Unseen { axes: axes.join(", ") });
    }
    let machine = &from.settings.machine;
    let apart = from.there.apart.iter().map(|(_, _, number)| *number);
    let others: Vec<u8> = apart.filter(|number| machine.m_functions.group(*number) == OTHER_GROUP).collect();
    for group in BUILDER_GROUPS.filter(|_| !from.options.all_m) {
        let power_up = machine.m_power_up.get(group).copied().flatten();
        let in_force = state.m_in_force(group).filter(|number| Some(*number) != power_up);
        let not_restored =
            if group == usize::from(OTHER_GROUP) { others.clone() } else { in_force.into_iter().collect() };
        for functions in not_restored.chunks(NAMED) {
            let names: Vec<String> = functions.iter().map(|number| format!("M{number:02}")).collect();
            notes.push(Note::NotRestored { m: names.join(", "), group });
        }
    }
    for &r in parameters.iter().filter(|index| state.parameter(**index).is_none()) {
        notes.push(Note::MachineParameter { r });
    }
    notes.extend(from.there.corrections.map(|n| Note::Corrections { n }));
    notes
}
