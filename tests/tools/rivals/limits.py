"""The physical limit: bytes to be moved and flops to be done, at the pace the machine has shown."""

import math
import time
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.tools.rivals.compiled import Compiled

ROUNDS, LEAST = 15, 0.01  # measurements, and seconds of each
PASSES = 3  # over the thresholds, in which Newton's method balances a load
NUMBER = 8  # bytes
# Flops of a polynomial of seventh degree (kernels/lines/polynomials.py): two derivatives of a
# sample, the coefficients from both ends, a value, by Horner, a value with two derivatives, and
# from them the step to a zero.
BENDS, COEFFICIENTS, VALUE, VALUES, TO_ZERO, EXPONENTIAL = 32, 45, 14, 36, 6, 20


class Work(NamedTuple):
    """What a way to compute something has to do at the least, for each sample or patch."""

    bytes: float
    flops: float


def of_scene(units: int, passes: int = PASSES) -> Work:
    """Return the work of a step of every element; units : internal variables.

    A unit is read and written, settled (4 flops) and used (2). Two forces, the line and the
    thresholds are read or written; each pass reads the thresholds (3 flops), and forces follow.
    """
    return Work(NUMBER * (2 * units + 6 + passes), 6 * units + 3 * passes + 4)


def of_steady(units: int) -> Work:
    """Return the work of a steady state in full contact; units : internal variables.

    The element goes round twice (4 flops a unit), over the heights, and leaves its forces.
    """
    return Work(NUMBER * 4, 8 * units + 8)


def of_pass(samples: int) -> Work:
    """Return the work of a pass of the operator of a half-space over a map; samples : of the map.

    A transform of so many real numbers and its inverse take 5 log2 of them each sample. They go
    through the map by rows, by columns there and back with the compliances of half as many modes,
    and by rows. Then the displacement grows by its change, and the gap is looked at. What is done
    within the contact alone is left out.
    """
    return Work(NUMBER * (3 * 2 + 0.5 + 4), 5.0 * math.log2(samples) + 4)


# A march of Kelvin elements: w is read, decayed, written; every pass reads z and w; weights.
MARCH = Work(NUMBER * (3 + 2 * PASSES + 3), 2 + 4 * PASSES + 4)
# A sweep reads z and writes w: two decays, comparisons and sums.
SWEEP = Work(NUMBER * 2, 8)
# A line between its samples, once: z and z' are read. Written are two more derivatives,
# bounds of height and slope (35 + 28), integrals of z (8) and, by five points, of z'^2 (15 each).
SMOOTH = Work(NUMBER * 9, BENDS + COEFFICIENTS + 35 + 28 + 8 + 5 * 15)
# A turn over such a line reads and compares a bound of every span, between its patches.
GAPS = Work(NUMBER / SPAN, 2 / SPAN)
# A patch has two ends: z and three derivatives of two samples are read, a zero is found from values
# at a guess and beyond it, and elements decay. Nine numbers are written, d - z is summed by three
# points. A jump sums z'^2 over it, and p and p z' over what one more zero parts, by five.
PATCH = Work(
    NUMBER * (2 * 8 + 9),
    2 * (COEFFICIENTS + 2 * VALUES + TO_ZERO + EXPONENTIAL) + 3 * VALUE,
)
JUMP = Work(NUMBER * (2 * 8 + 9), 2 * COEFFICIENTS + VALUES + TO_ZERO + 5 * (15 + 2 * VALUE))


class Limits:
    """Bandwidth of arrays of any size, and flops a second, of one thread."""

    def __init__(self, compiled: Compiled) -> None:
        """Measure the flops."""
        self.compiled = compiled
        self.flops = 256.0 / _least(compiled.multiply_adds)
        self._bandwidth: dict[int, float] = {}

    def bandwidth(self, size: float) -> float:
        """Return the bytes a second that a loop over so many bytes moves, to a factor of two."""
        power = max(int(size).bit_length(), 13)
        if power not in self._bandwidth:
            room = np.ones(2**power // NUMBER + 7)
            whole = room[-room.ctypes.data % 64 // NUMBER :]  # lines of the cache
            a, b = whole[: 2**power // NUMBER].reshape(2, -1)
            each = _least(lambda times: self.compiled.triad(a, b, times))
            self._bandwidth[power] = 3 * NUMBER * a.size / each
        return self._bandwidth[power]

    def seconds(self, work: Work, number: float, size: float) -> float:
        """Return the least time of work on so many samples; size : bytes that it goes through."""
        return number * max(work.bytes / self.bandwidth(size), work.flops / self.flops)


@cache
def machine() -> tuple[Compiled, Limits]:
    """Return what is measured once in a run. Raises FileNotFoundError without a compiler."""
    compiled = Compiled()
    return compiled, Limits(compiled)


def limit_table() -> None:
    """Print the pace of the machine, and the bytes and flops of which limits are made."""
    limits = machine()[1]
    paces = (f"{limits.bandwidth(2**k - 1) / 1e9:.0f} in {2**k // 1024}" for k in (14, 18, 22, 26))
    print(f"Machine: {limits.flops / 1e9:.0f} flops a ns; bytes a ns: {', '.join(paces)} KiB\n")
    print("| least work of a sample or patch | bytes | flops |\n|---|---|---|")
    kinds = {
        "march of Kelvin elements, a step": MARCH,
        "sweep": SWEEP,
        "scene of 13 branches, a step": of_scene(13),
        "the same, indentation given": of_scene(13, 0),
        "steady state of 13 branches": of_steady(13),
        "line between its samples": SMOOTH,
        "turn between patches": GAPS,
        "patch": PATCH,
        "jump in a patch": JUMP,
        "half-space of 512 x 512, a pass": of_pass(512**2),
    }
    for name, work in kinds.items():
        print(f"| {name} | {work.bytes:.3g} | {work.flops:.3g} |")
    print()


def _least(run: Callable[[int], None]) -> float:
    """Return the least seconds of one of many turns."""
    turns = 100
    while True:
        taken = []
        for _ in range(ROUNDS):
            began = time.thread_time()
            run(turns)
            taken.append(time.thread_time() - began)
        if min(taken) > LEAST:
            return min(taken) / turns
        turns *= 4
