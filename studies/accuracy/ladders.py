"""Both schemes over m at all points, and sampling errors: as datasets."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from . import discretisation as disc
from .errors import QUANTITIES
from .points import Point, surface
from .sampling import Method, run
from .sampling_error import COUNTS, sampling_errors

TARGETS = (0.1, 0.03, 0.01, 0.003, 0.001)
TEXTS = {  # name: long_name, units
    "error": ("rms error over lines; rate: of the mean curve", "1"),
    "bias": ("error of the mean over lines, signed", "1"),
    "bias_error": ("standard error of the bias", "1"),
    "seconds": ("CPU time per realization, median", "s"),
    "order": ("measured order of convergence in 1/m", "1"),
    "reference_error": ("stated error of the reference", "1"),
    "deviation": ("standard deviation of one realization", "1"),
}


def warm_up() -> None:
    """Compile everything that is timed."""
    point = Point(0.5, 0.1, 3.0)
    for scheme in disc.SCHEMES:
        run(point, [surface(point, 64, 0, 0)], Method(scheme, 2))


def discretisations(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> tuple[xr.Dataset, xr.Dataset]:
    """Return errors, times, orders and what follows from them for all points.

    The first dataset is of both schemes with narrow contacts refined, as "auto" does. The second
    is of the exponential scheme with nothing refined, as in a study whose m is a number. Errors
    are relative, those of curves to the jump; missing at m that a point does not need.
    """
    found, plain = [], []
    for point in points:
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(settings["lines"])]
        limit = disc.reference(point, surfaces, settings["finest"])
        steps = disc.ladder_steps(point, settings["finest"])
        ladders = [disc.climb(point, surfaces, scheme, steps, limit) for scheme in disc.SCHEMES]
        both = xr.concat(ladders, "scheme")
        both["reference_error"] = ("quantity", limit.error)
        found.append(both.assign(deviation=ladders[0].deviation))
        plain.append(disc.climb(point, surfaces, disc.SCHEMES[0], steps, limit, refine=False))
        advance()
    data = together(found, points, TEXTS).assign_coords(
        scheme=list(disc.SCHEMES), target=list(TARGETS)
    )
    own = {name: text for name, text in TEXTS.items() if name in plain[0]}
    as_sampled = together(plain, points, own)
    for each in (data, as_sampled):
        each.steps.attrs["long_name"] = "m, steps and samples per spacing"
    data.target.attrs["long_name"] = "relative error aimed at"
    return data, as_sampled


def together(
    found: list[xr.Dataset], points: tuple[Point, ...], texts: dict[str, tuple[str, str]]
) -> xr.Dataset:
    """Return the datasets of points as one that says what the points and the variables are."""
    data = xr.concat(found, "point", join="outer").assign_coords(point_coords(points))
    for name, (text, unit) in texts.items():
        data[name].attrs = {"long_name": text, "units": unit}
    return data.assign_coords(quantity=list(QUANTITIES), part=list(disc.PARTS))


def point_coords(points: tuple[Point, ...]) -> dict:
    """Return the coordinates that say what the points are."""
    return {
        "point": [point.name for point in points],
        "hurst": ("point", [point.hurst for point in points], {"long_name": "Hurst exponent H"}),
        "load": ("point", [point.load for point in points], {"long_name": "F_N/(4 G L h)"}),
        "x": ("point", [point.x for point in points], {"long_name": "v1 tau q_max"}),
    }


def sampling(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return the error of the mean of R realizations at all points."""
    found = []
    for point in points:
        count = settings["realizations"]
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(count)]
        steps = int(2 ** np.clip(np.ceil(np.log2(0.2 / point.speed)), 2, 5))
        found.append(sampling_errors(point, surfaces, steps))
        advance()
    coords = point_coords(points) | {"realizations": list(COUNTS), "sampled": list(QUANTITIES[:3])}
    text = {"long_name": "rms relative error of the mean of R realizations", "units": "1"}
    error = (("point", "realizations", "sampled"), np.array(found), text)
    return xr.Dataset({"error": error}, coords)
