"""A run without workers says so, waits, and gives up in the end."""

import pytest

from workflow.cluster import watch as module
from workflow.cluster.watch import Watch
from workflow.errors import UserError


@pytest.fixture
def clock(monkeypatch):
    """Return a clock that moves when it is told to."""
    now = [100.0]
    monkeypatch.setattr(module.time, "monotonic", lambda: now[0])
    return now


def waited(watch, clock, seconds):
    """Let seconds pass without workers."""
    for _ in range(seconds):
        clock[0] += 1.0
        watch.look(0, 3)


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
