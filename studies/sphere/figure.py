"""Friction of a rigid sphere over its speed: bodies, layers, closed form and published values."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.kernels import BACKINGS
from elastomer_friction.workflow.report import COLOURS
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction is shown of a rigid sphere that slides over a Kelvin half-space, over layers half a "
    "radius of contact thick on a rigid base, and over the foundation with the profile x²/R, over "
    "the speed in radii of contact per relaxation time, beside the closed form for slow sliding, "
    "which holds for any thickness, and the shear part of a constant stress of 1e-4 E* on the real "
    "contact of the half-space. Panel (b) has a standard linear solid and the "
    "published values of Carbone and Putignano (2013), with periods of 9, 12 and 36 radii of "
    "contact; those of (a) are 6 radii where sliding is slow and up to 24, and with 48 radii µ of "
    "the half-space is 3 % larger at the last point."
)
TITLES = {
    "": ("(a) one relaxation time", "speed over radius of contact, $v \\tau/a$"),
    "published": (
        "(b) standard linear solid",
        "speed over radius of contact, $10 \\, v t_b/a$, $t_b$ = 1 ms",
    ),
}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    names = [name for name in TITLES if name in groups]
    figure, axes = plt.subplots(1, len(names), figsize=(3.6 * len(names), 3.2), squeeze=False)
    for ax, name in zip(axes[0], names, strict=True):
        dataset = groups[name]
        ax.plot(dataset.speed, dataset.half_space, "o", color=COLOURS[0], label="half-space", ms=4)
        ax.plot(dataset.speed, dataset.foundation, "s", color=COLOURS[1], label="foundation", ms=4)
        ax.set(xscale="log", yscale="log", ylabel="coefficient of friction $\\mu$")
        title, label = TITLES[name]
        ax.set(title=title, xlabel=label)
    data = groups[""]
    for name, marker, colour in zip(BACKINGS, "^v", COLOURS[2:], strict=False):
        axes[0, 0].plot(data.speed, data[name], marker, color=colour, label=f"{name} layer", ms=4)
    axes[0, 0].plot(data.speed, data.shear, "d", color=COLOURS[4], label="shear", ms=4)
    axes[0, 0].plot(data.speed, data.closed, "k--", lw=0.8, label="$v \\tau/R$")
    axes[0, 0].plot(data.speed, 2.0 * data.closed, "k:", lw=0.8, label="$2 v \\tau/R$")
    axes[0, 0].set_ylim(1e-5, 0.2)
    if "published" in groups:
        dataset = groups["published"]
        axes[0, 1].plot(dataset.speed, dataset.published, "kx", label="Carbone and Putignano")
    for ax in axes[0]:
        ax.legend(loc="best")
    return figure
