"""Stick-slip of a line that is pulled through a spring, and the region of steady sliding.

Steady sliding is stable above the critical stiffness k_c = -(d mu/d ln v) F_N/D_c of rate and state
(J. R. Rice, A. L. Ruina, J. Appl. Mech. 50, 343 (1983), doi:10.1115/1.3167042). D_c is taken as the
distance v t_b slid in the relaxation time t_b of the rubber's only branch, or as the mean length of
contacts if this is shorter, because contacts are then renewed sooner.
"""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from elastomer_friction.studies.style import shades
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "A line slides steadily, and the drive that pulls it through a spring becomes a tenth "
    "quicker. Panel (a) shows the swing of the drive's force at the end, over velocity and "
    "stiffness, with the critical stiffness of rate and state, panel (b) steady friction, which "
    "falls above its peak, panel (c) the swing over the stiffness at some velocities, and panel "
    "(d) the mean force of the drive over time at one velocity, on springs of different stiffness."
)
BRANCH = 1e-4  # s, t_b: time of the branch
NAMES = ("drive_swing", "drive_swing_error")
SLIPPING = 0.05  # smallest swing over the rms slope that counts as stick-slip


def critical_stiffness(data: xr.Dataset) -> xr.DataArray:
    """Return k_c (N/m) over the velocity; NaN where friction rises."""
    one = data.isel(stiffness=0)
    falls = one.mu_1.copy(data=-np.gradient(one.mu_1.values, np.log(one.velocity.values)))
    contacts = one.samples_per_contact * one.spacing / one.steps_per_spacing
    critical = falls * one.normal_force / np.minimum(one.velocity * BRANCH, contacts)
    return critical.where(critical > 0.0)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""].squeeze()
    scale = float(np.ravel(data.rms_slope)[0])
    steady = data.mu_1.isel(stiffness=0)
    critical = critical_stiffness(data)
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.2))
    _diagram(axes[0, 0], data, scale, critical)
    axes[0, 1].errorbar(
        data.velocity, steady / scale, data.mu_1_error.isel(stiffness=0) / scale, fmt="o-"
    )
    axes[0, 1].set(xscale="log", xlabel="velocity $v$ (m/s)", ylabel=r"$\mu_1/\nabla z$")
    axes[0, 1].set_title("(b) steady friction")
    for index, colour in zip(range(1, data.sizes["velocity"], 2), COLOURS, strict=False):
        point = data.isel(velocity=index)
        scaled = point.assign({name: point[name] / scale for name in NAMES})
        label = f"$v = {float(point.velocity):.2g}$ m/s"
        error_bars(axes[1, 0], scaled, NAMES[0], "stiffness", fmt="o-", color=colour, label=label)
        if np.isfinite(critical[index]):
            axes[1, 0].axvline(float(critical[index]), color=colour, ls=":", lw=0.8)
    axes[1, 0].set(xscale="log", xlabel="stiffness $k$ (N/m)", ylabel=r"swing$/\nabla z$")
    axes[1, 0].set_title("(c) swing of $F_d/F_N$; dotted: $k_c$")
    axes[1, 0].legend()
    _forces(axes[1, 1], data, scale, critical)
    for ax in axes.flat[:3]:  # minor labels of a narrow logarithmic range would overlap
        ax.xaxis.set_minor_formatter(NullFormatter())
    foot_line(
        figure,
        groups[""],
        "k_c is -(d mu/d ln v) F_N over v t_b or the mean length of contacts. In (d) lines of one "
        "surface each slip at times of their own, so that the mean swings less than each does.",
    )
    return figure


def _diagram(ax: Axes, data: xr.Dataset, scale: float, critical: xr.DataArray) -> None:
    """Draw the points, those with stick-slip coloured by their swing."""
    swing = (data.drive_swing / scale).transpose("stiffness", "velocity")
    v, k = np.meshgrid(data.velocity, data.stiffness)
    slips = swing.values > SLIPPING
    colours = shades(0.0, float(swing.max()), log=False)
    ax.scatter(v[slips], k[slips], c=colours.to_rgba(swing.values[slips]), s=24, label="stick-slip")
    ax.plot(v[~slips], k[~slips], "x", ms=3.5, mew=0.8, color="0.5", label="steady")
    ax.plot(data.velocity, critical, "k-", lw=1.2, label="$k_c$")
    ax.set(xscale="log", yscale="log", xlabel="velocity $v$ (m/s)", ylabel="stiffness $k$ (N/m)")
    ax.set_ylim(0.7 * k.min(), 4.0 * k.max())  # room for the legend
    ax.set_title("(a) stick-slip and steady sliding")
    ax.legend(loc="upper left", ncols=3, columnspacing=0.8, handletextpad=0.3)
    ax.figure.colorbar(colours, ax=ax, label=r"swing$/\nabla z$")


def _forces(ax: Axes, data: xr.Dataset, scale: float, critical: xr.DataArray) -> None:
    """Draw the drive's force on some springs, at the velocity of the largest k_c."""
    at = int(np.nanargmax(critical.values)) if np.isfinite(critical).any() else 0
    point = data.isel(velocity=at)
    count = point.sizes["stiffness"]
    chosen = sorted({count // 3, count // 2, count - 1})
    for index, colour in zip(chosen, COLOURS, strict=False):
        one = point.isel(stiffness=index)
        force = one.trace_drive_force / one.normal_force / scale
        label = f"$k = {float(one.stiffness):.2g}$ N/m"
        ax.plot(1e3 * one.trace_time, force, color=colour, lw=0.9, label=label)
    ax.set(xlabel="time (ms)", ylabel=r"$F_d/(F_N \nabla z)$")
    ax.set_title(f"(d) force of the drive at $v = {float(point.velocity):.2g}$ m/s")
    low, high = ax.get_ylim()
    ax.set_ylim(low - 0.35 * (high - low), high)  # room for the legend
    ax.legend(loc="lower right")
