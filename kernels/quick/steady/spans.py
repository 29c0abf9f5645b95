"""Spans: sums and extremes of sixteen consecutive samples, so that most samples are not visited.

In steady sliding at indentation d elements pass from sample j + 1 to sample j. If j + 1 touches,
its element arrives with E (z_{j+1} - d), where E is the decay factor of a step. Sample j then
touches if z_j - d lies below this displacement, i.e. if

    d > t_j = (z_j - E z_{j+1}) / (1 - E) = z_{j+1} + K (z_j - z_{j+1}),   K = 1 / (1 - E).

An element that enters a span in contact therefore stays in contact if d lies above the largest t_j
of the span, and its force at each sample follows from the heights. An element that enters free,
at u, stays free if the lowest sample of the span lies above d + E^16 u, and leaves it at E^16 u.
"""

from typing import Any, NamedTuple

import numpy as np

from ...compile.jit import refcount_free_kernel

SPAN = 16
# Columns of the row of a span, one cache line: height z0 and slope s0 of its first sample, then
# sums over all its samples j, with Delta f_j = f_(j+1) - f_j, of z - z0, z' - s0,
# (z - z0) (z' - s0), (z' - s0)^2, (z' - s0) Delta z and Delta z Delta z'.
SPAN_COLUMNS = 8
(
    FIRST_HEIGHT,
    FIRST_SLOPE,
    HEIGHT_SUM,
    SLOPE_SUM,
    WORK_SUM,
    SQUARE_SUM,
    RISE_SUM,
    TURN_SUM,
) = range(SPAN_COLUMNS)


class Spans(NamedTuple):
    """Sums over the whole spans of a line, each of shape (n // SPAN,), and over the whole line.

    Heights and slopes are taken relative to those of the first sample, z0 and s0, so that sums
    over high or steep spans lose no digits.
    """

    lowest: np.ndarray  # lowest height, in h
    first_height: np.ndarray  # z0, in h
    height_sum: np.ndarray  # sum of z - z0
    steepest: np.ndarray  # largest |z'|, in h/dx
    rows: np.ndarray  # shape (n // SPAN + 1, SPAN_COLUMNS); add_rises fills RISE_SUM and TURN_SUM;
    # the last row has FIRST_HEIGHT and FIRST_SLOPE of the sample after the last whole span
    line_sums: np.ndarray  # shape (4,): HEIGHT_SUM to SQUARE_SUM over all samples of the line
    deepest: Any  # index of the lowest sample; for several lines an array of indices (stack.py)


@refcount_free_kernel
def fill_spans(z, slope, spans):
    """Fill the arrays of Spans for a line; return the index of the deepest sample."""
    n, count = z.size, z.size // SPAN
    lowest, steepest, rows, line_sums = spans.lowest, spans.steepest, spans.rows, spans.line_sums
    line_sums[:] = 0.0
    for b in range(count):
        first = b * SPAN
        heights = slopes = work = squares = steep = 0.0
        low = z[first]
        for j in range(first, first + SPAN):
            dz, ds = z[j] - z[first], slope[j] - slope[first]
            heights, slopes = heights + dz, slopes + ds
            work, squares = work + dz * ds, squares + ds * ds
            low, steep = min(low, z[j]), max(steep, abs(slope[j]))
        lowest[b], steepest[b] = low, steep
        rows[b, FIRST_HEIGHT], rows[b, FIRST_SLOPE] = z[first], slope[first]
        rows[b, HEIGHT_SUM], rows[b, SLOPE_SUM] = heights, slopes
        rows[b, WORK_SUM], rows[b, SQUARE_SUM] = work, squares
        rows[b, RISE_SUM] = rows[b, TURN_SUM] = np.nan
        spans.first_height[b], spans.height_sum[b] = z[first], heights
        dz, ds = z[first] - z[0], slope[first] - slope[0]
        line_sums[0] += heights + SPAN * dz
        line_sums[1] += slopes + SPAN * ds
        line_sums[2] += work + dz * slopes + ds * (heights + SPAN * dz)
        line_sums[3] += squares + ds * (2.0 * slopes + SPAN * ds)
    for j in range(count * SPAN, n):
        dz, ds = z[j] - z[0], slope[j] - slope[0]
        line_sums[0] += dz
        line_sums[1] += ds
        line_sums[2] += dz * ds
        line_sums[3] += ds * ds
    after = count * SPAN if count * SPAN < n else 0
    rows[count, :] = np.nan
    rows[count, FIRST_HEIGHT], rows[count, FIRST_SLOPE] = z[after], slope[after]
    return int(np.argmin(z))


@refcount_free_kernel
def add_rises(rows, z, slope):
    """Fill RISE_SUM and TURN_SUM of the rows of Spans, which only a march needs."""
    for b in range(rows.shape[0] - 1):
        first = b * SPAN
        rises = turns = 0.0
        for j in range(first, first + SPAN):
            upstream = j + 1 if j + 1 < z.size else 0
            rise = z[upstream] - z[j]
            rises += (slope[j] - slope[first]) * rise
            turns += (slope[upstream] - slope[j]) * rise
        rows[b, RISE_SUM], rows[b, TURN_SUM] = rises, turns
