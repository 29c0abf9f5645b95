"""Friction and temperature of the contact after a velocity step: two relaxations.

Theory of the second one: B. N. J. Persson, A. I. Volokitin, Phys. Rev. B 65, 134106 (2002), cited
from memory.
"""

import json
import math
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import slide_of
from elastomer_friction.workflow.report import COLOURS, band, foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction (a) and mean temperature of the contact (b) of a rubber over the distance slid since "
    "a velocity step, with the heating of the block (solid), without it (dashed) and without any "
    "heating (dotted); the distances over which friction falls from its peak to 1/e of its decay "
    "without the heating of the block, and over which this heating takes a further tenth of it "
    "(c); and the temperature that the block adds (solid) with that of a uniform flux into a "
    "half-space (dotted), which grows as the heated depth $\\sqrt{Ds/v}$ (d). After each side of "
    "the surface, here 4 mm, contacts meet their own warm tracks."
)
HEATED, FLASH, COLD = "", "flash", "cold"
STYLES = {HEATED: "-", FLASH: "--", COLD: ":"}
NAMES = {HEATED: "contact and block heat", FLASH: "contact heats", COLD: "no heating"}
TENTH = 0.1  # further share of the friction that the block takes at the second distance


class Distances(NamedTuple):
    """Relaxation distances after a step, in m; NaN if the slide is too short."""

    contact: float
    background: float


def relaxation_distances(heated: xr.Dataset, flash: xr.Dataset) -> Distances:
    """Return the distances over which the contact and the background relax after a step."""
    slid, mu = flash.slid.values, flash.trace_mu.values
    peak = int(np.argmax(mu))
    decay = mu[-1] + (mu[peak] - mu[-1]) / math.e
    kept = heated.trace_mu.values / mu
    return Distances(
        _first(slid[peak:], mu[peak:] <= decay) - float(slid[peak]),
        _first(slid, kept <= (1.0 - TENTH) * kept[0]),
    )


def _first(slid: np.ndarray, reached: np.ndarray) -> float:
    """Return the first distance at which a condition holds, or NaN."""
    return float(slid[np.argmax(reached)]) if reached.any() else np.nan


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    axes_of_grid = ("velocity", "normal_pressure")
    velocities, pressures = (np.unique(groups[HEATED][name]) for name in axes_of_grid)
    middle = float(pressures[pressures.size // 2])
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.6))
    for velocity, colour in zip(velocities, COLOURS, strict=False):
        for name, line in STYLES.items():
            _history(axes[0, 0], _slide(groups[name], velocity, middle), "trace_mu", line, colour)
            if name != COLD:
                slide = _slide(groups[name], velocity, middle)
                _history(axes[0, 1], slide, "trace_contact_temperature", line, colour)
        axes[0, 0].plot([], [], color=colour, label=f"{with_unit(velocity, 'm/s')} × 3")
    for name, line in STYLES.items():
        axes[0, 1].plot([], [], line, color="0.3", label=NAMES[name])
    axes[0, 0].set(ylabel="coefficient of friction $\\mu$", title="(a) friction")
    axes[0, 1].set(ylabel="temperature (°C)", title="(b) contact temperature")
    _distances(axes[1, 0], groups, velocities, pressures)
    _background(axes[1, 1], groups, velocities, middle)
    for ax in (axes[0, 0], axes[0, 1]):
        ax.set(xscale="log", xlabel="distance since the step (m)")
    for ax in axes.flat:
        if ax.get_legend_handles_labels()[0]:
            ax.legend(loc="best")
    note = f"Panels a, b and d are at {with_unit(middle, 'Pa')}."
    foot_line(figure, groups[HEATED], note, bars="bands")
    return figure


def _slide(data: xr.Dataset, velocity: float, pressure: float) -> xr.Dataset:
    """Return the trace after the step at a velocity and pressure."""
    point = data.sel(velocity=velocity, normal_pressure=pressure, method="nearest").squeeze()
    return slide_of(point, 1)


def _history(ax: Axes, slide: xr.Dataset, name: str, line: str, colour: str) -> None:
    """Draw a trace over the distance slid since the step, with its standard error."""
    after = slide.isel(event=slide.slid.values > 0.0)
    band(ax, after.slid, after[name], after[f"{name}_error"], line, color=colour)


def _distances(ax: Axes, groups: Groups, velocities: np.ndarray, pressures: np.ndarray) -> None:
    """Draw both relaxation distances over the velocity after the step."""
    for pressure, form in zip(pressures, "sov", strict=False):
        distances = [
            relaxation_distances(*(_slide(groups[n], v, pressure) for n in (HEATED, FLASH)))
            for v in velocities
        ]
        label = with_unit(pressure, "Pa")
        style: dict[str, Any] = {"marker": form, "lw": 0.8}
        ax.plot(3.0 * velocities, [d.contact for d in distances], color="k", label=label, **style)
        ax.plot(3.0 * velocities, [d.background for d in distances], color=COLOURS[1], **style)
    ax.plot([], [], color="k", label="contact")
    ax.plot([], [], color=COLOURS[1], label="background heat")
    ax.set(xscale="log", yscale="log", xlabel="speed after the step (m/s)", ylabel="distance (m)")
    ax.set_title("(c) relaxation distances")


def _background(ax: Axes, groups: Groups, velocities: np.ndarray, pressure: float) -> None:
    """Draw the temperature that the block adds, and that of a uniform flux into a half-space."""
    heat = json.loads(groups[HEATED].attrs["study"])["scene"]["heat"]
    effusivity = np.sqrt(heat["conductivity"] * heat["heat_capacity"])
    for velocity, colour in zip(velocities, COLOURS, strict=False):
        points = {"velocity": velocity, "normal_pressure": pressure}
        heated, flash = (
            groups[name].sel(points, method="nearest").squeeze() for name in (HEATED, FLASH)
        )
        added = heated.trace_contact_temperature - flash.trace_contact_temperature
        flux = (heated.trace_mu * pressure * heated.trace_velocity).values
        time = heated.trace_time.values
        uniform = np.array([_warmed(flux[: k + 1], time[: k + 1]) for k in range(time.size)])
        after = slide_of(heated, 1)
        slid, inside = after.slid.values, heated.trace_segment.values == 1
        ax.plot(slid, added[inside], color=colour)
        ax.plot(slid, uniform[inside] / effusivity, ":", color=colour)
    ax.set(xscale="log", yscale="log", xlabel="distance since the step (m)")
    ax.set(ylabel="rise of temperature (K)", title="(d) added by the block; dotted: theory")


def _warmed(flux: np.ndarray, time: np.ndarray) -> float:
    """Return the effusivity times the temperature due to a flux, constant between the times."""
    root = np.sqrt(time[-1] - time)
    return float(2.0 / np.sqrt(np.pi) * np.sum(flux[1:] * (root[:-1] - root[1:])))
