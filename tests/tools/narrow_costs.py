"""What narrow contacts cost beside C that is as exact by finer samples.

    python -m tests.tools.narrow_costs

At light load and high speed contacts are narrower than a sample. The program follows them between
the samples; C, which knows samples alone, takes more of them. Both find steady friction at two
speeds and the jump between them. Printed by `make bench` (bench.py).
"""

import contextlib
import math
from collections.abc import Callable

import numpy as np

from elastomer_friction.kernels import (
    Case,
    Line,
    Quantities,
    amplitudes,
    draw_phases,
    prepare,
    run_prepared,
)
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from tests.tools.march_costs import fastest
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.problem import RATIO

M, FINER, LEAST = 4, (1, 4, 16, 64), 0.1  # samples to a spacing, times as many in C; seconds
LOADS = tuple(np.geomspace(1e-3, 0.1, 10))
ROWS = ((0.0, 2000, 100.0), (0.2, 2000, 100.0), (0.7, 2000, 1000.0))  # H, N, x


def by_program(line: Line, speed: float) -> Callable[[], np.ndarray]:
    """Return a run of all loads together; it returns (mu_1, jump), shape (loads, 2)."""
    cases = [Case(load, speed, (RATIO,), (np.arange(0),), "exponential") for load in LOADS]
    prepared = prepare(cases, M, Quantities(relaxation=False))

    def run() -> np.ndarray:
        (found,) = run_prepared([line], prepared)
        return np.array([(one.mu_1, one.jump[0]) for one in found])

    return run


def in_c(compiled: Compiled, line: Line, speed: float) -> Callable[[], np.ndarray]:
    """Return the same in C."""
    n, m = line.z.size, line.steps_per_spacing

    def run() -> np.ndarray:
        found = []
        for share in LOADS:
            load, mu = share * n, []
            for formed in (speed, RATIO * speed):
                law = SCHEMES["exponential"](1.0 / (m * formed))
                w, d = compiled.steady(line.z, law.decay, law.stiffness, load)
                mu.append(compiled.friction(line.z, line.slope, w, d, formed, load))
                if formed == speed:
                    at_once = compiled.friction(line.z, line.slope, w, d, RATIO * speed, load)
            found.append((mu[0], at_once - mu[0]))
        return np.array(found)

    return run


def narrow_costs() -> None:
    """Print the table."""
    with contextlib.suppress(FileNotFoundError):
        compiled = Compiled()
        print(
            "\nNarrow contacts: time of C with m samples to a spacing over that of the program with"
        )
        print(
            f"{M}: how far mu_1 and the jump of C are from the program's in the median, per cent\n"
        )
        print("| H, N, x | " + " | ".join(f"m = {M * more}" for more in FINER) + " |")
        print("|---|" + "---|" * len(FINER))
        for hurst, elements, x in ROWS:
            phases, speed = draw_phases(np.random.default_rng(1), elements), x / math.pi
            amplitude, cells = amplitudes(hurst, elements), []
            lines = [Line.self_affine(amplitude, phases, elements, M * more) for more in FINER]
            run = by_program(lines[0], speed)
            expected, taken = run(), fastest(run, LEAST)
            for line in lines:
                rival = in_c(compiled, line, speed)
                off = 100.0 * np.median(np.abs(rival() / expected - 1.0), axis=0)
                cells.append(f"{fastest(rival, LEAST) / taken:.1f}: {off[0]:.2g}, {off[1]:.2g}")
            print(f"| {hurst:g}, {elements}, {x:g} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    narrow_costs()
