"""`make bench`: what accuracy and effects cost, as ratios measured in one run.

Times are medians of CPU time; compare them with each other, not between machines.
"""

import statistics
import time
from collections.abc import Callable
from functools import partial

import numpy as np

from kernels import Case, Line, Outcome, Quantities, amplitudes, draw_phases, run_case

ELEMENTS = 2000
LINES = 8
POINTS = {  # name: (H, Fbar, x)
    "H = 0.7, x = 17": (0.7, 0.05, 17.0),
    "H = 0.3, x = 50": (0.3, 0.05, 50.0),
    "H = 0.7, x = 1": (0.7, 0.05, 1.0),
}
FINEST = 64
STEPS = (1, 2, 4, 8, 16)
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


def lines(hurst: float, steps: int) -> list[Line]:
    """Return the same lines for every number of steps per spacing."""
    amplitude = amplitudes(hurst, ELEMENTS)
    phases = [draw_phases(np.random.default_rng(k), ELEMENTS) for k in range(LINES)]
    return [Line.self_affine(amplitude, p, ELEMENTS, steps) for p in phases]


def outcomes(
    point: str, scheme: str, steps: int, asked: Quantities, sampled: list[Line]
) -> list[Outcome]:
    """Run one point on all lines, recording 16 moments up to 1.5 tau/b."""
    hurst, load, x = POINTS[point]
    span = 1.5 / x ** (1.0 - hurst) * 1.2 * x / np.pi  # in dx
    record = np.unique(np.ceil(np.linspace(span / 16, span, 16) * steps).astype(np.int64))
    case = Case(load, x / np.pi, (1.2,), (record,), scheme)
    return [run_case(line, case, asked) for line in sampled]


def accuracy() -> None:
    """Print the error of mu_1 and of the jump, averaged over lines, against the time taken."""
    print("\nWhat accuracy costs: rms error over lines, relative to m = 64 exponential")
    for point, (hurst, _, _) in POINTS.items():
        fine = outcomes(point, "exponential", FINEST, Quantities(), lines(hurst, FINEST))
        print(f"\n{point:24s}{'m':>4s}{'mu_1':>10s}{'jump':>10s}{'time / m=4':>12s}")
        for scheme in ("exponential", "implicit-euler"):
            base = 0.0
            for steps in (4, *STEPS):  # m = 4 first: the unit of time
                sampled = lines(hurst, steps)
                taken = seconds(partial(outcomes, point, scheme, steps, Quantities(), sampled))
                if not base:
                    base = taken
                    continue
                found = outcomes(point, scheme, steps, Quantities(), sampled)
                mu = rms([a.mu_1 / b.mu_1 - 1.0 for a, b in zip(found, fine, strict=True)])
                jump = rms([a.jump[0] / b.jump[0] - 1.0 for a, b in zip(found, fine, strict=True)])
                print(f"{scheme:24s}{steps:4d}{mu:10.1e}{jump:10.1e}{taken / base:12.2f}")


def rms(values: list[float]) -> float:
    """Return the root mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def effects() -> None:
    """Print what each effect costs: what is not asked for must cost nothing."""
    print("\nWhat effects cost (m = 4), relative to everything a relaxation needs")
    for point, (hurst, _, _) in POINTS.items():
        sampled = lines(hurst, 4)
        taken = {
            name: seconds(partial(outcomes, point, "exponential", 4, asked, sampled))
            for name, asked in EFFECTS.items()
        }
        whole = taken["steady states, jump, relaxation"]
        print(f"\n{point}")
        for name, value in taken.items():
            print(f"  {name:40s}{value / whole:6.2f}")


if __name__ == "__main__":
    accuracy()
    effects()
