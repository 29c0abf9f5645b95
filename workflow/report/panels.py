"""Common elements of all figures: style, colours, error bars, hollow markers and captions."""

from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..result import body_in_words, model_in_words
from ..study import ALL_AXES
from .in_words import plus_minus, unit_in_words, value_label, with_unit
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

PLAIN_TICK_RANGE = 1e-3, 2e3  # range in which an axis of one to two decades has plain numbers
MAX_HOVER_POINTS = 40  # per curve in the report

# Palette of Okabe and Ito, distinguishable with all kinds of colour vision.
COLOURS = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00", "#56B4E9", "#000000")

# Hollow markers are larger than filled ones and white inside, so that they are visible in print.
RING: dict[str, Any] = {"mfc": "white", "mew": 0.9, "ms": 3.4, "gid": "hollow"}


def foot_line(figure: Figure, dataset: xr.Dataset, note: str = "", bars: str = "bars") -> None:
    """Add the size and seed of the study to the caption of a figure.

    note : further sentences. bars : name of the marks that show standard errors. If the figure
    has hollow markers for unresolved points, a legend and the caption explain them.
    """
    points, lines = int(dataset.realizations.size), int(dataset.realizations.max())
    meaning = f"{bars.capitalize()} show one jackknife standard error"
    if lines < 2:
        how = dataset.attrs.get("standard_errors", "one line has no standard error")
        meaning = f"{how[0].upper()}{how[1:]}"
    size = (
        f"{meaning}; {points} grid point{'s' * (points != 1)}, {lines} "
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
    model = model_in_words(dataset).replace("mu_1", "µ₁")
    model = f"{model}." if model else ""
    write_below(figure, size, body_in_words(dataset), model, note, hollow)


def write_below(figure: Figure, *notes: str) -> None:
    """Set the sentences that depend on the result and follow the fixed caption."""
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

    Points with unresolved contacts are hollow. log : whether to use ``log_bars``. bias : added to
    the standard errors in the bars. style : passed to matplotlib's errorbar.
    """
    value, error = points[name].values, (points[f"{name}_error"] + bias).values
    if not np.isfinite(value).any():
        style["label"] = None  # a legend names only what is drawn
    bars = log_bars(value, error) if log else error
    drawn = ax.errorbar(points[over], value, bars, **style)
    record_hover_points(ax, points, name, over, error)
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

    name, error : names of variables along "sample". style : passed to matplotlib's plot.
    """
    value, spread = curve[name].values, curve[error].values
    band(ax, curve.time.values, value, spread, **style)
    thinned = curve.isel(sample=slice(None, None, -(-value.size // MAX_HOVER_POINTS)))
    record_hover_points(ax, thinned, name, "time", thinned[error].values)


def band(ax: Axes, over: Any, value: Any, error: Any, *form: str, **style: Any) -> None:
    """Draw a curve with a band of errors. form, style : passed to matplotlib's plot."""
    (line,) = ax.plot(over, value, *form, **style)
    ax.fill_between(over, value - error, value + error, color=line.get_color(), alpha=0.25, lw=0)


def legend_in_room(ax: Axes, share: float, **style: Any) -> None:
    """Place a legend above all curves by extending the y axis upwards by a share of its length."""
    scale = ax.yaxis.get_transform()
    low, high = scale.transform(np.array(ax.get_ylim()))
    ax.set_ylim(top=float(scale.inverted().transform(high + share * (high - low))))
    ax.legend(**({"loc": "upper left"} | style))


def plain_ticks(figure: Figure) -> None:
    """Label logarithmic axes of at most two decades by 1, 2, 5 instead of powers of ten alone."""
    for axis in (axis for ax in figure.axes for axis in (ax.xaxis, ax.yaxis)):
        low, high = sorted(axis.get_view_interval())
        if axis.get_scale() != "log" or not isinstance(axis.get_major_locator(), LogLocator):
            continue
        if high < 10.0 * low or PLAIN_TICK_RANGE[0] <= low < high <= min(
            100.0 * low, PLAIN_TICK_RANGE[1]
        ):
            subs = (1.0, 2.0, 5.0) if high > 5.0 * low else (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0)
            axis.set_major_locator(LogLocator(subs=subs))
            axis.set_major_formatter(FuncFormatter(lambda value, _: with_unit(value)))
        axis.set_minor_formatter(NullFormatter())


def log_bars(value: np.ndarray, error: np.ndarray) -> list[np.ndarray]:
    """Return lengths of error bars that are symmetric in the logarithm and never reach zero.

    A bar extends by at most a factor of ten each way.
    """
    ratio = np.minimum(error / value, np.log(10.0))
    return [value * -np.expm1(-ratio), value * np.expm1(ratio)]


class HoverPoint(NamedTuple):
    """A point of a drawn figure with its hover text."""

    x: float  # distance from the left edge over the figure's width
    y: float  # distance from the top edge over the figure's height
    text: str


_hover_texts: WeakKeyDictionary[Axes, list[tuple[float, float, str]]] = WeakKeyDictionary()


def record_hover_points(
    ax: Axes, points: xr.Dataset, name: str, over: str, error: np.ndarray
) -> None:
    """Record the hover texts of the finite points of an estimate drawn over another variable.

    error : standard errors, with the shape of the estimate.
    """
    estimate = points[name]
    # Axes on which the estimate does not depend are omitted, such as the velocity of an exponent.
    places = [a for a in ALL_AXES if a in points.coords and {*points[a].dims} <= {*estimate.dims}]
    values = {
        key: np.ravel(points[key].broadcast_like(estimate).transpose(*estimate.dims).values)
        for key in (name, over, *places)
    }
    across, up, errors = values[over], values[name], np.ravel(error)
    for i in np.flatnonzero(np.isfinite(across) & np.isfinite(up)):
        unit = unit_in_words(estimate)
        at = [
            value_label(n, values[n][i], unit_in_words(points[n]), 4)
            for n in dict.fromkeys((over, *places))
        ]
        spread = plus_minus(errors[i], with_unit(errors[i], unit, 2))
        text = f"{value_label(name, values[name][i], unit, 4)}{spread}\n{', '.join(at)}"
        _hover_texts.setdefault(ax, []).append((across[i], up[i], text))


def hover_points(figure: Figure) -> list[HoverPoint]:
    """Return the hover points within the limits of their axes, after the figure is laid out."""
    points = []
    for ax in figure.axes:
        for x, y, text in _hover_texts.get(ax, []):
            across, up = ax.transData.transform((x, y))
            if ax.bbox.contains(across, up):
                shares = across / figure.bbox.width, 1.0 - up / figure.bbox.height
                points.append(HoverPoint(float(shares[0]), float(shares[1]), text))
    return points
