"""Figure 8: exponent alpha of eq. 13 over the Hurst exponent, for x > 1."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import CONVERGED, SCHEMES, VARIANTS
from elastomer_friction.workflow.report import error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The exponent α of the relaxation rate for x > 1 is shown over the Hurst exponent H, with the "
    "time step of the paper's branch and converged in time, beside the paper's 1 − H (dashed). "
    "Filled markers stand for fits of b = x^α, and hollow ones for fits in which a factor before x "
    "is free."
)
SHARE = 0.16  # of the distance between two H, between the series of one of them


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, ax = plt.subplots(figsize=(4.8, 3.4))
    hurst = groups[CONVERGED].hurst.values
    apart = SHARE * float(np.diff(hurst).min() if hurst.size > 1 else 0.1)
    places = iter(apart * (np.arange(4) - 1.5))
    for group, label in VARIANTS.items():
        for name, law in (("alpha", "x^\\alpha"), ("alpha_free", "c\\,x^\\alpha")):
            data = groups[group]
            bias = data[f"{name}_bias"] if group == CONVERGED else 0.0  # the other is all step
            style: dict[str, Any] = {"ls": "", "ms": 4.5, "label": f"{label}, $b = {law}$"}
            style |= SCHEMES[group]
            if name == "alpha_free":
                style |= {"mfc": "white", "mew": 0.9}
            error_bars(ax, data, name, "hurst", bias=bias, aside=next(places), **style)
    note = "the four series of an H stand side by side; converged: with what the bias may add"
    foot_line(figure, groups[CONVERGED], note)
    ax.plot([0, 1], [1, 0], "k--", lw=0.8, label="$1 - H$ (paper)")
    ax.set(xlabel="Hurst exponent $H$", ylabel="exponent $\\alpha$ for $x > 1$", ylim=(-0.1, 1.45))
    ax.legend(loc="upper right", fontsize=6)
    return figure
