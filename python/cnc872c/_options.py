"""The options that all functions have."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, Literal, TypedDict, Union

Path = Union[str, "os.PathLike[str]"]
"""A path."""


class Options(TypedDict, total=False):
    """Keyword arguments of all functions: what the command line says over the project file."""

    config: Path | Mapping[str, Any] | None
    """The project file, or what it would hold; relative paths in a mapping begin at the working folder. By default the
    ``cnc872c.toml`` in the folder of the program or above it."""
    dialect: Literal["cnc872", "cnc8x6", "cnc8x9"] | None
    """The control."""
    channel_config: Path | None
    """The ChannelConfig of the machine."""
    macrocycles: Path | Iterable[Path] | None
    """Folders of macrocycles."""
    param: Mapping[str, float | str] | None
    """Values of parameters at program start: ``{"R10": 5}``."""
    block_skip: bool | None
    """Leave out skippable blocks."""
    optional_stop: bool | None
    """M01 stops."""
    encoding: Literal["utf-8", "cp852", "windows-1250", "iso-8859-2", "kamenicky"] | None
    """The encoding of what is not UTF-8."""
    max_blocks: int | None
    """Most blocks that are executed."""
    allow: str | Iterable[str] | None
    """Codes or names of warnings that are not wanted. ``deny`` wins over ``warn``, and ``warn`` over this."""
    warn: str | Iterable[str] | None
    """Codes or names of findings that are warnings."""
    deny: str | Iterable[str] | None
    """Codes or names of warnings that are errors."""
    lang: Literal["en", "cs"] | None
    """The language of findings."""


class At(Options, total=False):
    """A place of a program, named by one of the first five, beside the options of all functions."""

    n: int | None
    """The number of a block."""
    line: int | None
    """The line of a block."""
    seq: int | None
    """The executed block, as the stream counts them."""
    time: float | None
    """Seconds after program start."""
    at_tool: int | None
    """The tool that an M06 changes to."""
    file: str | None
    """The macrocycle that the number or line is of."""
    pass_: int | None
    """Which execution of the block is meant, from 1."""
    after: bool
    """Behind the block instead of before it."""


def place(options: At) -> tuple[dict[str, Any], dict[str, Any]]:
    """Options and the place as the native half takes them."""
    rest: dict[str, Any] = dict(options)
    at = {name: rest.pop(name, None) for name in ("n", "line", "seq", "time", "at_tool")}
    if sum(value is not None for value in at.values()) != 1:
        raise TypeError("a place is one of n, line, seq, time, at_tool")
    more = {"file": rest.pop("file", None), "pass": rest.pop("pass_", None), "after": rest.pop("after", False)}
    return plain(rest), {**at, **more}


def plain(options: Mapping[str, object]) -> dict[str, Any]:
    """Options as the native half takes them: mappings are dictionaries."""
    made: dict[str, Any] = dict(options)
    for name in ("config", "param"):
        value = made.get(name)
        if isinstance(value, Mapping):
            made[name] = dict(value)
    return made


def program(path: Path | None, text: str | bytes | None) -> tuple[str, bytes | None]:
    """A program: its path, and the text that replaces it."""
    if path is None and text is None:
        raise TypeError("a path or a text is needed")
    named = "-" if path is None else os.fspath(path)
    return named, text.encode() if isinstance(text, str) else text


def programs(path: Path | Iterable[Path] | None, text: str | bytes | None) -> tuple[str | list[str], bytes | None]:
    """The same, or the paths of several programs."""
    if path is None or isinstance(path, (str, os.PathLike)):
        return program(path, text)
    if text is not None:
        raise TypeError("a text replaces one program")
    return [os.fspath(one) for one in path], None
