"""Tangents of an element over many steps, as powers of the matrix of one step.

As long as an element stays in contact, or stays free, every step multiplies its tangents by the
same matrix, and n steps multiply them by its nth power. Negligible tangents are set to zero.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel
from ..rheology.law import advance_memory, predict

RADIX = 32  # base of the digits of a number of steps; a power is stored for each digit
LANES = 8  # columns that a loop processes at once; rows are padded with zeros to a multiple
DECAYED_TANGENT = 1e-13  # relative to the initial tangent


class Powers(NamedTuple):
    """Powers of the step matrices of an element that is free (0) and of one that touches (1).

    Stored are the powers 1 to RADIX - 1, then RADIX times these, and so on. Rows and columns are
    the M state variables, d and the sum of forces, padded to W, a multiple of LANES.
    """

    of: np.ndarray  # shape (2, (RADIX - 1) times the digits of the largest power, W, W)
    diagonal: np.ndarray  # shape (2,): whether a matrix is diagonal, with its diagonal in each row
    known: np.ndarray  # shape (2, powers): whether a power has been computed
    product: np.ndarray  # shape (W, W): work space
    size: int  # M + 2


@kernel
def powers_of_steps(law, size, max_steps):
    """Return the Powers of a law for up to ``max_steps`` steps; the first power is known.

    size : M + 2.
    """
    digits, width = 1, -(-size // LANES) * LANES
    while max_steps >= RADIX:
        max_steps //= RADIX
        digits += 1
    of, diagonal = np.empty((2, digits * (RADIX - 1), width, width)), np.zeros(2, np.bool_)
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
            for c in range(size - 2):
                step[r, c] = memory[c, r]
            step[r, size - 2], step[r, size - 1] = d[r], new[r]
        step[size - 1, size - 1] += 1.0
        diagonal[kind] = _spread_diagonal(step)
    return Powers(of, diagonal, known, np.empty((width, width)), size)


@refcount_free_kernel
def _spread_diagonal(step):
    """Return whether a matrix is diagonal; if so, copy its diagonal into every row."""
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
    """Return (tangents, stretches) of a turn round the line with these forces (n,).

    tangents : shape (M + 1, M + 2), derivatives of the final state, d and the sum of forces, by
    column, with respect to the initial state and d, by row (steady_memory.py).
    stretches : number of stretches of constant contact; each costs one product or more.
    """
    size, first, i, stretches = powers.size, 0, 0, 0
    tangents = np.eye(size - 1, powers.product.shape[0])
    while i < forces.size:
        touches, begin, stretches = forces[i] > 0.0, i, stretches + 1
        while i < forces.size and (forces[i] > 0.0) == touches:
            i += 1
        carry_rows(powers, touches, i - begin, tangents[first:])
        if first == 0 and _have_decayed(tangents[:-1, : size - 2]):
            tangents[:-1, : size - 2] = 0.0
            first = size - 2
    return tangents[:, :size].copy(), stretches


@refcount_free_kernel
def _have_decayed(tangents):
    """Return whether all tangents are negligible."""
    for row in tangents:
        for value in row:
            if abs(value) > DECAYED_TANGENT:
                return False
    return True


@refcount_free_kernel
def carry_rows(powers, touching, steps, tangents):
    """Carry rows of tangents (c, W) over ``steps`` steps in contact (``touching``) or free."""
    kind, place = 1 if touching else 0, -1
    of, diagonal, known = powers.of[kind], powers.diagonal[kind], powers.known[kind]
    product = powers.product[: tangents.shape[0]]
    while steps > 0:
        power = place + steps % RADIX
        if power > place:
            while not known[power]:
                _compute_next_power(of, diagonal, known, power)
            factor = of[power]
            if not diagonal:
                _multiply(tangents, factor, diagonal, product)
            for r in range(product.shape[0]):
                for c in range(product.shape[1]):
                    tangents[r, c] = tangents[r, c] * factor[r, c] if diagonal else product[r, c]
        place += RADIX - 1
        steps //= RADIX


@refcount_free_kernel
def _compute_next_power(of, diagonal, known, power):
    """Compute one of the unknown powers that ``power`` depends on, as a product of known ones."""
    left = right = power
    while not known[left]:
        power, times = left, left % (RADIX - 1) + 1
        left -= RADIX // 2 if times == 1 else times // 2 if times % 2 == 0 else 1
        right = left if times == 1 or times % 2 == 0 else power - times + 1
    _multiply(of[left], of[right], diagonal, of[power])
    known[power] = True


@refcount_free_kernel
def _multiply(rows, matrix, diagonal, product):
    """Fill ``product`` with rows (c, W) times a matrix; ``diagonal`` : as in Powers."""
    count, width = rows.shape
    if diagonal:
        for r in range(count):
            for c in range(width):
                product[r, c] = rows[r, c] * matrix[r, c]
        return
    for r in range(count):
        for c in range(width):
            product[r, c] = 0.0
    for j in range(0, width, LANES):
        block = matrix[j : j + LANES]
        for r in range(count):
            row, factors = product[r], rows[r, j : j + LANES]
            for c in range(width):
                value = row[c]
                for i in range(LANES):
                    value += factors[i] * block[i, c]
                row[c] = value
