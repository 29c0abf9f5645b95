"""Rows of `make bench`: the program compared with C that steps every element, and with tamaas.

Results are compared before both programs are timed in turns. A ratio is the CPU time of the other
program over the time of this one, so this one is faster if the ratio exceeds 1.
"""

import contextlib
import math
import time
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    KELVIN,
    SCHEMES,
    Case,
    Hold,
    Line,
    Programme,
    Quantities,
    SceneCase,
    Slide,
    Spectrum,
    lagged_slope,
    prepare,
    run_case,
    run_prepared,
    run_scene,
    scene_steps,
)
from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.half_space.waves import half_space_stiffness
from elastomer_friction.kernels.motion.track import tracks
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.law import Elements
from elastomer_friction.kernels.scene.initial_state import initial_state
from elastomer_friction.kernels.scene.records import TRACES
from elastomer_friction.studies.stability.probe import random_line
from elastomer_friction.workflow.simulate.realizations import lines_at_once
from tests.kernels.scene import given
from tests.tools.rivals.compiled import Compiled

MIN_SECONDS, MAX_REPEATS = 0.1, 7  # calls of a measurement are repeated up to either limit
TURNS = 3
RATIO = 1.2  # v2 / v1


class Row(NamedTuple):
    """A velocity step, with a march of four relaxation times or more."""

    hurst: float
    elements: int
    m: int  # steps per spacing
    x: float  # v1 tau q_max = pi vbar
    load: float  # Fbar
    steps: int


ROWS = (
    Row(0.7, 1000, 4, 0.09, 1e-3, 8),
    Row(0.7, 5000, 4, 78.0, 0.025, 130),
    Row(1.0, 5000, 4, 31.0, 1.0, 192),
    Row(1.0, 20000, 4, 94.0, 1.0, 576),
    Row(0.7, 300, 64, 0.09, 0.1, 10),
    Row(0.7, 300, 1, 9.4, 0.1, 8),
    Row(0.5, 5000, 64, 0.09, 1e-3, 10),
)

HURST, M, SPEED, LOAD = 0.7, 4, 5.0, 0.05  # parameters of scenes
SCENES: dict[str, tuple[Programme, float]] = {  # name: programme, load
    "slide of 8000 steps": ((Slide(SPEED, 2000.0),), LOAD),
    "slide of 400 steps": ((Slide(SPEED, 100.0),), LOAD),
    "the same, nearly full contact": ((Slide(SPEED, 100.0),), 100.0 * LOAD),
    "157 steps, mostly of a hold": ((Slide(SPEED, 5.0), Hold(1e6)), LOAD),
}
ELEMENTS, BRANCHES = (50, 500, 5000), (0, 13)

MAP_ELEMENTS, MAP_LOAD = (32, 64), 0.05  # elements of a side; pressure over E* times rms slope
TOLERANCES = (5e-9, 1e-8)  # of the program and of tamaas, which give equal errors of pressures


def fastest(function: Callable[[], object], least: float = MIN_SECONDS) -> float:
    """Return the smallest CPU time of a call, after a first call that is not timed."""
    function()
    seconds: list[float] = []
    while len(seconds) < MAX_REPEATS and sum(seconds) < least:
        began = time.thread_time()
        function()
        seconds.append(time.thread_time() - began)
    return min(seconds)


def in_turns(runs: Iterable[Callable[[], object]], turns: int, least: float) -> list[float]:
    """Return the smallest CPU times of some calls, measured in turns."""
    times = [[fastest(run, least) for run in runs] for _ in range(turns)]
    return [min(of_run) for of_run in zip(*times, strict=True)]


def branches(count: int) -> Spectrum:
    """Return a material of ``count`` branches over three decades; for 0 a Kelvin element."""
    if count == 0:
        return KELVIN
    times = np.geomspace(1e-2, 10.0, count) if count > 1 else np.ones(1)
    return Spectrum((1.0,) * count, tuple(times / times.sum()), 0.0)


def a_scene(programme: Programme, spectrum: Spectrum, **changes: Any) -> SceneCase:
    """Return a scene from rest that records a trace at up to 64 times."""
    usual: dict[str, Any] = {"load": LOAD, "start": "relaxed"}
    scene = given.a_scene(programme, spectrum, M, **usual | changes)
    recorded = np.linspace(0, scene.recorded[-1], 65).astype(np.int64)
    return scene._replace(recorded=np.unique(recorded)[1:])


def step_in_c(compiled: Compiled, line: Line, case: Case, steps: int) -> np.ndarray:
    """Return mu of each step after a velocity step: two steady states, the jump and the march."""
    load, m, speeds = case.load * line.z.size, line.steps_per_spacing, (1.0, RATIO)
    states = []
    for speed in (case.speed * ratio for ratio in speeds):
        law = SCHEMES[case.scheme](1.0 / (m * speed))
        w, d = compiled.steady(line.z, law.decay, law.stiffness, load)
        compiled.friction(line.z, line.slope, w, d, speed, load)
        states.append((w, d))
    compiled.friction(line.z, line.slope, *states[0], RATIO * case.speed, load)
    weight = lagged_slope(line.slope, law.lag)
    return compiled.march(line.z, weight, *states[0], law.decay, law.stiffness, load, steps)


