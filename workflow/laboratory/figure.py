"""Figure of a fit: each step with fits and residuals, rates over speed, jumps over friction."""

import math

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..kinetic_law import relaxation_rate
from ..report import COLOURS, write_below
from .step_fit import StepFit
from .together import Fit, Rates, friction_after, predicted_jump

STEPS_PER_ROW = 3
MAX_DRAWN_STEPS = 12  # largest number of steps drawn
MAX_DRAWN_SAMPLES = 4000  # approximate number of samples drawn, if a step has more
EQ_6, AGEING = COLOURS[4], COLOURS[0]
MEASURED_COLOUR = "0.6"


def figure_of_fit(fit: Fit) -> Figure:
    """Return the figure of a fit."""
    steps = list(zip(fit.steps, fit.ageing, strict=True))[:MAX_DRAWN_STEPS]
    rows = math.ceil(len(steps) / STEPS_PER_ROW)
    several = fit.rates is not None and len(fit.steps) > 1
    heights = [2.0, 0.8] * rows + [2.2] * several
    across = STEPS_PER_ROW if several else min(len(steps), STEPS_PER_ROW)
    figure = plt.figure(figsize=(1.0 + 2.4 * across, 0.5 + sum(heights)))
    grid = figure.add_gridspec(len(heights), across, height_ratios=heights)
    for i, (step, ageing) in enumerate(steps):
        row, place = 2 * (i // STEPS_PER_ROW), i % STEPS_PER_ROW
        upper = figure.add_subplot(grid[row, place])
        lower = figure.add_subplot(grid[row + 1, place], sharex=upper)
        _step(upper, lower, step, ageing)
    if several:
        assert fit.rates is not None
        last = grid[-1, :].subgridspec(1, 2)
        _rates(figure.add_subplot(last[0]), fit, fit.rates)
        _jumps(figure.add_subplot(last[1]), fit)
    figure.axes[0].legend(loc="best", fontsize=6)
    count = len(fit.steps)
    drawn = ""
    if count > MAX_DRAWN_STEPS:
        drawn = f"The first {MAX_DRAWN_STEPS} of {count} steps are drawn. "
    write_below(figure, f"{drawn}Bars show one standard error, correlated noise counted as it is.")
    return figure


def _step(upper: Axes, lower: Axes, fit: StepFit, ageing: StepFit) -> None:
    step = fit.step
    every = slice(None, None, max(1, step.time.size // MAX_DRAWN_SAMPLES))
    t = step.time[every]
    # Samples before the step are drawn at the mean time interval of those after it.
    before = -np.arange(step.before.size, 0, -1) * (step.time[-1] / step.time.size)
    shown = before > -0.3 * step.time[-1]
    upper.plot(before[shown], step.before[shown], ".", ms=1.0, color=MEASURED_COLOUR)
    upper.plot(t, step.after[every], ".", ms=1.0, color=MEASURED_COLOUR, label="measured")
    upper.plot(before[shown], np.full(int(shown.sum()), fit.mu_1.value), "-", color=EQ_6)
    for fitted, colour, style, label in (
        (ageing, AGEING, "--", "Dieterich"),
        (fit, EQ_6, "-", "eq. 6 (Ruina)"),
    ):
        upper.plot(t, fitted.curve[every], style, color=colour, label=label)
        rest = (step.after - fitted.curve)[every]
        lower.plot(t, rest, "." if fitted is fit else ",", ms=1.0, color=colour, alpha=0.6)
    lower.axhline(0.0, color="k", lw=0.6)
    upper.tick_params(labelbottom=False)
    upper.set_title(f"{step.name}\n{step.v1:.3g} to {step.v2:.3g} m/s", fontsize=7)
    upper.set_ylabel("$\\mu$")
    lower.set(xlabel="time after the step (s)", ylabel="residual")


def _rates(ax: Axes, fit: Fit, rates: Rates) -> None:
    """Draw k over v2, the power law, and eq. 13 if all of its parameters are determined."""
    known = [fitted for fitted in fit.steps if fitted.rate.known]
    v = np.array([fitted.step.v2 for fitted in known])
    k, error = np.array([fitted.rate for fitted in known]).T
    ax.set_xlim(0.5 * v.min(), 2.0 * v.max())  # a range of nonzero width even for one speed
    ax.errorbar(v, k, error, fmt="o", color="k", ms=3)
    span = np.geomspace(0.7 * v.min(), 1.4 * v.max(), 200)
    if rates.exponent.known:
        power = rates.rate.value * (span / rates.at) ** rates.exponent.value
        ax.plot(span, power, ":", color="0.5", label=f"exponent {rates.exponent.value:.2f}")
    tau, hurst, q_max = rates.relaxation_time, rates.hurst, rates.q_max
    if tau.known and hurst.known and q_max.known:
        b = relaxation_rate(span * tau.value * q_max.value, hurst.value, rates.time_below_one)
        ax.plot(span, b / tau.value, "-", color=EQ_6, label="eq. 13")
    ax.set(xscale="log", yscale="log", xlabel="$v_2$ (m/s)", ylabel="rate $b/\\tau$ (1/s)")
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left")


def _jumps(ax: Axes, fit: Fit) -> None:
    """Draw the jump over sqrt(mu_1 mu_2), and eq. 12 if grad z is determined."""
    known = [fitted for fitted in fit.steps if fitted.jump.known]
    mu = np.array(
        [math.sqrt(max(fitted.mu_1.value * friction_after(fitted), 0.0)) for fitted in known]
    )
    jump, error = (
        np.array([fitted.jump.times(1.0 / math.log(fitted.step.ratio)) for fitted in known])
        .reshape(-1, 2)
        .T
    )
    ax.errorbar(mu, jump, error, fmt="o", color="k", ms=3)
    if fit.slope.known:
        span = np.linspace(0.0, 1.1 * mu.max(), 100)[1:]
        label = f"eq. 12, $\\nabla z = {fit.slope.value:.3g}$"
        ax.plot(span, predicted_jump(span, fit.slope.value), "-", color=EQ_6, label=label)
        ax.legend(loc="upper left")
    ax.set(xlabel="$\\sqrt{\\mu_1\\mu_2}$", ylabel="$\\Delta\\mu_0/\\ln(v_2/v_1)$")
    ax.set_xlim(0.0, 1.1 * mu.max() if mu.size else 1.0)
