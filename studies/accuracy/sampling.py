"""Runs of a discretisation on a set of lines: CPU times and sampling errors."""

import time
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import Case, Line, Quantities, rms_slope, run_case
from elastomer_friction.workflow.plan import horizon_steps
from elastomer_friction.workflow.reduce import fit_exponential
from elastomer_friction.workflow.simulate import curve_times, record_steps
from elastomer_friction.workflow.study import Numerics

from .points import RATIO, Point, RandomLine

NUMERICS = Numerics()
GROUP_SIZES = (10, 20, 50, 100, 200, 500, 1000)
MAX_GROUPS = 40


class Method(NamedTuple):
    """A discretisation."""

    scheme: str
    steps: int  # m, samples and time steps per dx
    refine: bool = True  # locate contacts between samples, as "auto" does


class LineRuns(NamedTuple):
    """Results of one method at one point; first axis: lines. mu in h/dx, times in tau."""

    mu_1: np.ndarray
    mu_2: np.ndarray
    jump: np.ndarray
    curves: np.ndarray  # shape (lines, samples)
    moments: np.ndarray  # shape (samples,), times of the samples
    slope: float  # rms slope of the lines
    cpu: np.ndarray  # shape (lines, 3): drawing and sampling, steady states and jump, all


def kept_steps_of(point: Point, elements: int, method: Method) -> tuple[np.ndarray, np.ndarray]:
    """Return the steps at which the workflow records a relaxation, and their moments in tau."""
    march_steps = horizon_steps(point.problem(elements), NUMERICS, method.steps)
    kept_steps = record_steps(march_steps, NUMERICS.curve_samples)
    return kept_steps, curve_times(kept_steps, method.steps * point.speed * RATIO, method.scheme)


def run_lines(point: Point, surfaces: list[RandomLine], method: Method) -> LineRuns:
    """Run a method on lines as the workflow does, and measure the CPU time of each."""
    kept_steps, moments = kept_steps_of(point, surfaces[0].elements, method)
    parameters = point.load, point.speed, (RATIO,), (kept_steps,)
    case = Case(*parameters, method.scheme, refine=method.refine)
    rows = []
    for surface in surfaces:
        clock = [time.process_time()]
        line = Line.self_affine(*surface, method.steps)
        clock.append(time.process_time())
        run_case(line, case, Quantities(relaxation=False))
        clock.append(time.process_time())
        result = run_case(line, case, Quantities())
        clock.append(time.process_time())
        rows.append((result.mu_1, result.mu_2[0], result.jump[0], result.curves[0], np.diff(clock)))
    return collected(rows, moments, surfaces[0])


def collected(rows: list[tuple], moments: np.ndarray, line: RandomLine) -> LineRuns:
    """Return the rows (mu_1, mu_2, jump, curve, CPU times) of lines like ``line`` as arrays."""
    mu_1, mu_2, jump, curves, cpu = (np.array(column) for column in zip(*rows, strict=True))
    slope = rms_slope(line.amplitude, line.elements)
    return LineRuns(mu_1, mu_2, jump, curves, moments, slope, cpu)


def seconds(runs: LineRuns) -> np.ndarray:
    """Return the median CPU seconds per realization: of mu_1 and jump, and of everything."""
    drawn, steady, everything = np.median(runs.cpu, axis=0)
    return np.array([drawn + steady, drawn + everything])


def sampling_errors(point: Point, surfaces: list[RandomLine], steps: int) -> np.ndarray:
    """Return the rms relative error of groups of R lines, shape (GROUP_SIZES, 3): mu_1, jump, rate.

    The errors are relative to the mean over all lines, corrected for the share of a group in it.
    NaN for fewer than two groups, or if the rate can be fitted in fewer than half of them.
    """
    runs = run_lines(point, surfaces, Method("exponential", steps))
    lines = len(surfaces)
    whole = _estimate(runs, slice(0, lines))
    errors = np.full((len(GROUP_SIZES), 3), np.nan)
    for row, count in enumerate(GROUP_SIZES):
        number = min(MAX_GROUPS, lines // count)
        if number < 2:
            break
        parts = [_estimate(runs, slice(k * count, (k + 1) * count)) for k in range(number)]
        deviations = np.array(parts) / whole - 1.0
        for q in range(3):
            finite = deviations[np.isfinite(deviations[:, q]), q]
            if finite.size >= max(2, number // 2):
                errors[row, q] = np.sqrt(np.mean(finite**2) / (1.0 - count / lines))
    return errors


def _estimate(runs: LineRuns, rows: slice) -> np.ndarray:
    """Return (mu_1, jump, b) of the mean over some lines."""
    deviation = (runs.curves[rows] - runs.mu_2[rows, None]).mean(axis=0)
    rate = fit_exponential(runs.moments, deviation)[1]  # every b counts here, significant or not
    return np.array([runs.mu_1[rows].mean(), runs.jump[rows].mean(), rate])
