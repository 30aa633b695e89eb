//! The planner: executed blocks go in, in their order; their times come out in the same order, some blocks later. Its
//! memory does not depend on the length of the program.

use std::collections::VecDeque;

use super::curve;
use super::envelope::{self, Envelope, Linked, trapezoid};
use super::joint::{BlockCaps, JointCaps, Piece, angle_deg, early_break, half_tan, late_break};
use super::merge::{Merged, Merger};
use super::model::Model;
use super::parabola::{Curved, Parabola};
use super::ramp::{Hump, Limits};
use super::step::{Dynamics, Mode, Step};
use super::times::{BlockTimes, Dot, InStretch, Joint, Limit, MotionTimes, Phase, Untimed, Velocities};
use crate::config::Profile;
use crate::run::MotionType;

/// Who gets what is planned.
pub trait Listener {
    /// The next block in the order of execution.
    fn block(&mut self, block: &BlockTimes);
    /// Stretch number `index` takes so many seconds of motion; called when its last block is planned.
    fn stretch(&mut self, index: u64, motion_s: f64) {
        let _ = (index, motion_s);
    }
    /// Receives the time of a block's motion without limited jerk and time criterion, in order of the motions.
    fn no_jerk(&mut self, motion_s: f64) {
        let _ = motion_s;
    }
}

/// A block that waits for its times.
#[derive(Clone, Debug)]
struct Waiting {
    times: BlockTimes,
    ready: bool,
    /// The slot of the piece that it is joined to (CNT-4).
    joined_to: Option<u64>,
}

/// A piece in a stretch that is not planned yet.
#[derive(Clone, Debug)]
struct Linking {
    piece: Piece,
    caps: BlockCaps,
    /// Caps of the joint before it; none at the start of the stretch.
    joint: Option<JointCaps>,
}

/// Plans a program.
#[derive(Clone, Debug)]
pub struct Planner {
    model: Model,
    wants_phases: bool,
    /// Tangent of half the tolerance angle.
    allowed: f64,
    /// Blocks in their order, from block `taken - waiting.len()` on.
    waiting: VecDeque<Waiting>,
    taken: u64,
    clock: f64,
    merger: Merger,
    /// The motion block before, as it is written.
    before: Option<Piece>,
    /// Whether blocks without motion were executed since.
    idle: bool,
    /// A piece that may begin a stretch.
    first: Option<Piece>,
    /// Pieces of the current stretch that are not planned yet.
    stretch: VecDeque<Linking>,
    /// Whether a stretch of several pieces is open.
    open: bool,
    /// The last piece of the current stretch, for the joint behind it.
    last: Option<(Piece, BlockCaps)>,
    stretches: u64,
    stretch_s: f64,
    envelope: Envelope,
    parabola: Option<Parabola>,
    settled: VecDeque<Settled>,
}

/// A planned piece of a stretch.
#[derive(Clone, Debug)]
struct Settled {
    time_s: f64,
    velocities: Velocities,
    seen: f64,
    phases: Vec<Phase>,
}

impl Planner {
    /// For that machine; with the phases of each motion when they are asked for.
    pub fn new(model: Model, wants_phases: bool) -> Self {
        let look_ahead = if model.profile == Profile::Ramps { 1 } else { model.look_ahead };
        let parabola =
            (model.profile == Profile::Parabolic).then(|| Parabola::new(look_ahead, model.raise_s, wants_phases));
        Self {
            allowed: libm::tan((model.angle_deg / 2.0).to_radians()),
            merger: Merger::new(model.merge_mm),
            envelope: Envelope::new(look_ahead),
            parabola,
            wants_phases,
            waiting: VecDeque::new(),
            taken: 0,
            clock: 0.0,
            before: None,
            idle: false,
            first: None,
            stretch: VecDeque::new(),
            open: false,
            last: None,
            stretches: 0,
            stretch_s: 0.0,
            settled: VecDeque::new(),
            model,
        }
    }

    /// The machine.
    pub const fn model(&self) -> &Model {
        &self.model
    }

