"""Every column says what the records say, over all samples: by pyarrow, by polars, and record by record."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import cnc872c
import polars
import pyarrow
import pyarrow.ipc
import pytest
from cnc872c import _native
from shared import FAULTY, ROOT, WHOLE, run, samples

AXES = "xyzabcuvw"

MOST = 2000
"""Blocks of one sample that are compared."""


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
    if name.startswith("extents_"):
        _, part, letter, end = name.split("_")
        return ["extents", part, letter.upper(), end]
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


def records(rows: list[dict[str, Any]], schema: pyarrow.Schema, flat: bool = False) -> list[dict[str, Any]]:
    """Rows as records again. What is null or false is left out, as in records. ``flat``: names are not paths."""
    made = []
    for row in rows:
        record: dict[str, Any] = {}
        for name, value in row.items():
            value = plain(value, schema.field(name).type)
            if value is None or value is False:
                continue
            inner = record
            *outer, last = [name] if flat else where(name)
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
    # What is absent is null; a flag is false then.
    for field, column in zip(arrow.schema, arrow.columns, strict=True):
        assert field.nullable != pyarrow.types.is_boolean(field.type)
        assert field.nullable or column.null_count == 0
    assert [record.to_dict() for record in table] == expected
    without = [{key: value for key, value in record.items() if key != "kind"} for record in expected]
    assert records(arrow.to_pylist(), arrow.schema) == without
    assert records(table.to_polars().to_dicts(), arrow.schema) == without


@pytest.fixture(scope="module")
def programs() -> list[tuple[Path, list[dict[str, Any]]]]:
    """Samples that are whole, with their streams."""
    found = [(path, lines("compile", path, "--limit", str(MOST))) for path in samples()]
    whole = [(path, stream) for path, stream in found if stream]
    assert len(whole) > 50
    return whole


def test_blocks(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, stream in programs:
        monkeypatch.chdir(path.parent)
        blocks = cnc872c.compile(path.name, limit=MOST)
        assert blocks.program == stream[0]
        assert blocks.end == stream[-1]
        assert blocks.files[1:] == [record["name"] for record in of_kind(stream, "file")]
        same(blocks, of_kind(stream, "block"))


def test_motion(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, blocks in programs:
        if len(blocks) > MOST:
            continue
        monkeypatch.chdir(path.parent)
        stream = lines("motion", path, "--format", "json", "--phases")
        if not stream:
            continue
        expected = of_kind(stream, "block")
        for record in expected:
            # A motion that takes no time has no phases.
            if record.get("phases") == []:
                del record["phases"]
        motion = cnc872c.motion(path.name, phases=True)
        assert motion.machine == stream[0]
        assert motion.total == stream[-1]
        same(motion.blocks, expected)


def test_signals(programs: list[tuple[Path, list[dict[str, Any]]]], monkeypatch: pytest.MonkeyPatch) -> None:
    for path, _ in programs:
        monkeypatch.chdir(path.parent)
        stream = lines("plc", path, "--format", "json", "--limit", str(MOST))
        if not stream:
            continue
        steps = cnc872c.plc(path.name, limit=MOST)
        now: dict[str, Any] = {}
        rows = []
        expected = of_kind(stream, "step")
        for step, record in zip(steps, expected, strict=True):
            now |= record.pop("signals")
            assert step.to_dict() == {**record, "signals": now}
            rows.append({**{key: value for key, value in record.items() if key != "kind"}, **now})
        arrow = steps.to_arrow()
        without = [{key: value for key, value in row.items() if value is not None} for row in rows]
        assert records(arrow.to_pylist(), arrow.schema, flat=True) == without
        assert records(steps.to_polars().to_dicts(), arrow.schema, flat=True) == without


def test_facts() -> None:
    folders = ["samples/ok", "samples/rules"]
    rows = json.loads(run("stats", *folders, "--format", "json").stdout)["programs"]
    for row in rows:
        row["path"] = str(ROOT / row["path"])
    archive = cnc872c.stats([ROOT / folder for folder in folders])
    assert [facts.to_dict() for facts in archive] == rows
    assert len(rows) > 100
    arrow = archive.to_arrow()
    for row in rows:
        for axes in row["extents"].values():
            axes.update({axis: {"min": least, "max": greatest} for axis, (least, greatest) in axes.items()})
        if not row["extents"]:
            del row["extents"]
    assert records(arrow.to_pylist(), arrow.schema) == rows
    assert records(archive.to_polars().to_dicts(), arrow.schema) == rows


@pytest.mark.parametrize("command", ["compile", "motion", "plc", "stats"])
def test_files(command: str, folder: Path) -> None:
    """What the command writes is what the package gives; its last batch tells that it is whole."""
    shutil.copytree(ROOT / "docs/guide/examples/contour", folder, dirs_exist_ok=True)
    assert run(command, "contour.nc", "--format", "arrow", "-o", "out.arrow", cwd=folder).returncode == 0
    made = getattr(cnc872c, command)("contour.nc")
    expected = (made.blocks if command == "motion" else made).to_arrow()
    with pyarrow.ipc.open_stream(folder / "out.arrow") as reader:
        batches = [(batch, metadata) for batch, metadata in reader.iter_batches_with_custom_metadata()]
    table = pyarrow.Table.from_batches([batch for batch, _ in batches])
    assert table.schema.equals(expected.schema, check_metadata=True)
    assert table.to_pylist() == expected.to_pylist()
    assert polars.read_ipc_stream(folder / "out.arrow").to_dicts() == polars.DataFrame(expected).to_dicts()
    last, metadata = batches[-1]
    assert last.num_rows == 0
    end = json.loads(metadata[b"cnc872c.end"])
    assert end["kind"] in ("end", "total")
    assert command != "stats" or end["programs"] == 1
    (folder / "bad.nc").write_text(FAULTY)
    refused = run(command, "bad.nc", "--format", "arrow", "-o", "bad.arrow", cwd=folder)
    assert (refused.returncode, (folder / "bad.arrow").exists()) == ((0, True) if command == "stats" else (1, False))


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
    signals = cnc872c.plc(text=WHOLE, signals=["BLK.AxNC[0]", "BLK.AxNC[3]"]).to_arrow().schema
    assert [signals.field(f"BLK.AxNC[{at}]").metadata for at in (0, 3)] == [{b"unit": b"mm"}, {b"unit": b"deg"}]
    facts = cnc872c.stats(text=WHOLE).to_arrow().schema
    assert facts.field("extents_all_x_min").metadata == {b"unit": b"mm"}


def test_nothing_is_copied() -> None:
    """polars and pyarrow see the same numbers at the same address."""
    blocks = cnc872c.compile(text="%1\nN10 G90 G00 X0\nN20 G01 X5 F100\nN30 M30")
    first, second = (pyarrow.table(blocks)["x"].chunk(0).buffers()[1].address for _ in range(2))
    assert first == second
    series = polars.DataFrame(blocks)["x"]
    assert series.to_list() == [0.0, 5.0, 5.0]
