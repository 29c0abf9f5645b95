"""The cases of the study: all corners on random lines, lines of any shape, very long lines."""

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import SCHEMES, Line, amplitudes, draw_phases

from .probe import Motion
from .shapes import shapes

HURST = (0.0, 0.5, 1.0)
ELEMENTS = ((8, 1), (8, 4), (64, 2), (1000, 1))  # N and samples per spacing
LOADS = (1e-6, 1e-3, 1.0, 1e4)
X = (1e-4, 1.0, 1e3, 1e6)
RATIOS = (1e-3, 0.8, 1.2, 101.0)  # dv/v1 = -0.999 to +100
LONG = (10**5, 10**6)
LONG_STEPS = 2


class Corner(NamedTuple):
    """One case: what it is called, what moves, for how many steps."""

    line: str
    elements: int
    motion: Motion
    steps: int


def random_line(hurst: float, elements: int, m: int, seed: int, index: int) -> Line:
    """Return a random line, a function of these numbers alone."""
    rng = np.random.default_rng([seed, round(1e6 * hurst), elements, index])
    return Line.self_affine(amplitudes(hurst, elements), draw_phases(rng, elements), elements, m)


def corners(seed: int, lines: int, most_elements: int, steps: int) -> Iterator[Corner]:
    """Return all cases, the lines made as they are needed."""
    for hurst, (n, m), index in itertools.product(HURST, ELEMENTS, range(lines)):
        line = random_line(hurst, n, m, seed, index)
        yield from _every_motion(f"H = {hurst:g}", n, line, RATIOS, steps)
    for name, line in shapes().items():
        n = line.z.size // line.steps_per_spacing
        yield from _every_motion(name, n, line, (RATIOS[0], RATIOS[-1]), steps)
    for n in LONG:
        if n <= most_elements:
            line = random_line(1.0, n, 1, seed, 0)
            for load, scheme in itertools.product((LOADS[0], LOADS[-1]), SCHEMES):
                yield Corner("H = 1", n, Motion(line, load, 10.0, 2.0, scheme), LONG_STEPS)


def _every_motion(name, elements, line, ratios, steps):
    for load, x, ratio, scheme in itertools.product(LOADS, X, ratios, SCHEMES):
        yield Corner(name, elements, Motion(line, load, x / np.pi, ratio, scheme), steps)


def number_of_corners(lines: int, most_elements: int) -> int:
    """Return how many cases ``corners`` yields."""
    motions = len(LOADS) * len(X) * len(SCHEMES)
    random = len(HURST) * len(ELEMENTS) * lines * motions * len(RATIOS)
    long = sum(n <= most_elements for n in LONG)
    return random + len(shapes()) * motions * 2 + long * 2 * len(SCHEMES)
