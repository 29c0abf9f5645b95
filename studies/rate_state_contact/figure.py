"""a, a - b and D_c of the contact after a velocity step, without a fitted law.

The laws of rate and state: A. Ruina, J. Geophys. Res. 88, 10359 (1983), cited from memory.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.studies.style import TEMPERATURE_COLOURS
from elastomer_friction.workflow.report import foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The direct effect a (a), the evolution effect b (b), a − b (c) and the distance over which "
    "friction relaxes to 1/e after the direct effect (d), over the speed before a velocity step on "
    "a real contact with shear. None of them is fitted: they follow from moduli, topography and "
    "the shear stress."
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


def evolution_effect(points: xr.Dataset) -> OverSpeed:
    """Return b = (mu_1 + jump - mu_2)/ln r, which relaxes after the direct effect."""
    log_ratio = np.log(1.0 + float(points.velocity_step))
    start = points.isel(sample=0)
    return OverSpeed(start.deviation.values / log_ratio, start.deviation_error.values / log_ratio)


def steady_change(points: xr.Dataset) -> OverSpeed:
    """Return a - b = (mu_2 - mu_1)/ln r; its error contains the covariance on the same maps."""
    value, error = points.rate_state_a_minus_b, points.rate_state_a_minus_b_error
    return OverSpeed(value.values, error.values)


def critical_distance(points: xr.Dataset) -> OverSpeed:
    """Return D_c in mm: where 1/e of the change after the direct effect is left.

    Samples are interpolated. The error is at most that of the two deviations together, over the
    slope. NaN where the change is less than three standard errors, or does not fall to 1/e.
    """
    value, error = np.full((2, points.velocity.size), np.nan)
    for row in range(points.velocity.size):
        point = points.isel(velocity=row).dropna("sample", subset=["deviation"])
        left = (point.deviation / point.deviation[0]).values
        spread = (point.deviation_error / abs(point.deviation[0])).values
        slid = (1e3 * point.time_s * point.velocity * (1.0 + point.velocity_step)).values
        below = np.flatnonzero(left <= 1.0 / math.e)
        if MIN_CHANGE * spread[0] < 1.0 and below.size:
            k = below[0]
            step = (slid[k] - slid[k - 1]) / (left[k - 1] - left[k])
            value[row] = slid[k - 1] + (left[k - 1] - 1.0 / math.e) * step
            error[row] = (spread[k] + spread[0] / math.e) * step
    return OverSpeed(value, error)


MEASURES = (direct_effect, evolution_effect, steady_change, critical_distance)
TITLES = ("(a) direct effect $a$", "(b) evolution effect $b$", "(c) $a - b$", "(d) $D_c$ (mm)")


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""].squeeze(["spacing", "roughness", "velocity_step"])
    figure, axes = plt.subplots(2, 2, figsize=(7.4, 5.6), sharex=True)
    for force, colour in zip(data.normal_force.values, TEMPERATURE_COLOURS, strict=False):
        for hurst, line in zip(data.hurst.values, LINES, strict=False):
            points = data.sel(normal_force=force, hurst=hurst)
            label = f"{with_unit(float(points.normal_pressure), 'Pa')}, $H = {hurst:g}$"
            style: dict[str, Any] = {"color": colour, "ls": line, "lw": 0.8}
            bars = style | {"marker": "o", "ms": 2.4, "label": label}
            for ax, measure in zip(axes.flat, MEASURES, strict=True):
                ax.errorbar(points.velocity, *measure(points), **bars)
    for ax, title in zip(axes.flat, TITLES, strict=True):
        ax.set(xscale="log", title=title)
    for ax in axes[1]:
        ax.set_xlabel("speed before the step (m/s)")
    for ax in axes.flat[:3]:
        ax.axhline(0.0, color="0.7", lw=0.5)
    shortest = 1e3 / float(np.ravel(data.q_max)[0])
    axes[1, 1].axhline(shortest, color="0.4", lw=0.8, ls=":")
    axes[1, 1].set_ylim(bottom=0.0)
    axes[0, 0].legend(loc="best", fontsize=6)
    note = (
        "Dotted in (d) is 1/q_max. D_c is left out where less than three standard errors relax. "
        "Bars of D_c are upper bounds of its standard error."
    )
    foot_line(figure, groups[""], note)
    return figure
