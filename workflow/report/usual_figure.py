"""Default figure of a study: friction over time and the main estimates.

The first panel shows friction over time at up to six points spread over the grid. The other panels
show the main estimates, such as mu_1, over the longest axis, with a colour for each value of the
second longest axis and a row for each combination of the other axes.
"""

import textwrap
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...kernels import MAX_REMEMBERED
from ..reduce import LARGE_BIAS, NARROW_CONTACTS
from ..result import Groups
from ..study import COMMON_AXES
from .in_words import (
    SYMBOLS,
    axes_in,
    mathematical,
    plus_minus,
    unit_in_words,
    value_label,
    with_unit,
    without_tau,
)
from .panels import COLOURS, band, error_bars, foot_line, legend_in_room
from .unresolved import TRACE_STATUS, not_resolved

MAX_CURVES = MAX_COLOURS = 6
MAX_ROWS = 4
# The default figure shows those that are present, or else the first estimates of the result.
PREFERRED_ESTIMATES = ("mu_1", "jump", "relaxation_rate", "healing")
LOG_AXIS_RATIO = 10.0  # ratio of largest to smallest value from which an axis is logarithmic
LINE_STYLES = ("-", "--", ":", "-.")  # of the study and its comparisons, in order
AXIS_PRIORITY = ("velocity", "hurst", "normal_force")  # order of axes of equal length
ESTIMATE_LABELS = {
    "mu_1": "steady friction $\\mu_1$",
    "jump": "jump $\\Delta\\mu_0$",
    "relaxation_rate": "relaxation rate $b$ (per $\\tau$)",
}
CURVES = (
    ("time", "mu", "$(t - t_0)/\\tau$"),
    ("time_s", "mu", "time after the step (s)"),
    ("trace_time", "trace_mu", "time (s)"),
)


def draw(groups: Groups) -> Figure:
    """Draw the default figure of the result of a grid."""
    groups = {label: without_tau(dataset) for label, dataset in groups.items()}
    data = groups[""]
    varied = sorted(  # the longest axis comes first
        (axis for axis in axes_in(data) if data.sizes[axis] > 1),
        key=lambda axis: (-data.sizes[axis], [*AXIS_PRIORITY, axis].index(axis)),
    )
    curve = next((names for names in CURVES if {*names[:2]} <= {*data.variables}), None)
    shown = _estimates_to_draw(data) if varied or not curve else []
    places = list(product(*(range(data.sizes[axis]) for axis in varied[2:])))
    rows = [dict(zip(varied[2:], places[k], strict=True)) for k in _spread(len(places), MAX_ROWS)]
    panels = len(shown) + bool(curve)
    size = (1.0 + 2.3 * panels, 0.6 + 2.4 * len(rows))
    figure, axes = plt.subplots(len(rows), panels, figsize=size, squeeze=False, sharey="col")
    estimates = axes[:, bool(curve) :]
    for ax in estimates.flat[1:]:
        ax.sharex(estimates[0, 0])
    dotted = 0
    for k, place in enumerate(rows):
        at_place = {label: d.isel(place, missing_dims="ignore") for label, d in groups.items()}
        title = ", ".join(_axis_label(at_place[""], axis) for axis in place)
        axes[k, 0].set_title(title, fontsize=7)
        if curve:
            dotted += _curves(axes[k, 0], at_place[""], curve, varied[:2])
        for ax, name in zip(estimates[k], shown, strict=True):
            _estimate(ax, at_place, name, tuple(dict.fromkeys((*varied, *AXIS_PRIORITY)))[:2])
    for ax in axes[:-1].flat:
        ax.set_xlabel("")
    if varied and curve:
        _name_curves(axes[:, 0])
    if shown and estimates[0, 0].get_legend_handles_labels()[0]:
        estimates[0, 0].legend(fontsize=6)  # one legend serves all panels of estimates
    unresolved = f"Dotted curves ({dotted}) are not resolved: {NARROW_CONTACTS} or {LARGE_BIAS}."
    notes = [
        _limit_note(len(varied) > 1 and data.sizes[varied[1]], MAX_COLOURS, "values of the second"),
        _limit_note(len(places), MAX_ROWS, "places on the other axes"),
        unresolved if dotted else "",
        _repeated_note(data),
        "" if shown else _single_point_text(data),
    ]
    foot_line(figure, data, " ".join(filter(None, notes)), "bars and bands" if curve else "bars")
    figure.set_label(f"{_caption(data, bool(curve), shown, varied)} {figure.get_label()}")
    return figure


def _caption(data: xr.Dataset, curve: bool, shown: list[str], varied: list[str]) -> str:
    """Return a caption of the panels that are drawn."""
    first = "Friction over time" + " at points spread over the grid" * bool(varied) + "."
    words = [str(data[_axis_name(data, axis)].attrs.get("long_name", axis)) for axis in varied]
    parts = {" over ": words[:1], "; colours: ": words[1:2], "; rows: ": words[2:]}
    named = ", ".join(SYMBOLS.get(name, name) for name in shown)
    rest = named + "".join(f"{text}{', '.join(part)}" for text, part in parts.items() if part) + "."
    return " ".join([first] * curve + [rest] * bool(shown))


def _name_curves(axes: np.ndarray) -> None:
    """Add a legend to the first panel of curves, and to panels whose labels differ from it."""
    first, *others = axes
    labels = first.get_legend_handles_labels()[1]
    legend_in_room(first, 0.08 * len(labels), fontsize=5.5)
    for ax in others:
        if ax.get_legend_handles_labels()[1] != labels:
            ax.legend(loc="upper left", fontsize=5.5)


