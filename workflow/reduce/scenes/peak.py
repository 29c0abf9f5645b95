"""The peak of the friction after a change of motion: the direct effect, and where it ends.

Without a dashpot friction does not jump with the velocity; what an experiment calls its direct
effect is then the peak, and the time at which it is reached.
"""

import numpy as np


def extremum(place: np.ndarray, curves: np.ndarray, sign: float) -> tuple[np.ndarray, np.ndarray]:
    """Return (value, place) of the largest ``sign`` times value of each curve, shape (replicates,).

    place : times or distances, increasing, shape (samples,). curves : shape (replicates, samples).
    Between samples by the parabola through the largest and its neighbours; at either end the
    sample itself. NaN where a curve holds NaN.
    """
    found = np.full((2, len(curves)), np.nan)
    for row, curve in enumerate(curves):
        if np.isfinite(curve).all():
            found[:, row] = _highest(place, sign * curve)
    return sign * found[0], found[1]


def _highest(x: np.ndarray, y: np.ndarray) -> tuple[float, float]:
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
