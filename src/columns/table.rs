//! Rows under way to record batches.
//!
//! A row is given field by field, always in the same order: the first row of all declares the columns by it, the others
//! fill them. So one line has the name of a column, its type and its value.
//!
//! A row may follow the one before, and then has only some of the fields, always the same ones; the other columns
//! repeat what the last whole row has. They get a cell a whole row, and are spread over the rows when the batch is
//! full.

use std::fmt::Display;
use std::sync::Arc;

use arrow_array::{Array, ArrayRef, RecordBatch, StringArray, UInt32Array};
use arrow_schema::{ArrowError, Field, Metadata, Schema, SchemaRef};
use arrow_select::take::take;

use super::cells::{Cells, Kind};
use crate::sure::small;

/// Rows of a record batch; the last one has fewer.
pub const ROWS: usize = 1 << 16;

/// What a column is.
#[derive(Clone)]
struct Column {
    field: Field,
    kind: Kind,
    /// Rows that follow have it too.
    moves: bool,
    /// Its cells in a batch where all are the same, for the next such batch.
    constant: Option<ArrayRef>,
}

impl Column {
    /// The cells of whole rows over all rows, of which `of` says the cell.
    fn spread(&mut self, cells: ArrayRef, of: &UInt32Array) -> Result<ArrayRef, ArrowError> {
        let rows = of.len();
        let known = self.constant.as_ref().filter(|known| cells.len() == 1 && known.len() >= rows);
        if let Some(known) = known.filter(|known| *known.slice(0, 1) == *cells) {
            return Ok(known.slice(0, rows));
        }
        let spread = take(&cells, of, None)?;
        self.constant = (cells.len() == 1).then(|| ArrayRef::clone(&spread));
        Ok(spread)
    }
}

/// Cells after so many rows without a value, of as many as are expected.
#[cold]
fn after_absent(kind: &Kind, rows: usize, expected: usize) -> Box<Cells> {
    let mut cells = Cells::new(kind, expected);
    (0..rows).for_each(|_| cells.push_absent());
    Box::new(cells)
}

/// Rows of columns.
#[derive(Default)]
pub(crate) struct Table {
    columns: Vec<Column>,
    /// By column; `None`: no row has a value so far. Small, since every row goes through it.
    cells: Vec<Option<Box<Cells>>>,
    /// The column of the next field.
    at: usize,
    rows: usize,
    /// Rows of the batch before.
    expected: usize,
    /// The row under way follows the one before.
    follows: bool,
    /// The columns of such a row, in order.
    moving: Vec<usize>,
    /// Whole rows, by number.
    whole: Vec<u32>,
    declared: bool,
    /// Columns without any value, by what they hold: shared by all of them and by all batches.
    absent: Vec<(Kind, ArrayRef)>,
}

impl Table {
    /// The next field of the row. `unit` is that of its numbers, empty when they have none.
    #[inline]
    fn field<V>(
        &mut self,
        name: &dyn Display,
        unit: &str,
        kind: impl FnOnce() -> Kind,
        value: Option<V>,
        push: impl FnOnce(&mut Cells, V),
    ) {
        if !self.declared {
            self.declare_column(name, unit, kind());
        }
        let place = if self.follows { self.moving.get(self.at).copied().unwrap_or(usize::MAX) } else { self.at };
        if let (Some(cells), Some(column)) = (self.cells.get_mut(place), self.columns.get(place)) {
            match (value, cells) {
                (None, None) => {}
                (None, Some(cells)) => cells.push_absent(),
                (Some(value), Some(cells)) => push(cells, value),
                (Some(value), none) => {
                    let before = if column.moves { self.rows } else { self.whole.len() };
                    push(none.insert(after_absent(&column.kind, before, self.expected)), value);
                }
            }
        }
        self.at += 1;
    }

    #[cold]
    fn declare_column(&mut self, name: &dyn Display, unit: &str, kind: Kind) {
        if self.follows {
            let name = name.to_string();
            if let Some(place) = self.columns.iter().position(|column| *column.field.name() == name) {
                self.moving.push(place);
                self.columns.iter_mut().skip(place).take(1).for_each(|column| column.moves = true);
            }
            return;
        }
        let field = Field::new(name.to_string(), kind.data_type(), kind != Kind::Flag);
        let field = if unit.is_empty() { field } else { field.with_metadata(Metadata::new().with("unit", unit)) };
        self.columns.push(Column { field, kind, moves: false, constant: None });
        self.cells.push(None);
    }

