"""The simulated cluster: work is conserved, and a saturated one follows the formula."""

from operator import pos

import pytest
import xarray as xr

from elastomer_friction.studies.scaling.measure import table
from elastomer_friction.studies.scaling.virtual import (
    Costs,
    VirtualPool,
    durations,
    simulated,
)
from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.cluster.flow import PER_THREAD, stream
from tests.support.studies import check_drawing, load

whole_study = pytest.mark.exhaustive  # the simulation that it rests on is asked for in make test
COSTS = Costs(scheduler=2e-3, driver=5e-4, latency=1e-3)
FREE = Costs(scheduler=0.0, driver=0.0, latency=0.0)


@pytest.mark.parametrize("workers", [1, 7, 300])
def test_every_task_is_done_once_and_no_work_is_lost(workers):
    items = durations(0.5, 1000, 1)
    pool = VirtualPool(workers, COSTS, pos, pos)
    done = [item for item, _ in stream(pool, items)]
    assert sorted(done) == sorted(items)
    assert pool.tasks == len(items)
    assert pool.busy == pytest.approx(sum(items), rel=1e-12)
    assert pool.wall >= max(pool.busy / workers, max(items))


def test_efficiency_falls_with_the_workers_and_grows_with_the_batch():
    found = [
        simulated(workers, durations(seconds, 3000, 1), COSTS).efficiency
        for workers, seconds in ((1000, 0.1), (200, 0.1), (200, 1.0), (200, 10.0), (20, 10.0))
    ]
    assert 0.0 < found[0] < found[1] < found[2] < found[3] < found[4] < 1.0


@pytest.mark.parametrize("costs", [COSTS, COSTS._replace(scheduler=5e-4, driver=2e-3)])
def test_saturated_cluster_does_as_many_tasks_as_its_slowest_server(costs):
    workers, mean = 1000, 0.2
    pool = simulated(workers, durations(mean, 30 * workers, 1), costs)
    rate = 1.0 / max(costs.scheduler, costs.driver)
    assert workers / mean > 5.0 * rate  # what the workers could do
    assert pool.tasks / pool.wall == pytest.approx(rate, rel=0.05)
    assert pool.efficiency == pytest.approx(mean * rate / workers, rel=0.05)


def test_nothing_is_lost_where_nothing_costs_and_little_in_one_wave():
    alone = simulated(1, durations(2.0, 50, 1), FREE)
    assert alone.efficiency == pytest.approx(1.0, abs=1e-3)
    wave = simulated(500, [100.0] * 500, COSTS)
    assert wave.wall == pytest.approx(100.0, rel=0.03)


def test_no_more_is_in_flight_than_the_window():
    sent = []

    def source():
        for number in range(1000):
            sent.append(number)
            yield 1.0

    pool = VirtualPool(10, COSTS, pos, pos)
    for count, _ in enumerate(stream(pool, source())):
        assert len(sent) - count <= PER_THREAD * 10 + 10  # and the results not yet yielded


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """Run the study at smoke scale; return its result."""
    folder = tmp_path_factory.mktemp("scaling")
    assert main(["run", "scaling", "--scale", "smoke", "--out", str(folder)]) == 0
    return folder / "scaling-smoke.nc"


@pytest.fixture(scope="module")
def groups(path):
    """Return the groups of the result."""
    return load(path)


@whole_study
def test_figure_and_table_are_written(groups):
    check_drawing("scaling", groups)
    assert [*table(groups).columns][:2] == ["study", "workers"]


@whole_study
def test_a_result_opens_as_a_tree(path, groups):
    with xr.open_datatree(path) as tree:
        assert tree["studies"].ds.workers.attrs == groups["studies"].workers.attrs != {}


@whole_study
def test_the_same_work_is_done_by_any_number_of_workers(groups):
    studies = groups["studies"]
    work = studies.work.values
    assert work == pytest.approx(work[:, :1] * [[1.0] * work.shape[1]], rel=1e-9)
    assert (studies.wall * studies.workers >= studies.work).all()
    assert (studies.efficiency.diff("workers") < 0.0).all()
    assert (studies.shards <= studies.batches).all()
