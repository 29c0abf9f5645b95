"""Fits under hard data: the truth within the stated errors, or a status that says why not.

A pull is (estimate - truth) / standard error. Over g blocks pulls must follow Student's t with
g - 1 degrees of freedom; seeds are fixed, so that nothing here depends on luck.
"""

from collections import Counter
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pytest
from scipy.stats import kstest, t

from workflow.reduce.fits import (
    FITTED,
    NO_RELAXATION,
    NOT_EXPONENTIAL,
    UNDETERMINED,
    fit_power_law,
    fit_relaxation,
)
from workflow.reduce.jackknife import errors_needed, replicates, standard_error
from workflow.reduce.models import compare_models

SEEDS = 100
SAMPLES = 63


class Data(NamedTuple):
    """Blocks A (1 + share) exp(-b t) + noise, white and smooth; noises relative to A."""

    rate: float = 1.0
    amplitude: float = 1.0
    span: float = 4.0  # of the window, in 1/b (in tau for b = 0)
    blocks: int = 20
    share: float = 0.2
    white: float = 0.1
    smooth: float = 0.0
    outlier: float = 1.0  # factor on one block

    @property
    def time(self):
        """Return the samples, from the first step on."""
        span = self.span / self.rate if self.rate else self.span
        return np.linspace(span / SAMPLES, span, SAMPLES)

    def deviation(self, seed):
        """Return the mean curve and its jackknife replicates."""
        rng = np.random.default_rng([seed, self.blocks])
        share = 1.0 + self.share * rng.standard_normal((self.blocks, 1))
        curves = share * np.exp(-self.rate * self.time)
        curves += self.white * rng.standard_normal(curves.shape)
        curves += self.smooth * waves(rng, self.blocks, self.time / self.time[-1])
        curves[0] *= self.outlier
        return replicates(self.amplitude * curves, 0)

    @lru_cache  # noqa: B019
    def fits(self):
        """Return the fits over all seeds."""
        return [fit_relaxation(self.time, self.deviation(seed), 1.0) for seed in range(SEEDS)]


def waves(rng, blocks, x):
    """Return noise of unit size that varies slowly over 0 < x < 1, as that of rough lines does."""
    angle = 1.5 * np.multiply.outer(np.arange(1, 6), x)
    phase, size = rng.uniform(0.0, 2.0 * np.pi, (blocks, 5)), rng.standard_normal((blocks, 5))
    return np.einsum("bk,bkt->bt", size, np.cos(angle + phase[..., None])) / np.sqrt(2.5)


def statuses(fits):
    """Return how often each status was found."""
    return Counter(fit.status for fit in fits)


def pulls(fits, name, truth):
    """Return the pulls of an estimate over all fits that have it."""
    values = [getattr(fit, name) for fit in fits if fit.status == FITTED]
    return np.array([(v[0] - truth) / standard_error(v, 0) for v in values if np.isfinite(v[0])])


KNOWN = {
    "usual": Data(),
    "negative": Data(amplitude=-3e-4),
    "slow": Data(rate=1e-3),
    "fast": Data(rate=1e3, amplitude=-20.0),
    "ten blocks": Data(blocks=10),
    "four blocks": Data(blocks=4, share=0.05),
    "noise of a half": Data(white=0.5),
    "smooth noise": Data(white=0.0, smooth=0.2),
    "a tenth of the window": Data(span=0.4),
    "decayed before the window": Data(span=80.0, white=0.01),
}


@pytest.mark.parametrize("name", KNOWN)
def test_pulls_follow_students_t(name):
    data = KNOWN[name]
    fits = data.fits()
    assert statuses(fits)[FITTED] > 0.95 * SEEDS
    law = t(data.blocks - 1)
    for estimate, truth in (("rate", data.rate), ("amplitude", data.amplitude)):
        assert kstest(pulls(fits, estimate, truth), law.cdf).pvalue > 1e-3, estimate


def test_pulls_of_the_free_rate_where_the_window_determines_it():
    fits = Data().fits()
    found = pulls(fits, "rate_free", 1.0)
    assert found.size == SEEDS
    assert kstest(found, t(19).cdf).pvalue > 1e-3


@pytest.mark.parametrize("name", [*KNOWN, "short window"])
def test_no_estimate_goes_without_its_error(name):
    data = KNOWN.get(name, Data(span=0.1))
    for fit in data.fits():
        for values in (fit.rate, fit.amplitude, fit.rate_free):
            assert np.isfinite(values).all() or np.isnan(values).all()
            assert np.isnan(values[0]) or standard_error(values, 0) > 0.0


