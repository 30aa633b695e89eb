"""Tables of records: columns for polars, pyarrow and pandas, and the records one by one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from . import _native

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

T = TypeVar("T")
R = TypeVar("R", bound="Record")


class Record:
    """A record of a table. What it does not have is None, what is not so is False."""

    __slots__ = ("_cells", "_row")

    _fields: dict[str, Field[Any]] = {}
    """The fields, in their order."""
    _kind = ""
    """The kind of record in the stream."""

    def __init__(self, cells: Cells, row: int) -> None:
        self._cells = cells
        self._row = row

    def __init_subclass__(cls) -> None:
        own = {name: field for name, field in vars(cls).items() if isinstance(field, Field)}
        cls._fields = {**cls._fields, **own}

    def to_dict(self) -> dict[str, Any]:
        """The record as the JSON stream has it: without what is None, False or empty."""
        record: dict[str, Any] = {"kind": self._kind} if self._kind else {}
        for name, field in self._fields.items():
            value = field.plain(self)
            if value is not None and value is not False:
                record[field.key or name] = value
        return record

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Record) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        fields = (f"{name}={value!r}" for name, value in self.to_dict().items() if name != "kind")
        return f"{type(self).__name__}({', '.join(fields)})"


class Field(Generic[T]):
    """A field of a record."""

    def __init__(self, read: Callable[[Record, str], T], key: str = "", column: str | None = None) -> None:
        self.read = read
        self.key = key
        self.column = column
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name if self.column is None else self.column

    @overload
    def __get__(self, record: None, owner: type) -> Field[T]: ...

    @overload
    def __get__(self, record: Record, owner: type) -> T: ...

    def __get__(self, record: Record | None, owner: type) -> Field[T] | T:
        return self if record is None else self.read(record, self.name)

    def plain(self, record: Record) -> Any:
        """The value without classes of this package."""
        value = self.read(record, self.name)
        if isinstance(value, Record):
            return value.to_dict()
        if isinstance(value, list) and value and isinstance(value[0], dict):
            return [dict(item) for item in value]
        return value


def _read(record: Record, name: str) -> Any:
    return record._cells.value(name, record._row)


def cell() -> Any:
    """The column of that name. Its type is written at the field."""
    return Field(_read)


def by_axis(prefix: str) -> Any:
    """The columns of axes, as a dictionary by letter."""

    def read(record: Record, _: str) -> dict[str, float] | None:
        cells = record._cells
        values = {letter: cells.value(column, record._row) for letter, column in cells.axes(prefix)}
        known = {letter: value for letter, value in values.items() if value is not None}
        return known or None

    return Field(read)


def group(kind: type[R], prefix: str, present: str) -> Any:
    """Columns with a prefix, as a record; None where the column ``present`` has no value."""

    def read(record: Record, _: str) -> R | None:
        if record._cells.value(present, record._row) is None:
            return None
        return kind(record._cells.within(prefix), record._row)

    return Field(read)


class Cells:
    """Values of a table by column and row; of columns with a prefix."""

    __slots__ = ("_columns", "_inner", "_prefix", "_table")

    def __init__(self, table: _native.Table, prefix: str = "", columns: dict[str, int] | None = None) -> None:
        self._table = table
        self._prefix = prefix
        self._columns = columns or {name: index for index, name in enumerate(table.columns())}
        self._inner: dict[str, Cells] = {}

    def within(self, prefix: str) -> Cells:
        """Those of columns with that prefix behind the own one."""
        inner = self._inner.get(prefix)
        if inner is None:
            inner = self._inner[prefix] = Cells(self._table, self._prefix + prefix, self._columns)
        return inner

    def value(self, name: str, row: int) -> Any:
        """A value; None of a column that is not there."""
        column = self._columns.get(self._prefix + name)
        return None if column is None else self._table.cell(column, row)

    def axes(self, prefix: str) -> list[tuple[str, str]]:
        """Letters of axes with the names of their columns."""
        start = self._prefix + prefix
        names = (name[len(start) :] for name in self._columns if name.startswith(start))
        return [(name.upper(), prefix + name) for name in names if len(name) == 1 and name in "xyzabcuvw"]


class Table(Generic[R]):
    """Records in memory, as Arrow columns.

    It has a length, indices and slices as a list has; a record is made when it is asked for. What reads the Arrow PyCapsule interface (polars,
    pyarrow, pandas, DuckDB) takes the columns as they are.
    """

    _record: type[R]

    def __init__(self, table: _native.Table) -> None:
        self._table = table
        self._cells = Cells(table)

    def __len__(self) -> int:
        return len(self._table)

    @overload
    def __getitem__(self, index: int) -> R: ...

    @overload
    def __getitem__(self, index: slice) -> list[R]: ...

    def __getitem__(self, index: int | slice) -> R | list[R]:
        if isinstance(index, slice):
            return [self._record(self._cells, row) for row in range(*index.indices(len(self)))]
        row = index + len(self) if index < 0 else index
        if not 0 <= row < len(self):
            raise IndexError(f"there are {len(self)} records")
        return self._record(self._cells, row)

    def __iter__(self) -> Iterator[R]:
        for row in range(len(self)):
            yield self._record(self._cells, row)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {len(self)} records>"

    @property
    def columns(self) -> list[str]:
        """The names of the columns."""
        return self._table.columns()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._table.__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        return self._table.__arrow_c_schema__()

    def to_arrow(self) -> pyarrow.Table:
        """The columns as a table of pyarrow, which shares their memory."""
        import pyarrow

        return pyarrow.table(self)

    def to_polars(self) -> polars.DataFrame:
        """The columns as a frame of polars."""
        import polars

        return polars.DataFrame(self)

    def to_pandas(self) -> pandas.DataFrame:
        """The columns as a frame of pandas; pyarrow is needed for it."""
        frame: pandas.DataFrame = self.to_arrow().to_pandas()
        return frame
