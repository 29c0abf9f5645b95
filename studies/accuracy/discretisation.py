"""Errors and times of all discretisations of one point, against its reference."""

import math
from typing import NamedTuple

import numpy as np

from .errors import (
    Errors,
    Observed,
    Reference,
    compare,
    deviations,
    extrapolate,
    observe,
    order,
)
from .points import Point, Surface
from .sampling import Method, run, seconds

SCHEMES = ("exponential", "implicit-euler")
LEAST_LINES = 20  # a rate is claimed from 18 on


class Ladder(NamedTuple):
    """One scheme at one point over m = 1, 2, 4, ..."""

    steps: list[int]
    errors: list[Errors]
    seconds: np.ndarray  # shape (steps, 2): mu_1 and jump, everything
    observed: list[Observed]  # on all lines of each m


def ladder_steps(point: Point, most: int) -> list[int]:
    """Return m = 1, 2, 4 ... up to ``most``, further where tau is not resolved by then."""
    top = max(most, 2 ** math.ceil(math.log2(2.4 / point.speed)))
    return [2**k for k in range(int(math.log2(top)) + 1)]


def lines_at(steps: int, most: int) -> int:
    """Return the number of lines at m: fewer where they cost more."""
    return max(min(LEAST_LINES, most), min(most, 8 * most // steps))


def reference(point: Point, surfaces: list[Surface], most: int) -> Reference:
    """Return the reference of a point, extrapolated from twice the finest m."""
    finest = ladder_steps(point, most)[-1]
    lines = lines_at(2 * finest, len(surfaces))
    fine = run(point, surfaces[:lines], Method("exponential", 2 * finest))
    coarse = run(point, surfaces[:lines], Method("exponential", finest))
    end, elements = float(fine.moments[-1]), surfaces[0].elements
    limit = observe(point, elements, fine, lines, end)
    return extrapolate(limit, observe(point, elements, coarse, lines, end), end)


def climb(
    point: Point, surfaces: list[Surface], scheme: str, steps: list[int], limit: Reference
) -> Ladder:
    """Run a scheme over all m; errors are those on the lines of the reference."""
    paired, elements = limit.limit.mu_1.size, surfaces[0].elements
    errors, times, observed = [], [], []
    for m in steps:
        runs = run(point, surfaces[: lines_at(m, len(surfaces))], Method(scheme, m))
        errors.append(compare(observe(point, elements, runs, paired, limit.end), limit))
        observed.append(observe(point, elements, runs, runs.mu_1.size, limit.end))
        times.append(seconds(runs))
    return Ladder(steps, errors, np.array(times), observed)


def orders(ladder: Ladder, limit: Reference) -> np.ndarray:
    """Return the measured order of convergence per quantity."""
    steps = np.array(ladder.steps)
    rms = np.array([error.rms for error in ladder.errors])
    return np.array([order(steps, rms[:, q], 2.0 * limit.error[q]) for q in range(4)])


def spread(ladder: Ladder) -> np.ndarray:
    """Return the relative standard deviation of one realization, at a middle m."""
    found = np.array([deviations(o) for o in ladder.observed])
    middle = next((k for k, row in enumerate(found) if k >= 2 and np.isfinite(row).all()), 2)
    return found[middle]
