//! `cnc872c/dots`: the dots that the control draws at joints (DOT-1), for editors that show them.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use serde_json::{Value, json};

use super::analysis::Analysis;
use super::snapshot::{Answer, Snapshot};
use crate::analysis::motion::{BlockTimes, Dot, Listener, Model, Planner, StepReader};
use crate::diag::Findings;
use crate::query::cursor::DOCUMENT;
use crate::query::observe::MOST;
use crate::run::{End, Executed, Sink};

/// A program gives `[{ "line", "dot" }]`: lines from 0, the dot `yellow` or `red`. Where several joints are in a line,
/// or one is passed in several ways, a red one wins. Null for what is not executed.
pub(super) fn dots(snapshot: &Snapshot, analysis: &Analysis, _: Value) -> Answer<Option<Value>> {
    if !analysis.executable {
        return Ok(None);
    }
    let settings = &analysis.settings;
    let mut reader = Reader {
        snapshot,
        steps: StepReader::new(settings),
        planner: Planner::new(Model::of(settings), false),
        lines: Lines::default(),
    };
    analysis.observe(&mut reader);
    if snapshot.cancel.is_cancelled() {
        return Ok(None);
    }
    let Reader { mut planner, mut lines, .. } = reader;
    planner.finish(&mut lines);
    let dots = lines.0.into_iter().map(|(line, dot)| json!({ "line": line - 1, "dot": dot.name() }));
    Ok(Some(dots.collect()))
}

/// Dots by line, from 1.
#[derive(Default)]
struct Lines(BTreeMap<u32, Dot>);

impl Listener for Lines {
    fn block(&mut self, times: &BlockTimes) {
        let joint = times.motion.as_ref().and_then(|motion| motion.joint);
        if let Some(dot) = joint.and_then(|joint| joint.dot).filter(|_| times.place.file == DOCUMENT) {
            let line = self.0.entry(times.line.max(1)).or_insert(dot);
            if dot == Dot::Red {
                *line = dot;
            }
        }
    }
}

/// Plans the motion of a program.
struct Reader<'a> {
    snapshot: &'a Snapshot,
    steps: StepReader,
    planner: Planner,
    lines: Lines,
}

impl Sink for &mut Reader<'_> {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.planner.push(&self.steps.read(block), &mut self.lines);
        let executed = block.seq() + 1;
        if executed >= MOST || (executed.is_multiple_of(1 << 12) && self.snapshot.cancel.is_cancelled()) {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) {}
}
