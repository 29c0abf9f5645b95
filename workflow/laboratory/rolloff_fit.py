"""Hurst exponent, roll-off and cut-off of a measured power spectrum.

The spectrum of one piece of a surface scatters: C of a mode is that of the surface times a random
number, in the simplest case of an exponential distribution. The model C = C_0 max(q, q_r)^-s +
C_noise, with s = 2 H + 1 for lines and 2 H + 2 for maps, is therefore fitted by the likelihood of a
gamma distribution to means over logarithmic bins (Whittle, J. R. Stat. Soc. B 15, 125 (1953)). The
relative variance of a mode is estimated from neighbouring modes; deviations of the bins beyond it
count as independent errors of the bins. The likelihood over q_r and C_noise yields the
uncertainties.
"""

import math
from typing import NamedTuple

import numpy as np

from ..ground import UserError
from .estimate import Estimate
from .measured_spectrum import MeasuredSpectrum

BIN_RATIO = 1.1  # of the edges of bins
ROLLOFFS, COARSE_ROLLOFFS = 200, 20  # wave numbers that are tried
NOISE_SHARES = np.linspace(0.0, 1.0, 9)  # of C at the shortest waves, which are tried
SCORING_STEPS = 15
MIN_FREEDOM = 8  # of the scatter of modes
MIN_VARIANCE = 1e-6  # of lines drawn with given amplitudes
MIN_BINS, MIN_BINS_ABOVE = 8, 3  # on either side of a bend
MIN_IMPROVEMENT = 7.0  # of the deviance by a parameter: one per cent by chance
MIN_NOISE_IMPROVEMENT = 2.0  # by noise, whose neglect would bias H (Akaike)
BEND_TOLERANCE = 0.1  # of the model at each bin in the search for a bend
MIN_BEND = 0.5  # change of the exponent
MIN_EXPONENT = -0.4  # of the power law below a bend, relative to H = 0
BEND_MARGIN = 1.25  # between the waves of the fit and a bend
ERROR_QUANTILES = 0.16, 0.5, 0.84  # quantiles that bound one standard error


class RolloffFit(NamedTuple):
    """Parameters of a measured power spectrum, with standard errors."""

    hurst: Estimate
    rolloff: tuple[float, ...] | None  # m: lower limit, median, upper limit; None: no roll-off
    least_rolloff: float  # m: shorter ones are excluded at two standard errors
    first_q: float  # 1/m: begin of the fit
    last_q: float  # 1/m: end of the power law
    end_reason: str  # why the power law ends there
    mode_variance: float  # relative variance of C of one mode
    misfit: float  # relative deviation of bins from the model beyond their scatter
    bins: "Bins"
    model: np.ndarray  # C at the bins of the fit


class Bins(NamedTuple):
    """Means of a spectrum over logarithmic bins, shape (bins,)."""

    log_q: np.ndarray
    density: np.ndarray
    modes: np.ndarray  # their number
    scatter: np.ndarray  # sum of number times square deviation over the modes, or rings, of a bin
    freedom: np.ndarray  # degrees of freedom of the scatter

    @property
    def mode_variance(self) -> float:
        """Return the relative variance of C of a single mode."""
        return max(float(self.scatter.sum() / max(self.freedom.sum(), 1)), MIN_VARIANCE)

    def part(self, first: int, last: int | None = None) -> "Bins":
        """Return the bins of a range."""
        return Bins(*(values[first:last] for values in self))


class _PowerLaws(NamedTuple):
    """Fits of C = C_0 max(q, q_r)^-exponent + C_noise for several q_r and C_noise."""

    deviance: np.ndarray
    exponent: np.ndarray
    variance: np.ndarray  # of the exponent
    power_law: np.ndarray  # C without noise, shape (fits, bins)