    /// The next executed block.
    pub fn push(&mut self, step: &Step, listener: &mut impl Listener) {
        let slot = self.taken;
        self.taken += 1;
        let gap_s = if step.mode == Mode::Basic { self.model.gap_s } else { 0.0 };
        let moves = step.motion.filter(|motion| motion.length != Some(0.0));
        let times = BlockTimes {
            seq: step.seq,
            n: step.n,
            file: step.file,
            line: step.line,
            place: step.place,
            start_s: 0.0,
            duration_s: 0.0,
            dwell_s: step.dwell_s.unwrap_or(0.0),
            function_s: step.function_s,
            settle_s: 0.0,
            gap_s,
            unknown: step.opaque,
            approach: step.approach,
            tool: step.tool,
            untimed: [
                step.untimed_change,
                step.untimed_function,
                false,
                step.mode == Mode::Basic && !self.model.gap_given,
            ],
            lacks_cycle: self.model.lacks_cycle,
            motion: None,
        };
        self.waiting.push_back(Waiting { times, ready: moves.is_none(), joined_to: None });
        match moves {
            None => {
                self.idle = true;
                self.flush(listener);
            }
            Some(motion) => {
                let mut piece = Piece {
                    slot,
                    seq: step.seq,
                    n: step.n,
                    kind: motion.kind,
                    unit: motion.unit,
                    mode: step.mode,
                    end_mode: step.mode,
                    length: motion.length,
                    from: motion.from,
                    to: motion.to,
                    vector: motion.vector,
                    programmed: motion.programmed,
                    radius: motion.radius,
                    dynamics: motion.dynamics,
                    dwells: step.dwell_s.is_some(),
                    stops: step.stops,
                    breaks_before: step.breaks_before,
                    breaks_after: step.breaks_after,
                    plain: step.plain,
                    is_piece: false,
                    with: None,
                    broken: None,
                    half_tan: None,
                };
                piece.broken = early_break(&self.model, self.before.as_ref(), self.idle, &piece);
                self.idle = step.opaque;
                self.before = Some(piece.clone());
                self.merge(Some(piece), listener);
            }
        }
        self.give(listener);
    }

    /// The program is over: everything comes out.
    pub fn finish(&mut self, listener: &mut impl Listener) {
        self.flush(listener);
        self.give(listener);
    }

    /// Nothing after this joins what was before.
    fn flush(&mut self, listener: &mut impl Listener) {
        self.merge(None, listener);
        self.end_stretch(listener);
    }

    fn merge(&mut self, piece: Option<Piece>, listener: &mut impl Listener) {
        if self.model.merge_mm <= 0.0 {
            if let Some(piece) = piece {
                self.join(piece, listener);
            }
            return;
        }
        let mut out = Vec::new();
        match piece {
            Some(piece) => self.merger.push(piece, &mut |merged| out.push(merged)),
            None => self.merger.flush(&mut |merged| out.push(merged)),
        }
        for merged in out {
            match merged {
                Merged::Piece(piece) => self.join(*piece, listener),
                Merged::Joined { slot, of } => self.mark_joined(slot, of),
            }
        }
    }

    fn waiting_at(&mut self, slot: u64) -> Option<&mut Waiting> {
        let first = self.taken - self.waiting.len() as u64;
        self.waiting.get_mut(usize::try_from(slot.checked_sub(first)?).ok()?)
    }

    fn mark_joined(&mut self, slot: u64, of: u64) {
        if let Some(waiting) = self.waiting_at(slot) {
            waiting.joined_to = Some(of);
            waiting.times.motion = Some(MotionTimes {
                kind: MotionType::Linear,
                unit: super::step::Unit::Mm,
                length: None,
                motion_s: None,
                programmed: None,
                cap: None,
                velocities: None,
                accel: 0.0,
                jerk_free: false,
                merged: true,
                tight: false,
                is_piece: false,
                joint: None,
                stretch: None,
                joined_in: None,
                phases: Vec::new(),
            });
        }
    }

