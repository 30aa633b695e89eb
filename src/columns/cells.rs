//! The cells of one column: what it holds, and the arrays of it.

use std::sync::Arc;

use arrow_array::builder::{
    ArrayBuilder, BooleanBuilder, FixedSizeListBuilder, Float64Builder, Int8Builder, ListBuilder, MapBuilder,
    MapFieldNames, StringBuilder, UInt8Builder, UInt32Builder, UInt64Builder,
};
use arrow_array::types::Int8Type;
use arrow_array::{ArrayRef, DictionaryArray, Int8Array, ListArray, StringArray, StructArray};
use arrow_buffer::{NullBufferBuilder, OffsetBufferBuilder};
use arrow_schema::{ArrowError, DataType, Field, Fields};

/// The type of a column's values.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    Byte,
    Whole,
    Long,
    Number,
    Flag,
    /// One of these names.
    Name(StringArray),
    /// Several of them.
    Names(StringArray),
    Text,
    Texts,
    Bytes,
    Wholes,
    Numbers,
    /// So many bytes, any of which may be absent.
    Fixed(usize),
    /// Numbers by name.
    Map,
    /// Whole numbers by name.
    Counts,
    /// A name called `name` and six whole numbers.
    Structs {
        name: &'static str,
        names: StringArray,
        fields: &'static [&'static str],
    },
    /// Lists of four numbers.
    Quadruples,
}

/// Names are few: their places have seven bits.
fn dictionary() -> DataType {
    DataType::Dictionary(Box::new(DataType::Int8), Box::new(DataType::Utf8))
}

fn item(data_type: DataType) -> Arc<Field> {
    Arc::new(Field::new_list_field(data_type, true))
}

type Maps<V> = Box<MapBuilder<StringBuilder, V>>;

fn map<V: ArrayBuilder + Default>() -> Maps<V> {
    let names = MapFieldNames { entry: "entries".to_owned(), key: "key".to_owned(), value: "value".to_owned() };
    Box::new(MapBuilder::new(Some(names), StringBuilder::new(), V::default()))
}

fn map_of(value: DataType) -> DataType {
    let fields = Fields::from_iter([Field::new("key", DataType::Utf8, false), Field::new("value", value, true)]);
    DataType::Map(Arc::new(Field::new("entries", DataType::Struct(fields), false)), false)
}

fn struct_fields(name: &str, fields: &[&str]) -> Fields {
    let numbers = fields.iter().map(|field| Field::new(*field, DataType::UInt32, false));
    std::iter::once(Field::new(name, dictionary(), false)).chain(numbers).collect()
}

impl Kind {
    /// As Arrow calls it.
    pub fn data_type(&self) -> DataType {
        match self {
            Self::Byte => DataType::UInt8,
            Self::Whole => DataType::UInt32,
            Self::Long => DataType::UInt64,
            Self::Number => DataType::Float64,
            Self::Flag => DataType::Boolean,
            Self::Name(_) => dictionary(),
            Self::Names(_) => DataType::List(item(dictionary())),
            Self::Text => DataType::Utf8,
            Self::Texts => DataType::List(item(DataType::Utf8)),
            Self::Bytes => DataType::List(item(DataType::UInt8)),
            Self::Wholes => DataType::List(item(DataType::UInt32)),
            Self::Numbers => DataType::List(item(DataType::Float64)),
            Self::Fixed(count) => DataType::FixedSizeList(item(DataType::UInt8), i32::try_from(*count).unwrap_or(0)),
            Self::Map => map_of(DataType::Float64),
            Self::Counts => map_of(DataType::UInt64),
            Self::Structs { name, fields, .. } => DataType::List(item(DataType::Struct(struct_fields(name, fields)))),
            Self::Quadruples => DataType::List(item(DataType::FixedSizeList(item(DataType::Float64), 4))),
        }
    }
}

/// Lists whose items are put elsewhere.
pub(super) struct Lists {
    offsets: OffsetBufferBuilder<i32>,
    present: NullBufferBuilder,
}

impl Lists {
    fn new() -> Self {
        Self { offsets: OffsetBufferBuilder::new(0), present: NullBufferBuilder::new(0) }
    }

    fn push(&mut self, items: Option<usize>) {
        self.offsets.push_length(items.unwrap_or(0));
        self.present.append(items.is_some());
    }

    fn finish(mut self, field: Arc<Field>, items: ArrayRef) -> Result<ArrayRef, ArrowError> {
        Ok(Arc::new(ListArray::try_new(field, self.offsets.finish(), items, self.present.finish())?))
    }
}

