"""The common alternatives, as a dataset."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from . import discretisation as disc
from .alternatives import affordable, available, run_march
from .errors import QUANTITIES, Reference, compare, observe
from .ladders import PARTS, point_coords
from .marches import MARCHES
from .points import Point, Surface, surface
from .sampling import seconds

SOLVERS = ("kernels", *MARCHES)
WARM = Point(0.5, 0.3, 1.0)


def alternatives(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return errors and times of all methods on the same lines.

    Error and time are missing where a method is not installed, fails or would take too long.
    """
    top = [disc.ladder_steps(point, settings["finest"]) for point in points]
    steps = max(top, key=len)
    shape = (len(points), len(SOLVERS), len(steps))
    error, time = np.full((*shape, 4), np.nan), np.full((*shape, 2), np.nan)
    for name in MARCHES:
        if available(name):  # compile and load before anything is timed
            run_march(name, WARM, [surface(WARM, 64, seed, i) for i in range(2)], 2)
    for k, point in enumerate(points):
        surfaces = [
            surface(point, settings["elements"], seed, i) for i in range(settings["march_lines"])
        ]
        limit = disc.reference(point, surfaces, settings["finest"])
        own = disc.climb(point, surfaces, "exponential", top[k], limit)
        error[k, 0, : len(top[k])] = [e.rms for e in own.errors]
        time[k, 0, : len(top[k])] = own.seconds
        for row, name in enumerate(MARCHES, start=1):
            wanted = affordable(name, point, settings["elements"], settings["march_updates"])
            for column, m in enumerate(w for w in wanted if w in steps and available(name)):
                error[k, row, column], time[k, row, column] = _marched(
                    name, point, surfaces, m, limit
                )
        advance()
    coords = point_coords(points) | {
        "solver": list(SOLVERS),
        "steps": steps,
        "quantity": list(QUANTITIES),
        "part": list(PARTS),
    }
    dims = ("point", "solver", "steps")
    texts = {"long_name": "rms error over lines, relative", "units": "1"}
    timed = {"long_name": "CPU time per realization, median", "units": "s"}
    return xr.Dataset(
        {"error": ((*dims, "quantity"), error, texts), "seconds": ((*dims, "part"), time, timed)},
        coords,
    )


def _marched(
    name: str, point: Point, surfaces: list[Surface], steps: int, limit: Reference
) -> tuple[np.ndarray, np.ndarray]:
    """Return errors (QUANTITIES,) and times (2,) of an alternative; NaN where it fails."""
    try:
        runs = run_march(name, point, surfaces, steps)
    except ArithmeticError:
        return np.full(4, np.nan), np.full(2, np.nan)
    found = observe(point, surfaces[0].elements, runs, limit.limit.mu_1.size, limit.end)
    return compare(found, limit).rms, seconds(runs)
