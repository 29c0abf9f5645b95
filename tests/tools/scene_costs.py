"""What scenes cost beside a dense loop in C, and how far both are from what the machine can do.

    python -m tests.tools.scene_costs

Both ways march the same elements along the same track, keep the same and must agree in all of it.
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
    Programme,
    Ramp,
    SceneCase,
    Slide,
    Spectrum,
    scene_steps,
)
from elastomer_friction.kernels.branches.steady_memory import steady_memory
from elastomer_friction.kernels.control.indentation import PrescribedIndentation
from elastomer_friction.kernels.motion.track import tracks
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.law import Elements
from elastomer_friction.kernels.scene.initial_state import initial_state
from elastomer_friction.kernels.scene.march_blocks import in_blocks, march_blocks
from elastomer_friction.kernels.scene.records import Trace
from elastomer_friction.kernels.scene.run import Recorders
from elastomer_friction.kernels.scene.scene_case import indentation_at
from tests.kernels.scene import given
from tests.tools.march_costs import fastest, in_turns
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.limits import NUMBER, PASSES, Limits, machine, of_scene, of_steady
from tests.tools.rivals.problem import a_line

HURST, M, SPEED, LOAD = 0.7, 4, 5.0, 0.05
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


def a_scene(programme: Programme, spectrum: Spectrum, **changes: Any) -> SceneCase:
    """Return a scene that keeps a trace at 64 moments or fewer, from rest."""
    usual: dict[str, Any] = {"load": LOAD, "start": "relaxed"}
    scene = given.a_scene(programme, spectrum, M, **usual | changes)
    return scene._replace(
        recorded=np.unique(np.linspace(0, scene.recorded[-1], 65).astype(np.int64))[1:]
    )


class Marches(NamedTuple):
    """The same scene, marched in two ways."""

    steps: int
    by_blocks: Callable[[], Trace]  # they return it at the kept steps
    in_c: Callable[[], Trace]

    @classmethod
    def of(cls, line: Line, scene: SceneCase, compiled: Compiled) -> "Marches":
        """Prepare them: what all have in common is not measured."""
        steps = scene_steps(scene, M)
        form = form_of(scene.spectrum, scene.scheme)
        begin = initial_state(line, scene, form)
        (track,) = tracks(line.z, line.slope, M, steps, begin.position, begin.time)
        control: ConstantForce | PrescribedIndentation = ConstantForce(scene.load * line.z.size)
        given_d = None
        if scene.indentation is not None:
            given_d = indentation_at(scene, track.time[1:], line.datum)
            control = PrescribedIndentation(given_d)
        ends = np.flatnonzero(np.diff(steps.leg, append=-1)) + 1
        elements = Elements(begin.memory, begin.p, begin.d)

        def by_blocks() -> Trace:
            kept = Recorders(scene, line, steps)
            march_blocks(form, control, track, in_blocks(elements, 0), 0, ends, *kept.arguments())
            assert kept.trace
            return kept.trace

        load = 0.0 if scene.indentation is not None else scene.load * line.z.size
        return cls(
            steps.dt.size,
            by_blocks,
            lambda: compiled.follow(form, track, load, given_d, elements, scene.recorded),
        )

    def taken(self) -> list[float]:
        """Return the seconds of each. Raises AssertionError where they differ."""
        for name, actual, values in zip(Trace._fields, self.by_blocks(), self.in_c(), strict=True):
            atol = AGREEMENT * np.abs(values).max()
            np.testing.assert_allclose(actual, values, rtol=0.0, atol=atol, err_msg=name)
        return in_turns(self[1:], TURNS, 0.02)


def ratios(name: str, elements: int, compiled: Compiled, limits: Limits) -> str:
    """Return C and the limit of all elements over the march by blocks, for all BRANCHES."""
    over, share, line = [], [], a_line(HURST, elements, M)
    programme, changes = SCENES[name]
    for count in BRANCHES:
        scene = a_scene(programme, branches(count), **changes)
        marches = Marches.of(line, scene, compiled)
        blocks, dense = marches.taken()
        units, n = max(count, 1), line.z.size
        work = of_scene(units, PASSES if scene.indentation is None else 0)
        least = limits.seconds(work, n * marches.steps, NUMBER * n * (units + 4))
        over.append(f"{dense / blocks:.2f}")
        share.append(f"{least / blocks:.2f}")
    return f"{', '.join(over)}: {', '.join(share)}"


def scene_costs() -> None:
    """Print the table."""
    with contextlib.suppress(FileNotFoundError):
        rivals = machine()
        print(
            f"\nC that steps every element over the march by blocks, for {BRANCHES} branches: the"
        )
        print("share of the limit of every element in the march\n")
        print("| scene | " + " | ".join(f"N = {elements}" for elements in ELEMENTS) + " |")
        print("|---|" + "---|" * len(ELEMENTS))
        for name in SCENES:
            actual = [ratios(name, elements, *rivals) for elements in ELEMENTS]
            print(f"| {name} | " + " | ".join(actual) + " |", flush=True)


def steady_costs() -> None:
    """Print what whole steady states cost, in ns a sample, beside their limit in full contact."""
    line = a_line(HURST, max(ELEMENTS), M)
    form, n, least = form_of(branches(13), "exponential"), line.z.size, math.nan
    with contextlib.suppress(FileNotFoundError):
        least = machine()[1].seconds(of_steady(13), n, NUMBER * 2 * n)
    print(
        f"\nSteady states, the load given: ns a sample (N = {max(ELEMENTS)}, m = {M}, K = 13), and"
    )
    print(f"the share of the limit in full contact, {1e9 * least / n:.2g} ns\n")
    print("| Fbar | " + " | ".join(f"v = {speed:g}" for speed in SPEEDS) + " |")
    print("|---|" + "---|" * len(SPEEDS))
    for load in LOADS:
        taken = [
            fastest(lambda v=M * speed, f=load * n: steady_memory(form, line.z, v, f))
            for speed in SPEEDS
        ]
        cells = (f"{1e9 * t / n:.0f}: {least / t:.3f}" for t in taken)
        print(f"| {load:g} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    scene_costs()
    steady_costs()
