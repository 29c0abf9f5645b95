"""Figure 7: relaxation rate b over x = v1 tau q_max, as the paper steps and converged in time."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.figure import COLOURS, foot_line
from workflow.fits import FITTED, NO_RELAXATION

PANELS = {
    "paper_step": "(a) implicit Euler, one step per $\\Delta x$",
    None: "(b) converged in time",
}


def draw(result: Path) -> Figure:
    """Return the figure of a result file of this study."""
    figure, axes = plt.subplots(
        1, 3, figsize=(7.2, 3.1), width_ratios=(1.0, 1.0, 0.62), layout="constrained"
    )
    axes[1].sharex(axes[0])
    axes[1].sharey(axes[0])
    for ax, (group, title) in zip(axes, PANELS.items(), strict=False):
        with xr.open_dataset(result, group=group) as dataset:
            _rates(ax, dataset, left_branch=group is not None)
            _exponents(axes[2], dataset, group)
        ax.set_title(title, loc="left")
    axes[0].set_ylabel("relaxation rate $b$ (per $\\tau$)")
    axes[1].tick_params(labelleft=False)
    axes[0].legend(loc="upper left", ncols=2, columnspacing=0.8, handletextpad=0.2)
    axes[2].plot([0, 1], [1, 0], "k--", label="$1 - H$ (paper)")
    axes[2].set_title("(c) exponent, $x > 1$", loc="left")
    axes[2].set_xlabel("Hurst exponent $H$")
    axes[2].set_ylabel("$\\alpha$ of $b = x^\\alpha$")
    axes[2].legend(loc="lower left")
    with xr.open_dataset(result) as dataset:
        foot_line(figure, dataset, "rug: nothing to relax; crosses: not exponential")
    return figure


def _rates(ax: Axes, dataset: xr.Dataset, left_branch: bool) -> None:
    x_all = dataset.speed_ratio.values
    span = np.geomspace(x_all.min(), x_all.max(), 200)
    for colour, hurst in zip(_colours(dataset), dataset.hurst.values, strict=True):
        chosen = dataset.sel(hurst=hurst)
        x, b, error = (
            chosen[name].values.ravel()
            for name in ("speed_ratio", "relaxation_rate", "relaxation_rate_error")
        )
        status = chosen.fit_status.values.ravel()
        fitted = status == FITTED
        # Symmetric in the logarithm: a large error must not reach below zero.
        low, high = b * (1.0 - np.exp(-error / b)), b * (np.exp(error / b) - 1.0)
        ax.errorbar(
            x[fitted],
            b[fitted],
            np.array([low, high])[:, fitted],
            fmt="o",
            ms=2.2,
            lw=0.5,
            capsize=0,
            color=colour,
            alpha=0.75,
            label=f"$H = {hurst:g}$",
        )
        ax.plot(span[span > 1], span[span > 1] ** (1.0 - hurst), color=colour, lw=1.2)
        _unfitted(ax, x, status, colour, float(hurst))
    left = span[span <= 1]
    ax.plot(left, left if left_branch else np.ones_like(left), "k-" if left_branch else "k:", lw=1)
    if not left_branch:
        ax.plot(left, left, "k-", lw=1)
        ax.annotate("$b = 1$", (left[0] * 1.3, 1.15), fontsize=7)
    ax.annotate("$b = x$ (eq. 13)", (0.12, 0.1), fontsize=7, rotation=38)
    ax.set(xscale="log", yscale="log", xlabel="$x = v_1 \\tau q_\\mathrm{max}$", ylim=(1e-2, 2e3))


def _unfitted(ax: Axes, x: np.ndarray, status: np.ndarray, colour: str, hurst: float) -> None:
    """Mark what was not fitted below the data, one row per Hurst exponent."""
    row = 0.012 + 0.022 * hurst * 2.0
    for code, marker in ((NO_RELAXATION, "|"), (3 - NO_RELAXATION, "x")):
        there = x[status == code]
        ax.plot(
            there,
            np.full_like(there, row),
            marker,
            color=colour,
            ms=3,
            mew=0.6,
            transform=ax.get_xaxis_transform(),
        )


def _exponents(ax: Axes, dataset: xr.Dataset, group: str | None) -> None:
    ax.errorbar(
        dataset.hurst,
        dataset.alpha,
        dataset.alpha_error,
        fmt="s" if group else "o",
        color=COLOURS[4] if group else COLOURS[0],
        label="implicit Euler" if group else "converged",
    )


def _colours(dataset: xr.Dataset) -> list[str]:
    count = dataset.sizes["hurst"]
    return [COLOURS[i % len(COLOURS)] for i in range(count)]
