"""Kelvin elements, contact and the balance of forces, written as in the paper, without rounding.

All numbers have one type: ``fractions.Fraction`` for implicit Euler, which is rational, or
``decimal.Decimal`` with many digits for the exponential scheme. Units are those of
kernels/__init__.py. The line moves towards +x by one sample per step: the element under sample
j + 1 comes under sample j.
"""

from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import NamedTuple


class ImplicitEuler(NamedTuple):
    """f = -(u + du/dt) at the end of a step (eq. 2, G = tau = 1), du/dt averaged over the step."""

    dt: Fraction
    lag = 0

    def force(self, new, old):
        """Return the force that moves the displacement from old to new."""
        return -(new + (new - old) / self.dt)

    def free(self, old):
        """Return the displacement after a step without force: force(new, old) = 0."""
        return old / (1 + self.dt)


@lru_cache
def _decay(dt):
    return (-dt).exp()


class Exponential(NamedTuple):
    """u + du/dt = -f solved exactly for a force that is constant over the step."""

    dt: Decimal

    @property
    def lag(self):
        """Return the mean time before the end of the step with weight e^-time, in steps."""
        decay = _decay(self.dt)
        return (1 - decay * (1 + self.dt)) / (1 - decay) / self.dt

    def force(self, new, old):
        """Return the force that moves the displacement from old to new."""
        decay = _decay(self.dt)
        return (old * decay - new) / (1 - decay)

    def free(self, old):
        """Return the displacement after a step without force."""
        return old * _decay(self.dt)


def root_of_lines(zeros, slopes, load):
    """Return d with sum_i slope_i max(0, d - zero_i) = load.

    Without max, a sum over any subset of i is not larger, and it is equal for those with
    zero_i < d. So d is the smallest of the roots for the k lowest zeros, k = 1, 2, ...
    """
    lowest = sorted(zip(zeros, slopes, strict=True))
    subsets = (lowest[: count + 1] for count in range(len(lowest)))
    return min((load + sum(z * s for z, s in some)) / sum(s for _, s in some) for some in subsets)


def contact_step(scheme, z, old, load):
    """Return (u, f, d) after a step: f >= 0 and u <= z - d with one of them equal, sum f = load.

    z : heights over the elements after the step. The force at u = z - d is linear in d.
    """
    at_0 = [scheme.force(h, u) for h, u in zip(z, old, strict=True)]
    slopes = [scheme.force(h - 1, u) - f for h, u, f in zip(z, old, at_0, strict=True)]
    d = root_of_lines([-f / s for f, s in zip(at_0, slopes, strict=True)], slopes, load)
    u = [min(scheme.free(o), h - d) for h, o in zip(z, old, strict=True)]
    f = [scheme.force(new, o) for new, o in zip(u, old, strict=True)]
    return u, f, d


class Steady(NamedTuple):
    """Steady sliding at constant d; one entry per sample."""

    u: list  # displacement
    f: list  # force
    w: list  # free displacement
    d: object


def steady(scheme, z, load):
    """Return the steady state by trying all sets of touching samples; exactly one must fit."""
    actual = [
        _steady_with(scheme, z, load, touching) for touching in product((0, 1), repeat=len(z))
    ]
    fitting = [state for state in actual if state is not None]
    assert len(fitting) == 1, "the steady state must be unique"
    return fitting[0]


def _steady_with(scheme, z, load, touching):
    """Return the steady state with these touching samples, or None for tension or penetration."""
    if not any(touching):
        return None
    n = len(z)
    total = []  # sums of forces at d = 0 and d = 1; they are linear in d
    for d in (0 * load, 1 + 0 * load):
        u = _carried(scheme, z, d, touching)
        total.append(sum(scheme.force(u[j], u[(j + 1) % n]) for j in range(n)))
    if total[0] == total[1]:
        return None
    d = (load - total[0]) / (total[1] - total[0])
    u = _carried(scheme, z, d, touching)
    w = [scheme.free(u[(j + 1) % n]) for j in range(n)]
    for j in range(n):
        if (w[j] <= z[j] - d) if touching[j] else (u[j] > z[j] - d):
            return None
    return Steady(u, [scheme.force(u[j], u[(j + 1) % n]) for j in range(n)], w, d)


