"""Work and precision: error against CPU time, and what follows from it."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from elastomer_friction.workflow.report import COLOURS, write_below
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The first figure shows the relative error of steady friction, jump, rate and curve over the "
    "CPU time that it takes to get it, for both schemes, many time steps and all points of the "
    "study; for all but the rate also where narrow contacts are not refined. The second "
    "shows the error that is left by a finite number of random lines, how to balance both errors, "
    "and what common alternatives to these solvers give at the same cost."
)
MARKS = ("o", "s", "^")  # of the compared points
NAMES = {"mu_1": "$\\mu_1$", "jump": "$\\Delta\\mu_0$", "rate": "$b$", "curve": "$\\mu(t)$"}
REGIMES = ((0.0, 1.0, "$x < 1$"), (1.0, 10.5, "$1 \\leq x \\leq 10$"), (10.5, np.inf, "$x > 10$"))
REFINED = ("mu_1", "jump", "curve")  # a curve ends at mu_2; b is that of the march alone
LIMITS = (5e-9, 50.0)


def draw(groups: Groups) -> dict[str, Figure]:
    """Return two figures of a result of this study: of the discretisation, and of the rest."""
    return {"": _discretisation(groups), "alternatives": _rest(groups)}


def _discretisation(groups: Groups) -> Figure:
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.8))
    data = groups[""]
    for ax, (name, label), letter in zip(axes.flat, NAMES.items(), "abcd", strict=True):
        draw_ladders(ax, data, name)
        if name in REFINED:
            draw_narrow(ax, data, groups["as_sampled"], name)
        both = {"ncols": 2, "columnspacing": 0.6, "handletextpad": 0.4, "fontsize": 6.5}
        ax.legend(loc="lower left", handlelength=1.6, **(both if name in REFINED else {}))
        ax.set_title(f"({letter}) discretisation error of {label}")
    for k, (_, _, label) in enumerate(REGIMES):
        style: dict[str, Any] = {"ha": "right", "va": "top", "fontsize": 7, "color": COLOURS[k]}
        axes[0, 0].text(0.97, 0.97 - 0.08 * k, label, transform=axes[0, 0].transAxes, **style)
    worst = float(data.reference_error.sel(quantity="mu_1").max())
    write_below(
        figure,
        f"{data.sizes['point']} points ($H$, $\\bar F$, $x$), every marker one m = 1, 2, 4, ...; "
        f"rms over lines; process time, medians; seed {data.attrs['seed']}",
        f"references: Richardson extrapolation, error of $\\mu_1$ at most {worst:.0e}; "
        "curve relative to the jump",
        "numbers: m of the Pareto front of the medians (black); "
        "not refined: as where m is a number in a study",
    )
    return figure


def _rest(groups: Groups) -> Figure:
    """Return sampling errors, both errors together, and the common alternatives."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.8))
    data, found = groups[""], groups["alternatives"]
    _sampling(axes[0, 0], groups["sampling"])
    _balance(axes[0, 1], data)
    for ax, name, letter in zip(axes[1], ("mu_1", "rate"), "cd", strict=True):
        _alternatives(ax, found, name)
        ax.set_title(f"({letter}) common alternatives: {NAMES[name]}")
    for ax in axes[:, 0]:
        ax.set_ylabel("relative error")
    for mark, x in zip(MARKS, found.x.values, strict=False):
        axes[1, 0].plot([], [], mark, color="0.4", label=f"$x = {x:g}$")
    axes[1, 0].legend(loc="lower left", ncols=2, columnspacing=0.8)
    write_below(figure, f"process time, medians; seed {data.attrs['seed']}")
    return figure


def _sampling(ax: Axes, data: xr.Dataset) -> None:
    """Draw the error of the mean of R realizations: median and range over the points."""
    count = data.realizations.values
    for name, colour in zip(data.sampled.values, COLOURS[3:], strict=False):
        error = data.error.sel(sampled=name)
        low, high = error.min("point"), error.max("point")
        ax.fill_between(count, low, high, color=colour, alpha=0.15, lw=0)
        ax.plot(count, error.median("point"), "o-", color=colour, label=NAMES[str(name)])
    ax.plot(count, 0.25 / np.sqrt(count), "k--", lw=0.8, label="$0.25\\,R^{-1/2}$")
    ax.set(xscale="log", yscale="log", xlabel="realizations $R$")
    ax.set_title("(a) sampling error: median, range")
    ax.legend(loc="lower left", ncols=2)


def _balance(ax: Axes, data: xr.Dataset) -> None:
    """Draw total error over time for each m at one point, bias and sampling, and the best."""
    one = data.sel(point=data.point.values[min(2, data.sizes["point"] - 1)])
    one = one.sel(scheme="exponential", quantity="mu_1").isel(part=0)
    count = np.geomspace(10, 1e6, 60)
    best = []
    shown = [m for m in (1, 2, 4, 8, 16) if m in one.steps]
    for k, m in enumerate(shown):
        at, colour = one.sel(steps=m), plt.cm.viridis(0.8 * k / len(shown))
        total = np.hypot(float(at.bias), float(at.deviation) / np.sqrt(count))
        time = count * float(at.seconds)
        ax.plot(time, total, color=colour, label=f"$m = {m}$")
        ax.axhline(abs(float(at.bias)), color=colour, lw=0.5, ls=":")
        best.append((time, total))
    grid = np.geomspace(3e-3, 1e3, 200)
    front = np.min([np.interp(grid, t, e, right=e[-1], left=np.inf) for t, e in best], axis=0)
    ax.plot(grid, front, "k", lw=2.2, alpha=0.25, label="best")
    ax.set(xscale="log", yscale="log", xlabel="CPU s in all", xlim=(2e-3, 5e2), ylim=(1e-5, 0.2))
    ax.set_title(f"(b) both, $\\mu_1$ at $x = {float(one.x):g}$")
    ax.legend(loc="lower left", frameon=True, framealpha=1.0, edgecolor="none", borderpad=0.1)


