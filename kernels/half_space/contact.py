"""Elastic contact of a rigid surface with a body whose stiffness is known for every mode.

Pressures p >= 0 with a given mean displace the body by u = -A p, where A is the inverse stiffness.
The gap g is zero where the body is pressed, and not negative elsewhere:

    g = gap + A p - d >= 0,    p >= 0,    p g = 0.

The solution minimizes p A p/2 + p gap. It is found by conjugate gradients as in Polonsky and Keer,
with two changes that halve the number of passes (applications of A) and make it nearly independent
of the grid:

- A trial step is first clipped at p = 0, and the remaining change of p is the direction. The exact
  step along it costs one pass, even where contact begins or ends.
- Residuals are preconditioned by a stencil of five samples on the contact, which approximates |q|.

Source: I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999), doi:10.1016/S0043-1648(99)00113-1,
for a given mean pressure.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel

MAX_PASSES = 20_000
STENCIL_CENTRE = 5.0  # the neighbours are -1; found by trial, for any load
ZERO_PRESSURE = 1e-14  # set to zero up to this share of the mean pressure
MIN_TRIAL_RATIO, MAX_TRIAL_RATIO = 0.3, 3.0  # ratio of successive trial steps
MIN_STEP_RATIO = 0.01  # of the best step to the trial step; below it directions restart


class ElasticContact(NamedTuple):
    """Solution of a contact, and its cost."""

    p: np.ndarray  # pressures, shape (rows, n)
    depth: np.ndarray  # A p, shape (rows, n), with mean zero
    d: float  # approach
    passes: int  # applications of A


class Operator(NamedTuple):
    """The compliance A of every mode, and workspace for transforms and for a solution."""

    compliance: np.ndarray  # shape (rows, n//2 + 1); 0 for the mean
    stencil_scale: float  # makes the stencil nearly the inverse of A
    modes: np.ndarray  # complex
    fields: np.ndarray  # shape (3, rows, n)
    preconditioned: np.ndarray  # shape (rows n,)
    free: np.ndarray  # shape (rows n,), int64: indices of samples whose p may change

    @classmethod
    def of(cls, stiffness: np.ndarray, n: int) -> "Operator":
        """Return the operator for the stiffness of every mode of maps (rows, n).

        The stiffness of the mean is not used. Raises ValueError unless all others are positive.
        """
        inner = stiffness.ravel()[1:]
        if not np.all(inner > 0.0):
            raise ValueError("stiffness must be positive for every mode but the mean")
        compliance = np.zeros_like(stiffness)
        compliance.ravel()[1:] = 1.0 / inner
        return cls.inverse(compliance, n)

    @classmethod
    def inverse(cls, compliance: np.ndarray, n: int) -> "Operator":
        """Return the operator for the compliance of every mode; 0 for the mean."""
        rows = compliance.shape[0]
        quarter = max(1, n // 4)  # for a wave of four samples the stencil is STENCIL_CENTRE - 2
        scale = 1.0 / ((STENCIL_CENTRE - 2.0) * compliance[0, quarter])
        modes = np.empty(compliance.shape, complex)
        fields, preconditioned = np.empty((3, rows, n)), np.empty(rows * n)
        free = np.empty(rows * n, np.int64)
        return cls(compliance, scale, modes, fields, preconditioned, free)

    def displaced(self, p: np.ndarray, out: np.ndarray) -> np.ndarray:
        """Fill out, shape (rows, n), with A p, and return it."""
        np.fft.rfft(p, axis=1, out=self.modes)
        if p.shape[0] > 1:
            np.fft.fft(self.modes, axis=0, out=self.modes)
        np.multiply(self.modes, self.compliance, out=self.modes)
        if p.shape[0] > 1:
            np.fft.ifft(self.modes, axis=0, out=self.modes)
        return np.fft.irfft(self.modes, p.shape[1], axis=1, out=out)


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
    allowed = np.ones(gap.shape, np.bool_) if allowed is None else allowed
    if start is None:
        p = np.where(allowed, mean_pressure * gap.size / np.count_nonzero(allowed), 0.0)
        start = ElasticContact(p, operator.displaced(p, np.empty_like(p)), float(gap.mean()), 1)
    p, depth, passes = start.p.copy(), start.depth.copy(), start.passes
    residual, change, pushed = operator.fields
    preconditioned, free = operator.preconditioned, operator.free
    change[:] = pushed[:] = 0.0
    # Flat views of the same arrays: indices of free samples need no division.
    residuals, changes, pushes, pressures = (a.ravel() for a in (residual, change, pushed, p))
    d = start.d + _mean_gap(gap, depth, p, start.d)
    trial, product = 1.0, 0.0
    while True:
        count, least, first, second, touching, scale = _find_free(
            gap, depth, p, allowed, d, residual, change, free
        )
        shift = first / touching  # mean of g over the contact, due to rounding and clipping
        square = max(second - first * shift, 0.0)
        limit = tolerance * np.sqrt(scale)
        if square <= limit**2 * touching and least >= shift - limit:
            return ElasticContact(p, depth, d + shift, passes)
        if passes >= MAX_PASSES:
            raise ValueError(f"no contact was found in {MAX_PASSES} passes")
        _precondition(residual, p, free[:count], operator.stencil_scale, preconditioned)
        _conjugate(residuals, preconditioned, free[:count], changes, pushes, product)
        _clip(pressures, free[:count], changes, trial, mean_pressure)
        operator.displaced(change, pushed)
        passes += 1
        along, product, largest = _products(residuals, changes, pushes, pressures, free[:count])
        best = -along / product if product > 0.0 else 0.0
        step = min(best, max(largest, 1.0)) if best > 0.0 else 1.0
        zero = ZERO_PRESSURE * mean_pressure
        d += shift + _take_step(pressures, depth.ravel(), changes, pushes, free[:count], step, zero)
        trial *= min(max(best, MIN_TRIAL_RATIO), MAX_TRIAL_RATIO)
        if best < MIN_STEP_RATIO:  # the directions have stalled: restart them
            trial, product = 1.0, 0.0


@kernel
def _mean_gap(gap, depth, p, d):
    """Return the mean of g over the contact."""
    total = count = 0.0
    for y in range(p.shape[0]):
        for x in range(p.shape[1]):
            if p[y, x] > 0.0:
                total += gap[y, x] + depth[y, x] - d
                count += 1.0
    return total / count


@kernel
def _find_free(gap, depth, p, allowed, d, residual, change, free):
    """Find the free samples, whose p may change, and fill residual with g minus its mean there.

    residual and change are set to 0 elsewhere. Return (number of free samples, minimum of 0 and of
    g outside the contact, sums of g and g^2 over it, number of samples in it, mean of depth^2).
    """
    rows, n = p.shape
    count = touching = 0
    least = first = second = scale = total = 0.0
    for y in range(rows):
        for x in range(n):
            g = gap[y, x] + depth[y, x] - d
            scale += depth[y, x] * depth[y, x]
            residual[y, x] = 0.0
            if p[y, x] > 0.0:
                touching += 1
                first += g
                second += g * g
            elif g < 0.0 and allowed[y, x]:
                least = min(least, g)
            else:
                change[y, x] = 0.0
                continue
            residual[y, x] = g
            total += g
            free[count] = y * n + x
            count += 1
    mean = total / count
    for i in range(count):
        residual[free[i] // n, free[i] % n] -= mean
    return count, least, first, second, touching, scale / p.size


@kernel
def _precondition(residual, p, free, stencil_scale, preconditioned):
    """Apply the stencil to the residual and subtract the mean; p = 0 may only increase."""
    rows, n = p.shape
    total = 0.0
    for i in range(free.size):
        y, x = free[i] // n, free[i] % n
        above, below = y - 1 if y > 0 else rows - 1, y + 1 if y + 1 < rows else 0
        left, right = x - 1 if x > 0 else n - 1, x + 1 if x + 1 < n else 0
        sides = residual[above, x] + residual[below, x] + residual[y, left] + residual[y, right]
        preconditioned[i] = stencil_scale * (STENCIL_CENTRE * residual[y, x] - sides)
        total += preconditioned[i]
    for i in range(free.size):
        preconditioned[i] -= total / free.size
        if preconditioned[i] > 0.0 and p[free[i] // n, free[i] % n] == 0.0:
            preconditioned[i] = 0.0


@kernel
def _conjugate(residual, preconditioned, free, change, pushed, product):
    """Set change to the next search direction, conjugate to the last one.

    product : last change times its displacement, or 0 at a restart.
    """
    share = total = along = 0.0
    if product > 0.0:
        for i in range(free.size):
            share += preconditioned[i] * pushed[free[i]]
        share /= product
    for i, j in enumerate(free):
        change[j] = share * change[j] - preconditioned[i]
        total += change[j]
        along += change[j] * residual[j]
    for i, j in enumerate(free):
        change[j] = -preconditioned[i] if along >= 0.0 else change[j] - total / free.size


@kernel
def _clip(p, free, change, trial, mean_pressure):
    """Replace change by a trial step that is clipped at p = 0 and keeps the mean of p."""
    total = 0.0
    for j in free:
        change[j] = max(p[j] + trial * change[j], 0.0)
        total += change[j]
    factor = mean_pressure * p.size / total
    for j in free:
        change[j] = change[j] * factor - p[j]


@kernel
def _products(residual, change, pushed, p, free):
    """Return (change times residual, change times its displacement, largest step with p >= 0)."""
    along = product = 0.0
    largest = np.inf
    for j in free:
        along += residual[j] * change[j]
        product += pushed[j] * change[j]
        if change[j] < 0.0 and p[j] < -largest * change[j]:
            largest = -p[j] / change[j]
    return along, product, largest


@kernel
def _take_step(p, depth, change, pushed, free, step, zero):
    """Take a step in place; return the mean change of A p over the contact."""
    moved = count = 0.0
    for j in range(depth.size):
        depth[j] += step * pushed[j]
    for j in free:
        pressure = p[j] + step * change[j]
        p[j] = pressure if pressure > zero else 0.0
        if pressure > zero:
            moved += step * pushed[j]
            count += 1.0
    return moved / count
