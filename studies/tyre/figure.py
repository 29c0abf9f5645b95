"""Friction and contact area of a tread rubber over speed and temperature, by three models."""

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import BODIES, TEMPERATURE_COLOURS
from elastomer_friction.workflow.report import error_bars, foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Hysteretic friction (a) and real contact area (b) of a tread rubber on a rough surface under "
    "a nominal pressure, over the speed, at several temperatures: a half-space (circles), the "
    "foundation (squares) and Persson's theory (dotted). The spread of the three is the error "
    "of the model."
)
PANEL_VARIABLES = {"mu_1": "mu_persson", "contact_fraction": "area_persson"}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.3))
    for ax, (name, theory) in zip(axes, PANEL_VARIABLES.items(), strict=True):
        for group, form in BODIES.items():
            data = groups[group].squeeze()
            for temperature, colour in zip(
                data.temperature.values, TEMPERATURE_COLOURS, strict=False
            ):
                points = data.sel(temperature=temperature)
                error_bars(ax, points, name, "velocity", lw=0.8, color=colour, **form)
                if group == "" and theory in points:
                    ax.plot(points.velocity, points[theory], ":", color=colour)
        ax.set(xscale="log", xlabel="speed (m/s)")
    for temperature, colour in zip(
        groups[""].temperature.values, TEMPERATURE_COLOURS, strict=False
    ):
        axes[0].plot([], [], "-", color=colour, label=with_unit(temperature, "°C"))
    for form, label in zip(BODIES.values(), ("half-space", "foundation"), strict=True):
        axes[1].plot([], [], color="0.3", label=label, **form)
    axes[1].plot([], [], ":", color="0.3", label="Persson's theory")
    axes[0].set(ylabel="coefficient of friction $\\mu$", title="(a) friction by hysteresis")
    axes[0].set_ylim(0.0, None)
    axes[1].set(yscale="log", ylabel="share in contact", title="(b) real contact area")
    for ax in axes:
        ax.legend(loc="best")
    pressure = with_unit(float(np.ravel(groups[""].normal_pressure)[0]), "Pa")
    foot_line(figure, groups[""], f"The nominal pressure is {pressure}.")
    return figure
