"""Change code at random places, one at a time, and report whether its tests notice.

    python -m tests.tools.mutation workflow/store --count 100 --seed 12
    NUMBA_DISABLE_JIT=1 python -m tests.tools.mutation kernels/model/contact.py

Each mutant (mutants.py) is tried in its own process, by those tests of its room that reach the
changed line. The tests of a folder, or of the folder of a file, are in the folder of the same name
under tests. A mutant is killed if a test fails, or if the tests take far more CPU time than without
it. The files are changed in place and restored, so use a separate clone.
"""

import argparse
import contextlib
import os
import pickle
import random
import resource
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter, defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import coverage
import distributed  # noqa: F401  imported once for all tests, before child processes start
import matplotlib.pyplot  # noqa: F401
import netCDF4  # noqa: F401
import numba  # noqa: F401
import pytest
import scipy.optimize  # noqa: F401
import xarray  # noqa: F401

from tests.tools.mutants import Mutant, mutants_of

SETUP, IMPORT = "setup of ", "import of "


class Reached:
    """A pytest plugin that records which tests reach which line, and the time of each test."""

    def __init__(self, files: list[Path]) -> None:
        ours = [str(file.resolve()) for file in files]
        self.coverage = coverage.Coverage(data_file=None, config_file=False, include=ours)
        self.fixtures: dict[str, set[str]] = {}  # names of the fixtures of each test
        self.seconds: dict[str, float] = defaultdict(float)  # CPU time of each test

    def pytest_collectstart(self, collector: pytest.Collector) -> None:
        """Record lines that a test module reaches on import."""
        self.coverage.switch_context(IMPORT + collector.nodeid)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        """Record the lines, fixtures and CPU time of a test."""
        name = item.nodeid.partition("[")[0]
        self.fixtures[name] = set(getattr(item, "fixturenames", ()))
        self.coverage.switch_context(name)
        began = time.process_time()
        try:
            return (yield)
        finally:
            self.seconds[name] += time.process_time() - began

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: pytest.FixtureDef, request: pytest.FixtureRequest):
        """Record lines that a fixture reaches, for all tests that use it."""
        self.coverage.switch_context(SETUP + fixturedef.argname)
        try:
            return (yield)
        finally:
            self.coverage.switch_context(request.node.nodeid.partition("[")[0])

    def by_line(self) -> dict[str, dict[int, set[str]]]:
        """Return the tests that reach each line: {path: {line: tests}}."""
        users = defaultdict(set)
        for test, fixtures in self.fixtures.items():
            users[test].add(test)
            users[IMPORT + test.partition("::")[0]].add(test)
            for fixture in fixtures:
                users[SETUP + fixture].add(test)

        def tests_of(contexts: list[str]) -> set[str]:
            actual = {test for c in contexts if not c.startswith(IMPORT) for test in users[c]}
            return actual and actual.union(*(users[c] for c in contexts))  # empty: on import only

        data = self.coverage.get_data()
        return {
            path: {line: tests_of(c) for line, c in data.contexts_by_lineno(path).items()}
            for path in data.measured_files()
        }


QUIET = ["-x", "-q", "-n", "0", "-p", "no:cacheprovider", "--hypothesis-seed=0"]
USUAL = ["-m", "not cluster and not exhaustive"]
TIMES_LONGER = 10.0  # limit of CPU time, over that of the tests without a change
WALL_TIMES_LONGER = 2.0  # limit of wall time, over that of CPU time


class Room(NamedTuple):
    """A folder or a file of the program with its tests."""

    mutants: list[Mutant]
    lines: dict[str, dict[int, set[str]]]  # path -> line -> tests that reach it
    cost: dict[str, float]  # CPU seconds of each test

    def chosen(self, mutant: Mutant) -> list[str]:
        """Return the tests that reach a mutant: those of its module first, then by CPU time.

        Return all tests of the room if none does, e.g. if the line is reached only on import.
        """
        lines = self.lines.get(str(mutant.path.resolve()), {})
        actual = set().union(*(lines.get(n, ()) for n in range(mutant.line, mutant.last + 1)))
        file = f"test_{mutant.path.stem}.py"
        return sorted(actual or self.cost, key=lambda test: (file not in test, self.cost[test]))


