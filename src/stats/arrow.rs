//! Rows as Arrow columns.

use std::io::{self, Write};

use arrow_schema::Metadata;

use super::row::{Reach, Row};
use crate::columns::{Kept, Plain, Table};
use crate::dict::AxisLetter;

/// Begins an Arrow IPC stream of rows, which are then [put](put) into it.
pub fn write(out: &mut (dyn Write + Send)) -> io::Result<Plain<'_, Row>> {
    Plain::begin(out, put, &Row::default(), Metadata::new().with("cnc872c.schema", super::SCHEMA))
}

/// Rows as record batches in memory.
///
/// # Errors
/// Never for rows of programs: what columns refuse.
pub fn kept(rows: &[Row]) -> io::Result<Kept> {
    let mut table = Table::default();
    put(&mut table, &Row::default());
    let schema = table.declare(Metadata::new().with("cnc872c.schema", super::SCHEMA));
    let mut batches = Vec::new();
    let mut left = rows.len();
    for row in rows {
        put(&mut table, row);
        left -= 1;
        if table.end_row() || left == 0 {
            batches.push(table.batch(&schema).map_err(io::Error::other)?);
        }
    }
    Ok(Kept { schema: Some(schema), batches, end: None })
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
    table.text("encoding", encoding.as_deref());
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
    #[expect(clippy::cast_precision_loss, reason = "nobody has so many findings")]
    table.map("findings", "", findings.iter().map(|(code, count)| (code, *count as f64)));
}

fn put_reach(table: &mut Table, name: &str, reach: &Reach) {
    for axis in AxisLetter::ALL {
        let [least, greatest] = reach.get(axis.name()).map_or([None; 2], |ends| ends.map(|end| Some(end.0)));
        let letter = axis.letter().to_ascii_lowercase();
        table.number(format_args!("{name}_{letter}_min"), "", least);
        table.number(format_args!("{name}_{letter}_max"), "", greatest);
    }
}
