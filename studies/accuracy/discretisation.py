"""Errors and times of all discretisations of the points, against references on the same lines.

A reference is extrapolated after Richardson.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from typing import NamedTuple

import numpy as np
import xarray as xr

from elastomer_friction.workflow.reduce import fit_relaxation, replicates, standard_error

from .points import Point, RandomLine, surface
from .sampling import COUNTS, LineRuns, Method, run_lines, sampling_errors, seconds

SCHEMES = ("exponential", "implicit-euler")
LEAST_LINES = 20  # a rate is claimed from 18 on
PARTS = ("mu_1 and jump", "everything")  # of the time
QUANTITIES = ("mu_1", "jump", "rate", "curve")
MOMENTS = 24  # at which curves are compared
TARGETS = (0.1, 0.03, 0.01, 0.003, 0.001)
TEXTS = {  # name: long_name, units
    "error": ("rms error over lines; rate: of the mean curve", "1"),
    "bias": ("error of the mean over lines, signed", "1"),
    "bias_error": ("standard error of the bias", "1"),
    "seconds": ("CPU time per realization, median", "s"),
    "order": ("measured order of convergence in 1/m", "1"),
    "reference_error": ("stated error of the reference", "1"),
    "deviation": ("standard deviation of one realization", "1"),
}


class Observed(NamedTuple):
    """What a method gives on some lines."""

    mu_1: np.ndarray  # shape (lines,)
    jump: np.ndarray  # shape (lines,)
    curve: np.ndarray  # shape (lines, MOMENTS): mu over its mean jump
    rate: np.ndarray  # b of the mean curve and of its jackknife replicates; NaN: no fit


class Reference(NamedTuple):
    """Observed values in the limit m -> infinity, and how far they may be off (relative)."""

    limit: Observed
    error: np.ndarray  # shape (QUANTITIES,)
    end: float  # of the compared curves, in tau


class Errors(NamedTuple):
    """Relative errors of a method; the curve's relative to the jump. Shapes (QUANTITIES,)."""

    rms: np.ndarray  # over lines; of the rate: |bias|
    bias: np.ndarray  # of the mean over lines, signed; of the curve: rms over time
    bias_error: np.ndarray  # standard error of the bias


def observe(runs: LineRuns, lines: int, end: float) -> Observed:
    """Return what the first ``lines`` of some runs give, curves up to ``end`` (tau)."""
    rows = slice(0, lines)
    start = (runs.mu_1 + runs.jump)[rows, None]
    values = np.concatenate([start, runs.curves[rows]], axis=1)
    moments = np.concatenate([[0.0], runs.moments])
    grid = np.linspace(0.0, end, MOMENTS)
    curve = np.array([np.interp(grid, moments, line) for line in values])
    deviation = replicates(runs.curves[rows] - runs.mu_2[rows, None], 0)
    rate = fit_relaxation(runs.moments, deviation, runs.slope).rate
    return Observed(runs.mu_1[rows], runs.jump[rows], curve, rate)


def compare(found: Observed, reference: Reference) -> Errors:
    """Return the errors of what was found on the lines of the reference."""
    limit = reference.limit
    scale = limit.jump.mean()
    mu_1 = (found.mu_1 - limit.mu_1) / limit.mu_1.mean()
    jump, curve = (found.jump - limit.jump) / scale, (found.curve - limit.curve) / scale
    rate = found.rate / limit.rate - 1.0
    rms = [np.sqrt(np.mean(each**2)) for each in (mu_1, jump, rate[:1], curve)]
    curves = np.sqrt(np.mean(replicates(curve, 0) ** 2, axis=1))
    means = (replicates(mu_1, 0), replicates(jump, 0), rate, curves)
    bias, error = [mean[0] for mean in means], [standard_error(mean, 0) for mean in means]
    return Errors(np.array(rms), np.array(bias), np.array(error))


def deviations(found: Observed) -> np.ndarray:
    """Return the relative standard deviation of one realization, shape (QUANTITIES,).

    Of the rate: that of its jackknife, per realization; of the curve: rms over time, over the jump.
    """
    lines = found.mu_1.size
    rate = np.sqrt(lines) * standard_error(found.rate, 0) / found.rate[0]
    curve = np.sqrt(np.mean(found.curve.var(axis=0, ddof=1))) / found.jump.mean()
    each = (np.std(q, ddof=1) / q.mean() for q in (found.mu_1, found.jump))
    return np.array([*each, rate, curve])


def order(steps: np.ndarray, error: np.ndarray, floor: float) -> float:
    """Return the measured order of convergence: the slope of log error over log m.

    Over m with errors between ``floor`` and 0.1: those not resolved yet, or not resolved by the
    reference, do not count. NaN with fewer than 3.
    """
    used = (error < 0.1) & (error > floor)
    if np.count_nonzero(used) < 3:
        return np.nan
    return float(-np.polyfit(np.log(steps[used]), np.log(error[used]), 1)[0])


def ladder_steps(point: Point, most: int) -> list[int]:
    """Return m = 1, 2, 4 ... up to ``most``, further where tau is not resolved by then."""
    top = max(most, 2 ** math.ceil(math.log2(2.4 / point.speed)))
    return [2**k for k in range(int(math.log2(top)) + 1)]


