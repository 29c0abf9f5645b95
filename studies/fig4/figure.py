"""Figure 4: fit of eq. 6 to the relaxation, and the rate b over the spacing."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import CONVERGED, SCHEMES, VARIANTS, fitted
from elastomer_friction.workflow.ground import with_error
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panel (a) shows how friction relaxes to its steady value µ₂ after a velocity step, and the "
    "exponential of eq. 6 that is fitted to it within the window shown. Panel (b) shows the rate b "
    "of such fits over the spacing Δx of the elements, beside the value that the paper reports "
    "without saying its spacing."
)
PAPER_RATE = 2.4
UNIT = 1e4  # panel (a) shows friction in units of 1e-4


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 2.8))
    for group, label in VARIANTS.items():
        points = groups[group].squeeze()
        rates = fitted(points)
        style = SCHEMES[group] | {"ls": "-", "label": label}
        error_bars(axes[1], rates, "relaxation_rate", "spacing", **style)
        if group == CONVERGED:
            nearest = np.abs(rates.relaxation_rate - PAPER_RATE).argmin("spacing")
            _fit(axes[0], points.isel(spacing=nearest))
    note = (
        "The first points of (a) lie below the exponential, which is not the whole law. The "
        "caption of the paper gives no spacing."
    )
    foot_line(figure, groups[CONVERGED], note)
    axes[1].axhline(PAPER_RATE, color="k", ls="--", lw=0.8, label="paper, $b = 2.4$")
    axes[1].set(xscale="log", ylim=(0, None), title="(b) rate over spacing")
    spacing = groups[CONVERGED].spacing.values
    axes[1].set_xticks(spacing, [f"{1e6 * value:.3g}" for value in spacing])
    axes[1].minorticks_off()
    axes[1].set_xlabel("spacing $\\Delta x$ (µm)")
    axes[1].set_ylabel("relaxation rate $b$ (per $\\tau$)")
    axes[1].legend()
    return figure


def _fit(ax: Axes, point: xr.Dataset) -> None:
    curve = point.dropna("sample", subset=["mu"]).isel(sample=slice(0, None, 2))
    deviation, error = UNIT * curve.deviation, UNIT * curve.deviation_error
    style = SCHEMES[CONVERGED] | {"ls": "", "ms": 2.6, "lw": 0.6, "label": "simulated"}
    ax.errorbar(curve.time, deviation, error, **style)
    inside = np.linspace(0.0, float(point.fit_window), 100)
    rate, error = float(point.relaxation_rate), float(point.relaxation_rate_error)
    exponential = UNIT * float(point.amplitude) * np.exp(-rate * inside)
    label = f"eq. 6, b = {with_error(rate, error)}, window shown"
    ax.plot(inside, exponential, color=COLOURS[0], zorder=3, label=label)
    ax.axhline(0.0, color="0.6", lw=0.5)
    ax.set(xlabel="time after the jump $(t - t_0)/\\tau$", ylabel="$\\mu - \\mu_2$ ($10^{-4}$)")
    ax.set_title(f"(a) $\\Delta x$ = {float(point.spacing) * 1e6:.3g} µm")
    ax.legend()
