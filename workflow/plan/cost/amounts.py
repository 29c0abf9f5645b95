"""How much of a line is computed: what of it can touch, how finely it is sampled, what is repeated.

Laws take a problem, or many of them together (problems.py).
"""

import numpy as np

from ....kernels.quick.contacts.refined import FINE, LEAST_STEPS, MOST_SAMPLES, NARROW
from ...simulate import Problem
from ..problems import Numbers, speed_ratio


def touchable_share(hurst: Numbers, load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the share of the line that is marched: what lies below the indentation.

    At rest it grows with the load; at speed little area carries it, load over viscous pressure.
    Measured on 1500 random problems, Fbar 1e-4 ... 30, vbar 0.02 ... 1000, N 700 ... 12000: half of
    them within 20 %, nine of ten within a factor of 2.2.
    """
    rest = np.exp(-0.40 + 0.78 * hurst) * load**0.635
    speed = np.exp(1.58 + 0.44 * hurst) * (load / viscous_pressure**0.72) ** 1.06
    return (1.0 + rest**-2.8 + speed**-2.8) ** (-1.0 / 2.8)


def partial_contact(load: Numbers, viscous_pressure: Numbers, limit: float) -> Numbers:
    """Return 1 where part of a line touches and 0 where all of it does, at loads over a limit."""
    return 1.0 / (1.0 + (load / (1.0 + viscous_pressure) / limit) ** 4)


def begun_anew(problem: Problem) -> Numbers:
    """Return how much longer marches take that begin anew, with wider bounds (kernels/quick/march).

    Near H = 1 and above x = 1e4 most do. Of 60 batches of grid6d at paper scale, together as long
    as predicted with it, half are within a factor of two, and nine of ten within ten.
    """
    near_one = 1.0 / (1.0 + np.exp((0.83 - problem.hurst) / 0.03))
    return 1.0 + 1.5 * near_one / (1.0 + (1e4 / speed_ratio(problem)) ** 2)


def fine_samples(problem: Problem, samples: Numbers, share: Numbers, width: Numbers) -> Numbers:
    """Return the fine samples of a steady state, where contacts are narrow (quick/contacts).

    share : of the line that can touch. width : of the contacts, in samples.
    """
    odds = (samples / problem.elements >= LEAST_STEPS) & (speed_ratio(problem) >= 1.0)
    fold = 1.46 * FINE / width  # a power of two, between this and twice that
    whole = samples * np.minimum(1.2 * share, 1.0) * fold
    few = 1.0 / (1.0 + (whole / (0.6 * MOST_SAMPLES)) ** 2)  # of more it takes none
    return odds * few * whole / (1.0 + (width / (1.05 * NARROW)) ** 6)
