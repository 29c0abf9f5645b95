"""The table [cluster]: what it says."""

import pytest

from elastomer_friction.workflow.study.cluster import CLUSTER as KEYS
from elastomer_friction.workflow.study.cluster import HERE, Cluster, read_cluster, walltime_seconds
from elastomer_friction.workflow.study.settings import checked
from tests.support.documents import CLUSTER


def test_walltimes_are_those_of_slurm():
    known = {"90": 5400, "00:02:30": 150, "30:15": 1815, "1-00": 86400, "2-01:30": 178200}
    known["1-02:03:04"] = 93784
    assert {text: walltime_seconds(text) for text in known} == known


def test_a_study_is_computed_here_unless_it_says_otherwise():
    assert read_cluster({}) == HERE == Cluster(where="local")
    assert HERE.longest_batch == float("inf")


def test_every_key_arrives():
    assert read_cluster(checked("cluster", CLUSTER, KEYS)) == Cluster(
        **CLUSTER | {"prologue": ("module load python",)}
    )


def test_batches_are_far_shorter_than_the_life_of_a_worker():
    place = read_cluster(CLUSTER)
    assert place.lifetime == pytest.approx(6480.0)
    assert place.longest_batch == pytest.approx(324.0)
