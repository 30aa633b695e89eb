"""The example with Ray makes the rows of `stats`, on several workers."""

from __future__ import annotations

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import cnc872c
import pyarrow.parquet
import pytest
from shared import ROOT, WHOLE


@pytest.mark.skipif(find_spec("ray") is None, reason="Ray is not installed")
def test_archive(folder: Path) -> None:
    archive = folder / "archive"
    for number in range(1, 301):
        part = archive / f"part{number % 3}"
        part.mkdir(parents=True, exist_ok=True)
        (part / f"{number}.nc").write_text(WHOLE.replace("%1", f"%{number}").replace("X3", f"X{number}"))
        (part / "L9001.nc").write_text("N10 G79 L9001\nN20 M09 G70\n")
    script = ROOT / "python/examples/archive_ray.py"
    subprocess.run([sys.executable, script, archive, folder / "facts"], check=True, timeout=300, cwd=folder)
    made = pyarrow.parquet.read_table(folder / "facts").to_pylist()
    expected = cnc872c.stats(archive).to_arrow().to_pylist()
    assert len(made) == 300
    assert sorted(made, key=lambda row: row["path"]) == sorted(expected, key=lambda row: row["path"])
