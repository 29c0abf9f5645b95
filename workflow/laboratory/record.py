"""Read one measured record, and part it into stretches of constant velocity and the steps between.

A record is a text file with the columns time, velocity and coefficient of friction.
"""

import re
from itertools import pairwise
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
LEAST_CHANGE = 0.02  # of log velocity: the smallest step that is looked for
LEAST_SAMPLES = 12  # of a stretch
CHANCE = 5.0  # standard errors by which the means of two stretches must differ


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


class MeasuredStep(NamedTuple):
    """One velocity step as it was measured."""

    name: str  # of the file, and which step of it
    v1: float  # m/s
    v2: float
    change: float  # s: between the last sample at v1 and the first at v2
    before: np.ndarray  # friction: the later half of sliding at v1, shape (samples,)
    time: np.ndarray  # s since the middle of the change, at v2, shape (n,)
    after: np.ndarray  # friction at these times

    @property
    def ratio(self) -> float:
        """Return v2/v1."""
        return self.v2 / self.v1


def measured_steps(record: Record, window: float | None = None) -> list[MeasuredStep]:
    """Return the velocity steps of a record, in order.

    window : seconds after each step that are looked at, at most; all by default. Raises UserError
    where there is no step.
    """
    stretches = constant_stretches(np.log(record.velocity))
    if len(stretches) < 2:
        raise UserError(
            f"fit {record.name}: holds no velocity step: no two stretches of {LEAST_SAMPLES} "
            f"samples or more at velocities {100 * LEAST_CHANGE:g} % apart"
        )
    found, t = [], record.time
    for number, (one, two) in enumerate(pairwise(stretches), 1):
        name = f"{record.name}, step {number}" if len(stretches) > 2 else record.name
        last, first = t[one.stop - 1], t[two.start]
        start, end = 0.5 * (last + first), two.stop
        if window is not None:
            end = min(end, int(np.searchsorted(t, start + window, side="right")))
        if end - two.start < LEAST_SAMPLES:
            raise UserError(
                f"fit {name}: {max(end - two.start, 0)} samples within {window:g} s of the step; a "
                f"fit needs {LEAST_SAMPLES}: give a longer --window"
            )
        step = MeasuredStep(
            name=name,
            v1=float(record.velocity[one].mean()),
            v2=float(record.velocity[two].mean()),
            change=float(first - last),
            before=record.friction[(one.start + one.stop) // 2 : one.stop],
            time=t[two.start : end] - start,
            after=record.friction[two.start : end],
        )
        found.append(step)
    return found


def constant_stretches(values: np.ndarray) -> list[slice]:
    """Return where values are constant but for noise, in order; what lies between is left out.

    The values are cut in two where that reduces their scatter most, and the parts again, as long
    as the means of the parts differ; parts that are short, or in which they go up or down, are a
    change of velocity that takes its time. Neighbours of one mean are one stretch.
    """
    noise = float(np.median(np.abs(np.diff(values)))) / (0.6745 * np.sqrt(2.0))
    open_parts, done = [(0, values.size)], []
    while open_parts:
        start, stop = open_parts.pop()
        cut = _cut(values[start:stop], noise)
        if cut is None:
            done.append(slice(start, stop))
        else:
            open_parts += [(start, start + cut), (start + cut, stop)]
    parts = []
    for part in sorted(done, key=lambda part: part.start):
        own = values[part]
        place = np.linspace(-0.5, 0.5, own.size)
        if own.size >= LEAST_SAMPLES and abs(place @ own / (place @ place)) < LEAST_CHANGE:
            parts.append(part)
    joined: list[slice] = []
    for part in parts:
        if joined and abs(values[part].mean() - values[joined[-1]].mean()) < LEAST_CHANGE:
            joined[-1] = slice(joined[-1].start, part.stop)
        else:
            joined.append(part)
    return joined


def _cut(values: np.ndarray, noise: float) -> int | None:
    """Return after how many values their mean changes most; None where it does not."""
    n = values.size
    if n < 2:
        return None
    left = np.arange(1, n)
    sums = np.cumsum(values)
    difference = (sums[-1] - sums[:-1]) / (n - left) - sums[:-1] / left
    weight = left * (n - left) / n
    best = int(np.argmax(weight * difference**2))
    least = max(LEAST_CHANGE, CHANCE * noise / np.sqrt(weight[best]))
    return best + 1 if abs(difference[best]) > least else None
