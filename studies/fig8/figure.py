"""Figure 8: exponent alpha of eq. 13 over the Hurst exponent, for x > 1."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import ASIDE, CONVERGED, SCHEMES, VARIANTS
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The exponent α of the relaxation rate for x > 1 is shown over the Hurst exponent H, with the "
    "time step of the paper's branch and converged in time, beside the paper's 1 − H (dashed). "
    "In panel (a) b = x^α is fitted, and in (b) with a factor before it that is free."
)
LAWS = {"alpha": "$b = x^\\alpha$", "alpha_free": "$b = c\\,x^\\alpha$"}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.4, 3.1), sharey=True)
    for ax, (name, law), letter in zip(axes, LAWS.items(), "ab", strict=True):
        for group, label in VARIANTS.items():
            data = groups[group].assign_coords(hurst=groups[group].hurst + ASIDE[group])
            bias = data[f"{name}_bias"] if group == CONVERGED else 0.0  # not converged
            style = SCHEMES[group] | {"ls": "", "ms": 4.0, "label": label}
            error_bars(ax, data, name, "hurst", bias=bias, **style)
        ax.plot([0, 1], [1, 0], "k--", lw=0.8, label="$1 - H$ (paper)")
        ax.set(xlabel="Hurst exponent $H$", title=f"({letter}) fits of {law}")
    axes[0].set_ylabel("exponent $\\alpha$ for $x > 1$")
    axes[0].legend(loc="lower left")
    foot_line(figure, groups[CONVERGED], "Bars of converged rates include the bound of the bias.")
    return figure
