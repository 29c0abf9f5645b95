"""Predicted cost of a case: how much work it is (laws below) times how fast a machine works.

The amounts (sweeps, touching samples) belong to the problem, the timings to a machine; those are
measured by timing.py. Laws take a problem, or many of them together (problems.py).
"""

from typing import NamedTuple

import numpy as np

from kernels import KELVIN, Quantities
from workflow.plan.problems import Numbers, viscous_pressure
from workflow.simulate import Problem, Recording, programme_steps

# Of elements with internal variables, in steps (of all samples) and sweeps of a Kelvin element.
# Ratios of CPU times on one machine, H = 0.7, m = 4, Prony series without a dashpot. March at
# N = 1000, Fbar = 0.3, vbar = 1: 1.07, 2.03 and 4.91 steps with 1, 4 and 13 branches. Steady states
# there 165, 230 and 394 sweeps; at N = 4000 93 and 208 with 1 and 13; at other loads and speeds 85
# to 185 with 4: the line through them is within a factor of two.
DENSE = 0.75  # of a step: moves, forces, friction
UNIT = 0.32  # of a step, for each internal variable
NEWTON = 100.0  # sweeps of a steady state
TANGENT = 15.0  # sweeps, for each internal variable

LOOK = 0.2  # of a sweep: finding the samples that touch


class SecondsBySize(NamedTuple):
    """Seconds per call over the number of samples: a power law between measured sizes."""

    sizes: tuple[float, ...]  # increasing
    seconds: tuple[float, ...]

    def __call__(self, size: Numbers) -> Numbers:
        """Return the seconds for ``size`` samples: a call takes some, many in proportion."""
        between = np.interp(np.log(size), np.log(self.sizes), np.log(self.seconds))
        return np.exp(between) * np.maximum(1.0, size / self.sizes[-1])


class Timings(NamedTuple):
    """How fast a machine is."""

    draw: SecondsBySize  # phases, two FFTs, shifts
    sweep: SecondsBySize  # one pass of a steady state
    quadrature: SecondsBySize  # friction of a steady state, or a jump, over the samples that touch
    setup: SecondsBySize  # of a march, over the samples of the line
    step: SecondsBySize  # of a march, over the samples that are marched
    case: float  # s, calls from Python


# One core of the machine of the first measurements; for tests, and where nothing is measured.
TYPICAL = Timings(
    draw=SecondsBySize((2e3, 2e4, 2e5), (2.4e-4, 1.1e-3, 1.1e-2)),
    sweep=SecondsBySize((2e3, 2e4, 2e5), (1.2e-5, 8.5e-5, 9.0e-4)),
    quadrature=SecondsBySize((2e3, 2e4, 2e5), (4.5e-5, 4.2e-4, 4.5e-3)),
    setup=SecondsBySize((2e3, 2e4, 2e5), (2.0e-5, 1.7e-4, 1.7e-3)),
    step=SecondsBySize((6e1, 2e3, 2e4, 2e5), (4.0e-7, 8.0e-6, 8.0e-5, 8.5e-4)),
    case=1.2e-4,
)


def touchable_share(hurst: Numbers, load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the share of the line that is marched: what lies below the indentation.

    At rest it grows with the load; at speed little area carries it, load over viscous pressure.
    Measured on 1500 random problems, Fbar 1e-4 ... 30, vbar 0.02 ... 1000, N 700 ... 12000: half of
    them within 20 %, nine of ten within a factor of 2.2.
    """
    rest = np.exp(-0.40 + 0.78 * hurst) * load**0.635
    speed = np.exp(1.58 + 0.44 * hurst) * (load / viscous_pressure**0.72) ** 1.06
    return (1.0 + rest**-2.8 + speed**-2.8) ** (-1.0 / 2.8)


def sweeps(load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the number of sweeps of a steady state, 1 to 8: within 40 %, same problems."""
    light = np.clip(3.8 + 0.9 * np.log10(viscous_pressure), 2.5, 5.5)
    return 1.2 + (light - 1.2) / (1.0 + load / 3.0)


class Work(NamedTuple):
    """What is computed of a problem on each line, or of many together."""

    problem: Problem
    steps: Numbers  # per spacing
    march_steps: Numbers  # after the jump; 0: none

    @property
    def samples(self) -> Numbers:
        """Number of samples of the line."""
        return self.problem.elements * self.steps

    @property
    def units(self) -> int:
        """Number of internal variables of an element."""
        return len(self.problem.spectrum.moduli) + (self.problem.spectrum.viscosity > 0.0)


def work_seconds(timings: Timings, asked: Quantities, work: Work, recording: Recording) -> Numbers:
    """Return the predicted time of one realization on a line that exists."""
    seconds = timings.case
    if asked.anything:
        plain = work.problem.spectrum == KELVIN
        seconds = seconds + (_kelvin if plain else _memory)(timings, asked, work)
    if recording.asked:
        seconds = seconds + timings.case + _programme_steps(work) * _dense_step(timings, work)
    return seconds


def _programme_steps(work: Work) -> np.ndarray:
    """Return the number of steps of the programme of a problem, which the steps per spacing say."""
    different, inverse = np.unique(work.steps, return_inverse=True)
    counts = [programme_steps(work.problem, int(steps)).time.size for steps in different]
    return np.array(counts)[inverse]


def _kelvin(timings: Timings, asked: Quantities, work: Work) -> Numbers:
    """Return the time of a case of Kelvin elements, of which those that can touch are marched."""
    hurst, load = work.problem.hurst, work.problem.load
    n, pressure = work.samples, viscous_pressure(work.problem)
    steady_states = 1 + (asked.steady or asked.relaxation)
    sweep = timings.sweep(n)
    states = steady_states * sweeps(load, pressure) * sweep
    touching = n * touchable_share(hurst, load, pressure)
    look = LOOK * sweep
    friction = (steady_states + asked.jump) * (look + timings.quadrature(touching))
    march: Numbers = 0.0
    if asked.relaxation:
        march = timings.setup(n) + work.march_steps * timings.step(touching)
    return states + friction + march


def _memory(timings: Timings, asked: Quantities, work: Work) -> Numbers:
    """Return the time of a case of elements with internal variables, all of which are marched."""
    steady_states = 1 + (asked.steady or asked.relaxation)
    states = steady_states * (NEWTON + TANGENT * work.units) * timings.sweep(work.samples)
    return states + work.march_steps * _dense_step(timings, work)


def _dense_step(timings: Timings, work: Work) -> Numbers:
    """Return the time of a step in which every element moves all that it remembers."""
    return (DENSE + UNIT * work.units) * timings.step(work.samples)
