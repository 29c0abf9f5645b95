"""Every study at smoke scale: its figure is drawn, and shows the physics it is to show."""

import numpy as np
import pytest

from elastomer_friction.studies.grid6d.figure import law_error
from elastomer_friction.workflow.kinetic_law import normalised_jump
from elastomer_friction.workflow.reduce.fits import FITTED
from tests.support.studies import check_drawing, run
from tests.support.sweeps import mostly_exhaustive

SETTINGS = {  # what makes a study smaller than at smoke scale
    "fig2": ("grid.spacing=1e-5",),
    "fig3": (),
    "fig4": (),
    "fig5": ("grid.spacing=1e-5", "grid.normal_force=[0.01, 1.0, 100.0]"),
    "fig6": ("grid.spacing=1e-5",),
    "fig8": ("grid.spacing=1e-5",),
    "beyond": ("grid.spacing=1e-5", "grid.velocity=[1e-4, 1e-3, 1e-2, 1e-1]"),
    "grid6d": ("grid.hurst=0.5", "grid.roughness=[1e-6, 1e-4]", "grid.velocity=[1e-4, 1e-2]"),
}


DRAWN = ("fig2", "fig8")  # in make test; all results are looked at there


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Run every study; return name -> groups of its result."""
    folder = tmp_path_factory.mktemp("studies")
    return {name: run(folder, name, *held, drawn=False) for name, held in SETTINGS.items()}


@mostly_exhaustive("name", DRAWN, [name for name in SETTINGS if name not in DRAWN])
def test_the_figure_is_drawn(results, name):
    check_drawing(name, results[name])


def test_fig2_friction_overshoots_and_relaxes_on_both_sides(results):
    up, down = (results["fig2"][""].squeeze().sel(velocity_step=step) for step in (0.2, -0.2))
    assert up.mu[0] > up.mu_2 > up.mu_1
    assert down.mu.min() < down.mu_2 < down.mu_1
    for point in (up, down):
        late = abs(point.deviation.dropna("sample")[-1])
        assert late < 0.05 * abs(point.deviation).max()


def test_fig3_friction_is_linear_then_a_plateau(results):
    points = results["fig3"][""].squeeze()
    exponent = np.gradient(np.log(points.mu_1), np.log(points.velocity))
    assert exponent[:2] == pytest.approx([1.0, 1.0], abs=0.05)  # region I
    assert abs(exponent[-3:]).max() < 0.2  # region III
    assert 1.1 < float(points.mu_1.max() / points.rms_slope.max()) < 1.6


def test_fig4_rate_falls_with_the_spacing_through_that_of_the_paper(results):
    points = results["fig4"][""].squeeze()
    assert (points.fit_status == FITTED).all()
    assert points.relaxation_rate[0] > points.relaxation_rate[-1]
    assert 1.0 < float(points.relaxation_rate[-1]) < 3.5


def test_fig5_jump_is_proportional_to_friction_then_a_plateau(results):
    points = results["fig5"][""].squeeze()
    slow = points.isel(velocity=0)
    zeta = slow.jump / slow.mu_1 / points.velocity_step
    xi = (slow.mu_2 / slow.mu_1 - 1.0) / points.velocity_step
    assert zeta.values == pytest.approx(1.0, abs=0.02)
    assert xi.values == pytest.approx(1.0, abs=0.02)
    plateau = (points.jump / points.rms_slope / points.velocity_step).max("velocity")
    assert ((plateau > 0.33) & (plateau < 0.5)).all()


def test_fig6_jump_follows_equation_12(results):
    points = results["fig6"][""].squeeze()
    mu = points.mu_1 / points.rms_slope
    ratio = points.jump / points.rms_slope / points.velocity_step / normalised_jump(mu)
    assert abs(ratio.where(mu < 0.1) - 1.0).max() < 0.05
    assert ratio.where((mu > 0.2) & (mu < 1.0)).max() < 1.4


def test_fig8_exponent_falls_with_the_hurst_exponent(results):
    dataset = results["fig8"][""].squeeze()
    assert (np.diff(dataset.alpha) < 0.0).all()
    assert abs(dataset.alpha - (1.0 - dataset.hurst)).max() < 0.3


def test_beyond_low_speed_is_one_exponential_of_rate_one(results):
    points = results["beyond"][""].squeeze()
    slow = points.isel(velocity=0).where(points.isel(velocity=0).fit_status == FITTED)
    assert slow.relaxation_rate.count() >= 2
    assert abs(slow.relaxation_rate - 1.0).max() < 0.1
    assert (slow.best_model.dropna("hurst", how="all") >= 1).any()


def test_grid6d_scales_exactly_and_the_law_holds_at_low_friction(results):
    dataset = results["grid6d"][""].squeeze()
    one = dataset.sel(normal_force=1e-2, roughness=1e-6)
    two = dataset.sel(normal_force=1.0, roughness=1e-4)
    assert one.contact_fraction.values == pytest.approx(two.contact_fraction.values, rel=0, abs=0)
    assert (100.0 * one.mu_1).values == pytest.approx(two.mu_1.values, rel=1e-12)
    error = law_error(dataset).where(dataset.speed_ratio < 1.0)
    assert error.max() < 0.05
