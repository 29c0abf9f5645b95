"""Tell the sweeps of a table apart by their temperatures.

They are given, one for each sweep in order, or stand in a column, or in the lines above each block.
"""

import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..ground import UserError
from ..text_tables import ZERO, Column, ColumnSpec, TextTable, find_column, select_columns, unit_of

TEMPERATURE = ColumnSpec("a temperature", "temperature", r"temp(?!(o|s|us)([\W_]|$))|^T[s]?$", "°C")
OF_TEMPERATURE = re.compile(
    r"([-+]?\d+(?:[.,]\d+)?)\s*([°º]\s?[CF]|[CK]\b|deg\.?\s?C|celsius)", re.I
)
APART = 2.0  # K, of one sweep
BETWEEN = 1.0  # K, at least, between two


def temperatures_of(
    table: TextTable, omega: np.ndarray, given: Sequence[float]
) -> tuple[np.ndarray | None, list[str]]:
    """Return the temperature of the sweep of each row, °C, and whose it is in words; None for one.

    omega : frequency of each row, shape (rows,). given : temperatures in the order of the sweeps,
    which go before what the file says. Raises UserError where they are another number, or where
    temperatures of the file are those of no sweeps.
    """
    blocks = table.blocks
    if given:
        sweeps = blocks if len(blocks) > 1 else _runs(omega)
        if len(sweeps) != len(given):
            raise UserError(
                f"--temperatures: {len(given)} are given, but {table.name!r} holds {len(sweeps)} "
                "sweeps: blocks, or runs of frequencies from one end to the other"
            )
        each, said = _over_rows(given, sweeps), f"{len(sweeps)} sweeps at the given temperatures"
    elif (named := _temperature_column(table)) is not None:
        each, said = _grouped(table, named), f"temperatures: column {named.number}"
    else:
        headed = [_temperature_in(table.block_header(n)) for n in range(len(blocks))]
        if len(blocks) < 2 or None in headed:
            return None, []
        each = _over_rows([t for t in headed if t is not None], blocks)
        said = "temperatures: as above each block"
    several = len(set(given)) > 1 or np.nanmax(each) - np.nanmin(each) > APART
    return (each, [said]) if several else (None, [])


def _over_rows(temperatures: Sequence[float], sweeps: Sequence[slice]) -> np.ndarray:
    return np.repeat(temperatures, [sweep.stop - sweep.start for sweep in sweeps])


def _runs(omega: np.ndarray) -> tuple[slice, ...]:
    """Return the runs in which frequencies rise, or fall, as those of the first run do."""
    change = np.nan_to_num(np.diff(omega))
    moving = change[change != 0.0]
    back = change * np.sign(moving[0]) < 0.0 if moving.size else change < 0.0
    ends = [0, *(np.flatnonzero(back) + 1).tolist(), omega.size]
    return tuple(slice(a, b) for a, b in pairwise(ends))


def _temperature_column(table: TextTable) -> Column | None:
    """Return the column of temperatures by its name, or by its unit; None where there is none."""
    named = find_column(table, TEMPERATURE, "--temperatures")
    if named is not None:
        return named
    units = {n: unit_of(table.title(n).unit) for n in table.numeric}
    own = [n for n, unit in units.items() if unit and unit.family == TEMPERATURE.family]
    return select_columns(table, (TEMPERATURE,), own)[0] if len(own) == 1 else None


def _grouped(table: TextTable, named: Column) -> np.ndarray:
    """Return the mean temperature of the sweep of each row, °C, NaN where it is missing."""
    values = named.values - ZERO
    order = np.argsort(values)
    new = np.append(True, np.diff(values[order]) > BETWEEN)
    own = np.empty(values.size, int)
    own[order] = np.cumsum(new) - 1
    found = np.full(values.size, np.nan)
    for sweep in np.unique(own[np.isfinite(values)]):
        there = (own == sweep) & np.isfinite(values)
        low, high = values[there].min(), values[there].max()
        if high - low > APART:
            raise UserError(
                f"prony {table.name}: temperatures from {low:g} to {high:g} °C in column "
                f"{named.number} run into one another: a ramp is no sweep; give --temperatures, "
                "one for each sweep in order"
            )
        found[there] = round(float(values[there].mean()), 2)
    return found


def _temperature_in(lines: Sequence[str]) -> float | None:
    """Return the temperature that lines above a block state, °C; None where they state none."""
    for number, text in OF_TEMPERATURE.findall("\n".join(lines))[::-1]:
        unit = unit_of(text)
        if unit is not None and unit.family == TEMPERATURE.family:
            return float(unit.si(np.array(float(number.replace(",", "."))))) - ZERO
    return None
