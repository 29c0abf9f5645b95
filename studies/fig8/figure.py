"""Figure 8: exponent alpha of eq. 13 over the Hurst exponent, for x > 1."""

from typing import Any

from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from studies.style import CONVERGED, VARIANTS
from workflow.report import COLOURS, error_bars, foot_line
from workflow.result import Groups


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, ax = plt.subplots(figsize=(3.6, 3.0))
    for (group, label), colour in zip(VARIANTS.items(), COLOURS, strict=False):
        for name, marker, face, law in (
            ("alpha", "o", colour, "x^\\alpha"),
            ("alpha_free", "^", "none", "c\\,x^\\alpha"),
        ):
            text = f"{label}, $b = {law}$"
            data = groups[group]
            style: dict[str, Any] = {"color": colour, "mfc": face, "label": text}
            bias = data[f"{name}_bias"] if group == CONVERGED else 0.0  # the other is all step
            error_bars(ax, data, name, "hurst", bias=bias, fmt=marker, **style)
    foot_line(figure, groups[CONVERGED], "where converged with what the bias of b may add")
    ax.plot([0, 1], [1, 0], "k--", lw=0.8, label="$1 - H$ (paper)")
    ax.set(xlabel="Hurst exponent $H$", ylabel="exponent $\\alpha$ for $x > 1$", ylim=(-0.1, 1.45))
    ax.legend(loc="upper right", fontsize=6)
    return figure
