"""Figure 6: normalised jump over normalised friction, against eq. 12, for many H."""

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import DOTS, normalised, shades
from elastomer_friction.workflow.kinetic_law import PLATEAU, normalised_jump
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The upper panel shows the normalised jump of friction over the normalised steady friction for "
    "several Hurst exponents H, with eq. 12 of the paper as a line. The lower panel shows the "
    "ratio of the simulated jump to that of eq. 12, which would be 1 if the law were exact."
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 1, figsize=(3.6, 4.4), sharex=True, height_ratios=(2.4, 1))
    points = normalised(groups[""].squeeze())
    law = normalised_jump(points.mu_bar)
    points["ratio"], points["ratio_error"] = points.jump_bar / law, points.jump_bar_error / law
    colours = shades(0.0, 1.0, log=False)
    for hurst in points.hurst.values:
        for ax, name in zip(axes, ("jump_bar", "ratio"), strict=True):
            line = points.sel(hurst=hurst)
            error_bars(ax, line, name, "mu_bar", color=colours.to_rgba(hurst), **DOTS)
    low, high = axes[0].get_xlim()
    span = np.geomspace(low, high, 200) if low > 0.0 else np.geomspace(1e-4, 3.0, 200)
    axes[0].plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12", zorder=3)
    axes[0].axhline(PLATEAU, color="0.5", ls=":", lw=0.8, label="0.4 (eq. 11)")
    axes[0].set(xscale="log", yscale="log", ylabel="$\\Delta\\bar\\mu_0 / (\\Delta v/v_1)$")
    axes[0].legend(loc="lower right")
    axes[1].axhline(1.0, color="k", lw=0.8)
    axes[1].set(xlabel="$\\bar\\mu_1 = \\mu_1/\\nabla z$", ylabel="simulated / eq. 12")
    axes[1].set_ylim(0.0, 1.6)
    figure.colorbar(colours, ax=axes, label="Hurst exponent $H$")
    foot_line(figure, groups[""])
    return figure
