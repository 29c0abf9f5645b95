"""Errors and times of all discretisations of one point, against its reference."""

import math

import numpy as np
import xarray as xr

from .errors import Reference, compare, deviations, extrapolate, observe, order
from .points import Point, Surface
from .sampling import Method, run, seconds

SCHEMES = ("exponential", "implicit-euler")
LEAST_LINES = 20  # a rate is claimed from 18 on
PARTS = ("mu_1 and jump", "everything")  # of the time


def ladder_steps(point: Point, most: int) -> list[int]:
    """Return m = 1, 2, 4 ... up to ``most``, further where tau is not resolved by then."""
    top = max(most, 2 ** math.ceil(math.log2(2.4 / point.speed)))
    return [2**k for k in range(int(math.log2(top)) + 1)]


def lines_at(steps: int, most: int) -> int:
    """Return the number of lines at m: fewer where they cost more."""
    return max(min(LEAST_LINES, most), min(most, 8 * most // steps))


def reference(point: Point, surfaces: list[Surface], most: int) -> Reference:
    """Return the reference of a point, extrapolated from twice the finest m."""
    finest = ladder_steps(point, most)[-1]
    lines = lines_at(2 * finest, len(surfaces))
    fine = run(point, surfaces[:lines], Method("exponential", 2 * finest))
    coarse = run(point, surfaces[:lines], Method("exponential", finest))
    end, elements = float(fine.moments[-1]), surfaces[0].elements
    limit = observe(point, elements, fine, lines, end)
    return extrapolate(limit, observe(point, elements, coarse, lines, end), end)


def climb(
    point: Point,
    surfaces: list[Surface],
    scheme: str,
    steps: list[int],
    limit: Reference,
    refine: bool = True,
) -> xr.Dataset:
    """Return what a scheme gives over m; errors are those on the lines of the reference.

    refine : whether narrow contacts are refined, as "auto" does. The deviation of one realization
    is that at a middle m, on all lines.
    """
    paired, elements = limit.limit.mu_1.size, surfaces[0].elements
    rows, apart = [], []
    for m in steps:
        runs = run(point, surfaces[: lines_at(m, len(surfaces))], Method(scheme, m, refine))
        found = compare(observe(point, elements, runs, paired, limit.end), limit)
        rows.append((*found, seconds(runs)))
        apart.append(deviations(observe(point, elements, runs, runs.mu_1.size, limit.end)))
    rms, bias, bias_error, cpu = (np.array(column) for column in zip(*rows, strict=True))
    middle = next((k for k in range(2, len(steps)) if np.isfinite(apart[k]).all()), 2)
    orders = [order(np.array(steps), rms[:, q], 2.0 * limit.error[q]) for q in range(4)]
    return xr.Dataset(
        {
            "error": (("steps", "quantity"), rms),
            "bias": (("steps", "quantity"), bias),
            "bias_error": (("steps", "quantity"), bias_error),
            "seconds": (("steps", "part"), cpu),
            "order": ("quantity", orders),
            "deviation": ("quantity", apart[middle]),
        },
        {"steps": steps},
    )
