"""Parameters a, b and D_c of velocity steps, and where rate-and-state laws describe them.

Compare O. Ronsin and K. L. Coeyrehourcq, "State, rate and temperature-dependent sliding friction
of elastomers", Proc. R. Soc. A (2001), on a rough elastomer on rough glass. Its friction was due to
interfacial shear, so compare kinetics, not magnitudes (abstract read only). S. Hulikal,
K. Bhattacharya and N. Lapusta, arXiv:1405.3643 and arXiv:1811.03811, compare arrays of viscoelastic
elements with the same laws and need many relaxation times for a wide range of times (abstracts
read only). Steps that follow Ruina's law together with holds that follow Dieterich's are reported
for rocks (from memory); the study slide_hold_slide treats holds. Li et al. (2014) remark that D_c
is about 1/q_max, and fit no a, b and D_c.
"""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from elastomer_friction.workflow.reduce import FITTED, NO_STATE
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line, value_label
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "The parameters a, b and D_c of the rate-and-state law of friction are fitted to computed "
    "velocity steps of two materials, and shown over the ratio of the velocities and over the "
    "dimensionless velocity. Panels (e) and (f) show how the critical distance D_c depends on the "
    "normal force and on the shortest wave of the surface."
)
BROAD, KELVIN = "", "kelvin"
MIDDLE_TIME = 1e-3  # s, tau of the Kelvin element, and middle relaxation time of the rubber
RATIO_LABEL = "$v_2/v_1$"
X_LABEL = "$x = v_2 \\, t \\, q_\\mathrm{max}$"
PANELS = (  # title, x label, y label, scale of y
    ("(a) direct effect $a$", RATIO_LABEL, "$a/\\nabla z$", "log"),
    ("(b) evolution effect $b$", RATIO_LABEL, "$b/\\nabla z$", "linear"),
    ("(c) $a - b$", X_LABEL, "$(a-b)/\\nabla z$", "linear"),
    ("(d) critical distance $D_c$", X_LABEL, "$D_c \\, q_\\mathrm{max}$", "log"),
    ("(e) rubber: $D_c$ over the load", "$F_N$ (N)", "$D_c$ (m)", "log"),
    ("(f) rubber: $D_c$ over $q_\\mathrm{max}$", "$q_\\mathrm{max}$ (1/m)", "$D_c$ (m)", "log"),
)
STYLES: dict[str, dict[str, Any]] = {
    BROAD: {"fmt": "o-", "ms": 3.2, "lw": 0.6},
    KELVIN: {"fmt": "s--", "ms": 3.2, "lw": 0.6},
}
PARAMETERS = ("rate_state_a", "rate_state_b", "rate_state_a_minus_b", "rate_state_dc")


def points(data: xr.Dataset) -> xr.Dataset:
    """Return the points over force, spacing, velocity, step and law, with derived variables.

    a, b and a - b are divided by the rms slope, D_c is NaN unless the law was fitted, ``ratio`` is
    v2/v1, ``x`` is v2 MIDDLE_TIME q_max, ``q_max`` is in 1/m and ``distance`` is D_c q_max.
    """
    one = data.isel(hurst=0, roughness=0)
    fitted = one.rate_state_status == FITTED
    scaled = {}
    for name in PARAMETERS:
        divisor = 1.0 if name == "rate_state_dc" else one.rms_slope
        known = fitted if name == "rate_state_dc" else True
        for variable in (name, f"{name}_error"):
            scaled[variable] = (one[variable] / divisor).where(known)
    scaled_points = one.assign(scaled)
    ratio = 1.0 + scaled_points.velocity_step
    q_max = np.pi / scaled_points.spacing
    for variable in ("", "_error"):
        scaled_points[f"distance{variable}"] = scaled_points[f"rate_state_dc{variable}"] * q_max
    return scaled_points.assign(
        ratio=ratio, q_max=q_max, x=scaled_points.velocity * ratio * MIDDLE_TIME * q_max
    )


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 3, figsize=(7.6, 5.2))
    shown = {name: points(data) for name, data in groups.items()}
    middle = {name: _middle(data).isel(spacing=0) for name, data in shown.items()}
    for name, data in middle.items():
        _by_velocity(axes[0, 0], data, name, "rate_state_a", "ratio", log=True)
        _by_velocity(axes[0, 1], data, name, "rate_state_b", "ratio")
        _by_velocity(axes[0, 2], data, name, "rate_state_a_minus_b", "x")
        _by_velocity(axes[1, 0], data, name, "distance", "x", log=True)
    for velocity, colour in zip(middle[BROAD].velocity.values, COLOURS, strict=False):
        line = middle[BROAD].sel(velocity=velocity, law="dieterich")
        style: dict[str, Any] = {"fmt": "x:", "ms": 3.2, "lw": 0.6, "color": colour}
        error_bars(axes[1, 0], line, "distance", "x", log=True, **style)
    broad = shown[BROAD].sel(law="ruina")
    fastest = broad.isel(velocity=-1, spacing=0)
    _by_step(axes[1, 1], fastest, "normal_force")
    _by_step(axes[1, 2], _middle(broad).isel(velocity=-1), "q_max")
    _dress(axes, broad)
    for velocity, colour in zip(middle[BROAD].velocity.values, COLOURS, strict=False):
        axes[0, 0].plot([], [], "-", color=colour, label=value_label("velocity", velocity, "m/s"))
    axes[0, 0].legend(loc="lower right", fontsize=6)
    axes[0, 1].plot([], [], "ko-", ms=3.2, lw=0.6, label="nine branches")
    axes[0, 1].plot([], [], "ks--", ms=3.2, lw=0.6, label="Kelvin")
    for ax in (axes[0, 1], axes[1, 1]):
        ax.legend(loc="upper left")
    axes[1, 2].legend(handles=[axes[1, 2].lines[-1]], loc="lower left")
    note = (
        "The law is Ruina's; crosses in (d) are Dieterich's for the rubber. Panels (a) to (d) are "
        "of the middle load and the finest spacing, (e) and (f) of the fastest v₁, and t is 1 ms. "
        "Pluses are steps that were not fitted. "
    )
    foot_line(figure, groups[BROAD], note + " ".join(left_out(groups)))
    return figure


