"""What functions take, give and raise."""

from __future__ import annotations

import pickle
import sys
from pathlib import Path

import cnc872c
import pytest
from shared import FAULTY, ROOT, WHOLE, run


def test_findings_are_those_of_the_command(folder: Path) -> None:
    (folder / "part.nc").write_text(FAULTY, newline="\n")
    report = cnc872c.check("part.nc")
    short = run("check", "part.nc", "--format", "short", cwd=folder).stdout.splitlines()
    assert [str(finding) for finding in report.findings] == short[: len(report.findings)]
    [finding] = report.findings
    assert (finding.code, finding.severity, finding.line, finding.column) == ("E0104", "error", 2, 9)
    [fix] = finding.fixes
    [edit] = fix.edits
    assert (fix.certain, edit.text, FAULTY[edit.start : edit.end]) == (True, "X5.5", "X5,5")
    assert (report.ok, report.errors, report.warnings, report.by_code) == (False, 1, 0, {"E0104": 1})
    with pytest.raises(TypeError):
        bool(report)


def test_several_programs_and_folders(folder: Path) -> None:
    (folder / "a.nc").write_text(WHOLE)
    (folder / "more").mkdir()
    (folder / "more" / "b.nc").write_text(FAULTY)
    assert cnc872c.check(["a.nc", folder / "more"]).files == ["a.nc", str(folder / "more" / "b.nc")]
    assert [facts.path for facts in cnc872c.stats(".")] == ["a.nc", str(Path("more/b.nc"))]
    (folder / "empty").mkdir()
    with pytest.raises(FileNotFoundError):
        cnc872c.check("empty")
    assert cnc872c.check("empty", allow_empty=True).ok


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights")
def test_an_archive_with_a_file_that_cannot_be_read(folder: Path) -> None:
    """One that was named raises; one that was found does not keep the others from being read."""
    (folder / "a.nc").write_text(WHOLE)
    (folder / "b.nc").symlink_to("missing.nc")
    archive = cnc872c.stats(".")
    assert [(facts.path, facts.findings) for facts in archive] == [("a.nc", None), ("b.nc", {"E0112": 1})]
    assert cnc872c.check(".").by_code == {"E0112": 1}
    with pytest.raises(OSError):
        cnc872c.stats(["a.nc", "b.nc"])


def test_language_and_levels() -> None:
    assert cnc872c.check(text=FAULTY, lang="cs").findings[0].message == "desetinná čárka"
    warned = cnc872c.check(text="%1\nN10\nN20 M30")
    assert warned.ok and [finding.code for finding in warned.findings] == ["W0214"]
    assert not cnc872c.check(text="%1\nN10\nN20 M30", deny_warnings=True).ok
    assert not cnc872c.check(text="%1\nN10\nN20 M30", deny="W0214").ok
    assert not cnc872c.check(text="%1\nN10\nN20 M30", allow=["empty-block"]).findings


@pytest.mark.parametrize("function", [cnc872c.check, cnc872c.compile, cnc872c.motion, cnc872c.plc, cnc872c.stats])
def test_paths_that_are_none(folder: Path, function: object) -> None:
    assert callable(function)
    with pytest.raises(FileNotFoundError) as found:
        function("missing.nc")
    assert (found.value.errno, found.value.filename) == (2, "missing.nc")
    if function not in (cnc872c.check, cnc872c.stats):
        with pytest.raises(IsADirectoryError):
            function(folder)
    with pytest.raises(TypeError):
        function()
    with pytest.raises(TypeError):
        function(5)
    with pytest.raises(TypeError):
        function("part.nc", colour="red")
    with pytest.raises((OSError, ValueError)):
        function("a\0b.nc")


def test_a_missing_program_of_a_comparison_or_a_state(folder: Path) -> None:
    (folder / "part.nc").write_text(WHOLE)
    with pytest.raises(FileNotFoundError):
        cnc872c.compare("part.nc", "missing.nc")
    with pytest.raises(FileNotFoundError):
        cnc872c.state("missing.nc", n=10)


