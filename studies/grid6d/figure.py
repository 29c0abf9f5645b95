"""The six-dimensional grid on the paper's scalings: friction, jump and rate of every point."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from workflow.figure import COLOURS, foot_line
from workflow.fits import FITTED
from workflow.kinetic_law import normalised_jump


def draw(result: Path) -> Figure:
    """Return the figure of a result file of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 2.8), layout="constrained")
    with xr.open_dataset(result) as dataset:
        for number, hurst in enumerate(dataset.hurst.values):
            points = dataset.sel(hurst=hurst).stack(point=dataset.mu_1.dims[1:])
            style = {"fmt": "o", "ms": 2.2, "lw": 0.5, "capsize": 0, "alpha": 0.7}
            style["color"] = COLOURS[number % len(COLOURS)]
            mu, slope = points.mu_1 / points.rms_slope, points.rms_slope
            x, step = points.speed_ratio, points.velocity_step
            axes[0].errorbar(x, mu, points.mu_1_error / slope, label=f"$H = {hurst:g}$", **style)
            jump, error = points.jump / slope / step, points.jump_error / slope / np.abs(step)
            axes[1].errorbar(mu, jump, error, **style)
            fitted = points.isel(point=(points.fit_status == FITTED).values)
            axes[2].errorbar(
                fitted.speed_ratio, fitted.relaxation_rate, fitted.relaxation_rate_error, **style
            )
        foot_line(figure, dataset)
    span = np.geomspace(*(np.array([1e-5, 3.0])), 100)
    axes[1].plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12")
    axes[0].set(xlabel="$x = v_1\\tau q_\\mathrm{max}$", ylabel="$\\mu_1/\\nabla z$")
    axes[1].set(xlabel="$\\mu_1/\\nabla z$", ylabel="$\\Delta\\bar\\mu_0/(\\Delta v/v_1)$")
    axes[2].set(xlabel="$x = v_1\\tau q_\\mathrm{max}$", ylabel="relaxation rate $b$ (per $\\tau$)")
    for ax, letter in zip(axes, "abc", strict=True):
        ax.set(xscale="log", yscale="log")
        ax.set_title(f"({letter})", loc="left")
    axes[0].legend(loc="lower right")
    axes[1].legend(loc="upper left")
    return figure
