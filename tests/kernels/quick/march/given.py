"""Velocity jumps for tests of the active-set march."""

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
from elastomer_friction.kernels.quick.march.problem import JumpProblem, SteadyState
from elastomer_friction.kernels.quick.steady.span_sliding import decay_factors
from elastomer_friction.kernels.quick.steady.spans import (
    SPAN,
    add_rises,
    spans_of_line,
    stack_of,
    thresholds_of,
)
from elastomer_friction.kernels.rheology.law import State
from tests.lines import random_line


class Jump(NamedTuple):
    """A velocity jump on a given or random line."""

    hurst: float
    m: int
    load: float
    x: float  # pi vbar
    ratio: float
    scheme: str = "exponential"


def setting_of(jump, elements, seed=1, line=None):
    """Return (JumpProblem, load) of a Jump."""
    z, slope = random_line(elements, jump.hurst, jump.m, seed) if line is None else line
    load = jump.load * z.size
    laws = [SCHEMES[jump.scheme](np.pi / (jump.m * jump.x * r)) for r in (1.0, jump.ratio)]
    states = [steady_sliding(law, z, load)[0] for law in laws]
    passing = (steady_state_of(z, law, state) for law, state in zip(laws, states, strict=True))
    v = jump.x / np.pi
    before, after = (quadrature(z, slope, *states[0], v, r * v, load)[1] for r in (1.0, jump.ratio))
    spans = spans_of_line(stack_of(z[None], slope[None]), 0)
    add_rises(spans.rows, z, slope)
    return JumpProblem(z, slope, spans, *laws, *passing, after - before), load


def steady_state_of(z, law, state):
    """Return the SteadyState of a march for a State."""
    w, d = state
    u = np.minimum(w, z - d)
    above = np.append(np.arange(SPAN, z.size, SPAN), 0)
    entered = np.full(z.size // SPAN + 1, np.nan)
    entered[: above.size] = u[above]
    thresholds = thresholds_of(z, law.stiffness)
    return SteadyState(decay_factors(law), thresholds.contact, entered, d)


def states_of(setting):
    """Return the states of steady sliding at both speeds, by plain sweeps."""
    states = []
    for law, d in ((setting.before, setting.start.d), (setting.law, setting.end.d)):
        w = np.empty_like(setting.z)
        sweep(law, setting.z, d, np.argmin(setting.z), w)
        states.append(State(w, d))
    return states


def size_of_jump(setting, jump, load):
    """Return the absolute jump of mu."""
    v, start = jump.x / np.pi, states_of(setting)[0]
    before, after = (
        quadrature(setting.z, setting.slope, *start, v, speed, load)[0]
        for speed in (v, v * jump.ratio)
    )
    return abs(after - before)


def dense(setting, load, kept_steps):
    """Return (deviation of mu from its steady value at v2, indentation) by the plain march."""
    law, (one, (w, d)) = setting.law, states_of(setting)
    weight = lagged_slope(setting.slope, law.lag)
    # The cap excludes samples that cannot touch, where small displacements would lose digits.
    for cap in (1.02 * max(one.d, d), 1.001 * max(one.d, load)):
        mu, indentation, _, inside = march(
            law, ConstantForce(load), setting.z, weight, one, kept_steps, cap
        )
        if inside:
            break
    assert inside
    return mu - step_average(weight, setting.z - w, d), indentation


def rounding_of_mu(setting, load):
    """Return the rounding error of mu, which comes from overlaps as differences of heights."""
    w, d = states_of(setting)[1]
    touching = (setting.z - w < d).sum()
    overlap = load / setting.law.stiffness / touching
    share = 1e-16 * (setting.z.max() + d) / overlap
    return (1e-14 + 2.0 * share) * np.abs(setting.slope).max()
