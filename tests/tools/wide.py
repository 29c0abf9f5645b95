"""How far "auto" is from the limit of fine samples, over the whole range of the paper.

    python -m tests.tools.wide [POINTS [LINES [SEED]]]

Random problems (a Latin hypercube in H, log N, log Fbar, log x), a few lines each; the same lines
at the steps that "auto" takes, at half and at FINER times as many. Printed is what 50 and 90
of 100 problems keep, in per cent, by range of x, how many keep 2 %, and how many keep the bound of
the bias that a result file would state: the table of docs/accuracy.md.
"""

import sys
from collections.abc import Iterator

import numpy as np

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from elastomer_friction.workflow.plan import horizon_steps, rate_error, steps_per_spacing
from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.reduce import FITTED, fit_relaxation, replicates
from elastomer_friction.workflow.simulate import Problem, curve_steps, curve_times
from elastomer_friction.workflow.study import Numerics, Scene

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


def mean_of_lines(problem: Problem, steps: int, lines: int, seed: int) -> np.ndarray:
    """Return (mu_1, jump, b, samples per contact) of some lines at so many steps per spacing.

    b is NaN without a fit.
    """
    hurst, elements, load, speed, ratio = problem[:5]
    kept = curve_steps(horizon_steps(problem, Numerics(), steps), Numerics().curve_samples)
    case = Case(load, speed, (ratio,), (kept,), "exponential")
    amplitude = amplitudes(hurst, elements)
    actual, curves = [], []
    for index in range(lines):
        rng = np.random.default_rng([seed, elements, index])
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        outcome = run_case(line, case, Quantities())
        actual.append((outcome.mu_1, outcome.jump[0], outcome.samples_per_contact))
        curves.append(outcome.curves[0] - outcome.mu_2[0])
    time = curve_times(kept, steps * speed * ratio, "exponential")
    fit = fit_relaxation(time, replicates(np.array(curves), 0), 1.0)
    mu_1, jump, samples = np.mean(actual, axis=0)
    return np.array([mu_1, jump, fit.rate[0] if fit.status == FITTED else np.nan, samples])


def stated(problem: Problem, steps: int, seen: np.ndarray) -> np.ndarray:
    """Return the bounds of the bias of (mu_1, jump, b) that a result file states."""
    steady = [LAWS[name].error(problem, steps) for name in NAMES[:2]]
    return np.array([*steady, rate_error(problem, steps, seen[3], seen[2])])


def errors(count: int, lines: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return x, the relative errors and their stated bounds at "auto" and at half of it.

    The shape is (problems, 2, 2, 3): errors and bounds; the two m; mu_1, jump and b.
    """
    x, actual = [], []
    for problem in problems(count, seed):
        auto = steps_per_spacing(problem, Scene(), Numerics())
        fine = FINER * auto
        while fine > 2 * auto and _work(problem, fine) > LARGEST:
            fine //= 2
        limit = mean_of_lines(problem, fine, lines, seed)
        both = auto, max(auto // 2, 1)
        each = [mean_of_lines(problem, m, lines, seed) for m in both]
        bounds = [stated(problem, m, seen) for m, seen in zip(both, each, strict=True)]
        actual.append((np.abs(np.array(each) / limit - 1.0)[:, :3], bounds))
        x.append(np.pi * problem.speed)
    return np.array(x), np.array(actual)


def _work(problem: Problem, steps: int) -> float:
    return float(problem.elements * steps * horizon_steps(problem, Numerics(), steps))


def print_table(count: int = 240, lines: int = 8, seed: int = 2014) -> None:
    """Print the table."""
    x, actual = errors(count, lines, seed)
    for low, high in RANGES:
        inside = (x >= low) & (x < high)
        for k, steps in enumerate(("auto", "half")):
            cells = [
                f"{name} {_summary(*actual[inside, :, k, column].T)}"
                for column, name in enumerate(NAMES)
            ]
            print(f"{low:g} <= x < {high:g}, {steps}: {'; '.join(cells)}", flush=True)


def _summary(error: np.ndarray, bound: np.ndarray) -> str:
    """Say what is kept by relative errors, of which NaN is none, and by their bounds."""
    known = np.isfinite(error)
    if not known.any():
        return "none"
    error, bound = error[known], bound[known]
    middle, most = 100.0 * np.percentile(error, [50, 90])
    return (
        f"{middle:.2g} {most:.2g} ({np.mean(error <= 0.02):.0%} keep 2 %, "
        f"{np.mean(error <= bound):.0%} their bound, of {error.size})"
    )


if __name__ == "__main__":
    print_table(*map(int, sys.argv[1:]))