    /// A whole number below 256.
    #[inline]
    pub fn byte(&mut self, name: impl Display, value: Option<u8>) {
        self.field(&name, "", || Kind::Byte, value, Cells::push_byte);
    }

    /// A whole number.
    #[inline]
    pub fn whole(&mut self, name: impl Display, unit: &str, value: Option<u32>) {
        self.field(&name, unit, || Kind::Whole, value, Cells::push_whole);
    }

    /// A whole number without bounds.
    #[inline]
    pub fn long(&mut self, name: impl Display, value: Option<u64>) {
        self.field(&name, "", || Kind::Long, value, Cells::push_long);
    }

    /// A number.
    #[inline]
    pub fn number(&mut self, name: impl Display, unit: &str, value: Option<f64>) {
        self.field(&name, unit, || Kind::Number, value, Cells::push_number);
    }

    /// A flag: absent is false.
    #[inline]
    pub fn flag(&mut self, name: impl Display, value: bool) {
        self.field(&name, "", || Kind::Flag, value.then_some(true), Cells::push_flag);
    }

    /// One of `names`, by its place among them.
    #[inline]
    pub fn name<N: Iterator<Item: AsRef<str>>>(
        &mut self,
        name: impl Display,
        names: impl FnOnce() -> N,
        value: Option<usize>,
    ) {
        self.field(&name, "", || Kind::Name(StringArray::from_iter_values(names())), value, Cells::push_name);
    }

    /// Several of `names`, by their places among them; none of them is absent.
    #[inline]
    pub fn names<N: Iterator<Item: AsRef<str>>>(
        &mut self,
        name: impl Display,
        names: impl FnOnce() -> N,
        values: Option<impl Iterator<Item = usize>>,
    ) {
        self.field(
            &name,
            "",
            || Kind::Names(StringArray::from_iter_values(names())),
            values,
            |cells, values| cells.push_names(values),
        );
    }

    /// A text.
    #[inline]
    pub fn text(&mut self, name: impl Display, value: Option<&str>) {
        self.field(&name, "", || Kind::Text, value, Cells::push_text);
    }

    /// Texts; none of them is absent.
    #[inline]
    pub fn texts(&mut self, name: impl Display, values: &[String]) {
        self.field(&name, "", || Kind::Texts, (!values.is_empty()).then_some(values), Cells::push_texts);
    }

    /// Whole numbers below 256; none of them is absent.
    #[inline]
    pub fn bytes(&mut self, name: impl Display, values: &[u8]) {
        self.field(&name, "", || Kind::Bytes, (!values.is_empty()).then_some(values), Cells::push_bytes);
    }

    /// Whole numbers; none of them is absent.
    pub fn wholes(&mut self, name: impl Display, values: &[u32]) {
        self.field(&name, "", || Kind::Wholes, (!values.is_empty()).then_some(values), Cells::push_wholes);
    }

    /// Numbers; none of them is absent.
    pub fn numbers(&mut self, name: impl Display, values: &[f64]) {
        self.field(&name, "", || Kind::Numbers, (!values.is_empty()).then_some(values), Cells::push_numbers);
    }

    /// So many whole numbers below 256, some of which are absent.
    #[inline]
    pub fn fixed(&mut self, name: impl Display, values: &[Option<u8>]) {
        self.field(&name, "", || Kind::Fixed(values.len()), Some(values), Cells::push_fixed);
    }

    /// Numbers by name; none of them is absent.
    #[inline]
    pub fn map<K: AsRef<str>>(&mut self, name: impl Display, unit: &str, values: impl Iterator<Item = (K, f64)>) {
        let mut values = values.peekable();
        let some = values.peek().is_some().then_some(values);
        self.field(&name, unit, || Kind::Map, some, |cells, values| cells.push_map(values));
    }

    /// Whole numbers by name; none of them is absent.
    pub fn counts<K: AsRef<str>>(&mut self, name: impl Display, values: impl Iterator<Item = (K, u64)>) {
        let mut values = values.peekable();
        let some = values.peek().is_some().then_some(values);
        self.field(&name, "", || Kind::Counts, some, |cells, values| cells.push_counts(values));
    }

