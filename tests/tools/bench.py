"""`make bench`: what effects cost, as ratios measured in one run.

Times are medians of CPU time; compare them with each other, not between machines. What accuracy
costs is the study of that name: `make study-accuracy`.
"""

import statistics
import time
from collections.abc import Callable
from functools import partial

import numpy as np

from kernels import Case, Line, Outcome, Quantities, amplitudes, draw_phases, run_case

ELEMENTS = 2000
LINES = 8
STEPS = 4
POINTS = {  # name: (H, Fbar, x)
    "H = 0.7, x = 17": (0.7, 0.05, 17.0),
    "H = 0.3, x = 50": (0.3, 0.05, 50.0),
    "H = 0.7, x = 1": (0.7, 0.05, 1.0),
}
EFFECTS = {
    "steady states": Quantities(True, False, False),
    "steady states, jump": Quantities(True, True, False),
    "steady states, jump, relaxation": Quantities(),
    "the same, indentation rate dropped": Quantities(indentation_rate=False),
}


def seconds(function: Callable[[], object], repeats: int = 15) -> float:
    """Return the median CPU time of a call, after one that is not counted."""
    function()
    found = []
    for _ in range(repeats):
        began = time.process_time()
        function()
        found.append(time.process_time() - began)
    return statistics.median(found)


def lines(hurst: float) -> list[Line]:
    """Return the lines of a point."""
    amplitude = amplitudes(hurst, ELEMENTS)
    phases = [draw_phases(np.random.default_rng(k), ELEMENTS) for k in range(LINES)]
    return [Line.self_affine(amplitude, p, ELEMENTS, STEPS) for p in phases]


def outcomes(point: str, asked: Quantities, sampled: list[Line]) -> list[Outcome]:
    """Run one point on all lines, recording 16 moments up to 1.5 tau/b."""
    hurst, load, x = POINTS[point]
    span = 1.5 / x ** (1.0 - hurst) * 1.2 * x / np.pi  # in dx
    kept_steps = np.unique(np.ceil(np.linspace(span / 16, span, 16) * STEPS).astype(np.int64))
    case = Case(load, x / np.pi, (1.2,), (kept_steps,), "exponential")
    return [run_case(line, case, asked) for line in sampled]


def effects() -> None:
    """Print what each effect costs: what is not asked for must cost nothing."""
    print(f"What effects cost (m = {STEPS}), relative to everything a relaxation needs")
    for point, (hurst, _, _) in POINTS.items():
        sampled = lines(hurst)
        taken = {
            name: seconds(partial(outcomes, point, asked, sampled))
            for name, asked in EFFECTS.items()
        }
        whole = taken["steady states, jump, relaxation"]
        print(f"\n{point}")
        for name, value in taken.items():
            print(f"  {name:40s}{value / whole:6.2f}")


if __name__ == "__main__":
    effects()