    /// A piece is complete, and with it the blocks that are joined to it, before it or behind: they take no
    /// time of their own, and lie in its stretch. `time_s` is what the piece takes.
    fn complete_joined_to(&mut self, piece: &Piece, stretch: Option<InStretch>, time_s: f64) {
        if !piece.is_piece {
            return;
        }
        let of = piece.slot;
        let mut complete = |slot: u64, after_s: f64| {
            let joined = self.waiting_at(slot).filter(|waiting| waiting.joined_to == Some(of));
            let Some(waiting) = joined else { return false };
            waiting.ready = true;
            if let Some(motion) = &mut waiting.times.motion {
                motion.joined_in = stretch.map(|stretch| InStretch { before_s: stretch.before_s + after_s, ..stretch });
            }
            true
        };
        let mut slot = of;
        while slot > 0 && complete(slot - 1, 0.0) {
            slot -= 1;
        }
        slot = of;
        while complete(slot + 1, time_s) {
            slot += 1;
        }
    }

    /// Takes the next piece: it continues the current stretch, or begins another.
    fn join(&mut self, mut piece: Piece, listener: &mut impl Listener) {
        let earlier = self.last.as_ref().map(|(last, _)| last);
        if let Some(earlier) = earlier {
            piece.with = Some(earlier.as_with());
            piece.half_tan = half_tan(earlier.to, piece.from);
            if piece.broken.is_none() {
                piece.broken = late_break(&self.model, self.allowed, earlier, &piece);
            }
        }
        if piece.broken.is_some() {
            self.end_stretch(listener);
            let caps = BlockCaps::of(&self.model, &piece, false);
            self.last = Some((piece.clone(), caps));
            self.first = Some(piece);
            return;
        }
        if let Some(first) = self.first.take() {
            self.open = true;
            let caps = BlockCaps::of(&self.model, &first, true);
            self.last = Some((first.clone(), caps));
            self.link(first, caps, None, listener);
        }
        let caps = BlockCaps::of(&self.model, &piece, true);
        let joint =
            self.last.as_ref().map(|(last, last_caps)| JointCaps::of(&self.model, (last, last_caps), (&piece, &caps)));
        self.last = Some((piece.clone(), caps));
        self.link(piece, caps, joint, listener);
    }

    /// Adds a piece to the current stretch.
    fn link(&mut self, piece: Piece, caps: BlockCaps, joint: Option<JointCaps>, listener: &mut impl Listener) {
        let (length, cap) = (piece.length.unwrap_or(0.0), caps.least());
        let joint_cap = joint.as_ref().map_or(0.0, JointCaps::least);
        let Dynamics { accel, jerk, .. } = piece.dynamics;
        self.stretch.push_back(Linking { piece, caps, joint });
        let linear = envelope::Link { length, cap, joint: joint_cap, accel };
        let (model, settled) = (&self.model, &mut self.settled);
        match &mut self.parabola {
            None => {
                let wants = self.wants_phases;
                self.envelope.push(linear, |link, linked| settled.push_back(straight(model, link, linked, wants)));
            }
            Some(parabola) => {
                let link = curve::Link { length, cap, joint: joint_cap, limits: Limits { accel, jerk } };
                parabola.push(link, |_, curved| settled.push_back(curved.into()));
                self.envelope.push(linear, |link, linked| listener.no_jerk(without_jerk(link, linked)));
            }
        }
        self.settle(listener);
    }

    /// Ends the current stretch, or a single piece.
    fn end_stretch(&mut self, listener: &mut impl Listener) {
        if self.open {
            self.close(listener);
        } else if let Some(piece) = self.first.take() {
            if !piece.is_timed() {
                self.complete_unknown(piece);
            } else if piece.end_mode == Mode::Continuous && piece.kind.is_working() {
                self.open = true;
                let caps = BlockCaps::of(&self.model, &piece, true);
                self.link(piece, caps, None, listener);
                self.close(listener);
            } else {
                self.alone(piece, listener);
            }
        }
    }

