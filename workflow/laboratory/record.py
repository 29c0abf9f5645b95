"""Read one measured record: time, velocity and coefficient of friction, columns of a text file."""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..errors import UserError
from ..study import Rows, named_unit, rows_of_file

TIMES = {"s": 1.0, "ms": 1e-3, "min": 60.0}  # in s
VELOCITIES = {"m/s": 1.0, "mm/s": 1e-3, "um/s": 1e-6}  # in m/s
COLUMNS = ("a time", "a velocity", "a coefficient of friction")
OF_TIME = re.compile(r"[\[(]\s*(s|ms|min)\s*[\])]")
OF_VELOCITY = re.compile(r"(?<![\w/])([mu]?m/s)(?![\w²^])")


class Record(NamedTuple):
    """What was measured, in SI units; arrays of one shape, (samples,)."""

    name: str  # of the file
    time: np.ndarray  # s, increasing
    velocity: np.ndarray  # m/s, positive
    friction: np.ndarray  # coefficient of friction
    units: tuple[str, str]  # of times and velocities in the file


def read_record(
    path: Path,
    columns: tuple[int, ...] = (0, 1, 2),
    time: str | None = None,
    velocity: str | None = None,
) -> Record:
    """Return the record of a text file.

    columns : numbers, from 0, of time, velocity and friction. time, velocity : units; where they
    are not given the lines before the first row say them, and without that they are s and m/s.

    Raises UserError, naming file and line, for what is no number, for times that do not increase
    and for velocities that are not positive.
    """
    rows = rows_of_file("fit", path, columns, COLUMNS)
    header = " ".join(rows.header).replace("µ", "u").replace("μ", "u")
    units = (
        time or named_unit(f"fit {path}", "--time", OF_TIME, header) or "s",
        velocity or named_unit(f"fit {path}", "--velocity", OF_VELOCITY, header) or "m/s",
    )
    t, v, mu = rows.values
    back = np.flatnonzero(np.diff(t) <= 0.0)
    if back.size:
        i = int(back[0]) + 1
        raise _refused(path, rows, i, f"time {t[i]:g} does not come after {t[i - 1]:g}", "increase")
    still = np.flatnonzero(v <= 0.0)
    if still.size:
        i = int(still[0])
        raise _refused(path, rows, i, f"holds the velocity {v[i]:g}", "be greater than zero")
    return Record(path.name, t * TIMES[units[0]], v * VELOCITIES[units[1]], mu, units)


def _refused(path: Path, rows: Rows, index: int, found: str, must: str) -> UserError:
    return UserError(f"fit: line {rows.lines[index]} of {str(path)!r}: {found}; must {must}")