def _middle(data: xr.Dataset) -> xr.Dataset:
    """Return the points at the middle load."""
    return data.isel(normal_force=data.sizes["normal_force"] // 2)


def _by_velocity(
    ax: Axes, data: xr.Dataset, name: str, variable: str, over: str, log: bool = False
) -> None:
    """Draw a variable of Ruina's law, with a colour for every velocity v1; pluses are NaN."""
    for i, velocity in enumerate(data.velocity.values):
        line = data.sel(velocity=velocity, law="ruina")
        error_bars(ax, line, variable, over, log=log, color=COLOURS[i], **STYLES[name])
        left = line[over].values[np.isnan(line[variable].values)]
        low = np.full(left.size, 0.02)  # in heights of the panel
        ax.plot(left, low, "+", ms=5, color=COLOURS[i], transform=ax.get_xaxis_transform())


def _by_step(ax: Axes, data: xr.Dataset, over: str) -> None:
    """Draw D_c over a variable, with a colour for every velocity step."""
    for i, step in enumerate(data.velocity_step.values):
        line = data.sel(velocity_step=step)
        label = f"$v_2/v_1 = {float(line.ratio):g}$"
        style = STYLES[BROAD] | {"color": COLOURS[3 + i % 4], "label": label}
        error_bars(ax, line, "rate_state_dc", over, log=True, **style)


def _dress(axes: np.ndarray, broad: xr.Dataset) -> None:
    """Set scales, labels and reference lines."""
    for ax, (title, x_label, y_label, scale) in zip(axes.flat, PANELS, strict=True):
        ax.set(xscale="log", yscale=scale, xlabel=x_label, ylabel=y_label, title=title)
    a, b, weakening, length, load, cutoff = axes.flat
    a.set_ylim(3e-3, 1.0)
    load.set_ylim(1e-5, 1e-3)
    cutoff.set(xlim=(1e4, 1e5), ylim=(1e-5, 1e-3))
    for ax in (a, b):
        ax.set_xticks(np.unique(broad.ratio))
        ax.xaxis.set_major_formatter("{x:.3g}")
        ax.xaxis.set_minor_formatter(NullFormatter())
    for ax in (b, weakening):
        ax.axhline(0.0, color="0.5", lw=0.6)
    x = np.array([0.3, 3.0])
    length.plot(x, x, "-", color="0.6", lw=0.8, label="a time, $D_c = v_2 t$")
    length.legend(loc="center left")
    q_max = np.sort(broad.q_max.values)
    cutoff.xaxis.set_minor_formatter(NullFormatter())
    cutoff.plot(q_max, 1.0 / q_max, "-", color="0.6", lw=0.8, label="$1/q_\\mathrm{max}$")


def left_out(groups: Groups) -> list[str]:
    """Return sentences with the numbers of failed fits of Ruina's law, one per material."""
    sentences = []
    for name, data in groups.items():
        status = data.rate_state_status.sel(law="ruina").values
        none, others = int((status == NO_STATE).sum()), int((status != FITTED).sum())
        label = "Nine branches" if name == BROAD else "Kelvin"
        sentences.append(
            f"{label}: {others} of {status.size} steps are not fitted by Ruina's law, {none} of "
            "them because |b| is below three standard errors."
        )
    return sentences
