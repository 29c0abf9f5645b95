"""Figure of a fitted material: moduli with their Prony series, and the shifts of sweeps."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...kernels import Arrhenius, ShiftTable, Wlf
from ..report import COLOURS, write_below
from ..study import Moduli
from .master import MasterCurve
from .prony_fit import PronyFit, in_oscillation, in_relaxation

LAWS = {Wlf: "WLF", Arrhenius: "Arrhenius", ShiftTable: "table"}
MEGA = 1e-6  # MPa per Pa
SWEEP_COLOURS = "coolwarm"  # from the coldest to the warmest sweep


def figure_of_moduli(measured: Moduli, fit: PronyFit, master: MasterCurve | None) -> Figure:
    """Return the figure of moduli at one temperature, their fit, and the shifts of the sweeps."""
    panels = 2 if master else 1
    figure, axes = plt.subplots(1, panels, figsize=(0.6 + 3.4 * panels, 3.0), squeeze=False)
    _moduli(axes[0, 0], measured, fit)
    if master:
        axes[0, 0].set_title("(a) moduli and fit")
        _shifts_of_sweeps(axes[0, 1], master)
    note = "Bars show one standard error of the shifts." if master else ""
    write_below(figure, f"Lines show the fit of {len(fit.branches)} branches.", note)
    return figure


def _moduli(ax: Axes, measured: Moduli, fit: PronyFit) -> None:
    """Draw G' and G'' over the frequency, or G(t) over the time, with the fit."""
    dense = np.geomspace(measured.omega.min(), measured.omega.max(), 400)
    moduli, times = np.array(fit.branches).T
    shares = in_relaxation if measured.over_time else in_oscillation
    series = fit.shear_modulus + shares(dense[:, None] * times)[0] @ moduli
    parts = [
        ("$G'$", measured.values.real, series.real),
        ("$G''$", measured.values.imag, series.imag),
    ]
    if measured.over_time:
        parts = [("$G(t)$", measured.values, series)]
    x, x_fit = (1.0 / w if measured.over_time else w for w in (measured.omega, dense))
    style: dict[str, Any] = {"s": 7.0, "lw": 0.0, "color": COLOURS[0]}
    if measured.temperatures is not None:
        style = {"s": 7.0, "lw": 0.0, "c": measured.temperatures, "cmap": SWEEP_COLOURS}
    for (name, values, fitted), marker, line in zip(parts, "o^", ("-", "--"), strict=False):
        points = ax.scatter(x, MEGA * values, marker=marker, **style)
        ax.plot(x_fit, MEGA * fitted, line, color="k", lw=0.9)
        ax.plot([], [], marker + line, color="0.3", label=f"{name} and fit")
    if measured.temperatures is not None:
        ax.figure.colorbar(points, ax=ax, label="temperature of the sweep (°C)")
    over = "time (s)" if measured.over_time else "frequency $\\omega$ (rad/s)"
    ax.set(xscale="log", yscale="log", xlabel=over, ylabel="modulus (MPa)")
    ax.legend(loc="best")


def _shifts_of_sweeps(ax: Axes, master: MasterCurve) -> None:
    """Draw the shifts over the temperature, with their errors and their law."""
    temperatures, shift, fit = master.temperatures, master.shift, master.fit
    span = np.linspace(temperatures[0], temperatures[-1], 200)
    ax.plot(span, [fit.law.decades(t) for t in span], "-", color="k", label=LAWS[type(fit.law)])
    drawn = [(fit.decades, shift.errors, "o", COLOURS[0], "$a_T$")]
    if shift.vertical.any():
        drawn.append((shift.vertical, shift.vertical_errors, "s", COLOURS[4], "$b_T$"))
    for values, errors, marker, colour, label in drawn:
        ax.errorbar(temperatures, values, errors, fmt=marker, color=colour, label=label)
    ax.set(xlabel="temperature (°C)", ylabel="$\\log_{10}$ of the shift")
    ax.set_title("(b) shifts")
    ax.legend(loc="best")
