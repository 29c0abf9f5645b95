"""One step of Kelvin units and a glassy spring in series: the scheme "exponential".

The units move exactly under a force that is linear in the step, from kappa of the old force and
1 - kappa of the new one to the new one. A linear force (kappa = 1) is second order, but where
the glassy spring is stiff the old force comes back with a gain that tends to one: it would
ring. A constant one (kappa = 0) is right without that spring, where forces jump at touch-down.
kappa = min(1, 4 J_g / S) keeps the gain at 4/5 or below, and departs from one while J_g is of
the order of the step alone: the error is of second order throughout.
"""

import math
from typing import NamedTuple

import numpy as np

from kernels.jit import kernel
from kernels.rheology.law import (
    NEGLIGIBLE,
    displacement,
    lasting,
    law_of,
    memories,
    predict,
    rest,
    settle,
)
from kernels.rheology.retardation import Retardation

SCHEME = "exponential"


class Prony(NamedTuple):
    """Constants of one step: y_k becomes E_k y_k - B_k p_new - A_k p_old."""

    decay: np.ndarray  # E_k, shape (K,)
    fresh: np.ndarray  # B_k, shape (K,): what the new force does to unit k
    stale: np.ndarray  # A_k, shape (K,): what the old force does
    stiffness: float  # 1 / (J_g + sum B_k) (law.py)
    lag: float  # (law.py)
    linear: float  # kappa: 1 where the force is linear, 0 where it is constant


@kernel
def moments(x):
    """Return (1 - E, beta, alpha): E = exp(-x) and the weights of the end and the start force."""
    if x > 0.1:
        gone = -math.expm1(-x)
        return gone, 1.0 - gone / x, gone / x - (1.0 - gone)
    beta = alpha = 0.0  # differences of nearly equal numbers otherwise
    term = x
    for power in range(1, 12):
        term /= power + 1.0
        beta += term
        alpha += power * term
        term *= -x
    return -math.expm1(-x), beta, alpha


@law_of.of(Retardation)
def _law_of(form, dt):
    count = form.times.size
    decay, fresh, stale = np.empty(count), np.empty(count), np.empty(count)
    ramp = moved = 0.0  # S and a: displacements by a unit force that starts or lasts
    for k in range(count):
        gone, beta, alpha = moments(dt / form.times[k])
        decay[k] = 1.0 - gone if gone < 0.5 else math.exp(-dt / form.times[k])
        if not decay[k] > math.sqrt(NEGLIGIBLE):
            decay[k] = 0.0
        fresh[k], stale[k] = form.compliances[k] * beta, form.compliances[k] * alpha
        ramp += stale[k]
        moved += form.compliances[k] * gone
    linear = min(1.0, 4.0 * form.glass / ramp)
    compliance = form.glass
    for k in range(count):
        fresh[k] += (1.0 - linear) * stale[k]
        stale[k] *= linear
        compliance += fresh[k]
    lag = (1.0 - linear) * ramp / (form.glass + moved)
    return Prony(decay, fresh, stale, 1.0 / compliance, lag, linear)


@memories.of(Retardation)
def _memories(form):
    return form.times.size


@rest.of(Retardation)
def _rest(form, p):
    memory = np.empty((form.times.size, p.size))
    for k in range(form.times.size):
        for i in range(p.size):
            memory[k, i] = -form.compliances[k] * p[i]
    return memory


@displacement.of(Retardation)
def _displacement(form, memory, p):
    return memory.sum(0) - form.glass * p


@lasting.of(Retardation)
def _lasting(form, memory):
    """Without a glassy spring the units' rates add up to du/dt: p = -eta (du/dt + sum y/lambda)."""
    viscosity = 1.0 / (form.compliances / form.times).sum() if form.glass == 0.0 else 0.0
    pressure = np.zeros(memory.shape[1])
    for k in range(form.times.size):
        for i in range(pressure.size):
            pressure[i] -= viscosity / form.times[k] * memory[k, i]
    return viscosity, pressure


@predict.of(Prony)
def _predict(law, memory, p, w):
    total = law.stale.sum()
    for i in range(w.size):
        w[i] = law.decay[0] * memory[0, i] - total * p[i]
    for k in range(1, law.decay.size):
        decay = law.decay[k]
        for i in range(w.size):
            w[i] += decay * memory[k, i]


@settle.of(Prony)
def _settle(law, memory, w, p, new):
    for k in range(law.decay.size):
        decay, fresh, stale = law.decay[k], law.fresh[k], law.stale[k]
        for i in range(p.size):
            y = decay * memory[k, i] - fresh * new[i] - stale * p[i]
            memory[k, i] = y if abs(y) > NEGLIGIBLE else 0.0
