"""Processes that are stopped (SIGSTOP): said, waited for with patience, done without."""

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
        words = (write_study(folder), "--out", str(folder), *SETTINGS, *where)
        self.driver = start(self.log, "workflow", "run", *words)

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
def hopeless(folder):
    """Return a run on a scheduler that is stopped before and for good; it waits from now on."""
    port, log = free_port(), folder / "scheduler.log"
    scheduler = start_scheduler(log, port)
    address = f"tcp://127.0.0.1:{port}"
    with Client(address, timeout=PATIENCE):
        pass
    scheduler.send_signal(signal.SIGSTOP)
    where = ("--scheduler", address, "--set", "cluster.patience=35")
    trial = Trial(folder / "hopeless", *where)
    yield trial
    end(trial.driver)
    end(scheduler)


@pytest.fixture(scope="module")
def cluster(folder, hopeless):
    """Return a scheduler and two workers."""
    del hopeless  # it waits meanwhile
    standing = Standing(folder / "standing")
    yield standing
    for process in standing.processes.values():
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
    assert status == 0
    silent = r"worker tcp://\S+: no sign of life for 3\d s; its batches are computed elsewhere"
    assert said(silent, lines) == 1
    assert trial.result() == expected


LACKING = {"scheduler": "answer of the scheduler", "workers": "sign of life of any worker"}


@pytest.mark.parametrize("who", LACKING)
def test_who_is_stopped_during_a_run_is_said_to_be_and_waited_for(folder, cluster, expected, who):
    trial = Trial(folder / who, "--scheduler", cluster.address)
    try:
        trial.wait_for_a_shard()
        pids = cluster.workers() if who == "workers" else [cluster.processes["scheduler"].pid]
        for pid in pids:
            os.kill(pid, signal.SIGSTOP)
        try:
            trial.wait_for(rf"no {LACKING[who]} for 3\d s: waiting, at most 10.0 min")
        finally:
            for pid in pids:
                os.kill(pid, signal.SIGCONT)
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
    assert taken[1] < 8.0 + 3.0 * taken[0]  # 7.6 s are waited


def test_a_scheduler_that_is_stopped_before_a_run_is_said_and_given_up(hopeless):
    status, lines = hopeless.ended()
    assert status == 2
    assert said(r"no answer of the scheduler for 3[0-4] s: waiting, at most 35 s", lines) == 1
    last = r"error: no answer of the scheduler for \d+ s: given up; run again to resume"
    assert re.fullmatch(last, lines[-1])
