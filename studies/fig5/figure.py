"""Figure 5: jump over the relative velocity step, and steady friction, for many forces."""

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import shades
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panel (a) shows the jump of friction over the relative velocity step, and panel (b) the "
    "steady friction, over the sliding velocity and for several normal forces. At low velocities "
    "both grow with the velocity, and at high ones both reach a plateau (dashed) that no longer "
    "depends on the force."
)
JUMP_LABEL = "$\\Delta\\mu_0 / (\\Delta v/v_1)$"
PANELS = (  # variable, label, plateau over the rms slope, its label, title
    ("jump_over_step", JUMP_LABEL, 0.4, "$0.4\\,\\nabla z$ (eq. 11)", "(a) jump"),
    ("mu_1", "$\\mu_1$", 1.0, "$\\nabla z$", "(b) steady friction"),
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 3.0), sharey=True)
    points = groups[""].squeeze()
    step, slope = points.velocity_step, float(points.rms_slope.max())
    points = points.assign(
        jump_over_step=points.jump / step, jump_over_step_error=points.jump_error / step
    )
    forces = points.normal_force.values
    colours = shades(forces.min(), forces.max())
    for ax, (name, label, level, text, title) in zip(axes, PANELS, strict=True):
        for force in forces:
            line, colour = points.sel(normal_force=force), colours.to_rgba(force)
            error_bars(ax, line, name, "velocity", color=colour, lw=0.8, capsize=0)
        ax.axhline(level * slope, color="k", ls="--", lw=0.8)
        ax.text(points.velocity.values[0], 1.15 * level * slope, text, fontsize=7)
        ax.set(xscale="log", yscale="log", xlabel="sliding velocity $v_1$ (m/s)")
        ax.set(ylabel=label, title=title)
    axes[1].tick_params(labelleft=True)
    axes[0].set_ylim(slope * 1e-5 if np.isfinite(slope) else None, 4.0 * slope)
    figure.colorbar(colours, ax=axes, label="normal force $F_N$ (N)")
    foot_line(figure, groups[""])
    return figure
