"""What all tests share."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

WHOLE = "%1\nN10 G90 G00 X0 Y0\nN20 G01 X3 Y4 F100\nN30 M30\n"
"""A program without findings."""

FAULTY = "%1\nN10 G01 X5,5 F100\nN20 M30\n"
"""A program with E0104."""

_LOOP = "%1\nN10 G90 G00 X0\nN20 G01 X1 F100\nN30 X0\nN40 G73 L20 Q9999\n"

LONG = _LOOP + "N50 G73 L20 Q9\nN60 M30\n"
"""A program of some 300,000 executed blocks."""

ENDLESS = _LOOP + "N50 G73 L20 Q9999\nN60 G73 L20 Q9999\nN70 G73 L20 Q9999\nN80 M30\n"
"""A program that nobody sees the end of."""


def run(*arguments: str, cwd: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """The command that the package brings."""
    command = [sys.executable, "-m", "cnc872c", *arguments]
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False)


def samples() -> list[Path]:
    """Every sample that may be a whole program."""
    found = []
    for folder in ("ok", "projects", "rules", "err"):
        for path in sorted((ROOT / "samples" / folder).rglob("*.nc")):
            if path.is_file() and not (path.stem[:1] in "Ll" and path.stem[1:].isdigit()):
                found.append(path)
    assert len(found) > 100, "the samples are gone"
    return found
