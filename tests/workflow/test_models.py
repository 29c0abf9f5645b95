"""Models beyond eq. 6: the true one is chosen and its coefficients are found."""

import numpy as np
import pytest

from workflow.reduce import models
from workflow.reduce.jackknife import replicates, standard_error
from workflow.reduce.models import (
    EXPONENTIAL,
    STRETCHED,
    TWO_EXPONENTIALS,
    UNDECIDED,
    Comparison,
    compare_models,
    determined,
)

TIME = np.linspace(0.02, 4.0, 63)
CURVES = {
    EXPONENTIAL: np.exp(-1.3 * TIME),
    STRETCHED: np.exp(-((1.3 * TIME) ** 0.5)),
    TWO_EXPONENTIALS: 0.6 * np.exp(-12.0 * TIME) + 0.4 * np.exp(-0.5 * TIME),
}


def compared(curve, amplitude=1.0, rate=1.3, seed=1, blocks=30):
    """Compare the models on blocks that vary in amplitude and carry noise."""
    rng = np.random.default_rng(seed)
    share = 1.0 + 0.05 * rng.standard_normal((blocks, 1))
    each = amplitude * (share * curve + 0.01 * rng.standard_normal((blocks, TIME.size)))
    return compare_models(TIME, replicates(each, 0), each, rate)


@pytest.mark.parametrize("model", CURVES)
@pytest.mark.parametrize("amplitude", [1.0, -2e-4])
def test_the_true_model_is_chosen(model, amplitude):
    assert compared(CURVES[model], amplitude).best == model


def within(values, truth):
    """Return whether the estimate is within four of its standard errors, and not by their size."""
    error = standard_error(values, 0)
    assert error < 0.2 * truth
    return abs(values[0] - truth) < 4.0 * error


def test_coefficients_of_the_stretched_exponential():
    found = compared(CURVES[STRETCHED])
    assert within(found.stretched_rate, 1.3)
    assert within(found.stretched_exponent, 0.5)
    assert found.gain_stretched[0] > 0.1


def test_coefficients_of_two_exponentials():
    found = compared(CURVES[TWO_EXPONENTIALS])
    assert within(found.fast_rate, 12.0)
    assert within(found.slow_rate, 0.5)
    assert within(found.fast_share, 0.6)


@pytest.mark.parametrize("rate", [0.1, 30.0])
def test_result_does_not_depend_on_the_start(rate):
    found = compared(CURVES[STRETCHED], rate=rate)
    assert found.best == STRETCHED
    assert within(found.stretched_exponent, 0.5)


def test_coefficients_that_mean_nothing_are_no_numbers():
    found = compared(CURVES[EXPONENTIAL])
    assert np.isnan([*found.stretched_rate, *found.stretched_exponent]).all()
    assert np.isnan([*found.fast_rate, *found.slow_rate, *found.fast_share]).all()


def test_nothing_is_compared_where_eq_6_was_not_fitted():
    found = compared(CURVES[EXPONENTIAL], rate=np.nan)
    assert found.best == UNDECIDED
    for name in set(Comparison._fields) - {"best"}:
        assert np.isnan(getattr(found, name)).all()
    assert found.fast_rate.shape == (31,)


# (rate, exponent) per unit of time, for samples at TIME: what they can determine, and what not
RESOLVED = [(1.0, 1.0), (0.01, 1.0), (12.0, 1.0), (60.0, 1.0), (1.0, 0.3), (1.0, 3.0), (100.0, 0.2)]
RUN_AWAY = {
    "faster than the second sample": (1e3, 1.0),
    "far faster": (4.46e18, 1.0),
    "slower than the whole time": (1e-5, 1.0),
    "a fall between two samples": (1.0, 200.0),
    "a constant": (1.0, 1e-3),
    "a constant from long ago": (4.46e18, 1e-4),
    "no number": (np.nan, 1.0),
    "without bounds": (np.inf, 1.0),
    "exponent without bounds": (1.0, np.inf),
    "exponent of zero": (1.0, 0.0),
}


@pytest.mark.parametrize(("rate", "exponent"), RESOLVED)
def test_what_the_samples_resolve_can_be_determined(rate, exponent):
    assert determined(TIME, np.array([rate]), np.array([exponent])).all()


@pytest.mark.parametrize("name", RUN_AWAY)
def test_what_the_samples_do_not_resolve_cannot_be_determined(name):
    rate, exponent = RUN_AWAY[name]
    assert not determined(TIME, np.array([rate]), np.array([exponent])).any()


@pytest.mark.parametrize("spread", [0.0, 1e-3])
def test_coefficients_that_ran_away_are_refused_even_where_replicates_agree(monkeypatch, spread):
    rng = np.random.default_rng(2)
    blocks = CURVES[STRETCHED] + 1e-3 * rng.standard_normal((30, TIME.size))

    def run_away(count):
        fits = np.tile([1.0, np.log(4.46e18), 0.0, np.log(2e18)], (31, 1))[:, :count]
        return fits + spread * rng.standard_normal(fits.shape)

    gains = dict.fromkeys(CURVES, (0.5, 0.01))  # as if both predicted better by far
    fits = {EXPONENTIAL: run_away(2), STRETCHED: run_away(3), TWO_EXPONENTIALS: run_away(4)}
    monkeypatch.setattr(models, "_fits_and_gains", lambda *_: (fits, gains))
    found = compare_models(TIME, replicates(blocks, 0), blocks, 1.3)
    assert found.best == EXPONENTIAL
    for name in ("stretched_rate", "stretched_exponent", "fast_rate", "slow_rate", "fast_share"):
        assert np.isnan(getattr(found, name)).all()
