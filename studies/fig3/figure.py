"""Figure 3: steady friction over velocity, and friction over time with a jump at t = 10 tau."""

from itertools import pairwise
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure

from elastomer_friction.studies.style import SCHEMES, VARIANTS, shades
from elastomer_friction.workflow.report import error_band, error_bars, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panel (a) shows the steady coefficient of friction over the sliding velocity, with the "
    "regions I, in which friction grows with the velocity, II and III, in which it has reached its "
    "plateau near the rms slope of the surface, converged in time and with one implicit Euler step "
    "per spacing Δx. Panel (b) shows friction over time, converged in time, for each of these "
    "velocities, over that before they all rise by the same share at the time 10 τ."
)
JUMP_AT = 10.0  # tau
END = 20.0  # tau
LINEAR = 0.9  # region I: local exponent of mu(v) above this
FLAT = 0.1  # region III: local exponent below this


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 3.0))
    points = groups[""].squeeze()
    _steady(axes[0], points, groups)
    colours = shades(float(points.velocity.min()), float(points.velocity.max()))
    _kinetics(axes[1], points, colours)
    figure.colorbar(colours, ax=axes[1], label="velocity $v_1$ (m/s)")
    foot_line(figure, groups[""], bars="bars and bands")
    return figure


def regions(points: xr.Dataset) -> list[float]:
    """Return the velocities between regions I and II and between II and III."""
    velocity = points.velocity.values
    exponent = np.gradient(np.log(points.mu_1.values), np.log(velocity))
    return [velocity[exponent < part].min(initial=np.inf) for part in (LINEAR, FLAT)]


def _steady(ax: Axes, points: xr.Dataset, groups: Groups) -> None:
    for group, label in VARIANTS.items():
        style = SCHEMES[group] | {"ls": "-", "ms": 2.4, "label": label}
        error_bars(ax, groups[group].squeeze(), "mu_1", "velocity", **style)
    velocity = points.velocity.values
    ends = [velocity[0], *regions(points), velocity[-1]]
    regimes = (("I", 0.04), ("II", 0.12), ("III", 0.04))
    for (a, b), (name, alpha) in zip(pairwise(ends), regimes, strict=True):
        if a < b < np.inf:
            ax.axvspan(a, b, color="0.5", alpha=alpha, lw=0)
            ax.text(np.sqrt(a * b), 0.93, name, ha="center", transform=ax.get_xaxis_transform())
    line = points.mu_1.values[0] * velocity / velocity[0]
    ax.plot(velocity, line, "k--", lw=0.7, label="$\\mu \\propto v$")
    plateau = float(points.rms_slope.max())
    ax.axhline(plateau, color="0.4", lw=0.7, ls=":", label="rms slope $\\nabla z$")
    ax.set(
        xscale="log", yscale="log", xlabel="sliding velocity $v$ (m/s)", title="(a) steady sliding"
    )
    ax.set(ylabel="coefficient of friction $\\mu$", ylim=(None, 4.0 * plateau))
    ax.legend(loc="lower right")


def _kinetics(ax: Axes, points: xr.Dataset, colours: ScalarMappable) -> None:
    for velocity in points.velocity.values:
        one = points.sel(velocity=velocity)
        over = one[["mu", "mu_2", "deviation_error"]] / one.mu_1
        curve = one.assign(over).dropna("sample", subset=["mu"])
        after = curve.assign_coords(time=JUMP_AT + curve.time)
        style: dict[str, Any] = {"color": colours.to_rgba(velocity), "lw": 0.8}
        error_band(ax, after, "mu", "deviation_error", **style)
        ax.plot([0.0, JUMP_AT, JUMP_AT], [1.0, 1.0, curve.mu[0]], **style)
        ax.plot([after.time[-1], END], [curve.mu[-1], curve.mu_2], **style)
    ax.set(xlim=(0, END), xlabel="time $t/\\tau$", ylabel="$\\mu/\\mu_1$")
    ratio = 1.0 + float(points.velocity_step)
    ax.set_title(f"(b) converged, $v_2 = {ratio:g}\\,v_1$ at $t = {JUMP_AT:g}\\,\\tau$")
