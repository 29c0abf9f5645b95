"""Three rheologies: moduli, friction over nine decades of speed, temperature, and a step."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.kernels.rheology.spectrum import Spectrum, complex_modulus
from elastomer_friction.studies.master_curve.collapse import UNSHIFTED, Collapse, Curve, collapse
from elastomer_friction.studies.style import TEMPERATURE_COLOURS, slide_of
from elastomer_friction.workflow.report import (
    COLOURS,
    band,
    error_bars,
    foot_line,
    legend_in_room,
    with_unit,
)
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Material, Study, read_study

CAPTION = (
    "Three materials, a Kelvin element, a standard linear solid and a rubber of many branches, are "
    "compared by their moduli, their steady friction and the share of the line that is in contact. "
    "The lower panels show friction of the rubber at several temperatures, as computed and after "
    "the shift of its relaxation times, and the friction of all three after a velocity step."
)
RUBBER, KELVIN, STANDARD = "", "kelvin", "standard"
LABELS = {
    KELVIN: ("Kelvin element", COLOURS[1], "s"),
    STANDARD: ("standard linear solid", COLOURS[2], "^"),
    RUBBER: ("SBR, 13 branches", COLOURS[0], "o"),
}
POINTS: dict[str, Any] = {"ms": 2.4, "lw": 0.7}
NOTE = (
    "Deformation alone is simulated: no adhesion, so no adhesion peak, and no heating. Panel (f) "
    "is at the speed of each with the largest friction in (b); its bands are standard errors of "
    "µ, most of them common to a whole curve, and its triangles the steady values at 2 v₁."
)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    known = {name: groups[name].squeeze() for name in LABELS if name in groups}
    study = read_study("rheology")
    assert isinstance(study, Study)
    materials = study.materials
    figure, axes = plt.subplots(2, 3, figsize=(7.4, 4.9))
    _moduli(axes[0, 0], {name: materials[name].at_reference for name in known})
    slope = float(known[RUBBER].rms_slope.max())
    _over_speed(axes[0, 1], known, "mu_1", (1e-5, 3.0 * slope))
    axes[0, 1].axhline(slope, color="0.4", lw=0.7, ls=":")
    axes[0, 1].text(1e-8, 1.1 * slope, "rms slope", fontsize=6.5)
    axes[0, 1].set(title="(b) steady at 20 °C", ylabel="coefficient of friction $\\mu$")
    _over_speed(axes[0, 2], known, "contact_fraction", (1e-4, 1.5))
    axes[0, 2].set(title="(c) share in contact at 20 °C", ylabel="share of the line in contact")
    axes[0, 2].legend(loc="lower left", fontsize=6.5)
    for temperature, colour in zip(
        known[RUBBER].temperature.values, TEMPERATURE_COLOURS, strict=False
    ):
        one = known[RUBBER].sel(temperature=temperature)
        style = POINTS | {"fmt": "o-", "color": colour, "label": with_unit(temperature, "°C")}
        error_bars(axes[1, 0], one, "mu_1", "velocity", **style)
    axes[1, 0].set(xscale="log", xlabel="speed $v$ (m/s)", ylabel="coefficient of friction $\\mu$")
    axes[1, 0].set(title="(d) SBR at several temperatures", ylim=(0.0, None))
    axes[1, 0].legend(loc="upper left")
    _master(axes[1, 1], known[RUBBER], materials[RUBBER])
    _step(axes[1, 2], known)
    foot_line(figure, groups[RUBBER], NOTE, bars="bars and bands")
    return figure


def warmest(data: xr.Dataset) -> xr.Dataset:
    """Return the points at the highest temperature, at which relaxation times are given."""
    return data.sel(temperature=data.temperature.max())


def master(data: xr.Dataset, material: Material) -> tuple[Collapse, list[Curve]]:
    """Return the collapse of mu(a_T v) at all temperatures onto one curve, and the curves.

    The shift is that of the material, without a fit; the reference is the highest temperature.
    """
    curves = [_curve(data, t, material.shift(float(t))) for t in data.temperature.values]
    reference = curves[int(np.argmax(data.temperature.values))]
    return collapse(curves, reference, UNSHIFTED), curves


def _moduli(ax: Axes, materials: dict[str, Material]) -> None:
    for name, material in materials.items():
        label, colour, _ = LABELS[name]
        spectrum: Spectrum = material.spectrum()
        omega = np.geomspace(1e-4, 1e12, 300)
        modulus = material.shear_modulus * np.array(
            [complex_modulus(spectrum, w * material.tau) for w in omega]
        )
        ax.plot(omega, modulus.real / 1e6, color=colour, label=label)
        ax.plot(omega, modulus.imag / 1e6, "--", color=colour)
    ax.set(xscale="log", yscale="log", ylim=(1e-3, 3e3), title="(a) moduli at 20 °C")
    ax.set(xlabel="frequency $\\omega$ (rad/s)", ylabel="$G'$ (full), $G''$ (dashed) (MPa)")


def _over_speed(
    ax: Axes, known: dict[str, xr.Dataset], variable: str, limits: tuple[float, float]
) -> None:
    for name, data in known.items():
        label, colour, marker = LABELS[name]
        style = POINTS | {"fmt": f"{marker}-", "color": colour, "label": label}
        error_bars(ax, warmest(data), variable, "velocity", log=True, **style)
    ax.set(xscale="log", yscale="log", ylim=limits, xlabel="speed $v$ (m/s)")


def _master(ax: Axes, data: xr.Dataset, material: Material) -> None:
    shifted, curves = master(data, material)
    for curve, colour in zip(curves, TEMPERATURE_COLOURS, strict=False):
        mu = 10.0**curve.y
        bars = mu * curve.error * np.log(10.0)
        ax.errorbar(10.0**curve.x, mu, bars, fmt="o", color=colour, **POINTS)
    before = collapse([_curve(data, t) for t in data.temperature.values], curves[-1], UNSHIFTED)
    ax.text(
        0.03,
        0.97,
        "rms difference in the overlap:\n"
        f"{_percent(shifted.rms)}, unshifted {_percent(before.rms)}\n"
        f"({shifted.left_out} of {sum(c.x.size for c in curves)} points beyond it)",
        transform=ax.transAxes,
        va="top",
        fontsize=6.5,
    )
    ax.set(xscale="log", xlabel="shifted speed $a_T v$ (m/s)", ylim=(0.0, None))
    ax.set(ylabel="coefficient of friction $\\mu$", title="(e) SBR, times shifted by $a_T$ (WLF)")


def _curve(data: xr.Dataset, temperature: float, shift: float = 1.0) -> Curve:
    """Return friction at a temperature over ``shift`` times the speed."""
    one = data.sel(temperature=temperature)
    error = (one.mu_1_error / one.mu_1).values / np.log(10.0)
    return Curve(np.log10(shift * one.velocity.values), np.log10(one.mu_1.values), error)


def _percent(decades: float) -> str:
    """Return a difference of log10 mu as a percentage of mu."""
    percent = 100.0 * (10.0**decades - 1.0)
    return f"{percent:.2g} %" if percent < 10.0 else f"{percent:.0f} %"


def _step(ax: Axes, known: dict[str, xr.Dataset]) -> None:
    for name, data in known.items():
        label, colour, _ = LABELS[name]
        warm = warmest(data)
        point = warm.isel(velocity=int(np.argmax(warm.mu_1.values)))  # with the largest friction
        slide = slide_of(point, 1)
        mu, error = slide.trace_mu.values, slide.trace_mu_error.values
        one, two = float(point.mu_1), float(point.mu_2)
        text = f"{label}, {with_unit(float(point.velocity), 'm/s')}"
        band(ax, slide.slid, mu / one, error / one, color=colour, label=text)
        ax.plot(slide.slid[-1] * 1.3, two / one, "<", color=colour, ms=4.0, clip_on=False)
    ax.set(xscale="log", xlabel="slip since the step (m)", ylabel="$\\mu/\\mu_1$")
    ax.set(title="(f) after a step to $2 v_1$")
    legend_in_room(ax, 0.35, loc="upper right", fontsize=6.5)
