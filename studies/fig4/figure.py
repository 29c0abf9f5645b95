"""Figure 4: fit of eq. 6 to the relaxation, and the rate b over the spacing."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from studies.style import CONVERGED, VARIANTS
from workflow.reduce import FITTED
from workflow.report import COLOURS, foot_line
from workflow.result import Groups

PAPER_RATE = 2.4


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 2.8), layout="constrained")
    for number, (group, label) in enumerate(VARIANTS.items()):
        points = groups[group].squeeze()
        _rates(axes[1], points, COLOURS[number], label)
        if group == CONVERGED:
            _fit(axes[0], points.isel(spacing=nearest_to_paper(points)))
            foot_line(figure, groups[group], "the caption of the paper gives no spacing")
    axes[1].axhline(PAPER_RATE, color="k", ls="--", lw=0.8, label="paper, $b = 2.4$")
    axes[1].set(xscale="log", xlabel="spacing $\\Delta x$ (m)", ylim=(0, None))
    axes[1].set_ylabel("relaxation rate $b$ (per $\\tau$)")
    axes[1].set_title("(b)", loc="left")
    axes[1].legend()
    return figure


def nearest_to_paper(points: xr.Dataset) -> int:
    """Return the index of the spacing whose fitted rate is nearest to the paper's."""
    distance = np.abs(points.relaxation_rate.values - PAPER_RATE)
    return int(np.nanargmin(np.where(points.fit_status.values == FITTED, distance, np.nan)))


def _fit(ax: Axes, point: xr.Dataset) -> None:
    time = point.time.dropna("sample").values
    deviation = (point.mu.dropna("sample") - point.mu_2).values
    shown = slice(0, None, 2)
    ax.plot(time[shown], 1e3 * deviation[shown], "o", color=COLOURS[0], label="simulated")
    inside = np.linspace(0.0, float(point.fit_window), 100)
    rate, error = float(point.relaxation_rate), float(point.relaxation_rate_error)
    ax.plot(
        inside,
        1e3 * float(point.amplitude) * np.exp(-rate * inside),
        color=COLOURS[4],
        label=f"eq. 6, $b = {rate:.2f} \\pm {error:.2f}$, window shown",
    )
    ax.axhline(0.0, color="0.6", lw=0.5)
    ax.set(xlabel="time after the jump $(t - t_0)/\\tau$")
    ax.set_ylabel("$10^3\\,(\\mu - \\mu_2)$")
    ax.set_title(f"(a) $\\Delta x$ = {float(point.spacing) * 1e6:.3g} µm", loc="left")
    ax.legend()


def _rates(ax: Axes, points: xr.Dataset, colour: str, label: str) -> None:
    fitted = points.where(points.fit_status == FITTED)
    ax.errorbar(
        fitted.spacing,
        fitted.relaxation_rate,
        fitted.relaxation_rate_error,
        fmt="o-",
        color=colour,
        label=label,
    )
