"""The study of stability at smoke scale: every case within rounding, the map drawn, the table."""

import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt

from workflow.cli import main


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """Run the study at smoke scale and return its result file."""
    folder = tmp_path_factory.mktemp("stability")
    assert main(["run", "stability", "--scale", "smoke", "--out", str(folder)]) == 0
    return folder / "stability.nc"


@pytest.mark.parametrize("group", [None, "corners"])
def test_no_case_is_lost_falls_or_leaves_the_normal_numbers(result, group):
    with xr.open_dataset(result, group=group) as data:
        for kind in ("falling", "subnormal", "not_finite", "contact"):
            assert data[kind].max() == 0.0
        assert np.isfinite(data.to_dataarray() if group is None else data.balance).all()


@pytest.mark.parametrize("group", [None, "corners"])
def test_residuals_are_rounding_times_the_stiffness(result, group):
    """K = 1/dt = x m / pi times the larger speed: at most 1.3e8 here, times eps = 2e-16."""
    with xr.open_dataset(result, group=group) as data:
        for kind in ("balance", "mean", "energy"):
            assert data[kind].max() < 1e-6
        for kind in ("steady", "march"):
            assert data[kind].max() < 1e-9
        assert 2 <= data.passes.max() <= 15
        assert 2 <= data.sweeps.max() <= 15


def test_low_speed_is_exact_to_rounding(result):
    with xr.open_dataset(result) as data:
        slow = data.sel(speed_ratio=data.speed_ratio < 1.0)
        assert max(slow[kind].max() for kind in ("balance", "mean", "energy", "steady")) < 1e-12


def test_full_contact_does_not_depend_on_the_samples_and_narrow_contacts_do(result):
    with xr.open_dataset(result) as data:
        assert data.refinement.sel(mean_load=1e4, speed_ratio=1e-4, method="nearest").max() < 1e-6
        assert data.refinement.sel(mean_load=1e-6, speed_ratio=1e6, method="nearest").min() > 1e-3


def test_the_figure_is_drawn_and_the_table_names_the_worst_case_of_every_kind(result):
    try:
        assert main(["figure", "stability", "--out", str(result)]) == 0
    finally:
        plt.close("all")
    assert result.with_suffix(".png").stat().st_size > 20_000
    assert main(["table", "stability", "--out", str(result)]) == 0
    rows = result.with_suffix(".csv").read_text().splitlines()
    assert [row.split(",")[0] for row in rows[1:]] == [
        *("balance", "mean", "contact", "energy", "steady", "march"),
        *("falling", "subnormal", "not_finite", "passes", "sweeps"),
    ]
