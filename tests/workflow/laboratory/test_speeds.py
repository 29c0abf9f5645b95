"""Several speeds: what their rates and jumps determine, and nothing elsewhere."""

import numpy as np
import pytest

from elastomer_friction.workflow.laboratory.estimate import Estimate
from elastomer_friction.workflow.laboratory.parting import measured_steps
from elastomer_friction.workflow.laboratory.step_fit import fit_step
from elastomer_friction.workflow.laboratory.together import (
    Known,
    fit_rates,
    fit_slope,
    predicted_jump,
)
from tests.workflow.laboratory.given import HURST, Q_MAX, SLOPE, TAU, law, record

STEP = fit_step(*measured_steps(record()))
BOTH, RIGHT, LEFT = [2e-3, 5e-3, 8e-3, 2e-2, 5e-2, 0.1, 0.3], [0.02, 0.05, 0.1, 0.3], [1e-3, 3e-3]
NAMES = ("relaxation_time", "hurst", "q_max")


def rates(speeds, known=Known(), share=0.02, seed=None, **changes):  # noqa: B008
    """Return what rates at speeds after steps determine; seed: of their scatter, None for none."""
    off = 0.0 * np.array(speeds)
    if seed is not None:
        off = share * np.random.default_rng(seed).standard_normal(len(speeds))
    fits = []
    for v, more in zip(speeds, off, strict=True):
        rate = float(np.exp(more) / law(**changes).relaxation_times(v))
        step = STEP.step._replace(v1=v / 1.2, v2=v)
        fits.append(STEP._replace(step=step, rate=Estimate(rate, share * rate)))
    return fit_rates(fits, known)


def found(result):
    """Return which of tau, H and q_max are determined."""
    return [name for name in NAMES if getattr(result, name).known]


@pytest.mark.parametrize("below", [False, True])
def test_stated_errors_hold_two_thirds_of_the_estimates(below):
    results = [rates(BOTH, seed=seed, time_below_one=below) for seed in range(30)]
    assert all(result.time_below_one == below for result in results)
    for name, true in zip(NAMES, (TAU, HURST, Q_MAX), strict=True):
        estimates = [getattr(result, name) for result in results]
        pulls = np.array([(each.value - true) / each.error for each in estimates])
        assert np.isfinite(pulls).all()
        assert np.mean(abs(pulls) < 1.0) > 0.5, name
        assert np.mean(abs(pulls) < 3.0) > 0.95, name


@pytest.mark.parametrize(
    ("speeds", "known", "determined"),
    [
        (BOTH, Known(), ["relaxation_time", "hurst", "q_max"]),
        (RIGHT, Known(), ["hurst"]),
        (RIGHT, Known(relaxation_time=TAU), ["relaxation_time", "hurst", "q_max"]),
        (RIGHT, Known(q_max=Q_MAX), ["relaxation_time", "hurst", "q_max"]),
        ([0.1], Known(), []),
        ([0.1], Known(relaxation_time=TAU), ["relaxation_time"]),
        ([0.1], Known(TAU, None, Q_MAX), ["relaxation_time", "hurst", "q_max"]),
        ([0.1], Known(None, HURST, Q_MAX), ["relaxation_time", "hurst", "q_max"]),
        (LEFT, Known(None, HURST, Q_MAX), ["hurst", "q_max"]),
    ],
)
def test_what_the_speeds_determine(speeds, known, determined):
    result = rates(speeds, known)
    assert found(result) == determined
    for name, true in zip(NAMES, (TAU, HURST, Q_MAX), strict=True):
        each = getattr(result, name)
        assert not each.known or abs(each.value - true) <= max(each.error, 1e-9 * true)


def test_one_speed_has_no_exponent_and_several_that_of_the_right_branch():
    one, many = rates([0.1]), rates(RIGHT)
    assert not one.exponent.known
    assert one.speeds == 1
    assert one.rate.value == pytest.approx(1.0 / law().relaxation_times(0.1))
    assert many.exponent.value == pytest.approx(1.0 - HURST)
    assert many.speeds == 4


def test_rates_that_scatter_more_than_their_errors_enlarge_them():
    calm, wild = (rates(BOTH, share=0.005, seed=1), rates(BOTH, share=0.005))
    assert calm.squares > wild.squares
    scattered = [rates(BOTH, share=0.05, seed=s) for s in range(3)]
    assert all(each.hurst.error > 2.0 * wild.hurst.error for each in scattered)


def test_no_rate_no_result():
    assert fit_rates([STEP._replace(rate=Estimate())], Known()) is None


def slope(speeds, share=0.02, seed=None, ratio=1.2):
    """Return grad z from jumps with relative errors; seed: of their scatter, None for none."""
    rng = np.random.default_rng(seed)
    fits = []
    for v in speeds:
        off = share * rng.standard_normal() if seed is not None else 0.0
        jump = float(law().jump(v, ratio * v)) * (1.0 + off)
        step = STEP.step._replace(v1=v, v2=ratio * v)
        mu_1, mu_2 = (Estimate(float(law().steady(each)), 0.0) for each in (v, ratio * v))
        jump = Estimate(jump, share * abs(jump))
        fits.append(STEP._replace(step=step, mu_1=mu_1, mu_2=mu_2, jump=jump))
    return fit_slope(fits)


@pytest.mark.parametrize("ratio", [0.8, 1.2, 3.0])
def test_the_slope_of_the_law_is_found(ratio):
    assert slope([0.05, 0.1, 1.0], ratio=ratio).value == pytest.approx(SLOPE, rel=2e-3)


def test_stated_errors_of_the_slope_hold_two_thirds_of_them():
    found = [slope([0.02, 0.05, 0.2, 1.0], seed=seed) for seed in range(40)]
    pulls = np.array([(each.value - SLOPE) / each.error for each in found])
    assert np.mean(abs(pulls) < 1.0) > 0.5
    assert np.mean(abs(pulls) < 3.0) > 0.95


def test_jumps_in_proportion_to_friction_say_nothing():
    assert not slope([1e-5, 1e-4]).known
    assert not fit_slope([STEP._replace(jump=Estimate())]).known


def test_the_jump_is_that_of_equation_12():
    for v in (1e-3, 0.1):
        jump = predicted_jump(np.array([float(law().steady(v))]), SLOPE)
        assert 1e-3 * jump[0] == pytest.approx(float(law().jump(v, 1.001 * v)), rel=1e-3)
