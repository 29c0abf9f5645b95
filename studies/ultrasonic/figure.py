"""Mean friction of a line that slides with a superposed oscillation, and Coulomb's law.

With one coefficient of friction mu, whose sign is that of the velocity v + v^ cos(omega t), the
mean is (2/pi) asin(v/v^) mu for v < v^, and else mu (V. L. Popov, Contact Mechanics and Friction,
Springer 2010, cited from memory). Here mu depends on the velocity. For a slow oscillation
the mean is that of steady friction over the velocities of a cycle, taken without a fit from the
same lines at other temperatures. If the amplitude of the displacement is small compared with the
shortest wave, contacts are not renewed within a cycle and the mean friction does not change.
"""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from elastomer_friction.studies.style import computed_study, shift_factors
from elastomer_friction.workflow.report import COLOURS, foot_line
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "A line slides with an oscillation along its path. Panel (a) shows steady "
    "friction over the velocity, panel (b) how a slow oscillation lowers the mean friction of a "
    "rubber at three points of (a), over the amplitude of the velocity, panel (c) the same at "
    "one of them for several frequencies, and panel (d) that of a Kelvin element."
)
LABELS = {"": "Kelvin element", "rubber": "nine branches"}
PLACES = {"": (5.3, 20.0, 59.9), "rubber": (5.3, 32.9, 49.6)}  # °C, in panels (b) and (d)
TOP = 32.9  # °C, of the largest friction of the rubber


def coulomb(ratio: np.ndarray) -> np.ndarray:
    """Return the mean friction over mu for Coulomb's law. ratio : v^/v."""
    return 2.0 / np.pi * np.arcsin(1.0 / np.maximum(ratio, 1.0))


def fastness(data: xr.Dataset) -> np.ndarray:
    """Return a_T v tau q_max at the temperatures of a result; tau is that at the reference."""
    tau = computed_study(data).material.at_reference.tau
    return shift_factors(data) * float(data.velocity * data.q_max) * tau


def quasi_steady(data: xr.Dataset, temperature: float, ratio: np.ndarray) -> np.ndarray:
    """Return the mean of steady friction at v + v^ cos, over that at v.

    Steady friction over velocity follows from that over temperature. It is linear in logarithms
    between the temperatures, and proportional to the velocity below them. ratio : v^/v.
    """
    shift, mu = fastness(data), data.mu_1.isel(velocity_amplitude=0, frequency=0).values
    here = list(data.temperature.values).index(temperature)
    order = np.argsort(shift)
    x, log_mu = shift[order], np.log(mu[order])
    angle = 2.0 * np.pi * (np.arange(4000) + 0.5) / 4000
    along = shift[here] * (1.0 + ratio[:, None] * np.cos(angle))
    low = np.minimum(np.abs(along) / x[0], 1.0)
    steady = low * np.exp(np.interp(np.log(np.abs(along)), np.log(x), log_mu))
    return np.mean(np.sign(along) * steady, axis=1) / mu[here]


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(6.9, 5.4))
    shown = {name: groups[name].squeeze() for name in LABELS}
    for (name, data), marker in zip(shown.items(), "so", strict=True):
        mu, error = (
            (data[f"mu_1{end}"] / data.rms_slope).isel(velocity_amplitude=0, frequency=0)
            for end in ("", "_error")
        )
        x = fastness(data)
        style: dict[str, Any] = {"ms": 3, "lw": 0.7, "color": "0.4", "label": LABELS[name]}
        axes[0, 0].errorbar(x, mu, error, fmt=f"{marker}-", **style)
        for place, colour in zip(PLACES[name], COLOURS, strict=False):
            at = list(data.temperature.values).index(place)
            axes[0, 0].plot(x[at], mu[at], marker, ms=6, color=colour)
    axes[0, 0].set(xscale="log", xlabel="$a_T\\, v \\tau q_\\mathrm{max}$")
    axes[0, 0].set_ylabel("$\\mu_1/\\nabla z$")
    axes[0, 0].set_title("(a) steady friction; coloured: of (b) and (d)")
    axes[0, 0].legend(loc="upper left")
    slowest = float(data.frequency[0])
    for ax, name in ((axes[0, 1], "rubber"), (axes[1, 1], "")):
        for place, colour in zip(PLACES[name], COLOURS, strict=False):
            _share(ax, shown[name], place, slowest, colour, f"{place:g} °C")
    data = shown["rubber"]
    colours = plt.get_cmap("viridis")(np.linspace(0.0, 0.8, data.sizes["frequency"]))
    for frequency, colour in zip(data.frequency.values, colours, strict=True):
        _share(axes[1, 0], data, TOP, float(frequency), colour, f"{frequency:g} Hz")
    titles = (
        f"(b) nine branches, {slowest:g} Hz",
        f"(c) nine branches, {TOP:g} °C",
        f"(d) Kelvin element, {slowest:g} Hz",
    )
    for ax, title in zip(axes.flat[1:], titles, strict=True):
        _dress(ax, data)
        ax.set_title(title)
    foot_line(
        figure,
        groups[""],
        "Black: Coulomb's law, one coefficient of friction. Dashed: mean of steady friction over "
        "the velocities of a cycle, from (a); nothing is fitted. (c): amplitudes "
        "of the displacement times q_max, where that of the velocity is v: "
        + ", ".join(f"{_displacement_amplitude(data, f):.2g}" for f in data.frequency.values)
        + ".",
    )
    return figure


def _displacement_amplitude(data: xr.Dataset, frequency: float) -> float:
    """Return the displacement amplitude times q_max at a velocity amplitude of v."""
    return float(data.velocity * data.q_max) / (2.0 * np.pi * frequency)


def _share(
    ax: Axes, data: xr.Dataset, temperature: float, frequency: float, colour: str, label: str
) -> None:
    """Draw mean friction over that of steady sliding, with the quasi-steady prediction."""
    at = data.sel(temperature=temperature, frequency=frequency)
    ratio = at.velocity_amplitude.values / float(at.velocity)
    style: dict[str, Any] = {"fmt": "o", "ms": 3.5, "color": colour, "label": label}
    ax.errorbar(ratio, at.mu_cycle_share, at.mu_cycle_share_error, **style)
    if frequency == data.frequency.values[0]:
        fine = np.geomspace(0.4, 12.0, 100)
        ax.plot(fine, quasi_steady(data, temperature, fine), "--", color=colour, lw=0.8)


def _dress(ax: Axes, data: xr.Dataset) -> None:
    """Draw Coulomb's law, and label the axes."""
    fine = np.geomspace(0.4, 12.0, 200)
    ax.plot(fine, coulomb(fine), "k-", lw=1.0, label="Coulomb")
    ax.set(xscale="log", ylim=(-0.03, 1.15), xlabel="$\\hat{v}/v$")
    ax.set_xticks([0.5, 1.0, 2.0, 5.0, 10.0])
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set_ylabel("$\\bar\\mu/\\mu_1$")
    ax.legend(loc="lower left")
