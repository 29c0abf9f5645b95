"""Simulated: what is tried instead of an item that was alone in the cluster."""

from elastomer_friction.workflow.cluster import WorkerDied
from tests.support.simulated import Cluster, streamed
from tests.support.simulated_workers import DIE


def test_two_items_instead_of_one_that_was_alone_are_not_alone():
    """The item kills four workers, then it fails alone; of the two instead of it, one kills."""
    deaths, asked = iter([DIE] * 4), []

    def work(item):
        if item == "both":
            return 0.1, next(deaths, OSError())
        return 0.1, DIE if item == 1 else item

    def retry(item, error, alone):
        asked.append((item, type(error), alone))
        instead = [1, 2] if alone else [item]
        return instead if item == "both" else []

    cluster = Cluster(b0=work, c0=work)
    cluster.replaced = work
    assert streamed(cluster, ["both"], retry=retry) == [(2, 2)]
    both = [("both", WorkerDied, False), ("both", OSError, True)]
    assert asked == [*both, (1, WorkerDied, False)]


def test_what_outlives_every_worker_is_given_up_once_it_did_so_alone():
    """Workers of jobs retire before their walltime, of which dask thinks nothing of a task."""
    asked = []

    def work(item):
        return (1e9 if item == "endless" else 1.0), item

    def retry(item, error, alone):
        asked.append((item, type(error), alone))
        return [] if alone else [item]

    cluster = Cluster(b0=work, c0=work)
    cluster.replaced = work
    for i in range(30):
        for name in "bc":
            cluster.after(50.0 * (i + 1), cluster.retire, f"{name}{i}")
    items = ["endless", *range(20)]
    assert sorted(streamed(cluster, items, retry=retry)) == [(i, i) for i in range(20)]
    assert asked == [("endless", WorkerDied, alone) for alone in (False, True)]
    once = [item for item, _ in cluster.tried if item != "endless"]
    assert sorted(once) == [*range(20)]
    assert cluster.now < 1000.0 + 8.0 * 50.0 + 30.0
