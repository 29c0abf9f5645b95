"""What a march and a whole case cost, beside other ways to do the same work.

    python -m tests.tools.march_costs     with tamaas where it is installed

Nanoseconds of CPU time of one thread, per step and sample of the line (a nominal element step), and
per sample of the line in a sweep. All ways march from the same state and must agree in mu.
Printed by `make bench` (bench.py).
"""

import contextlib
import time
from collections.abc import Callable, Iterable

import numpy as np

from elastomer_friction.kernels import (
    Case,
    Quantities,
    march,
    prepare,
    run_prepared,
    steady_sliding,
)
from elastomer_friction.kernels.quick.march.active import active_march
from elastomer_friction.studies.accuracy.alternatives import TamaasMarch
from elastomer_friction.workflow.simulate.realizations import lines_at_once
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.limits import MARCH, NUMBER, SWEEP, machine
from tests.tools.rivals.problem import RATIO, ROWS, Problem

LEAST, MOST = 0.2, 7  # seconds for each way, and repeats
AGREEMENT = 1e-8  # of the change of mu in the march
COLUMNS = ("march", "dense", "C", "limit of a step", "share of it", "tamaas")
COLUMNS += ("sweep", "limit of a sweep", "share of one", "case", "case in C")


def fastest(function: Callable[[], object], least: float = LEAST) -> float:
    """Return the least CPU time of a call, after one that is not counted."""
    function()
    taken: list[float] = []
    while len(taken) < MOST and sum(taken) < least:
        began = time.thread_time()
        function()
        taken.append(time.thread_time() - began)
    return min(taken)


def in_turns(runs: Iterable[Callable[[], object]], turns: int, least: float) -> list[float]:
    """Return the least CPU times of some calls, taken in turns."""
    taken = [[fastest(run, least) for run in runs] for _ in range(turns)]
    return [min(each) for each in zip(*taken, strict=True)]


def marches(problem: Problem, compiled: Compiled | None) -> dict[str, float]:
    """Return seconds per nominal element step of each way. Raises AssertionError: they differ."""
    p, z, weight, steps = problem, problem.line.z, problem.weight, problem.row.steps
    (w, d), law = p.one, p.law
    cap = 1.02 * max(p.one.d, p.two.d)
    ways: dict[str, Callable[[int], float]] = {
        "march": lambda n: active_march(p.setting, p.control, np.array([n]))[0][-1],
        "dense": lambda n: march(law, p.control, z, weight, p.one, np.array([n]), cap)[0][-1],
    }
    if compiled:
        ways["C"] = lambda n: compiled.march(z, weight, w, d, law.decay, law.stiffness, p.load, n)[
            -1
        ]
    actual, expected = {}, ways["march"](steps)
    for name, way in ways.items():
        actual[name] = fastest(lambda way=way: way(steps)) / (z.size * steps)  # type: ignore[misc]
        mu, scale = way(steps), abs(expected) + AGREEMENT
        assert abs(mu - expected) < AGREEMENT * scale, (name, problem.row, mu, expected)
    with contextlib.suppress(ImportError, ArithmeticError):
        solver = TamaasMarch(p.line, p.row.load)
        dt = 1.0 / (p.row.m * p.speed * RATIO)
        actual["tamaas"] = fastest(lambda: solver.advance(1, dt)) / z.size
    return actual


def cases(problem: Problem, compiled: Compiled | None) -> dict[str, float]:
    """Return seconds of two steady states, the jump and the march: the program's, and in C.

    The program's for lines that come as in a batch, short ones many at a time.
    """
    p = problem
    case = Case(p.row.load, p.speed, (RATIO,), (p.kept,), "exponential")
    prepared = prepare([case], p.row.m, Quantities())
    lines = [p.line] * lines_at_once(p.line.z.size)
    actual = {"case": fastest(lambda: run_prepared(lines, prepared)) / len(lines)}
    if compiled:

        def in_c() -> None:
            ends = []
            for law, speed in ((p.before, p.speed), (p.law, p.speed * RATIO)):
                w, d = compiled.steady(p.line.z, law.decay, law.stiffness, p.load)
                compiled.friction(p.line.z, p.line.slope, w, d, speed, p.load)
                ends.append((w, d))
            w, d = ends[0]
            compiled.friction(p.line.z, p.line.slope, w, d, p.speed * RATIO, p.load)
            law = p.law
            compiled.march(p.line.z, p.weight, w, d, law.decay, law.stiffness, p.load, p.row.steps)

        actual["case in C"] = fastest(in_c)
    return actual


def march_costs() -> None:
    """Print the table."""
    compiled = limits = None
    with contextlib.suppress(FileNotFoundError):
        compiled, limits = machine()
    print(
        "\nns per nominal element step of this march, of one of all samples that can touch (dense),"
    )
    print("and of all elements (C, tamaas), whose limit and its share in this march follow; ns per")
    print("sample of a sweep; ms of a whole case: two steady states, jump and march\n")
    print("| H, N, m, x, Fbar, steps | " + " | ".join(COLUMNS) + " |")
    print("|---|" + "---|" * len(COLUMNS))
    for row in ROWS:
        problem = Problem(row)
        z, actual = problem.line.z, {k: 1e9 * s for k, s in marches(problem, compiled).items()}
        actual |= {k: 1e3 * s for k, s in cases(problem, compiled).items()}
        sweep = fastest(lambda p=problem, z=z: steady_sliding(p.before, z, p.load))
        actual["sweep"] = 1e9 * sweep / problem.sweeps / z.size
        if limits:
            step = actual["limit of a step"] = 1e9 * limits.seconds(MARCH, 1, 3 * NUMBER * z.size)
            least = actual["limit of a sweep"] = 1e9 * limits.seconds(SWEEP, 1, 2 * NUMBER * z.size)
            actual["share of it"] = step / actual["march"]
            actual["share of one"] = least / actual["sweep"]
        cells = (f"{actual[name]:.3g}" if name in actual else "" for name in COLUMNS)
        print(f"| {', '.join(f'{value:g}' for value in row)} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    march_costs()
