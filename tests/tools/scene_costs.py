"""What scenes cost beside a dense loop in C, and how far both are from what the machine can do.

    python -m tests.tools.scene_costs

All ways march the same elements along the same track, keep the same and must agree in all of it.
Printed are ratios of CPU times of one thread, the least of several taken in turns. Printed by
`make bench` (bench.py).
"""

import contextlib
import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    KELVIN,
    ConstantForce,
    Hold,
    Line,
    Oscillation,
    Ramp,
    SceneCase,
    Slide,
    Spectrum,
    amplitudes,
    draw_phases,
    scene_steps,
)
from elastomer_friction.kernels.branches.steady_memory import steady_memory
from elastomer_friction.kernels.control.indentation import PrescribedIndentation
from elastomer_friction.kernels.motion.track import tracks
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.law import Elements
from elastomer_friction.kernels.scene.begin import begun
from elastomer_friction.kernels.scene.follow import follow
from elastomer_friction.kernels.scene.march_blocks import follow_blocks, in_blocks
from elastomer_friction.kernels.scene.records import Trace
from elastomer_friction.kernels.scene.run import Recorders
from elastomer_friction.kernels.scene.scene_case import indentation_at
from tests.kernels.scene import given
from tests.tools.march_costs import fastest
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.limits import NUMBER, Limits, of_steady

M, SPEED, LOAD = 4, 5.0, 0.05
ELEMENTS, BRANCHES = (50, 500, 5000), (0, 1, 5, 13)
LOADS = (0.001, 0.05, 0.3, 1.0, 3.0, 40.0)  # of steady states
SPEEDS = (0.1, 1.0, 10.0, 100.0, 1000.0)
TURNS = 5
AGREEMENT = 1e-11  # of the largest value
SCENES: dict[str, tuple[tuple, dict]] = {
    "long slide": ((Slide(SPEED, 2000.0),), {}),
    "long slide, nearly full contact": ((Slide(SPEED, 2000.0),), {"load": 100.0 * LOAD}),
    "slide": ((Slide(SPEED, 100.0),), {}),
    "slide, nearly full contact": ((Slide(SPEED, 100.0),), {"load": 100.0 * LOAD}),
    "hold after a slide": ((Slide(SPEED, 5.0), Hold(1e6)), {}),
    "reversal": ((Slide(SPEED, 50.0), Slide(-SPEED, 50.0)), {}),
    "ramp of the velocity": ((Ramp(SPEED, 3.0 * SPEED, 10.0),), {}),
    "oscillation of less than a sample": ((Oscillation(0.0, 0.02, 1.0, 6),), {}),
    "prescribed indentation": ((Slide(SPEED, 100.0),), {"load": math.nan, "indentation": 1.0}),
}


def branches(count: int) -> Spectrum:
    """Return a material of as many branches, over three decades; none: a Kelvin element."""
    if count == 0:
        return KELVIN
    times = np.geomspace(1e-2, 10.0, count) if count > 1 else np.ones(1)
    return Spectrum((1.0,) * count, tuple(times / times.sum()), 0.0)


def a_line(elements: int) -> Line:
    """Return a random line."""
    phases = draw_phases(np.random.default_rng(1), elements)
    return Line.self_affine(amplitudes(0.7, elements), phases, elements, M)


def a_scene(name: str, count: int) -> SceneCase:
    """Return a scene that keeps a trace at 64 moments, from rest."""
    programme, changes = SCENES[name]
    usual: dict[str, Any] = {"load": LOAD, "start": "relaxed"}
    scene = given.a_scene(programme, branches(count), M, **usual | changes)
    return scene._replace(kept=np.linspace(0, scene.kept[-1], 65).astype(np.int64)[1:])


