"""Part programs of the CNC8x6, CNC8x9 and CNC872 machine controls.

===========  ==========================================================================
check        everything that is wrong with programs
compile      the blocks that the control will execute
motion       how the machine moves, and how long it takes
plc          what a program asks of the PLC
state        what holds at a place of a program
restart      a program that starts at a place of another one
compare      what two programs do differently
format       one layout for programs
stats        facts about the programs of an archive
===========  ==========================================================================

All of them take a path or a ``text``, and the keyword arguments of :class:`Options`. A file that cannot be read raises
``OSError``, a program with errors :class:`ProgramError`, wrong configuration :class:`ConfigError`. Other threads run
meanwhile, and Ctrl-C stops a long call.

>>> import cnc872c
>>> cnc872c.check(text="%1\\nN10 G00 X0\\nN20 M30").ok
True
"""

from ._api import (
    Archive,
    Blocks,
    Change,
    Comparison,
    Motion,
    Moves,
    Place,
    RestartPlace,
    State,
    Steps,
    check,
    compare,
    compile,
    format,
    motion,
    plc,
    restart,
    restart_places,
    state,
    stats,
)
from ._errors import ConfigError, Error, PlaceError, ProgramError
from ._findings import CallSite, Edit, Finding, Fix, Label, Report
from ._native import __version__
from ._options import At, Options
from ._records import Block, Call, Facts, Move, Step

__all__ = [
    "Archive",
    "At",
    "Block",
    "Blocks",
    "Call",
    "CallSite",
    "Change",
    "Comparison",
    "ConfigError",
    "Edit",
    "Error",
    "Facts",
    "Finding",
    "Fix",
    "Label",
    "Motion",
    "Move",
    "Moves",
    "Options",
    "Place",
    "PlaceError",
    "ProgramError",
    "Report",
    "RestartPlace",
    "State",
    "Step",
    "Steps",
    "__version__",
    "check",
    "compare",
    "compile",
    "format",
    "motion",
    "plc",
    "restart",
    "restart_places",
    "state",
    "stats",
]
