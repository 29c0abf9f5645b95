"""Least squares of exponential decays, many curves at once, by variable projection.

The amplitude, and an offset, enter the sum of squares in such a way that the best ones are known
for every rate. What is left is a search for the rate k alone: with <f> the weighted mean of f over
the samples, y the curve and e = exp(-k t), both less their means where there is an offset,

    min over the amplitude of <(y - a e)^2> = <y^2> - <y e>^2 / <e^2>,

so that k makes <y e>^2 / <e^2> largest. Its derivatives with respect to log k are known, and
Newton's method needs few steps. ``least_squares.fit_curves``, which fits any law, finds the same
and takes longer.
Source: G. H. Golub and V. Pereyra, SIAM J. Numer. Anal. 10, 413 (1973), doi:10.1137/0710036.
"""

from typing import NamedTuple

import numpy as np

MOST_STEPS = 100
LARGEST_STEP = 1.0  # of log k
ENOUGH = 1e-5  # step of log k below which it is the last: the next one would be its square
ROUNDING = 1e-13  # relative fall of what is made largest that counts as none
RANGE = (1e-4, 1e5)  # of k times the last time: beyond it a curve is flat, or gone at once
SMALLER = 0.25  # share of a step that is tried where it was too long


class _Rates(NamedTuple):
    """Curves at some rate of each; arrays of shape (curves,)."""

    log: np.ndarray  # of k
    amplitude: np.ndarray
    gain: np.ndarray  # by how much the decay lowers the sum of squares
    step: np.ndarray  # of log k to the largest gain, by Newton's method where that is near


def fit_decays(
    time: np.ndarray,
    curves: np.ndarray,
    weight: np.ndarray,
    rates: np.ndarray,
    offset: bool = False,
) -> np.ndarray:
    """Return rows (amplitude, rate) of the exponential that fits each row of ``curves`` best.

    time : shape (samples,). curves : shape (curves, samples). weight : of the samples, shape
    (samples,), positive. rates : where the search begins, positive, shape (curves,) or (1,).
    offset : whether a constant is fitted too. A curve with no exponential near ends at the end of
    the RANGE, or where it began.
    """
    share = weight / weight.sum()
    if offset:
        curves = curves - _means(curves, share)
    weighted = share * curves
    low, high = np.log(np.array(RANGE) / time[-1])
    log = np.clip(np.log(np.broadcast_to(rates, len(curves))), low, high)
    with np.errstate(all="ignore"):  # a decay that is gone at once has no amplitude
        best = _at(time, weighted, share, log, offset)
        part, going = np.ones(len(curves)), np.ones(len(curves), bool)
        for _ in range(MOST_STEPS):
            tried = np.clip(best.log + part * best.step, low, high)
            going &= np.isfinite(tried)
            step = np.abs(tried - best.log)
            new = _at(time, weighted, share, tried, offset)
            better = new.gain >= (1.0 - ROUNDING) * best.gain
            best = _Rates(*(np.where(better & going, *p) for p in zip(new, best, strict=True)))
            part = np.where(better, 1.0, SMALLER * part)
            going &= step > ENOUGH
            if not going.any():
                break
    return np.column_stack([best.amplitude, np.exp(best.log)])


def _at(
    time: np.ndarray, weighted: np.ndarray, share: np.ndarray, log: np.ndarray, offset: bool
) -> _Rates:
    """Return what curves come to at some rates.

    share : of the samples in the weight. weighted : each curve times it. log : log k of each.
    """
    phase = np.exp(log)[:, None] * time
    decay = np.exp(-phase)  # e, then its derivatives with respect to log k
    first = -phase * decay
    second = first * (1.0 - phase)
    if offset:  # the second derivative is only multiplied by what has no mean
        decay, first = (each - _means(each, share) for each in (decay, first))
    own, slope = share * decay, share * first
    # p = <y e>, q = <e^2>, and their derivatives: the gain is p^2 / q, the amplitude a is p / q.
    p, dp, ddp = (_sums(weighted, each) for each in (decay, first, second))
    q, dq = _sums(own, decay), 2.0 * _sums(own, first)
    ddq = 2.0 * (_sums(slope, first) + _sums(own, second))
    gain, a = p * p / q, p / q
    up = a * (2.0 * dp - a * dq)
    bend = 2.0 * (dp - a * dq) ** 2 / q + a * (2.0 * ddp - a * ddq)
    newton = np.where(bend < 0.0, -up / bend, np.copysign(LARGEST_STEP, up))
    return _Rates(log, a, gain, np.clip(newton, -LARGEST_STEP, LARGEST_STEP))


def _means(values: np.ndarray, share: np.ndarray) -> np.ndarray:
    return np.einsum("cs,s->c", values, share)[:, None]


def _sums(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.einsum("cs,cs->c", one, other)