@pytest.mark.parametrize("text", ["", "no program at all", b"\x00\xff\xfe", "%", "\n" * 1000, b"\x7fELF" + bytes(range(256))])
def test_text_that_is_no_program(text: str | bytes) -> None:
    report = cnc872c.check(text=text)
    assert not report.ok
    assert {finding.file for finding in report.findings} == {"-"}
    for function in (cnc872c.compile, cnc872c.motion, cnc872c.plc):
        with pytest.raises(cnc872c.ProgramError) as raised:
            function(text=text)
        assert raised.value.findings
    assert cnc872c.stats(text=text)[0].findings


def test_a_text_in_place_of_a_file(folder: Path) -> None:
    (folder / "part.nc").write_text(FAULTY)
    report = cnc872c.check("part.nc", text=WHOLE)
    assert (report.ok, report.files) == (True, ["part.nc"])
    (folder / "cnc872c.toml").write_text('dialect = "cnc8x9"\n')
    assert cnc872c.compile("part.nc", text=WHOLE).program["dialect"] == "cnc8x9"
    with pytest.raises(cnc872c.ProgramError):
        cnc872c.compile(text='%1 "příruba"\nN10 M30\n'.encode("cp1250"), encoding="utf-8")
    bytes_of_windows = '%1 "příruba"\nN10 M30\n'.encode("cp1250")
    assert cnc872c.compile(text=bytes_of_windows, encoding="windows-1250").program["title"] == "příruba"


def test_configuration(folder: Path) -> None:
    blocks = cnc872c.compile(text=WHOLE, config={"dialect": "cnc8x6", "parameters": {"R10": 2.5}})
    assert (blocks.program["dialect"], blocks.program["parameters"]) == ("cnc8x6", {"R10": 2.5})
    assert cnc872c.compile(text=WHOLE, param={"R10": 5}).program["parameters"] == {"R10": 5}
    (folder / "other.toml").write_text('dialect = "cnc8x9"\n')
    assert cnc872c.compile(text=WHOLE, config="other.toml").program["dialect"] == "cnc8x9"
    assert cnc872c.compile(text=WHOLE, config="other.toml", dialect="cnc872").program["dialect"] == "cnc872"
    axes = {"axes": [{"letter": "X", "type": "linear"}, {"letter": "C", "type": "rotary"}]}
    assert isinstance(cnc872c.check(text=WHOLE, config={"motion": {"accel-mm-s2": 800}}), cnc872c.Report)
    assert axes


@pytest.mark.parametrize(
    "options",
    [
        {"config": {"dialect": "cnc900"}},
        {"config": {"dialect": 5}},
        {"config": "missing.toml"},
        {"dialect": "cnc900"},
        {"encoding": "ascii"},
        {"lang": "de"},
        {"param": {"R96": 1}},
        {"param": {"X": 1}},
        {"max_blocks": 0},
        {"max_blocks": -1},
        {"config": {"limits": {"records": 2**63}}},
        {"macrocycles": "missing"},
        {"deny": "E0104"},
        {"allow": "W9999"},
        {"channel_config": "missing.xml"},
        {"channel_config": "missing.xml", "dialect": "cnc8x6"},
    ],
)
def test_wrong_configuration(folder: Path, options: dict[str, object]) -> None:
    for function in (cnc872c.check, cnc872c.compile, cnc872c.motion, cnc872c.plc, cnc872c.stats):
        with pytest.raises(cnc872c.ConfigError) as raised:
            function(text=WHOLE, **options)
        assert isinstance(raised.value, ValueError)
        assert str(raised.value)


def test_what_motion_and_plc_refuse() -> None:
    with pytest.raises(cnc872c.ConfigError):
        cnc872c.motion(text=WHOLE, set={"acel": 5})
    with pytest.raises(cnc872c.ConfigError):
        cnc872c.plc(text=WHOLE, signals="NONE")
    with pytest.raises(cnc872c.ConfigError) as raised:
        cnc872c.plc(text=WHOLE, find="BLK.T >")
    assert raised.value.findings[0].file == "find"
    for both in ({"signals": ["BLK.T"]}, {"compat": True}):
        with pytest.raises(cnc872c.ConfigError, match="find"):
            cnc872c.plc(text=WHOLE, find="BLK.TProg", **both)
    for number in ({"first": -1}, {"limit": -1}):
        for function in (cnc872c.compile, cnc872c.plc):
            with pytest.raises(cnc872c.ConfigError, match="-1"):
                function(text=WHOLE, **number)
    cnc872c.motion(text=WHOLE, set={"rapid-mm-min": {"X": 5000}})
    faster = cnc872c.motion(text=WHOLE, set={"accel-mm-s2": 5000})
    assert faster.time_s < cnc872c.motion(text=WHOLE).time_s


