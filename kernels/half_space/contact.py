"""Elastic contact of a rigid surface with a body whose stiffness is known for every mode.

Pressures p >= 0 of a given mean displace the body by u = -A p, A the inverse stiffness; where it
is pressed it touches, elsewhere it does not reach the surface:

    g = gap + A p - d >= 0,    p >= 0,    p g = 0.

This is the least of p A p/2 + p gap. Conjugate directions lead there, as in Polonsky and Keer,
with two changes that halve the passes of the operator and make them few whatever the grid:

- A trial step is cut off at p = 0 first, and the change of p that is left is the direction:
  the step along it is exact, also where contact begins or ends, and costs one pass.
- Residuals are sharpened on the contact by a stencil of five samples, which is nearly as |q|.

Source: I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999), doi:10.1016/S0043-1648(99)00113-1,
with the mean pressure given.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel

MOST_PASSES = 20_000
CENTRE = 5.0  # of the stencil, whose neighbours are -1; by trial, for any load
NOTHING = 1e-14  # of the mean pressure
BOLDER, SHYER = 3.0, 0.3  # by how much the next trial step may differ from this one
STALE = 0.01  # of the trial step


class ElasticContact(NamedTuple):
    """A solution: pressures, how far they displace the body, and what it took."""

    p: np.ndarray  # shape of the gap
    depth: np.ndarray  # A p, of mean zero, the same shape
    d: float
    passes: int  # of the operator


class Operator(NamedTuple):
    """A over the modes, and room for transforms and for what a solution needs on its way."""

    compliance: np.ndarray  # shape (rows, n//2 + 1); 0 for the mean
    sharpening: float  # of the stencil: so that A and it are nearly inverse
    modes: np.ndarray  # complex
    fields: np.ndarray  # shape (3, rows, n)
    sharp: np.ndarray  # shape (rows n,)
    free: np.ndarray  # shape (rows n,), int64: samples whose p may change

    @classmethod
    def of(cls, stiffness: np.ndarray, n: int) -> "Operator":
        """Return the operator of a stiffness over the modes of maps (rows, n).

        Raises ValueError where it is not positive; that of the mean is not used.
        """
        inner = stiffness.ravel()[1:]
        if not np.all(inner > 0.0):
            raise ValueError("stiffness must be positive for every mode but the mean")
        compliance = np.zeros_like(stiffness)
        compliance.ravel()[1:] = 1.0 / inner
        return cls.inverse(compliance, n)

    @classmethod
    def inverse(cls, compliance: np.ndarray, n: int) -> "Operator":
        """Return the operator of a compliance over the modes, 0 for the mean."""
        rows = compliance.shape[0]
        quarter = max(1, n // 4)  # a wave of four samples: the stencil has CENTRE - 2 there
        sharpening = 1.0 / ((CENTRE - 2.0) * compliance[0, quarter])
        modes = np.empty(compliance.shape, complex)
        fields, sharp = np.empty((3, rows, n)), np.empty(rows * n)
        return cls(compliance, sharpening, modes, fields, sharp, np.empty(rows * n, np.int64))

    def displaced(self, p: np.ndarray, out: np.ndarray) -> np.ndarray:
        """Fill out, shape (rows, n), with A p."""
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
    """Solve the contact; p is in units of the stiffness times those of the gap.

    gap : height of the rigid surface over the body without pressure, shape (rows, n).
    mean_pressure : > 0. start : pressures of the same mean, where they are allowed, and A p of
    them; or None. tolerance : rms of g over the contact, relative to the rms of A p. allowed :
    where p may be positive, or None for everywhere. Raises ValueError where none is found.
    """
    allowed = np.ones(gap.shape, np.bool_) if allowed is None else allowed
    if start is None:
        p = np.where(allowed, mean_pressure * gap.size / np.count_nonzero(allowed), 0.0)
        start = ElasticContact(p, operator.displaced(p, np.empty_like(p)), float(gap.mean()), 1)
    p, depth, passes = start.p.copy(), start.depth.copy(), start.passes
    residual, change, pushed = operator.fields
    sharp, free = operator.sharp, operator.free
    change[:] = pushed[:] = 0.0
    # The same arrays, one sample after the other: what is free is found without a division.
    residuals, changes, pushes, pressures = (a.ravel() for a in (residual, change, pushed, p))
    d = start.d + _mean_gap(gap, depth, p, start.d)
    trial, product = 1.0, 0.0
    while True:
        count, least, first, second, touching, scale = _look(
            gap, depth, p, allowed, d, residual, change, free
        )
        shift = first / touching  # rounding, and what has been cut off: d is the mean of g + d
        square = max(second - first * shift, 0.0)
        limit = tolerance * np.sqrt(scale)
        if square <= limit**2 * touching and least >= shift - limit:
            return ElasticContact(p, depth, d + shift, passes)
        if passes >= MOST_PASSES:
            raise ValueError(f"no contact was found in {MOST_PASSES} passes")
        _sharpen(residual, p, free[:count], operator.sharpening, sharp)
        _turn(residuals, sharp, free[:count], changes, pushes, product)
        _cut(pressures, free[:count], changes, trial, mean_pressure)
        operator.displaced(change, pushed)
        passes += 1
        along, product, most = _products(residuals, changes, pushes, pressures, free[:count])
        best = -along / product if product > 0.0 else 0.0
        step = min(best, max(most, 1.0)) if best > 0.0 else 1.0
        nothing = NOTHING * mean_pressure
        d += shift + _go(pressures, depth.ravel(), changes, pushes, free[:count], step, nothing)
        trial *= min(max(best, SHYER), BOLDER)
        if best < STALE:  # directions that no longer lead on: begin them anew
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
def _look(gap, depth, p, allowed, d, residual, change, free):
    """Find where p may change, and g there, less its mean.

    residual and change become 0 elsewhere. Return (the number of these samples, the least g outside
    the contact, sums of g and g^2 over it, the number of samples in it, mean of depth^2).
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
def _sharpen(residual, p, free, sharpening, sharp):
    """Apply the stencil to the residual, and take its mean away; what is closed begins only."""
    rows, n = p.shape
    total = 0.0
    for i in range(free.size):
        y, x = free[i] // n, free[i] % n
        above, below = y - 1 if y > 0 else rows - 1, y + 1 if y + 1 < rows else 0
        left, right = x - 1 if x > 0 else n - 1, x + 1 if x + 1 < n else 0
        sides = residual[above, x] + residual[below, x] + residual[y, left] + residual[y, right]
        sharp[i] = sharpening * (CENTRE * residual[y, x] - sides)
        total += sharp[i]
    for i in range(free.size):
        sharp[i] -= total / free.size
        if sharp[i] > 0.0 and p[free[i] // n, free[i] % n] == 0.0:
            sharp[i] = 0.0


@kernel
def _turn(residual, sharp, free, change, pushed, product):
    """Make change the next direction: against the sharp residual, conjugate to the last one.

    product : of the last change with what it displaces, or 0 where there is none.
    """
    share = total = along = 0.0
    if product > 0.0:
        for i in range(free.size):
            share += sharp[i] * pushed[free[i]]
        share /= product
    for i, j in enumerate(free):
        change[j] = share * change[j] - sharp[i]
        total += change[j]
        along += change[j] * residual[j]
    for i, j in enumerate(free):
        change[j] = -sharp[i] if along >= 0.0 else change[j] - total / free.size


@kernel
def _cut(p, free, change, trial, mean_pressure):
    """Make change what is left of a trial step where p stays positive and keeps its mean."""
    total = 0.0
    for j in free:
        change[j] = max(p[j] + trial * change[j], 0.0)
        total += change[j]
    factor = mean_pressure * p.size / total
    for j in free:
        change[j] = change[j] * factor - p[j]


@kernel
def _products(residual, change, pushed, p, free):
    """Return change times g, change times what it displaces, and how far p stays positive."""
    along = product = 0.0
    most = np.inf
    for j in free:
        along += residual[j] * change[j]
        product += pushed[j] * change[j]
        if change[j] < 0.0 and p[j] < -most * change[j]:
            most = -p[j] / change[j]
    return along, product, most


@kernel
def _go(p, depth, change, pushed, free, step, nothing):
    """Go a step, in place; return by how much the mean of A p over the contact has moved."""
    moved = count = 0.0
    for j in range(depth.size):
        depth[j] += step * pushed[j]
    for j in free:
        pressure = p[j] + step * change[j]
        p[j] = pressure if pressure > nothing else 0.0
        if pressure > nothing:
            moved += step * pushed[j]
            count += 1.0
    return moved / count
