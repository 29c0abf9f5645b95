"""Beyond eq. 6: stretched exponent, rates of two exponentials, and which model predicts best."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.reduce import EXPONENTIAL, STRETCHED, TWO_EXPONENTIALS
from workflow.report import COLOURS, foot_line, log_bars
from workflow.result import Groups

NAMES = {EXPONENTIAL: "eq. 6", STRETCHED: "stretched", TWO_EXPONENTIALS: "two exponentials"}
X_LABEL = "$x = v_1 \\tau q_\\mathrm{max}$"
SLOWEST_SHOWN = 1e-2  # rates far below the horizon are lines, not rates


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 2.9), layout="constrained")
    dataset = groups[""]
    for number, hurst in enumerate(dataset.hurst.values):
        points = dataset.sel(hurst=hurst).stack(point=dataset.mu_1.dims[1:])
        colour = COLOURS[number % len(COLOURS)]
        _exponents(axes[0], points, colour, f"$H = {hurst:g}$")
        _rates(axes[1], points, colour)
    _label(axes)
    _shares(axes[2], dataset)
    foot_line(
        figure,
        dataset,
        "(a, b): points where the model beats eq. 6 by two standard errors; squared error on "
        "blocks left out",
    )
    return figure


def _exponents(ax: Axes, points: xr.Dataset, colour: str, label: str) -> None:
    ax.errorbar(
        points.speed_ratio,
        points.stretched_exponent,
        points.stretched_exponent_error,
        fmt="o",
        ms=2.4,
        lw=0.5,
        capsize=0,
        color=colour,
        label=label,
    )


def _rates(ax: Axes, points: xr.Dataset, colour: str) -> None:
    for name, face in (("fast_rate", colour), ("slow_rate", "none")):
        rate = points[name].values
        shown = rate > SLOWEST_SHOWN
        bars = log_bars(rate[shown], points[f"{name}_error"].values[shown])
        x = points.speed_ratio.values[shown]
        style: dict[str, Any] = {"ms": 2.4, "mew": 0.5, "lw": 0.5, "capsize": 0}
        ax.errorbar(x, rate[shown], bars, fmt="o", color=colour, mfc=face, **style)


def _label(axes: np.ndarray) -> None:
    axes[0].axhline(1.0, color="k", lw=0.7, ls="--")
    axes[0].set(xscale="log", xlabel=X_LABEL, ylabel="stretched exponent $\\beta$")
    axes[0].set_ylim(bottom=0.0)
    axes[0].set_title("(a)", loc="left")
    axes[0].legend(loc="lower left", fontsize=6, handletextpad=0.2)
    axes[1].set(xscale="log", yscale="log", xlabel=X_LABEL)
    axes[1].set_ylim(bottom=SLOWEST_SHOWN)
    axes[1].set_ylabel("rates of two exponentials (per $\\tau$)")
    axes[1].set_title("(b) filled: fast, hollow: slow", loc="left")


def _shares(ax: Axes, dataset: xr.Dataset) -> None:
    """Stack, over x, the share of fitted points that each model describes best."""
    x, best = dataset.speed_ratio.values.ravel(), dataset.best_model.values.ravel()
    edges = np.geomspace(x.min() * 0.99, x.max() * 1.01, 7)
    group = np.digitize(x, edges) - 1
    below = np.zeros(edges.size - 1)
    for number, (code, name) in enumerate(NAMES.items()):
        count = np.array([np.sum(best[group == k] == code) for k in range(edges.size - 1)])
        every = np.array([np.sum(best[group == k] > 0) for k in range(edges.size - 1)])
        share = count / np.maximum(every, 1)
        colour = COLOURS[(6, 5, 1)[number]]
        ax.bar(edges[:-1], share, np.diff(edges), below, align="edge", color=colour, label=name)
        below += share
    ax.set(xscale="log", xlabel=X_LABEL, ylim=(0, 1.32))
    ax.set_ylabel("share of fitted points")
    ax.set_yticks([0, 0.5, 1])
    ax.set_title("(c) best model", loc="left")
    ax.legend(loc="upper center", fontsize=6, ncols=2)
