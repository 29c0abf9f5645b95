"""Result files open as a tree with coordinates in SI units to draw over."""

import numpy as np
import pytest
import xarray as xr

from workflow.result.netcdf import write_datasets
from workflow.result.variables import AUXILIARY, FLAGS, VARIABLES


@pytest.fixture(scope="module")
def path(tmp_path_factory, with_models):
    """Return a result with two comparisons."""
    path = tmp_path_factory.mktemp("cf") / "small.nc"
    write_datasets(path, {"": with_models, "coarse": with_models, "fine": with_models})
    return path


def test_a_result_opens_as_a_tree_and_its_curves_over_time_in_s(path):
    with xr.open_datatree(path) as tree:
        assert set(tree.children) == {"coarse", "fine"}
        assert tree.ds.coords["time_s"].attrs["units"] == "s"
        for group in (tree.ds, tree["coarse"].ds):
            assert {"time", "time_s", "speed_ratio", "q_max"} <= set(group.mu.coords)
            np.testing.assert_allclose(group.time_s, group.time * group.tau, rtol=1e-7)
            point = group.isel(velocity=0, roughness=0).squeeze()
            (line,) = point.mu.plot(x="time_s")
            assert line.get_xdata()[0] == 0.0


def test_coordinates_are_in_si_units(with_models):
    assert float(with_models.tau) == 1e-3
    assert float(with_models.shear_modulus) == 1e7
    assert float(with_models.length) == 0.01
    np.testing.assert_allclose(with_models.q_max * with_models.spacing, np.pi)
    x = with_models.velocity * with_models.tau * with_models.q_max
    np.testing.assert_allclose(with_models.speed_ratio, x.broadcast_like(with_models.speed_ratio))
    assert set(AUXILIARY) <= set(VARIABLES)


def test_every_flag_says_what_its_values_mean():
    assert set(FLAGS) == {name for name, each in VARIABLES.items() if each.dtype == "int8"}
