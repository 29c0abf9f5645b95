"""Interpolation of a line between its samples by polynomials of degree seven.

Interval j lies between the samples j and j + 1. There the line is the polynomial that matches the
height and three derivatives at both samples. For a wave of eight samples, the shortest at m = 4,
its error is 1e-7 of the height. Elements traverse it against the motion: t runs from 0 at sample
j + 1 to 1 at sample j.
"""

import numpy as np

from ..compile.jit import inlined_kernel, kernel, refcount_free_kernel


@kernel
def sample_derivatives(z, slope, spacing):
    """Return the second and the third derivative (in h/dx^2 and h/dx^3), shape (2, n).

    Both are of eighth order, from five heights and slopes.
    """
    n = z.size
    derivatives = np.empty((2, n))
    for j in range(2, n - 2):  # without a branch, so that the loop vectorises
        fill_derivatives(z, slope, spacing, (j - 2, j - 1, j, j + 1, j + 2), derivatives)
    for j in range(-2, min(2, n - 2)):  # across the end of the period
        near = (j - 2) % n, (j - 1) % n, j % n, (j + 1) % n, (j + 2) % n
        fill_derivatives(z, slope, spacing, near, derivatives)
    return derivatives


@inlined_kernel
def fill_derivatives(z, slope, spacing, near, derivatives):
    """Fill the derivatives at the middle one of the five samples ``near``."""
    before, left, j, right, after = near
    rise = 64.0 / 27.0 * ((z[right] - z[j]) - (z[j] - z[left]))
    rise += 7.0 / 54.0 * ((z[after] - z[j]) - (z[j] - z[before]))
    turn = 8.0 / 9.0 * (slope[right] - slope[left])
    turn += 1.0 / 36.0 * (slope[after] - slope[before])
    derivatives[0, j] = rise / spacing**2 - turn / spacing
    odd = 88.0 / 9.0 * (z[right] - z[left]) + 31.0 / 144.0 * (z[after] - z[before])
    even = 15.0 * slope[j] + 8.0 / 3.0 * (slope[right] + slope[left])
    even += (slope[after] + slope[before]) / 24.0
    derivatives[1, j] = odd / spacing**3 - even / spacing**2


@refcount_free_kernel
def septic_coefficients(z, slope, bend, h, j):
    """Return the eight coefficients of the height in interval j, a polynomial in t.

    bend : from sample_derivatives. h : spacing.
    """
    return coefficients_between(z, slope, bend, h, j + 1 if j + 1 < z.size else 0, j)


@inlined_kernel
def coefficients_between(z, slope, bend, h, k, j):
    """Return septic_coefficients of the interval from sample j to k: j + 1, or 0 for the last."""
    s, c, e = -h * slope[k], 0.5 * h * h * bend[0, k], -h * h * h / 6.0 * bend[1, k]
    # Remainders at t = 1 of the height and of its first three derivatives, divided by 1, 2 and 6.
    rise = z[j] - z[k] - s - c - e
    steep = -h * slope[j] - s - 2.0 * c - 3.0 * e
    curved = 0.5 * h * h * bend[0, j] - c - 3.0 * e
    third = -h * h * h / 6.0 * bend[1, j] - e
    return (
        z[k],
        s,
        c,
        e,
        35.0 * rise - 15.0 * steep + 5.0 * curved - third,
        -84.0 * rise + 39.0 * steep - 14.0 * curved + 3.0 * third,
        70.0 * rise - 34.0 * steep + 13.0 * curved - 3.0 * third,
        -20.0 * rise + 10.0 * steep - 4.0 * curved + third,
    )


@inlined_kernel
def bernstein_coefficients(c):
    """Return the eight Bernstein coefficients, whose extremes bound the polynomial on [0, 1]."""
    c0, c1, c2, c3, c4, c5, c6, c7 = c
    # Bernstein coefficients are sums of the coefficients divided by binomial ones.
    c1, c2, c3, c4 = c1 * (1.0 / 7.0), c2 * (1.0 / 21.0), c3 * (1.0 / 35.0), c4 * (1.0 / 35.0)
    c5, c6 = c5 * (1.0 / 21.0), c6 * (1.0 / 7.0)
    return (
        c0,
        c0 + c1,
        c0 + 2.0 * c1 + c2,
        c0 + 3.0 * (c1 + c2) + c3,
        c0 + 4.0 * (c1 + c3) + 6.0 * c2 + c4,
        c0 + 5.0 * (c1 + c4) + 10.0 * (c2 + c3) + c5,
        c0 + 6.0 * (c1 + c5) + 15.0 * (c2 + c4) + 20.0 * c3 + c6,
        c0 + 7.0 * (c1 + c6) + 21.0 * (c2 + c5) + 35.0 * (c3 + c4) + c7,
    )


@kernel
def septic_height(c, t):
    """Return the value of a polynomial, by G. Estrin's scheme with its short dependency chains."""
    square = t * t
    low = (c[0] + t * c[1]) + square * (c[2] + t * c[3])
    return low + square * square * ((c[4] + t * c[5]) + square * (c[6] + t * c[7]))


@kernel
def septic_slope(c, t):
    """Return the derivative of a polynomial."""
    square = t * t
    low = (c[1] + t * (2.0 * c[2])) + square * (3.0 * c[3] + t * (4.0 * c[4]))
    high = (5.0 * c[5] + t * (6.0 * c[6])) + square * (7.0 * c[7])
    return low + square * square * high


@kernel
def bending(c, t):
    """Return the second derivative of a polynomial."""
    square = t * t
    low = (2.0 * c[2] + t * (6.0 * c[3])) + square * (12.0 * c[4] + t * (20.0 * c[5]))
    return low + square * square * (30.0 * c[6] + t * (42.0 * c[7]))
