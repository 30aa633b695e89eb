//! Findings of `check` about motion (W0629, W0801 to W0804): one for each place in the text, with how often it happens.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use super::planner::{Listener, Planner};
use super::read::StepReader;
use super::times::{BlockTimes, Break, Dot, Joint, Limit, MotionTimes};
use super::{Model, trimmed};
use crate::config::{Profile, Settings};
use crate::diag::{Code, Diagnostic, Finding, Findings, JointBreak, JointLimit};
use crate::dict::GCode;
use crate::run::{End, Executed, MotionType, Sink};
use crate::text::Location;

/// Tangents that differ by so many degrees lead back (W0629): an arc of the other direction joins them smoothly.
const TURNED_BACK_DEG: f64 = 179.0;

/// Looks for joints that break, are slow, or leave no room to stop, and for arcs and blocks that W0629 and W0804 mean.
/// Without any of these asked for it does nothing.
#[derive(Debug)]
pub struct JointFindings {
    planning: Option<(StepReader, Planner)>,
    found: Found,
}

/// What was found so far.
#[derive(Debug)]
struct Found {
    model: Model,
    wants: Wants,
    least_tight_ms: u32,
    /// An arc before which the path turned back.
    turned: Option<(Location, GCode)>,
    places: BTreeMap<(Location, Code), (Finding, u64)>,
}

/// The findings that are asked for.
#[derive(Clone, Copy, Debug)]
struct Wants {
    turned: bool,
    broken: bool,
    slow: bool,
    room: bool,
    tight: bool,
}

impl JointFindings {
    /// For programs checked with these settings.
    pub fn new(settings: &Settings) -> Self {
        let on = |code| settings.severity(code).is_some();
        let model = Model::of(settings);
        let ramps = model.profile == Profile::Ramps && settings.machine.motion.configured;
        let wants = Wants {
            turned: on(Code::W0629),
            broken: on(Code::W0801),
            slow: on(Code::W0802),
            room: on(Code::W0803) && ramps,
            tight: on(Code::W0804),
        };
        let Wants { turned, broken, slow, room, tight } = wants;
        let any = turned || broken || slow || room || tight;
        let planning = any.then(|| (StepReader::new(settings), Planner::new(model.clone(), false)));
        let least_tight_ms = settings.machine.dialect.shortest_tight_block_ms();
        Self { planning, found: Found { model, wants, least_tight_ms, turned: None, places: BTreeMap::new() } }
    }

    /// Whether anything is asked for.
    pub const fn is_wanted(&self) -> bool {
        self.planning.is_some()
    }
}

impl Sink for JointFindings {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        if let Some((reader, planner)) = &mut self.planning {
            planner.push(&reader.read(block), &mut self.found);
        }
        ControlFlow::Continue(())
    }

    fn end(mut self, _: End, findings: &mut Findings) {
        if let Some((_, planner)) = &mut self.planning {
            planner.finish(&mut self.found);
        }
        for ((place, _), (mut finding, times)) in self.found.places {
            if let Finding::ArcTurnsBack { count, .. }
            | Finding::ContinuityBroken { count, .. }
            | Finding::TightBlockTooShort { count, .. }
            | Finding::SlowJoint { count, .. }
            | Finding::NoRoomToStop { count, .. } = &mut finding
            {
                *count = times;
            }
            findings.add(Diagnostic::new(finding, place));
        }
    }
}

