"""Steady sliding of elements with internal variables, without time marching.

At constant indentation the line carries its field of states along. One turn of an element round
the period, from the deepest sample, is a piecewise linear map of its state there and of d. It
must come back to where it began, and the forces on the way must carry the load (eq. 4): Newton's
method on both with exact tangents, which follow the same law in columns of their own. While an
element touches, or does not, a step does the same to all tangents: many at once are a power of it.
Eq. 4 alone is solved in model/contact.py, and in model/steady.py where u is all that is remembered.

The state of an element at given d contracts in its own energy norm and the force grows with d,
so that there is one solution. A step that leaves no element touching is halved; all loops are
bounded, and what is left of the equations is the residual.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..model.contact import solve_indentation
from ..rheology.forms import Form
from ..rheology.law import (
    Elements,
    law_of,
    memories,
    predict,
    predict_one,
    rest,
    settle,
    settle_one,
)

TURNS = 60  # at most; a few are enough
EXACT = 1e-13  # residual that is as good as none
SOUND = 1e-6  # residual that is taken
FINEST = 1e-13  # and beside it, times the stiffness of a step: what rounding leaves


class SteadyMemory(NamedTuple):
    """A steady state of sliding of elements with internal variables."""

    elements: Elements  # at the samples of the line, after a step
    work: int  # updates of an element or of a tangent that it took
    residual: float  # what is left of the equations, relative


def steady_memory(form: Form, z: np.ndarray, speed: float, load: float) -> SteadyMemory:
    """Return the steady state of sliding under the load sum_i f_i = load.

    form : of the material (rheology/forms.py). z : heights of the line, shape (n,), in h.
    speed : in samples per tau, negative towards -x. Raises ValueError where it is not found.
    """
    start, _ = solve_indentation(z, load, float(z.min()) + load / z.size)
    return _found(form, z, speed, load, start)


def steady_at(form: Form, z: np.ndarray, speed: float, d: float) -> SteadyMemory:
    """Return the steady state of sliding at a given indentation d (in h), as steady_memory."""
    return _found(form, z, speed, np.nan, d)


def _found(form: Form, z: np.ndarray, speed: float, load: float, d: float) -> SteadyMemory:
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
    powers = _no_powers(count + 3, z.size)
    while turns < TURNS:
        tangents = np.eye(count + 3, count + 2)
        field, forces = np.empty((z.size, count)), np.empty(z.size)
        total = _turn(law, z, first, way, x, tangents, powers, field, forces)
        turns += 1
        if total <= 0.0 and not np.isnan(load):
            step *= 0.5
            x = x - step
            continue
        excess = np.append(field[first] - x[:count], [forces[first] - x[count], total - load])
        left = _residual(excess, x, load)
        stuck = least < sound and not left < 0.5 * least
        if left < least:
            found, least = (
                Elements(np.ascontiguousarray(field.T), forces, float(x[-1]) + deepest),
                left,
            )
        if stuck or left < EXACT:
            break
        step = _step(tangents, excess)
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


class Powers(NamedTuple):
    """What 2^k steps do to tangents: of an element that is free (0) and of one that touches (1)."""

    of: np.ndarray  # shape (2, k, M + 3, M + 3)
    known: np.ndarray  # shape (2,): how many of them are known


def _no_powers(size: int, steps: int) -> Powers:
    """Return room for the powers of so many steps."""
    return Powers(np.empty((2, steps.bit_length(), size, size)), np.zeros(2, np.int64))


@kernel
def _turn(law, z, first, way, x, tangents, powers, field, forces):
    """Take an element round the line, from under sample ``first``; return the sum of its forces.

    x : its memory and force at the start, and d. tangents : shape (M + 3, M + 2), of memory, force,
    d and the sum of forces with respect to x, changed from those at the start to those at the end.
    field (n, M) and forces (n,) are filled with the state at all samples.
    """
    y, p, d, total = x[:-2].copy(), x[-2], x[-1], 0.0
    j, touched, length = first, True, 0
    for _ in range(z.size):
        j += way
        if j < 0 or j == z.size:
            j = 0 if j > 0 else z.size - 1
        w = predict_one(law, y, p)
        depth = d - (z[j] - w)
        if (depth > 0.0) != touched:
            _carry(law, powers, touched, length, tangents)
            touched, length = depth > 0.0, 0
        length += 1
        new = law.stiffness * depth if touched else 0.0
        settle_one(law, y, w, p, new)
        p = forces[j] = new
        total += new
        for k in range(y.size):
            field[j, k] = y[k]
    _carry(law, powers, touched, length, tangents)
    return total


@kernel
def _carry(law, powers, touching, length, tangents):
    """Take tangents over so many steps in which an element touches, or does not.

    One by one, or where it takes less by powers of two of them.
    """
    bits = 0
    while length >> bits > 0:
        bits += 1
    if 3 * length <= bits * tangents.shape[0]:
        _take_steps(law, touching, length, tangents)
        return
    kind = 1 if touching else 0
    of, known = powers.of[kind], powers.known[kind]
    for k in range(known, bits):
        if k == 0:
            of[0] = np.eye(of.shape[1])
            _take_steps(law, touching, 1, of[0])
        else:
            of[k] = of[k - 1]
            _multiply(of[k - 1], of[k])
    powers.known[kind] = max(known, bits)
    for k in range(bits):
        if length >> k & 1:
            _multiply(of[k], tangents)


@kernel
def _take_steps(law, touching, length, tangents):
    """Take tangents over so many steps; their rows are as of ``_turn``."""
    size, columns = tangents.shape
    memory, p, d, total = tangents[: size - 3], tangents[size - 3], tangents[size - 2], tangents[-1]
    w, new = np.empty(columns), np.empty(columns)
    for _ in range(length):
        predict(law, memory, p, w)
        for c in range(columns):
            new[c] = law.stiffness * (w[c] + d[c]) if touching else 0.0
        settle(law, memory, w, p, new)
        for c in range(columns):
            p[c] = new[c]
            total[c] += new[c]


@kernel
def _multiply(a, b):
    """Change b to the product a b."""
    product = np.zeros(b.shape)
    for i in range(a.shape[0]):
        row = product[i]
        for j in range(a.shape[1]):
            factor, other = a[i, j], b[j]
            for c in range(row.size):
                row[c] += factor * other[c]
    b[:] = product


def _step(tangents: np.ndarray, excess: np.ndarray) -> np.ndarray:
    """Return the step of Newton's method: elimination with pivots, the same bits everywhere.

    Where the load is not given, d is: its row says that it stays.
    """
    size = excess.size
    a = np.delete(tangents, size - 1, axis=0)
    a[:-1] -= np.eye(size - 1, size)
    if np.isnan(excess[-1]):
        a[-1] = np.eye(1, size, size - 1)
    a = np.column_stack([a, np.nan_to_num(-excess)])
    a /= np.abs(a[:, :size]).max(axis=1, keepdims=True)
    _eliminate(a)
    return a[:, size]


@kernel
def _eliminate(a):
    """Solve the equations a, shape (size, size + 1), with pivots; the last column is the answer."""
    for k in range(a.shape[0]):
        pivot = k
        for i in range(k + 1, a.shape[0]):
            if abs(a[i, k]) > abs(a[pivot, k]):
                pivot = i
        for j in range(a.shape[1]):
            a[k, j], a[pivot, j] = a[pivot, j], a[k, j]
        whole = a[k, k]
        for j in range(a.shape[1]):
            a[k, j] /= whole
        for i in range(a.shape[0]):
            if i != k:
                factor = a[i, k]
                for j in range(a.shape[1]):
                    a[i, j] -= factor * a[k, j]
