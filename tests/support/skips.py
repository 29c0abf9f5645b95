"""Tests that are left out: where a list is given, none but those on it; for CI.

A test without its browser, its solver, its batch system or its second user would drop out in
silence. The list has one line per kind of skip, "where: reason": the beginning of the name of the
test, and the beginning of the reason.
"""

import os
from pathlib import Path

import pytest

LIST = "SKIPS"  # of the environment: the path of the list


class Skips:
    """Lets a run of tests fail where a skip is not on the list."""

    def __init__(self, path: Path) -> None:
        lines = path.read_text(encoding="utf-8").splitlines()
        entries = [line for line in lines if line and not line.startswith("#")]
        self.allowed = [entry.split(": ", 1) for entry in entries]
        self.strangers: list[str] = []

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a test that was left out."""
        if report.skipped and not hasattr(report, "wasxfail"):
            self._note(report)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Note a file that was left out."""
        if report.skipped:
            self._note(report)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Let the run fail."""
        if self.strangers:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """Say why."""
        for line in self.strangers:
            terminalreporter.write_line(f"skipped, but not on the list: {line}", red=True)

    def _note(self, report: pytest.TestReport | pytest.CollectReport) -> None:
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        reason = reason.removeprefix("Skipped: ")
        known = ((report.nodeid.startswith(w), reason.startswith(why)) for w, why in self.allowed)
        if (True, True) not in known:
            self.strangers.append(f"{report.nodeid}: {reason}")


def register(config: pytest.Config) -> None:
    """Watch over skips where the environment names a list; in one process of all."""
    if LIST in os.environ and not hasattr(config, "workerinput"):
        config.pluginmanager.register(Skips(config.rootpath / os.environ[LIST]), "skips")
