"""What an elastic contact of a half-space costs, beside tamaas where it is installed.

    python -m tests.tools.contact_costs

Seconds of CPU time from a cold start, and the largest error of the pressures relative to their
peak, against a solution that is much more exact: ours is as exact as that of tamaas, or more. The
limit is that of as many passes of the operator as are taken. Then the passes that a step of a march
takes in the median. Printed by `make bench` (bench.py).
"""

import contextlib
from collections.abc import Callable

import numpy as np

from elastomer_friction.kernels.half_space.body import HalfSpace, step_tolerance, take_step
from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.sliding_body import slide_steadily
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.half_space.waves import half_space_stiffness
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from tests.tools.march_costs import fastest
from tests.tools.rivals.limits import NUMBER, machine, of_pass

M, LOAD, OURS, THEIRS = 4, 0.05, 5e-9, 1e-8  # load: of E* times the rms slope; tolerances
SPEEDS, STEPS = (1.0, 3.0, 10.0), 20  # v tau q_max, and steps after a velocity step


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


def from_cold(surface: Surface, elements: int, pressure: float) -> list[str]:
    """Return the cells of a row."""
    z, n = surface.z, surface.z.size
    operator = Operator.of(half_space_stiffness(z.shape, M), z.shape[1])
    exact = press(z, pressure, operator, None, 1e-12).p

    def told(taken: float, p: np.ndarray) -> str:
        return f"{taken:.4f} {float(np.abs(p - exact).max() / exact.max()):.0e}"

    actual = press(z, pressure, operator, None, OURS)
    taken = fastest(lambda: press(z, pressure, operator, None, OURS))
    out, each = np.empty_like(z), 1e9 * taken / (actual.passes * n)
    alone = 1e9 * fastest(lambda: operator.displaced(actual.p, out)) / n
    cells = [told(taken, actual.p), f"{each:.1f} {alone:.1f}"]
    with contextlib.suppress(FileNotFoundError):
        # The gap, and what the operator and a solution hold: fields, compliances, modes, two maps.
        least = 1e9 * machine()[1].seconds(of_pass(n), 1, 7.5 * NUMBER * n)
        cells.append(f"{least:.2f} {least / each:.3f}")
    with contextlib.suppress(ImportError):
        solve = by_tamaas(surface, elements, pressure)
        theirs = fastest(solve)
        cells.append(f"{told(theirs, solve())} {theirs / taken:.1f}")
    return cells


def passes_of_steps(surface: Surface, load: float, x: float) -> float:
    """Return the median of the passes that a step takes, x : v tau q_max before."""
    space = HalfSpace.under(form_of(KELVIN, "exponential"), surface, load)
    body = slide_steadily(space, KELVIN, x / np.pi).body
    step, passes = slide_steadily(space, KELVIN, 1.2 * x / np.pi).step, []
    for _ in range(STEPS):
        body, used = take_step(space, body, step, step_tolerance(KELVIN, step.law))
        passes.append(used)
    return float(np.median(passes))


def contact_costs() -> None:
    """Print all of it."""
    print(
        "\nContact of a half-space: samples; s and error; ns a sample and pass, and of the operator"
    )
    print("alone; their limit and its share; s and error of tamaas, and the ratio to the time here")
    for elements in (32, 64, 128):
        amplitudes = ring_amplitudes(0.7, elements)
        pressure = LOAD * rms_slope_of(amplitudes, elements)
        surface = Surface.drawn(np.random.default_rng(1), amplitudes, elements, M)
        print(elements * M, *from_cold(surface, elements, pressure), sep="; ")
        for x in SPEEDS if elements < 128 else ():
            passes = passes_of_steps(surface, pressure * elements, x)
            print(f"  passes of a step at v tau q_max = {x:g}: {passes:g}")


if __name__ == "__main__":
    contact_costs()
