"""The claims of the paper, on results whose truth is known."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.studies.fig4 import claims as fig4
from elastomer_friction.studies.fig5 import claims as fig5
from elastomer_friction.studies.fig6 import claims as fig6
from elastomer_friction.studies.fig7 import claims as fig7
from elastomer_friction.studies.fig7_half_space import claims as fig7_half_space
from elastomer_friction.studies.fig8 import claims as fig8
from elastomer_friction.studies.grid6d import claims as grid6d
from elastomer_friction.workflow.kinetic_law import jump_between, normalised_jump
from elastomer_friction.workflow.report.claims import evaluate
from tests.support.synthetic import SLOPE, add, result, with_alpha, with_rates


def slow(zeta=1.0, xi=1.0, covariance=1.0, error=0.03):
    """Return figure 3 with these ratios; mu_1 and the jump correlated by ``covariance``."""
    dataset = result("fig3", hurst=[0.7], normal_force=[0.1])
    mu = dataset.velocity
    dataset = add(dataset, error, mu_1=mu, mu_2=mu * (1 + 0.2 * xi), jump=0.2 * zeta * mu)
    dataset = add(dataset, 0.0, amplitude=0.2 * (zeta - xi) * mu)
    errors = dataset.mu_1_error, dataset.jump_error
    both = errors[0] ** 2 + errors[1] ** 2 + 2.0 * covariance * errors[0] * errors[1]
    start = (dataset.mu_1 + dataset.jump).expand_dims(sample=[0, 1])
    return dataset.assign(mu=start, mu_error=np.sqrt(both).expand_dims(sample=[0, 1]))


@pytest.mark.parametrize("claim", [fig5.slow_jump, fig5.slow_steady])
@pytest.mark.parametrize(
    ("ratio", "verdict"), [(0.996, "holds"), (0.93, "holds within 7 %"), (0.6, "not found")]
)
def test_slow_sliding(claim, ratio, verdict):
    actual = claim({"fig3": slow(zeta=ratio, xi=ratio)})
    assert actual.verdict == verdict
    assert actual.found.startswith(f"{ratio:.4f} (")
    assert "points with x < 0.5, fig3" in actual.found


def test_uncertain_ratio_is_no_verdict():
    unsure = fig5.slow_jump({"fig3": slow(zeta=0.9, covariance=0.0, error=0.15)})
    assert unsure.verdict == "cannot be judged: the error is too large"


def test_figure_5_alone_has_no_error_of_the_ratio():
    actual = fig5.slow_jump({"fig5": slow(0.95).drop_vars(["mu", "mu_error"])})
    assert actual.verdict == "holds within 5 %"
    assert actual.error == "not known without the curves of fig3"


def jumps(level):
    """Return figure 6 with mu_1 saturating at 1.3 grad z and jumps of eq. 12 times ``level``."""
    dataset = result("fig6", hurst=[0.0, 0.3, 0.5, 0.7], normal_force=[1.2])
    mu = 1.3 * dataset.speed_ratio / (1.0 + dataset.speed_ratio)
    law = xr.apply_ufunc(normalised_jump, mu)
    return add(dataset, 0.001, mu_1=SLOPE * mu, jump=SLOPE * 0.2 * law * level)


@pytest.mark.parametrize(("level", "verdict"), [(1.0, "holds"), (0.5, "not found")])
def test_plateau_and_interpolation(level, verdict):
    actual = fig6.interpolation({"fig6": jumps(level)})
    assert (actual.verdict, actual.error) == (verdict, "0.1 % a point")
    assert fig6.plateau({"fig6": jumps(1.05 * level)}).verdict == verdict


@pytest.mark.parametrize(("level", "holds"), [(1.0, True), (0.65, False)])
def test_the_plateau_on_a_half_space(level, holds):
    """A level 35 % below the paper's is no plateau of the paper."""
    data = jumps(level)
    alpha = xr.zeros_like(data.hurst)
    data = data.assign(alpha=alpha, alpha_error=alpha, alpha_bias=alpha)
    actual = fig7_half_space.plateau_on_half_space({"fig7_half_space": data})
    assert actual.verdict.startswith("holds" if holds else "not found")


