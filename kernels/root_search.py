"""Bracketed search for the root of an increasing function, by Newton's or Halley's method.

The caller evaluates the function at x and passes its value on, until the search has ended. Machine
code thus contains one search for all functions, whatever else an evaluation returns.

Every value moves an end of the bracket [low, high]. The step of the method is taken if it stays
inside and is at most half as long as the step before the last one; otherwise the bracket is halved.
Steps are thus shorter than s after at most 2 log2(w/s) of them without a halving, and a bracket of
width w is shorter than s after log2(w/s) halvings. While an end is infinite, the length of steps is
limited, and the limit doubles. Without a change of sign x approaches an end.

A search ends where the value is at most a tolerance, or not a number; with a step of the method of
at most ``last_step``, which is taken; if no number lies between the ends; or after MAX_EVALUATIONS.
At a simple root the error after the last step is of the order of its square, or of its cube by
Halley's method; at a multiple root it is of the order of the step.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

from .compile.jit import jitable

MAX_EVALUATIONS = 100
BRACKET_ROUNDING = 1e-15  # minimum step of root_between, relative to the bracket


class RootSearch(NamedTuple):
    """A bracket of a root, and the next step."""

    x: float  # where to evaluate the function, or the result
    low: float  # x of a negative value, or the initial end
    high: float  # x of a positive value, or the initial end
    max_step: float  # limit of the next step
    later_max_step: float  # limit of the step after it, if both ends are finite
    evaluations: int
    ended: bool


class SecantSearch(NamedTuple):
    """A search whose slopes are those of secants."""

    search: RootSearch
    last_x: float  # of the last evaluation, or NaN
    last_value: float
    slope: float  # of the last rising secant, or an estimate; 0 if unknown


@jitable
def new_search(x, low, high, max_step):
    """Return the RootSearch that begins at x. max_step : limit of its first step, or inf."""
    return RootSearch(x, low, high, max_step, math.inf, 0, False)


@jitable
def next_guess(search, x, value, slope, bend, tolerance, last_step):
    """Return the RootSearch after an evaluation at x.

    value, slope, bend : of the function, its first and second derivative; without bend (0) the
    method is Newton's. tolerance : of the value. last_step : if bend hardly changes the slope.
    """
    low, high = (x, search.high) if value < 0.0 else (search.low, x)
    limit, later, evaluations = search.max_step, search.later_max_step, search.evaluations + 1
    settled = not abs(value) > tolerance or evaluations == MAX_EVALUATIONS
    halley_slope = slope - 0.5 * value * bend / slope if slope != 0.0 else 0.0
    step = -value / halley_slope if halley_slope != 0.0 else math.nan
    is_last = abs(step) <= last_step and abs(value * bend) <= last_step * slope * slope
    if high - low == math.inf:
        step = min(max(step, -limit), limit) if slope > 0.0 else math.copysign(limit, -value)
        limit, is_last = 2.0 * limit, False
    elif not is_last:
        if not (low < x + step < high and abs(step) <= limit):
            step = 0.5 * (low + high) - x
        limit, later, is_last = later, 0.5 * abs(step), not low < x + step < high
    new_x = x if settled else min(max(x + step, low), high)
    return RootSearch(new_x, low, high, limit, later, evaluations, settled or is_last)


@jitable
def new_secant_search(x, max_step, slope):
    """Return the SecantSearch that begins at x without a bracket. slope : an estimate, or 0."""
    search = new_search(x, -math.inf, math.inf, max_step)
    return SecantSearch(search, math.nan, math.nan, slope)


@jitable
def next_secant_guess(secants, x, value, tolerance, min_step):
    """Return the SecantSearch after an evaluation at x. min_step : > 0, of steps by secants.

    A secant can be much steeper than the function near its root, so that a short step ends nothing.
    """
    slope = (value - secants.last_value) / (x - secants.last_x) if x != secants.last_x else 0.0
    slope = slope if slope > 0.0 else secants.slope
    limited = min(slope, abs(value) / min_step)
    search = next_guess(secants.search, x, value, limited, 0.0, tolerance, 0.0)
    return SecantSearch(search, x, value, slope)


def root_between(function: Callable[[float], float], low: float, high: float) -> float:
    """Return the root of an increasing function between finite ends, nearly to the last bit.

    The ends are not evaluated. Raises ValueError if a value is not a number.
    """
    min_step = BRACKET_ROUNDING * (high - low)
    search = new_search(0.5 * (low + high), low, high, math.inf)
    secants = SecantSearch(search, math.nan, math.nan, 0.0)
    while not secants.search.ended:
        x = secants.search.x
        value = float(function(x))
        if math.isnan(value):
            raise ValueError(f"the function is not a number at {x:g}")
        secants = next_secant_guess(secants, x, value, 0.0, min_step)
    return secants.search.x
