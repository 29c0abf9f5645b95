"""A run without workers warns, waits, and gives up after its patience."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.system.watch import NO_ANSWER, Watch


def wait(watch, clock, seconds, threads=0, lack=""):
    """Let seconds pass without workers, or with another lack."""
    for _ in range(seconds):
        clock[0] += 1.0
        watch.look(threads, 3, lack)


def test_the_interval_between_lines_doubles(clock, capsys):
    wait(Watch(patience=600.0), clock, 100)
    lines = capsys.readouterr().err.splitlines()
    assert lines == [f"no worker for {s} s: waiting, at most 10.0 min" for s in (10, 20, 40, 80)]


def test_the_end_of_patience_names_the_remedy(clock):
    with pytest.raises(UserError, match=r"^no worker for 31 s: given up; run again to resume$"):
        wait(Watch(patience=30.0), clock, 40)


def test_patience_restarts_with_every_worker(clock, capsys):
    watch = Watch(patience=30.0)
    for _ in range(5):
        wait(watch, clock, 25)
        watch.look(1, 3)
    assert capsys.readouterr().err.count("10 s") == 5


def test_missing_answers_use_the_same_patience(clock, capsys):
    watch = Watch(patience=70.0)
    watch.look(2, 3)
    with pytest.raises(UserError, match=r"^no answer of the scheduler for 71 s: given up"):
        wait(watch, clock, 90, 2, NO_ANSWER)
    lines = capsys.readouterr().err.splitlines()
    assert lines == [f"no {NO_ANSWER} for {s} s: waiting, at most 70 s" for s in (30, 60)]


def test_a_pause_of_this_process_does_not_count_as_waiting(clock):
    """The process may have been stopped, or the computer suspended."""
    watch = Watch(patience=30.0)
    wait(watch, clock, 20)
    clock[0] += 1e5
    wait(watch, clock, 5)


def test_a_listener_is_called_at_every_look_and_can_stop_the_watch():
    calls = []
    watch = Watch(lambda: len(calls) > 1)
    with watch.telling(lambda *counts: calls.append(counts)):
        watch.look(2, 7)
        assert not watch()
        watch.look(1, 5)
    assert watch()
    watch.look(3, 1)  # without a listener
    assert calls == [(2, 7), (1, 5)]


FAILED_LOG = """\
Traceback (most recent call last):
  File "worker.py", line 2, in start
    self.http_application
AttributeError: no attribute
slurmstepd: error
"""


def test_a_line_about_missing_jobs_holds_the_error_of_the_newest_failed_job(
    clock, capsys, tmp_path
):
    (tmp_path / "before.out").write_text(FAILED_LOG.replace("no attribute", "long ago"))
    watch = Watch()
    watch.follow(str(tmp_path))
    wait(watch, clock, 15)
    (tmp_path / "slurm-2.out").write_text(FAILED_LOG)
    (tmp_path / "slurm-3.out").write_text("all is well\n")
    wait(watch, clock, 10)
    first, second = capsys.readouterr().err.splitlines()
    assert first == f"no worker for 10 s (logs of the jobs: {tmp_path}): waiting"
    error = "slurm-2.out: AttributeError: no attribute"
    assert second == f"no worker for 20 s (logs of the jobs: {tmp_path}; {error}): waiting"
