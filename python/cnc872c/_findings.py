"""Findings, as the JSON form ``cnc872c.diagnostics/1`` has them."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Literal


@dataclass(frozen=True)
class Edit:
    """One replacement in a file."""

    file: str
    """The file."""
    line: int
    """The line where it begins, from 1."""
    column: int
    """The column where it begins, in characters, from 1."""
    end_line: int
    """The line of the first character behind it."""
    end_column: int
    """The column of the first character behind it."""
    start: int
    """Bytes of the file before it."""
    end: int
    """Bytes of the file before the first character behind it."""
    text: str
    """What stands there afterwards."""


@dataclass(frozen=True)
class Fix:
    """A change that fixes what a finding reports."""

    title: str
    """What it does."""
    certain: bool
    """Whether it is what was meant beyond doubt, so that ``cnc872c check --fix`` applies it."""
    edits: list[Edit]
    """Replacements that do not overlap."""


@dataclass(frozen=True)
class Label:
    """Another place that explains a finding."""

    file: str
    """The file."""
    line: int
    """The line, from 1."""
    column: int
    """The column in characters, from 1."""
    message: str
    """What it shows."""


@dataclass(frozen=True)
class CallSite:
    """A call on the way to a finding."""

    by: str
    """G71, G72, or the cycle function that calls a macrocycle."""
    l: int  # noqa: E741
    """What was called."""
    file: str
    """The file of the calling block."""
    n: int
    """The number of the calling block."""
    line: int
    """The line of the calling block, from 1."""


@dataclass(frozen=True)
class Finding:
    """Something that is wrong, or may be, at a place of a file.

    As text it is what compilers write: ``part.nc:5:9: error[E0104]: a decimal comma``.
    """

    code: str
    """E0104: ``cnc872c explain E0104`` tells more."""
    name: str
    """decimal-comma"""
    severity: Literal["error", "warning"]
    """How serious it is."""
    message: str
    """What is wrong."""
    file: str
    """The file, as named or found; ``-`` for a text in memory."""
    line: int
    """The line, from 1."""
    column: int
    """The column in characters, from 1."""
    end_line: int
    """The line of the first character behind it."""
    end_column: int
    """The column of the first character behind it."""
    help: str | None = None
    """What to write instead."""
    notes: list[str] = field(default_factory=list)
    """Why."""
    labels: list[Label] = field(default_factory=list)
    """Other places that explain it."""
    calls: list[CallSite] = field(default_factory=list)
    """The calls that led there, outermost first."""
    fixes: list[Fix] = field(default_factory=list)
    """Changes, each of which may fix it; the certain one comes first."""

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity}[{self.code}]: {self.message}"


def _edit(item: dict[str, Any]) -> Edit:
    start, end = item["span"]["start"], item["span"]["end"]
    return Edit(
        file=item["file"],
        line=start["line"],
        column=start["column"],
        end_line=end["line"],
        end_column=end["column"],
        start=start["offset"],
        end=end["offset"],
        text=item["text"],
    )


def _label(item: dict[str, Any]) -> Label:
    start = item["span"]["start"]
    return Label(item["file"], start["line"], start["column"], item["message"])


def _finding(item: dict[str, Any]) -> Finding:
    start, end = item["span"]["start"], item["span"]["end"]
    return Finding(
        code=item["code"],
        name=item["name"],
        severity=item["severity"],
        message=item["message"],
        file=item["file"],
        line=start["line"],
        column=start["column"],
        end_line=end["line"],
        end_column=end["column"],
        help=item.get("help"),
        notes=item["notes"],
        labels=[_label(label) for label in item["labels"]],
        calls=[CallSite(call["by"], call["l"], call["file"], call["n"], call["line"]) for call in item["calls"]],
        fixes=[
            Fix(fix["title"], fix["certain"], [_edit(edit) for edit in fix["edits"]]) for fix in item["fixes"]
        ],
    )


@dataclass(frozen=True)
class Report:
    """What was found in one or more programs."""

    files: list[str]
    """The programs, as named or found."""
    findings: list[Finding]
    """The findings, sorted by file and place. Of one code and file there are at most 10,000 here."""
    errors: int
    """How many errors there are, also those beyond."""
    warnings: int
    """How many warnings there are, also those beyond."""
    by_code: dict[str, int]
    """How many there are of each code."""
    not_executed: dict[str, str]
    """The programs that were not executed, and why: what only execution finds is not known of them."""
    deny_warnings: bool = False
    """Whether warnings count as errors."""

    @property
    def ok(self) -> bool:
        """Whether there are no errors."""
        return self.errors == 0 and not (self.deny_warnings and self.warnings)

    def __bool__(self) -> bool:
        raise TypeError("`ok` tells whether there are no errors")

    @classmethod
    def from_json(cls, text: str, deny_warnings: bool = False) -> Report:
        """Reads the form ``cnc872c.diagnostics/1``, which also ``cnc872c check --format json`` writes."""
        document = json.loads(text)
        summary = document["summary"]
        return cls(
            files=document["files"],
            findings=[_finding(item) for item in document["diagnostics"]],
            errors=summary["errors"],
            warnings=summary["warnings"],
            by_code=summary["by_code"],
            not_executed={item["file"]: item["reason"] for item in summary["not_executed"]},
            deny_warnings=deny_warnings,
        )
