"""Figure 2: friction before, during and after a jump of the sliding velocity, up and down."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import SCHEMES, VARIANTS
from elastomer_friction.workflow.report import error_band, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The coefficient of friction µ is shown over the time since a jump of the sliding velocity, "
    "for a jump up and for a jump down; above in the computation that is converged in time, below "
    "in that with one implicit Euler step per spacing Δx. It jumps at once and then relaxes to its "
    "steady value at the new velocity (dotted), all of one curve in the same time step."
)
MARKERS = 8  # along a curve


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 4.2), sharex=True, sharey="row")
    for row, (group, label) in zip(axes, VARIANTS.items(), strict=True):
        dataset = groups[group]
        for ax, step in zip(row, dataset.velocity_step.values, strict=True):
            point = dataset.sel(velocity_step=step).squeeze()
            curve = point.dropna("sample", subset=["mu"])
            before = [-0.15 * float(curve.time[-1]), 0.0, 0.0]
            style = SCHEMES[group] | {"markevery": max(1, curve.sample.size // MARKERS)}
            error_band(ax, curve, "mu", "deviation_error", label=label, **style)
            colour = style["color"]
            ax.plot(before, [point.mu_1, point.mu_1, curve.mu[0]], color=colour)
            ax.axhline(float(point.mu_2), color=colour, lw=0.6, ls=":")
        row[0].set_ylabel("friction $\\mu$")
        row[1].legend(loc="upper right")
    for letter, k, step in zip("ab", range(2), groups[""].velocity_step.values, strict=True):
        axes[0, k].set_title(f"({letter}) $v_2 = {1.0 + step:g}\\,v_1$")
        axes[1, k].set_xlabel("time after the jump $(t - t_0)/\\tau$")
    foot_line(figure, groups[""], "The error is that of µ − µ₂.", bars="bands")
    return figure
