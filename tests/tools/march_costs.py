"""What a march and a whole case cost, beside other ways to do the same work.

    python -m tests.tools.march_costs     with tamaas where it is installed

Nanoseconds of CPU time of one thread, per step and sample of the line (a nominal element step), and
per sample of the line in a sweep. All ways march from the same state and must agree in mu.
Printed by `make bench` (bench.py).
"""

import contextlib
import time
from collections.abc import Callable

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
from tests.tools.rivals.limits import MARCH, NUMBER, SWEEP, Limits
from tests.tools.rivals.problem import RATIO, ROWS, Problem, Row

LEAST, MOST = 0.2, 7  # seconds for each way, and repeats
AGREEMENT = 1e-8  # of the change of mu in the march
HEAD = ("march", "dense", "C", "limit", "tamaas")
PARTS = ("sweep", "limit", "case", "C")


def fastest(function: Callable[[], object], least: float = LEAST) -> float:
    """Return the least CPU time of a call, after one that is not counted."""
    function()
    taken: list[float] = []
    while len(taken) < MOST and sum(taken) < least:
        began = time.thread_time()
        function()
        taken.append(time.thread_time() - began)
    return min(taken)


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
    found, expected = {}, ways["march"](steps)
    for name, way in ways.items():
        found[name] = fastest(lambda way=way: way(steps)) / (z.size * steps)  # type: ignore[misc]
        mu, scale = way(steps), abs(expected) + AGREEMENT
        assert abs(mu - expected) < AGREEMENT * scale, (name, problem.row, mu, expected)
    with contextlib.suppress(ImportError, ArithmeticError):
        solver = TamaasMarch(p.line, p.row.load)
        dt = 1.0 / (p.row.m * p.speed * RATIO)
        found["tamaas"] = fastest(lambda: solver.advance(1, dt)) / z.size
    return found


def cases(problem: Problem, compiled: Compiled | None) -> dict[str, float]:
    """Return seconds of two steady states, the jump and the march: the program's, and in C.

    The program's for lines that come as in a batch, short ones many at a time.
    """
    p = problem
    case = Case(p.row.load, p.speed, (RATIO,), (p.kept,), "exponential")
    prepared = prepare([case], p.row.m, Quantities())
    lines = [p.line] * lines_at_once(p.line.z.size)
    found = {"case": fastest(lambda: run_prepared(lines, prepared)) / len(lines)}
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

        found["C"] = fastest(in_c)
    return found


def march_costs() -> None:
    """Print the tables."""
    compiled = limits = None
    with contextlib.suppress(FileNotFoundError):
        compiled = Compiled()
        limits = Limits(compiled)
    print(
        "March: ns per nominal element step; C: every element, vectorised; limit: rivals/limits.py"
    )
    print(f"{'H, N, m, x, Fbar, steps':36s}" + "".join(f"{name:>9s}" for name in HEAD))
    below = []
    for row in ROWS:
        problem = Problem(row)
        found = marches(problem, compiled)
        whole = cases(problem, compiled)
        sweep = fastest(lambda p=problem: steady_sliding(p.before, p.line.z, p.load))
        n, least = problem.line.z.size, None
        if limits:
            found["limit"] = limits.seconds(MARCH, 1, 3 * NUMBER * n)
            least = 1e9 * limits.seconds(SWEEP, 1, 2 * NUMBER * n)
        print(f"{_name(row):36s}" + "".join(_number(found.get(name)) for name in HEAD))
        parts = [1e9 * sweep / problem.sweeps / n, least, 1e3 * whole["case"]]
        below.append((row, [*parts, 1e3 * whole["C"] if "C" in whole else None]))
    print("\nSweep: ns per sample; whole case (two steady states, jump, march): ms")
    print(f"{'H, N, m, x, Fbar, steps':36s}" + "".join(f"{name:>9s}" for name in PARTS))
    for row, values in below:
        print(f"{_name(row):36s}" + "".join(_number(value, 1.0) for value in values))


def _name(row: Row) -> str:
    return ", ".join(f"{value:g}" for value in row)


def _number(value: float | None, scale: float = 1e9) -> str:
    return f"{'-':>9s}" if value is None else f"{scale * value:9.3g}"


if __name__ == "__main__":
    march_costs()
