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

from elastomer_friction.kernels import Case, Line, Quantities, prepare, run_prepared
from elastomer_friction.kernels.quick.contacts.between_samples import FollowedColumns, slide_between
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    LineSet,
    SpeedConstants,
    follow_contacts,
    steady_friction,
)
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from tests.tools.march_costs import fastest
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.limits import GAPS, JUMP, NUMBER, PATCH, SMOOTH, Limits, Work, machine
from tests.tools.rivals.problem import RATIO, a_line

M, FINER, LEAST = 4, (1, 4, 16, 64), 0.1  # samples to a spacing, times as many in C; seconds
LOADS = tuple(np.geomspace(1e-3, 0.1, 10))
LAST = " | ns | limit | share |"
ROWS = ((0.0, 2000, 100.0), (0.2, 2000, 100.0), (0.7, 2000, 1000.0))  # H, N, x


def by_program(line: Line, speed: float) -> Callable[[], np.ndarray]:
    """Return a run of all loads together; it returns (mu_1, jump), shape (loads, 2)."""
    cases = [Case(load, speed, (RATIO,), (np.arange(0),), "exponential") for load in LOADS]
    prepared = prepare(cases, M, Quantities(relaxation=False))

    def run() -> np.ndarray:
        (actual,) = run_prepared([line], prepared)
        return np.array([(one.mu_1, one.jump[0]) for one in actual])

    return run


def in_c(compiled: Compiled, line: Line, speed: float) -> Callable[[], np.ndarray]:
    """Return the same in C."""
    n, m = line.z.size, line.steps_per_spacing

    def run() -> np.ndarray:
        actual = []
        for share in LOADS:
            load, mu = share * n, []
            for formed in (speed, RATIO * speed):
                law = SCHEMES["exponential"](1.0 / (m * formed))
                w, d = compiled.steady(line.z, law.decay, law.stiffness, load)
                mu.append(compiled.friction(line.z, line.slope, w, d, formed, load))
                if formed == speed:
                    at_once = compiled.friction(line.z, line.slope, w, d, RATIO * speed, load)
            actual.append((mu[0], at_once - mu[0]))
        return np.array(actual)

    return run


def patches(line: Line, speed: float) -> float:
    """Return how many patches of contact there are between the samples, under all loads."""
    (data,) = (line_set := LineSet.of([line])).lines
    loads = np.array(LOADS) * line.z.size
    sliding = steady_friction(line_set, SpeedConstants.of("exponential", M, speed), loads, True)
    follow_contacts(sliding)
    d = sliding.indentation[0] - line.datum
    # From the indentation that is found, one turn is enough.
    table, *_ = slide_between(data.smooth, speed, np.empty(0), loads / data.stride, d)
    return FollowedColumns(*table.T).events.sum()


def least(limits: Limits, line: Line, speed: float) -> float:
    """Return the least seconds of both steady states and of the jump, under all loads."""
    n, before, after = line.z.size, patches(line, speed), patches(line, RATIO * speed)

    def of(work: Work, number: float) -> float:
        return limits.seconds(work, number, NUMBER * 9 * n)

    turns = of(GAPS, 2 * len(LOADS) * n) + of(PATCH, before + after)
    return of(SMOOTH, n) + turns + of(JUMP, before)


def narrow_costs() -> None:
    """Print the table."""
    with contextlib.suppress(FileNotFoundError):
        compiled, limits = machine()
        print(f"\nNarrow contacts: time of C over that of the program with m = {M}: how far mu_1")
        print("and the jump of C are from the program's in the median, per cent; ns of the program")
        print("for each sample and load, their limit, and its share\n")
        print("| H, N, x | " + " | ".join(f"m = {M * more}" for more in FINER) + LAST)
        print("|---|" + "---|" * (len(FINER) + 3))
        for hurst, elements, x in ROWS:
            lines, cells = [a_line(hurst, elements, M * more) for more in FINER], []
            speed = x / math.pi
            run = by_program(lines[0], speed)
            expected, taken = run(), fastest(run, LEAST)
            for line in lines:
                rival = in_c(compiled, line, speed)
                off = 100.0 * np.median(np.abs(rival() / expected - 1.0), axis=0)
                cells.append(f"{fastest(rival, LEAST) / taken:.1f}: {off[0]:.2g}, {off[1]:.2g}")
            limit, each = least(limits, lines[0], speed), 1e9 / (len(LOADS) * lines[0].z.size)
            cells += [f"{taken * each:.2f}", f"{limit * each:.3f}", f"{limit / taken:.3f}"]
            print(f"| {hurst:g}, {elements}, {x:g} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    narrow_costs()
