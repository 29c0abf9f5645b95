"""A case of rows.py with its line and its steady states, from which all ways march."""

import math

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
from elastomer_friction.kernels.quick.contacts.steady_friction import Grounds
from elastomer_friction.kernels.quick.march.given import March
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from tests.kernels.quick.march.given import steady_state_of
from tests.tools.rivals.rows import RATIO, Row


class Problem:
    """A row with its line and its steady states."""

    def __init__(self, row: Row) -> None:
        self.row, self.speed = row, row.x / math.pi
        phases = draw_phases(np.random.default_rng(1), row.elements)
        amplitude = amplitudes(row.hurst, row.elements)
        self.line = line = Line.self_affine(amplitude, phases, row.elements, row.m)
        self.load = row.load * line.z.size
        paces = (1.0 / (row.m * self.speed * ratio) for ratio in (1.0, RATIO))
        self.before, self.law = (SCHEMES["exponential"](pace) for pace in paces)
        self.one, self.sweeps = steady_sliding(self.before, line.z, self.load)
        self.two, _ = steady_sliding(self.law, line.z, self.load)
        self.weight = lagged_slope(line.slope, self.law.lag)
        self.kept = np.array([row.steps])
        self.control = ConstantForce(self.load)
        spans = Grounds.of([line], marched=True).each[0].spans
        laws = self.before, self.law
        states = (self.before, self.one), (self.law, self.two)
        ends = (steady_state_of(line.z, law, state) for law, state in states)
        rates = [
            quadrature(*line[:2], *self.one, self.speed, speed, self.load)[1]
            for speed in (self.speed, RATIO * self.speed)
        ]
        self.setting = March(line.z, line.slope, spans, *laws, *ends, rates[1] - rates[0])
