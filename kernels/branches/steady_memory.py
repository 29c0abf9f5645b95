"""Steady sliding of elements with internal variables, without time marching.

At constant indentation the line carries its field of states along. One turn of an element round
the period, from the deepest sample, is a piecewise linear map of its state there and of d. It
must come back to where it began, and the forces on the way must carry the load (eq. 4): Newton's
method on both with exact tangents, which are columns beside the state that follow the same law.
Eq. 4 alone is solved in model/contact.py, and in model/steady.py where u is all that is remembered.

The state of an element at given d contracts in its own energy norm and the force grows with d,
so that there is one solution. A step that leaves no element touching is halved; all loops are
bounded, and what is left of the equations is the residual.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..model.contact import solve_indentation
from ..rheology.law import Elements, law_of, memories, predict, rest, settle
from ..rheology.relaxed import RelaxationForm
from ..rheology.retardation import Retardation

TURNS = 60  # at most; a few are enough
EXACT = 1e-13  # residual that is as good as none
SOUND = 1e-6  # residual that is taken
FINEST = 1e-13  # and beside it, times the stiffness of a step: what rounding leaves


class SteadyMemory(NamedTuple):
    """A steady state of sliding of elements with internal variables."""

    elements: Elements  # at the samples of the line, after a step
    work: int  # updates of an element or of a tangent that it took
    residual: float  # what is left of the equations, relative


def steady_memory(
    form: Retardation | RelaxationForm, z: np.ndarray, speed: float, load: float
) -> SteadyMemory:
    """Return the steady state of sliding under the load sum_i f_i = load.

    form : of the material (rheology/forms.py). z : heights of the line, shape (n,), in h.
    speed : in samples per tau, negative towards -x. Raises ValueError where it is not found.
    """
    start, _ = solve_indentation(z, load, float(z.min()) + load / z.size)
    return _found(form, z, speed, load, start)


def steady_at(
    form: Retardation | RelaxationForm, z: np.ndarray, speed: float, d: float
) -> SteadyMemory:
    """Return the steady state of sliding at a given indentation d (in h), as steady_memory."""
    return _found(form, z, speed, np.nan, d)


def _found(
    form: Retardation | RelaxationForm, z: np.ndarray, speed: float, load: float, d: float
) -> SteadyMemory:
    """Return the steady state under a load, from a first guess d, or at d if the load is NaN.

    Heights and d are counted from the deepest sample: what presses in is known to rounding then.
    """
    law, count = law_of(form, 1.0 / abs(speed)), memories(form)
    first, way, sound = int(np.argmin(z)), -1 if speed > 0.0 else 1, SOUND + FINEST * law.stiffness
    deepest = float(z[first])
    z, d = z - deepest, d - deepest
    held = np.array([max(0.0, d)])
    x = np.concatenate([rest(form, held)[:, 0], held, [d]])
    found, least, turns, step = Elements(np.empty((0, 0)), held, d), np.inf, 0, np.zeros_like(x)
    while turns < TURNS:
        memory, p, total = _columns(x)
        field, forces = np.empty((count, z.size)), np.empty(z.size)
        _turn(law, z, first, way, x[-1], memory, p, total, field, forces)
        turns += 1
        if total[0] <= 0.0 and not np.isnan(load):
            step *= 0.5
            x = x - step
            continue
        excess = np.append(memory[:, 0] - x[:count], [p[0] - x[count], total[0] - load])
        left = _residual(excess, x, load)
        stuck = least < sound and not left < 0.5 * least
        if left < least:
            found, least = Elements(field, forces, float(x[-1]) + deepest), left
        if stuck or left < EXACT:
            break
        step = _step(memory, p, total, excess)
        x = x + step
    if not least <= sound:
        raise ValueError(
            f"speed = {speed:g} samples per tau: no steady state was found, "
            f"its equations are off by {least:.1e}"
        )
    return SteadyMemory(found, turns * z.size * (count + 3), least)


def _residual(excess: np.ndarray, x: np.ndarray, load: float) -> float:
    """Return what is left of the equations: of the state relative to it, of forces to the load."""
    scale = max(float(np.abs(x[:-2]).max()), 1e-30 * float(np.abs(x).max()), 1e-300)
    state = float(np.abs(excess[:-1]).max()) / scale
    return state if np.isnan(load) else max(state, abs(float(excess[-1])) / load)


def _columns(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return memory and force at the start with their tangents, and the sum of no forces yet."""
    start = np.column_stack([x[:-1], np.eye(x.size - 1, x.size)])
    return start[:-1].copy(), start[-1].copy(), np.zeros(x.size + 1)


@kernel
def _turn(law, z, first, way, d, memory, p, total, field, forces):
    """Take an element round the line, from under sample ``first``; tangents in columns from 1.

    Column k + 1 is the derivative with respect to unknown k: the memory and the force at the
    start, and d. memory (M, M + 3) and p (M + 3,) change to those at the end; total (M + 3,)
    becomes the sum of p. field (M, n) and forces (n,) are filled with the state at all samples.
    """
    columns = p.size
    w, new = np.empty(columns), np.empty(columns)
    j = first
    for _ in range(z.size):
        j = (j + way) % z.size
        predict(law, memory, p, w)
        depth = d - (z[j] - w[0])
        for c in range(columns):
            new[c] = law.stiffness * w[c] if depth > 0.0 else 0.0
        if depth > 0.0:
            new[0] = law.stiffness * depth
            new[columns - 1] += law.stiffness
        settle(law, memory, w, p, new)
        for c in range(columns):
            p[c] = new[c]
            total[c] += new[c]
        forces[j] = p[0]
        for k in range(memory.shape[0]):
            field[k, j] = memory[k, 0]


def _step(memory: np.ndarray, p: np.ndarray, total: np.ndarray, excess: np.ndarray) -> np.ndarray:
    """Return the step of Newton's method: elimination with pivots, the same bits everywhere.

    Where the load is not given, d is: its row says that it stays.
    """
    size = excess.size
    a = np.vstack([memory[:, 1:], p[1:], total[1:]])
    a[:-1] -= np.eye(size - 1, size)
    if np.isnan(excess[-1]):
        a[-1] = np.eye(1, size, size - 1)
    a = np.column_stack([a, np.nan_to_num(-excess)])
    a /= np.abs(a[:, :size]).max(axis=1, keepdims=True)
    for k in range(size):
        pivot = k + int(np.argmax(np.abs(a[k:, k])))
        a[[k, pivot]] = a[[pivot, k]]
        a[k] /= a[k, k]
        for i in range(size):
            if i != k:
                a[i] -= a[i, k] * a[k]
    return a[:, size]
