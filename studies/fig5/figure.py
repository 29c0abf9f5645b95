"""Figure 5: jump and steady friction, both over the relative velocity step, for 20 forces."""

import matplotlib as mpl
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from workflow.report import foot_line
from workflow.result import Groups

QUANTITIES = {
    "jump": "$\\Delta\\mu_0 / (\\Delta v/v_1)$",
    "mu_1": "$\\mu_1$",
}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 3.0), sharey=True, layout="constrained")
    points = groups[""].squeeze()
    step = float(points.velocity_step)
    forces = points.normal_force.values
    norm = mpl.colors.LogNorm(forces.min(), forces.max())
    for ax, (name, label) in zip(axes, QUANTITIES.items(), strict=True):
        scale = step if name == "jump" else 1.0
        for force in forces:
            line = points.sel(normal_force=force)
            ax.errorbar(
                line.velocity,
                line[name] / scale,
                line[f"{name}_error"] / scale,
                color=plt.get_cmap("viridis")(norm(force)),
                lw=0.8,
                capsize=0,
            )
        ax.set(xscale="log", yscale="log", xlabel="sliding velocity $v_1$ (m/s)", ylabel=label)
    slope = float(points.rms_slope.max())
    for ax, level, text in (
        (axes[0], 0.4, "$0.4\\,\\nabla z$ (eq. 11)"),
        (axes[1], 1.0, "$\\nabla z$"),
    ):
        ax.axhline(level * slope, color="k", ls="--", lw=0.8)
        ax.text(points.velocity.values[0], 1.15 * level * slope, text, fontsize=7)
    axes[1].tick_params(labelleft=True)
    axes[0].set_title("(a)", loc="left")
    axes[1].set_title("(b)", loc="left")
    axes[0].set_ylim(slope * 1e-5 if np.isfinite(slope) else None, 4.0 * slope)
    colours = plt.cm.ScalarMappable(norm, "viridis")
    figure.colorbar(colours, ax=axes, label="normal force $F_N$ (N)")
    foot_line(figure, groups[""])
    return figure
