"""Which tests reach which line of our code, by coverage with a context for each test."""

import time
from collections import defaultdict
from pathlib import Path

import coverage
import pytest

SETUP, IMPORT = "setup of ", "import of "


class Reached:
    """A pytest plugin that notes which tests reach which line, and how long each takes."""

    def __init__(self, files: list[Path]) -> None:
        ours = [str(file.resolve()) for file in files]
        self.coverage = coverage.Coverage(data_file=None, config_file=False, include=ours)
        self.fixtures: dict[str, set[str]] = {}  # of each test
        self.seconds: dict[str, float] = defaultdict(float)

    def pytest_collectstart(self, collector: pytest.Collector) -> None:
        """Note lines that a module of tests reaches on import."""
        self.coverage.switch_context(IMPORT + collector.nodeid)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        """Note lines for a test, and what it is made of."""
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
        """Note lines that a fixture reaches for all who use it."""
        self.coverage.switch_context(SETUP + fixturedef.argname)
        try:
            return (yield)
        finally:
            self.coverage.switch_context(request.node.nodeid.partition("[")[0])

    def by_line(self) -> dict[str, dict[int, set[str]]]:
        """Return path -> line -> tests that reach it."""
        users = defaultdict(set)
        for test, fixtures in self.fixtures.items():
            users[test].add(test)
            users[IMPORT + test.partition("::")[0]].add(test)
            for fixture in fixtures:
                users[SETUP + fixture].add(test)

        def tests_of(contexts: list[str]) -> set[str]:
            found = {test for c in contexts if not c.startswith(IMPORT) for test in users[c]}
            return found and found.union(*(users[c] for c in contexts))  # on import alone: all

        data = self.coverage.get_data()
        return {
            path: {line: tests_of(c) for line, c in data.contexts_by_lineno(path).items()}
            for path in data.measured_files()
        }
