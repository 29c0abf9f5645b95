"""Nodes that wait for others: they are given results, or values that a lost worker cannot take."""

import os
import signal
import time
from collections import Counter
from pathlib import Path

from distributed import get_worker

from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.cluster.pool import Pool
from elastomer_friction.workflow.run.node import Node
from elastomer_friction.workflow.study.cluster import Cluster
from tests.support.python import PATIENCE
from tests.support.simulated import stream


def march(item):
    """Note that it is computed; wait for a file if it has one to wait for; return its number."""
    number, folder, awaited = item
    Path(folder, f"{number}-{os.getpid()}-{time.monotonic_ns()}").touch()
    while awaited and not Path(awaited).exists():
        time.sleep(0.01)
    return number, get_worker().address


def total(values, *results):
    """Return the sum of stored numbers, and of those that are given."""
    return sum(values) + sum(number for number, _ in results)


class Fit(Node):
    """Adds the numbers of its inputs; of those whose results are lost, from what was yielded."""

    def __init__(self, inputs):
        super().__init__("fit", None, inputs)
        self.yielded = {}

    def prepare(self):
        """Give what is there; take the rest from what was yielded."""
        self.given = [node for node in self.needs() if node.result is not None]
        self.item = [self.yielded[node] for node in self.needs() if node.result is None]
        return True


FUNCTIONS = {"march": march, "fit": total}


def computed(folder):
    """Return how often each number was computed."""
    return Counter(int(path.name.partition("-")[0]) for path in folder.iterdir())


def keys(dask_scheduler):
    """Return the keys that a scheduler knows."""
    return {str(key) for key in dask_scheduler.tasks}


def test_results_stay_on_the_workers_until_they_are_fitted_and_no_longer(client, tmp_path):
    before = client.run_on_scheduler(keys)
    marches = [Node("march", (number, str(tmp_path), "")) for number in range(20)]
    fits = [Fit(marches[:12]), Fit(marches[8:])]
    nodes = [*marches[:12], fits[0], *marches[12:], fits[1]]
    values = dict(stream(Pool(client, FUNCTIONS), nodes))
    assert [values[fit] for fit in fits] == [sum(range(12)), sum(range(8, 20))]
    assert [fit.item for fit in fits] == [[], []]
    assert computed(tmp_path) == Counter(range(20))
    del values, marches, nodes, fits
    began = time.monotonic()
    while client.run_on_scheduler(keys) - before:
        assert time.monotonic() - began < PATIENCE
        time.sleep(0.05)


def test_what_a_lost_worker_had_is_not_computed_again(tmp_path):
    """Its values are given to the fit, which waited for another march all the time."""
    folder, signalled = tmp_path / "computed", tmp_path / "go on"
    folder.mkdir()
    marches = [Node("march", (number, str(folder), "")) for number in range(6)]
    last = Node("march", (100, str(folder), str(signalled)))
    fit, places = Fit([*marches, last]), {}
    with open_client(Cluster(), 2) as client:
        pids = client.run(os.getpid)
        for node, value in stream(Pool(client, FUNCTIONS), [last, *marches, fit]):
            if node is fit:
                assert value == 115
                continue
            fit.yielded[node], places[node] = value
            if len(places) == 6 and last not in places:
                (address,) = {*places.values()}  # the other worker is busy with the last
                os.kill(pids[address], signal.SIGKILL)
                began = time.monotonic()
                while address in client.scheduler_info()["workers"]:
                    assert time.monotonic() - began < PATIENCE
                    time.sleep(0.05)
                signalled.touch()
    assert computed(folder) == Counter([*range(6), 100])
    assert sorted(fit.item) == [*range(6)]
