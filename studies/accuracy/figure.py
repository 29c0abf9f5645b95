"""Work and precision: error against CPU time, and what follows from it."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.report.figure import COLOURS

from .panels import LIMITS, NAMES, draw_ladders, milliseconds, name_regimes


def draw(result: Path) -> Figure:
    """Return the figure of a result file of this study."""
    with xr.open_dataset(result) as data:
        figure, axes = plt.subplots(3, 3, figsize=(7.4, 7.8), layout="constrained")
        for ax, (name, label) in zip(axes.flat, NAMES.items(), strict=False):
            draw_ladders(ax, data, name)
            letter = "abcd"[list(NAMES).index(name)]
            ax.set_title(f"({letter}) discretisation error of {label}", loc="left")
        name_regimes(axes[0, 0])
        _balance(axes[1, 2], data)
        _multilevel(axes[2, 2], data)
    with xr.open_dataset(result, group="sampling") as sampling:
        _sampling(axes[1, 1], sampling)
    with xr.open_dataset(result, group="alternatives") as found:
        _alternatives(axes[2, 0], found, "mu_1", "(g)")
        _alternatives(axes[2, 1], found, "rate", "(h)")
    figure.supxlabel(_foot(result), fontsize=6, color="0.35")
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


def _multilevel(ax: Axes, data: xr.Dataset) -> None:
    """Draw the gain of multilevel Monte Carlo over the wanted error."""
    for k, name in enumerate(data.sampled.values):
        gain = data.multilevel_gain.sel(sampled=name)
        colour = COLOURS[k + 3]
        shift = 1.12 ** (k - 1)
        for point in range(data.sizes["point"]):
            ax.plot(shift * data.target, gain.isel(point=point), ".", color=colour, ms=2, alpha=0.5)
        ax.plot(
            shift * data.target,
            gain.median("point", skipna=True),
            "o-",
            color=colour,
            label=NAMES[str(name)],
        )
    ax.axhline(2.0, color="0.4", lw=0.8, ls="--")
    ax.annotate("worth it above", (1.3e-3, 2.08), ha="right", fontsize=6.5, color="0.35")
    ax.set(xscale="log", yscale="log", xlabel="wanted relative error", ylim=(0.8, 20.0))
    ax.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    ax.minorticks_off()
    ax.invert_xaxis()
    ax.set_title("(i) gain of multilevel MC", loc="left")
    ax.legend(loc="upper left")


def _foot(result: Path) -> str:
    with xr.open_dataset(result) as data:
        worst = float(data.reference_error.sel(quantity="mu_1").max())
        return (
            f"{data.sizes['point']} points (H, Fbar, x), every marker one m = 1, 2, 4, ...; rms "
            "over lines; references: Richardson extrapolation,\n"
            "numbers: m of the Pareto front of the medians (black); "
            f"error of mu_1 at most {worst:.0e}; curve relative to the jump; "
            f"process time, medians; seed {data.attrs['seed']}"
        )
