"""What is asked for is simulated, and nothing else: runs of other scenes."""

import numpy as np
import pytest

from tests.support.runs import run


@pytest.fixture(scope="module")
def scenes(scheduler, tmp_path_factory):
    """Return results of the small study where much relaxes: with and without indentation rate."""
    folder = tmp_path_factory.mktemp("scenes")
    where = ("grid.velocity=[0.1, 1.0]", "study.realizations=20")
    kept = run(scheduler, folder, *where)
    return kept.load(), run(scheduler, folder, *where, "scene.indentation_rate=false").load()


def test_without_the_indentation_rate_steady_friction_and_jump_are_the_same(scenes):
    kept, dropped = scenes
    for name in ("mu_1", "mu_2", "jump", "indentation"):
        assert np.array_equal(kept[name], dropped[name])


def test_without_the_indentation_rate_the_jump_is_over_in_one_step(scenes):
    kept, dropped = (abs(dataset.deviation).isel(sample=[0, 1]) for dataset in scenes)
    assert (kept.isel(sample=1) > 0.35 * kept.isel(sample=0)).all()
    assert (dropped.isel(sample=1) < 0.3 * dropped.isel(sample=0)).all()


def test_without_the_indentation_rate_fewer_relaxations_are_found(scenes):
    kept, dropped = ((dataset.fit_status == 0).sum().item() for dataset in scenes)
    assert kept >= 6
    assert dropped < 0.5 * kept


def test_steady_sliding_alone_leaves_the_rest_out(finished, scheduler, tmp_path):
    steady = run(scheduler, tmp_path, 'scene.quantities=["steady"]').load()
    kept = {"mu_1", "mu_2", "indentation", "contact_fraction"}
    errors = {f"{name}_error" for name in kept}
    always = {"rms_slope", "speed_ratio", "realizations", "steps_per_spacing"}
    assert set(steady.data_vars) == kept | errors | always
    assert "sample" not in steady.dims
