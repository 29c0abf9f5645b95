"""The six-dimensional grid in the paper's scaled variables, and the error of the kinetic law."""

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from elastomer_friction.studies.style import DOTS, X_LABEL, by_hurst, normalised
from elastomer_friction.workflow.kinetic_law import (
    jump_between,
    normalised_jump,
    relaxation_rate,
)
from elastomer_friction.workflow.reduce import FITTED
from elastomer_friction.workflow.report import COLOURS, error_bars, foot_line, without_unresolved
from elastomer_friction.workflow.result import Groups

CAPTION = (
    "Panels (a) to (c) show steady friction, jump and relaxation rate at points spread over the "
    "ranges of all six parameters, in the scaled variables of the paper. Panels (d) to (f) show by "
    "how much the kinetic law, eqs. 14 and 15 with the rate at v2, misses the simulated friction "
    "at these points."
)
NOISY = 0.5  # relative standard error above which points are crosses, without bars
PANELS = (  # x label, y label, title
    (X_LABEL, "$\\bar\\mu_1 = \\mu_1/\\nabla z$", "(a) steady friction"),
    ("$\\bar\\mu_1$", "$\\Delta\\bar\\mu_0/(\\Delta v/v_1)$", "(b) jump"),
    (X_LABEL, "relaxation rate $b$ (per $\\tau$)", "(c) relaxation"),
    (X_LABEL, "error of eqs. 14, 15, max $|\\Delta\\mu|/\\mu_1$", "(d) error of the law"),
    ("error of eqs. 14, 15", "share of points", "(e) its distribution"),
    ("", "", "(f) % of points predicted within"),
)
LIMITS = (0.01, 0.05, 0.20)  # of the relative error, in (e) and (f)


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 5.0))
    flat = axes.ravel()
    dataset = groups[""]
    for hurst, points, colour in by_hurst(normalised(dataset)):
        _points(flat[0], points, "mu_bar", "speed_ratio", colour, f"$H = {hurst:g}$")
        _points(flat[1], points, "jump_bar", "mu_bar", colour)
        fitted = points.isel(point=(points.fit_status == FITTED).values)
        _points(flat[2], fitted, "relaxation_rate", "speed_ratio", colour)
        flat[3].plot(points.speed_ratio, law_error(points), "o", color=colour, ms=2.2, alpha=0.7)
    judged, left_out = without_unresolved(dataset)
    _cumulative(flat[4], judged)
    _table(flat[5], judged)
    foot_line(figure, dataset, f"Panels (e) and (f) leave out {left_out} unresolved points.")
    span = np.geomspace(1e-6, 2.0, 100)
    flat[1].plot(span, normalised_jump(span), "k-", lw=1, label="eq. 12", zorder=0)
    for ax, (x_label, y_label, title) in zip(flat, PANELS, strict=True):
        ax.set(xlabel=x_label, ylabel=y_label, title=title)
    for ax in flat[:4]:
        ax.set(xscale="log", yscale="log")
    flat[0].legend(loc="lower right", fontsize=6)
    flat[1].legend(loc="upper left")
    return figure


def _points(
    ax: Axes, points: xr.Dataset, name: str, over: str, colour: str, label: str | None = None
) -> None:
    good = (points[f"{name}_error"] < NOISY * points[name]).values
    style = DOTS | {"color": colour, "label": label, "ms": 2.2, "alpha": 0.7}
    error_bars(ax, points.isel(point=good), name, over, log=True, **style)
    noisy = points.isel(point=~good & np.isfinite(points[name].values))
    crosses = f"standard error over {100.0 * NOISY:g} %" if noisy.point.size else None
    ax.plot(noisy[over], noisy[name], "x", color=colour, ms=3.0, mew=0.6, label=crosses)


def _cumulative(ax: Axes, dataset: xr.Dataset) -> None:
    """Draw the share of points over the error of the law, for both laws below x = 1."""
    branches = (
        (False, "as printed", COLOURS[0], "-"),
        (True, "$b = 1$ for $x < 1$", COLOURS[4], "--"),
    )
    for time_below_one, label, colour, ls in branches:
        error = law_error(dataset, time_below_one).fillna(np.inf)  # unknown errors count as large
        judged = np.isfinite(dataset.mu_1.values)  # points with a result
        ax.ecdf(
            error.transpose(*dataset.mu_1.dims).values[judged], color=colour, label=label, ls=ls
        )
    for limit in LIMITS:
        ax.axvline(limit, color="0.6", lw=0.6, ls=":")
    ax.set(xscale="log", xlim=(1e-6, 2.0), ylim=(0, 1))
    ax.legend(loc="upper left", fontsize=6)


def _table(ax: Axes, dataset: xr.Dataset) -> None:
    """Write the shares of points that the law predicts within 1, 5 and 20 %."""
    error, x = law_error(dataset), dataset.speed_ratio
    rough = dataset.mu_1 / dataset.rms_slope >= 0.3
    rows = {
        "all points": error,
        "$x < 1$": error.where(x < 1.0),
        "$x > 1$, $\\bar\\mu_1 < 0.3$": error.where((x > 1.0) & ~rough),
        "$x > 1$, $\\bar\\mu_1 > 0.3$": error.where((x > 1.0) & rough),
    }
    shares = [shares_within(part.values) for part in rows.values()]
    cells = [[f"{100.0 * share:.0f}" for share in row] for row in shares]
    table = ax.table(
        cells,
        rowLabels=list(rows),
        colLabels=[f"{100.0 * limit:g} %" for limit in LIMITS],
        bbox=Bbox.from_bounds(0.45, 0.3, 0.55, 0.55),
        edges="horizontal",
        cellLoc="center",
    )
    table.auto_set_font_size(False)
    table.set_fontsize(7)
    ax.axis("off")


def law_curve(dataset: xr.Dataset, time_below_one: bool = False) -> xr.DataArray:
    """Return mu(t) of eqs. 14 and 15 at the samples of a result, from its mu_1, mu_2, grad z.

    mu_2 replaces the linearised mu_1 + mu'(v1) dv, the jump is the sum of small jumps, and the
    rate is that at v2. time_below_one : see kinetic_law.py.
    """
    ratio, friction = 1.0 + dataset.velocity_step, (dataset.mu_1, dataset.mu_2)
    jump = xr.apply_ufunc(jump_between, *friction, np.log(ratio), dataset.rms_slope)
    rate = xr.apply_ufunc(
        relaxation_rate,
        ratio * dataset.speed_ratio,
        dataset.hurst,
        kwargs={"time_below_one": time_below_one},
    )
    amplitude = dataset.mu_1 + jump - dataset.mu_2
    return dataset.mu_2 + amplitude * np.exp(-rate * dataset.time)


def law_error(dataset: xr.Dataset, time_below_one: bool = False) -> xr.DataArray:
    """Return the largest |law - simulated| / mu_1 over the recorded samples, per grid point."""
    difference = np.abs(law_curve(dataset, time_below_one) - dataset.mu)
    return (difference / np.abs(dataset.mu_1)).max("sample")


def shares_within(error: np.ndarray) -> list[float]:
    """Return the shares of points with an error within 1, 5 and 20 %."""
    known = error[np.isfinite(error)]
    return [float(np.mean(known <= limit)) for limit in LIMITS]
