"""The alternatives at the points of the study: errors and times as those of the kernels."""

import importlib.util
import math
import time

import numpy as np

from kernels import Line

from .marches import MARCHES
from .points import RATIO, Point, Surface
from .sampling import Method, Runs, kept_steps_of

SPIN_UP = 10.0  # what is left of the start is e^-10; implicit Euler: a factor 1 + dt a step
SLOWER = {"tamaas": 10.0}  # than the others, per update: fewer steps per dx in the same time


def available(name: str) -> bool:
    """Tell whether an alternative can be run here; tamaas is optional."""
    return name != "tamaas" or importlib.util.find_spec("tamaas") is not None


def affordable(name: str, point: Point, elements: int, updates: float) -> list[int]:
    """Return the powers of two of m for which a march takes at most ``updates`` updates."""
    most = math.sqrt(updates / SLOWER.get(name, 1.0) / (2.0 * SPIN_UP * point.speed * elements))
    return [2**k for k in range(int(math.log2(max(most, 1.0))) + 1)]


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
    found, cpu = [], []
    for surface in surfaces:
        began = time.process_time()
        line = Line.self_affine(*surface, steps)
        drawn = time.process_time()
        march = MARCHES[name](line, point.load)
        before = march.advance(first, 1.0 / steps_per_tau)
        steady = time.process_time()
        after = march.advance(max(second, int(kept_steps[-1])), 1.0 / (steps_per_tau * RATIO))
        done = time.process_time()
        found.append((before[-1], after[-1], after[0] - before[-1], after[kept_steps - 1]))
        cpu.append((drawn - began, steady - drawn, done - drawn))
    mu_1, mu_2, jump, curves = (np.array(column) for column in zip(*found, strict=True))
    return Runs(mu_1, mu_2, jump, curves, moments, np.array(cpu))
