"""Processes that are stopped (SIGSTOP): said, waited for with patience, done without."""

import contextlib
import os
import re
import signal
import time

import psutil
import pytest
from distributed import Client

from elastomer_friction.workflow.store import journal
from tests.cluster.processes import (
    PATIENCE,
    Standing,
    end,
    free_port,
    start,
    start_scheduler,
    workers_of,
)
from tests.support.small import write_study

pytestmark = pytest.mark.cluster

SETTINGS = ("--set", "study.realizations=80", "--batch-seconds", "1e-9")  # many batches


class Trial:
    """A run of the small study, of whose scheduler or workers some will be stopped."""

    def __init__(self, folder, *where):
        folder.mkdir()
        self.folder, self.log = folder, folder / "log"
        self.words = (write_study(folder), "--out", str(folder), *SETTINGS, *where)
        self.again()

    def again(self):
        """Start the run, or start it once more."""
        self.driver = start(self.log, "workflow", "run", *self.words)

    def wait_for_a_shard(self):
        until = time.monotonic() + PATIENCE
        while not any("shard" in entry for entry, _ in journal.entries(self.folder / "store")):
            assert self.driver.poll() is None, self.log.read_text()
            assert time.monotonic() < until
            time.sleep(0.02)

    def wait_for(self, pattern):
        until = time.monotonic() + PATIENCE
        while not said(pattern, self.log.read_text().splitlines()):
            assert self.driver.poll() is None, self.log.read_text()
            assert time.monotonic() < until
            time.sleep(0.1)

    def interrupted(self):
        """Press Ctrl-C; return the exit status, what was said, and how long it took (s)."""
        began = time.monotonic()
        os.killpg(self.driver.pid, signal.SIGINT)
        return *self.ended(), time.monotonic() - began

    def ended(self):
        """Return the exit status and what was said."""
        return self.driver.wait(timeout=4.0 * PATIENCE), self.log.read_text().splitlines()

    def result(self):
        """Return the bytes of the result."""
        return (self.folder / "small.nc").read_bytes()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return the folder of all trials."""
    return tmp_path_factory.mktemp("stops")


@pytest.fixture(scope="module")
def cluster(folder):
    """Return a scheduler and two workers."""
    standing = Standing(folder / "standing")
    yield standing
    for process in standing.processes.values():
        with contextlib.suppress(ProcessLookupError):  # given up meanwhile, it may have ended
            os.killpg(process.pid, signal.SIGCONT)
    standing.stop()


def said(pattern, lines):
    """Return how many lines are of a pattern."""
    return sum(re.fullmatch(pattern, line) is not None for line in lines)


@pytest.fixture(scope="module")
def expected(folder):
    """Return the bytes of an undisturbed run."""
    peace = Trial(folder / "peace", "--workers", "2", "--batch-seconds", "3")
    assert peace.ended()[0] == 0
    return peace.result()


def test_what_a_stopped_worker_has_is_computed_elsewhere(folder, cluster, expected):
    """Its nanny is stopped with it, as where a node hangs."""
    trial = Trial(folder / "worker", "--scheduler", cluster.address)
    nanny = cluster.processes["worker-1"].pid
    try:
        trial.wait_for_a_shard()
        os.killpg(nanny, signal.SIGSTOP)
        status, lines = trial.ended()
    finally:
        end(trial.driver)
        os.killpg(nanny, signal.SIGCONT)
    assert status == 0, lines
    assert trial.result() == expected


def test_a_scheduler_that_is_stopped_during_a_run_is_said_to_be_and_waited_for(
    folder, cluster, expected
):
    trial = Trial(folder / "scheduler", "--scheduler", cluster.address)
    scheduler = cluster.processes["scheduler"].pid
    try:
        trial.wait_for_a_shard()
        os.kill(scheduler, signal.SIGSTOP)
        try:
            trial.wait_for(r"no answer of the scheduler for 3\d s: waiting, at most 10.0 min")
        finally:
            os.kill(scheduler, signal.SIGCONT)
        assert trial.ended()[0] == 0
    finally:
        end(trial.driver)
    assert trial.result() == expected


@pytest.mark.parametrize("away", [0.0, 5.0])
def test_a_scheduler_that_is_started_anew_during_a_run_ends_it_and_the_next_resumes(
    folder, cluster, expected, away
):
    """The work of a scheduler is lost with it: one line says so, and stored batches are kept."""
    where = f"restart-{away:g}"
    trial = Trial(folder / where, "--scheduler", cluster.address)
    try:
        trial.wait_for_a_shard()
        end(cluster.processes["scheduler"])
        time.sleep(away)
        cluster.heal()
        status, lines = trial.ended()
    finally:
        end(trial.driver)
    assert (status, lines[-1]) == (2, "error: the scheduler was lost; run again to resume")
    assert "Traceback" not in "".join(lines)
    kept = {path.name for path in (trial.folder / "store").glob("*.nc")}
    trial.again()
    while trial.driver.poll() is None:
        cluster.heal()  # workers end with the scheduler that they had
        time.sleep(0.1)
    assert trial.ended()[0] == 0
    assert kept < {path.name for path in (trial.folder / "store").glob("*.nc")}
    assert trial.result() == expected


def test_where_all_workers_are_stopped_others_take_their_place(folder, cluster, expected):
    """Dask looks every 25 s of whom nothing was heard for 25 s, and starts it anew."""
    trial = Trial(folder / "workers", "--scheduler", cluster.address)
    stopped = []
    try:
        trial.wait_for_a_shard()
        stopped += cluster.workers()
        began = time.monotonic()
        for pid in stopped:
            os.kill(pid, signal.SIGSTOP)
        while {*cluster.workers()} & {*stopped}:
            assert time.monotonic() - began < 60.0 + PATIENCE
            time.sleep(0.5)
        assert trial.ended()[0] == 0
    finally:
        end(trial.driver)
    assert trial.result() == expected


def test_ctrl_c_does_not_wait_for_a_scheduler_that_is_stopped(folder, cluster):
    trial = Trial(folder / "interrupted", "--scheduler", cluster.address)
    scheduler = cluster.processes["scheduler"].pid
    try:
        trial.wait_for_a_shard()
        os.killpg(scheduler, signal.SIGSTOP)
        status, lines, _ = trial.interrupted()
    finally:
        end(trial.driver)
        os.killpg(scheduler, signal.SIGCONT)
    assert status == 130
    assert said(r"left behind: \d+ batches that were not done in time", lines) == 1
    assert said(r"interrupted; what is finished is kept, to resume run again: .*", lines) == 1


def test_ctrl_c_does_not_wait_for_a_worker_of_our_own_that_is_stopped(folder):
    """Compared with a run where none is stopped: the machine may be slow."""
    taken = {}
    for stopped in (0, 1):
        trial = Trial(folder / f"own-{stopped}", "--workers", "2")
        try:
            trial.wait_for_a_shard()
            for pid in workers_of(psutil.Process(trial.driver.pid))[:stopped]:
                os.kill(pid, signal.SIGSTOP)
            status, lines, taken[stopped] = trial.interrupted()
        finally:
            end(trial.driver)
        assert status == 130
        left = r"left behind: \d+ batches that were not done in time"
        assert stopped or said(left, lines) == 0
        assert said(r"interrupted; what is finished is kept, to resume run again: .*", lines) == 1
    assert taken[1] < 16.0 + 3.0 * taken[0]  # 10 s for what runs, and some to end it


def test_a_scheduler_that_is_stopped_before_a_run_is_given_up(folder):
    port = free_port()
    scheduler = start_scheduler(folder / "scheduler.log", port)
    address = f"tcp://127.0.0.1:{port}"
    try:
        with Client(address, timeout=PATIENCE):
            pass
        scheduler.send_signal(signal.SIGSTOP)
        trial = Trial(folder / "hopeless", "--scheduler", address)
        status, lines = trial.ended()
    finally:
        end(scheduler)
    assert (status, lines[-1]) == (2, f"error: --scheduler {address}: no scheduler answers there")
