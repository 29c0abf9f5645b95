"""Friction of a rigid sphere over its speed: half-space, foundation, closed form, published."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import COLOURS
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction is shown of a rigid sphere that slides over a Kelvin half-space and over the "
    "foundation with the profile x²/R, over the speed in radii of contact per relaxation time, "
    "beside the closed form for slow sliding. Panel (b) has a standard linear solid and the "
    "published values of Carbone and Putignano (2013)."
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.2))
    data = groups[""]
    axes[0].plot(data.speed, data.closed, "k--", lw=0.8, label="$v \\tau/R$")
    axes[0].plot(data.speed, 2.0 * data.closed, "k:", lw=0.8, label="$2 v \\tau/R$")
    axes[0].set(title="(a) one relaxation time", xlabel="$v \\tau/a$", ylim=(1e-5, 0.2))
    for ax, name in zip(axes, ("", "published"), strict=True):
        if name in groups:
            own = groups[name]
            ax.plot(own.speed, own.half_space, "o", color=COLOURS[0], label="half-space", ms=4)
            ax.plot(own.speed, own.foundation, "s", color=COLOURS[1], label="foundation", ms=4)
        ax.set(xscale="log", yscale="log", ylabel="coefficient of friction $\\mu$")
    if "published" in groups:
        own = groups["published"]
        axes[1].plot(own.speed, own.published, "kx", label="Carbone and Putignano")
    axes[1].set(title="(b) standard linear solid", xlabel="$v \\cdot 10$ ms$/a$")
    for ax in axes[: len(groups)]:
        ax.legend(loc="best")
    return figure
