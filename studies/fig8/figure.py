"""Figure 8: exponent alpha of eq. 13 over the Hurst exponent, for x > 1."""

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from studies.style import CONVERGED, VARIANTS
from workflow.report import COLOURS, foot_line
from workflow.result import Groups


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, ax = plt.subplots(figsize=(3.6, 3.0), layout="constrained")
    for number, (group, label) in enumerate(VARIANTS.items()):
        dataset = groups[group]
        for name, marker, law in (
            ("alpha", "o", "x^\\alpha"),
            ("alpha_free", "^", "c\\,x^\\alpha"),
        ):
            ax.errorbar(
                dataset.hurst,
                dataset[name],
                dataset[f"{name}_error"],
                fmt=marker,
                color=COLOURS[number],
                mfc=COLOURS[number] if name == "alpha" else "none",
                label=f"{label}, $b = {law}$",
            )
        if group == CONVERGED:
            foot_line(figure, dataset, "")
    ax.plot([0, 1], [1, 0], "k--", lw=0.8, label="$1 - H$ (paper)")
    ax.set(xlabel="Hurst exponent $H$", ylabel="exponent $\\alpha$ for $x > 1$", ylim=(-0.1, 1.45))
    ax.legend(loc="upper right", fontsize=6)
    return figure
