"""Bounds of d and D that a march assumes: first guessed, then checked at every step."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .jump_problem import indentation_advance

MIN_SPREAD = 1e-11  # smallest spread of d or D, relative to d; far above rounding


class Bounds(NamedTuple):
    """Open intervals assumed to contain d and D(t) = d(t) - E d(t - 1), in h."""

    d_min: float
    d_max: float
    advance_min: float  # of D
    advance_max: float


EMPTY_BOUNDS = Bounds(np.inf, -np.inf, np.inf, -np.inf)


@kernel
def within_bounds(bounds, d, advance):
    """Return whether d and D = ``advance`` lie within the bounds; False for NaN."""
    d_inside = bounds.d_min < d < bounds.d_max
    return d_inside and bounds.advance_min < advance < bounds.advance_max


@kernel
def spread_bounds(law, visited, margin):
    """Return the range ``visited`` of d and D, widened on each side by ``margin`` of its spread.

    The bounds of D include d / K, its value at constant d, for every d within the bounds.
    """
    d_min, d_max, advance_min, advance_max = visited
    wide = margin * max(d_max - d_min, MIN_SPREAD * d_max)
    low, high = max(d_min - wide, 0.0), d_max + wide
    least, most = min(advance_min, low / law.stiffness), max(advance_max, high / law.stiffness)
    wide = margin * max(most - least, MIN_SPREAD * d_max)
    return Bounds(low, high, least - wide, most + wide)


@refcount_free_kernel
def initial_bounds(problem, d, margin):
    """Return the Bounds of a whole march. d : estimate of d after the first step."""
    one, two = problem.start.d, problem.end.d
    advance = indentation_advance(problem.law, d, one)
    visited = Bounds(min(one, two, d), max(one, two, d), advance, advance)
    return spread_bounds(problem.law, visited, margin)


@kernel
def extended_bounds(visited, d, advance):
    """Return the range ``visited`` of d and D, extended to include this d and D."""
    least, most = min(visited.advance_min, advance), max(visited.advance_max, advance)
    return Bounds(min(visited.d_min, d), max(visited.d_max, d), least, most)
