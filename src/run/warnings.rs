//! Warnings of motions, tool changes and corrections (TEC-1…TEC-9), and of the travel of the axes (W0621).

use super::block::{Block, Effect, InForce};
use super::parameters::with_origin;
use super::site::Site;
use super::state::{Held, Position, Retracted, SpindleWords, State};
use super::travel::Travel;
use super::words::BlockWords;
use crate::config::Axis;
use crate::diag::{Diagnostic, Finding, LabelText, OtherMeaning};
use crate::dict::{
    Address, AxisLetter, Decimal, FeedMode, FeedPer, GCode, GGroup, Micro, ORIENTED_STOP, PROGRAM_ENDS, SPINDLE_GROUP,
    SPINDLE_STOP, SPINDLE_TURNS, TOOL_CHANGE,
};
use crate::resolve::value_or_word;

/// Reports what a working motion, or a thread, lacks: a feed (W0601), a feed of this unit (W0615), a speed (W0604), a
/// spindle that turns (W0619).
pub(super) fn check_motion(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce, thread: bool) {
    if state.feed == Held::None && !state.said.feed {
        state.said.feed = true;
        site.found(Finding::MissingFeed { thread }, words.place_of_motion(site));
    }
    if !thread {
        check_feed_unit(site, state, words, g);
    }
    if let Some((m, zero)) = lacks_speed(site, state, g).filter(|_| !thread) {
        state.said.speed_zero = true;
        site.found(Finding::SpindleSpeedZero { m, zero }, words.place_of_motion(site));
    }
    if let Some(function) = speed_reader(site, g)
        && state.speed == Held::None
        && !state.said.speed
    {
        state.said.speed = true;
        site.found(Finding::MissingSpindleSpeed { function, thread }, words.place_of_motion(site));
    }
    if lacks_spindle(site, state, thread) {
        state.said.spindle_stopped = true;
        site.found(Finding::SpindleStopped { thread }, words.place_of_motion(site));
    }
    match state.retracted {
        Retracted::No => state.works_by_g53 |= g.of(GGroup::G5) == Some(GCode::G53),
        Retracted::ByG53 if words.written(GGroup::G5).is_none() => {
            state.retracted = Retracted::Said;
            let meant = OtherMeaning::ModalOrigin;
            site.found(Finding::OtherMeaning { meant, count: None }, words.place_of_motion(site));
        }
        Retracted::ByG53 | Retracted::Said => {}
    }
}

/// Notes a G53 that is written for one block, as on other controls (W0116).
pub(super) fn note_retraction(site: &Site<'_>, state: &mut State, words: &BlockWords) {
    if let Some((origin, _)) = words.written(GGroup::G5) {
        let work = state.modal(GGroup::G5).is_some_and(|before| before != GCode::G53);
        let mut axes = words.axis_words().filter_map(|(axis, _)| site.machine().axes.get(axis));
        let only_z = axes.next().is_some_and(|axis| axis.letter == AxisLetter::Z) && axes.next().is_none();
        let writes = words.data().is_some();
        state.works_by_g53 |= writes && origin == GCode::G53;
        let retracts = origin == GCode::G53 && work && only_z && !writes && !state.works_by_g53;
        state.retracted = if retracts { Retracted::ByG53 } else { Retracted::No };
    }
}

/// Whether [`check_motion`] may have something to say.
pub(super) fn may_lack(site: &Site<'_>, state: &mut State, g: &InForce, thread: bool) -> bool {
    let feed = (state.feed == Held::None && !state.said.feed)
        || (!thread && (differing_unit(site, state, g).is_some() || lacks_speed(site, state, g).is_some()));
    let speed = state.speed == Held::None && !state.said.speed && speed_reader(site, g).is_some();
    let origin = match state.retracted {
        Retracted::No => !state.works_by_g53 && g.of(GGroup::G5) == Some(GCode::G53),
        Retracted::ByG53 => true,
        Retracted::Said => false,
    };
    origin || feed || speed || lacks_spindle(site, state, thread)
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
    if let Some(place) = state.origins.feed {
        let written = match written {
            FeedPer::Minute => LabelText::FeedPerMinute,
            FeedPer::Revolution => LabelText::FeedPerRevolution,
        };
        diagnostic = diagnostic.with_label(place, written);
    }
    site.report(diagnostic);
}

