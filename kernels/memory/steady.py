"""Steady sliding of elements with internal variables, without time marching.

At constant indentation the line carries its field of states along. One turn of an element round
the period, from the deepest sample, is a piecewise linear map of its state there and of d. It
must come back to where it began, and the forces on the way must carry the load: Newton's method
on both with exact tangents, which are columns beside the state that follow the same law.

The state of an element at given d contracts in its own energy norm and the force grows with d,
so that there is one solution. A step that leaves no element touching is halved; all loops are
bounded, and what is left of the equations is the residual.
"""

from typing import NamedTuple

import numpy as np

from kernels.contact import solve_indentation
from kernels.jit import kernel
from kernels.rheology.law import Elements, law_of, memories, predict, rest, settle
from kernels.rheology.relaxed import Moduli
from kernels.rheology.retardation import Retardation

TURNS = 60  # at most; a few are enough
EXACT = 1e-13  # residual that is as good as none
SOUND = 1e-6  # residual that is taken; rounding leaves 1e-13 times the stiffness of a step


class Steady(NamedTuple):
    """A steady state of sliding."""

    elements: Elements  # at the samples of the line, after a step
    work: int  # updates of an element or of a tangent that it took
    residual: float  # what is left of the equations, relative


def steady_memory(form: Retardation | Moduli, z: np.ndarray, speed: float, load: float) -> Steady:
    """Return the steady state of sliding under the load sum_i f_i = load.

    form : of the material (rheology/forms.py). z : heights of the line, shape (n,), in h.
    speed : in samples per tau, negative towards -x. Raises ValueError where it is not found.
    """
    start, _ = solve_indentation(z, load, float(z.min()) + load / z.size)
    return _found(form, z, speed, load, start)


def steady_at(form: Retardation | Moduli, z: np.ndarray, speed: float, d: float) -> Steady:
    """Return the steady state of sliding at a given indentation d (in h), as steady_memory."""
    return _found(form, z, speed, np.nan, d)


def _found(
    form: Retardation | Moduli, z: np.ndarray, speed: float, load: float, d: float
) -> Steady:
    memory, p, d, work, residual = _newton(form, z, speed, load, d)
    if not residual <= SOUND:
        raise ValueError(
            f"speed = {speed:g} samples per tau: no steady state was found, "
            f"its equations are off by {residual:.1e}"
        )
    return Steady(Elements(memory, p, d), work, residual)


@kernel
def _newton(form, z, speed, load, d):
    """Return (memory, p, d, work, residual); a load that is NaN leaves d as it is."""
    law, count = law_of(form, 1.0 / abs(speed)), memories(form)
    first = np.argmin(z)
    prescribed = np.isnan(load)
    held = np.full(1, max(0.0, d - z[first]))
    x = np.append(np.append(rest(form, held)[:, 0], held), d)
    best, least = x.copy(), np.inf
    step = np.zeros_like(x)
    turns = 0
    for _ in range(TURNS):
        memory, p, total = _turn(law, count, z, first, speed, x)
        turns += 1
        if total[0] <= 0.0 and not prescribed:
            step *= 0.5
            x = x - step
            continue
        excess = np.append(np.append(memory[:, 0], p[0]) - x[:-1], total[0] - load)
        if prescribed:
            excess[-1] = 0.0
        left = np.abs(excess[:-1]).max() / max(np.abs(memory[:, 0]).max(), np.abs(x).max() * 1e-30)
        if not prescribed:
            left = max(left, abs(excess[-1]) / load)
        stuck = least < SOUND and not left < 0.5 * least
        if left < least:
            best, least = x.copy(), left
        if stuck or left < EXACT:
            break
        step = _step(memory, p, total, excess, prescribed)
        x = x + step
    memory, p = _carried(law, count, z, first, speed, best)
    return memory, p, best[-1], turns * z.size * (count + 3) + z.size, least


@kernel
def _turn(law, count, z, first, speed, x):
    """Take an element round the line; return (memory, p, sum of p), tangents in columns from 1.

    x : memory and force of the element under sample ``first``, and the indentation. Column k + 1
    is the derivative with respect to x_k. Shapes (M, M + 3), (M + 3,), (M + 3,).
    """
    columns = count + 3
    memory, p, total = np.zeros((count, columns)), np.zeros(columns), np.zeros(columns)
    memory[:, 0], p[0], d = x[:count], x[count], x[count + 1]
    for k in range(count):
        memory[k, k + 1] = 1.0
    p[count + 1] = 1.0
    w, new = np.empty(columns), np.empty(columns)
    way = -1 if speed > 0.0 else 1
    j = first
    for _ in range(z.size):
        j = (j + way) % z.size
        predict(law, memory, p, w)
        depth = d - (z[j] - w[0])
        if depth > 0.0:
            for c in range(columns):
                new[c] = law.stiffness * w[c]
            new[0] = law.stiffness * depth
            new[columns - 1] += law.stiffness
        else:
            new[:] = 0.0
        settle(law, memory, w, p, new)
        for c in range(columns):
            p[c] = new[c]
            total[c] += new[c]
    return memory, p, total


@kernel
def _carried(law, count, z, first, speed, x):
    """Return memory (M, n) and forces (n,) at all samples, one turn from state x on."""
    memory, p = np.empty((count, z.size)), np.empty(z.size)
    one, w, old, new = x[:count].copy().reshape((count, 1)), np.empty(1), np.empty(1), np.empty(1)
    old[0] = x[count]
    way = -1 if speed > 0.0 else 1
    j = first
    for _ in range(z.size):
        j = (j + way) % z.size
        predict(law, one, old, w)
        new[0] = law.stiffness * max(0.0, x[-1] - (z[j] - w[0]))
        settle(law, one, w, old, new)
        old[0] = p[j] = new[0]
        memory[:, j] = one[:, 0]
    return memory, p


@kernel
def _step(memory, p, total, excess, prescribed):
    """Return the step of Newton's method, by elimination with pivots of scaled rows."""
    size = excess.size
    a = np.empty((size, size + 1))
    a[:-2, :size], a[-2, :size], a[-1, :size] = memory[:, 1:], p[1:], total[1:]
    for k in range(size - 1):
        a[k, k] -= 1.0
    if prescribed:
        a[-1] = 0.0
        a[-1, size - 1] = 1.0
    a[:, size] = -excess
    for k in range(size):
        a[k] /= np.abs(a[k, :size]).max()
    for k in range(size):
        pivot = k + np.argmax(np.abs(a[k:, k]))
        for c in range(k, size + 1):
            a[k, c], a[pivot, c] = a[pivot, c], a[k, c]
        for i in range(k + 1, size):
            share = a[i, k] / a[k, k]
            for c in range(k, size + 1):
                a[i, c] -= share * a[k, c]
    x = np.empty(size)
    for k in range(size - 1, -1, -1):
        x[k] = a[k, size]
        for c in range(k + 1, size):
            x[k] -= a[k, c] * x[c]
        x[k] /= a[k, k]
    return x