/// The cells of a column.
pub(super) enum Cells {
    Byte(UInt8Builder),
    Whole(UInt32Builder),
    Long(UInt64Builder),
    Number(Float64Builder),
    Flag(BooleanBuilder),
    Name(Int8Builder),
    Names(Lists, Int8Builder),
    Text(StringBuilder),
    Texts(ListBuilder<StringBuilder>),
    Bytes(ListBuilder<UInt8Builder>),
    Wholes(ListBuilder<UInt32Builder>),
    Numbers(ListBuilder<Float64Builder>),
    Fixed(FixedSizeListBuilder<UInt8Builder>),
    Map(Maps<Float64Builder>),
    Counts(Maps<UInt64Builder>),
    Structs(Box<(Lists, Int8Builder, [UInt32Builder; 6])>),
    Quadruples(ListBuilder<FixedSizeListBuilder<Float64Builder>>),
}

macro_rules! push {
    ($($method:ident $variant:ident $value:ty;)*) => {
        $(#[inline]
        pub fn $method(&mut self, value: $value) {
            if let Self::$variant(builder) = self {
                builder.append_value(value);
            }
        })*
    };
}

macro_rules! push_list {
    ($($method:ident $variant:ident $value:ty;)*) => {
        $(#[inline]
        pub fn $method(&mut self, values: &[$value]) {
            if let Self::$variant(builder) = self {
                builder.values().append_slice(values);
                builder.append(true);
            }
        })*
    };
}

macro_rules! push_map {
    ($($method:ident $variant:ident $value:ty;)*) => {
        $(pub fn $method<K: AsRef<str>>(&mut self, entries: impl Iterator<Item = (K, $value)>) {
            if let Self::$variant(builder) = self {
                for (key, value) in entries {
                    builder.keys().append_value(key);
                    builder.values().append_value(value);
                }
                // As many keys as values.
                let _ = builder.append(true);
            }
        })*
    };
}

impl Cells {
    /// Without rows, of which so many are expected.
    pub fn new(kind: &Kind, rows: usize) -> Self {
        match kind {
            Kind::Byte => Self::Byte(UInt8Builder::with_capacity(rows)),
            Kind::Whole => Self::Whole(UInt32Builder::with_capacity(rows)),
            Kind::Long => Self::Long(UInt64Builder::with_capacity(rows)),
            Kind::Number => Self::Number(Float64Builder::with_capacity(rows)),
            Kind::Flag => Self::Flag(BooleanBuilder::with_capacity(rows)),
            Kind::Name(_) => Self::Name(Int8Builder::with_capacity(rows)),
            Kind::Names(_) => Self::Names(Lists::new(), Int8Builder::new()),
            Kind::Text => Self::Text(StringBuilder::new()),
            Kind::Texts => Self::Texts(ListBuilder::new(StringBuilder::new())),
            Kind::Bytes => Self::Bytes(ListBuilder::new(UInt8Builder::new())),
            Kind::Wholes => Self::Wholes(ListBuilder::new(UInt32Builder::new())),
            Kind::Numbers => Self::Numbers(ListBuilder::new(Float64Builder::new())),
            Kind::Fixed(count) => {
                let count = i32::try_from(*count).unwrap_or(0);
                Self::Fixed(FixedSizeListBuilder::new(UInt8Builder::new(), count))
            }
            Kind::Map => Self::Map(map()),
            Kind::Counts => Self::Counts(map()),
            Kind::Structs { .. } => Self::Structs(Box::new((Lists::new(), Int8Builder::new(), Default::default()))),
            Kind::Quadruples => Self::Quadruples(ListBuilder::new(FixedSizeListBuilder::new(Float64Builder::new(), 4))),
        }
    }

    push! {
        push_byte Byte u8;
        push_whole Whole u32;
        push_long Long u64;
        push_number Number f64;
        push_flag Flag bool;
        push_text Text &str;
    }

    /// The name at this place.
    #[inline]
    pub fn push_name(&mut self, place: usize) {
        if let Self::Name(builder) = self {
            builder.append_value(key(place));
        }
    }

    /// The names at these places.
    #[inline]
    pub fn push_names(&mut self, places: impl Iterator<Item = usize>) {
        if let Self::Names(lists, builder) = self {
            let before = builder.len();
            places.for_each(|place| builder.append_value(key(place)));
            lists.push(Some(builder.len() - before));
        }
    }

    /// Texts.
    pub fn push_texts(&mut self, texts: &[String]) {
        if let Self::Texts(builder) = self {
            texts.iter().for_each(|text| builder.values().append_value(text));
            builder.append(true);
        }
    }

    push_list! {
        push_bytes Bytes u8;
        push_wholes Wholes u32;
        push_numbers Numbers f64;
    }

    /// As many bytes as the column has.
    #[inline]
    pub fn push_fixed(&mut self, bytes: &[Option<u8>]) {
        if let Self::Fixed(builder) = self {
            bytes.iter().for_each(|byte| builder.values().append_option(*byte));
            builder.append(true);
        }
    }