def fit_rolloff(spectrum: MeasuredSpectrum, lowest: float) -> RolloffFit:
    """Return the fit to the waves of a spectrum from the wave number ``lowest`` (1/m).

    Detrending by a line removes waves longer than the measured length, by a parabola some shorter
    ones as well. Raises UserError for too few waves.
    """
    bins = _binned(spectrum, lowest)
    if bins.freedom.sum() < MIN_FREEDOM:
        raise UserError(
            f"spectrum: {spectrum.q.size} wave numbers are too few for a fit; give lines of 64 "
            "samples or more"
        )
    end, bend = _bend(bins, spectrum.falling)
    below = bins.part(0, end)
    variance = (below if below.freedom.sum() >= MIN_FREEDOM else bins).mode_variance
    grid = np.linspace(below.log_q[0], below.log_q[-3], ROLLOFFS)
    for shares in (NOISE_SHARES, NOISE_SHARES[:1]):  # without noise if it is not significant
        floors = shares * below.density[-3:].min()
        rolloffs, noise = (values.ravel() for values in np.meshgrid(grid, floors))
        fits, misfit = _with_misfit(below, variance, rolloffs, noise)
        best = int(np.argmin(fits.deviance))
        excess = fits.deviance - fits.deviance[best]
        if excess[noise == 0.0].min() > MIN_NOISE_IMPROVEMENT:
            break
    share = np.exp(-0.5 * excess) / np.exp(-0.5 * excess).sum()
    exponent = float(share @ fits.exponent)
    of_exponent = share @ (fits.variance + (fits.exponent - exponent) ** 2)
    hurst = Estimate(0.5 * (exponent - spectrum.falling), 0.5 * math.sqrt(of_exponent))
    has_rolloff = excess[rolloffs == grid[0]].min() > MIN_IMPROVEMENT
    cumulative = np.cumsum(share.reshape(floors.size, -1).sum(axis=0))
    limits = 2.0 * math.pi / np.exp(np.interp(ERROR_QUANTILES, cumulative, grid))
    return RolloffFit(
        hurst,
        tuple(limits[::-1].tolist()) if has_rolloff else None,
        2.0 * math.pi / math.exp(rolloffs[excess < 4.0].max()),
        math.exp(below.log_q[0]),
        *_end(spectrum, below, bend, fits.power_law[best] > noise[best]),
        variance,
        misfit,
        bins,
        fits.power_law[best] + noise[best],
    )


def _end(
    spectrum: MeasuredSpectrum, below: Bins, bend: float, above_noise: np.ndarray
) -> tuple[float, str]:
    """Return the last wave number (1/m) of the power law, and the reason in words.

    above_noise : whether the power law exceeds the noise, for the bins below the bend.
    """
    if not above_noise.all():
        return math.exp(below.log_q[np.argmin(above_noise)]), "noise is as large"
    if not bend:
        return float(spectrum.q[-1]), "the spacing of the samples"
    reason = "steeper, by the instrument or wear" if bend > 0.0 else "flatter, by noise"
    return math.exp(below.log_q[-1]), f"shorter waves are {reason}"


def _with_misfit(
    bins: Bins, variance: float, rolloffs: np.ndarray, noise: np.ndarray
) -> tuple[_PowerLaws, float]:
    """Return power laws, and the errors of bins beyond the scatter of the modes."""
    spread, misfit = variance / bins.modes, 0.0
    for _ in range(4):
        fits = _power_laws(bins, 1.0 / (spread + misfit**2), rolloffs, noise)
        best = int(np.argmin(fits.deviance))
        misfit = _misfit(bins.density / (fits.power_law[best] + noise[best]) - 1.0, spread)
    return fits, misfit


