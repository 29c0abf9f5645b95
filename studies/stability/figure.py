"""The map of Fbar over x: worst residual, Newton passes, and what halving the samples changes."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import BoundaryNorm, LogNorm
from matplotlib.figure import Figure

from workflow.result import Groups

from .probe import RESIDUALS

TICKS = [1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6]
TITLES = (
    "worst residual, relative",
    "Newton passes of a step, at most",
    "change of $\\mu_1/\\nabla z$ by halving the step",
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""]
    cases = data.passes.size + groups["corners"].sizes["case"]
    worst = data[list(RESIDUALS)].to_dataarray().max("variable")
    passes = data.passes
    columns = (
        (worst, {"cmap": "viridis", "norm": LogNorm(1e-16, 1e-6)}),
        (passes, {"cmap": "cividis", "norm": _whole_numbers(passes)}),
        (data.refinement, {"cmap": "magma", "norm": LogNorm(1e-8, 1.0)}),
    )
    figure, axes = plt.subplots(
        2, 3, figsize=(7.2, 4.6), sharex=True, sharey=True, layout="constrained"
    )
    for column, (values, colours) in enumerate(columns):
        for row, scheme in enumerate(data.scheme.values):
            ax = axes[row, column]
            mesh = _map(ax, values.sel(scheme=scheme), colours)
            letter = "abcdef"[3 * row + column]
            ax.set_title(f"({letter}) {scheme}", loc="left")
        bar = figure.colorbar(mesh, ax=axes[:, column], location="top", aspect=30)
        bar.set_label(TITLES[column], fontsize=7.5)
        if column == 1:
            bar.set_ticks(list(range(int(passes.min()), int(passes.max()) + 1)))
    for ax in axes[-1]:
        ax.set_xlabel("$x = v_1 \\tau q_\\mathrm{max}$")
    for ax in axes[:, 0]:
        ax.set_ylabel("load $\\bar F = F_N/(4GLh)$")
    figure.supxlabel(
        f"$H = {data.hurst:g}$, {data.elements} elements, $m = {data.steps_per_spacing}$ samples "
        f"each, $v_2/v_1 = 1.2$; {cases} cases with those in the corners, seed "
        f"{data.attrs['seed']};\n(c, f): pale where contacts are narrower than a sample, which no "
        "residual shows",
        fontsize=6,
        color="0.35",
    )
    return figure


def _whole_numbers(values: xr.DataArray) -> BoundaryNorm:
    edges = np.arange(float(values.min()), float(values.max()) + 2.0) - 0.5
    return BoundaryNorm(edges, 256)


def _map(ax: Axes, values: xr.DataArray, colours: dict[str, Any]) -> QuadMesh:
    """Colour the map; what is smaller than the scale, or zero, has its lowest colour."""
    floor = float(colours["norm"].vmin)
    mesh = ax.pcolormesh(
        values.speed_ratio, values.mean_load, np.maximum(values, floor), rasterized=True, **colours
    )
    ax.set(xscale="log", yscale="log")
    ax.set_xticks(TICKS)
    ax.minorticks_off()
    return mesh
