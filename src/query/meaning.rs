//! The meaning of a word in the dictionary and the configuration.

use std::path::Path;

use super::analysis::Analysis;
use super::callee::{about, inputs, tool};
use super::flow::Flow;
use super::hover_texts::Said;
use super::observe::{control_of, g_functions};
use super::observed::Observed;
use super::page::Page;
use super::reach::Reach;
use super::shown;
use crate::analysis::plc;
use crate::dict::Micro;
use crate::dict::{Address, FeedMode, GCode, Lang, Lasting, standard_m_functions};
use crate::resolve::Target;
use crate::run::FeedUnit;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::Span;

/// Longest text of a block that is shown, in characters.
const EXCERPT: usize = 60;

/// The subject of a hover.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Subject<'a> {
    pub(crate) analysis: &'a Analysis,
    /// The document.
    pub(crate) file: &'a ParsedFile,
    pub(crate) lang: Lang,
}

impl Subject<'_> {
    /// Adds what a word of a block is.
    pub(crate) fn word(&self, page: &mut Page, block: BlockId, word: Word, observed: Option<&Observed>) {
        let shown_word = shown::word(word, self.unit_of_word(block, word, observed));
        let number = word.whole().and_then(|number| u8::try_from(number).ok());
        match (word.address, number) {
            (Address::G, Some(number)) if let Some(code) = GCode::from_number(number) => {
                page.heading(&shown_word, code.meaning().get(self.lang));
                let (group, meaning) = (code.group().to_string(), code.group().meaning().get(self.lang));
                self.lines(page, [Said::GGroup { group, meaning }, lasts(code.lasting())]);
            }
            (Address::M, Some(number)) => self.m_function(page, &shown_word, number),
            _ => {
                if word.address == Address::S && self.cuts(block, observed) == Some(true) {
                    page.heading(&shown_word, &self.say(&Said::CuttingSpeed));
                } else {
                    page.heading(&shown_word, word.address.row().meaning.get(self.lang));
                }
                self.address(page, block, word);
                if word.address == Address::T
                    && let Some(title) = word.whole().and_then(|number| tool(self.file, number))
                {
                    page.line(&self.say(&Said::Title { title: page.user(title) }));
                }
            }
        }
        self.signals(page, word, observed);
        if matches!(word.address, Address::G | Address::L | Address::Q)
            && let Some(flow) = Flow::of(self.analysis, self.file, block)
            && (word.address != Address::G || word.start() == flow.word.start())
        {
            self.flow(page, block, &flow);
            self.called(page, &flow, observed);
        }
    }

    /// The parameters that the macrocycle takes which a block calls.
    pub(crate) fn inputs(&self, block: BlockId) -> Vec<u8> {
        let flow = Flow::of(self.analysis, self.file, block).filter(|flow| flow.code == GCode::G72);
        let Some(Target::Unit(id)) = flow.and_then(|flow| flow.target) else { return Vec::new() };
        let reach = Reach::of(self.analysis);
        let unit = reach.resolved().unit(id).copied();
        unit.and_then(|unit| Some(inputs(&reach.names(unit.file)?, &unit))).unwrap_or_default()
    }

    /// Adds the comments of the called unit, and the values that it takes.
    fn called(&self, page: &mut Page, flow: &Flow, observed: Option<&Observed>) {
        let Some(Target::Unit(id)) = flow.target else { return };
        let Some(unit) = self.analysis.resolved.unit(id) else { return };
        if let Some(file) = self.analysis.resolved.file(unit.file) {
            page.quote(&about(file, unit));
        }
        let values = observed.map(|observed| &observed.inputs).into_iter().flatten();
        let shown: Vec<String> = values
            .map(|(index, values)| match values.is_known() {
                true => format!("R{index} = {}", values.list(|value| value)),
                false => format!("R{index}"),
            })
            .collect();
        if !shown.is_empty() {
            page.item(&self.say(&Said::Inputs), &shown.join("; "));
        }
    }

    /// Adds the signals that the word sets in the interface to the PLC.
    fn signals(&self, page: &mut Page, word: Word, observed: Option<&Observed>) {
        let Some(number) = word.number() else { return };
        let seen = observed.map(|observed| observed.plc.as_slice()).unwrap_or_default();
        let more = observed.is_some_and(|observed| observed.more_plc);
        let sets = plc::of_word(word.address, number, &self.analysis.settings.machine, seen);
        for (said, set) in [(Said::Plc, &sets.step), (Said::PlcAtStop, &sets.stop)] {
            if !set.is_empty() {
                let texts: Vec<String> =
                    set.iter().map(|set| page.code(&set_signal(set, !seen.is_empty(), more))).collect();
                page.item(&self.say(&said), &texts.join(" "));
            }
        }
    }

    fn say(&self, said: &Said) -> String {
        said.text(self.lang)
    }

    fn lines(&self, page: &mut Page, said: impl IntoIterator<Item = Said>) {
        let texts: Vec<String> = said.into_iter().map(|said| self.say(&said)).collect();
        if !texts.is_empty() {
            page.line(&texts.join("; "));
        }
    }

    fn m_function(&self, page: &mut Page, shown_word: &str, number: u8) {
        let machine = &self.analysis.settings.machine;
        let row = standard_m_functions(machine.dialect).find(|row| row.number == number);
        let meaning = row.map_or(Address::M.row().meaning, |row| row.meaning);
        page.heading(shown_word, meaning.get(self.lang));
        let group = machine.m_functions.group(number);
        let of_block = matches!(group, 1 | 7 | 9);
        let lasting = row.map_or(if of_block { Lasting::Block } else { Lasting::Modal }, |row| row.lasting);
        let mut said = vec![Said::MGroup { group }, lasts(lasting)];
        if row.is_none() {
            said.insert(0, Said::ByBuilder);
        }
        self.lines(page, said);
        let Some(function) = machine.m_functions.get(number) else { return };
        let attributes = [
            (function.break_cont, Said::BreakCont),
            (function.break_cont_end, Said::BreakContEnd),
            (function.change_pos, Said::ChangePos),
        ];
        self.lines(page, attributes.into_iter().filter(|(set, _)| *set).map(|(_, said)| said));
    }

    /// What there is to say of an address that is neither G nor M.
    fn address(&self, page: &mut Page, block: BlockId, word: Word) {
        let mut said = Vec::new();
        if word.address == Address::R {
            self.parameter(page, block, word, &mut said);
        } else if word.address == Address::I && self.writes(block, |code| code == GCode::G23) {
            said.push(Said::DynamicSet);
        } else if word.address == Address::Q && self.writes(block, |code| code == GCode::G04) {
            let seconds = word.number().map(|number| Micro::from_millionths(number.thousandths().saturating_mul(10)));
            said.extend(seconds.map(|seconds| Said::Dwell { s: seconds.to_string() }));
        } else {
            said.extend(self.axis(word).map(|rotary| if rotary { Said::RotaryAxis } else { Said::LinearAxis }));
        }
        if word.address.row().lasts_until_changed {
            said.push(Said::UntilChanged);
        }
        self.lines(page, said);
    }

    /// Adds the purpose of a parameter.
    fn parameter(&self, page: &Page, block: BlockId, word: Word, said: &mut Vec<Said>) {
        match (word.target(), control_of(&self.analysis.settings.machine, self.file, block, word)) {
            (_, Some(control)) => {
                said.push(Said::Control { formula: page.code(&shown::formula(control)) });
                said.extend(control.whole.then_some(Said::InWholes));
            }
            (95, None) => said.push(Said::Reserved),
            (5..=8, None) => said.push(Said::MayControl),
            (_, None) => {}
        }
    }

    fn writes(&self, block: BlockId, wanted: impl Fn(GCode) -> bool) -> bool {
        g_functions(self.file, block).any(|(code, _)| wanted(code))
    }

    /// What the function of group G6 that a block writes says of F and S.
    fn written_mode(&self, block: BlockId) -> Option<FeedMode> {
        let machine = &self.analysis.settings.machine;
        g_functions(self.file, block).find_map(|(code, _)| machine.feed_mode(code))
    }

    /// Whether S is a constant cutting speed in a block.
    fn cuts(&self, block: BlockId, observed: Option<&Observed>) -> Option<bool> {
        let seen = observed.and_then(|observed| observed.cuts.only());
        seen.or_else(|| self.written_mode(block).map(|mode| mode.constant_cut))
    }

    /// The unit of a word's value; empty when there is none, or it is not known.
    fn unit_of_word(&self, block: BlockId, word: Word, observed: Option<&Observed>) -> &'static str {
        let writes = |wanted: &[GCode]| self.writes(block, |code| wanted.contains(&code));
        if word.address == Address::S {
            return if self.cuts(block, observed) == Some(true) { "" } else { shown::speed_unit(self.lang) };
        }
        if word.address == Address::F {
            let seen = observed.and_then(|observed| observed.feed_unit.only());
            let written = self.written_mode(block).map(|mode| FeedUnit::of(mode.per, false));
            return seen.or(written).map_or("", |unit| unit.shown(self.lang));
        }
        // Factors, angles and the like.
        if writes(&[GCode::G31, GCode::G35, GCode::G36, GCode::G38, GCode::G39]) {
            return "";
        }
        let distance = matches!(word.address, Address::I | Address::J) && !writes(&[GCode::G23]);
        match self.axis(word) {
            Some(true) => "°",
            Some(false) => "mm",
            None if distance => "mm",
            None => "",
        }
    }

    /// Whether the axis that a word is turns; `None`: it is no axis of the machine.
    fn axis(&self, word: Word) -> Option<bool> {
        let axes = &self.analysis.settings.machine.axes;
        axes.index_of(word.address).and_then(|axis| axes.get(axis)).map(|axis| axis.rotary)
    }

    /// Adds the unit or block that a block calls, enters or jumps to.
    fn flow(&self, page: &mut Page, block: BlockId, flow: &Flow) {
        let file = self.file;
        let number = |block| file.shown_number(block);
        let l = flow.l.and_then(|l| l.whole()).and_then(|l| u32::try_from(l).ok());
        match (flow.code, l) {
            (GCode::G71 | GCode::G72, Some(l)) => {
                let name = format!("L{l}");
                let called =
                    if flow.code == GCode::G71 { Said::Subprogram { name } } else { Said::Macrocycle { name } };
                let text = self.say(&called);
                match flow.times() {
                    Some(times) if times != 1 => page.line(&self.say(&Said::Times { text, times })),
                    _ => page.line(&text),
                }
            }
            (GCode::G73, Some(to)) => {
                let mut said = vec![Said::Jump { to }];
                match (flow.jump(), flow.times()) {
                    (Some(to), Some(times)) if to <= block => {
                        let passes = times.saturating_add(1).to_string();
                        said.push(Said::Stretch { from: number(to), to: number(block), passes });
                    }
                    (Some(_), Some(_)) if flow.uncounted => said.push(Said::Always),
                    (Some(_), Some(times)) => said.push(Said::TakenThenOn { times: times.to_string() }),
                    _ => {}
                }
                self.lines(page, said);
            }
            _ => {}
        }
        if let Some(target) = self.target(page, flow) {
            page.item(&self.say(&Said::Target), &target);
        }
    }

    /// The block that a call or jump leads to: its text, its comment, its file.
    fn target(&self, page: &Page, flow: &Flow) -> Option<String> {
        let (index, block) = flow.place(self.analysis)?;
        let file = self.analysis.resolved.file(index)?;
        let mut parts = vec![page.code(&excerpt(file, block))];
        let comments = file.comments(block).iter().map(|comment| file.comment_text(*comment));
        let of_unit = matches!(flow.target, Some(Target::Unit(_)));
        if let Some(title) = comments.into_iter().find(|text| !text.is_empty()).filter(|_| !of_unit) {
            parts.push(self.say(&Said::Title { title: page.user(title) }));
        }
        if matches!(flow.target, Some(Target::Unit(_))) && index != super::cursor::DOCUMENT {
            parts.push(self.say(&Said::InFile { file: page.code(&file_name(file.source.name())) }));
        }
        Some(parts.join(" "))
    }
}

