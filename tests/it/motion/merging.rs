//! CNT-4: short blocks that are joined before anything else.

use cnc872c::analysis::motion::{Break, Model, Planner, Profile, Step};
use proptest::prelude::*;

use super::build::{Planned, close, dynamics, idle, lines, model, plan};
use super::verify::verify;
use crate::properties::cases;

fn merging(length: f64) -> Model {
    Model { merge_mm: length, ..model(Profile::Linear) }
}

/// Lengths of pieces by the place of their record; `None` where a block is part of one.
fn pieces(planned: &Planned) -> Vec<Option<f64>> {
    let motions = planned.blocks.iter().filter_map(|block| block.motion.as_ref());
    motions.map(|motion| if motion.merged { None } else { motion.length }).collect()
}

fn of(lengths: &[f64], model: &Model) -> Planned {
    let vectors: Vec<[f64; 3]> = lengths.iter().map(|length| [*length, 0.0, 0.0]).collect();
    plan(model, &lines(&vectors, 3000.0, dynamics()))
}

fn about(found: &[Option<f64>], expected: &[Option<f64>]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for pair in found.iter().zip(expected) {
        match pair {
            (Some(found), Some(expected)) => close(*found, *expected, 1e-9),
            (None, None) => {}
            (Some(_), None) | (None, Some(_)) => panic!("{found:?} is not {expected:?}"),
        }
    }
}

/// Small blocks are taken in until the piece is long enough, or a block that is not small ends it.
#[test]
fn pieces_from_left_to_right() {
    let model = merging(1.0);
    about(&pieces(&of(&[5.0, 0.4, 0.4, 0.4, 5.0], &model)), &[Some(5.0), None, None, Some(1.2), Some(5.0)]);
    about(&pieces(&of(&[5.0, 0.4, 5.0, 3.0], &model)), &[Some(5.0), None, Some(5.4), Some(3.0)]);
    // Nothing follows: it is added to the one before, whose record stays where it is.
    about(&pieces(&of(&[5.0, 0.4], &model)), &[Some(5.4), None]);
    // Nothing is before either.
    about(&pieces(&of(&[0.4], &model)), &[Some(0.4)]);
    about(&pieces(&of(&[0.4, 0.4], &model)), &[None, Some(0.8)]);
    // A block as long as the limit is not small.
    about(&pieces(&of(&[5.0, 1.0, 5.0], &model)), &[Some(5.0), Some(1.0), Some(5.0)]);
}

/// A merged block has no times, joint or phases; pieces are straight between their ends.
#[test]
fn records_of_pieces() {
    let vectors = [[5.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.4, 0.0], [5.0, 0.0, 0.0]];
    let planned = plan(&merging(0.5), &lines(&vectors, 3000.0, dynamics()));
    about(&pieces(&planned), &[Some(5.0), None, Some(0.5), Some(5.0)]);
    let motion = |at: usize| planned.blocks[at].motion.as_ref().unwrap();
    let merged = motion(1);
    assert!(merged.joint.is_none() && merged.velocities.is_none() && merged.motion_s.is_none());
    assert!(merged.phases.is_empty() && merged.cap.is_none() && planned.blocks[1].duration_s == 0.0);
    let piece = motion(2);
    assert!(piece.is_piece);
    close(piece.joint.unwrap().angle_deg.unwrap(), 53.130_102_354_155_98, 1e-9);
    assert_eq!(piece.joint.unwrap().with, Some(0));
    close(motion(3).joint.unwrap().angle_deg.unwrap(), 53.130_102_354_155_98, 1e-9);
    assert_eq!(motion(3).joint.unwrap().with, Some(2));
}

/// Words, blocks without motion and broken joints keep blocks apart.
#[test]
fn what_is_not_joined() {
    let model = merging(1.0);
    let short = |count: usize| lines(&vec![[0.4, 0.0, 0.0]; count], 3000.0, dynamics());
    let with = |change: &dyn Fn(&mut Vec<Step>)| {
        let mut steps = short(4);
        change(&mut steps);
        pieces(&plan(&model, &steps))
    };
    about(&with(&|_| {}), &[None, None, Some(1.2 + 0.4), None]);
    // The block with another word is not small: it ends the piece.
    about(&with(&|steps| steps[1].plain = false), &[None, Some(0.8 + 0.8), None, None]);
    let mut steps = short(2);
    steps.push(idle(2));
    steps.extend(short(2).into_iter().map(|step| Step { seq: step.seq + 3, ..step }));
    let planned = plan(&model, &steps);
    about(&pieces(&planned), &[None, Some(0.8), None, Some(0.8)]);
    let joint = planned.blocks[4].motion.as_ref().unwrap().joint.unwrap();
    assert_eq!((joint.with, joint.broken_by), (Some(1), Some(Break::NoMotion)));
}

