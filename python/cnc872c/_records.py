"""The records of tables, field by field: as the JSON Schemas of the streams have them (``cnc872c schema blocks``)."""

from __future__ import annotations

from typing import Any, Literal, TypedDict

from ._tables import Field, Record, by_axis, cell, group


Call = TypedDict(
    "Call",
    {"by": str, "l": int, "file": int, "n": int, "line": int, "pass": int, "of": int},
)
"""A call on the way to a block: by which function, what was called, where the calling block is (index of its file, its
number and line), which pass this is, and of how many."""


class Jump(Record):
    """The jump that is taken at the end of a block."""

    __slots__ = ()

    to: int = cell()
    """The block jumped to."""
    left: int | None = cell()
    """The counter after lowering; None when uncounted."""


class Motion(Record):
    """The motion of a block."""

    __slots__ = ()

    type: Literal["rapid", "linear", "arc_cw", "arc_ccw", "thread", "reference"] = cell()
    """What kind: G00, G01, G02, G03, G33, G30."""
    axes: list[str] | None = cell()
    """Axes that move, in machine order."""
    start: dict[str, float] | None = by_axis("start_")
    """Where these axes stand before, as far as known."""
    delta: dict[str, float] | None = by_axis("delta_")
    """Distances of axes moved by G91 from an unknown position."""
    length_mm: float | None = cell()
    """BlockLen in mm."""
    length_deg: float | None = cell()
    """BlockLen in degrees, when rotary axes only move."""
    length_missing: str | None = cell()
    """Why there is no length."""
    plane: str | None = cell()
    """Of an arc: its axes, as XY."""
    center: dict[str, float] | None = by_axis("center_")
    """Of an arc: its centre."""
    radius_mm: float | None = cell()
    """Of an arc: its radius."""
    sweep_deg: float | None = cell()
    """Of an arc: how far it goes round."""
    spindle_axis: str | None = cell()
    """The axis that the spindle moves as, under M19."""


class Data(Record):
    """Words that are data."""

    __slots__ = ()

    g: int = cell()
    """G92 and its like."""
    origin: int | None = cell()
    """Which zero point."""
    d: int | None = cell()
    """Which tool correction."""
    values: dict[str, float] | None = cell()
    """The values, by letter."""


class Block(Record):
    """An executed block."""

    __slots__ = ()
    _kind = "block"

    seq: int = cell()
    """0, 1, 2 …"""
    n: int = cell()
    """Block number."""
    file: int = cell()
    """Index of the file."""
    line: int = cell()
    """Line of the N, from 1."""
    column: int = cell()
    """Column of the N in characters, from 1."""
    calls: list[Call] | None = cell()
    """How execution got here, outermost first."""
    jump: Jump | None = group(Jump, "jump_", "jump_to")
    """The jump that is taken at the end of this block."""
    skippable: bool = cell()
    """The block carries / (and was executed)."""
    first_block: bool = cell()
    """First executed block of the program."""
    last_block: bool = cell()
    """Last executed block of the program."""
    g: list[int | None] = cell()
    """For each G group what is in force in this block."""
    g_set: list[int] | None = cell()
    """G functions written in this block, in written order."""
    m: list[int | None] = cell()
    """By group, 0 always None: what is in force after this block."""
    m_set: list[int] | None = cell()
    """M functions written in this block, in written order."""
    m_changed: list[int] | None = cell()
    """Groups with a change bit, ascending."""
    m_at_stop: dict[str, int] | None = cell()
    """Values of groups 2, 5, 6 while the program stands."""
    break_cont: bool = cell()
    """Some M of this block breaks continuous motion at its start."""
    break_cont_end: bool = cell()
    """Some M of this block breaks continuous motion at its end."""
    change_pos: bool = cell()
    """Some M of this block moves the machine."""
    gear: int | None = cell()
    """1–4: M41–M44 in force, or what M40 chose."""
    motion: Motion | None = group(Motion, "motion_", "motion_type")
    """The motion of the block."""
    position: dict[str, float] | None = by_axis("")
    """Every axis whose programmed position is known, after the block."""
    feed: float | None = cell()
    """F, as programmed."""
    feed_unit: str | None = cell()
    """What it counts in this block."""
    feed_scale: float | None = cell()
    """0.01 under M37."""
    tool: int | None = cell()
    """The tool in the spindle: T at the last M06."""
    rev_feed: bool = cell()
    """The feed counts per revolution."""
    const_cut_speed: bool = cell()
    """The cutting speed is constant."""
    s: int | None = cell()
    """Speed of the spindle, rev/min."""
    t: int | None = cell()
    """T in force."""
    h: float | None = cell()
    """H in force."""
    p: int | None = cell()
    """P in force."""
    d: int | None = cell()
    """D in force."""
    t_set: bool = cell()
    """T is written in this block."""
    h_set: bool = cell()
    """H is written in this block."""
    p_set: bool = cell()
    """P is written in this block."""
    d_set: bool = cell()
    """D is written in this block."""
    s_set: bool = cell()
    """S is written in this block."""
    f_set: bool = cell()
    """F is written in this block."""
    length_correction: str | None = cell()
    """The four digits of & in force."""
    dwell_s: float | None = cell()
    """Delay, in seconds."""
    stop: bool = cell()
    """M00."""
    cond_stop: bool = cell()
    """M01."""
    continuous_mode: bool = cell()
    """G23 in force."""
    dynamic_set: int | None = cell()
    """Under G23: 1, until G23 with I chooses another, 1–4."""
    opaque_call: int | None = cell()
    """The macrocycle that it calls at its end and that only the machine has: the axes that it may move are unknown after it."""
    data: Data | None = group(Data, "data_", "data_g")
    """Words that are data."""
    words: dict[str, float] | None = cell()
    """Words as written, by letter."""
    params: dict[str, float] | None = cell()
    """Parameters this block wrote, with their values after its arithmetic."""
    comments: list[str] | None = cell()
    """Texts of its comments."""


