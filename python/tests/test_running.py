"""Long calls, threads, processes, memory, and files that change."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import cnc872c
import pytest
from shared import ENDLESS, LONG, WHOLE, run

WITH_SIGNALS = pytest.mark.skipif(sys.platform == "win32", reason="signals of another kind")


@WITH_SIGNALS
@pytest.mark.parametrize("name", ["check", "compile", "motion", "plc", "stats", "state", "restart", "compare"])
def test_ctrl_c_stops_a_long_call(name: str) -> None:
    # Minutes, not for ever, where the signal is not heard.
    options = {"max_blocks": 3 * 10**7}
    calls = {
        "state": lambda: cnc872c.state(text=ENDLESS, n=80, **options),
        "restart": lambda: cnc872c.restart(text=ENDLESS, n=80, **options),
        "compare": lambda: cnc872c.compare(old_text=ENDLESS, new_text=ENDLESS, **options),
    }
    call = calls.get(name, lambda: getattr(cnc872c, name)(text=ENDLESS, **options))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call()
    assert time.monotonic() - start < 10
    timer.join()
    # What comes afterwards is not disturbed.
    assert cnc872c.check(text=WHOLE).ok


@WITH_SIGNALS
@pytest.mark.parametrize("name", ["check", "compile", "format"])
def test_ctrl_c_stops_a_call_that_waits_for_a_pipe(name: str, folder: Path) -> None:
    # More calls than there are threads.
    for at in range(5):
        pipe = folder / f"pipe{at}.nc"
        os.mkfifo(pipe)
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            getattr(cnc872c, name)(pipe)
        assert time.monotonic() - start < 10
        timer.join()
    assert cnc872c.check(text=WHOLE).ok


@WITH_SIGNALS
def test_ctrl_c_ends_the_command(folder: Path) -> None:
    (folder / "endless.nc").write_text(ENDLESS)
    command = [sys.executable, "-m", "cnc872c", "check", "endless.nc", "--max-blocks", "999999999999"]
    child = subprocess.Popen(command, cwd=folder, stderr=subprocess.DEVNULL)
    time.sleep(1)
    child.send_signal(signal.SIGINT)
    assert child.wait(10) != 0


@pytest.mark.skipif(
    sys.platform != "linux" or len(os.sched_getaffinity(0)) < 2, reason="threads are read from /proc; two are needed"
)
def test_two_threads_work_at_once() -> None:
    """Both are ready for a processor at the same moments, however busy the machine is."""

    def ready() -> int:
        found = 0
        for task in Path("/proc/self/task").iterdir():
            try:
                name, _, rest = (task / "stat").read_text().partition("(")[2].rpartition(")")
            except (FileNotFoundError, ProcessLookupError):
                # It ended since it was listed.
                continue
            found += name.startswith("cnc872c") and rest.split()[0] == "R"
        return found

    threads = [threading.Thread(target=cnc872c.check, kwargs={"text": ENDLESS, "max_blocks": 3_000_000}) for _ in range(2)]
    for thread in threads:
        thread.start()
    seen = []
    while all(thread.is_alive() for thread in threads):
        seen.append(ready())
        time.sleep(0.002)
    for thread in threads:
        thread.join()
    assert len(seen) > 20
    assert sum(count >= 2 for count in seen) > 0.8 * len(seen)


def test_many_threads() -> None:
    found: list[int] = []
    threads = [threading.Thread(target=lambda: found.append(len(cnc872c.compile(text=LONG)))) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [len(cnc872c.compile(text=LONG))] * 6


def _check(text: str) -> bool:
    return cnc872c.check(text=text).ok


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_processes(method: str) -> None:
    long = "%1\nN10 G90 G00 X0\n" + "".join(f"N{20 + at} G01 X{at} F100\n" for at in range(60_000)) + "N99990 M30\n"
    assert _check(long)
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map_async(_check, [long] * 4).get(120) == [True] * 4


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read from /proc")
def test_memory_does_not_grow() -> None:
    def megabytes() -> float:
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6

    def call() -> None:
        blocks = cnc872c.compile(text=WHOLE)
        blocks.to_arrow()
        assert blocks[1].motion is not None
        with pytest.raises(cnc872c.ConfigError):
            cnc872c.check(text=WHOLE, dialect="none")  # type: ignore[arg-type]
        cnc872c.check(text=WHOLE)

    for _ in range(500):
        call()
    before = megabytes()
    for _ in range(2_500):
        call()
    # Less than a kilobyte a call.
    assert megabytes() - before < 2


@pytest.mark.skipif(sys.platform != "linux", reason="memory in other units")
def test_a_stream_of_columns_takes_the_same_memory_however_long(folder: Path) -> None:
    def megabytes(passes: int) -> float:
        (folder / "part.nc").write_text(LONG.replace("Q9\n", f"Q{passes}\n"))
        arguments = ["cnc872c", "compile", "part.nc", "--format", "arrow", "-o", "part.arrow"]
        child = os.posix_spawn(sys.executable, [sys.executable, "-m", *arguments], os.environ)
        _, status, used = os.wait4(child, 0)
        assert status == 0
        return used.ru_maxrss / 1000

    assert megabytes(19) - megabytes(3) < 25


def test_a_file_that_changes(folder: Path) -> None:
    """The blocks are those of the text that was read, whatever becomes of the file."""
    path = folder / "part.nc"
    path.write_text(WHOLE)
    blocks = cnc872c.compile(path)
    path.write_text("%2\nN10 M30\n")
    assert [block.n for block in blocks] == [10, 20, 30]
    assert len(cnc872c.compile(path)) == 1
    path.unlink()
    assert blocks.to_arrow().num_rows == 3
    with pytest.raises(FileNotFoundError):
        cnc872c.compile(path)


@pytest.mark.skipif(sys.platform == "win32", reason="an open file cannot be replaced")
def test_a_file_that_changes_all_the_time(folder: Path) -> None:
    """What is read is one of the texts, never halves of two."""
    path = folder / "part.nc"
    texts = [f"%{number}\n" + "".join(f"N{n} X{number}\n" for n in range(10, 20_000, 10)) + "N20000 M30\n" for number in (1, 2)]
    path.write_text(texts[0])
    stop = threading.Event()

    def write() -> None:
        while not stop.is_set():
            for text in texts:
                beside = folder / "beside"
                beside.write_text(text)
                beside.replace(path)

    thread = threading.Thread(target=write)
    thread.start()
    try:
        for _ in range(20):
            try:
                blocks = cnc872c.compile(path)
            except (OSError, cnc872c.ProgramError):
                # It is never still.
                continue
            number = blocks.program["number"]
            assert {block.position["X"] for block in blocks[::500] if block.position} == {number}
    finally:
        stop.set()
        thread.join()


def test_columns_outlive_their_program() -> None:
    frame = cnc872c.compile(text=WHOLE).to_polars()
    table = cnc872c.compile(text=WHOLE).to_arrow()
    for _ in range(3):
        cnc872c.compile(text=LONG)
    assert frame["n"].to_list() == table["n"].to_pylist() == [10, 20, 30]


def test_a_cache(folder: Path) -> None:
    for number in range(30):
        (folder / f"p{number}.nc").write_text(WHOLE.replace("X3", f"X{number}"))
    first = cnc872c.stats(folder, cache="cache")
    again = cnc872c.stats(folder, cache=folder / "cache")
    assert [facts.to_dict() for facts in first] == [facts.to_dict() for facts in again]
    assert len(first) == 30
    shown = run("stats", ".", "--cache", "cache", "--format", "csv", cwd=folder)
    assert (shown.returncode, shown.stderr) == (0, "")
    [kept] = (folder / "cache").iterdir()
    kept.write_text(kept.read_text().replace('"blocks":3', '"blocks":4', 1))
    with pytest.warns(UserWarning, match="damaged"):
        again = cnc872c.stats(folder, cache="cache")
    assert [facts.to_dict() for facts in first] == [facts.to_dict() for facts in again]
