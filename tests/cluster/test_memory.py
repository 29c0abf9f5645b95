"""The memory of a driver: real workers return results of the right size that took no time."""

import pytest

from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.study.read import read_study
from elastomer_friction.workflow.system import peak_bytes
from tests.cluster.many_points import pretended
from tests.support.runs import run

pytestmark = pytest.mark.cluster


@pytest.fixture(scope="module")
def warm(standing, tmp_path_factory):
    """Return the cluster after a run, by which all is imported that a driver needs."""
    run(tmp_path_factory.mktemp("warm"), scheduler=standing.address)
    return standing


@pytest.mark.parametrize("realizations", [200, 20_000])
def test_memory_of_the_driver_is_as_predicted_whatever_the_realizations(
    warm, tmp_path, realizations
):
    settings = [f"study.realizations={realizations}", "study.realizations_per_block=100"]
    plan = make_plan(read_study("fig4", "smoke", settings))
    before = peak_bytes()
    how = RunOptions(Cluster(warm.address), work=pretended, batch_seconds=1e9)
    run_plan(plan, tmp_path / "fig4.nc", how)
    assert peak_bytes() - before < 0.1 * plan.predicted_driver_bytes()
