"""Common definitions of the figures of several studies."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, LogNorm, Normalize, to_hex

from elastomer_friction.workflow.reduce import FITTED
from elastomer_friction.workflow.report import COLOURS
from elastomer_friction.workflow.study import Study, read_grid_study

CONVERGED, PAPER_STEP = "", "paper_step"  # groups of a result; the first is the study itself
VARIANTS = {
    CONVERGED: "converged in time",
    PAPER_STEP: "implicit Euler, one step per $\\Delta x$",
}
# Colour and marker of each variant in all figures, distinct from the colours of H and of forces.
SCHEMES: dict[str, dict[str, Any]] = {
    CONVERGED: {"color": "#000000", "marker": "o"},
    PAPER_STEP: {"color": "#D55E00", "marker": "s"},
}
ASIDE = {CONVERGED: -0.01, PAPER_STEP: 0.01}  # of H, to tell overlapping markers apart
MAX_LIGHTNESS = 0.8  # largest value in a colour map; lighter lines are too pale for print
X_LABEL = "$x = v_1 \\tau q_\\mathrm{max}$"
# Marker and line style of each body, distinct from those of unresolved points.
BODIES: dict[str, dict[str, Any]] = {
    "": {"marker": "o", "ls": "-"},
    "foundation": {"marker": "s", "ls": "--"},
}
TEMPERATURE_COLOURS = (COLOURS[0], COLOURS[3], COLOURS[4])  # from the lowest temperature on
MAX_RATE_ERROR = 0.15  # relative standard error of b for a point to count in claims
NEARLY_FULL = 0.8  # contact fraction from which a contact counts as full
DOTS: dict[str, Any] = {"fmt": "o", "ms": 2.4, "mew": 0.5, "lw": 0.5, "capsize": 0}


def shades(low: float, high: float, log: bool = True) -> ScalarMappable:
    """Return a colour map from ``low`` to ``high``, without its pale end."""
    dark = mpl.colormaps["viridis"](np.linspace(0.0, MAX_LIGHTNESS, 256))
    norm = LogNorm(low, high) if log else Normalize(low, high)
    return ScalarMappable(norm, LinearSegmentedColormap.from_list("dark", dark))


def by_hurst(dataset: xr.Dataset) -> Iterator[tuple[float, xr.Dataset, str]]:
    """Yield every Hurst exponent, its points along "point", and its colour in all figures."""
    colours = shades(0.0, 1.0, log=False)
    for hurst in dataset.hurst.values:
        points = dataset.sel(hurst=hurst)
        yield (
            float(hurst),
            points.stack(point=points.mu_1.dims),
            to_hex(tuple(colours.to_rgba(np.array([hurst]))[0])),
        )


def computed_study(data: xr.Dataset) -> Study:
    """Return the study that a result was computed from, without reading other files."""
    return read_grid_study("", Path(), json.loads(data.attrs["study"]))


def shift_factors(data: xr.Dataset) -> np.ndarray:
    """Return a_T at the temperatures of a result, shape (temperatures,)."""
    material = computed_study(data).material
    return np.array([material.shift(t) for t in data.temperature.values])


def fitted(points: xr.Dataset) -> xr.Dataset:
    """Return points with a relaxation rate of NaN unless eq. 6 was fitted."""
    rate = points.relaxation_rate.where(points.fit_status == FITTED)
    return points.assign(relaxation_rate=rate)


def ratio_of(data: xr.Dataset, other: xr.Dataset, name: str) -> xr.Dataset:
    """Return ``ratio``, a variable divided by that of another result, and ``ratio_error``.

    Relative errors add in quadrature, as for independent ensembles.
    """
    ratio = data[name] / other[name]
    parts = (data[f"{name}_error"] / data[name], other[f"{name}_error"] / other[name])
    return xr.Dataset({"ratio": ratio, "ratio_error": np.abs(ratio) * np.hypot(*parts)})


def slide_of(data: xr.Dataset, segment: int) -> xr.Dataset:
    """Return the trace in a segment of the programme, with ``slid``, the distance (m) slid in it.

    data : without axes of length 1.
    """
    before, inside = (
        data.isel(event=data.trace_segment.values == k) for k in (segment - 1, segment)
    )
    return inside.assign(slid=inside.trace_distance - float(before.trace_distance[-1]))


def usable(points: xr.Dataset) -> xr.DataArray:
    """Return a mask of points short of full contact where the fitted b has a small error."""
    small = points.relaxation_rate_error < MAX_RATE_ERROR * points.relaxation_rate
    return (points.fit_status == FITTED) & small & (points.contact_fraction < NEARLY_FULL)


def significant_jumps(points: xr.Dataset) -> xr.Dataset:
    """Return points with a jump of NaN where it is below two standard errors."""
    return points.assign(jump=points.jump.where(points.jump > 2.0 * points.jump_error))


def normalised(points: xr.Dataset) -> xr.Dataset:
    """Add mu_bar, mu_1 over grad z, and jump_bar, the jump over grad z dv/v1 (eqs. 11, 12)."""
    slope, step = points.rms_slope, points.velocity_step
    return points.assign(
        mu_bar=points.mu_1 / slope,
        mu_bar_error=points.mu_1_error / slope,
        jump_bar=points.jump / slope / step,
        jump_bar_error=points.jump_error / slope / np.abs(step),
    )
