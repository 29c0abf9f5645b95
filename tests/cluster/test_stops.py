"""Processes that are stopped (SIGSTOP): said, waited for with patience, done without."""

import contextlib
import os
import signal
import time

import psutil
import pytest
from distributed import Client

from tests.cluster.processes import (
    PATIENCE,
    Trial,
    end,
    free_port,
    said,
    shards,
    start_scheduler,
    workers_of,
)

pytestmark = pytest.mark.cluster


@pytest.fixture(scope="module")
def cluster(standing):
    """Return a scheduler and two workers, which go on in the end."""
    yield standing
    for process in standing.processes.values():
        with contextlib.suppress(ProcessLookupError):  # given up meanwhile, it may have ended
            os.killpg(process.pid, signal.SIGCONT)


def interrupted(trial):
    """Press Ctrl-C; return the exit status, what was said, and how long it took (s)."""
    began = time.monotonic()
    os.killpg(trial.driver.pid, signal.SIGINT)
    return *trial.ended(), time.monotonic() - began


def test_what_a_stopped_worker_has_is_computed_elsewhere(tmp_path, cluster, undisturbed):
    """Its nanny is stopped with it, as where a node hangs."""
    trial = Trial(tmp_path, "--scheduler", cluster.address)
    nanny = cluster.processes["worker-1"].pid
    try:
        trial.wait_for_a_shard()
        os.killpg(nanny, signal.SIGSTOP)
        status, lines = trial.ended()
    finally:
        end(trial.driver)
        os.killpg(nanny, signal.SIGCONT)
    assert status == 0, lines
    assert trial.result() == undisturbed


def test_a_scheduler_that_is_stopped_during_a_run_is_said_to_be_and_waited_for(
    tmp_path, cluster, undisturbed
):
    trial = Trial(tmp_path, "--scheduler", cluster.address)
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
    assert trial.result() == undisturbed


@pytest.mark.parametrize("away", [0.0, 5.0])
def test_a_scheduler_that_is_started_anew_during_a_run_ends_it_and_the_next_resumes(
    tmp_path, cluster, undisturbed, away
):
    """The work of a scheduler is lost with it: one line says so, and stored batches are kept."""
    trial = Trial(tmp_path, "--scheduler", cluster.address)
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
    kept = shards(tmp_path)
    trial.again()
    while trial.driver.poll() is None:
        cluster.heal()  # workers end with the scheduler that they had
        time.sleep(0.1)
    assert trial.ended()[0] == 0
    assert kept < shards(tmp_path)
    assert trial.result() == undisturbed


def test_where_all_workers_are_stopped_others_take_their_place(tmp_path, cluster, undisturbed):
    """Dask looks every 25 s of whom nothing was heard for 25 s, and starts it anew."""
    trial = Trial(tmp_path, "--scheduler", cluster.address)
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
    assert trial.result() == undisturbed


def test_ctrl_c_does_not_wait_for_a_scheduler_that_is_stopped(tmp_path, cluster):
    trial = Trial(tmp_path, "--scheduler", cluster.address)
    scheduler = cluster.processes["scheduler"].pid
    try:
        trial.wait_for_a_shard()
        os.killpg(scheduler, signal.SIGSTOP)
        status, lines, _ = interrupted(trial)
    finally:
        end(trial.driver)
        os.killpg(scheduler, signal.SIGCONT)
    assert status == 130
    left = r"left behind: \d+ batches that were not done in time"  # if anything was not done
    assert said(left, lines) <= 1
    assert said(r"interrupted; what is finished is kept, to resume run again: .*", lines) == 1


def test_ctrl_c_does_not_wait_for_a_worker_of_our_own_that_is_stopped(tmp_path):
    """Compared with a run where none is stopped: the machine may be slow."""
    taken = {}
    for stopped in (0, 1):
        trial = Trial(tmp_path / str(stopped), "--workers", "2")
        try:
            trial.wait_for_a_shard()
            for pid in workers_of(psutil.Process(trial.driver.pid))[:stopped]:
                os.kill(pid, signal.SIGSTOP)
            status, lines, taken[stopped] = interrupted(trial)
        finally:
            end(trial.driver)
        assert status == 130
        left = r"left behind: \d+ batches that were not done in time"
        assert stopped or said(left, lines) == 0
        assert said(r"interrupted; what is finished is kept, to resume run again: .*", lines) == 1
    assert taken[1] < 16.0 + 3.0 * taken[0]  # 10 s for what runs, and some to end it


def test_a_scheduler_that_is_stopped_before_a_run_is_given_up(tmp_path):
    port = free_port()
    scheduler = start_scheduler(tmp_path / "scheduler.log", port)
    address = f"tcp://127.0.0.1:{port}"
    try:
        with Client(address, timeout=PATIENCE):
            pass
        scheduler.send_signal(signal.SIGSTOP)
        trial = Trial(tmp_path, "--scheduler", address)
        status, lines = trial.ended()
    finally:
        end(scheduler)
    assert (status, lines[-1]) == (2, f"error: --scheduler {address}: no scheduler answers there")
