"""One step of Kelvin units and a glassy spring in series: the scheme "exponential".

The units move exactly under a force that is linear in the step. It begins at kappa times the old
force plus 1 - kappa times the new one, and ends at the new one. Under a unit force that starts in
the step, unit k moves by J_k (1 - E_k), with a delay of late_k, and ramp = sum J_k (1 - E_k)
late_k.

- A linear force (kappa = 1) is second order. If all delays are equal, however, the old force
  returns with a gain close to one, and the solution oscillates.
- A constant force (kappa = 0) is accurate in that case, where forces jump at touch-down, as in a
  Kelvin element. Otherwise the force has no single time within the step: first order.

Therefore kappa = min(1, 4 prompt / ramp). The prompt response is that of the glassy spring, J_g,
and of each unit, J_k (1 - E_k) (1 - late_k / max late). The gain is then 4/5 at most. Units much
faster than the step count as a glassy spring, so branches need not be resolved.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, refcount_free_kernel
from .law import (
    MIN_MAGNITUDE,
    advance_memory,
    displacement,
    law_of,
    memory_size,
    predict,
    rest_memory,
    static_pressure,
)
from .retardation import Retardation

PRONY_SCHEME = "exponential"
LN_2 = math.log(2.0)
SERIES_COEFFICIENTS = tuple(1.0 / power for power in range(11, 2, -1))  # from its last term on


class Prony(NamedTuple):
    """Constants of one step: y_k becomes E_k y_k - B_k p_new - A_k p_old."""

    decay: np.ndarray  # E_k, shape (K,)
    fresh: np.ndarray  # B_k, shape (K,): what the new force does to unit k
    stale: np.ndarray  # A_k, shape (K,): what the old force does
    stiffness: float  # 1 / (J_g + sum B_k) (law.py)
    lag: float  # (law.py)
    linear: float  # kappa: 1 where the force is linear, 0 where it is constant


@inlined_kernel
def moments(x):
    """Return (E, 1 - E, beta, alpha): E = exp(-x), weights of the end and the start force."""
    if x > LN_2:
        left = math.exp(-x)
        decayed = 1.0 - left
        return left, decayed, 1.0 - decayed / x, decayed / x - left
    if x > 0.1:
        decayed = -math.expm1(-x)
        return 1.0 - decayed, decayed, 1.0 - decayed / x, decayed / x - (1.0 - decayed)
    end = 1.0  # a difference of nearly equal numbers otherwise
    for share in SERIES_COEFFICIENTS:
        end = 1.0 - x * share * end
    end *= 0.5 * x
    decayed = x * (1.0 - end)
    return 1.0 - decayed, decayed, end, decayed - end


@law_of.register(Retardation)
def _law_of(form, dt):
    constants = np.empty((5, form.times.size))  # to make one array takes as long as ten samples
    return Prony(constants[0], constants[1], constants[2], *fill_law(form, dt, constants))


@refcount_free_kernel
def fill_law(form, dt, constants):
    """Return (stiffness, lag, linear); the first rows of ``constants`` (5, K) get the others."""
    decay, fresh, stale = constants[0], constants[1], constants[2]
    moved, late = constants[3], constants[4]  # by a unit force that lasts, and how late
    ramp = latest = 0.0
    for k in range(form.times.size):
        x, compliance = dt / form.times[k], form.compliances[k]
        left, decayed, end, start = moments(x)
        decay[k] = left if left > math.sqrt(MIN_MAGNITUDE) else 0.0
        fresh[k], stale[k] = compliance * end, compliance * start
        moved[k], late[k] = compliance * decayed, start / decayed
        ramp += stale[k]
        latest = max(latest, late[k])
    prompt = answered = form.glass
    for k in range(form.times.size):
        prompt += moved[k] * (1.0 - late[k] / latest)
        answered += moved[k]
    linear = min(1.0, 4.0 * prompt / ramp)
    softness = form.glass
    for k in range(form.times.size):
        fresh[k] += (1.0 - linear) * stale[k]
        stale[k] *= linear
        softness += fresh[k]
    return 1.0 / softness, (1.0 - linear) * ramp / answered, linear


@memory_size.register(Retardation)
def _memories(form):
    return form.times.size


@rest_memory.register(Retardation)
def _rest(form, p):
    return -form.compliances.reshape(-1, 1) * p


@displacement.register(Retardation)
def _displacement(form, memory, p):
    return memory.sum(0) - form.glass * p


@static_pressure.register(Retardation)
def _lasting(form, memory):
    """Without a glassy spring the units' rates add up to du/dt: p = -eta (du/dt + sum y/lambda)."""
    viscosity = 1.0 / (form.compliances / form.times).sum() if form.glass == 0.0 else 0.0
    pressure = np.zeros(memory.shape[1])
    for k in range(form.times.size):
        pressure -= viscosity / form.times[k] * memory[k]
    return viscosity, pressure


@predict.register(Prony)
def _predict(law, memory, p, w):
    total = law.stale.sum()
    for i in range(w.size):
        w[i] = law.decay[0] * memory[0, i] - total * p[i]
    for k in range(1, law.decay.size):
        decay = law.decay[k]
        for i in range(w.size):
            w[i] += decay * memory[k, i]


@advance_memory.register(Prony)
def _settle(law, memory, w, p, new):
    for k in range(law.decay.size):
        decay, fresh, stale = law.decay[k], law.fresh[k], law.stale[k]
        for i in range(p.size):
            y = decay * memory[k, i] - fresh * new[i] - stale * p[i]
            memory[k, i] = y if abs(y) > MIN_MAGNITUDE else 0.0
