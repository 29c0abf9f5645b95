"""Tests that are left out: where a list is given, none but those on it; for CI.

A test without its browser, its solver, its batch system or its second user would drop out in
silence. The list has one line per kind of skip, "where: reason": the beginning of the name of the
test, and the beginning of the reason. This module is a plugin of pytest.
"""

import os

import pytest

LIST = "SKIPS"  # of the environment: the path of the list


def strangers(config: pytest.Config) -> list[str]:
    """Return the tests and files that were left out and are not on the list, with their reasons."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")  # none in a process of xdist
    if LIST not in os.environ or reporter is None:
        return []
    lines = (config.rootpath / os.environ[LIST]).read_text(encoding="utf-8").splitlines()
    allowed = [line.split(": ", 1) for line in lines if line and not line.startswith("#")]
    actual = []
    for report in reporter.stats.get("skipped", ()):
        message = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        reason = message.removeprefix("Skipped: ")
        if not any(report.nodeid.startswith(a) and reason.startswith(b) for a, b in allowed):
            actual.append(f"{report.nodeid}: {reason}")
    return actual


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Let the run fail on a stranger."""
    if strangers(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say why."""
    for line in strangers(terminalreporter.config):
        terminalreporter.write_line(f"skipped, but not on the list: {line}", red=True)
