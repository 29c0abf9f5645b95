"""`make bench`: what a case costs beside other ways to compute it, and what effects cost.

Times are the least CPU times of several; compare them with each other, not between machines. What
accuracy costs is the study of that name: `make study-accuracy`.
"""

import contextlib
import math
from collections.abc import Callable
from functools import partial

import numpy as np

from elastomer_friction.kernels import (
    KELVIN,
    Case,
    Hold,
    Line,
    Oscillation,
    Quantities,
    Ramp,
    SceneCase,
    Slide,
    Spectrum,
    march,
    run_case,
    run_scene,
    scene_steps,
)
from elastomer_friction.kernels.drive import Drive, run_pulled
from tests.tools.contact_costs import contact_costs
from tests.tools.march_costs import fastest, in_turns, march_costs
from tests.tools.narrow_costs import narrow_costs
from tests.tools.rivals.limits import limit_table
from tests.tools.rivals.problem import Problem, Row, a_line
from tests.tools.scene_costs import (
    HURST,
    LOAD,
    SPEED,
    M,
    a_scene,
    branches,
    scene_costs,
    steady_costs,
)
from tests.tools.task_costs import task_costs

OF_SCENES = (HURST, 500, M)
SLIDE = (Slide(SPEED, 100.0),)
MARCHED = round(100.0 * M)  # steps
REPEATS, ONCE = 10, 1e-9  # turns, and seconds that one call fills


def pulled(line: Line, spectrum: Spectrum, stiffness: float) -> tuple[Callable, Callable]:
    """Return a run of a slider on a spring, stiff over load times slope, and one that is moved."""
    start = "steady" if stiffness >= 1.0 else "relaxed"
    scene = a_scene(SLIDE, spectrum, start=start)
    drive = Drive(stiffness * LOAD * math.sqrt(float(np.mean(line.slope**2))))
    return partial(run_pulled, line, scene, drive), partial(run_scene, line, scene)


def drive_costs() -> None:
    """Print what a programme costs where a spring pulls, over the same of a line that is moved."""
    print(f"\nPull over slide (N = {OF_SCENES[1]}, m = {M})\n")
    print("| material | stiff spring, slides through | soft spring, creeps |\n|---|---|---|")
    for name, spectrum in (("Kelvin", KELVIN), ("K = 13", branches(13))):
        ratios = []
        for stiffness in (1.0, 2e-3):
            runs = pulled(a_line(*OF_SCENES), spectrum, stiffness)
            pull, slide = in_turns(runs, REPEATS, ONCE)
            ratios.append(pull / slide)
        print(f"| {name} | {ratios[0]:.2f} | {ratios[1]:.2f} |")


def scenes() -> dict[str, tuple[Line, SceneCase, str]]:
    """Return lines and scenes by the effect that they show, and what they are compared with."""
    line, one = a_line(*OF_SCENES), branches(1)
    kelvin, slide = "general path, Kelvin", "slide, K = 1"
    held = {"load": math.nan, "indentation": 1.0}
    frames = {"requested": ("trace", "snapshots"), "frames": np.arange(64)}
    lengths = {
        "requested": ("trace", "contact_lengths"),
        "edges": np.array([0.0, 1.0, 2.0, 4.0, 8.0, 1000.0]),
    }
    return {
        kelvin: (line, a_scene(SLIDE, KELVIN), "march, all samples"),
        slide: (line, a_scene(SLIDE, one), kelvin),
        "slide, K = 5": (line, a_scene(SLIDE, branches(5)), kelvin),
        "slide, K = 13": (line, a_scene(SLIDE, branches(13)), kelvin),
        "relaxation form": (line, a_scene(SLIDE, one, scheme="implicit-euler"), slide),
        "hold": (line, a_scene((Slide(SPEED, 5.0), Hold(1e6)), one), slide),
        "reversal": (line, a_scene((Slide(SPEED, 50.0), Slide(-SPEED, 50.0)), one), slide),
        "small oscillation": (line, a_scene((Oscillation(0.0, 0.02, 1.0, 6),), one), slide),
        "ramp": (line, a_scene((Ramp(SPEED, 3.0 * SPEED, 10.0),), one), slide),
        "prescribed indentation": (line, a_scene(SLIDE, one, **held), slide),
        "energy": (line, a_scene(SLIDE, one, requested=("trace", "energy")), slide),
        "contact lengths": (line, a_scene(SLIDE, one, **lengths), slide),
        "64 snapshots": (line, a_scene(SLIDE, one, **frames), slide),
        "no trace": (line, a_scene(SLIDE, one, requested=()), slide),
        "measured line": (Line.measured(line.z[::M], M), a_scene(SLIDE, one), slide),
    }


def effects_of_scenes() -> None:
    """Print what a step of every scene costs, over the scene it is compared with.

    Each is the least of several times, taken in turns.
    """
    compared, p = scenes(), Problem(Row(*OF_SCENES, math.pi * SPEED, LOAD, MARCHED))
    runs: dict[str, Callable[[], object]] = {
        name: partial(run_scene, line, scene) for name, (line, scene, _) in compared.items()
    }
    steps = {name: scene_steps(scene, M).dt.size for name, (_, scene, _) in compared.items()}
    # What corresponds: a Kelvin element slides on, no sample is left out.
    every, kept = "march, all samples", np.unique(np.linspace(1, MARCHED, 64, dtype=int))
    runs[every] = partial(march, p.law, p.control, p.line.z, p.weight, p.one, kept, math.inf)
    steps[every] = MARCHED
    times = in_turns(runs.values(), REPEATS, ONCE)
    taken = {name: s / steps[name] for name, s in zip(runs, times, strict=True)}
    print(f"\nWhat a step of a scene costs (N = {OF_SCENES[1]}, m = {M})\n")
    print("| effect | ratio | to |\n|---|---|---|")
    for name, (_, _, other) in compared.items():
        print(f"| {name} | {taken[name] / taken[other]:.2f} | {other} |")


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
    print(f"\nWhat effects cost (m = {STEPS}), relative to everything a relaxation needs")
    for point, (hurst, load, x) in POINTS.items():
        lines = [a_line(hurst, ELEMENTS, STEPS, seed) for seed in range(LINES)]
        span = 1.5 / x ** (1.0 - hurst) * 1.2 * x / np.pi  # 1.5 tau/b
        run = partial(outcomes, lines, load, x, span)
        taken = {name: fastest(partial(run, asked)) for name, asked in EFFECTS.items()}
        print(f"\n{point}")
        for name, value in taken.items():
            print(f"  {name:40s}{value / taken['steady states, jump, relaxation']:6.2f}")


if __name__ == "__main__":
    with contextlib.suppress(FileNotFoundError):
        limit_table()
    march_costs()
    narrow_costs()
    scene_costs()
    steady_costs()
    contact_costs()
    task_costs()
    effects()
    effects_of_scenes()
    drive_costs()
