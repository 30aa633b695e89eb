//! The stream as a reader of executed blocks.

use std::io::{self, Write};
use std::ops::ControlFlow;

use super::beside::{Closed, Records, write_beside};
use super::records::{
    AxisMap, AxisRecord, EndRecord, FileRecord, GearRecord, MFunctionRecord, ProgramRecord, Record, SCHEMA,
};
use super::row::Rows;
use crate::analysis::{Part, Totals};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::{AxisLetter, Decimal, Micro};
use crate::run::{End, Executed, Program, Sink};
use crate::text::FileId;

/// Writes to `out` the stream of the program that `run` shows to the sink. Its text is made and written in a thread
/// beside execution, or between its blocks when the system gives no thread.
///
/// # Errors
/// What `out` says.
pub fn write<T>(
    out: &mut (dyn Write + Send),
    settings: &Settings,
    part: Part,
    run: impl FnOnce(JsonStream<'_, '_>) -> T,
) -> io::Result<T> {
    let letters: Vec<AxisLetter> = settings.machine.axes.iter().map(|axis| axis.letter).collect();
    write_beside(out, &letters, |records| {
        let result = run(JsonStream::new(records, part));
        if records.is_closed() { Err(Closed) } else { Ok(result) }
    })
}

/// The stream, as a reader of executed blocks.
pub struct JsonStream<'r, 'o> {
    records: &'r mut Records<'o>,
    part: Part,
    totals: Totals,
    rows: Rows,
    next_file: u32,
}

impl<'r, 'o> JsonStream<'r, 'o> {
    fn new(records: &'r mut Records<'o>, part: Part) -> Self {
        Self { records, part, totals: Totals::new(), rows: Rows::default(), next_file: 1 }
    }
}

impl std::fmt::Debug for JsonStream<'_, '_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("JsonStream").field("part", &self.part).finish_non_exhaustive()
    }
}

impl Sink for JsonStream<'_, '_> {
    /// Its `end` record is written.
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        self.records.rare(Record::Program(Box::new(program_record(program))));
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        let index = block.file_index();
        if index == self.next_file {
            self.next_file += 1;
            self.records.rare(Record::File(FileRecord { index, name: block.file_name().to_owned() }));
        }
        let Self { records, part, totals, rows, .. } = self;
        if !part.contains(block.seq()) {
            totals.add_motion(block.motion().and_then(|motion| Some((motion.kind(), motion.length().mm()?))));
            return ControlFlow::Continue(());
        }
        let written = records.block(|row, before| {
            rows.fill(block, row, before);
            totals.add_motion(row.motion.as_ref().and_then(|motion| Some((motion.kind, motion.length_mm?))));
        });
        if written.is_err() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        self.records.rare(Record::End(EndRecord {
            reason: end.reason(),
            blocks: end.blocks(),
            path_mm: self.totals.path(),
            path_mm_by_type: self.totals.by_type().collect(),
        }));
        end
    }
}

/// The first record.
pub(crate) fn program_record(program: &Program<'_>) -> ProgramRecord {
    let machine = &program.settings.machine;
    let file = program.resolved.file(FileId(0));
    let number = file.and_then(|file| file.program).and_then(|word| word.whole());
    ProgramRecord {
        schema: SCHEMA.to_owned(),
        generator: concat!("cnc872c ", env!("CARGO_PKG_VERSION")).to_owned(),
        dialect: machine.dialect.name().to_owned(),
        number: number.and_then(|number| u32::try_from(number).ok()).unwrap_or(0),
        title: file.and_then(|file| file.title.map(|title| file.comment_text(title).to_owned())),
        comments: file.map_or_else(Vec::new, |file| file.program_comments().map(str::to_owned).collect()),
        name: program.name().to_owned(),
        axes: machine
            .axes
            .iter()
            .map(|axis| AxisRecord {
                letter: axis.letter.to_string(),
                kind: if axis.rotary { "rotary" } else { "linear" }.to_owned(),
            })
            .collect(),
        block_skip: program.settings.block_skip,
        optional_stop: program.settings.optional_stop,
        parameters: machine.parameters.iter().map(|(index, value)| (*index, *value)).collect(),
        start: {
            let mut start = AxisMap::default();
            for (letter, value) in &machine.start {
                start.set(*letter, Some(Micro::from(*value)));
            }
            start
        },
        gears: machine
            .gears
            .iter()
            .map(|gear| {
                let output = Some(gear.output).filter(|output| *output != Decimal::whole(1));
                GearRecord { m: gear.m, min: gear.min, max: gear.max, output }
            })
            .collect(),
        cycles: machine.cycles.iter().map(|(cycle, macrocycle)| (*cycle, *macrocycle)).collect(),
        g97: machine.g97.name().to_owned(),
        arc_centers: machine.arc_centers.name().to_owned(),
        arc_tolerance: machine.limits.arc_tolerance,
        spindle_axis: machine.spindle().and_then(|axis| machine.axes.get(axis)).map(|axis| axis.letter),
        m_functions: machine
            .m_functions
            .configured()
            .map(|function| MFunctionRecord {
                no: function.number,
                group: function.group,
                break_cont: function.break_cont,
                break_cont_end: function.break_cont_end,
                change_pos: function.change_pos,
            })
            .collect(),
    }
}
