"""Figure 5: jump over the relative velocity step, and steady friction, for many forces."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import (
    CONVERGED,
    PAPER_STEP,
    VARIANTS,
    shades,
    significant_jumps,
)
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panel (a) shows the jump of friction over the relative velocity step, and panel (b) the "
    "steady friction, over the sliding velocity and for several normal forces, converged in time "
    "and for three forces with one implicit Euler step per spacing Δx. At low velocities both grow "
    "with the velocity, and at high ones both reach a plateau (horizontal)."
)
JUMP_LABEL = "$\\Delta\\mu_0 / (\\Delta v/v_1)$"
PANELS = (  # variable, label, plateau over the rms slope, its label, title
    ("jump_over_step", JUMP_LABEL, 0.4, "$0.4\\,\\nabla z$ (eq. 11)", "(a) jump"),
    ("mu_1", "$\\mu_1$", 1.0, "$\\nabla z$", "(b) steady friction"),
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 3.0), sharey=True)
    points, coarse = (_over_step(groups[group].squeeze()) for group in (CONVERGED, PAPER_STEP))
    slope = float(points.rms_slope.max())
    forces = points.normal_force.values
    colours = shades(forces.min(), forces.max())
    for ax, (name, label, level, text, title) in zip(axes, PANELS, strict=True):
        for force in forces:
            line, colour = points.sel(normal_force=force), colours.to_rgba(force)
            error_bars(ax, line, name, "velocity", color=colour, lw=0.8, capsize=0)
        for force in forces[[0, forces.size // 2, -1]]:
            line, colour = coarse.sel(normal_force=force), colours.to_rgba(force)
            error_bars(ax, line, name, "velocity", color=colour, lw=0.8, ls=":", capsize=0)
        ax.axhline(level * slope, color="k", ls="--", lw=0.8)
        ax.text(points.velocity.values[0], 1.15 * level * slope, text, fontsize=7)
        ax.set(xscale="log", yscale="log", xlabel="sliding velocity $v_1$ (m/s)")
        ax.set(ylabel=label, title=title)
    for group, style in ((CONVERGED, "-"), (PAPER_STEP, ":")):
        axes[1].plot([], [], style, color="0.3", label=VARIANTS[group])
    axes[1].legend(loc="lower right")
    axes[1].tick_params(labelleft=True)
    axes[0].set_ylim(slope * 1e-5 if np.isfinite(slope) else None, 4.0 * slope)
    figure.colorbar(colours, ax=axes, label="normal force $F_N$ (N)")
    foot_line(figure, groups[""], "Jumps below two standard errors are not shown.")
    return figure


def _over_step(points: xr.Dataset) -> xr.Dataset:
    """Add the jump over the relative velocity step."""
    step, points = points.velocity_step, significant_jumps(points)
    return points.assign(
        jump_over_step=points.jump / step, jump_over_step_error=points.jump_error / step
    )