def test_places() -> None:
    text = "%1\nN10 G90 G00 X0\nN20 G01 X5 F100\nN30 G73 L20 Q2\nN40 M30\n"
    assert cnc872c.state(text=text, n=40)["place"]["line"] == 5
    assert cnc872c.state(text=text, n=20, pass_=2)["place"]["seq"] == 3
    assert cnc872c.state(text=text, line=3, pass_=1)["place"]["n"] == 20
    assert cnc872c.state(text=text, time=1.0)["place"]["n"] == 20
    for place in ({"n": 20}, {"n": 99}, {"n": -1}, {"n": 2**33}, {"seq": -1}, {"seq": 99}, {"time": 1e9}, {"at_tool": 3}, {"n": 20, "file": "L5"}):
        with pytest.raises(cnc872c.PlaceError) as raised:
            cnc872c.state(text=text, **place)
        assert isinstance(raised.value, LookupError)
    with pytest.raises(TypeError):
        cnc872c.state(text=text)
    with pytest.raises(TypeError):
        cnc872c.state(text=text, n=20, line=3)


def test_starts(folder: Path) -> None:
    text = "%1\nN10 G54 G90 T1 M06\nN20 S900 M03\nN30 G00 X0 Z50\nN40 G01 Z-1 F100\nN50 X30\nN60 G00 Z50\nN70 M30\n"
    (folder / "part.nc").write_text(text, newline="\n")
    command = run("restart", "part.nc", "--n", "50", "--clearance", "5", cwd=folder)
    assert cnc872c.restart("part.nc", n=50, clearance=5).decode() == command.stdout
    listed = run("restart", "part.nc", "--list", cwd=folder).stdout.splitlines()
    assert len(cnc872c.restart_places("part.nc", clearance=5)) == len(listed)
    with pytest.raises(cnc872c.PlaceError):
        cnc872c.restart("part.nc", n=55)
    corrected = text.replace("T1 M06", "T1 D1 M06").replace("N40 G01", "N40 G01 G41")
    with pytest.raises(cnc872c.PlaceError, match="G41"):
        cnc872c.restart(text=corrected, n=50)
    with pytest.raises(cnc872c.ProgramError):
        cnc872c.restart(text=FAULTY, n=10)
    with pytest.raises(FileNotFoundError):
        cnc872c.restart("missing.nc", n=10)
    for wrong in ({"safe": 1e9}, {"clearance": 0.0}, {"clearance": 0.00001}):
        with pytest.raises(cnc872c.ConfigError):
            cnc872c.restart("part.nc", n=50, **wrong)


def test_layout(folder: Path) -> None:
    untidy = '%1 "příruba"\nN10 G1X5.5F100\nN20 M30\n'
    (folder / "part.nc").write_bytes(untidy.encode("cp1250"))
    run("format", "part.nc", "--encoding", "windows-1250", cwd=folder)
    expected = (folder / "part.nc").read_bytes()
    assert cnc872c.format(text=untidy.encode("cp1250"), encoding="windows-1250") == expected
    assert cnc872c.format("part.nc", encoding="windows-1250") == expected
    assert cnc872c.format(text=untidy) == expected.decode("cp1250")
    assert (folder / "part.nc").read_bytes() == expected
    with pytest.raises(FileNotFoundError):
        cnc872c.format("missing.nc")
    with pytest.raises(cnc872c.ProgramError, match="E0112"):
        cnc872c.format(text=untidy.encode("cp1250"), encoding="utf-8")
    with pytest.warns(UserWarning, match="1 lines"):
        assert "??" in cnc872c.format(text="%1\nN10 G1X5.5F100 ??\nN20 M30\n")


