"""Choice of the blocks that can touch, by a cap over the indentation."""

from typing import NamedTuple

import numpy as np

from ...body.ground import CELL_SAMPLES
from ...compile.jit import inlined_kernel
from .scaled_units import BLOCK_ELEMENTS

MAX_SHIFT_SAMPLES = 16  # shift of the line after which blocks are chosen again
CAP_MARGIN = 0.02  # from the indentation to the cap, over the indentation


class Choice(NamedTuple):
    """Range in which a list of blocks is valid."""

    begin: int  # sample over element 0 when the blocks were chosen, or -1
    cap: float  # maximum indentation at which other blocks cannot touch, in h
    chosen_d: float  # indentation before the step in which the blocks were chosen, in h
    size: int  # number of listed blocks


@inlined_kernel
def is_near(begin, choice, n):
    """Return whether a choice covers the line with sample ``begin`` over element 0 of n."""
    apart = abs(begin - choice.begin)
    return choice.begin >= 0 and min(apart, n - apart) <= MAX_SHIFT_SAMPLES


@inlined_kernel
def cap_over(d, before, lowest):
    """Return a cap above the indentation d, and above the deepest part of the line.

    before : an earlier indentation; the margin allows for further changes of the same size.
    """
    deepest = np.inf
    for cell in range(lowest.size):
        deepest = min(deepest, lowest[cell])
    margin = max(CAP_MARGIN * abs(d - deepest), 4.0 * abs(d - before))
    return max(d, deepest) + max(margin, 1e-9)


@inlined_kernel
def can_touch(lowest, begin, b, n, cap):
    """Return whether the line is below the cap over block b, up to the maximum shift."""
    first = (begin + b * BLOCK_ELEMENTS - MAX_SHIFT_SAMPLES) % n
    last = min(first + BLOCK_ELEMENTS + 2 * MAX_SHIFT_SAMPLES, 2 * n) - 1
    below = False
    for cell in range(first // CELL_SAMPLES, last // CELL_SAMPLES + 1):
        below = below or lowest[cell] < cap
    return below
