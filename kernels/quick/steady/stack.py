"""Stacks of lines with equally many samples, processed by one call from Python.

A call from Python costs more than steady sliding on a short line, so short lines are passed
together. The result for one line does not depend on the others.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel
from .spans import SPAN, SPAN_COLUMNS, Spans, fill_spans


class Stack(NamedTuple):
    """Lines and their Spans: every array has one row per line."""

    z: np.ndarray  # in h, shape (lines, n)
    slope: np.ndarray  # in h/dx, shape (lines, n)
    spans: Spans  # with a leading axis of lines; ``deepest`` has the shape (lines,)


def spans_of_line(stack: Stack, k: int) -> Spans:
    """Return the Spans of line k as views of the stack."""
    lowest, first_height, height_sum, steepest, rows, line_sums, deepest = stack.spans
    per_span = lowest[k], first_height[k], height_sum[k], steepest[k]
    return Spans(*per_span, rows[k], line_sums[k], deepest[k])


spans_in = kernel(spans_of_line)  # the same function for kernels


@kernel
def stack_of(z, slope):
    """Return the Stack of lines. z (in h), slope (in h/dx) : shape (lines, n)."""
    lines, count = z.shape[0], z.shape[1] // SPAN
    shape, deepest = (lines, count), np.empty(lines, np.int64)
    per_span = np.empty(shape), np.empty(shape), np.empty(shape), np.empty(shape)
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
