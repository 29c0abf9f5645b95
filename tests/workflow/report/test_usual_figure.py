"""The figure of a study without a script: curves, and estimates over the longest axes."""

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt

from elastomer_friction.workflow.report.panels import STYLE
from elastomer_friction.workflow.report.usual_figure import draw
from tests.support.synthetic import add, result, with_rates


@pytest.fixture(autouse=True)
def _style():
    with mpl.rc_context(STYLE):
        yield
    plt.close("all")


def estimates():
    """Return a result with mu_1, jump and b over velocity, H and load."""
    data = result("fig7", hurst=[0.3, 0.5, 0.7])
    data = add(data, mu_1=data.velocity, jump=0.2 * data.velocity)
    return with_rates(data, data.speed_ratio ** (1.0 - data.hurst))


def with_curves(data):
    """Return the result with relaxation curves; those of the first velocity are lost."""
    time = xr.DataArray(np.linspace(0.0, 3.0, 9), dims="sample")
    mu = (data.mu_1 * (1.0 + 0.1 * np.exp(-time))).where(data.velocity > 2e-4)
    error = 0.01 * mu
    return data.assign(time=time + 0.0 * mu, mu=mu, deviation_error=error)


def test_estimates_are_drawn_over_the_longest_axis_with_a_colour_for_the_next():
    figure = draw({"": estimates()})
    labels = [ax.get_ylabel().partition("$")[0] for ax in figure.axes]
    assert labels == ["steady friction ", "jump ", "relaxation rate "]
    assert [ax.get_legend() is None for ax in figure.axes] == [False, True, True]
    for ax in figure.axes:
        assert ax.get_xlabel() == "$v_1$ (m/s)"
        assert len(ax.containers) == 3
        assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert texts == ["$H$ = 0.3", "$H$ = 0.5", "$H$ = 0.7"]
    assert "normal force F_N 0.1" in figure._supxlabel.get_text()


def test_curves_of_six_points_that_have_one_with_their_bands():
    ax = draw({"": with_curves(estimates())}).axes[0]
    assert len(ax.lines) == len(ax.collections) == 6
    assert all(np.isfinite(line.get_ydata()).all() for line in ax.lines)


def test_a_comparison_is_drawn_beside_the_study():
    data = estimates()
    figure = draw({"": data, "coarse": data})
    assert len(figure.axes[0].containers) == 6
    assert "coarse" in [text.get_text() for text in figure.axes[0].get_legend().get_texts()]


def test_a_single_point_and_other_quantities_have_a_figure_too():
    one = result("fig7", hurst=[0.7], normal_force=[0.1], velocity=[0.1])
    figure = draw({"": add(one, peak=0.1, healing=0.2)})
    assert {"rms_slope", "peak"} & {ax.get_ylabel() for ax in figure.axes}


def test_points_that_failed_leave_gaps():
    data = estimates()
    figure = draw({"": data.assign(mu_1=data.mu_1 * np.nan)})
    figure.canvas.draw()
    assert len(figure.axes) == 3
