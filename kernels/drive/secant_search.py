"""Bracketed secant search for the root of an increasing function."""

import numpy as np

from ..compile.jit import kernel

# State of a search: one record, changed in place.
SEARCH_STATE = np.dtype(
    [
        ("low", np.float64),  # lower end of the bracket: x with a negative value
        ("high", np.float64),  # upper end of the bracket: x with a value that is not negative
        ("last_x", np.float64),
        ("last_value", np.float64),
        ("slope", np.float64),  # slope of the last rising secant, or its estimate; 0 if unknown
        ("max_step", np.float64),  # maximum step while the root is not bracketed
        ("bracketed_steps", np.int64),  # number of steps since the root was bracketed
    ]
)
MAX_BRACKETED_STEPS = 80
BISECTION_PERIOD = 4  # every fourth step within a bracket halves it


@kernel
def new_search(slope, max_step):
    """Return the state of a search, shape (1,).

    slope : estimate of the slope of the function, or 0. max_step : maximum of the first step.
    """
    search = np.zeros(1, SEARCH_STATE)
    state = search[0]
    state["low"], state["high"] = -np.inf, np.inf
    state["last_x"] = state["last_value"] = np.nan
    state["slope"], state["max_step"] = slope, max_step
    return search


@kernel
def next_guess(search, x, value):
    """Add the value of the function at x to the search, and return the next x to try."""
    state = search[0]
    if value < 0.0:
        state["low"] = x
    else:
        state["high"] = x
    if state["last_x"] != x and not np.isnan(state["last_x"]):
        slope = (value - state["last_value"]) / (x - state["last_x"])
        if slope > 0.0:
            state["slope"] = slope
    state["last_x"], state["last_value"] = x, value
    max_step = state["max_step"]
    step = -value / state["slope"] if state["slope"] > 0.0 else -np.sign(value) * max_step
    low, high = state["low"], state["high"]
    if np.isinf(high - low):
        state["max_step"] = 2.0 * max_step
        return x + min(max(step, -max_step), max_step)
    state["bracketed_steps"] += 1
    if state["bracketed_steps"] % BISECTION_PERIOD != 0 and low < x + step < high:
        return x + step
    return 0.5 * (low + high)


@kernel
def search_is_exhausted(search, rounding):
    """Return whether the bracket is at rounding level or the maximum number of steps is reached."""
    state = search[0]
    at_rounding = state["high"] - state["low"] <= rounding
    return at_rounding or state["bracketed_steps"] >= MAX_BRACKETED_STEPS
