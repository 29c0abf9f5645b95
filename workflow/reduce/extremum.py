"""Extremum of sampled curves."""

import numpy as np


def extremum(place: np.ndarray, curves: np.ndarray, sign: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the value and place of the maximum (sign 1) or minimum (-1) of each curve.

    place : times or distances, increasing, shape (samples,). curves : shape (replicates, samples).
    The extremum is that of a parabola through the extreme sample and its neighbours, or the sample
    itself at an end. NaN for a curve with NaN.
    """
    extrema = np.full((2, len(curves)), np.nan)
    for row, curve in enumerate(curves):
        if np.isfinite(curve).all():
            extrema[:, row] = _highest(place, sign * curve)
    return sign * extrema[0], extrema[1]


def _highest(x: np.ndarray, y: np.ndarray) -> tuple[float, float]:
    """Return value and place of the maximum of samples."""
    k = int(np.argmax(y))
    if not 0 < k < y.size - 1:
        return float(y[k]), float(x[k])
    before, after = x[k] - x[k - 1], x[k + 1] - x[k]
    fall, rise = (y[k] - y[k - 1]) / before, (y[k + 1] - y[k]) / after
    bend = (rise - fall) / (before + after)  # not positive, as y[k] is the largest
    if bend == 0.0:
        return float(y[k]), float(x[k])
    slope = fall + bend * before  # of the parabola at x[k]
    shift = -slope / (2.0 * bend)
    return float(y[k] + 0.5 * slope * shift), float(x[k] + shift)
