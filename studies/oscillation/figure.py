"""Oscillation about rest: loops of friction, and the response to small amplitudes and G*(omega).

Temperature shifts all times by a_T, so that one frequency covers five decades, as in dynamic
mechanical analysis. Compare oscillating and reversing slides on rubber: "Memory effects in
friction: the role of sliding heterogeneities" (silicone on glass, abstract read) and T. Baumberger,
"Transient processes in soft tribology". There contacts creep and stick. Here only deformation gives
friction, so loops over velocity pass through the origin if the rubber relaxes at once.

The line moves by X, and an element in contact by z' X, so the force along the line is
F = 4 L <z'^2> (G* - G) X, where <z'^2> is the mean over the line of the squared slope in contact.
The relaxed modulus G gives no friction. The mean indentation does not change, as the mean slope
over a contact is zero. Height and slope of a Gaussian line are independent at a point, so <z'^2> is
the contact fraction times the squared rms slope, and nothing is fitted. (Within a line they are not
quite independent: with a quarter in contact this <z'^2> is 4 % too large, with a half less than
1 %, by 600 lines of this study each.)
"""

from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from elastomer_friction.studies.style import TEMPERATURE_COLOURS, computed_study, shift_factors
from elastomer_friction.workflow.report import COLOURS, band, foot_line, legend_in_room, log_bars
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import HoldSegment, Oscillate

CAPTION = (
    "A line oscillates about a place of rest, and friction is shown over the velocity in loops, "
    "(a) for a small amplitude and (c, d) for a large one at several temperatures. Panel (b) "
    "shows the response to the small amplitude over the frequency, beside the complex modulus of "
    "the rubber."
)
LABELS = {"": "Kelvin element", "rubber": "nine branches"}
REFERENCE = 20.0  # °C
LOOP_TEMPERATURES = (20.0, 35.0, 50.0)  # °C, of the large loops


class Swing(NamedTuple):
    """An oscillation of the programme of a study."""

    segment: int  # number of the segment
    amplitude: float  # m
    frequency: float  # Hz
    end: float  # s since the start of the programme


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.4))
    for (name, label), colour in zip(LABELS.items(), COLOURS, strict=False):
        data = groups[name].squeeze()
        at = data.sel(temperature=REFERENCE)
        omega = np.array(2.0 * np.pi * motions(data)[-1].frequency)
        scale = float(unit(data)[0] * abs(modulus(data, name, omega)))
        _loop(axes[0, 0], at, motions(data)[-1], scale, colour, label)
        _response(axes[0, 1], data, name, colour, label)
    for ax, (name, label), letter in zip(axes[1], LABELS.items(), "cd", strict=True):
        data = groups[name].squeeze()
        for temperature, colour in zip(LOOP_TEMPERATURES, TEMPERATURE_COLOURS, strict=True):
            at = data.sel(temperature=temperature)
            factor = float(shift_factors(data)[list(data.temperature.values).index(temperature)])
            text = f"{temperature:g} °C, $a_T = {factor:.2g}$"
            _loop(ax, at, motions(data)[0], float(at.rms_slope), colour, text)
        ax.set_title(f"({letter}) {label}, amplitude {1e3 * motions(data)[0].amplitude:g} mm")
        ax.set(xlabel="velocity over its amplitude", ylabel="$\\mu\\,/\\,\\nabla z$")
        legend_in_room(ax, 0.45)
    axes[0, 0].set_title(f"(a) amplitude {1e9 * motions(data)[-1].amplitude:g} nm, 20 °C")
    axes[0, 0].set(xlabel="velocity over its amplitude", ylabel="$\\mu$ over that of $G^* - G$")
    legend_in_room(axes[0, 0], 0.3)
    axes[0, 1].set_title("(b) small response; lines: $G^*/G - 1$")
    note = (
        "Nothing is fitted. In (b) circles are the part of µ in phase with the velocity, and "
        "triangles that in phase with the displacement, which is zero for a Kelvin element. In (d) "
        "the rubber at 20 °C has not forgotten where the line stood before, which it passes at its "
        "largest velocity."
    )
    foot_line(figure, groups[""], note, bars="bars and bands")
    return figure


def _loop(ax: Axes, data: xr.Dataset, motion: Swing, scale: float, colour: str, label: str) -> None:
    """Draw the last cycle of an oscillation over the velocity, with its band."""
    inside = data.isel(event=data.trace_segment.values == motion.segment)
    cycles = (inside.trace_time.values - motion.end) * motion.frequency
    inside, cycles = inside.isel(event=cycles > -1.005), cycles[cycles > -1.005]
    speed = np.cos(2.0 * np.pi * cycles)
    mu, error = inside.trace_mu.values / scale, inside.trace_mu_error.values / scale
    turn = int(np.argmin(speed))
    for part, text in ((slice(turn + 1), label), (slice(turn, None), None)):
        band(ax, speed[part], mu[part], error[part], color=colour, label=text)
    ax.axhline(0.0, color="0.7", lw=0.5)
    ax.axvline(0.0, color="0.7", lw=0.5)


def _response(ax: Axes, data: xr.Dataset, name: str, colour: str, label: str) -> None:
    """Draw both parts of the response to the small amplitude over the shifted frequency."""
    omega = 2.0 * np.pi * motions(data)[-1].frequency * shift_factors(data)
    fine = np.geomspace(omega.min() / 2.0, omega.max() * 2.0, 200)
    lines = modulus(data, name, fine)
    parts = (
        ("mu_quadrature", lines.imag, "o", "-", f"{label}, $G''/G$"),
        ("mu_in_phase", lines.real, "^", "--", f"{label}, $G'/G - 1$"),
    )
    for variable, line, marker, dashes, text in parts:
        if not line.any():
            continue
        value, error = (data[f"{variable}{end}"].values / unit(data) for end in ("", "_error"))
        style: dict[str, Any] = {"fmt": marker, "color": colour, "label": text}
        ax.errorbar(omega, value, log_bars(value, error), **style)
        ax.plot(fine, line, dashes, color=colour, lw=0.8)
    ax.set(xscale="log", yscale="log", xlabel="$\\omega a_T$ (rad/s)")
    ax.set_ylabel("response in units of $G$")
    ax.legend(loc="upper left")


def motions(data: xr.Dataset) -> list[Swing]:
    """Return the oscillations in the programme of a result; other segments are holds."""
    swings: list[Swing] = []
    time = 0.0
    for number, segment in enumerate(computed_study(data).scene.programme):
        if isinstance(segment, HoldSegment):
            time += segment.durations[0]
        elif isinstance(segment, Oscillate):
            time += segment.cycles / segment.frequency
            swings.append(Swing(number, segment.amplitude, segment.frequency, time))
    return swings


def modulus(data: xr.Dataset, name: str, omega: np.ndarray) -> np.ndarray:
    """Return G*/G - 1 of a variant at angular frequencies (rad/s) and the reference temperature."""
    material = computed_study(data).materials[name].at_reference
    return complex_modulus(material.spectrum(), omega * material.tau) - 1.0


def unit(data: xr.Dataset) -> np.ndarray:
    """Return the amplitude of friction if |G* - G| were G, shape (temperatures,)."""
    amplitude = motions(data)[-1].amplitude
    stiffness = 4.0 * float(data.shear_modulus * data.length)
    contact = data.trace_contact_fraction.isel(event=0)
    unit = stiffness * amplitude / data.normal_force * data.rms_slope**2 * contact
    return np.asarray(unit.values)
