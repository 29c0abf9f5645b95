"""Figure 7: relaxation rate b over x = v1 tau q_max, as the paper steps and converged in time."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from studies.style import CONVERGED, PAPER_STEP
from workflow.reduce import FITTED, NO_RELAXATION, NOT_EXPONENTIAL, UNDETERMINED
from workflow.report import COLOURS, foot_line, log_bars
from workflow.result import Groups

PANELS = {
    PAPER_STEP: "(a) implicit Euler, one step per $\\Delta x$",
    CONVERGED: "(b) converged in time",
}
NEARLY_FULL = 0.8  # contact fraction above which markers are hollow
MARKS = {NO_RELAXATION: "|", NOT_EXPONENTIAL: "x", UNDETERMINED: "+"}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(
        1, 3, figsize=(7.2, 3.3), width_ratios=(1.0, 1.0, 0.62), layout="constrained"
    )
    for ax, (group, title) in zip(axes, PANELS.items(), strict=False):
        _rates(ax, groups[group])
        _exponents(axes[2], groups[group], group)
        ax.set_title(title, loc="left")
    axes[0].set_ylabel("relaxation rate $b$ (per $\\tau$)")
    axes[1].tick_params(labelleft=False)
    axes[1].annotate("$b = 1$", (0.035, 1.5), fontsize=7)
    axes[0].legend(loc="upper left", ncols=2, columnspacing=0.8, handletextpad=0.2)
    axes[2].plot([0, 1], [1, 0], "k--", label="$1 - H$ (paper)")
    axes[2].set_title("(c) exponent, $x > 1$", loc="left")
    axes[2].set_xlabel("Hurst exponent $H$")
    axes[2].set_ylabel("$\\alpha$ of $b = x^\\alpha$")
    axes[2].legend(loc="lower left")
    foot_line(
        figure,
        groups[CONVERGED],
        "lines: eq. 13; hollow: over 80 % in contact; below the axis line, by $H$: | nothing "
        "to relax, x not exponential, + lost in noise",
    )
    return figure


def _rates(ax: Axes, dataset: xr.Dataset) -> None:
    x_all = dataset.speed_ratio.values
    span = np.geomspace(min(x_all.min(), 0.5), max(x_all.max(), 2.0), 200)
    ax.plot(span[span <= 1], span[span <= 1], "k-", lw=1.2)
    ax.annotate("$b = x$ (eq. 13)", (0.16, 0.06), fontsize=7)
    rows = np.geomspace(5.2e-3, 9e-4, dataset.sizes["hurst"])
    for number, hurst in enumerate(dataset.hurst.values):
        chosen = dataset.sel(hurst=hurst)
        colour = COLOURS[number % len(COLOURS)]
        full = (chosen.contact_fraction > NEARLY_FULL).values.ravel()
        status = chosen.fit_status.values.ravel()
        for part, face in ((~full, colour), (full, "none")):
            label = f"$H = {hurst:g}$" if face == colour else None
            _points(ax, chosen, (status == FITTED) & part, colour, face, label)
        ax.plot(span[span > 1], span[span > 1] ** (1.0 - hurst), color=colour, lw=1.2)
        _unfitted(ax, chosen.speed_ratio.values.ravel(), status, colour, rows[number])
    ax.axhline(8e-3, color="0.7", lw=0.5)
    ax.set(xscale="log", yscale="log", xlabel="$x = v_1 \\tau q_\\mathrm{max}$", ylim=(6e-4, 5e3))
    ax.set_yticks([10.0**k for k in range(-2, 4)])
    ax.tick_params(which="minor", left=False)


def _points(
    ax: Axes, chosen: xr.Dataset, where: np.ndarray, colour: str, face: str, label: str | None
) -> None:
    x, b, error = (
        chosen[name].values.ravel()[where]
        for name in ("speed_ratio", "relaxation_rate", "relaxation_rate_error")
    )
    style: dict[str, Any] = {"ms": 2.4, "mew": 0.5, "lw": 0.5, "capsize": 0, "alpha": 0.8}
    ax.errorbar(x, b, log_bars(b, error), fmt="o", color=colour, mfc=face, label=label, **style)


def _unfitted(ax: Axes, x: np.ndarray, status: np.ndarray, colour: str, row: float) -> None:
    """Mark what was not fitted below the data, one row per Hurst exponent."""
    for code, marker in MARKS.items():
        there = np.unique(x[status == code])
        ax.plot(there, np.full_like(there, row), marker, color=colour, ms=2.5, mew=0.6)


def _exponents(ax: Axes, dataset: xr.Dataset, group: str) -> None:
    ax.errorbar(
        dataset.hurst,
        dataset.alpha,
        dataset.alpha_error,
        fmt="s" if group else "o",
        color=COLOURS[4] if group else COLOURS[0],
        label="implicit Euler" if group else "converged",
    )
