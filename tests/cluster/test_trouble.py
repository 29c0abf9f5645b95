"""What goes wrong on a cluster: kills, a problem that kills, another program, no workers."""

import os
import re
import shutil

import pytest

from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.store.store import Store, store_folder
from tests.cluster.havoc import Count
from tests.cluster.processes import (
    PATIENCE,
    STUDY,
    Standing,
    end,
    free_port,
    shards,
    start,
    start_scheduler,
    start_worker,
    wait_while,
)
from tests.support.python import ROOT
from tests.support.runs import run
from tests.support.shards import held
from tests.support.small import all_records, small_plan
from tests.tools.chaos import run_chaos

pytestmark = pytest.mark.cluster


def test_kills_change_no_bit_and_lose_no_finished_work(tmp_path):
    report = run_chaos(tmp_path, Count(8), seed=7, core_seconds=25.0)  # make chaos: many more
    assert report[0].startswith("8 kills and stops")


def poisonous(batch):
    """Run a batch, but die of one problem; stands in for block_means."""
    if any(task.key == small_plan().variants[0].tasks[1].key for task in batch.tasks):
        os._exit(1)
    return block_means(batch)


def test_the_poisonous_problem_alone_is_blamed_and_the_rest_computed(standing, tmp_path):
    plan, _, path = run(tmp_path, scheduler=standing.address, max_failures=1, work=poisonous)
    key = plan.variants[0].tasks[1].key
    store = Store(store_folder(path))
    assert list(store.failed) == [key]
    assert store.failed[key].startswith("its worker died 4 times")
    assert held(store) == {record for record in all_records(plan) if record[0] != key}
    assert run(tmp_path, scheduler=standing.address, retry_failed=True).summary.failures == []


def assert_refused(run, log):
    """Assert that the last that a run says is the table of what differs."""
    assert run.wait(timeout=PATIENCE) == 2
    table = log.read_text().partition("error: ")[2].splitlines()
    assert "must have the versions of the driver" in table[0]
    assert table[1].split() == ["worker", "driver"]
    assert len(table) == 3
    assert "our sources" in table[2]
    assert "Traceback" not in log.read_text()


def test_a_worker_that_joins_later_with_other_sources_is_refused(tmp_path):
    edited, log = tmp_path / "edited", tmp_path / "log"
    for name in ("src", "kernels", "workflow", "studies"):
        shutil.copytree(ROOT / name, edited / name, symlinks=True)
    with (edited / "kernels" / "model" / "steady.py").open("a") as file:
        file.write("# edited\n")
    cluster = Standing(tmp_path / "standing")
    options = ("--out", str(tmp_path), "--scheduler", cluster.address, "--batch-seconds", "0.2")
    options += ("--set", "study.realizations=40000")  # it cannot end before that worker joins
    processes = [start(log, *STUDY, *options)]
    try:
        wait_while(lambda: not shards(tmp_path), processes[0], log)
        path = str(edited / "src")
        processes.append(start_worker(edited / "worker.log", cluster.address, PYTHONPATH=path))
        assert_refused(processes[0], log)
        again = tmp_path / "again"  # the stranger is still there
        processes.append(start(again, *STUDY, *options))
        assert_refused(processes[2], again)
    finally:
        for process in processes:
            end(process)
        cluster.stop()


def test_a_scheduler_without_workers_is_waited_for_and_given_up(tmp_path):
    port, log = free_port(), tmp_path / "log"
    scheduler = start_scheduler(tmp_path / "scheduler", port)
    try:
        address = ("--scheduler", f"tcp://127.0.0.1:{port}", "--set", "cluster.patience=15")
        run = start(log, *STUDY, "--out", str(tmp_path), *address)
        assert run.wait(timeout=PATIENCE) == 2
        message = [line for line in log.read_text().splitlines() if "no worker" in line]
        assert re.fullmatch(r"no worker for \d+ s: waiting, at most 15 s", message[0])
        last = r"error: no worker for \d+ s: given up; run again to resume"
        assert re.fullmatch(last, message[-1])
    finally:
        end(scheduler)
