"""Ratio of the friction of the foundation to that of the half-space, over area, speed and cost."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import X_LABEL, computed_study, ratio_of, shades
from elastomer_friction.workflow.plan import make_plan
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction of the foundation is shown over that of a half-space at the same nominal pressure, "
    "over the real contact area of the half-space (a, and c for a broad spectrum of relaxation "
    "times in place of one) and over the speed (b). Panel (d) compares the error of each model "
    "with the time of one realization."
)
PAIRS = {"": "foundation", "broad": "broad_foundation"}  # groups of half-space: foundation
RATIO = "$\\mu_1$, foundation over half-space"
BESIDE: dict[str, Any] = {"textcoords": "offset points", "ha": "center", "va": "center"}
BESIDE["fontsize"] = 7.0


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.6))
    for ax, half, title in (
        (axes[0, 0], "", "(a) one relaxation time"),
        (axes[1, 0], "broad", "(c) five times, a decade apart"),
    ):
        _over_area(ax, groups, half)
        ax.set_title(title)
    _over_speed(axes[0, 1], groups)
    _over_cost(axes[1, 1], groups)
    note = (
        "Bars include the errors of both bodies. In (d) circles and lines are the median and 10 to "
        "90 % of the points, and squares the mean bias of the discretisation."
    )
    foot_line(figure, groups[""], note)
    return figure


def ratios(groups: Groups, half: str) -> xr.Dataset:
    """Return the ratio of the foundation to the half-space, with its error, load and area."""
    whole, line = groups[half].squeeze(), groups[PAIRS[half]].squeeze()
    ratio = ratio_of(line, whole, "mu_1").assign(area=whole.contact_fraction)
    return ratio.assign_coords(speed_ratio=whole.speed_ratio)


def _over_area(ax: Axes, groups: Groups, half: str) -> None:
    ratio = ratios(groups, half)
    for velocity, colour in _coloured(ax, ratio, "velocity", ratio.speed_ratio, X_LABEL):
        points = ratio.sel(velocity=velocity)
        points = points.stack(point=points.ratio.dims).sortby("area")
        error_bars(ax, points, "ratio", "area", fmt="o", ms=3.0, color=colour)
    _dress(ax, "real contact area of the half-space")


def _over_speed(ax: Axes, groups: Groups) -> None:
    ratio = ratios(groups, "")
    ratio = ratio.isel(hurst=ratio.sizes["hurst"] // 2) if "hurst" in ratio.dims else ratio
    pressures = ratio.normal_pressure
    for force, colour in _coloured(ax, ratio, "normal_force", pressures, "nominal pressure (Pa)"):
        points = ratio.sel(normal_force=force)
        error_bars(ax, points, "ratio", "speed_ratio", fmt="o-", ms=3.0, lw=0.7, color=colour)
    _dress(ax, X_LABEL)
    ax.set_title("(b) one relaxation time, over speed")


def _coloured(
    ax: Axes, data: xr.Dataset, axis: str, values: xr.DataArray, label: str
) -> Iterator[tuple[float, Any]]:
    """Pair each value on an axis with the colour of ``values`` there; add the colour bar."""
    largest = values.max([dim for dim in values.dims if dim != axis])
    colours = shades(float(largest.min()), float(largest.max()))
    ax.figure.colorbar(colours, ax=ax, label=label)
    return zip(data[axis].values, colours.to_rgba(largest.values), strict=True)


def _over_cost(ax: Axes, groups: Groups) -> None:
    """Draw the error of the model over the predicted time of one realization."""
    plan = make_plan(computed_study(groups[""]))
    seconds = {v.label: float(np.mean(v.seconds)) for v in plan.variants}
    for half, line in PAIRS.items():
        deviation = np.abs(ratios(groups, half).ratio - 1.0).values
        low, middle, high = np.nanpercentile(deviation, [10, 50, 90])
        bar = [[middle - low], [high - middle]]
        style: dict[str, Any] = {"color": COLOURS[half != ""], "ms": 5.0}
        ax.errorbar(seconds[line], middle, bar, fmt="o", **style)
        bias = float(groups[half].mu_1_bias.mean())
        ax.plot(seconds[half], bias, "s", **style)
        kind = "one time" if half == "" else "five times"
        aside, end = ((0, 14), high) if half else ((0, -14), low)
        ax.annotate(f"foundation,\n{kind}", (seconds[line], end), aside, **BESIDE)
        ax.annotate(f"half-space,\n{kind}", (seconds[half], bias), aside, **BESIDE)
    ax.set(xscale="log", yscale="log", xlabel="predicted CPU s of a map or line", ylim=(0.006, 3.0))
    ax.set(ylabel="relative error of $\\mu_1$", title="(d) error against cost")
    ax.margins(x=0.25)


def _dress(ax: Axes, label: str) -> None:
    ax.axhline(1.0, color="0.4", lw=0.7, ls=":")
    ax.set(xscale="log", yscale="log", xlabel=label, ylabel=RATIO)
