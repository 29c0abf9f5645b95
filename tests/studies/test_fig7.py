"""Figure 7, reduced to a few points: the physics that the figure is to show."""

import numpy as np
import pytest
from matplotlib import pyplot as plt

from elastomer_friction.studies.fig7.figure import draw
from elastomer_friction.workflow.reduce.fits import NO_RELAXATION
from tests.support.studies import rates

FULL_CONTACT = 1000.0  # N


STUDY = (  # a rough and a smooth line, two loads and full contact
    "fig7",
    "study.realizations=32",
    f"grid.normal_force=[0.1, 1.0, {FULL_CONTACT}]",
    "grid.spacing=1e-5",
    "grid.velocity=[1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1]",  # x = 0.03 ... 31
)


@pytest.fixture
def converged(groups):
    """Return the rates converged in time."""
    return groups[""]


@pytest.fixture
def paper_step(groups):
    """Return the rates of implicit Euler with one step per spacing."""
    return groups["paper_step"]


def test_converged_rate_tends_to_one_at_low_speed(converged):
    _, rate = rates(converged, 0.0, 0.1)
    assert rate.size >= 6
    assert np.abs(rate - 1.0).max() < 0.05


def test_one_step_per_spacing_shows_the_left_branch_of_the_paper(paper_step):
    x, rate = rates(paper_step, 0.03, 1.0)
    assert rate.size >= 6
    assert (rate / x).min() > 0.7
    assert (rate / x).max() < 2.6


def test_left_branch_is_a_matter_of_the_time_step(converged, paper_step):
    slow = {"velocity": 1e-4, "hurst": 0.3}
    ratio = converged.relaxation_rate.sel(slow) / paper_step.relaxation_rate.sel(slow)
    assert (ratio.dropna("normal_force") > 5.0).all()


@pytest.mark.parametrize("hurst", [0.3, 0.7])
def test_rate_grows_with_speed_above_one(converged, hurst):
    x, rate = rates(converged.sel(hurst=hurst), 1.0, 100.0)
    assert np.polyfit(np.log(x), np.log(rate), 1)[0] > 0.1
    assert rate[x > 30.0].min() > rate[x < 4.0].max()


def test_rate_grows_more_slowly_on_smoother_lines(converged):
    rough, smooth = converged.alpha.values
    error = np.hypot(*converged.alpha_error.values)
    assert rough - smooth > 3.0 * error


@pytest.mark.parametrize("hurst", [0.3, 0.7])
def test_exponent_is_near_that_of_the_paper(converged, hurst):
    law = converged.sel(hurst=hurst)
    assert law.alpha_points >= 4
    assert law.alpha == pytest.approx(1.0 - hurst, abs=0.15)


def test_nothing_is_fitted_in_full_contact(converged, paper_step):
    for dataset in (converged, paper_step):
        full = dataset.sel(normal_force=FULL_CONTACT)
        assert (full.fit_status == NO_RELAXATION).all()
        assert full.relaxation_rate.isnull().all()


def test_bias_of_an_exponent_is_small_where_converged_and_less_than_at_one_step(
    converged, paper_step
):
    assert (converged.alpha_bias > 0.0).all()
    assert (converged.alpha_bias <= converged.alpha_free_bias).all()
    assert (converged.alpha_bias < 0.02).all()
    assert (paper_step.alpha_bias > 5.0 * converged.alpha_bias).all()


def test_bars_of_exponents_contain_the_bias_where_converged(result):
    figure = draw(result)
    drawn = [
        [np.ptp(bar[:, 1]) / 2.0 for bar in c.get_segments()] for c in figure.axes[2].collections
    ]
    paper, data = result["paper_step"], result[""]
    np.testing.assert_allclose(drawn[0], paper.alpha_error)
    np.testing.assert_allclose(drawn[1], data.alpha_error + data.alpha_bias)
    plt.close(figure)
