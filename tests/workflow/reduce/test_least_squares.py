"""Least squares of many curves at once: the minimum, found row by row, whatever the company."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import curve_fit

from elastomer_friction.workflow.reduce.least_squares import fit_curves
from elastomer_friction.workflow.reduce.models import one_exponential, stretched
from tests.support.sweeps import examples

TIME = np.linspace(0.02, 4.0, 63)


def noisy(rows, seed=1):
    """Return decaying curves with noise."""
    rng = np.random.default_rng(seed)
    rate = rng.uniform(0.5, 2.0, (rows, 1))
    return np.exp(-rate * TIME) + 0.02 * rng.standard_normal((rows, TIME.size))


@settings(max_examples=examples(40))
@given(st.floats(-3.0, 3.0), st.floats(0.3, 3.0), st.floats(0.4, 1.5))
def test_exact_curves_give_their_parameters(size, rate, exponent):
    truth = np.array([[10.0**size, np.log(rate), np.log(exponent)]])
    curve, _ = stretched(truth, TIME)
    found = fit_curves(stretched, TIME, curve / curve[0, 0], np.array([1.0, 0.0, 0.0]))
    np.testing.assert_allclose(found[0, 1:], truth[0, 1:], atol=1e-6)


def test_noisy_curves_are_fitted_as_by_an_independent_solver():
    curves = noisy(6)
    found = fit_curves(one_exponential, TIME, curves, np.array([1.0, 0.0]))
    for p, curve in zip(found, curves, strict=True):
        expected, _ = curve_fit(lambda t, a, b: a * np.exp(-b * t), TIME, curve, (1.0, 1.0))
        assert (p[0], np.exp(p[1])) == pytest.approx(tuple(expected), rel=1e-6)


def test_a_row_does_not_depend_on_its_company():
    curves, start = noisy(8), np.array([1.0, 0.0])
    together = fit_curves(one_exponential, TIME, curves, start)
    for row in range(8):
        alone = fit_curves(one_exponential, TIME, curves[row : row + 1], start)
        np.testing.assert_allclose(alone[0], together[row], rtol=1e-7)


@pytest.mark.parametrize("curve", [np.exp(5.0 * TIME), np.full(TIME.size, np.nan), -np.ones(63)])
def test_a_fit_that_cannot_succeed_ends_no_worse_than_it_began(curve):
    start = np.array([1.0, 0.0])
    with np.errstate(all="ignore"):
        found = fit_curves(one_exponential, TIME, curve[None], start)
        after, before = (
            np.sum((one_exponential(p[None], TIME)[0][0] - curve) ** 2) for p in (found[0], start)
        )
    assert after <= before or np.isnan(before)
