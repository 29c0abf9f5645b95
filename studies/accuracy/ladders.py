"""Both schemes over m at all points, and sampling errors: as datasets."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from . import discretisation as disc
from .errors import QUANTITIES
from .points import Point, Surface, surface
from .sampling import Method, run
from .sampling_error import COUNTS, sampling_errors

TARGETS = (0.1, 0.03, 0.01, 0.003, 0.001)
PARTS = ("mu_1 and jump", "everything")


def warm_up() -> None:
    """Compile everything that is timed."""
    point = Point(0.5, 0.1, 3.0)
    for scheme in disc.SCHEMES:
        run(point, [surface(point, 64, 0, 0)], Method(scheme, 2))


# name: (dimensions, long_name, unit)
DECLARED = {
    "error": ("point scheme steps quantity", "rms error over lines; rate: of the mean curve", "1"),
    "bias": ("point scheme steps quantity", "error of the mean over lines, signed", "1"),
    "bias_error": ("point scheme steps quantity", "standard error of the bias", "1"),
    "seconds": ("point scheme steps part", "CPU time per realization, median", "s"),
    "order": ("point scheme quantity", "measured order of convergence in 1/m", "1"),
    "reference_error": ("point quantity", "stated error of the reference", "1"),
    "deviation": ("point quantity", "standard deviation of one realization", "1"),
}


def discretisations(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return errors, times, orders and what follows from them for all points.

    Errors are relative, those of curves to the jump.
    """
    steps = max((disc.ladder_steps(p, settings["finest"]) for p in points), key=len)
    coords = point_coords(points) | {
        "scheme": list(disc.SCHEMES),
        "steps": ("steps", steps, {"long_name": "m, steps and samples per spacing"}),
        "quantity": list(QUANTITIES),
        "part": list(PARTS),
        "target": list(TARGETS),
    }
    data = xr.Dataset(coords=coords)
    for name, (dims, text, unit) in DECLARED.items():
        empty = np.full([data.sizes[dim] for dim in dims.split()], np.nan)
        data[name] = (dims.split(), empty, {"long_name": text, "units": unit})
    for k, point in enumerate(points):
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(settings["lines"])]
        _fill(data, k, point, surfaces, settings["finest"])
        advance()
    return data


def _fill(data: xr.Dataset, k: int, point: Point, surfaces: list[Surface], finest: int) -> None:
    """Measure point number k and enter it."""
    limit = disc.reference(point, surfaces, finest)
    data["reference_error"][k] = limit.error
    steps = disc.ladder_steps(point, finest)
    rows = slice(0, len(steps))
    ladders = [disc.climb(point, surfaces, scheme, steps, limit) for scheme in disc.SCHEMES]
    for s, ladder in enumerate(ladders):
        data["error"][k, s, rows] = [e.rms for e in ladder.errors]
        data["bias"][k, s, rows] = [e.bias for e in ladder.errors]
        data["bias_error"][k, s, rows] = [e.bias_error for e in ladder.errors]
        data["seconds"][k, s, rows] = ladder.seconds
        data["order"][k, s] = disc.orders(ladder, limit)
    data["deviation"][k] = disc.spread(ladders[0])


def point_coords(points: tuple[Point, ...]) -> dict:
    """Return the coordinates that say what the points are."""
    return {
        "point": [point.name for point in points],
        "hurst": ("point", [point.hurst for point in points]),
        "load": ("point", [point.load for point in points], {"long_name": "F_N/(4 G L h)"}),
        "x": ("point", [point.x for point in points], {"long_name": "v1 tau q_max"}),
    }


def sampling(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return the error of the mean of R realizations at all points."""
    found = np.empty((len(points), len(COUNTS), 3))
    for k, point in enumerate(points):
        count = settings["realizations"]
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(count)]
        steps = int(2 ** np.clip(np.ceil(np.log2(0.2 / point.speed)), 2, 5))
        found[k] = sampling_errors(point, surfaces, steps)
        advance()
    coords = point_coords(points) | {"realizations": list(COUNTS), "sampled": list(QUANTITIES[:3])}
    text = {"long_name": "rms relative error of the mean of R realizations", "units": "1"}
    return xr.Dataset({"error": (("point", "realizations", "sampled"), found, text)}, coords)
