"""The alternatives at the points of the study: errors and times as those of the kernels."""

import math
import time

import numpy as np

from elastomer_friction.kernels import Line

from .marches import MARCHES
from .points import RATIO, Point, Surface
from .sampling import Method, Runs, collected, kept_steps_of

SPIN_UP = 10.0  # what is left of the start is e^-10; implicit Euler: a factor 1 + dt a step
SLOWER = {"tamaas": 10.0}  # than the others, per update: fewer steps per dx in the same time


def affordable(name: str, point: Point, elements: int, updates: float) -> float:
    """Return up to which m a march takes at most ``updates`` updates; at least 1."""
    most = math.sqrt(updates / SLOWER.get(name, 1.0) / (2.0 * SPIN_UP * point.speed * elements))
    return max(most, 1.0)


def run_march(name: str, point: Point, surfaces: list[Surface], steps: int) -> Runs:
    """March from rest to steady sliding at v1, then at v2, and read off what the kernels give.

    mu_1 and mu_2 are what friction ends at, the jump is its change over the first step.
    """
    kept_steps, moments = kept_steps_of(
        point, surfaces[0].elements, Method("implicit-euler", steps)
    )
    steps_per_tau = steps * point.speed  # steps per tau at v1
    first, second = (
        math.ceil(SPIN_UP / math.log1p(1.0 / p)) for p in (steps_per_tau, steps_per_tau * RATIO)
    )
    rows = []
    for surface in surfaces:
        began = time.process_time()
        line = Line.self_affine(*surface, steps)
        drawn = time.process_time()
        march = MARCHES[name](line, point.load)
        before = march.advance(first, 1.0 / steps_per_tau)
        steady = time.process_time()
        after = march.advance(max(second, int(kept_steps[-1])), 1.0 / (steps_per_tau * RATIO))
        cpu = np.array([drawn - began, steady - drawn, time.process_time() - drawn])
        mu_1 = before[-1]
        rows.append((mu_1, after[-1], after[0] - mu_1, after[kept_steps - 1], cpu))
    return collected(rows, moments)
