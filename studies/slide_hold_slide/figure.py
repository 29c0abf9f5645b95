"""Slide, hold, slide: static peak of the friction over the duration of the hold.

The hold is at a fixed position, so that friction decays to zero in it; an experiment holds the
drive, and the machine's stiffness keeps some friction. To be read beside Dieterich's law of healing
(C. Marone, Annu. Rev. Earth Planet. Sci. 26, 643 (1998)), of which b and D_c are those of the
velocity step at the end of each run, by Ruina's law: nothing is fitted to the holds. Beside it S.
Hulikal, K. Bhattacharya, N. Lapusta, arXiv:1811.03811 (an array of viscoelastic elements: static
friction that goes on growing tells of many relaxation times), F. Landes, A. Rosso, E. Jagla,
arXiv:1503.07847 (slide-hold-slide of viscoelastic spring-blocks), and O. Ronsin, K. L.
Coeyrehourcq, "State, rate and temperature-dependent sliding friction of elastomers" (rubber on
glass, where deformation is negligible: kinetics, not magnitudes). The abstracts of Hulikal et al.
and of Ronsin and Coeyrehourcq were read, the others are cited from memory.
"""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import PALEST
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "A line slides, rests for a while and slides on, and panels (a) and (b) show by how much the "
    "static peak afterwards exceeds the friction before, over the duration of the rest and for two "
    "materials. Panel (c) shows which share of the friction is left at the end of the rest, and "
    "panel (d) how friction passes its peak over the distance slid."
)
KELVIN, RUBBER = "", "rubber"
TAU = 1e-3  # s, of the Kelvin element; the middle of the rubber's times
LONGEST = 0.1  # s, of the rubber
SHOWN = (0, 3, 4, 5, 6, 8)  # holds in panel (d)


def law(point: xr.Dataset, hold: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return b ln(1 + v t/D_c) after holds of t seconds, and its standard error.

    point : one velocity of a result, without axes of length 1. b and D_c are of Ruina's law at the
    velocity step, their errors taken as independent.
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
            label = f"$v = {float(point.velocity):g}$ m/s"
            error_bars(ax, point, "healing", "hold", fmt="o", color=colour, label=label)
            holds = point.hold.values
            hold = np.geomspace(holds[0], holds[-1], 100)
            if name == KELVIN:
                healed = -np.expm1(-hold / TAU) * float(point.healing[-1])
                ax.plot(hold, healed, "--", color=colour, lw=0.7)
            else:
                rise, error = law(point, hold)
                ax.plot(hold, rise, "-", color=colour, lw=0.7)
                ax.fill_between(hold, rise - error, rise + error, color=colour, alpha=0.2, lw=0)
            before = point.static_peak - point.healing
            share, error = (point[f"mu_end_of_hold{end}"] / before for end in ("", "_error"))
            form = "o-" if name == KELVIN else "s--"
            axes[1, 0].errorbar(point.hold, share, error, fmt=form, color=colour)
        ax.set(xscale="log", xlabel="duration of the hold $t_h$ (s)")
        ax.axvline(TAU if name == KELVIN else LONGEST, color="0.6", lw=0.7, ls=":")
        ax.axhline(0.0, color="0.7", lw=0.5)
        ax.legend(loc="upper left")
    axes[0, 0].set_title("(a) Kelvin element; dotted: $\\tau$")
    axes[0, 1].set_title("(b) nine branches; dotted: longest time")
    axes[0, 0].set_ylabel("static peak $-$ $\\mu$ before the hold")
    axes[1, 0].axhline(0.0, color="0.7", lw=0.5)
    axes[1, 0].set_title("(c) friction at the end of the hold")
    axes[1, 0].set(xscale="log", xlabel="duration of the hold $t_h$ (s)")
    axes[1, 0].set_ylabel("$\\mu\\,/\\,\\mu$ before the hold")
    _after(axes[1, 1], groups[RUBBER].squeeze().isel(velocity=0))
    foot_line(
        figure,
        groups[""],
        "(a) dashed: 1 - exp(-t_h/tau) to the last point. (b) bands: Dieterich's b ln(1 + v t_h/"
        "D_c), b and D_c from a velocity step, nothing fitted to the holds. (c) circles: Kelvin, "
        "squares: nine branches. The hold is at a fixed position; experiments hold the drive.",
    )
    return figure


def _after(ax: Axes, point: xr.Dataset) -> None:
    """Draw the friction over the distance slid after holds of different lengths."""
    colours = plt.get_cmap("viridis")(np.linspace(PALEST, 0.0, len(SHOWN)))
    for index, colour in zip(SHOWN, colours, strict=True):
        one = point.isel(hold=index)
        rest = one.isel(event=one.trace_segment.values == 1)
        slide = one.isel(event=one.trace_segment.values == 2)
        slid = slide.trace_distance - float(rest.trace_distance[-1])
        mu, error = slide.trace_mu.values, slide.trace_mu_error.values
        ax.plot(slid, mu, color=colour, label=f"{float(one.hold):.0e} s")
        ax.fill_between(slid, mu - error, mu + error, color=colour, alpha=0.2, lw=0)
    ax.axhline(float(point.mu_1[0]), color="0.4", lw=0.7, ls=":")
    ax.set(xscale="log", xlabel="distance since the hold (m)", ylabel="$\\mu$")
    ax.set_title(f"(d) nine branches, $v = {float(point.velocity):g}$ m/s, after holds")
    low, high = ax.get_ylim()
    ax.set_ylim(low, high + 0.25 * (high - low))  # room for the legend
    ax.legend(loc="upper center", ncols=3)
