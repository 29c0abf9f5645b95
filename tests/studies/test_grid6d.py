"""Prediction error of the law: zero on curves made by the law, known where they differ."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.studies.grid6d.figure import law_curve, law_error, shares_within
from elastomer_friction.workflow.kinetic_law import jump_between


def result(x):
    """Two points whose curves follow eqs. 14, 15 exactly; time in tau."""
    x = np.array(x)
    hurst, slope, step, mu_1 = 0.4, 0.1, 0.2, np.array([0.03, 0.08])
    mu_2 = 1.1 * mu_1
    after = (1.0 + step) * x
    rate = np.where(after < 1.0, after, after ** (1.0 - hurst))
    time = np.linspace(0.0, 5.0, 20) / rate[:, None]
    start = mu_1 + jump_between(mu_1, mu_2, np.log(1.0 + step), slope)
    mu = mu_2[:, None] + (start - mu_2)[:, None] * np.exp(-rate[:, None] * time)
    return xr.Dataset(
        {
            "mu_1": ("velocity", mu_1),
            "mu_2": ("velocity", mu_2),
            "rms_slope": ("velocity", np.full(2, slope)),
            "speed_ratio": ("velocity", x),
            "mu": (("velocity", "sample"), mu),
            "time": (("velocity", "sample"), time),
        },
        {"hurst": hurst, "velocity_step": step},
    )


def test_curves_of_the_law_are_predicted_exactly():
    data = result([0.2, 30.0])
    np.testing.assert_allclose(law_curve(data), data.mu, rtol=1e-12)
    assert law_error(data).values == pytest.approx([0.0, 0.0], abs=1e-12)


def test_the_other_left_branch_differs_below_one_only():
    error = law_error(result([0.2, 30.0]), time_below_one=True).values
    assert error[0] > 1e-3
    assert error[1] < 1e-12


def test_error_is_relative_to_the_friction_before():
    data = result([2.0, 30.0])
    data["mu"] = data.mu + 0.01 * data.mu_1
    assert law_error(data).values == pytest.approx([0.01, 0.01], rel=1e-9)


def test_shares_count_known_points():
    assert shares_within(np.array([0.005, 0.03, 0.1, 0.5, np.nan])) == [0.25, 0.5, 0.75]
