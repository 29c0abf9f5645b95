"""Errors and times of all discretisations, against references on the same lines.

The references are Richardson extrapolations.
"""

import math
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import NamedTuple

import numpy as np
import xarray as xr

from elastomer_friction.workflow.reduce import fit_relaxation, replicates, standard_error

from .points import Point, RandomLine, surface
from .sampling import GROUP_SIZES, LineRuns, Method, run_lines, sampling_errors, seconds

Run = Callable[[Point, list[RandomLine], Method], LineRuns]  # runs a scheme on lines
SCHEMES = ("exponential", "implicit-euler")
MIN_LINES = 20  # smallest number of lines; a rate needs 18
TIME_PARTS = ("mu_1 and jump", "everything")
QUANTITIES = ("mu_1", "jump", "rate", "curve")
CURVE_TIMES = 24  # number of times at which curves are compared
TARGET_ERRORS = (0.1, 0.03, 0.01, 0.003, 0.001)
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
    """Results of a method on a set of lines."""

    mu_1: np.ndarray  # shape (lines,)
    jump: np.ndarray  # shape (lines,)
    curve: np.ndarray  # shape (lines, CURVE_TIMES): mu
    rate: np.ndarray  # b of the mean curve and of its jackknife replicates; NaN: no fit


class Reference(NamedTuple):
    """Observed values in the limit m -> infinity, with relative error bounds."""

    limit: Observed
    error: np.ndarray  # shape (QUANTITIES,)
    end: float  # last time of the compared curves, in tau


class Errors(NamedTuple):
    """Relative errors of a method, that of the curve relative to the jump; shape (QUANTITIES,)."""

    rms: np.ndarray  # over lines; of the rate: |bias|
    bias: np.ndarray  # of the mean over lines, signed; of the curve: rms over time
    bias_error: np.ndarray  # standard error of the bias


def observe(runs: LineRuns, lines: int, end: float) -> Observed:
    """Return the results of the first ``lines`` lines of runs, with curves up to ``end`` (tau)."""
    rows = slice(0, lines)
    start = (runs.mu_1 + runs.jump)[rows, None]
    values = np.concatenate([start, runs.curves[rows]], axis=1)
    moments = np.concatenate([[0.0], runs.moments])
    grid = np.linspace(0.0, end, CURVE_TIMES)
    curve = np.array([np.interp(grid, moments, line) for line in values])
    deviation = replicates(runs.curves[rows] - runs.mu_2[rows, None], 0)
    rate = fit_relaxation(runs.moments, deviation, runs.slope).rate
    return Observed(runs.mu_1[rows], runs.jump[rows], curve, rate)


def compare(observed: Observed, reference: Reference) -> Errors:
    """Return the errors of a method on the lines of the reference."""
    limit = reference.limit
    scale = limit.jump.mean()
    mu_1 = (observed.mu_1 - limit.mu_1) / limit.mu_1.mean()
    jump, curve = (observed.jump - limit.jump) / scale, (observed.curve - limit.curve) / scale
    rate = observed.rate / limit.rate - 1.0
    rms = [np.sqrt(np.mean(errors**2)) for errors in (mu_1, jump, rate[:1], curve)]
    curves = np.sqrt(np.mean(replicates(curve, 0) ** 2, axis=1))
    means = (replicates(mu_1, 0), replicates(jump, 0), rate, curves)
    bias, error = [mean[0] for mean in means], [standard_error(mean, 0) for mean in means]
    return Errors(np.array(rms), np.array(bias), np.array(error))


def deviations(observed: Observed) -> np.ndarray:
    """Return the relative standard deviation of one realization, shape (QUANTITIES,).

    That of the rate is from its jackknife; that of the curve is its rms over time over the jump.
    """
    lines = observed.mu_1.size
    rate = np.sqrt(lines) * standard_error(observed.rate, 0) / observed.rate[0]
    curve = np.sqrt(np.mean(observed.curve.var(axis=0, ddof=1))) / observed.jump.mean()
    relative = (np.std(q, ddof=1) / q.mean() for q in (observed.mu_1, observed.jump))
    return np.array([*relative, rate, curve])


def order(steps: np.ndarray, error: np.ndarray, floor: float) -> float:
    """Return the measured order of convergence: the slope of log error over log m.

    The fit uses the m with errors between ``floor`` and 0.1: above the error of the reference, and
    resolved. NaN for fewer than 3 such m.
    """
    used = (error < 0.1) & (error > floor)
    if np.count_nonzero(used) < 3:
        return np.nan
    return float(-np.polyfit(np.log(steps[used]), np.log(error[used]), 1)[0])


def ladder_steps(point: Point, most: int) -> list[int]:
    """Return m = 1, 2, 4 ... up to ``most``, or further until tau is resolved."""
    top = max(most, 2 ** math.ceil(math.log2(2.4 / point.speed)))
    return [2**k for k in range(int(math.log2(top)) + 1)]


