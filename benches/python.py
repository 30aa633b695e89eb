"""Times the Python package: a program from its file to a polars frame, beside nc-gcode-interpreter, and an archive.

    pip install . polars nc-gcode-interpreter
    cargo run --release --example generate -- cam 1000000 > cam.nc
    python benches/python.py cam.nc                     # frames
    python benches/python.py cam.nc --archive 100000    # also `stats` of so many programs of 500 blocks; 16 kB each

Each call is a process. The calls take turns, and the least figures count; on a busy machine look at the processor time.
The other reader gets the program without its title and the `*` at the end, which it does not know.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

FRAME = "import cnc872c, sys; frame = cnc872c.compile(sys.argv[1]).to_polars(); assert len(frame) > 0"
PEER = (
    "import nc_gcode_interpreter as peer, sys; "
    "frame, _ = peer.nc_to_dataframe(open(sys.argv[1])); assert len(frame) > 0"
)
START = "import cnc872c, polars"


def run(arguments: list[str]) -> tuple[float, float, float]:
    """Seconds, seconds of processor, megabytes of a process."""
    begin = time.perf_counter()
    null = os.open(os.devnull, os.O_WRONLY)
    to_nowhere = [(os.POSIX_SPAWN_DUP2, null, 1)]
    child = os.posix_spawn(sys.executable, [sys.executable, *arguments], os.environ, file_actions=to_nowhere)
    _, status, used = os.wait4(child, 0)
    os.close(null)
    assert status == 0, arguments
    return time.perf_counter() - begin, used.ru_utime + used.ru_stime, used.ru_maxrss / 1000


def show(name: str, runs: list[tuple[float, float, float]]) -> list[float]:
    least = [min(values) for values in zip(*runs, strict=True)]
    print(f"{name:<28} {least[0]:7.2f} s {least[1]:7.2f} s of processor {least[2]:6.0f} MB")
    return least


def archive(folder: Path, programs: int) -> None:
    """Writes programs that differ, 500 to a folder."""
    for number in range(programs):
        place = folder / f"{number // 500:03}"
        place.mkdir(exist_ok=True)
        lines = [f'%{number % 99_999 + 1} "PART {number}"', f"N1 G54 G17 G90 G94 T{number % 30 + 1} M06"]
        lines += ["N2 S1000 M03", "N3 G01 F600"]
        for block in range(4, 499):
            x, y, z = (number * 7 + block * 137) % 100_000, block * 71 % 80_000, block * 13 % 5_000
            lines.append(f"N{block} X{x / 1000:.3f} Y{y / 1000:.3f} Z-{z / 1000:.3f}")
        (place / f"{number}.nc").write_text("\n".join([*lines, "N499 G00 Z50 M05", "N500 M30", "*", ""]))


def main() -> None:
    """Runs what is asked for."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program", type=Path)
    arguments.add_argument("--archive", type=int, default=0)
    arguments.add_argument("--runs", type=int, default=5)
    given = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        lines = given.program.read_text().splitlines()
        peer = Path(folder, "peer.nc")
        peer.write_text("\n".join(line for line in lines if line[:1] not in "%*") + "\n")
        calls = {
            "start of Python, imports": ["-c", START],
            "to a frame": ["-c", FRAME, str(given.program)],
            "nc-gcode-interpreter": ["-c", PEER, str(peer)],
        }
        runs = {name: [] for name in calls}
        for _ in range(given.runs):
            for name, call in calls.items():
                runs[name].append(run(call))
        _, ours, theirs = (show(name, of) for name, of in runs.items())
        print(f"the other takes {theirs[0] / ours[0]:.1f} times as long, {theirs[1] / ours[1]:.1f} times the processor")
        if given.archive:
            Path(folder, "archive").mkdir()
            archive(Path(folder, "archive"), given.archive)
            stats = ["-m", "cnc872c", "stats", f"{folder}/archive", "--format", "json", "--cache", f"{folder}/cache"]
            show(f"stats of {given.archive}", [run(stats)])
            show("again", [run(stats) for _ in range(given.runs)])


if __name__ == "__main__":
    main()
