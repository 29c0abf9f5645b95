"""Check of the rows of files and arrays: numbers within limits, the first ones increasing."""

from collections.abc import Mapping, Sequence

import numpy as np

from ..ground import UserError

POSITIVE_NUMBER = float(np.nextafter(0.0, 1.0))  # the smallest one


def check_rows(
    prefix: str, values: Mapping[str, np.ndarray], least: Sequence[float], rule: str
) -> None:
    """Raise UserError unless values are numbers from ``least`` on, and the first ones increase.

    prefix : start of the message. values : by their meaning. rule : the rule of the values.
    """
    rows = np.array(list(values.values()))
    ok = np.isfinite(rows) & (rows >= np.array(least)[:, None])
    for row in np.flatnonzero(~ok.all(axis=0)).tolist():
        held = " and ".join(f"{name} of {value[row]:g}" for name, value in values.items())
        raise UserError(f"{prefix}: row {row + 1} holds {held}: {rule}")
    for row in np.flatnonzero(np.diff(rows[0]) <= 0.0).tolist():
        raise UserError(
            f"{prefix}: {next(iter(values))} of {rows[0, row + 1]:g} in row {row + 2} follows "
            f"{rows[0, row]:g}: must increase from row to row; sort them, and average equal ones"
        )