def _binned(spectrum: MeasuredSpectrum, lowest: float) -> Bins:
    """Return the means of a spectrum over bins."""
    used = spectrum.q > lowest * (1.0 - 1e-9)
    q, density, count = spectrum.q[used], spectrum.density[used], spectrum.modes[used]
    density = np.maximum(density, 1e-30 * density.max())
    number = np.floor(np.log(q / q[0]) / math.log(BIN_RATIO) + 1e-9)
    _, index = np.unique(number, return_inverse=True)
    total = np.bincount(index, count)
    log_q = np.bincount(index, count * np.log(q)) / total
    mean = np.bincount(index, count * density) / total
    slope = np.gradient(np.log(mean), log_q)
    level = density / mean[index] * np.exp(-slope[index] * (np.log(q) - log_q[index]))
    scatter = np.bincount(index, count * (level - 1.0) ** 2)
    return Bins(log_q, mean, total, scatter, np.bincount(index) - 1)


def _power_laws(
    bins: Bins, weights: np.ndarray, rolloffs: np.ndarray, noise: np.ndarray | float = 0.0
) -> _PowerLaws:
    """Fit the power law for each log q_r and C_noise by Fisher scoring of the gamma likelihood."""
    x = np.maximum(bins.log_q, rolloffs[:, None])
    noise = np.broadcast_to(noise, rolloffs.shape)[:, None]
    target = np.broadcast_to(np.log(bins.density), x.shape)
    weight = np.broadcast_to(weights, x.shape)
    for _ in range(SCORING_STEPS):
        total = weight.sum(axis=1)
        mean_x, level = ((weight * values).sum(axis=1) / total for values in (x, target))
        centred = x - mean_x[:, None]
        moment = (weight * centred**2).sum(axis=1)
        exponent = -(weight * centred * target).sum(axis=1) / moment
        log_power = level[:, None] - exponent[:, None] * centred
        power = np.exp(np.clip(log_power, -300.0, 300.0))
        model = power + noise
        target = log_power + np.clip((bins.density - model) / power, -3.0, 3.0)
        weight = weights * (power / model) ** 2
    ratio = bins.density / model
    deviance = 2.0 * (ratio - 1.0 - np.log(ratio)) @ weights
    return _PowerLaws(deviance, exponent, 1.0 / moment, power)


def _misfit(residual: np.ndarray, variance: np.ndarray) -> float:
    """Return the relative error of each bin that explains the residuals besides their variance."""
    sizes = np.linspace(0.0, 1.0, 201)
    squares = np.sum(residual**2 / (variance + sizes[:, None] ** 2), axis=1)
    return float(sizes[np.argmax(np.append(squares[:-1] <= residual.size - 3.0, True))])


def _bend(bins: Bins, falling: int) -> tuple[int, float]:
    """Return the end of the power law, and the increase of its exponent there (0: no bend)."""
    weights = 1.0 / (bins.mode_variance / bins.modes + BEND_TOLERANCE**2)

    def fitted(last: int) -> tuple[float, float, float]:
        part = bins.part(0, last)
        grid = np.linspace(part.log_q[0], part.log_q[-3], COARSE_ROLLOFFS)
        fits = _power_laws(part, weights[:last], grid)
        best = int(np.argmin(fits.deviance))
        return float(fits.deviance[best]), float(fits.exponent[best]), float(grid[best])

    size = bins.log_q.size
    least, end, change = fitted(size)[0] - 2.0 * MIN_IMPROVEMENT, size, 0.0
    for last in range(MIN_BINS, size - MIN_BINS_ABOVE + 1):
        deviance, exponent, log_rolloff = fitted(last)
        above = _power_laws(bins.part(last), weights[last:], np.array([-np.inf]))
        deviance, bend = deviance + above.deviance[0], float(above.exponent[0] - exponent)
        log_end = bins.log_q[last - 1]
        power_law = log_end - log_rolloff > math.log(2.0) and exponent > falling + MIN_EXPONENT
        if deviance < least and abs(bend) > MIN_BEND and power_law:
            least, change = deviance, bend
            end = int(np.searchsorted(bins.log_q, log_end - math.log(BEND_MARGIN)))
    return max(end, MIN_BINS), change
