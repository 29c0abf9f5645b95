"""The cases of `make bench`, from all over figure 7 at paper scale, and where all ways begin."""

import math
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    ConstantForce,
    Line,
    amplitudes,
    draw_phases,
    lagged_slope,
    quadrature,
    steady_sliding,
)
from elastomer_friction.kernels.quick.contacts.steady_friction import LineSet
from elastomer_friction.kernels.quick.march.jump_problem import JumpProblem
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from tests.kernels.quick.march.given import steady_state_of

RATIO = 1.2  # v2 / v1


class Row(NamedTuple):
    """One case: a march of so many steps, four relaxation times or more."""

    hurst: float
    elements: int
    m: int  # steps per spacing
    x: float  # v1 tau q_max = pi vbar
    load: float  # Fbar
    steps: int


ROWS = (
    Row(0.7, 1000, 4, 0.09, 1e-3, 8),
    Row(0.7, 5000, 4, 78.0, 0.025, 130),
    Row(0.7, 5000, 4, 78.0, 1.0, 130),
    Row(0.0, 5000, 8, 31.0, 0.03, 13),
    Row(1.0, 5000, 4, 31.0, 1.0, 192),
    Row(0.7, 20000, 4, 9.4, 0.1, 30),
    Row(0.0, 20000, 4, 94.0, 1e-3, 8),
    Row(0.7, 20000, 4, 94.0, 1.0, 148),
    Row(1.0, 20000, 4, 94.0, 1.0, 576),
    Row(0.7, 300, 64, 0.09, 0.1, 10),
    Row(0.7, 300, 1, 9.4, 0.1, 8),
    Row(0.7, 5000, 1, 94.0, 0.1, 37),
    Row(0.5, 5000, 64, 0.09, 1e-3, 10),
)


def a_line(hurst: float, elements: int, m: int, seed: int = 1) -> Line:
    """Return a random line."""
    phases = draw_phases(np.random.default_rng(seed), elements)
    return Line.self_affine(amplitudes(hurst, elements), phases, elements, m)


class Problem:
    """A row with its line and its steady states."""

    def __init__(self, row: Row) -> None:
        self.row, self.speed = row, row.x / math.pi
        self.line = line = a_line(row.hurst, row.elements, row.m)
        self.load = row.load * line.z.size
        paces = (1.0 / (row.m * self.speed * ratio) for ratio in (1.0, RATIO))
        self.before, self.law = (SCHEMES["exponential"](pace) for pace in paces)
        self.one, self.sweeps = steady_sliding(self.before, line.z, self.load)
        self.two, _ = steady_sliding(self.law, line.z, self.load)
        self.weight = lagged_slope(line.slope, self.law.lag)
        self.kept = np.array([row.steps])
        self.control = ConstantForce(self.load)
        spans = LineSet.of([line], marched=True).lines[0].spans
        laws = self.before, self.law
        states = (self.before, self.one), (self.law, self.two)
        ends = (steady_state_of(line.z, law, state) for law, state in states)
        rates = [
            quadrature(*line[:2], *self.one, self.speed, speed, self.load)[1]
            for speed in (self.speed, RATIO * self.speed)
        ]
        self.setting = JumpProblem(line.z, line.slope, spans, *laws, *ends, rates[1] - rates[0])
