"""Every column says what the records say, over all samples: by pyarrow, by polars, and record by record."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import cnc872c
import polars
import pyarrow
import pytest
from cnc872c import _native
from shared import run, samples

AXES = "xyzabcuvw"


@contextmanager
def inside(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    yield
    os.chdir(before)


def where(name: str) -> list[str]:
    """Where the value of a column stands in a record: `motion_start_x` is `motion`, `start`, `X`."""
    if name in AXES:
        return ["position", name.upper()]
    for outer in ("motion", "jump", "data", "joint"):
        rest = name.removeprefix(f"{outer}_")
        if rest == name:
            continue
        inner, _, letter = rest.rpartition("_")
        return [outer, inner, letter.upper()] if inner and letter in AXES else [outer, rest]
    return [name]


def plain(value: Any, kind: pyarrow.DataType) -> Any:
    """A value of pyarrow or polars as JSON would have it: maps are dictionaries."""
    if value is None:
        return None
    if pyarrow.types.is_map(kind):
        return dict(value)
    if isinstance(value, (list, tuple)):
        return [plain(item, kind.value_type) for item in value]
    return value


def records(rows: list[dict[str, Any]], schema: pyarrow.Schema) -> list[dict[str, Any]]:
    """Rows as records again. What is null or false is left out, as in records."""
    made = []
    for row in rows:
        record: dict[str, Any] = {}
        for name, value in row.items():
            value = plain(value, schema.field(name).type)
            if value is None or value is False:
                continue
            inner = record
            *outer, last = where(name)
            for key in outer:
                inner = inner.setdefault(key, {})
            inner[last] = value
        made.append(record)
    return made


def lines(command: str, path: Path, *arguments: str) -> list[dict[str, Any]]:
    """The records that the command writes; none of a program with errors."""
    with TemporaryDirectory() as folder, inside(path.parent):
        out = Path(folder, "out")
        whole = _native.main(["cnc872c", command, path.name, *arguments, "-o", str(out)]) == 0
        return [json.loads(line) for line in out.read_text("utf-8").splitlines()] if whole else []


def of_kind(stream: list[dict[str, Any]], kind: str) -> list[dict[str, Any]]:
    return [record for record in stream if record["kind"] == kind]


def same(table: Any, expected: list[dict[str, Any]]) -> None:
    """The columns hold these records."""
    arrow = table.to_arrow()
    assert [record.to_dict() for record in table] == expected
    without = [{key: value for key, value in record.items() if key != "kind"} for record in expected]
    assert records(arrow.to_pylist(), arrow.schema) == without
    assert records(table.to_polars().to_dicts(), arrow.schema) == without


@pytest.fixture(scope="module")
def programs() -> list[tuple[Path, list[dict[str, Any]]]]:
    """Samples that are whole, with their streams."""
    found = [(path, lines("compile", path)) for path in samples()]
    whole = [(path, stream) for path, stream in found if stream]
    assert len(whole) > 50
    return whole


def test_blocks(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, stream in programs:
        monkeypatch.chdir(path.parent)
        blocks = cnc872c.compile(path.name)
        assert blocks.program == stream[0]
        assert blocks.end == stream[-1]
        assert blocks.files[1:] == [record["name"] for record in of_kind(stream, "file")]
        same(blocks, of_kind(stream, "block"))


def test_motion(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, _ in programs[::3]:
        monkeypatch.chdir(path.parent)
        stream = lines("motion", path, "--format", "json", "--phases")
        if not stream:
            continue
        for record in stream:
            if record.get("phases") == []:
                del record["phases"]
        motion = cnc872c.motion(path.name, phases=True)
        assert motion.machine == stream[0]
        assert motion.total == stream[-1]
        found = [{key: value for key, value in move.to_dict().items() if value != []} for move in motion.blocks]
        assert found == of_kind(stream, "block")


def test_signals(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, _ in programs[1::3]:
        monkeypatch.chdir(path.parent)
        stream = lines("plc", path, "--format", "json")
        if not stream:
            continue
        steps = cnc872c.plc(path.name)
        now: dict[str, Any] = {}
        expected = of_kind(stream, "step")
        assert len(steps) == len(expected)
        for step, record in zip(steps, expected, strict=True):
            now |= record["signals"]
            assert step.to_dict() == {**record, "signals": now}
        frame = steps.to_polars()
        assert [row for row in frame.rows()] == [tuple(row.values()) for row in steps.to_arrow().to_pylist()]


def test_facts() -> None:
    folder = "samples/ok"
    made = run("stats", folder, "--format", "json")
    rows = json.loads(made.stdout)["programs"]
    root = Path(__file__).resolve().parents[2]
    for row in rows:
        row["path"] = str(root / row["path"])
    found = [facts.to_dict() for facts in cnc872c.stats(root / folder)]
    assert found == rows
    assert len(found) > 5


def test_fields_are_the_columns() -> None:
    """Each column belongs to a field of a record, and each field has columns."""
    motion = cnc872c.motion(text="%1\nN10 M30")
    tables: list[tuple[list[str], type[Any]]] = [
        (cnc872c.compile(text="%1\nN10 M30").columns, cnc872c.Block),
        (motion.blocks.columns, cnc872c.Move),
    ]
    for columns, record in tables:
        ends = {where(name)[0] for name in columns}
        assert ends == {field.key or name for name, field in record._fields.items()}


def test_units() -> None:
    schema = cnc872c.compile(text="%1\nN10 M30").to_arrow().schema
    assert schema.field("motion_length_mm").metadata == {b"unit": b"mm"}
    assert schema.field("a").metadata == {b"unit": b"deg"}
    assert json.loads(schema.metadata[b"cnc872c.program"])["number"] == 1


def test_nothing_is_copied() -> None:
    """polars and pyarrow see the same numbers at the same address."""
    blocks = cnc872c.compile(text="%1\nN10 G90 G00 X0\nN20 G01 X5 F100\nN30 M30")
    first, second = (pyarrow.table(blocks)["x"].chunk(0).buffers()[1].address for _ in range(2))
    assert first == second
    series = polars.DataFrame(blocks)["x"]
    assert series.to_list() == [0.0, 5.0, 5.0]
