"""Velocity steps up and down: friction and indentation over the distance slid, and their peaks.

Compare a step in rate-and-state friction (A. Ruina, J. Geophys. Res. 88, 10359 (1983); C. Marone,
Annu. Rev. Earth Planet. Sci. 26, 643 (1998)): a direct effect a ln r, then a decay over one
distance D_c to (a - b) ln r, the same for all sizes, up and down. Compare also steps on rubber (O.
Ronsin and K. L. Coeyrehourcq, "State, rate and temperature-dependent sliding friction of
elastomers": kinetics, not magnitudes, as deformation is negligible there), and an ensemble of
viscoelastic elements on a rough rigid surface (S. Hulikal, K. Bhattacharya, N. Lapusta,
arXiv:1405.3643). The abstracts of the last two were read; the others are cited from memory.
"""

from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.studies.style import slide_of
from elastomer_friction.workflow.report import COLOURS, band, foot_line, legend_in_room
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Friction and indentation are shown over the distance slid since velocity steps up (solid) and "
    "down (dashed) of several sizes, for a Kelvin element and for a rubber of nine branches. The "
    "panels on the right show the largest and the final change of friction over the logarithm of "
    "the step; in rate-and-state friction each is a constant."
)
LABELS = {"": "Kelvin element", "rubber": "nine branches"}
MICRO = 1e6


class StepWithSlide(NamedTuple):
    """A velocity step from v1, and the slide after it."""

    ratio: float  # v2 / v1
    slide: xr.Dataset  # along "event", with slid, the distance (m) since the step
    peak: tuple[float, float]  # largest change of mu in the direction of the step, and its error
    rest: tuple[float, float]  # change of mu at the end of the slide, and its error


def simulated_steps(data: xr.Dataset) -> list[StepWithSlide]:
    """Return the steps from v1, ordered by their ratio. data : without axes of length 1."""
    steps = []
    for k in range(1, int(data.trace_segment.max()) + 1, 2):
        slide, before = slide_of(data, k), data.trace_velocity[data.trace_segment == k - 1]
        ratio = float(slide.trace_velocity[-1] / before[-1])
        change, error = slide.trace_mu_change.values, slide.trace_mu_change_error.values
        top = int(np.argmax(np.sign(ratio - 1.0) * change))
        steps.append(
            StepWithSlide(ratio, slide, (change[top], error[top]), (change[-1], error[-1]))
        )
    return sorted(steps, key=lambda step: step.ratio)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 3, figsize=(7.4, 4.7), width_ratios=(1.0, 1.0, 0.85))
    for column, (name, label) in enumerate(LABELS.items()):
        data = groups[name].squeeze()
        steps = simulated_steps(data)
        _histories(axes[0, column], steps, "trace_mu_change", 1.0)
        _histories(axes[1, column], steps, "trace_indentation_change", MICRO)
        axes[0, column].set_title(f"({'ab'[column]}) {label}, $\\mu_1 = {float(data.mu_1):.2g}$")
        axes[1, column].set_xlabel("distance since the step (m)")
        style: dict[str, Any] = {"fmt": "os"[column], "color": COLOURS[column], "label": label}
        _per_decade(axes[0, 2], steps, "peak", **style)
        _per_decade(axes[1, 2], steps, "rest", **style)
    axes[0, 0].set_ylabel("change of $\\mu$")
    axes[1, 0].set_ylabel("change of indentation (µm)")
    legend_in_room(axes[0, 0], 0.2, ncols=3, handlelength=1.0, columnspacing=0.8)
    axes[0, 2].set_title("(c) direct effect: peak$\\,/\\,\\ln r$")
    axes[1, 2].set_title("(d) lasting: $(\\mu_2 - \\mu_1)/\\ln r$")
    axes[1, 2].set_xlabel("velocity ratio $r = v_2/v_1$")
    legend_in_room(axes[0, 2], 0.25)
    note = (
        "Dotted is D_c = 1/q_max, which the paper remarks on. In rate-and-state friction all "
        "points of (c) are one a, and those of (d) one a − b."
    )
    foot_line(figure, groups[""], note, bars="bars and bands")
    return figure


def _histories(ax: Axes, steps: list[StepWithSlide], name: str, scale: float) -> None:
    """Draw the change of a trace over the distance slid since each step."""
    sizes = sorted({round(max(step.ratio, 1.0 / step.ratio), 6) for step in steps})
    for step in steps:
        up = step.ratio > 1.0
        colour = COLOURS[sizes.index(round(max(step.ratio, 1.0 / step.ratio), 6))]
        slid = step.slide.slid.values
        change, error = (scale * step.slide[f"{name}{end}"].values for end in ("", "_error"))
        label = f"$r = {step.ratio:g}^{{\\pm 1}}$" if up else None
        band(ax, slid, change, error, "-" if up else "--", color=colour, label=label)
    reach = float(steps[0].slide.spacing) / np.pi
    ax.axvline(reach, color="0.6", lw=0.7, ls=":")
    ax.axhline(0.0, color="0.7", lw=0.5)
    ax.set(xscale="log")


def _per_decade(ax: Axes, steps: list[StepWithSlide], kind: str, **style: Any) -> None:
    """Draw a change of friction divided by ln r over r."""
    ratio = np.array([step.ratio for step in steps])
    value, error = np.array([getattr(step, kind) for step in steps]).T / np.log(ratio)
    ax.errorbar(ratio, value, np.abs(error), **style)
    ax.axhline(0.0, color="0.7", lw=0.5)
    ax.set(xscale="log")
