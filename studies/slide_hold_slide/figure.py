"""Slide-hold-slide tests: static peak of the friction over the duration of the hold.

The drive is held, as in an experiment, and the line creeps while its spring relaxes; the stiffest
spring holds the line in place, where friction decays to zero. Compare Dieterich's law of healing
(C. Marone, Annu. Rev. Earth Planet. Sci. 26, 643 (1998)) with b and D_c from a velocity step of the
line by Ruina's law; nothing is fitted to the holds. Compare also S. Hulikal, K. Bhattacharya,
N. Lapusta, arXiv:1811.03811 (an array of viscoelastic elements, where a sustained increase of
static friction suggests many relaxation times), F. Landes, A. Rosso, E. Jagla,
arXiv:1503.07847 (slide-hold-slide of viscoelastic spring-blocks), and O. Ronsin, K. L.
Coeyrehourcq, "State, rate and temperature-dependent sliding friction of elastomers" (rubber on
glass, where deformation is negligible: compare kinetics, not magnitudes). The abstracts of Hulikal
et al. and of Ronsin and Coeyrehourcq were read; the others are cited from memory.
"""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import MAX_LIGHTNESS, slide_of
from elastomer_friction.workflow.report import (
    COLOURS,
    band,
    error_bars,
    foot_line,
    legend_in_room,
    with_unit,
)
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The drive of a sliding line is held for a while and then moves on; panels (a) and (b) show "
    "the static peak after the hold minus the friction before it, over the duration of the hold, "
    "for two materials, on springs and at a fixed position. Panel (c) shows the share of friction "
    "that remains at the end of the hold, and panel (d) friction over the distance slid after it."
)
KELVIN, RUBBER = "", "rubber"
TAU = 1e-3  # s, of the Kelvin element; the middle relaxation time of the rubber
LONGEST_TIME = 0.1  # s, longest relaxation time of the rubber
SHOWN_HOLDS = (0, 4, 5, 8)  # indices of the holds in panel (d)
STYLES: tuple[dict[str, Any], ...] = (  # of the springs, the softest first
    {"marker": "s", "ls": ":"},
    {"marker": "^", "ls": "--"},
    {"marker": "o", "ls": "-"},
)


def law(point: xr.Dataset, hold: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return b ln(1 + v t/D_c) after holds of t seconds, and its standard error.

    point : one velocity of a result, without axes of length 1. b and D_c are those of Ruina's law
    at the velocity step; their errors are taken as independent.
    """
    step = point.isel(hold=0).sel(law="ruina")
    b, dc = float(step.rate_state_b), float(step.rate_state_dc)
    slid = float(point.velocity) * hold / dc
    rise = b * np.log1p(slid)
    of_b = rise / b * float(step.rate_state_b_error)
    of_dc = b * slid / (1.0 + slid) / dc * float(step.rate_state_dc_error)
    return rise, np.hypot(of_b, of_dc)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.2))
    for name, ax in ((KELVIN, axes[0, 0]), (RUBBER, axes[0, 1])):
        data = groups[name].squeeze()
        for index, colour in zip(range(data.sizes["velocity"]), COLOURS, strict=False):
            point = data.isel(velocity=index)
            for spring, style in enumerate(STYLES):
                on_spring = point.isel(stiffness=spring)
                error_bars(ax, on_spring, "healing", "hold", ms=3, lw=0.6, color=colour, **style)
            holds = point.hold.values
            hold = np.geomspace(holds[0], holds[-1], 100)
            if name == RUBBER:
                rise, error = law(point.isel(stiffness=-1), hold)
                ax.fill_between(hold, rise - error, rise + error, color=colour, alpha=0.2, lw=0)
        ax.set(xscale="log", xlabel="duration of the hold $t_h$ (s)")
        ax.axvline(TAU if name == KELVIN else LONGEST_TIME, color="0.6", lw=0.7, ls=":")
        ax.axhline(0.0, color="0.7", lw=0.5)
    for velocity, colour in zip(data.velocity.values, COLOURS, strict=False):
        axes[0, 0].plot([], [], "-", color=colour, label=f"$v = {velocity:g}$ m/s")
    for stiffness, style in zip(data.stiffness.values, STYLES, strict=True):
        label = "fixed position" if stiffness == data.stiffness[-1] else f"$k = {stiffness:g}$ N/m"
        axes[0, 1].plot([], [], ms=3, lw=0.6, color="0.3", label=label, **style)
    axes[0, 0].legend(loc="center right")
    axes[0, 1].legend(loc="upper left")
    axes[0, 0].set_title("(a) Kelvin element; vertical: $\\tau$")
    axes[0, 1].set_title("(b) nine branches; vertical: longest time")
    axes[0, 0].set_ylabel("static peak $-$ $\\mu$ before the hold")
    _left(axes[1, 0], groups[RUBBER].squeeze().isel(velocity=0))
    _after(axes[1, 1], groups[RUBBER].squeeze().isel(velocity=0))
    foot_line(
        figure,
        groups[""],
        "(b) bands: Dieterich's b ln(1 + v t_h/D_c), b and D_c from a velocity step of the line, "
        "nothing fitted to the holds. Fixed position: k = 1 MN/m.",
    )
    return figure


def _left(ax: Axes, point: xr.Dataset) -> None:
    """Draw the share of friction that remains at the end of the hold, on every spring."""
    for index, style in enumerate(STYLES):
        on_spring = point.isel(stiffness=index)
        before = on_spring.static_peak - on_spring.healing
        share, error = (on_spring[f"mu_end_of_hold{end}"] / before for end in ("", "_error"))
        ax.errorbar(on_spring.hold, share, error, ms=3, lw=0.8, color=COLOURS[0], **style)
    ax.axhline(0.0, color="0.7", lw=0.5)
    ax.set(xscale="log", xlabel="duration of the hold $t_h$ (s)")
    ax.set_ylabel("$\\mu\\,/\\,\\mu$ before the hold")
    ax.set_title(f"(c) end of the hold, $v = {float(point.velocity):g}$ m/s, nine branches")


def _after(ax: Axes, point: xr.Dataset) -> None:
    """Draw friction over the distance slid after holds, at a fixed position and on a spring."""
    colours = plt.get_cmap("viridis")(np.linspace(MAX_LIGHTNESS, 0.0, len(SHOWN_HOLDS)))
    for index, colour in zip(SHOWN_HOLDS, colours, strict=True):
        for spring in (-1, 0):
            one = point.isel(hold=index, stiffness=spring)
            slide = slide_of(one, 2)
            label = with_unit(float(one.hold), "s", 2) if spring else None
            style = {"ls": STYLES[spring]["ls"], "color": colour, "label": label}
            band(ax, slide.slid, slide.trace_mu.values, slide.trace_mu_error.values, **style)
    ax.set(xscale="log", xlabel="distance since the hold (m)", ylabel="$\\mu$")
    ax.set_title(f"(d) the same, after holds; dotted: $k = {float(point.stiffness[0]):g}$ N/m")
    legend_in_room(ax, 0.25, loc="upper center", ncols=2)
