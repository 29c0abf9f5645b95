"""Predicted cost of a case, from element updates and seconds per update."""

import math
from typing import NamedTuple

SECONDS_PER_SAMPLE_DRAWN = 9e-8  # phases and two FFTs
SECONDS_PER_SAMPLE_STEADY = 2.2e-8  # one steady state: 3 to 6 sweeps, one quadrature
SECONDS_PER_UPDATE = 3.5e-9  # marching one touchable element one step, 3 to 4 passes
SECONDS_PER_CASE = 1.5e-4  # calls from Python
BYTES_PER_SAMPLE = 130  # line, state and temporaries at the peak
WORKER_BYTES = 220e6  # interpreter, libraries, machine code


class Load(NamedTuple):
    """What one case does on one line."""

    samples: int
    steady_states: int
    jumps: int
    steps: int
    load: float  # Fbar


def touchable_share(load: float) -> float:
    """Return the share of the line that is marched, roughly: what touches at rest."""
    return min(1.0, 3.0 * load**0.6)


def line_seconds(samples: int) -> float:
    """Return the predicted time to draw and sample one line."""
    return samples * SECONDS_PER_SAMPLE_DRAWN * max(1.0, math.log2(samples) / 15.0)


def case_seconds(work: Load) -> float:
    """Return the predicted time of one case on a line that exists."""
    steady = (work.steady_states + 0.5 * work.jumps) * SECONDS_PER_SAMPLE_STEADY
    march = work.steps * touchable_share(work.load) * SECONDS_PER_UPDATE
    return SECONDS_PER_CASE + work.samples * (steady + march)


def worker_bytes(samples: int) -> float:
    """Return the predicted peak memory of a worker whose longest line has ``samples``."""
    return WORKER_BYTES + BYTES_PER_SAMPLE * samples
