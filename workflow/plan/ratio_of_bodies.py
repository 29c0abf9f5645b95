"""Error of the model: simulated friction of the foundation over that of a half-space.

The study `bodies` makes ratio_of_bodies.csv (studies/bodies/ratio_table.py) at equal nominal
pressure, F_N = sigma_0 lambda_r L on the foundation. Between table rows the logarithm of the ratio
is linear in H and in the logarithms of waves, load and x. Outside the table the ratio is unknown.
"""

import csv
import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...kernels import KELVIN
from ..simulate import Problem
from ..study import HALF_SPACE
from .problems import line_slope, speed_ratio

TABLE = Path(__file__).with_name("ratio_of_bodies.csv")
KINDS = ("kelvin", "broad")  # one relaxation time, or many
UNKNOWN = math.nan, math.nan
ROUNDING = 1e-5  # relative distance by which a point may lie outside the table


class InTable(NamedTuple):
    """Coordinates of a problem in the table."""

    kind: str
    waves: float  # lambda_r q_max/(2 pi): number of shortest waves in the longest
    hurst: float
    load: float  # sigma_0/(E* grad z)
    speed_ratio: float  # x = v1 tau q_max


def nominal_pressure(problem: Problem) -> float:
    """Return the nominal pressure, in E* h/dx; on a foundation F_N = sigma_0 lambda_r L."""
    longest = max(problem.surface.rolloff, 1.0)  # wave number of lambda_r, in 2 pi/L
    shared = 1.0 if problem.surface.body == HALF_SPACE else longest
    return problem.load * shared / problem.elements


def place_of(problem: Problem, normalisation: str = "modal") -> InTable:
    """Return the coordinates of a problem in the table, on either body."""
    longest = max(problem.surface.rolloff, 1.0)  # wave number of lambda_r, in 2 pi/L
    last = problem.surface.cutoff or problem.elements // 2
    kind = KINDS[problem.spectrum != KELVIN]
    load = nominal_pressure(problem) / line_slope(problem, normalisation)
    return InTable(kind, last / longest, problem.hurst, load, float(speed_ratio(problem)))


def model_ratio(problem: Problem, normalisation: str = "modal") -> tuple[float, float]:
    """Return mu_1 of the foundation over that of a half-space, and its error; NaN where unknown."""
    if problem.surface.measured or problem.programme:
        return UNKNOWN
    place = place_of(problem, normalisation)
    table = _table().get(place.kind, {})

    def at_hurst(entries: dict[float, Any]) -> np.ndarray | None:
        return _between(entries, place.hurst, lambda points: _of_point(points, place), float)

    ratios = _between(table, place.waves, at_hurst, np.log)
    if ratios is None:
        return UNKNOWN
    ratio = math.exp(ratios[0])
    return ratio, ratio * float(ratios[1])


def _of_point(entries: dict[str, np.ndarray], place: InTable) -> np.ndarray | None:
    """Return (ln ratio, relative error) at a load and speed, interpolated; None outside."""
    ratios = []
    for name in ("ratio", "error"):
        along = [
            _inside(np.log(place.speed_ratio), np.log(entries["speed_ratio"]), row)
            for row in entries[name]
        ]
        ratios.append(_inside(np.log(place.load), np.log(entries["load"]), np.array(along)))
    return None if np.isnan(ratios).any() else np.array(ratios)


def _inside(at: float, x: np.ndarray, values: np.ndarray) -> float:
    """Return ``values`` interpolated linearly at ``at``, or NaN outside ``x``."""
    if not x[0] - ROUNDING <= at <= x[-1] + ROUNDING:
        return math.nan
    return float(np.interp(at, x, values))


def _between(
    table: dict[float, Any], at: float, value: Callable, scale: Callable
) -> np.ndarray | None:
    """Return the value interpolated between the two table keys next to ``at``, or None outside."""
    below = [key for key in table if key <= at * (1.0 + ROUNDING) + 1e-12]
    above = [key for key in table if key >= at * (1.0 - ROUNDING) - 1e-12]
    if not (below and above):
        return None
    low, high = max(below), min(above)
    first, last = value(table[low]), value(table[high])
    if low >= high or first is None or last is None:
        return first if last is not None else None
    share = (scale(at) - scale(low)) / (scale(high) - scale(low))
    return (1.0 - share) * first + share * last


@cache
def _table() -> dict[str, dict[float, dict[float, dict[str, np.ndarray]]]]:
    """Return kind -> waves -> H -> columns: ln ratio and its error over (load, x)."""
    ratios: dict = {}
    with TABLE.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            of_waves = ratios.setdefault(row.pop("kind"), {})
            waves, hurst, load, x, ratio, error = map(float, row.values())
            points = of_waves.setdefault(waves, {}).setdefault(hurst, {})
            points[load, x] = math.log(ratio), error / ratio
    return {
        kind: {
            waves: {hurst: _columns(points) for hurst, points in entries.items()}
            for waves, entries in of_waves.items()
        }
        for kind, of_waves in ratios.items()
    }


def _columns(points: dict[tuple[float, float], tuple[float, float]]) -> dict[str, np.ndarray]:
    loads, speeds = (np.unique(axis) for axis in zip(*points, strict=True))
    grid = np.array([[points.get((f, x), UNKNOWN) for x in speeds] for f in loads])
    return {"load": loads, "speed_ratio": speeds, "ratio": grid[..., 0], "error": grid[..., 1]}
