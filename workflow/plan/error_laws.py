"""Laws of error and scatter, which turn a requested accuracy into steps and realizations.

All are relative and were measured with the scheme ``exponential`` at r = 1.2. Errors: 224 random
problems, H 0 ... 1, Fbar 1e-3 ... 25, x 0.03 ... 3200, N 320 ... 10 000, against the finest m (64
to 512) on the same lines. The laws bound the errors of 9 in 10 of these, and of 9 in 10 of 480
others (tests/tools/wide.py, docs/accuracy.md). Scatter: standard error times the root of the number
of lines, from 16 quartets of lines; 290 problems, Fbar 1e-3 ... 25, x 0.25 ... 600, N 320 ... 3200.
Two in three are within a factor of 1.7 of the law.

The functions take a problem or a stack of problems (problems.py), and the steps of each.
"""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from ...kernels import KELVIN
from ...kernels.quick.contacts.between_samples import MIN_SMOOTH_STEPS
from ..simulate import SHAPE_ERROR, Problem
from ..study import FOUNDATION
from .problems import Numbers, expected_rate, speed_ratio, viscous_pressure

FEW_PATCHES = 2.0  # number of contact patches below which marches are shorter (window_rate)


def known(problem: Problem, body: str = FOUNDATION) -> Numbers:
    """Return whether laws hold: Kelvin, random surface, no programme; load, speed and r > 0."""
    plain = problem.spectrum == KELVIN and not problem.programme and not problem.surface.given
    plain = plain and problem.surface.body == body
    numbers = np.stack([problem.load, problem.speed, problem.ratio])
    return plain & (numbers > 0.0).all(axis=0)


class Coarseness(NamedTuple):
    """Constants of the error law of steady sliding, or of the jump."""

    size: float  # prefactor
    load: float  # exponent of the load
    pressed: float  # exponent of 1 + viscous pressure/load
    sliding: float  # exponent of 1 + 1/vbar
    elements: float  # unit of the number of elements
    rough: float  # exponent of the number of elements, over H
    whole: float  # least error times m^2, added in quadrature


STEADY = Coarseness(0.060, -0.32, 0.41, 0.92, 88.0, -1.22, 0.03)
JUMP = Coarseness(0.158, -0.26, 0.61, 0.68, 94.0, -1.36, 0.06)
FOLLOWED = 1e-5  # error of mu_1 and jump with located edges; 3 of 1000 jumps exceed it


def coarse_error(law: Coarseness, problem: Problem, steps: Numbers, refine: bool = True) -> Numbers:
    """Return the error of mu_1 or jump: second order in 1/m, or FOLLOWED with located edges.

    refine : whether the edges of contacts are located between the samples.
    """
    _, elements, load, speed, _ = problem[:5]
    contacts = load**law.load * (1.0 + viscous_pressure(problem) / load) ** law.pressed
    line = (elements / law.elements) ** (law.rough * problem.hurst)
    coarse = law.size * contacts * (1.0 + 1.0 / speed) ** law.sliding * line
    sampled = np.hypot(coarse, law.whole) / np.square(steps)
    return np.where(refine & (np.asarray(steps) >= MIN_SMOOTH_STEPS), FOLLOWED, sampled)


def relaxation_rate_error(problem: Problem, steps: Numbers) -> Numbers:
    """Return the predicted error of b; see ``rate_error``."""
    return rate_error(problem, steps, contact_width(problem) * steps, expected_rate(problem))


def rate_error(problem: Problem, steps: Numbers, samples: Numbers, rate: Numbers) -> Numbers:
    """Return the error of b from the steps of the march and the samples per contact.

    rate : b. Errors of contact edges and of straight lines between samples count for x >= 1, where
    sliding replaces the contacts.
    """
    share = _share(problem, steps, rate)
    stepping = 0.02 * (share / allowed_share(problem)) ** 1.5
    edges = 1.8 * np.maximum(samples, 1.0) ** -1.8
    shape = shape_error(steps)
    return np.hypot(stepping, np.where(speed_ratio(problem) >= 1.0, np.hypot(edges, shape), 0.0))


def shape_error(steps: Numbers) -> Numbers:
    """Return the error of a march due to straight lines between samples."""
    return SHAPE_ERROR / np.asarray(steps) ** 2.0


def stepped_error(steps: Numbers) -> Numbers:
    """Return the error of friction, or of its jump, that is averaged over steps of implicit Euler.

    It bounds nine in ten of 220 means over 4 lines at m = 1 ... 64, for the problems named above.
    """
    return 1.6 / np.asarray(steps)


def first_order_rate_error(problem: Problem, steps: Numbers, rate: Numbers) -> Numbers:
    """Return the additional error of b due to the implicit Euler scheme.

    A mode of rate b decays at the rate b ln(1 + s)/s, where s is the time step over the relaxation
    time 1/b. With several modes the error is up to four times as large.
    """
    share = _share(problem, steps, rate)
    return 4.0 * (1.0 - np.log1p(share) / share)


def _share(problem: Problem, steps: Numbers, rate: Numbers) -> Numbers:
    """Return the time step over the relaxation time, at the slower speed."""
    fastest = np.maximum(rate, expected_rate(problem))
    return fastest / (problem.speed * np.minimum(1.0, problem.ratio) * steps)


def allowed_share(problem: Problem) -> Numbers:
    """Return the time step over the relaxation time at which the error of b is 2 %."""
    return np.minimum(1.0, 0.27 * np.minimum(speed_ratio(problem), 1.0) ** -0.8)


