"""Reference points of the study, and the random lines on which all methods run."""

import math
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import amplitudes, draw_phases
from elastomer_friction.workflow.simulate import Problem, line_generator

RATIO = 1.2  # v2 / v1


class Point(NamedTuple):
    """A reference point."""

    hurst: float
    load: float  # Fbar
    x: float  # v1 tau q_max

    @property
    def speed(self) -> float:
        """Return vbar = v1 tau / dx."""
        return self.x / math.pi

    @property
    def name(self) -> str:
        """Return a short text for tables and figures."""
        return f"H={self.hurst:g} F={self.load:g} x={self.x:g}"

    def problem(self, elements: int) -> Problem:
        """Return the point as a problem of the workflow."""
        return Problem(self.hurst, elements, self.load, self.speed, RATIO)


COMPARED = 3  # number of points at which the alternatives run too
POINTS = (
    Point(0.0, 0.01, 0.3),
    Point(0.5, 0.05, 3.0),
    Point(0.7, 0.05, 17.0),
    Point(0.3, 0.1, 0.03),
    Point(0.7, 0.01, 0.03),
    Point(0.7, 0.1, 0.3),
    Point(1.0, 0.001, 0.3),
    Point(0.3, 0.001, 1.0),
    Point(0.7, 1.0, 1.0),
    Point(1.0, 0.01, 3.0),
    Point(0.0, 0.1, 10.0),
    Point(0.3, 1.0, 10.0),
    Point(1.0, 0.03, 10.0),
    Point(0.3, 0.05, 50.0),
    Point(0.0, 0.01, 100.0),
    Point(0.3, 0.001, 100.0),
    Point(0.7, 0.01, 100.0),
)


class RandomLine(NamedTuple):
    """Spectrum and phases of one random line, before it is sampled."""

    amplitude: np.ndarray
    phases: np.ndarray
    elements: int


def surface(point: Point, elements: int, seed: int, index: int) -> RandomLine:
    """Return random line ``index`` of a point, the same for all methods and all m."""
    generator = line_generator(seed, point.hurst, elements, index)
    return RandomLine(amplitudes(point.hurst, elements), draw_phases(generator, elements), elements)
