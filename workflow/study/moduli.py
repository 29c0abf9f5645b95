"""Read measured storage and loss moduli over frequency: three columns of a text file."""

import math
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..errors import UserError
from .settings import named_unit, read_columns

FREQUENCIES = {"rad/s": 1.0, "Hz": 2.0 * math.pi}  # in rad/s
MODULI = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9}  # in Pa
COLUMNS = ("a frequency", "a storage modulus G'", "a loss modulus G''")
LEAST = 4  # frequencies
OF_FREQUENCY = re.compile(r"(?<![\w/])(rad/s|Hz)(?!\w)")
OF_MODULUS = re.compile(r"(?<!\w)([kMG]?Pa)(?!\w)")


class Moduli(NamedTuple):
    """Measured moduli, frequencies ascending, and the units that the file was read with."""

    omega: np.ndarray  # rad/s, shape (n,)
    values: np.ndarray  # G' + i G'' in Pa, shape (n,)
    units: tuple[str, str]  # of frequencies and moduli


def read_moduli(path: Path, frequency: str | None = None, modulus: str | None = None) -> Moduli:
    """Return the moduli of a text file with the columns frequency, G' and G''.

    frequency : "rad/s" or "Hz". modulus : "Pa", "kPa", "MPa" or "GPa". Where they are not given
    the lines before the first row say them, and without that they are rad/s and Pa.

    Raises UserError for a file that cannot be read and for values that no material has.
    """
    rows = read_columns("prony", path, COLUMNS)
    columns, head = rows.values, " ".join(rows.header)
    units = (
        frequency or named_unit(f"prony {path}", "--frequency", OF_FREQUENCY, head) or "rad/s",
        modulus or named_unit(f"prony {path}", "--modulus", OF_MODULUS, head) or "Pa",
    )
    if columns.shape[1] < LEAST:
        raise UserError(f"prony {path}: holds {columns.shape[1]} rows; a fit needs {LEAST}")
    for name, values, least in zip(COLUMNS, columns, (True, True, False), strict=True):
        bad = values <= 0.0 if least else values < 0.0
        if np.any(bad):
            raise UserError(
                f"prony {path}: row {np.argmax(bad) + 1} holds {values[bad][0]:g} as {name}; must "
                + ("be greater than zero" if least else "not be negative")
            )
    order = np.argsort(columns[0], kind="stable")
    omega, storage, loss = columns[:, order]
    scale = MODULI[units[1]]
    return Moduli(FREQUENCIES[units[0]] * omega, scale * (storage + 1j * loss), units)
