"""The physical limit: bytes to be moved and flops to be done, at the pace the machine has shown."""

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tests.tools.rivals.compiled import Compiled

ROUNDS, LEAST = 5, 0.01  # measurements, and seconds of each
PASSES = 3  # over the thresholds, in which Newton's method balances a load
NUMBER = 8  # bytes


class Work(NamedTuple):
    """What a way to compute something has to do at the least, for each sample."""

    bytes: float
    flops: float


def of_scene(units: int) -> Work:
    """Return the work of a step of every element; units : internal variables.

    A unit is read and written, settled (4 flops) and used (2). Two forces, the line and the
    thresholds are read or written; each pass reads the thresholds (3 flops), and forces follow.
    """
    return Work(NUMBER * (2 * units + 6 + PASSES), 6 * units + 3 * PASSES + 4)


def of_steady(units: int) -> Work:
    """Return the work of a steady state in full contact; units : internal variables.

    The element goes round twice (4 flops a unit), over the heights, and leaves its forces.
    """
    return Work(NUMBER * 4, 8 * units + 8)


# A march of Kelvin elements: w is read, decayed, written; every pass reads z and w; weights.
MARCH = Work(NUMBER * (3 + 2 * PASSES + 3), 2 + 4 * PASSES + 4)
# A sweep reads z and writes w: two decays, comparisons and sums.
SWEEP = Work(NUMBER * 2, 8)


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
            a, b = np.ones((2, 2**power // (2 * NUMBER)))
            each = _least(lambda times: self.compiled.triad(a, b, times))
            self._bandwidth[power] = 3 * NUMBER * a.size / each
        return self._bandwidth[power]

    def seconds(self, work: Work, samples: int, size: float) -> float:
        """Return the least time of a pass over all samples; size : bytes that it goes through."""
        return samples * max(work.bytes / self.bandwidth(size), work.flops / self.flops)

    def of_scene(self, samples: int, units: int) -> float:
        """Return the least time of a step of every element."""
        return self.seconds(of_scene(units), samples, NUMBER * samples * (units + 4))


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
