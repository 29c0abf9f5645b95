"""Figure 2: friction before, during and after a jump of the sliding velocity, up and down."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import SCHEMES, VARIANTS
from elastomer_friction.workflow.report import error_band, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The coefficient of friction µ is shown over the time since a jump of the sliding velocity, "
    "(a) for a jump up and (b) for a jump down. It jumps at once and then relaxes to its steady "
    "value at the new velocity (dotted), in the computation that is converged in time and in that "
    "with one implicit Euler step per element."
)
MARKERS = 8  # along a curve


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 2.8), sharey=True)
    for group, label in VARIANTS.items():
        dataset = groups[group]
        for ax, step, letter in zip(axes, dataset.velocity_step.values, "ab", strict=True):
            point = dataset.sel(velocity_step=step).squeeze()
            curve = point.dropna("sample", subset=["mu"])
            before = [-0.15 * float(curve.time[-1]), 0.0, 0.0]
            style = SCHEMES[group] | {"markevery": max(1, curve.sample.size // MARKERS)}
            error_band(ax, curve, "mu", "deviation_error", label=label, **style)
            colour = style["color"]
            ax.plot(before, [point.mu_1, point.mu_1, curve.mu[0]], color=colour)
            ax.axhline(float(point.mu_2), color=colour, lw=0.6, ls=":")
            ax.set_title(f"({letter}) $v_2 = {1.0 + step:g}\\,v_1$")
            ax.set_xlabel("time after the jump $(t - t_0)/\\tau$")
    axes[0].set_ylabel("coefficient of friction $\\mu$")
    axes[0].legend(loc="lower right")
    foot_line(figure, groups[""], "The error is that of µ − µ₂.", bars="bands")
    return figure