    /// Rows of numbers with a name each, `fields` wide; none of them is absent.
    #[inline]
    pub fn structs<N: Iterator<Item: AsRef<str>>>(
        &mut self,
        name: impl Display,
        names: impl FnOnce() -> (&'static str, N),
        fields: &'static [&'static str],
        rows: Option<impl Iterator<Item = (usize, [u32; 6])>>,
    ) {
        let kind = || {
            let (name, names) = names();
            Kind::Structs { name, names: StringArray::from_iter_values(names), fields }
        };
        self.field(&name, "", kind, rows, |cells, rows| cells.push_structs(rows));
    }

    /// Lists of four numbers; none of them is absent.
    #[inline]
    pub fn quadruples(&mut self, name: impl Display, rows: Option<impl Iterator<Item = [f64; 4]>>) {
        self.field(&name, "", || Kind::Quadruples, rows, |cells, rows| cells.push_quadruples(rows));
    }

    /// Before the first field of a row. A row that `follows` has only the fields that the one before the declaration
    /// had.
    #[inline]
    pub const fn begin_row(&mut self, follows: bool) {
        self.follows = follows;
        self.at = 0;
    }

    /// The row in the table has declared the columns; it is no row of the data. So has one that follows, if there are
    /// such.
    pub fn declare(&mut self, metadata: Metadata) -> SchemaRef {
        self.declared = true;
        self.begin_row(false);
        self.cells.fill_with(|| None);
        let fields: Vec<Field> = self.columns.iter().map(|column| column.field.clone()).collect();
        Arc::new(Schema::new_with_metadata(fields, metadata))
    }

    /// A table with the same columns, and without rows.
    pub fn another(&self) -> Self {
        let cells = self.columns.iter().map(|_| None).collect();
        Self { columns: self.columns.clone(), cells, moving: self.moving.clone(), declared: true, ..Self::default() }
    }

    /// After the last field of a row. `true`: the batch is full.
    #[inline]
    pub fn end_row(&mut self) -> bool {
        let fields = if self.follows { self.moving.len() } else { self.columns.len() };
        debug_assert_eq!(self.at, fields, "every row has every field");
        if !self.follows {
            // A batch has far fewer rows than that.
            self.whole.push(small(self.rows));
        }
        debug_assert!(!self.whole.is_empty(), "no batch begins with a row that follows");
        self.begin_row(false);
        self.rows += 1;
        self.rows == ROWS
    }

    /// Whether there are rows that no batch has.
    pub const fn has_rows(&self) -> bool {
        self.rows > 0
    }

    /// A batch of the rows, which the table then has no more.
    pub fn batch(&mut self, schema: &SchemaRef) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        self.expected = rows;
        let whole = std::mem::take(&mut self.whole);
        let spread = (whole.len() < rows).then(|| cells_of_rows(&whole, rows));
        let Self { columns, cells, absent, .. } = self;
        let arrays = columns.iter_mut().zip(cells).map(|(column, cells)| match (cells.take(), &spread) {
            (None, _) => absent_column(absent, &column.kind, rows),
            (Some(cells), Some(of)) if !column.moves => column.spread(cells.finish(&column.kind)?, of),
            (Some(cells), _) => cells.finish(&column.kind),
        });
        RecordBatch::try_new(SchemaRef::clone(schema), arrays.collect::<Result<_, _>>()?)
    }
}

/// The cell of each row, where only these rows have one, and the others repeat the one before.
fn cells_of_rows(whole: &[u32], rows: usize) -> UInt32Array {
    let mut later = whole.iter().skip(1).peekable();
    let mut cell = 0;
    (0..rows)
        .map(|row| {
            if later.next_if(|whole| **whole as usize == row).is_some() {
                cell += 1;
            }
            cell
        })
        .collect::<Vec<u32>>()
        .into()
}

/// A column without any value.
fn absent_column(known: &mut Vec<(Kind, ArrayRef)>, kind: &Kind, rows: usize) -> Result<ArrayRef, ArrowError> {
    if let Some((_, array)) = known.iter().find(|(of, array)| of == kind && array.len() >= rows) {
        return Ok(array.slice(0, rows));
    }
    let array = after_absent(kind, rows, rows).finish(kind)?;
    known.retain(|(of, _)| of != kind);
    known.push((kind.clone(), ArrayRef::clone(&array)));
    Ok(array)
}
