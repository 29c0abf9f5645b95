"""Refinement of figure 7 in time: what of its left branch is physics, and what the time step."""

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.reduce import FITTED
from workflow.report import COLOURS, foot_line
from workflow.result import Groups

SCHEMES = {"euler": "implicit Euler", "exponential": "exponential"}
FORCE = 0.1  # N, the nearest is shown
ARTEFACT = (
    "Artefact: the left branch $b \\approx x$ is implicit Euler at $m = 1$, which decays by "
    "$1/(1 + \\Delta t/\\tau)$ per step: $b = \\ln(1 + \\Delta t/\\tau)\\,\\tau/\\Delta t$ "
    "(dotted), $\\Delta t = \\Delta x / m v_2$."
)
PHYSICS = (
    "Physics: $b = 1$ for $x < 1$, creep with $\\tau$; next to nothing is left to relax there (c). "
    "Above $x = 1$ all steps and both schemes meet in one curve."
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    hursts = groups[""].hurst.values[[0, -1]] if groups[""].hurst.size > 2 else groups[""].hurst
    figure, axes = plt.subplots(
        2, 3, figsize=(7.4, 5.4), sharex=True, layout="constrained", squeeze=False
    )
    for row, hurst in zip(axes, np.asarray(hursts), strict=False):
        for ax, scheme in zip(row, SCHEMES, strict=False):
            _rates(ax, groups, scheme, float(hurst))
        _amplitudes(row[2], groups, float(hurst))
        row[0].set_ylabel(f"relaxation rate $b$, $H = {hurst:g}$")
    for ax, title in zip(axes[0], ("(a) implicit Euler", "(b) exponential"), strict=False):
        ax.set_title(title, loc="left")
    axes[0, 2].set_title("(c) what is left to relax, $|\\mu^*| / \\Delta\\mu_0$", loc="left")
    for ax in axes[1]:
        ax.set_xlabel("$x = v_1 \\tau q_\\mathrm{max}$")
    axes[0, 0].legend(loc="lower right", ncols=2, columnspacing=0.6, handlelength=1.2)
    axes[0, 2].legend(loc="lower right")
    figure.suptitle(f"{ARTEFACT}\n{PHYSICS}", fontsize=7.5, x=0.01, ha="left")
    force = float(_at(groups[""], hursts[0]).normal_force)
    foot_line(
        figure,
        groups[""],
        f"shown: F_N = {force:g} N; missing markers: no fit, nothing relaxes there",
    )
    return figure


def _at(data: xr.Dataset, hurst: float) -> xr.Dataset:
    """Return one Hurst exponent at the force that is shown, over velocity alone."""
    chosen = data.sel(hurst=hurst).sel(normal_force=FORCE, method="nearest")
    return chosen.isel(spacing=0, roughness=0, velocity_step=0)


def decay_rate(data: xr.Dataset, steps: int) -> xr.DataArray:
    """Return the rate, per tau, at which implicit Euler lets a free element decay at v2.

    By 1/(1 + dt) a step of dt instead of exp(-dt): ln(1 + dt)/dt.
    """
    dt = np.pi / (steps * data.speed_ratio * (1.0 + data.velocity_step))
    return np.log1p(dt) / dt


def _steps(groups: Groups, scheme: str) -> list[int]:
    return sorted(int(name.rpartition("_")[2]) for name in groups if name.startswith(scheme))


def _rates(ax: Axes, groups: Groups, scheme: str, hurst: float) -> None:
    steps = _steps(groups, scheme)
    colours = mpl.colormaps["viridis"](np.linspace(0.9, 0.15, len(steps)))
    for m, colour in zip(steps, colours, strict=True):
        one = _at(groups[f"{scheme}_{m}"], hurst)
        rate = one.relaxation_rate.where(one.fit_status == FITTED)
        ax.errorbar(
            one.speed_ratio,
            rate,
            one.relaxation_rate_error,
            fmt="o",
            color=colour,
            ms=2.8,
            lw=0.7,
            capsize=0,
            label=f"$m = {m}$",
        )
        if scheme == "euler":
            slow = one.where(one.speed_ratio < 1.2, drop=True)
            ax.plot(slow.speed_ratio, decay_rate(slow, m), ":", color=colour, lw=1.0)
    one = _at(groups[""], hurst)
    ax.plot(
        one.speed_ratio,
        one.relaxation_rate.where(one.fit_status == FITTED),
        "k",
        lw=1.6,
        label="converged",
        zorder=5,
    )
    x = np.geomspace(0.02, 50.0, 100)
    ax.plot(x[x < 1], x[x < 1], "--", color="0.5", lw=0.9)
    ax.plot(x[x >= 1], x[x >= 1] ** (1.0 - hurst), "--", color="0.5", lw=0.9)
    ax.annotate("eq. 13", (0.045, 0.026), fontsize=6.5, color="0.35")
    ax.set(xscale="log", yscale="log", ylim=(0.02, 40.0))


def _amplitudes(ax: Axes, groups: Groups, hurst: float) -> None:
    shown = {"": ("converged", "k"), "euler_1": ("implicit Euler, $m = 1$", COLOURS[4])}
    for name, (label, colour) in shown.items():
        if name not in groups:
            continue
        one = _at(groups[name], hurst)
        share = (abs(one.amplitude) / abs(one.jump)).where(one.fit_status == FITTED)
        ax.plot(one.speed_ratio, share, "o-", color=colour, label=label)
    ax.set(xscale="log", yscale="log")
