"""Predicted cost of a case, from element updates and seconds per update."""

import math
from typing import NamedTuple

SECONDS_PER_SAMPLE_DRAWN = 9e-8  # phases and two FFTs
SECONDS_PER_SAMPLE_STEADY = 2.2e-8  # one steady state: 3 to 6 sweeps, one quadrature
SECONDS_PER_UPDATE = 3.0e-9  # marching one touchable element one step, 3 to 4 passes
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
    pace: float  # vbar grad z, the viscous pressure on a mean slope in G h


def touchable_share(load: float, pace: float) -> float:
    """Return the share of the line that is marched: what lies below the indentation.

    At rest it grows with the load; at speed little area carries it, load over viscous pressure.
    Measured on the grids of figure 7 and of the study grid6d, within a factor of 2 mostly.
    """
    return min(1.0, 1.1 * load**0.6, 3.0 * (load / pace) ** 0.75)


def line_seconds(samples: int) -> float:
    """Return the predicted time to draw and sample one line."""
    return samples * SECONDS_PER_SAMPLE_DRAWN * max(1.0, math.log2(samples) / 15.0)


def case_seconds(work: Load) -> float:
    """Return the predicted time of one case on a line that exists."""
    steady = (work.steady_states + 0.5 * work.jumps) * SECONDS_PER_SAMPLE_STEADY
    march = work.steps * touchable_share(work.load, work.pace) * SECONDS_PER_UPDATE
    return SECONDS_PER_CASE + work.samples * (steady + march)


def worker_bytes(samples: int) -> float:
    """Return the predicted peak memory of a worker whose longest line has ``samples``."""
    return WORKER_BYTES + BYTES_PER_SAMPLE * samples
