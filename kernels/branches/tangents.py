"""What many steps do to tangents of an element, and with it a turn round the line.

While an element touches, or does not, a step does the same to all of them: many at once are a power
of it. What the element has forgotten is not carried further.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import borrowing, kernel
from ..rheology.law import predict, settle

RADIX = 8  # of the powers of a step that are kept
FORGOTTEN = 1e-13  # of what was remembered at first


class Powers(NamedTuple):
    """What steps do to tangents: of an element that is free (0) and of one that touches (1).

    Of 1 to RADIX - 1 steps, then of RADIX times as many, and so on. Rows and columns are as those
    of ``tangents_of``, and of the sum of forces.
    """

    of: np.ndarray  # shape (2, RADIX - 1 for every digit of the most steps, M + 2, M + 2)
    known: np.ndarray  # shape (2,): how many of them are known
    product: np.ndarray  # shape (M + 2, M + 2): overwritten


@kernel
def powers_of_steps(law, size, most):
    """Return Powers of the law, the first of them known, for at most so many steps.

    size : M + 2.
    """
    digits = 1
    while most >= RADIX:
        most //= RADIX
        digits += 1
    of = np.empty((2, digits * (RADIX - 1), size, size))
    for kind in range(2):
        memory, d, w, new = np.eye(size - 2, size), np.zeros(size), np.empty(size), np.zeros(size)
        d[-2] = 1.0
        predict(law, memory, new, w)
        if kind == 1:
            new = law.stiffness * (w + d)
        settle(law, memory, w, new, new)
        of[kind, 0, :, :-2], of[kind, 0, :, -2], of[kind, 0, :, -1] = memory.T, d, new
        of[kind, 0, -1, -1] += 1.0
    return Powers(of, np.ones(2, np.int64), np.empty((size, size)))


@kernel
def tangents_of(powers, forces):
    """Return the derivatives of what a turn round the line has made of x, shape (M + 1, M + 2).

    x : what is counted of the element, d, and the sum of the forces on it (steady_memory.py). A row
    is with respect to one of what is counted of the element at first, the last one to d.
    forces (n,) : on the way.
    """
    size = powers.product.shape[0]
    tangents, first, i = np.eye(size - 1, size), 0, 0
    while i < forces.size:
        touches, begun = forces[i] > 0.0, i
        while i < forces.size and (forces[i] > 0.0) == touches:
            i += 1
        carry_rows(powers, touches, i - begun, tangents[first:])
        if first == 0 and _forgotten(tangents[:-1, :-2]):
            tangents[:-1, :-2] = 0.0
            first = size - 2
    return tangents


@borrowing
def _forgotten(tangents):
    """Return whether none of them matters any more."""
    for row in tangents:
        for value in row:
            if abs(value) > FORGOTTEN:
                return False
    return True


@borrowing
def carry_rows(powers, touching, length, tangents):
    """Take rows of tangents (c, M + 2) over so many steps in which an element touches, or not."""
    kind, place = 1 if touching else 0, -1
    of, product = powers.of[kind], powers.product[: tangents.shape[0]]
    while length > 0:
        power = place + length % RADIX
        for k in range(powers.known[kind], power + 1):
            _multiply(of[k - 1], of[(k - 1) // (RADIX - 1) * (RADIX - 1)], of[k])
            powers.known[kind] = k + 1
        if power > place:
            _multiply(tangents, of[power], product)
            for r in range(product.shape[0]):
                for c in range(product.shape[1]):
                    tangents[r, c] = product[r, c]
        place += RADIX - 1
        length //= RADIX


@borrowing
def _multiply(rows, by, product):
    """Fill in the product of rows (c, M + 2) with a matrix."""
    count, size = rows.shape
    for r in range(count):
        for c in range(size):
            product[r, c] = 0.0
    fours = size // 4 * 4  # a sum would wait for itself, and row after row for it
    for j in range(0, fours, 4):
        some = by[j : j + 4]
        for r in range(count):
            row, first, second = product[r], rows[r, j], rows[r, j + 1]
            third, fourth = rows[r, j + 2], rows[r, j + 3]
            for c in range(size):
                row[c] += (first * some[0, c] + second * some[1, c]) + (
                    third * some[2, c] + fourth * some[3, c]
                )
    for j in range(fours, size):
        for r in range(count):
            row, value = product[r], rows[r, j]
            for c in range(size):
                row[c] += value * by[j, c]
