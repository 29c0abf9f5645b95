"""Prescribed indentation: d is given at every step, and the force follows from it.

If d lies below every threshold, no element touches: the force is zero and the friction coefficient
is undefined.
"""

from typing import NamedTuple

import numpy as np

from ..model.balance import balance, balance_rows


class PrescribedIndentation(NamedTuple):
    """Control with a prescribed indentation."""

    indentation: np.ndarray  # at the end of every step, in h over the deepest point


@balance.register(PrescribedIndentation)
def _balance(control, law, z, c, history, d, step):
    return control.indentation[step - 1], 0


@balance_rows.register(PrescribedIndentation)
def _balance_rows(control, law, rows, d, step):
    rows.evaluation[0]["highest_d"] = control.indentation[step - 1]
    return control.indentation[step - 1], 0
