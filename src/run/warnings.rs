//! What a motion or a tool change lacks (TEC-1…TEC-7), each said once in a program, and the travel of the axes (W0621).

use super::block::InForce;
use super::parameters::with_origin;
use super::site::Site;
use super::state::{Held, Position, State};
use super::travel::Travel;
use super::words::BlockWords;
use crate::config::Axis;
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{
    Address, AxisLetter, Decimal, FeedMode, FeedPer, GCode, GGroup, Micro, SPINDLE_GROUP, SPINDLE_STOP, SPINDLE_TURNS,
    TOOL_CHANGE,
};
use crate::resolve::value_or_word;
use crate::syntax::Word;
use crate::text::FileId;

/// What a working motion, or a thread, lacks: a feed (W0601), a feed of this unit (W0615), a speed (W0604), a spindle that
/// turns (W0619).
pub(super) fn check_motion(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce, thread: bool) {
    if !thread {
        if state.feed == Held::None && !state.said.feed {
            state.said.feed = true;
            site.found(Finding::MissingFeed {}, words.place_of_motion(site));
        }
        check_feed_unit(site, state, words, g);
    }
    if let Some(function) = speed_reader(site, g)
        && state.speed == Held::None
        && !state.said.speed
    {
        state.said.speed = true;
        site.found(Finding::MissingSpindleSpeed { function }, words.place_of_motion(site));
    }
    if lacks_spindle(site, state, thread) {
        state.said.spindle_stopped = true;
        site.found(Finding::SpindleStopped { thread }, words.place_of_motion(site));
    }
}

/// Whether [`check_motion`] may have something to say.
pub(super) fn may_lack(site: &Site<'_>, state: &mut State, g: &InForce, thread: bool) -> bool {
    let feed = !thread && ((state.feed == Held::None && !state.said.feed) || differing_unit(site, state, g).is_some());
    let speed = state.speed == Held::None && !state.said.speed && speed_reader(site, g).is_some();
    feed || speed || lacks_spindle(site, state, thread)
}

/// The G6 function in force, when a motion under it needs S (TEC-3).
fn speed_reader(site: &Site<'_>, g: &InForce) -> Option<GCode> {
    let machine = site.machine();
    g.of(GGroup::G6).filter(|function| machine.feed_mode(*function).is_some_and(FeedMode::needs_speed))
}

/// The G6 function in force, with what F was written as and what it counts now, when these differ and that was not said
/// yet (TEC-1).
fn differing_unit(site: &Site<'_>, state: &State, g: &InForce) -> Option<(GCode, [FeedPer; 2])> {
    let function = g.of(GGroup::G6)?;
    let (written, now) = (state.feed_per?, site.machine().feed_mode(function)?.per);
    let differs = written != now && !state.said.feed_unit && state.feed.value().is_some();
    differs.then_some((function, [written, now]))
}

fn check_feed_unit(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce) {
    let Some((function, [written, now])) = differing_unit(site, state, g) else { return };
    let Some(feed) = state.feed.value() else { return };
    state.said.feed_unit = true;
    let finding = Finding::FeedUnitChanged { feed: feed.to_string(), function, written, now };
    let mut diagnostic = Diagnostic::new(finding, words.place_of_motion(site));
    if let Some(place) = state.origins.feed.0 {
        let written = match written {
            FeedPer::Minute => LabelText::FeedPerMinute,
            FeedPer::Revolution => LabelText::FeedPerRevolution,
        };
        diagnostic = diagnostic.with_label(place, written);
    }
    site.report(diagnostic);
}

/// Whether the spindle stands where it should turn, and nobody said so yet (TEC-7).
fn lacks_spindle(site: &Site<'_>, state: &mut State, thread: bool) -> bool {
    state.m(SPINDLE_GROUP) == Some(SPINDLE_STOP)
        && !state.said.spindle_stopped
        && (thread || *state.turns_spindle.get_or_insert_with(|| program_turns_spindle(site)))
}

/// Whether M03 or M04 is written in the program's file or a macrocycle that it names: else the spindle is none of the
/// program's business.
fn program_turns_spindle(site: &Site<'_>) -> bool {
    let turns = |word: &Word| {
        word.address == Address::M
            && word.number().and_then(Decimal::as_whole).is_some_and(|m| SPINDLE_TURNS.map(i64::from).contains(&m))
    };
    let mut files = (0..).map_while(|file| site.resolved.file(FileId(file)));
    files.any(|file| file.block_ids().any(|block| file.words(block).iter().any(turns)))
}

/// G41 or G42 with no D in force (W0618), M06 with no T (W0620).
pub(super) fn check_tool(site: &mut Site<'_>, state: &mut State, words: &BlockWords) {
    let correction = words.written(GGroup::G3).filter(|(code, _)| *code != GCode::G40);
    if let Some((function, word)) = correction
        && state.d == Held::None
        && !state.said.no_entry
    {
        state.said.no_entry = true;
        site.found(Finding::CorrectionWithoutEntry { function }, site.word_place(word));
    }
    let change = words.m.iter().find(|(m, _)| *m == TOOL_CHANGE).map(|(_, word)| *word);
    if let Some(word) = change
        && state.tool == Held::None
        && !state.said.no_tool
    {
        state.said.no_tool = true;
        site.found(Finding::ToolChangeWithoutTool {}, site.word_place(word));
    }
}

/// An axis that goes some way from where nobody knows (MOT-2): said once for each.
#[inline]
pub(super) fn warn_incremental(site: &mut Site<'_>, state: &mut State, travel: &Travel) {
    if travel.incremental && travel.before == Position::Unknown && travel.distance.is_some() {
        report_incremental(site, state, travel);
    }
}

fn report_incremental(site: &mut Site<'_>, state: &mut State, travel: &Travel) {
    let Some(said @ false) = state.said.incremental.get_mut(travel.axis) else { return };
    *said = true;
    let Some(word) = travel.word else { return };
    let finding = Finding::IncrementalFromUnknown { axis: travel.definition.letter.letter() };
    site.found(finding, site.word_place(word));
}

/// Whether the travel of an axis is configured.
#[inline]
pub(super) const fn has_limits(axis: &Axis) -> bool {
    axis.min.is_some() || axis.max.is_some()
}

/// A target outside the configured travel (W0621), X under diameter programming as a diameter.
#[inline]
pub(super) fn check_travel(site: &mut Site<'_>, state: &State, travel: &Travel) {
    if has_limits(&travel.definition) {
        check_limits(site, state, travel);
    }
}

fn check_limits(site: &mut Site<'_>, state: &State, travel: &Travel) {
    let axis = travel.definition;
    let (Some(after), Some(word)) = (travel.after.known(), travel.word) else { return };
    let diameter = axis.letter == AxisLetter::X && state.modal(GGroup::G10) == Some(GCode::G74);
    let value = if diameter { after.plus(after) } else { after };
    let (limit, above) = match (axis.min, axis.max) {
        (Some(min), _) if value < Micro::from(min) => (min, false),
        (_, Some(max)) if value > Micro::from(max) => (max, true),
        _ => return,
    };
    let (value, limit) = (value.to_string(), limit.to_string());
    let finding = Finding::OutsideTravel { axis: axis.letter.letter(), value, limit, above };
    site.report(with_origin(state, Diagnostic::new(finding, value_or_word(site.file, word)), word));
}
