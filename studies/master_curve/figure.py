"""Master curves of friction over speed, for several forces, indentations and temperatures."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure

from elastomer_friction.studies.style import shades
from elastomer_friction.workflow.report import COLOURS, foot_line, legend_in_room, log_bars
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Study, read_study

from .collapse import (
    ALONG_BOTH,
    MAX_FRICTION_ERROR,
    SHIFT_MODES,
    UNSHIFTED,
    Collapsed,
    remaining,
    resolved,
    thermal,
)

CAPTION = (
    "Panels (a) to (d) show steady friction over the sliding speed at several normal forces or "
    "indentations, temperatures and sizes, as computed and after each curve has been shifted along "
    "both axes onto one reference. Panels (e) to (g) show the shifts, their "
    "difference from the thermal shift of the material, and the residuals."
)
MARKERS = ("o", "s", "^", "D")  # of the sizes
MODE_LABELS = ("unshifted", "along $v$", "and $\\mu$")
NAMES = {"": "SBR", "kelvin": "Kelvin"}


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    layout = [[*"abe"]] * 2 + [[*"abf"], [*"cdf"]] + [[*"cdg"]] * 2
    figure, axes = plt.subplot_mosaic(layout, figsize=(7.6, 6.0), width_ratios=(1.0, 1.25, 0.95))
    sound = {name: resolved(groups[name]) for name in NAMES if name in groups}
    collapsed = {}
    for name, (dataset, _) in sound.items():
        for how, family_collapse in remaining(dataset).items():
            collapsed[name, how] = family_collapse
    _pair(figure, (axes["a"], axes["b"]), collapsed["", "force"], True, "normal force $F_N$ (N)")
    _pair(figure, (axes["c"], axes["d"]), collapsed["", "indentation"], False, "indentation $d/h$")
    axes["a"].set_title("(a) SBR at given normal forces")
    axes["b"].set_title("(b) the same, shifted")
    axes["c"].set_title("(c) SBR at given indentations")
    axes["d"].set_title("(d) the same, shifted")
    _shifts(axes["e"], collapsed)
    _thermal(axes["f"], collapsed["", "force"], collapsed["", "indentation"])
    _residuals(axes["g"], collapsed)
    coarse = sum(count for _, count in sound.values())
    sets = list(collapsed.values())
    invalid = ", ".join(str(one.family.left_out) for one in sets)
    beyond = ", ".join(str(one.collapses[ALONG_BOTH].left_out) for one in sets)
    points = ", ".join(str(sum(c.x.size for c in one.family.curves)) for one in sets)
    rule = (
        "Each curve has one shift, by least squares with at least two thirds of its points over "
        f"the reference (black). Left out are {coarse} points with contacts of fewer than 4 "
        f"samples; of the sets of (g) {invalid} without a number or with errors over "
        f"{100.0 * MAX_FRICTION_ERROR:g} %, and {beyond} of {points} beyond the reference. Panel "
        "(f) has all pairs of curves, and their medians filled."
    )
    foot_line(figure, sound[""][0], rule)
    return figure


def _pair(
    figure: Figure, axes: tuple[Axes, Axes], collapsed: Collapsed, log: bool, label: str
) -> None:
    """Draw the curves unshifted, and shifted along both axes."""
    pressed = [place.pressed for place in collapsed.family.places]
    colours = shades(min(pressed), max(pressed), log=log)
    _curves(axes[0], collapsed, UNSHIFTED, colours)
    _curves(axes[1], collapsed, ALONG_BOTH, colours)
    axes[0].set(xlabel="speed $v$ (m/s)", ylabel="friction $\\mu$")
    axes[1].set(xlabel="shifted speed (m/s)", ylabel="shifted friction")
    for marker, size in zip(
        MARKERS, sorted({p.size for p in collapsed.family.places}), strict=False
    ):
        axes[0].plot([], [], marker, color="0.4", ms=2.4, label=f"length $\\times$ {size:g}")
    axes[0].legend(loc="lower right", fontsize=6.0, handletextpad=0.1)
    figure.colorbar(colours, ax=axes[1], label=label)


def _curves(ax: Axes, collapsed: Collapsed, mode: str, colours: ScalarMappable) -> None:
    family, sizes = collapsed.family, sorted({place.size for place in collapsed.family.places})
    reference = family.reference()
    rows = zip(family.places, family.curves, collapsed.collapses[mode].shifts, strict=True)
    for k, (place, curve, shift) in enumerate(rows):
        mu = 10.0 ** (curve.y + shift.along_friction)
        bars = log_bars(mu, mu * curve.error * np.log(10.0))
        style: dict[str, Any] = {"fmt": MARKERS[sizes.index(place.size)], "ms": 1.6, "lw": 0.4}
        style["color"] = "k" if k == reference else colours.to_rgba(np.array(place.pressed))
        front = 3.0 if k == reference else 2.0
        moved = 10.0 ** (curve.x + shift.along_speed)
        ax.errorbar(moved, mu, bars, mew=0.3, zorder=front, **style)
    ax.set(xscale="log", yscale="log")


def _shifts(ax: Axes, collapsed: dict[tuple[str, str], Collapsed]) -> None:
    """Draw the shifts of the smallest system at the highest temperature over the normal force."""
    for name, colour in zip(NAMES, (COLOURS[0], COLOURS[1]), strict=True):
        if (name, "force") not in collapsed:
            continue
        at_force = collapsed[name, "force"]
        reference = at_force.family.places[at_force.family.reference()]
        rows = zip(at_force.family.places, at_force.collapses[ALONG_BOTH].shifts, strict=True)
        chosen = [(p.pressed, *s[:3]) for p, s in rows if p[1:] == reference[1:]]
        force, along, lift, error = np.array(chosen).T
        label = NAMES[name]
        ax.errorbar(force, along, error, fmt="o-", color=colour, lw=0.7, label=f"{label}, of $v$")
        ax.errorbar(force, lift, fmt="s--", color=colour, lw=0.7, label=f"{label}, of $\\mu$")
    ax.set(xscale="log", xlabel="normal force (N)", ylabel="shift (decades)")
    ax.set_title("(e) shifts over force")
    legend_in_room(ax, 0.35, fontsize=5.5, ncols=2)


def _thermal(ax: Axes, force: Collapsed, depth: Collapsed) -> None:
    """Draw the fitted shift along speed minus the WLF shift, for every pair of curves."""
    study = read_study("master_curve")
    assert isinstance(study, Study)
    material = study.material
    for collapsed, label, colour, marker, offset in (
        (force, "given force", COLOURS[4], "s", -1.0),
        (depth, "given indentation", COLOURS[2], "o", 1.0),
    ):
        temperature, fitted, _ = thermal(collapsed)
        difference = fitted - np.log10([material.shift(t) for t in temperature])
        style: dict[str, Any] = {"color": colour, "marker": marker, "ls": ""}
        pairs = style | {"ms": 2.0, "mfc": "none", "mew": 0.5, "label": label}
        ax.plot(temperature + offset, difference, **pairs)
        for t in np.unique(temperature):
            median = np.median(difference[temperature == t])
            ax.plot(t + 2.0 * offset, median, ms=4.0, **style)
    ax.axhline(0.0, color="k", lw=0.7, ls="--")
    ax.set_xticks(np.unique(temperature))
    ax.set_xlim(temperature.min() - 10.0, temperature.max() + 10.0)
    ax.set(xlabel="temperature (°C)", ylabel="fitted $-$ WLF (decades)")
    ax.set_title("(f) thermal shifts")
    legend_in_room(ax, 0.3, fontsize=5.5)


def _residuals(ax: Axes, collapsed: dict[tuple[str, str], Collapsed]) -> None:
    """Draw the rms residuals for all shift modes."""
    modes = zip(
        SHIFT_MODES, MODE_LABELS, ("s", "^", "o"), ("0.5", COLOURS[5], COLOURS[0]), strict=True
    )
    for mode, label, marker, colour in modes:
        rms = [family_collapse.collapses[mode].rms for family_collapse in collapsed.values()]
        ax.plot(range(len(rms)), rms, marker, color=colour, label=label)
    symbols = {"force": "$F_N$", "indentation": "$d$"}
    names = [f"{NAMES[name]}\nat {symbols[pressing]}" for name, pressing in collapsed]
    ax.set_xticks(range(len(collapsed)), names, fontsize=5.5)
    ax.set(yscale="log", ylabel="rms difference\n(decades of $\\mu$)", title="(g) residuals")
    ax.set(xlim=(-0.5, len(collapsed) - 0.5), ylim=(None, 5.0 * ax.get_ylim()[1]))
    ax.legend(loc="upper right", fontsize=5.5, ncols=3, columnspacing=0.5, handlelength=1.0)
