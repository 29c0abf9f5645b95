"""Refinement of figure 7 in time: physical and numerical parts of its left branch."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import (
    CONVERGED,
    DOTS,
    MAX_LIGHTNESS,
    PAPER_STEP,
    SCHEMES,
    X_LABEL,
    fitted,
)
from elastomer_friction.workflow.kinetic_law import relaxation_rate
from elastomer_friction.workflow.report import error_bars, foot_line, value_label
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panels (a) and (b) show the relaxation rate b over the dimensionless velocity x with ever "
    "smaller time steps of both schemes, beside the limit to which they converge and eq. 13 of "
    "the paper. Panel (c) shows the share of the jump that relaxes."
)
SHARE_CURVES = {"": ("converged", CONVERGED), "euler_1": ("implicit Euler, $m = 1$", PAPER_STEP)}
FORCE = 0.1  # N; the nearest force of the study is shown
NOTE = (
    "Dotted in (a) is the rate at which implicit Euler lets a free element decay, "
    "ln(1 + Δt/τ)·τ/Δt with Δt = Δx/(m·v₂). Points without a fit have no marker; "
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    hursts = np.unique(groups[""].hurst.values[[0, -1]])
    figure, axes = plt.subplots(2, 3, figsize=(7.4, 5.2), sharex=True, sharey="col")
    for row, hurst in zip(axes, hursts, strict=False):
        shown = {
            name: fitted(data.sel(hurst=hurst).sel(normal_force=FORCE, method="nearest").squeeze())
            for name, data in groups.items()
        }
        _rates(row[0], shown, "euler", hurst)
        _rates(row[1], shown, "exponential", hurst)
        for name, (label, scheme) in SHARE_CURVES.items():
            if name in shown:
                one = shown[name].where(shown[name].relaxation_rate.notnull())
                share = abs(one.amplitude / one.jump)
                row[2].plot(one.speed_ratio, share, "-", label=label, **SCHEMES[scheme])
        row[2].set(xscale="log", yscale="log")
        row[0].set_ylabel(f"relaxation rate $b$, $H = {hurst:g}$")
    axes[0, 0].set_title("(a) implicit Euler; dotted: free")
    axes[0, 1].set_title("(b) exponential")
    axes[0, 2].set_title("(c) share that relaxes, $|\\mu^*| / \\Delta\\mu_0$")
    for ax in axes[1]:
        ax.set_xlabel(X_LABEL)
    axes[0, 0].legend(loc="upper left", ncols=2, columnspacing=0.6, handlelength=1.2)
    axes[0, 2].legend(loc="lower right")
    force = float(shown[""].normal_force)
    foot_line(figure, groups[""], f"{NOTE}{value_label('normal_force', force, 'N')}.")
    return figure


def decay_rate(data: xr.Dataset, steps: int) -> xr.DataArray:
    """Return the decay rate, per tau, of a free element at v2 with implicit Euler.

    A step of dt multiplies displacements by 1/(1 + dt) instead of exp(-dt).
    """
    dt = np.pi / (steps * data.speed_ratio * (1.0 + data.velocity_step))
    return np.log1p(dt) / dt


def _rates(ax: Axes, shown: dict[str, xr.Dataset], scheme: str, hurst: float) -> None:
    steps = sorted(int(name.rpartition("_")[2]) for name in shown if name.startswith(scheme))
    colours = plt.get_cmap("viridis")(np.linspace(MAX_LIGHTNESS, 0.1, len(steps)))
    for m, colour in zip(steps, colours, strict=True):
        one = shown[f"{scheme}_{m}"]
        style = DOTS | {"color": colour, "ms": 2.8, "mew": 1.0, "lw": 0.7, "label": f"$m = {m}$"}
        error_bars(ax, one, "relaxation_rate", "speed_ratio", **style)
        if scheme == "euler":
            slow = one.where(one.speed_ratio < 1.2, drop=True)
            ax.plot(slow.speed_ratio, decay_rate(slow, m), ":", color=colour, lw=1.0)
    limit = shown[""]
    ax.plot(limit.speed_ratio, limit.relaxation_rate, "k", lw=1.6, label="converged", zorder=5)
    x = np.geomspace(0.02, 50.0, 100)
    ax.plot(x, relaxation_rate(x, hurst), "--", color="0.5", lw=0.9)
    ax.annotate("eq. 13", (0.045, 0.026), fontsize=6.5, color="0.35")
    ax.set(xscale="log", yscale="log", ylim=(0.02, 40.0))