REFUSED = {
    "no decay": (Data(rate=0.0), {NOT_EXPONENTIAL, UNDETERMINED}),
    "too short a window": (Data(span=0.004), {NOT_EXPONENTIAL, UNDETERMINED}),
    "noise of four times": (Data(white=4.0), {NO_RELAXATION, UNDETERMINED}),
    "smooth noise of twice": (Data(white=0.0, smooth=2.0), {NO_RELAXATION, UNDETERMINED}),
    "one block outweighs all": (Data(outlier=100.0), {NO_RELAXATION}),
    "two blocks": (Data(blocks=2), {NO_RELAXATION, UNDETERMINED}),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_known_has_a_status(name):
    data, allowed = REFUSED[name]
    fits = data.fits()
    counts = statuses(fits)
    assert counts[FITTED] <= 0.02 * SEEDS
    assert sum(counts[status] for status in allowed) >= 0.97 * SEEDS
    for fit in fits:
        if fit.status != FITTED:
            assert np.isnan([*fit.rate, *fit.amplitude, *fit.rate_free]).all()


@pytest.mark.parametrize("blocks", [2, 4, 10, 50])
@pytest.mark.parametrize("shape", ["white", "smooth", "exponential"])
def test_pure_noise_is_hardly_ever_fitted(blocks, shape):
    fitted = 0
    x = np.linspace(0.02, 4.0, SAMPLES)
    for seed in range(2 * SEEDS):
        rng = np.random.default_rng(seed)
        if shape == "white":
            noise = rng.standard_normal((blocks, x.size))
        elif shape == "smooth":
            noise = waves(rng, blocks, x / 4.0)
        else:  # every block relaxes, to either side
            noise = rng.standard_normal((blocks, 1)) * np.exp(-x)
        fitted += fit_relaxation(x, replicates(noise, 0), 1.0).status == FITTED
    assert fitted <= 9  # 1 % by chance; 3.5 standard deviations


@pytest.mark.parametrize("factor", [10.0, -10.0])
def test_an_outlier_among_the_blocks_widens_the_error(factor):
    fits = Data(outlier=factor).fits()
    found = pulls(fits, "amplitude", 1.0)
    assert found.size in range(SEEDS // 2, SEEDS + 1) or factor < 0.0
    assert np.abs(pulls(fits, "rate", 1.0)).max(initial=0.0) < 4.0
    assert np.abs(found).max(initial=0.0) < 4.0


def test_few_blocks_need_more_standard_errors():
    needed = [errors_needed(blocks) for blocks in (2, 4, 10, 50, 1000)]
    assert needed == pytest.approx([63.7, 5.84, 3.25, 3.0, 3.0], abs=0.05)


def test_exponent_of_eq_13_is_within_its_stated_error():
    x = np.geomspace(2.0, 300.0, 12)
    found = []
    for seed in range(SEEDS):
        rng = np.random.default_rng(seed)
        line = rng.standard_normal((1, 20))  # blocks share their lines between points
        noise = 0.1 * rng.standard_normal((x.size, 20)) + 0.1 * line
        rates = replicates(np.exp(0.4 * np.log(x))[:, None] * (1.0 + noise), 1)
        fit = fit_power_law(x, rates)
        found.append((fit.alpha[0] - 0.4) / standard_error(fit.alpha, 0))
    assert kstest(found, t(19).cdf).pvalue > 1e-3


SHAPES = {
    "exact": lambda x, rng: np.tile(np.exp(-x), (30, 1)),
    "noise": lambda x, rng: rng.standard_normal((30, x.size)),
    "constant": lambda x, rng: 1.0 + 0.01 * rng.standard_normal((30, x.size)),
    "growing": lambda x, rng: np.exp(x) + 0.01 * rng.standard_normal((30, x.size)),
    "steep": lambda x, rng: np.exp(-60.0 * x) + 0.01 * rng.standard_normal((30, x.size)),
    "outlier": lambda x, rng: np.vstack([np.tile(np.exp(-x), (29, 1)), -20.0 * np.exp(-3.0 * x)]),
}


@pytest.mark.parametrize("name", SHAPES)
def test_models_beyond_eq_6_claim_no_number_they_cannot_know(name):
    x = np.linspace(0.02, 4.0, SAMPLES)
    for seed in range(10):
        blocks = SHAPES[name](x, np.random.default_rng(seed))
        found = compare_models(x, replicates(blocks, 0), blocks, 1.3)
        for values in (found.stretched_rate, found.stretched_exponent, found.fast_rate):
            assert np.isfinite(values).all() or np.isnan(values).all()
            assert np.isnan(values[0]) or values[0] > 3.0 * standard_error(values, 0)
        if name in ("exact", "constant"):
            assert np.isnan([found.fast_rate[0], found.stretched_rate[0]]).all()
