"""Error of the rate b at "auto" against the limit of fine samples, over the range of the paper.

    python -m tests.tools.wide [POINTS [LINES [SEED]]]

Random problems (a Latin hypercube in H, log N, log Fbar, log x) are computed on the same lines with
the steps of "auto" and with up to FINER times as many. The table of docs/accuracy.md lists, by
range of x, the ninth decile of the relative error and the shares of problems with errors within the
stated bound of the bias and within 2 %.
"""

import sys
from collections.abc import Iterator

import numpy as np

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from elastomer_friction.workflow.plan import horizon_steps, steps_per_spacing
from elastomer_friction.workflow.plan.error_laws import LAWS, rate_error
from elastomer_friction.workflow.reduce import FITTED, fit_relaxation, replicates
from elastomer_friction.workflow.simulate import Problem, curve_times, record_steps
from elastomer_friction.workflow.study import Numerics, Scene

FINER = 8
LARGEST = 1e10  # largest number of samples times steps in a march
BOUNDS = np.array([[0.0, 1.0], [2.5, 4.0], [-3.0, 1.4], [-1.5, 3.5]])  # H; log10 of N, Fbar, x
RANGES = ((0.0, 1.0), (1.0, 30.0), (30.0, 300.0), (300.0, np.inf))
RATIO = 1.2
NAMES = ("mu_1", "jump", "b")


def problems(count: int, seed: int) -> Iterator[Problem]:
    """Yield random problems in the range of figure 7."""
    rng = np.random.default_rng(seed)
    cells = np.array([rng.permutation(count) for _ in BOUNDS]).T
    unit = (cells + rng.random(cells.shape)) / count
    for hurst, *logs in BOUNDS[:, 0] + unit * np.ptp(BOUNDS, axis=1):
        elements, load, x = 10.0 ** np.array(logs)
        yield Problem(round(hurst, 1), 20 * round(elements / 20), load, x / np.pi, RATIO)


def mean_of_lines(problem: Problem, steps: int, lines: int, seed: int) -> np.ndarray:
    """Return (mu_1, jump, b, samples per contact), means over lines. steps : per spacing.

    b is NaN without a fit.
    """
    hurst, elements, load, speed, ratio = problem[:5]
    recorded = record_steps(horizon_steps(problem, Numerics(), steps), Numerics().curve_samples)
    case = Case(load, speed, (ratio,), (recorded,), "exponential")
    amplitude = amplitudes(hurst, elements)
    actual, curves = [], []
    for index in range(lines):
        rng = np.random.default_rng([seed, elements, index])
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        outcome = run_case(line, case, Quantities())
        actual.append((outcome.mu_1, outcome.jump[0], outcome.samples_per_contact))
        curves.append(outcome.curves[0] - outcome.mu_2[0])
    time = curve_times(recorded, steps * speed * ratio, "exponential")
    fit = fit_relaxation(time, replicates(np.array(curves), 0), 1.0)
    mu_1, jump, samples = np.mean(actual, axis=0)
    return np.array([mu_1, jump, fit.rate[0] if fit.status == FITTED else np.nan, samples])


def stated(problem: Problem, steps: int, means: np.ndarray) -> np.ndarray:
    """Return the bounds of the bias of (mu_1, jump, b) that a result file states."""
    steady = [LAWS[name].error(problem, steps) for name in NAMES[:2]]
    return np.array([*steady, rate_error(problem, steps, means[3], means[2])])


def error_of_rate(problem: Problem, lines: int, seed: int) -> tuple[float, float]:
    """Return the relative error of b at "auto", NaN without a fit, and its stated bound."""
    auto = int(steps_per_spacing(problem, Scene(), Numerics()))
    fine = FINER * auto
    while fine > 2 * auto and _work(problem, fine) > LARGEST:
        fine //= 2
    limit = mean_of_lines(problem, fine, lines, seed)
    means = mean_of_lines(problem, auto, lines, seed)
    return abs(means[2] / limit[2] - 1.0), float(stated(problem, auto, means)[2])


def _work(problem: Problem, steps: int) -> float:
    return float(problem.elements * steps * horizon_steps(problem, Numerics(), steps))


def print_table(count: int = 240, lines: int = 8, seed: int = 2014) -> None:
    """Print the table."""
    chosen = list(problems(count, seed))
    x = np.array([np.pi * problem.speed for problem in chosen])
    errors = np.array([error_of_rate(problem, lines, seed) for problem in chosen])
    print("| range | b | b within 2 % |\n|---|---|---|")
    for low, high in RANGES:
        error, bound = errors[(x >= low) & (x < high) & np.isfinite(errors[:, 0])].T
        if error.size:
            ninth, within = 100.0 * np.percentile(error, 90), np.mean(error <= bound)
            small = f"{np.mean(error <= 0.02):.0%} of {error.size}"
            print(f"| {low:g} <= x < {high:g} | {ninth:.2g} ({within:.0%}) | {small} |")


if __name__ == "__main__":
    print_table(*map(int, sys.argv[1:]))