def room_of(place: Path, scratch: Path) -> Room:
    """Run the tests of a place once, in a child process. Raises SystemExit if they fail."""
    files = sorted(place.rglob("*.py")) if place.is_dir() else [place]
    tests = Path("tests") / (place if place.is_dir() else place.parent)

    def survey() -> int:
        reached = Reached(files)
        reached.coverage.start()
        status = pytest.main([*QUIET, *USUAL, str(tests)], plugins=[reached])
        reached.coverage.stop()
        known = pickle.dumps((reached.by_line(), dict(reached.seconds)))
        (scratch / "known").write_bytes(known)
        return int(status)

    if in_a_process(survey, 3600.0, scratch / "log"):
        raise SystemExit(f"{(scratch / 'log').read_text()}\n{tests} fail before any change")
    lines, cost = pickle.loads((scratch / "known").read_bytes())
    return Room([mutant for file in files for mutant in mutants_of(file)], lines, cost)


def in_a_process(work: Callable[[], int], seconds: float, log: Path) -> int:
    """Return the exit status of ``work`` in a child process, -1 if it exceeds its time."""
    pid = os.fork()
    if pid == 0:
        status = 3
        try:
            os.setsid()
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 5))
            with log.open("wb") as file:
                os.dup2(file.fileno(), 1)
                os.dup2(file.fileno(), 2)
            status = int(work())
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stdout.flush()
            os._exit(status)
    end = time.monotonic() + WALL_TIMES_LONGER * seconds
    ended, actual = 0, 0
    while not ended and time.monotonic() < end:
        time.sleep(0.05)
        ended, actual = os.waitpid(pid, os.WNOHANG)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)  # the child and its own children
    if not ended:
        os.waitpid(pid, 0)
        return -1
    return os.waitstatus_to_exitcode(actual) if os.WIFEXITED(actual) else -1


def try_one(room: Room, mutant: Mutant, log: Path) -> str:
    """Try a mutant; return "killed", "timed out" or "survived"."""
    tests = room.chosen(mutant)
    sound, known = mutant.path.read_text(encoding="utf-8"), mutant.path.stat()
    try:
        mutant.path.write_text(mutant.source(), encoding="utf-8")
        longest = max(60.0, TIMES_LONGER * sum(room.cost[test] for test in tests))
        status = in_a_process(lambda: pytest.main([*QUIET, *USUAL, *tests]), longest, log)
    finally:
        mutant.path.write_text(sound, encoding="utf-8")
        os.utime(mutant.path, ns=(known.st_atime_ns, known.st_mtime_ns))  # keep bytecode valid
    return "survived" if status == 0 else "timed out" if status < 0 else "killed"


def main() -> None:
    """Try some mutants; print the outcome of each, and the numbers of outcomes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("place", type=Path)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=12)
    given = parser.parse_args()
    actual: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        room = room_of(given.place, scratch)
        sys.dont_write_bytecode = True  # bytecode of a mutant would be taken for that of the code
        os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
        count = min(given.count, len(room.mutants))
        print(f"{given.place}: {len(room.cost)} tests of {sum(room.cost.values()):.0f} s of CPU")
        for mutant in random.Random(given.seed).sample(room.mutants, count):
            outcome = try_one(room, mutant, scratch / "log")
            actual[outcome] += 1
            print(f"{outcome:9} {mutant}", flush=True)
    times = os.times()
    used = times.children_user + times.children_system
    print(f"{given.place}: {dict(actual)} of {count}, {used:.0f} s of CPU")


if __name__ == "__main__":
    main()
