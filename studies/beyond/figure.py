"""Beyond eq. 6: stretched exponent, rates of two exponentials, and the best model."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import DOTS, X_LABEL, by_hurst
from elastomer_friction.workflow.reduce import EXPONENTIAL, STRETCHED, TWO_EXPONENTIALS
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panels (a) and (b) show fits to friction that does not relax as one exponential: the exponent "
    "of a stretched exponential, and the rates of two exponentials. Panel (c) shows, over the "
    "dimensionless velocity x, the share of points that each model predicts best on random lines "
    "that were left out of the fit."
)
MODELS = (
    (EXPONENTIAL, "eq. 6", COLOURS[6]),
    (STRETCHED, "stretched", COLOURS[5]),
    (TWO_EXPONENTIALS, "two exponentials", COLOURS[1]),
)
RATES = {"fast_rate": "^", "slow_rate": "v"}
MIN_RATE = 1e-2  # slower terms are straight lines within the horizon


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 2.9))
    dataset = groups[""]
    for hurst, points, colour in by_hurst(dataset):
        style = DOTS | {"color": colour, "label": f"$H = {hurst:g}$"}
        error_bars(axes[0], points, "stretched_exponent", "speed_ratio", **style)
        for name, marker in RATES.items():
            shown = points.isel(point=_beating(points, name).values)
            style = DOTS | {"color": colour, "fmt": marker}
            error_bars(axes[1], shown, name, "speed_ratio", log=True, **style)
    axes[0].axhline(1.0, color="k", lw=0.7, ls="--")
    axes[0].set(xscale="log", xlabel=X_LABEL, title="(a) stretched exponential")
    axes[0].set(ylabel="stretched exponent $\\beta$", ylim=(0.0, None))
    axes[0].legend(loc="lower left", fontsize=6, handletextpad=0.2)
    axes[1].set(xscale="log", yscale="log", xlabel=X_LABEL, title="(b) two exponentials")
    axes[1].set_ylim(MIN_RATE, max(axes[1].get_ylim()[1], 1.0 / MIN_RATE))
    for name, marker in RATES.items():
        axes[1].plot([], [], marker, color="0.3", ms=3.0, label=name.replace("_rate", ""))
    axes[1].legend(loc="upper left", fontsize=6)
    axes[1].set_ylabel("rates of two exponentials (per $\\tau$)")
    if not any(_beating(dataset, name).any() for name in RATES):
        axes[1].text(0.5, 0.5, "better at no point", transform=axes[1].transAxes, ha="center")
    _shares(axes[2], dataset)
    for ax in axes[:2]:
        ax.set_xlim(axes[2].get_xlim())
    note = (
        "Panels (a) and (b) have the points at which the model beats eq. 6 by two standard errors "
        "of the squared error."
    )
    foot_line(figure, dataset, note)
    return figure


def _beating(points: xr.Dataset, name: str) -> xr.DataArray:
    """Return a mask of points at which two exponentials beat eq. 6 with a rate in range."""
    return points[name] > MIN_RATE


def _shares(ax: Axes, dataset: xr.Dataset) -> None:
    """Stack, over x, the share of fitted points that each model describes best."""
    x, best = dataset.speed_ratio.values.ravel(), dataset.best_model.values.ravel()
    edges = np.geomspace(x.min() * 0.99, x.max() * 1.01, 7)
    every, _ = np.histogram(x[best > 0], edges)
    below = np.zeros(every.size)
    for code, name, colour in MODELS:
        share = np.histogram(x[best == code], edges)[0] / np.maximum(every, 1)
        ax.bar(edges[:-1], share, np.diff(edges), below, align="edge", color=colour, label=name)
        below += share
    ax.set(xscale="log", xlabel=X_LABEL, ylim=(0, 1.32), yticks=[0, 0.5, 1])
    ax.set(ylabel="share of fitted points", title="(c) best model")
    ax.legend(loc="upper center", fontsize=6, ncols=2)