def lines_at(steps: int, most: int) -> int:
    """Return the number of lines at m = ``steps``, which decreases with the cost of a line."""
    return max(min(MIN_LINES, most), min(most, 8 * most // steps))


def reference(point: Point, surfaces: list[RandomLine], most: int) -> Reference:
    """Return the reference of a point: second-order extrapolation from the finest m and 2 m.

    The stated error is the difference from first-order extrapolation: 2/3 (fine - coarse).
    """
    finest = ladder_steps(point, most)[-1]
    lines = lines_at(2 * finest, len(surfaces))
    both = [run_lines(point, surfaces[:lines], Method(SCHEMES[0], m * finest)) for m in (2, 1)]
    end = float(both[0].moments[-1])
    fine, coarse = (observe(runs, lines, end) for runs in both)
    limit = Observed(*(f + (f - c) / 3.0 for f, c in zip(fine, coarse, strict=True)))
    difference = compare(coarse, Reference(fine, np.zeros(4), end))
    return Reference(limit, 2.0 / 3.0 * difference.rms, end)


def climb(
    point: Point,
    surfaces: list[RandomLine],
    scheme: str,
    steps: list[int],
    limit: Reference,
    refine: bool = True,
    run: Run = run_lines,
) -> xr.Dataset:
    """Return the errors and times of a scheme over m, on the lines of the reference.

    refine : whether contacts are located between samples, as "auto" does. run : function that runs
    the scheme on lines; if it fails or is not installed, the values are NaN. The deviation of one
    realization is that at the third m, or at the next one where it is finite.
    """
    rows, scatter = [], []
    for m in steps:
        rows.append((*np.full((3, 4), np.nan), np.full(2, np.nan)))
        scatter.append(np.full(4, np.nan))
        with suppress(ImportError, ArithmeticError):
            lines = surfaces[: lines_at(m, len(surfaces))]
            runs = run(point, lines, Method(scheme, m, refine))
            errors = compare(observe(runs, limit.limit.mu_1.size, limit.end), limit)
            rows[-1] = (*errors, seconds(runs))
            scatter[-1] = deviations(observe(runs, len(lines), limit.end))
    rms, bias, bias_error, cpu = (np.array(column) for column in zip(*rows, strict=True))
    middle = (
        [deviation for deviation in scatter[2:] if np.isfinite(deviation).all()]
        or scatter[2:]
        or scatter
    )
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


def warm_up(schemes: Iterable[str], run: Run = run_lines) -> None:
    """Compile or load the code of schemes before they are timed."""
    point = Point(0.5, 0.1, 3.0)
    for scheme in schemes:
        with suppress(ImportError):
            run(point, [surface(point, 64, 0, 0)], Method(scheme, 2))


def discretisations(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> tuple[xr.Dataset, xr.Dataset]:
    """Return errors, times and orders for all points.

    The first dataset is for both schemes with contacts located between the samples, as "auto"
    does. The second is for the exponential scheme with contacts read from the samples, as for a
    given m. Errors are relative, those of curves to the jump; NaN at any m that a point lacks.
    """
    followed, sampled = [], []
    for point in points:
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(settings["lines"])]
        limit = reference(point, surfaces, settings["finest"])
        steps = ladder_steps(point, settings["finest"])
        ladders = [climb(point, surfaces, scheme, steps, limit) for scheme in SCHEMES]
        both = xr.concat(ladders, "scheme")
        both["reference_error"] = ("quantity", limit.error)
        followed.append(both.assign(deviation=ladders[0].deviation))
        sampled.append(climb(point, surfaces, SCHEMES[0], steps, limit, refine=False))
        advance()
    data = over_points(followed, points, TEXTS).assign_coords(
        scheme=list(SCHEMES), target=list(TARGET_ERRORS)
    )
    texts = {name: text for name, text in TEXTS.items() if name in sampled[0]}
    as_sampled = over_points(sampled, points, texts)
    for dataset in (data, as_sampled):
        dataset.steps.attrs["long_name"] = "m, steps and samples per spacing"
    data.target.attrs["long_name"] = "target of the relative error"
    return data, as_sampled


def over_points(
    datasets: list[xr.Dataset], points: tuple[Point, ...], texts: dict[str, tuple[str, str]]
) -> xr.Dataset:
    """Concatenate the datasets of all points, with coordinates and attributes."""
    data = xr.concat(datasets, "point", join="outer").assign_coords(point_coords(points))
    for name, (text, unit) in texts.items():
        data[name].attrs = {"long_name": text, "units": unit}
    return data.assign_coords(quantity=list(QUANTITIES), part=list(TIME_PARTS))


def point_coords(points: tuple[Point, ...]) -> dict:
    """Return the coordinates that identify the points."""
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
    errors = []
    for point in points:
        count = settings["realizations"]
        surfaces = [surface(point, settings["elements"], seed, i) for i in range(count)]
        steps = int(2 ** np.clip(np.ceil(np.log2(0.2 / point.speed)), 2, 5))
        errors.append(sampling_errors(point, surfaces, steps))
        advance()
    coords = point_coords(points) | {
        "realizations": list(GROUP_SIZES),
        "sampled": list(QUANTITIES[:3]),
    }
    text = {"long_name": "rms relative error of the mean of R realizations", "units": "1"}
    error = (("point", "realizations", "sampled"), np.array(errors), text)
    return xr.Dataset({"error": error}, coords)
