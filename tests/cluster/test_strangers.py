"""Workers that run another program, and no workers at all."""

import re
import shutil

import pytest

from tests.cluster.processes import PATIENCE, ROOT, Standing, end, free_port, start
from workflow.store import journal

pytestmark = pytest.mark.cluster
STUDY = ("workflow", "run", "fig7", "--scale", "smoke", "--batch-seconds", "0.2")


@pytest.fixture
def cluster(tmp_path):
    """Return a cluster of its own, which a stranger may join."""
    standing = Standing(tmp_path / "standing")
    yield standing
    standing.stop()


@pytest.fixture
def edited(tmp_path):
    """Return a copy of the program with a kernel that is not ours."""
    for name in ("kernels", "workflow"):
        shutil.copytree(ROOT / name, tmp_path / "edited" / name)
    with (tmp_path / "edited" / "kernels" / "steady.py").open("a") as file:
        file.write("# edited\n")
    return tmp_path / "edited"


def stranger(cluster, edited):
    """Start a worker that runs the edited program."""
    options = ("--nthreads", "1", "--no-dashboard", "--local-directory", str(edited / "scratch"))
    log = edited / "log"
    return start(log, "distributed.cli.dask_worker", cluster.address, *options, cwd=edited)


def assert_refused(log):
    """Assert that the last that a run says is the table of what differs."""
    table = log.read_text().partition("error: ")[2].splitlines()
    assert "must run what the driver runs" in table[0]
    assert table[1].split() == ["there", "driver"]
    assert len(table) == 3
    assert "our sources" in table[2]
    assert "Traceback" not in log.read_text()


def test_a_worker_that_joins_later_with_other_sources_is_refused(cluster, edited, tmp_path):
    log = tmp_path / "log"
    options = ("--set", "study.realizations=200", "--scheduler", cluster.address)
    run = start(log, *STUDY, "--out", str(tmp_path), *options)
    try:
        while not any("shard" in entry for entry, _ in journal.entries(tmp_path / "store")):
            assert run.poll() is None, log.read_text()
        other = stranger(cluster, edited)
        assert run.wait(timeout=PATIENCE) == 2
        assert_refused(log)
        again = start(tmp_path / "again", *STUDY, "--out", str(tmp_path), *options)
        assert again.wait(timeout=PATIENCE) == 2  # the stranger is still there
        assert_refused(tmp_path / "again")
        end(other)
    finally:
        end(run)


def test_a_scheduler_without_workers_is_waited_for_and_given_up(tmp_path):
    port, log = free_port(), tmp_path / "log"
    options = ("--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
    scheduler = start(tmp_path / "scheduler", "distributed.cli.dask_scheduler", *options)
    try:
        address = ("--scheduler", f"tcp://127.0.0.1:{port}", "--set", "cluster.patience=15")
        run = start(log, *STUDY, "--out", str(tmp_path), *address)
        assert run.wait(timeout=PATIENCE) == 2
        said = [line for line in log.read_text().splitlines() if "no worker" in line]
        assert re.fullmatch(r"no worker for \d+ s: waiting, at most 15 s", said[0])
        last = r"error: no worker for \d+ s: given up; run again to resume"
        assert re.fullmatch(last, said[-1])
    finally:
        end(scheduler)
