"""The memory of a driver: real workers return results of the right size that took no time."""

import pytest

from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.study.read import read_study
from elastomer_friction.workflow.system import peak_bytes
from tests.cluster.many_points import pretended

pytestmark = pytest.mark.cluster


@pytest.mark.parametrize("realizations", [200, 20_000])
def test_memory_of_the_driver_is_as_predicted_whatever_the_realizations(
    standing, tmp_path, realizations
):
    settings = [f"study.realizations={realizations}", "study.realizations_per_block=100"]
    plan = make_plan(read_study("fig4", "smoke", settings))
    before = peak_bytes()
    how = RunOptions(Cluster(standing.address), work=pretended, batch_seconds=1e9)
    run_plan(plan, tmp_path / "fig4.nc", how)
    assert peak_bytes() - before < 0.3 * plan.predicted_driver_bytes()