    push_map! {
        push_map Map f64;
        push_counts Counts u64;
    }

    /// Names with their numbers.
    pub fn push_structs(&mut self, rows: impl Iterator<Item = (usize, [u32; 6])>) {
        if let Self::Structs(parts) = self {
            let (lists, names, numbers) = parts.as_mut();
            let before = names.len();
            for (place, values) in rows {
                names.append_value(key(place));
                numbers.iter_mut().zip(values).for_each(|(builder, value)| builder.append_value(value));
            }
            lists.push(Some(names.len() - before));
        }
    }

    /// Lists of four.
    pub fn push_quadruples(&mut self, rows: impl Iterator<Item = [f64; 4]>) {
        if let Self::Quadruples(builder) = self {
            for row in rows {
                builder.values().values().append_slice(&row);
                builder.values().append(true);
            }
            builder.append(true);
        }
    }

    /// A row without a value.
    #[inline]
    pub fn push_absent(&mut self) {
        match self {
            Self::Byte(builder) => builder.append_null(),
            Self::Whole(builder) => builder.append_null(),
            Self::Long(builder) => builder.append_null(),
            Self::Number(builder) => builder.append_null(),
            Self::Flag(builder) => builder.append_value(false),
            Self::Name(builder) => builder.append_null(),
            Self::Names(lists, _) => lists.push(None),
            Self::Text(builder) => builder.append_null(),
            Self::Texts(builder) => builder.append(false),
            Self::Bytes(builder) => builder.append(false),
            Self::Wholes(builder) => builder.append(false),
            Self::Numbers(builder) => builder.append(false),
            Self::Fixed(builder) => {
                (0..builder.value_length()).for_each(|_| builder.values().append_null());
                builder.append(false);
            }
            Self::Map(builder) => drop(builder.append(false)),
            Self::Counts(builder) => drop(builder.append(false)),
            Self::Structs(parts) => parts.0.push(None),
            Self::Quadruples(builder) => builder.append(false),
        }
    }

    /// The array of the rows. `kind` is what it was made for.
    pub fn finish(self, kind: &Kind) -> Result<ArrayRef, ArrowError> {
        Ok(match (self, kind) {
            (Self::Byte(mut builder), _) => Arc::new(builder.finish()),
            (Self::Whole(mut builder), _) => Arc::new(builder.finish()),
            (Self::Long(mut builder), _) => Arc::new(builder.finish()),
            (Self::Number(mut builder), _) => Arc::new(builder.finish()),
            (Self::Flag(mut builder), _) => Arc::new(builder.finish()),
            (Self::Text(mut builder), _) => Arc::new(builder.finish()),
            (Self::Texts(mut builder), _) => Arc::new(builder.finish()),
            (Self::Bytes(mut builder), _) => Arc::new(builder.finish()),
            (Self::Wholes(mut builder), _) => Arc::new(builder.finish()),
            (Self::Numbers(mut builder), _) => Arc::new(builder.finish()),
            (Self::Fixed(mut builder), _) => Arc::new(builder.finish()),
            (Self::Map(mut builder), _) => Arc::new(builder.finish()),
            (Self::Counts(mut builder), _) => Arc::new(builder.finish()),
            (Self::Quadruples(mut builder), _) => Arc::new(builder.finish()),
            (Self::Name(mut builder), Kind::Name(names)) => named(builder.finish(), names)?,
            (Self::Names(lists, mut builder), Kind::Names(names)) => {
                lists.finish(item(dictionary()), named(builder.finish(), names)?)?
            }
            (Self::Structs(parts), Kind::Structs { name, names, fields }) => {
                let (lists, mut keys, numbers) = *parts;
                let fields = struct_fields(name, fields);
                let numbers = numbers.into_iter().map(|mut numbers| Arc::new(numbers.finish()) as ArrayRef);
                let columns = std::iter::once(named(keys.finish(), names)?).chain(numbers).collect();
                let items = StructArray::try_new(fields.clone(), columns, None)?;
                lists.finish(item(DataType::Struct(fields)), Arc::new(items))?
            }
            (Self::Name(_) | Self::Names(..) | Self::Structs(_), _) => {
                return Err(ArrowError::SchemaError("a column holds what it was not made for".to_owned()));
            }
        })
    }
}

/// The place of a name in its dictionary.
#[inline]
fn key(place: usize) -> i8 {
    i8::try_from(place).unwrap_or(0)
}

fn named(keys: Int8Array, names: &StringArray) -> Result<ArrayRef, ArrowError> {
    Ok(Arc::new(DictionaryArray::<Int8Type>::try_new(keys, Arc::new(names.clone()))?))
}
