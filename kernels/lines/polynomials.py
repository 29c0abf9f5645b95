"""A line between its samples, by polynomials of fifth degree.

Interval j lies between the samples j and j + 1. In it the line is the polynomial that has the
height, slope and curvature of both: of a wave of eight samples, the shortest at m = 4, to 1e-5 of
its height. It is gone through as elements go, against the motion: t runs from 0 at sample j + 1 to
1 at sample j.
"""

import numpy as np

from ..compile.jit import borrowing, kernel


@kernel
def curvatures(z, slope, spacing):
    """Return z'' (in h/dx^2), shape (n,), of eighth order, from five heights and slopes each."""
    n = z.size
    found = np.empty(n)
    for j in range(n):  # below zero an index counts from the end, as the period does
        one, two = j + 1 - n, j + 2 - n
        rise = 64.0 / 27.0 * ((z[one] - z[j]) - (z[j] - z[j - 1]))
        rise += 7.0 / 54.0 * ((z[two] - z[j]) - (z[j] - z[j - 2]))
        turn = 8.0 / 9.0 * (slope[one] - slope[j - 1])
        turn += 1.0 / 36.0 * (slope[two] - slope[j - 2])
        found[j] = rise / spacing**2 - turn / spacing
    return found


@borrowing
def quintic(z, slope, curvature, h, j):
    """Return the six coefficients of the height in interval j, a polynomial in t. h : spacing."""
    k = j + 1 if j + 1 < z.size else 0
    rise, s, t = z[j] - z[k], -h * slope[k], -h * slope[j]
    b, c = 0.5 * h * h * curvature[k], 0.5 * h * h * curvature[j]
    p3 = 10.0 * rise - 6.0 * s - 4.0 * t - 3.0 * b + c
    p4 = -15.0 * rise + 8.0 * s + 7.0 * t + 3.0 * b - 2.0 * c
    p5 = 6.0 * rise - 3.0 * s - 3.0 * t - b + c
    return z[k], s, b, p3, p4, p5


@kernel
def bernstein(c):
    """Return six numbers between whose extremes the polynomial stays from t = 0 to 1."""
    c0, c1, c2, c3, c4, c5 = c
    return (
        c0,
        c0 + c1 / 5.0,
        c0 + 0.4 * c1 + c2 / 10.0,
        c0 + 0.6 * c1 + 0.3 * c2 + c3 / 10.0,
        c0 + 0.8 * c1 + 0.6 * c2 + 0.4 * c3 + c4 / 5.0,
        c0 + c1 + c2 + c3 + c4 + c5,
    )


@kernel
def height(c, t):
    """Return the value of a polynomial."""
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))))


@kernel
def steepness(c, t):
    """Return the derivative of a polynomial."""
    return c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * 5.0 * c[5])))