def _spread(size: int, count: int) -> list[int]:
    """Return at most ``count`` integers below ``size``, spread evenly from first to last."""
    return np.unique(np.linspace(0, size - 1, min(size, count)).round().astype(int)).tolist()


def _limit_note(size: int, most: int, noun: str) -> str:
    """Return a note that only ``most`` items are drawn, or "" if there are no more."""
    return f"Of {size} {noun} {most} are drawn." if size > most else ""


def _repeated_note(data: xr.Dataset) -> str:
    """Return a note on traces that meet their first contact again every period, or ""."""
    share = float(data.trace_remembered.max()) if "trace_remembered" in data else 0.0
    if share <= MAX_REMEMBERED:
        return ""
    return f"Friction repeats {share:.0%} of the first contact after each period of the surface."


def _estimates_to_draw(data: xr.Dataset) -> list[str]:
    """Return the names of the estimates to draw, among those with a finite value."""
    known = [
        str(name)
        for name, values in data.data_vars.items()
        if f"{name}_error" in data
        and {*COMMON_AXES} <= {*values.dims} <= {*axes_in(data)}
        and np.isfinite(values).any()
    ]
    preferred = [name for name in PREFERRED_ESTIMATES if name in known]
    return preferred or known[: len(PREFERRED_ESTIMATES)]


def _axis_name(data: xr.Dataset, axis: str) -> str:
    """Return ``axis``, or "normal_pressure" if that coordinate replaces the normal force."""
    given = "normal_pressure" in data.coords and axis == "normal_force"
    return "normal_pressure" if given else axis


def _axis_label(data: xr.Dataset, axis: str) -> str:
    """Return the coordinate of a point as text, such as "T = 60 °C"."""
    name = _axis_name(data, axis)
    return mathematical(value_label(name, float(data[name]), unit_in_words(data[name])))


def _label(variable: xr.DataArray) -> str:
    """Return the label of an axis of a panel: its meaning and unit."""
    words, unit = str(variable.attrs.get("long_name", variable.name)), unit_in_words(variable)
    for letters, symbol in (("v1", "v₁"), ("dv", "Δv"), ("dx", "Δx")):
        words = words.replace(letters, symbol)
    return mathematical(textwrap.fill(f"{words} ({unit})" if unit else words, 34))


def _single_point_text(data: xr.Dataset) -> str:
    """Return a sentence with the estimates of a result that has a single point."""
    words = []
    for name in _estimates_to_draw(data):
        value = value_label(name, float(data[name].squeeze()), unit_in_words(data[name]))
        error = float(data[f"{name}_error"].squeeze())
        words.append(f"{value}{plus_minus(error, with_unit(error, digits=2))}")
    return f"Estimates: {'; '.join(words)}." if words else ""


def _curves(ax: Axes, data: xr.Dataset, curve: tuple[str, str, str], varied: list[str]) -> int:
    """Draw friction over time with error bands at points spread over the grid.

    Unresolved traces are dotted; return their number.
    """
    time, mu, label = curve
    curve_dims = [dim for dim in data[mu].dims if dim in ("sample", "event")]
    points = data.stack(point=[dim for dim in data[mu].dims if dim not in curve_dims])
    known = np.flatnonzero(points[mu].notnull().any(curve_dims))
    error = {"mu": "deviation_error"}.get(mu, f"{mu}_error")
    dotted = 0
    for k, colour in zip(_spread(known.size, MAX_CURVES), COLOURS, strict=False):
        point = points.isel(point=known[k]).dropna(curve_dims[0], subset=[mu])
        unit = float(point.mu_1) if mu == "mu" and "mu_1" in point else 1.0
        spread = point[error].values if error in point else 0.0
        words = ", ".join(_axis_label(point, axis) for axis in varied)
        coarse = mu == "trace_mu" and bool(not_resolved(point, TRACE_STATUS))
        style: dict[str, Any] = {"color": colour, "label": words, "ls": ":" if coarse else "-"}
        band(ax, point[time], point[mu].values / unit, spread / unit, **style)
        dotted += coarse
    ends = points[time].max(curve_dims).values[known]
    if known.size and (time == "time_s" or ends.max() > LOG_AXIS_RATIO * ends.min()):
        ax.set_xscale("log")
    over = " over that before" if mu == "mu" and "mu_1" in points else ""
    ax.set(xlabel=label, ylabel=f"friction{over}")
    return dotted


def _estimate(ax: Axes, groups: Groups, name: str, axes: Sequence[str]) -> None:
    """Draw an estimate over the first of ``axes``, for several values of the second."""
    data, (along, across) = groups[""], axes
    over = _axis_name(data, along)
    for line_style, (group, dataset) in zip(LINE_STYLES, groups.items(), strict=False):
        if name not in dataset or dataset.sizes[along] != data.sizes[along]:
            continue
        size = dataset.sizes[across]
        rest = {dim: 0 for dim in dataset[name].dims if dim not in (along, across)}
        for k, colour in zip(_spread(size, MAX_COLOURS), COLOURS, strict=False):
            line = dataset.isel(rest).isel({across: k})
            style: dict[str, Any] = {"color": colour, "ls": line_style, "marker": "o"}
            label = group or (_axis_label(line, across) if size > 1 else None)
            error_bars(ax, line, name, over, label=None if group and k else label, **style)
    values, estimates = data[over].values, data[name].values[np.isfinite(data[name].values)]
    for scale, numbers in (ax.set_xscale, values), (ax.set_yscale, estimates):
        if numbers.size and numbers.min() > 0.0 and numbers.max() >= LOG_AXIS_RATIO * numbers.min():
            scale("log")
    label = "" if data[name].attrs.get("units") == "s-1" else ESTIMATE_LABELS.get(name)
    ax.set(xlabel=_label(data[over]), ylabel=label or _label(data[name]))