def _carried(scheme, z, d, touching):
    """Return u at the samples: z - d in contact, else that from upstream after a free step."""
    n = len(z)
    last = touching.index(1)
    u = [None] * n
    for step in range(n):
        j = (last - step) % n
        u[j] = z[j] - d if touching[j] else scheme.free(u[(j + 1) % n])
    return u


def step_friction(scheme, f, slope, moved):
    """Return mu over a step (eq. 5); element i ends under sample i - moved, slopes lag."""
    n = len(f)
    under = [(i - moved) % n for i in range(n)]
    lever = [(1 - scheme.lag) * slope[j] + scheme.lag * slope[(j + 1) % n] for j in under]
    return sum(a * b for a, b in zip(f, lever, strict=True)) / sum(f)


def relaxation(scheme, z, slope, start, load, steps):
    """Return [(mu, d)] after each step from the steady state ``start``."""
    n = len(z)
    u = start.u
    rows = []
    for step in range(1, steps + 1):
        u, f, d = contact_step(scheme, [z[(i - step) % n] for i in range(n)], u, load)
        rows.append((step_friction(scheme, f, slope, step), d))
    return rows


def _edges(z, slope, state, formed):
    """Return {touching sample: [distance to trailing edge, distance to leading edge]}, in samples.

    The leading edge is where d equals the free height, the trailing edge where the steady pressure
    vanishes, both by linear interpolation; inside a contact the distances are half a sample.
    """
    n = len(z)
    half = (1 + 0 * state.d) / 2
    free = [z[j] - state.w[j] for j in range(n)]
    pressure = [state.d - z[j] + formed * slope[j] for j in range(n)]
    reaches = {j: [half, half] for j in range(n) if free[j] < state.d}
    for j, reach in reaches.items():
        ahead, behind = (j + 1) % n, (j - 1) % n
        if ahead not in reaches:
            reach[1] = (state.d - free[j]) / (free[ahead] - free[j])
        if behind not in reaches and pressure[j] > pressure[behind]:
            reach[0] = min(max(pressure[j] / (pressure[j] - pressure[behind]), -half), 3 * half)
    return reaches


def friction_at_once(z, slope, state, formed, speed, load):
    """Return (mu, d') by eqs 5 and 4 at an instant. state : of steady sliding at speed ``formed``.

    p = d - z + speed z' + d' at the touching samples, each weighted by its length in contact.
    """
    reaches = _edges(z, slope, state, formed)
    weights = [max(sum(reach), (1 + 0 * load) / 100) for reach in reaches.values()]
    pressure = [state.d - z[j] + speed * slope[j] for j in reaches]
    rate = root_of_lines([-p for p in pressure], weights, load)
    forces = [w * max(0, p + rate) for w, p in zip(weights, pressure, strict=True)]
    return sum(f * slope[j] for f, j in zip(forces, reaches, strict=True)) / sum(forces), rate


def elastic_correction(z, slope, state, speed, rate, steps):
    """Return -steps [(d + d' - z)^2 / 2] minus the elastic part of the sum of eq. 5, over cells."""
    reaches, n = _edges(z, slope, state, speed), len(z)
    half, missing = (1 + 0 * rate) / 2, 0 * rate
    for j, (back, upto) in reaches.items():
        if (j - 1) % n not in reaches and back in (-half, 3 * half):
            continue
        ends = [z[j] + back * (z[j - 1] - z[j]), z[j] + upto * (z[(j + 1) % n] - z[j])]
        before, after = ((state.d + rate - end) ** 2 / 2 for end in ends)
        missing += steps * (before - after)
        covered = max(back + upto, half / 50)
        pressure = state.d + rate - z[j] + speed * slope[j]
        missing += covered * (speed * slope[j] - max(0, pressure)) * slope[j]
    return missing
