"""The root of a function that rises, from a guess: secants that are kept between two signs."""

import numpy as np

from ..compile.jit import kernel

LOW, HIGH, LAST, VALUE, SLOPE, REACH, TURN = range(7)  # of the notes of a search
MOST_TURNS = 80
FORCED = 4  # of so many turns between two signs one halves the interval


@kernel
def new_search(slope, reach):
    """Return the notes of a search.

    slope : of the function, about; 0 where nothing is known. reach : of the first step, at most.
    """
    return np.array([-np.inf, np.inf, np.nan, np.nan, slope, reach, 0.0])


@kernel
def next_guess(notes, x, value):
    """Note the value of the function at x, and return where to look next."""
    notes[LOW if value < 0.0 else HIGH] = x
    if notes[LAST] != x and not np.isnan(notes[LAST]):
        slope = (value - notes[VALUE]) / (x - notes[LAST])
        if slope > 0.0:
            notes[SLOPE] = slope
    notes[LAST], notes[VALUE] = x, value
    reach = notes[REACH]
    step = -value / notes[SLOPE] if notes[SLOPE] > 0.0 else -np.sign(value) * reach
    low, high = notes[LOW], notes[HIGH]
    if np.isinf(high - low):
        notes[REACH] = 2.0 * reach
        return x + min(max(step, -reach), reach)
    notes[TURN] += 1.0
    if notes[TURN] % FORCED != 0.0 and low < x + step < high:
        return x + step
    return 0.5 * (low + high)


@kernel
def narrow_enough(notes, least):
    """Return whether no more can be known, for what is smaller than ``least`` is rounding."""
    return notes[HIGH] - notes[LOW] <= least or notes[TURN] >= MOST_TURNS
