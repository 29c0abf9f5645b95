"""The bounds of d and D that a march takes for granted: guessed, and checked at every step."""

from typing import NamedTuple

import numpy as np

from kernels.active.lists import Sums, add_span
from kernels.active.marks import reached
from kernels.active.setting import advance
from kernels.jit import kernel
from kernels.steady.spans import SPAN

LEAST_SPREAD = 1e-11  # of d: rounding stays far below it
CLOSER = 0.6  # margin of bounds that follow d towards its end, of the spread


class Bounds(NamedTuple):
    """Between which values d and D(t) = d(t) - E d(t - 1) are taken to stay, both in h."""

    low: float  # of d
    high: float
    least: float  # of D
    most: float


NOTHING = Bounds(np.inf, -np.inf, np.inf, -np.inf)  # seen so far


@kernel
def holds(bounds, d, push):
    """Return whether d and D, here ``push``, lie within the bounds; NaN does not."""
    return bounds.low < d < bounds.high and bounds.least < push < bounds.most


@kernel
def bounds_of(law, lowest, highest, least, most, margin):
    """Return the Bounds around values of d and of D, farther out by ``margin`` of their spread.

    D of any d that stays where it is, d / K, lies within them.
    """
    wide = margin * max(highest - lowest, LEAST_SPREAD * highest)
    low, high = max(lowest - wide, 0.0), highest + wide
    least, most = min(least, low / law.stiffness), max(most, high / law.stiffness)
    wide = margin * max(most - least, LEAST_SPREAD * highest)
    return Bounds(low, high, least - wide, most + wide)


@kernel
def first_bounds(setting, d, margin):
    """Return the Bounds of a whole march, of which the first step takes d to ``d`` or nearby."""
    one, two = setting.start.d, setting.end.d
    push = advance(setting.law, d, one)
    return bounds_of(setting.law, min(one, two, d), max(one, two, d), push, push, margin)


@kernel
def widened(law, bounds, d, push, margin):
    """Return Bounds that hold also d and D, here ``push``, as a march left them."""
    lowest, highest = min(bounds.low, d), max(bounds.high, d)
    least, most = min(bounds.least, push), max(bounds.most, push)
    return bounds_of(law, lowest, highest, least, most, margin)


@kernel
def including(seen, d, push):
    """Return Bounds that hold values seen so far, and d and D, here ``push``."""
    low, high = min(seen.low, d), max(seen.high, d)
    return Bounds(low, high, min(seen.least, push), max(seen.most, push))


@kernel
def closer_bounds(law, bounds, seen, end):
    """Return Bounds, none beyond ``bounds``, for d between what was seen of it and ``end``."""
    lowest, highest = min(seen.low, end), max(seen.high, end)
    new = bounds_of(law, lowest, highest, seen.least, seen.most, CLOSER)
    low, high = max(new.low, bounds.low), min(new.high, bounds.high)
    return Bounds(low, high, max(new.least, bounds.least), min(new.most, bounds.most))


@kernel
def first_thresholds(setting):
    """Return (c, sums): thresholds of the first step, and sums over spans that touch all over.

    The thresholds of all elements at v2 are z - (E / E_1) w, as w = E_1 u at v1. Spans that touch
    nowhere are left out.
    """
    z, spans, start, end = setting.z, setting.spans, setting.start, setting.end
    factor = setting.law.decay / start.decay.once if start.decay.once > 0.0 else 0.0
    level, tally = end.d / setting.law.stiffness, np.zeros(4)
    c, count, most = np.empty(z.size), 0, max(start.d, end.d)
    for b in range(start.entered.size):
        u, stop = start.entered[b], min((b + 1) * SPAN, z.size)
        if b < spans.lowest.size:
            w = start.decay.span * u  # nowhere in the span do elements lie higher
            if spans.lowest[b] - max(w, factor * w) >= most:
                continue
            above = z[stop if stop < z.size else 0]
            if u == above - start.d and start.d > max(start.stay[b], end.stay[b]):
                add_span(setting, level, b, tally)
                continue
        for j in range(stop - 1, b * SPAN - 1, -1):
            w = reached(start.decay, u)
            u = min(w, z[j] - start.d)
            c[count] = z[j] - factor * w
            count += 1
    return c[:count], Sums(level, tally[0], tally[1], tally[2], tally[3])
