"""References by Richardson extrapolation, and errors against them on the same lines."""

from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import amplitudes, rms_slope
from elastomer_friction.workflow.reduce import fit_relaxation, replicates, standard_error

from .points import Point
from .sampling import Runs

QUANTITIES = ("mu_1", "jump", "rate", "curve")
MOMENTS = 24  # at which curves are compared


class Observed(NamedTuple):
    """What a method gives on some lines."""

    mu_1: np.ndarray  # shape (lines,)
    jump: np.ndarray  # shape (lines,)
    curve: np.ndarray  # shape (lines, MOMENTS): mu over its mean jump
    rate: np.ndarray  # b of the mean curve and of its jackknife replicates; NaN: no fit


class Reference(NamedTuple):
    """Observed values in the limit m -> infinity, and how far they may be off (relative)."""

    limit: Observed
    error: np.ndarray  # shape (QUANTITIES,)
    end: float  # of the compared curves, in tau


class Errors(NamedTuple):
    """Relative errors of a method; the curve's relative to the jump. Shapes (QUANTITIES,)."""

    rms: np.ndarray  # over lines; of the rate: |bias|
    bias: np.ndarray  # of the mean over lines, signed; of the curve: rms over time
    bias_error: np.ndarray  # standard error of the bias


def observe(point: Point, elements: int, runs: Runs, lines: int, end: float) -> Observed:
    """Return what the first ``lines`` of some runs give."""
    rows = slice(0, lines)
    start = (runs.mu_1 + runs.jump)[rows, None]
    values = np.concatenate([start, runs.curves[rows]], axis=1)
    moments = np.concatenate([[0.0], runs.moments])
    grid = np.linspace(0.0, end, MOMENTS)
    curve = np.array([np.interp(grid, moments, line) for line in values])
    deviation = replicates(runs.curves[rows] - runs.mu_2[rows, None], 0)
    slope = rms_slope(amplitudes(point.hurst, elements), elements)
    rate = fit_relaxation(runs.moments, deviation, slope).rate
    return Observed(runs.mu_1[rows], runs.jump[rows], curve, rate)


def extrapolate(fine: Observed, coarse: Observed, end: float) -> Reference:
    """Return the limit by Richardson extrapolation from 2 m (fine) and m (coarse), of order 2.

    Its error is stated as the difference to extrapolation of order 1: 2/3 of fine - coarse.
    """
    limit = Observed(*(f + (f - c) / 3.0 for f, c in zip(fine, coarse, strict=True)))
    apart = compare(coarse, Reference(fine, np.zeros(4), end))
    return Reference(limit, 2.0 / 3.0 * apart.rms, end)


def compare(found: Observed, reference: Reference) -> Errors:
    """Return the errors of what was found on the lines of the reference."""
    limit = reference.limit
    scale = limit.jump.mean()
    mu_1 = (found.mu_1 - limit.mu_1) / limit.mu_1.mean()
    jump, curve = (found.jump - limit.jump) / scale, (found.curve - limit.curve) / scale
    rate = found.rate / limit.rate - 1.0
    rms = [np.sqrt(np.mean(each**2)) for each in (mu_1, jump, rate[:1], curve)]
    curves = np.sqrt(np.mean(replicates(curve, 0) ** 2, axis=1))
    means = (replicates(mu_1, 0), replicates(jump, 0), rate, curves)
    bias, error = [mean[0] for mean in means], [standard_error(mean, 0) for mean in means]
    return Errors(np.array(rms), np.array(bias), np.array(error))


def deviations(found: Observed) -> np.ndarray:
    """Return the relative standard deviation of one realization, shape (QUANTITIES,).

    Of the rate: that of its jackknife, per realization; of the curve: rms over time, over the jump.
    """
    lines = found.mu_1.size
    rate = np.sqrt(lines) * standard_error(found.rate, 0) / found.rate[0]
    curve = np.sqrt(np.mean(found.curve.var(axis=0, ddof=1))) / found.jump.mean()
    each = (np.std(q, ddof=1) / q.mean() for q in (found.mu_1, found.jump))
    return np.array([*each, rate, curve])


def order(steps: np.ndarray, error: np.ndarray, floor: float) -> float:
    """Return the measured order of convergence: the slope of log error over log m.

    Over m with errors between ``floor`` and 0.1: those not resolved yet, or not resolved by the
    reference, do not count. NaN with fewer than 3.
    """
    used = (error < 0.1) & (error > floor)
    if np.count_nonzero(used) < 3:
        return np.nan
    return float(-np.polyfit(np.log(steps[used]), np.log(error[used]), 1)[0])