    fn close(&mut self, listener: &mut impl Listener) {
        let (model, settled) = (&self.model, &mut self.settled);
        match &mut self.parabola {
            None => {
                let wants = self.wants_phases;
                self.envelope.close(|link, linked| settled.push_back(straight(model, link, linked, wants)));
            }
            Some(parabola) => {
                parabola.close(|_, curved| settled.push_back(curved.into()));
                self.envelope.close(|link, linked| listener.no_jerk(without_jerk(link, linked)));
            }
        }
        self.open = false;
        self.settle(listener);
        listener.stretch(self.stretches, self.stretch_s);
        self.stretches += 1;
        self.stretch_s = 0.0;
    }

    /// Gives the settled pieces of the current stretch their times.
    fn settle(&mut self, listener: &mut impl Listener) {
        while let Some(settled) = self.settled.pop_front() {
            let Some(linking) = self.stretch.pop_front() else { break };
            let last = !self.open && self.stretch.is_empty();
            let alone = last && linking.joint.is_none() && !linking.piece.is_piece;
            let before = self.stretch_s;
            self.stretch_s += settled.time_s;
            let stretch =
                Some(InStretch { index: self.stretches, before_s: before, continued: !alone, time_dist_s: None });
            self.complete(linking.piece, linking.caps, linking.joint, settled, stretch, last);
        }
        self.give(listener);
    }

    /// A motion outside of stretches: it begins and ends with a ramp (CNT-1).
    fn alone(&mut self, piece: Piece, listener: &mut impl Listener) {
        let caps = BlockCaps::of(&self.model, &piece, false);
        let (length, cap) = (piece.length.unwrap_or(0.0), caps.least());
        let settled = if self.parabola.is_some() {
            let Dynamics { accel, jerk, .. } = piece.dynamics;
            let limits = Limits { accel, jerk };
            let hump = Hump::new(0.0, 0.0, limits, length, cap);
            listener.no_jerk(trapezoid(length, 0.0, 0.0, cap, accel, true).0);
            let time_s = hump.phases().iter().map(|phase| phase.duration_s).sum();
            let phases =
                if self.wants_phases { hump.phases().into_iter().filter(Phase::lasts).collect() } else { Vec::new() };
            let velocities = Velocities { start: 0.0, peak: hump.peak, end: 0.0 };
            Settled { time_s, velocities, seen: f64::INFINITY, phases }
        } else {
            let accel = self.accel_alone(&piece);
            let link = envelope::Link { length, cap, joint: 0.0, accel };
            let linked = Linked { start: 0.0, end: 0.0, seen: f64::INFINITY };
            let settled = straight_in(&link, linked, true, self.wants_phases);
            listener.no_jerk(settled.time_s);
            settled
        };
        self.complete(piece, caps, None, settled, None, true);
    }

    /// The acceleration of a motion outside of stretches (VEL-8).
    fn accel_alone(&self, piece: &Piece) -> f64 {
        match piece.kind {
            _ if self.parabola.is_some() => piece.dynamics.accel,
            MotionType::Rapid => self.model.accel_rapid,
            MotionType::Linear
            | MotionType::ArcCw
            | MotionType::ArcCcw
            | MotionType::Thread
            | MotionType::Reference => self.model.accel,
        }
    }

    fn complete_unknown(&mut self, piece: Piece) {
        let joint = self.joint(&piece, None, 0.0, f64::INFINITY, false);
        let settle_s = self.settle_time(piece.end_mode);
        self.complete_joined_to(&piece, None, 0.0);
        if let Some(waiting) = self.waiting_at(piece.slot) {
            waiting.ready = true;
            waiting.times.unknown = true;
            waiting.times.settle_s = settle_s;
            waiting.times.motion = Some(MotionTimes {
                kind: piece.kind,
                unit: piece.unit,
                length: piece.length,
                motion_s: None,
                programmed: piece.programmed,
                cap: None,
                velocities: None,
                accel: 0.0,
                jerk_free: false,
                merged: false,
                tight: piece.end_mode == Mode::Tight,
                is_piece: piece.is_piece,
                joint: Some(joint),
                stretch: None,
                joined_in: None,
                phases: Vec::new(),
            });
        }
    }