/// Out and back to where it began: no piece of length 0.
#[test]
fn out_and_back() {
    let vectors = [[5.0, 0.0, 0.0], [0.2, 0.0, 0.0], [-0.2, 0.0, 0.0]];
    let planned = plan(&merging(0.5), &lines(&vectors, 3000.0, dynamics()));
    assert!(pieces(&planned).iter().flatten().all(|length| *length > 0.0), "{:?}", pieces(&planned));
}

/// To and fro for ever: no more blocks than the control sees become one piece, and blocks come out while others go in.
#[test]
fn to_and_fro_without_end() {
    let there_and_back = [[0.2, 0.0, 0.0], [-0.2, 0.0, 0.0]];
    for before in [None, Some([5.0, 0.0, 0.0])] {
        let vectors: Vec<_> = before.into_iter().chain(there_and_back.into_iter().cycle().take(20_001)).collect();
        let mut planner = Planner::new(merging(0.5), false);
        let mut planned = Planned::default();
        let mut waiting = 0;
        for (pushed, step) in (1..).zip(lines(&vectors, 3000.0, dynamics())) {
            planner.push(&step, &mut planned);
            waiting = waiting.max(pushed - planned.blocks.len());
        }
        assert!(waiting <= 5000, "{waiting}");
        planner.finish(&mut planned);
        assert_eq!(planned.blocks.len(), vectors.len());
    }
}

/// PLC-15, CNT-5: blocks that are joined lie in the stretch of their piece. Those before its record are at its start,
/// those behind it at its end.
#[test]
fn what_is_joined_lies_in_the_stretch() {
    for lengths in [&[5.0, 0.4, 0.4, 0.4, 5.0, 0.3][..], &[0.4, 0.4], &[5.0, 0.4], &[0.4, 5.0, 0.2, 0.2]] {
        in_one_stretch(&of(lengths, &merging(1.0)));
    }
}

/// Every block of a continuous line is in its only stretch, at the time at which it starts.
fn in_one_stretch(planned: &Planned) {
    for block in &planned.blocks {
        let motion = block.motion.as_ref().unwrap();
        assert_eq!((motion.stretch.is_none(), motion.joined_in.is_some()), (motion.merged, motion.merged));
        let stretch = motion.stretch.or(motion.joined_in).unwrap();
        assert_eq!((stretch.index, stretch.continued), (0, planned.blocks.len() > 1));
        close(stretch.before_s, block.start_s, 1e-9);
    }
}

proptest! {
    #![proptest_config(cases(300))]

    /// The same of any lengths.
    #[test]
    fn any_lengths_are_one_stretch(lengths in prop::collection::vec(0.05..2.5_f64, 1..60), parabolic in any::<bool>()) {
        let profile = if parabolic { Profile::Parabolic } else { Profile::Linear };
        in_one_stretch(&of(&lengths, &Model { merge_mm: 1.0, ..model(profile) }));
    }
}

/// A straight line in tiny blocks takes as long as the line.
#[test]
fn straight_lines() {
    for profile in [Profile::Linear, Profile::Parabolic] {
        for count in [10_u32, 100, 1000] {
            let model = Model { merge_mm: 0.7, ..model(profile) };
            let vectors = vec![[100.0 / f64::from(count), 0.0, 0.0]; count as usize];
            let steps = lines(&vectors, 5000.0, dynamics());
            let planned = plan(&model, &steps);
            let whole = plan(&model, &lines(&[[100.0, 0.0, 0.0]], 5000.0, dynamics()));
            close(planned.time(), whole.time(), 1e-6);
            if count == 10 {
                verify(&model, &steps, &planned.blocks);
            }
        }
    }
}
