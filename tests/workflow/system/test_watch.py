"""A run without workers says so, waits, and gives up in the end."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.system.watch import NO_ANSWER, Watch


def waited(watch, clock, seconds, threads=0, lack=""):
    """Let seconds pass without workers, or without something else."""
    for _ in range(seconds):
        clock[0] += 1.0
        watch.look(threads, 3, lack)


def test_silence_is_broken_less_and_less_often(clock, capsys):
    waited(Watch(patience=600.0), clock, 100)
    said = capsys.readouterr().err.splitlines()
    assert said == [f"no worker for {s} s: waiting, at most 10.0 min" for s in (10, 20, 40, 80)]


def test_patience_ends_with_what_to_do(clock):
    with pytest.raises(UserError, match=r"^no worker for 31 s: given up; run again to resume$"):
        waited(Watch(patience=30.0), clock, 40)


def test_patience_begins_anew_with_every_worker(clock, capsys):
    watch = Watch(patience=30.0)
    for _ in range(5):
        waited(watch, clock, 25)
        watch.look(1, 3)
    assert capsys.readouterr().err.count("10 s") == 5


def test_answers_that_do_not_come_are_waited_for_with_the_same_patience(clock, capsys):
    watch = Watch(patience=70.0)
    watch.look(2, 3)
    with pytest.raises(UserError, match=r"^no answer of the scheduler for 71 s: given up"):
        waited(watch, clock, 90, 2, NO_ANSWER)
    said = capsys.readouterr().err.splitlines()
    assert said == [f"no {NO_ANSWER} for {s} s: waiting, at most 70 s" for s in (30, 60)]


def test_what_this_process_did_not_watch_is_no_waiting(clock):
    """It may have been stopped itself, or the computer suspended."""
    watch = Watch(patience=30.0)
    waited(watch, clock, 20)
    clock[0] += 1e5
    waited(watch, clock, 5)


def test_a_watch_tells_what_it_sees_and_when_to_stop():
    seen = []
    watch = Watch(lambda: len(seen) > 1)
    with watch.telling(lambda *what: seen.append(what)):
        watch.look(2, 7)
        assert not watch()
        watch.look(1, 5)
    assert watch()
    watch.look(3, 1)  # to nobody
    assert seen == [(2, 7), (1, 5)]


TRIED = """\
Traceback (most recent call last):
  File "worker.py", line 2, in start
    self.http_application
AttributeError: no attribute
slurmstepd: error
"""


def test_who_waits_for_jobs_reads_the_error_in_which_the_newest_of_them_ended(
    clock, capsys, tmp_path
):
    (tmp_path / "before.out").write_text(TRIED.replace("no attribute", "long ago"))
    watch = Watch()
    watch.follow(str(tmp_path))
    waited(watch, clock, 15)
    (tmp_path / "slurm-2.out").write_text(TRIED)
    (tmp_path / "slurm-3.out").write_text("all is well\n")
    waited(watch, clock, 10)
    first, second = capsys.readouterr().err.splitlines()
    assert first == f"no worker for 10 s (logs of the jobs: {tmp_path}): waiting"
    error = "slurm-2.out: AttributeError: no attribute"
    assert second == f"no worker for 20 s (logs of the jobs: {tmp_path}; {error}): waiting"
