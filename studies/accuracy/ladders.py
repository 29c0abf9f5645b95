"""Both schemes over m at all points, float32, multilevel gains, sampling errors: as datasets."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from . import discretisation as disc
from .errors import QUANTITIES
from .points import Point, surface
from .sampling import Method, run
from .sampling_error import COUNTS, sampling_errors

TARGETS = (0.1, 0.03, 0.01, 0.003, 0.001)
SINGLE_STEPS = (1, 2, 4, 8, 16)
PARTS = ("mu_1 and jump", "everything")


def warm_up() -> None:
    """Compile everything that is timed."""
    point = Point(0.5, 0.1, 3.0)
    for scheme in disc.SCHEMES:
        for single in (False, True):
            run(point, [surface(point, 64, 0, 0)], Method(scheme, 2, single))


def discretisations(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return errors, times, orders and what follows from them for all points."""
    top = [disc.ladder_steps(point, settings["finest"]) for point in points]
    steps = max(top, key=len)
    shape = (len(points), 2, len(steps), 4)
    data = {name: np.full(shape, np.nan) for name in ("error", "bias", "bias_error")}
    data["seconds"] = np.full((*shape[:3], 2), np.nan)
    data["order"] = np.full((len(points), 2, 4), np.nan)
    data["reference_error"] = np.full((len(points), 4), np.nan)
    data["deviation"] = np.full((len(points), 4), np.nan)
    data["multilevel_gain"] = np.full((len(points), len(TARGETS), 3), np.nan)
    data["single_error"] = np.full((len(points), len(SINGLE_STEPS), 4), np.nan)
    data["single_time"] = np.full((len(points), len(SINGLE_STEPS), 2), np.nan)
    for k, point in enumerate(points):
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(settings["lines"])]
        limit = disc.reference(point, surfaces, settings["finest"])
        data["reference_error"][k] = limit.error
        for s, scheme in enumerate(disc.SCHEMES):
            ladder = disc.climb(point, surfaces, scheme, top[k], limit)
            rows = slice(0, len(top[k]))
            data["error"][k, s, rows] = [e.rms for e in ladder.errors]
            data["bias"][k, s, rows] = [e.bias for e in ladder.errors]
            data["bias_error"][k, s, rows] = [e.bias_error for e in ladder.errors]
            data["seconds"][k, s, rows] = ladder.seconds
            data["order"][k, s] = disc.orders(ladder, limit)
            if s == 0:
                data["deviation"][k] = disc.spread(ladder)
                data["multilevel_gain"][k] = disc.gains(ladder, TARGETS)
                found = disc.single_precision(point, surfaces, ladder, limit, SINGLE_STEPS)
                data["single_error"][k], data["single_time"][k] = found
        advance()
    return _labelled(points, data, steps)


def _labelled(points: tuple[Point, ...], data: dict[str, np.ndarray], steps: list[int]):
    dims = {
        "error": ("point", "scheme", "steps", "quantity"),
        "bias": ("point", "scheme", "steps", "quantity"),
        "bias_error": ("point", "scheme", "steps", "quantity"),
        "seconds": ("point", "scheme", "steps", "part"),
        "order": ("point", "scheme", "quantity"),
        "reference_error": ("point", "quantity"),
        "deviation": ("point", "quantity"),
        "multilevel_gain": ("point", "target", "sampled"),
        "single_error": ("point", "single_steps", "quantity"),
        "single_time": ("point", "single_steps", "part"),
    }
    names = {
        "error": "rms error over lines, relative (rate: bias; curve: relative to the jump)",
        "bias": "error of the mean over lines, relative, signed",
        "bias_error": "standard error of the bias",
        "seconds": "CPU time per realization, median",
        "order": "measured order of convergence in 1/m",
        "reference_error": "stated error of the extrapolated reference, relative",
        "deviation": "standard deviation of one realization, relative",
        "multilevel_gain": "cost of plain over multilevel Monte Carlo at equal error",
        "single_error": "error with the line in float32",
        "single_time": "CPU time with the line in float32 over that with float64",
    }
    coords = {
        **point_coords(points),
        "scheme": list(disc.SCHEMES),
        "steps": ("steps", steps, {"long_name": "m, steps and samples per spacing"}),
        "quantity": list(QUANTITIES),
        "part": list(PARTS),
        "target": list(TARGETS),
        "sampled": list(QUANTITIES[:3]),
        "single_steps": list(SINGLE_STEPS),
    }
    units = {"seconds": "s"}
    return xr.Dataset(
        {
            name: (dims[name], values, {"long_name": names[name], "units": units.get(name, "1")})
            for name, values in data.items()
        },
        coords,
    )


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
