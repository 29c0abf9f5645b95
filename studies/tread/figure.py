"""Friction of a tread rubber over speed: its two parts, cold and hot, area and temperature."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import TEMPERATURE_COLOURS
from elastomer_friction.workflow.report import error_bars, foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction of a tread rubber on a rough surface under a nominal pressure, over the speed: its "
    "sum with frictional heating at several temperatures (a); its viscoelastic and shear parts at "
    "the middle temperature, hot (discs) and cold (squares), with Persson's theory of the "
    "viscoelastic part, cold (dotted) (b); real contact area, hot (discs) and cold (squares) (c); "
    "and mean temperature of the contact over that of the scene (d). All heat enters the rubber, "
    "an upper bound."
)
HOT, COLD = "", "cold"
FORMS: dict[str, dict[str, Any]] = {
    HOT: {"marker": "o", "ls": "-"},
    COLD: {"marker": "s", "ls": "--"},
}
PARTS = {"mu_1_viscoelastic": ("viscoelastic", "#0072B2"), "mu_1_shear": ("shear", "#D55E00")}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    hot, cold = (groups[name].squeeze() for name in (HOT, COLD))
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.6))
    _over_temperatures(axes[0, 0], hot, "mu_1")
    axes[0, 0].set(ylabel="coefficient of friction $\\mu$", title="(a) friction, with heating")
    _parts(axes[0, 1], hot, cold)
    _over_temperatures(axes[1, 0], hot, "contact_fraction")
    _over_temperatures(axes[1, 0], cold, "contact_fraction", **FORMS[COLD])
    axes[1, 0].set(ylabel="share in contact", title="(c) real contact area")
    rise = hot.assign(rise=hot.contact_temperature - hot.temperature)
    rise = rise.assign(rise_error=hot.contact_temperature_error)
    _over_temperatures(axes[1, 1], rise, "rise")
    axes[1, 1].set(ylabel="rise of temperature (K)", title="(d) heating of the contact")
    for ax in axes.flat:
        ax.set(xscale="log", xlabel="speed (m/s)")
        ax.set_ylim(0.0, None)
        ax.legend(loc="best")
    pressure = with_unit(float(np.ravel(hot.normal_pressure)[0]), "Pa")
    foot_line(figure, groups[HOT], f"The nominal pressure is {pressure}.")
    return figure


def _over_temperatures(ax: Axes, data: xr.Dataset, name: str, **form: Any) -> None:
    """Draw an estimate over speed, a colour for each temperature."""
    style = FORMS[HOT] | form
    for temperature, colour in zip(data.temperature.values, TEMPERATURE_COLOURS, strict=False):
        points = data.sel(temperature=temperature)
        label = "" if form else with_unit(temperature, "°C")
        error_bars(ax, points, name, "velocity", lw=0.8, color=colour, label=label, **style)


def _parts(ax: Axes, hot: xr.Dataset, cold: xr.Dataset) -> None:
    """Draw the two parts of the friction, hot and cold, at the middle temperature."""
    middle = hot.temperature.values[hot.temperature.size // 2]
    for group, data in ((HOT, hot), (COLD, cold)):
        points = data.sel(temperature=middle)
        for name, (part, colour) in PARTS.items():
            label = f"{part}, {group or 'hot'}"
            style: dict[str, Any] = {"lw": 0.8, "color": colour, "label": label, **FORMS[group]}
            error_bars(ax, points, name, "velocity", **style)
    theory = cold.sel(temperature=middle)
    ax.plot(theory.velocity, theory.mu_persson, ":", color="0.3", label="Persson, viscoelastic")
    ax.set(ylabel="part of $\\mu$", title=f"(b) parts at {with_unit(middle, '°C')}")
