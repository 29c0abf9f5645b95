"""Stretches of a line that can touch; only their samples are marched.

An element cannot touch a sample that is higher than a cap above all indentations. Between two
stretches, elements only decay (slide.py).
"""

import numpy as np

from ..compile.jit import kernel

SHORT_GAP = 16  # gaps up to this many samples are cheaper to carry along than to skip


@kernel
def touchable(z, cap):
    """Return (start, stop) of the stretches where z < cap, in line order, both int64 arrays.

    z : heights, shape (n,); z[0] must not be below cap unless all of z is.
    """
    start = np.empty(z.size // 2 + 1, np.int64)
    stop = np.empty(z.size // 2 + 1, np.int64)
    count = 0
    for j in range(z.size):
        if z[j] < cap:
            if count > 0 and j - stop[count - 1] <= SHORT_GAP:
                stop[count - 1] = j + 1
            else:
                start[count] = j
                stop[count] = j + 1
                count += 1
    return start[:count].copy(), stop[:count].copy()


@kernel
def gather(values, start, stop):
    """Return the values of all stretches [start, stop), concatenated."""
    size = 0
    for s in range(start.size):
        size += stop[s] - start[s]
    out = np.empty(size)
    i = 0
    for s in range(start.size):
        for j in range(start[s], stop[s]):
            out[i] = values[j]
            i += 1
    return out


@kernel
def piece_bounds(lengths):
    """Return the first index of each of consecutive pieces, and the end of the last one."""
    out = np.zeros(lengths.size + 1, np.int64)
    for s in range(lengths.size):
        out[s + 1] = out[s] + lengths[s]
    return out
