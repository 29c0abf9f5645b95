"""Reader of a measured record: time, velocity or displacement, and friction, from a text table.

Columns are identified by their names and units, else by their order.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..ground import UserError, counted
from ..study import ColumnSpec, describe_columns, find_column, select_columns
from ..text_tables import TextTable, read_text_table, unit_of

TIME = ColumnSpec("a time", "time", r"time|zeit|^t$", "s", "--time", clock=True)
VELOCITY = ColumnSpec("a velocity", "velocity", r"vel|speed|geschw|^v([_ ]|$)", "m/s", "--velocity")
PLACE = ColumnSpec(
    "a displacement", "length", r"disp|posit|slip|dist|^weg|^[xs]$", "m", "--displacement"
)
FRICTION = ColumnSpec(
    "a coefficient of friction",
    "number",
    r"fric|reib|^(mu|\u03bc|\u00b5)([\W_\d]|$)|coef|cof",
    "1",
)
MAX_VELOCITY_NOISE = 0.05  # largest relative noise of a velocity from differences of displacements
MIN_PLACES = 3  # displacements for a second difference
MAX_DIFFERENCE_SAMPLES = 12  # largest number of samples per difference of displacements


class Record(NamedTuple):
    """A measured record in SI units; arrays of shape (samples,)."""

    name: str  # name of the file
    time: np.ndarray  # s, increasing
    velocity: np.ndarray  # m/s, of any sign
    friction: np.ndarray  # coefficient of friction, of any sign
    description: tuple[str, ...] = ()  # of the columns, in sentences
    is_named: bool = False  # whether the file names the velocity


def read_record(
    path: Path,
    columns: Sequence[int] | None = None,
    time: str | None = None,
    velocity: str | None = None,
    displacement: str | None = None,
) -> Record:
    """Return the record of a text file.

    columns : numbers, from 0, of time, velocity or displacement, and friction. time, velocity :
    units, which replace those of the file; the defaults are s and m/s. displacement : unit of a
    displacement in place of the velocity, if the file does not state it.

    Rows with a missing value are left out; equal time stamps are spread evenly up to the next one.
    Raises UserError for a file that does not determine the columns, for an unknown unit, for times
    that decrease, and for displacements that are too noisy to be differenced.
    """
    table = read_text_table("fit", path)
    _check_rotation(path, table, columns)
    second = _motion_spec(table, columns, displacement)._replace(unit=displacement or velocity)
    selected = select_columns(table, (TIME._replace(unit=time), second, FRICTION), columns)
    lines = [describe_columns(table, selected)]
    values = np.array([one.values for one in selected])
    complete = np.isfinite(values).all(axis=0)
    t, moved, mu = values[:, complete]
    if not t.size:
        raise UserError(f"fit {path}: holds no row of 3 finite numbers")
    back = np.flatnonzero(np.diff(t) < 0.0)
    if back.size:
        line = np.array(table.lines)[complete][back[0] + 1]
        raise UserError(
            f"fit: line {line} of {str(path)!r}: time {t[back[0] + 1]:g} s comes before "
            f"{t[back[0]]:g} s of the row above; must increase: part the file there, or sort it"
        )
    if np.any(np.diff(t) == 0.0):
        lines.append(f"{np.sum(np.diff(t) == 0.0)} samples have the time of the one before; spread")
        t = _spread(t)
    if second.family == PLACE.family:
        moved, width = _differenced(path, t, moved)
        lines.append(f"velocity is the difference of displacements over {width} samples")
    return Record(path.name, t, moved, mu, tuple(lines), second.is_named(selected[1].title))


def _check_rotation(path: Path, table: TextTable, columns: Sequence[int] | None) -> None:
    """Raise UserError for a velocity in rpm or rad/s."""
    for n in table.numeric if columns is None else columns[1:2]:
        title = table.title(n)
        unit = unit_of(title.unit)
        if unit is not None and unit.family == "frequency" and VELOCITY.is_named(title):
            raise UserError(
                f"fit {path}: column {n} {title.name!r} is in {title.unit}: write the velocity of "
                "the track of radius r, 2 pi r rpm/60, in its place"
            )


def _motion_spec(
    table: TextTable, columns: Sequence[int] | None, displacement: str | None
) -> ColumnSpec:
    """Return the column specification of the velocity, or of the displacement in its place."""
    if displacement:
        return PLACE
    if columns is not None:
        title = table.title(columns[1])
        unit, name = unit_of(title.unit), title.name
        family = unit.family if unit else ""
        if re.search(VELOCITY.names, name, re.I) and not title.stated:
            return VELOCITY
        placed = family == "" and bool(re.search(PLACE.names, name, re.I))
        return PLACE if family == PLACE.family or placed else VELOCITY
    units = [unit_of(title.unit) for title in table.titles]
    families = [unit.family for unit in units if unit]
    if find_column(table, VELOCITY) is not None or VELOCITY.family in families:
        return VELOCITY
    placed = find_column(table, PLACE) is not None or PLACE.family in families
    return PLACE if placed else VELOCITY


def _spread(t: np.ndarray) -> np.ndarray:
    """Spread samples with equal time stamps evenly up to the next stamp."""
    stamps, first, counts = np.unique(t, return_index=True, return_counts=True)
    if stamps.size < 2:
        raise UserError(f"fit: all samples have one time stamp, {stamps[0]:g} s; must increase")
    steps = np.append(np.diff(stamps), np.diff(stamps)[-1])
    within = np.arange(t.size) - np.repeat(first, counts)
    return t + within * np.repeat(steps / counts, counts)


def _differenced(path: Path, t: np.ndarray, place: np.ndarray) -> tuple[np.ndarray, int]:
    """Return finite-difference velocities and the number of samples per difference.

    The number limits the noise of the velocity, as known from second differences of ``place``.
    """
    if place.size < MIN_PLACES:
        raise UserError(f"fit {path}: holds {counted(place.size, 'row')}: a fit needs {MIN_PLACES}")
    step = float(np.median(np.abs(np.diff(place))))
    noise = float(np.median(np.abs(np.diff(place, 2)))) / (0.6745 * np.sqrt(6.0))
    width = max(int(np.ceil(np.sqrt(2.0) * noise / (MAX_VELOCITY_NOISE * step))), 1) if step else 1
    if width > MAX_DIFFERENCE_SAMPLES:
        raise UserError(
            f"fit {path}: displacements scatter by {noise:.2g} m, beside {step:.2g} m from sample "
            "to sample: smooth them, or give the commanded velocity"
        )
    velocity = (place[width:] - place[:-width]) / (t[width:] - t[:-width])
    return np.concatenate([np.full(width, velocity[0]), velocity]), width
