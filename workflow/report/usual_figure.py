"""The figure of a study without one of its own: friction over time, and what was found of it.

Curves of up to six points, spread over the grid; then mu_1, the jump and b over the longest axis,
in a colour for each value of the second longest. All other axes are at their first value.
"""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..result import AXIS_ATTRIBUTES, Groups
from ..study import AXES
from .panels import COLOURS, error_bars, foot_line, model_in_words

CAPTION = (
    "The first panel shows the coefficient of friction over time after the velocity step at points "
    "that are spread over the grid, with bands of one standard error. The other panels show steady "
    "friction, the jump and the relaxation rate over the longest axis of the grid, in a colour for "
    "each value of the second longest."
)
MOST_CURVES = MOST_COLOURS = 6
WANTED = ("mu_1", "jump", "relaxation_rate")  # those that are there, or the first estimates
DECADES = 10.0  # ratio of the largest to the least value from which on an axis is logarithmic
FORMS = ("-", "--", ":", "-.")  # of the study and of its comparisons
SYMBOLS = {
    "hurst": "$H$",
    "normal_force": "$F_N$ (N)",
    "spacing": "$\\Delta x$ (m)",
    "roughness": "$h$ (m)",
    "velocity": "$v_1$ (m/s)",
    "velocity_step": "$\\Delta v/v_1$",
}
LABELS = {
    "mu_1": "steady friction $\\mu_1$",
    "jump": "jump $\\Delta\\mu_0$",
    "relaxation_rate": "relaxation rate $b$ (per $\\tau$)",
}
CURVES = (("time", "mu", "$(t - t_0)/\\tau$"), ("trace_time", "trace_mu", "time (s)"))


def draw(groups: Groups) -> Figure:
    """Return the figure of any result of a grid."""
    data = groups[""]
    shown = [name for name in WANTED if name in data]
    if not shown:
        estimates = [str(n) for n in data.data_vars if f"{n}_error" in data]
        shown = [n for n in estimates if set(data[n].dims) >= {*AXES}][: len(WANTED)]
    curve = next((names for names in CURVES if names[1] in data), None)
    panels = len(shown) + (curve is not None)
    figure, axes = plt.subplots(1, panels, figsize=(1.0 + 2.3 * panels, 3.0), squeeze=False)
    places = iter(axes[0])
    if curve:
        _curves(next(places), data, *curve)
    for ax, name in zip(places, shown, strict=True):
        _estimate(ax, groups, name)
    if shown and axes[0, -len(shown)].get_legend_handles_labels()[0]:
        axes[0, -len(shown)].legend(fontsize=6)  # the same in all panels of estimates
    others = [axis for axis in _by_length(data)[2:] if data.sizes[axis] > 1]
    values = [f"{AXIS_ATTRIBUTES[axis][1]} {float(data[axis][0]):.3g}" for axis in others]
    note = f"estimates are shown at the first of several values: {', '.join(values)}"
    bars = "bars and bands" if curve else "bars"
    notes = [note * bool(others), model_in_words(data).replace("mu_1", "µ₁")]
    foot_line(figure, data, "; ".join(filter(None, notes)), bars=bars)
    return figure


def _by_length(data: xr.Dataset) -> list[str]:
    """Return the axes of the grid, the longest first."""
    order = ("velocity", "hurst", "normal_force", "velocity_step", "spacing", "roughness")
    return sorted(order, key=lambda axis: -data.sizes[axis])


def _curves(ax: Axes, data: xr.Dataset, time: str, mu: str, label: str) -> None:
    """Draw friction over time with bands at points spread over the grid."""
    long = [dim for dim in data[mu].dims if dim in ("sample", "event")]
    points = data.stack(point=[dim for dim in data[mu].dims if dim not in long])
    there = np.flatnonzero(points[mu].notnull().any(long))
    chosen = np.unique(np.linspace(0, there.size - 1, MOST_CURVES).round().astype(int))
    varied = [axis for axis in _by_length(data) if data.sizes[axis] > 1][:2]
    error = {"mu": "deviation_error"}.get(mu, f"{mu}_error")
    for k, colour in zip(there[chosen] if there.size else [], COLOURS, strict=False):
        one = points.isel(point=k)
        one = one.dropna(long[0], subset=[mu])
        unit = float(one.mu_1) if mu == "mu" and "mu_1" in one else 1.0
        values, band = one[mu].values / unit, (one[error].values if error in one else 0.0) / unit
        said = ", ".join(f"{float(one[axis]):.3g}" for axis in varied)
        ax.plot(one[time], values, color=colour, label=said)
        ax.fill_between(one[time], values - band, values + band, color=colour, alpha=0.25, lw=0)
    over = " over that before" if mu == "mu" and "mu_1" in points else ""
    ax.set(xlabel=label, ylabel=f"friction{over}")
    if varied and there.size:
        ax.legend(title=", ".join(SYMBOLS[axis] for axis in varied), fontsize=6, title_fontsize=6)


def _estimate(ax: Axes, groups: Groups, name: str) -> None:
    """Draw an estimate over the longest axis, for some values of the second longest."""
    data = groups[""]
    along, across = _by_length(data)[:2]
    size = data.sizes[across]
    picked = np.unique(np.linspace(0, size - 1, min(size, MOST_COLOURS)).round().astype(int))
    for form, (group, held) in zip(FORMS, groups.items(), strict=False):
        if name not in held or held.sizes[along] != data.sizes[along]:
            continue
        rest = {dim: 0 for dim in held[name].dims if dim not in (along, across)}
        for k, colour in zip(picked, COLOURS, strict=False):
            line = held.isel(rest).isel({across: k})
            value = f"{SYMBOLS[across].partition(' (')[0]} = {float(line[across]):.3g}"
            label = group or (value if size > 1 else None)
            style: dict[str, Any] = {"color": colour, "ls": form, "marker": "o"}
            said = label if not group or k == picked[0] else None
            error_bars(ax, line, name, along, label=said, **style)
    values = data[along].values
    if values.min() > 0.0 and values.max() > DECADES * values.min():
        ax.set_xscale("log")
    found = data[name].values[np.isfinite(data[name].values)]
    if found.size and found.min() > 0.0 and found.max() > DECADES * found.min():
        ax.set_yscale("log")
    ax.set(xlabel=SYMBOLS[along], ylabel=LABELS.get(name, name))
