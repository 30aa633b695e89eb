//! Rows as Arrow columns.

use std::fmt;
use std::io;

use super::row::{Reach, Row, SCHEMA};
use crate::columns::{Batches, End, Rows, Table};
use crate::dict::AxisLetter;
use crate::text::Encoding;

/// Key of the schema's name in the metadata of the columns.
const FORM: &str = "cnc872c.schema";

/// Rows as columns.
pub struct RowTable<'o> {
    rows: Rows<'o>,
    programs: u64,
}

impl fmt::Debug for RowTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RowTable").finish_non_exhaustive()
    }
}

impl<'o> RowTable<'o> {
    /// Gives record batches to `out`. What that fails with goes to `failed`.
    pub fn new(out: &'o mut (dyn Batches + Send), failed: &'o mut Option<io::Error>) -> Self {
        let mut rows = Rows::new(out, failed);
        put(&mut rows.table, &Row::default());
        rows.begin(FORM, SCHEMA);
        Self { rows, programs: 0 }
    }

    /// The next row.
    ///
    /// # Errors
    /// What `out` gives.
    pub fn row(&mut self, row: &Row) -> io::Result<()> {
        put(&mut self.rows.table, row);
        self.rows.row();
        self.programs += 1;
        self.rows.result()
    }

    /// After the last row.
    ///
    /// # Errors
    /// What `out` gives.
    pub fn end(self) -> io::Result<()> {
        let Self { mut rows, programs } = self;
        rows.end(&End::new(&format!(r#"{{"kind":"end","programs":{programs}}}"#), &[]));
        rows.result()
    }
}

fn put(table: &mut Table, row: &Row) {
    let Row {
        path,
        hash,
        number,
        title,
        dialect,
        encoding,
        blocks,
        executed,
        time_s,
        lower_bound,
        path_mm_by_type,
        extents,
        tools,
        m,
        g,
        h,
        subprograms,
        macrocycles,
        parameters,
        findings,
    } = row;
    table.text("path", Some(path));
    table.text("hash", hash.as_deref());
    table.whole("number", "", *number);
    table.text("title", title.as_deref());
    table.text("dialect", dialect.as_deref());
    let at = encoding.as_deref().and_then(|name| Encoding::ALL.iter().position(|known| known.name() == name));
    table.name("encoding", || Encoding::ALL.map(Encoding::name).into_iter(), at);
    table.long("blocks", Some(*blocks));
    table.long("executed", *executed);
    table.number("time_s", "s", time_s.map(|time| time.0));
    table.flag("lower_bound", *lower_bound);
    table.map("path_mm_by_type", "mm", path_mm_by_type.iter().map(|(kind, path)| (kind, path.0)));
    put_reach(table, "extents_working", &extents.working);
    put_reach(table, "extents_all", &extents.all);
    table.wholes("tools", tools);
    table.bytes("m", m);
    table.bytes("g", g);
    table.numbers("h", &h.iter().map(|h| h.0).collect::<Vec<_>>());
    table.wholes("subprograms", subprograms);
    table.wholes("macrocycles", macrocycles);
    table.texts("parameters", parameters);
    table.counts("findings", findings.iter().map(|(code, count)| (code, *count)));
}

fn put_reach(table: &mut Table, name: &str, reach: &Reach) {
    for axis in AxisLetter::ALL {
        let [least, greatest] = reach.get(axis.name()).map_or([None; 2], |ends| ends.map(|end| Some(end.0)));
        let letter = axis.letter().to_ascii_lowercase();
        // Programs of other machines may mean others by the other letters.
        let unit = if matches!(axis, AxisLetter::X | AxisLetter::Y | AxisLetter::Z) { "mm" } else { "" };
        table.number(format_args!("{name}_{letter}_min"), unit, least);
        table.number(format_args!("{name}_{letter}_max"), unit, greatest);
    }
}
