"""Sampled histories of velocity or indentation, from text files and from arrays."""

from pathlib import Path
from typing import Any

import numpy as np

from ...ground import UserError
from ...text_tables import read_text_table
from ..columns import ColumnSpec, describe_columns, select_columns
from ..row_checks import check_rows
from ..settings import number
from .programme import FromFile

MAX_SAMPLES = 100_000
TIME_COLUMN = ColumnSpec("a time", "time", r"time|zeit|^t$", "s", "a header with known units")
VELOCITY_COLUMN = TIME_COLUMN._replace(
    meaning="a velocity", family="velocity", names=r"vel|speed|^v([_ ]|$)", default="m/s"
)
INDENTATION_COLUMN = TIME_COLUMN._replace(
    meaning="an indentation", family="length", names=r"ind|depth|^d([_ ]|$)", default="m"
)


def read_history(key: str, path: Path, wanted: ColumnSpec) -> tuple[np.ndarray, str]:
    """Return times and values of a file in SI units, shape (2, samples), and a description.

    wanted : column of values. Raises UserError for missing values and times that do not increase.
    """
    second = f"{wanted.meaning.split()[-1]} [{wanted.default}]"
    table = read_text_table(key, path, path.name)
    columns = select_columns(table, (TIME_COLUMN, wanted), None, f"the header time [s], {second}")
    samples = np.array([column.values for column in columns])
    _check_samples(table.prefix, wanted.meaning, samples)
    return samples, f"; read {describe_columns(table, columns)}"


def velocity_file(key: str, path: Path) -> FromFile:
    """Return the segment of a file of times and velocities. Raises UserError."""
    samples, description = read_history(key, path, VELOCITY_COLUMN)
    return _segment(key, samples, description)


def velocity_arrays(where: str, table: dict[str, Any]) -> FromFile:
    """Return the segment of {"time": ..., "velocity": ...}, lists in s and m/s."""
    times, velocities = table["time"], table["velocity"]
    for name, values in ("time", times), ("velocity", velocities):
        if not isinstance(values, list):
            raise UserError(f"{where}.{name} = {values!r:.60}: must be a list of numbers")
    if len(times) != len(velocities):
        raise UserError(
            f"{where}: holds {len(times)} times and {len(velocities)} velocities; give equal "
            "numbers of both"
        )
    samples = np.array([[number(where, v) for v in values] for values in (times, velocities)])
    _check_samples(where, "a velocity", samples)
    return _segment(where, samples, "")


def _check_samples(key: str, meaning: str, samples: np.ndarray) -> None:
    """Raise UserError for times that do not increase and for missing values."""
    if not 2 <= samples.shape[1] <= MAX_SAMPLES:
        raise UserError(f"{key}: holds {samples.shape[1]} rows; must be 2 to {MAX_SAMPLES}")
    values = {"a time (s)": samples[0], meaning: samples[1]}
    check_rows(key, values, (-np.inf, -np.inf), "must be numbers; leave the row out")


def _segment(where: str, samples: np.ndarray, source: str) -> FromFile:
    """Return the segment of times (s) and velocities (m/s), shape (2, samples)."""
    times, velocities = samples
    if not np.any(velocities):
        raise UserError(f"{where}: all velocities are zero; use a segment hold")
    description = (
        f"{times.size} samples over {times[-1] - times[0]:g} s, {velocities.min():g} to "
        f"{velocities.max():g} m/s{source}"
    )
    return FromFile(tuple((times - times[0]).tolist()), tuple(velocities.tolist()), description)