def print_velocity_steps(compiled: Compiled) -> None:
    """Print the times of velocity steps; short lines are run together as in a batch."""
    print("\nTwo steady states, the jump and the march: ms, and those of C over it\n")
    print("| H, N, m, x, Fbar, steps | ms | C |\n|---|---|---|")
    for row in ROWS:
        line = random_line(row.hurst, row.elements, row.m, 1, 0)
        recorded = np.array([1, row.steps])
        case = Case(row.load, row.x / math.pi, (RATIO,), (recorded,), "exponential")
        as_sampled = run_case(line, case._replace(refine=False), Quantities())
        in_c = step_in_c(compiled, line, case, row.steps)
        # Curves end towards the steady friction between samples, so compare their changes.
        change = in_c[recorded[1:] - 1] - in_c[0]
        np.testing.assert_allclose(np.diff(as_sampled.curves[0]), change, 1e-7, 1e-9 * in_c[0])
        prepared = prepare([case], row.m, Quantities())
        lines = [line] * lines_at_once(line.z.size)
        ways = (
            lambda lines=lines, prepared=prepared: run_prepared(lines, prepared),
            lambda line=line, case=case, row=row: step_in_c(compiled, line, case, row.steps),
        )
        seconds, other = in_turns(ways, TURNS, MIN_SECONDS)
        per_line = seconds / len(lines)
        print(
            f"| {', '.join(f'{value:g}' for value in row)} | {1e3 * per_line:.3g} | "
            f"{other / per_line:.2f} |",
            flush=True,
        )


def scene_in_c(compiled: Compiled, line: Line, scene: SceneCase) -> dict[str, np.ndarray]:
    """Return the traces of a scene, computed in C except for initial state and track."""
    steps = scene_steps(scene, M)
    form = form_of(scene.spectrum, scene.scheme)
    begin = initial_state(line, scene, form)
    (track,) = tracks(line.z, line.slope, M, steps, begin.position, begin.time)
    elements = Elements(begin.memory, begin.p, begin.d)
    load = scene.load * line.z.size
    trace = compiled.follow(form, track, load, elements, scene.recorded)
    return dict(zip(TRACES, trace, strict=True))


def scene_ratio(compiled: Compiled, line: Line, scene: SceneCase) -> float:
    """Return the time of a scene in C over that of the program."""
    actual, expected = run_scene(line, scene), scene_in_c(compiled, line, scene)
    expected["trace_indentation"] = expected["trace_indentation"] + line.datum
    for name, values in expected.items():
        atol = 1e-11 * np.abs(values).max()
        np.testing.assert_allclose(actual[name], values, rtol=0.0, atol=atol, err_msg=name)
    ways = (lambda: run_scene(line, scene), lambda: scene_in_c(compiled, line, scene))
    seconds, other = in_turns(ways, TURNS, 0.02)
    return other / seconds


def print_scenes(compiled: Compiled) -> None:
    """Print the times of scenes in C that steps every element, over those of the program."""
    print(f"\nScenes: C over the program, for {' and '.join(map(str, BRANCHES))} branches\n")
    print("| scene | " + " | ".join(f"N = {elements}" for elements in ELEMENTS) + " |")
    print("|---|" + "---|" * len(ELEMENTS))
    for name, (programme, load) in SCENES.items():
        cells = []
        for elements in ELEMENTS:
            line = random_line(HURST, elements, M, 1, 0)
            scenes = (a_scene(programme, branches(count), load=load) for count in BRANCHES)
            cells.append(", ".join(f"{scene_ratio(compiled, line, one):.2f}" for one in scenes))
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def by_tamaas(surface: Surface, elements: int, pressure: float) -> Callable[[], np.ndarray]:
    """Return a solver of an elastic contact. Raises ImportError if tamaas is not installed."""
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    shape = surface.z.shape
    side = [float(elements)] * 2
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, side, list(shape))
    model.nu, model.E = 0.0, 1.0
    solver = tamaas.PolonskyKeerRey(model, -surface.z, TOLERANCES[1])

    def solve() -> np.ndarray:
        model.traction[:] = 0.0
        model.displacement[:] = 0.0
        solver.solve(pressure)
        return np.array(model.traction).reshape(shape)

    return solve


def print_contacts() -> None:
    """Print the times of an elastic contact of a map from a cold start, and those of tamaas."""
    print(
        "\nContact of a half-space: samples; s; tamaas over it; errors of the pressures, relative"
    )
    for elements in MAP_ELEMENTS:
        amplitudes = ring_amplitudes(HURST, elements)
        pressure = MAP_LOAD * rms_slope_of(amplitudes, elements)
        surface = Surface.drawn(np.random.default_rng(1), amplitudes, elements, M)
        z = surface.z
        operator = Operator.of(half_space_stiffness(z.shape, M), z.shape[1])
        exact = press(z, pressure, operator, None, 1e-12).p
        ways = [lambda z=z, p=pressure, o=operator: press(z, p, o, None, TOLERANCES[0]).p]
        with contextlib.suppress(ImportError):
            ways.append(by_tamaas(surface, elements, pressure))
        seconds = in_turns(ways, TURNS, MIN_SECONDS)
        errors = (np.abs(way() - exact).max() / exact.max() for way in ways)
        ratio = f"{seconds[1] / seconds[0]:.1f}" if len(ways) == 2 else "not installed"
        print(elements * M, f"{seconds[0]:.4f}", ratio, *(f"{e:.0e}" for e in errors), sep="; ")
