"""Fits of eq. 6 to curves and of eq. 13 to rates; with noise: tests/hard."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.reduce.complete import fit_exponents, fit_power_law
from elastomer_friction.workflow.reduce.fits import (
    FITTED,
    NO_RELAXATION,
    NOT_EXPONENTIAL,
    NOT_FINITE,
    UNDETERMINED,
    fit_relaxation,
    fit_window,
)
from elastomer_friction.workflow.reduce.jackknife import replicates
from elastomer_friction.workflow.reduce.resolution import COARSE, RESOLVED, UNRESOLVED

SHARE = np.linspace(0.0, 4.0, 63)


def fit(deviation, time=SHARE, blocks=4, slope=1.0):
    """Fit one curve whose replicates differ by just enough to have a spread."""
    return fit_relaxation(time, spread(deviation, blocks), slope)


def spread(deviation, blocks=4):
    """Return a curve, then replicates of it that differ by 1e-10."""
    noise = np.random.default_rng(3).standard_normal((blocks + 1, len(deviation)))
    noise[0] = 0.0
    return deviation * (1.0 + 1e-10 * noise)


@given(st.floats(-3.0, 3.0), st.floats(-6.0, 2.0), st.sampled_from([-1.0, 1.0]))
def test_rate_and_amplitude_over_six_decades_with_either_sign(decade, size, sign):
    rate, amplitude = 10.0**decade, sign * 10.0**size
    actual = fit(amplitude * np.exp(-SHARE), SHARE / rate)
    assert actual.status == FITTED
    np.testing.assert_allclose(actual.rate, rate, rtol=1e-6)
    np.testing.assert_allclose(actual.amplitude, amplitude, rtol=1e-6)
    np.testing.assert_allclose(actual.rate_free, rate, rtol=1e-5)
    assert actual.quality == pytest.approx(1.0)


def test_amplitude_is_that_at_the_jump_not_at_the_first_sample():
    time = SHARE + 0.5
    actual = fit(2.0 * np.exp(-1.5 * time), time)
    assert actual.amplitude[0] == pytest.approx(2.0)


def test_window_ends_at_five_per_cent_or_with_the_curve():
    curve = np.exp(-2.0 * SHARE)
    assert fit(curve).window == SHARE[np.argmax(curve < 0.05)]
    assert fit(np.exp(-0.1 * SHARE)).window == SHARE[-1]


def test_samples_after_the_window_are_ignored():
    curve = np.exp(-2.0 * SHARE)
    tail = np.where(np.arange(63) > fit_window(curve), 0.04, 0.0)
    assert fit(curve + tail).rate[0] == fit(curve).rate[0]


def test_window_holds_three_samples_at_least():
    steep = np.array([1.0, 0.01, 0.0001, 0.0, 0.0, 0.0, 0.0])
    assert fit_window(steep) == 3
    assert fit_window(steep[:2]) == 2


def test_a_window_too_short_for_three_parameters_gives_no_free_fit():
    actual = fit(np.exp(-100.0 * SHARE))
    assert actual.status == FITTED
    assert actual.rate[0] == pytest.approx(100.0, rel=1e-3)
    assert np.isnan(actual.rate_free).all()


def test_free_asymptote_finds_the_rate_over_an_offset():
    actual = fit(0.8 * np.exp(-1.5 * SHARE) + 0.2)
    assert actual.rate_free[0] == pytest.approx(1.5, rel=1e-5)
    assert actual.rate[0] < 1.3  # with mu_2 known to be zero


def test_pure_noise_is_no_relaxation():
    actual = []
    for seed in range(100):
        noise = np.random.default_rng(seed).standard_normal((20, 63))
        actual.append(fit_relaxation(SHARE, replicates(noise, 0), 1.0).status)
    assert actual.count(NO_RELAXATION) >= 95  # one in 100 is beyond 3 standard errors of 20 blocks
    assert FITTED not in actual


def test_rounding_is_judged_against_the_slope():
    curve = 3e-15 * np.exp(-SHARE)
    assert fit(curve, slope=0.1).status == FITTED
    assert fit(1e3 * curve, slope=1e3).status == NO_RELAXATION


@pytest.mark.parametrize(("second", "status"), [(4e-19, UNDETERMINED), (2e-13, FITTED)])
def test_a_decay_within_a_step_has_no_rate(second, status):
    """At m = 8 and x = 0.03 a step lasts ten tau: a rate of 1.116 was fitted to rounding."""
    curve = np.array([2.4e-12, second, 2e-19, -1e-19])
    actual = fit(curve, np.array([9.4, 19.8, 30.2, 40.6]))
    assert actual.status == status
    assert np.isfinite(actual.rate[0]) == (status == FITTED)


SIZES = np.array([1.0, 0.9, 1.1, 1.05, 0.95])
ONE_GROWS = spread(np.exp(-SHARE))
ONE_GROWS[3] = np.exp(SHARE)
REFUSED = {
    "nothing": (spread(0.0 * SHARE), NO_RELAXATION),
    "rounding": (spread(3e-15 * np.exp(-SHARE)), NO_RELAXATION),
    "negative rounding": (spread(-3e-15 * np.exp(-SHARE)), NO_RELAXATION),
    "equal replicates": (np.tile(np.exp(-SHARE), (5, 1)), NO_RELAXATION),
    "replicates of one rate": (np.outer(SIZES, np.exp(-1.5 * SHARE)), UNDETERMINED),
    "one replicate without a fit": (ONE_GROWS, UNDETERMINED),
    "growing": (spread(np.exp(SHARE)), NOT_EXPONENTIAL),
    "constant": (spread(np.ones(63)), NOT_EXPONENTIAL),
    "turning its sign": (spread(np.where(np.arange(63) < 1, 1.0, -1.0)), NOT_EXPONENTIAL),
    "oscillating": (spread(np.cos(40.0 * SHARE)), NOT_EXPONENTIAL),
    "oscillating in growth": (spread(np.cos(10.0 * SHARE) * np.exp(SHARE)), NOT_EXPONENTIAL),
}


def assert_refused(deviation, status, time=SHARE):
    """Assert that there is no fit but a status."""
    actual = fit_relaxation(time, deviation, 1.0)
    assert actual.status == status
    assert np.isnan(np.concatenate([np.ravel(values) for values in actual[1:]])).all()


@pytest.mark.parametrize("name", REFUSED)
def test_curves_without_relaxation_have_a_status_and_nan(name):
    assert_refused(*REFUSED[name])


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", [(0, 0), (0, 62), (3, 20)])
def test_a_number_that_is_not_finite_has_a_status(value, place):
    deviation = np.tile(np.exp(-SHARE), (5, 1))
    deviation[place] = value
    assert_refused(deviation, NOT_FINITE)


def test_quality_is_lower_for_a_stretched_exponential():
    rough = fit(np.exp(-np.sqrt(4.0 * SHARE)))  # a stretched exponential
    assert rough.status == FITTED
    assert 0.9 < rough.quality < 0.999


def test_the_unit_of_friction_changes_no_bit_of_a_rate():
    """Scaling by a power of two is exact, so that only terms in another unit could change bits."""
    curve = 0.8 * np.exp(-1.5 * SHARE) + 0.2
    one, other = fit(curve), fit(2.0**-20 * curve)
    assert other.rate.tobytes() == one.rate.tobytes()
    assert other.rate_free.tobytes() == one.rate_free.tobytes()
    assert other.amplitude.tobytes() == (2.0**-20 * one.amplitude).tobytes()


@pytest.mark.parametrize(("noise", "status"), [(0.4, UNDETERMINED), (0.04, NOT_EXPONENTIAL)])
def test_residuals_of_noise_differ_from_those_of_another_law(noise, status):
    """A wave has a quarter of the sum of squares: about 1.7 times the variance of the noise."""
    wave = np.where(np.arange(63) % 2 == 0, 1.6, 0.4)
    blocks = np.random.default_rng(5).standard_normal((20, 63))
    blocks = (blocks - blocks.mean(axis=0)) * noise * np.sqrt(20.0)  # of their mean: noise
    assert_refused(replicates(wave * np.exp(-SHARE) + blocks, 0), status)


@pytest.mark.parametrize("last", [-1.1e-6, 1e-13])
def test_a_decay_within_a_sample_has_no_rate(last):
    """With steps of 8 tau only the first sample exceeds rounding; every rate above 1 fits it."""
    curves = 2.3e-4 * (1.0 + 0.05 * np.random.default_rng(1).standard_normal((16, 1)))
    deviation = np.hstack([curves, last * curves / 2.3e-4, 1e-13 * curves])
    assert_refused(replicates(deviation, 0), UNDETERMINED, np.array([8.3, 16.7, 25.0]))


X = np.geomspace(1.5, 300.0, 12)


OFF = np.full(X.size, 0.1)  # biases


def columns(rate, count=5):
    """Return the same rates for the estimate and every replicate."""
    return np.tile(rate[:, None], (1, count))


@given(st.floats(-1.0, 2.0), st.floats(0.01, 100.0))
def test_prefactor_and_exponent_are_told_apart(alpha, prefactor):
    law = fit_power_law(X, columns(prefactor * X**alpha), OFF)
    np.testing.assert_allclose(law.alpha_free, alpha, atol=1e-11)
    np.testing.assert_allclose(law.alpha_prefactor, prefactor, rtol=1e-11)


def test_scatter_is_in_decades_about_the_law_without_prefactor():
    alternating = 10.0 ** (0.1 * np.array([1, -1, -1, 1, 1, -1]))
    x = np.array([10.0, 10.0, 100.0, 100.0, 1000.0, 1000.0])
    law = fit_power_law(x, columns(x**0.5 * alternating), OFF[:6])
    assert law.alpha[0] == pytest.approx(0.5)
    assert law.alpha_scatter == pytest.approx(0.1)


@pytest.mark.parametrize("x", [X[:0], X[:1], X[:2], np.full(4, 2.0)])
def test_fewer_than_three_abscissae_give_no_number_and_no_bias(x):
    law = fit_power_law(x, columns(np.arange(1.0, x.size + 1.0)), OFF[: x.size])
    assert law.alpha_points == x.size
    assert np.isnan(np.concatenate([np.ravel(values) for values in law[:-1]])).all()
    assert law.alpha.shape == (5,)


def test_biases_of_exponents_are_those_of_biased_rates():
    """Rates are too large everywhere, then too large for large x and too small for small x."""
    law = fit_power_law(X, columns(1.1 * X**0.3), OFF)
    assert law.alpha[0] == pytest.approx(0.3 + law.alpha_bias)
    turned = X**0.3 * np.where(np.log(X) < np.log(X).mean(), 1 / 1.1, 1.1)
    law = fit_power_law(X, columns(turned), OFF)
    assert law.alpha_free[0] == pytest.approx(0.3 + law.alpha_free_bias)


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
    actual = fit_exponents((0.7, 0.2), hurst, points, columns(rate))
    assert actual["alpha"][0] == pytest.approx(0.4)
    assert actual["alpha_points"].tolist() == [12, 1]
    assert actual["alpha_unresolved"].tolist() == [1, 0]
    assert 0.0 < actual["alpha_bias"][0] < actual["alpha_free_bias"][0] < 0.02
    assert np.isnan(actual["alpha"][1])
    assert np.isnan(actual["alpha_bias"][1])
