"""Friction of a tread rubber over speed at several temperatures, and its three errors."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Hysteretic friction (a) and real contact area (b) of a tread rubber on a rough surface under "
    "a nominal pressure, over the speed, at several temperatures: a half-space (full symbols, with "
    "standard error and bias of the discretisation) and the foundation (open symbols). What lies "
    "between the two is the error of the model."
)
BODIES: dict[str, str | None] = {"": None, "foundation": "white"}  # and the faces of their symbols


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.3))
    for group, face in BODIES.items():
        data = groups[group].squeeze()
        for temperature, colour in zip(data.temperature.values, COLOURS, strict=False):
            points = data.sel(temperature=temperature)
            style: dict[str, Any] = {"fmt": "o-", "ms": 3.5, "lw": 0.7, "color": colour}
            style |= {"markerfacecolor": face or colour}
            label = f"{temperature:g} °C" if group == "" else None
            error_bars(axes[0], points, "mu_1", "velocity", label=label, **style)
            error_bars(axes[1], points, "contact_fraction", "velocity", **style)
    axes[0].set(xscale="log", xlabel="speed (m/s)", ylabel="coefficient of friction $\\mu$")
    axes[0].set_title("(a) friction by hysteresis")
    axes[0].set_ylim(0.0, None)
    axes[0].legend(loc="best")
    axes[1].set(xscale="log", yscale="log", xlabel="speed (m/s)", ylabel="share in contact")
    axes[1].set_title("(b) real contact area")
    pressure = float(np.ravel(groups[""].normal_pressure)[0])
    foot_line(figure, groups[""], f"nominal pressure {pressure / 1e3:.3g} kPa")
    return figure
