"""What a march and a whole case cost, beside other ways to do the same work.

    python -m tests.tools.march_costs     with tamaas where it is installed

Nanoseconds of CPU time of one thread, per step and sample of the line (a nominal element step), and
per sample of the line in a sweep. All ways march from the same state and must agree in mu.
Printed by `make bench` (bench.py).
"""

import contextlib
import time
from collections.abc import Callable, Sequence

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
HEAD = ("march", "dense", "C", "limit", "share", "tamaas")
PARTS = ("sweep", "limit", "share", "case", "C")


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
        compiled, limits = machine()
    print(
        "March: ns per nominal element step; C: every element, vectorised; limit of the same, and"
    )
    print("its share in the time of the march: more than 1 by elements that are not stepped")
    _print_row("H, N, m, x, Fbar, steps", HEAD)
    below = []
    for row in ROWS:
        problem, name = Problem(row), ", ".join(f"{value:g}" for value in row)
        z, found = problem.line.z, {k: 1e9 * s for k, s in marches(problem, compiled).items()}
        parts = {k: 1e3 * s for k, s in cases(problem, compiled).items()}
        sweep = fastest(lambda p=problem, z=z: steady_sliding(p.before, z, p.load))
        parts["sweep"] = 1e9 * sweep / problem.sweeps / z.size
        if limits:
            for values, what, work, arrays in (
                (found, "march", MARCH, 3),
                (parts, "sweep", SWEEP, 2),
            ):
                values["limit"] = 1e9 * limits.seconds(work, 1, arrays * NUMBER * z.size)
                values["share"] = values["limit"] / values[what]
        _print_row(name, [f"{found[k]:.3g}" if k in found else "-" for k in HEAD])
        below.append((name, [f"{parts[k]:.3g}" if k in parts else "-" for k in PARTS]))
    print("\nSweep: ns per sample; whole case (two steady states, jump, march): ms")
    _print_row("H, N, m, x, Fbar, steps", PARTS)
    for each in below:
        _print_row(*each)


def _print_row(name: str, cells: Sequence[str]) -> None:
    print(f"{name:36s}" + "".join(f"{cell:>9s}" for cell in cells))


if __name__ == "__main__":
    march_costs()
