"""Figure 2: friction before, during and after a jump of the sliding velocity, up and down."""

import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from studies.style import VARIANTS
from workflow.report import COLOURS, foot_line
from workflow.result import Groups


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 2.8))
    for (group, label), colour in zip(VARIANTS.items(), COLOURS, strict=False):
        dataset = groups[group]
        for ax, step in zip(axes, dataset.velocity_step.values, strict=True):
            _history(ax, dataset.sel(velocity_step=step).squeeze(), colour, label)
            ax.set_title(f"({'ab'[int(step < 0)]}) $v_2 = {1.0 + step:g}\\,v_1$")
            ax.set_xlabel("time after the jump $(t - t_0)/\\tau$")
    axes[0].set_ylabel("coefficient of friction $\\mu$")
    axes[0].legend(loc="lower right")
    foot_line(figure, groups[""], "bands: one standard error of the deviation from $\\mu_2$")
    return figure


def _history(ax: Axes, point: xr.Dataset, colour: str, label: str) -> None:
    curve = point.dropna("sample", subset=["mu"])
    time, mu, spread = curve.time.values, curve.mu.values, curve.deviation_error.values
    before = -0.15 * time[-1]
    ax.plot([before, 0.0, *time], [point.mu_1, point.mu_1, *mu], color=colour, label=label)
    ax.axhline(float(point.mu_2), color=colour, lw=0.6, ls=":")
    ax.fill_between(time, mu - spread, mu + spread, color=colour, alpha=0.25, lw=0)
