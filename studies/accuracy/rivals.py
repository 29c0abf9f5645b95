"""The common alternatives, as a dataset."""

import contextlib
from collections.abc import Callable

import numpy as np
import xarray as xr

from . import discretisation as disc
from .alternatives import affordable, run_march
from .errors import Reference, compare, observe
from .ladders import together
from .marches import MARCHES
from .points import Point, Surface, surface
from .sampling import seconds

SOLVERS = ("kernels", *MARCHES)
WARM = Point(0.5, 0.3, 1.0)
TEXTS = {
    "error": ("rms error over lines, relative", "1"),
    "seconds": ("CPU time per realization, median", "s"),
}


def alternatives(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return errors and times of all methods on the same lines, over (compared, solver, tried).

    Points and steps per spacing are fewer than those of the ladders, and named otherwise: groups
    of one file share the dimensions of its root. Error and time are missing where a method is not
    installed, fails or would take too long.
    """
    elements, finest = settings["elements"], settings["finest"]
    every = max((disc.ladder_steps(point, finest) for point in points), key=len)
    for name in MARCHES:
        with contextlib.suppress(ImportError):  # load everything before it is timed
            run_march(name, WARM, [surface(WARM, 64, seed, i) for i in range(2)], 2)
    found = []
    for point in points:
        surfaces = [surface(point, elements, seed, i) for i in range(settings["march_lines"])]
        limit = disc.reference(point, surfaces, finest)
        steps = disc.ladder_steps(point, finest)
        ways = [disc.climb(point, surfaces, "exponential", steps, limit)[list(TEXTS)]]
        for name in MARCHES:
            most = affordable(name, point, elements, settings["march_updates"])
            ways.append(_marched(name, point, surfaces, [m for m in every if m <= most], limit))
        found.append(xr.concat(ways, "solver", join="outer"))
        advance()
    data = together(found, points, TEXTS).assign_coords(solver=list(SOLVERS))
    return data.rename(point="compared", steps="tried")


def _marched(
    name: str, point: Point, surfaces: list[Surface], steps: list[int], limit: Reference
) -> xr.Dataset:
    """Return errors and times of an alternative over m; NaN where it fails."""
    error, time = np.full((len(steps), 4), np.nan), np.full((len(steps), 2), np.nan)
    for row, m in enumerate(steps):
        with contextlib.suppress(ImportError, ArithmeticError):
            runs = run_march(name, point, surfaces, m)
            elements, lines = surfaces[0].elements, limit.limit.mu_1.size
            error[row] = compare(observe(point, elements, runs, lines, limit.end), limit).rms
            time[row] = seconds(runs)
    data = {"error": (("steps", "quantity"), error), "seconds": (("steps", "part"), time)}
    return xr.Dataset(data, {"steps": steps})
