"""The map of Fbar over x: worst residual, Newton passes, and change on halving the samples."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.collections import QuadMesh
from matplotlib.colors import BoundaryNorm, LogNorm, Normalize
from matplotlib.figure import Figure

from elastomer_friction.studies.style import X_LABEL
from elastomer_friction.workflow.report import write_below
from elastomer_friction.workflow.result import Groups

from .probe import RESIDUALS

CAPTION = (
    "The maps show three quantities over the dimensionless velocity x and load, for both schemes: "
    "the worst residual of any step, the largest number of Newton passes of a step, and by how "
    "much friction changes when the step is halved. A computation that fails anywhere in the space "
    "of parameters would show here."
)
TICKS = [1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6]


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""]
    cases = data.passes.size + groups["corners"].sizes["case"]
    worst = data[list(RESIDUALS)].to_dataarray().max("variable")
    whole = range(int(data.passes.min()), int(data.passes.max()) + 1)
    passes = BoundaryNorm([*(np.array(whole) - 0.5), whole[-1] + 0.5], 256)
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 4.6), sharex=True, sharey=True)
    mesh = _maps(axes[:, 0], "ad", worst, "viridis", LogNorm(1e-16, 1e-6))
    _bar(mesh, axes[:, 0], "worst residual, relative")
    mesh = _maps(axes[:, 1], "be", data.passes, "cividis", passes)
    _bar(mesh, axes[:, 1], "Newton passes of a step, at most", whole)
    mesh = _maps(axes[:, 2], "cf", data.refinement, "magma", LogNorm(1e-8, 1.0))
    _bar(mesh, axes[:, 2], "change of $\\mu_1/\\nabla z$ by halving the step")
    for ax in axes[-1]:
        ax.set_xlabel(X_LABEL)
    for ax in axes[:, 0]:
        ax.set_ylabel("load $\\bar F = F_N/(4GLh)$")
    write_below(
        figure,
        f"H = {data.hurst:g}, {data.elements} elements of m = {data.steps_per_spacing} samples, "
        f"v₂/v₁ = 1.2; {cases} cases with those in the corners, seed {data.attrs['seed']}.",
        "Panels (c) and (f) are pale where contacts are narrower than a sample.",
    )
    return figure


def _maps(
    axes: np.ndarray, letters: str, values: xr.DataArray, cmap: str, norm: Normalize
) -> QuadMesh:
    """Colour the maps of both schemes; values below the scale have its lowest colour."""
    shown = values.clip(norm.vmin)
    for ax, scheme, letter in zip(axes, values.scheme.values, letters, strict=True):
        colours = shown.sel(scheme=scheme)
        at = (values.speed_ratio, values.mean_load)
        mesh = ax.pcolormesh(*at, colours, rasterized=True, cmap=cmap, norm=norm)
        ax.set(xscale="log", yscale="log", xticks=TICKS, title=f"({letter}) {scheme}")
        ax.minorticks_off()
    return mesh


def _bar(mesh: QuadMesh, axes: np.ndarray, title: str, ticks: range | None = None) -> None:
    bar = axes[0].figure.colorbar(mesh, ax=axes, location="top", aspect=30, ticks=ticks)
    bar.set_label(title, fontsize=7.5)
