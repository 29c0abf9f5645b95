"""Figure 7 on a half-space and the foundation: steady friction, jump and relaxation over x."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import BODIES, DOTS, X_LABEL, by_hurst, fitted, normalised
from elastomer_friction.workflow.report import (
    COLOURS,
    error_bars,
    foot_line,
    legend_in_room,
    with_unit,
)
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Velocity steps of 20 % are shown on a half-space (circles, solid) and on the foundation of "
    "the paper at the same nominal pressure (squares, dashed). The panels hold (a) steady friction "
    "over the rms slope, (b) the jump over slope and relative step, which the paper gives as 0.4 "
    "on its plateau, (c) the relaxation rate b with eq. 13 as dotted lines, and (d) the exponent α "
    "of b = x^α for x > 1, which the paper gives as 1 − H; squares are shifted by 0.015, and "
    "bars in (c) and (d) hold the bound of the discretisation error beside the standard error."
)
HALF_SPACE, ASIDE = "", 0.015  # group; shift of H of the foundation in (d), so that both are seen


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.6))
    for group, form in BODIES.items():
        data = middle_pressure(groups[group])
        for hurst, points, colour in by_hurst(fitted(normalised(data))):
            style = DOTS | form | {"color": colour, "fmt": "", "ms": 3.5}
            label = f"$H = {hurst:g}$" if group == HALF_SPACE else None
            _over_x(axes[0, 0], points, "mu_bar", style | {"label": label})
            _over_x(axes[0, 1], points, "jump_bar", style)
            bias = points.relaxation_rate_bias * points.relaxation_rate
            _over_x(axes[1, 0], points, "relaxation_rate", style, bias)
    for hurst, points, colour in by_hurst(groups[HALF_SPACE]):
        x = np.geomspace(1.0, max(2.0, float(points.speed_ratio.max())), 50)
        axes[1, 0].plot(x, x ** (1.0 - hurst), color=colour, lw=0.8, ls=":")
    axes[0, 0].set(ylabel="$\\mu_1/\\nabla z$", title="(a) steady sliding", yscale="log")
    axes[0, 0].legend(loc="lower right")
    axes[0, 1].set(
        ylabel="$\\Delta\\mu_0/(\\nabla z\\,\\Delta v/v_1)$", title="(b) jump", ylim=(0.0, None)
    )
    axes[0, 1].axhline(0.4, color="0.4", lw=0.7, ls=":")
    for form, label in zip(BODIES.values(), ("half-space", "foundation"), strict=True):
        axes[0, 1].plot([], [], color="0.3", lw=0.5, ms=3.5, label=label, **form)
    legend_in_room(axes[0, 1], 0.15)
    axes[1, 0].set(ylabel="relaxation rate $b$ (per $\\tau$)", title="(c) relaxation", yscale="log")
    _exponents(axes[1, 1], groups)
    pressure = with_unit(float(middle_pressure(groups[HALF_SPACE]).normal_pressure[0]), "Pa")
    note = f"The nominal pressure is {pressure} in (a) to (c); (d) is of all pressures."
    foot_line(figure, groups[HALF_SPACE], note)
    return figure


def middle_pressure(data: xr.Dataset) -> xr.Dataset:
    """Return the points at the middle pressure."""
    return data.isel(normal_force=[data.sizes["normal_force"] // 2])


def _over_x(
    ax: Axes, points: xr.Dataset, name: str, style: dict, bias: xr.DataArray | float = 0.0
) -> None:
    error_bars(ax, points, name, "speed_ratio", bias=bias, **style)
    ax.set(xscale="log", xlabel=X_LABEL)


def _exponents(ax: Axes, groups: Groups) -> None:
    """Draw the exponents of both bodies over H."""
    for (group, form), colour in zip(BODIES.items(), COLOURS, strict=False):
        data = groups[group]
        data = data.assign_coords(hurst=data.hurst + ASIDE * (group != HALF_SPACE))
        style: dict[str, Any] = {"color": colour, "fmt": form["marker"], "ms": 4.0}
        label = "half-space" if group == HALF_SPACE else "foundation"
        error_bars(ax, data, "alpha", "hurst", bias=data.alpha_bias, label=label, **style)
    ax.plot([0, 1], [1, 0], "k--", lw=0.8, label="$1 - H$ (paper)")
    ax.set(xlabel="Hurst exponent $H$", ylabel="$\\alpha$ of $b = x^\\alpha$, $x > 1$")
    ax.set_title("(d) exponent")
    ax.legend(loc="best")
