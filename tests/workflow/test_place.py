"""The table [cluster]: what it says, and one line for what it cannot mean."""

import subprocess

import pytest

from workflow.cluster import jobs as slurm
from workflow.errors import UserError
from workflow.study.cluster import HERE, Cluster, read_cluster, walltime_seconds

TABLE = {
    "where": "slurm",
    "queue": "normal",
    "cores": 4,
    "memory": "8GB",
    "walltime": "02:00:00",
    "account": "friction",
    "prologue": ["module load python"],
    "jobs": 25,
    "interface": "ib0",
    "log_folder": "logs",
    "patience": 86400,
}


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("90", 5400.0),
        ("00:02:30", 150.0),
        ("30:15", 1815.0),
        ("1-00", 86400.0),
        ("2-01:30", 178200.0),
        ("1-02:03:04", 93784.0),
    ],
)
def test_walltimes_are_those_of_slurm(text, seconds):
    assert walltime_seconds(text) == seconds


def test_a_study_is_computed_here_unless_it_says_otherwise():
    assert read_cluster({}) == HERE == Cluster(where="local")
    assert HERE.longest_batch == float("inf")


def test_every_key_arrives():
    assert read_cluster(TABLE) == Cluster(**TABLE | {"prologue": ("module load python",)})


def test_batches_are_far_shorter_than_the_life_of_a_worker():
    place = read_cluster(TABLE)
    assert place.lifetime == pytest.approx(6480.0)
    assert place.longest_batch == pytest.approx(324.0)


@pytest.mark.parametrize(
    ("key", "value", "right"),
    [
        ("where", "pbs", "local, slurm or tcp://host:port"),
        ("jobs", 0, "at least 1"),
        ("cores", 1.5, "whole number"),
        ("memory", "much", "as a size"),
        ("memory", 4, "string"),
        ("walltime", "soon", "as a time"),
        ("walltime", "00:00:10", "at least 60 s"),
        ("patience", -1, "greater than zero"),
        ("prologue", [1], "string"),
        ("cors", 1, "unknown key"),
    ],
)
def test_what_cannot_be_meant_is_one_line(key, value, right):
    with pytest.raises(UserError) as error:
        read_cluster({key: value})
    message = str(error.value)
    assert message.startswith(f"cluster.{key}")
    assert "\n" not in message
    assert any(word in message for word in (right, right.removeprefix("as ")))


def test_jobs_are_asked_for_as_the_table_says():
    from dask_jobqueue.slurm import SLURMJob

    settings = slurm._settings(read_cluster(TABLE))
    settings.pop("scheduler_options")
    script = SLURMJob("tcp://here:1", "name", **settings).job_script()
    for line in (
        "#SBATCH -p normal",
        "#SBATCH -A friction",
        "#SBATCH --cpus-per-task=4",
        "#SBATCH -t 02:00:00",
        "#SBATCH --no-requeue",
        "export OMP_NUM_THREADS=1",
        "export NUMBA_NUM_THREADS=1",
        "export MALLOC_TRIM_THRESHOLD_=268435456",
        "module load python",
    ):
        assert line in script.splitlines()
    for option in (
        "--nthreads 1",
        "--nworkers 4",
        "--interface ib0",
        "--lifetime 6480s",
        "--lifetime-stagger 648s",
        "--preload workflow.cluster.worker",
    ):
        assert option in script


def test_without_slurm_one_line_says_so(monkeypatch):
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(UserError, match="sbatch is not found on this machine"):
        slurm._try_submitting("slurm", "")


def test_what_slurm_refuses_is_passed_on(monkeypatch):
    def refuse(command, **_):
        return subprocess.CompletedProcess(command, 1, "", "sbatch: error: invalid partition\n")

    monkeypatch.setattr(slurm.subprocess, "run", refuse)
    with pytest.raises(UserError, match="SLURM refuses the jobs: sbatch: error: invalid partition"):
        slurm._try_submitting("slurm", "")
