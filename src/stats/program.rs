//! From a program to its row.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use std::path::Path;

use sha2::{Digest, Sha256};

use super::row::{Extents, Number, Reach, Row};
use crate::analysis::Totals;
use crate::analysis::equidistant::Equidistant;
use crate::analysis::motion::{Estimate, JointFindings, Summary};
use crate::analysis::sheet::{self, Sheet, SheetReader};
use crate::config::Settings;
use crate::diag::{Finding, Findings};
use crate::dict::{Address, Decimal, Dialect, GCode, Micro};
use crate::run::{End, Executed, Sink};
use crate::session::{Outcome, Session};
use crate::text::{FileId, Sources};

/// SHA-256, hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    let digit = |value: u8| char::from_digit(u32::from(value), 16).unwrap_or('0');
    Sha256::digest(bytes).iter().flat_map(|byte| [digit(byte >> 4), digit(byte & 15)]).collect()
}

/// G functions, H and T that blocks write.
#[derive(Default)]
struct Used {
    g: BTreeSet<u8>,
    h: BTreeSet<Decimal>,
    t: BTreeSet<Decimal>,
}

impl Sink for Used {
    type Whole = Self;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        if block.moves_on() {
            return ControlFlow::Continue(());
        }
        self.g.extend(block.g_written().map(GCode::number));
        if block.written(Address::H) {
            self.h.extend(block.h());
        }
        if block.written(Address::T) {
            self.t.extend(block.t());
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> Self {
        self
    }
}

/// The facts of the program at `path`, called `name`, whose bytes have this hash; and the texts that were read.
pub fn row(session: &Session<'_>, path: &Path, name: &str, hash: String) -> (Row, Sources) {
    let (outcome, resolved) = session.resolve(path, name);
    let file = resolved.file(FileId(0));
    let number = file.and_then(|file| file.program).and_then(|word| word.whole());
    let mut row = Row {
        path: name.to_owned(),
        hash: Some(hash),
        number: number.and_then(|number| u32::try_from(number).ok()),
        title: file.and_then(|file| file.title.map(|title| file.comment_text(title).to_owned())),
        dialect: Some(dialect(session, path, name, &outcome).to_owned()),
        encoding: outcome.sources.get(FileId(0)).map(|source| source.encoding().name().to_owned()),
        blocks: file.map_or(0, |file| u64::from(file.block_count())),
        ..Row::default()
    };
    let outcome = if Session::can_execute(&resolved) {
        let settings = session.settings;
        let findings = (JointFindings::new(settings), Equidistant::new(settings, false));
        let sinks =
            ((SheetReader::new(), Estimate::new(settings, 0)), ((Totals::new(), Used::default()), (findings, ())));
        let run = session.execute(path, resolved, outcome, sinks);
        if let Some(((sheet, summary), ((totals, used), (_, end)))) = run.whole {
            fill(&mut row, &sheet, &summary, &totals, &used, end);
        }
        run.outcome
    } else {
        outcome
    };
    row.findings = count(&outcome.findings);
    (row, outcome.sources)
}

fn fill(row: &mut Row, sheet: &Sheet, summary: &Summary, totals: &Totals, used: &Used, end: End) {
    let whole = |value: Decimal| value.as_whole().and_then(|value| u32::try_from(value).ok());
    let in_spindle = sheet.tools.iter().filter_map(|tool| tool.tool);
    let tools: BTreeSet<u32> = in_spindle.chain(used.t.iter().copied()).filter_map(whole).collect();
    let units = |macrocycle: bool| {
        let of = sheet.units.iter().filter(move |unit| unit.macrocycle == macrocycle);
        of.map(|unit| unit.l).collect::<BTreeSet<u32>>().into_iter().collect()
    };
    row.executed = Some(end.blocks());
    row.time_s = Some(Number(Micro::from_f64(summary.total.time_s).to_f64()));
    row.lower_bound = summary.total.is_lower_bound();
    row.path_mm_by_type =
        totals.by_type().map(|(kind, path)| (kind.name().to_owned(), Number(path.to_f64()))).collect();
    row.extents = Extents { working: reach(&sheet.size.working), all: reach(&sheet.size.all) };
    row.tools = tools.into_iter().collect();
    row.m = sheet.m_functions.keys().copied().collect();
    row.g = used.g.iter().copied().collect();
    row.h = used.h.iter().map(|h| Number(Micro::from(*h).to_f64())).collect();
    row.subprograms = units(false);
    row.macrocycles = units(true);
    row.parameters = sheet.parameters.keys().map(|index| format!("R{index}")).collect();
}

fn reach(extents: &sheet::Extents) -> Reach {
    let known = extents.axes().filter_map(|(axis, reach)| Some((axis, reach.known?)));
    known
        .map(|(axis, (least, greatest))| (axis.to_string(), [Number(least.to_f64()), Number(greatest.to_f64())]))
        .collect()
}

fn count(findings: &Findings) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::new();
    for item in findings.items() {
        *counts.entry(item.code().to_string()).or_insert(0) += 1;
    }
    for ((_, code), more) in findings.beyond() {
        *counts.entry(code.to_string()).or_insert(0) += more as u64;
    }
    counts
}

/// The control that a program seems to be for: what its texts say of another maker's, else, of ours, the one that is
/// configured, unless the program has fewer errors on another.
fn dialect(session: &Session<'_>, path: &Path, name: &str, outcome: &Outcome) -> &'static str {
    let other = outcome.findings.items().iter().find_map(|item| {
        if let Finding::OtherControlProgram { control } = &item.finding { Some(control.name()) } else { None }
    });
    if let Some(other) = other {
        return other;
    }
    let configured = session.settings.machine.dialect;
    let mut fewest = (outcome.findings.error_count(), configured);
    for dialect in Dialect::ALL.into_iter().filter(|dialect| *dialect != configured) {
        if fewest.0 == 0 {
            break;
        }
        let settings = Settings { encoding: session.settings.encoding, ..Settings::new(dialect) };
        let errors = Session { settings: &settings, ..*session }.resolve(path, name).0.findings.error_count();
        if errors < fewest.0 {
            fewest = (errors, dialect);
        }
    }
    fewest.1.name()
}