def test_interpolation_names_the_worst_point():
    dataset = jumps(1.0)
    dataset.jump[0, 0, 0, 0, 3, 0] *= 0.6
    actual = fig6.interpolation({"fig6": dataset})
    assert actual.verdict.endswith("% (rms), 40 % at worst")
    assert "largest 40 % at H = 0, v₁ = 0.0032 m/s" in actual.found


@pytest.mark.parametrize(
    ("converged", "coarse", "verdict"),
    [
        ("2.4 at 5 µm", None, "holds if Δx = 5 ± 0.1 µm"),
        ("5 at 10 µm", "5 at 10 µm", "not found"),
        ("1", "2.4 at 5 µm", "only with one implicit Euler step per Δx, Δx = 5 ± 0.1 µm"),
    ],
)
def test_rate_of_figure_4(converged, coarse, verdict):
    axes = {"normal_force": [1.2], "velocity": [0.05], "spacing": np.geomspace(1e-6, 1e-5, 7)}
    dataset = result("fig4", hurst=[0.7], **axes)
    laws = {
        "1": xr.ones_like(dataset.spacing),
        "2.4 at 5 µm": 2.4 * (dataset.spacing / 5e-6) ** -0.5,
        "5 at 10 µm": 5.0 * (dataset.spacing / 1e-5) ** -0.5,
    }
    results = {"fig4": with_rates(dataset.copy(), laws[converged])}
    if coarse:
        results["fig4/paper_step"] = with_rates(dataset.copy(), laws[coarse])
    assert fig4.example_rate(results).verdict == verdict


@pytest.mark.parametrize(
    ("quality", "verdict"), [(0.999, "holds"), (0.9, "not found"), (None, "holds for 86 % of the")]
)
def test_exponential(quality, verdict):
    dataset = with_rates(result(), 1.0)
    if quality is None:
        dataset.fit_quality[..., 0, :] = 0.9
    else:
        dataset.fit_quality[...] = quality
    assert fig7.exponential_fits({"fig7": dataset}).verdict.startswith(verdict)


LEFT = {
    "x": lambda d: d.speed_ratio,
    "1": lambda d: xr.ones_like(d.speed_ratio),
    "1.5 x": lambda d: 1.5 * d.speed_ratio,
}


@pytest.mark.parametrize(
    ("converged", "coarse", "verdict"),
    [
        ("x", "x", "holds"),
        ("1.5 x", "x", "holds within a factor 1.5"),
        ("1", "1.5 x", "only with one implicit Euler step per Δx, within a factor 1.5"),
        ("1", "1", "not found"),
    ],
)
def test_left_branch(converged, coarse, verdict):
    dataset = result(velocity=np.geomspace(2e-6, 1e-3, 9))
    results = {
        "fig7": with_rates(dataset.copy(), LEFT[converged](dataset)),
        "fig7/paper_step": with_rates(dataset.copy(), LEFT[coarse](dataset)),
    }
    actual = fig7.slow_rate(results)
    assert actual.verdict == verdict
    assert "b ∝ x^0.00" in actual.found or converged != "1"


def test_points_with_large_errors_or_near_full_contact_are_left_out():
    dataset = with_rates(result(velocity=np.geomspace(2e-6, 1e-3, 9)), 1.0)
    dataset.relaxation_rate_error[0] = 0.2
    dataset.contact_fraction[1] = 0.9
    assert evaluate([fig7.slow_rate, fig7.force_independence], {"fig7": dataset}) == []


@pytest.mark.parametrize(
    ("offset", "verdict"), [(0.01, "holds"), (0.093, "holds within 0.10"), (0.3, "not found")]
)
def test_exponent(offset, verdict):
    dataset = result()
    dataset = with_alpha(dataset, 1.0 - dataset.hurst + offset)
    assert fig8.exponent_converged({"fig7": dataset}).verdict == verdict
    assert "points of fig8" in fig8.exponent_converged({"fig7": dataset, "fig8": dataset}).found
    assert evaluate([fig8.exponent_paper_step], {"fig7": dataset}) == []
    assert fig8.exponent_paper_step({"fig7/paper_step": dataset}).verdict == verdict


