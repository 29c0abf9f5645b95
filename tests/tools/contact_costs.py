"""What an elastic contact of a half-space costs, beside tamaas where it is installed.

    python -m tests.tools.contact_costs

Seconds of CPU time from a cold start, and the largest error of the pressures relative to their
peak, against a solution that is much more exact: ours is as exact as that of tamaas, or more.
Then the passes of the operator that a step of a march takes in the median. Printed by `make bench`
(bench.py).
"""

import contextlib
import time
from collections.abc import Callable

import numpy as np

from elastomer_friction.kernels.half_space.body import HalfSpace, step_tolerance, take_step
from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.sliding_body import slide_steadily
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.half_space.waves import half_space_stiffness
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.spectrum import KELVIN

M, LOAD, OURS, THEIRS = 4, 0.05, 5e-9, 1e-8  # load: of E* times the rms slope; tolerances
SPEEDS, STEPS = (1.0, 3.0, 10.0), 20  # v tau q_max, and steps after a velocity step


def fastest(function: Callable[[], np.ndarray], repeats: int) -> tuple[float, np.ndarray]:
    """Return the least CPU time of a call, and what it returns."""
    taken = []
    for _ in range(repeats):
        began = time.thread_time()
        found = function()
        taken.append(time.thread_time() - began)
    return min(taken), found


def by_tamaas(surface: Surface, elements: int, pressure: float) -> Callable[[], np.ndarray]:
    """Return how tamaas finds the pressures. Raises ImportError where it is not installed."""
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    shape = surface.z.shape
    side = [float(elements)] * 2
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, side, list(shape))
    model.nu, model.E = 0.0, 1.0
    solver = tamaas.PolonskyKeerRey(model, -surface.z, THEIRS)

    def solve() -> np.ndarray:
        model.traction[:] = 0.0
        model.displacement[:] = 0.0
        solver.solve(pressure)
        return np.array(model.traction).reshape(shape)

    return solve


def contact_costs() -> None:
    """Print all of it."""
    print("contact of a half-space: samples, s and error, s and error of tamaas, ratio")
    for elements in (32, 64, 128):
        amplitudes = ring_amplitudes(0.7, elements)
        slope = rms_slope_of(amplitudes, elements)
        surface = Surface.drawn(np.random.default_rng(1), amplitudes, elements, M)
        stiffness, pressure = half_space_stiffness(surface.z.shape, M), LOAD * slope
        n = surface.z.shape[1]
        exact = press(surface.z, pressure, Operator.of(stiffness, n), None, 1e-12).p
        ways = [
            lambda s=surface, k=stiffness, p=pressure, n=n: (
                press(s.z, p, Operator.of(k, n), None, OURS).p
            )
        ]
        with contextlib.suppress(ImportError):
            ways.append(by_tamaas(surface, elements, pressure))
        found = [fastest(way, 2 if elements > 64 else 5) for way in ways]
        errors = [float(np.abs(p - exact).max() / exact.max()) for _, p in found]
        row = [f"{s:.4f} {error:.0e}" for (s, _), error in zip(found, errors, strict=True)]
        print(elements * M, *row, f"{found[-1][0] / found[0][0]:.1f}")
        if elements == 128:
            continue
        space = HalfSpace.under(form_of(KELVIN, "exponential"), surface, pressure * elements)
        for x in SPEEDS:
            body = slide_steadily(space, KELVIN, x / np.pi).body
            step, passes = slide_steadily(space, KELVIN, 1.2 * x / np.pi).step, []
            for _ in range(STEPS):
                tolerance = step_tolerance(KELVIN, step.law)
                body, used = take_step(space, body, step, tolerance)
                passes.append(used)
            print(f"  passes of a step at v tau q_max = {x:g}: {np.median(passes):g}")


if __name__ == "__main__":
    contact_costs()
