"""The six-dimensional grid on the paper's scalings, and how well the kinetic law predicts it."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from workflow.kinetic_law import normalised_jump
from workflow.reduce import FITTED
from workflow.report import COLOURS, foot_line, log_bars
from workflow.result import Groups

from .prediction import LIMITS, law_error, shares_within

X_LABEL = "$x = v_1\\tau q_\\mathrm{max}$"
STYLE: dict[str, Any] = {"ms": 2.2, "mew": 0.5, "lw": 0.5, "capsize": 0, "alpha": 0.7}
NOISY = 0.5  # relative standard error above which markers are hollow, without bars


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 5.0), layout="constrained")
    flat = axes.ravel()
    dataset = groups[""]
    for number, hurst in enumerate(dataset.hurst.values):
        points = dataset.sel(hurst=hurst).stack(point=dataset.mu_1.dims[1:])
        _scalings(flat, points, COLOURS[number % len(COLOURS)], f"$H = {hurst:g}$")
    _cumulative(flat[4], dataset)
    _table(flat[5], dataset)
    foot_line(figure, dataset, "hollow: standard error over 50 %")
    span = np.geomspace(1e-6, 2.0, 100)
    flat[1].plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12", zorder=0)
    _label(flat)
    return figure


def _scalings(flat: np.ndarray, points: xr.Dataset, colour: str, label: str) -> None:
    slope, step, x = points.rms_slope.values, points.velocity_step.values, points.speed_ratio.values
    mu = points.mu_1.values / slope
    _points(flat[0], x, mu, points.mu_1_error.values / slope, colour, label)
    jump, error = points.jump.values / slope / step, points.jump_error.values / slope / abs(step)
    _points(flat[1], mu, jump, error, colour)
    fitted = (points.fit_status == FITTED).values
    rate, error = points.relaxation_rate.values, points.relaxation_rate_error.values
    _points(flat[2], x[fitted], rate[fitted], error[fitted], colour)
    flat[3].plot(x, law_error(points).values, "o", color=colour, ms=2.2, alpha=0.7)


def _points(
    ax: Axes, x: np.ndarray, y: np.ndarray, error: np.ndarray, colour: str, label: str | None = None
) -> None:
    good = error < NOISY * y
    bars = log_bars(y[good], error[good])
    ax.errorbar(x[good], y[good], bars, fmt="o", color=colour, label=label, **STYLE)
    ax.plot(x[~good], y[~good], "o", color=colour, mfc="none", ms=2.2, mew=0.5)


def _cumulative(ax: Axes, dataset: xr.Dataset) -> None:
    """Draw the share of points over the error of the law, with both left branches."""
    for number, (below, name) in enumerate(((False, "as printed"), (True, "$b = 1$ for $x < 1$"))):
        error = np.sort(law_error(dataset, below).values.ravel())
        share = np.arange(1, error.size + 1) / error.size
        ax.step(
            error,
            share,
            where="post",
            color=COLOURS[4 * number],
            label=name,
            ls=("-", "--")[number],
        )
    for limit in LIMITS:
        ax.axvline(limit, color="0.6", lw=0.6, ls=":")
    ax.set(xlim=(1e-6, 2.0), ylim=(0, 1))
    ax.legend(loc="upper left", fontsize=6)


def _table(ax: Axes, dataset: xr.Dataset) -> None:
    """Write which share of the points the law predicts within 1, 5 and 20 %."""
    error = law_error(dataset).values
    x, mu = dataset.speed_ratio.values, (dataset.mu_1 / dataset.rms_slope).values
    everything = np.ones(error.shape, dtype=bool)
    rows = {
        "all points": everything,
        "$x < 1$": x < 1.0,
        "$x > 1$, $\\bar\\mu_1 < 0.3$": (x > 1.0) & (mu < 0.3),
        "$x > 1$, $\\bar\\mu_1 > 0.3$": (x > 1.0) & (mu >= 0.3),
    }
    cells = [[f"{share:.0%}" for share in shares_within(error[where])] for where in rows.values()]
    table = ax.table(
        cells,
        rowLabels=list(rows),
        colLabels=[f"{limit:.0%}" for limit in LIMITS],
        loc="center",
        bbox=Bbox.from_bounds(0.45, 0.3, 0.55, 0.55),
    )
    table.auto_set_font_size(False)
    table.set_fontsize(7)
    ax.axis("off")


def _label(flat: np.ndarray) -> None:
    flat[0].set(xlabel=X_LABEL, ylabel="$\\bar\\mu_1 = \\mu_1/\\nabla z$")
    flat[1].set(xlabel="$\\bar\\mu_1$", ylabel="$\\Delta\\bar\\mu_0/(\\Delta v/v_1)$")
    flat[2].set(xlabel=X_LABEL, ylabel="relaxation rate $b$ (per $\\tau$)")
    flat[3].set(xlabel=X_LABEL, ylabel="error of eqs. 14, 15, max $|\\Delta\\mu|/\\mu_1$")
    flat[4].set(xlabel="error of eqs. 14, 15", ylabel="share of points")
    for ax in flat[:4]:
        ax.set(xscale="log", yscale="log")
    flat[4].set_xscale("log")
    titles = ("(a)", "(b)", "(c)", "(d)", "(e)", "(f) points predicted within")
    for ax, title in zip(flat, titles, strict=True):
        ax.set_title(title, loc="left")
    flat[0].legend(loc="lower right")
    flat[1].legend(loc="upper left")
