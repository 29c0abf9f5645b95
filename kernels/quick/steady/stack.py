"""Lines of as many samples each, one above the other, that one call from Python goes through.

A call costs more than steady sliding on a short line, so short lines are handed over together. What
is found on one does not depend on the others.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel
from .spans import SPAN, TURN, Spans, fill_spans


class Stack(NamedTuple):
    """Lines and what is known of their spans: every array has a row for each line."""

    z: np.ndarray  # in h, shape (lines, n)
    slope: np.ndarray  # in h/dx, of the same shape
    lowest: np.ndarray  # shape (lines, n // SPAN), as the next three; as of Spans
    first: np.ndarray
    height: np.ndarray
    steepest: np.ndarray
    rows: np.ndarray  # shape (lines, n // SPAN + 1, 8)
    whole: np.ndarray  # shape (lines, 4)
    deepest: np.ndarray  # shape (lines,)


def spans_of_line(stack: Stack, k: int) -> Spans:
    """Return the Spans of line k: rows of the stack."""
    return Spans(
        stack.lowest[k],
        stack.first[k],
        stack.height[k],
        stack.steepest[k],
        stack.rows[k],
        stack.whole[k],
        stack.deepest[k],
    )


spans_in = kernel(spans_of_line)  # the same for kernels


@kernel
def stack_of(z, slope):
    """Return the Stack of lines. z (in h), slope (in h/dx) : shape (lines, n)."""
    lines, count = z.shape[0], z.shape[1] // SPAN
    shape = lines, count
    found = Stack(
        z,
        slope,
        np.empty(shape),
        np.empty(shape),
        np.empty(shape),
        np.empty(shape),
        np.empty((lines, count + 1, TURN + 1)),
        np.empty((lines, 4)),
        np.empty(lines, np.int64),
    )
    for k in range(lines):
        found.deepest[k] = fill_spans(z[k], slope[k], spans_in(found, k))
    return found


def stacked(rows: Sequence[np.ndarray]) -> np.ndarray:
    """Return arrays of as many numbers as rows of one; a single one is not copied."""
    joined = rows[0] if len(rows) == 1 else np.concatenate(rows)
    return joined.reshape(len(rows), -1)


def alone(stack: Stack, k: int) -> Stack:
    """Return line k as a stack of its own: a row of it."""
    return Stack(*(field[k : k + 1] for field in stack))
