"""Plugin of pytest for CI: fail if a test is skipped that is not on a list of allowed skips.

Without a browser, solver, batch system or second user, tests would otherwise be skipped unnoticed.
The list has one line per kind of skip, "where: reason": the beginning of the name of the test, and
the beginning of the reason.
"""

import os

import pytest

LIST = "SKIPS"  # environment variable with the path of the list


def strangers(config: pytest.Config) -> list[str]:
    """Return the skipped tests and files that are not on the list, with their reasons."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")  # None in a process of xdist
    if LIST not in os.environ or reporter is None:
        return []
    lines = (config.rootpath / os.environ[LIST]).read_text(encoding="utf-8").splitlines()
    allowed = [line.split(": ", 1) for line in lines if line and not line.startswith("#")]
    unlisted = []
    for report in reporter.stats.get("skipped", ()):
        message = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        reason = message.removeprefix("Skipped: ")
        if not any(report.nodeid.startswith(a) and reason.startswith(b) for a, b in allowed):
            unlisted.append(f"{report.nodeid}: {reason}")
    return unlisted


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Let the run fail if a skip is not on the list."""
    if strangers(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print the skips that are not on the list."""
    for line in strangers(terminalreporter.config):
        terminalreporter.write_line(f"skipped, but not on the list: {line}", red=True)