def _alternatives(ax: Axes, data: xr.Dataset, name: str) -> None:
    """Draw error over time of the kernels and of the alternatives, at the compared points."""
    data = data.sel(quantity=name).isel(part=1 if name == "rate" else 0)
    for solver, colour in zip(data.solver.values, (0, 1, 4), strict=True):
        if not data.error.sel(solver=solver).notnull().any():  # it is not installed
            continue
        for k, mark in enumerate(MARKS[: data.sizes["compared"]]):
            one = data.isel(compared=k).sel(solver=solver)
            (line,) = ax.plot(1e3 * one.seconds, one.error, lw=0.8, marker=mark, ms=2.5)
            line.set(color=COLOURS[colour], label=None if k else str(solver))
    ax.set(xscale="log", yscale="log", ylim=(2e-8, 2.0))
    milliseconds(ax)


def draw_ladders(ax: Axes, data: xr.Dataset, name: str) -> None:
    """Draw error over time of every point, and the median order of each scheme."""
    data = data.sel(quantity=name).isel(part=1 if name in ("rate", "curve") else 0)
    for (low, high, _), colour in zip(REGIMES, COLOURS, strict=False):
        regime = data.sel(point=(low <= data.x) & (data.x < high))
        for scheme, line in (("exponential", "o-"), ("implicit-euler", ":")):
            one = regime.sel(scheme=scheme)
            style: dict[str, Any] = {"color": colour, "lw": 0.7, "ms": 1.6, "alpha": 0.8}
            ax.plot(1e3 * one.seconds.T, one.error.T, line, **style)
    _front(ax, data)
    for scheme, line, label in (
        ("exponential", "-", "exponential"),
        ("implicit-euler", ":", "implicit Euler"),
    ):
        order = float(data.order.sel(scheme=scheme).median())
        said = f": order {order:.1f}" if np.isfinite(order) else ""
        ax.plot([], [], line, color="0.2", label=f"{label}{said}")
    ax.set(xscale="log", yscale="log", ylim=LIMITS)
    milliseconds(ax)
    ax.set_ylabel("relative error")


def draw_narrow(ax: Axes, refined: xr.Dataset, as_sampled: xr.Dataset, name: str) -> None:
    """Draw the worst point where narrow contacts are refined, and where not, with the median."""
    ways = (
        (refined.sel(scheme="exponential"), "refined", "k", ("worst",)),
        (as_sampled, "not refined", "w", ("median", "worst")),
    )
    for data, said, filling, shown in ways:
        one = data.sel(quantity=name).isel(part=1 if name == "curve" else 0)
        middle = _medians(one)
        worst = one.error.max("point").where(np.isfinite(middle.error))
        for which in shown:
            error, line = (middle.error, "o--") if which == "median" else (worst, "v-.")
            (drawn,) = ax.plot(1e3 * middle.seconds, error, line, color="k", lw=0.8, ms=3.0)
            drawn.set(mfc=filling, mew=0.8, label=f"{which}, {said}")


def _medians(data: xr.Dataset) -> xr.Dataset:
    """Return the medians over the points of times and errors, of m that most points have."""
    common = data.error.notnull().mean("point") > 0.5
    return data[["seconds", "error"]].median("point").where(common)


def _front(ax: Axes, data: xr.Dataset) -> None:
    """Draw the Pareto front of the medians over points: nothing is faster and more accurate."""
    medians = _medians(data)
    ways = medians.to_dataframe().dropna().sort_values("seconds").reset_index()
    front = ways[ways.error < ways.error.cummin().shift(fill_value=np.inf)]
    ax.plot(1e3 * front.seconds, front.error, "k-", lw=2.0, alpha=0.6)
    numbered = front[(front.scheme == "exponential") & front.steps.isin([1, 4, 16, 64])]
    for m, seconds, error in zip(numbered.steps, numbered.seconds, numbered.error, strict=True):
        style: dict[str, Any] = {"fontsize": 6.5, "weight": "bold"}
        ax.annotate(f"{m}", (1e3 * seconds, error), (3, 2), textcoords="offset points", **style)


def milliseconds(ax: Axes) -> None:
    """Label the axis of time, which is logarithmic and has its limits."""
    ax.set_xlabel("CPU ms per realization")
    low, high = ax.get_xlim()
    few = (1.0, 2.0, 5.0)  # less than a decade has hardly any of them, and would be cut evenly
    ax.xaxis.set_major_locator(
        LogLocator(subs=few if high > 10.0 * low else (1.0, 1.5, 2.0, 3.0, 5.0))
    )
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter("")
