"""The relaxation form of a material and its step: the scheme "implicit-euler".

The material is a set of parallel Maxwell branches, and the displacement is linear in the step. The
derivation shares only the balance of forces with prony.py, and needs no zeros of the modulus. The
scheme is second order if the step resolves the times of all branches, first order otherwise and
with a dashpot. For a Kelvin element it is the implicit Euler scheme of kelvin.py.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import refcount_free_kernel
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
from .retardation import merged_branches
from .spectrum import Spectrum

RELAXATION_SCHEME = "implicit-euler"


class RelaxationForm(NamedTuple):
    """A material in its relaxation form."""

    moduli: np.ndarray  # g_b / G, shape (B,)
    times: np.ndarray  # t_b / tau, shape (B,), descending
    viscosity: float  # eta / (G tau)


class Relaxed(NamedTuple):
    """Constants of one step; the memory is the stress of each branch, then the displacement."""

    decay: np.ndarray  # E_b, shape (B,)
    gain: np.ndarray  # g_b (1 - E_b) t_b / dt, shape (B,): stress per displacement in the step
    drag: float  # eta / dt
    stiffness: float  # 1 + sum of gains + drag (law.py)
    lag: float  # 0 (law.py)


def relaxation(spectrum: Spectrum) -> RelaxationForm:
    """Return the relaxation form. Raises ValueError as ``merged_branches`` does."""
    return RelaxationForm(*merged_branches(spectrum), spectrum.viscosity)


@law_of.register(RelaxationForm)
def _law_of(form, dt):
    count = form.times.size
    decay, gain = np.empty(count), np.empty(count)
    drag = form.viscosity / dt
    stiffness = 1.0 + drag
    for b in range(count):
        x = dt / form.times[b]
        decay[b] = math.exp(-x)
        if not decay[b] > math.sqrt(MIN_MAGNITUDE):
            decay[b] = 0.0
        gain[b] = form.moduli[b] * (-math.expm1(-x) / x)
        stiffness += gain[b]
    return Relaxed(decay, gain, drag, stiffness, 0.0)


@memory_size.register(RelaxationForm)
def _memory_size(form):
    return form.times.size + 1


@rest_memory.register(RelaxationForm)
def _rest_memory(form, p):
    memory = np.zeros((form.times.size + 1, p.size))
    memory[-1] -= p
    return memory


@displacement.register(RelaxationForm)
def _displacement(form, memory, p):
    return memory[-1].copy()


@static_pressure.register(RelaxationForm)
def _static_pressure(form, memory):
    return form.viscosity, -memory.sum(0)


@predict.register(Relaxed)
def _predict(law, memory, p, w):
    count = law.decay.size
    keep = (law.drag + law.gain.sum()) / law.stiffness
    for i in range(w.size):
        w[i] = keep * memory[count, i]
    for b in range(count):
        share = law.decay[b] / law.stiffness
        for i in range(w.size):
            w[i] -= share * memory[b, i]


@advance_memory.register(Relaxed)
def _advance_memory(law, memory, w, p, new):
    count = law.decay.size
    for i in range(w.size):
        u = w[i] - new[i] / law.stiffness
        w[i] = u - memory[count, i]
        memory[count, i] = u if abs(u) > MIN_MAGNITUDE else 0.0
    for b in range(count):
        decay, gain = law.decay[b], law.gain[b]
        for i in range(w.size):
            s = decay * memory[b, i] + gain * w[i]
            memory[b, i] = s if abs(s) > MIN_MAGNITUDE else 0.0


@refcount_free_kernel
def predict_element(law, y):
    """Return the displacement of one element without force, as predict; y (M,) : its memory."""
    count = law.decay.size
    carried, keep = 0.0, law.drag
    for b in range(count):
        carried += law.decay[b] * y[b]
        keep += law.gain[b]
    return (keep * y[count] - carried) / law.stiffness


@refcount_free_kernel
def advance_element(law, y, w, new):
    """Advance the memory y (M,) of one element over the step, as advance_memory does."""
    count = law.decay.size
    u = w - new / law.stiffness
    moved = u - y[count]
    y[count] = u if abs(u) > MIN_MAGNITUDE else 0.0
    for b in range(count):
        s = law.decay[b] * y[b] + law.gain[b] * moved
        y[b] = s if abs(s) > MIN_MAGNITUDE else 0.0
