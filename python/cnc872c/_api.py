"""The functions of the package."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypedDict, overload

from . import _native
from ._findings import Finding, Report
from ._options import At, Options, Path, place, plain, program, programs
from ._records import Block, Facts, Move, Step
from ._tables import R, Table

if TYPE_CHECKING:
    from typing_extensions import Unpack


class _Executed(Table[R]):
    """Records of an executed program, between its first record and its last one."""

    program: dict[str, Any]
    """The first record: what the others were made from and for; of steps also the names of the signals."""
    files: list[str]
    """The files that blocks come from, by index."""
    end: dict[str, Any]
    """The last record: how the program ended; of blocks also their number, and the path."""
    findings: list[Finding]
    """Warnings."""

    def __init__(self, table: _native.Table, findings: list[Finding]) -> None:
        super().__init__(table)
        self.program = json.loads(table.first())
        self.files = [self.program["name"], *(record["name"] for record in json.loads(table.files()))]
        self.end = json.loads(table.last())
        self.findings = findings


class Blocks(_Executed[Block]):
    """The executed blocks of a program: records :class:`Block`, and its columns."""

    _record = Block


class Moves(Table[Move]):
    """The executed blocks of a program with their times: records :class:`Move`, and its columns."""

    _record = Move


class Steps(_Executed[Step]):
    """Steps of a program as the PLC sees them: records :class:`Step`, and its columns, one a signal."""

    _record = Step


class Archive(Table[Facts]):
    """Facts about programs: records :class:`Facts`, and its columns."""

    _record = Facts


class Motion:
    """How the machine moves through a program, and how long it takes."""

    machine: dict[str, Any]
    """The machine that the times are of."""
    total: dict[str, Any]
    """Sums over the program."""
    blocks: Moves
    """The blocks with their times."""
    findings: list[Finding]
    """Warnings."""

    def __init__(self, table: _native.Table, findings: list[Finding]) -> None:
        self.machine = json.loads(table.first())
        self.total = json.loads(table.last())
        self.blocks = Moves(table)
        self.findings = findings

    @property
    def time_s(self) -> float:
        """How long the program takes, in seconds."""
        return float(self.total["time_s"])

    @property
    def lower_bound(self) -> bool:
        """Some blocks have no known time: the program takes at least this."""
        return bool(self.total.get("lower_bound", False))

    def __repr__(self) -> str:
        least = "at least " if self.lower_bound else ""
        return f"<Motion of {len(self.blocks)} blocks, {least}{self.time_s} s>"


class Place(TypedDict):
    """A place of a program."""

    seq: int
    n: int
    file: int
    line: int
    column: int
    calls: list[dict[str, Any]]
    after: bool


class _State(TypedDict):
    kind: str
    schema: str
    generator: str
    name: str
    place: Place
    g: list[int | None]
    m: list[int | None]
    unknown: dict[str, str]
    parameters: dict[str, float]
    written: dict[str, dict[str, int]]
    counters: list[dict[str, int]]
    progress: dict[str, Any]


class State(_State, total=False):
    """What holds at a place of a program, as ``cnc872c schema state`` says. What is absent is left out."""

    gear: int
    position: dict[str, float]
    feed: float
    feed_unit: str
    feed_scale: float
    s: float
    t: float
    tool: float
    h: float
    p: float
    d: float
    length_correction: str
    dynamic_set: int
    continuous_mode: bool


class _Change(TypedDict):
    kind: str
    count: int
    old_blocks: list[list[int]]
    new_blocks: list[list[int]]


class Change(_Change, total=False):
    """What differs. What is absent is left out."""

    tool: float
    what: str
    old: float | str
    new: float | str
    delta: float


class Comparison(TypedDict):
    """What two programs do differently, as ``cnc872c schema compare`` says."""

    kind: str
    schema: str
    generator: str
    same: bool
    old: dict[str, Any]
    new: dict[str, Any]
    changes: list[Change]


def check(
    path: Path | Iterable[Path] | None = None,
    *,
    text: str | bytes | None = None,
    deny_warnings: bool = False,
    allow_empty: bool = False,
    **options: Unpack[Options],
) -> Report:
    """Checks programs, macrocycles, or folders of them: everything that ``cnc872c check`` finds.

    ``text`` replaces the program at ``path``; without a path its file is ``"-"``. With ``deny_warnings`` a report with warnings is
    not ``ok``; with ``allow_empty`` a folder may be without programs.

    >>> import cnc872c
    >>> report = cnc872c.check(text="%1\\nN10 G01 X5,5 F100\\nN20 M30")
    >>> report.ok
    False
    >>> for finding in report.findings:
    ...     print(finding)
    -:2:9: error[E0104]: a decimal comma
    >>> report.findings[0].fixes[0].title
    'write `X5.5`'
    """
    found = _native.check(*programs(path, text), plain(options), allow_empty)
    return Report.from_json(found, deny_warnings)


def compile(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    first: int = 0,
    limit: int | None = None,
    **options: Unpack[Options],
) -> Blocks:
    """Executes a program, and gives its blocks: the records of ``cnc872c compile``, from the one with ``seq`` ``first`` on,
    at most ``limit``.

    Raises ProgramError when the program has errors.

    >>> import cnc872c
    >>> blocks = cnc872c.compile(text="%1\\nN10 G00 X0 Y0\\nN20 G01 X3 Y4 F100\\nN30 M30")
    >>> [block.n for block in blocks]
    [10, 20, 30]
    >>> blocks[1].motion.length_mm
    5.0
    >>> blocks[1].position
    {'X': 3.0, 'Y': 4.0}
    >>> print(blocks[1].s)
    None
    >>> blocks.end["path_mm"]
    5
    >>> blocks.to_polars().select("n", "motion_type", "x").rows()
    [(10, 'rapid', 0.0), (20, 'linear', 3.0), (30, None, 3.0)]
    """
    table, report = _native.compile(program(path, text), plain(options), first, limit)
    return Blocks(table, Report.from_json(report).findings)


def motion(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    phases: bool = False,
    set: Mapping[str, object] | None = None,
    **options: Unpack[Options],
) -> Motion:
    """How the machine moves through a program, and how long it takes: the records of ``cnc872c motion``.

    ``set`` tries other values: ``{"accel-mm-s2": 800}``. With ``phases`` the blocks have the phases of their motions.

    >>> import cnc872c
    >>> motion = cnc872c.motion(text="%1\\nN10 G90 G00 X0\\nN20 G01 X100 F600\\nN30 M30")
    >>> motion.time_s
    10.02
    >>> motion.blocks[1].peak
    600.0
    >>> motion.blocks.to_arrow().schema.field("duration_s").metadata
    {b'unit': b's'}
    """
    tried = {} if set is None else dict(set)
    table, report = _native.motion(program(path, text), plain(options), phases, tried)
    return Motion(table, Report.from_json(report).findings)


def plc(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    signals: str | Iterable[str] | None = None,
    compat: bool = False,
    find: str | None = None,
    first: int = 0,
    limit: int | None = None,
    **options: Unpack[Options],
) -> Steps:
    """What a program asks of the PLC, step by step: the signals of ``cnc872c plc``.

    With ``find`` only the steps in which a condition holds, with the signals that it names, instead of ``signals``.

    >>> import cnc872c
    >>> text = "%1\\nN10 G90 G00 X0 T5\\nN20 M03 S500\\nN30 M30"
    >>> steps = cnc872c.plc(text=text, signals=["BLK.T", "BLK.SpindleSpeed"])
    >>> steps[1]["BLK.SpindleSpeed"]
    500.0
    >>> [step.n for step in cnc872c.plc(text=text, find="BLK.TProg")]
    [10]
    """
    names = signals if signals is None or isinstance(signals, str) else ",".join(signals)
    wanted = {"signals": names, "compat": compat, "find": find, "first": first, "limit": limit}
    table, report = _native.plc(program(path, text), plain(options), wanted)
    return Steps(table, Report.from_json(report).findings)


def state(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    **options: Unpack[At],
) -> State:
    """What holds at a place of a program: the document of ``cnc872c state``.

    :class:`At` names the place. Raises PlaceError when there is no such place.

    >>> import cnc872c
    >>> state = cnc872c.state(text="%1\\nN10 G90 G00 X0\\nN20 G01 X5 F100\\nN30 M30", n=20, after=True)
    >>> state["position"], state["feed"]
    ({'X': 5}, 100)
    """
    found: State = json.loads(_native.state(program(path, text), *place(options)))
    return found


def restart(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    safe: float | None = None,
    clearance: float = 2.0,
    all_m: bool = False,
    **options: Unpack[At],
) -> bytes:
    """A program that starts at a place of another one, in its encoding: what ``cnc872c restart`` writes.

    :class:`At` names the place. The tool crosses at ``safe``; rapid ends ``clearance`` mm above the place. With ``all_m`` M
    functions of groups 10 to 14 are repeated too. Raises PlaceError when there is no such place, or the program cannot start there.

    >>> import cnc872c
    >>> text = "%1\\nN10 G54 G90 T1 M06\\nN20 S900 M03\\nN30 G00 X0 Z50\\nN40 G01 Z-1 F100\\nN50 X30\\nN60 G00 Z50\\nN70 M30"
    >>> started = cnc872c.restart(text=text, n=50)
    >>> cnc872c.check(text=started).ok
    True
    """
    start = {"safe": safe, "clearance": clearance, "all_m": all_m}
    return _native.restart(program(path, text), *place(options), start)


class RestartPlace(TypedDict):
    """A place at which a program can start."""

    seq: int
    n: int
    file: str | None
    line: int
    pass_: int
    tool: float | None
    changes_tool: bool


def restart_places(
    path: Path | None = None,
    *,
    text: str | bytes | None = None,
    safe: float | None = None,
    clearance: float = 2.0,
    **options: Unpack[Options],
) -> list[RestartPlace]:
    """The tool changes and rapids at which a program can start: those of ``cnc872c restart --list``.

    >>> import cnc872c
    >>> text = "%1\\nN10 G54 G90 T1 M06\\nN20 S900 M03\\nN30 G00 X0 Z50\\nN40 G01 Z-1 F100\\nN50 X30\\nN60 G00 Z50\\nN70 M30"
    >>> [place["n"] for place in cnc872c.restart_places(text=text, safe=50)]
    [10, 30, 60]
    """
    start = {"safe": safe, "clearance": clearance, "all_m": False}
    places, more = _native.restart_places(program(path, text), plain(options), start)
    if more and not places:
        warnings.warn(f"with `safe` there would be {more} places", stacklevel=2)
    return [
        RestartPlace(seq=seq, n=n, file=file, line=line, pass_=pass_, tool=tool, changes_tool=changes)
        for seq, n, file, line, pass_, tool, changes in places
    ]


@overload
def format(path: Path | None = None, *, text: str, **options: Unpack[Options]) -> str: ...


@overload
def format(path: Path | None = None, *, text: bytes | None = None, **options: Unpack[Options]) -> bytes: ...


def format(
    path: Path | None = None, *, text: str | bytes | None = None, **options: Unpack[Options]
) -> str | bytes:
    """A program in one layout: what ``cnc872c format`` makes of it, a ``str`` of a ``str``, else bytes in its encoding. The file
    stays as it is.

    Raises ProgramError when a finding keeps the program from being formatted. Lines that cannot be read stay as they are, with a
    warning.

    >>> import cnc872c
    >>> print(cnc872c.format(text="%1\\nN10 G1X5.5F100\\nN20 M30\\n"), end="")
    %1
    N10 G01 X5.5 F100
    N20 M30
    """
    named, given = program(path, text)
    made, left = _native.format((named, given), plain(options))
    if left:
        warnings.warn(f"{named}: {left} lines that cannot be read stay as they are", stacklevel=2)
    return made.decode() if isinstance(text, str) else made


def compare(
    old: Path | None = None,
    new: Path | None = None,
    *,
    old_text: str | bytes | None = None,
    new_text: str | bytes | None = None,
    tolerance: float = 0.001,
    feed_tolerance: float = 0.0,
    parameters: bool = False,
    partial: bool = False,
    **options: Unpack[Options],
) -> Comparison:
    """What two programs do differently: the document of ``cnc872c compare``.

    ``tolerance`` is in mm, ``feed_tolerance`` in percent. With ``partial`` programs with errors are compared as far as they
    are executed.

    >>> import cnc872c
    >>> old = "%1\\nN10 G90 G00 X0\\nN20 G01 X5 F100\\nN30 M30"
    >>> comparison = cnc872c.compare(old_text=old, new_text=old.replace("F100", "F120"))
    >>> comparison["same"]
    False
    >>> [(change["kind"], change["old"], change["new"]) for change in comparison["changes"]]
    [('feed', 100, 120)]
    """
    differences = {
        "tolerance": tolerance,
        "feed_tolerance": feed_tolerance,
        "parameters": parameters,
        "partial": partial,
    }
    sides = program(old, old_text), program(new, new_text)
    made: Comparison = json.loads(_native.compare(*sides, plain(options), differences))
    return made


def stats(
    path: Path | Iterable[Path] | None = None,
    *,
    text: str | bytes | None = None,
    cache: Path | None = None,
    **options: Unpack[Options],
) -> Archive:
    """Facts about programs, a row each: those of ``cnc872c stats``. Programs with errors have rows too.

    With a folder ``cache`` another call reads only what changed.

    >>> import cnc872c
    >>> archive = cnc872c.stats(text="%5\\nN10 G90 G00 X0 T3\\nN20 M06\\nN30 G01 X100 F600\\nN40 M30")
    >>> archive[0].number, archive[0].tools, archive[0].m
    (5, [3], [6, 30])
    """
    folder = None if cache is None else os.fspath(cache)
    return Archive(_native.stats(*programs(path, text), plain(options), folder))
