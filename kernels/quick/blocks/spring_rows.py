"""Elements in rows of BLOCK_ELEMENTS, as springs with thresholds, with some rows left out.

Elements of rows that are left out cannot touch while the indentation is below some bound. The load
is balanced as in model/contact.py.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel
from ...model.contact import excess_at, lowest_threshold
from .scaled_units import BLOCK_ELEMENTS

SUM_COLUMNS = BLOCK_ELEMENTS // 4

# Evaluations of the load balance: one record, changed in place.
EVALUATION = np.dtype(
    [
        ("highest_d", np.float64),  # highest indentation so far
        ("d", np.float64),  # last indentation; NaN before the first
        ("overlap", np.float64),  # sum of depths at d, in h
        ("touching", np.float64),  # number of touching elements at d
    ]
)


class SpringRows(NamedTuple):
    """Elements in rows, all with stiffness 1."""

    c: np.ndarray  # shape (rows, BLOCK_ELEMENTS): thresholds z_i - w_i, in h; inf: no element
    some: np.ndarray  # indices of the rows that are not left out, ascending
    sums: np.ndarray  # workspace, shape (2, SUM_COLUMNS), or 3 rows for add_weighted
    evaluation: np.ndarray  # EVALUATION, shape (1,)


@inlined_kernel
def forget_evaluation(rows):
    """Discard the last evaluation after a change of thresholds."""
    evaluation = rows.evaluation[0]
    evaluation["highest_d"], evaluation["d"] = -np.inf, np.nan


@inlined_kernel
def add_overlap(rows, row, d):
    """Add depths and the number of touching elements of a row to the column sums.

    Columns let the compiler vectorize the loop. Four parts of the row are added before the sums are
    stored, because storing takes as long as everything else. Rows without contact change no sum.
    """
    c, sums = rows.c, rows.sums
    for i in range(SUM_COLUMNS):
        p0, p1 = d - c[row, i], d - c[row, SUM_COLUMNS + i]
        p2, p3 = d - c[row, 2 * SUM_COLUMNS + i], d - c[row, 3 * SUM_COLUMNS + i]
        depth = (p0 if p0 > 0.0 else 0.0) + (p1 if p1 > 0.0 else 0.0)
        depth += (p2 if p2 > 0.0 else 0.0) + (p3 if p3 > 0.0 else 0.0)
        count = (1.0 if p0 > 0.0 else 0.0) + (1.0 if p1 > 0.0 else 0.0)
        count += (1.0 if p2 > 0.0 else 0.0) + (1.0 if p3 > 0.0 else 0.0)
        sums[0, i] += depth
        sums[1, i] += count


@inlined_kernel
def add_weighted(rows, row, weight, d):
    """Add depths of a row times a weight (BLOCK_ELEMENTS,) to the third column sums."""
    c, sums = rows.c, rows.sums
    for i in range(SUM_COLUMNS):
        p0, p1 = d - c[row, i], d - c[row, SUM_COLUMNS + i]
        p2, p3 = d - c[row, 2 * SUM_COLUMNS + i], d - c[row, 3 * SUM_COLUMNS + i]
        total = sums[2, i] + (p0 if p0 > 0.0 else 0.0) * weight[i]
        total += (p1 if p1 > 0.0 else 0.0) * weight[SUM_COLUMNS + i]
        total += (p2 if p2 > 0.0 else 0.0) * weight[2 * SUM_COLUMNS + i]
        sums[2, i] = total + (p3 if p3 > 0.0 else 0.0) * weight[3 * SUM_COLUMNS + i]


@inlined_kernel
def clear(sums):
    """Set all column sums to zero."""
    for row in range(sums.shape[0]):
        for i in range(SUM_COLUMNS):
            sums[row, i] = 0.0


@inlined_kernel
def fold(sums):
    """Sum the columns of every row of ``sums`` into its first column."""
    half = SUM_COLUMNS // 2
    while half > 0:
        for row in range(sums.shape[0]):
            for i in range(half):
                sums[row, i] += sums[row, half + i]
        half //= 2


@excess_at.register(SpringRows)
def _excess_of_spring_rows(contact, load, d):
    sums, evaluation = contact.sums, contact.evaluation[0]
    if d != evaluation["d"]:
        evaluation["highest_d"] = max(evaluation["highest_d"], d)
        clear(sums)
        for row in contact.some:
            add_overlap(contact, row, d)
        fold(sums)
        evaluation["d"], evaluation["overlap"] = d, sums[0, 0]
        evaluation["touching"] = sums[1, 0]
    return evaluation["overlap"] - load, evaluation["touching"], evaluation["touching"]


@lowest_threshold.register(SpringRows)
def _lowest_of_spring_rows(contact, load):
    lowest = np.inf
    for row in contact.some:
        for i in range(BLOCK_ELEMENTS):
            lowest = min(lowest, contact.c[row, i])
    return lowest, lowest + load
