"""Steady sliding where contacts are narrow: the line is refined where it can touch.

At light load and high speed an element stays behind the line and only the front of the highest
peaks touches, over less than a sample. The line is a smooth function known by its heights and
slopes, so it is interpolated where it lies below the indentation; all else is out of contact and
costs one decay. Fine samples there stand for a finer line throughout.
"""

import math
from typing import NamedTuple

import numpy as np

from kernels.jit import kernel
from kernels.patches.samples import samples_per_contact
from kernels.rheology.kelvin import SCHEMES
from kernels.rheology.law import State
from kernels.steady.plain import steady_sliding
from kernels.surfaces.line import Line

LEAST_STEPS = 4  # samples per spacing, eight in the shortest wave: heights in between to 1e-3
NARROW = 24.0  # samples per contact; in wider ones quadrature keeps 2 % of the jump
FINE = 48.0  # samples per contact that are aimed at; half of it will do
MOST_FOLD = 2**17  # fine samples for one
MOST_SAMPLES = 2_000_000  # fine ones of all
BELOW = 1.5  # times the indentation over the deepest point: what lies lower is refined
TRIED = 12


class Refined(NamedTuple):
    """The stretches of a line that can touch, on finer samples, and its steady state there."""

    line: Line  # one stretch after the other; steps_per_spacing is the fine one
    state: State
    load: float  # sum of the forces on the fine samples, n Fbar times the fold
    share: float  # of the line that the fine samples stand for
    samples: float  # per contact


def refined(
    line: Line, speed: float, scheme: str, load: float, d: float, samples: float
) -> Refined | None:
    """Return the steady state on a refined line, or None where none is needed or within reach.

    speed : vbar. load : n Fbar. d, samples : indentation and samples per contact of steady sliding
    on the line as it is. None for wide contacts, for lines that are not known between their
    samples, and where what could touch is too long.
    """
    z, slope, steps = line.z, line.slope, line.steps_per_spacing
    if samples >= NARROW or not line.band_limited or steps < LEAST_STEPS:
        return None
    curvature = curvatures(z, slope, 1.0 / steps)
    fold = finer(samples)
    reach_to = BELOW * d
    for _ in range(TRIED):
        at = stretches(z, slope, 1.0 / steps, reach_to)
        if fold > MOST_FOLD or at.size * fold > MOST_SAMPLES:
            return None
        fine = steps * fold
        law = SCHEMES[scheme](1.0 / (fine * speed))
        heights, slopes = interpolate(z, slope, curvature, at, 1.0 / steps, fold)
        decay = decays(at, fold, z.size, math.exp(-1.0 / (fine * speed)))
        (w, d), _ = steady_sliding(law, heights, load * fold, decay)
        lowest = float(heights.min())  # perhaps between samples, below all of them
        beyond, reach_to = d > reach_to, lowest + BELOW * (d - lowest)
        if beyond:
            continue
        samples = samples_per_contact(d - (heights - w))
        if samples >= 0.5 * FINE:
            part = line._replace(z=heights, slope=slopes, steps_per_spacing=fine)
            return Refined(part, State(w, d), load * fold, at.size / z.size, samples)
        fold *= finer(samples)
    return None


def finer(samples: float) -> int:
    """Return how many times finer samples must be, a power of two, for FINE of them per contact."""
    return 2 ** max(1, math.ceil(math.log2(FINE / samples)))


@kernel
def curvatures(z, slope, spacing):
    """Return z'' (in h/dx^2) from heights and slopes, shape (n,); of fourth order."""
    n = z.size
    found = np.empty(n)
    for j in range(n):
        k, i = (j + 1) % n, (j - 1) % n
        bend = (z[k] - z[j]) - (z[j] - z[i])
        found[j] = 2.0 * bend / spacing**2 - 0.5 * (slope[k] - slope[i]) / spacing
    return found


@kernel
def stretches(z, slope, spacing, height):
    """Return the intervals (j, j + 1) in which the line may lie below ``height``, increasing.

    And one more on either side of each stretch of them.
    """
    n = z.size
    low = np.zeros(n, np.bool_)
    for j in range(n):
        k = (j + 1) % n
        if min(z[j], z[k]) - 0.25 * spacing * (abs(slope[j]) + abs(slope[k])) < height:
            low[j] = low[k] = low[(j - 1) % n] = True
    return np.flatnonzero(low)


@kernel
def interpolate(z, slope, curvature, at, spacing, fold):
    """Return (heights, slopes) at ``fold`` points from the beginning of every interval ``at``.

    By the polynomial of fifth degree that has the height, slope and curvature at both ends.
    """
    heights, slopes = np.empty(at.size * fold), np.empty(at.size * fold)
    for i in range(at.size):
        j, k = at[i], (at[i] + 1) % z.size
        rise = z[k] - z[j]
        s, t = spacing * slope[j], spacing * slope[k]
        b, c = 0.5 * spacing**2 * curvature[j], 0.5 * spacing**2 * curvature[k]
        p3 = 10.0 * rise - 6.0 * s - 4.0 * t - 3.0 * b + c
        p4 = -15.0 * rise + 8.0 * s + 7.0 * t + 3.0 * b - 2.0 * c
        p5 = 6.0 * rise - 3.0 * s - 3.0 * t - b + c
        for q in range(fold):
            x = q / fold
            heights[i * fold + q] = z[j] + x * (s + x * (b + x * (p3 + x * (p4 + x * p5))))
            slopes[i * fold + q] = (
                s + x * (2.0 * b + x * (3.0 * p3 + x * (4.0 * p4 + x * 5.0 * p5)))
            ) / spacing
    return heights, slopes


@kernel
def decays(at, fold, n, once):
    """Return what is left of a displacement from a fine sample to the one before it.

    once : left after one fine step. Shape (fine samples,); the first one is before the last one.
    """
    left = np.full(at.size * fold, once)
    for i in range(at.size):
        after = at[i + 1] if i + 1 < at.size else at[0] + n
        left[(i + 1) * fold - 1] = once ** ((after - at[i] - 1) * fold + 1)
    return left
