"""The bounds of d and D that a march takes for granted: guessed, and checked at every step."""

from typing import NamedTuple

from kernels.active.setting import advance
from kernels.jit import kernel

LEAST_SPREAD = 1e-11  # of d: rounding stays far below it


class Bounds(NamedTuple):
    """Between which values d and D(t) = d(t) - E d(t - 1) are taken to stay, both in h."""

    low: float  # of d
    high: float
    least: float  # of D
    most: float


@kernel
def holds(bounds, d, push):
    """Return whether d and D, here ``push``, lie within the bounds; NaN does not."""
    return bounds.low < d < bounds.high and bounds.least < push < bounds.most


@kernel
def bounds_of(law, lowest, highest, least, most, margin):
    """Return the Bounds around values of d and of D, farther out by ``margin`` of their spread.

    D of any d that stays where it is, d / K, lies within them.
    """
    wide = margin * max(highest - lowest, LEAST_SPREAD * highest)
    low, high = max(lowest - wide, 0.0), highest + wide
    least, most = min(least, low / law.stiffness), max(most, high / law.stiffness)
    wide = margin * max(most - least, LEAST_SPREAD * highest)
    return Bounds(low, high, least - wide, most + wide)


@kernel
def first_bounds(setting, d, margin):
    """Return the Bounds of a whole march, of which the first step takes d to ``d`` or nearby."""
    one, two = setting.start.d, setting.end.d
    push = advance(setting.law, d, one)
    return bounds_of(setting.law, min(one, two, d), max(one, two, d), push, push, margin)


@kernel
def widened(law, bounds, d, push, margin):
    """Return Bounds that hold also d and D, here ``push``, as a march left them."""
    lowest, highest = min(bounds.low, d), max(bounds.high, d)
    least, most = min(bounds.least, push), max(bounds.most, push)
    return bounds_of(law, lowest, highest, least, most, margin)


@kernel
def first_indentation(setting, load):
    """Return d after the first step, were the same elements to touch as before it.

    For these, n of them, both steps balance the load: sum (d - z + (E / E_1) w) = load / K at
    v2, where sum (d_1 - z + w) = load / K_1 at v1.
    """
    z, (w, d) = setting.z, setting.start
    before, law = setting.before, setting.law
    w0 = w1 = w2 = w3 = 0.0
    n0 = n1 = n2 = n3 = 0.0
    whole = z.size - z.size % 4
    for j in range(0, whole, 4):
        t0, t1 = z[j] - w[j] < d, z[j + 1] - w[j + 1] < d
        t2, t3 = z[j + 2] - w[j + 2] < d, z[j + 3] - w[j + 3] < d
        w0 += w[j] if t0 else 0.0
        w1 += w[j + 1] if t1 else 0.0
        w2 += w[j + 2] if t2 else 0.0
        w3 += w[j + 3] if t3 else 0.0
        n0 += 1.0 if t0 else 0.0
        n1 += 1.0 if t1 else 0.0
        n2 += 1.0 if t2 else 0.0
        n3 += 1.0 if t3 else 0.0
    for j in range(whole, z.size):
        if z[j] - w[j] < d:
            w0 += w[j]
            n0 += 1.0
    free, touching = (w0 + w1) + (w2 + w3), (n0 + n1) + (n2 + n3)
    if touching == 0.0 or before.decay == 0.0:
        return d
    lost = (before.decay - law.decay) / before.decay
    return d + (load * (1.0 / law.stiffness - 1.0 / before.stiffness) + lost * free) / touching
