"""The table [cluster]: what it says, and one line for what it cannot mean."""

import pytest

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


@pytest.mark.parametrize(("key", "value"), [("cors", 1), ("prologue", [1]), ("where", "pbs")])
def test_what_cannot_be_meant_is_one_line(key, value):
    with pytest.raises(UserError, match=rf"^cluster\.{key}.*(unknown key|string|local, slurm or)"):
        read_cluster({key: value})