def contact_width(problem: Problem) -> Numbers:
    """Return the width of the contacts that carry half of the load, in dx; valid above x = 1.

    Law 1: a single peak of radius R touches only in front, on 2 sqrt(R F_N / (8 G v tau)).
    Law 2: with many peaks in contact, the width grows with H and, except near H = 0, with N.
    The smaller width holds. Of 88 measured widths below 15 dx, 8 in 10 are within a factor of 1.5.
    """
    hurst, elements, load, speed, _ = problem[:5]
    line, fast = np.log(elements), np.log(speed)
    pressure = np.log(load / viscous_pressure(problem))
    one = 0.5 * (pressure + line) - 0.712 + hurst * (1.385 - 0.079 * line) + 0.045 * fast
    many = 0.124 * pressure + 0.916 + hurst * (0.399 + 0.281 * line)
    return np.exp(np.minimum(one, many - 0.139 * fast - 0.021 * line))


def touchable_share(hurst: Numbers, load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the share of the line that lies below z = d, which a march visits.

    At rest the share grows with the load. At speed it is smaller, about load over viscous
    pressure. Of 1500 random problems, Fbar 1e-4 ... 30, vbar 0.02 ... 1000, N 700 ... 12000,
    half are within 20 % and nine in ten within a factor of 2.2.
    """
    rest = np.exp(-0.40 + 0.78 * hurst) * load**0.635
    speed = np.exp(1.58 + 0.44 * hurst) * (load / viscous_pressure**0.72) ** 1.06
    return (1.0 + rest**-2.8 + speed**-2.8) ** (-1.0 / 2.8)


def window_rate(problem: Problem) -> Numbers:
    """Return the rate that sets the length of a march, at least the expected rate b.

    It is b if many patches carry the load. One or two patches are renewed once they have slid
    their own width. Of 92 measured curves with x > 1, N to 3000, 94 % fell to 5 % within 4/rate,
    the others within 4.2/rate. With b alone marches took up to 100 times longer.
    """
    rate = expected_rate(problem)
    with np.errstate(all="ignore"):  # loads of zero, where no law holds
        width = contact_width(problem)
        patches = problem.elements * problem.load / viscous_pressure(problem) / width
        few = known(problem) & (speed_ratio(problem) > 1.0) & (patches < FEW_PATCHES)
        return rate + np.where(few, 0.4 * np.abs(problem.speed) / width, 0.0)


def relaxing_share(problem: Problem) -> Numbers:
    """Return the magnitude of the share of the jump that relaxes, valid above 1e-3.

    The share was below 0.01 in 112 measured problems; the law finds 105 of these and 4 others.
    """
    hurst, elements, load, _, _ = problem[:5]
    x = speed_ratio(problem)
    speed = (viscous_pressure(problem) / load) ** 0.40 * x ** (0.555 + 0.433 * hurst)
    line = np.exp(-2.2 - 1.125 * hurst) * elements ** (-0.179 - 0.435 * hurst)
    return speed * line * np.exp(-0.605 * load**0.659)


def mu_1_scatter(problem: Problem) -> Numbers:
    """Return the scatter of mu_1 and mu_2, which decreases towards full contact."""
    hurst, elements, load, _, _ = problem[:5]
    contacts = (
        load**-0.09 * (1.0 + load) ** -1.57 * (1.0 + viscous_pressure(problem) / load) ** 0.08
    )
    return 0.97 * contacts * np.exp(-2.17 * hurst) * elements ** (0.30 * hurst - 0.34)


def jump_scatter(problem: Problem) -> Numbers:
    """Return the scatter of the jump, whose distribution has heavy tails at light loads."""
    hurst, elements, load, _, _ = problem[:5]
    contacts = (1.0 + load) ** -1.1 * (1.0 + viscous_pressure(problem) / load) ** 0.30
    sliding = 1.6 * contacts * np.exp(-3.35 * hurst) * elements ** (0.633 * hurst - 0.545)
    return np.where(speed_ratio(problem) < 1.0, mu_1_scatter(problem), sliding)


def relaxation_rate_scatter(problem: Problem) -> Numbers:
    """Return the scatter of b, which is fitted to a mean curve."""
    hurst, elements, load, _, _ = problem[:5]
    x = speed_ratio(problem)
    contacts = load**0.43 * (1.0 + load) ** -0.61 * (1.0 + viscous_pressure(problem) / load) ** 0.53
    sliding = 0.090 * contacts * np.exp(0.77 * hurst) * elements ** (0.34 * hurst - 0.05)
    # Below x = 1 (creep) b is about 1, except under heavy loads, where hardly anything relaxes.
    creep = np.where((load > 0.1) & (x > 0.2), 0.6, np.minimum(0.1, 0.5 * x))
    return np.where(x < 1.0, creep, sliding)


class Laws(NamedTuple):
    """Laws of error and scatter of one estimate."""

    error: Callable[..., Numbers]  # function of (problem, steps)
    scatter: Callable[[Problem], Numbers]  # standard error for one line


LAWS = {
    "mu_1": Laws(partial(coarse_error, STEADY), mu_1_scatter),
    "jump": Laws(partial(coarse_error, JUMP), jump_scatter),
    "relaxation_rate": Laws(relaxation_rate_error, relaxation_rate_scatter),
}
