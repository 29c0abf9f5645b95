"""The inline table surface.spectrum: a measured power spectrum, read from a text table.

Conventions, with q = 2 pi/wavelength and the mean square height h^2:

    "2D"          C_2D, int C_2D d^2q = h^2                              m^4
    "equivalent"  pi q C_2D, the equivalent line over both signs of q    m^3
    "profile"     the straight cut over both signs of q                  m^3
    "profile+"    the straight cut over q > 0, twice "profile"           m^3
"""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ....kernels import IsotropicSpectrum, isotropic_of_cut, isotropic_of_equivalent
from ...ground import UserError
from ...text_tables import TextTable, read_text_table
from ..columns import ColumnSpec, describe_columns, select_columns
from ..row_checks import POSITIVE_NUMBER, check_rows
from ..settings import FILE_NAME, Key, choice, positive

SPECTRUM_KEY = "surface.spectrum"
MAX_ROW_RATIO = 10.0  # of neighbouring wave numbers
ADVICE = 'a header "q [1/m], C [m^4]"'
WAVE_NUMBER_COLUMN = ColumnSpec(
    "a wave number q", "wave number", r"^q([\W_]|$)|wave|^k([\W_]|$)", "1/m", ADVICE
)
DENSITY_NAMES = r"^C([\W_\d]|$)|psd|power|spectr|dens"


# Each kind with the unit of its column, its family, and the conversion to C_2D.
KINDS: dict[str, tuple[str, str, Callable[[np.ndarray, np.ndarray], np.ndarray]]] = {
    "2D": ("m^4", "spectrum of a surface", lambda q, density: density),
    "equivalent": ("m^3", "spectrum of a line", isotropic_of_equivalent),
    "profile": ("m^3", "spectrum of a line", isotropic_of_cut),
    "profile+": ("m^3", "spectrum of a line", lambda q, c: isotropic_of_cut(q, 0.5 * c)),
}
SPECTRUM = {
    "file": FILE_NAME(
        "A text file beside `study.toml` with columns q = 2π/λ, ascending, and C(q), or as its "
        "header says.",
    ),
    "kind": Key(
        partial(choice, known=tuple(KINDS)),
        'The definition of C: `"2D"` with ∫C d²q = h² (m⁴); in m³ `"equivalent"`, πqC₂D; '
        '`"profile"`, the spectrum of a straight cut over both signs of q, which is inverted; '
        '`"profile+"`, twice that, over q > 0.',
    ),
    "times": Key(
        positive,
        "A factor of C, such as 39.478 = 4π².",
        "Doubled, h and slopes grow by √2.",
        default=1.0,
    ),
}


def read_spectrum(table: Mapping[str, Any], folder: Path) -> tuple[IsotropicSpectrum, str]:
    """Return the spectrum of a file, and a description of its columns. Raises UserError.

    table : values of the keys of SPECTRUM. folder : of the file.
    """
    name, kind = table["file"], table["kind"]
    unit, family, isotropic = KINDS[kind]
    rows = read_text_table(f"{SPECTRUM_KEY}.file", folder / name, name)
    wanted = WAVE_NUMBER_COLUMN, ColumnSpec("C(q)", family, DENSITY_NAMES, unit, ADVICE)
    columns = select_columns(rows, wanted, None, ADVICE.replace("m^4", unit))
    q, density = (column.values for column in columns)
    _check_rows(rows, q, density)
    surface = isotropic(q, table["times"] * density)
    lost = ~(np.isfinite(surface) & (surface > 0.0))
    if lost.any():
        raise UserError(
            f"{SPECTRUM_KEY}.kind = {kind!r}: no isotropic surface has the cuts of {name!r} at q = "
            f"{q[lost][0]:.4g} 1/m, where C scatters or rises; average C over wider bins of q"
        )
    told = f'{describe_columns(rows, columns)}; read as "{kind}"'
    if table["times"] != 1.0:
        told += f", times {table['times']:g}"
    return IsotropicSpectrum(tuple(q.tolist()), tuple(surface.tolist())), told


def _check_rows(table: TextTable, q: np.ndarray, density: np.ndarray) -> None:
    """Raise UserError unless q and C are positive, and q ascends without gaps."""
    if q.size < 2:
        raise table.refused("holds one row: needs two wave numbers or more")
    values = {"q (1/m)": q, "C": density}
    rule = "both must be greater than zero; leave the row out"
    check_rows(table.prefix, values, (POSITIVE_NUMBER, POSITIVE_NUMBER), rule)
    ratio = q[1:] / q[:-1]
    for row in np.flatnonzero(ratio > MAX_ROW_RATIO * (1.0 + 1e-9)):
        raise table.refused(
            f"has no row between q = {q[row]:g} and {q[row + 1]:g} 1/m: a gap of more "
            f"than a factor of {MAX_ROW_RATIO:g}; add rows, or cut the table there"
        )
