"""Measured lines and random lines with the same spectrum, or with the same height and slope.

Compare Persson et al., J. Phys.: Condens. Matter 17, R1 (2005), on spectra of measured surfaces,
and Li et al. (2014), figure 3a, on mu over velocity.
"""

from typing import Any

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import X_LABEL, fitted, normalised, ratio_of
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line, with_unit
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panels (a) to (c) show the power spectra of measured lines, their steady friction and the "
    "rate at which it relaxes. Panels (d) to (f) set friction, jump and contact of measured lines "
    "and of self-affine lines in relation to those of random lines that have the spectrum of the "
    "measured ones."
)
RANDOM = "random_phase"  # the reference group
STYLES: dict[str, dict[str, Any]] = {
    "": {"fmt": "o", "ms": 3.0, "label": "measured"},
    "random_phase": {"fmt": "-", "lw": 1.2, "label": "random phases"},
    "self_affine": {"fmt": "--", "lw": 0.9, "label": "self-affine, $H = 1$"},
}
ABOVE = (
    ("mu_bar", "$\\mu_1 / \\nabla z$", "(b) steady friction"),
    ("relaxation_rate", "relaxation rate $b$ (per $\\tau$)", "(c) relaxation after the step"),
)
BELOW = {
    "mu_1": "(d) steady friction $\\mu_1$",
    "jump": "(e) jump $\\Delta\\mu_0$",
    "contact_fraction": "(f) contact fraction",
}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    shown = {
        name: normalised(fitted(data.isel(hurst=0, spacing=0, roughness=0, velocity_step=0)))
        for name, data in groups.items()
    }
    figure, axes = plt.subplots(2, 3, figsize=(7.4, 5.0))
    _spectra(axes[0, 0], groups)
    for ax, (name, label, title) in zip(axes[0, 1:], ABOVE, strict=True):
        _by_force(ax, shown, name)
        ax.set(yscale="log", ylabel=label, title=title)
    for ax, (name, title) in zip(axes[1], BELOW.items(), strict=True):
        # Self-affine lines share the phases of the random-phase lines, so that the bars of their
        # ratios are too large.
        others = {
            group: data.assign(ratio_of(data, shown[RANDOM], name))
            for group, data in shown.items()
            if group != RANDOM
        }
        _by_force(ax, others, "ratio")
        ax.axhline(1.0, color="k", lw=0.8)
        ax.set_title(title)
    axes[1, 0].set_ylabel("over that of random phases")
    for ax in axes.flat[1:]:
        ax.set(xscale="log", xlabel=X_LABEL)
    for style in STYLES.values():
        axes[0, 1].plot([], [], style["fmt"], color="0.3", ms=3.0, label=style["label"])
    axes[0, 1].legend(loc="lower right")
    for force, colour in zip(groups[""].normal_force.values, COLOURS, strict=False):
        axes[0, 2].plot([], [], "o", color=colour, label=f"$F_N$ = {with_unit(force, 'N')}")
    axes[0, 2].legend(loc="upper left")
    foot_line(figure, groups[""], f"The lines are {groups[''].attrs['lines']}.")
    return figure


def _spectra(ax: Axes, groups: Groups) -> None:
    """Draw the power spectra; the random-phase lines have the measured one."""
    for name in ("", "self_affine"):
        spectrum = groups[name].power_spectrum
        colour = COLOURS[6] if name == "" else COLOURS[4]
        label = STYLES[name]["label"]
        ax.plot(spectrum.wave_number, spectrum, color=colour, lw=0.9, label=label)
    ax.set(xscale="log", yscale="log", xlabel="$q$ (1/m)", ylabel="$C_{1D}$ (m³)")
    ax.set_title("(a) power spectra")
    ax.legend(loc="lower left")


def _by_force(ax: Axes, shown: Groups, name: str) -> None:
    """Draw a variable over the velocity, with a colour for every force."""
    for label, data in shown.items():
        for i, force in enumerate(data.normal_force.values):
            style = STYLES[label] | {"color": COLOURS[i], "label": None}
            error_bars(ax, data.sel(normal_force=force), name, "speed_ratio", **style)
