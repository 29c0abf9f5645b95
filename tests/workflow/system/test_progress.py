"""Messages on progress: lines in a log, a bar in a terminal, and one line on compilation."""

import io
import re
import sys

import numba
import pytest
from numba.core import event

from elastomer_friction.workflow.system.compiling import report_compilation
from elastomer_friction.workflow.system.progress import Reporter, core_time, duration

SECONDS = (0.0, 0.4, 12.3, 119.0, 120.0, 204.0, 7199.0, 20160.0, 674000.0)
WORDS = "0 s, 0 s, 12 s, 119 s, 2.0 min, 3.4 min, 120.0 min, 5.6 h, 7.8 d"


def test_duration_in_words():
    assert ", ".join(map(duration, SECONDS)) == WORDS


def lines(capsys):
    """Return the lines of the log so far; stdout must be empty."""
    out, err = capsys.readouterr()
    assert out == ""
    assert err == "" or err.endswith("\n")
    assert "\r" not in err
    return err.splitlines()


def test_a_log_gets_plain_lines_with_share_and_time_left(capsys, clock):
    with Reporter("computing", 40.0) as reporter:
        clock[0] += 5.0
        reporter.advance(10.0)
        assert lines(capsys) == ["computing:  25%, 15 s left"]
        clock[0] += 5.0
        reporter.advance(30.0)
    assert lines(capsys) == ["computing: 100%, 0 s left"]


def test_lines_are_sparse_and_slow_work_is_reported_too(capsys, clock):
    with Reporter("computing", 1000.0) as reporter:
        for _ in range(1000):
            reporter.advance(1.0)
    log = lines(capsys)
    assert 15 <= len(log) <= 21
    assert log[-1] == "computing: 100%, 0 s left"
    reporter = Reporter("computing", 1e6)
    for _ in range(10):
        clock[0] += 10.0
        reporter.advance(1.0)
    assert len(lines(capsys)) == 3


def test_no_work_prints_no_line_and_excess_work_ends_at_all_of_it(capsys, clock):
    for predicted, expected in ((0.0, []), (1.0, ["computing: 100%, 0 s left"])):
        with Reporter("computing", predicted) as reporter:
            clock[0] += 3.0
            reporter.advance(5.0 * predicted)
        assert lines(capsys) == expected


def test_a_terminal_gets_a_bar(monkeypatch):
    terminal = io.StringIO()
    terminal.isatty = lambda: True
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys, "stderr", terminal)
    with Reporter("computing", 2.0) as reporter:
        reporter.advance(1.0)
    shown = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", terminal.getvalue())
    assert "computing" in shown
    assert "50.0 %" in shown


def test_lines_name_the_workers(capsys, clock):
    with Reporter("computing", 10.0) as reporter:
        reporter.beat(3, 0)
        assert lines(capsys) == []
        clock[0] += 31.0
        reporter.beat(3, 0)
        assert lines(capsys) == ["computing:   0%, 3 workers"]
        reporter.beat(2, 1)
        reporter.advance(10.0)
        reporter.beat(2, 1)
    assert lines(capsys) == ["computing: 100%, 0 s left, 2 workers, 1 failed"]


def test_an_interval_is_in_one_unit_and_two_digits():
    assert core_time(2100.0, 3000.0) == "about 35 to 50 core-minutes"
    assert core_time(0.4, 0.61) == "about 0.4 to 0.61 core-seconds"
    assert core_time(1e5, 1.23e5) == "about 28 to 34 core-hours"
    assert core_time(3e6, 1.23e7) == "about 35 to 140 core-days"
    assert core_time(0.0, 0.0) == "about 0 to 0 core-seconds"


@pytest.fixture
def saying():
    """Return a report of the compilation of a toy."""
    return lambda: report_compilation("a toy", "1 to 2 s", "waiting")


def compile_one():
    """Compile a kernel, for two types."""
    one = numba.njit(lambda x: x)
    one(1)
    one(1.0)


def test_compilation_is_announced_once(saying, capsys):
    with saying():
        assert capsys.readouterr().err == ""
        compile_one()
        assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s and about 300 MiB, once.\n"
    with saying():
        pass
    compile_one()
    assert capsys.readouterr().err == ""


def test_waiting_for_another_process_is_announced_before_compilation(saying, capsys):
    with saying():
        for _ in range(2):
            with event.trigger_event("waiting"):
                pass
        assert capsys.readouterr().err == "Waiting for another process that compiles.\n"
        compile_one()  # as that process did not
        assert capsys.readouterr().err == "Compiling a toy, 1 to 2 s and about 300 MiB, once.\n"
        with event.trigger_event("waiting"):
            pass
    assert capsys.readouterr().err == ""
