"""Work and precision: error against CPU time, and what follows from it."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.report import COLOURS
from workflow.result import Groups

from .panels import LIMITS, NAMES, draw_ladders, milliseconds, name_regimes


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 4, figsize=(9.6, 5.4), layout="constrained")
    data, found = groups[""], groups["alternatives"]
    for ax, (name, label) in zip(axes.flat, NAMES.items(), strict=False):
        draw_ladders(ax, data, name)
        letter = "abcd"[list(NAMES).index(name)]
        ax.set_title(f"({letter}) discretisation error of {label}", loc="left")
    name_regimes(axes[0, 0])
    _sampling(axes[1, 0], groups["sampling"])
    _balance(axes[1, 1], data)
    _alternatives(axes[1, 2], found, "mu_1", "(g)")
    _alternatives(axes[1, 3], found, "rate", "(h)")
    figure.supxlabel(_foot(data), fontsize=6, color="0.35")
    return figure


def _sampling(ax: Axes, data: xr.Dataset) -> None:
    """Draw the error of the mean of R realizations: median and range over the points."""
    for k, name in enumerate(data.sampled.values):
        error = data.error.sel(sampled=name)
        ax.fill_between(
            data.realizations,
            error.min("point"),
            error.max("point"),
            color=COLOURS[k + 3],
            alpha=0.15,
            lw=0,
        )
        ax.plot(
            data.realizations,
            error.median("point", skipna=True),
            "o-",
            color=COLOURS[k + 3],
            label=NAMES[str(name)],
        )
    count = data.realizations.values
    ax.plot(count, 0.25 / np.sqrt(count), "k--", lw=0.8, label="$0.25\\,R^{-1/2}$")
    ax.set(xscale="log", yscale="log", xlabel="realizations $R$")
    ax.set_title("(e) sampling error: median, range", loc="left")
    ax.legend(loc="lower left", ncols=2)


def _balance(ax: Axes, data: xr.Dataset) -> None:
    """Draw total error over time for each m at one point, bias and sampling, and the best."""
    one = data.sel(point=data.point.values[min(2, data.sizes["point"] - 1)])
    one = one.sel(scheme="exponential", quantity="mu_1").isel(part=0)
    count = np.geomspace(10, 1e6, 60)
    best = []
    shown = [m for m in (1, 2, 4, 8, 16) if m in one.steps]
    for k, m in enumerate(shown):
        at = one.sel(steps=m)
        total = np.hypot(float(at.bias), float(at.deviation) / np.sqrt(count))
        time = count * float(at.seconds)
        ax.plot(time, total, color=plt.cm.viridis(k / len(shown)), label=f"$m = {m}$")
        ax.axhline(abs(float(at.bias)), color=plt.cm.viridis(k / len(shown)), lw=0.5, ls=":")
        best.append((time, total))
    grid = np.geomspace(3e-3, 1e3, 200)
    front = np.min([np.interp(grid, t, e, right=e[-1], left=np.inf) for t, e in best], axis=0)
    ax.plot(grid, front, "k", lw=2.2, alpha=0.25, label="best")
    ax.set(xscale="log", yscale="log", xlabel="CPU s in all", xlim=(2e-3, 5e2), ylim=(1e-5, 0.2))
    ax.set_title(f"(f) both, $\\mu_1$ at $x = {float(one.x):g}$", loc="left")
    ax.legend(loc="lower left")


def _alternatives(ax: Axes, data: xr.Dataset, name: str, letter: str) -> None:
    """Draw error over time of the kernels and of the alternatives, at the compared points."""
    part = 1 if name == "rate" else 0
    marks = ("o", "s", "^")
    for row, solver in enumerate(data.solver.values):
        for k, point in enumerate(data.point.values):
            one = data.sel(point=point, solver=solver)
            ax.plot(
                1e3 * one.seconds.isel(part=part),
                one.error.sel(quantity=name),
                marker=marks[k],
                color=COLOURS[(0, 1, 2, 4)[row]],
                lw=0.8,
                ms=2.5,
                label=str(solver) if k == 0 else None,
            )
    ax.set(xscale="log", yscale="log", ylim=(LIMITS[0], LIMITS[1]))
    milliseconds(ax)
    ax.set_title(f"{letter} common alternatives: {NAMES[name]}", loc="left")
    if name == "mu_1":
        ax.set_ylabel("relative error")
        for k, point in enumerate(data.point.values):
            label = f"$x = {float(data.x.sel(point=point)):g}$"
            ax.plot([], [], marks[k], color="0.4", label=label)
        ax.legend(loc="lower left", ncols=2, columnspacing=0.8)


def _foot(data: xr.Dataset) -> str:
    worst = float(data.reference_error.sel(quantity="mu_1").max())
    return (
        f"{data.sizes['point']} points (H, Fbar, x), every marker one m = 1, 2, 4, ...; rms "
        "over lines; references: Richardson extrapolation,\n"
        "numbers: m of the Pareto front of the medians (black); "
        f"error of mu_1 at most {worst:.0e}; curve relative to the jump; "
        f"process time, medians; seed {data.attrs['seed']}"
    )
