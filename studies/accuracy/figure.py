"""Work-precision diagrams: error against CPU time, and recommended settings."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import COLOURS, legend_in_room, with_unit, write_below
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The first figure shows the relative error of steady friction, jump, rate and curve over the "
    "CPU time of their computation, as medians over the points of the study with the range from "
    "the tenth to the ninetieth percentile. The second shows the sampling error of a finite "
    "number of random lines, the balance of both errors, and the error of common alternatives to "
    "these solvers at the same cost."
)
MARKS = ("o", "s", "^")  # of the compared points, and of quantities in (a)
NAMES = {"mu_1": "$\\mu_1$", "jump": "$\\Delta\\mu_0$", "rate": "$b$", "curve": "$\\mu(t)$"}
LOCATED = ("mu_1", "jump", "curve")  # quantities that depend on located contacts, unlike b
LABELLED_STEPS = (1, 4, 16, 64)
LIMITS = ((1e-10, 10.0), (1e-6, 10.0))  # of the rows of panels


def draw(groups: Groups) -> dict[str, Figure]:
    """Return the figure of the discretisation, and that of sampling errors and alternatives."""
    return {"": _discretisation(groups), "alternatives": _rest(groups)}


def _discretisation(groups: Groups) -> Figure:
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.4), sharey="row")
    data = groups[""]
    for ax, (name, label), letter in zip(axes.flat, NAMES.items(), "abcd", strict=True):
        drawn = [(data.sel(scheme="exponential"), "exponential", "o-")]
        drawn += [(data.sel(scheme="implicit-euler"), "implicit Euler", "s--")]
        if name in LOCATED:
            drawn += [(groups["as_sampled"], "exponential, as sampled", "^-.")]
        for (dataset, label_text, style), colour in zip(drawn, COLOURS, strict=False):
            draw_ladder(ax, dataset.sel(quantity=name), label_text, style, colour)
        ax.set(xscale="log", yscale="log", xlabel="CPU ms per realization; numbers: $m$")
        ax.set_title(f"({letter}) discretisation error of {label}")
    axes[1, 0].legend(*axes[0, 0].get_legend_handles_labels(), loc="lower left")
    for ax, limits in zip(axes[:, 0], LIMITS, strict=True):
        ax.set(ylabel="relative error", ylim=limits)
    worst = float(data.reference_error.sel(quantity="mu_1").max())
    write_below(
        figure,
        f"There are {data.sizes['point']} points (H, F̄, x), seed {data.attrs['seed']}; each "
        "marker is one m = 1, 2, 4, …, some of them labelled; errors are rms over lines, times "
        "those of a process. References are Richardson extrapolations, whose error of µ₁ is at "
        f"most {with_unit(worst, digits=1)}; the error of a curve is relative to the jump. "
        "Contacts are located between the samples, except for the curves marked as sampled.",
    )
    return figure


def _rest(groups: Groups) -> Figure:
    """Return the figure of sampling errors, total errors, and common alternatives."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.8))
    data, by_method = groups[""], groups["alternatives"]
    _sampling(axes[0, 0], groups["sampling"])
    _balance(axes[0, 1], data)
    for ax, name, letter in zip(axes[1], ("mu_1", "rate"), "cd", strict=True):
        _alternatives(ax, by_method, name)
        ax.set_title(f"({letter}) common alternatives: {NAMES[name]}")
    for ax in axes[:, 0]:
        ax.set_ylabel("relative error")
    for mark, x in zip(MARKS, by_method.x.values, strict=False):
        axes[1, 1].plot([], [], mark, color="0.4", label=f"$x = {x:g}$")
    axes[1, 0].legend(loc="lower right")
    axes[1, 1].legend(handles=axes[1, 1].lines[-len(MARKS) :], loc="lower right")
    write_below(figure, f"Times are medians of those of a process; seed {data.attrs['seed']}.")
    return figure


def _sampling(ax: Axes, data: xr.Dataset) -> None:
    """Draw the error of the mean of R realizations: median and range over the points."""
    count = data.realizations.values
    for name, mark, colour in zip(data.sampled.values, MARKS, COLOURS, strict=False):
        error = data.error.sel(sampled=name)
        low, high = error.min("point"), error.max("point")
        ax.fill_between(count, low, high, fc=(colour, 0.12), ec=(colour, 0.6), lw=0.4)
        ax.plot(count, error.median("point"), f"{mark}-", color=colour, label=NAMES[str(name)])
    ax.plot(count, 0.25 / np.sqrt(count), "k--", lw=0.8, label="$0.25\\,R^{-1/2}$")
    ax.set(xscale="log", yscale="log", xlabel="realizations $R$")
    ax.set_title("(a) sampling error: median, range")
    legend_in_room(ax, 0.25, ncols=2)


def _balance(ax: Axes, data: xr.Dataset) -> None:
    """Draw the total error over time for each m at one point, and its lower envelope."""
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
    ax.set(xscale="log", yscale="log", xlabel="CPU s in all", xlim=(2e-3, 5e2), ylim=(5e-5, 0.3))
    ax.set_title(f"(b) both, $\\mu_1$ at $x = {float(one.x):g}$; dotted: bias alone")
    ax.legend(loc="upper right", ncols=2, columnspacing=0.8)


def _alternatives(ax: Axes, data: xr.Dataset, name: str) -> None:
    """Draw error over time of the kernels and of the alternatives, at the compared points."""
    data = data.sel(quantity=name).isel(part=1 if name == "rate" else 0)
    for solver, colour in zip(data.solver.values, (0, 1, 4), strict=True):
        if not data.error.sel(solver=solver).notnull().any():  # not installed
            continue
        for k, mark in enumerate(MARKS[: data.sizes["compared"]]):
            one = data.isel(compared=k).sel(solver=solver)
            (line,) = ax.plot(1e3 * one.seconds, one.error, lw=0.8, marker=mark, ms=4.0)
            line.set(color=COLOURS[colour], label=None if k else str(solver))
    ax.set(xscale="log", yscale="log", xlabel="CPU ms per realization")


def draw_ladder(ax: Axes, data: xr.Dataset, label: str, form: str, colour: str) -> None:
    """Draw error over time for m = 1, 2, 4, ...: the median over the points, and their range.

    data : of one quantity and scheme. An m with values at half of the points or fewer is left out.
    """
    data = data.isel(part=1 if str(data.quantity.values) in ("rate", "curve") else 0)
    data = data.isel(steps=(data.error.notnull().mean("point") > 0.5).values)
    time, error = 1e3 * data.seconds.median("point"), data.error
    low, middle, high = (error.quantile(share, "point") for share in (0.1, 0.5, 0.9))
    ax.plot(time, middle, form, color=colour, label=label)
    ax.fill_between(time, low, high, fc=(colour, 0.12), ec=(colour, 0.6), lw=0.4)
    if form == "o-":
        for m in set(LABELLED_STEPS) & set(data.steps.values.tolist()):
            at = float(time.sel(steps=m)), float(middle.sel(steps=m))
            box = {"fc": "white", "ec": "none", "alpha": 0.7, "pad": 0.3}
            ax.annotate(f"{m}", at, (3, 4), textcoords="offset points", fontsize=6.5, bbox=box)
