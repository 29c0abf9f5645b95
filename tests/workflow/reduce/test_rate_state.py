"""Rate and state: constants recovered from noisy laws, and a status where no law fits."""

import math

import numpy as np
import pytest

from elastomer_friction.workflow.reduce.fits import (
    FITTED,
    NO_STATE,
    NOT_EXPONENTIAL,
    NOT_FINITE,
    UNDETERMINED,
)
from elastomer_friction.workflow.reduce.jackknife import replicates, standard_error
from elastomer_friction.workflow.reduce.rate_state import STATE_LAWS, fit_rate_state

A, B, DC = 0.03, 0.05, 2.0
DISTANCE = np.geomspace(0.01, 20.0, 80)
BLOCKS = 32


def deviation(law, ratio, b=B, at=DISTANCE):
    """Return mu - mu_2 over the distance after a step of the velocity."""
    decay = np.exp(-at / DC)
    if law == "ruina":
        return b * math.log(ratio) * decay
    return b * np.log1p((ratio - 1.0) * decay)


def fitted(law, ratio, noise=0.001, b=B, of=None):
    """Return the fit of a law to noisy blocks of it, or of another law ``of``."""
    rng = np.random.default_rng(7)
    blocks = deviation(of or law, ratio, b) + noise * rng.standard_normal((BLOCKS, DISTANCE.size))
    change = (A - b) * math.log(ratio) + 0.1 * noise * rng.standard_normal(BLOCKS)
    return fit_rate_state(DISTANCE, replicates(blocks, 0), replicates(change, 0), ratio, law)


@pytest.mark.parametrize("law", STATE_LAWS)
@pytest.mark.parametrize("ratio", [0.1, 0.5, 0.9, 1.1, 2.0, 10.0])
def test_constants_are_recovered_within_their_errors(law, ratio):
    actual = fitted(law, ratio)
    assert actual.status == FITTED
    for values, true in ((actual.a, A), (actual.b, B), (actual.dc, DC)):
        error = standard_error(values, 0)
        assert abs(values[0] - true) < 5.0 * error  # the peak is chosen by the largest noise
        assert error < 0.15 * true
    assert actual.residual < 0.06


def test_constants_without_noise_are_exact_for_one_line_and_negative_b():
    for b in (B, -B):
        curve = deviation("ruina", 2.0, b)[None]
        change = np.array([(A - b) * math.log(2.0)])
        actual = fit_rate_state(DISTANCE, curve, change, 2.0, "ruina")
        assert actual.status == FITTED
        assert [actual.a[0], actual.b[0], actual.dc[0]] == pytest.approx([A, b, DC], rel=1e-6)


@pytest.mark.parametrize("law", STATE_LAWS)
@pytest.mark.parametrize("ratio", [1e-4, 0.01, 2.0, 50.0, 100.0, 1e4])
def test_constants_of_large_steps_are_found_on_samples_at_equal_distances(law, ratio):
    """By Dieterich's law friction stays high over several D_c after a large step upwards."""
    even = np.linspace(0.05, 40.0, 100)
    change = np.array([(A - B) * math.log(ratio)])
    actual = fit_rate_state(even, deviation(law, ratio, at=even)[None], change, ratio, law)
    assert actual.status == FITTED
    assert [actual.a[0], actual.b[0], actual.dc[0]] == pytest.approx([A, B, DC], rel=1e-6)


def test_each_law_fits_its_own_step_best():
    for law, other in (STATE_LAWS, STATE_LAWS[::-1]):
        assert fitted(law, 10.0).residual < 0.3 * fitted(law, 10.0, of=other).residual


@pytest.mark.parametrize("law", STATE_LAWS)
def test_no_state_where_b_is_noise(law):
    actual = fitted(law, 2.0, b=0.0)
    assert actual.status != FITTED
    assert np.isnan(actual.dc).all()


def test_missing_steps_numbers_and_samples_have_a_status():
    curve, change = np.ones((3, DISTANCE.size)), np.zeros(3)
    assert fit_rate_state(DISTANCE, curve, change, 1.0, "ruina").status == NO_STATE
    assert fit_rate_state(DISTANCE, curve, change, -1.0, "ruina").status == NO_STATE
    assert fit_rate_state(DISTANCE, curve * np.nan, change, 2.0, "ruina").status == NOT_FINITE
    few = slice(0, 3)
    actual = fit_rate_state(DISTANCE[few], curve[:, few], change, 2.0, "ruina")
    assert actual.status == UNDETERMINED


def test_a_curve_of_another_shape_is_refused():
    rng = np.random.default_rng(1)
    waves = 0.1 * np.cos(4.0 * DISTANCE) + 1e-4 * rng.standard_normal((BLOCKS, DISTANCE.size))
    change = np.full(BLOCKS + 1, 0.02)
    actual = fit_rate_state(DISTANCE, replicates(waves, 0), change, 2.0, "ruina")
    assert actual.status in (NOT_EXPONENTIAL, UNDETERMINED)
    assert np.isnan(actual.dc).all()