/// `PB06=03h`; values of different passes behind one another. Without execution only the names of signals that depend
/// on it.
fn set_signal((signal, values): &plc::SetSignal, executed: bool, more: bool) -> String {
    let mut text = signal.name.clone();
    if !executed && values.iter().all(Option::is_none) {
        return text;
    }
    for (index, value) in values.iter().enumerate() {
        text.push(if index == 0 { '=' } else { '/' });
        match value {
            Some(_) => plc::write_value(signal, *value, &mut text),
            None => text.push('-'),
        }
    }
    if more && values.len() > 1 {
        text.push_str("/…");
    }
    text
}

/// How long something holds.
const fn lasts(lasting: Lasting) -> Said {
    match lasting {
        Lasting::Modal => Said::UntilNext,
        Lasting::Default => Said::UntilNextAndDefault,
        Lasting::Block => Said::InBlock,
    }
}

/// The last part of a path.
pub(crate) fn file_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The words of a block in one line, cut when long.
fn excerpt(file: &ParsedFile, block: BlockId) -> String {
    let text = file.source.text();
    let words = file.n_word(block).into_iter().chain(file.words(block).iter().copied());
    let mut line = String::new();
    for word in words {
        let span: Span = word.span(text);
        if !line.is_empty() {
            line.push(' ');
        }
        if line.chars().count() + span.range().len() > EXCERPT {
            line.push('…');
            break;
        }
        line.extend(file.source.slice(span).chars().filter(|character| !character.is_control()));
    }
    line
}
