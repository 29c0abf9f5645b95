"""How all figures look: style, colours, error bars, hollow markers, what captions add."""

from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..study import ALL_AXES
from .in_words import said, unit_in_words, with_unit
from .unresolved import not_resolved, why_hollow

STYLE: dict[str, Any] = {
    "figure.dpi": 150,
    "savefig.dpi": 200,
    "font.size": 8.0,
    "axes.labelsize": 8.5,
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.formatter.useoffset": False,
    "figure.constrained_layout.use": True,
    "legend.fontsize": 7.0,
    "legend.frameon": False,
    "lines.linewidth": 1.0,
    "lines.markersize": 3.0,
    "errorbar.capsize": 1.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "pdf.fonttype": 42,
}

PLAINLY = 1e-3, 2e3  # between these an axis of two decades has plain numbers
TOLD = 40  # most points of a curve that a pointer can find in the report

# Okabe and Ito: distinguishable with any colour vision.
COLOURS = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00", "#56B4E9", "#000000")

# Hollow markers are larger than filled ones, and white inside: apart in print as well.
RING: dict[str, Any] = {"mfc": "white", "mew": 0.9, "ms": 3.4, "gid": "hollow"}


def foot_line(figure: Figure, dataset: xr.Dataset, note: str = "", bars: str = "bars") -> None:
    """Say in the caption of a figure how large the study was, and from which seed.

    note : sentences that follow. bars : what shows the standard errors. Where points that are not
    resolved have been drawn, a legend above the figure says so, and the caption what that means.
    """
    points, lines = int(dataset.realizations.size), int(dataset.realizations.max())
    known = f"{bars.capitalize()} show one jackknife standard error"
    if lines < 2:
        known = "One line gives no standard error"
    size = (
        f"{known}; {points} grid point{'s' * (points != 1)}, {lines} "
        f"realization{'s' * (lines != 1)} each, seed {dataset.attrs['seed']}."
    )
    rings = [line for ax in figure.axes for line in ax.lines if line.get_gid() == RING["gid"]]
    hollow = ""
    if rings:
        count = sum(np.size(line.get_xdata()) for line in rings)
        hollow = f"Hollow markers ({count} of the points shown) have {why_hollow(dataset)}."
        ring = Line2D([], [], ls="", marker="o", color="0.3", **RING)
        style: dict[str, Any] = {"loc": "outside upper right", "fontsize": 6, "handletextpad": 0.2}
        figure.legend([ring], ["hollow: not resolved"], **style)
    write_below(figure, size, note, hollow)


def write_below(figure: Figure, *notes: str) -> None:
    """Give the caption of a figure sentences that depend on its result."""
    figure.set_label(" ".join(filter(None, notes)))


def error_bars(
    ax: Axes,
    points: xr.Dataset,
    name: str,
    over: str,
    log: bool = False,
    bias: xr.DataArray | float = 0.0,
    **style: Any,
) -> None:
    """Draw an estimate with its standard errors over another variable of a result.

    Points whose contacts are not resolved are hollow. ``log`` : bars as of ``log_bars``.
    ``bias`` : added to the standard errors. ``style`` : as for matplotlib's errorbar.
    """
    value, error = points[name].values, (points[f"{name}_error"] + bias).values
    bars = log_bars(value, error) if log else error
    drawn = ax.errorbar(points[over], value, bars, **style)
    remember(ax, points, name, over, error)
    hollow = not_resolved(points)
    if hollow.shape == value.shape and hollow.any():
        line = drawn.lines[0]
        marker = line.get_marker() if line is not None else "None"
        ring: dict[str, Any] = {"color": drawn.lines[2][0].get_color()[0], "ls": ""} | RING
        ring["marker"] = "o" if marker in ("None", None, "") else marker
        ring["ms"] = style.get("ms", RING["ms"] - 0.8) + 0.8
        ring["mew"] = min(RING["mew"], 0.3 * ring["ms"])
        ax.plot(points[over].values[hollow], value[hollow], zorder=2.5, **ring)


def error_band(ax: Axes, curve: xr.Dataset, name: str, error: str, **style: Any) -> None:
    """Draw a curve over ``time`` with a band of its standard errors.

    name, error : variables along "sample". ``style`` : as for matplotlib's plot.
    """
    value, spread = curve[name].values, curve[error].values
    band(ax, curve.time.values, value, spread, **style)
    thinned = curve.isel(sample=slice(None, None, -(-value.size // TOLD)))
    remember(ax, thinned, name, "time", thinned[error].values)


def band(ax: Axes, over: Any, value: Any, error: Any, *form: str, **style: Any) -> None:
    """Draw a curve with a band of its errors. form, style : as for matplotlib's plot."""
    (line,) = ax.plot(over, value, *form, **style)
    ax.fill_between(over, value - error, value + error, color=line.get_color(), alpha=0.25, lw=0)


def legend_in_room(ax: Axes, share: float, **style: Any) -> None:
    """Put a legend above all curves: the axis grows upwards by a share of its range."""
    low, high = ax.get_ylim()
    ax.set_ylim(low, high + share * (high - low))
    ax.legend(**({"loc": "upper left"} | style))


def plain_ticks(figure: Figure) -> None:
    """Label logarithmic axes of two decades or fewer by 1, 2, 5: a power of ten says little."""
    for axis in (axis for ax in figure.axes for axis in (ax.xaxis, ax.yaxis)):
        low, high = sorted(axis.get_view_interval())
        if axis.get_scale() != "log" or not isinstance(axis.get_major_locator(), LogLocator):
            continue
        if high < 10.0 * low or PLAINLY[0] <= low < high <= min(100.0 * low, PLAINLY[1]):
            subs = (1.0, 2.0, 5.0) if high > 5.0 * low else (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0)
            axis.set_major_locator(LogLocator(subs=subs))
            axis.set_major_formatter(FuncFormatter(lambda value, _: with_unit(value)))
        axis.set_minor_formatter(NullFormatter())


def log_bars(value: np.ndarray, error: np.ndarray) -> list[np.ndarray]:
    """Return lengths of error bars that are symmetric in the logarithm: none reaches zero.

    A bar is at most a factor of ten long each way.
    """
    ratio = np.minimum(error / value, np.log(10.0))
    return [value * -np.expm1(-ratio), value * np.expm1(ratio)]


class HoverPoint(NamedTuple):
    """A point of a drawn figure and what is said of it."""

    x: float  # share of the figure's width, from the left
    y: float  # share of its height, from above
    text: str


_remembered: WeakKeyDictionary[Axes, list[tuple[float, float, str]]] = WeakKeyDictionary()


def remember(ax: Axes, points: xr.Dataset, name: str, over: str, error: np.ndarray) -> None:
    """Remember the finite points of an estimate that have been drawn over another variable.

    error : as drawn, of the shape of the estimate.
    """
    estimate = points[name]
    # Of an exponent per H alone there is no velocity to name.
    places = [a for a in ALL_AXES if a in points.coords and {*points[a].dims} <= {*estimate.dims}]
    values = {
        each: np.ravel(points[each].broadcast_like(estimate).transpose(*estimate.dims).values)
        for each in (name, over, *places)
    }
    across, up, errors = values[over], values[name], np.ravel(error)
    for i in np.flatnonzero(np.isfinite(across) & np.isfinite(up)):
        unit = unit_in_words(estimate)
        spread = with_unit(errors[i], unit, 2)
        at = [
            said(n, values[n][i], unit_in_words(points[n]), 4)
            for n in dict.fromkeys((over, *places))
        ]
        text = f"{said(name, values[name][i], unit, 4)} ± {spread}\n{', '.join(at)}"
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
