"""Fits of eq. 6: exact on exact curves, honest on noisy ones, silent where nothing relaxes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workflow.reduce.fits import (
    FITTED,
    NO_RELAXATION,
    NOT_EXPONENTIAL,
    NOT_FINITE,
    UNDETERMINED,
    fit_relaxation,
    fit_window,
)
from workflow.reduce.jackknife import replicates, standard_error

SHARE = np.linspace(0.0, 4.0, 63)


def fit(deviation, time=SHARE, blocks=4, slope=1.0):
    """Fit one curve whose replicates differ by just enough to have a spread."""
    return fit_relaxation(time, spread(deviation, blocks), slope)


def spread(deviation, blocks=4):
    """Return a curve, then replicates of it that differ by 1e-10."""
    noise = np.random.default_rng(3).standard_normal((blocks + 1, len(deviation)))
    noise[0] = 0.0
    return deviation * (1.0 + 1e-10 * noise)


def noisy(rng, rate, amplitude, noise, blocks=40):
    """Return block curves: an amplitude that varies by 20 %, and white noise."""
    share = amplitude * (1.0 + 0.2 * rng.standard_normal((blocks, 1)))
    curves = share * np.exp(-rate * SHARE)
    return curves + noise * abs(amplitude) * rng.standard_normal((blocks, SHARE.size))


@given(st.floats(-3.0, 3.0), st.floats(-6.0, 2.0), st.sampled_from([-1.0, 1.0]))
def test_rate_and_amplitude_over_six_decades_with_either_sign(decade, size, sign):
    rate, amplitude = 10.0**decade, sign * 10.0**size
    found = fit(amplitude * np.exp(-SHARE), SHARE / rate)
    assert found.status == FITTED
    np.testing.assert_allclose(found.rate, rate, rtol=1e-6)
    np.testing.assert_allclose(found.amplitude, amplitude, rtol=1e-6)
    np.testing.assert_allclose(found.rate_free, rate, rtol=1e-5)
    assert found.quality == pytest.approx(1.0)


def test_amplitude_is_that_at_the_jump_not_at_the_first_sample():
    time = SHARE + 0.5
    found = fit(2.0 * np.exp(-1.5 * time), time)
    assert found.amplitude[0] == pytest.approx(2.0)


def test_window_ends_where_five_percent_are_left():
    found = fit(np.exp(-2.0 * SHARE))
    assert found.window == SHARE[np.argmax(np.exp(-2.0 * SHARE) < 0.05)]


def test_curve_that_stays_above_five_percent_is_fitted_whole():
    assert fit(np.exp(-0.1 * SHARE)).window == SHARE[-1]


def test_what_comes_after_the_window_plays_no_part():
    curve = np.exp(-2.0 * SHARE)
    tail = np.where(np.arange(63) > fit_window(curve), 0.04, 0.0)
    assert fit(curve + tail).rate[0] == fit(curve).rate[0]


def test_window_holds_three_samples_at_least():
    steep = np.array([1.0, 0.01, 0.0001, 0.0, 0.0, 0.0, 0.0])
    assert fit_window(steep) == 3
    assert fit_window(steep[:2]) == 2


def test_a_window_too_short_for_three_parameters_gives_no_free_fit():
    found = fit(np.exp(-100.0 * SHARE))
    assert found.status == FITTED
    assert found.rate[0] == pytest.approx(100.0, rel=1e-3)
    assert np.isnan(found.rate_free).all()


def test_free_asymptote_finds_the_rate_over_an_offset():
    found = fit(0.8 * np.exp(-1.5 * SHARE) + 0.2)
    assert found.rate_free[0] == pytest.approx(1.5, rel=1e-5)
    assert found.rate[0] < 1.3  # with mu_2 known to be zero


@pytest.mark.parametrize(("rate", "amplitude"), [(1.0, 3.0), (0.3, -2e-3), (3.0, 1e4)])
def test_noise_leaves_the_rate_within_its_stated_error(rate, amplitude):
    rng = np.random.default_rng(7)
    hits = 0
    for _ in range(50):
        deviation = replicates(noisy(rng, rate, amplitude, 0.1), 0)
        found = fit_relaxation(SHARE, deviation, 1.0)
        assert found.status == FITTED
        hits += abs(found.rate[0] - rate) < 2.0 * standard_error(found.rate, 0)
    assert 41 <= hits <= 50  # 95 % expected; 4 standard deviations


def test_noise_leaves_the_amplitude_within_its_stated_error():
    rng = np.random.default_rng(8)
    deviation = replicates(noisy(rng, 1.0, 5.0, 0.1), 0)
    found = fit_relaxation(SHARE, deviation, 1.0)
    error = standard_error(found.amplitude, 0)
    assert 0.0 < error < 0.5
    assert abs(found.amplitude[0] - 5.0) < 3.0 * error


def test_pure_noise_is_no_relaxation():
    found = []
    for seed in range(100):
        noise = np.random.default_rng(seed).standard_normal((20, 63))
        found.append(fit_relaxation(SHARE, replicates(noise, 0), 1.0).status)
    assert found.count(NO_RELAXATION) >= 95  # one in 100 is beyond 3 standard errors of 20 blocks
    assert FITTED not in found


@pytest.mark.parametrize("size", [0.0, 3e-15, -3e-15])
def test_rounding_noise_is_no_relaxation(size):
    found = fit(size * np.exp(-SHARE))
    assert found.status == NO_RELAXATION
    assert np.isnan([*found.rate, *found.amplitude, *found.rate_free, found.window]).all()


def test_rounding_is_judged_against_the_slope():
    curve = 3e-15 * np.exp(-SHARE)
    assert fit(curve, slope=0.1).status == FITTED
    assert fit(1e3 * curve, slope=1e3).status == NO_RELAXATION


NOT_DECAYING = {
    "growing": np.exp(SHARE),
    "constant": np.ones(63),
    "turning its sign": np.where(np.arange(63) < 1, 1.0, -1.0),
    "oscillating": np.cos(40.0 * SHARE),
    "oscillating in growth": np.cos(10.0 * SHARE) * np.exp(SHARE),
}


@pytest.mark.parametrize("name", NOT_DECAYING)
def test_what_does_not_decay_is_not_exponential(name):
    found = fit(NOT_DECAYING[name])
    assert found.status == NOT_EXPONENTIAL
    assert np.isnan([*found.rate, *found.amplitude, *found.rate_free, found.quality]).all()


def test_a_curve_whose_replicates_are_all_equal_is_not_fitted():
    equal = np.tile(np.exp(-SHARE), (5, 1))
    assert fit_relaxation(SHARE, equal, 1.0).status == NO_RELAXATION


def test_a_rate_whose_replicates_are_all_equal_is_undetermined():
    amplitude = np.array([1.0, 0.9, 1.1, 1.05, 0.95])
    scaled = np.multiply.outer(amplitude, np.exp(-1.5 * SHARE))
    assert fit_relaxation(SHARE, scaled, 1.0).status == UNDETERMINED


def test_one_replicate_without_a_fit_leaves_the_rate_undetermined():
    deviation = spread(np.exp(-SHARE))
    deviation[3] = np.exp(SHARE)
    assert fit_relaxation(SHARE, deviation, 1.0).status == UNDETERMINED


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", [(0, 0), (0, 62), (3, 20)])
def test_a_number_that_is_not_finite_is_said(value, place):
    deviation = np.tile(np.exp(-SHARE), (5, 1))
    deviation[place] = value
    found = fit_relaxation(SHARE, deviation, 1.0)
    assert found.status == NOT_FINITE
    assert np.isnan([*found.rate, *found.amplitude, *found.rate_free, found.quality]).all()


def test_quality_says_how_exponential_a_curve_is():
    rough = fit(np.exp(-np.sqrt(4.0 * SHARE)))  # a stretched exponential
    assert rough.status == FITTED
    assert 0.9 < rough.quality < 0.999
