"""What effects of a scene cost: CPU time of each, over a scene like it without the effect.

Printed by `make bench` (bench.py).
"""

import math
import statistics
import time
import timeit
from collections.abc import Callable
from functools import partial

import numpy as np

from elastomer_friction.kernels import (
    KELVIN,
    SCHEMES,
    ConstantForce,
    Hold,
    Line,
    Oscillation,
    Programme,
    Ramp,
    SceneCase,
    Slide,
    Spectrum,
    amplitudes,
    draw_phases,
    lagged_slope,
    march,
    run_scene,
    scene_steps,
    steady_sliding,
)

ELEMENTS, M, LOAD, SPEED = 500, 4, 0.05, 5.0
SLIDE = (Slide(SPEED, 100.0),)
MARCHED = round(100.0 * M)  # steps
REPEATS = 10


def seconds(function: Callable[[], object], repeats: int = 15) -> float:
    """Return the median CPU time of a call, after one that is not counted."""
    clock = timeit.Timer(function, timer=time.process_time)
    return statistics.median(clock.repeat(repeats + 1, number=1)[1:])


def branches(count: int) -> Spectrum:
    """Return a material of as many branches, over three decades or as long."""
    times = np.geomspace(1e-2, 10.0, count) if count > 1 else np.ones(1)
    return Spectrum((1.0,) * count, tuple(times / times.sum()), 0.0)


def a_line(measured: bool = False) -> Line:
    """Return a random line, or the same heights taken as measured."""
    phases = draw_phases(np.random.default_rng(1), ELEMENTS)
    line = Line.self_affine(amplitudes(0.7, ELEMENTS), phases, ELEMENTS, M)
    return Line.measured(line.z[::M], M) if measured else line


def a_scene(programme: Programme, spectrum: Spectrum, **changes: object) -> SceneCase:
    """Return a scene that keeps a trace at 64 moments, from rest."""
    values: dict = {
        "spectrum": spectrum,
        "scheme": "exponential",
        "programme": programme,
        "load": LOAD,
        "indentation": None,
        "start": "relaxed",
        "asked": ("trace",),
        "kept": np.arange(1),
        "edges": np.array([0.0, 1.0, 2.0, 4.0, 8.0, 1000.0]),
        "frames": np.arange(0),
    } | changes
    scene = SceneCase(**values)
    kept = np.linspace(0, scene_steps(scene, M).dt.size, 65).astype(np.int64)
    return scene._replace(kept=np.unique(kept))


def scenes() -> dict[str, tuple[Line, SceneCase, str]]:
    """Return lines and scenes by the effect that they show, and what they are compared with."""
    line, one = a_line(), branches(1)
    kelvin, slide = "general path, Kelvin", "slide, K = 1"
    held = {"load": math.nan, "indentation": 1.0}
    frames = {"asked": ("trace", "snapshots"), "frames": np.arange(64)}
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
        "energy": (line, a_scene(SLIDE, one, asked=("trace", "energy")), slide),
        "contact lengths": (line, a_scene(SLIDE, one, asked=("trace", "contact_lengths")), slide),
        "64 snapshots": (line, a_scene(SLIDE, one, **frames), slide),
        "no trace": (line, a_scene(SLIDE, one, asked=()), slide),
        "measured line": (a_line(measured=True), a_scene(SLIDE, one), slide),
    }


def marching(line: Line) -> Callable[[], object]:
    """Return the march that corresponds: a Kelvin element slides on, no sample is left out."""
    law = SCHEMES["exponential"](1.0 / (M * SPEED))
    load = LOAD * line.z.size
    state, _ = steady_sliding(law, line.z, load)
    weight = lagged_slope(line.slope, law.lag)
    kept = np.unique(np.linspace(1, MARCHED, 64, dtype=int))
    return partial(march, law, ConstantForce(load), line.z, weight, state, kept, math.inf)


def scene_costs() -> None:
    """Print what a step of every scene costs, over the scene it is compared with.

    Each is the least of several times, taken in turns.
    """
    compared = scenes()
    steps = {name: scene_steps(scene, M).dt.size for name, (_, scene, _) in compared.items()}
    runs: dict[str, Callable[[], object]] = {
        name: partial(run_scene, line, scene) for name, (line, scene, _) in compared.items()
    }
    runs["march, all samples"], steps["march, all samples"] = marching(a_line()), MARCHED
    taken = dict.fromkeys(runs, math.inf)
    for _ in range(REPEATS):
        for name, run in runs.items():
            taken[name] = min(taken[name], seconds(run, 1) / steps[name])
    print(f"\nWhat a step of a scene costs (N = {ELEMENTS}, m = {M})\n")
    print("| effect | ratio | to |\n|---|---|---|")
    for name, (_, _, other) in compared.items():
        print(f"| {name} | {taken[name] / taken[other]:.2f} | {other} |")
