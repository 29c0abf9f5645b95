"""What many steps do to tangents of an element, and with it a turn round the line.

While an element touches, or does not, a step does the same to all of them: many at once are a power
of it. What the element has forgotten is not carried further.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel
from ..rheology.law import advance_memory, predict

RADIX = 32  # of the powers of a step that are kept
WIDE = 8  # what a loop over columns takes at once; they are filled up with zeros to a multiple
FORGOTTEN = 1e-13  # of what was remembered at first


class Powers(NamedTuple):
    """What steps do to tangents: of an element that is free (0) and of one that touches (1).

    Of 1 to RADIX - 1 steps, then of RADIX times as many, and so on. Rows and columns are as those
    of ``tangents_of``, of the sum of forces, and of nothing: W, a multiple of WIDE.
    """

    of: np.ndarray  # shape (2, RADIX - 1 for every digit of the most steps, W, W)
    alone: np.ndarray  # shape (2,): whether columns stay apart; every row is the diagonal then
    known: np.ndarray  # shape (2, so many): whether they are known
    product: np.ndarray  # shape (W, W): overwritten
    size: int  # M + 2


@kernel
def powers_of_steps(law, size, most):
    """Return Powers of the law, the first of them known, for at most so many steps.

    size : M + 2.
    """
    digits, wide = 1, -(-size // WIDE) * WIDE
    while most >= RADIX:
        most //= RADIX
        digits += 1
    of, alone = np.empty((2, digits * (RADIX - 1), wide, wide)), np.zeros(2, np.bool_)
    known = np.zeros(of.shape[:2], np.bool_)
    known[:, 0] = True
    for kind in range(2):
        memory, d, w, new = np.eye(size - 2, size), np.zeros(size), np.empty(size), np.zeros(size)
        d[-2] = 1.0
        predict(law, memory, new, w)
        if kind == 1:
            new = law.stiffness * (w + d)
        advance_memory(law, memory, w, new, new)
        step = of[kind, 0]
        step[:] = 0.0
        for r in range(size):
            step[r, : size - 2], step[r, size - 2], step[r, size - 1] = memory[:, r], d[r], new[r]
        step[size - 1, size - 1] += 1.0
        alone[kind] = _spread(step)
    return Powers(of, alone, known, np.empty((wide, wide)), size)


@refcount_free_kernel
def _spread(step):
    """Return whether a matrix is a diagonal, of which all its rows are then made."""
    for r in range(step.shape[0]):
        for c in range(step.shape[1]):
            if r != c and step[r, c] != 0.0:
                return False
    for r in range(step.shape[0]):
        for c in range(step.shape[1]):
            step[r, c] = step[c, c]
    return True


@kernel
def tangents_of(powers, forces):
    """Return the derivatives of what a turn round the line has made of x, shape (M + 1, M + 2).

    And the number of spells in which the element touched, or did not: each takes a product or more.
    x : what is counted of the element, d, and the sum of the forces on it (steady_memory.py). A row
    is with respect to one of what is counted of the element at first, the last one to d.
    forces (n,) : on the way.
    """
    size, first, i, spells = powers.size, 0, 0, 0
    tangents = np.eye(size - 1, powers.product.shape[0])
    while i < forces.size:
        touches, begun, spells = forces[i] > 0.0, i, spells + 1
        while i < forces.size and (forces[i] > 0.0) == touches:
            i += 1
        carry_rows(powers, touches, i - begun, tangents[first:])
        if first == 0 and _forgotten(tangents[:-1, : size - 2]):
            tangents[:-1, : size - 2] = 0.0
            first = size - 2
    return tangents[:, :size].copy(), spells


@refcount_free_kernel
def _forgotten(tangents):
    """Return whether none of them matters any more."""
    for row in tangents:
        for value in row:
            if abs(value) > FORGOTTEN:
                return False
    return True


@refcount_free_kernel
def carry_rows(powers, touching, length, tangents):
    """Take rows of tangents (c, W) over so many steps in which an element touches, or not."""
    kind, place = 1 if touching else 0, -1
    of, alone, product = powers.of[kind], powers.alone[kind], powers.product[: tangents.shape[0]]
    while length > 0:
        power = place + length % RADIX
        if power > place:
            while not powers.known[kind, power]:
                _next_power(of, alone, powers.known[kind], power)
            by = of[power]
            if not alone:
                _multiply(tangents, by, alone, product)
            for r in range(product.shape[0]):
                for c in range(product.shape[1]):
                    tangents[r, c] = tangents[r, c] * by[r, c] if alone else product[r, c]
        place += RADIX - 1
        length //= RADIX


@refcount_free_kernel
def _next_power(of, alone, known, power):
    """Fill in the first of the powers that lead to one: of half as many steps, or of one less."""
    before = other = power
    while not known[before]:
        power, times = before, before % (RADIX - 1) + 1
        before -= RADIX // 2 if times == 1 else times // 2 if times % 2 == 0 else 1
        other = before if times == 1 or times % 2 == 0 else power - times + 1
    _multiply(of[before], of[other], alone, of[power])
    known[power] = True


@refcount_free_kernel
def _multiply(rows, by, alone, product):
    """Fill in the product of rows (c, W) with a matrix, or a diagonal that all rows are."""
    count, wide = rows.shape
    if alone:
        for r in range(count):
            for c in range(wide):
                product[r, c] = rows[r, c] * by[r, c]
        return
    for r in range(count):
        for c in range(wide):
            product[r, c] = 0.0
    for j in range(0, wide, WIDE):
        some = by[j : j + WIDE]
        for r in range(count):
            row, factors = product[r], rows[r, j : j + WIDE]
            for c in range(wide):
                value = row[c]
                for i in range(WIDE):
                    value += factors[i] * some[i, c]
                row[c] = value