/// Whether the spindle is stopped where it should turn, and there was no finding yet (TEC-7).
fn lacks_spindle(site: &Site<'_>, state: &mut State, thread: bool) -> bool {
    state.m(SPINDLE_GROUP) == Some(SPINDLE_STOP)
        && !state.said.spindle_stopped
        && (thread || spindle_words(site, state).any)
}

/// The function that turns the spindle while S is 0 or, `false`, while no S was executed in a program that writes one,
/// when nobody said so yet (TEC-8). A motion that needs S in any case has W0604.
fn lacks_speed(site: &Site<'_>, state: &mut State, g: &InForce) -> Option<(u8, bool)> {
    let m = state.m(SPINDLE_GROUP).filter(|m| SPINDLE_TURNS.contains(m) && !state.said.speed_zero)?;
    let zero = state.speed == Held::Value(Decimal::ZERO);
    let none = state.speed == Held::None;
    let lacks = zero || none && speed_reader(site, g).is_none() && spindle_words(site, state).speed;
    lacks.then_some((m, zero))
}

/// The words of the spindle in the program's file and the macrocycles that written calls lead to. A program without
/// such words leaves the spindle to others.
fn spindle_words(site: &Site<'_>, state: &mut State) -> SpindleWords {
    *state.spindle_words.get_or_insert_with(|| {
        let mut found = SpindleWords::default();
        let spindle =
            |m: i64| SPINDLE_TURNS.into_iter().chain([SPINDLE_STOP, ORIENTED_STOP]).any(|own| i64::from(own) == m);
        for file in site.resolved.written_files() {
            for word in file.block_ids().flat_map(|block| file.words(block)) {
                found.speed |= word.address == Address::S;
                found.any |= found.speed
                    || word.address == Address::M && word.number().and_then(Decimal::as_whole).is_some_and(spindle);
                if found.speed {
                    return found;
                }
            }
        }
        found
    })
}

/// G41 or G42 with no D in force (W0618), M06 with no T (W0620), and what is in force where tool or program end (W0625,
/// W0627).
pub(super) fn check_tool(site: &mut Site<'_>, state: &mut State, words: &BlockWords, g: &InForce) {
    let written = words.written(GGroup::G3).filter(|(code, _)| *code != GCode::G40);
    if let Some((function, word)) = written
        && state.d == Held::None
        && !state.said.no_entry
    {
        state.said.no_entry = true;
        site.found(Finding::CorrectionWithoutEntry { function }, site.word_place(word));
    }
    let corrects = g.of(GGroup::G3).filter(|code| *code != GCode::G40);
    let cycle = g.of(GGroup::G8).filter(|code| code.is_cycle());
    if let Some(t) = words.t {
        state.named_tool = t.value.map(|value| (value, site.word_place(t.word)));
    }
    for &(m, word) in &words.m {
        let at = site.word_place(word);
        if PROGRAM_ENDS.contains(&m)
            && let Some((t, place)) = state.named_tool.filter(|_| !site.resolved.is_cut_off())
        {
            site.found(Finding::ToolNotChanged { t: t.to_string() }, place);
        }
        let ends = (m == TOOL_CHANGE || PROGRAM_ENDS.contains(&m)) && !site.resolved.is_cut_off();
        if let Some(function) = corrects.filter(|_| ends) {
            site.found(Finding::CorrectionLeftOn { function, m }, at);
        }
        if m != TOOL_CHANGE {
            continue;
        }
        state.named_tool = None;
        if let Some(cycle) = cycle {
            site.found(Finding::CycleOverToolChange { cycle }, at);
        }
        if state.tool == Held::None && !state.said.no_tool {
            state.said.no_tool = true;
            site.found(Finding::ToolChangeWithoutTool {}, at);
        }
    }
}

/// A correction that changes on an arc (W0624): in its block, or as the first motion after it.
pub(super) fn check_correction(site: &mut Site<'_>, state: &mut State, block: &Block) {
    match &block.effect {
        Effect::Motion(moving) => {
            let function = state.corrects.take().filter(|_| moving.kind.is_arc());
            if let Some(function) = function {
                let finding = Finding::CorrectionOnArc { function, sides: false };
                site.found(finding, block.words.place_of_motion(site));
            }
        }
        // Nobody knows how it moves.
        Effect::None if block.words.axis_count > 0 => state.corrects = None,
        Effect::None | Effect::Data(_) => {}
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
