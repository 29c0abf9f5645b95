"""Analytic references in the units of kernels/__init__.py (h, dx, tau).

In contact the pressure is p = d - z + vbar z' + d' (eq. 3 of Li et al. 2014, including the
indentation rate d'), mean(p) = Fbar (eq. 4) and mu = sum(p z') / sum(p) (eq. 5).
"""

import numpy as np
from scipy.optimize import brentq


def sorted_root(thresholds, target: float) -> float:
    """Return d with sum max(0, d - c_i) = target, from the sorted thresholds c_i.

    Source: if the k lowest elements touch, d_k = (target + c_1 + ... + c_k) / k; the solution has
    the largest k with d_k > c_k. Sums are relative to c_1, so that high lines lose no digits.
    """
    c = np.sort(thresholds)
    height = c - c[0]
    d = (target + np.cumsum(height)) / np.arange(1.0, c.size + 1)
    return float(c[0] + d[np.flatnonzero(d > height)[-1]])


def parabola_edges(d: float, radius: float, speed: float) -> tuple[float, float]:
    """Return the trailing and the leading edge of the contact with z = x^2 / (2 R).

    Source: p = 0 at the trailing edge gives v tau - ((v tau)^2 + 2 R d)^(1/2); at the leading
    edge the line meets the undeformed elastomer, and z = d gives (2 R d)^(1/2).
    """
    return speed - np.sqrt(speed**2 + 2.0 * radius * d), np.sqrt(2.0 * radius * d)


def parabola_forces(d: float, radius: float, speed: float, edges=None) -> tuple[float, float]:
    """Return int p dx (h dx) and int p z' dx (h^2) of the parabola. edges : by default steady.

    Source: eqs 4 and 5 with p = d - x^2/2R + v tau x/R, integrated between the edges.
    """
    trailing, leading = parabola_edges(d, radius, speed) if edges is None else edges

    def normal(x):
        return d * x - x**3 / (6.0 * radius) + speed * x**2 / (2.0 * radius)

    def tangential(x):
        elastic = d * x**2 / (2.0 * radius) - x**4 / (8.0 * radius**2)
        return elastic + speed * x**3 / (3.0 * radius**2)

    return normal(leading) - normal(trailing), tangential(leading) - tangential(trailing)


def parabola_jump(d: float, radius: float, speed: float, ratio: float) -> float:
    """Return the jump of mu on the parabola.

    Source: displacements do not change; p = (d + d') - x^2/2R + r v tau x/R in the old contact
    where p > 0, with d' from eq. 4. Only a higher speed moves the trailing edge.
    """
    load, before = parabola_forces(d, radius, speed)
    trailing, leading = parabola_edges(d, radius, speed)

    def after(rate):
        lost, _ = parabola_edges(d + rate, radius, ratio * speed)
        return parabola_forces(d + rate, radius, ratio * speed, (max(trailing, lost), leading))

    rate = brentq(lambda rate: after(rate)[0] - load, -0.9 * d, d, xtol=1e-14)
    return (after(rate)[1] - before) / load


def slow_sliding(z, slope, load: float) -> float:
    """Return mu / vbar for v -> 0, load = Fbar.

    Source: eq. 4 becomes mean (d - z)+ = Fbar; in eq. 5 the elastic part integrates to zero over
    every contact, and mu = vbar mean(z'^2 in contact) / Fbar remains.
    """
    d = sorted_root(z, load * z.size)
    return float(np.sum(slope[z < d] ** 2)) / (load * z.size)
