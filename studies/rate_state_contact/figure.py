"""a, a - b and D_c of the contact after a velocity step, without a fitted law.

The laws of rate and state: A. Ruina, J. Geophys. Res. 88, 10359 (1983), cited from memory.
"""

from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import TEMPERATURE_COLOURS
from elastomer_friction.workflow.report import foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The direct effect a (a) and the change of steady friction a − b (b), each per unit of the "
    "logarithm of the velocity ratio, and the distance over which friction relaxes to 1/e after "
    "the direct effect (c), over the speed before a velocity step on a real contact with shear. "
    "None of them is fitted: they follow from moduli, topography and the shear stress."
)
LINES = ("-", "--")  # for each Hurst exponent
MIN_CHANGE = 3.0  # standard errors of the change that relaxes, below which D_c is not given


class OverSpeed(NamedTuple):
    """Estimates over the speed, and their standard errors."""

    value: np.ndarray
    error: np.ndarray


def direct_effect(points: xr.Dataset) -> OverSpeed:
    """Return a = jump/ln r, over the speed."""
    log_ratio = np.log(1.0 + float(points.velocity_step))
    return OverSpeed(points.jump.values / log_ratio, points.jump_error.values / log_ratio)


def steady_change(points: xr.Dataset) -> OverSpeed:
    """Return a - b = (mu_2 - mu_1)/ln r, over the speed; errors as if both were independent."""
    log_ratio = np.log(1.0 + float(points.velocity_step))
    error = np.hypot(points.mu_1_error, points.mu_2_error).values
    return OverSpeed((points.mu_2 - points.mu_1).values / log_ratio, error / log_ratio)


def critical_distances(points: xr.Dataset) -> np.ndarray:
    """Return D_c in m over the speed: where 1/e of the change after the direct effect is left.

    It is NaN where this change is less than three standard errors, or does not fall to 1/e.
    """
    distances = []
    for row in range(points.velocity.size):
        point = points.isel(velocity=row).dropna("sample", subset=["mu"])
        left = np.abs(point.mu - point.mu_2).values
        slid = (point.time_s * point.velocity * (1.0 + point.velocity_step)).values
        known = left[0] > MIN_CHANGE * float(point.mu_error[0])
        below = np.flatnonzero(left <= left[0] / np.e)
        distances.append(slid[below[0]] if known and below.size else np.nan)
    return np.array(distances)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""].squeeze(["spacing", "roughness", "velocity_step"])
    figure, axes = plt.subplots(1, 3, figsize=(7.4, 3.0))
    for force, colour in zip(data.normal_force.values, TEMPERATURE_COLOURS, strict=False):
        for hurst, line in zip(data.hurst.values, LINES, strict=False):
            points = data.sel(normal_force=force, hurst=hurst)
            label = f"{with_unit(float(points.normal_pressure), 'Pa')}, $H = {hurst:g}$"
            style: dict[str, Any] = {"color": colour, "ls": line, "lw": 0.8}
            bars = style | {"marker": "o", "ms": 2.4}
            for ax, measure in zip(axes, (direct_effect, steady_change), strict=False):
                value, error = measure(points)
                ax.errorbar(points.velocity, value, error, **bars)
            axes[2].plot(points.velocity, critical_distances(points), label=label, **bars)
    titles = ("(a) direct effect $a$", "(b) $a - b$", "(c) $D_c$ (m)")
    for ax, title in zip(axes, titles, strict=True):
        ax.set(xscale="log", xlabel="speed (m/s)", title=title)
    for ax in axes[:2]:
        ax.axhline(0.0, color="0.7", lw=0.5)
    axes[2].set_yscale("log")
    axes[2].axhline(1.0 / float(np.ravel(data.q_max)[0]), color="0.4", lw=0.8, ls=":")
    axes[2].legend(loc="best", fontsize=6)
    note = (
        "Dotted in (c) is 1/q_max; D_c is in whole time steps and left out where less than three "
        "standard errors relax. Bars of a − b are those of independent ensembles, an upper bound."
    )
    foot_line(figure, groups[""], note)
    return figure
