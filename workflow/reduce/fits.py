"""Fits of eq. 6 to relaxation curves. Source: Li et al. (2014), doi:10.1038/srep05795."""

from typing import NamedTuple

import numpy as np

from .decays import fit_decays
from .jackknife import significant, standard_error

FITTED, NO_RELAXATION, NOT_EXPONENTIAL, UNDETERMINED, NOT_FINITE, NO_STATE, NEGLIGIBLE = range(7)

STATUS_MEANINGS = "fitted no_relaxation not_exponential undetermined not_finite no_state negligible"
STATUS_COMMENT = (
    "no_relaxation: mu after the first step differs from mu_2 by less than three standard "
    "errors (more with fewer than 15 blocks) or by rounding; not_exponential: eq. 6 leaves "
    "over a fifth of the sum of squares; undetermined: b is less than three standard errors, "
    "does not differ between blocks, or all samples but the first are rounding; not_finite: "
    "the curve contains NaN or inf; no_state: b of a rate-and-state law is less than three "
    "standard errors; negligible: the relaxation is significantly below the share "
    "numerics.negligible of the jump"
)

WINDOW_END = 0.05  # the window ends where the deviation has decreased to this share
MIN_WINDOW_SAMPLES = 3
DEVIATION_ROUNDING = 1e-14  # relative to the rms slope: smaller deviations are rounding
MIN_QUALITY = 0.8
MAX_NOISE_RESIDUAL = 3.0  # largest sum of squares left by noise, over the summed variances


class RelaxationFit(NamedTuple):
    """Fit of eq. 6; arrays hold the fit of the mean curve, then of its jackknife replicates."""

    status: int
    rate: np.ndarray  # b, shape (replicates,)
    amplitude: np.ndarray  # mu*, shape (replicates,)
    rate_free: np.ndarray  # b with mu_2 fitted too, shape (replicates,)
    window: float  # end of the fit window, in tau
    quality: float  # 1 - residual sum of squares / sum of squares, of the mean curve


def fit_relaxation(time: np.ndarray, deviation: np.ndarray, slope: float) -> RelaxationFit:
    """Fit mu - mu_2 = mu* exp(-b t) (eq. 6) with mu_2 known, and with mu_2 free.

    time : shape (samples,), from the first step after the jump, in tau.
    deviation : mu - mu_2, shape (replicates, samples), row 0 the mean curve.
    slope : rms slope in the same units, the scale of rounding.
    """
    size = len(deviation)
    if not np.isfinite(deviation).all():
        return _unfitted(NOT_FINITE, size)
    first = deviation[:, 0]
    if not significant(first) or abs(first[0]) <= DEVIATION_ROUNDING * slope:
        return _unfitted(NO_RELAXATION, size)
    end = fit_window(deviation[0])
    time, deviation = time[:end], deviation[:, :end]
    if np.abs(deviation[0, 1:]).max(initial=0.0) <= DEVIATION_ROUNDING * slope:
        return _unfitted(UNDETERMINED, size)  # decayed within one step: the rest is rounding
    start = _start(time, deviation[0])
    if start is None:
        return _unfitted(NOT_EXPONENTIAL, size)
    known = _fit_all(time, deviation, start)
    quality = _quality(time, deviation[0], known[0])
    if not quality >= MIN_QUALITY:  # NaN where the mean curve has no fit
        residual = (1.0 - quality) * np.sum(deviation[0] ** 2)
        noise = MAX_NOISE_RESIDUAL * np.sum(standard_error(deviation, 0) ** 2)
        return _unfitted(UNDETERMINED if residual <= noise else NOT_EXPONENTIAL, size)
    if not significant(known[:, 1]):
        return _unfitted(UNDETERMINED, size)
    free = np.full(size, np.nan)
    if end > MIN_WINDOW_SAMPLES:
        free = _fit_all(time, deviation, known[:, 1], offset=True)[:, 1]
        if not significant(free):
            free[:] = np.nan
    return RelaxationFit(FITTED, known[:, 1], known[:, 0], free, float(time[-1]), quality)


def fit_exponential(time: np.ndarray, deviation: np.ndarray) -> np.ndarray:
    """Return (amplitude, rate) of eq. 6 fitted to one curve, without a test of significance.

    time, deviation : as for ``fit_relaxation``, of shape (samples,). NaN if no exponential fits.
    """
    nothing = np.full(2, np.nan)
    end = fit_window(deviation)
    time, deviation = time[:end], deviation[:end]
    start = _start(time, deviation)
    if start is None:
        return nothing
    (fit,) = _fit_all(time, deviation[None], start)
    return fit if _quality(time, deviation, fit) >= MIN_QUALITY else nothing


def fit_window(deviation: np.ndarray) -> int:
    """Return the number of samples until the deviation has decreased to 5 % of its first value."""
    low = np.flatnonzero(np.abs(deviation) < WINDOW_END * abs(deviation[0]))
    end = low[0] + 1 if low.size else deviation.size
    return int(min(max(end, MIN_WINDOW_SAMPLES), deviation.size))


def _quality(time: np.ndarray, deviation: np.ndarray, fit: np.ndarray) -> float:
    """Return 1 - residual sum of squares / sum of squares, NaN without a fit."""
    residual = np.sum((deviation - fit[0] * np.exp(-fit[1] * time)) ** 2)
    return float(1.0 - residual / np.sum(deviation**2))


def _start(time: np.ndarray, deviation: np.ndarray) -> np.ndarray | None:
    """Return the rate from the first sample and the one nearest to 1/e of it, shape (1,)."""
    share = deviation[1:] / deviation[0]
    usable = np.flatnonzero((share > 0.0) & (share < 1.0))
    if not usable.size:
        return None
    k = usable[np.argmin(np.abs(np.log(share[usable]) + 1.0))]
    return -np.log(share[k : k + 1]) / (time[k + 1] - time[0])


def _fit_all(
    time: np.ndarray, curves: np.ndarray, rates: np.ndarray, offset: bool = False
) -> np.ndarray:
    """Return rows (amplitude, rate) of the fit of every row of ``curves``, NaN if it fails.

    rates : initial guesses. offset : also fit an offset. The weight of a sample is the time between
    the midpoints to its neighbours (of the first sample, from the jump on). The weighted sum then
    approximates an integral over time for any spacing of the samples.
    """
    scale, span = curves[0, 0], time[-1]
    halfway = 0.5 * (time[1:] + time[:-1])
    durations = np.diff(np.concatenate([[0.0], halfway, [2.0 * span - halfway[-1]]]))
    fits = fit_decays(time, curves / scale, durations, rates, offset)
    amplitude, phase = scale * fits[:, 0], fits[:, 1] * span
    inside = (phase > 1e-3) & (phase < 1e4)
    return np.where(inside[:, None], np.column_stack([amplitude, fits[:, 1]]), np.nan)


def _unfitted(status: int, size: int) -> RelaxationFit:
    nothing = np.full(size, np.nan)
    return RelaxationFit(status, nothing, nothing, nothing, np.nan, np.nan)
