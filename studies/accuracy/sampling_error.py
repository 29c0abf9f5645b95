"""Sampling error: how far the mean of R realizations is from that of all, R = 10 ... 2000."""

import numpy as np

from elastomer_friction.workflow.reduce import fit_exponential

from .points import Point, Surface
from .sampling import Method, Runs, run

COUNTS = (10, 20, 50, 100, 200, 500, 1000)
MOST_GROUPS = 40


def sampling_errors(point: Point, surfaces: list[Surface], steps: int) -> np.ndarray:
    """Return the rms relative error of groups of R lines, shape (COUNTS, 3): mu_1, jump, rate.

    Against all lines; what the group has in common with them is corrected for. NaN with fewer
    than two groups, or where the rate can be fitted in fewer than half of them.
    """
    runs = run(point, surfaces, Method("exponential", steps))
    lines = len(surfaces)
    whole = _estimate(runs, slice(0, lines))
    found = np.full((len(COUNTS), 3), np.nan)
    for row, count in enumerate(COUNTS):
        number = min(MOST_GROUPS, lines // count)
        if number < 2:
            break
        parts = [_estimate(runs, slice(k * count, (k + 1) * count)) for k in range(number)]
        apart = np.array(parts) / whole - 1.0
        for q in range(3):
            there = apart[np.isfinite(apart[:, q]), q]
            if there.size >= max(2, number // 2):
                found[row, q] = np.sqrt(np.mean(there**2) / (1.0 - count / lines))
    return found


def _estimate(runs: Runs, rows: slice) -> np.ndarray:
    """Return (mu_1, jump, b) of the mean over some lines."""
    deviation = (runs.curves[rows] - runs.mu_2[rows, None]).mean(axis=0)
    rate = fit_exponential(runs.moments, deviation)[1]  # here every b counts, significant or not
    return np.array([runs.mu_1[rows].mean(), runs.jump[rows].mean(), rate])
