"""Figure 6: normalised jump over normalised friction, against eq. 12, for many H."""

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import DOTS, VARIANTS, normalised, shades, significant_jumps
from elastomer_friction.workflow.kinetic_law import PLATEAU, normalised_jump
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The upper panels show the normalised jump of friction over the normalised steady friction for "
    "several Hurst exponents H, with eq. 12 of the paper as a line, (a) converged in time and (b) "
    "with one implicit Euler step per spacing Δx. The lower panels show the ratio of the simulated "
    "jump to that of eq. 12, which would be 1 if the law were exact."
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(
        2, 2, figsize=(6.9, 4.4), sharex=True, sharey="row", height_ratios=(2.4, 1)
    )
    colours = shades(0.0, 1.0, log=False)
    for column, (group, label), letter in zip(axes.T, VARIANTS.items(), "ab", strict=True):
        points = normalised(significant_jumps(groups[group].squeeze()))
        law = normalised_jump(points.mu_bar)
        points["ratio"], points["ratio_error"] = points.jump_bar / law, points.jump_bar_error / law
        for hurst in points.hurst.values:
            for ax, name in zip(column, ("jump_bar", "ratio"), strict=True):
                line = points.sel(hurst=hurst)
                error_bars(ax, line, name, "mu_bar", color=colours.to_rgba(hurst), **DOTS)
        column[0].set_title(f"({letter}) {label}")
        column[1].axhline(1.0, color="k", lw=0.8)
        column[1].set_xlabel("$\\bar\\mu_1 = \\mu_1/\\nabla z$")
    low, high = axes[0, 0].get_xlim()
    span = np.geomspace(low, high, 200) if low > 0.0 else np.geomspace(1e-4, 3.0, 200)
    for ax in axes[0]:
        ax.plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12", zorder=3)
        ax.axhline(PLATEAU, color="0.5", ls=":", lw=0.8, label="0.4 (eq. 11)")
        ax.set(xscale="log", yscale="log")
    axes[0, 0].set_ylabel("$\\Delta\\bar\\mu_0 / (\\Delta v/v_1)$")
    axes[0, 0].legend(loc="lower right")
    axes[1, 0].set(ylabel="simulated / eq. 12", ylim=(0.0, 1.6))
    figure.colorbar(colours, ax=axes, label="Hurst exponent $H$")
    foot_line(figure, groups[""], "Jumps below two standard errors are not shown.")
    return figure
