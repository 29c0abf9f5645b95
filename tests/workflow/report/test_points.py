"""What is said of drawn points: value, drawn error and place, within the axes alone."""

import numpy as np
import pytest
from matplotlib import pyplot as plt

from elastomer_friction.workflow.report.panels import error_band, error_bars, remembered
from tests.support.synthetic import result


@pytest.fixture
def points():
    """Return a result over velocity alone."""
    dataset = result("fig7", hurst=[0.7], normal_force=[0.1])
    return dataset.isel(hurst=0, normal_force=0, spacing=0, roughness=0, velocity_step=0)


@pytest.fixture
def ax():
    """Return axes from 0 to 1 that fill the figure."""
    figure = plt.figure()
    yield figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    plt.close(figure)


def test_points_are_where_they_are_drawn_and_say_what_they_are(ax, points):
    points = points.assign(
        share=0.5 + 0.0 * points.rms_slope, share_error=0.1 + 0 * points.rms_slope
    )
    points = points.assign_coords(
        velocity=("velocity", np.linspace(0.2, 1.4, 7), {"units": "m s-1"})
    )
    error_bars(ax, points, "share", "velocity", bias=0.05, aside=0.01, fmt="o")
    ax.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    found = remembered(ax.figure)
    assert len(found) == 4  # 0.21 ... 0.81; the others lie outside
    assert [point.x for point in found] == pytest.approx([0.21, 0.41, 0.61, 0.81])
    assert [point.y for point in found] == pytest.approx([0.5] * 4)
    value, place = found[1].text.split("\n")
    assert value == "share = 0.5 ± 0.15"
    assert place.startswith("v₁ = 0.4 m s⁻¹, H = 0.7, F_N = 0.1 N, Δx = 2e-06 m, h = 1e-05 m")


def test_a_number_that_is_not_known_is_no_point(ax, points):
    points["rms_slope"][2] = np.nan
    error_bars(ax, points, "rms_slope", "velocity", fmt="o")
    ax.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    assert len(remembered(ax.figure)) == points.velocity.size - 1


def test_of_a_curve_some_points_are_said(ax, points):
    time = np.linspace(0.01, 0.99, 300)
    curve = points.isel(velocity=0).assign(mu=("sample", 0.5 * time), spread=("sample", 0.1 * time))
    error_band(ax, curve.assign_coords(time=("sample", time)), "mu", "spread", color="C0")
    ax.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    found = remembered(ax.figure)
    assert 30 <= len(found) <= 40
    assert found[0].text.startswith("µ = 0.005 ± 0.001\ntime = 0.01, H = 0.7")
