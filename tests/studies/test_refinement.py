"""Figure 7 refined in time: the left branch belongs to implicit Euler, the right one to all."""

import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt

from workflow.cli import main
from workflow.reduce.fits import FITTED


@pytest.fixture(scope="module")
def groups(scheduler, tmp_path_factory):
    """Run the study at smoke scale; return group -> dataset, and the result file."""
    folder = tmp_path_factory.mktemp("refinement")
    words = ["--scale", "smoke", "--out", str(folder), "--scheduler", scheduler]
    assert main(["run", "refinement", *words]) == 0
    path = folder / "refinement.nc"
    found = {name.strip("/"): data.load().squeeze() for name, data in xr.open_groups(path).items()}
    for data in found.values():
        data.close()
    return found, path


def rates(data, low, high):
    """Return (x, m v2 tau/dx, b) of the fitted points with low <= x <= high."""
    chosen = (data.fit_status == FITTED) & (data.speed_ratio >= low) & (data.speed_ratio <= high)
    x = data.speed_ratio.values[chosen.values]
    return x, data.relaxation_rate.values[chosen.values]


def test_converged_rate_is_that_of_creep_at_low_speed(groups):
    x, rate = rates(groups[0][""], 0.0, 0.2)
    assert x.size >= 4
    assert np.abs(rate - 1.0).max() < 0.05


@pytest.mark.parametrize("m", [8, 16, 64])
def test_left_branch_is_the_decay_of_implicit_euler(groups, m):
    """b = ln(1 + dt)/dt: what a factor 1/(1 + dt) per step amounts to."""
    x, rate = rates(groups[0][f"euler_{m}"], 0.0, 0.2)
    dt = np.pi / (1.2 * m * x)
    assert x.size >= 4
    np.testing.assert_allclose(rate, np.log1p(dt) / dt, rtol=0.06)


def test_left_branch_rises_with_every_refinement(groups):
    slow = [
        float(groups[0][f"euler_{m}"].relaxation_rate.isel(velocity=1, hurst=0))
        for m in (2, 4, 8, 16, 64)
    ]
    assert np.all(np.diff(slow) > 0.0)
    assert slow[0] < 0.3 < 0.8 < slow[-1]


def test_exponential_scheme_has_no_left_branch_at_any_m(groups):
    for m in (8, 16, 64):
        x, rate = rates(groups[0][f"exponential_{m}"], 0.0, 0.2)
        assert x.size >= 1
        assert np.abs(rate - 1.0).max() < 0.1


def test_schemes_meet_above_one(groups):
    fast = {"velocity": slice(4, None)}  # x > 3
    limit = groups[0][""].relaxation_rate.isel(fast)
    for name in ("euler_16", "euler_64", "exponential_16", "exponential_64"):
        ratio = groups[0][name].relaxation_rate.isel(fast) / limit
        np.testing.assert_allclose(ratio, 1.0, atol=0.15)


def test_next_to_nothing_is_left_to_relax_at_low_speed(groups):
    data = groups[0][""]
    share = abs(data.amplitude / data.jump)
    assert (share.isel(velocity=0) < 1e-3).all()
    assert (share.isel(hurst=0).dropna("velocity")[-1] > 0.1).all()


def test_figure_is_drawn(groups):
    try:
        words = ["figure", "refinement", "--scale", "smoke", "--out", str(groups[1])]
        assert main(words) == 0
    finally:
        plt.close("all")
    assert groups[1].with_suffix(".png").stat().st_size > 20_000
