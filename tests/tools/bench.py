"""`make bench`: what a case costs beside other ways to compute it, and what effects cost.

Times are medians of CPU time; compare them with each other, not between machines. What accuracy
costs is the study of that name: `make study-accuracy`.
"""

from functools import partial

import numpy as np

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from tests.tools.march_costs import march_costs
from tests.tools.scene_costs import scene_costs, seconds

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


def outcomes(lines: list[Line], load: float, x: float, span: float, asked: Quantities) -> None:
    """Run one point on all lines, recording 16 moments over a way of ``span`` (dx)."""
    kept_steps = np.unique(np.ceil(np.linspace(span / 16, span, 16) * STEPS).astype(np.int64))
    case = Case(load, x / np.pi, (1.2,), (kept_steps,), "exponential")
    for line in lines:
        run_case(line, case, asked)


def effects() -> None:
    """Print what each effect costs: what is not asked for must cost nothing."""
    print(f"What effects cost (m = {STEPS}), relative to everything a relaxation needs")
    for point, (hurst, load, x) in POINTS.items():
        amplitude = amplitudes(hurst, ELEMENTS)
        phases = [draw_phases(np.random.default_rng(k), ELEMENTS) for k in range(LINES)]
        lines = [Line.self_affine(amplitude, p, ELEMENTS, STEPS) for p in phases]
        span = 1.5 / x ** (1.0 - hurst) * 1.2 * x / np.pi  # 1.5 tau/b
        run = partial(outcomes, lines, load, x, span)
        taken = {name: seconds(partial(run, asked)) for name, asked in EFFECTS.items()}
        print(f"\n{point}")
        for name, value in taken.items():
            print(f"  {name:40s}{value / taken['steady states, jump, relaxation']:6.2f}")


if __name__ == "__main__":
    march_costs()
    effects()
    scene_costs()
