"""Fits of eq. 13, b = x^alpha, and their biases; with noise: tests/hard."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.reduce.complete import (
    COARSE,
    RESOLVED,
    UNRESOLVED,
    exponent_bias,
    fit_exponents,
    fit_power_law,
)
from elastomer_friction.workflow.reduce.fits import FITTED

X = np.geomspace(1.5, 300.0, 12)


def columns(rate, count=5):
    """Return the same rates for the estimate and every replicate."""
    return np.tile(rate[:, None], (1, count))


@given(st.floats(-1.0, 2.0))
def test_exact_power_law(alpha):
    law = fit_power_law(X, columns(X**alpha))
    np.testing.assert_allclose(law.alpha, alpha, atol=1e-12)
    assert law.scatter == pytest.approx(0.0, abs=1e-12)
    assert law.points == 12


@given(st.floats(-1.0, 2.0), st.floats(0.01, 100.0))
def test_prefactor_and_exponent_are_told_apart(alpha, prefactor):
    law = fit_power_law(X, columns(prefactor * X**alpha))
    np.testing.assert_allclose(law.alpha_free, alpha, atol=1e-11)
    np.testing.assert_allclose(law.prefactor, prefactor, rtol=1e-11)


def test_scatter_is_in_decades_about_the_law_without_prefactor():
    alternating = 10.0 ** (0.1 * np.array([1, -1, -1, 1, 1, -1]))
    x = np.array([10.0, 10.0, 100.0, 100.0, 1000.0, 1000.0])
    law = fit_power_law(x, columns(x**0.5 * alternating))
    assert law.alpha[0] == pytest.approx(0.5)
    assert law.scatter == pytest.approx(0.1)


def test_each_replicate_has_a_fit_of_its_own():
    law = fit_power_law(X, np.stack([X**0.3, X**0.5, X**0.7], axis=1))
    np.testing.assert_allclose(law.alpha, [0.3, 0.5, 0.7])
    np.testing.assert_allclose(law.alpha_free, [0.3, 0.5, 0.7])


@pytest.mark.parametrize("count", [0, 1, 2])
def test_fewer_than_three_points_give_no_number(count):
    law = fit_power_law(X[:count], columns(X[:count]))
    assert law.points == count
    assert np.isnan([*law.alpha, *law.alpha_free, *law.prefactor, law.scatter]).all()
    assert law.alpha.shape == (5,)


def test_points_at_one_abscissa_give_no_number():
    law = fit_power_law(np.full(4, 2.0), columns(np.arange(1.0, 5.0)))
    assert np.isnan(law.alpha).all()


def test_biases_of_exponents_are_what_rates_that_are_all_off_give():
    """The first of a rate that is off everywhere, the second of one off the other way below."""
    off = np.full(X.size, 0.1)
    one, free = exponent_bias(X, off)
    assert fit_power_law(X, columns(1.1 * X**0.3)).alpha[0] == pytest.approx(0.3 + one)
    turned = X**0.3 * np.where(np.log(X) < np.log(X).mean(), 1 / 1.1, 1.1)
    assert fit_power_law(X, columns(turned)).alpha_free[0] == pytest.approx(0.3 + free)


@pytest.mark.parametrize("x", [X[:2], np.full(4, 2.0)])
def test_no_fit_has_no_bias(x):
    assert np.isnan(exponent_bias(x, np.full(x.size, 0.1))).all()


def test_exponents_leave_out_what_is_unresolved_slow_or_of_another_hurst_exponent():
    x = np.append(X, [0.5, 30.0, 30.0, 30.0])
    status = np.full(x.size, RESOLVED)
    status[0], status[13] = COARSE, UNRESOLVED
    fitted = np.full(x.size, FITTED)
    fitted[14] = FITTED + 1
    hurst = np.full(x.size, 0.7)
    hurst[15] = 0.2
    rate = x**0.4
    rate[12:] = 5.0  # would move the exponent
    points = {
        "speed_ratio": x,
        "fit_status": fitted,
        "resolution_status": status,
        "relaxation_rate_bias": np.full(x.size, 0.01),
    }
    found = fit_exponents((0.7, 0.2), hurst, points, columns(rate))
    assert found["alpha"][0] == pytest.approx(0.4)
    assert found["alpha_points"].tolist() == [12, 1]
    assert found["alpha_unresolved"].tolist() == [1, 0]
    assert 0.0 < found["alpha_bias"][0] < found["alpha_free_bias"][0] < 0.02
    assert np.isnan(found["alpha"][1])
    assert np.isnan(found["alpha_bias"][1])
