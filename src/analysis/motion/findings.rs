//! What `check` says of motion (W0801 to W0803): one finding for each place in the text, with how often it happens.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use super::planner::{Listener, Planner};
use super::read::StepReader;
use super::times::{BlockTimes, Break, Dot, Joint, Limit, MotionTimes};
use super::{Model, trimmed};
use crate::config::{Profile, Settings};
use crate::diag::{Code, Diagnostic, Finding, Findings, JointBreak, JointLimit};
use crate::run::{End, Executed, Sink};
use crate::text::Location;

/// Looks for joints that break, are slow, or leave no room to stop. Without any of these asked for it does nothing.
#[derive(Debug)]
pub struct JointFindings {
    planning: Option<(StepReader, Planner)>,
    found: Found,
}

/// What was found so far.
#[derive(Debug)]
struct Found {
    model: Model,
    wants: [bool; 3],
    places: BTreeMap<(Location, Code), (Finding, u64)>,
}

impl JointFindings {
    /// For programs checked with these settings.
    pub fn new(settings: &Settings) -> Self {
        let on = |code| settings.severity(code).is_some();
        let model = Model::of(settings);
        let ramps = model.profile == Profile::Ramps && settings.machine.motion.configured;
        let wants = [on(Code::W0801), on(Code::W0802), on(Code::W0803) && ramps];
        let planning = wants.contains(&true).then(|| (StepReader::new(settings), Planner::new(model.clone(), false)));
        Self { planning, found: Found { model, wants, places: BTreeMap::new() } }
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
            if let Finding::ContinuityBroken { count, .. }
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
        let Some(joint) = &motion.joint else { return };
        let [broken, slow, room] = self.wants;
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