    fn settle_time(&self, mode: Mode) -> f64 {
        if matches!(mode, Mode::Continuous | Mode::Tight) { self.model.settle_s } else { 0.0 }
    }

    /// Whether there is such a wait that nobody gave.
    fn settles_unsaid(&self, mode: Mode) -> bool {
        matches!(mode, Mode::Continuous | Mode::Tight) && !self.model.settle_given
    }

    fn complete(
        &mut self,
        piece: Piece,
        caps: BlockCaps,
        joint_caps: Option<JointCaps>,
        settled: Settled,
        stretch: Option<InStretch>,
        ends: bool,
    ) {
        let Settled { time_s, velocities, seen, phases } = settled;
        let accel = if stretch.is_some() { piece.dynamics.accel } else { self.accel_alone(&piece) };
        let jerk_free = piece.dynamics.jerk_free;
        let joint = self.joint(&piece, joint_caps.as_ref(), velocities.start, seen, ends);
        let settle_s = if ends { self.settle_time(piece.end_mode) } else { 0.0 };
        let unsettled = ends && self.settles_unsaid(piece.end_mode);
        self.complete_joined_to(&piece, stretch, time_s);
        if let Some(waiting) = self.waiting_at(piece.slot) {
            waiting.ready = true;
            if let Some(untimed) = waiting.times.untimed.get_mut(Untimed::Settle as usize) {
                *untimed = unsettled;
            }
            waiting.times.settle_s = settle_s;
            waiting.times.motion = Some(MotionTimes {
                kind: piece.kind,
                unit: piece.unit,
                length: piece.length,
                motion_s: Some(time_s),
                programmed: piece.programmed,
                cap: Some((caps.least(), caps.by)),
                velocities: Some(velocities),
                accel,
                jerk_free,
                merged: false,
                tight: piece.end_mode == Mode::Tight,
                is_piece: piece.is_piece,
                joint: Some(joint),
                stretch,
                joined_in: None,
                phases,
            });
        }
    }

    /// The joint before a piece.
    fn joint(&self, piece: &Piece, caps: Option<&JointCaps>, velocity: f64, seen: f64, ends: bool) -> Joint {
        let limited_by: Option<Limit> = caps.map(|caps| caps.limit(velocity, seen));
        let with_in_g23 = piece.with.is_some_and(|with| with.in_g23);
        let has_dot = piece.with.is_some() && (with_in_g23 || piece.is_in_g23());
        let velocity = if piece.broken.is_some() { 0.0 } else { velocity };
        let red = match (piece.broken, self.model.profile) {
            (Some(_), _) => true,
            (None, Profile::Ramps) => false,
            (None, Profile::Linear | Profile::Parabolic) => {
                velocity < self.model.red * piece.programmed.unwrap_or(0.0) * (1.0 - 1e-12)
            }
        };
        let short = || {
            let (Some(caps), Some(length)) = (caps, piece.length) else { return false };
            let feed = caps.feed();
            feed * feed > 2.0 * piece.dynamics.accel * length * (1.0 + 1e-12)
        };
        Joint {
            with: piece.with.map(|with| with.seq),
            with_n: piece.with.map(|with| with.n),
            angle_deg: piece.half_tan.map(angle_deg),
            broken_by: piece.broken,
            velocity,
            limited_by,
            dot: has_dot.then_some(if red { Dot::Red } else { Dot::Yellow }),
            within_g23: piece.with.is_some_and(|with| with.ends_in_g23()) && piece.is_in_g23(),
            beside_rapid: piece.kind == MotionType::Rapid
                || piece.with.is_some_and(|with| with.kind == MotionType::Rapid),
            cost_s: if has_dot && red { self.cost(piece, velocity) } else { 0.0 },
            feed_cap: caps.map_or(0.0, JointCaps::feed),
            no_room_to_stop: self.model.profile == Profile::Ramps && ends && short(),
        }
    }