def test_comparison(folder: Path) -> None:
    (folder / "a.nc").write_text(WHOLE)
    assert cnc872c.compare("a.nc", "a.nc")["same"]
    assert cnc872c.compare("a.nc", new_text=WHOLE)["old"]["name"] == "a.nc"
    with pytest.raises(cnc872c.ProgramError):
        cnc872c.compare("a.nc", new_text=FAULTY)
    assert not cnc872c.compare("a.nc", new_text=FAULTY, partial=True)["same"]


def test_sequences() -> None:
    blocks = cnc872c.compile(text=WHOLE)
    assert [block.n for block in blocks] == [10, 20, 30]
    assert [block.n for block in blocks[1:]] == [20, 30]
    assert (blocks[-1].n, len(blocks), blocks[0] == blocks[0], blocks[0] == blocks[1]) == (30, 3, True, False)
    with pytest.raises(IndexError):
        blocks[3]
    block = blocks[1]
    assert block.motion is not None and block.motion.axes == ["X", "Y"]
    assert (block.jump, block.calls, block.stop, block.s) == (None, None, False, None)
    with pytest.raises(AttributeError):
        block.missing  # noqa: B018
    assert repr(block.motion).startswith("Motion(type='linear'")
    assert [block.seq for block in cnc872c.compile(text=WHOLE, first=1, limit=1)] == [1]
    assert len(blocks.to_pandas()) == 3


def test_errors_can_be_pickled() -> None:
    with pytest.raises(cnc872c.ProgramError) as raised:
        cnc872c.compile(text=FAULTY)
    again = pickle.loads(pickle.dumps(raised.value))
    assert (type(again), str(again), again.findings) == (cnc872c.ProgramError, str(raised.value), raised.value.findings)


def test_all_errors_are_counted() -> None:
    text = "%1\n" + "".join(f"N{n} X5,5\n" for n in range(1, 10_102)) + "N20000 M30\n"
    with pytest.raises(cnc872c.ProgramError, match=r"and 10100 more\)$"):
        cnc872c.compile(text=text)


def test_the_command(folder: Path) -> None:
    (folder / "part.nc").write_text(FAULTY)
    made = run("check", "part.nc", cwd=folder)
    assert made.returncode == 1 and "E0104" in made.stdout
    assert run("--version").stdout.split() == ["cnc872c", cnc872c.__version__]
    assert run("check", "missing.nc").returncode == 2
    toml = (ROOT / "Cargo.toml").read_text()
    assert f'version = "{cnc872c.__version__}"' in toml


def test_values_that_cannot_be() -> None:
    text = "%1\nN10 G90 G00 X0 Y0\nN20 G01 X3 Y4 F100\nN30 M30"
    other = text.replace("X3", "X3.5")
    for wrong in (-1.0, float("nan"), float("inf")):
        for name in ("tolerance", "feed_tolerance"):
            with pytest.raises(cnc872c.ConfigError, match=name):
                cnc872c.compare(old_text=text, new_text=other, **{name: wrong})  # type: ignore[arg-type]
        with pytest.raises(cnc872c.PlaceError, match="no time"):
            cnc872c.state(text=text, time=wrong)
    endless: dict[str, object] = {}
    endless["a"] = endless
    deep: list[object] = []
    for _ in range(100_000):
        deep = [deep]
    for config in (endless, {"a": deep}):
        with pytest.raises(cnc872c.ConfigError, match="nested too deeply"):
            cnc872c.check(text=text, config=config)  # type: ignore[arg-type]
    for function in (cnc872c.check, cnc872c.stats):
        with pytest.raises(FileNotFoundError, match="no program is named"):
            function([])
    assert cnc872c.check([], allow_empty=True).ok


def test_what_is_not_formatted() -> None:
    for text in ("", "N1 G79 L9001\nN2 G1X5\nN3 G70\n"):
        assert cnc872c.format(text=text) == text
    assert "G01 X5" in cnc872c.format("L9001", text="N1 G79 L9001\nN2 G1X5\nN3 G70\n")
