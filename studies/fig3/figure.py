"""Figure 3: steady friction over velocity, and friction over time with a jump at t = 10 tau."""

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.report import COLOURS, foot_line
from workflow.result import Groups

JUMP_AT = 10.0  # tau
END = 20.0
LINEAR = 0.9  # region I: local exponent of mu(v) above this
FLAT = 0.1  # region III: local exponent below this


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 2, figsize=(6.9, 3.0), layout="constrained")
    points = groups[""].squeeze()
    _steady(axes[0], points)
    _kinetics(axes[1], points)
    colours = plt.cm.ScalarMappable(
        mpl.colors.LogNorm(points.velocity.min(), points.velocity.max()), "viridis"
    )
    figure.colorbar(colours, ax=axes[1], label="velocity $v_1$ (m/s)")
    foot_line(figure, groups[""])
    return figure


def regions(points: xr.Dataset) -> tuple[float, float]:
    """Return the velocities that part regions I | II and II | III, from the local exponent."""
    log_v = np.log(points.velocity.values)
    exponent = np.gradient(np.log(points.mu_1.values), log_v)
    first = np.flatnonzero(exponent < LINEAR)
    last = np.flatnonzero(exponent < FLAT)
    velocity = points.velocity.values
    return velocity[first[0]] if first.size else np.inf, velocity[last[0]] if last.size else np.inf


def _steady(ax: Axes, points: xr.Dataset) -> None:
    ax.errorbar(points.velocity, points.mu_1, points.mu_1_error, fmt="o-", color=COLOURS[0])
    low, high = regions(points)
    ends = [float(points.velocity[0]), low, high, float(points.velocity[-1])]
    for number, name in enumerate(("I", "II", "III")):
        a, b = ends[number], ends[number + 1]
        if np.isfinite(b) and b > a:
            ax.axvspan(a, b, color="0.5", alpha=(0.04, 0.12, 0.04)[number], lw=0)
            middle = np.sqrt(a * b)
            ax.text(middle, 0.93, name, ha="center", transform=ax.get_xaxis_transform())
    line = points.mu_1.values[0] * points.velocity / points.velocity.values[0]
    ax.plot(points.velocity, line, "k--", lw=0.7, label="$\\mu \\propto v$")
    plateau = float(points.rms_slope.max())
    ax.axhline(plateau, color="0.4", lw=0.7, ls=":", label="rms slope $\\nabla z$")
    ax.set(xscale="log", yscale="log", xlabel="sliding velocity $v$ (m/s)")
    ax.set(ylabel="coefficient of friction $\\mu$", ylim=(None, 4.0 * plateau))
    ax.set_title("(a)", loc="left")
    ax.legend(loc="lower right")


def _kinetics(ax: Axes, points: xr.Dataset) -> None:
    colours = plt.get_cmap("viridis")(np.linspace(0.0, 1.0, points.sizes["velocity"]))
    for number, colour in enumerate(colours):
        point = points.isel(velocity=number)
        time = JUMP_AT + point.time.dropna("sample").values
        mu = point.mu.dropna("sample").values
        mu_1, mu_2 = float(point.mu_1), float(point.mu_2)
        ax.plot([0, JUMP_AT, *time, END], [mu_1, mu_1, *mu, mu_2], color=colour, lw=0.8)
    ax.set(xlim=(0, END), yscale="log", xlabel="time $t/\\tau$")
    ax.set_ylabel("coefficient of friction $\\mu$")
    ax.set_title("(b) $v_2 = 1.2\\,v_1$ at $t = 10\\,\\tau$", loc="left")
