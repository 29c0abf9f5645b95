"""Relaxations after velocity jumps, by the plain march, on many lines in one call."""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..model.friction import lagged_slope, steady_step_average
from ..model.march import march
from ..rheology.law import State
from .steady.span_sliding import DecayFactors, sweep_spans
from .steady.spans import spans_in


class SteadyEnds(NamedTuple):
    """Steady sliding on lines at v1 or v2, the initial or the final state of a march."""

    decay: DecayFactors
    thresholds: np.ndarray  # d above which whole spans touch (spans.py), shape (lines, spans)
    d: np.ndarray  # indentation over the deepest sample, in h, shape (lines,)


@kernel
def steady_step_frictions(stack, law, ends):
    """Return mu of the steps of steady sliding of each line, shape (lines,).

    stack, law, ends : as in plain_relaxations, all at one speed.
    """
    lines, n = stack.z.shape
    mu, w = np.empty(lines), np.empty(n)
    for k in range(lines):
        z, spans = stack.z[k], spans_in(stack, k)
        sweep_spans(ends.decay, z, spans, ends.thresholds[k], ends.d[k], None, w)
        mu[k] = steady_step_average(z, stack.slope[k], State(w, ends.d[k]), law.lag)
    return mu


@kernel
def plain_relaxations(stack, law, one, two, control, kept_steps):
    """Return (curves, updates): mu minus its steady value at v2, and element updates.

    stack : the lines (steady/spans.py). law : at v2. one, two : SteadyEnds at v1 and at v2.
    control, kept_steps : see march. curves : in h/dx, shape (lines, kept). updates : (lines,).
    """
    lines, n = stack.z.shape
    curves = np.empty((lines, kept_steps.size))
    updates = np.zeros(lines, np.int64)
    for k in range(lines):
        z, spans = stack.z[k], spans_in(stack, k)
        before, after = np.empty(n), np.empty(n)
        sweep_spans(one.decay, z, spans, one.thresholds[k], one.d[k], None, before)
        sweep_spans(two.decay, z, spans, two.thresholds[k], two.d[k], None, after)
        weight = lagged_slope(stack.slope[k], law.lag)
        state = State(before, one.d[k])
        # Apart from a transient, d stays between its steady values. It never exceeds the d at which
        # the deepest sample carries all the load: d_new <= E d_old + load / K, where K (1 - E) = 1.
        cap, last = 1.02 * max(one.d[k], two.d[k]), 1.001 * max(one.d[k], control.load)
        mu, _, passes, inside = march(law, control, z, weight, state, kept_steps, cap)
        updates[k] = passes * n
        if not inside:
            mu, _, passes, _ = march(law, control, z, weight, state, kept_steps, last)
            updates[k] += passes * n
        steady = steady_step_average(z, stack.slope[k], State(after, two.d[k]), law.lag)
        for i in range(mu.size):
            curves[k, i] = mu[i] - steady
    return curves, updates
