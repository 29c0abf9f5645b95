"""Elastic contact of a rigid surface with a body whose stiffness is known for every mode.

Pressures p >= 0 with a given mean displace the body by u = -A p, where A is the inverse stiffness.
The gap g is zero where the body is pressed, and not negative elsewhere:

    g = gap + A p - d >= 0,    p >= 0,    p g = 0.

The solution minimizes p A p/2 + p gap. It is found by conjugate gradients as in Polonsky and Keer,
with changes that reduce the number of passes (applications of A) and make it nearly independent of
the grid:

- A trial step is first clipped at p = 0, and the remaining change of p is the direction. The exact
  step along it costs one pass, even where contact begins or ends.
- Residuals are preconditioned by a stencil of five samples on the contact, which approximates |q|.
- Without a start, the search begins with the contact of every second sample.

Few samples are in contact. They are listed with their values, so that a pass visits the whole map
only in transforms and once to displace the body and to find overlaps.

Source: I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999), doi:10.1016/S0043-1648(99)00113-1,
for a given mean pressure.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from .modal_operator import STENCIL_CENTRE, Operator

MAX_PASSES = 20_000
ZERO_PRESSURE = 1e-14  # over the mean pressure: smaller pressures become zero
MIN_TRIAL_RATIO, MAX_TRIAL_RATIO = 0.3, 3.0  # ratio of successive trial steps
MIN_STEP_RATIO = 0.01  # best over trial step: below it, directions restart
COARSE_TOLERANCE, MIN_COARSE_COLUMNS = 0.03, 32  # of cold starts
SCALE_PASSES = 4  # between two evaluations of the rms of A p
BLOCK = 128  # samples per search for overlaps
# Rows of the values listed for free samples: p, g minus its mean, the last change of p, the
# displacement by it, and the preconditioned residual.
PRESSURE, RESIDUAL, CHANGE, PUSH, CONDITIONED = range(5)


class ElasticContact(NamedTuple):
    """Solution of a contact, and its cost."""

    p: np.ndarray  # pressures, shape (rows, n)
    depth: np.ndarray  # A p, shape (rows, n), with mean zero
    d: float  # approach
    passes: int  # applications of A


def press(
    gap: np.ndarray,
    mean_pressure: float,
    operator: Operator,
    start: ElasticContact | None,
    tolerance: float,
    allowed: np.ndarray | None = None,
) -> ElasticContact:
    """Solve a contact; the unit of p is that of the stiffness times that of the gap.

    gap : height of the rigid surface over the body without pressure, shape (rows, n).
    mean_pressure : > 0. start : warm start with allowed pressures of the same mean and their A p,
    or None. tolerance : rms of g over the contact, relative to the rms of A p. allowed : mask of
    the samples whose p may be positive, or None for all. Raises ValueError if the search does not
    converge.
    """
    if start is None:
        start = _cold_start(gap, mean_pressure, operator, allowed)
    allowed = np.ones(gap.shape, np.bool_) if allowed is None else allowed
    p, height, passes = start.p.copy(), gap + start.depth, start.passes
    residual, change, pushed = operator.fields
    residual[:] = change[:] = 0.0
    values, free = operator.listed, operator.free
    touching, d = _list_contact(height, p, free, values)
    trial, product, step, scale = 1.0, 0.0, 0.0, 0.0
    while True:
        count = _displace(height, d, step, pushed, change, p, allowed, free, values, touching)
        least, first, second = _fill_residual(height, d, residual, free[:count], values, touching)
        shift = first / touching  # mean of g over the contact, due to rounding and clipping
        square, least = max(second / touching - shift**2, 0.0), least - shift
        if (passes - start.passes) % SCALE_PASSES == 0:
            scale = _mean_square(height, gap)
        if square <= tolerance**2 * scale and least >= -tolerance * np.sqrt(scale):
            return ElasticContact(p, np.subtract(height, gap, out=height), d + shift, passes)
        if passes >= MAX_PASSES:
            raise ValueError(f"no contact was found in {MAX_PASSES} passes")
        _condition(residual, free[:count], operator.stencil_scale, values)
        _conjugate(values[:, :count], product)
        _clip(values[:, :count], trial, mean_pressure * p.size, free, change)
        operator.displaced(change, pushed)
        passes += 1
        along, product, largest = _products(values[:, :count], free, pushed)
        best = -along / product if product > 0.0 else 0.0
        step = min(best, max(largest, 1.0)) if best > 0.0 else 1.0
        zero = ZERO_PRESSURE * mean_pressure
        touching, moved = _take_step(p, residual, change, values, free[:count], step, zero)
        d += shift + moved
        trial *= min(max(best, MIN_TRIAL_RATIO), MAX_TRIAL_RATIO)
        if best < MIN_STEP_RATIO:  # the directions have stalled: restart them
            trial, product = 1.0, 0.0


def _cold_start(
    gap: np.ndarray, mean_pressure: float, operator: Operator, allowed: np.ndarray | None
) -> ElasticContact:
    """Return initial pressures: those of every second sample, or a constant."""
    rows, n = gap.shape
    odd = n % 2 or (rows > 1 and rows % 2)
    if allowed is not None or n < 2 * MIN_COARSE_COLUMNS or odd:
        touching = np.ones(gap.shape, np.bool_) if allowed is None else allowed
        p = np.where(touching, mean_pressure * gap.size / np.count_nonzero(touching), 0.0)
        passes = 1
    else:
        coarse = np.ascontiguousarray(gap[::2, ::2])
        contact = press(coarse, mean_pressure, operator.coarse(), None, COARSE_TOLERANCE)
        p = np.repeat(np.repeat(contact.p, 2, axis=1), rows // coarse.shape[0], axis=0)
        passes = 1 + contact.passes * coarse.size // gap.size
    return ElasticContact(p, operator.displaced(p, np.empty_like(p)), 0.0, passes)


@kernel
def _mean_square(height, gap):
    """Return the mean square of the difference; four sums are faster than one."""
    heights, gaps = height.ravel(), gap.ravel()
    whole = gaps.size - gaps.size % 4
    a = b = c = e = 0.0
    for j in range(0, whole, 4):
        a += (heights[j] - gaps[j]) ** 2
        b += (heights[j + 1] - gaps[j + 1]) ** 2
        c += (heights[j + 2] - gaps[j + 2]) ** 2
        e += (heights[j + 3] - gaps[j + 3]) ** 2
    for j in range(whole, gaps.size):
        a += (heights[j] - gaps[j]) ** 2
    return (a + b + c + e) / gaps.size


@kernel
def _list_contact(height, p, free, values):
    """List the contact with its pressures; return (number of samples, mean of g + d there)."""
    heights, pressures = height.ravel(), p.ravel()
    total, count = 0.0, 0
    for j in range(pressures.size):
        if pressures[j] > 0.0:
            free[count], values[PRESSURE, count] = j, pressures[j]
            values[CHANGE, count] = values[PUSH, count] = 0.0
            total += heights[j]
            count += 1
    return count, total / count


@kernel
def _displace(height, d, step, pushed, change, p, allowed, free, values, count):
    """Displace the body by a step, and list the samples without pressure that it overlaps.

    height : gap + A p, in place. Return the number of listed samples; count : of the contact.
    """
    heights, pushes, changes, pressures = height.ravel(), pushed.ravel(), change.ravel(), p.ravel()
    open_to = allowed.ravel()
    for start in range(0, heights.size, BLOCK):
        stop, overlaps = min(start + BLOCK, heights.size), 0
        if step != 0.0:  # height already includes that of the start
            for j in range(start, stop):
                heights[j] += step * pushes[j]
        for j in range(start, stop):
            overlaps += 1 if heights[j] < d else 0
        if overlaps == 0:
            continue
        for j in range(start, stop):
            if heights[j] < d and pressures[j] == 0.0 and open_to[j]:
                free[count], values[PRESSURE, count] = j, 0.0
                values[CHANGE, count], values[PUSH, count] = changes[j], pushes[j]
                count += 1
    return count


@kernel
def _fill_residual(height, d, residual, free, values, touching):
    """Fill residual with g minus its mean over the free samples.

    touching : number of samples in contact, at the head of the list. Return (minimum of g outside
    the contact, sums of g and g^2 over it).
    """
    heights, residuals = height.ravel(), residual.ravel()
    least = first = second = outside = 0.0
    for i in range(free.size):
        g = values[RESIDUAL, i] = heights[free[i]] - d
        if i < touching:
            first += g
            second += g * g
        else:
            outside += g
            least = min(least, g)
    mean = (first + outside) / free.size
    for i in range(free.size):
        values[RESIDUAL, i] -= mean
        residuals[free[i]] = values[RESIDUAL, i]
    return least, first, second


@kernel
def _condition(residual, free, stencil_scale, values):
    """Apply the stencil to the residual and subtract its mean; zero p may only increase.

    At the ends of a row the stencil continues in the next: it need not be exact.
    """
    residuals, n = residual.ravel(), residual.shape[1]
    size, total = residuals.size, 0.0
    for i, j in enumerate(free):
        above, below = j - n if j >= n else j - n + size, j + n if j + n < size else j + n - size
        left, right = j - 1 if j > 0 else size - 1, j + 1 if j + 1 < size else 0
        sides = residuals[above] + residuals[below] + residuals[left] + residuals[right]
        values[CONDITIONED, i] = stencil_scale * (STENCIL_CENTRE * residuals[j] - sides)
        total += values[CONDITIONED, i]
    for i in range(free.size):
        values[CONDITIONED, i] -= total / free.size
        if values[CONDITIONED, i] > 0.0 and values[PRESSURE, i] == 0.0:
            values[CONDITIONED, i] = 0.0


@kernel
def _conjugate(values, product):
    """Set changes to the next direction of descent, conjugate to the last one.

    product : of the last change and its displacement, or 0 at a restart.
    """
    size = values.shape[1]
    share = total = along = 0.0
    if product > 0.0:
        for i in range(size):
            share += values[CONDITIONED, i] * values[PUSH, i]
        share /= product
    for i in range(size):
        values[CHANGE, i] = share * values[CHANGE, i] - values[CONDITIONED, i]
        total += values[CHANGE, i]
        along += values[CHANGE, i] * values[RESIDUAL, i]
    for i in range(size):
        if along >= 0.0:
            values[CHANGE, i] = -values[CONDITIONED, i]
        else:
            values[CHANGE, i] -= total / size


@kernel
def _clip(values, trial, force, free, change):
    """Fill change with a trial step that is clipped at p = 0 and keeps the sum of p, ``force``."""
    changes, total = change.ravel(), 0.0
    for i in range(values.shape[1]):
        values[CHANGE, i] = max(values[PRESSURE, i] + trial * values[CHANGE, i], 0.0)
        total += values[CHANGE, i]
    factor = force / total
    for i in range(values.shape[1]):
        values[CHANGE, i] = values[CHANGE, i] * factor - values[PRESSURE, i]
        changes[free[i]] = values[CHANGE, i]


@kernel
def _products(values, free, pushed):
    """Return (change times g, change times its displacement, largest step with p >= 0)."""
    pushes = pushed.ravel()
    along = product = 0.0
    largest = np.inf
    for i in range(values.shape[1]):
        change = values[CHANGE, i]
        values[PUSH, i] = pushes[free[i]]
        along += values[RESIDUAL, i] * change
        product += values[PUSH, i] * change
        if change < 0.0 and values[PRESSURE, i] < -largest * change:
            largest = -values[PRESSURE, i] / change
    return along, product, largest


@kernel
def _take_step(p, residual, change, values, free, step, zero):
    """Take a step in place, and move the samples with pressure to the head of the list.

    Return (their number, change of the mean of A p over them).
    """
    pressures, residuals, changes = p.ravel(), residual.ravel(), change.ravel()
    moved, count = 0.0, 0
    for i, j in enumerate(free):
        pressure = values[PRESSURE, i] + step * values[CHANGE, i]
        if pressure > zero:
            pressures[j] = values[PRESSURE, count] = pressure
            free[count] = j
            values[CHANGE, count], values[PUSH, count] = values[CHANGE, i], values[PUSH, i]
            moved += step * values[PUSH, i]
            count += 1
        else:
            pressures[j] = residuals[j] = changes[j] = 0.0
    return count, moved / count
