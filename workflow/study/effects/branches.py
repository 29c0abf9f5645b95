"""Read the branches of a material from a text table of times and moduli, or shares of G_0.

Columns are identified by name and unit, else by order: modulus, time. Shares, as written by Abaqus
and Ansys, refer to the instantaneous modulus G_0 = G/(1 - sum of the shares).
"""

import re
from pathlib import Path

import numpy as np

from ...ground import UserError
from ...text_tables import TextTable, read_text_table
from ..columns import Column, ColumnSpec, describe_columns, select_columns

HEADER_ADVICE = 'a header "modulus [Pa], time [s]"'
MODULUS = ColumnSpec("a modulus", "pressure", r"modul|^[GE]([\W_]|\d|[bi]?$)", "Pa", HEADER_ADVICE)
SHARE = ColumnSpec(
    "a share of G_0", "number", r"alpha|\u03b1|share|norm|/ ?[GE]_?0|^g_?i?$", "1", HEADER_ADVICE
)
BRANCH_TIME_COLUMN = ColumnSpec(
    "a time", "time", r"time|tau|\u03c4|^t([\W_]|[bi]?$)", "s", HEADER_ADVICE
)
MIN_BRANCH_SHARE = 0.01  # of the relaxed modulus; below it the order of columns is doubtful
ABAQUS_KEYWORD = re.compile(r"^\s*\*VISCOELASTIC", re.IGNORECASE)
YOUNG_NAME = re.compile(r"young|tens|^E([\W_]|\d|[bi]?$)", re.IGNORECASE)


def read_branches(
    key: str, path: Path, relaxed: float, poisson: float
) -> tuple[list[list[float]], str]:
    """Return [modulus (Pa), time (s)] of each branch of a file, and a description of the columns.

    relaxed : shear modulus G, Pa. poisson : Poisson's ratio, for Young's moduli. Raises UserError,
    which begins with ``key``, for ambiguous columns, unknown units and invalid shares.
    """
    table = read_text_table(key, path, path.name)
    if any(ABAQUS_KEYWORD.search(line) for line in table.above) and len(table.numeric) == 3:
        columns = select_columns(
            table, (SHARE, BRANCH_TIME_COLUMN), (table.numeric[0], table.numeric[2]), HEADER_ADVICE
        )
        description = f"{describe_columns(table, columns)}; shares g_i, k_i, tau_i of Abaqus"
        return _branches_of_shares(key, columns, relaxed), description
    if len(table.numeric) == 3 and not table.titles:
        raise table.refused(
            "holds three columns; put the line *VISCOELASTIC above shares g_i, k_i, tau_i of "
            f"Abaqus, or give two columns with {HEADER_ADVICE}"
        )
    if _has_share_name(table):
        columns = select_columns(table, (SHARE, BRANCH_TIME_COLUMN), None, HEADER_ADVICE)
        description = f"{describe_columns(table, columns)}; G_0 from shear_modulus"
        return _branches_of_shares(key, columns, relaxed), description
    columns = select_columns(table, (MODULUS, BRANCH_TIME_COLUMN), None, HEADER_ADVICE)
    moduli, description = columns[0].values, describe_columns(table, columns)
    for column in columns:
        if not np.isfinite(column.values).all():
            raise table.refused(f"{column.spec.meaning} is missing in a row")
    if columns[0].unit_source == "assumed" and moduli.sum() < 1.0:
        raise table.refused(
            f"the moduli sum to {moduli.sum():.3g}; name the column alpha "
            f"if they are shares of G_0, or give {HEADER_ADVICE} with their unit"
        )
    if columns[0].unit_source == "assumed" and moduli.sum() < MIN_BRANCH_SHARE * relaxed:
        share = 100.0 * moduli.sum() / relaxed
        description += f"; warning: all branches together are {share:.2g} % of shear_modulus: the "
        description += "order is taken as modulus, time"
    if YOUNG_NAME.search(columns[0].title.name):
        factor = 2.0 * (1.0 + poisson)
        moduli = moduli / factor
        description += f"; Young's moduli divided by 2 (1 + nu) = {factor:g}"
    return np.stack([moduli, columns[1].values], axis=1).tolist(), description


def _has_share_name(table: TextTable) -> bool:
    """Return whether the name of a dimensionless column denotes a share of G_0."""
    return any(
        re.search(SHARE.names, title.name, re.IGNORECASE if len(title.name) > 2 else 0)
        and not re.fullmatch("G_?i?", title.name)
        and title.unit in ("", "-", "1", "%")
        for title in table.titles
    )


def _branches_of_shares(key: str, columns: tuple[Column, ...], relaxed: float) -> list[list[float]]:
    shares, times = (column.values for column in columns)
    total = float(shares.sum())
    if not 0.0 < total < 1.0:
        raise UserError(
            f"{key}: the shares of G_0 sum to {total:.4g}; the sum must lie between 0 and 1"
        )
    return np.stack([shares * relaxed / (1.0 - total), times], axis=1).tolist()
