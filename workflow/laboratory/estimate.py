"""Estimates with standard errors for noise that is correlated between samples.

Measured friction is filtered, and machines vibrate, so neighbouring samples are not independent,
and errors that treat them as independent are too small. The variance of a mean of n samples is
1 + 2 (rho_1 + rho_2 + ...) times that of n independent ones, with rho_k the autocorrelation at lag
k. The same factor holds for fits of curves that vary more slowly than the noise decorrelates.

A simulated quantity has independent realizations, so its error is that of the jackknife
(workflow/reduce/jackknife.py). A record is measured once, so its error must come from the
autocorrelation of its samples.

Source: A. D. Sokal, Monte Carlo Methods in Statistical Mechanics (1997), sec. 3: the sum ends at
five integrated autocorrelation times, each half of the factor above. U. Wolff, Comput. Phys.
Commun. 156, 143 (2004), eq. 49: correction for the subtraction of the mean of the same samples.
"""

import math
from typing import NamedTuple

import numpy as np

MAX_CHANCE_ERRORS = 3.0  # standard errors up to which a difference counts as chance, in all modules
MAX_LAG_TIMES = 5.0  # largest lag of the sum, in integrated autocorrelation times


class Estimate(NamedTuple):
    """An estimate with its standard error; NaN if the data do not determine it."""

    value: float = math.nan
    error: float = math.nan

    @property
    def known(self) -> bool:
        """Return whether the value and its error are finite."""
        return math.isfinite(self.value) and math.isfinite(self.error)

    def times(self, factor: float) -> "Estimate":
        """Return the estimate multiplied by an exact factor."""
        return Estimate(self.value * factor, self.error * abs(factor))

    def if_below(self, largest: float) -> "Estimate":
        """Return the estimate if its error is below ``largest``, else an estimate of NaN."""
        return self if self.error < largest else Estimate()


def correlation_factor(residual: np.ndarray) -> float:
    """Return the factor by which correlation increases variances; residual : shape (samples,).

    It is at least one, since anticorrelation does not justify smaller errors.
    """
    n = residual.size
    centred = residual - residual.mean()
    spectrum = np.abs(np.fft.rfft(centred, 2 * n)) ** 2
    covariance = np.fft.irfft(spectrum)[:n]
    if not covariance[0] > 0.0:
        return 1.0
    sums = 2.0 * np.cumsum(covariance / covariance[0]) - 1.0
    ends = np.flatnonzero(np.arange(n) >= 0.5 * MAX_LAG_TIMES * sums)
    last = int(ends[0]) if ends.size else n - 1
    return max(float(sums[last]) * (1.0 + (2 * last + 1) / n), 1.0)


def noise_of(changes: np.ndarray) -> float:
    """Return the standard deviation of noise from differences of adjacent samples."""
    return float(np.median(np.abs(changes))) / (0.6745 * math.sqrt(2.0))


def mean(values: np.ndarray) -> Estimate:
    """Return the mean of correlated samples, shape (samples,), with its standard error."""
    n = values.size
    error = values.std(ddof=1) * np.sqrt(correlation_factor(values) / n)
    return Estimate(float(values.mean()), float(error))
