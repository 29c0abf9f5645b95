"""The smoke study on three kinds of cluster: the same file, bit for bit."""

import pytest

from elastomer_friction.workflow.store import journal
from tests.cluster.processes import PATIENCE, STUDY, result_of, start
from tests.cluster.tally import begun

pytestmark = pytest.mark.cluster


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    """Return the result computed by processes of this machine."""
    return result_of(tmp_path_factory.mktemp("local"), "--workers", "2")[0]


def test_a_scheduler_with_two_workers_gives_the_same_bytes(local, standing, tmp_path):
    actual, message = result_of(tmp_path, "--scheduler", standing.address, "--batch-seconds", "0.2")
    assert actual == local
    assert "then 2 workers" in message
    stored = [e["chunks"] for e, _ in journal.entries(tmp_path / "store") if "shard" in e]
    assert begun(standing.tally) == sum(len(chunks) for chunks in stored)


def test_jobs_of_slurm_give_the_same_bytes(local, slurm, tmp_path):
    actual, message = result_of(tmp_path, *slurm.options(), **slurm.environment)
    assert actual == local
    assert "1 worker," in message or "1 worker\n" in message or "2 workers" in message
    assert list((slurm.folder / "jobs").glob("*.out"))


def test_what_slurm_refuses_is_one_line(slurm, tmp_path):
    options = [*slurm.options(), "--set", 'cluster.queue="nowhere"']
    log = tmp_path / "log"
    process = start(log, *STUDY, "--out", str(tmp_path), *options, **slurm.environment)
    assert process.wait(timeout=PATIENCE) == 2
    last = log.read_text().splitlines()[-1]
    assert last.startswith("error: --slurm: SLURM refuses the jobs: ")
    assert "invalid partition" in last
