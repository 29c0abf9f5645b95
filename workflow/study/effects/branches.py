"""Read the branches of a material from a text table: moduli and times, or shares of G_0 and times.

Columns are known by their names and units, else by their order: modulus, time. Shares, as Abaqus
and Ansys have them, are of the modulus at once after a step, G_0 = G/(1 - sum of the shares).
"""

import re
from pathlib import Path

import numpy as np

from ...ground import UserError
from ...text_tables import (
    Column,
    ColumnSpec,
    TextTable,
    describe_columns,
    read_text_table,
    select_columns,
)

HEADER = 'a header "modulus [Pa], time [s]"'
MODULUS = ColumnSpec("a modulus", "pressure", r"modul|^[GE]([\W_]|\d|[bi]?$)", "Pa", HEADER)
SHARE = ColumnSpec(
    "a share of G_0", "number", r"alpha|\u03b1|share|norm|/ ?[GE]_?0|^g_?i?$", "1", HEADER
)
TIME = ColumnSpec("a time", "time", r"time|tau|\u03c4|^t([\W_]|[bi]?$)", "s", HEADER)
OF_ABAQUS = re.compile(r"^\s*\*VISCOELASTIC", re.IGNORECASE)
OF_YOUNG = re.compile(r"young|tens|^E([\W_]|\d|[bi]?$)", re.IGNORECASE)


def read_branches(
    key: str, path: Path, relaxed: float, poisson: float
) -> tuple[list[list[float]], str]:
    """Return [modulus (Pa), time (s)] of each branch of a file, and what the file was read as.

    relaxed : shear modulus G, Pa. poisson : ratio, for Young's moduli. Raises UserError, which
    begins with ``key``, for a file that does not say which columns are meant, for unknown units
    and for shares that are none.
    """
    table = read_text_table(key, path, path.name)
    if any(OF_ABAQUS.search(line) for line in table.above) and len(table.numeric) == 3:
        found = select_columns(table, (SHARE, TIME), (table.numeric[0], table.numeric[2]), HEADER)
        said = f"{describe_columns(table, found)}; as Abaqus writes shares g_i, k_i, tau_i"
        return _of_shares(key, found, relaxed), said
    if len(table.numeric) == 3 and not table.titles:
        raise UserError(
            f"{key} = {path.name!r}: holds three columns, as Abaqus writes shares g_i, k_i, tau_i "
            f"below *VISCOELASTIC; put that line above them, or give two columns with {HEADER}"
        )
    if _of_share(table):
        found = select_columns(table, (SHARE, TIME), None, HEADER)
        return _of_shares(
            key, found, relaxed
        ), f"{describe_columns(table, found)}; G_0 from shear_modulus"
    found = select_columns(table, (MODULUS, TIME), None, HEADER)
    moduli, said = found[0].values, describe_columns(table, found)
    _check_finite(key, path, found)
    if found[0].unit_source == "assumed" and moduli.sum() < 1.0:
        raise UserError(
            f"{key} = {path.name!r}: the moduli sum up to {moduli.sum():.3g}: for shares of G_0 "
            f"name the column alpha; for moduli give {HEADER}, with their unit"
        )
    if OF_YOUNG.search(found[0].title.name):
        factor = 2.0 * (1.0 + poisson)
        moduli, said = moduli / factor, f"{said}; Young's moduli divided by 2 (1 + nu) = {factor:g}"
    return np.stack([moduli, found[1].values], axis=1).tolist(), said


def _of_share(table: TextTable) -> bool:
    """Return whether a column is named as a share, and has no unit."""
    return any(
        re.search(SHARE.names, title.name, re.IGNORECASE if len(title.name) > 2 else 0)
        and not re.fullmatch("G_?i?", title.name)
        and title.unit in ("", "-", "1", "%")
        for title in table.titles
    )


def _of_shares(key: str, found: tuple[Column, ...], relaxed: float) -> list[list[float]]:
    shares, times = (one.values for one in found)
    whole = float(shares.sum())
    if not 0.0 < whole < 1.0:
        raise UserError(f"{key}: the shares of G_0 sum up to {whole:.4g}; must be between 0 and 1")
    return np.stack([shares * relaxed / (1.0 - whole), times], axis=1).tolist()


def _check_finite(key: str, path: Path, found: tuple[Column, ...]) -> None:
    for one in found:
        if not np.isfinite(one.values).all():
            raise UserError(f"{key} = {path.name!r}: {one.spec.meaning} is missing in a row")
