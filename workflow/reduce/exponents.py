"""Fits of eq. 13, b = x^alpha, over the rates of one H. Source: Li et al. (2014), eq. 13."""

from typing import NamedTuple

import numpy as np

from .blocks import Estimates, enter
from .fits import FITTED
from .resolution import UNRESOLVED


class PowerLaw(NamedTuple):
    """Fit of eq. 13; arrays hold the estimate, then its jackknife replicates."""

    alpha: np.ndarray  # b = x^alpha, shape (replicates,)
    alpha_free: np.ndarray  # b = c x^alpha, shape (replicates,)
    prefactor: np.ndarray  # c, shape (replicates,)
    scatter: float  # rms of log10(b / x^alpha)
    points: int


def fit_power_law(x: np.ndarray, rate: np.ndarray) -> PowerLaw:
    """Fit log b = alpha log x (eq. 13) over the given points, all with x > 1.

    x : shape (points,). rate : b, shape (points, replicates). NaN where fewer than 3 points.
    """
    count, size = rate.shape
    if count < 3 or np.ptp(x) == 0.0:
        nothing = np.full(size, np.nan)
        return PowerLaw(nothing, nothing, nothing, np.nan, count)
    log_x, log_b = np.log(x), np.log(rate)
    alpha = log_x @ log_b / (log_x @ log_x)
    centred = log_x - log_x.mean()
    free = centred @ log_b / (centred @ centred)
    prefactor = np.exp(log_b.mean(axis=0) - free * log_x.mean())
    residual = (log_b[:, 0] - alpha[0] * log_x) / np.log(10.0)
    return PowerLaw(alpha, free, prefactor, float(np.sqrt(np.mean(residual**2))), count)


def exponent_bias(x: np.ndarray, bias: np.ndarray) -> tuple[float, float]:
    """Return how far a bias of b may move alpha of b = x^alpha, and of b = c x^alpha.

    x, bias : relative bound, shape (points,). The one: all points off in the same direction; the
    other: fast and slow ones in opposite directions. NaN where there is no fit.
    """
    if x.size < 3 or np.ptp(x) == 0.0:
        return np.nan, np.nan
    off, log_x = np.log1p(bias), np.log(x)
    centred = log_x - log_x.mean()
    return float(off @ log_x / (log_x @ log_x)), float(off @ np.abs(centred) / (centred @ centred))


def fit_exponents(
    axis: tuple[float, ...], hurst: np.ndarray, points: Estimates, rates: np.ndarray
) -> Estimates:
    """Return name -> array over ``axis``: the fits of eq. 13 over distinct problems with x > 1.

    axis : the Hurst exponents to fit for. hurst and points : per task, shape (tasks,). rates : b
    and its jackknife replicates, shape (tasks, blocks + 1). Points whose contacts are unresolved
    are left out and counted.
    """
    x = points["speed_ratio"]
    fitted = (points["fit_status"] == FITTED) & (x > 1.0)
    resolved = points["resolution_status"] != UNRESOLVED
    chosen = [fitted & resolved & (hurst == value) for value in axis]
    bias = [exponent_bias(x[rows], points["relaxation_rate_bias"][rows]) for rows in chosen]
    left = [np.sum(fitted & ~resolved & (hurst == value)) for value in axis]
    laws = [fit_power_law(x[rows], rates[rows]) for rows in chosen]
    found: Estimates = {}
    enter(found, "alpha", np.array([law.alpha for law in laws]))
    enter(found, "alpha_free", np.array([law.alpha_free for law in laws]))
    enter(found, "alpha_prefactor", np.array([law.prefactor for law in laws]))
    found["alpha_scatter"] = np.array([law.scatter for law in laws])
    found["alpha_bias"], found["alpha_free_bias"] = np.array(bias).T
    found["alpha_unresolved"] = np.array(left, dtype=np.int32)
    found["alpha_points"] = np.array([law.points for law in laws], dtype=np.int32)
    return found