def lines_at(steps: int, most: int) -> int:
    """Return the number of lines at m: fewer where they cost more."""
    return max(min(LEAST_LINES, most), min(most, 8 * most // steps))


def reference(point: Point, surfaces: list[RandomLine], most: int) -> Reference:
    """Return the reference of a point: the limit from the finest m and twice of it, of order 2.

    Its error is stated as the difference to extrapolation of order 1: 2/3 of fine - coarse.
    """
    finest = ladder_steps(point, most)[-1]
    lines = lines_at(2 * finest, len(surfaces))
    both = [run_lines(point, surfaces[:lines], Method(SCHEMES[0], m * finest)) for m in (2, 1)]
    end = float(both[0].moments[-1])
    fine, coarse = (observe(runs, lines, end) for runs in both)
    limit = Observed(*(f + (f - c) / 3.0 for f, c in zip(fine, coarse, strict=True)))
    apart = compare(coarse, Reference(fine, np.zeros(4), end))
    return Reference(limit, 2.0 / 3.0 * apart.rms, end)


def climb(
    point: Point,
    surfaces: list[RandomLine],
    scheme: str,
    steps: list[int],
    limit: Reference,
    refine: bool = True,
    run: Callable[[Point, list[RandomLine], Method], LineRuns] = run_lines,
) -> xr.Dataset:
    """Return what a scheme gives over m; errors are those on the lines of the reference.

    refine : whether contacts are followed between samples, as "auto" does. run : what runs
    the scheme on lines; NaN where it is not installed or fails. The deviation of one realization is
    that at a middle m, on all lines.
    """
    rows, apart = [], []
    for m in steps:
        rows.append((*np.full((3, 4), np.nan), np.full(2, np.nan)))
        apart.append(np.full(4, np.nan))
        with suppress(ImportError, ArithmeticError):
            lines = surfaces[: lines_at(m, len(surfaces))]
            runs = run(point, lines, Method(scheme, m, refine))
            found = compare(observe(runs, limit.limit.mu_1.size, limit.end), limit)
            rows[-1] = (*found, seconds(runs))
            apart[-1] = deviations(observe(runs, len(lines), limit.end))
    rms, bias, bias_error, cpu = (np.array(column) for column in zip(*rows, strict=True))
    middle = [each for each in apart[2:] if np.isfinite(each).all()] or apart[2:] or apart
    orders = [order(np.array(steps), rms[:, q], 2.0 * limit.error[q]) for q in range(4)]
    return xr.Dataset(
        {
            "error": (("steps", "quantity"), rms),
            "bias": (("steps", "quantity"), bias),
            "bias_error": (("steps", "quantity"), bias_error),
            "seconds": (("steps", "part"), cpu),
            "order": ("quantity", orders),
            "deviation": ("quantity", middle[0]),
        },
        {"steps": steps},
    )


def warm_up() -> None:
    """Compile everything that is timed."""
    point = Point(0.5, 0.1, 3.0)
    for scheme in SCHEMES:
        run_lines(point, [surface(point, 64, 0, 0)], Method(scheme, 2))


def discretisations(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> tuple[xr.Dataset, xr.Dataset]:
    """Return errors, times, orders and what follows from them for all points.

    The first dataset is of both schemes with contacts followed between the samples, as
    "auto" does. The second is of the exponential scheme as sampled, as where m is given. Errors
    are relative, those of curves to the jump; missing at m that a point does not need.
    """
    found, plain = [], []
    for point in points:
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(settings["lines"])]
        limit = reference(point, surfaces, settings["finest"])
        steps = ladder_steps(point, settings["finest"])
        ladders = [climb(point, surfaces, scheme, steps, limit) for scheme in SCHEMES]
        both = xr.concat(ladders, "scheme")
        both["reference_error"] = ("quantity", limit.error)
        found.append(both.assign(deviation=ladders[0].deviation))
        plain.append(climb(point, surfaces, SCHEMES[0], steps, limit, refine=False))
        advance()
    data = over_points(found, points, TEXTS).assign_coords(
        scheme=list(SCHEMES), target=list(TARGETS)
    )
    own = {name: text for name, text in TEXTS.items() if name in plain[0]}
    as_sampled = over_points(plain, points, own)
    for each in (data, as_sampled):
        each.steps.attrs["long_name"] = "m, steps and samples per spacing"
    data.target.attrs["long_name"] = "relative error aimed at"
    return data, as_sampled


def over_points(
    found: list[xr.Dataset], points: tuple[Point, ...], texts: dict[str, tuple[str, str]]
) -> xr.Dataset:
    """Return the datasets of points as one that says what the points and the variables are."""
    data = xr.concat(found, "point", join="outer").assign_coords(point_coords(points))
    for name, (text, unit) in texts.items():
        data[name].attrs = {"long_name": text, "units": unit}
    return data.assign_coords(quantity=list(QUANTITIES), part=list(PARTS))


def point_coords(points: tuple[Point, ...]) -> dict:
    """Return the coordinates that say what the points are."""
    return {
        "point": [point.name for point in points],
        "hurst": ("point", [point.hurst for point in points], {"long_name": "Hurst exponent H"}),
        "load": ("point", [point.load for point in points], {"long_name": "F_N/(4 G L h)"}),
        "x": ("point", [point.x for point in points], {"long_name": "v1 tau q_max"}),
    }


def sampling(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return the error of the mean of R realizations at all points."""
    found = []
    for point in points:
        count = settings["realizations"]
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(count)]
        steps = int(2 ** np.clip(np.ceil(np.log2(0.2 / point.speed)), 2, 5))
        found.append(sampling_errors(point, surfaces, steps))
        advance()
    coords = point_coords(points) | {"realizations": list(COUNTS), "sampled": list(QUANTITIES[:3])}
    text = {"long_name": "rms relative error of the mean of R realizations", "units": "1"}
    error = (("point", "realizations", "sampled"), np.array(found), text)
    return xr.Dataset({"error": error}, coords)
