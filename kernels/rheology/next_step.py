"""A law for elements that count what the next step finds: it needs no force of the step before.

Let y_k be the memory of unit k after a step, and v_k = E_k y_k - A_k p what the next step makes of
it before its own force acts (prony.py). From step to step, all being of one length,

    v_k <- E_k v_k - (E_k B_k + A_k) p,

and an element without force would reach sum v_k. The relaxation form needs no force as it is.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import by_type
from .law import NEGLIGIBLE, predict, predict_one, settle, settle_one
from .prony import Prony
from .relaxed import Relaxed


@by_type
def foreseen(law):
    """Return a law of the same step whose predictions need no force of the step before."""


@by_type
def from_memory(law, memory, p):
    """Return what is counted of an element (M,) with this memory (M,) after a step with force p."""


@by_type
def step_one(law, y, w, new):
    """Take an element over a step with the force new; return where none would take it in the next.

    law : as ``foreseen`` returns it. y (M,) : what it counts of the element, changed. w : where the
    element would be without the force new.
    """


@by_type
def fill_memory(law, y, forces, memory, at, way):
    """Fill what an element remembers at the samples at, at + way, ... of ``memory`` (M, n).

    law : as ``foreseen`` returns it. y (M,) : what it counts of the element before it comes to the
    first of them, changed to that after the last. forces : at these samples.
    """


class Foreseen(NamedTuple):
    """Constants of one step of v_k; stiffness as of every law (law.py)."""

    decay: np.ndarray  # E_k, shape (K,)
    due: np.ndarray  # E_k B_k + A_k, shape (K,): what a force takes from v_k
    fresh: np.ndarray  # B_k, shape (K,): what it takes from the memory
    stiffness: float


@foreseen.of(Prony)
def _foreseen_of_units(law):
    return Foreseen(law.decay, law.decay * law.fresh + law.stale, law.fresh, law.stiffness)


@foreseen.of(Relaxed)
def _foreseen_of_branches(law):
    return law


@from_memory.of(Foreseen)
def _from_memory(law, memory, p):
    return law.decay * (memory + law.fresh * p) - law.due * p


@from_memory.of(Relaxed)
def _from_memory_of_branches(law, memory, p):
    return memory.copy()


@predict.of(Foreseen)
def _predict(law, memory, p, w):
    w[:] = 0.0
    for k in range(law.decay.size):
        for i in range(w.size):
            w[i] += memory[k, i]


@settle.of(Foreseen)
def _settle(law, memory, w, p, new):
    for k in range(law.decay.size):
        decay, due = law.decay[k], law.due[k]
        for i in range(w.size):
            v = decay * memory[k, i] - due * new[i]
            memory[k, i] = v if abs(v) > NEGLIGIBLE else 0.0


@predict_one.of(Foreseen)
def _predict_one(law, y, p):
    even = odd = 0.0  # one sum would wait for itself
    for k in range(0, y.size - 1, 2):
        even += y[k]
        odd += y[k + 1]
    return even + odd + (y[-1] if y.size % 2 == 1 else 0.0)


@step_one.of(Foreseen)
def _step_one(law, y, w, new):
    for k in range(y.size):
        y[k] = law.decay[k] * y[k] - law.due[k] * new
    if new == 0.0:
        for k in range(y.size):
            y[k] = y[k] if abs(y[k]) > NEGLIGIBLE else 0.0
    return predict_one(law, y, 0.0)


@step_one.of(Relaxed)
def _step_of_branches(law, y, w, new):
    settle_one(law, y, w, 0.0, new)
    return predict_one(law, y, 0.0)


@fill_memory.of(Foreseen)
def _fill_memory(law, y, forces, memory, at, way):
    for k in range(y.size):
        decay, due, fresh, v, j = law.decay[k], law.due[k], law.fresh[k], y[k], at
        for i in range(forces.size):
            memory[k, j] = v - fresh * forces[i]
            v = decay * v - due * forces[i]
            j += way
        y[k] = v if abs(v) > NEGLIGIBLE else 0.0


@fill_memory.of(Relaxed)
def _fill_memory_of_branches(law, y, forces, memory, at, way):
    for i in range(forces.size):
        settle_one(law, y, predict_one(law, y, 0.0), 0.0, forces[i])
        for k in range(y.size):
            memory[k, at + way * i] = y[k]
