"""Steady sliding of elements with internal variables, without time marching.

At constant indentation the field of states moves with the line. One turn of an element round the
period, from the deepest sample, is a piecewise linear map of its state there and of d. The state
must return to its initial value, and the forces on the way must carry the load (eq. 4). Newton's
method solves both equations, with exact tangents (quick/tangents.py). Displacements are never
positive, so samples above d do not touch, and an element crosses them with many steps at once.
The initial guess is the solution on every sixteenth sample, with steps sixteen times as long; the
guess of that solution comes from a still coarser line.
Eq. 4 alone is solved in model/contact.py, and in model/steady.py for elements that remember only u.

At given d, a turn contracts the state in its energy norm, and the force grows with d, so the
solution is unique. A Newton step that leads to no contact is halved. All loops are bounded, and
the remaining error is reported as the residual.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel
from ..model.contact import solve_indentation
from ..quick.tangents import carry_rows, powers_of_steps, tangents_of
from ..rheology.forms import Form
from ..rheology.law import Elements, law_of, memory_size, rest_memory
from ..rheology.lookahead import (
    BLOCK_SAMPLES,
    fill_memory,
    lookahead_law,
    lookahead_memory,
    slide_element,
)

MAX_TURNS = 60  # a few usually suffice
TARGET_RESIDUAL = 1e-13
COARSE_RESIDUAL = 1e-3  # target on a coarser line, which only gives a guess
ACCEPTED_RESIDUAL = 1e-6  # a larger residual raises an error
STIFFNESS_ROUNDING = 1e-13  # times the stiffness of a step: added to ACCEPTED_RESIDUAL
CHEAP_PRODUCTS = 8  # per sample; tangents that cost fewer are computed exactly in every turn
FILL_SAMPLES = 16  # samples for which the memory of one unit is filled at a time
SLIDE_SAMPLES = 64  # samples taken one by one before the next test for a gap
COARSENING, MIN_COARSE_SAMPLES = 16, 1000  # samples per coarse sample; least size of a coarse line


@dataclass(frozen=True)
class SteadyMemory:
    """A steady state of sliding of elements with internal variables."""

    p: np.ndarray  # forces at the samples of the line, after a step, shape (n,), in 4 G dx h
    d: float  # indentation, in h
    work: int  # updates of elements and of tangents
    residual: float  # relative residual of the equations
    form: Form
    speed: float  # in samples per tau, signed
    deepest: int  # index of the deepest sample
    before: np.ndarray  # shape (M,): lookahead memory of the element that leaves that sample

    @cached_property
    def elements(self) -> Elements:
        """The elements with their memory, which is computed on first use."""
        memory = _memory_of_forces(self.form, self.speed, self.before.copy(), self.p, self.deepest)
        return Elements(memory, self.p, self.d)


def steady_memory(
    form: Form, z: np.ndarray, speed: float, load: float, d: float = np.nan
) -> SteadyMemory:
    """Return the steady state of sliding under the load sum_i f_i = load.

    form : of the material (rheology/forms.py). z : heights of the line, shape (n,), in h.
    speed : in samples per tau, negative towards -x. d : indentation (in h) to keep if the load is
    NaN. Raises ValueError without convergence.
    """
    p, d, work, residual, deepest, before = _solve_grids(form, z, speed, load, d, MAX_TURNS)
    rounding = STIFFNESS_ROUNDING * law_of(form, 1.0 / abs(speed)).stiffness
    if not residual <= ACCEPTED_RESIDUAL + rounding:
        raise ValueError(
            f"speed = {speed:g} samples per tau: no steady state was found, "
            f"relative residual {residual:.1e}"
        )
    return SteadyMemory(p, d, work, residual, form, speed, deepest, before)


@kernel
def _solve_grids(form, z, speed, load, d, max_turns):
    """Solve on coarse to fine lines; return p, d, work, residual, deepest, before of SteadyMemory.

    Heights and d are taken relative to the deepest sample, so that indentations are exact to
    rounding.
    """
    count, n = memory_size(form), z.size
    deepest, direction = np.argmin(z), -1 if speed > 0.0 else 1
    stride = 1
    while n // (COARSENING * stride) >= MIN_COARSE_SAMPLES:
        stride *= COARSENING
    x, forces, updates, residual = np.zeros(count + 1), np.empty(0), 0, np.inf
    x[-1] = d - z[deepest]
    while stride > 0:
        line = heights_in_order(z, deepest, direction * stride, n // stride)
        line_load, law = load * line.size / n, lookahead_law(law_of(form, stride / abs(speed)))
        if not residual < 1.0:
            relaxed = np.array([x[-1]])
            if not np.isnan(load):
                relaxed[0], _ = solve_indentation(line, line_load, line_load / line.size)
            x[-1], relaxed[0] = relaxed[0], max(relaxed[0], 0.0)
            memory = np.ascontiguousarray(rest_memory(form, relaxed)[:, 0])
            _copy(lookahead_memory(law, memory, relaxed[0]), x)
        forces = np.empty(line.size)
        target = TARGET_RESIDUAL if stride == 1 else COARSE_RESIDUAL
        turns, residual = _solve_line(law, line, line_load, target, max_turns, x, forces)
        updates += turns * line.size * (count + 2)
        stride //= COARSENING
    cut = deepest if direction < 0 else n - 1 - deepest
    if direction < 0:
        p = np.concatenate((forces[:cut][::-1], forces[cut:][::-1]))
    else:
        p = np.concatenate((forces[cut:], forces[:cut]))
    return p, x[-1] + z[deepest], updates, residual, deepest, x[:-1].copy()


@refcount_free_kernel
def _copy(values, target):
    """Copy values to the beginning of an array; assignment to a slice compiles for a second."""
    for i in range(values.size):
        target[i] = values[i]


@kernel
def heights_in_order(z, deepest, stride, count):
    """Return ``count`` heights over the deepest sample, a stride apart; the last is its own: 0."""
    line, j = np.empty(count), (deepest - stride * count) % z.size
    for i in range(count):
        j += stride
        if j < 0 or j >= z.size:
            j %= z.size
        line[i] = z[j] - z[deepest]
    return line


@kernel
def _memory_of_forces(form, speed, y, p, deepest):
    """Return the memory (M, n) of elements under the forces p (n,). y : ``before``, changed."""
    law, direction = lookahead_law(law_of(form, 1.0 / abs(speed))), -1 if speed > 0.0 else 1
    n, memory, i, j = p.size, np.empty((y.size, p.size)), 0, deepest
    while i < n:
        j = (j + direction) % n
        count = min(FILL_SAMPLES, n - i, j + 1 if direction < 0 else n - j)
        fill_memory(law, y, p, memory, j, direction, count)
        i, j = i + count, j + direction * (count - 1)
    return memory


@kernel
def _solve_line(law, line, load, target, max_turns, x, forces):
    """Solve for x with Newton's method; return (turns, residual).

    After a step that reduces the residual tenfold, expensive tangents are not computed again but
    corrected by a rank-one update (C. G. Broyden, Math. Comp. 19 (1965) 577).
    x : state of the element before its turn, and d; overwritten by the best iterate. forces (n,) :
    filled with the forces of the best iterate. load : NaN if d is given.
    """
    size, best, previous, turns, exact, cheap = x.size, np.inf, 0.0, 0, False, False
    accepted = ACCEPTED_RESIDUAL + STIFFNESS_ROUNDING * law.stiffness
    powers, tangents = powers_of_steps(law, size + 1, line.size), np.empty((size, size + 1))
    trial, step, trial_forces = x.copy(), np.zeros(size), np.empty(line.size)
    while turns < max_turns:
        y = np.zeros(powers.product.shape[0])
        _copy(trial, y)
        turn_element(law, line, y, powers, trial_forces)
        y = y[: size + 1]
        turns += 1
        if y[-1] <= 0.0 and not np.isnan(load):
            step *= 0.5
            trial -= step
            previous = 0.0
            continue
        for k in range(size):
            y[k] -= trial[k]
        y[-1] -= load
        residual = _residual(y, trial, load)
        stalled = exact and best < accepted and not residual < 0.5 * best
        if residual < best:
            best = residual
            _copy(trial, x)
            _copy(trial_forces, forces)
        if stalled or residual < target:
            break
        exact = not residual < 0.1 * previous or cheap
        previous = residual
        if exact:
            tangents, stretches = tangents_of(powers, trial_forces)
            cheap = stretches * powers.product.size < CHEAP_PRODUCTS * line.size
        else:
            change = step / (step**2).sum()
            for k in range(size):
                for column in range(size + 1):
                    tangents[k, column] += change[k] * y[column]
        step = _newton_step(tangents, y)
        trial += step
    return turns, best


@kernel
def _residual(excess, x, load):
    """Return the larger of the relative residuals of the state and of the load."""
    largest = np.abs(x[:-1]).max()
    scale = max(largest, 1e-30 * max(largest, abs(x[-1])), 1e-300)
    state = np.abs(excess[:-1]).max() / scale
    return state if np.isnan(load) else max(state, abs(excess[-1]) / load)


@refcount_free_kernel
def turn_element(law, line, x, powers, forces):
    """Carry an element once round the line, from before its first height to after its last.

    line (n,) : heights. x (W,) : state of the element, d, and the sum of its forces; changed.
    powers : from powers_of_steps. forces (n,) : filled.
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
            stop = min(i + SLIDE_SAMPLES, line.size)
            total += slide_element(law, x[:count], d, line[i:stop], forces[i:stop])
        i = stop
    x[count + 1] = total


@kernel
def _newton_step(tangents, excess):
    """Return the Newton step, by elimination with pivots: the same bits on every machine.

    Where d is given instead of the load, the row of d keeps it constant.
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
    """Solve the equations a, shape (size, size + 1), by Gauss-Jordan elimination with pivots.

    The last column is the right-hand side and becomes the solution.
    """
    for k in range(a.shape[0]):
        pivot = k
        for i in range(k + 1, a.shape[0]):
            if abs(a[i, k]) > abs(a[pivot, k]):
                pivot = i
        for j in range(a.shape[1]):
            a[k, j], a[pivot, j] = a[pivot, j], a[k, j]
        diagonal = a[k, k]
        for j in range(a.shape[1]):
            a[k, j] /= diagonal
        for i in range(a.shape[0]):
            if i != k:
                factor = a[i, k]
                for j in range(a.shape[1]):
                    a[i, j] -= factor * a[k, j]
