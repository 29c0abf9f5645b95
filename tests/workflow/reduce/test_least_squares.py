"""Least squares of many curves at once: the minimum of each row, independent of the others."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import curve_fit

from elastomer_friction.workflow.reduce.decays import RATE_RANGE, fit_decays
from elastomer_friction.workflow.reduce.least_squares import fit_curves
from elastomer_friction.workflow.reduce.models import one_exponential, stretched
from tests.support.sweeps import examples

TIME = np.linspace(0.02, 4.0, 63)


EVEN = np.ones(TIME.size)


def decaying(rows, offset=0.0, size=0.02):
    """Return decaying curves with noise."""
    rng = np.random.default_rng(1)
    rate = rng.uniform(0.5, 2.0, (rows, 1))
    return np.exp(-rate * TIME) + offset + size * rng.standard_normal((rows, TIME.size))


@settings(max_examples=examples(40))
@given(st.floats(-3.0, 3.0), st.floats(0.3, 3.0), st.floats(0.4, 1.5))
def test_exact_curves_give_their_parameters(size, rate, exponent):
    truth = np.array([[10.0**size, np.log(rate), np.log(exponent)]])
    curve, _ = stretched(truth, TIME)
    actual = fit_curves(stretched, TIME, curve / curve[0, 0], np.array([1.0, 0.0, 0.0]))
    np.testing.assert_allclose(actual[0, 1:], truth[0, 1:], atol=1e-6)


def test_noisy_curves_are_fitted_as_by_an_independent_solver():
    curves = decaying(6)
    actual = fit_curves(one_exponential, TIME, curves, np.array([1.0, 0.0]))
    for p, curve in zip(actual, curves, strict=True):
        expected, _ = curve_fit(lambda t, a, b: a * np.exp(-b * t), TIME, curve, (1.0, 1.0))
        assert (p[0], np.exp(p[1])) == pytest.approx(tuple(expected), rel=1e-6)


def test_a_row_does_not_depend_on_other_rows():
    curves, start = decaying(8), np.array([1.0, 0.0])
    together = fit_curves(one_exponential, TIME, curves, start)
    for row in range(8):
        alone = fit_curves(one_exponential, TIME, curves[row : row + 1], start)
        np.testing.assert_allclose(alone[0], together[row], rtol=1e-7)


@pytest.mark.parametrize("curve", [np.exp(5.0 * TIME), np.full(TIME.size, np.nan), -np.ones(63)])
def test_a_fit_that_cannot_succeed_ends_no_worse_than_it_began(curve):
    start = np.array([1.0, 0.0])
    with np.errstate(all="ignore"):
        actual = fit_curves(one_exponential, TIME, curve[None], start)
        after, before = (
            np.sum((one_exponential(p[None], TIME)[0][0] - curve) ** 2) for p in (actual[0], start)
        )
    assert after <= before or np.isnan(before)


@settings(max_examples=examples(60))
@given(st.floats(-8.0, 8.0), st.sampled_from([-1.0, 1.0]), st.floats(0.05, 30.0), st.booleans())
def test_exact_decays_give_their_parameters(size, sign, rate, offset):
    a = sign * 10.0**size
    curve = a * np.exp(-rate * TIME) + (0.3 * a if offset else 0.0)
    actual = fit_decays(TIME, curve[None], EVEN, np.array([0.6 * rate]), offset)
    np.testing.assert_allclose(actual[0], (a, rate), rtol=1e-7)


@pytest.mark.parametrize("offset", [False, True])
@pytest.mark.parametrize("late", [1.0, 5.0])
def test_noisy_decays_are_fitted_as_by_an_independent_solver(offset, late):
    """Samples that weigh alike, and late ones that weigh more."""
    weight, curves = np.linspace(1.0, late, TIME.size), decaying(6, 0.2 * offset)
    actual = fit_decays(TIME, curves, weight, np.ones(6), offset)
    for (a, b), curve in zip(actual, curves, strict=True):

        def law(t, a, b, c=0.0):
            return a * np.exp(-b * t) + c

        start, each = (1.0, 1.0, 0.0)[: 2 + offset], weight**-0.5
        expected, _ = curve_fit(law, TIME, curve, start, each)
        assert (a, b) == pytest.approx(tuple(expected[:2]), rel=1e-6)


@pytest.mark.parametrize("offset", [False, True])
def test_a_row_does_not_depend_on_other_rows_or_its_unit(offset):
    """To the bit, for units that are powers of two."""
    curves = decaying(8, 0.2 * offset, size=0.1)
    actual = fit_decays(TIME, curves, EVEN, np.ones(8), offset)
    for row in range(8):
        alone = fit_decays(TIME, curves[row : row + 1], EVEN, np.ones(1), offset)
        np.testing.assert_array_equal(alone[0], actual[row])
    larger = fit_decays(TIME, 2.0**30 * curves, EVEN, np.ones(8), offset)
    np.testing.assert_array_equal(larger, actual * [2.0**30, 1.0])


def test_curves_without_a_decay_end_without_warnings():
    """A rising curve, noise, a single nonzero sample, zeros, and NaN as the initial rate."""
    rng = np.random.default_rng(2)
    spike = np.eye(1, TIME.size)[0]
    curves = np.array([TIME, rng.standard_normal(TIME.size), spike, 0.0 * TIME, TIME])
    rates = np.array([1.0, 1.0, 1.0, 1.0, np.nan])
    for offset in (False, True):
        actual = fit_decays(TIME, curves, EVEN, rates, offset)
        known = actual[np.isfinite(actual).all(axis=1)]
        span = known[:, 1] * TIME[-1]
        assert ((span >= 0.999 * RATE_RANGE[0]) & (span <= 1.001 * RATE_RANGE[1])).all()
        assert np.isnan(actual[4]).all()
    flat, steep = (fit_decays(TIME, curves[i : i + 1], EVEN, rates[:1])[0, 1] for i in (0, 2))
    assert flat < 0.01 / TIME[-1]
    assert steep > 10.0 / (TIME[1] - TIME[0])


def test_three_samples_are_enough():
    time = np.array([0.5, 1.0, 2.0])
    curve = -3.0 * np.exp(-0.7 * time)
    actual = fit_decays(time, curve[None], np.array([1.0, 0.5, 1.0]), np.array([0.2]), offset=True)
    np.testing.assert_allclose(actual[0], (-3.0, 0.7), rtol=1e-7)
