"""Least squares of exponential decays, many curves at once, by variable projection.

For every rate k the best amplitude and offset follow in closed form, so that the search is over k
alone. With <f> the weighted mean of f over the samples, y the curve and e = exp(-k t), both minus
their means if an offset is fitted,

    min over the amplitude of <(y - a e)^2> = <y^2> - <y e>^2 / <e^2>,

so that k maximizes the gain <y e>^2 / <e^2>. Newton's method with the derivatives by log k needs
few steps. ``least_squares.fit_curves`` fits any model with the same result, but is slower.
Source: G. H. Golub and V. Pereyra, SIAM J. Numer. Anal. 10, 413 (1973), doi:10.1137/0710036.
"""

from typing import NamedTuple

import numpy as np

MAX_NEWTON_STEPS = 100
MAX_LOG_STEP = 1.0  # largest step of log k
LAST_LOG_STEP = 1e-5  # of log k, at convergence: the next step would be about its square
GAIN_ROUNDING = 1e-13  # relative decrease of the gain that is accepted
RATE_RANGE = (1e-4, 1e5)  # of k times the last time, from a constant to an immediate decay
STEP_REDUCTION = 0.25  # factor on a step after which the gain decreased


class _Rates(NamedTuple):
    """Fits of curves at given rates; arrays of shape (curves,)."""

    log: np.ndarray  # of k
    amplitude: np.ndarray
    gain: np.ndarray  # decrease of the sum of squares by the decay
    step: np.ndarray  # of log k towards the largest gain


def fit_decays(
    time: np.ndarray,
    curves: np.ndarray,
    weight: np.ndarray,
    rates: np.ndarray,
    offset: bool = False,
) -> np.ndarray:
    """Return the amplitude and rate of the exponential that fits each row of ``curves`` best.

    time : shape (samples,). curves : shape (curves, samples). weight : of the samples, shape
    (samples,), positive. rates : initial guesses, positive, shape (curves,) or (1,).
    offset : also fit a constant. If no exponential fits near the guess, the rate ends at a bound of
    RATE_RANGE or at the guess. The result has the shape (curves, 2).
    """
    share = weight / weight.sum()
    if offset:
        curves = curves - _means(curves, share)
    weighted = share * curves
    low, high = np.log(np.array(RATE_RANGE) / time[-1])
    log = np.clip(np.log(np.broadcast_to(rates, len(curves))), low, high)
    with np.errstate(all="ignore"):  # the amplitude of a decay before the first sample is undefined
        best = _fits_at(time, weighted, share, log, offset)
        fraction, active = np.ones(len(curves)), np.ones(len(curves), bool)
        for _ in range(MAX_NEWTON_STEPS):
            trial = np.clip(best.log + fraction * best.step, low, high)
            active &= np.isfinite(trial)
            step = np.abs(trial - best.log)
            new = _fits_at(time, weighted, share, trial, offset)
            better = new.gain >= (1.0 - GAIN_ROUNDING) * best.gain
            best = _Rates(*(np.where(better & active, *p) for p in zip(new, best, strict=True)))
            fraction = np.where(better, 1.0, STEP_REDUCTION * fraction)
            active &= step > LAST_LOG_STEP
            if not active.any():
                break
    return np.column_stack([best.amplitude, np.exp(best.log)])


def _fits_at(
    time: np.ndarray, weighted: np.ndarray, share: np.ndarray, log: np.ndarray, offset: bool
) -> _Rates:
    """Return the fits of curves at given rates.

    share : normalised weights of the samples. weighted : curves times share. log : log k, shape
    (curves,).
    """
    phase = np.exp(log)[:, None] * time
    decay = np.exp(-phase)  # e, then its derivatives with respect to log k
    first = -phase * decay
    second = first * (1.0 - phase)
    if offset:  # the second derivative is only multiplied by functions without mean
        decay, first = (f - _means(f, share) for f in (decay, first))
    weighted_decay, weighted_slope = share * decay, share * first
    # p = <y e>, q = <e^2>, and their derivatives: the gain is p^2 / q, the amplitude a is p / q.
    p, dp, ddp = (_sums(weighted, f) for f in (decay, first, second))
    q, dq = _sums(weighted_decay, decay), 2.0 * _sums(weighted_decay, first)
    ddq = 2.0 * (_sums(weighted_slope, first) + _sums(weighted_decay, second))
    gain, a = p * p / q, p / q
    up = a * (2.0 * dp - a * dq)
    bend = 2.0 * (dp - a * dq) ** 2 / q + a * (2.0 * ddp - a * ddq)
    newton = np.where(bend < 0.0, -up / bend, np.copysign(MAX_LOG_STEP, up))
    return _Rates(log, a, gain, np.clip(newton, -MAX_LOG_STEP, MAX_LOG_STEP))


def _means(values: np.ndarray, share: np.ndarray) -> np.ndarray:
    return np.einsum("cs,s->c", values, share)[:, None]


def _sums(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.einsum("cs,cs->c", one, other)
