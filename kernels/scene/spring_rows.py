"""The thresholds of elements in rows of BLOCK_ELEMENTS, of which some are left out.

Those that are left out are not reached by an indentation below some bound. The load is balanced as
in model/contact.py.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..model.contact import excess_at, lowest_threshold
from ..rheology.scaled_units import BLOCK_ELEMENTS

COLUMNS = BLOCK_ELEMENTS // 4  # of sums


class SpringRows(NamedTuple):
    """Elements in rows, all of the stiffness 1."""

    c: (
        np.ndarray
    )  # contact thresholds z_i - w_i, shape (rows, BLOCK_ELEMENTS), in h; infinite: no element
    some: np.ndarray  # the rows that are not left out, in ascending order
    sums: np.ndarray  # room, shape (3, COLUMNS)
    highest: np.ndarray  # shape (1,): the highest indentation at which they were asked
    found: np.ndarray  # shape (3,): the last one, and the overlap and the number touching there


@kernel
def spring_rows_of(c):
    """Return SpringRows of thresholds, with room for the rest."""
    room = np.empty((3, COLUMNS)), np.empty(1), np.empty(3)
    return SpringRows(c, np.empty(c.shape[0], np.int64), *room)


@inlined_kernel
def refilled(rows):
    """Note that other thresholds fill the rows."""
    rows.highest[0], rows.found[0] = -np.inf, np.nan


@inlined_kernel
def add_overlap(rows, row, d):
    """Add that of a row.

    By columns, of which the compiler takes several at once; four parts of the row are added in one
    go: to store the sums takes as long as all else. A row in which nothing touches changes no bit.
    """
    c, sums = rows.c, rows.sums
    for i in range(COLUMNS):
        p0, p1 = d - c[row, i], d - c[row, COLUMNS + i]
        p2, p3 = d - c[row, 2 * COLUMNS + i], d - c[row, 3 * COLUMNS + i]
        depth = (p0 if p0 > 0.0 else 0.0) + (p1 if p1 > 0.0 else 0.0)
        depth += (p2 if p2 > 0.0 else 0.0) + (p3 if p3 > 0.0 else 0.0)
        count = (1.0 if p0 > 0.0 else 0.0) + (1.0 if p1 > 0.0 else 0.0)
        count += (1.0 if p2 > 0.0 else 0.0) + (1.0 if p3 > 0.0 else 0.0)
        sums[0, i] += depth
        sums[1, i] += count


@inlined_kernel
def fold(sums):
    """Add up the columns of every row, in the first of them."""
    half = COLUMNS // 2
    while half > 0:
        for row in range(sums.shape[0]):
            for i in range(half):
                sums[row, i] += sums[row, half + i]
        half //= 2


@excess_at.register(SpringRows)
def _excess_of_spring_rows(contact, load, d):
    sums, found = contact.sums, contact.found
    if d != found[0]:
        contact.highest[0] = max(contact.highest[0], d)
        for i in range(COLUMNS):
            sums[0, i] = sums[1, i] = 0.0
        for row in contact.some:
            add_overlap(contact, row, d)
        fold(sums)
        found[0], found[1], found[2] = d, sums[0, 0], sums[1, 0]
    return found[1] - load, found[2], found[2]


@lowest_threshold.register(SpringRows)
def _lowest_of_spring_rows(contact, load):
    lowest = np.inf
    for row in contact.some:
        for i in range(BLOCK_ELEMENTS):
            lowest = min(lowest, contact.c[row, i])
    return lowest, lowest + load
