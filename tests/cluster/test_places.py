"""The same study on three kinds of cluster: the same file, bit for bit."""

import pytest

from elastomer_friction.workflow.store import journal
from tests.cluster.processes import said
from tests.cluster.tally import begun

pytestmark = pytest.mark.cluster


def test_a_scheduler_with_two_workers_gives_the_same_bytes(undisturbed, standing, tried, tmp_path):
    trial = tried(tmp_path, "--scheduler", standing.address)
    assert trial.whole() == undisturbed
    assert said(r".*then 2 workers.*", trial.lines()) == 1
    stored = [e["chunks"] for e, _ in journal.entries(tmp_path / "store") if "shard" in e]
    assert begun(standing.tally) == sum(len(chunks) for chunks in stored)


def test_jobs_of_slurm_give_the_same_bytes(undisturbed, slurm, tried, tmp_path):
    trial = tried(tmp_path, *slurm.options(), **slurm.environment)
    assert trial.whole() == undisturbed
    assert said(r".*(1 worker\b|2 workers).*", trial.lines())
    assert list((slurm.folder / "jobs").glob("*.out"))


def test_what_slurm_refuses_is_one_line(slurm, tried, tmp_path):
    options = [*slurm.options(), "--set", 'cluster.queue="nowhere"']
    status, lines = tried(tmp_path, *options, **slurm.environment).ended()
    assert status == 2
    assert lines[-1].startswith("error: --slurm: SLURM refuses the jobs: ")
    assert "invalid partition" in lines[-1]
