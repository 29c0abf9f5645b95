"""Fits of eq. 13, b = x^alpha; with noise: tests/hard."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workflow.reduce.exponents import fit_power_law

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
