"""Settings of velocity jumps that the tests of the active-set march share."""

from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    lagged_slope,
    march,
    quadrature,
    steady_sliding,
    step_average,
)
from elastomer_friction.kernels.model.steady import sweep
from elastomer_friction.kernels.quick.march.given import March, SteadyState
from elastomer_friction.kernels.quick.steady.carry import decay_of
from elastomer_friction.kernels.quick.steady.spans import SPAN, TURN, Spans, add_rises, fill_spans
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of
from elastomer_friction.kernels.rheology.law import State
from tests.lines import random_line


class Jump(NamedTuple):
    """A velocity jump on a line that is given or random."""

    hurst: float
    m: int
    load: float
    x: float  # pi vbar
    ratio: float
    scheme: str = "exponential"


def setting_of(jump, elements, seed=1, line=None):
    """Return (setting, load)."""
    z, slope = random_line(elements, jump.hurst, jump.m, seed) if line is None else line
    load = jump.load * z.size
    laws = [SCHEMES[jump.scheme](np.pi / (jump.m * jump.x * r)) for r in (1.0, jump.ratio)]
    states = [steady_sliding(law, z, load)[0] for law in laws]
    passing = (steady_state_of(z, law, state) for law, state in zip(laws, states, strict=True))
    v = jump.x / np.pi
    before, after = (quadrature(z, slope, *states[0], v, r * v, load)[1] for r in (1.0, jump.ratio))
    spans = spans_of(z, slope)
    add_rises(spans.rows, z, slope)
    return March(z, slope, spans, *laws, *passing, after - before), load


def spans_of(z, slope):
    """Return the Spans of a line."""
    count = z.size // SPAN
    rows, whole = np.empty((count + 1, TURN + 1)), np.empty(4)
    spans = Spans(*(np.empty(count) for _ in range(4)), rows, whole, 0)
    return spans._replace(deepest=fill_spans(z, slope, spans))


def steady_state_of(z, law, state):
    """Return a steady state as elements pass the spans of a line."""
    w, d = state
    u = np.minimum(w, z - d)
    above = np.append(np.arange(SPAN, z.size, SPAN), 0)
    entered = np.full(z.size // SPAN + 1, np.nan)
    entered[: above.size] = u[above]
    # No pressure is asked for: any speed.
    return SteadyState(decay_of(law), thresholds_of(z, z, 1.0, law.stiffness).stay, entered, d)


def states_of(setting):
    """Return the states of both steady slides, by plain sweeps."""
    states = []
    for law, d in ((setting.before, setting.start.d), (setting.law, setting.end.d)):
        w = np.empty_like(setting.z)
        sweep(law, setting.z, d, np.argmin(setting.z), w)
        states.append(State(w, d))
    return states


def size_of_jump(setting, jump, load):
    """Return the change of mu when the speed changes."""
    v, start = jump.x / np.pi, states_of(setting)[0]
    before, after = (
        quadrature(setting.z, setting.slope, *start, v, speed, load)[0]
        for speed in (v, v * jump.ratio)
    )
    return abs(after - before)


def dense(setting, load, kept_steps):
    """Return (deviation of mu from its steady value at v2, indentation) of the plain march."""
    law, (one, (w, d)) = setting.law, states_of(setting)
    weight = lagged_slope(setting.slope, law.lag)
    # Samples that cannot touch are left out: the digits of small displacements would be lost.
    for cap in (1.02 * max(one.d, d), 1.001 * max(one.d, load)):
        mu, found, _, inside = march(
            law, ConstantForce(load), setting.z, weight, one, kept_steps, cap
        )
        if inside:
            break
    assert inside
    return mu - step_average(weight, setting.z - w, d), found


def rounding_of_mu(setting, load):
    """Return what rounding leaves open of mu: of the overlaps, differences of heights."""
    w, d = states_of(setting)[1]
    touching = (setting.z - w < d).sum()
    overlap = load / setting.law.stiffness / touching
    share = 1e-16 * (setting.z.max() + d) / overlap
    return (1e-14 + 2.0 * share) * np.abs(setting.slope).max()
