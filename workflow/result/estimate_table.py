"""Short table of a result for the terminal: estimates with their errors at each point."""

import math

import numpy as np
import xarray as xr

from ..ground import with_error

MAX_POINTS = 12  # of a result that is shown as a table
ESTIMATES = (  # columns, if the result has them
    "mu_1",
    "mu_1_viscoelastic",
    "mu_1_shear",
    "contact_temperature",
    "jump",
    "relaxation_rate",
    "model_ratio",
)


def short_table(data: xr.Dataset) -> list[str]:
    """Return the lines of a table of a small result; none for a result of many points.

    An estimate has its standard error and the bound of its discretisation error, in percent.
    ``model_ratio``, the error of the model, has a standard error alone. A point at which contacts
    are narrower than a sample is marked as unresolved.
    """
    names = [name for name in ESTIMATES if name in data]
    if not names or data[names[0]].size > MAX_POINTS:  # before any value is read
        return []
    names = [name for name in names if np.isfinite(data[name]).any()]
    if not names:
        return []
    axes = [str(axis) for axis in data[names[0]].dims]
    varied = [axis for axis in axes if data.sizes[axis] > 1] or ["velocity"]
    pressures = "normal_pressure" in data.coords
    varied = ["normal_pressure" if pressures and a == "normal_force" else a for a in varied]
    units = [data[axis].attrs["units"] for axis in varied]
    titles = [f"{a} ({unit})".removesuffix(" (1)") for a, unit in zip(varied, units, strict=True)]
    rows = [[*titles, *names, ""]]
    for index in np.ndindex(data[names[0]].shape):
        point = data.isel(dict(zip(axes, index, strict=True)))
        values = [f"{float(point[axis]):.4g}" for axis in varied]
        mark = "unresolved" if int(point.get("resolution_status", 1)) == 0 else ""
        rows.append([*values, *(_cell(point, name) for name in names), mark])
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]


def _cell(point: xr.Dataset, name: str) -> str:
    """Return an estimate with its errors as text."""
    value, error, bias = (
        float(point[key]) if key in point else math.nan
        for key in (name, f"{name}_error", f"{name}_bias")
    )
    if math.isnan(value):
        return "not determined"
    text = with_error(value, error)
    return f"{text}, bias < {100.0 * bias:.2g} %" if bias > 0.0 else text
