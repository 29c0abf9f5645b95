"""Panels of error over CPU time, with measured orders and the Pareto front of the medians."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from workflow.report import COLOURS

NAMES = {"mu_1": "$\\mu_1$", "jump": "$\\Delta\\mu_0$", "rate": "$b$", "curve": "$\\mu(t)$"}
REGIMES = ((0.0, 1.0, "$x < 1$"), (1.0, 10.5, "$1 \\leq x \\leq 10$"), (10.5, np.inf, "$x > 10$"))
LIMITS = (2e-8, 2.0)


def _regime(x: float) -> int:
    return next(k for k, (low, high, _) in enumerate(REGIMES) if low <= x < high)


def draw_ladders(ax: Axes, data: xr.Dataset, name: str) -> None:
    """Draw error over time of every point, and the median order of each scheme."""
    part = 1 if name in ("rate", "curve") else 0
    for point in data.point.values:
        one = data.sel(point=point)
        colour = COLOURS[_regime(float(one.x))]
        for scheme, line in zip(data.scheme.values, ("-", ":"), strict=True):
            error = one.error.sel(scheme=scheme, quantity=name)
            time = 1e3 * one.seconds.sel(scheme=scheme).isel(part=part)
            style: dict[str, Any] = {"color": colour, "lw": 0.7, "ms": 1.6, "alpha": 0.8}
            ax.plot(time, error, line, marker="o" if line == "-" else None, **style)
    _front(ax, data, name, part)
    orders = data.order.sel(quantity=name).median("point", skipna=True)
    text = [f"order {float(o):.1f}" for o in orders]
    words = (f"exponential: {text[0]}", f"implicit Euler: {text[1]}")
    for line, word in zip(("-", ":"), words, strict=True):
        ax.plot([], [], line, color="0.2", label=word)
    ax.legend(loc="lower left", handlelength=1.6)
    ax.set(xscale="log", yscale="log", ylim=LIMITS)
    milliseconds(ax)
    if name in ("mu_1", "curve"):
        ax.set_ylabel("relative error")


def _front(ax: Axes, data: xr.Dataset, name: str, part: int) -> None:
    """Draw the Pareto front of the medians over points: nothing is faster and more accurate."""
    common = data.error.sel(quantity=name).notnull().mean("point") > 0.5
    error = data.error.sel(quantity=name).median("point", skipna=True).where(common)
    time = data.seconds.isel(part=part).median("point", skipna=True)
    found = [
        (1e3 * float(time.sel(at)), float(error.sel(at)), int(m), scheme)
        for scheme in data.scheme.values
        for m in data.steps.values
        for at in [{"scheme": scheme, "steps": m}]
        if np.isfinite(error.sel(at))
    ]
    best = np.inf
    front = []
    for at in sorted(found):
        if at[1] < best:
            front.append(at)
            best = at[1]
    ax.plot([f[0] for f in front], [f[1] for f in front], "k-", lw=2.0, alpha=0.6)
    for time, error, m, scheme in front:
        if m in (1, 4, 16, 64) and scheme == "exponential":
            ax.annotate(
                f"{m}",
                (time, error),
                (3, 2),
                textcoords="offset points",
                fontsize=6.5,
                weight="bold",
            )


def milliseconds(ax: Axes) -> None:
    """Label the axis of time."""
    ax.set_xlabel("CPU ms per realization")
    ax.xaxis.set_minor_formatter("")


def name_regimes(ax: Axes) -> None:
    """Say which colour is which regime of x."""
    for k, (_, _, label) in enumerate(REGIMES):
        ax.annotate(
            label,
            (0.97, 0.97 - 0.08 * k),
            xycoords="axes fraction",
            ha="right",
            va="top",
            color=COLOURS[k],
            fontsize=7,
        )
