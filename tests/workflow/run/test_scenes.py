"""A run of scenes: several rheologies and a programme over a grid, with all that a run promises."""

import numpy as np
import pytest

from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.simulate import block_means
from elastomer_friction.workflow.store.store import Store, store_folder
from elastomer_friction.workflow.study.cluster import LOCAL, Cluster
from tests.support.documents import without
from tests.support.runs import Run, shards
from tests.support.shards import held
from tests.support.small import all_records, small_plan

TEXT = without("material.relaxation_time", "grid.velocity_step", "compare.coarse", "scales.wide")
SCENES = (
    "study.realizations=4",
    "material.branches=[[1e8, 1e-4], [2e7, 1e-3]]",
    "grid.spacing=2e-4",
    'scene.quantities=["steady", "trace", "peak", "healing"]',
    "scene.programme=[{slide={ratio=1, distance=1e-3}}, {hold={duration=1e-2}}, "
    "{slide={ratio=1, distance=4e-4}}, {slide={ratio=1.2, distance=4e-4}}]",
    "numerics.steps_per_spacing=2",
    "compare.solid.branches=[[8e7, 1e-3]]",
    "compare.other_scheme.scheme=implicit-euler",
)


def run(folder, *settings, scheduler=LOCAL, batch_seconds=0.2, **how):
    """Run the scenes, in this process unless a scheduler is given."""
    plan, path = small_plan(*SCENES, *settings, text=TEXT), folder / "small.nc"
    how = RunOptions(Cluster(scheduler), batch_seconds=batch_seconds, **how)
    return Run(plan, run_plan(plan, path, how), path)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Return a finished run. Leave its folder as it is."""
    return run(tmp_path_factory.mktemp("scenes"))


def test_every_rheology_has_its_own_result(whole):
    assert held(Store(store_folder(whole.path))) == set(all_records(whole.plan))
    shape = (2, 2, 1, 1, 2)  # hurst, load, spacing, roughness, velocity
    found = [whole.load(group).squeeze("velocity_step", drop=True) for group in (None, "solid")]
    for dataset in found:
        assert dataset.mu_1.shape == shape
        assert (dataset.mu_1 > 0.0).all()
        assert dataset.trace_mu.shape[:5] == shape
        assert np.isfinite(dataset.trace_mu.values[..., 0]).all()
    assert not np.allclose(found[0].mu_1, found[1].mu_1, rtol=0.01)
    other = whole.load("other_scheme")
    # Euler's few steps per spacing lose up to half of the friction.
    ratio = other.mu_1.squeeze() / found[0].mu_1.squeeze()
    assert ((ratio > 0.5) & (ratio < 1.1)).all()


def test_other_batches_on_a_cluster_give_the_same_bytes(whole, scheduler, tmp_path):
    cut = run(tmp_path, scheduler=scheduler, batch_seconds=1e-6)
    assert cut.summary.batches > 2 * whole.summary.batches
    assert cut.path.read_bytes() == whole.path.read_bytes()


def _ends_early(batch):
    """Compute a batch, but for the problems of the rougher lines."""
    if batch.tasks[0].problem.hurst < 0.5:
        raise RuntimeError("ended")
    return block_means(batch)


def test_a_run_that_ends_early_goes_on_and_a_second_one_computes_nothing(whole, tmp_path):
    ended = run(tmp_path, max_failures=10**6, work=_ends_early)
    stored = held(Store(store_folder(ended.path)))
    assert 0 < len(stored) < len(all_records(ended.plan))
    before = shards(tmp_path)
    resumed = run(tmp_path, retry_failed=True)
    assert resumed.summary.reused == len(stored)
    assert before.items() <= shards(tmp_path).items()
    assert resumed.path.read_bytes() == whole.path.read_bytes()
    again = run(tmp_path)
    assert (again.summary.batches, again.summary.reused) == (0, len(all_records(whole.plan)))
    assert again.path.read_bytes() == whole.path.read_bytes()


def test_a_temperature_that_acts_as_a_velocity_does_is_computed_once(tmp_path):
    """At 70 degrees all times are a tenth: there 0.1 m/s is the problem of 0.01 m/s at 20."""
    settings = (
        "material.wlf={c1=2, c2=50, reference=20}",
        "material.temperature=[20, 70]",
        "grid.velocity=[0.01, 0.1]",
        "grid.hurst=0.7",
        "scene.programme=[{slide={ratio=1, distance=1e-3}}, {slide={ratio=1.2, distance=4e-4}}]",
        'scene.quantities=["steady", "trace"]',
    )
    found = run(tmp_path, *settings)
    assert (found.plan.points, found.plan.problems) == (8, 6)
    dataset = found.load()
    cold = dataset.sel(temperature=20, velocity=0.01)
    warm = dataset.sel(temperature=70, velocity=0.1)
    assert (cold.mu_1.values == warm.mu_1.values).all()
    assert not (cold.mu_1.values == dataset.sel(temperature=20, velocity=0.1).mu_1.values).any()
