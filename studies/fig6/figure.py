"""Figure 6: normalised jump over normalised friction, against eq. 12, for 11 Hurst exponents."""

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from workflow.kinetic_law import PLATEAU, normalised_jump
from workflow.report import foot_line
from workflow.result import Groups


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(
        2, 1, figsize=(3.6, 4.4), sharex=True, height_ratios=(2.4, 1), layout="constrained"
    )
    points = groups[""].squeeze()
    norm = mpl.colors.Normalize(0.0, 1.0)
    for hurst in points.hurst.values:
        line = points.sel(hurst=hurst)
        mu, jump, error = _normalised(line)
        style = {"fmt": "o", "ms": 2.2, "lw": 0.6, "capsize": 0}
        colour = plt.get_cmap("viridis")(norm(hurst))
        axes[0].errorbar(mu, jump, error, color=colour, **style)
        law = normalised_jump(mu)
        axes[1].errorbar(mu, jump / law, error / law, color=colour, **style)
    low, high = axes[0].get_xlim()
    span = np.geomspace(low, high, 200) if low > 0.0 else np.geomspace(1e-4, 3.0, 200)
    axes[0].plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12", zorder=3)
    axes[0].axhline(PLATEAU, color="0.5", ls=":", lw=0.8, label="0.4 (eq. 11)")
    axes[0].set(xscale="log", yscale="log")
    axes[0].set_ylabel("$\\Delta\\bar\\mu_0 / (\\Delta v/v_1)$")
    axes[0].legend(loc="lower right")
    axes[1].axhline(1.0, color="k", lw=0.8)
    axes[1].set(xlabel="$\\bar\\mu_1 = \\mu_1/\\nabla z$", ylabel="simulated / eq. 12")
    axes[1].set_ylim(0.0, 1.6)
    colours = plt.cm.ScalarMappable(norm, "viridis")
    figure.colorbar(colours, ax=axes, label="Hurst exponent $H$")
    foot_line(figure, groups[""])
    return figure


def _normalised(line: xr.Dataset) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    step, slope = float(line.velocity_step), line.rms_slope
    return (
        (line.mu_1 / slope).values,
        (line.jump / slope / step).values,
        (line.jump_error / slope / abs(step)).values,
    )
