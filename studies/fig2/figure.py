"""Figure 2: friction before, during and after a jump of the sliding velocity, up and down."""

from typing import Any

import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from studies.style import SCHEMES, VARIANTS
from workflow.report import foot_line
from workflow.result import Groups

MARKERS = 8  # along a curve


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 2.8))
    for group, label in VARIANTS.items():
        dataset = groups[group]
        for ax, step, letter in zip(axes, dataset.velocity_step.values, "ab", strict=True):
            _history(ax, dataset.sel(velocity_step=step).squeeze(), SCHEMES[group], label)
            ax.set_title(f"({letter}) $v_2 = {1.0 + step:g}\\,v_1$")
            ax.set_xlabel("time after the jump $(t - t_0)/\\tau$")
    axes[0].set_ylabel("coefficient of friction $\\mu$")
    axes[0].legend(loc="lower right")
    note = "the error is that of the deviation from $\\mu_2$; dotted: $\\mu_2$"
    foot_line(figure, groups[""], note, bars="bands")
    return figure


def _history(ax: Axes, point: xr.Dataset, style: dict[str, Any], label: str) -> None:
    curve = point.dropna("sample", subset=["mu"])
    time, mu, spread = curve.time.values, curve.mu.values, curve.deviation_error.values
    before = -0.15 * time[-1]
    every = max(1, time.size // MARKERS)
    ax.plot(
        [before, 0.0, *time], [point.mu_1, point.mu_1, *mu], markevery=every, label=label, **style
    )
    colour = style["color"]
    ax.axhline(float(point.mu_2), color=colour, lw=0.6, ls=":")
    ax.fill_between(time, mu - spread, mu + spread, color=colour, alpha=0.25, lw=0)