    /// What passing a joint at `velocity` costs about, against the programmed velocities: a ramp on either side, and
    /// the wait where it is broken.
    fn cost(&self, piece: &Piece, velocity: f64) -> f64 {
        let accel = if piece.broken.is_none() { piece.dynamics.accel } else { self.accel_alone(piece) };
        let jerk = if self.parabola.is_some() { piece.dynamics.jerk } else { f64::INFINITY };
        let limits = Limits { accel, jerk };
        let side = |length: Option<f64>, programmed: Option<f64>| match (length, programmed) {
            (Some(length), Some(programmed)) if programmed > velocity => {
                let top = limits.reach(velocity, length).min(programmed);
                limits.time(top - velocity) - limits.distance(velocity, top) / programmed
            }
            _ => 0.0,
        };
        let before = piece.with.map_or(0.0, |with| {
            let wait = if piece.broken.is_some() { self.settle_time(with.end_mode) } else { 0.0 };
            side(with.length, with.programmed) + wait
        });
        side(piece.length, piece.programmed) + before
    }

    /// Gives the blocks that have their times.
    fn give(&mut self, listener: &mut impl Listener) {
        while self.waiting.front().is_some_and(|waiting| waiting.ready) {
            let Some(Waiting { mut times, .. }) = self.waiting.pop_front() else { break };
            let motion_s = times.motion.as_ref().and_then(|motion| motion.motion_s).unwrap_or(0.0);
            times.start_s = self.clock;
            times.duration_s = motion_s + times.dwell_s + times.function_s + times.settle_s + times.gap_s;
            self.clock += times.duration_s;
            listener.block(&times);
        }
    }
}

impl From<Curved> for Settled {
    fn from(curved: Curved) -> Self {
        let Curved { velocities, time_s, seen, phases } = curved;
        Self { time_s, velocities, seen, phases }
    }
}

/// A motion of a stretch with constant accelerations.
fn straight(model: &Model, link: &envelope::Link, linked: Linked, wants_phases: bool) -> Settled {
    let highest = linked.start.max(linked.end);
    // VEL-9: without rising it would last less than the time criterion, or it is short. From rest to rest it rises.
    let rise = model.profile == Profile::Ramps
        || highest <= 0.0
        || (link.length >= model.raise_mm
            && trapezoid(link.length, linked.start, linked.end, highest, link.accel, false).0 >= model.raise_s);
    straight_in(link, linked, rise, wants_phases)
}

fn without_jerk(link: &envelope::Link, linked: Linked) -> f64 {
    trapezoid(link.length, linked.start, linked.end, link.cap, link.accel, true).0
}

fn straight_in(link: &envelope::Link, linked: Linked, rise: bool, wants_phases: bool) -> Settled {
    let Linked { start, end, seen } = linked;
    let (time_s, peak) = trapezoid(link.length, start, end, link.cap, link.accel, rise);
    let phases = if wants_phases { trapezoid_phases(link, start, end, peak) } else { Vec::new() };
    Settled { time_s, velocities: Velocities { start, peak, end }, seen, phases }
}

fn trapezoid_phases(link: &envelope::Link, start: f64, end: f64, peak: f64) -> Vec<Phase> {
    let accel = link.accel;
    let ramps = (2.0 * peak * peak - start * start - end * end) / (2.0 * accel);
    let hold = (link.length - ramps).max(0.0);
    let phase =
        |duration_s: f64, velocity: f64, acceleration: f64| Phase { duration_s, velocity, acceleration, jerk: 0.0 };
    [
        phase((peak - start) / accel, start, accel),
        phase(if hold > 0.0 { hold / peak } else { 0.0 }, peak, 0.0),
        phase((peak - end) / accel, peak, -accel),
    ]
    .into_iter()
    .filter(Phase::lasts)
    .collect()
}