impl Listener for Found {
    fn block(&mut self, block: &BlockTimes) {
        let Some(motion) = &block.motion else { return };
        let Wants { turned, broken, slow, room, tight } = self.wants;
        if tight
            && motion.tight
            && let Some(seconds) = motion.motion_s.filter(|seconds| *seconds * 1000.0 < f64::from(self.least_tight_ms))
        {
            let duration = trimmed(seconds * 1000.0, 3);
            let finding = Finding::TightBlockTooShort { n: block.n, duration, least: self.least_tight_ms, count: 1 };
            self.note(block.place, Code::W0804, finding);
        }
        let Some(joint) = &motion.joint else { return };
        if turned {
            self.look_for_turns(block.place, motion.kind, joint);
        }
        if broken
            && joint.within_g23
            && let Some(reason) = self.reason(joint)
        {
            let finding = Finding::ContinuityBroken { n: block.n, with: joint.with_n.unwrap_or(0), reason, count: 1 };
            self.note(block.place, Code::W0801, finding);
        }
        if slow
            && joint.dot == Some(Dot::Red)
            && let Some(limit) = joint.limited_by
        {
            let finding = Finding::SlowJoint {
                n: block.n,
                with: joint.with_n.unwrap_or(0),
                feed: trimmed(joint.velocity * 60.0, 1),
                programmed: trimmed(motion.programmed.unwrap_or(0.0) * 60.0, 1),
                limit: limit_words(limit),
                count: 1,
            };
            self.note(block.place, Code::W0802, finding);
        }
        if room && joint.no_room_to_stop {
            let finding = self.no_room(block, motion, joint);
            self.note(block.place, Code::W0803, finding);
        }
    }
}

impl Found {
    fn note(&mut self, place: Location, code: Code, finding: Finding) {
        self.places.entry((place, code)).or_insert((finding, 0)).1 += 1;
    }

    /// Notes an arc that both neighbours lead back from (W0629).
    fn look_for_turns(&mut self, place: Location, kind: MotionType, joint: &Joint) {
        let turns = joint.angle_deg.is_some_and(|angle| angle >= TURNED_BACK_DEG);
        if let Some((arc, function)) = self.turned.take().filter(|_| turns) {
            let meant = if function == GCode::G02 { GCode::G03 } else { GCode::G02 };
            self.note(arc, Code::W0629, Finding::ArcTurnsBack { function, meant, count: 1 });
        }
        let function = match kind {
            MotionType::ArcCw => Some(GCode::G02),
            MotionType::ArcCcw => Some(GCode::G03),
            MotionType::Rapid | MotionType::Linear | MotionType::Thread | MotionType::Reference => None,
        };
        self.turned = function.filter(|_| turns).map(|function| (place, function));
    }

    fn reason(&self, joint: &Joint) -> Option<JointBreak> {
        Some(match joint.broken_by? {
            Break::Angle => {
                JointBreak::Angle { angle: trimmed(joint.angle_deg?, 3), allowed: trimmed(self.model.angle_deg, 3) }
            }
            Break::ShortLength => JointBreak::ShortLength { limit: trimmed(self.model.break_mm, 3) },
            Break::ShortTime => JointBreak::ShortTime { limit: trimmed(self.model.shortest_s * 1000.0, 3) },
            Break::MFunction => JointBreak::MFunction,
            Break::NoMotion => JointBreak::NoMotion,
            Break::Dwell => JointBreak::Dwell,
            Break::Start
            | Break::Mode
            | Break::Rapid
            | Break::OtherMotion
            | Break::Stop
            | Break::Unknown
            | Break::Axes => return None,
        })
    }

    fn no_room(&self, block: &BlockTimes, motion: &MotionTimes, joint: &Joint) -> Finding {
        let feed = joint.feed_cap;
        Finding::NoRoomToStop {
            n: block.n,
            length: trimmed(motion.length.unwrap_or(0.0), 3),
            feed: trimmed(feed * 60.0, 1),
            needs: trimmed(feed * feed / (2.0 * motion.accel), 3),
            count: 1,
        }
    }
}

/// What limits a joint, in words.
pub(super) const fn limit_words(limit: Limit) -> JointLimit {
    match limit {
        Limit::Feed => JointLimit::Feed,
        Limit::Centripetal => JointLimit::Centripetal,
        Limit::ShortestBlock => JointLimit::ShortestBlock,
        Limit::Accuracy => JointLimit::Accuracy,
        Limit::Overload => JointLimit::Overload,
        Limit::LookAhead => JointLimit::LookAhead,
        Limit::Ramp => JointLimit::Ramp,
    }
}
