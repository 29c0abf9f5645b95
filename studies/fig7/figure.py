"""Figure 7: relaxation rate b over x = v1 tau q_max, with the paper's step and converged."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import (
    ASIDE,
    CONVERGED,
    DOTS,
    NEARLY_FULL,
    PAPER_STEP,
    SCHEMES,
    X_LABEL,
    by_hurst,
)
from elastomer_friction.workflow.reduce import FITTED, NO_RELAXATION, NOT_EXPONENTIAL, UNDETERMINED
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The rate b at which friction relaxes after a velocity step is shown over the dimensionless "
    "velocity x, (a) with one implicit Euler step per element and (b) converged in time, with eq. "
    "13 of the paper as lines. Panel (c) shows the exponent α of b = x^α for x > 1, which the "
    "paper gives as 1 − H."
)
MANY_POINTS, SMALL_MARKER = 3000, 1.3  # number of points above which markers have this size
UNFITTED_MARKERS = {  # of points without a fit; below the grey line, in a row for each H
    NO_RELAXATION: ("|", "nothing to relax"),
    NOT_EXPONENTIAL: ("x", "not exponential"),
    UNDETERMINED: ("+", "lost in noise"),
}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 3.3), width_ratios=(1.0, 1.0, 0.62))
    paper, converged = groups[PAPER_STEP], groups[CONVERGED]
    _rates(axes[0], paper, PAPER_STEP)
    axes[0].set_title("(a) implicit Euler, one step per $\\Delta x$")
    axes[0].set_ylabel("relaxation rate $b$ (per $\\tau$)")
    axes[0].legend(loc="upper left", ncols=2, columnspacing=0.8, handletextpad=0.2)
    _rates(axes[1], converged, CONVERGED, bias=1.0)
    axes[1].set_title("(b) converged in time")
    axes[1].tick_params(labelleft=False)
    axes[1].annotate("$b = 1$", (0.035, 1.5), fontsize=7)
    for marker, label in (
        ("^", f"over {100 * NEARLY_FULL:g} % in contact"),
        *UNFITTED_MARKERS.values(),
    ):
        axes[1].plot([], [], marker, color="0.3", ms=3.0, label=label)
    axes[1].legend(handles=list(axes[1].lines[-1 - len(UNFITTED_MARKERS) :]), loc="upper left")
    for group, label in ((PAPER_STEP, "implicit Euler"), (CONVERGED, "converged")):
        style: dict[str, Any] = SCHEMES[group] | {"ls": "", "ms": 4.0, "label": label}
        data = groups[group].assign_coords(hurst=groups[group].hurst + ASIDE[group])
        bias = data.alpha_bias if group == CONVERGED else 0.0
        error_bars(axes[2], data, "alpha", "hurst", bias=bias, **style)
    axes[2].plot([0, 1], [1, 0], "k--", label="$1 - H$ (paper)")
    axes[2].set(xlabel="Hurst exponent $H$", ylabel="$\\alpha$ of $b = x^\\alpha$")
    axes[2].set_title("(c) exponent, $x > 1$")
    axes[2].legend(loc="lower left")
    note = (
        "Bars of (b) and (c) include the bound of the bias. Below the grey line are, in a row for "
        "each H, the points that were not fitted, and why."
    )
    foot_line(figure, converged, note)
    return figure


def _rates(ax: Axes, dataset: xr.Dataset, group: str, bias: float = 0.0) -> None:
    """Draw b; ``bias`` times the bound of the discretisation error is added to the bars."""
    x_all = dataset.speed_ratio.values
    span = np.geomspace(min(x_all.min(), 0.5), max(x_all.max(), 2.0), 200)
    ax.plot(span[span <= 1], span[span <= 1], "k-", lw=1.2)
    ax.annotate("$b = x$ (eq. 13)", (0.16, 0.06), fontsize=7)
    rows = np.geomspace(5.2e-3, 9e-4, dataset.sizes["hurst"])
    for (hurst, points, colour), row in zip(by_hurst(dataset), rows, strict=True):
        fitted = points.fit_status == FITTED
        full = points.contact_fraction > NEARLY_FULL
        marker = SCHEMES[group]["marker"]
        ax.plot([], [], marker, color=colour, ms=3.0, label=f"$H = {hurst:g}$")
        for part, form in ((~full, marker), (full, "^")):
            style = DOTS | {"fmt": form, "color": colour, "alpha": 0.8}
            if dataset.relaxation_rate.size > MANY_POINTS:
                style |= {"ms": SMALL_MARKER, "lw": 0.3}
            shown = points.isel(point=(fitted & part).values)
            more = bias * shown.relaxation_rate_bias * shown.relaxation_rate
            error_bars(ax, shown, "relaxation_rate", "speed_ratio", log=True, bias=more, **style)
        ax.plot(span[span > 1], span[span > 1] ** (1.0 - hurst), color=colour, lw=1.2)
        for code, (marker, _) in UNFITTED_MARKERS.items():
            there = np.unique(points.speed_ratio[(points.fit_status == code).values])
            ax.plot(there, np.full_like(there, row), marker, color=colour, ms=2.5, mew=0.6)
    ax.axhline(8e-3, color="0.7", lw=0.5)
    ax.set(xscale="log", yscale="log", xlabel=X_LABEL, ylim=(6e-4, 5e3))
    ax.set_yticks([10.0**k for k in range(-2, 4)])
    ax.tick_params(which="minor", left=False)
