"""What the report says of a drawn point on which a pointer rests: its value, error and place."""

from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..study import AXES

SYMBOLS = {
    "hurst": "H",
    "normal_force": "F_N",
    "spacing": "Δx",
    "roughness": "h",
    "velocity": "v₁",
    "velocity_step": "Δv/v₁",
    "speed_ratio": "x",
    "mu_1": "µ₁",
    "mu": "µ",
    "jump": "Δµ₀",
    "jump_over_step": "Δµ₀/(Δv/v₁)",
    "relaxation_rate": "b",
    "alpha": "α",
}


class HoverPoint(NamedTuple):
    """A point of a drawn figure and what is said of it."""

    x: float  # share of the figure's width, from the left
    y: float  # share of its height, from above
    text: str


_remembered: WeakKeyDictionary[Axes, list[tuple[float, float, str]]] = WeakKeyDictionary()


def remember(
    ax: Axes, points: xr.Dataset, name: str, over: str, error: np.ndarray, aside: float = 0.0
) -> None:
    """Remember the finite points of an estimate that have been drawn over another variable.

    error : as drawn, of the shape of the estimate. aside : by how much they are drawn beside.
    """
    estimate = points[name]
    # Of an exponent per H alone there is no velocity to name.
    places = [a for a in AXES if a in points.coords and {*points[a].dims} <= {*estimate.dims}]
    values = {each: _flat(points[each], estimate) for each in (name, over, *places)}
    across, up, errors = values[over] + aside, values[name], np.ravel(error)
    for i in np.flatnonzero(np.isfinite(across) & np.isfinite(up)):
        said = [
            f"{SYMBOLS.get(name, name)} = {values[name][i]:.4g} ± {errors[i]:.2g}{_unit(estimate)}"
        ]
        said += [
            f"{SYMBOLS.get(each, each)} = {values[each][i]:.4g}{_unit(points[each])}"
            for each in dict.fromkeys((over, *places))
        ]
        text = f"{said[0]}\n{', '.join(said[1:])}"
        _remembered.setdefault(ax, []).append((across[i], up[i], text))


def remembered(figure: Figure) -> list[HoverPoint]:
    """Return the points that lie within their axes; the figure must have been laid out."""
    found = []
    for ax in figure.axes:
        for x, y, text in _remembered.get(ax, []):
            across, up = ax.transData.transform((x, y))
            if ax.bbox.contains(across, up):
                shares = across / figure.bbox.width, 1.0 - up / figure.bbox.height
                found.append(HoverPoint(float(shares[0]), float(shares[1]), text))
    return found


def _flat(variable: xr.DataArray, like: xr.DataArray) -> np.ndarray:
    return np.ravel(variable.broadcast_like(like).transpose(*like.dims).values)


def _unit(variable: xr.DataArray) -> str:
    unit = str(variable.attrs.get("units", "1")).replace("s-1", "s⁻¹")
    return "" if unit == "1" else f" {unit}"
