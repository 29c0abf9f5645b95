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

from kernels import (
    KELVIN,
    SCHEMES,
    ConstantForce,
    Hold,
    Line,
    Oscillation,
    Programme,
    Ramp,
    Scene,
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
REPEATS = 5


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


def a_scene(programme: Programme, spectrum: Spectrum, **changes: object) -> Scene:
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
    scene = Scene(**values)
    kept = np.linspace(0, scene_steps(scene, M).dt.size, 65).astype(np.int64)
    return scene._replace(kept=np.unique(kept))


def per_step(line: Line, scene: Scene) -> float:
    """Return the CPU time of a step of a scene, in seconds."""
    return seconds(partial(run_scene, line, scene), REPEATS) / scene_steps(scene, M).dt.size


def by_march(line: Line) -> float:
    """Return the CPU time of a step of the march, as of per_step: a Kelvin element slides on."""
    law = SCHEMES["exponential"](1.0 / (M * SPEED))
    load, steps = LOAD * line.z.size, round(100.0 * M)
    state, _ = steady_sliding(law, line.z, load)
    weight, kept = (
        lagged_slope(line.slope, law.lag),
        np.unique(np.linspace(1, steps, 64, dtype=int)),
    )
    run = partial(march, law, ConstantForce(load), line.z, weight, state, kept, math.inf)
    return seconds(run, REPEATS) / steps


def costs() -> list[tuple[str, str, float]]:
    """Return (effect, what it is compared with, ratio of the CPU times of a step)."""
    line, one = a_line(), branches(1)
    kelvin = per_step(line, a_scene(SLIDE, KELVIN))
    base = per_step(line, a_scene(SLIDE, one))
    held = {"load": math.nan, "indentation": 1.0}
    rows = [("general path", "march, all samples, Kelvin", kelvin / by_march(line))]
    rows += [
        (f"branches, K = {k}", "general path, Kelvin", per_step(line, a_scene(SLIDE, m)) / kelvin)
        for k, m in ((1, one), (5, branches(5)), (13, branches(13)))
    ]
    others = {
        "relaxation form": a_scene(SLIDE, one, scheme="implicit-euler"),
        "hold": a_scene((Slide(SPEED, 5.0), Hold(1e3)), one),
        "reversal": a_scene((Slide(SPEED, 50.0), Slide(-SPEED, 50.0)), one),
        "fractional steps (small oscillation)": a_scene((Oscillation(0.0, 0.1, 1.0, 6),), one),
        "ramp": a_scene((Ramp(SPEED, 3.0 * SPEED, 10.0),), one),
        "prescribed indentation": a_scene(SLIDE, one, **held),
        "energy": a_scene(SLIDE, one, asked=("trace", "energy")),
        "contact lengths": a_scene(SLIDE, one, asked=("trace", "contact_lengths")),
        "no trace": a_scene(SLIDE, one, asked=()),
        "64 snapshots": a_scene(SLIDE, one, asked=("trace", "snapshots"), frames=np.arange(64)),
    }
    rows += [(name, "slide, K = 1", per_step(line, scene) / base) for name, scene in others.items()]
    measured = per_step(a_line(measured=True), a_scene(SLIDE, one))
    return [*rows, ("measured line", "slide, K = 1", measured / base)]


def scene_costs() -> None:
    """Print a table of what every effect of a scene costs."""
    print(f"\nWhat effects of scenes cost, per step (N = {ELEMENTS}, m = {M})\n")
    print("| effect | ratio | to |\n|---|---|---|")
    for effect, other, ratio in costs():
        print(f"| {effect} | {ratio:.2f} | {other} |")
