"""Separation of the sweeps of a table by temperature.

Temperatures are given in the order of the sweeps, or read from a column or the lines above a block.
"""

import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..ground import UserError
from ..text_tables import ZERO, TextTable, unit_of
from .columns import Column, ColumnSpec, find_column, select_columns

TEMPERATURE = ColumnSpec(
    "a temperature", "temperature", r"temp(?!(o|s|us)([\W_]|$))|(?-i:^Ts?$)", "°C"
)
TEMPERATURE_TEXT = re.compile(
    r"((?<![\d.,])[-+]?\d+(?:[.,]\d+)?)\s*([°º]\s?[CF]|[CK]\b|deg\.?\s?C|celsius)", re.I
)
MAX_SWEEP_SPREAD = 2.0  # K, within one sweep
MIN_SWEEP_GAP = 1.0  # K, between two sweeps


def temperatures_of(
    table: TextTable, omega: np.ndarray, given: Sequence[float]
) -> tuple[np.ndarray | None, list[str]]:
    """Return the sweep temperature (°C) of each row, and a note; None for a single sweep.

    omega : frequency of each row, shape (rows,). given : temperatures in the order of the sweeps,
    which replace those of the file. Raises UserError if their number is not that of the sweeps, or
    if the temperatures of the file do not form sweeps.
    """
    blocks = table.blocks
    if given:
        sweeps = blocks if len(blocks) > 1 else _runs(omega)
        if len(sweeps) != len(given):
            raise UserError(
                f"--temperatures: {len(given)} are given, but {table.name!r} holds {len(sweeps)} "
                "sweeps (blocks or monotonic runs of frequencies); give one for each"
            )
        per_row = _over_rows(given, sweeps)
        source = f"{len(sweeps)} sweeps at the given temperatures"
    elif (named := _temperature_column(table)) is not None:
        per_row, source = _sweep_means(table, named), f"temperatures: column {named.number}"
    else:
        headed = [temperature_in(table.gaps.get(block.start, ())) for block in blocks]
        if len(blocks) < 2 or None in headed:
            return None, []
        per_row = _over_rows([t for t in headed if t is not None], blocks)
        source = "temperatures: as above each block"
    several = len(set(given)) > 1 or np.nanmax(per_row) - np.nanmin(per_row) > MAX_SWEEP_SPREAD
    return (per_row, [source]) if several else (None, [])


def _over_rows(temperatures: Sequence[float], sweeps: Sequence[slice]) -> np.ndarray:
    return np.repeat(temperatures, [sweep.stop - sweep.start for sweep in sweeps])


def _runs(omega: np.ndarray) -> tuple[slice, ...]:
    """Return the monotonic runs of frequencies, all in the direction of the first run."""
    change = np.nan_to_num(np.diff(omega))
    moving = change[change != 0.0]
    back = change * np.sign(moving[0]) < 0.0 if moving.size else change < 0.0
    ends = [0, *(np.flatnonzero(back) + 1).tolist(), omega.size]
    return tuple(slice(a, b) for a, b in pairwise(ends))


def _temperature_column(table: TextTable) -> Column | None:
    """Return the column of temperatures, identified by name or unit, or None."""
    named = find_column(table, TEMPERATURE, "--temperatures")
    if named is not None:
        return named
    units = {n: unit_of(table.title(n).unit) for n in table.numeric}
    columns = [n for n, unit in units.items() if unit and unit.family == TEMPERATURE.family]
    return select_columns(table, (TEMPERATURE,), columns)[0] if len(columns) == 1 else None


def _sweep_means(table: TextTable, column: Column) -> np.ndarray:
    """Return for each row the mean temperature (°C) of its sweep; NaN if missing."""
    values = column.values - ZERO
    order = np.argsort(values)
    starts = np.append(True, np.diff(values[order]) > MIN_SWEEP_GAP)
    sweep_index = np.empty(values.size, int)
    sweep_index[order] = np.cumsum(starts) - 1
    means = np.full(values.size, np.nan)
    for sweep in np.unique(sweep_index[np.isfinite(values)]):
        rows = (sweep_index == sweep) & np.isfinite(values)
        low, high = values[rows].min(), values[rows].max()
        if high - low > MAX_SWEEP_SPREAD:
            raise UserError(
                f"prony {table.name}: temperatures from {low:g} to {high:g} °C in column "
                f"{column.number} are not separate sweeps but a ramp; give --temperatures, "
                "one for each sweep in order"
            )
        means[rows] = round(float(values[rows].mean()), 2)
    return means


def temperature_in(lines: Sequence[str]) -> float | None:
    """Return the temperature (°C) stated above a block, or None."""
    for number, text in TEMPERATURE_TEXT.findall("\n".join(lines))[::-1]:
        unit = unit_of(text)
        if unit is not None and unit.family == TEMPERATURE.family:
            return float(unit.si(np.array(float(number.replace(",", "."))))) - ZERO
    return None