class Joint(Record):
    """A joint with the motion before."""

    __slots__ = ()

    with_: int | None = Field(lambda record, name: record._cells.value(name, record._row), "with", "with")  # type: ignore[assignment]
    """``seq`` of the motion before; None at the first motion."""
    angle_deg: float | None = cell()
    """Angle between the tangents."""
    continuous: bool = cell()
    """It is passed continuously."""
    broken_by: str | None = cell()
    """What breaks it."""
    feed: float = cell()
    """Velocity at the joint, mm/min."""
    limited_by: str | None = cell()
    """What gives this velocity."""
    dot: Literal["yellow", "red"] | None = cell()
    """The dot that the control shows."""


class Move(Record):
    """An executed block with its times. Velocities in mm/min, or deg/min where only rotary axes move."""

    __slots__ = ()
    _kind = "block"

    seq: int = cell()
    """As in the block stream."""
    n: int = cell()
    """Block number."""
    file: int = cell()
    """Index of the file, as in the block stream."""
    line: int = cell()
    """Line of the N, from 1."""
    start_s: float = cell()
    """When it starts, from program start."""
    duration_s: float = cell()
    """How long it takes."""
    programmed: float | None = cell()
    """Programmed velocity."""
    cap: float | None = cell()
    """Greatest velocity in the block."""
    cap_by: str | None = cell()
    """What gives it."""
    start: float | None = cell()
    """Velocity at its start."""
    peak: float | None = cell()
    """The greatest velocity that it reaches."""
    end: float | None = cell()
    """Velocity at its end."""
    time_dist_s: float | None = cell()
    """Motion time from its start to the end of its stretch."""
    merged: bool = cell()
    """It is part of a piece whose record is another one."""
    piece_mm: float | None = cell()
    """Length of the piece that other blocks are joined to."""
    joint: Joint | None = group(Joint, "joint_", "joint_feed")
    """The joint with the motion before."""
    phases: list[list[float]] | None = cell()
    """Duration in s, start velocity in mm/s, acceleration in mm/s², jerk in mm/s³."""


class Step(Record):
    """A step as the PLC sees it. The values of signals are asked for by name: ``step["BLK.T"]``."""

    __slots__ = ()
    _kind = "step"

    seq: int = cell()
    """The executed block, as in the block stream."""
    n: int = cell()
    """Block number."""
    file: int = cell()
    """Index of the file."""
    line: int = cell()
    """Line of the N, from 1."""
    start_s: float | None = cell()
    """When it starts, in seconds from program start; with [motion]."""
    stop: bool = cell()
    """The program stands."""

    def __getitem__(self, signal: str) -> float | None:
        if signal in self._fields or signal not in self._cells._columns:
            raise KeyError(signal)
        value: float | None = self._cells.value(signal, self._row)
        return value

    @property
    def signals(self) -> dict[str, float | None]:
        """The values of all chosen signals."""
        names = (name for name in self._cells._columns if name not in self._fields)
        return {name: self._cells.value(name, self._row) for name in names}

    def to_dict(self) -> dict[str, Any]:
        return {**super().to_dict(), "signals": self.signals}


class Facts(Record):
    """A program of an archive. What execution gives is there only when the program was executed without errors."""

    __slots__ = ()

    path: str = cell()
    """The file, as named or found."""
    hash: str | None = cell()
    """SHA-256 of its bytes, hexadecimal."""
    number: int | None = cell()
    """The number after %."""
    title: str | None = cell()
    """The title."""
    dialect: str | None = cell()
    """The control that the program seems to be for."""
    encoding: str | None = cell()
    """How its bytes are read."""
    blocks: int = cell()
    """Blocks written in the file."""
    executed: int | None = cell()
    """Blocks executed."""
    time_s: float | None = cell()
    """Time of the program in seconds, as ``motion`` estimates it."""
    lower_bound: bool = cell()
    """Some blocks have no known time: the time is at least this."""
    path_mm_by_type: dict[str, float] | None = cell()
    """Path in mm by type of motion."""
    extents: dict[str, dict[str, list[float]]] = Field(lambda record, _: _extents(record))  # type: ignore[assignment]
    """How far motions reach: working motions and all, by axis, least and greatest."""
    tools: list[int] | None = cell()
    """Tools: T written, and tools in the spindle."""
    m: list[int] | None = cell()
    """M functions used."""
    g: list[int] | None = cell()
    """G functions used."""
    h: list[float] | None = cell()
    """H used."""
    subprograms: list[int] | None = cell()
    """Subprograms that run."""
    macrocycles: list[int] | None = cell()
    """Macrocycles that run."""
    parameters: list[str] | None = cell()
    """Parameters that are read before the program gives them a value."""
    findings: dict[str, int] | None = cell()
    """How many findings of each code there are."""


def _extents(record: Record) -> dict[str, dict[str, list[float]]]:
    extents: dict[str, dict[str, list[float]]] = {}
    for part in ("working", "all"):
        for letter in "xyzabcuvw":
            name = f"extents_{part}_{letter}"
            least = record._cells.value(f"{name}_min", record._row)
            if least is not None:
                greatest = record._cells.value(f"{name}_max", record._row)
                extents.setdefault(part, {})[letter.upper()] = [least, greatest]
    return extents
