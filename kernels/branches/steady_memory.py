"""Steady sliding of elements with internal variables, without time marching.

At constant indentation the line carries its field of states along. One turn of an element round
the period, from the deepest sample, is a piecewise linear map of its state there and of d. It
must come back to where it began, and the forces on the way must carry the load (eq. 4): Newton's
method on both with exact tangents, which follow the same law (tangents.py). Where the line lies
above d no element touches, as none is ever pulled up, and the element takes many steps at once.
The first guess is the state of every sixteenth sample in steps that are as long, and its own that
of still fewer.
Eq. 4 alone is solved in model/contact.py, and in model/steady.py where u is all that is remembered.

The state of an element at given d contracts in its own energy norm and the force grows with d,
so that there is one solution. A step that leaves no element touching is halved; all loops are
bounded, and what is left of the equations is the residual.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel
from ..model.contact import solve_indentation
from ..rheology.forms import Form
from ..rheology.law import Elements, law_of, memory_size, rest_memory
from ..rheology.lookahead import (
    BLOCK_SAMPLES,
    fill_memory,
    lookahead_law,
    lookahead_memory,
    slide_element,
)
from .tangents import carry_rows, powers_of_steps, tangents_of

TURNS = 60  # at most; a few are enough
EXACT = 1e-13  # residual that is as good as none
GUESSED = 1e-3  # and that is as good as it need be of a first guess
SOUND = 1e-6  # residual that is taken
FINEST = 1e-13  # and beside it, times the stiffness of a step: what rounding leaves
QUICK = 8  # tangents that take so many numbers of products for each sample spare more time
TOGETHER = 16  # samples at which the memory of a unit is filled before that of the next
APART = 64  # samples that are taken one by one before it is asked again whether many can be passed
COARSER, COARSEST = 16, 1000  # samples of the line for one of a guess, and how many it has at least


@dataclass(frozen=True)
class SteadyMemory:
    """A steady state of sliding of elements with internal variables."""

    p: np.ndarray  # forces at the samples of the line, after a step, shape (n,), in 4 G dx h
    d: float  # indentation, in h
    work: int  # updates of an element or of a tangent that it took
    residual: float  # what is left of the equations, relative
    form: Form
    speed: float  # in samples per tau, signed
    deepest: int  # sample
    before: np.ndarray  # shape (M,): what is counted of an element that comes from there

    @cached_property
    def elements(self) -> Elements:
        """The elements: where forces alone are asked for no memory is filled, else once."""
        memory = _remembered(self.form, self.speed, self.before.copy(), self.p, self.deepest)
        return Elements(memory, self.p, self.d)


def steady_memory(form: Form, z: np.ndarray, speed: float, load: float) -> SteadyMemory:
    """Return the steady state of sliding under the load sum_i f_i = load.

    form : of the material (rheology/forms.py). z : heights of the line, shape (n,), in h.
    speed : in samples per tau, negative towards -x. Raises ValueError where it is not found.
    """
    return _found(form, z, speed, load, np.nan)


def steady_at(form: Form, z: np.ndarray, speed: float, d: float) -> SteadyMemory:
    """Return the steady state of sliding at a given indentation d (in h), as steady_memory."""
    return _found(form, z, speed, np.nan, d)


def _found(form: Form, z: np.ndarray, speed: float, load: float, d: float) -> SteadyMemory:
    """Return the steady state under a load, or at d if the load is NaN.

    Heights and d are counted from the deepest sample: what presses in is known to rounding then.
    """
    p, d, work, residual, deepest, before = _solved(form, z, speed, load, d, TURNS)
    if not residual <= SOUND + FINEST * law_of(form, 1.0 / abs(speed)).stiffness:
        raise ValueError(
            f"speed = {speed:g} samples per tau: no steady state was found, "
            f"its equations are off by {residual:.1e}"
        )
    return SteadyMemory(p, d, work, residual, form, speed, deepest, before)


@kernel
def _solved(form, z, speed, load, d, most):
    """Return the first four fields of SteadyMemory, and the last two."""
    count, n = memory_size(form), z.size
    first, way = np.argmin(z), -1 if speed > 0.0 else 1
    apart = 1
    while n // (COARSER * apart) >= COARSEST:
        apart *= COARSER
    x, forces, updates, residual = np.zeros(count + 1), np.empty(0), 0, np.inf
    x[-1] = d - z[first]
    while apart > 0:
        line = _as_met(z, first, way * apart, n // apart)
        here, law = load * line.size / n, lookahead_law(law_of(form, apart / abs(speed)))
        if not residual < 1.0:
            held = np.array([x[-1]])
            if not np.isnan(load):
                held[0], _ = solve_indentation(line, here, here / line.size)
            x[-1], held[0] = held[0], max(held[0], 0.0)
            x[:-1] = lookahead_memory(
                law, np.ascontiguousarray(rest_memory(form, held)[:, 0]), held[0]
            )
        forces = np.empty(line.size)
        turns, residual = _solve(law, line, here, EXACT if apart == 1 else GUESSED, most, x, forces)
        updates += turns * line.size * (count + 2)
        apart //= COARSER
    cut = first if way < 0 else n - 1 - first
    if way < 0:
        p = np.concatenate((forces[:cut][::-1], forces[cut:][::-1]))
    else:
        p = np.concatenate((forces[cut:], forces[:cut]))
    return p, x[-1] + z[first], updates, residual, first, x[:-1].copy()


@kernel
def _as_met(z, first, way, count):
    """Return ``count`` heights over the deepest, at every ``way``-th sample up to ``first``."""
    line, j = np.empty(count), (first - way * count) % z.size
    for i in range(count):
        j += way
        if j < 0 or j >= z.size:
            j %= z.size
        line[i] = z[j] - z[first]
    return line


@kernel
def _remembered(form, speed, y, p, first):
    """Return what elements under the forces p remember, shape (M, n); y is changed."""
    law, way = lookahead_law(law_of(form, 1.0 / abs(speed))), -1 if speed > 0.0 else 1
    n, memory, i, j = p.size, np.empty((y.size, p.size)), 0, first
    while i < n:
        j = (j + way) % n
        some = min(TOGETHER, n - i, j + 1 if way < 0 else n - j)
        fill_memory(law, y, p, memory, j, way, some)
        i, j = i + some, j + way * (some - 1)
    return memory


@kernel
def _solve(law, line, load, enough, most, x, forces):
    """Take x to the solution with Newton's method; return (turns, residual).

    Where a step leaves less than a tenth and tangents take longer than the turns that they spare,
    what it leaves corrects them (C. G. Broyden, Math. Comp. 19 (1965) 577).
    x : what is counted of the element before its turn, and d; the best of all turns is left there,
    and its forces (n,) too. load : NaN where d is given. most : turns.
    """
    size, least, before, turns, exact, quick = x.size, np.inf, 0.0, 0, False, False
    sound = SOUND + FINEST * law.stiffness
    powers, tangents = powers_of_steps(law, size + 1, line.size), np.empty((size, size + 1))
    now, step, tried = x.copy(), np.zeros(size), np.empty(line.size)
    while turns < most:
        y = np.zeros(powers.product.shape[0])
        y[:size] = now
        _turn(law, line, y, powers, tried)
        y = y[: size + 1]
        turns += 1
        if y[-1] <= 0.0 and not np.isnan(load):
            step *= 0.5
            now -= step
            before = 0.0
            continue
        y[:-1] -= now
        y[-1] -= load
        left = _residual(y, now, load)
        stuck = exact and least < sound and not left < 0.5 * least
        if left < least:
            least = left
            x[:], forces[:] = now, tried
        if stuck or left < enough:
            break
        exact = not left < 0.1 * before or quick
        before = left
        if exact:
            tangents, spells = tangents_of(powers, tried)
            quick = spells * powers.product.size < QUICK * line.size
        else:
            tangents += np.outer(step / (step**2).sum(), y)
        step = _step(tangents, y)
        now += step
    return turns, least


@kernel
def _residual(excess, x, load):
    """Return what is left of the equations: of the state relative to it, of forces to the load."""
    largest = np.abs(x[:-1]).max()
    scale = max(largest, 1e-30 * max(largest, abs(x[-1])), 1e-300)
    state = np.abs(excess[:-1]).max() / scale
    return state if np.isnan(load) else max(state, abs(excess[-1]) / load)


@refcount_free_kernel
def _turn(law, line, x, powers, forces):
    """Take an element round the line, from before the first of the heights (n,) to after the last.

    x : shape (W,), what is counted of it, d, and the sum of the forces on it, changed.
    forces (n,) is filled.
    """
    count, total, i = powers.size - 2, 0.0, 0
    d = x[count]
    while i < line.size:
        stop = i
        while stop < line.size and line[stop] >= d:
            forces[stop] = 0.0
            stop += 1
        if stop - i >= BLOCK_SAMPLES:
            carry_rows(powers, False, stop - i, x.reshape(1, -1))
        else:
            stop = min(i + APART, line.size)
            total += slide_element(law, x[:count], d, line[i:stop], forces[i:stop])
        i = stop
    x[count + 1] = total


@kernel
def _step(tangents, excess):
    """Return the step of Newton's method: elimination with pivots, the same bits everywhere.

    Where the load is not given, d is: its row says that it stays.
    """
    size = excess.size - 1
    a = np.empty((size, size + 1))
    for i in range(size):
        row = i if i < size - 1 else size
        for j in range(size):
            a[i, j] = tangents[j, row] - (1.0 if i == j and i < size - 1 else 0.0)
        a[i, size] = -excess[row]
        if np.isnan(excess[row]):
            a[i] = 0.0
            a[i, size - 1] = 1.0
        a[i] /= np.abs(a[i, :size]).max()
    _eliminate(a)
    return a[:, size].copy()


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