@pytest.mark.parametrize(
    ("factor", "verdict"), [(1.0, "holds"), (0.7, "holds within a factor 1.4"), (3.0, "not found")]
)
def test_relaxation_time(factor, verdict):
    dataset = result()
    rate = factor * dataset.speed_ratio ** (1.0 - dataset.hurst)
    assert fig7.relaxation_time({"fig7": with_rates(dataset, rate)}).verdict == verdict


@pytest.mark.parametrize(
    ("ratio", "verdict"), [(1.0, "holds"), (1.2, "holds within 14 % (rms)"), (4.0, "not found")]
)
def test_force_independence(ratio, verdict):
    dataset = result()
    rate = xr.where(dataset.normal_force > 0.5, ratio, 1.0) * dataset.speed_ratio
    actual = fig7.force_independence({"fig7": with_rates(dataset, rate)})
    assert actual.verdict.startswith(verdict)
    assert f"largest ratio {ratio:.2f}" in actual.found


@pytest.mark.parametrize(("light", "verdict"), [(1.0, "holds"), (0.2, "not found")])
def test_plateau_over_the_normal_force(light, verdict):
    axes = {"hurst": [0.7], "normal_force": [0.01, 1.0], "velocity": np.geomspace(1e-3, 10.0, 9)}
    dataset = result("fig5", **axes)
    mu = 1.3 * dataset.speed_ratio / (1.0 + dataset.speed_ratio)
    level = xr.where(dataset.normal_force < 0.1, light, 1.0)
    dataset = add(dataset, 0.001, mu_1=SLOPE * mu, jump=SLOPE * 0.2 * 0.4 * level)
    actual = fig5.plateau_over_force({"fig5": dataset})
    assert actual.verdict == verdict
    assert f"{0.4 * light:.3f} at F_N = 0.01 N" in actual.found
    assert evaluate([fig5.plateau_over_force], {"fig5": dataset.isel(normal_force=[0])}) == []


@pytest.mark.parametrize(
    ("shift", "verdict"), [(0.0, "holds"), (0.09, "holds within 0.09"), (0.4, "not found")]
)
def test_exponent_over_the_normal_force(shift, verdict):
    dataset = result(hurst=[0.3, 0.7], velocity=np.geomspace(1e-3, 0.1, 7))
    alpha = 1.0 - dataset.hurst + xr.where(dataset.normal_force > 0.5, shift, 0.0)
    actual = fig7.exponent_over_force({"fig7": with_rates(dataset, dataset.speed_ratio**alpha)})
    assert actual.verdict == verdict
    assert f"spreads by {shift:.2f} at H = " in actual.found


def steps(jump=None, at="v2"):
    """Return the grid with jumps in proportion to the step or summed up, and rates at v1 or v2."""
    dataset = result("grid6d", hurst=[0.0, 0.5, 1.0], velocity_step=[-0.2, 0.3])
    mu, ratio = SLOPE * 1.2, 1.0 + dataset.velocity_step
    linear = 0.38 * SLOPE * dataset.velocity_step
    summed = xr.apply_ufunc(jump_between, mu, mu, np.log(ratio), SLOPE)
    dataset = add(dataset, 0.001, mu_1=mu, jump=summed if jump == "summed" else linear)
    x = dataset.speed_ratio * (ratio if at == "v2" else 1.0)
    return with_rates(dataset, x ** (1.0 - dataset.hurst))


@pytest.mark.parametrize(("jump", "verdict"), [("linear", "holds"), ("summed", "not found")])
def test_jump_over_the_size_of_the_step(jump, verdict):
    actual = grid6d.jump_over_step({"grid6d": steps(jump)})
    assert actual.verdict == verdict
    assert "0.78 would be small steps summed up" in actual.found


@pytest.mark.parametrize(("at", "verdict"), [("v1", "holds"), ("v2", "not found")])
def test_rate_after_steps_up_and_down(at, verdict):
    actual = grid6d.rate_after_step({"grid6d": steps(at=at)})
    assert actual.verdict == verdict
    assert f"s = {1.0 if at == 'v2' else 0.0:.2f} (" in actual.found
