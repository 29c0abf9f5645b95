"""Elastic contact of a rigid surface with a body whose stiffness is known for every mode.

Pressures p >= 0 of a given mean displace the body by u = -A p, A the inverse stiffness; where it
is pressed it touches, elsewhere it does not reach the surface:

    g = gap + A p - d >= 0,    p >= 0,    p g = 0.

Conjugate gradients on the samples that touch, which are found on the way.
Source: I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999), doi:10.1016/S0043-1648(99)00113-1,
with the mean pressure given.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel

MOST_PASSES = 20_000


class ElasticContact(NamedTuple):
    """A solution: pressures, how far they displace the body, and what it took."""

    p: np.ndarray  # shape of the gap
    depth: np.ndarray  # A p, of mean zero, the same shape
    d: float
    passes: int  # of the operator


def compliance_of(stiffness: np.ndarray) -> np.ndarray:
    """Return A over the modes: 1/stiffness, and 0 for the mean, which is free."""
    compliance = np.zeros_like(stiffness)
    inner = stiffness.ravel()[1:]
    if not np.all(inner > 0.0):
        raise ValueError("stiffness must be positive for every mode but the mean")
    compliance.ravel()[1:] = 1.0 / inner
    return compliance


def solve_contact(
    gap: np.ndarray,
    mean_pressure: float,
    stiffness: np.ndarray,
    pressure0: np.ndarray | None,
    tolerance: float,
) -> tuple[np.ndarray, float, int]:
    """Return (p, d, passes): pressures, the distance of approach, and passes of the operator.

    gap : height of the rigid surface over the body without pressure, shape (rows, n).
    mean_pressure : > 0. stiffness : over the modes of a real transform, shape
    (rows, n//2 + 1); that of the mean is not used. pressure0 : where to start from, or None.
    tolerance : rms of g over the contact, relative to the rms of A p. p is in units of the
    stiffness times those of the gap. Raises ValueError where a stiffness is not positive.
    """
    found = press(gap, mean_pressure, compliance_of(stiffness), pressure0, tolerance)
    return found.p, found.d, found.passes


def press(
    gap: np.ndarray,
    mean_pressure: float,
    compliance: np.ndarray,
    pressure0: np.ndarray | None,
    tolerance: float,
    allowed: np.ndarray | None = None,
) -> ElasticContact:
    """Solve the contact, as solve_contact.

    compliance : A over the modes, 0 for the mean. allowed : where p may be positive, or None for
    everywhere.
    """
    allowed = np.ones(gap.shape, np.bool_) if allowed is None else allowed
    p = np.where(allowed, 1.0 if pressure0 is None else pressure0, 0.0)
    p *= mean_pressure / p.mean()
    depth = _displaced(p, compliance)
    passes, before, keep = 1, 1.0, 0.0
    t, d = np.zeros_like(p), float(np.mean(gap + depth))
    while True:
        d, square, count, scale = _measure(gap, depth, p, d)
        if square <= tolerance**2 * scale * count and _closed(gap, depth, p, allowed, d, scale):
            return ElasticContact(p, depth, d, passes)
        if passes >= MOST_PASSES:
            raise ValueError(f"no contact was found in {MOST_PASSES} passes")
        along = _turn(gap, depth, p, d, keep * square / before, t)
        before = square
        pushed = _displaced(t, compliance)
        passes += 1
        step = along / _curvature(pushed, t, p)
        changed, total = _advance(gap, depth, p, t, pushed, allowed, d, step)
        factor = mean_pressure * p.size / total
        p *= factor
        if changed:
            depth = _displaced(p, compliance)
            passes += 1
        else:
            depth *= factor
        keep = 0.0 if changed > 1 else 1.0


def _displaced(p: np.ndarray, compliance: np.ndarray) -> np.ndarray:
    """Return A p."""
    return np.fft.irfft2(np.fft.rfft2(p) * compliance, p.shape)


@kernel
def _measure(gap, depth, p, guess):
    """Return (d, sum of g^2 over the contact, number of samples in it, mean of depth^2)."""
    count = first = second = scale = 0.0
    for i in range(p.shape[0]):
        for j in range(p.shape[1]):
            scale += depth[i, j] * depth[i, j]
            if p[i, j] > 0.0:
                g = gap[i, j] + depth[i, j] - guess
                count += 1.0
                first += g
                second += g * g
    shift = first / count
    return guess + shift, max(second - first * shift, 0.0), count, scale / p.size


@kernel
def _closed(gap, depth, p, allowed, d, scale):
    """Return whether no sample that is free reaches into the surface, but for rounding."""
    least = -1e-12 * np.sqrt(scale)
    for i in range(p.shape[0]):
        for j in range(p.shape[1]):
            if p[i, j] == 0.0 and allowed[i, j] and gap[i, j] + depth[i, j] - d < least:
                return False
    return True


@kernel
def _turn(gap, depth, p, d, share, t):
    """Take the next direction of search, in place; return its product with g."""
    along = 0.0
    for i in range(p.shape[0]):
        for j in range(p.shape[1]):
            if p[i, j] > 0.0:
                g = gap[i, j] + depth[i, j] - d
                t[i, j] = g + share * t[i, j]
                along += g * t[i, j]
            else:
                t[i, j] = 0.0
    return along


@kernel
def _curvature(pushed, t, p):
    """Return the product of a direction with what it displaces, the mean over the contact apart."""
    count = mean = moved = product = 0.0
    for i in range(p.shape[0]):
        for j in range(p.shape[1]):
            if p[i, j] > 0.0:
                count += 1.0
                mean += pushed[i, j]
                moved += t[i, j]
                product += pushed[i, j] * t[i, j]
    return product - mean / count * moved


@kernel
def _advance(gap, depth, p, t, pushed, allowed, d, step):
    """Go a step, in place; return (0, 1, 2: pressures were free, cut off, begun; their sum)."""
    changed, total = 0, 0.0
    for i in range(p.shape[0]):
        for j in range(p.shape[1]):
            g = gap[i, j] + depth[i, j] - d
            depth[i, j] -= step * pushed[i, j]
            if p[i, j] > 0.0:
                p[i, j] -= step * t[i, j]
                if p[i, j] <= 0.0:
                    p[i, j] = 0.0
                    changed = max(changed, 1)
            elif g < 0.0 and allowed[i, j]:
                p[i, j] = -step * g
                changed = 2
            total += p[i, j]
    return changed, total
