"""Processes that are stopped (SIGSTOP): said, waited for with patience, done without."""

import contextlib
import os
import signal
import time

import psutil
import pytest

from tests.cluster.processes import (
    PATIENCE,
    TRIAL_SIZE,
    end,
    said,
    shards,
    wait_while,
    workers_of,
)

pytestmark = pytest.mark.cluster

SILENT = r"no answer of the scheduler for \d+ s: waiting, at most 10.0 min"


@pytest.fixture
def cluster(standing):
    """Return a scheduler and two workers, which go on in the end."""
    standing.complete()
    yield standing
    for process in standing.processes.values():
        with contextlib.suppress(ProcessLookupError):  # given up meanwhile, it may have ended
            os.killpg(process.pid, signal.SIGCONT)


@pytest.fixture
def trial(tried, tmp_path, cluster):
    """Return a run on the cluster that has stored something, and goes on when it is told to."""
    trial = tried(tmp_path, "--scheduler", cluster.address, stopping=True)
    trial.wait_for_its_stop()
    return trial


def interrupted(trial):
    """Press Ctrl-C; return how often batches were left behind."""
    os.killpg(trial.driver.pid, signal.SIGINT)
    trial.go_on()
    status, lines = trial.ended()
    assert status == 130
    assert said(r"interrupted; what is finished is kept, to resume run again: .*", lines) == 1
    return said(r"abandoned: \d+ batches that did not finish in time", lines)


def test_what_a_stopped_worker_has_is_computed_elsewhere(trial, cluster, undisturbed):
    """Its nanny is stopped with it, as where a node hangs."""
    os.killpg(cluster.processes["worker-1"].pid, signal.SIGSTOP)
    trial.go_on()
    assert trial.whole() == undisturbed


def test_a_stopped_scheduler_is_reported_and_waited_for_but_not_after_ctrl_c(
    trial, cluster, undisturbed
):
    scheduler = cluster.processes["scheduler"]
    scheduler.send_signal(signal.SIGSTOP)
    trial.go_on()
    trial.wait_for(SILENT)
    assert interrupted(trial) <= 1  # none if nothing was under way
    scheduler.send_signal(signal.SIGCONT)
    trial.again(module="tests.cluster.stopping")
    trial.wait_for_its_stop()
    scheduler.send_signal(signal.SIGSTOP)
    trial.go_on()
    wait_while(lambda: said(SILENT, trial.lines()) < 2, trial.driver, trial.log)
    scheduler.send_signal(signal.SIGCONT)
    assert trial.whole() == undisturbed


@pytest.mark.parametrize("away", [0.0, 5.0])
def test_a_scheduler_that_is_started_anew_during_a_run_ends_it_and_the_next_resumes(
    tried, tmp_path, cluster, undisturbed, away
):
    """The work of a scheduler is lost with it: one line says so, and stored batches are kept.

    Of batches that take no time there may be no work just then: the run would go on.
    """
    long = ("--set", "study.realizations=48000", "--batch-seconds", "0.5")
    trial = tried(tmp_path, "--scheduler", cluster.address, *long)
    wait_while(lambda: not shards(trial.folder), trial.driver, trial.log)
    end(cluster.processes["scheduler"])
    time.sleep(away)
    cluster.heal()
    status, lines = trial.ended()
    assert (status, lines[-1]) == (2, "error: the scheduler was lost; run again to resume")
    assert "Traceback" not in "".join(lines)
    kept = shards(trial.folder)
    trial.again(*TRIAL_SIZE)
    while trial.driver.poll() is None:
        cluster.heal()  # workers end with the scheduler that they had
        time.sleep(0.1)
    assert trial.whole() == undisturbed
    assert kept <= shards(trial.folder)


def test_where_all_workers_are_stopped_others_take_their_place(trial, cluster, undisturbed):
    """Dask looks every 10 s of whom nothing was heard for 10 s, and starts it anew."""
    stopped, began = cluster.workers(), time.monotonic()
    for pid in stopped:
        os.kill(pid, signal.SIGSTOP)
    trial.go_on()
    while {*cluster.workers()} & {*stopped}:
        assert time.monotonic() - began < 60.0 + PATIENCE
        time.sleep(0.5)
    assert trial.whole() == undisturbed


def test_ctrl_c_does_not_wait_for_a_worker_of_our_own_that_is_stopped(tried, tmp_path):
    """The worker stays stopped, so that a run that waited for it would not end."""
    long = ("--set", "study.realizations=4800")  # it cannot end before the signal
    trial = tried(tmp_path, "--workers", "2", *long)
    wait_while(lambda: not shards(trial.folder), trial.driver, trial.log)
    os.kill(workers_of(psutil.Process(trial.driver.pid))[0], signal.SIGSTOP)
    assert interrupted(trial) <= 1
