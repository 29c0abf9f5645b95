"""One step of Kelvin units and a glassy spring in series: the scheme "exponential".

The motion of the units is exact for a force that is linear in the step. This force begins at kappa
times the old force plus 1 - kappa times the new one, and ends at the new one. Under a unit force
from the start of the step, unit k moves by J_k (1 - E_k), with a delay of late_k steps, and
ramp = sum J_k (1 - E_k) late_k.

- With a linear force (kappa = 1) the scheme is second order. If all delays are equal, however, the
  old force is passed on with a gain close to one, and the solution oscillates.
- With a constant force (kappa = 0) the scheme is accurate in that case, as for a Kelvin element,
  whose force jumps at touch-down. If delays differ, it is only first order.

Therefore kappa = min(1, 4 prompt / ramp), where prompt is the sum of J_g, of the glassy spring,
and of J_k (1 - E_k) (1 - late_k / max late) over the units. The gain is then 4/5 at most. Units
much faster than the step act as a glassy spring, so the step need not resolve all branches.
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
SERIES_COEFFICIENTS = tuple(1.0 / power for power in range(11, 2, -1))  # last term first


class Prony(NamedTuple):
    """Constants of one step: y_k becomes E_k y_k - B_k p_new - A_k p_old."""

    decay: np.ndarray  # E_k, shape (K,)
    fresh: np.ndarray  # B_k, shape (K,): decrease of y_k per unit new force
    stale: np.ndarray  # A_k, shape (K,): decrease of y_k per unit old force
    stiffness: float  # 1 / (J_g + sum B_k) (law.py)
    lag: float  # (law.py)
    linear: float  # kappa: 1 if the force is linear in the step, 0 if it is constant


@inlined_kernel
def moments(x):
    """Return (E, 1 - E, beta, alpha) of a step x: E = exp(-x), weights of end and start force."""
    if x > LN_2:
        left = math.exp(-x)
        decayed = 1.0 - left
        return left, decayed, 1.0 - decayed / x, decayed / x - left
    if x > 0.1:
        decayed = -math.expm1(-x)
        return 1.0 - decayed, decayed, 1.0 - decayed / x, decayed / x - (1.0 - decayed)
    end = 1.0  # a series, to avoid the difference of nearly equal numbers
    for share in SERIES_COEFFICIENTS:
        end = 1.0 - x * share * end
    end *= 0.5 * x
    decayed = x * (1.0 - end)
    return 1.0 - decayed, decayed, end, decayed - end


@law_of.register(Retardation)
def _law_of(form, dt):
    constants = np.empty((5, form.times.size))  # one array: making one costs ten samples
    return Prony(constants[0], constants[1], constants[2], *fill_law(form, dt, constants))


@refcount_free_kernel
def fill_law(form, dt, constants):
    """Return (stiffness, lag, linear); fill rows of ``constants`` (5, K): decay, fresh, stale."""
    decay, fresh, stale = constants[0], constants[1], constants[2]
    moved, late = constants[3], constants[4]  # response to a constant unit force, its delay
    ramp = latest = 0.0
    for k in range(form.times.size):
        x, compliance = dt / form.times[k], form.compliances[k]
        left, decayed, end, start = moments(x)
        decay[k] = left if left > math.sqrt(MIN_MAGNITUDE) else 0.0
        fresh[k], stale[k] = compliance * end, compliance * start
        moved[k], late[k] = compliance * decayed, start / decayed
        ramp += stale[k]
        latest = max(latest, late[k])
    prompt = total_response = form.glass
    for k in range(form.times.size):
        prompt += moved[k] * (1.0 - late[k] / latest)
        total_response += moved[k]
    linear = min(1.0, 4.0 * prompt / ramp)
    softness = form.glass
    for k in range(form.times.size):
        fresh[k] += (1.0 - linear) * stale[k]
        stale[k] *= linear
        softness += fresh[k]
    return 1.0 / softness, (1.0 - linear) * ramp / total_response, linear


@memory_size.register(Retardation)
def _memory_size(form):
    return form.times.size


@rest_memory.register(Retardation)
def _rest_memory(form, p):
    return -form.compliances.reshape(-1, 1) * p


@displacement.register(Retardation)
def _displacement(form, memory, p):
    return memory.sum(0) - form.glass * p


@static_pressure.register(Retardation)
def _static_pressure(form, memory):
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
    for k in range(1, memory.shape[0]):
        decay = law.decay[k]
        for i in range(w.size):
            w[i] += decay * memory[k, i]


@advance_memory.register(Prony)
def _advance_memory(law, memory, w, p, new):
    for k in range(memory.shape[0]):
        decay, fresh, stale = law.decay[k], law.fresh[k], law.stale[k]
        for i in range(p.size):
            y = decay * memory[k, i] - fresh * new[i] - stale * p[i]
            memory[k, i] = y if abs(y) > MIN_MAGNITUDE else 0.0
