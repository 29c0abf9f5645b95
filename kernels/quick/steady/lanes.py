"""A sweep for sixteen loads of one line at once, where contact changes from sample to sample.

Where patches are as short as spans, carry.py visits most samples, and what costs time is that each
decides anew. Sixteen loads side by side decide without branches, in the vector registers of the
processor. Every lane does what carry.py does, the same operations in the same order: its sums are
those of carry.py to the bit, and which loads lie beside each other plays no part.
"""

import numpy as np

from ...compile.jit import kernel
from ...rheology.law import NEGLIGIBLE
from .spans import SPAN

LANES = 16
# Rows of the memory of lanes: indentation, displacement u and -du/dd, -sum u and its derivative,
# the last four after a span that is all in contact or all free, and whether it is one.
D, U, DU, TOTAL, SLOPE, U_LEFT, DU_LEFT, TOTAL_LEFT, SLOPE_LEFT, WHOLE = range(0, 10 * LANES, LANES)


@kernel
def carry_lanes(decay, z, spans, stay, d):
    """Carry elements round the line at LANES indentations d; return (-sum u, its derivatives).

    Arguments and numbers as of carry.py. d : shape (LANES,), as both results.
    """
    n, deepest = z.size, spans.deepest
    lanes = np.empty(10 * LANES)
    for k in range(LANES):
        lanes[D + k], lanes[U + k], lanes[DU + k] = d[k], z[deepest] - d[k], 1.0
        lanes[TOTAL + k], lanes[SLOPE + k] = d[k] - z[deepest], 1.0
    for first, last in ((deepest - 1, 0), (n - 1, deepest + 1)):
        j = first
        while j >= last:
            b = j // SPAN
            low = b * SPAN
            stop = max(low, last)
            whole = 0.0
            if j == low + SPAN - 1 and low >= last:
                whole = _cross(
                    decay, lanes, stay[b], spans.lowest[b], spans.first[b], spans.height[b]
                )
            if whole < LANES:
                _visit(decay, z, lanes, j, stop)
            if whole > 0.0:
                _keep_whole(lanes)
            j = stop - 1
    return lanes[TOTAL : TOTAL + LANES].copy(), lanes[SLOPE : SLOPE + LANES].copy()


@kernel
def _visit(decay, z, lanes, first, stop):
    """Carry elements from sample ``first`` down to ``stop``, one by one."""
    for j in range(first, stop - 1, -1):
        for k in range(LANES):
            u = lanes[U + k]
            alive = u < -NEGLIGIBLE
            free = decay.once * u if alive else 0.0
            du = decay.once * lanes[DU + k] if alive else 0.0
            gap = z[j] - lanes[D + k]
            touches = gap < free
            u = gap if touches else free
            du = 1.0 if touches else du
            lanes[TOTAL + k] -= u
            lanes[SLOPE + k] += du
            lanes[U + k] = u
            lanes[DU + k] = du


@kernel
def _cross(decay, lanes, stay, lowest, z0, height):
    """Carry elements over a span as if it were whole; return in how many lanes it is.

    stay, lowest, height : of the span, z0 : of its first sample (spans.py).
    """
    for k in range(LANES):
        u, du, d = lanes[U + k], lanes[DU + k], lanes[D + k]
        alive = u < -NEGLIGIBLE
        left = decay.span * u if alive else 0.0
        du_left = decay.span * du if alive else 0.0
        held = du == 1.0
        stays = 1.0 if d > stay else 0.0
        passes = 1.0 if lowest - d >= left else 0.0
        lanes[WHOLE + k] = stays if held else passes
        lanes[U_LEFT + k] = z0 - d if held else left
        lanes[DU_LEFT + k] = 1.0 if held else du_left
        total, slope = lanes[TOTAL + k], lanes[SLOPE + k]
        lanes[TOTAL_LEFT + k] = total + (SPAN * (d - z0) - height if held else -(decay.within * u))
        lanes[SLOPE_LEFT + k] = slope + (SPAN if held else decay.within * du)
    whole = 0.0
    for k in range(LANES):
        whole += lanes[WHOLE + k]
    return whole


@kernel
def _keep_whole(lanes):
    """Take what _cross has found in the lanes in which the span is whole."""
    for k in range(LANES):
        whole = lanes[WHOLE + k] > 0.0
        lanes[U + k] = lanes[U_LEFT + k] if whole else lanes[U + k]
        lanes[DU + k] = lanes[DU_LEFT + k] if whole else lanes[DU + k]
        lanes[TOTAL + k] = lanes[TOTAL_LEFT + k] if whole else lanes[TOTAL + k]
        lanes[SLOPE + k] = lanes[SLOPE_LEFT + k] if whole else lanes[SLOPE + k]
