"""Measured lines made ready: levelled, then made periodic, each in a stated way."""

import numpy as np

from ...errors import UserError

DETRENDS = {"none": None, "mean": 0, "line": 1, "parabola": 2}  # degree of what is removed
PERIODICS = {"none": 1, "mirror": 2, "taper": 1}  # how often a line goes into the period
TAPERED = 0.1  # of the length, at either end
FLAT = 1e-9  # of the largest height: what levelling leaves of a straight line by rounding
UNEVEN = 0.01  # of a step: positions that are off by less are uniform
MIXED = 0.01  # of the steps: so many must be of another length where all of them are rounded


def uniform_step(key: str, name: str, x: np.ndarray, precision: np.ndarray) -> float:
    """Return the step of uniform positions, negative where they descend.

    precision : to how much each position is known, shape of x. Positions that are written with
    few decimals step unevenly, now by 0.1 and now by 0.2; then the straight line fitted to them
    must pass within a decimal of all. Its slope is the step. The length of n samples is n steps.

    Raises UserError where the positions are not uniform. A single longer step is a gap, even
    where a decimal is as long as a step.
    """
    index = np.arange(x.size) - 0.5 * (x.size - 1)
    step = float(np.sum(index * (x - x.mean())) / np.sum(index**2))
    off = np.abs(x - x.mean() - step * index)
    steps = np.diff(x)
    uneven = np.abs(steps - np.median(steps))
    even = np.all(off <= UNEVEN * abs(step))
    other = np.count_nonzero(uneven > 0.5 * precision[1:])
    if not even and other >= max(2.0, MIXED * x.size):
        even = np.all(off <= precision + UNEVEN * abs(step))
    if step == 0.0 or not even:
        worst = int(np.argmax(uneven))
        raise UserError(
            f"{key} = {name!r}: sample {worst + 2} is {steps[worst]:.6g} after the one before, in "
            f"the mean steps are {step:.6g}: bring the samples to equal steps first"
        )
    return step


def level(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Return the heights, shape (lines, n), less the polynomial fitted to each line."""
    degree = DETRENDS[detrend]
    if degree is None:
        return heights
    t = np.linspace(-1.0, 1.0, heights.shape[1])
    for polynomial in (np.ones_like(t), t, t**2 - np.mean(t**2))[: degree + 1]:  # orthogonal
        part = np.sum(heights * polynomial, axis=1) / np.sum(polynomial**2)
        heights = heights - part[:, None] * polynomial
    return heights


def make_periodic(heights: np.ndarray, periodic: str) -> np.ndarray:
    """Return one period of each line, shape (lines, n), or (lines, 2 n) where it is mirrored.

    ``mirror`` appends the line reversed. ``taper`` brings both ends to the mean height by a
    cosine over a tenth of the length. ``none`` leaves a step where the ends do not meet.
    """
    if periodic == "mirror":
        return np.concatenate([heights, heights[:, ::-1]], axis=1)
    if periodic == "taper":
        samples = heights.shape[1]
        from_end = np.minimum(np.arange(samples), np.arange(samples)[::-1]) + 0.5
        window = np.sin(0.5 * np.pi * np.minimum(1.0, from_end / (TAPERED * samples))) ** 2
        mean = heights.mean(axis=1, keepdims=True)
        return mean + window * (heights - mean)
    return heights


def spikes(heights: np.ndarray) -> int:
    """Return how many samples stand out from both neighbours by over 10 usual differences.

    The usual difference is the median, over the line, of a sample's distance from the mean of its
    neighbours; where that is zero, nothing can be said.
    """
    curvature = heights[:, 1:-1] - 0.5 * (heights[:, :-2] + heights[:, 2:])
    usual = np.median(np.abs(curvature), axis=1, keepdims=True) / 0.6745  # sigma, if normal
    return int(np.count_nonzero((usual > 0.0) & (np.abs(curvature) > 10.0 * usual)))


def check_not_flat(what: str, heights: np.ndarray, raw: np.ndarray) -> None:
    """Raise UserError for a line that is a plateau, heights without any roughness."""
    flat = heights.std(axis=1) <= FLAT * np.abs(raw).max(axis=1)
    if flat.any():
        raise UserError(
            f"{what}: line {int(np.argmax(flat)) + 1} of {flat.size} is flat: needs "
            "heights that differ by more than a trend"
        )
