"""The rms slope grad z from the jumps of friction (eq. 12).

Source: Li et al. (2014), doi:10.1038/srep05795, eq. 12.
"""

import numpy as np

from ..kinetic_law import normalised_jump
from .errors import DEVIATIONS, Estimate
from .step_fit import LARGEST_SHARE, StepFit

LEAST_ERROR = 1e-3  # share of a jump: none is measured better
SLOPES = np.geomspace(1e-2, 1e4, 20_001)  # tried, in units of the largest friction


def fit_slope(fits: list[StepFit]) -> Estimate:
    """Return grad z from the jumps of steps; NaN where they do not determine it.

    At low speed the jump is in proportion to friction alone, whatever the slope (eq. 10).
    """
    found = [fit for fit in fits if fit.jump.known]
    if not found:
        return Estimate()
    step = np.array([fit.step.ratio - 1.0 for fit in found])
    mu = np.array([fit.mu_1.value for fit in found])
    jump = np.array([fit.jump.value for fit in found]) / step
    error = np.array([fit.jump.error for fit in found]) / np.abs(step)
    error = np.maximum(error, LEAST_ERROR * np.abs(jump))
    slopes = SLOPES * np.max(np.abs(mu))
    squares = np.sum(((predicted_jump(mu, slopes[:, None]) - jump) / error) ** 2, axis=1)
    least = squares.min()
    scatter = max(1.0, least / max(mu.size - 1, 1))
    inside = np.log(slopes[squares <= least + DEVIATIONS**2 * scatter])
    value = float(slopes[np.argmin(squares)])
    share = float(np.ptp(inside)) / (2.0 * DEVIATIONS)
    return Estimate(value, value * share).if_below(LARGEST_SHARE * value)


def predicted_jump(mu_1: np.ndarray, slope: np.ndarray | float) -> np.ndarray:
    """Return the jump over the relative step dv/v1, for friction before the step (eq. 12)."""
    return slope * normalised_jump(mu_1 / slope)
