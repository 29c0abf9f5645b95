"""The workers: silence is noted, failures are blamed on whom they follow, others do the work."""

import time
from types import SimpleNamespace

import pytest
from distributed.comm import CommClosedError

from elastomer_friction.workflow.cluster.calls import ROLL, Call, Roll, answer_rolls, call_roll
from elastomer_friction.workflow.cluster.crew import Crew, RollCalls
from elastomer_friction.workflow.cluster.watch import Watch
from elastomer_friction.workflow.errors import UserError

A, B, C = (f"tls://127.0.0.1:{port}" for port in (1, 2, 3))
FAR = {name: f"tls://10.0.0.{name[0]}:{name[1]}" for name in ("11", "12", "21", "31")}


def called(crew, beat, *, silent=(), busy=(), workers=(A, B, C)):
    """Let a crew note a roll call."""
    heard = {address: 0.0 if address in silent else float(beat) for address in workers}
    keys = {address: ["key"] if address in busy else [] for address in workers}
    crew.note(Roll(dict.fromkeys(workers, 1), heard, keys), 1.0)


def test_who_sends_no_heartbeat_is_quiet_then_silent_and_said_to_be(capsys):
    crew, seen = Crew(), {}
    for beat in range(70):
        called(crew, beat, silent=[B])
        seen[beat] = (crew.quiet(B), crew.silent(B), crew.threads())
    assert seen[3] == (False, False, 3)
    assert seen[5] == (True, False, 3)
    assert seen[31] == (True, True, 2)
    assert not crew.quiet(A)
    lines = capsys.readouterr().err.splitlines()
    text = f"worker {B}: no sign of life for {{}} s; its batches are computed elsewhere"
    assert lines == [text.format(30), text.format(60)]
    called(crew, 70.0)
    assert (crew.quiet(B), crew.silent(B), crew.threads()) == (False, False, 3)


def test_where_all_are_silent_the_watch_says_so(capsys):
    crew = Crew()
    for beat in range(40):
        called(crew, beat, silent=[A, B, C])
    assert crew.all_quiet()
    assert capsys.readouterr().err == ""
    assert not Crew().all_quiet()  # nobody is there


def test_time_that_passed_while_this_process_was_stopped_is_no_silence():
    crew = Crew()
    called(crew, 0)
    crew.note(crew.roll, 3600.0)
    assert not crew.silent(A)


def test_who_is_gone_is_waited_for_no_more():
    crew = Crew()
    called(crew, 0)
    called(crew, 1, workers=(A, B))
    assert crew.quiet(C)
    assert not crew.silent(C)  # the scheduler has given its work to others already


def test_who_is_paused_is_there_but_not_fit():
    crew = Crew()
    called(crew, 0)
    crew.note(crew.roll._replace(paused=[B]), 1.0)
    assert (crew.threads(), crew.able([A]), crew.fit()) == (3, [C], [A, C])


def test_of_a_failure_that_was_nobody_knows_where_nobody_is_blamed(capsys):
    crew = Crew()
    called(crew, 0)
    for _ in range(5):
        crew.succeeded(B, [""])
    assert (crew.left_out, capsys.readouterr().err) == (set(), "")


def change(status, address, dask_scheduler):
    """Let a scheduler take a worker for paused, or running; run there."""
    dask_scheduler.handle_worker_status_change(status, address, "test")


def test_a_scheduler_says_what_nobody_is_there_for_and_who_is_paused(client):
    """As dask's own says it: the future is for a worker that never was."""
    first, _ = client.nthreads()
    future = client.submit(abs, -1, workers=["tcp://127.0.0.1:1"], pure=False)
    client.run_on_scheduler(change, "paused", first)
    try:
        while not (roll := call_roll(client, True)).stranded:
            time.sleep(0.01)
    finally:
        client.run_on_scheduler(change, "running", first)
    assert ([*roll.stranded], [*roll.paused]) == ([future.key], [first])
    assert {*roll.threads} == {*client.nthreads()}
    assert [*call_roll(client, False).paused] == []


def test_who_fails_in_a_row_what_others_can_do_is_left_out_and_named(capsys):
    crew = Crew()
    called(crew, 0)
    for _ in range(2):
        crew.succeeded(B, [A])
    crew.succeeded(A, [])  # no longer in a row
    for _ in range(3):
        assert A in crew.fit()
        crew.succeeded(B, [A])
    assert crew.fit() == [B, C]
    crew.succeeded(B, [A])
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"worker {A}: 3 batches in a row failed there")


def test_on_several_hosts_the_host_is_blamed():
    crew = Crew()
    called(crew, 0, workers=FAR.values())
    assert crew.fit([FAR["11"]]) == [FAR["21"], FAR["31"]]
    for worker in ("11", "12", "11"):
        crew.succeeded(FAR["21"], [FAR[worker]])
    assert crew.fit() == [FAR["21"], FAR["31"]]


class Asked:
    """A client whose scheduler answers as it is told to."""

    def __init__(self, answer):
        self.answer = answer

    scheduler = SimpleNamespace(**{ROLL: None})

    def run_on_scheduler(self, function):
        assert function is answer_rolls

    def sync(self, function):
        assert function is None
        return self.answer()


class Instant(Call):
    """A call that waits for its end."""

    def wait(self, seconds):
        return super().wait(10.0)


class Clock:
    """A clock that is set."""

    now = 0.0

    def monotonic(self):
        return self.now


def test_the_roll_is_called_every_second_and_at_once_after_a_stop(client):
    clock = Clock()
    rolls = RollCalls(client, Watch(), clock, Instant)
    assert not rolls.answered()
    told = []
    for clock.now, stopping in ((0.0, False), (0.5, False), (1.0, False), (1.2, True), (1.4, True)):
        told.append(rolls.tick(stopping))
    assert told == [True, False, True, True, False]
    assert rolls.answered()
    assert rolls.crew.threads() == 2


def test_what_streams_know_of_the_workers_is_kept():
    watch = Watch()
    first = RollCalls(Asked(None), watch, Clock(), Call)
    assert RollCalls(Asked(None), watch, Clock(), Call).crew is first.crew


def test_a_scheduler_that_is_lost_while_it_is_asked_ends_the_run():
    def lost():
        raise CommClosedError

    with pytest.raises(UserError, match="the scheduler was lost"):
        RollCalls(Asked(lost), Watch(), Clock(), Instant).tick(False)


def test_a_scheduler_that_does_not_answer_is_noticed():
    clock = Clock()
    rolls = RollCalls(Asked(lambda: None), Watch(), clock, Call)
    rolls.call = lambda *_: type("Never", (), {"wait": lambda *_: False})()
    assert not rolls.tick(False)
    assert not rolls.unanswered()
    clock.now = 4.0
    assert rolls.unanswered()
