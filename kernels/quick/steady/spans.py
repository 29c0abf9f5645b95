"""Spans: what is known of sixteen samples in a row, so that most need not be visited.

In steady sliding at indentation d the sample upstream of j is j + 1. If j + 1 touches, its element
comes with E (z_{j+1} - d), E the decay of a step, and j touches where z_j - d lies below that:

    d > t_j = (z_j - E z_{j+1}) / (1 - E) = z_{j+1} + K (z_j - z_{j+1}),   K = 1 / (1 - E).

So a span entered in contact stays in contact throughout where d lies above the largest of its t_j,
and then its forces are sums over its heights. A span that is entered free, at u, is left free, at
E^16 u, where its lowest sample lies higher than that over -d.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import refcount_free_kernel

SPAN = 16
# Columns of what is known of a span, as many as the processor fetches at once: height z0 and slope
# s0 of its first sample, and sums over all its samples j, with Delta f_j = f_(j+1) - f_j, of
# z - z0, z' - s0, (z - z0) (z' - s0), (z' - s0)^2, (z' - s0) Delta z and Delta z Delta z'.
FIRST, STEEP, HEIGHT, SLOPE, WORK, SQUARE, RISE, TURN = range(8)


class Spans(NamedTuple):
    """Sums over the whole spans of a line, each of shape (n // SPAN,), and over all of it.

    Of heights and slopes from those of the first sample, z0 and s0: sums over spans that lie
    high or steep lose no digits.
    """

    lowest: np.ndarray  # height
    first: np.ndarray  # z0
    height: np.ndarray  # sum of z - z0
    steepest: np.ndarray  # largest |z'|
    rows: np.ndarray  # shape (n // SPAN + 1, 8): of every span, RISE and TURN as add_rises leaves
    # them; the last row has FIRST and STEEP of what follows
    whole: np.ndarray  # shape (4,): sums over all samples, as HEIGHT to SQUARE of the line
    deepest: int  # sample, the lowest one


@refcount_free_kernel
def fill_spans(z, slope, spans):
    """Fill the arrays of Spans with what they are of a line; return the deepest sample."""
    n, count = z.size, z.size // SPAN
    lowest, steepest, rows, whole = spans.lowest, spans.steepest, spans.rows, spans.whole
    whole[:] = 0.0
    for b in range(count):
        first = b * SPAN
        a0 = a1 = a2 = a3 = steep = 0.0
        low = z[first]
        for j in range(first, first + SPAN):
            a, c = z[j] - z[first], slope[j] - slope[first]
            a0, a1, a2, a3 = a0 + a, a1 + c, a2 + a * c, a3 + c * c
            low, steep = min(low, z[j]), max(steep, abs(slope[j]))
        lowest[b], steepest[b] = low, steep
        rows[b, FIRST], rows[b, STEEP] = z[first], slope[first]
        rows[b, HEIGHT], rows[b, SLOPE], rows[b, WORK], rows[b, SQUARE] = a0, a1, a2, a3
        rows[b, RISE] = rows[b, TURN] = np.nan
        spans.first[b], spans.height[b] = z[first], a0
        a, c = z[first] - z[0], slope[first] - slope[0]
        whole[0] += a0 + SPAN * a
        whole[1] += a1 + SPAN * c
        whole[2] += a2 + a * a1 + c * (a0 + SPAN * a)
        whole[3] += a3 + c * (2.0 * a1 + SPAN * c)
    for j in range(count * SPAN, n):
        a, c = z[j] - z[0], slope[j] - slope[0]
        whole[0] += a
        whole[1] += c
        whole[2] += a * c
        whole[3] += c * c
    after = count * SPAN if count * SPAN < n else 0
    rows[count, :] = np.nan
    rows[count, FIRST], rows[count, STEEP] = z[after], slope[after]
    return int(np.argmin(z))


@refcount_free_kernel
def add_rises(rows, z, slope):
    """Fill in RISE and TURN of the rows of Spans. Only a march asks for them."""
    for b in range(rows.shape[0] - 1):
        first = b * SPAN
        one = other = 0.0
        for j in range(first, first + SPAN):
            above = j + 1 if j + 1 < z.size else 0
            up = z[above] - z[j]
            one += (slope[j] - slope[first]) * up
            other += (slope[above] - slope[j]) * up
        rows[b, RISE], rows[b, TURN] = one, other