class Marches(NamedTuple):
    """The same scene, marched in three ways."""

    steps: int
    by_blocks: Callable[[], Trace]  # they return it at the kept steps
    all_elements: Callable[[], Trace]
    in_c: Callable[[], Trace]

    @classmethod
    def of(cls, line: Line, scene: SceneCase, compiled: Compiled) -> "Marches":
        """Prepare them: what all have in common is not measured."""
        steps = scene_steps(scene, M)
        form = form_of(scene.spectrum, scene.scheme)
        begin = begun(line, scene, form)
        (track,) = tracks(line.z, line.slope, M, steps, begin.position, begin.time)
        control: ConstantForce | PrescribedIndentation = ConstantForce(scene.load * line.z.size)
        given_d = None
        if scene.indentation is not None:
            given_d = indentation_at(scene, track.time[1:], line.datum)
            control = PrescribedIndentation(given_d)
        ends = np.flatnonzero(np.diff(steps.leg, append=-1)) + 1
        elements = Elements(begin.memory, begin.p, begin.d)

        def recorded(way: Callable, state: object, *more: np.ndarray) -> Trace:
            kept = Recorders(scene, line, steps)
            way(form, control, track, state, 0, *more, *kept.all())
            assert kept.trace
            return kept.trace

        load = 0.0 if scene.indentation is not None else scene.load * line.z.size
        return cls(
            steps.dt.size,
            lambda: recorded(follow_blocks, in_blocks(elements, 0), ends),
            lambda: recorded(follow, elements),
            lambda: compiled.follow(form, track, load, given_d, elements, scene.kept),
        )

    def taken(self) -> list[float]:
        """Return the seconds of each. Raises AssertionError where they differ."""
        expected = self.in_c()
        for way in self[1:3]:
            for name, found, values in zip(Trace._fields, way(), expected, strict=True):
                atol = AGREEMENT * np.abs(values).max()
                np.testing.assert_allclose(found, values, rtol=0.0, atol=atol, err_msg=name)
        turns = [[fastest(way, 0.02) for way in self[1:]] for _ in range(TURNS)]
        return [min(each) for each in zip(*turns, strict=True)]


def ratios(name: str, elements: int, compiled: Compiled, limits: Limits) -> tuple[str, str]:
    """Return C over the march by blocks, and the limit of all elements over C, for all BRANCHES."""
    over, limit, line = [], [], a_line(elements)
    for count in BRANCHES:
        marches = Marches.of(line, a_scene(name, count), compiled)
        blocks, _, dense = marches.taken()
        least = limits.of_scene(line.z.size, max(count, 1)) * marches.steps
        over.append(f"{dense / blocks:.2f}")
        limit.append(f"{least / dense:.2f}")
    return ", ".join(over), ", ".join(limit)


def scene_costs() -> None:
    """Print the table."""
    with contextlib.suppress(FileNotFoundError):
        compiled = Compiled()
        limits = Limits(compiled)
        print(f"\nC that steps every element over the march by blocks, for {BRANCHES} branches\n")
        print("| scene | " + " | ".join(f"N = {elements}" for elements in ELEMENTS) + " |")
        print("|---|" + "---|" * len(ELEMENTS))
        for name in SCENES:
            found = [ratios(name, elements, compiled, limits) for elements in ELEMENTS]
            print(f"| {name} | " + " | ".join(over for over, _ in found) + " |", flush=True)
        print(
            "| limit of bytes and flops over C | " + " | ".join(limit for _, limit in found) + " |"
        )


def steady_costs() -> None:
    """Print what whole steady states cost, in ns a sample, beside their limit in full contact."""
    line = a_line(max(ELEMENTS))
    print(f"\nSteady states, the load given: ns a sample (N = {max(ELEMENTS)}, m = {M}, K = 13)\n")
    print("| Fbar | " + " | ".join(f"v = {speed:g}" for speed in SPEEDS) + " |")
    print("|---|" + "---|" * len(SPEEDS))
    form, samples = form_of(branches(13), "exponential"), line.z.size
    for load in LOADS:
        taken = [
            fastest(lambda v=M * speed, f=load * samples: steady_memory(form, line.z, v, f))
            for speed in SPEEDS
        ]
        print(f"| {load:g} | " + " | ".join(f"{1e9 * t / samples:.0f}" for t in taken) + " |")
    with contextlib.suppress(FileNotFoundError):
        least = Limits(Compiled()).seconds(of_steady(13), samples, NUMBER * 2 * samples)
        print(f"| limit | {1e9 * least / samples:.1f} |")


if __name__ == "__main__":
    scene_costs()
    steady_costs()
