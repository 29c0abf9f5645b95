"""Spans: sums and extremes of sixteen consecutive samples, so that most samples are not visited.

In steady sliding at indentation d elements pass from sample j + 1 to sample j. If j + 1 touches,
its element arrives with E (z_{j+1} - d), where E is the decay factor of a step. Sample j then
touches if z_j - d lies below this displacement, i.e. if

    d > t_j = (z_j - E z_{j+1}) / (1 - E) = z_{j+1} + K (z_j - z_{j+1}),   K = 1 / (1 - E).

An element that enters a span in contact therefore stays in contact if d lies above the largest t_j
of the span, and its force at each sample follows from the heights. An element that enters free,
at u, stays free if the lowest sample of the span lies above d + E^16 u, and leaves it at E^16 u.

A call from Python costs more than steady sliding on a short line, so lines with equally many
samples form a Stack and are passed together. The result for one line does not depend on the others.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel

SPAN = 16
# Columns of the row of a span, one cache line: height z0 and slope s0 of its first sample, then
# sums over all its samples j, with Delta f_j = f_(j+1) - f_j, of z - z0, z' - s0,
# (z - z0) (z' - s0), (z' - s0) Delta z and Delta z Delta z'. The last column is not used.
SPAN_COLUMNS = 8
(
    FIRST_HEIGHT,
    FIRST_SLOPE,
    HEIGHT_SUM,
    SLOPE_SUM,
    WORK_SUM,
    RISE_SUM,
    TURN_SUM,
) = range(SPAN_COLUMNS - 1)


class Spans(NamedTuple):
    """Sums over the whole spans of a line, each of shape (n // SPAN,), and over the whole line.

    Heights and slopes are taken relative to those of the first sample, z0 and s0, so that sums
    over high or steep spans lose no digits.
    """

    lowest: np.ndarray  # lowest height, in h
    first_height: np.ndarray  # z0, in h
    height_sum: np.ndarray  # sum of z - z0
    rows: np.ndarray  # shape (n // SPAN + 1, SPAN_COLUMNS); add_rises fills RISE_SUM and TURN_SUM;
    # the last row has FIRST_HEIGHT and FIRST_SLOPE of the sample after the last whole span
    line_sums: np.ndarray  # shape (4,): HEIGHT_SUM to WORK_SUM, and the sum of (z' - s0)^2, over
    # all samples of the line
    deepest: Any  # index of the lowest sample; for several lines an array of indices


class Stack(NamedTuple):
    """Lines and their Spans: every array has one row per line."""

    z: np.ndarray  # in h, shape (lines, n)
    slope: np.ndarray  # in h/dx, shape (lines, n)
    spans: Spans  # with a leading axis of lines; ``deepest`` has the shape (lines,)


class Thresholds(NamedTuple):
    """Indentations above which whole spans, and the whole line, stay in contact at one speed."""

    contact: np.ndarray  # largest t_j of each span, shape (n // SPAN,)
    line_contact: float  # largest t_j of the line


@refcount_free_kernel
def fill_spans(z, slope, spans):
    """Fill the arrays of Spans for a line; return the index of the deepest sample."""
    n, count = z.size, z.size // SPAN
    lowest, rows, line_sums = spans.lowest, spans.rows, spans.line_sums
    line_sums[:] = 0.0
    for b in range(count):
        first = b * SPAN
        heights = slopes = work = squares = 0.0
        low = z[first]
        for j in range(first, first + SPAN):
            dz, ds = z[j] - z[first], slope[j] - slope[first]
            heights, slopes = heights + dz, slopes + ds
            work, squares = work + dz * ds, squares + ds * ds
            low = min(low, z[j])
        lowest[b] = low
        rows[b, FIRST_HEIGHT], rows[b, FIRST_SLOPE] = z[first], slope[first]
        rows[b, HEIGHT_SUM], rows[b, SLOPE_SUM] = heights, slopes
        rows[b, WORK_SUM], rows[b, RISE_SUM], rows[b, TURN_SUM] = work, np.nan, np.nan
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


def spans_of_line(stack: Stack, k: int) -> Spans:
    """Return the Spans of line k as views of the stack."""
    lowest, first_height, height_sum, rows, line_sums, deepest = stack.spans
    per_span = lowest[k], first_height[k], height_sum[k]
    return Spans(*per_span, rows[k], line_sums[k], deepest[k])


spans_in = kernel(spans_of_line)  # the same function for kernels


@kernel
def stack_of(z, slope):
    """Return the Stack of lines. z (in h), slope (in h/dx) : shape (lines, n)."""
    lines, count = z.shape[0], z.shape[1] // SPAN
    shape, deepest = (lines, count), np.empty(lines, np.int64)
    per_span = np.empty(shape), np.empty(shape), np.empty(shape)
    rows, line_sums = np.empty((lines, count + 1, SPAN_COLUMNS)), np.empty((lines, 4))
    stack = Stack(z, slope, Spans(*per_span, rows, line_sums, deepest))
    for k in range(lines):
        deepest[k] = fill_spans(z[k], slope[k], spans_in(stack, k))
    return stack


def stacked(rows: Sequence[np.ndarray]) -> np.ndarray:
    """Return arrays of equal size as the rows of one array; a single array is not copied."""
    joined = rows[0] if len(rows) == 1 else np.concatenate(rows)
    return joined.reshape(len(rows), -1)


def single_line(stack: Stack, k: int) -> Stack:
    """Return line k as a Stack of one line, a view of its row."""
    z, slope, spans = stack
    row = slice(k, k + 1)
    return Stack(z[row], slope[row], Spans(*(field[row] for field in spans)))


@kernel
def thresholds_of(z, stiffness):
    """Return the Thresholds at one speed. stiffness : K of the law (rheology/law.py)."""
    n = z.size
    contact, in_span = np.empty(n // SPAN), np.empty(SPAN)
    inner = (n - 1) // SPAN  # spans whose upstream neighbour lies in the array
    line_contact = -np.inf
    for b in range(inner):
        h = z[b * SPAN : b * SPAN + SPAN + 1]
        for k in range(SPAN):
            in_span[k] = h[k + 1] + stiffness * (h[k] - h[k + 1])
        contact[b] = _largest(in_span)
        line_contact = max(line_contact, contact[b])
    tail = -np.inf
    for j in range(inner * SPAN, n):
        ahead = z[j + 1 if j + 1 < n else 0]
        tail = max(tail, ahead + stiffness * (z[j] - ahead))
    contact[inner:] = tail  # a whole span that ends the line
    return Thresholds(contact, max(line_contact, tail))


@kernel
def pressure_threshold(z, slope, speed):
    """Return the largest z - vbar z' of the line; every sample is pressed if d + d' exceeds it."""
    highest = -np.inf
    for j in range(z.size):
        highest = max(highest, z[j] - speed * slope[j])
    return highest


@refcount_free_kernel
def _largest(values):
    """Return the largest of SPAN values, which are overwritten. Halving lets loops vectorise."""
    for half in (8, 4, 2, 1):
        for k in range(half):
            values[k] = max(values[k], values[half + k])
    return values[0]
