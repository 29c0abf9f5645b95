"""The simulated cluster of studies/scaling beside a real scheduler and real, sleeping workers.

Times are not compared here: machines are busy. What both do must be the same; the efficiencies of
both, measured at rest, stand in docs/scaling.md.
"""

import time
from operator import pos

import pytest
from distributed import Client

from studies.scaling.paper import pretend
from studies.scaling.virtual import Costs, VirtualClient, durations, virtual_stream
from workflow.cluster.flow import stream
from workflow.plan.plan import make_plan
from workflow.run.run import How, run_plan
from workflow.study.cluster import Cluster
from workflow.study.read import read_study
from workflow.system.process import peak_bytes

pytestmark = pytest.mark.cluster
WORKERS, SECONDS, EACH = 2, 0.05, 12


def test_the_real_and_the_simulated_cluster_do_the_same_work(standing):
    items = durations(SECONDS, EACH * WORKERS, 1)
    virtual = VirtualClient(WORKERS, Costs(1e-3, 1e-3, 1e-3), pos)
    simulated = [item for item, _ in virtual_stream(virtual, pos, items)]
    with Client(standing.address) as client:
        client.wait_for_workers(WORKERS)
        began = time.monotonic()
        real = [item for item, _ in stream(client, time.sleep, items)]
        wall = time.monotonic() - began
    assert sorted(real) == sorted(simulated) == sorted(items)
    assert min(wall, virtual.wall) >= sum(items) / WORKERS  # none is quicker than its workers


def pretended(batch, expected):
    """Stand in for run_batch: compute nothing."""
    del expected
    return pretend(batch)


@pytest.mark.parametrize("realizations", [200, 20_000])
def test_memory_of_the_driver_is_as_predicted_whatever_the_realizations(
    standing, tmp_path, realizations
):
    settings = [f"study.realizations={realizations}", "study.realizations_per_block=100"]
    plan = make_plan(read_study("fig4", "smoke", settings))
    before = peak_bytes()
    how = How(Cluster(standing.address), work=pretended, batch_seconds=1e9)
    run_plan(plan, tmp_path / "fig4.nc", how)
    assert peak_bytes() - before < 0.3 * plan.predicted_driver_bytes()
