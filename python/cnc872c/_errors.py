"""What functions raise."""

from __future__ import annotations

from ._findings import Finding, Report


class Error(Exception):
    """A program or its configuration is wrong.

    ``findings`` says what, at which place, and how it may be fixed.
    """

    findings: list[Finding]

    def __init__(self, message: str, findings: list[Finding] | None = None) -> None:
        super().__init__(message)
        self.findings = findings or []

    def __reduce__(self) -> tuple[type[Error], tuple[str, list[Finding]]]:
        return type(self), (str(self), self.findings)


class ProgramError(Error):
    """A program has errors, or was not executed to its end.

    >>> import cnc872c
    >>> try:
    ...     cnc872c.compile(text='%1\\nN10 G01 X5,5 F100\\nN20 M30')
    ... except cnc872c.ProgramError as error:
    ...     print(error)
    ...     print(error.findings[0].code)
    -:2:9: error[E0104]: a decimal comma
    E0104
    """


class ConfigError(Error, ValueError):
    """The project file, or an option in the place of one of its keys, is wrong.

    >>> import cnc872c
    >>> try:
    ...     cnc872c.check("part.nc", config={"dialect": "cnc900"})
    ... except cnc872c.ConfigError as error:
    ...     print(error.findings[0].code)
    E0702
    """


class PlaceError(Error, LookupError):
    """A program has no such place, executes it more than once, or cannot start there."""


def _message(report: Report, otherwise: str) -> str:
    errors = [finding for finding in report.findings if finding.severity == "error"]
    if not errors:
        return otherwise
    # Only so many findings are listed.
    more = report.errors - 1
    return f"{errors[0]} (and {more} more)" if more else str(errors[0])


def program_error(text: str) -> ProgramError:
    """The exception for findings as JSON."""
    report = Report.from_json(text)
    otherwise = str(report.findings[0]) if report.findings else "the program was not executed to its end"
    return ProgramError(_message(report, otherwise), report.findings)


def config_error(text: str) -> ConfigError:
    """The exception for findings as JSON."""
    report = Report.from_json(text)
    return ConfigError(_message(report, "the configuration is wrong"), report.findings)
