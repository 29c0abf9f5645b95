"""How far "auto" is from the limit of fine samples, over the whole range of the paper.

    python -m studies.accuracy.wide [POINTS [LINES [SEED]]]

Random problems (a Latin hypercube in H, log N, log Fbar, log x), a few lines each; the same lines
at the steps that "auto" takes, at half and at FINER times as many. Printed is what 50 and 90
of 100 problems keep, in per cent, by range of x: the table of docs/accuracy.md.
"""

import sys
from collections.abc import Iterator

import numpy as np

from kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from workflow.plan import horizon_steps, steps_per_spacing
from workflow.reduce import FITTED, fit_relaxation, replicates
from workflow.simulate import Problem, record_steps, record_times
from workflow.study import Numerics, Scene

FINER = 8
LARGEST = 1e10  # samples times steps of the finest march of a line
BOUNDS = np.array([[0.0, 1.0], [2.5, 4.0], [-3.0, 1.4], [-1.5, 3.5]])  # H; log10 of N, Fbar, x
RANGES = ((0.0, 1.0), (1.0, 30.0), (30.0, 300.0), (300.0, np.inf))
RATIO = 1.2
NAMES = ("mu_1", "jump", "b")


def problems(count: int, seed: int) -> Iterator[Problem]:
    """Yield random problems of the range of figure 7."""
    rng = np.random.default_rng(seed)
    cells = np.array([rng.permutation(count) for _ in BOUNDS]).T
    unit = (cells + rng.random(cells.shape)) / count
    for hurst, *logs in BOUNDS[:, 0] + unit * np.ptp(BOUNDS, axis=1):
        elements, load, x = 10.0 ** np.array(logs)
        yield Problem(round(hurst, 1), 20 * round(elements / 20), load, x / np.pi, RATIO)


def observe(problem: Problem, steps: int, lines: int, seed: int) -> np.ndarray:
    """Return (mu_1, jump, b) of some lines at so many steps per spacing; b NaN without a fit."""
    hurst, elements, load, speed, ratio = problem[:5]
    kept = record_steps(horizon_steps(problem, Numerics(), steps), Numerics().curve_samples)
    case = Case(load, speed, (ratio,), (kept,), "exponential")
    amplitude = amplitudes(hurst, elements)
    found, curves = [], []
    for index in range(lines):
        rng = np.random.default_rng([seed, elements, index])
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        outcome = run_case(line, case, Quantities())
        found.append((outcome.mu_1, outcome.jump[0]))
        curves.append(outcome.curves[0] - outcome.mu_2[0])
    time = record_times(kept, steps * speed * ratio, "exponential")
    fit = fit_relaxation(time, replicates(np.array(curves), 0), 1.0)
    return np.array([*np.mean(found, axis=0), fit.rate[0] if fit.status == FITTED else np.nan])


def errors(count: int, lines: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return x, and the relative errors at "auto" and at half of it, shape (problems, 2, 3)."""
    x, found = [], []
    for problem in problems(count, seed):
        auto = steps_per_spacing(problem, Scene(), Numerics())
        fine = FINER * auto
        while fine > 2 * auto and _work(problem, fine) > LARGEST:
            fine //= 2
        limit = observe(problem, fine, lines, seed)
        each = [observe(problem, m, lines, seed) for m in (auto, max(auto // 2, 1))]
        found.append(np.abs(np.array(each) / limit - 1.0))
        x.append(np.pi * problem.speed)
    return np.array(x), np.array(found)


def _work(problem: Problem, steps: int) -> float:
    return float(problem.elements * steps * horizon_steps(problem, Numerics(), steps))


def main(count: int = 60, lines: int = 8, seed: int = 2014) -> None:
    """Print the table."""
    x, found = errors(count, lines, seed)
    for low, high in RANGES:
        inside = (x >= low) & (x < high)
        for steps, rows in zip(("auto", "half"), np.moveaxis(found[inside], 1, 0), strict=True):
            cells = []
            for name, column in zip(NAMES, rows.T, strict=True):
                known = 100.0 * column[np.isfinite(column)]
                middle, most = np.percentile(known, [50, 90]) if known.size else (np.nan, np.nan)
                within = np.mean(known <= 2.0) if known.size else np.nan
                cells.append(f"{name} {middle:.2g} {most:.2g} ({within:.0%} of {known.size})")
            print(f"{low:g} <= x < {high:g}, {steps}: {'; '.join(cells)}", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
