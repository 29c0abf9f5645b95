"""Panels of error over CPU time, with measured orders and the Pareto front of the medians."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator

from elastomer_friction.workflow.report import COLOURS

NAMES = {"mu_1": "$\\mu_1$", "jump": "$\\Delta\\mu_0$", "rate": "$b$", "curve": "$\\mu(t)$"}
REGIMES = ((0.0, 1.0, "$x < 1$"), (1.0, 10.5, "$1 \\leq x \\leq 10$"), (10.5, np.inf, "$x > 10$"))
REFINED = ("mu_1", "jump", "curve")  # a curve ends at mu_2; b is that of the march alone
LIMITS = (5e-9, 50.0)


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


def name_regimes(ax: Axes) -> None:
    """Say which colour is which regime of x."""
    for k, (_, _, label) in enumerate(REGIMES):
        at = (0.97, 0.97 - 0.08 * k)
        ax.annotate(
            label, at, xycoords="axes fraction", color=COLOURS[k], ha="right", va="top", fontsize=7
        )
