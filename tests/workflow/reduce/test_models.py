"""Models beyond eq. 6: the true one is chosen and its coefficients are found."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from elastomer_friction.workflow.reduce.jackknife import replicates, standard_error
from elastomer_friction.workflow.reduce.models import (
    EXPONENTIAL,
    STRETCHED,
    TWO_EXPONENTIALS,
    UNDECIDED_MODEL,
    Comparison,
    compare_models,
    determined,
)
from tests.support.sweeps import mostly_exhaustive

TIME = np.linspace(0.02, 4.0, 63)
CURVES = {
    EXPONENTIAL: np.exp(-1.3 * TIME),
    STRETCHED: np.exp(-((1.3 * TIME) ** 0.5)),
    TWO_EXPONENTIALS: 0.6 * np.exp(-12.0 * TIME) + 0.4 * np.exp(-0.5 * TIME),
}


def compared(curve, amplitude=1.0, rate=1.3):
    """Compare the models on 30 blocks that vary in amplitude and carry noise."""
    rng = np.random.default_rng(1)
    share = 1.0 + 0.05 * rng.standard_normal((30, 1))
    each = amplitude * (share * curve + 0.01 * rng.standard_normal((30, TIME.size)))
    return compare_models(TIME, replicates(each, 0), each, rate)


@pytest.mark.parametrize("model", CURVES)
@pytest.mark.parametrize("amplitude", [1.0, -2e-4])
def test_the_true_model_is_chosen(model, amplitude):
    assert compared(CURVES[model], amplitude).best == model


TRUTH = {
    STRETCHED: {"stretched_rate": 1.3, "stretched_exponent": 0.5},
    TWO_EXPONENTIALS: {"fast_rate": 12.0, "slow_rate": 0.5, "fast_share": 0.6},
}


@pytest.mark.parametrize("model", TRUTH)
@pytest.mark.parametrize("start", [1.3, 0.1, 30.0])
def test_coefficients_do_not_depend_on_the_initial_guess(model, start):
    actual = compared(CURVES[model], rate=start)
    assert actual.best == model
    for name, truth in TRUTH[model].items():
        values = getattr(actual, name)
        error = standard_error(values, 0)
        assert error < 0.2 * truth
        assert abs(values[0] - truth) < 4.0 * error
    assert max(actual.gain_stretched[0], actual.gain_two_exponentials[0]) > 0.1


def test_meaningless_coefficients_are_nan():
    actual = compared(CURVES[EXPONENTIAL])
    assert np.isnan([*actual.stretched_rate, *actual.stretched_exponent]).all()
    assert np.isnan([*actual.fast_rate, *actual.slow_rate, *actual.fast_share]).all()


def test_nothing_is_compared_where_eq_6_was_not_fitted():
    actual = compared(CURVES[EXPONENTIAL], rate=np.nan)
    assert actual.best == UNDECIDED_MODEL
    for name in set(Comparison._fields) - {"best"}:
        assert np.isnan(getattr(actual, name)).all()
    assert actual.fast_rate.shape == (31,)


# (rate, exponent) per unit of time, for samples at TIME: what they can determine, and what not
RESOLVED = [(1.0, 1.0), (0.01, 1.0), (12.0, 1.0), (60.0, 1.0), (1.0, 0.3), (1.0, 3.0), (100.0, 0.2)]
RUN_AWAY = [
    *((1e3, 1.0), (4.46e18, 1.0)),  # faster than the second sample
    (1e-5, 1.0),  # slower than the whole time
    (1.0, 200.0),  # a fall between two samples
    *((1.0, 1e-3), (4.46e18, 1e-4)),  # a constant
    *((np.nan, 1.0), (np.inf, 1.0), (1.0, np.inf), (1.0, 0.0)),  # no numbers
]


@pytest.mark.parametrize(("rate", "exponent"), RESOLVED + RUN_AWAY)
def test_only_what_the_samples_resolve_can_be_determined(rate, exponent):
    known = determined(TIME, np.array([rate]), np.array([exponent]))
    assert known.tolist() == [(rate, exponent) in RESOLVED]


FEW = np.linspace(0.02, 4.0, 9)


def after_others(value, seed):
    """Compare the models on few samples of an exponential, in memory that held ``value`` before."""
    # The Jacobian gets new memory, with other content.
    taken = [np.empty(4 * FEW.size) for _ in range(32)]
    freed = [np.full(4 * FEW.size + 1, value) for _ in range(64)]
    del freed
    rng = np.random.default_rng(seed)
    blocks = (1.0 + 0.05 * rng.standard_normal((8, 1))) * np.exp(-1.3 * FEW)
    blocks += 0.01 * rng.standard_normal(blocks.shape)
    actual = compare_models(FEW, replicates(blocks, 0), blocks, 1.3)
    del taken
    return [np.asarray(number).tobytes() for number in actual]


@mostly_exhaustive("seed", [0, 1], [2, 3])
def test_a_thread_finds_the_same_bits_as_the_main_thread(seed):
    """Nor do the bits depend on the former content of memory (docs/decisions.md)."""
    expected = after_others(0.0, seed)
    assert after_others(1e300, seed) == expected
    with ThreadPoolExecutor(1) as pool:
        assert pool.submit(after_others, 1e300, seed).result() == expected
